"""Does sampling from Python cost more than the call of the C function, and planning more than Ruckig's?"""

import ctypes
import random
import time
from pathlib import Path

import numpy as np
import pytest
import ruckig

import atraj

LIBRARY = Path(__file__).parents[2] / "target/dist/lib/libatraj.so"
SAMPLES = 1_000_000
ROUNDS = 60
MOST = 1.2  # times the C call


def c_function(move):
    """The C function that samples this bell from time 0 on into arrays."""
    sample = ctypes.CDLL(str(LIBRARY)).atraj_bell_sample
    sample.restype = ctypes.c_size_t
    sample.argtypes = [ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_size_t, *[ctypes.c_void_p] * 4]
    struct = (ctypes.c_double * len(move.fields))(*move.fields)

    def call(dt, arrays):
        return sample(struct, 0.0, dt, SAMPLES, *[array.ctypes.data for array in arrays])

    return call


def fastest(*calls):
    """The shortest time of each call, s. The calls take turns, so a busy machine slows all of them."""
    times = [[] for _ in calls]
    for _ in range(ROUNDS):
        for call, taken in zip(calls, times):
            start = time.perf_counter()
            call()
            taken.append(time.perf_counter() - start)
    return [min(taken) for taken in times]


def test_a_million_samples():
    move = atraj.Bell(30, 10, 5, 0, 10)
    dt = move.t / (SAMPLES - 1)
    c_arrays = [np.zeros(SAMPLES) for _ in range(4)]
    arrays = [np.zeros(SAMPLES) for _ in range(5)]
    some, all_five = atraj.Samples(None, *arrays[1:]), atraj.Samples(*arrays)
    in_c = c_function(move)
    c, c_fresh, python, with_times, fresh = fastest(
        lambda: in_c(dt, c_arrays),
        lambda: in_c(dt, [np.zeros(SAMPLES) for _ in range(4)]),
        lambda: move.sample(dt, out=some),
        lambda: move.sample(dt, out=all_five),
        lambda: move.sample(dt, n=SAMPLES),
    )
    for ours, theirs in zip(arrays[1:], c_arrays):
        assert np.array_equal(ours.view("u8"), theirs.view("u8"))
    print(f"a million samples: C {1e3 * c:.2f} ms, into fresh arrays {c_fresh / c:.2f} times as long;")
    print(f"Python {python / c:.2f}, with times {with_times / c:.2f}, with times into fresh arrays {fresh / c:.2f}")
    assert python <= MOST * c


MOST_OF_A_MOVE = 2  # times the positions of one axis


def test_positions_of_a_path():
    limits = [atraj.Limits(jerk=60000, acceleration=3000, velocity=100)] * 2
    turns = np.linspace(0, 2 * np.pi, 101)
    path = atraj.path(limits, np.stack([50 * np.cos(turns), 50 * np.sin(turns)], 1).tolist())
    move, times = atraj.Move.plan(limits[0], 0, 50), np.linspace(0, 1, SAMPLES)
    of_path, of_move = fastest(lambda: path.position(path.t * times), lambda: move.position(move.t * times))
    of_path, of_move = of_path / (2 * SAMPLES), of_move / SAMPLES
    print(f"positions of a path of 100 sections: {1e9 * of_path:.1f} ns a number, {of_path / of_move:.2f} times those of a move")
    assert of_path <= MOST_OF_A_MOVE * of_move


PROBLEMS = 500
MOST_OF_RUCKIG = 1.5  # times its calculation alone, whose input is there before, or its state


def problems(axes):
    """The same problems for both: the axes are in motion, and the targets at rest."""
    chance = random.Random(axes)
    limits = [atraj.Limits(jerk=30, acceleration=10, velocity=5)] * axes
    for _ in range(PROBLEMS):
        start = [(chance.uniform(-5, 5), chance.uniform(-2, 2), chance.uniform(-2, 2)) for _ in limits]
        end = [chance.uniform(-5, 5) for _ in limits]
        given = ruckig.InputParameter(axes)
        given.max_velocity, given.max_acceleration, given.max_jerk = [5] * axes, [10] * axes, [30] * axes
        given.current_position, given.current_velocity, given.current_acceleration = map(list, zip(*start))
        given.target_position = end
        yield limits, start, end, given


@pytest.mark.parametrize("axes", [1, 3])
def test_plans_next_to_ruckig(axes):
    otg, trajectory, given = ruckig.Ruckig(axes), ruckig.Trajectory(axes), list(problems(axes))
    plan = atraj.synchronise

    def ours():
        if axes == 1:
            for (limits,), (start,), (end,), _ in given:
                atraj.Move.plan(limits, start, end)
        else:
            for limits, start, end, _ in given:
                plan(limits, start, end)

    def theirs():
        for *_, problem in given:
            otg.calculate(problem, trajectory)

    mine, other = (taken / PROBLEMS for taken in fastest(ours, theirs))
    print(f"plan of {axes}: {1e6 * mine:.2f} µs, Ruckig {ruckig.__version__} {1e6 * other:.2f} µs, {mine / other:.2f} times as long")
    assert mine <= MOST_OF_RUCKIG * other


def test_a_state():
    move, calls = atraj.Move.plan(atraj.Limits(jerk=30, acceleration=10, velocity=5), 0, 10), range(1000)
    (limits, start, end, problem), *_ = problems(1)
    trajectory = ruckig.Trajectory(1)
    ruckig.Ruckig(1).calculate(problem, trajectory)
    state_at, at_time = move.state_at, trajectory.at_time
    ours, theirs = lambda: [state_at(0.7) for _ in calls], lambda: [at_time(0.7) for _ in calls]
    mine, other = (taken / len(calls) for taken in fastest(ours, theirs))
    print(f"state_at: {1e9 * mine:.0f} ns, Ruckig {ruckig.__version__} {1e9 * other:.0f} ns")
    assert mine <= MOST_OF_RUCKIG * other


def test_positions_of_several_axes():
    limits, calls = [atraj.Limits(jerk=30, acceleration=10, velocity=5)] * 3, range(1000)
    path = atraj.path(limits, [[0, 0, 0], [3, 1, 2], [4, 5, 6]])
    position, state_at = path.position, path.state_at
    row, states = (
        taken / len(calls)
        for taken in fastest(lambda: [position(0.7) for _ in calls], lambda: [state_at(0.7) for _ in calls])
    )
    print(f"positions of three axes: {1e6 * row:.2f} µs, their states {1e6 * states:.2f} µs")
    assert row <= states
