"""The classes and functions of `atraj` in binary32: the bits of a controller that computes in `float`.

Floats go in and come out, and are rounded on the way in. Arrays are of `numpy.float32`.

>>> import atraj
>>> atraj.f32.Bell(30, 10, 5, 0, 10).sample(n=3).p
array([ 0.,  5., 10.], dtype=float32)
"""

from ._atraj import f32

Profile = f32.Profile
Bell = f32.Bell
Trap = f32.Trap
Poly3 = f32.Poly3
Poly5 = f32.Poly5
Poly7 = f32.Poly7
Move = f32.Move
Axes = f32.Axes
Moves = f32.Moves
synchronise = f32.synchronise
synchronise_within = f32.synchronise_within
line = f32.line
line_stop = f32.line_stop
Path = f32.Path
path = f32.path
Clock = f32.Clock
Group = f32.Group
Shaper = f32.Shaper
Shaped = f32.Shaped
Steps = f32.Steps
del f32

__all__ = [
    "Axes",
    "Bell",
    "Clock",
    "Group",
    "Move",
    "Moves",
    "Path",
    "Poly3",
    "Poly5",
    "Poly7",
    "Profile",
    "Shaped",
    "Shaper",
    "Steps",
    "Trap",
    "line",
    "line_stop",
    "path",
    "synchronise",
    "synchronise_within",
]
