"""Does sampling from Python cost more than the call of the C function?"""

import ctypes
import time
from pathlib import Path

import numpy as np

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
