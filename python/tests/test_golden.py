"""Do the classes give every bit of the golden data, in both real types?"""

import collections

import numpy as np
import pytest
from golden import REALS, rows

from atraj.claraty import Mode, Trajectory, TrapezoidalProfile

FIELDS = {"Bell": 14, "Trap": 12}
POLYNOMIALS = [("Poly3", 5, 4, 3), ("Poly5", 7, 6, 3), ("Poly7", 9, 8, 4)]


def plans(table, real):
    """The arguments, the duration and the fields of each golden plan."""
    for row in rows(f"{table}_gen_{real.name}"):
        numbers = [real.parse(cell) for cell in row[2:]]
        yield numbers[:7], numbers[7], numbers[8:]


def check_plan(real, family, golden, **choices):
    """Plans, compares, and returns the move of the golden fields."""
    arguments, duration, fields = golden
    assert len(fields) == FIELDS[family.__name__]
    if duration > 0:
        move = family(*arguments, **choices)
        assert real.bits(move.fields) == real.bits(fields), arguments
        assert real.bits(move.t) == real.bits(duration)
    else:
        with pytest.raises(ValueError, match="no such move|infinite or not a number|is not a number|a limit must leave room|have the same sign"):
            family(*arguments, **choices)
    return family.from_fields(fields)


def check_evaluations(real, table, moves, quantities):
    """Compares each golden evaluation with the value at a float and with the value of an array."""
    cases = collections.defaultdict(list)
    for case, *cells in rows(f"{table}_eval_{real.name}"):
        cases[int(case)].append([real.parse(cell) for cell in cells])
    assert set(cases) <= set(moves)
    for case, evaluations in cases.items():
        times, *columns = np.array(evaluations, dtype=real.dtype).T
        for quantity, golden in zip(quantities, columns, strict=True):
            evaluate = getattr(moves[case], quantity)
            assert real.bits(evaluate(times)) == real.bits(golden), (table, case, quantity)
            assert real.bits([evaluate(x) for x in times.tolist()]) == real.bits(golden)


@pytest.mark.parametrize("name", FIELDS)
def test_bells_and_trapezoids(real, name):
    family, table = getattr(real.module, name), name.lower()
    moves = {case: check_plan(real, family, golden) for case, golden in enumerate(plans(table, real))}
    quantities = ["position", "velocity", "acceleration", "jerk"][: 4 if name == "Bell" else 3]
    check_evaluations(real, table, moves, quantities)


@pytest.mark.parametrize("name", FIELDS)
def test_newest_saturation(real, name):
    family = getattr(real.module, name)
    for golden in plans(f"newest_{name.lower()}", real):
        check_plan(real, family, golden, newest_saturation=True)


@pytest.mark.parametrize("name, arguments, coefficients, quantities", POLYNOMIALS)
def test_polynomials(real, name, arguments, coefficients, quantities):
    family, table = getattr(real.module, name), name.lower()
    moves = {}
    for case, *cells in rows(f"{table}_gen_{real.name}"):
        numbers = [real.parse(cell) for cell in cells]
        given, golden = numbers[:arguments], numbers[arguments : arguments + coefficients]
        moves[int(case)] = family.from_coefficients(given[0], golden)
        if np.isfinite(golden).all():
            assert real.bits(family(*given).c) == real.bits(golden)
        else:
            with pytest.raises(ValueError, match="infinite or not a number|takes no time|beyond the range"):
                family(*given)
    check_evaluations(real, table, moves, ["position", "velocity", "acceleration", "jerk"][:quantities])


def do(axis, operation, numbers):
    """Does a golden operation; the clock stands still."""
    match operation:
        case "set":
            return axis.set(*numbers, now=0.0)
        case "start" | "stop" | "reset":
            return getattr(axis, operation)(now=0.0)
        case "advance":
            return axis.advance_timer_by(*numbers)
        case "get":
            return axis.setpoint(now=0.0)
        case "get_at":
            return axis.setpoint_at(*numbers)
    raise AssertionError(operation)


def test_claraty():
    real = REALS[0]
    script = None
    for row in rows("claraty_listing_f64"):
        if row[0] != script:
            script, axis = row[0], Trajectory(Mode.LISTING)
        outcome = do(axis, row[1], [real.parse(cell) for cell in row[2:6] if cell])
        assert axis.is_started == (row[16] == "1")
        if row[6]:
            golden = TrapezoidalProfile(*map(real.parse, row[6:15]))
            assert real.bits(axis.profile) == real.bits(golden), row
            assert (axis.is_trapezoidal, outcome) == (row[15] == "1", int(row[17]))
        if row[18]:
            assert real.bits(outcome) == real.bits([real.parse(cell) for cell in row[18:]]), row
