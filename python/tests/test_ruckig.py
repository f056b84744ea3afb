"""Is a move ever longer than Ruckig's, or wrong where Ruckig's is right?"""

import math
import random

import ruckig

import atraj

PROBLEMS = 20_000
LONGER = 1e-7  # relative
ROUNDING = 1e-9  # of what the move reaches


def problem(chance):
    """Limits in each direction, and two states within them, from which and to which the limits can be kept."""
    high_v, low_v, high_a, low_a, jerk = (10 ** chance.uniform(-1, 1.5) for _ in range(5))
    if chance.random() < 0.5:
        low_v, low_a = high_v, high_a
    limits = atraj.Limits(vmax=high_v, vmin=-low_v, amax=high_a, amin=-low_a, jerk=jerk)

    def state():
        v, a = chance.uniform(-low_v, high_v), chance.uniform(-low_a, high_a) * chance.choice([0, 0.5])
        beyond = v + math.copysign(a * a / (2 * jerk), a)
        before = v - math.copysign(a * a / (2 * jerk), a)
        keeps = all(-low_v < x < high_v for x in (beyond, before))
        return atraj.State(chance.uniform(-10, 10), v, a) if keeps else atraj.State(chance.uniform(-10, 10))

    return limits, state(), state()


def planned_by_ruckig(limits, start, end):
    """The duration of Ruckig's trajectory, or None if it refuses."""
    given, trajectory = ruckig.InputParameter(1), ruckig.Trajectory(1)
    given.current_position, given.current_velocity, given.current_acceleration = ([x] for x in start)
    given.target_position, given.target_velocity, given.target_acceleration = ([x] for x in end)
    given.max_velocity, given.min_velocity = [limits.vmax], [limits.vmin]
    given.max_acceleration, given.min_acceleration = [limits.amax], [limits.amin]
    given.max_jerk = [limits.jmax]
    try:
        result = ruckig.Ruckig(1).calculate(given, trajectory)
    except RuntimeError:
        return None
    return trajectory.duration if result in (ruckig.Result.Working, ruckig.Result.Finished) else None


def check_valid(move, limits, start, end):
    """The move starts and arrives, keeps its limits, and no phase jumps."""
    assert move.state_at(0) == start and move.state_at(move.t) == end
    lowest, highest = move.extremes()
    room = ROUNDING * max(map(abs, limits))
    assert limits.vmin - room <= lowest.velocity and highest.velocity <= limits.vmax + room
    assert limits.amin - room <= lowest.acceleration and highest.acceleration <= limits.amax + room
    scale = max(abs(lowest.position), abs(highest.position), 1) + max(map(abs, limits)) * max(1, move.t)
    following = [*move.phases[1:], atraj.Phase(move.t, 0, *end, 0)]
    for phase, after in zip(move.phases, following):
        d, j = phase.duration, phase.jerk
        assert limits.jmin - room <= j <= limits.jmax + room
        a = phase.acceleration + j * d
        v = phase.velocity + d * (phase.acceleration + d * j / 2)
        p = phase.position + d * (phase.velocity + d * (phase.acceleration / 2 + d * j / 6))
        reached, wanted = (p, v, a), (after.position, after.velocity, after.acceleration)
        assert all(abs(x - y) <= ROUNDING * scale for x, y in zip(reached, wanted)), (phase, after)


def test_moves_next_to_ruckig():
    chance = random.Random(18)
    refused = shorter = 0
    for _ in range(PROBLEMS):
        limits, start, end = problem(chance)
        move = atraj.Move.plan(limits, start, end)
        check_valid(move, limits, start, end)
        theirs = planned_by_ruckig(limits, start, end)
        if theirs is None:
            refused += 1
            continue
        assert move.t <= theirs * (1 + LONGER), (limits, start, end, move.t, theirs)
        shorter += move.t < theirs * (1 - LONGER)
    print(f"{PROBLEMS} problems: Ruckig {ruckig.__version__} refuses {refused}; of the others ours is shorter in {shorter}, longer in none")
    assert refused < PROBLEMS / 100
