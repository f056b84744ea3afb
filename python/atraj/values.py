"""What goes into the profiles and comes out of them: named tuples and sets. They do not depend on the real type."""

from enum import IntEnum, IntFlag
from typing import Any, Generic, NamedTuple, Self, TypeVar

import numpy as np
import numpy.typing as npt

R = TypeVar("R", bound=np.floating[Any])


class State(NamedTuple):
    """Position, velocity and acceleration of an axis at one instant, all signed. `State(10)` is at rest."""

    position: float
    velocity: float = 0.0
    acceleration: float = 0.0


class Limits(NamedTuple):
    """What an axis can do.

    The highest values are above 0, the lowest ones below 0. An infinite limit is no limit.
    A jerk, or both accelerations, are finite.
    """

    vmax: float
    vmin: float
    amax: float
    amin: float
    jmax: float
    jmin: float

    @classmethod
    def symmetric(cls, jerk: float, acceleration: float, velocity: float) -> Self:
        """The same limits in both directions, in liba's order. Signs are ignored."""
        j, a, v = abs(jerk), abs(acceleration), abs(velocity)
        return cls(v, -v, a, -a, j, -j)


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


class Samples(NamedTuple, Generic[R]):
    """Times, s, and what a motion does then: positions, velocities, accelerations and jerks.

    The `out` of `sample` may hold None in the place of an array that is not wanted.
    """

    t: npt.NDArray[R]
    p: npt.NDArray[R]
    v: npt.NDArray[R]
    a: npt.NDArray[R]
    j: npt.NDArray[R]


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
    """The move leaves the positions between its ends by more than rounding: 128 roundings in a plan, 64 in a check."""
    STARTS_OUTSIDE = 32
    """The move starts outside its limits, or is bound to leave them."""
    ENDS_LEAVING = 64
    """The axis is bound to leave its limits after the move: the acceleration at the end does not vanish at once."""


class Mode(IntEnum):
    """The motion that CLARAty's class documents, or the numbers of its published listing, wrong motions included."""

    CORRECTED = 0
    LISTING = 1


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
