//! Do `state`, `states` and `sample_into` give the bits of the single calls, whatever the times, lengths and outputs are?

mod common;

use atraj::{Bell, Boundary, Poly3, Poly5, Poly7, Trap};
use common::{Comparison, GoldenReal, golden};

/// A profile with `N` quantities as its single calls and its joint ones.
trait Sampled<R, const N: usize> {
    fn single(&self, x: R) -> [R; N];
    fn state(&self, x: R) -> [R; N];
    fn states(&self, x0: R, dt: R, n: usize) -> Vec<[R; N]>;
    fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; N]) -> usize;
}

macro_rules! sampled {
    ($profile:ident, $n:literal, $($quantity:ident)*) => {
        impl<R: GoldenReal> Sampled<R, $n> for $profile<R> {
            fn single(&self, x: R) -> [R; $n] {
                [$(self.$quantity(x)),*]
            }
            fn state(&self, x: R) -> [R; $n] {
                self.state(x)
            }
            fn states(&self, x0: R, dt: R, n: usize) -> Vec<[R; $n]> {
                self.states(x0, dt).take(n).collect()
            }
            fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; $n]) -> usize {
                self.sample_into(x0, dt, outputs)
            }
        }
    };
}
sampled!(Bell, 4, position velocity acceleration jerk);
sampled!(Trap, 3, position velocity acceleration);
sampled!(Poly3, 3, position velocity acceleration);
sampled!(Poly5, 3, position velocity acceleration);
sampled!(Poly7, 4, position velocity acceleration jerk);

/// One sweep; output `i` has `lengths[i]` elements and begins `offset` elements into its memory.
fn check_sweep<R: GoldenReal, const N: usize>(
    comparison: &mut Comparison,
    place: &str,
    profile: &impl Sampled<R, N>,
    [x0, dt]: [R; 2],
    lengths: [usize; N],
    offset: usize,
) {
    let untouched = R::from(77);
    let mut memory = lengths.map(|len| vec![untouched; offset + len + 1]);
    let outputs = memory.each_mut().map(|memory| {
        let end = memory.len() - 1;
        &mut memory[offset..end]
    });
    let n = lengths.into_iter().max().unwrap();
    assert_eq!(profile.sample_into(x0, dt, outputs), n, "{place}");
    let states = profile.states(x0, dt, n);
    let mut k_real = R::from(0);
    for (k, joint) in states.into_iter().enumerate() {
        let x = x0 + k_real * dt;
        k_real = k_real + R::from(1);
        let single = profile.single(x);
        let state = profile.state(x);
        let mut check = |what, got: R, want| {
            if got.same(want) {
                comparison.compared += 1;
            } else {
                let place = format!("{place}: sample {k} from {x0:e} by {dt:e}");
                comparison.check(&place, what, got, want);
            }
        };
        for (i, &want) in single.iter().enumerate() {
            check("state", state[i], want);
            check("states", joint[i], want);
            if k < lengths[i] {
                check("sample", memory[i][offset + k], want);
            }
        }
    }
    for (memory, len) in memory.iter().zip(lengths) {
        let around = memory[..offset].iter().chain(&memory[offset + len..]);
        assert!(
            around.into_iter().all(|&x| x == untouched),
            "{place}: written outside"
        );
    }
}

/// Sweeps of every kind over a profile in which something happens at the times `borders`.
fn check_profile<R: GoldenReal, const N: usize>(
    comparison: &mut Comparison,
    place: &str,
    profile: &impl Sampled<R, N>,
    borders: &[R],
) {
    let zero = R::from(0);
    let one = R::from(1);
    let huge = one / (R::EPSILON * R::EPSILON);
    let end = borders.last().copied().unwrap_or(one);
    let mut sweeps = Vec::new();
    for n in [0, 1, 2, 3, 9, 70] {
        let dt = end / R::from(n.max(2) - 1);
        sweeps.extend([(zero, dt, n), (end + dt, -dt, n), (-dt, dt * R::HALF, n)]);
    }
    for &border in borders {
        let ulp = border * R::EPSILON;
        let before = border - R::from(6) * ulp;
        let after = border + R::from(6) * ulp;
        sweeps.extend([(before, ulp, 12), (after, -ulp, 12)]);
        sweeps.extend([(border, zero, 2), (border, -zero, 2)]);
        sweeps.extend([(zero, border, 3), (-zero, -border, 3)]);
    }
    let infinity = R::INFINITY;
    let special = [zero, one, infinity, huge, R::parse("nan").unwrap()];
    let special = special.into_iter().flat_map(|x| [x, -x]);
    for x0 in special.clone() {
        sweeps.extend(special.clone().map(|dt| (x0, dt, 4)));
    }
    for (i, (x0, dt, n)) in sweeps.into_iter().enumerate() {
        let n = usize::from(n);
        let some = std::array::from_fn(|output| if i >> output & 1 == 1 { n } else { 0 });
        for lengths in [[n; N], some] {
            check_sweep(comparison, place, profile, [x0, dt], lengths, i % 4);
        }
    }
}

fn bell_of<R: Copy>(fields: &[R]) -> Bell<R> {
    let [t, tv, ta, td, taj, tdj, p0, p1, v0, v1, vm, jm, am, dm] = *fields else {
        panic!("{} fields", fields.len());
    };
    #[rustfmt::skip]
    let bell = Bell { t, tv, ta, td, taj, tdj, p0, p1, v0, v1, vm, jm, am, dm };
    bell
}

fn bell_borders<R: GoldenReal>(bell: &Bell<R>) -> [R; 7] {
    #[rustfmt::skip]
    let Bell { t, tv, ta, td, taj, tdj, .. } = *bell;
    [taj, ta - taj, ta, ta + tv, t - td + tdj, t - tdj, t]
}

fn trap_of<R: Copy>(fields: &[R]) -> Trap<R> {
    let [t, p0, p1, v0, v1, vc, ta, td, pa, pd, ac, de] = *fields else {
        panic!("{} fields", fields.len());
    };
    #[rustfmt::skip]
    let trap = Trap { t, p0, p1, v0, v1, vc, ta, td, pa, pd, ac, de };
    trap
}

/// Every golden move through sweeps, and every golden evaluation through the joint calls.
fn golden_moves<R: GoldenReal, const N: usize, P: Sampled<R, N>>(
    family: &str,
    [text, arguments, fields]: [usize; 3],
    profile: impl Fn(&[R]) -> P,
    borders: impl Fn(&P) -> Vec<R>,
) {
    let mut comparison = Comparison::default();
    let moves: Vec<_> = golden::<R>(&format!("{family}_gen"), text, arguments + fields)
        .iter()
        .map(|row| {
            let profile = profile(&row.values[arguments..]);
            check_profile(&mut comparison, &row.place, &profile, &borders(&profile));
            profile
        })
        .collect();
    for row in golden::<R>(&format!("{family}_eval"), 1, 1 + N) {
        let x = row.values[0];
        let mut sampled = [[R::from(0); 3]; N];
        // Any time plus -0 is that time.
        moves[row.case].sample_into(x, -R::from(0), sampled.each_mut().map(|y| &mut y[..]));
        let state = moves[row.case].state(x);
        for (i, &want) in row.values[1..].iter().enumerate() {
            comparison.check(&row.place, "state", state[i], want);
            for got in sampled[i] {
                comparison.check(&row.place, "sample", got, want);
            }
        }
    }
    comparison.finish(family);
}

fn bell<R: GoldenReal>() {
    golden_moves("bell", [2, 8, 14], bell_of::<R>, |bell| {
        bell_borders(bell).to_vec()
    });
}

fn trap<R: GoldenReal>() {
    golden_moves("trap", [2, 8, 12], trap_of::<R>, |trap| {
        vec![trap.ta, trap.td, trap.t]
    });
}

fn poly3<R: GoldenReal>() {
    let poly = |fields: &[R]| Poly3 {
        c: *fields.first_chunk().unwrap(),
    };
    golden_moves("poly3", [1, 5, 9], poly, |_| vec![]);
}

fn poly5<R: GoldenReal>() {
    let poly = |fields: &[R]| Poly5 {
        c: *fields.first_chunk().unwrap(),
    };
    golden_moves("poly5", [1, 7, 15], poly, |_| vec![]);
}

fn poly7<R: GoldenReal>() {
    let poly = |fields: &[R]| Poly7 {
        c: *fields.first_chunk().unwrap(),
    };
    golden_moves("poly7", [1, 9, 26], poly, |_| vec![]);
}

/// Structs that no plan makes: borders in any order, NaN and infinite fields.
fn any_fields<R: GoldenReal>() {
    let [zero, one, two, three] = [0, 1, 2, 3].map(R::from);
    let values = [
        zero,
        one,
        two,
        three,
        R::HALF,
        -one,
        R::INFINITY,
        R::parse("nan").unwrap(),
    ];
    let mut random = 1_u64;
    let mut comparison = Comparison::default();
    for number in 0..400 {
        let fields: [R; 14] = std::array::from_fn(|_| {
            random = random
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            // Finite ones more often.
            values[[0, 1, 2, 3, 4, 5, 6, 7, 1, 2, 3, 4, 1, 2, 3, 4][(random >> 60) as usize]]
        });
        let place = format!("struct {number}");
        let bell = bell_of(&fields);
        check_profile(&mut comparison, &place, &bell, &bell_borders(&bell));
        let trap = trap_of(&fields[..12]);
        check_profile(&mut comparison, &place, &trap, &[trap.ta, trap.td, trap.t]);
    }
    comparison.finish("any fields");
}

/// Beyond 2^24 not every number of a sample is a binary32.
#[test]
fn many_samples() {
    const MANY: usize = (1 << 24) + 1000;
    let bell = Bell::new(30.0, 10.0, 5.0, Boundary::rest_to_rest(0.0, 10.0)).unwrap();
    let dt = bell.t / ((1 << 24) + 500) as f32;
    let mut jerk = vec![0.0_f32; MANY];
    assert_eq!(
        bell.sample_into(0.0, dt, [&mut [], &mut [], &mut [], &mut jerk]),
        MANY
    );
    for (k, &sampled) in jerk.iter().enumerate() {
        let single = bell.jerk(k as f32 * dt);
        assert!(
            sampled.same(single),
            "sample {k}: {sampled} instead of {single}"
        );
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

macro_rules! for_both_reals {
    ($($name:ident)*) => {$(
        mod $name {
            #[test]
            fn f32() {
                super::$name::<f32>();
            }
            #[test]
            fn f64() {
                super::$name::<f64>();
            }
        }
    )*};
}
for_both_reals!(bell trap poly3 poly5 poly7 any_fields);
