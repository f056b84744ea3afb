//! Does `check` see what is wrong with a move: what it exceeds, where it jumps, which phases are none?

use support::online::state_of;
use support::prelude::*;

const MOVES: usize = 2_000;

/// A fault that is planted: what it is called, and what `check` has to find then.
type Fault<R> = (&'static str, Findings, fn(&mut Move<R>, &mut Limits<R>));

/// Makes a number wrong by little, but far above roundings.
fn spoil<R: Real>(x: &mut R) {
    *x = *x + R::of(1e-2 * (1.0 + x.widen().abs()));
}

fn middle<R: Real>(planned: &mut Move<R>) -> &mut Phase<R> {
    &mut planned.phase[1 + planned.count as usize / 2]
}

fn end<R: Real>(planned: &mut Move<R>) -> &mut Phase<R> {
    &mut planned.phase[planned.count as usize]
}

fn faults<R: Real>() -> Vec<Fault<R>> {
    let (jumps, jerk) = (Findings::JUMPS, Findings::EXCEEDS_JERK);
    vec![
        ("a velocity beyond its limit", Findings::EXCEEDS_VELOCITY, |planned, limits| {
            let reached = planned.extremes();
            let (low, high) = (reached.lowest.velocity, reached.highest.velocity);
            let (limit, most) = if high > -low { (&mut limits.vmax, high) } else { (&mut limits.vmin, low) };
            *limit = R::of(0.99) * most;
        }),
        ("an acceleration above its limit", Findings::EXCEEDS_ACCELERATION, |planned, limits| {
            limits.amax = R::of(0.99) * planned.extremes().highest.acceleration;
        }),
        ("an acceleration below its limit", Findings::EXCEEDS_ACCELERATION, |planned, limits| {
            limits.amin = R::of(0.99) * planned.extremes().lowest.acceleration;
        }),
        ("a jerk above its limit", jerk, |_, limits| limits.jmax = R::of(0.99) * limits.jmax),
        ("a jerk below its limit", jerk, |_, limits| limits.jmin = R::of(0.99) * limits.jmin),
        ("a step of the acceleration", jerk, |planned, _| spoil(&mut middle(planned).acceleration)),
        ("a step of the velocity", jumps, |planned, _| spoil(&mut middle(planned).velocity)),
        ("a step of the position", jumps, |planned, _| spoil(&mut middle(planned).position)),
        ("another start", jumps, |planned, _| spoil(&mut planned.phase[0].position)),
        ("another end", jumps, |planned, _| spoil(&mut end(planned).position)),
        ("another velocity at the end", jumps, |planned, _| spoil(&mut end(planned).velocity)),
        ("a late end", jumps, |planned, _| spoil(&mut planned.t)),
        ("a late phase", jumps, |planned, _| spoil(&mut middle(planned).start)),
        ("less than no time", jumps, |planned, _| planned.phase[1].duration = -planned.phase[1].duration),
        ("a missing phase", jumps, |planned, _| planned.count -= 1),
        ("too many phases", jumps, |planned, _| planned.count = 16),
        ("an end that lasts", jumps, |planned, _| end(planned).duration = R::ONE),
        ("a jerk after the end", jumps, |planned, _| end(planned).jerk = R::ONE),
        ("a start that lasts", jumps, |planned, _| planned.phase[0].duration = R::ONE),
        ("a start a rounding before 0", jumps, |planned, _| planned.phase[0].start = -R::MACHINE_EPSILON * planned.t),
        ("a start of a rounding", jumps, |planned, _| planned.phase[0].duration = R::MACHINE_EPSILON * planned.t),
    ]
}

/// A plan within symmetric limits in which each limit is reached, so each fault spoils it.
fn clean<R: Real>(random: &mut Random) -> (Limits<R>, Move<R>) {
    let [v, a, j, jerk, acceleration, velocity] = [(); 6].map(|()| R::of(random.between(1.0, 4.0)));
    let limits = Limits { vmin: -v, amin: -a, jmin: -j, ..Limits::symmetric(jerk, acceleration, velocity) };
    let start: State<R> = state_of([random.between(-5.0, 5.0), random.between(-0.5, 0.5), 0.0]);
    let far = R::of(start.position.widen() + random.sign() * 50.0);
    (limits, online::plan(&limits, start, State::at(far)))
}

fn every_fault_is_seen<R: Real>() {
    let mut random = Random::seeded(1);
    for _ in 0..MOVES {
        let (limits, planned) = clean::<R>(&mut random);
        let clean = planned.check(&limits).expect("an answer");
        assert!((Findings::OVERSHOOTS).contains(clean), "{clean:?} {planned:?}");
        for (what, expected, plant) in faults::<R>() {
            let (mut spoiled, mut within) = (planned, limits);
            plant(&mut spoiled, &mut within);
            let found = spoiled.check(&within).expect("an answer");
            assert!(found.contains(expected), "{what}: {found:?} {spoiled:?} {within:?}");
        }
    }
}

fn what_is_no_number_is_refused<R: Real>() {
    let (limits, planned) = clean::<R>(&mut Random::seeded(3));
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY].map(R::of) {
        assert_eq!(Move { t: bad, ..planned }.check(&limits), Err(Error::NotFinite));
        for index in 0..16 {
            let is_read = index <= planned.count as usize;
            let expected = if is_read { Err(Error::NotFinite) } else { planned.check(&limits) };
            let mut spoiled = [planned; 3];
            spoiled[0].phase[index].duration = bad;
            spoiled[1].phase[index].position = bad;
            spoiled[2].phase[index].jerk = bad;
            for spoiled in spoiled {
                assert_eq!(spoiled.check(&limits), expected);
            }
        }
    }
    for within in [Limits { vmax: R::ZERO, ..limits }, Limits { jmin: limits.jmax, ..limits }] {
        assert_eq!(planned.check(&within), Err(Error::Limits));
    }
    assert_eq!(planned.check(&Limits { amin: R::NAN, ..limits }), Err(Error::NotFinite));
}

/// The first of the changes is none.
fn judge<P: Copy>(clean: P, changes: &[fn(&mut P)], check: impl Fn(&P) -> Result<Findings, Error>) {
    for (index, change) in changes.iter().enumerate() {
        let mut profile = clean;
        change(&mut profile);
        let found = check(&profile).expect("numbers");
        assert_eq!((found.contains(Findings::JUMPS), found.is_empty()), (index > 0, index == 0), "{index} {found:?}");
    }
}

/// Phases of a double-S and of a trapezoid, there and back, that are not in order or do not meet.
fn spoiled_profiles_are_seen<R: Real>() {
    let [acceleration, velocity] = [2.0, 3.0].map(R::of);
    for way in [20.0, -20.0] {
        let boundary = Boundary::rest_to_rest(R::ZERO, R::of(way));
        let bell = Bell::fastest(R::ONE, acceleration, velocity, boundary).expect("a plan");
        let trap = Trap::fastest(velocity, acceleration, -acceleration, boundary).expect("a plan");
        let bells: [fn(&mut Bell<R>); 6] = [
            |_| {},
            |bell| bell.taj = bell.ta,
            |bell| bell.tdj = bell.td,
            |bell| bell.tv = bell.tv + bell.t,
            |bell| bell.v0 = bell.v0 + R::ONE,
            |bell| bell.p1 = bell.p1 + R::ONE,
        ];
        judge(bell, &bells, |bell| bell.check(R::ONE, acceleration, velocity));
        let traps: [fn(&mut Trap<R>); 8] = [
            |_| {},
            |trap| trap.ta = -R::ONE,
            |trap| trap.ta = trap.cruise_end + R::ONE,
            |trap| trap.cruise_end = trap.t + R::ONE,
            |trap| trap.p0 = trap.p0 + R::ONE,
            |trap| trap.pa = trap.pa + R::ONE,
            |trap| trap.pd = trap.pd + R::ONE,
            |trap| trap.v1 = trap.v1 + R::ONE,
        ];
        judge(trap, &traps, |trap| trap.check(velocity, acceleration, -acceleration));
    }
}

/// A limit of 0 is kept by a cruise, and the order of the phases counts by itself. At its end a cruise has the deceleration of the plan.
fn a_cruise_needs_no_acceleration<R: Real>() {
    let [zero, one, few] = [0.0, 1.0, 4.0].map(R::of);
    for sign in [one, -one] {
        let boundary = Boundary { v0: sign, v1: sign, ..Boundary::rest_to_rest(zero, sign * few) };
        let cruise = Trap::fastest(one, one, -one, boundary).expect("a plan");
        let clean = Ok(Findings::default());
        assert_eq!(cruise.check(one, zero, -sign), clean);
        assert_eq!(cruise.check(one, -sign, zero), clean);
        assert_eq!(cruise.check(one, sign, sign), Err(Error::Limits));
        assert_eq!(cruise.check(one, R::NAN, -sign), Err(Error::NotFinite));
        assert_eq!(Bell::fastest(one, one, one, boundary).expect("a plan").check(zero, zero, one), clean);
        let beyond = Trap { cruise_end: cruise.t + one, pd: cruise.p1 + sign, a1: zero, ..cruise };
        let found = beyond.check(one, one, -one).expect("numbers");
        assert!(found.contains(Findings::JUMPS), "{found:?}");
    }
}

/// A double-S that only accelerates or only brakes has the jerk of its one ramp.
fn one_ramp_has_a_jerk<R: Real>() {
    let [zero, half, one] = [0.0, 0.5, 1.0].map(R::of);
    for [v0, v1] in [[zero, one], [one, zero]] {
        let [p0, p1] = [zero, one];
        let ramp = Bell::fastest(one, one, one, Boundary { p0, p1, v0, v1 }).expect("a plan");
        assert_eq!([ramp.taj > zero, ramp.tdj > zero], [v1 > v0, v0 > v1]);
        assert_eq!(ramp.check(one, one, one), Ok(Findings::default()));
        assert_eq!(ramp.check(half, one, one), Ok(Findings::EXCEEDS_JERK));
    }
}

/// A move of these phases: start, duration, position, velocity, acceleration and jerk. The last one is the end.
fn of_phases<R: Real>(rows: &[[f64; 6]]) -> Move<R> {
    let mut planned = Move { count: rows.len() as u32 - 1, ..Move::default() };
    for (phase, row) in planned.phase.iter_mut().zip(rows) {
        let [start, duration, position, velocity, acceleration, jerk] = row.map(R::of);
        *phase = Phase { start, duration, position, velocity, acceleration, jerk };
        planned.t = start;
    }
    planned
}

/// The second phase ends 128 ulps above the limit, and the third one begins only 64 above it.
fn a_phase_may_end_too_fast<R: Real>() {
    let few = 384.0 * R::MACHINE_EPSILON.widen();
    let planned = of_phases::<R>(&[
        [0.0, 0.0, 0.0, 2.0 * few, 0.0, 0.0],
        [0.0, 1.0, 0.0, 2.0 * few, 0.0, 1.0],
        [1.0, 1.0, 1.0 / 6.0, 0.5 + 2.0 * few, 1.0, -1.0],
        [2.0, 1.0, 1.0, 1.0 + few, 0.0, -1.0],
        [3.0, 1.0, 11.0 / 6.0, 0.5, -1.0, 1.0],
        [4.0, 0.0, 2.0, 0.0, 0.0, 0.0],
    ]);
    let found = planned.check(&Limits::symmetric(R::ONE, R::ONE, R::ONE));
    assert!(found.is_ok_and(|found| found.contains(Findings::EXCEEDS_VELOCITY)), "{found:?}");
}

/// A start that does not last would accelerate until the next phase begins, 64 ulps of the duration later.
fn a_phase_of_no_duration_has_no_gap<R: Real>() {
    let gap = 64e3 * R::MACHINE_EPSILON.widen();
    let planned = of_phases::<R>(&[
        [0.0, 0.0, 0.0, 1.0, 10.0, 0.0],
        [gap, 0.1, 0.0, 1.0, -10.0, 0.0],
        [gap + 0.1, 999.9 - gap, 0.05, 0.0, 0.0, 0.0],
        [1000.0, 0.0, 0.05, 0.0, 0.0, 0.0],
    ]);
    let found = planned.check(&Limits::symmetric(R::INFINITY, R::of(10.0), R::ONE));
    assert!(found.is_ok_and(|found| found.contains(Findings::JUMPS)), "{found:?}");
}

test_both_reals!(
    every_fault_is_seen, what_is_no_number_is_refused, spoiled_profiles_are_seen, a_cruise_needs_no_acceleration,
    one_ramp_has_a_jerk, a_phase_may_end_too_fast, a_phase_of_no_duration_has_no_gap
);

/// A set is written as a sentence for each finding, and for the programmer as their names.
#[test]
fn findings_are_told() {
    let found = Findings::EXCEEDS_VELOCITY | Findings::OVERSHOOTS;
    assert_eq!(found.to_string(), "the velocity is above its limit; the move leaves the positions between its ends");
    assert_eq!(format!("{found:?}"), "Findings(EXCEEDS_VELOCITY | OVERSHOOTS)");
    assert_eq!(Findings::default().to_string(), "nothing is wrong");
    assert_eq!(format!("{:?}", Findings::default()), "Findings()");
}
