"""The kernels compile for a real card, round as the processor does and allocate nothing."""

import re

import pytest
from offline_card import arguments_of, ptx_of, require_compiler, resources
from robots import DESIGNS, small_march

pytestmark = pytest.mark.slow
MOST_SPILLED_BYTES = 4096


@pytest.fixture(scope="module", autouse=True)
def compiler():
    require_compiler()


@pytest.mark.parametrize("kernel", ["find_starts", "march"])
def test_kernel(kernel, monkeypatch, tmp_path):
    from snapjump.engine.cuda import kernels

    starts, steps = arguments_of(small_march(DESIGNS[:1], 1))
    arguments = {"find_starts": starts, "march": steps}[kernel]
    ptx = ptx_of(monkeypatch, getattr(kernels, kernel), *arguments)
    assert ".target sm_90" in ptx
    # Products and sums that could still be merged have no rounding mode.
    assert re.findall(r"\b(?:mul|add|sub)\.f64", ptx) == []
    assert "mul.rn.f64" in ptx and "fma.rn.f64" in ptx
    assert not re.search(r"approx|ftz", ptx)
    # Neither a stack of its own, nor calls: everything is merged into one program.
    assert "__local_depot" not in ptx
    assert not re.search(r"^\s*call", ptx, re.MULTILINE)
    found = resources(ptx, tmp_path)
    if found:
        assert found["spilled_bytes"] < MOST_SPILLED_BYTES
        print(found)
