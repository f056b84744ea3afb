//! Roots of increasing functions and of quadratics.

use crate::real::Real;

/// More rounds than the root of a convex function takes, as `docs/planner.md` shows.
const MOST_ROUNDS: u32 = 16;

/// Where an increasing convex function, `(value, derivative)`, has the value `target`: from `x` on downwards but not below `least`.
/// The function is not below `target` at `x`.
///
/// Near the root a step is as large as the square of the step before, up to a factor. So two steps foretell the third one. If the
/// third one would have no effect, it is not taken.
pub(crate) fn convex_root<R: Real>(least: R, mut x: R, target: R, f: impl Fn(R) -> (R, R)) -> R {
    let mut before = R::ZERO;
    for _round in 1..=MOST_ROUNDS {
        #[cfg(test)]
        tests::note(_round);
        let (value, derivative) = f(x);
        let step = (value - target) / derivative;
        let next = x - step;
        if next < x {
            x = next;
        } else {
            break; // by rounding
        }
        let shrinks = step / before;
        if step * (shrinks * shrinks) < R::EPSILON * x {
            break;
        }
        before = step;
    }
    x.at_least(least)
}

/// Enough to halve a range until nothing is left of it.
const MOST_HALVES: u32 = 64;

/// The root of an increasing function, `(value, derivative)`, between `low` and `high`. Newton's method begins at `high`.
#[inline] // a call less in each search
pub(crate) fn root_between<R: Real>(low: R, high: R, f: impl Fn(R) -> (R, R)) -> R {
    root_near(low, high, high, R::ZERO, f)
}

/// The root of an increasing function, `(value, derivative)`, between `low` and `high`. Newton's method begins at `x`, to which the step
/// `before` led, 0 if none did. Where a step leaves the range that holds the root, the range is halved.
#[inline] // a call less in each search
pub(crate) fn root_near<R: Real>(mut low: R, mut high: R, mut x: R, mut before: R, f: impl Fn(R) -> (R, R)) -> R {
    let mut shrank = R::ONE;
    for _ in 0..MOST_HALVES {
        let (value, derivative) = f(x);
        if value > R::ZERO {
            high = x;
        } else {
            low = x;
        }
        let newton = x - value / derivative;
        let is_newton = newton >= low && newton <= high;
        let next = if is_newton { newton } else { low + R::HALF * (high - low) };
        let step = (next - x).abs();
        x = next;
        // As above, but a step may be small by chance: where the function bends the other way, or after a bisection. So the next Newton step is predicted
        // from the last three: by the larger one of both factors between a step and the square of the step before. A bisection predicts nothing.
        let shrinks = (step / before).at_most(R::ONE);
        let foretold = if is_newton { step * shrinks * shrinks.at_least(shrank * shrank) } else { step };
        if foretold <= R::EPSILON * x {
            break;
        }
        (before, shrank) = if is_newton { (step, shrinks) } else { (R::ZERO, R::ONE) };
    }
    x
}

/// The larger root of `x^2 + 2 p x + q`.
pub(crate) fn larger_root<R: Real>(p: R, q: R) -> R {
    let d = (p * p - q).at_least(R::ZERO).sqrt();
    if p > R::ZERO { -q / (p + d) } else { d - p }
}

/// Where `x^2 + 2 p x + q` first is 0 for a positive `x`, or for 0 if `q` is not positive.
pub(crate) fn first_zero<R: Real>(p: R, q: R) -> Option<R> {
    if q <= R::ZERO {
        return Some(larger_root(p, q));
    }
    let d = p * p - q;
    (p < R::ZERO && d > R::ZERO).then(|| q / (d.sqrt() - p))
}

#[cfg(test)]
mod tests {
    extern crate std;
    use crate::liba::Bell;
    use crate::real::Real;
    use crate::state::Boundary;
    use std::cell::Cell;
    use support::Random;

    std::thread_local! {
        static MOST_SEEN: Cell<u32> = const { Cell::new(0) };
    }

    pub(super) fn note(round: u32) {
        MOST_SEEN.set(MOST_SEEN.get().max(round));
    }

    /// Limits of any size, and a displacement of any size or near the one of the direct ramp.
    fn problem(random: &mut Random, decades: f64) -> ([f64; 3], Boundary<f64>) {
        let [jm, am, vm, mut v0, mut v1] = [(); 5].map(|()| random.magnitude(-decades, decades));
        v0 *= random.sign();
        v1 *= random.pick(&[0.0, 0.0, 1.0, -1.0]);
        if random.one_in(4) {
            v1 = v0 * random.pick(&[1.0, -1.0, 1.0 + 1e-6]);
        }
        let am = if random.one_in(4) { f64::INFINITY } else { am };
        let (v0, v1) = (v0.clamp(-vm, vm), v1.clamp(-vm, vm));
        let dv = (v1 - v0).abs();
        let duration = if dv * jm < am * am { 2.0 * (dv / jm).sqrt() } else { am / jm + dv / am };
        let direct = 0.5 * (v0 + v1) * duration;
        let p1 = match random.below(4) {
            0 => direct * (1.0 + random.sign() * random.magnitude(-16.0, 0.0)),
            1 => direct * (1.0 + random.sign() * random.magnitude(-8.0, -6.0)),
            2 => direct,
            _ => random.sign() * random.magnitude(-decades, decades),
        };
        ([jm, am, vm], Boundary { p0: 0.0, p1, v0, v1 })
    }

    /// The most rounds of a root in these plans.
    fn most_rounds<R: Real>(seed: u64, decades: f64, of: fn(f64) -> R) -> u32 {
        let mut random = Random::seeded(seed);
        MOST_SEEN.set(0);
        for _ in 0..PROBLEMS {
            let (limits, Boundary { p0, p1, v0, v1 }) = problem(&mut random, decades);
            let [jm, am, vm] = limits.map(of);
            let [p0, p1, v0, v1] = [p0, p1, v0, v1].map(of);
            assert!(Bell::fastest(jm, am, vm, Boundary { p0, p1, v0, v1 }).is_ok());
        }
        MOST_SEEN.get()
    }

    const PROBLEMS: u32 = 1_000_000;

    /// `MOST_ROUNDS` is more than any root takes.
    #[test]
    fn a_root_takes_few_rounds() {
        let most = [
            most_rounds(0, 1.0, |x| x),
            most_rounds(1, 6.0, |x| x),
            most_rounds(2, 1.0, |x| x as f32),
            most_rounds(3, 3.0, |x| x as f32),
        ];
        assert!(most.iter().all(|most| (6..=8).contains(most)), "{most:?}");
    }
}
