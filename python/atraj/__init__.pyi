from collections.abc import Iterator, Sequence
from typing import Any, TypeAlias, final, overload

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes as _Plot
from matplotlib.figure import Figure
from typing_extensions import Self, disjoint_base

from . import claraty as claraty
from . import f32 as f32
from .values import BellFields as BellFields
from .values import Extremes as Extremes
from .values import Findings as Findings
from .values import Limits as Limits
from .values import Phase as Phase
from .values import Samples as Samples
from .values import ShaperKind as ShaperKind
from .values import State as State
from .values import Step as Step
from .values import TrapFields as TrapFields

_Real: TypeAlias = np.float64
_Array: TypeAlias = npt.NDArray[_Real]
_Times: TypeAlias = Sequence[float] | npt.NDArray[Any]
_Out: TypeAlias = Samples[_Real] | tuple[_Array | None, _Array | None, _Array | None, _Array | None, _Array | None]
_Numbers: TypeAlias = Sequence[float] | npt.NDArray[Any]
_State: TypeAlias = State | float | _Numbers
_States: TypeAlias = Sequence[_State] | npt.NDArray[Any]
_Limits: TypeAlias = Limits | _Numbers
_LimitsOfAxes: TypeAlias = Sequence[_Limits] | npt.NDArray[Any]
_Points: TypeAlias = Sequence[Sequence[_State] | npt.NDArray[Any]] | npt.NDArray[Any]
_Tolerances: TypeAlias = _Numbers | Sequence[_Numbers]
_Plots: TypeAlias = Sequence[_Plot] | npt.NDArray[Any]

@disjoint_base
class Profile:
    """A planned motion of one axis: what all profiles have in common.

    Times are in seconds since the start of the motion. Positions have any unit of length or angle, and the other quantities
    follow from it: m, m/s, m/s², m/s³.

    An array of times has any strides, alignment, byte order and type of real number. The mask of a masked array is not looked at."""
    @property
    def t(self) -> float:
        """Duration, s."""
    @overload
    def position(self, time: float) -> float:
        """Position at `time`, s: a float, or an array for an array of times. Before the start it is the initial one, after the
        end the final one, but a polynomial goes on."""
    @overload
    def position(self, time: _Times) -> _Array: ...
    @overload
    def velocity(self, time: float) -> float:
        """Velocity at `time`, s: a float, or an array for an array of times."""
    @overload
    def velocity(self, time: _Times) -> _Array: ...
    @overload
    def acceleration(self, time: float) -> float:
        """Acceleration at `time`, s: a float, or an array for an array of times."""
    @overload
    def acceleration(self, time: _Times) -> _Array: ...
    @overload
    def jerk(self, time: float) -> float:
        """Jerk at `time`, s: a float, or an array for an array of times. The jerk of a trapezoid is NaN, for its acceleration
        jumps, and the jerk of a shaped move too, for a shaper gives none."""
    @overload
    def jerk(self, time: _Times) -> _Array: ...
    def state_at(self, time: float) -> State:
        """The `State` at `time`, s: where another plan starts."""
    def extremes(self) -> Extremes:
        """The `Extremes`: the lowest and the highest position, velocity and acceleration between 0 and `t`. ValueError for a shaped move, whose
        extremes only `sample` can tell."""
    def sample(
        self, dt: float | None = None, *, n: int | None = None, start: float = 0.0, out: _Out | None = None
    ) -> Samples[_Real]:
        """`Samples`: times, positions, velocities, accelerations and jerks, with the bits of the single calls.

        Sample `k` belongs to the time `start + k*dt`, s. `dt` alone samples until the end is reached, `n` alone takes `n` samples
        evenly from the start to the end. With `out`, a `Samples` of arrays, nothing is allocated, which saves most of the time of a long
        sweep: each array is filled, and None leaves a quantity out. ValueError, before anything is written, if an array of `out` is not
        contiguous or not aligned. ValueError for more than 2147483647 samples.

        >>> import atraj
        >>> move = atraj.Bell(30, 10, 5, 0, 10)
        >>> t, p, v, a, j = move.sample(0.5)
        >>> p.round(3)
        array([ 0.   ,  0.602,  2.917,  5.417,  7.917,  9.815, 10.   ])
        >>> move.sample(n=3).v
        array([0., 5., 0.])"""
    def plot(
        self,
        *,
        axes: _Plots | None = None,
        limits: _Limits | None = None,
        unit: str | None = None,
        label: str | None = None,
        offset: float = 0.0,
    ) -> Figure:
        """Draws position, velocity, acceleration and jerk over time, and returns the figure. Needs matplotlib.

        `limits` are drawn as dashed lines. The labels have the `unit` of the position, "m" or "deg" for example, and the others that follow
        from it. `label` names the motion, which begins at the time `offset`, s. `axes`, the axes of a figure, draws over what is there, so
        motions lie over each other:

        >>> import atraj
        >>> figure = atraj.Bell(30, 10, 5, 0, 10).plot(label="double-S", unit="m") # doctest: +SKIP
        >>> atraj.Trap(5, 10, -10, 0, 10).plot(axes=figure.axes, label="trapezoid") # doctest: +SKIP"""
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Self: ...
    def __deepcopy__(self, _memo: Any) -> Self: ...

@final
class Bell(Profile):
    """Double-S: jerk, acceleration and velocity are limited.

    `Bell(jerk, acceleration, velocity, p0, p1, v0=0, v1=0)` plans as liba's `a_trajbell_gen`, to the last bit, from the position
    `p0` to `p1` and from the velocity `v0` to `v1`. The signs of the limits are ignored, and velocities beyond the limit are
    limited to it. A ValueError says that there is no such move; `Bell.fastest` plans where liba fails. With
    `newest_saturation=True` velocities are limited as liba does since 2025: a NaN stays NaN, and a zero keeps its sign.

    `fields` carry liba's names. For a move towards smaller positions `vm`, `jm`, `am` and `dm` hold in the mirrored axis.

    >>> import atraj
    >>> move = atraj.Bell(jerk=30, acceleration=10, velocity=5, p0=0, p1=10)
    >>> move.t, move.position(1.0)
    (2.833333333333333, 2.916666666666667)"""
    def __new__(
        cls,
        jerk: float,
        acceleration: float,
        velocity: float,
        p0: float,
        p1: float,
        v0: float = 0.0,
        v1: float = 0.0,
        *,
        newest_saturation: bool = False,
    ) -> Self: ...
    @staticmethod
    def fastest(
        jerk: float,
        acceleration: float,
        velocity: float,
        p0: float,
        p1: float,
        v0: float = 0.0,
        v1: float = 0.0,
    ) -> Bell:
        """The fastest move within the limits, which never fails: a target behind, or too near to stop, is reached by turning.

        An infinite limit is no limit. A jerk, or both accelerations, are finite. ValueError if a limit is 0, an argument is no
        number, or a position is infinite.

        >>> import atraj
        >>> atraj.Bell.fastest(30, 10, 5, p0=0, p1=0.1, v0=2).t # 0.1 m to go at 2 m/s
        1.015182383138908"""
    @staticmethod
    def from_fields(fields: BellFields | Sequence[float]) -> Bell:
        """The move with these `BellFields`, whoever planned it: a log of a drive, or liba. Nothing is checked here; `check` does."""
    @property
    def fields(self) -> BellFields:
        """The `BellFields`: what liba's struct holds."""
    def check(self, jerk: float, acceleration: float, velocity: float) -> Findings:
        """The `Findings` of the move within these limits: empty if the move keeps them, does not jump and does not overshoot.
        ValueError if a field is not finite, or a limit is not a number.

        >>> import atraj
        >>> move = atraj.Bell(30, 2.5, 10, p0=0, p1=10, v0=7.5) # liba's plan forgets the limit of the acceleration
        >>> move.check(30, 2.5, 10)
        <Findings.EXCEEDS_ACCELERATION: 2>"""

@final
class Trap(Profile):
    """Trapezoid: acceleration and velocity are limited.

    `Trap(velocity, ac, de, p0, p1, v0=0, v1=0)` plans as liba's `a_trajtrap_gen`, to the last bit. `ac` and `de` are signed: a
    forward move has `ac > 0` and `de < 0`, a backward one the opposite. A final velocity out of reach is replaced by the one that is
    reached. Otherwise as `Bell`.

    >>> import atraj
    >>> move = atraj.Trap(velocity=5, ac=4, de=-2, p0=0, p1=50)
    >>> move.t, move.velocity(5)
    (11.875, 5.0)"""
    def __new__(
        cls,
        velocity: float,
        ac: float,
        de: float,
        p0: float,
        p1: float,
        v0: float = 0.0,
        v1: float = 0.0,
        *,
        newest_saturation: bool = False,
    ) -> Self: ...
    @staticmethod
    def fastest(
        velocity: float,
        ac: float,
        de: float,
        p0: float,
        p1: float,
        v0: float = 0.0,
        v1: float = 0.0,
    ) -> Trap:
        """The fastest move within the limits, which never fails: a target behind, or too near to stop, is reached by turning.

        One of `ac` and `de` is positive, the other negative. ValueError if not, if the velocity is 0, an argument is NaN or infinite, or
        a position is infinite."""
    @staticmethod
    def from_fields(fields: TrapFields | Sequence[float]) -> Trap:
        """The move with these `TrapFields`, whoever planned it: a log of a drive, or liba. Nothing is checked here; `check` does."""
    @property
    def fields(self) -> TrapFields:
        """The `TrapFields`: what liba's struct holds."""
    def check(self, velocity: float, ac: float, de: float) -> Findings:
        """The `Findings` of the move within these limits: empty if the move keeps them, does not jump and does not overshoot.
        ValueError if a field is not finite, a limit is not a number, or both accelerations have one sign."""

@final
class Poly3(Profile):
    """Cubic: position and velocity are given at both ends.

    `Poly3(t, p0, p1, v0=0, v1=0)` takes `t`, s, with the bits of liba's `a_trajpoly3_gen`. ValueError if a coefficient is not finite.

    >>> import atraj
    >>> cubic = atraj.Poly3(8, p0=0, p1=10)
    >>> cubic.position(4), cubic.velocity(8)
    (5.0, 0.0)"""
    def __new__(cls, t: float, p0: float, p1: float, v0: float = 0.0, v1: float = 0.0) -> Self: ...
    @staticmethod
    def from_coefficients(t: float, c: Sequence[float]) -> Poly3:
        """The polynomial of duration `t`, s, with these coefficients `c`, finite or not."""
    @property
    def c(self) -> tuple[float, float, float, float]:
        """Coefficients of the position in ascending powers of time."""

@final
class Poly5(Profile):
    """Quintic: position, velocity and acceleration are given at both ends.

    `Poly5(t, p0, p1, v0=0, v1=0, a0=0, a1=0)` takes `t`, s, with the bits of liba's `a_trajpoly5_gen`. ValueError if a coefficient
    is not finite."""
    def __new__(
        cls,
        t: float,
        p0: float,
        p1: float,
        v0: float = 0.0,
        v1: float = 0.0,
        a0: float = 0.0,
        a1: float = 0.0,
    ) -> Self: ...
    @staticmethod
    def from_coefficients(t: float, c: Sequence[float]) -> Poly5:
        """The polynomial of duration `t`, s, with these coefficients `c`, finite or not."""
    @property
    def c(self) -> tuple[float, float, float, float, float, float]:
        """Coefficients of the position in ascending powers of time."""

@final
class Poly7(Profile):
    """Septic: position, velocity, acceleration and jerk are given at both ends.

    `Poly7(t, p0, p1, v0=0, v1=0, a0=0, a1=0, j0=0, j1=0)` takes `t`, s, with the bits of liba's `a_trajpoly7_gen`. ValueError if a
    coefficient is not finite."""
    def __new__(
        cls,
        t: float,
        p0: float,
        p1: float,
        v0: float = 0.0,
        v1: float = 0.0,
        a0: float = 0.0,
        a1: float = 0.0,
        j0: float = 0.0,
        j1: float = 0.0,
    ) -> Self: ...
    @staticmethod
    def from_coefficients(t: float, c: Sequence[float]) -> Poly7:
        """The polynomial of duration `t`, s, with these coefficients `c`, finite or not."""
    @property
    def c(self) -> tuple[float, float, float, float, float, float, float, float]:
        """Coefficients of the position in ascending powers of time."""

@final
class Move(Profile):
    """A move from any state to any state, planned in motion: phases of constant jerk.

    `Move.plan`, `within`, `reach`, `stop`, `meet` and `track` plan one axis, `synchronise` and `line` several. A move never changes: when the
    target changes, plan again from `state_at` of this moment. After its end the axis moves on with the acceleration of the end.

    A state is a `State`, up to three numbers in its order, or a position at rest; limits are a `Limits` or six numbers in its order. ValueError
    says which number is NaN or infinite, which limit is 0 or has the wrong sign, or what is outside the limits.

    >>> import atraj
    >>> limits = atraj.Limits(jerk=30, acceleration=10, velocity=5)
    >>> move = atraj.Move.plan(limits, 0, 10)
    >>> other = atraj.Move.plan(limits, move.state_at(0.7), -2) # in mid-motion, another target
    >>> other.position(other.t), other.findings
    (-2.0, <Findings.OVERSHOOTS: 16>)"""
    @staticmethod
    def plan(limits: _Limits, start: _State, end: _State) -> Move:
        """The fastest motion from the state `start` to the state `end`.

        A start outside the limits returns within them in minimum time. The end may be behind, or nearer than the stopping distance."""
    @staticmethod
    def within(limits: _Limits, start: _State, end: _State, lowest: float, highest: float) -> Move:
        """The fastest motion from the state `start` to the state `end`, if it stays between two positions until its end; `-inf` and `inf` are no
        limits. ValueError also if the motion leaves the positions: then the axis cannot stop between them, or the state `end` cannot be
        reached from rest between them."""
    @staticmethod
    def reach(limits: _Limits, start: _State, velocity: float, acceleration: float = 0.0) -> Move:
        """The fastest motion from the state `start` to a velocity and an acceleration; the position is free."""
    @staticmethod
    def stop(limits: _Limits, start: _State) -> Move:
        """The fastest stop from the state `start`; the position is free."""
    @staticmethod
    def meet(limits: _Limits, start: _State, target: _State) -> Move:
        """The fastest motion from the state `start` to a target that moves on at its velocity. The move ends at the target, at
        `target.position + t * target.velocity`. The target must not accelerate."""
    @staticmethod
    def track(limits: _Limits, start: _State, signal: _State, jerk: float, horizon: float) -> Move:
        """The next moments of an axis that follows `signal`, a state, with its `jerk`, 0 if nobody knows it: call it in every tick. Where the axis
        can be next to the signal after the time `horizon`, s, it gets there in just this time. Else it chases the signal as fast as it can."""
    def check(self, limits: _Limits) -> Findings:
        """What is wrong with the move against `limits`, a `Findings`: what it exceeds, whether it jumps. It reads the phases alone."""
    def time_at(self, position: float) -> float | None:
        """The first time from 0 to `t` at which the axis is at `position`, s; None if it never is."""
    @property
    def findings(self) -> Findings:
        """The `Findings` of the plan: of OVERSHOOTS, STARTS_OUTSIDE and ENDS_LEAVING any or none. For several axes it is what any of them does."""
    @property
    def phases(self) -> list[Phase]:
        """The phases of constant jerk in order of time, each a `Phase`."""

@disjoint_base
class Axes:
    """A planned motion of several axes: what `Moves` and `Path` have in common.

    Times are in seconds since the start of the motion. A result has one number for each axis, and an array of times gives one such row for
    each time. Before the start the axes are at the start. After the end each of them moves on with the acceleration of the end: an axis that
    ends at rest stays."""
    @property
    def t(self) -> float:
        """Duration, s."""
    @property
    def findings(self) -> Findings:
        """The `Findings` of the plan: what any axis does."""
    def position(self, time: float | _Times) -> _Array:
        """Positions at `time`, s."""
    def velocity(self, time: float | _Times) -> _Array:
        """Velocities at `time`, s."""
    def acceleration(self, time: float | _Times) -> _Array:
        """Accelerations at `time`, s."""
    def jerk(self, time: float | _Times) -> _Array:
        """Jerks at `time`, s."""
    def state_at(self, time: float) -> list[State]:
        """The `State` of each axis at `time`, s: where another plan starts."""
    def sample(self, dt: float | None = None, *, n: int | None = None, start: float = 0.0) -> Samples[_Real]:
        """`Samples`: times, and a row of positions, velocities, accelerations and jerks for each time.

        Sample `k` belongs to the time `start + k*dt`, s. `dt` alone samples until the end is reached, `n` alone takes `n` samples
        evenly from the start to the end. ValueError for more than 2147483647 samples.

        >>> import atraj
        >>> limits = [atraj.Limits(jerk=30, acceleration=10, velocity=5)] * 2
        >>> atraj.path(limits, [[0, 0], [3, 1], [4, 5]]).sample(0.01).p.shape
        (226, 2)"""
    def plot(
        self,
        *,
        axes: _Plots | None = None,
        limits: _LimitsOfAxes | None = None,
        unit: str | None = None,
        labels: Sequence[str] | None = None,
        plane: tuple[int, int] | None = None,
        offset: float = 0.0,
    ) -> Figure:
        """Draws position, velocity, acceleration and jerk of all axes over time, in a colour each, and returns the figure. Needs matplotlib.

        With `plane=(0, 1)` it draws the axes 0 and 1 in their plane, on equal scales, in the place of the motion over time. `limits`, an item
        for each axis, are drawn as dashed lines in the colours of the axes. The labels have the `unit` of the positions, and `labels` names
        the axes. `axes`, the axes of a figure, draws over what is there. The motion begins at the time `offset`, s."""
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Self: ...
    def __deepcopy__(self, _memo: Any) -> Self: ...

@final
class Moves(Axes):
    """Moves of several axes that arrive together: what `synchronise`, `synchronise_within`, `line` and `line_stop` plan. It is a sequence of a
    `Move` for each axis."""
    def __len__(self) -> int: ...
    def __getitem__(self, axis: int, /) -> Move: ...
    def __iter__(self) -> Iterator[Move]: ...

def synchronise(
    limits: _LimitsOfAxes,
    start: _States,
    end: _States,
    *,
    duration: float = 0.0,
    cycle: float = 0.0,
) -> Moves:
    """Moves of several axes that arrive together: the shortest duration that is possible for each axis, is at least `duration`, s, and is
    a multiple of `cycle`, s (0: any). An item of `limits`, `start` and `end` belongs to one axis. ValueError as for one axis.

    >>> import atraj
    >>> limits = [atraj.Limits(jerk=30, acceleration=10, velocity=5), atraj.Limits(jerk=60, acceleration=20, velocity=5)]
    >>> moves = atraj.synchronise(limits, [0, 0], [10, -1])
    >>> moves.position(moves.t)
    array([10., -1.])
    >>> x, y = moves
    >>> x.t == y.t == moves.t
    True"""
def synchronise_within(
    limits: _LimitsOfAxes,
    start: _States,
    end: _States,
    lowest: _Numbers,
    highest: _Numbers,
    *,
    duration: float = 0.0,
    cycle: float = 0.0,
) -> Moves:
    """Moves of several axes that arrive together, as `synchronise` plans them, but each axis stays between two positions until its end: its
    items of `lowest` and `highest`, where `-inf` and `inf` are no limits.

    An axis that would leave its positions on a slower way makes its fastest move and waits, or it stops, waits and goes, or it is slower
    between its turns at the positions. ValueError as for `Move.within`.

    >>> import atraj
    >>> limits = [atraj.Limits(jerk=30, acceleration=10, velocity=5)] * 2
    >>> start, end = [0, (9, 2)], [10, 8] # y turns
    >>> x, y = atraj.synchronise(limits, start, end)
    >>> round(y.extremes().highest.position, 4)
    9.4912
    >>> x, y = atraj.synchronise_within(limits, start, end, lowest=[0, 0], highest=[10, 9.49])
    >>> round(y.extremes().highest.position, 4)
    9.487"""
def line(
    limits: _LimitsOfAxes,
    start: _States,
    end: _States,
    *,
    duration: float = 0.0,
    cycle: float = 0.0,
) -> Moves:
    """Moves of several axes on the straight line from their start to their end: the fastest motion on it that lasts at least `duration`,
    s, and a multiple of `cycle`, s (0: any). ValueError also if velocities and accelerations do not point along the line.

    >>> import atraj
    >>> limits = [atraj.Limits(jerk=20, acceleration=4, velocity=1), atraj.Limits(jerk=10, acceleration=2, velocity=0.8)]
    >>> x, y = atraj.line(limits, [0, 0], [0.8, 0.4], cycle=0.001)
    >>> abs(x.position(0.5) - 2 * y.position(0.5)) < 1e-15
    True"""
def line_stop(limits: _LimitsOfAxes, moves: Moves, time: float) -> Moves:
    """Moves that stop on the straight line of `moves`, from their `time` on, s: a feed hold. The stop begins at its time 0.

    It is the fastest stop on the line within `limits`, an item for each axis, so no reserve is needed. `moves` are those of `line`, or others
    on one straight line: ValueError if they are not.

    >>> import atraj
    >>> limits = [atraj.Limits(jerk=20, acceleration=4, velocity=1), atraj.Limits(jerk=10, acceleration=2, velocity=0.8)]
    >>> moves = atraj.line(limits, [0, 0], [0.8, 0.4])
    >>> x, y = stop = atraj.line_stop(limits, moves, 0.5) # the button is pressed at 0.5 s
    >>> stop.velocity(stop.t)
    array([0., 0.])
    >>> abs(x.position(stop.t) - 2 * y.position(stop.t)) < 1e-15
    True"""
@final
class Path(Axes):
    """A motion of several axes through waypoints, without stops between them unless an axis must turn there: what `path` plans.
    It is a sequence of the `Moves` of its sections."""
    @property
    def times(self) -> _Array:
        """The times at which the points are passed, s, from 0 to `t`."""
    @property
    def deviation(self) -> float:
        """How far the path leaves the straight lines between its points, in the space of all axes: the largest distance, or up to 1 % more.

        >>> import atraj
        >>> limits = [atraj.Limits(jerk=30, acceleration=10, velocity=5)] * 2
        >>> round(atraj.path(limits, [[0, 0], [3, 1], [4, 5]]).deviation, 2)
        0.82"""
    @property
    def phases(self) -> list[list[Phase]]:
        """For each axis its phases of constant jerk, in order of time, each a `Phase`. Their starts are times of the path, s.

        >>> import atraj
        >>> limits = [atraj.Limits(jerk=30, acceleration=10, velocity=5)] * 2
        >>> x, y = atraj.path(limits, [[0, 0], [3, 1], [4, 5]]).phases
        >>> y[-1].jerk
        30.0"""
    def __len__(self) -> int: ...
    def __getitem__(self, section: int, /) -> Moves: ...
    def __iter__(self) -> Iterator[Moves]: ...
    def improve(self, *, steps: int = 0) -> Path:
        """A path through the same points that is not longer, from at most `steps` steps (0: as many as the path needs, at most 48).

        >>> import atraj
        >>> limits = [atraj.Limits(jerk=30, acceleration=10, velocity=5)] * 2
        >>> hasty = atraj.path(limits, [[0, 0], [3, 1], [4, 5]], steps=4)
        >>> hasty.improve().t < hasty.t
        True"""

def path(
    limits: _LimitsOfAxes | Sequence[_LimitsOfAxes],
    points: _Points,
    *,
    tolerances: _Tolerances | None = None,
    contour: float | None = None,
    feed: float | Sequence[float] | None = None,
    steps: int = 0,
) -> Path:
    """A fast path of several axes through points, which all axes pass at the same times. They stop nowhere between the first point and
    the last one unless they must.

    A point has a position for each axis, and `limits` has an item for each axis, or for each section a list of them. The path starts and ends
    at rest; the first and the last point may have a `State` in the place of a position. The planner takes at most `steps` steps (0: as many
    as the path needs, at most 48). ValueError says which point or axis is wrong.

    With `tolerances` the path passes the points between the first and the last one within fly-by zones: a number for each axis says how far its
    position may be from the given one, for all points or in a list for each of them. The path is not longer than the one through the points.

    With `contour` the path stays so near the straight lines between its points: points are added where it would leave them farther. With both,
    these are the lines between the points that it passes. `feed` is the highest speed of all axes together, or a list of one for each section.

    >>> import atraj
    >>> limits = [atraj.Limits(jerk=30, acceleration=10, velocity=5)] * 2
    >>> path = atraj.path(limits, [[0, 0], [3, 1], [4, 5]])
    >>> path.position(path.times)
    array([[0., 0.],
           [3., 1.],
           [4., 5.]])
    >>> bool((path.velocity(path.times[1]) > 1).all())
    True
    >>> near = atraj.path(limits, [[0, 0], [3, 1], [4, 5]], tolerances=[0, 0.1])
    >>> bool(near.t < path.t)
    True
    >>> part = atraj.path(limits, [[0, 0], [3, 1], [4, 5]], contour=0.01, feed=2)
    >>> bool(part.deviation <= 0.01 and part.t > path.t)
    True"""
@final
class Clock:
    """The clock of several axes: hold, override and reverse on their path.

    `Clock(limits, moves)` runs `Moves` or a `Path` by a time of its own, which runs as planned until `rate` changes it. So the axes never leave
    their path. The axes have the limits in `limits`, an item for each: those of the plan and a reserve, 10 to 20 % for example, because
    braking the time costs acceleration and jerk. ValueError says which limit is wrong.

    >>> import atraj
    >>> planned = [atraj.Limits(jerk=16, acceleration=4, velocity=0.8)] * 2
    >>> limits = [atraj.Limits(jerk=20, acceleration=5, velocity=1)] * 2
    >>> clock = atraj.Clock(limits, atraj.synchronise(planned, [0, 0], [0.8, -0.4]))
    >>> found = clock.rate(0.5, 0) # the button is pressed at 0.5 s
    >>> held = clock.until
    >>> bool((clock.velocity(held + 1) == 0).all())
    True
    >>> found = clock.rate(held + 2, 1) # and released
    >>> clock.position(10)
    array([ 0.8, -0.4])"""
    def __new__(cls, limits: _LimitsOfAxes, moves: Axes) -> Self: ...
    def __copy__(self) -> Self: ...
    def __deepcopy__(self, _memo: Any) -> Self: ...
    def rate(self, time: float, rate: float) -> Findings:
        """Goes to another rate from `time` on, s, which is not before the last change: 1 as planned, 0 hold, 0.5 half as fast, -1 back along
        the path. Until the end of the path, or until its start if the rate is negative, no axis exceeds its limits. `time` may be ahead: until then the
        clock goes on as it did. Returns `Findings`: RATE_NOT_REACHED if the path ends before. ValueError if no such change is found, `time` is before
        the last change, or a number is not finite; then the clock goes on as it did."""
    def rebase(self, time: float) -> None:
        """`time`, s, is 0 from now on. Times of many hours are rounded coarsely."""
    @property
    def until(self) -> float:
        """When the last rate is reached, s; the end of the path if it is not reached."""
    def time(self, time: float) -> float:
        """The time of the path at `time`, s. Until the first change it is `time`."""
    def position(self, time: float | _Times) -> _Array:
        """Positions at `time`, s, or a row of them for each of an array of times."""
    def velocity(self, time: float | _Times) -> _Array:
        """Velocities at `time`, s."""
    def acceleration(self, time: float | _Times) -> _Array:
        """Accelerations at `time`, s."""
    def jerk(self, time: float | _Times) -> _Array:
        """Jerks at `time`, s."""
    def state_at(self, time: float) -> list[State]:
        """The `State` of each axis at `time`, s."""
    def sample(self, dt: float, *, n: int, start: float = 0.0) -> Samples[_Real]:
        """`Samples` as of `Moves`, with the time `start + k*dt`, s. A clock that holds never ends, so `n` is needed."""

@final
class Group:
    """Several axes that follow one plan after another, as a machine does: in each cycle of a control loop `tick` gives the next setpoints, and
    between two ticks another motion may be planned.

    `Group(period, states)` has an axis for each of the `states`, and a tick every `period`, s. A plan starts from the states that the axes will
    have after `lead` ticks, and all axes take it over together, in this tick. No axis exceeds its limits, and nothing jumps. Each plan returns
    `Findings`, or ValueError says why it is refused, and the motion goes on. A group keeps the moves of its paths as long as it lives.

    >>> import atraj
    >>> limits = [atraj.Limits(jerk=20, acceleration=4, velocity=1)] * 2
    >>> planned = [atraj.Limits(jerk=17, acceleration=3.4, velocity=0.85)] * 2 # with a reserve for holds
    >>> cell = atraj.Group(0.002, [0, 0])
    >>> found = cell.line(planned, [0.8, 0.4])
    >>> for _ in range(300):
    ...     states = cell.tick()
    >>> found = cell.rate(limits, 0) # feed hold
    >>> while not cell.done:
    ...     states = cell.tick()
    >>> [state.velocity for state in states]
    [0.0, 0.0]
    >>> found = cell.rate(limits, 1) # and on
    >>> while not cell.done:
    ...     states = cell.tick()
    >>> [state.position for state in states]
    [0.8, 0.4]"""
    def __new__(cls, period: float, states: _States) -> Self: ...
    def __len__(self) -> int: ...
    def tick(self) -> list[State]:
        """The next setpoints: a `State` for each axis. Call it once in each cycle."""
    @property
    def done(self) -> bool:
        """Whether the motion is at its end, at the targets or in a hold, and no plan waits for its tick."""
    def within(self, lowest: _Numbers, highest: _Numbers) -> None:
        """Keeps each motion that is planned from now on between the positions: `lowest` and `highest` have an item for each axis, and `-inf` and `inf`
        are no limits. ValueError if the lowest is not below the highest. An axis that cannot stop between them stops as fast as it can."""
    def go(self, limits: _LimitsOfAxes, targets: _States, *, lead: int = 1) -> Findings:
        """Each axis goes to its state by its fastest move. `limits` and `targets` have an item for each axis."""
    def synchronise(self, limits: _LimitsOfAxes, targets: _States, *, lead: int = 1) -> Findings:
        """As `go`, but all axes arrive in the same tick."""
    def line(self, limits: _LimitsOfAxes, targets: _States, *, lead: int = 1) -> Findings:
        """As `go`, but on the straight line to the targets."""
    def path(self, limits: _LimitsOfAxes, path: Axes, *, begun: float = 0.0, lead: int = 1) -> Findings:
        """Follows a `Path` or `Moves` from their time `begun` on, s. The axes must be there: another path may take over while the axes move, if it
        has their states at this time."""
    def rate(self, limits: _LimitsOfAxes, rate: float, *, lead: int = 1) -> Findings:
        """Goes to another rate on the line or path: 1 as planned, 0 hold, 0.5 half as fast, -1 back. `limits` are those of the plan and a reserve.
        Where the axes rest, before a motion or after it, a hold has nothing to do, and 1 is RATE_NOT_REACHED."""
    def stop(self, limits: _LimitsOfAxes, *, lead: int = 1) -> Findings:
        """Stops on the line or path where that is not much slower, else each axis at once."""

@final
class Shaper:
    """An input shaper: a mean of a move at several times, which leaves little vibration at its frequencies.

    `Shaper(kind, frequency, damping=0)` is for a load that swings with this frequency, Hz, and this damping, a part of the critical one.
    A shaper never changes: `add` gives another one. `shape` gives the shaped motion, which keeps every limit of the move, starts and ends where
    the move does, and takes `duration` longer. ValueError says which number is wrong, or that there are more than 16 impulses.

    >>> import atraj
    >>> move = atraj.Move.plan(atraj.Limits(jerk=1000, acceleration=4, velocity=1), 0, 0.5)
    >>> shaper = atraj.Shaper(atraj.ShaperKind.ZVD, 5).add(atraj.ShaperKind.ZV, 12.5) # 5 Hz and 12.5 Hz
    >>> round(shaper.duration, 3)
    0.24
    >>> shaped = shaper.shape(move)
    >>> shaped.t == move.t + shaper.duration, shaped.position(shaped.t)
    (True, 0.5)"""
    def __new__(cls, kind: ShaperKind | int, frequency: float, damping: float = 0.0) -> Self: ...
    @staticmethod
    def smooth(time: float) -> Shaper:
        """A shaper without a frequency: the motion becomes its mean over this time, s. So its acceleration changes evenly, and the derivative of
        its jerk is at most twice the limit of the jerk, divided by the time. A time of 0 changes nothing. ValueError if the time is negative or
        not finite."""
    def add(self, kind: ShaperKind | int, frequency: float, damping: float = 0.0) -> Shaper:
        """This shaper for another frequency of the load too, as a new shaper. The impulses of both are multiplied."""
    @property
    def duration(self) -> float:
        """How much longer a shaped move takes, s."""
    def shape(self, move: Move | Bell) -> Shaped:
        """The shaped motion of a `Move` or a `Bell`, as a `Shaped`. TypeError for another motion."""
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Self: ...
    def __deepcopy__(self, _memo: Any) -> Self: ...

@final
class Shaped(Profile):
    """A shaped move: what `Shaper.shape` gives. Its jerk is NaN, because a shaper gives none, in C and Rust too. It keeps the limits of the
    move's jerk."""

@final
class Steps:
    """The steps of a motor that follows a move: an iterator over each `Step`, with its time, s, and its direction, 1 or -1.

    `Steps(move, offset, step)`: line `k` is the position `offset + k*step`. The motor stands at the line `count` while the axis is between this
    line and the next one. With an offset of half a step the motor is never farther than half a step from the axis. No step is lost, whatever is
    rounded. ValueError if `step` is not above 0, a number is not finite, or a position is too many steps away from the offset.

    >>> import atraj
    >>> move = atraj.Move.plan(atraj.Limits(jerk=3000, acceleration=200, velocity=50), 0, 10) # mm
    >>> steps = atraj.Steps(move, offset=0.00625, step=0.0125) # 80 steps per mm
    >>> pulses = list(steps)
    >>> pulses[0].direction, len(pulses), steps.count
    (1, 800, 799)"""
    def __new__(cls, move: Move, offset: float, step: float) -> Self: ...
    @property
    def count(self) -> int:
        """The line of the motor."""
    def follow(self, move: Move) -> None:
        """Goes on with another move from its start, and keeps the motor where it is. So no step is lost where the moves meet."""
    def __iter__(self) -> Self: ...
    def __next__(self) -> Step: ...
    def __copy__(self) -> Self: ...
    def __deepcopy__(self, _memo: Any) -> Self: ...

__version__: str
__all__ = [
    "Axes",
    "Bell",
    "BellFields",
    "Clock",
    "Extremes",
    "Findings",
    "Group",
    "Limits",
    "Move",
    "Moves",
    "Path",
    "Phase",
    "Poly3",
    "Poly5",
    "Poly7",
    "Profile",
    "Samples",
    "Shaped",
    "Shaper",
    "ShaperKind",
    "State",
    "Step",
    "Steps",
    "Trap",
    "TrapFields",
    "line",
    "line_stop",
    "path",
    "synchronise",
    "synchronise_within",
]
