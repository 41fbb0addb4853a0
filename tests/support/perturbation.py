"""``pytest --perturb SEED``: whether a test passes by the luck of last bits.

Every first guess and every number of a model is multiplied by 1 + 1e-15 u, with u in [-1, 1] made
of the seed and of the value's own bits: equal values stay equal, so that lanes, scalars and a card
still agree. Tests marked ``exact`` are left out: they compare with bits that were written down.
"""

from typing import Any

import numpy as np
import pytest

SIZE = 1e-15


def shaken(values: Any, seed: int) -> Any:
    """Numbers (...) times 1 + SIZE u."""
    array = np.ascontiguousarray(values, dtype=float)
    bits = array.view(np.uint64) + np.uint64(seed * 0x9E3779B97F4A7C15 % 2**64)
    # splitmix64 (Steele, Lea and Flood 2014)
    bits = (bits ^ (bits >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    bits = (bits ^ (bits >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    bits = bits ^ (bits >> np.uint64(31))
    u = 2.0 * ((bits >> np.uint64(11)) * 2.0**-53) - 1.0
    return array * (1.0 + SIZE * u)


def perturb(seed: int) -> None:
    """Shake whatever is computed in this process from now on."""
    from snapjump.batch import derivatives
    from snapjump.engine import model, models
    from snapjump.scenes import resting
    from snapjump.statics import arch, elastica

    plain = model.numbers_of, models.numbers_of_columns, elastica.buckled_arch

    def numbers_of(parts: Any) -> Any:
        return shaken(plain[0](parts), seed)

    def numbers_of_columns(*arguments: Any) -> Any:
        return shaken(plain[1](*arguments), seed)

    def buckled_arch(*arguments: Any) -> Any:
        return tuple(shaken(values, seed) for values in plain[2](*arguments))

    for module in (model, models, arch, derivatives):
        module.numbers_of = numbers_of
    models.numbers_of_columns = numbers_of_columns
    for module in (elastica, arch, resting):
        module.buckled_arch = buckled_arch


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--perturb", type=int, metavar="SEED", help="shake first guesses and models by 1e-15"
    )


def pytest_configure(config: pytest.Config) -> None:
    seed = config.getoption("--perturb")
    if seed is not None:
        perturb(seed)


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if config.getoption("--perturb") is None:
        return
    exact = [item for item in items if item.get_closest_marker("exact")]
    config.hook.pytest_deselected(items=exact)
    items[:] = [item for item in items if item not in exact]
