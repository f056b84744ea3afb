//! Is CLARAty's trapezoid right where no golden script looks: at ends, timers, ties, waypoints and clocks?

use Mode::{Corrected, Listing};
use approx::assert_abs_diff_eq;
use atraj::claraty::{EPS, Kind, LARGEST, Mode, OutOfRange, Profile, Route, Target, Trajectory, Warnings, Waypoints};
use support::claraty::{borders, corrected, moving, target};
use support::prelude::*;
use support::real::just_after;

const MODES: [Mode; 2] = [Corrected, Listing];

fn to(position: f64) -> Target {
    target([position, 2.0, 2.0, 2.0])
}

fn started<'w>(mode: Mode, route: impl Into<Route<'w>>) -> Trajectory<'w> {
    let mut axis = Trajectory::new(mode, 0.0);
    axis.set(route.into(), 0.0).unwrap();
    assert_eq!(axis.start(0.0), Warnings::default());
    axis
}

/// Axes long after the end of a motion to 10, and whether they take themselves for moving, as in the listing if nobody has read the end.
fn after_the_end() -> impl Iterator<Item = (Trajectory<'static>, bool)> {
    MODES.into_iter().flat_map(|mode| [(mode, true), (mode, false)]).map(|(mode, read)| {
        let mut axis = started(mode, to(10.0));
        if read {
            assert_eq!(axis.setpoint(100.0), State::at(10.0));
        }
        assert_eq!(axis.is_started(), !read);
        (axis, mode == Listing && !read)
    })
}

#[track_caller]
fn assert_fresh_start(axis: &mut Trajectory, now: f64) {
    axis.start(now);
    assert_eq!(axis.elapsed(now + 1.0), 1.0);
    assert_eq!(axis.setpoint(now + 1.0).position, 1.0);
}

#[track_caller]
fn assert_close(x: State<f64>, y: State<f64>) {
    for (x, y) in [(x.position, y.position), (x.velocity, y.velocity)] {
        assert_abs_diff_eq!(x, y, epsilon = 1e-9 * (1.0 + x.abs()));
    }
}

#[test]
fn a_start_after_the_end_is_fresh_unless_nobody_read_the_end_of_a_listing() {
    for (mut axis, carries_on) in after_the_end() {
        axis.set(to(20.0).into(), 100.0).unwrap();
        axis.start(100.0);
        assert_eq!(axis.setpoint(100.0).position, if carries_on { 10.0 } else { 0.0 }, "{axis:?}");
    }
}

#[test]
fn a_stop_after_the_end_is_idle_unless_nobody_read_the_end_of_a_listing() {
    for (mut axis, stands_still) in after_the_end() {
        let before = *axis.profile();
        let warnings = axis.stop(100.0);
        assert_eq!(axis.is_started(), stands_still);
        assert_eq!(axis.elapsed(100.5), 0.5);
        if stands_still {
            assert_eq!((warnings, axis.duration()), (Warnings::VELOCITY, 0.0));
            assert_eq!(axis.setpoint(100.0).position, 10.0);
        } else {
            assert_eq!((warnings, *axis.profile()), (Warnings::default(), before));
        }
    }
}

#[test]
fn a_motion_keeps_the_mode_in_which_it_began() {
    for (mode, other) in [(Corrected, Listing), (Listing, Corrected)] {
        let mut axis = started(mode, to(10.0));
        assert_eq!([axis.mode(), axis.motion_mode()], [mode, mode]);
        axis.set_mode(other);
        assert_eq!([axis.mode(), axis.motion_mode()], [other, mode]);
    }
}

#[test]
fn reset_and_idle_stop_set_the_timer_to_zero_and_keep_the_profile() {
    for mode in MODES {
        let mut axis = started(mode, to(10.0));
        axis.advance_timer_by(0.25);
        assert_eq!(axis.elapsed(1.0), 1.25);
        axis.reset(1.0);
        assert_eq!(axis.elapsed(1.0), 0.0);
        assert!(!axis.is_started());
        assert_eq!(axis.setpoint(2.0).position, 1.0);
        axis.stop(3.0);
        assert_eq!((axis.elapsed(3.0), axis.duration()), (0.0, 6.0));
    }
}

#[test]
fn before_the_start_is_the_start_when_corrected_and_zero_in_the_listing() {
    for (mode, before) in [(Corrected, moving(1.0, 2.0)), (Listing, State::default())] {
        let mut axis = started(mode, to(10.0));
        axis.set(to(20.0).into(), 1.0).unwrap();
        axis.start(1.0);
        assert_eq!(axis.setpoint_at(-1.0), before);
        assert!(axis.is_started());
    }
}

#[test]
fn a_look_beyond_the_end_ends_the_motion_only_in_the_listing() {
    for mode in MODES {
        let mut axis = started(mode, to(10.0));
        for t in [100.0, f64::NAN] {
            assert_eq!(axis.setpoint_at(t), State::at(10.0));
            assert_eq!(axis.is_started(), mode == Corrected);
        }
    }
}

#[test]
fn no_time_to_cruise_is_a_triangle() {
    for mode in MODES {
        let profile = *started(mode, to(2.0)).profile();
        assert_eq!(borders(&profile), [1.0, 1.0, 2.0]);
        assert_eq!(profile.kind, Kind::Triangular);
        assert_eq!((profile.velocity, profile.p_at_t1), (2.0, 1.0));
    }
}

#[test]
fn a_root_at_zero_is_no_switching_time() {
    let (start, target) = (moving(1.0, 2.0), target([2.0, 4.0, 2.0, 2.0]));
    let mut listing = Profile::default();
    assert_eq!(listing.plan_listing(start, target), Warnings::SWITCH);
    assert_eq!((listing.t1, listing.velocity), (1.0, 4.0));
    let (profile, warnings) = corrected(start, target);
    assert_eq!(warnings, Warnings::default());
    assert_eq!(borders(&profile), [0.0, 0.0, 1.0]);
    assert_eq!(profile.setpoint(0.5).position, 1.75);
}

#[test]
fn the_smallest_way_of_a_listing_is_a_motion() {
    for (way, moves) in [(just_after(EPS), true), (EPS, true), (0.999 * EPS, false)] {
        let mut listing = Profile::default();
        listing.plan_listing(moving(0.0, 0.0), to(way));
        assert_eq!(listing.tf > 0.0, moves, "{way}");
    }
}

#[test]
fn a_short_move_keeps_the_type_in_the_listing() {
    let mut listing = *started(Listing, to(10.0)).profile();
    assert_eq!(listing.kind, Kind::Trapezoidal);
    listing.plan_listing(moving(5.0, 1.0), to(5.0 + 0.5 * EPS));
    assert_eq!(listing.kind, Kind::Trapezoidal);
    assert_eq!(borders(&listing), [0.0, 0.0, 0.5]);
    assert_eq!(listing.final_position, 5.25 + 0.5 * EPS);
}

#[test]
fn limits_count_by_magnitude() {
    let negative = target([10.0, -2.0, -2.0, -2.0]);
    for mode in MODES {
        assert_eq!(started(mode, negative).profile(), started(mode, to(10.0)).profile());
    }
}

#[test]
fn limits_are_raised_to_eps() {
    let rates = Warnings::ACCELERATION | Warnings::DECELERATION;
    let (rest, all) = (State::default(), rates | Warnings::VELOCITY);
    for tiny in [0.0, -0.0, 0.5 * EPS] {
        let target = target([10.0, tiny, tiny, tiny]);
        let (mut profile, warnings) = corrected(rest, target);
        assert_eq!((warnings, warnings.bits()), (all, 7));
        assert_eq!((profile.velocity, profile.acceleration), (EPS, EPS));
        assert_eq!(profile.plan_listing(rest, target), all);
        assert_eq!(profile.plan_stop(rest, target), rates);
    }
}

#[test]
fn a_motion_that_brakes_at_once_brakes_from_the_first_instant() {
    let (profile, _) = corrected(moving(0.0, 2.0), target([0.5, 2.0, 1.0, 4.0]));
    assert_eq!(profile.setpoint(0.0).acceleration, -4.0);
}

/// The square of the peak velocity is below the range of a number.
#[test]
fn the_smallest_ways_are_motions() {
    for way in [1.8e-314, 1e-320, 5e-324] {
        let (profile, _) = corrected(State::at(0.0), target([way, 1.0, EPS, 2.0 * EPS]));
        assert!(borders(&profile).iter().all(|t| t.is_finite()), "{way}");
        assert_eq!(profile.setpoint(just_after(profile.tf)), State::at(way));
    }
}

#[test]
fn an_empty_move_stands_still() {
    let (profile, _) = corrected(State::at(3.0), to(3.0));
    assert_eq!(profile.tf, 0.0);
    assert!([-1.0, 0.0, 1.0].iter().all(|&t| profile.setpoint(t) == State::at(3.0)));
}

#[test]
fn a_copy_of_a_running_trajectory_runs_on_its_own() {
    let mut axis = started(Corrected, to(10.0));
    let (mut copy, mut alone) = (axis, started(Corrected, to(10.0)));
    axis.set(to(-10.0).into(), 1.0).unwrap();
    axis.start(1.0);
    for step in 0..80 {
        let now = 0.1 * f64::from(step);
        axis.setpoint(1.0 + now);
        assert_eq!(copy.setpoint(now), alone.setpoint(now));
    }
    assert_ne!(axis.setpoint(3.0), alone.setpoint(2.0));
}

const POSITIONS: [f64; 5] = [3.0, 5.0, 5.0, -4.0, 1.0];
const VELOCITIES: [f64; 5] = [1.0, 20.0, 1.0, 3.0, 0.5];
const ACCELERATIONS: [f64; 5] = [2.0, 1.0, 4.0, 0.5, 8.0];

fn waypoints() -> Waypoints<'static> {
    Waypoints::new(&POSITIONS, &VELOCITIES, &ACCELERATIONS).unwrap()
}

fn single_moves(mut from: State<f64>) -> [(f64, Profile); 5] {
    let mut begins = 0.0;
    [0, 1, 2, 3, 4].map(|i| {
        let rate = ACCELERATIONS[i];
        let (profile, _) = corrected(from, target([POSITIONS[i], VELOCITIES[i], rate, rate]));
        let leg = (begins, profile);
        begins += profile.tf;
        from = State::at(POSITIONS[i]);
        leg
    })
}

fn setpoint_of(moves: &[(f64, Profile)], t: f64) -> State<f64> {
    let mut at_or_after = moves.iter().filter(|(begins, leg)| t - begins <= leg.tf);
    let (begins, leg) = at_or_after.next().unwrap_or(&moves[4]);
    leg.setpoint(t - begins)
}

#[test]
fn waypoints_are_the_sum_of_single_moves_at_any_time() {
    let mut random = Random(3);
    for (mode, now) in MODES.into_iter().flat_map(|mode| [100.0, 0.7, 3.0].map(|now| (mode, now))) {
        let mut axis = started(mode, to(10.0));
        let present = axis.setpoint(now);
        let mut from = if axis.is_started() { present } else { State::default() };
        from.acceleration = 0.0;
        axis.set(waypoints().into(), now).unwrap();
        assert_eq!(axis.setpoint(now), present, "set moves nothing");
        assert_eq!(axis.start(now), Warnings::default());

        let moves = single_moves(from);
        let duration = moves[4].0 + moves[4].1.tf;
        assert_eq!(axis.duration(), duration);
        assert_eq!(*axis.profile(), moves[0].1, "the first leg is in hand");
        for _ in 0..20_000 {
            let t = random.between(0.0, 1.1 * duration);
            assert_eq!(axis.setpoint_at(t), setpoint_of(&moves, t), "t = {t}");
            assert!(t <= duration || axis.is_started() == (mode == Corrected));
        }
        for (begins, profile) in &moves {
            let t = begins + profile.tf;
            assert_close(axis.setpoint_at(t), setpoint_of(&moves, t));
        }
        assert_eq!(axis.setpoint_at(f64::INFINITY), State::at(1.0));
    }
}

#[test]
fn a_motion_along_waypoints_ends_once() {
    let mut axis = started(Corrected, waypoints());
    let duration = axis.duration();
    for step in 0..=1000 {
        axis.setpoint(duration * f64::from(step) / 1000.0);
        assert!(axis.is_started());
    }
    assert_eq!(axis.setpoint(just_after(duration)), State::at(1.0));
    assert!(!axis.is_started());
}

#[test]
fn a_stop_among_waypoints_brakes_at_the_rate_of_the_leg() {
    let mut axis = started(Corrected, waypoints());
    let (begins, profile) = single_moves(State::default())[3];
    let now = begins + 0.4 * profile.tf;
    let before = axis.setpoint(now);
    axis.stop(now);
    let rate = -before.velocity.signum() * ACCELERATIONS[3];
    assert_eq!(axis.profile().deceleration, rate);
    assert_eq!(axis.setpoint(now).position, before.position);
    let duration = axis.duration();
    assert_eq!(duration, -before.velocity / rate);
    assert_eq!(axis.setpoint(now + duration + 1.0).velocity, 0.0);
}

#[test]
fn a_set_lets_go_of_the_waypoints_and_ends_at_the_next_one() {
    let (begins, profile) = single_moves(State::default())[1];
    let now = begins + 0.5 * profile.tf;
    let mut axis = started(Corrected, waypoints());
    let before = axis.setpoint(now);
    axis.setpoint_at(0.0); // The outcome must not depend on the last look.
    axis.set(to(0.0).into(), now).unwrap();
    assert_eq!(axis.setpoint(now), before);
    assert_eq!(axis.duration(), begins + profile.tf);
    assert_eq!(axis.setpoint_at(1000.0), State::at(POSITIONS[1]));
    assert_eq!(axis.setpoint_at(0.0), State::at(POSITIONS[0]));
    axis.start(now);
    assert_close(axis.setpoint(now), before);
}

#[test]
fn waypoints_need_a_limit_each() {
    let [five, four, none]: [&[f64]; 3] = [&POSITIONS, &POSITIONS[1..], &[]];
    for [p, v, a] in [[five, four, five], [five, five, four], [none; 3]] {
        assert!(Waypoints::new(p, v, a).is_none());
    }
    assert!(Waypoints::uniform(&[], 1.0, 1.0).is_none());
}

#[test]
fn a_listing_that_ends_at_no_number_is_over_at_its_first_instant() {
    let mut listing = Profile::default();
    listing.plan_listing(moving(1.0, f64::NAN), to(10.0));
    assert!(borders(&listing).iter().all(|t| t.is_nan()));
    assert!(listing.is_over(0.0) && listing.is_over(1.0) && !listing.is_over(-1.0));
    assert_eq!(listing.setpoint(0.0), State::at(10.0));
}

#[test]
fn a_set_refuses_what_would_overflow_and_changes_nothing() {
    assert_eq!(OutOfRange.to_string(), "a number is larger than 1e60, or is not a number");
    let large = [1.001 * LARGEST, f64::MAX, f64::INFINITY, f64::NAN];
    for wrong in large.into_iter().flat_map(|large| [large, -large]) {
        let (good, bad) = ([1.0, 2.0], [1.0, wrong]);
        let [mut axis, mut alone] = [(); 2].map(|()| started(Corrected, to(10.0)));
        let wrong_targets = [0, 1, 2, 3].map(|number| {
            let mut numbers = [1.0, 2.0, 2.0, 2.0];
            numbers[number] = wrong;
            Route::from(target(numbers))
        });
        let wrong_waypoints = [
            Waypoints::new(&bad, &good, &good),
            Waypoints::new(&good, &bad, &good),
            Waypoints::new(&good, &good, &bad),
            Waypoints::uniform(&bad, 1.0, 1.0),
            Waypoints::uniform(&good, wrong, 1.0),
            Waypoints::uniform(&good, 1.0, wrong),
        ];
        for route in wrong_targets.into_iter().chain(wrong_waypoints.map(|waypoints| waypoints.unwrap().into())) {
            assert_eq!(axis.set(route, 1.0), Err(OutOfRange), "{route:?}");
        }
        for axis in [&mut axis, &mut alone] {
            axis.start(2.0);
        }
        assert_eq!(axis.profile(), alone.profile());
        assert_eq!(axis.set(target([-LARGEST, LARGEST, LARGEST, LARGEST]).into(), 3.0), Ok(()));
    }
}

/// Whatever the limits say. No sum of finite setpoints overflows here.
#[test]
fn a_corrected_setpoint_is_finite_up_to_the_largest_numbers() {
    let mut random = Random(11);
    let mut farthest = 0.0f64;
    for _ in 0..100_000 {
        let mut axis = Trajectory::new(Corrected, 0.0);
        let mut now = 0.0;
        for _ in 0..6 {
            let mut target = target([(); 4].map(|()| match random.bits() % 4 {
                0 => LARGEST,
                1 => 0.0,
                2 => random.magnitude(-80.0, 60.0),
                _ => random.magnitude(-3.0, 3.0),
            }));
            target.position *= random.sign();
            axis.set(target.into(), now).unwrap();
            let _ = if random.one_in(8) { axis.stop(now) } else { axis.start(now) };
            let [t1, t2, tf] = borders(axis.profile());
            let at = random.between(0.0, 1.0) * axis.duration();
            for t in [0.0, t1, just_after(t1), 0.5 * t1, t2, just_after(t2), tf, at] {
                let setpoint = axis.setpoint_at(t);
                let sum = setpoint.position + setpoint.velocity + setpoint.acceleration;
                assert!(sum.is_finite(), "{setpoint:?} at {t}");
                farthest = farthest.max(setpoint.position.abs());
            }
            now += at;
        }
    }
    assert!(farthest > 1e100, "{farthest}");
}

#[test]
fn a_change_of_clock_does_not_show_in_a_running_motion() {
    let mut axis = started(Corrected, to(10.0));
    axis.change_clock(1.5, 1000.0);
    assert_eq!(axis.elapsed(1000.25), 1.75);
    axis.reset(1001.0);
    axis.change_clock(1001.0, 0.0);
    assert_eq!(axis.elapsed(0.5), 0.5);
}

#[test]
fn a_clock_without_a_number_forgets_the_motion() {
    // The last change resets the timer too, as the new clock has a number.
    let resets: [(fn(&mut Trajectory), _, _); 5] = [
        (|axis| axis.reset(f64::NAN), 1.5, 1.5),
        (|axis| axis.reset(f64::INFINITY), 1.5, 1.5),
        (|axis| axis.reset(f64::NEG_INFINITY), 1.5, 1.5),
        (|axis| axis.change_clock(1.0, f64::NAN), 1.5, 1.5),
        (|axis| axis.change_clock(f64::NAN, 1000.0), 1000.5, 0.5),
    ];
    for (reset, now, elapsed) in resets {
        let mut axis = started(Corrected, to(10.0));
        reset(&mut axis);
        assert!(!axis.is_started());
        assert_eq!(axis.elapsed(now), elapsed);
        assert_fresh_start(&mut axis, now + 0.5);
    }
}

#[test]
fn a_huge_advance_of_the_timer_lasts_until_the_next_start() {
    for advances in [[1e308, 1e308], [1e17, 0.0], [-1e17, 0.0]] {
        let mut axis = started(Corrected, to(10.0));
        for seconds in advances {
            axis.advance_timer_by(seconds);
            assert!(axis.elapsed(0.0).is_finite(), "{seconds}");
        }
        axis.reset(0.5);
        assert_fresh_start(&mut axis, 0.5);
        axis.advance_timer_by(0.25);
        assert_eq!(axis.elapsed(1.5), 1.25);
    }
}
