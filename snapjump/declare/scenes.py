"""The contract of a scene: what exists, when a simulation ends, and what it reports."""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from snapjump.declare.fields import Part, required
from snapjump.declare.outputs import Outputs

Progress = Callable[[float, str], None]  # called with the share that is done, and a word


class SceneOptions(Part):
    """A scene and its numbers.

    ``outputs``: the class of what it reports. ``chooses``: members that go with it unless others
    are asked for, by family. ``tells``: paths of the values in its reports' titles; by default all
    of its own.
    """

    group = "sim"
    outputs: ClassVar[type[Outputs]]
    chooses: ClassVar[Mapping[str, str]] = {}
    tells: ClassVar[tuple[str, ...]] = ()
    moves_a_beam: ClassVar[bool] = False

    def check_start(self, simulation: Any) -> None:
        """What only the machine and the robot's statics tell. Raises ParameterError if the scene
        cannot begin."""

    @required
    def simulate(self, simulation: Any, progress: Progress | None = None) -> Any:
        """The :class:`~snapjump.results.Result` of a simulation of this scene."""

    if TYPE_CHECKING:  # fields of a member that only its family is known of

        def __getattr__(self, name: str) -> Any: ...
