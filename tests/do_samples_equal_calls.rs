//! Do `state`, `states` and `sample_into` give the bits of single calls, whatever the times, lengths and outputs are?

use std::array;
use support::prelude::*;
use support::profiles::{Profile, bell, move_borders, poly3, poly5, poly7, trap};
use support::{Comparison, Family, golden, test_each_family};

type Sweep<R> = (R, R, usize); // the first time, the time between two samples, and how many they are

fn check_sweep<R: Real, const N: usize>(
    comparison: &mut Comparison, place: &str, profile: &impl Profile<R, N>, [x0, dt]: [R; 2], lengths: [usize; N],
    offset: usize,
) {
    let untouched = R::of(77.0);
    let mut memory = lengths.map(|len| vec![untouched; offset + len + 1]);
    let outputs = memory.each_mut().map(|memory| memory[offset..].split_last_mut().expect("a number behind it").1);
    let n = lengths.into_iter().max().unwrap();
    assert_eq!(profile.sample_into(x0, dt, outputs), n, "{place}");
    for (k, joint) in profile.states(x0, dt, n).into_iter().enumerate() {
        let place = format_args!("{place}: sample {k} from {x0:e} by {dt:e}");
        let x = x0 + R::of(k as f64) * dt;
        let each = profile.each(x);
        let state = profile.state(x);
        for (i, &want) in each.iter().enumerate() {
            comparison.check(place, "state", state[i], want);
            comparison.check(place, "states", joint[i], want);
            if k < lengths[i] {
                comparison.check(place, "sample", memory[i][offset + k], want);
            }
        }
    }
    for (memory, len) in memory.iter().zip(lengths) {
        let mut around = memory[..offset].iter().chain(&memory[offset + len..]);
        assert!(around.all(|&x| x == untouched), "{place}: written outside the output");
    }
}

fn check_profile<R: Real, const N: usize>(
    comparison: &mut Comparison, place: &str, profile: &impl Profile<R, N>, borders: &[R],
) {
    let all = [sweeps_over(borders[borders.len() - 1]), sweeps_around(borders), sweeps_of_special_times()];
    for (i, (x0, dt, n)) in all.into_iter().flatten().enumerate() {
        let some = array::from_fn(|output| if i >> output & 1 == 1 { n } else { 0 });
        for lengths in [[n; N], some] {
            check_sweep(comparison, place, profile, [x0, dt], lengths, i % 4);
        }
    }
}

fn sweeps_over<R: Real>(end: R) -> Vec<Sweep<R>> {
    let of_length = |n: u8| {
        let dt = end / R::of(f64::from(n.max(2) - 1));
        [(R::ZERO, dt), (end + dt, -dt), (-dt, dt * R::of(0.5))].map(|(x0, dt)| (x0, dt, n.into()))
    };
    [0, 1, 2, 3, 9, 70].into_iter().flat_map(of_length).collect()
}

/// By single roundings across each border, standing at it, and from zero to it.
fn sweeps_around<R: Real>(borders: &[R]) -> Vec<Sweep<R>> {
    let around = |&border: &R| {
        let (zero, ulp) = (R::ZERO, border * R::MACHINE_EPSILON);
        let [before, after] = [-6.0, 6.0].map(|ulps| border + R::of(ulps) * ulp);
        let crossing = [(before, ulp, 12), (after, -ulp, 12)];
        crossing.into_iter().chain([(border, zero, 2), (border, -zero, 2), (zero, border, 3), (-zero, -border, 3)])
    };
    borders.iter().flat_map(around).collect()
}

fn sweeps_of_special_times<R: Real>() -> Vec<Sweep<R>> {
    let huge = R::ONE / (R::MACHINE_EPSILON * R::MACHINE_EPSILON);
    let [zero, one, infinity, nan] = [0.0, 1.0, f64::INFINITY, f64::NAN].map(R::of);
    let special = [zero, one, infinity, huge, nan].into_iter().flat_map(|x| [x, -x]);
    special.clone().flat_map(|x0| special.clone().map(move |dt| (x0, dt, 4))).collect()
}

fn check_golden_moves<R: Real, const N: usize, P: Profile<R, N>>(family: Family, profile: fn(&[R]) -> P) {
    let mut comparison = Comparison::default();
    for golden in golden::moves::<R>(family) {
        let borders = family.borders(&golden.arguments, &golden.fields);
        check_profile(&mut comparison, &golden.place, &profile(&golden.fields), &borders);
    }
    comparison.finish(family.name());
}

fn golden_moves<R: Real>(family: Family) {
    match family {
        Family::Bell => check_golden_moves::<R, _, Bell<R>>(family, bell),
        Family::Trap => check_golden_moves::<R, _, Trap<R>>(family, trap),
        Family::Poly3 => check_golden_moves::<R, _, Poly3<R>>(family, poly3),
        Family::Poly5 => check_golden_moves::<R, _, Poly5<R>>(family, poly5),
        Family::Poly7 => check_golden_moves::<R, _, Poly7<R>>(family, poly7),
    }
}

test_each_family!(golden_moves);

fn moves<R: Real>() {
    let mut random = Random::seeded(1);
    let mut comparison = Comparison::default();
    for number in 0..400 {
        let (_, _, planned) = online::planned::<R>(&mut random);
        let (place, borders) = (format!("move {number}"), move_borders(&planned));
        check_profile(&mut comparison, &place, &planned, &borders);
    }
    comparison.finish("moves");
}

/// Structs that no plan makes: borders in any order, NaN and infinite fields.
fn any_fields<R: Real>() {
    let mut random = Random::seeded(1);
    let mut comparison = Comparison::default();
    for number in 0..400 {
        let place = format!("struct {number}");
        let mut fields = |of: Family| -> Vec<R> { of.fields().iter().map(|_| any_field(&mut random)).collect() };
        let of_bell = fields(Family::Bell);
        check_profile(&mut comparison, &place, &bell(&of_bell), &Family::Bell.borders(&[], &of_bell));
        let of_trap = fields(Family::Trap);
        check_profile(&mut comparison, &place, &trap(&of_trap), &Family::Trap.borders(&[], &of_trap));
        let of_moves = any_move::<R>(&mut random);
        check_profile(&mut comparison, &place, &of_moves, &move_borders(&of_moves));
    }
    comparison.finish("any fields");
}

/// Fields that no plan gives, but that the first phase starts at 0.
fn any_move<R: Real>(random: &mut Random) -> Move<R> {
    let (t, count) = (any_field(random), random.pick(&[0, 1, 2, 7, 15, 16, u32::MAX]));
    let phase = [(); 16].map(|()| {
        let [start, duration, position, velocity, acceleration, jerk] = [(); 6].map(|()| any_field(random));
        Phase { start, duration, position, velocity, acceleration, jerk }
    });
    let mut planned = Move { t, count, phase };
    planned.phase[0].start = R::ZERO;
    planned
}

/// A small positive number more often than another.
fn any_field<R: Real>(random: &mut Random) -> R {
    let is_peculiar = random.one_in(4);
    R::of(random.pick(&if is_peculiar { [0.0, -1.0, f64::INFINITY, f64::NAN] } else { [1.0, 2.0, 3.0, 0.5] }))
}

test_both_reals!(moves, any_fields);

/// Beyond 2^24 the number of a sample need not be a binary32.
#[test]
fn many_samples() {
    const MANY: usize = (1 << 24) + 1000;
    let bell = Bell::new(30.0, 10.0, 5.0, Boundary::rest_to_rest(0.0, 10.0)).unwrap();
    let dt = bell.t / ((1 << 24) + 500) as f32;
    let mut jerk = vec![0.0_f32; MANY];
    assert_eq!(bell.sample_into(0.0, dt, [&mut [], &mut [], &mut [], &mut jerk]), MANY);
    for (k, &sampled) in jerk.iter().enumerate() {
        let single = bell.jerk(k as f32 * dt);
        assert!(sampled.same(single), "sample {k}: {sampled} instead of {single}");
    }
    assert_eq!(jerk[(1 << 24) - 1000], 30.0);
    assert_eq!(jerk[MANY - 1], 0.0);
}

#[test]
fn outputs_of_different_lengths() {
    let bell = Bell::new(30.0, 10.0, 5.0, Boundary::rest_to_rest(0.0, 10.0)).unwrap();
    let mut comparison = Comparison::default();
    for number in 0..4_usize.pow(4) {
        let lengths = [0, 2, 4, 6].map(|shift| [0, 1, 40, 101][number >> shift & 3]);
        check_sweep(&mut comparison, "bell", &bell, [-0.1, 0.03], lengths, 1);
    }
    comparison.finish("different lengths");
}
