"""Names of memory that do not share any: what a load or store of one cannot touch.

Kernels get all their arrays from one block, and a compiler that knows no better loads a number
again after every store to another part of it.
"""

from typing import Any

from llvmlite import ir

SCOPES = ["own"]  # names of memory that do not share any


def scope_lists(module: Any, scope: str) -> Any:
    """In the metadata of a module: the memory of a name, and that of all the others."""
    known = module.__dict__.setdefault("scope_lists", {})
    if scope not in known:
        domain = module.add_metadata([ir.MetaDataString(module, "snapjump")])
        scopes = {
            name: module.add_metadata([ir.MetaDataString(module, name), domain]) for name in SCOPES
        }
        others = [node for name, node in scopes.items() if name != scope]
        known[scope] = module.add_metadata([scopes[scope]]), module.add_metadata(others)
    return known[scope]


def apart(builder: Any, scope: str, access: Any) -> Any:
    """A load or store, of which the compiler is told what memory it does not touch."""
    memory = isinstance(access, (ir.instructions.LoadInstr, ir.instructions.StoreInstr))
    if scope and memory and not builder.module.triple.startswith("nvptx"):
        own, others = scope_lists(builder.module, scope)
        access.set_metadata("alias.scope", own)
        access.set_metadata("noalias", others)
    return access
