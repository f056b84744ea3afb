//! The derivatives of the displacement on the border by velocity and acceleration at both ends, and by the duration.
//! `docs/path-theory.md` has the tables, in "Its derivatives". Letters without a variable of that name are given in comments.

use super::{border::Border, profile::Profile, ramp::PerJerk};
use crate::real::Real;

pub(crate) struct Derivatives<R> {
    /// By `v0`, `a0`, `v1`, `a1`, `t`.
    pub first: [R; 5],
    /// By two of them, row by row up to the diagonal.
    pub second: [R; 15],
}

impl<R: Real> Border<R> {
    /// The derivatives of the displacement of a motion on this border by the numbers of the axis. `sign` is -1 on that of the mirrored axis, else 1.
    pub fn derivatives(&self, profile: &Profile<R>, sign: R) -> Derivatives<R> {
        if profile.cruise > R::ZERO {
            self.derivatives_of_cruise(profile, sign)
        } else {
            self.derivatives_without_cruise(profile, sign)
        }
    }

    fn derivatives_without_cruise(&self, profile: &Profile<R>, sign: R) -> Derivatives<R> {
        let Profile { peak, top, fall, trough, bottom, .. } = *profile;
        let Self { a0, a1, .. } = *self;
        let PerJerk { gu, gd } = self.per_jerk;
        let (q, bu, bd) = (self.per_jerk.q(), self.limits.amax, -self.limits.amin);
        let ([first, c0], [last, c1]) = self.halves(profile, [fall; 2]);
        let per_fall = R::ONE / fall; // 1/u
        let half = R::HALF * per_fall / q; // 1/2qu
        let zero = R::ZERO;
        // The derivatives of `A`, `u` and `h1` with respect to `c`, then to `R`.
        let ([peak_c, fall_c, top_c], [peak_r, fall_r, top_r]) = match (top > zero, bottom > zero) {
            (false, false) => {
                let fall = R::HALF / q;
                let sum = peak + trough;
                ([half, zero, zero], [R::HALF * (fall - sum * half), fall, zero])
            }
            (true, false) => ([zero, -half, per_fall], [zero, bu * half, R::ONE - bu * per_fall]),
            (false, true) => ([half, half, zero], [bd * half, bd * half, zero]),
            (true, true) => ([zero, zero, per_fall], [zero, zero, bd * per_fall]),
        };
        let alpha = gu * peak_c + top_c + R::HALF * gd * fall_c;
        let beta = gu * peak_r + top_r + R::HALF * gd * fall_r;
        let nu = R::ONE - beta;
        let (k0, k1) = (c0 - first, c1 - last);
        let (first_c, first_r) = (gu * peak_c, gu * peak_r);
        let (last_c, last_r) = (gu * (fall_c - peak_c), gu * (fall_r - peak_r));
        let p = gu * (alpha * a0 + beta - R::ONE);
        let r = -gu * (alpha * a1 + beta);
        Derivatives {
            first: first_derivatives([first, c0], [last, c1], self.slope(profile), sign),
            #[rustfmt::skip]
            second: [
                -alpha,
                p, k0 * gu * (first_c * a0 + first_r - R::ONE) + first * p,
                alpha, -p, -alpha,
                r, first * r - gu * k0 * (first_c * a1 + first_r),
                    -r, last * r - k1 * gu * (R::ONE - last_c * a1 - last_r),
                sign * beta, sign * (k0 * first_r + first * beta),
                    sign * nu, -sign * (k1 * last_r + last * nu), k1 * (fall_r - peak_r) - trough * nu,
            ],
        }
    }

    /// The two ramps know nothing of each other, and the duration adds to the cruise alone.
    fn derivatives_of_cruise(&self, profile: &Profile<R>, sign: R) -> Derivatives<R> {
        let Profile { peak, top, trough, bottom, .. } = *profile;
        let PerJerk { gu, gd } = self.per_jerk;
        let q = self.per_jerk.q();
        let (start @ [first, c0], end @ [last, c1]) = self.halves(profile, [peak, -trough]);
        let zero = R::ZERO;
        let ramp = |peak: R, hold: R, a: R, rise: R, middle: R| {
            let (per_peak, per_hold) = if hold > zero {
                (zero, R::ONE / peak)
            } else if peak > zero {
                (R::HALF / (q * peak), zero)
            } else {
                (zero, zero)
            };
            let alpha = (gu + R::HALF * gd) * per_peak + per_hold;
            let mixed = gu * (alpha * a - R::ONE);
            let of_a = (middle - rise) * gu * (gu * per_peak * a - R::ONE) + rise * mixed;
            [-alpha, mixed, of_a]
        };
        let [v0v0, a0v0, a0a0] = ramp(peak, top, self.a0, first, c0);
        // In the other order of time the acceleration has the other sign.
        let [vv, va, aa] = ramp(-trough, bottom, -self.a1, last, c1);
        Derivatives {
            first: first_derivatives(start, end, self.limits.vmax, sign),
            #[rustfmt::skip]
            second: [
                v0v0,
                a0v0, a0a0,
                zero, zero, vv,
                zero, zero, -va, aa,
                zero, zero, zero, zero, zero,
            ],
        }
    }

    /// How long the acceleration rises at the start, and from there to the middle of the fall, s: `t1`, `c0`. The same from the end: `t7`, `c1`.
    /// `falls` is how far the acceleration falls, counted from the start and from the end: the fall pauses where the axis cruises.
    fn halves(&self, profile: &Profile<R>, falls: [R; 2]) -> ([R; 2], [R; 2]) {
        let PerJerk { gu, gd } = self.per_jerk;
        let half = |rise: R, hold: R, fall: R| [gu * rise, gu * rise + hold + R::HALF * gd * fall];
        let [after, before] = falls;
        (half(profile.first, profile.top, after), half(profile.last, profile.bottom, before))
    }
}

fn first_derivatives<R: Real>([first, c0]: [R; 2], [last, c1]: [R; 2], by_t: R, sign: R) -> [R; 5] {
    [sign * c0, sign * first * (c0 - R::HALF * first), sign * c1, -sign * last * (c1 - R::HALF * last), by_t]
}
