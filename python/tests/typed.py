"""What a type checker must accept, and infer."""

from typing import assert_type

import numpy as np
import numpy.typing as npt

import atraj
import atraj.f32
from atraj.claraty import Mode, Trajectory

move = atraj.Move.plan(atraj.Limits.symmetric(30, 10, 5), atraj.State(0), (1, 0, 0))
assert_type(move.position(0.5), float)
assert_type(move.position([0.5, 1]), npt.NDArray[np.float64])
assert_type(move.sample(0.1).v, npt.NDArray[np.float64])
assert_type(atraj.f32.Bell(30, 10, 5, 0, 10).sample(n=3).j, npt.NDArray[np.float32])
assert_type(move.findings, atraj.Findings)
assert_type(Trajectory(Mode.LISTING).setpoint(0), atraj.State)
path = atraj.f32.path(np.zeros((3, 1)), [atraj.Limits.symmetric(30, 10, 5)])
assert_type(path.position(0.5), npt.NDArray[np.float32])
assert_type(path.sample(0.1).p, npt.NDArray[np.float32])
assert_type(atraj.path([path.state_at(0.5), [1]], [(5, -5, 10, -10, 30, -30)], steps=20).t, float)
