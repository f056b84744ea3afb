//! Does `time_at` give the first time at which a move is at a position, and nothing if it never is there?

use approx::{abs_diff_eq, assert_abs_diff_eq};
use support::prelude::*;

const MOVES: usize = 4_000;
const SAMPLES: usize = 400;

fn times<R: Real>(planned: &Move<R>) -> Vec<R> {
    let phases = &planned.phase[..=planned.count as usize];
    let part = |x: R, duration: R, k: usize, of: usize| x + R::of(k as f64 / of as f64) * duration;
    let whole = (0..=SAMPLES).map(|k| part(R::ZERO, planned.t, k, SAMPLES));
    let each = phases.iter().flat_map(|phase| (0..=40).map(|k| part(phase.start, phase.duration, k, 40)));
    let mut times: Vec<R> = whole.chain(each).collect();
    times.retain(|x| *x <= planned.t);
    times.sort_by(|x, y| x.partial_cmp(y).expect("no NaN"));
    times
}

/// How wrong a position may be by rounding: the whole way, and what the rounding of a velocity adds up to.
fn rounding<R: Real>(planned: &Move<R>) -> f64 {
    let [position, velocity, _] = online::largest(planned.extremes());
    16.0 * R::MACHINE_EPSILON.widen() * (position + velocity * planned.t.widen())
}

/// Asks for the positions of samples, for the extremes and for what lies beyond. The first sample at a position, or the first pair of
/// samples with the position between them, says when the axis is there.
fn in_random_moves<R: Real>() {
    let mut random = Random::seeded(1);
    let (mut found, mut never) = (0, 0);
    for number in 0..MOVES {
        let (_, _, planned) = online::planned::<R>(&mut random);
        let reached = planned.extremes();
        let (low, high) = (reached.lowest.position, reached.highest.position);
        let times = times(&planned);
        let positions: Vec<R> = times.iter().map(|x| planned.position(*x)).collect();
        let rounding = rounding(&planned);
        let [start, end] = [R::ZERO, planned.t].map(|x| planned.time_at(planned.position(x)));
        assert_eq!(start, Some(R::ZERO), "the start of move {number}");
        assert!(end.is_some(), "the end of move {number}");
        for _ in 0..8 {
            let wanted = match random.below(3) {
                0 => positions[random.below(positions.len())],
                1 => random.pick(&[low, high, positions[0], positions[positions.len() - 1]]),
                _ => R::of(random.between(low.widen(), high.widen())),
            };
            let place = format!("move {number} at {wanted:e}: {planned:?}");
            // Every position from the lowest to the highest is reached, whatever is rounded.
            let x = planned.time_at(wanted).unwrap_or_else(|| panic!("nothing found, {place}"));
            found += 1;
            assert!(x >= R::ZERO && x <= planned.t, "{x:e}, {place}");
            let [there, asked] = [planned.position(x), wanted].map(R::widen);
            assert!(abs_diff_eq!(there, asked, epsilon = rounding), "{there:e} at {x:e}, {place}");
            // Before the first time the axis is on one side.
            let before = times.iter().zip(&positions).take_while(|(t, _)| **t < x);
            let sides: Vec<f64> =
                before.map(|(_, p)| p.widen() - wanted.widen()).filter(|side| side.abs() > rounding).collect();
            assert!(sides.iter().all(|side| side * sides[0] > 0.0), "passed before {x:e}, {place}");
        }
        let beyond = R::of(rounding + 1e-3);
        for wanted in [low - beyond, high + beyond, R::NAN] {
            assert_eq!(planned.time_at(wanted), None, "move {number}");
            never += 1;
        }
    }
    assert!(found == MOVES * 8 && never == MOVES * 3, "{found} {never}");
}

/// A move that is shifted in time may have a phase of no duration, which begins one ulp from the next phase.
fn next_to_a_phase_of_no_duration<R: Real>() {
    let [zero, one] = [R::ZERO, R::ONE];
    let next = zero.neighbour(2);
    let mut shifted = Move::<R>::default();
    shifted.phase[2] = Phase { position: next, velocity: one, duration: one, ..Phase::default() };
    shifted.phase[3] = Phase { position: one, start: one, ..Phase::default() };
    (shifted.count, shifted.t) = (3, one);
    for position in [zero, zero.neighbour(1), next] {
        assert_eq!(shifted.time_at(position), Some(zero), "{position:e}");
    }
}

test_both_reals!(next_to_a_phase_of_no_duration, in_random_moves);

/// The axis passes its target, turns and comes back.
#[test]
fn the_first_of_two() {
    let from = State { velocity: 4.0, ..State::at(0.0) };
    let planned = online::plan(&Limits::symmetric(30.0, 10.0, 5.0), from, State::at(1.0));
    let x: f64 = planned.time_at(1.0).expect("the target");
    assert!(x < 0.5 * planned.t && planned.velocity(x) > 0.0);
    assert_abs_diff_eq!(planned.position(x), 1.0, epsilon = 1e-14);
}

#[test]
fn at_rest() {
    let here = State::at(2.0);
    let planned = online::plan(&Limits::symmetric(30.0, 10.0, 5.0), here, here);
    assert_eq!(planned.time_at(2.0), Some(0.0));
    assert_eq!(planned.time_at(2.5), None);
}
