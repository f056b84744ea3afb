"""What a type checker must accept, and infer."""

import numpy as np
import numpy.typing as npt
from typing_extensions import assert_type

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
moves = atraj.synchronise([(5, -5, 10, -10, 30, -30)] * 2, [0, (1, 2)], np.zeros(2))
assert_type(moves[0], atraj.Move)
assert_type([axis.t for axis in moves], list[float])
assert_type(atraj.synchronise_within([(5, -5, 10, -10, 30, -30)] * 2, [0, 1], [1, 0], [0, 0], np.ones(2), cycle=0.001), atraj.Moves)
assert_type(atraj.line_stop(np.zeros((2, 6)), moves, 0.5), atraj.Moves)
assert_type(atraj.Clock(np.zeros((2, 6)), moves).state_at(0.1), list[atraj.State])
assert_type(atraj.Shaper(atraj.ShaperKind.ZV, 5).shape(move).state_at(0.1), atraj.State)
assert_type(next(atraj.Steps(move, 0, 1)).direction, int)
path = atraj.f32.path([atraj.Limits.symmetric(30, 10, 5)], np.zeros((3, 1)))
assert_type(path.position(0.5), npt.NDArray[np.float32])
assert_type(path.sample(0.1).p, npt.NDArray[np.float32])
assert_type(atraj.path([(5, -5, 10, -10, 30, -30)], [path.state_at(0.5), [1]], steps=20).t, float)
