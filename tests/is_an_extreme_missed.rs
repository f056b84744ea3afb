//! Does a move reach beyond its reported extremes, or are they reported without being reached?

use support::Family;
use support::prelude::*;
use support::profiles::{Profile, bell_fields, trap_fields};

const MOVES: usize = 4_000;
const SAMPLES: usize = 400;
const ROUNDINGS: f64 = 8.0;

struct Move<R> {
    duration: R,
    reached: Extremes<R>,
    each: Box<dyn Fn(R) -> [f64; 3]>,
    scales: [f64; 3],
    borders: Vec<R>, // times at which something short may happen
}

impl<R: Real> Move<R> {
    fn new<const N: usize>(
        profile: impl Profile<R, N> + 'static, duration: R, reached: Extremes<R>, scales: [f64; 3], borders: Vec<R>,
    ) -> Self {
        let each = Box::new(move |x| std::array::from_fn(|i| profile.each(x)[i].widen()));
        Self { duration, reached, each, scales, borders }
    }
}

fn boundary<R: Real>(random: &mut Random) -> Boundary<R> {
    let mut number = || R::of(random.sign() * random.magnitude(-2.0, 2.0));
    Boundary { p0: number(), p1: number(), v0: number(), v1: number() }
}

fn polynomial<R: Real>(random: &mut Random) -> Move<R> {
    let boundary = boundary(random);
    let ts = R::of(random.magnitude(-1.0, 1.0));
    let mut pair = || [(); 2].map(|()| R::of(random.sign() * random.magnitude(-2.0, 2.0)));
    let (accelerations, jerks) = (pair(), pair());
    macro_rules! moved {
        ($poly:expr) => {{
            let poly = $poly.expect("a duration");
            Move::new(poly, ts, poly.extremes(ts), terms(&poly.c, ts), Vec::new())
        }};
    }
    match random.below(3) {
        0 => moved!(Poly3::new(ts, boundary)),
        1 => moved!(Poly5::new(ts, boundary, accelerations)),
        _ => moved!(Poly7::new(ts, boundary, accelerations, jerks)),
    }
}

/// The sum of the magnitudes of the terms of a polynomial and of its first two derivatives.
fn terms<R: Real>(coefficients: &[R], ts: R) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for (power, c) in coefficients.iter().enumerate() {
        let mut factor = 1.0;
        for (order, sum) in sums.iter_mut().enumerate().take(power + 1) {
            *sum += factor * c.widen().abs() * ts.widen().powi((power - order) as i32);
            factor *= (power - order) as f64;
        }
    }
    sums
}

fn fastest<R: Real>(random: &mut Random) -> Move<R> {
    let boundary: Boundary<R> = boundary(random);
    let Boundary { p0, p1, v0, v1 } = boundary;
    let [x, y, z] = [(); 3].map(|()| R::of(random.magnitude(-1.0, 2.0)));
    let scales = |duration: R, jerk: R, acceleration: R, velocity: R| {
        let [t, j, a, v] = [duration, jerk, acceleration, velocity].map(R::widen);
        let speed = v0.widen().abs().max(v1.widen().abs()).min(v);
        let speed = f64::min(speed.max(a * t), v);
        let way = p0.widen().abs() + p1.widen().abs();
        [way + speed * t, speed + a * t, a + j * t]
    };
    if random.one_in(2) {
        let bell = Bell::fastest(x, y, z, boundary).expect("numbers");
        let scales = scales(bell.t, x, y, z);
        Move::new(bell, bell.t, bell.extremes(), scales, Family::Bell.borders(&[], &bell_fields(&bell)))
    } else {
        let trap = Trap::fastest(x, y, -z, boundary).expect("numbers");
        let scales = scales(trap.t, R::ZERO, if y > z { y } else { z }, x);
        Move::new(trap, trap.t, trap.extremes(), scales, Family::Trap.borders(&[], &trap_fields(&trap)))
    }
}

fn between_any_states<R: Real>(random: &mut Random) -> Move<R> {
    let (_, _, planned) = online::planned::<R>(random);
    let phases = &planned.phase[..=planned.count as usize];
    let of_phase = |phase: &Phase<R>| {
        let [half, sixth] = [R::of(0.5), R::of(1.0 / 6.0)];
        let (a, j) = (half * phase.acceleration, sixth * phase.jerk);
        terms(&[phase.position, phase.velocity, a, j], phase.duration)
    };
    // A phase starts where the phases before it, or behind it, add up to.
    let added = |all: [f64; 3], sums: [f64; 3]| std::array::from_fn(|i| all[i] + sums[i]);
    let [p, v, a] = phases.iter().map(of_phase).fold([0.0; 3], added);
    let scales = [p + v * planned.t.widen(), v, a]; // the rounding of a velocity lasts until the end
    // Compared with a long phase the others are short.
    let inside = |part: i32| {
        let share = R::of(f64::from(part) / 40.0);
        phases.iter().map(move |phase| phase.start + share * phase.duration)
    };
    Move::new(planned, planned.t, planned.extremes(), scales, (0..=40).flat_map(inside).collect())
}

/// Samples the move densely. The result is how far samples lie beyond the reported extremes, in ulps of the scale. The extremes
/// may lie beyond the samples by no more than what samples miss.
fn worst<R: Real>(the_move: &Move<R>) -> f64 {
    let [lowest, highest] = [the_move.reached.lowest, the_move.reached.highest].map(online::numbers_of_state);
    let even = (0..=SAMPLES).map(|k| R::of(k as f64 / SAMPLES as f64) * the_move.duration);
    let borders = the_move.borders.iter().flat_map(|x| [x.neighbour(-1), *x, x.neighbour(1)]);
    let within = |x: &R| *x >= R::ZERO && *x <= the_move.duration;
    let times: Vec<R> = even.chain(borders).filter(within).collect();
    let mut worst = 0.0_f64;
    for quantity in 0..3 {
        let at = times.iter().map(|&x| (the_move.each)(x)[quantity]);
        let (sampled_low, sampled_high) = at.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), y| (l.min(y), h.max(y)));
        let (low, high) = (lowest[quantity], highest[quantity]);
        let rounding = R::MACHINE_EPSILON.widen() * the_move.scales[quantity];
        let missed = 0.01 * (sampled_high - sampled_low) + ROUNDINGS * rounding;
        assert!(low >= sampled_low - missed, "{low:e} is not reached");
        assert!(high <= sampled_high + missed, "{high:e} is not reached");
        worst = worst.max((low - sampled_low) / rounding).max((sampled_high - high) / rounding);
    }
    worst
}

fn nothing_lies_beyond<R: Real>() {
    for (name, of) in [
        ("polynomials", polynomial as fn(&mut Random) -> Move<R>),
        ("plans", fastest),
        ("moves from any state", between_any_states),
    ] {
        let mut random = Random::seeded(1);
        let moves = (0..MOVES).map(|_| of(&mut random)).filter(|the_move| the_move.duration > R::ZERO);
        let most = moves.map(|the_move| worst(&the_move)).fold(0.0, f64::max);
        assert!(most <= ROUNDINGS, "{name}: {most}");
    }
}

test_both_reals!(nothing_lies_beyond);

/// A trapezoid that only brakes has no phase without acceleration.
#[test]
fn a_ramp_alone_never_cruises() {
    let [p0, p1, v0, v1] = [0.0, 4.0, 4.0, 0.0];
    let braking = Trap::fastest(5.0, 4.0, -2.0, Boundary { p0, p1, v0, v1 }).expect("a plan");
    assert_eq!(braking.ta, braking.cruise_end);
    let reached = braking.extremes();
    assert_eq!([reached.lowest, reached.highest].map(|state| state.acceleration), [-2.0; 2]);
}
