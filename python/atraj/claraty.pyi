from typing import Any, Literal, final

from typing_extensions import Self

from .values import Mode as Mode
from .values import State
from .values import TrapezoidalProfile as TrapezoidalProfile
from .values import Warnings as Warnings

@final
class Trajectory:
    """CLARAty's trapezoid: a target, start and stop at any time, and a setpoint whenever the controller asks.

    `now` is a reading of one clock, s, `time.monotonic()` for example. Nothing here reads a clock. `mode` is the `Mode` of the starts and
    stops: `Mode.CORRECTED` keeps the promise of CLARAty's class, `Mode.LISTING` gives the bits of the published listing. ValueError for
    another number. Waypoints are in Rust and C only.

    >>> from atraj.claraty import Trajectory
    >>> axis = Trajectory()
    >>> axis.set(position=10, velocity=2, acceleration=4, deceleration=4, now=0)
    >>> axis.start(now=0), axis.duration
    (<Warnings: 0>, 5.5)
    >>> axis.setpoint(now=3)
    State(position=5.5, velocity=2.0, acceleration=0.0)
    >>> axis.stop(now=3) # brakes from here
    <Warnings: 0>
    >>> axis.setpoint(now=3.5).position
    6.0"""
    def __new__(cls, mode: Mode | Literal[0, 1] = 0, *, now: float = 0.0) -> Self: ...
    @property
    def mode(self) -> Mode:
        """The `Mode` of the following starts and stops. It can be set."""
    @mode.setter
    def mode(self, mode: Mode | Literal[0, 1]) -> None: ...
    @property
    def motion_mode(self) -> Mode:
        """The `Mode` of the motion under way."""
    def set(self, position: float, velocity: float, acceleration: float, deceleration: float, now: float) -> None:
        """Stores where to go next, and the limits on the way, whose signs are ignored. Nothing moves before `start`. ValueError if a
        number is larger than 1e60, or is not a number; then the trajectory stays as it was."""
    def start(self, now: float) -> Warnings:
        """Sets off with the timer at zero, from the setpoint if a motion is under way, else from rest at 0. The result is the
        `Warnings` of the plan."""
    def stop(self, now: float) -> Warnings:
        """Brakes a motion under way. The result is the `Warnings` of the plan."""
    def reset(self, now: float) -> None:
        """Forgets the motion and sets the timer to zero."""
    @property
    def is_started(self) -> bool:
        """Whether a motion is under way: from the start until a setpoint after the end has been read."""
    def elapsed(self, now: float) -> float:
        """Time since the last start, stop or reset, s."""
    def advance_timer_by(self, seconds: float) -> None:
        """Adds seconds to what the clock shows."""
    def change_clock(self, now: float, instead: float) -> None:
        """Another clock, which shows `instead`, replaces the clock that shows `now`. A motion under way goes on where it is."""
    @property
    def duration(self) -> float:
        """Time from the start to rest, s; 0 before the first start."""
    @property
    def profile(self) -> TrapezoidalProfile:
        """The `TrapezoidalProfile` of the last start or stop."""
    @property
    def is_trapezoidal(self) -> bool:
        """Whether the last start or stop cruises at its maximum velocity."""
    def setpoint(self, now: float) -> State:
        """The setpoint now, a `State`. A reading after the end of the motion ends the motion."""
    def __copy__(self) -> Self: ...
    def __deepcopy__(self, _memo: Any) -> Self: ...
    def setpoint_at(self, t: float) -> State:
        """The setpoint at the time `t` after the start, s, a `State`. In a motion of the listing a look beyond the end ends the motion."""

__all__ = ["Mode", "Trajectory", "TrapezoidalProfile", "Warnings"]
