"""Do clock, shaper and steps keep their promises in Python, in both real types, and say what is wrong with bad arguments?"""

import copy
import math
import pickle

import numpy as np
import pytest
from refused import assert_refused

import atraj

PLANNED = [atraj.Limits(jerk=16, acceleration=4, velocity=0.8)] * 2
LIMITS = [atraj.Limits(jerk=20, acceleration=5, velocity=1)] * 2
POINTS = [[0, 0], [0.8, 0.1], [0.9, 0.9], [0, 1]]


def test_a_clock_holds_and_goes_on(real):
    rounding = 1e-4 if real.dtype == np.float32 else 1e-9
    for moves in [real.module.synchronise(PLANNED, [0, 0], [0.8, -0.4]), real.module.path(PLANNED, POINTS)]:
        clock = real.module.Clock(LIMITS, moves)
        assert clock.position(0.3).tolist() == moves.position(0.3).tolist()
        clock.rate(0.5, 0)
        held = clock.until
        # `until` is rounded, and may be an ulp before the end of the hold.
        stands = clock.position(held + 0.001).tolist()
        assert held > 0.5 and clock.position(held + 5).tolist() == stands and not clock.velocity(held + 0.001).any()
        np.testing.assert_allclose(clock.position(held), stands, atol=rounding)
        np.testing.assert_allclose(clock.velocity(held), [0, 0], atol=rounding)
        clock.rate(held + 2, 0.5)
        clock.rate(clock.until + 0.1, 1)
        samples = clock.sample(0.005, n=2400)
        assert samples.p.dtype == real.dtype and samples.p.shape == (2400, 2)
        np.testing.assert_allclose(samples.p[-1], moves.position(moves.t), atol=rounding)
        # On its path, within its limits.
        times = np.array([clock.time(float(x)) for x in samples.t], real.dtype)
        assert real.bits(samples.p) == real.bits(moves.position(times))
        for quantity, highest in [(samples.v, 1), (samples.a, 5), (samples.j, 20)]:
            assert abs(quantity).max() <= highest * (1 + rounding)
        states = clock.state_at(0.7)
        assert [state.velocity for state in states] == clock.velocity(0.7).tolist()


def test_a_copied_clock_goes_its_own_way(real):
    clock = real.module.Clock(LIMITS, real.module.synchronise(PLANNED, [0, 0], [0.8, -0.4]))
    for copied in [copy.copy(clock), copy.deepcopy(clock), pickle.loads(pickle.dumps(clock))]:
        copied.rate(0.5, 0)
        assert copied.time(9) < 1 and clock.time(9) == 9
        copied.rebase(copied.until)
        copied.rate(1, 0.5)
        again = pickle.loads(pickle.dumps(copied))
        assert type(again) is real.module.Clock and again.until == copied.until
        assert real.bits(again.sample(0.01, n=200).p) == real.bits(copied.sample(0.01, n=200).p)


def test_a_clock_stands_at_its_ends(real):
    clock = real.module.Clock(LIMITS, real.module.path(PLANNED, POINTS))
    found = atraj.Findings
    assert real.module.Group(0.002, [0, 0]).rate(LIMITS, 0) == found(0)  # nothing moves
    assert clock.rate(100, 1) == found.RATE_NOT_REACHED and clock.until == 100
    assert clock.rate(120, -1) == found(0)
    assert clock.position(200).tolist() == POINTS[0] and not clock.velocity(200).any()
    clock.rebase(200)
    assert clock.time(0) == 0 and clock.rate(0, 1) == found(0)
    assert clock.position(100).tolist() == real.module.path(PLANNED, POINTS).position(100).tolist()


def test_a_clock_says_why_not():
    moves = atraj.synchronise(PLANNED, [0, 0], [0.8, -0.4])
    clock = atraj.Clock(PLANNED, moves)
    assert_refused("clock", PLANNED=PLANNED, LIMITS=LIMITS, moves=moves, clock=clock)
    assert clock.position(0.3).tolist() == moves.position(0.3).tolist()


def left_of(motion, frequency, damping):
    """Amplitude that a motion leaves of a load, by the sum of its velocity."""
    t, _, v, _, _ = motion.sample(n=20001)
    pole = 2 * math.pi * frequency * complex(-damping, math.sqrt(1 - damping**2))
    return abs(pole * (np.exp(pole * (motion.t - t)) * v).sum() * (t[1] - t[0]) / pole.imag)


@pytest.mark.parametrize("kind", atraj.ShaperKind, ids=lambda kind: kind.name)
def test_a_shaper_leaves_the_load_at_rest(kind):
    for move in [atraj.Move.plan((1, -1, 4, -4, 900, -900), 0, 0.5), atraj.Bell(900, 4, 1, 0, 0.5)]:
        shaped = atraj.Shaper(kind, 5, 0.02).shape(move)
        assert shaped.t == move.t + atraj.Shaper(kind, 5, 0.02).duration
        assert shaped.state_at(shaped.t) == pytest.approx(atraj.State(0.5), abs=1e-12)
        assert left_of(shaped, 5, 0.02) < 0.06 * left_of(move, 5, 0.02)
        samples = shaped.sample(0.001)
        assert abs(samples.v).max() <= 1 + 1e-12 and abs(samples.a).max() <= 4 + 1e-12 and np.isnan(samples.j).all()
        with pytest.raises(ValueError, match="not known"):
            shaped.extremes()


def test_shapers_add_and_smooth(real):
    kinds, shaper = atraj.ShaperKind, real.module.Shaper
    both = shaper(kinds.ZV, 5).add(kinds.ZVD, 12, 0.1)
    assert both.duration == pytest.approx(0.1 + 1 / (12 * math.sqrt(0.99)))
    smooth = shaper.smooth(0.05).add(kinds.EI, 4)
    move = real.module.Move.plan(LIMITS[0], 0, 0.5)
    assert smooth.duration == pytest.approx(0.3) and smooth.shape(move).t == pytest.approx(move.t + 0.3)
    assert_refused("shaper", Shaper=shaper, both=both)
    with pytest.raises(TypeError, match="a Move or a Bell can be shaped, and this is a Trap"):
        both.shape(real.module.Trap(5, 4, -2, 0, 50))


def test_no_step_is_lost(real):
    move = real.module.Move.plan(LIMITS[0], (0, -0.5), 0.9)  # turns once
    steps = real.module.Steps(move, 0.005, 0.01)
    first = steps.count
    ahead = copy.copy(steps)
    next(ahead)
    again = pickle.loads(pickle.dumps(ahead))
    assert again.count == ahead.count and next(copy.copy(ahead)) == next(copy.copy(again))
    ahead = copy.copy(steps)
    taken = list(steps)
    assert [step.direction for step in ahead] == [step.direction for step in taken]
    assert {step.direction for step in taken} == {1, -1}
    assert first + sum(step.direction for step in taken) == steps.count == 89
    times = [step.time for step in taken]
    assert times == sorted(times) and 0 <= times[0] and times[-1] <= move.t
    lines = first + np.cumsum([step.direction for step in taken]) + [step.direction < 0 for step in taken]
    np.testing.assert_allclose(move.position(times), 0.005 + 0.01 * lines, atol=1e-5 if real.dtype == np.float32 else 1e-12)
    back = real.module.Move.plan(LIMITS[0], 0.9, 0)
    steps.follow(back)
    assert sum(step.direction for step in steps) == -90
    assert_refused("steps", Steps=real.module.Steps, move=move)


def run(cell, ticks=10_000):
    """Ticks until the motion is at its end: an array of states, tick by tick."""
    states = []
    while not cell.done and len(states) < ticks:
        states.append(cell.tick())
    assert cell.done
    return np.array(states)


def test_a_group_works_in_a_cell(real):
    rounding, period = (1e-4 if real.dtype == np.float32 else 1e-9), 0.002
    cell = real.module.Group(period, [0, (0.1, 0, 0)])
    assert len(cell) == 2 and cell.done and cell.tick() == [atraj.State(0), pytest.approx(atraj.State(0.1))]
    cell.line(PLANNED, [0.8, -0.3], lead=3)
    assert not cell.done
    states = [cell.tick() for _ in range(250)]
    cell.rate(LIMITS, 0)
    states += run(cell).tolist()
    assert 0 < states[-1][0][0] < 0.8 and states[-1][0][1:] == [0, 0]
    cell.rate(LIMITS, 1)
    states += run(cell).tolist()
    states = np.array(states)
    np.testing.assert_allclose(states[-1][:, 0], [0.8, -0.3], atol=rounding)
    np.testing.assert_allclose(states[:, 1, 0], 0.1 - states[:, 0, 0] / 2, atol=rounding)  # on the line
    cell.synchronise(PLANNED, [(0.2, 0, 0), 0.5])
    for _ in range(100):
        cell.tick()
    cell.stop(LIMITS)
    assert run(cell)[-1][:, 1].tolist() == [0, 0]
    cell.go(PLANNED, [0, 0])
    assert run(cell)[-1].tolist() == [[0, 0, 0]] * 2
    path = real.module.path(PLANNED, POINTS)
    cell.path(LIMITS, path)
    states = run(cell)
    np.testing.assert_allclose(states[:, :, 0], path.position(period * np.arange(len(states))), atol=rounding)
    assert abs(np.diff(states[:, :, 1], axis=0)).max() <= 5 * period * (1 + rounding)
    cell.within([-2, -2], [2, math.inf])
    with pytest.raises(ValueError, match="leaves the positions"):
        cell.synchronise(PLANNED, [0, -2.5])
    cell.synchronise(PLANNED, [2, 2.5])
    assert run(cell)[-1][:, 0].tolist() == [2, 2.5]


def test_a_group_says_why_not():
    cell = atraj.Group(0.002, [0, 0])
    path = atraj.path(PLANNED, POINTS)
    cell.line(LIMITS, [1, 1])
    for _ in range(200):
        before = cell.tick()
    assert_refused("group", LIMITS=LIMITS, path=path, cell=cell)
    after = cell.tick()
    assert after[0].position > before[0].position and after[0].velocity == pytest.approx(before[0].velocity, abs=0.02)
    np.testing.assert_allclose(run(cell)[-1][:, 0], [1, 1], atol=1e-9)
