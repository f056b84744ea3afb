"""Do the classes take and give what their documentation says, and say what is wrong with bad arguments?"""

import copy
import csv
import inspect
import math
import operator
import pickle
import subprocess
import sys

import numpy as np
import pytest
from golden import DIRECTORY
from refused import assert_refused

import atraj
from atraj.claraty import Trajectory, Warnings

LIMITS = atraj.Limits.symmetric(jerk=30, acceleration=10, velocity=5)
QUANTITIES = ["position", "velocity", "acceleration", "jerk"]


def profiles(module):
    return [
        module.Bell(30, 10, 5, 0, 10),
        module.Trap(5, 4, -2, 0, 50),
        module.Poly3(8, 0, 10),
        module.Poly5(8, 0, 10, a0=1),
        module.Poly7(8, 0, 10, j1=1),
        module.Move.plan(LIMITS, atraj.State(0, 1, 2), atraj.State(-1)),
    ]


def test_version():
    manifest = (DIRECTORY.parents[1] / "Cargo.toml").read_text()
    assert f'\nversion = "{atraj.__version__}"\n' in manifest


def test_each_name_of_the_table_is_there():
    """`tests/do_names_agree.rs` asks whether the others have the same names."""
    with open(DIRECTORY.parent / "names.csv") as table:
        names = [row["Python"] for row in csv.DictReader(table) if row["Python"]]
    assert len(operator.attrgetter(*names)(atraj)) > 40


def test_one_import_brings_all():
    program = "import atraj; print(atraj.f32.Move.__module__, atraj.claraty.Trajectory.__module__)"
    printed = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout
    assert printed == "atraj.f32 atraj.claraty\n"


def test_times_have_any_shape_and_type(real):
    for profile in profiles(real.module):
        assert isinstance(profile, real.module.Profile)
        one, two = profile.position(1.0), profile.position(2.0)
        assert type(one) is float
        assert profile.position(1) == profile.position(np.int64(1)) == profile.position(np.float32(1)) == one
        for times in [[1, 2], (1.0, 2.0), np.array([1, 2]), np.array([1, 2], np.float32), np.array([1.0, 9, 2])[::2]]:
            values = profile.position(times)
            assert values.dtype == real.dtype and values.tolist() == [one, two]
        square = profile.position(np.array([[1.0, 2.0], [2.0, 1.0]]))
        assert square.tolist() == [[one, two], [two, one]]
        assert profile.position(np.array([1.0])).shape == (1,) and profile.position(np.array(1.0)).shape == ()
        assert profile.position([]).shape == (0,)


def layouts(dtype):
    """The times 0.5, 1, 1.5 and 2 in the layouts that NumPy knows, and a stride of 0 too."""
    times = np.array([0.5, 1, 1.5, 2], dtype)
    size = times.itemsize
    records = np.zeros(4, [("id", "u1"), ("t", dtype)])
    records["t"] = times
    unaligned = np.frombuffer(b"x" + times.tobytes(), dtype, offset=1)
    objects = times.astype(object)
    yield from [times, times[::-1], times.repeat(3)[::3], times.reshape(2, 2).T, np.broadcast_to(times[:1], 3)]
    yield from [records["t"], records["t"][::-1], records["t"][::2], records["t"].reshape(2, 2).T, records["t"][:1]]
    yield from [unaligned, unaligned[::-1], memoryview(records["t"]), memoryview(unaligned)]
    yield from [times.astype(f">f{size}"), times.astype(f"<f{size}"), objects, objects[::-1]]


def test_times_have_any_layout(real):
    for profile in profiles(real.module):
        for times in layouts(real.dtype):
            expected = np.vectorize(profile.position, otypes=[real.dtype])(np.array(times, float))
            values = profile.position(times)
            assert values.dtype == real.dtype and values.tolist() == expected.tolist(), times


def test_numbers_of_records_have_any_type(real):
    for dtype in ["i1", "u2", ">i4", "i8", ">f2", "f4", ">f8", "O", "?"]:
        records = np.zeros(2, [("id", "S3"), ("t", dtype)])
        records["t"] = [0, 1]
        for profile in profiles(real.module):
            values = profile.position(records["t"])
            assert values.dtype == real.dtype and values.tolist() == [profile.position(0), profile.position(1)], dtype


def test_complex_numbers_are_refused(real):
    for times in [np.array([0.5j]), [0.5, 1j]]:
        with pytest.raises(TypeError, match="complex"):
            real.module.Bell(30, 10, 5, 0, 10).position(times)


def test_errors_name_the_class():
    with pytest.raises(TypeError, match="'atraj.Move'"):
        atraj.Move()


def test_no_times_give_no_values(real):
    records = np.zeros((0, 2), [("id", "u1"), ("t", real.dtype)])
    for times in [records["t"], records["t"][::-1], records["t"].T]:
        values = real.module.Bell(30, 10, 5, 0, 10).position(times)
        assert values.shape == times.shape and values.dtype == real.dtype


def test_masks_are_not_looked_at(real):
    bell = real.module.Bell(30, 10, 5, 0, 10)
    times = np.ma.array([0.5, 1], real.dtype, mask=[True, False])
    values = bell.position(times)
    assert type(values) is np.ndarray and values.tolist() == [bell.position(0.5), bell.position(1)]
    samples = bell.sample(0.5, start=0.5, out=(times, None, None, None, None))
    assert samples.t is times and times.data.tolist() == [0.5, 1] and times.mask.tolist() == [True, False]


def test_samples_have_the_bits_of_single_calls(real):
    for profile in profiles(real.module):
        samples = profile.sample(0.01, start=-0.1)
        assert samples.t[0] == real.dtype(-0.1) and samples.t[-2] < profile.t <= samples.t[-1]
        for quantity, values in zip(QUANTITIES, samples[1:]):
            assert values.dtype == real.dtype
            assert real.bits(values) == real.bits(getattr(profile, quantity)(samples.t)), quantity


def test_number_of_samples():
    move = atraj.Poly3(2, 0, 10)
    assert move.sample(0.5).t.tolist() == [0, 0.5, 1, 1.5, 2]
    assert move.sample(0.75).t.tolist() == [0, 0.75, 1.5, 2.25]
    assert move.sample(n=3).t.tolist() == [0, 1, 2]
    assert move.sample(n=3, start=1).t.tolist() == [1, 1.5, 2]
    assert move.sample(-0.5, n=2, start=1).t.tolist() == [1, 0.5]
    assert move.sample(0.5, start=5).t.tolist() == [5]
    assert move.sample(n=1).t.tolist() == [0] and move.sample(n=0).t.tolist() == []


def test_samples_go_into_given_arrays():
    move = atraj.Bell(30, 10, 5, 0, 10)
    out = atraj.Samples(*np.full((5, 100), 7.0))
    samples = move.sample(0.01, out=out)
    assert all(given is filled for given, filled in zip(out, samples))
    for given, fresh in zip(out, move.sample(0.01, n=100)):
        assert np.array_equal(given, fresh)
    some = move.sample(n=100, out=(None, None, out.v, None, None))
    assert [array is None for array in some] == [True, True, False, True, True]
    assert np.array_equal(out.v, move.sample(n=100).v)


def test_bad_arrays_are_refused():
    move = atraj.Bell(30, 10, 5, 0, 10)
    array, frozen = np.full(4, 7.0), np.zeros(4)
    frozen.flags.writeable = False
    records = np.zeros(4, [("id", "u1"), ("p", "f8")])
    unaligned = np.frombuffer(bytearray(33), offset=1)

    def refused(raised, message, *arrays, **choices):
        with pytest.raises(raised, match=message):
            move.sample(0.1, out=(*arrays, *[None] * (5 - len(arrays))), **choices)

    refused(ValueError, "differ in length", array, np.zeros(5))
    refused(ValueError, "differ in length", array, n=5)
    refused(TypeError, "already borrowed", array, array)
    refused(TypeError, "not writeable", frozen)
    for layout in [np.zeros(8)[::2], np.zeros(4)[::-1], records["p"], unaligned]:
        refused(ValueError, "contiguous and aligned", array, layout)
    refused(TypeError, "float32", np.zeros(4, np.float32))
    refused(TypeError, ">f8", np.zeros(4, ">f8"))
    refused(TypeError, "dimension", np.zeros((2, 2)))
    assert array.tolist() == [7] * 4


def test_bad_requests_are_refused():
    assert_refused("sample", bell=atraj.Bell(30, 10, 5, 0, 10))


def test_extremes_and_states(real):
    bell = real.module.Bell(30, 10, 5, 0, 10)
    lowest, highest = bell.extremes()
    assert (lowest.position, highest.position, lowest.velocity, highest.velocity) == (0, 10, 0, 5)
    assert bell.state_at(bell.t) == atraj.State(10)
    quintic = real.module.Poly5(8, 0, 10)
    assert quintic.extremes().highest.velocity == pytest.approx(quintic.velocity(4))


def test_check():
    plan = atraj.Bell(30, 2.5, 10, p0=0, p1=10, v0=7.5)
    assert plan.check(30, 2.5, 10) == atraj.Findings.EXCEEDS_ACCELERATION
    assert atraj.Bell.from_fields(plan.fields).fields == plan.fields
    jump = atraj.Bell.from_fields(plan.fields._replace(p1=11))
    assert atraj.Findings.JUMPS in jump.check(30, 2.5, 10)
    trap = atraj.Trap(5, 4, -2, 0, 50)
    assert trap.check(5, 4, -2) == atraj.Findings(0) and trap.check(4, 4, -2) == atraj.Findings.EXCEEDS_VELOCITY
    with pytest.raises(ValueError, match="infinite or not a number"):
        atraj.Bell.from_fields([math.nan] * 14).check(1, 1, 1)


def test_fastest_plans_where_liba_fails(real):
    for family, limits in [(real.module.Bell, (30, 10, 5)), (real.module.Trap, (5, 10, -10))]:
        with pytest.raises(ValueError, match="no such move within the limits"):
            family(*limits, 0, 0)
        move = family.fastest(*limits, p0=0, p1=0.1, v0=2)
        assert move.position(move.t) == real.dtype(0.1) and atraj.Findings.OVERSHOOTS == move.check(*limits)
        with pytest.raises(ValueError, match="^p1 = NaN is infinite or not a number"):
            family.fastest(*limits, 0, math.nan)


def test_an_axis_is_retargeted(real):
    axis = real.module.Move
    move = axis.plan(LIMITS, atraj.State(0), (10, 0, 0))
    now = move.state_at(0.7)
    for other, end in [
        (axis.plan(LIMITS, now, atraj.State(-2)), (-2, 0, 0)),
        (axis.reach(LIMITS, now, 1), (None, 1, 0)),
        (axis.stop(LIMITS, now), (None, 0, 0)),
    ]:
        assert other.state_at(0) == now
        assert all(wanted in (None, reached) for wanted, reached in zip(end, other.state_at(other.t)))
        assert len(other.phases) > 1 and other.phases[-1].start + other.phases[-1].duration == pytest.approx(other.t)
    target = atraj.State(3, 0.5)
    assert axis.within(LIMITS, now, target, -9, 9).t == axis.plan(LIMITS, now, target).t
    assert not move.check(LIMITS) and move.check(atraj.Limits.symmetric(1e-3, 10, 5)) == atraj.Findings.EXCEEDS_JERK
    with pytest.raises(ValueError, match="leaves the positions"):
        axis.within(LIMITS, now, target, -9, target[0] - 0.1)
    assert axis.track(LIMITS, target, target, 0, 0.125).t == 0.125
    meeting = axis.meet(LIMITS, now, target)
    reached = meeting.state_at(meeting.t)
    assert reached.velocity == 0.5 and reached.position == pytest.approx(3 + 0.5 * meeting.t)
    assert move.position(move.time_at(4)) == pytest.approx(4) and move.time_at(11) is None


def test_axes_move_together(real):
    limits = [LIMITS, atraj.Limits.symmetric(60, 20, 5)]
    start, end = [atraj.State(0), atraj.State(1)], [atraj.State(10), atraj.State(-1)]
    for plan in [real.module.synchronise, real.module.line]:
        x, y = plan(limits, start, end, duration=3, cycle=0.25)
        assert x.t == y.t == 3 and (x.position(3), y.position(3)) == (10, -1)
    times = np.linspace(0, 3, 50)
    np.testing.assert_allclose(y.position(times), 1 - 0.2 * x.position(times), atol=1e-5)


def test_axes_stay_between_their_positions(real):
    limits, start, end = [LIMITS] * 2, [0, (9, 2)], [10, 8]
    lowest, highest = np.array([-math.inf, 8]), [math.inf, 9.49]
    assert real.module.synchronise(limits, start, end)[1].extremes().highest.position > 9.49
    for times in [{}, {"duration": 5, "cycle": 0.25}]:
        moves = real.module.synchronise_within(limits, start, end, lowest, highest, **times)
        assert isinstance(moves, real.module.Moves) and moves.t == (5 if times else moves[0].t)
        assert moves.state_at(0) == [atraj.State(0), atraj.State(9, 2)] and moves.state_at(moves.t) == [atraj.State(10), atraj.State(8)]
        below, above = moves[1].extremes()
        assert 8 <= below.position and above.position <= 9.49
        # The second axis turns.
        turns = atraj.Findings.OVERSHOOTS
        assert moves.findings == turns and [axis.check(LIMITS) for axis in moves] == [atraj.Findings(0), turns]
    everywhere = [-math.inf] * 2, [math.inf] * 2
    assert real.module.synchronise_within(limits, start, end, *everywhere) == real.module.synchronise(limits, start, end)


def test_axes_stop_on_their_line(real):
    limits, rounding = [LIMITS, atraj.Limits.symmetric(60, 20, 0.5)], 1e-5 if real.dtype == np.float32 else 1e-12
    moves = real.module.line(limits, [0, 1], [10, -1])
    for x in [0.1, 1.5, float(moves.t) - 0.1]:
        stop = real.module.line_stop(limits, moves, x)
        assert isinstance(stop, real.module.Moves) and stop.position(0).tolist() == moves.position(x).tolist()
        np.testing.assert_allclose(stop.velocity(0), moves.velocity(x), atol=rounding)
        assert stop.velocity(stop.t).tolist() == stop.acceleration(stop.t).tolist() == [0, 0] != stop.velocity(0).tolist()
        p = stop.sample(0.001).p
        np.testing.assert_allclose(p[:, 1], 1 - 0.2 * p[:, 0], atol=rounding)
        assert [axis.check(limit) for axis, limit in zip(stop, limits)] == [atraj.Findings(0)] * 2
        # A stop is on a line, too.
        again = real.module.line_stop(limits, stop, 0.01)
        np.testing.assert_allclose(again.position(again.t), stop.position(stop.t), atol=1e-2)
    assert real.module.line_stop(limits, moves, 0).t == 0


POINTS = [[0, 0, 1], [3, 1, 1], [4, 5, 1], [4, 5, 1], [-2, 4, 0]]


def test_a_path_passes_its_points(real):
    limits = [LIMITS, atraj.Limits.symmetric(60, 20, 5), LIMITS]
    for points in [POINTS, np.array(POINTS), np.array(POINTS, np.float32).tolist()]:
        path = real.module.path(limits, points)
        assert path.times.dtype == real.dtype and path.times[0] == 0 and path.times[-1] == path.t
        assert path.position(path.times).tolist() == POINTS and path.findings == atraj.Findings(0)
        # The third point is there twice. No axis stops at the second one but the axis that stays.
        assert path.times[2] == path.times[3] and (abs(path.velocity(path.times[1]))[:2] > 1).all()
    stops = [real.module.synchronise(limits, *pair)[0].t for pair in states(POINTS)]
    assert path.t < 0.9 * sum(stops)
    assert path.position([-1, path.t + 1]).tolist() == [POINTS[0], POINTS[-1]]
    assert path.velocity(path.t).tolist() == path.acceleration(path.t).tolist() == [0, 0, 0]


def states(points):
    """The ends of each section, at rest."""
    rest = [[atraj.State(p) for p in point] for point in points]
    return zip(rest, rest[1:])


def test_a_path_leaves_its_lines(real):
    path = real.module.path([LIMITS] * 2, [[0, 0], [3, 0], [3, 3]])
    x, y = path.position(np.linspace(0, path.t, 10_001)).T.astype(float)
    most = np.where(np.linspace(0, path.t, 10_001) < path.times[1], np.hypot(y, x - x.clip(0, 3)), np.hypot(x - 3, y - y.clip(0, 3))).max()
    assert most * 0.999 < path.deviation < most * 1.011 and most > 0.01
    assert real.module.path([LIMITS], [[0], [3], [4]]).deviation < 1e-5


def test_a_path_is_a_sequence_of_sections(real):
    path = real.module.path([LIMITS] * 3, POINTS)
    assert len(path) == len(POINTS) - 1 and [moves.t for moves in path] == [path[k].t for k in range(len(path))]
    for k, moves in enumerate(path):
        assert moves == path[k] == path[k - len(path)] and isinstance(moves, real.module.Moves)
        assert moves.position([0, moves.t]).tolist() == POINTS[k : k + 2]
    for k in [len(path), -len(path) - 1]:
        with pytest.raises(IndexError, match=rf"section {k} of {len(path)} sections"):
            path[k]


def test_the_phases_of_a_path(real):
    path = real.module.path([LIMITS] * 3, POINTS)
    assert len(path.phases) == 3
    for axis, phases in enumerate(path.phases):
        assert [phase.start for phase in phases] == sorted(phase.start for phase in phases)
        for start, duration, position, velocity, acceleration, jerk in phases:
            middle = path.state_at(start + duration / 2)[axis]
            half, close = duration / 2, 1e-4 if real.dtype == np.float32 else 1e-12
            assert middle.acceleration == pytest.approx(acceleration + half * jerk, abs=60 * close)
            assert middle.velocity == pytest.approx(velocity + half * (acceleration + half * jerk / 2), abs=20 * close)
            assert middle.position == pytest.approx(position + half * (velocity + half * (acceleration / 2 + half * jerk / 6)), abs=9 * close)


def test_an_array_of_times_has_the_values_of_single_times(real):
    path = real.module.path([LIMITS] * 3, POINTS)
    times = np.concatenate([np.linspace(-0.1, path.t + 0.1, 301), path.times, [math.nan, math.inf, -math.inf]]).astype(real.dtype)
    for times in [times, times[::-1], np.random.default_rng(1).permutation(times)]:
        for value in [path.position, path.velocity, path.acceleration, path.jerk]:
            assert np.array_equal(value(times), np.stack([value(float(x)) for x in times]), equal_nan=True)


def test_a_path_keeps_its_limits_and_does_not_jump(real):
    limits = [LIMITS, atraj.Limits(vmax=4, vmin=-5, amax=20, amin=-15, jmax=60, jmin=-50), LIMITS]
    t, p, v, a, j = real.module.path(limits, POINTS).sample(0.001)
    dt, rounding = np.diff(t)[:, None], 1e-2 if real.dtype == np.float32 else 1e-9
    for axis, limit in enumerate(limits):
        for values, high, low in [(v, limit.vmax, limit.vmin), (a, limit.amax, limit.amin), (j, limit.jmax, limit.jmin)]:
            assert values[:, axis].max() <= high + rounding and values[:, axis].min() >= low - rounding
    # A step is the mean of both ends, up to what a bend of the next quantity adds.
    for values, rate, bend in [(p, v, 20), (v, a, 60)]:
        assert np.allclose(np.diff(values, axis=0), dt * (rate[1:] + rate[:-1]) / 2, atol=bend * 1e-6 + rounding * 1e-3)


def test_a_path_starts_in_motion(real):
    limits = [LIMITS] * 3
    first = real.module.path(limits, POINTS)
    now = first.state_at(0.5)
    assert [state.velocity for state in now] == first.velocity(0.5).tolist()
    path = real.module.path(limits, [now, *POINTS[1:]])
    assert path.state_at(0) == now
    assert path.t == pytest.approx(first.t - 0.5, rel=1e-3)
    assert real.module.path([LIMITS], [[(0, 6, 0)], [9]]).findings == atraj.Findings.STARTS_OUTSIDE


def test_a_path_is_improved(real):
    hasty = real.module.path([LIMITS] * 3, POINTS, steps=3)
    better = hasty.improve()
    assert better.t < hasty.t and better.improve(steps=8).t <= better.t
    assert better.position(better.times).tolist() == POINTS
    assert better.t == pytest.approx(real.module.path([LIMITS] * 3, POINTS).t, rel=1e-3)


def test_sections_of_a_path_have_limits_of_their_own(real):
    points, slow = [[0, 0], [3, 1], [4, 5]], LIMITS._replace(vmax=0.5, vmin=-0.5)
    fast = real.module.path([LIMITS] * 2, points)
    zones = [[LIMITS] * 2, [slow] * 2]
    path = real.module.path(zones, points)
    assert path.position(path.times).tolist() == points and path.t > fast.t
    t, _, v, _, _ = path.sample(0.01)
    behind = abs(v[t > path.times[1]])
    assert behind.max() <= 0.5 + 1e-6 and abs(v).max() > 1
    assert path.improve().t <= path.t
    # The end counts in the last section alone.
    assert real.module.path([[slow], [LIMITS]], [[0], [3], [(4, 1, 0)]]).velocity(99) == 1


def test_points_of_a_path_have_tolerances(real):
    exact = real.module.path([LIMITS] * 3, POINTS)
    near = real.module.path([LIMITS] * 3, POINTS, tolerances=[0.0625, 0, 0.125])
    off = abs(near.position(near.times) - np.array(POINTS))
    assert near.t < exact.t and (off[1:-1] <= [0.0625 + 1e-6, 0, 0.125 + 1e-6]).all() and off.any() and not off[[0, -1]].any()
    each = real.module.path([LIMITS] * 3, POINTS, tolerances=[[0.0625, 0, 0.125]] * (len(POINTS) - 2))
    assert each.t == near.t
    none = real.module.path([LIMITS] * 3, POINTS, tolerances=[0, 0, 0])
    assert none.t <= exact.t and none.position(none.times).tolist() == POINTS


def test_times_of_a_path_have_any_shape_and_layout(real):
    path = real.module.path([LIMITS] * 3, POINTS)
    one = path.position(0.5)
    assert one.shape == (3,) and path.position(np.zeros((2, 4))).shape == (2, 4, 3) and path.position([]).shape == (0, 3)
    for times in layouts(real.dtype):
        for quantity in QUANTITIES:
            values = getattr(path, quantity)
            expected = [values(x).tolist() for x in np.array(times, float).ravel()]
            assert values(times).dtype == real.dtype and values(times).reshape(-1, 3).tolist() == expected
    samples = path.sample(n=5)
    assert samples.t.tolist() == path.sample(float(samples.t[1])).t.tolist() and samples.j.shape == (5, 3)
    assert path.sample(0.25, start=0.5).t[:2].tolist() == [0.5, 0.75]
    with pytest.raises(ValueError, match="dt, n or out"):
        path.sample()


def test_paths_say_why_not():
    assert_refused("path", LIMITS=LIMITS, two=[LIMITS] * 2, rest=atraj.State(0))


def test_moves_say_why_not():
    two, fast = [LIMITS] * 2, [LIMITS, LIMITS._replace(vmax=-3)]

    def between(lowest, highest, limits=two, **times):
        return atraj.synchronise_within(limits, [0, (9, 3)], [10, 8], lowest, highest, **times)

    moves = atraj.line(two, [0, 0], [10, 5])
    assert_refused("move", LIMITS=LIMITS, two=two, fast=fast, rest=atraj.State(0), moves=moves, between=between, Trajectory=Trajectory)


def test_claraty_is_copied():
    axis = Trajectory()
    axis.set(10, 2, 4, 4, now=0)
    axis.start(now=0)
    for copied in [copy.copy(axis), copy.deepcopy(axis)]:
        copied.stop(now=1)
        assert copied.duration < axis.duration and copied.setpoint(now=1).position == axis.setpoint(now=1).position


def test_claraty_brakes_and_warns():
    axis = Trajectory(now=100)
    axis.set(10, 2, 4, 0, now=100)
    assert axis.start(now=100) == Warnings.DECELERATION
    assert axis.is_started and axis.setpoint(now=101).velocity == axis.setpoint_at(1).velocity
    axis.set(10, 2, 4, 4, now=101)
    axis.stop(now=101)
    axis.change_clock(101, instead=0)
    assert axis.setpoint(axis.duration).velocity == 0


def things(module):
    """One of each class that never changes."""
    x, y = moves = module.synchronise([LIMITS] * 2, [0, (1, 2)], [10, -1])
    path = module.path([LIMITS] * 2, [[0, 0], [3, 1], [4, 5]])
    zoned = module.path([[LIMITS], [LIMITS._replace(vmax=2)]], [[0], [3], [(4, 1, 0)]])
    shaper = module.Shaper.smooth(0.02).add(atraj.ShaperKind.EI2, 3.3, 0.02)
    other = module.Shaper(atraj.ShaperKind.ZV, 5)
    return [*profiles(module), x, y, moves, path, zoned, shaper, other, shaper.shape(x), other.shape(profiles(module)[0])]


def test_copies_are_equal(real):
    originals, same = things(real.module), things(real.module)
    for k, (thing, equal) in enumerate(zip(originals, same)):
        assert thing == equal and hash(thing) == hash(equal) and thing is not equal
        assert all(thing != other for other in originals[:k] + originals[k + 1 :] + [None, 1])
        for made in [pickle.loads(pickle.dumps(thing)), copy.copy(thing), copy.deepcopy(thing)]:
            assert made == thing and type(made) is type(thing)
            if hasattr(thing, "sample"):
                assert [real.bits(y) for y in made.sample(n=99)] == [real.bits(y) for y in thing.sample(n=99)]
                assert made.t == thing.t


def test_what_comes_back_from_its_text():
    texts = 0
    for module in [atraj, atraj.f32]:
        for thing in things(module):
            if not repr(thing).startswith("<"):
                assert eval(repr(thing)) == thing
                texts += 1
    assert texts == 2 * 7
    for value in [LIMITS, atraj.State(1, 2), atraj.Bell(30, 10, 5, 0, 10).fields, LIMITS._replace(vmax=4)]:
        assert eval(repr(value), vars(atraj)) == value == pickle.loads(pickle.dumps(value)) == copy.deepcopy(value)
        assert type(pickle.loads(pickle.dumps(value))) is type(value)


def test_limits():
    assert LIMITS == (5, -5, 10, -10, 30, -30) == atraj.Limits(jerk=-30, acceleration=10, velocity=5)
    assert atraj.Limits(30, 10, 5) == LIMITS == atraj.Limits(vmin=-5, vmax=5, amax=10, amin=-10, jmax=30, jmin=-30)
    assert atraj.Limits(jerk=30, acceleration=10, velocity=5, amin=-12) == LIMITS._replace(amin=-12)
    with pytest.raises(TypeError, match="positional"):
        atraj.Limits(5, -5, 10, -10, 30, -30)
    with pytest.raises(TypeError, match="Limits needs jerk, or jmax and jmin"):
        atraj.Limits(acceleration=10, velocity=5, jmax=3)


def test_numbers_come_in_lists_tuples_and_arrays(real):
    plan = real.module.Move.plan
    one = plan(LIMITS, atraj.State(0, 1), atraj.State(10))
    for form in [list, tuple, np.array, lambda numbers: np.array(numbers, np.float32), lambda numbers: np.array(numbers, int)]:
        assert plan(form([5, -5, 10, -10, 30, -30]), form([0, 1, 0]), form([10])) == one
    assert plan(LIMITS, (0, 1), 10) == one == plan(LIMITS, np.float64(0) * 0 + np.array([0, 1]), np.float32(10))
    many = real.module.synchronise([LIMITS] * 2, [0, 0], [10, -1])
    limits = np.array([LIMITS] * 2, float)
    assert many == real.module.synchronise(limits, np.zeros(2), np.array([10, -1])) == real.module.synchronise(limits, np.zeros((2, 3)), [[10], (-1, 0)])
    assert real.module.path(limits, np.array([[0, 0], [3, 1]])) == real.module.path([LIMITS] * 2, [[0, 0], [3, 1]])


ORDER = ["limits", "moves", "move", "jerk", "acceleration", "velocity", "ac", "de", "t", "c", "start", "p0", "end", "target", "signal", "p1", "points", "v0",
         "v1", "a0", "a1", "j0", "j1", "lowest", "highest", "horizon", "offset", "step", "kind", "frequency", "damping"]
# `reach` goes to a velocity, as `end`, and a signal has a jerk; a trapezoid has liba's order.
AFTER_START = {"velocity", "acceleration", "jerk"}


def test_arguments_have_one_order():
    seen = 0
    for module in [atraj, sys.modules["atraj.f32"]]:
        for name in module.__all__:
            item = getattr(module, name)
            if item.__module__ == "atraj.values" or name in ("Limits", "State"):
                continue
            functions = [item] if not inspect.isclass(item) else [item, *(getattr(item, member) for member in vars(item) if not member.startswith("_"))]
            for function in filter(callable, functions):
                try:
                    parameters = inspect.signature(function).parameters.values()
                except ValueError:
                    continue
                names = [p.name for p in parameters if p.kind is p.POSITIONAL_OR_KEYWORD and p.name in ORDER]
                if "start" in names:
                    names = [n for n in names if n not in AFTER_START]
                assert names == sorted(names, key=ORDER.index), (name, function)
                seen += len(names) > 1
    assert seen >= 40


def test_several_axes_are_alike(real):
    limits = [LIMITS, LIMITS._replace(vmax=3)]
    moves, path = real.module.synchronise(limits, [0, 0], [10, -1]), real.module.path(limits, [[0, 0], [3, 1], [10, -1]])
    for motion in [moves, path]:
        assert isinstance(motion, real.module.Axes)
        assert motion.position([0, motion.t, motion.t + 1]).tolist() == [[0, 0], [10, -1], [10, -1]]
        assert motion.position(math.nan).tolist() == [10, -1]
        t, p, v, a, j = motion.sample(0.01)
        assert p.shape == v.shape == a.shape == j.shape == (len(t), 2) and p.dtype == real.dtype
        assert [state.position for state in motion.state_at(0.3)] == motion.position(0.3).tolist()
        again = real.module.synchronise(limits, motion.state_at(0.3), [10, -1])
        assert again.velocity(0).tolist() == motion.velocity(0.3).tolist()
    assert len(moves) == 2 and moves[-1] == moves[1] and [axis.t for axis in moves] == [moves.t] * 2
    with pytest.raises(IndexError, match="axis 2 of 2 axes"):
        moves[2]
    # A path goes on as its axes do after their end.
    running = real.module.path([LIMITS], [[0], [(4, 1, 0)]])
    assert running.position(running.t + 2).tolist() == pytest.approx([6])


def test_pictures_have_limits_units_and_labels():
    bell, trap = atraj.Bell(30, 10, 5, 0, 10), atraj.Trap(5, 10, -10, 0, 10)
    figure = bell.plot(limits=LIMITS, unit="mm", label="double-S")
    assert [axis.get_ylabel() for axis in figure.axes] == ["position, mm", "velocity, mm/s", "acceleration, mm/s²", "jerk, mm/s³"]
    assert figure.axes[-1].get_xlabel() == "time, s"
    dashed = [[line.get_ydata()[0] for line in axis.lines if line.get_linestyle() == "--"] for axis in figure.axes]
    assert dashed == [[], [5, -5], [10, -10], [30, -30]]
    assert trap.plot(axes=figure.axes, label="trapezoid") is figure
    assert len([line for line in figure.axes[1].lines if line.get_linestyle() == "-"]) == 2
    assert [text.get_text() for text in figure.axes[0].get_legend().get_texts()] == ["double-S", "trapezoid"]
    later = atraj.Move.plan(LIMITS, atraj.State(3, 2), -2).plot(axes=figure.axes, offset=1.5).axes[0].lines[-1].get_xdata()
    assert later[0] == 1.5 and later[-1] == 1.5 + atraj.Move.plan(LIMITS, atraj.State(3, 2), -2).t
    with pytest.raises(ValueError, match="axes has 1 places"):
        bell.plot(axes=figure.axes[:1])


def test_pictures_of_several_axes():
    moves = atraj.synchronise([LIMITS] * 2, [0, 0], [10, -1])
    figure = moves.plot(limits=[LIMITS, LIMITS._replace(jmax=math.inf)], labels=["x", "y"])
    colors = [[line.get_color() for line in axis.lines if line.get_linestyle() == "-"] for axis in figure.axes]
    assert all(len(set(of_plot)) == 2 and of_plot == colors[0] for of_plot in colors)
    assert len([line for line in figure.axes[3].lines if line.get_linestyle() == "--"]) == 3
    for motion in [moves, atraj.path([LIMITS] * 2, [[0, 0], [3, 1], [4, 5]])]:
        (place,) = motion.plot(plane=(0, 1), unit="m", labels=["x", "y"]).axes
        assert place.get_aspect() == 1 and (place.get_xlabel(), place.get_ylabel()) == ("x, m", "y, m")
        x, y = place.lines[0].get_data()
        assert np.array_equal(np.stack([x, y], 1), motion.sample(n=1001).p)
    with pytest.raises(ValueError, match="needs an axis 2, and there are 2 axes"):
        moves.plot(plane=(0, 2))


def test_plot():
    for profile, axes in zip(profiles(atraj), [4, 3, 4, 4, 4, 4]):
        assert len(profile.plot().axes) == axes


def test_plot_of_a_path():
    path = atraj.path([LIMITS] * 3, POINTS)
    figure = path.plot()
    curves = figure.axes[0].lines
    assert len(figure.axes) == 4 and len(curves) == 6
    assert [curve.get_ydata()[0] for curve in curves[:3]] == POINTS[0]
    assert [dots.get_ydata().tolist() for dots in curves[3:]] == np.transpose(POINTS).tolist()


def test_plot_without_matplotlib(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(ImportError, match=r"plot needs matplotlib: pip install 'atraj\[plot\]'"):
        atraj.Bell(30, 10, 5, 0, 10).plot()
