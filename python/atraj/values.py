"""What goes into the motions and comes out of them: named tuples and sets. They do not depend on the real type."""

from __future__ import annotations

from enum import IntEnum, IntFlag
from types import GenericAlias
from typing import TYPE_CHECKING, Any, Generic, NamedTuple, TypeVar

import numpy as np
import numpy.typing as npt

R = TypeVar("R", bound=np.floating[Any])


class State(NamedTuple):
    """Position, velocity and acceleration of an axis at one instant, all signed. `State(10)` is at rest."""

    position: float
    velocity: float = 0.0
    acceleration: float = 0.0


class _Limits(NamedTuple):
    vmax: float
    vmin: float
    amax: float
    amin: float
    jmax: float
    jmin: float


class Limits(_Limits):
    """What an axis can do.

    The highest values are above 0, the lowest ones below 0. An infinite limit is no limit.
    A jerk, or both accelerations, are finite.

    `jerk`, `acceleration` and `velocity`, in this order, are limits in both directions, and their signs are ignored. `vmax`, `vmin`, `amax`,
    `amin`, `jmax` and `jmin` are limits in one direction. TypeError if a direction has no limit.

    >>> import atraj
    >>> atraj.Limits(jerk=30, acceleration=10, velocity=5)
    Limits(vmax=5, vmin=-5, amax=10, amin=-10, jmax=30, jmin=-30)
    >>> atraj.Limits(jerk=30, acceleration=10, velocity=5, amin=-12) # brakes harder
    Limits(vmax=5, vmin=-5, amax=10, amin=-12, jmax=30, jmin=-30)
    """

    __slots__ = ()

    def __new__(
        cls,
        jerk: float | None = None,
        acceleration: float | None = None,
        velocity: float | None = None,
        *,
        vmax: float | None = None,
        vmin: float | None = None,
        amax: float | None = None,
        amin: float | None = None,
        jmax: float | None = None,
        jmin: float | None = None,
    ) -> Limits:
        v = _directions(vmax, vmin, velocity, "velocity, or vmax and vmin")
        a = _directions(amax, amin, acceleration, "acceleration, or amax and amin")
        j = _directions(jmax, jmin, jerk, "jerk, or jmax and jmin")
        return super().__new__(cls, *v, *a, *j)

    def __getnewargs_ex__(self) -> tuple[tuple[()], dict[str, float]]:
        """What a copy is made of: the six numbers, each by its name."""
        return (), self._asdict()

    @classmethod
    def symmetric(cls, jerk: float, acceleration: float, velocity: float) -> Limits:
        """The same limits in both directions, in liba's order. Signs are ignored."""
        return cls(jerk=jerk, acceleration=acceleration, velocity=velocity)


def _directions(highest: float | None, lowest: float | None, both: float | None, needed: str) -> tuple[float, float]:
    """The limits in each direction, from those of one direction and that of both."""
    if both is not None:
        highest = abs(both) if highest is None else highest
        lowest = -abs(both) if lowest is None else lowest
    if highest is None or lowest is None:
        raise TypeError(f"Limits needs {needed}")
    return highest, lowest


class Phase(NamedTuple):
    """A phase of constant jerk: when it starts and how long it lasts, s, the state of the axis at its start, and the jerk."""

    start: float
    duration: float
    position: float
    velocity: float
    acceleration: float
    jerk: float


class Extremes(NamedTuple):
    """The lowest and the highest position, velocity and acceleration of a motion, each at its own time."""

    lowest: State
    highest: State


if TYPE_CHECKING:

    class Samples(NamedTuple, Generic[R]):
        t: npt.NDArray[R]
        p: npt.NDArray[R]
        v: npt.NDArray[R]
        a: npt.NDArray[R]
        j: npt.NDArray[R]

else:
    # A named tuple is generic at run time from Python 3.11 on.
    class Samples(NamedTuple):
        """Times, s, and what a motion does then: positions, velocities, accelerations and jerks.

        The `out` of `sample` may hold None in the place of an array that is not wanted.
        """

        t: npt.NDArray
        p: npt.NDArray
        v: npt.NDArray
        a: npt.NDArray
        j: npt.NDArray

        __class_getitem__ = classmethod(GenericAlias)


class Step(NamedTuple):
    """A step of a motor: its time since the start of the move, s, and its direction, 1 towards larger positions, else -1."""

    time: float
    direction: int


class ShaperKind(IntEnum):
    """How a shaper meets a frequency that is not exactly known. The number after each says by how much the frequency may be wrong while less than
    5 % of the vibration of an undamped load is left."""

    ZV = 0
    """Zero vibration: 2 impulses, 1/2 period longer; 3 %."""
    ZVD = 1
    """Zero vibration and derivative: 3 impulses, 1 period longer; 14 %."""
    MZV = 2
    """Zero vibration by three impulses, 3/4 period longer; 5 %."""
    EI = 3
    """Extra insensitive: 3 impulses, 1 period longer; 20 %."""
    EI2 = 4
    """Extra insensitive with two humps: 4 impulses, 3/2 periods longer; 36 %."""


class BellFields(NamedTuple):
    """The fields of liba's `a_trajbell`, in the order of its struct."""

    t: float
    tv: float
    ta: float
    td: float
    taj: float
    tdj: float
    p0: float
    p1: float
    v0: float
    v1: float
    vm: float
    jm: float
    am: float
    dm: float


class TrapFields(NamedTuple):
    """The fields of liba's `a_trajtrap`, in the order of its struct."""

    t: float
    p0: float
    p1: float
    v0: float
    v1: float
    vc: float
    ta: float
    td: float
    pa: float
    pd: float
    ac: float
    de: float


class Findings(IntFlag):
    """What a check or a plan found; empty for a clean move."""

    EXCEEDS_JERK = 1
    """The jerk is above its limit."""
    EXCEEDS_ACCELERATION = 2
    """The acceleration is above its limit."""
    EXCEEDS_VELOCITY = 4
    """The velocity is above its limit."""
    JUMPS = 8
    """Position or velocity is not continuous, or not where the fields say."""
    OVERSHOOTS = 16
    """The move leaves the positions between its ends by more than rounding: 128 ulps in a plan, 64 in a check."""
    STARTS_OUTSIDE = 32
    """The move starts outside its limits, or will unavoidably exceed them."""
    ENDS_LEAVING = 64
    """The axis will unavoidably exceed its limits after the move: the acceleration at the end does not vanish at once."""
    RATE_NOT_REACHED = 128
    """The path ends before its clock has the rate."""


class Mode(IntEnum):
    """Which motion a start or a stop of CLARAty's trajectory plans."""

    CORRECTED = 0
    """The motion that CLARAty's class documents."""
    LISTING = 1
    """The numbers of its published listing, wrong motions included."""


class Warnings(IntFlag):
    """What a plan of CLARAty's trajectory changed or could not do."""

    ACCELERATION = 1
    """The acceleration was below 1e-10 and was raised to it."""
    DECELERATION = 2
    """The deceleration was below 1e-10 and was raised to it."""
    VELOCITY = 4
    """The maximum velocity was below 1e-10 and was raised to it."""
    SWITCH = 8
    """The listing found no instant to switch from acceleration to deceleration. Its motion is wrong."""


class TrapezoidalProfile(NamedTuple):
    """Acceleration until `t1`, cruise until `t2`, deceleration until `tf`, s; the positions then; the signed rates."""

    t1: float
    t2: float
    tf: float
    p_at_t1: float
    p_at_t2: float
    final_position: float
    velocity: float
    acceleration: float
    deceleration: float


def _rebuild(cls: Any, method: str, arguments: tuple[Any, ...]) -> Any:
    """What a pickled object is made again by."""
    return getattr(cls, method)(*arguments)
