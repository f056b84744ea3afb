"""Do the classes take and give what their documentation says, and say what is wrong with bad arguments?"""

import math
import sys
import tomllib

import numpy as np
import pytest
from golden import DIRECTORY, REALS

import atraj
from atraj.claraty import Trajectory, Warnings

reals = pytest.mark.parametrize("real", REALS, ids=lambda real: real.name)
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
    with open(DIRECTORY.parents[1] / "Cargo.toml", "rb") as manifest:
        assert atraj.__version__ == tomllib.load(manifest)["package"]["version"]


@reals
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
    """The times 0.5, 1, 1.5 and 2 in the layouts that NumPy knows, and a stride of 0 beside them."""
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


@reals
def test_times_have_any_layout(real):
    for profile in profiles(real.module):
        for times in layouts(real.dtype):
            expected = np.vectorize(profile.position, otypes=[real.dtype])(np.array(times, float))
            values = profile.position(times)
            assert values.dtype == real.dtype and values.tolist() == expected.tolist(), times


@reals
def test_numbers_of_records_have_any_type(real):
    for dtype in ["i1", "u2", ">i4", "i8", ">f2", "f4", ">f8", "O", "?"]:
        records = np.zeros(2, [("id", "S3"), ("t", dtype)])
        records["t"] = [0, 1]
        for profile in profiles(real.module):
            values = profile.position(records["t"])
            assert values.dtype == real.dtype and values.tolist() == [profile.position(0), profile.position(1)], dtype


@reals
def test_no_times_give_no_values(real):
    records = np.zeros((0, 2), [("id", "u1"), ("t", real.dtype)])
    for times in [records["t"], records["t"][::-1], records["t"].T]:
        values = real.module.Bell(30, 10, 5, 0, 10).position(times)
        assert values.shape == times.shape and values.dtype == real.dtype


@reals
def test_masks_are_not_looked_at(real):
    bell = real.module.Bell(30, 10, 5, 0, 10)
    times = np.ma.array([0.5, 1], real.dtype, mask=[True, False])
    values = bell.position(times)
    assert type(values) is np.ndarray and values.tolist() == [bell.position(0.5), bell.position(1)]
    samples = bell.sample(0.5, start=0.5, out=(times, None, None, None, None))
    assert samples.t is times and times.data.tolist() == [0.5, 1] and times.mask.tolist() == [True, False]


@reals
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


@pytest.mark.parametrize(
    "request_, message",
    [
        ({}, "dt, n or out"),
        ({"dt": 0}, "dt must be above 0"),
        ({"dt": -0.1}, "dt must be above 0"),
        ({"dt": math.nan}, "dt must be above 0"),
        ({"dt": 0.1, "start": math.inf}, "start finite"),
        ({"dt": 1e-300}, "more than 2147483647"),
        ({"dt": 1e-9}, "more than 2147483647"),
        ({"n": 2**31}, "more than 2147483647"),
    ],
)
def test_bad_requests_are_refused(request_, message):
    with pytest.raises(ValueError, match=message):
        atraj.Bell(30, 10, 5, 0, 10).sample(**request_)


@reals
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


@reals
def test_fastest_plans_where_liba_fails(real):
    for family, limits in [(real.module.Bell, (30, 10, 5)), (real.module.Trap, (5, 10, -10))]:
        with pytest.raises(ValueError, match="no such move within the limits"):
            family(*limits, 0, 0)
        move = family.fastest(*limits, p0=0, p1=0.1, v0=2)
        assert move.position(move.t) == real.dtype(0.1) and atraj.Findings.OVERSHOOTS == move.check(*limits)
        with pytest.raises(ValueError, match="not a number"):
            family.fastest(*limits, 0, math.nan)


@reals
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
    assert axis.track(LIMITS, target, target, 0.125).t == 0.125
    meeting = axis.meet(LIMITS, now, target)
    reached = meeting.state_at(meeting.t)
    assert reached.velocity == 0.5 and reached.position == pytest.approx(3 + 0.5 * meeting.t)
    assert move.position(move.time_at(4)) == pytest.approx(4) and move.time_at(11) is None


@reals
def test_axes_move_together(real):
    limits = [LIMITS, atraj.Limits.symmetric(60, 20, 5)]
    start, end = [atraj.State(0), atraj.State(1)], [atraj.State(10), atraj.State(-1)]
    for plan in [real.module.synchronise, real.module.line]:
        x, y = plan(limits, start, end, duration=3, cycle=0.25)
        assert x.t == y.t == 3 and (x.position(3), y.position(3)) == (10, -1)
    times = np.linspace(0, 3, 50)
    np.testing.assert_allclose(y.position(times), 1 - 0.2 * x.position(times), atol=1e-5)


POINTS = [[0, 0, 1], [3, 1, 1], [4, 5, 1], [4, 5, 1], [-2, 4, 0]]


@reals
def test_a_path_passes_its_points(real):
    limits = [LIMITS, atraj.Limits.symmetric(60, 20, 5), LIMITS]
    for points in [POINTS, np.array(POINTS), np.array(POINTS, np.float32).tolist()]:
        path = real.module.path(points, limits)
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


@reals
def test_a_path_keeps_its_limits_and_does_not_jump(real):
    limits = [LIMITS, atraj.Limits(4, -5, 20, -15, 60, -50), LIMITS]
    t, p, v, a, j = real.module.path(POINTS, limits).sample(0.001)
    dt, rounding = np.diff(t)[:, None], 1e-2 if real.dtype == np.float32 else 1e-9
    for axis, limit in enumerate(limits):
        for values, high, low in [(v, limit.vmax, limit.vmin), (a, limit.amax, limit.amin), (j, limit.jmax, limit.jmin)]:
            assert values[:, axis].max() <= high + rounding and values[:, axis].min() >= low - rounding
    # A step is the mean of both ends, up to what a bend of the next quantity adds.
    for values, rate, bend in [(p, v, 20), (v, a, 60)]:
        assert np.allclose(np.diff(values, axis=0), dt * (rate[1:] + rate[:-1]) / 2, atol=bend * 1e-6 + rounding * 1e-3)


@reals
def test_a_path_starts_in_motion(real):
    limits = [LIMITS] * 3
    first = real.module.path(POINTS, limits)
    now = first.state_at(0.5)
    assert [state.velocity for state in now] == first.velocity(0.5).tolist()
    path = real.module.path([now, *POINTS[1:]], limits)
    assert path.state_at(0) == now
    assert path.t == pytest.approx(first.t - 0.5, rel=1e-3)
    assert real.module.path([[(0, 6, 0)], [9]], [LIMITS]).findings == atraj.Findings.STARTS_OUTSIDE


@reals
def test_a_path_is_improved(real):
    hasty = real.module.path(POINTS, [LIMITS] * 3, steps=3)
    better = hasty.improve()
    assert better.t < hasty.t and better.improve(steps=8).t <= better.t
    assert better.position(better.times).tolist() == POINTS
    assert better.t == pytest.approx(real.module.path(POINTS, [LIMITS] * 3).t, rel=1e-3)


@reals
def test_sections_of_a_path_have_limits_of_their_own(real):
    points, slow = [[0, 0], [3, 1], [4, 5]], LIMITS._replace(vmax=0.5, vmin=-0.5)
    fast = real.module.path(points, [LIMITS] * 2)
    zones = [[LIMITS] * 2, [slow] * 2]
    path = real.module.path(points, zones)
    assert path.position(path.times).tolist() == points and path.t > fast.t
    t, _, v, _, _ = path.sample(0.01)
    behind = abs(v[t > path.times[1]])
    assert behind.max() <= 0.5 + 1e-6 and abs(v).max() > 1
    assert path.improve().t <= path.t
    # The end counts in the last section alone.
    assert real.module.path([[0], [3], [(4, 1, 0)]], [[slow], [LIMITS]]).velocity(99) == 1


@reals
def test_times_of_a_path_have_any_shape_and_layout(real):
    path = real.module.path(POINTS, [LIMITS] * 3)
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
    two, rest = [LIMITS] * 2, atraj.State(0)
    for message, call in {
        "at least two points": lambda: atraj.path([[0, 0]], two),
        "no axis": lambda: atraj.path([[], []], []),
        "limits has 1 lists, and the path 2 sections": lambda: atraj.path([[0, 0], [1, 1], [2, 2]], [two]),
        "point 1 has 3 coordinates, and limits 2 axes": lambda: atraj.path([[0, 0], [1, 1, 1]], two),
        "point 0 has 2 coordinates, and limits 1 axes": lambda: atraj.path([[0, 0], [1, 1]], [LIMITS]),
        "point 1, axis 1: .*not a number": lambda: atraj.path([[0, 0], [0, math.nan], [1, 1]], two),
        "point 2, axis 0: .*infinite": lambda: atraj.path([[0, 0], [1, 1], [math.inf, 0], [1, 1]], two),
        "point 1, axis 0: only the first": lambda: atraj.path([[0, 0], [rest, 0], [1, 1]], two),
        "point 0, axis 1: neither a number nor a state": lambda: atraj.path([[0, "0"], [1, 1]], two),
        "axis 1: .*not a number": lambda: atraj.path([[0, math.nan], [1, 1]], two),
        "axis 0: .*wrong sign": lambda: atraj.path([[0, 0], [1, 1]], [LIMITS._replace(jmin=1), LIMITS]),
        "axis 1: .*outside the limits": lambda: atraj.path([[0, 0], [1, (1, 6, 0)]], two),
    }.items():
        with pytest.raises(ValueError, match=message):
            call()


def test_moves_say_why_not():
    plan, state = atraj.Move.plan, atraj.State(0)
    for message, call in {
        "infinite or not a number": lambda: plan(LIMITS, atraj.State(math.nan), state),
        "wrong sign": lambda: plan(LIMITS._replace(vmin=1), state, state),
        "outside the limits": lambda: plan(LIMITS, state, atraj.State(0, 6)),
        "duration or the cycle": lambda: atraj.line([LIMITS], [state], [state], cycle=-1),
        "straight line": lambda: atraj.line([LIMITS] * 2, [atraj.State(0, 1), state], [state, atraj.State(1)]),
        "no axis": lambda: atraj.synchronise([], [], []),
        "different lengths": lambda: atraj.synchronise([LIMITS], [state], []),
        "takes no time": lambda: atraj.Poly3(0, 0, 1),
        "tuple of length 6": lambda: plan((1, 2), state, state),
        "1e60": lambda: Trajectory().set(1e61, 1, 1, 1, now=0),
        "CORRECTED or LISTING": lambda: Trajectory(2),
    }.items():
        with pytest.raises(ValueError, match=message):
            call()


def test_claraty_brakes_and_warns():
    axis = Trajectory(now=100)
    axis.set(10, 2, 4, 0, now=100)
    assert axis.start(now=100) == Warnings.DECELERATION
    assert axis.is_started and axis.setpoint(now=101).velocity == axis.setpoint_at(1).velocity
    axis.set(10, 2, 4, 4, now=101)
    axis.stop(now=101)
    axis.change_clock(101, instead=0)
    assert axis.setpoint(axis.duration).velocity == 0


def test_plot():
    for profile, axes in zip(profiles(atraj), [4, 3, 4, 4, 4, 4]):
        assert len(profile.plot().axes) == axes


def test_plot_of_a_path():
    path = atraj.path(POINTS, [LIMITS] * 3)
    figure = path.plot()
    curves = figure.axes[0].lines
    assert len(figure.axes) == 4 and len(curves) == 6
    assert [curve.get_ydata()[0] for curve in curves[:3]] == POINTS[0]
    assert [dots.get_ydata().tolist() for dots in curves[3:]] == np.transpose(POINTS).tolist()


def test_plot_without_matplotlib(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(ImportError, match=r"plot needs matplotlib: pip install 'atraj\[plot\]'"):
        atraj.Bell(30, 10, 5, 0, 10).plot()
