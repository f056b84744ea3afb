"""Motion profiles with the bits of the C library liba, and the fastest moves from any state to any state.

>>> import atraj
>>> move = atraj.Bell(jerk=30, acceleration=10, velocity=5, p0=0, p1=10)
>>> move.t, move.position(1.0)
(2.833333333333333, 2.916666666666667)
>>> move.position([0.0, 1.0, 2.0]) # an array of times gives an array
array([0.        , 2.91666667, 7.91666667])
>>> t, p, v, a, j = move.sample(dt=0.001)
>>> move.plot().savefig("move.svg") # doctest: +SKIP

Times are in seconds since the start of a motion. Positions have any unit of length or angle, and the other quantities follow from
it: m, m/s, m/s², m/s³. The classes here compute in binary64, the classes of the same names in `atraj.f32` in binary32.
Arguments have one order: limits first, then where a motion starts and where it goes. `atraj.claraty` holds CLARAty's trajectory. What
cannot be planned raises ValueError.
"""

from importlib.metadata import version

from . import claraty, f32
from ._atraj import f64
from .values import (
    BellFields,
    Extremes,
    Findings,
    Limits,
    Phase,
    Samples,
    ShaperKind,
    State,
    Step,
    TrapFields,
)

Profile = f64.Profile
Bell = f64.Bell
Trap = f64.Trap
Poly3 = f64.Poly3
Poly5 = f64.Poly5
Poly7 = f64.Poly7
Move = f64.Move
Axes = f64.Axes
Moves = f64.Moves
synchronise = f64.synchronise
synchronise_within = f64.synchronise_within
line = f64.line
line_stop = f64.line_stop
Path = f64.Path
path = f64.path
Clock = f64.Clock
Group = f64.Group
Shaper = f64.Shaper
Shaped = f64.Shaped
Steps = f64.Steps
del f64

__version__ = version("atraj")
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
