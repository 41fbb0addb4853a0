"""Methods of members: the same in Python, compiled and in lanes; what is missing is said."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from numba import njit

from snapjump.number.dispatch import PROGRAM
from snapjump.number.lane import view_numbers
from snapjump.number.memory import aligned_zeros
from snapjump.number.methods import Contract, ContractError, required

program = njit(**{**PROGRAM, "cache": False})


class Spring(Contract):
    @required
    def force(self, gap):
        """Push of the ground."""

    def loss(self, gap):
        """Nothing is lost."""
        return 0.0 * gap

    def twice(self, gap):
        return 2.0 * self.force(gap)


@Spring.member
class Linear(NamedTuple):
    stiffness: float

    def force(self, gap):
        return -self._scaled(gap)

    def _scaled(self, gap):
        return self.stiffness * gap


@Spring.member
class Lossy(NamedTuple):
    stiffness: float
    share: float

    def force(self, gap):
        return -self.stiffness * gap * gap

    def loss(self, gap):
        return self.share * self.force(gap)


@Spring.member
class Nothing(NamedTuple):
    def force(self, gap):
        return 0.5 * gap


def total(law: Any, gap: Any) -> Any:
    return law.force(gap) + law.loss(gap) + law.twice(gap)


compiled_total, part_of_a_program = program(total), njit(total)


@program
def total_in_lanes(law, gaps, found, lanes):
    view_numbers(found, lanes)[0] = part_of_a_program(law, view_numbers(gaps, lanes)[0])


@pytest.mark.parametrize("law", [Linear(3.0), Lossy(2.0, 0.5), Nothing()])
def test_compiled_plain_and_lanes_agree(law):
    gaps, found = aligned_zeros((1, 8)), aligned_zeros((1, 8))
    gaps[0] = np.linspace(-1.0, 1.0, 8)
    plain = [total(law, gap) for gap in gaps[0]]
    assert [compiled_total(law, gap) for gap in gaps[0]] == plain
    assert plain[0] == 3.0 * law.force(-1.0) + law.loss(-1.0)
    total_in_lanes(law, gaps, found, (0,) * 8)
    assert found[0].tolist() == plain


def test_what_is_missing_is_said():
    with pytest.raises(ContractError, match=r"Empty has no method force\(self, gap\)"):

        @Spring.member
        class Empty(NamedTuple):
            stiffness: float


def test_other_arguments_are_refused():
    with pytest.raises(ContractError, match=r"Odd.force takes depth: gap are what"):

        @Spring.member
        class Odd(NamedTuple):
            stiffness: float

            def force(self, depth):
                return self.stiffness * depth


def test_an_argument_may_have_its_former_name():
    class Law(Contract):
        @required
        def force(self, gap, state):
            """Push of the ground."""

    @Law.member
    class Old(NamedTuple):
        stiffness: float

        def force(self, gap, approach):
            return self.stiffness * gap + approach

    assert Old(2.0).force(3.0, 1.0) == 7.0


def test_laws_of_one_name_and_the_same_fields_are_told_apart() -> None:
    def law(factor):
        @Spring.member
        class Law(NamedTuple):
            stiffness: float

            def force(self, gap):
                return factor * self.stiffness * gap

        return Law(1.0)

    @program
    def force(law, gap):
        return law.force(gap)

    assert [force(law(factor), 1.0) for factor in (2.0, 3.0)] == [2.0, 3.0]
