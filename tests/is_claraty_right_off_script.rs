//! Is CLARAty's trapezoid right where no golden script looks: at ends, timers, ties, waypoints and clocks?

use approx::assert_abs_diff_eq;
use atraj::State;
use atraj::claraty::{
    EPS, Kind, LARGEST, Mode, OutOfRange, Profile, Target, Trajectory, Warnings, Waypoints,
};
use support::Random;
use support::real::just_after;

const MODES: [Mode; 2] = [Mode::Corrected, Mode::Listing];

fn to(position: f64) -> Target {
    target([position, 2.0, 2.0, 2.0])
}

fn target([position, velocity, acceleration, deceleration]: [f64; 4]) -> Target {
    Target {
        position,
        velocity,
        acceleration,
        deceleration,
    }
}

fn state(position: f64, velocity: f64) -> State<f64> {
    State {
        position,
        velocity,
        acceleration: 0.0,
    }
}

fn at_rest(position: f64) -> State<f64> {
    state(position, 0.0)
}

fn corrected(start: State<f64>, target: Target) -> (Profile, Warnings) {
    let mut profile = Profile::default();
    let warnings = profile.plan_corrected(start, target);
    (profile, warnings)
}

fn started(mode: Mode, target: Target) -> Trajectory<'static> {
    let mut axis = Trajectory::new(mode, 0.0);
    axis.set(target.into(), 0.0).unwrap();
    assert_eq!(axis.start(0.0), Warnings::default());
    axis
}

#[track_caller]
fn assert_close(x: State<f64>, y: State<f64>) {
    for (x, y) in [(x.position, y.position), (x.velocity, y.velocity)] {
        assert_abs_diff_eq!(x, y, epsilon = 1e-9 * (1.0 + x.abs()));
    }
}

fn along(waypoints: Waypoints<'_>) -> Trajectory<'_> {
    let mut axis = Trajectory::new(Mode::Corrected, 0.0);
    axis.set(waypoints.into(), 0.0).unwrap();
    axis.start(0.0);
    axis
}

#[test]
fn a_start_after_the_end_is_a_fresh_one() {
    for mode in MODES {
        let mut axis = started(mode, to(10.0));
        assert_eq!(axis.setpoint(100.0), at_rest(10.0));
        assert!(!axis.is_started());
        axis.start(100.0);
        assert_eq!(axis.setpoint(100.0).position, 0.0, "{mode:?}");
    }
}

#[test]
fn a_start_after_an_end_that_nobody_read_is_fresh_only_when_corrected() {
    for (mode, position) in [(Mode::Corrected, 0.0), (Mode::Listing, 10.0)] {
        let mut axis = started(mode, to(10.0));
        assert!(axis.is_started());
        axis.set(to(20.0).into(), 100.0).unwrap();
        axis.start(100.0);
        assert_eq!(axis.setpoint(100.0).position, position, "{mode:?}");
    }
}

#[test]
fn a_stop_after_the_end_is_idle() {
    for mode in MODES {
        let mut axis = started(mode, to(10.0));
        axis.setpoint(100.0);
        let profile = *axis.profile();
        assert_eq!(axis.stop(100.0), Warnings::default());
        assert!(!axis.is_started());
        assert_eq!(*axis.profile(), profile);
        assert_eq!(axis.elapsed(100.5), 0.5);
    }
}

#[test]
fn a_stop_after_an_end_that_nobody_read_stands_still_in_the_listing() {
    let mut axis = started(Mode::Listing, to(10.0));
    assert_eq!(axis.stop(100.0), Warnings::VELOCITY);
    assert!(axis.is_started());
    assert_eq!(axis.setpoint(100.0).position, 10.0);
    assert_eq!(axis.duration(), 0.0);

    let mut axis = started(Mode::Corrected, to(10.0));
    assert_eq!(axis.stop(100.0), Warnings::default());
    assert!(!axis.is_started());
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
        assert_eq!(axis.elapsed(3.0), 0.0);
        assert_eq!(axis.duration(), 6.0);
    }
}

#[test]
fn before_the_start_is_the_start_when_corrected_and_zero_in_the_listing() {
    for (mode, before) in [
        (Mode::Corrected, state(1.0, 2.0)),
        (Mode::Listing, State::default()),
    ] {
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
        assert_eq!(axis.setpoint_at(100.0), at_rest(10.0));
        assert_eq!(axis.is_started(), mode == Mode::Corrected);
        assert_eq!(axis.setpoint_at(f64::NAN), at_rest(10.0));
        assert_eq!(axis.is_started(), mode == Mode::Corrected);
    }
}

#[test]
fn no_time_to_cruise_is_a_triangle() {
    for mode in MODES {
        let axis = started(mode, to(2.0));
        let profile = axis.profile();
        assert_eq!(profile.kind, Kind::Triangular);
        assert_eq!((profile.t1, profile.t2, profile.tf), (1.0, 1.0, 2.0));
        assert_eq!((profile.velocity, profile.p_at_t1), (2.0, 1.0));
    }
}

#[test]
fn a_root_at_zero_is_no_switching_time() {
    let (start, target) = (state(1.0, 2.0), target([2.0, 4.0, 2.0, 2.0]));
    let mut listing = Profile::default();
    assert_eq!(listing.plan_listing(start, target), Warnings::SWITCH);
    assert_eq!((listing.t1, listing.velocity), (1.0, 4.0));

    let (profile, warnings) = corrected(start, target);
    assert_eq!(warnings, Warnings::default());
    assert_eq!((profile.t1, profile.t2, profile.tf), (0.0, 0.0, 1.0));
    assert_eq!(profile.setpoint(0.5).position, 1.75);
}

#[test]
fn a_short_move_keeps_the_type_in_the_listing() {
    let mut listing = Profile::default();
    listing.plan_listing(State::default(), to(10.0));
    assert_eq!(listing.kind, Kind::Trapezoidal);
    listing.plan_listing(state(5.0, 1.0), to(5.0 + 0.5 * EPS));
    assert_eq!(listing.kind, Kind::Trapezoidal);
    assert_eq!((listing.t1, listing.t2, listing.tf), (0.0, 0.0, 0.5));
    assert_eq!(listing.final_position, 5.25 + 0.5 * EPS);
}

#[test]
fn limits_count_by_magnitude_and_are_raised_to_eps() {
    let all = Warnings::ACCELERATION | Warnings::DECELERATION | Warnings::VELOCITY;
    let negative = target([10.0, -2.0, -2.0, -2.0]);
    let mut listing = Profile::default();
    assert_eq!(
        listing.plan_listing(State::default(), negative),
        Warnings::default()
    );
    assert_eq!(
        corrected(State::default(), negative),
        corrected(State::default(), to(10.0))
    );
    for tiny in [0.0, -0.0, 0.5 * EPS] {
        let target = target([10.0, tiny, tiny, tiny]);
        let (profile, warnings) = corrected(State::default(), target);
        assert_eq!((warnings, warnings.bits()), (all, 7));
        assert_eq!((profile.velocity, profile.acceleration), (EPS, EPS));
        assert_eq!(listing.plan_listing(State::default(), target), all);
    }
    let warnings = Profile::default().plan_stop(State::default(), Target::default());
    assert_eq!(warnings, Warnings::ACCELERATION | Warnings::DECELERATION);
}

#[test]
fn a_motion_that_brakes_at_once_brakes_from_the_first_instant() {
    let (profile, _) = corrected(state(0.0, 2.0), target([0.5, 2.0, 1.0, 4.0]));
    assert_eq!(profile.setpoint(0.0).acceleration, -4.0);
}

#[test]
fn an_empty_move_stands_still() {
    let (profile, _) = corrected(state(3.0, 0.0), to(3.0));
    assert_eq!(profile.tf, 0.0);
    for t in [-1.0, 0.0, 1.0] {
        assert_eq!(profile.setpoint(t), at_rest(3.0));
    }
}

#[test]
fn a_copy_of_a_running_trajectory_runs_on_its_own() {
    let mut axis = started(Mode::Corrected, to(10.0));
    let mut copy = axis;
    axis.set(to(-10.0).into(), 1.0).unwrap();
    axis.start(1.0);
    let mut alone = started(Mode::Corrected, to(10.0));
    for step in 0..80 {
        let now = 0.1 * f64::from(step);
        axis.setpoint(1.0 + now);
        assert_eq!(copy.setpoint(now), alone.setpoint(now));
    }
    assert_ne!(axis.setpoint(3.0), alone.setpoint(2.0));
}

#[test]
fn a_change_of_clock_does_not_show_in_a_running_motion() {
    let mut axis = started(Mode::Corrected, to(10.0));
    axis.change_clock(1.5, 1000.0);
    assert_eq!(axis.elapsed(1000.25), 1.75);
    axis.reset(1001.0);
    axis.change_clock(1001.0, 0.0);
    assert_eq!(axis.elapsed(0.5), 0.5);
}

const POSITIONS: [f64; 5] = [3.0, 5.0, 5.0, -4.0, 1.0];
const VELOCITIES: [f64; 5] = [1.0, 20.0, 1.0, 3.0, 0.5];
const ACCELERATIONS: [f64; 5] = [2.0, 1.0, 4.0, 0.5, 8.0];

fn waypoints() -> Waypoints<'static> {
    Waypoints::new(&POSITIONS, &VELOCITIES, &ACCELERATIONS).unwrap()
}

/// The moves between the waypoints as single corrected profiles, each with its start time.
fn single_moves(mut from: State<f64>) -> Vec<(f64, Profile)> {
    let mut begins = 0.0;
    (0..POSITIONS.len())
        .map(|i| {
            let rate = ACCELERATIONS[i];
            let target = target([POSITIONS[i], VELOCITIES[i], rate, rate]);
            let (profile, _) = corrected(from, target);
            let leg = (begins, profile);
            begins += profile.tf;
            from = state(POSITIONS[i], 0.0);
            leg
        })
        .collect()
}

fn setpoint_of(moves: &[(f64, Profile)], t: f64) -> State<f64> {
    let (begins, profile) = moves
        .iter()
        .find(|(begins, profile)| t - begins <= profile.tf)
        .unwrap_or(moves.last().unwrap());
    profile.setpoint(t - begins)
}

#[test]
fn waypoints_are_the_sum_of_single_moves_at_any_time() {
    let mut random = Random(3);
    for mode in MODES {
        for retarget in [None, Some(0.7), Some(3.0)] {
            let mut axis = started(mode, to(10.0));
            let now = retarget.unwrap_or(100.0);
            let present = axis.setpoint(now);
            let from = retarget.map_or(State::default(), |_| {
                state(present.position, present.velocity)
            });
            axis.set(waypoints().into(), now).unwrap();
            assert_eq!(axis.setpoint(now), present, "set moves nothing");
            assert_eq!(axis.start(now), Warnings::default());

            let moves = single_moves(from);
            let (last_begins, last) = moves.last().unwrap();
            let duration = last_begins + last.tf;
            assert_eq!(axis.duration(), duration);
            assert_eq!(*axis.profile(), moves[0].1, "the first leg is in hand");
            for _ in 0..20_000 {
                let t = random.between(0.0, 1.1 * duration);
                assert_eq!(axis.setpoint_at(t), setpoint_of(&moves, t), "t = {t}");
                if t > duration {
                    assert_eq!(axis.is_started(), mode == Mode::Corrected);
                }
            }
            for (begins, profile) in &moves {
                let t = begins + profile.tf;
                assert_close(axis.setpoint_at(t), setpoint_of(&moves, t));
            }
            assert_eq!(axis.setpoint_at(f64::INFINITY), at_rest(1.0));
        }
    }
}

#[test]
fn a_motion_along_waypoints_ends_once() {
    let mut axis = along(waypoints());
    let duration = axis.duration();
    for step in 0..=1000 {
        axis.setpoint(duration * f64::from(step) / 1000.0);
        assert!(axis.is_started());
    }
    assert_eq!(axis.setpoint(just_after(duration)), at_rest(1.0));
    assert!(!axis.is_started());
}

#[test]
fn a_stop_among_waypoints_brakes_at_the_rate_of_the_leg() {
    let mut axis = along(waypoints());
    let (begins, profile) = single_moves(State::default())[3];
    let now = begins + 0.4 * profile.tf;
    let before = axis.setpoint(now);
    axis.stop(now);
    assert_eq!(
        axis.profile().deceleration,
        -before.velocity.signum() * ACCELERATIONS[3]
    );
    assert_eq!(axis.setpoint(now).position, before.position);
    let duration = axis.duration();
    assert_eq!(duration, before.velocity.abs() / ACCELERATIONS[3]);
    assert_eq!(axis.setpoint(now + duration + 1.0).velocity, 0.0);
}

#[test]
fn a_set_lets_go_of_the_waypoints_and_ends_at_the_next_one() {
    let (begins, profile) = single_moves(State::default())[1];
    let now = begins + 0.5 * profile.tf;
    let mut axis = along(waypoints());
    let before = axis.setpoint(now);
    axis.setpoint_at(0.0); // The outcome must not depend on the last look.
    axis.set(to(0.0).into(), now).unwrap();
    assert_eq!(axis.setpoint(now), before);
    assert_eq!(axis.duration(), begins + profile.tf);
    assert_eq!(axis.setpoint_at(1000.0), at_rest(POSITIONS[1]));
    assert_eq!(axis.setpoint_at(0.0), at_rest(POSITIONS[0]));
    axis.start(now);
    assert_close(axis.setpoint(now), before);
}

#[test]
fn one_limit_for_all_waypoints() {
    let same = [3.0; 5];
    let mut each = along(Waypoints::new(&POSITIONS, &same, &same).unwrap());
    let mut uniform = along(Waypoints::uniform(&POSITIONS, 3.0, 3.0).unwrap());
    assert_eq!(each.duration(), uniform.duration());
    for step in 0..1000 {
        let t = 0.01 * f64::from(step);
        assert_eq!(each.setpoint_at(t), uniform.setpoint_at(t));
    }
}

#[test]
fn waypoints_need_a_limit_each() {
    assert!(Waypoints::new(&POSITIONS, &VELOCITIES[1..], &ACCELERATIONS).is_none());
    assert!(Waypoints::new(&POSITIONS, &VELOCITIES, &ACCELERATIONS[1..]).is_none());
    assert!(Waypoints::new(&[], &[], &[]).is_none());
    assert!(Waypoints::uniform(&[], 1.0, 1.0).is_none());
}

#[test]
fn a_listing_that_ends_at_no_number_is_over_at_its_first_instant() {
    let mut listing = Profile::default();
    listing.plan_listing(state(1.0, f64::NAN), to(10.0));
    assert!(
        [listing.t1, listing.t2, listing.tf]
            .iter()
            .all(|t| t.is_nan())
    );
    assert!(listing.is_over(0.0) && listing.is_over(1.0) && !listing.is_over(-1.0));
    assert_eq!(listing.setpoint(0.0), at_rest(10.0));
}

#[test]
fn a_set_refuses_what_would_overflow_and_changes_nothing() {
    let mut axis = started(Mode::Corrected, to(10.0));
    let overflowing = target([1e300, 1e150, 1e-20, 1e-20]);
    assert_eq!(axis.set(overflowing.into(), 1.0), Err(OutOfRange));
    let large = [1.001 * LARGEST, f64::MAX, f64::INFINITY, f64::NAN];
    for wrong in large.into_iter().flat_map(|large| [large, -large]) {
        for number in 0..4 {
            let mut numbers = [1.0, 2.0, 2.0, 2.0];
            numbers[number] = wrong;
            assert_eq!(axis.set(target(numbers).into(), 1.0), Err(OutOfRange));
        }
        let (good, bad): (&[f64], &[f64]) = (&[1.0, 2.0], vec![1.0, wrong].leak());
        for waypoints in [
            Waypoints::new(bad, good, good),
            Waypoints::new(good, bad, good),
            Waypoints::new(good, good, bad),
            Waypoints::uniform(bad, 1.0, 1.0),
            Waypoints::uniform(good, wrong, 1.0),
            Waypoints::uniform(good, 1.0, wrong),
        ] {
            let waypoints = waypoints.unwrap();
            assert_eq!(axis.set(waypoints.into(), 1.0), Err(OutOfRange));
        }
    }
    let mut alone = started(Mode::Corrected, to(10.0));
    for axis in [&mut axis, &mut alone] {
        axis.start(2.0);
    }
    assert_eq!(axis.profile(), alone.profile());
    let largest = target([-LARGEST, LARGEST, LARGEST, LARGEST]);
    assert_eq!(axis.set(largest.into(), 3.0), Ok(()));
}

/// Whatever the limits say. No sum of finite setpoints overflows here.
#[test]
fn a_corrected_setpoint_is_finite_up_to_the_largest_numbers() {
    let mut random = Random(11);
    let mut farthest = 0.0f64;
    for _ in 0..100_000 {
        let mut axis = Trajectory::new(Mode::Corrected, 0.0);
        let mut now = 0.0;
        for _ in 0..6 {
            let mut number = || match random.bits() % 4 {
                0 => LARGEST,
                1 => 0.0,
                2 => random.magnitude(-80.0, 60.0),
                _ => random.magnitude(-3.0, 3.0),
            };
            let mut target = target([(); 4].map(|()| number()));
            target.position *= random.sign();
            axis.set(target.into(), now).unwrap();
            if random.one_in(8) {
                axis.stop(now);
            } else {
                axis.start(now);
            }
            let Profile { t1, t2, tf, .. } = *axis.profile();
            let at = random.between(0.0, 1.0) * axis.duration();
            let (after_t1, after_t2) = (just_after(t1), just_after(t2));
            for t in [0.0, t1, after_t1, 0.5 * t1, t2, after_t2, tf, at] {
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
fn a_reset_on_a_clock_without_a_number_forgets_the_motion_and_spares_the_timer() {
    for broken in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut axis = started(Mode::Corrected, to(10.0));
        axis.reset(broken);
        assert!(!axis.is_started());
        assert_eq!(axis.elapsed(1.5), 1.5);
        axis.start(2.0);
        assert_eq!(axis.setpoint(3.0).position, 1.0);
    }
}

#[test]
fn a_change_to_or_from_a_clock_without_a_number_is_a_reset() {
    for (now, instead) in [(1.0, f64::NAN), (f64::NAN, 1000.0)] {
        let mut axis = started(Mode::Corrected, to(10.0));
        axis.change_clock(now, instead);
        assert!(!axis.is_started());
        assert!(axis.elapsed(1000.5).is_finite());
        axis.start(1001.0);
        assert_eq!(axis.setpoint(1002.0).position, 1.0);
    }
}

#[test]
fn a_huge_advance_of_the_timer_lasts_until_the_next_start() {
    for advances in [[1e308, 1e308], [1e17, 0.0], [-1e17, 0.0]] {
        let mut axis = started(Mode::Corrected, to(10.0));
        for seconds in advances {
            axis.advance_timer_by(seconds);
            assert!(axis.elapsed(0.0).is_finite(), "{seconds}");
        }
        axis.reset(0.5);
        axis.start(0.5);
        assert_eq!(axis.elapsed(1.5), 1.0);
        assert_eq!(axis.setpoint(1.5).position, 1.0);
        axis.advance_timer_by(0.25);
        assert_eq!(axis.elapsed(1.5), 1.25);
    }
}

#[test]
fn a_mode_counts_from_the_next_start_or_stop() {
    let mut axis = started(Mode::Corrected, to(10.0));
    axis.set_mode(Mode::Listing);
    assert_eq!(axis.setpoint_at(100.0), at_rest(10.0));
    assert!(axis.is_started(), "a look changes a corrected motion");
    axis.start(1.0);
    assert_eq!(axis.setpoint_at(-1.0), State::default());
    axis.set_mode(Mode::Corrected);
    assert_eq!(axis.setpoint_at(-1.0), State::default());
    assert_eq!(axis.setpoint_at(100.0), at_rest(10.0));
    assert!(!axis.is_started(), "a look beyond the end of a listing");
}
