from collections.abc import Sequence
from typing import Any, Self, TypeAlias, final, overload

import numpy as np
import numpy.typing as npt
from matplotlib.figure import Figure
from typing_extensions import disjoint_base

from .values import BellFields as BellFields
from .values import Extremes as Extremes
from .values import Findings as Findings
from .values import Limits as Limits
from .values import Phase as Phase
from .values import Samples as Samples
from .values import State as State
from .values import TrapFields as TrapFields

_Real: TypeAlias = np.float64
_Array: TypeAlias = npt.NDArray[_Real]
_Times: TypeAlias = Sequence[float] | npt.NDArray[Any]
_Out: TypeAlias = Samples[_Real] | tuple[_Array | None, _Array | None, _Array | None, _Array | None, _Array | None]
_State: TypeAlias = State | tuple[float, float, float]
_Limits: TypeAlias = Limits | tuple[float, float, float, float, float, float]
_Points: TypeAlias = Sequence[Sequence[float | _State] | npt.NDArray[Any]] | npt.NDArray[Any]

@disjoint_base
class Profile:
    @property
    def t(self) -> float: ...
    @overload
    def position(self, x: float) -> float: ...
    @overload
    def position(self, x: _Times) -> _Array: ...
    @overload
    def velocity(self, x: float) -> float: ...
    @overload
    def velocity(self, x: _Times) -> _Array: ...
    @overload
    def acceleration(self, x: float) -> float: ...
    @overload
    def acceleration(self, x: _Times) -> _Array: ...
    @overload
    def jerk(self, x: float) -> float: ...
    @overload
    def jerk(self, x: _Times) -> _Array: ...
    def state_at(self, x: float) -> State: ...
    def extremes(self) -> Extremes: ...
    def sample(
        self, dt: float | None = None, *, n: int | None = None, start: float = 0.0, out: _Out | None = None
    ) -> Samples[_Real]: ...
    def plot(self) -> Figure: ...

@final
class Bell(Profile):
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
    ) -> Bell: ...
    @staticmethod
    def from_fields(fields: BellFields | Sequence[float]) -> Bell: ...
    @property
    def fields(self) -> BellFields: ...
    def check(self, jerk: float, acceleration: float, velocity: float) -> Findings: ...

@final
class Trap(Profile):
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
    ) -> Trap: ...
    @staticmethod
    def from_fields(fields: TrapFields | Sequence[float]) -> Trap: ...
    @property
    def fields(self) -> TrapFields: ...
    def check(self, velocity: float, ac: float, de: float) -> Findings: ...

@final
class Poly3(Profile):
    def __new__(cls, t: float, p0: float, p1: float, v0: float = 0.0, v1: float = 0.0) -> Self: ...
    @staticmethod
    def from_coefficients(t: float, c: Sequence[float]) -> Poly3: ...
    @property
    def c(self) -> tuple[float, float, float, float]: ...

@final
class Poly5(Profile):
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
    def from_coefficients(t: float, c: Sequence[float]) -> Poly5: ...
    @property
    def c(self) -> tuple[float, float, float, float, float, float]: ...

@final
class Poly7(Profile):
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
    def from_coefficients(t: float, c: Sequence[float]) -> Poly7: ...
    @property
    def c(self) -> tuple[float, float, float, float, float, float, float, float]: ...

@final
class Move(Profile):
    @staticmethod
    def plan(limits: _Limits, start: _State, end: _State) -> Move: ...
    @staticmethod
    def within(limits: _Limits, start: _State, end: _State, lowest: float, highest: float) -> Move: ...
    @staticmethod
    def reach(limits: _Limits, start: _State, velocity: float, acceleration: float = 0.0) -> Move: ...
    @staticmethod
    def stop(limits: _Limits, start: _State) -> Move: ...
    @staticmethod
    def meet(limits: _Limits, start: _State, target: _State) -> Move: ...
    @staticmethod
    def track(limits: _Limits, start: _State, signal: _State, horizon: float) -> Move: ...
    def check(self, limits: _Limits) -> Findings: ...
    def time_at(self, position: float) -> float | None: ...
    @property
    def findings(self) -> Findings: ...
    @property
    def phases(self) -> list[Phase]: ...

def synchronise(
    limits: Sequence[_Limits],
    start: Sequence[_State],
    end: Sequence[_State],
    *,
    duration: float = 0.0,
    cycle: float = 0.0,
) -> list[Move]: ...
def line(
    limits: Sequence[_Limits],
    start: Sequence[_State],
    end: Sequence[_State],
    *,
    duration: float = 0.0,
    cycle: float = 0.0,
) -> list[Move]: ...
@final
class Path:
    @property
    def t(self) -> float: ...
    @property
    def times(self) -> _Array: ...
    @property
    def findings(self) -> Findings: ...
    def position(self, x: float | _Times) -> _Array: ...
    def velocity(self, x: float | _Times) -> _Array: ...
    def acceleration(self, x: float | _Times) -> _Array: ...
    def jerk(self, x: float | _Times) -> _Array: ...
    def state_at(self, x: float) -> list[State]: ...
    def sample(self, dt: float | None = None, *, n: int | None = None, start: float = 0.0) -> Samples[_Real]: ...
    def improve(self, *, steps: int = 0) -> Path: ...
    def plot(self) -> Figure: ...

def path(
    points: _Points, limits: Sequence[_Limits] | Sequence[Sequence[_Limits]], *, steps: int = 0
) -> Path: ...

__version__: str
__all__ = [
    "Bell",
    "BellFields",
    "Extremes",
    "Findings",
    "Limits",
    "Move",
    "Path",
    "Phase",
    "Poly3",
    "Poly5",
    "Poly7",
    "Profile",
    "Samples",
    "State",
    "Trap",
    "TrapFields",
    "line",
    "path",
    "synchronise",
]
