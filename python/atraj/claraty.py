"""CLARAty's trapezoid, retargeted in motion."""

from ._atraj import claraty
from .values import Mode, TrapezoidalProfile, Warnings

Trajectory = claraty.Trajectory
del claraty

__all__ = ["Mode", "Trajectory", "TrapezoidalProfile", "Warnings"]
