//! The first motion on the border that gets as far as wanted.
//!
//! The search begins at the direct ramp, whose duration allows one displacement only. From there the pieces of the border follow each other
//! as the duration grows: the acceleration eases, changes its sign, holds at one limit, holds at both, and the axis cruises.

use super::border::Border;
use super::piece::{Easing, Piece};
use super::profile::Profile;
use super::ramp::{Fitted, Passed, Ramp};
use super::rounding::{of_formula, of_state};
use crate::real::Real;
use crate::roots::larger_root;

#[derive(Clone, Copy)]
pub(crate) struct Displacement<R> {
    pub h: R,
    /// The sum of the magnitudes of both positions: their rounding is an ulp of it.
    pub positions: R,
}

/// How often a duration leads to a later one: on each side a displacement may become impossible once, and a gap may follow. A gap may seem to end later.
const MOST_DELAYS: u32 = 5;
/// While the acceleration eases, a hold ends once at most.
const EASING_PIECES: u32 = 2;

/// What the displacement of a motion lacks.
#[derive(Clone, Copy)]
struct Shortfall<R> {
    lacks: R,
    /// What of it is rounding.
    tie: R,
}

impl<R: Real> Shortfall<R> {
    fn is_rounding(&self) -> bool {
        self.lacks.abs() <= self.tie
    }
}

/// Where the border first gets as far as wanted, before a gap: durations in which the end cannot be reached.
enum Crossing<R> {
    At(Profile<R>),
    /// A gap comes first: the last motion before it.
    GapAfter(Profile<R>),
}

impl<R: Real> Crossing<R> {
    fn map(self, motion: impl Fn(Profile<R>) -> Profile<R>) -> Self {
        match self {
            Self::At(profile) => Self::At(motion(profile)),
            Self::GapAfter(profile) => Self::GapAfter(motion(profile)),
        }
    }
}

/// The last motion of a piece that does not get as far as wanted, and what its displacement lacks.
type Lacking<R> = (Profile<R>, R);

/// The fastest motion over a displacement.
pub(crate) fn fastest<R: Real>(border: &Border<R>, wanted: Displacement<R>) -> Profile<R> {
    if border.a0 == R::ZERO && border.a1 == R::ZERO && border.dv == R::ZERO {
        return from_steady(border, wanted.h, border.rounding_of_displacement(R::ZERO, wanted.positions));
    }
    let beyond = border.beyond_straight();
    // What is left of a move may be a straight change of the acceleration, up to rounding.
    if beyond != R::ZERO && beyond.abs() <= border.rounding_before() {
        let straight = Ramp::straight(border.a0, border.a1);
        let shortfall = shortfall(border, &straight, wanted);
        if shortfall.is_rounding() && shortfall.tie.is_finite() {
            return border.profile(&straight);
        }
        if let Some(timed) = border.timed(&straight, shortfall.lacks) {
            return border.profile(&timed);
        }
    }
    let direct = border.direct(beyond);
    let of_direct = shortfall(border, &direct, wanted);
    let last_before_gap = match crossing_after_ramp(border, &direct, wanted.h, of_direct) {
        Crossing::At(motion) => return without_overshoot(border, motion, &direct, of_direct.lacks, wanted),
        Crossing::GapAfter(last) => last.as_ramp(),
    };
    if shortfall(border, &last_before_gap, wanted).is_rounding() {
        return border.profile(&last_before_gap);
    }
    let after = border.after_gap();
    let motion = match crossing_after_ramp(border, &after, wanted.h, shortfall(border, &after, wanted)) {
        Crossing::At(motion) => motion,
        Crossing::GapAfter(_) => border.profile(&after),
    };
    // The fastest ramp is the last one that is tried.
    let ramps = [&after, &last_before_gap, &direct];
    let shorter = |motion, ramp| without_overshoot(border, motion, ramp, shortfall(border, ramp, wanted).lacks, wanted);
    ramps.into_iter().fold(motion, shorter)
}

/// The first motion over `h` from the duration of a ramp on. This duration allows one displacement only, whose shortfall is given.
fn crossing_after_ramp<R: Real>(border: &Border<R>, ramp: &Ramp<R>, h: R, shortfall: Shortfall<R>) -> Crossing<R> {
    let lacks = shortfall.lacks;
    if shortfall.is_rounding() && shortfall.tie.is_finite() {
        let fitted = border.fitted(ramp, lacks).filter(|_| !ramp.is_straight());
        return Crossing::At(border.profile(&fitted.map_or(*ramp, |fitted| fitted.ramp)));
    }
    let mirrored = lacks < R::ZERO;
    let axis = border.mirrored_if(mirrored);
    let mut base = axis.profile(&ramp.mirrored_if(mirrored));
    split_at_0(&axis, &mut base);
    crossing_after(&axis, base, h.negate_if(mirrored), lacks.abs()).map(|profile| Profile { mirrored, ..profile })
}

/// The motion, or the ramp, if the motion overshoots only because of rounding errors of the velocities: with a change of the velocity at the start
/// by its rounding error, the ramp, whose displacement lacks `lacks` of `h`, is the motion.
fn without_overshoot<R: Real>(
    border: &Border<R>, motion: Profile<R>, ramp: &Ramp<R>, lacks: R, wanted: Displacement<R>,
) -> Profile<R> {
    let fitted = |ramp: &Ramp<R>| {
        let Fitted { ramp, faster } = border.fitted(ramp, lacks)?;
        let Passed { duration, displacement } = border.passed(&ramp);
        let lacks = wanted.h - (displacement - faster * duration);
        (lacks.abs() <= border.rounding_of_displacement(duration, wanted.positions)).then_some((ramp, duration))
    };
    let found = if ramp.is_straight() {
        // The ramp grows to one side, or to the other one if its acceleration is at a limit.
        let below = lacks < R::ZERO;
        let sides = [below, !below].map(|mirrored| border.straight(mirrored));
        sides.iter().find_map(fitted)
    } else {
        fitted(ramp)
    };
    let lasts = motion.duration(border.per_jerk.mirrored_if(motion.mirrored));
    match found {
        Some((ramp, duration)) if lasts > duration => border.profile(&ramp),
        _ => motion,
    }
}

/// The fastest motion over `h` between equal velocities without acceleration: the direct ramp has no duration.
fn from_steady<R: Real>(border: &Border<R>, h: R, tie: R) -> Profile<R> {
    let mirrored = h < R::ZERO;
    let distance = h.abs();
    let stay = border.profile(&Ramp::straight(border.a0, border.a1));
    if distance <= tie {
        return stay;
    }
    Profile { mirrored, ..turning(&border.mirrored_if(mirrored), stay, distance, distance) }
}

/// The shortest duration from `t` on in which the displacement `h` is possible; infinite if numbers are beyond the range.
pub(crate) fn next_duration<R: Real>(
    border: &Border<R>, mut t: R, Displacement { h, positions }: Displacement<R>,
) -> R {
    let after_gap = || border.passed(&border.after_gap()).duration;
    // At its end a gap may seem to be still ahead. A little later it does not.
    let later = |t: R, than: R| if t > than { t } else { than + of_state(than) };
    for _ in 0..MOST_DELAYS {
        let mirrored = border.mirrored();
        let (Some(farthest), Some(nearest)) = (border.farthest(t), mirrored.farthest(t)) else {
            // The fastest motion is below the shortest ramp, if its velocities are equal up to rounding.
            t = later(after_gap().at_least(border.shortest()), t);
            continue;
        };
        let tie = border.rounding_of_displacement(t, positions);
        let lacks = h - border.displacement(&farthest);
        let exceeds = -h - mirrored.displacement(&nearest);
        if !(lacks - exceeds).is_finite() {
            return R::INFINITY;
        }
        let (axis, h, base, lacks) = if lacks > tie {
            (*border, h, farthest, lacks)
        } else if exceeds > tie {
            (mirrored, -h, nearest, exceeds)
        } else {
            return t;
        };
        let next = match crossing_after(&axis, base, h, lacks) {
            Crossing::GapAfter(last) if h - axis.displacement(&last) > tie => None,
            Crossing::At(motion) | Crossing::GapAfter(motion) => Some(motion.duration(axis.per_jerk)),
        };
        // Rounding can yield a spurious motion just after the gap begins. The real one lies before the gap.
        let is_before = |next: R| next < t - of_formula(t);
        t = match next {
            Some(next) if !is_before(next) => next,
            // With an infinite jerk this time is inaccurate, and can fake a gap that has ended.
            _ => later(after_gap(), t),
        };
    }
    t
}

/// What the displacement of a ramp lacks of the one that is wanted.
fn shortfall<R: Real>(border: &Border<R>, ramp: &Ramp<R>, wanted: Displacement<R>) -> Shortfall<R> {
    let Passed { duration, displacement } = border.passed(ramp);
    Shortfall { lacks: wanted.h - displacement, tie: border.rounding_of_displacement(duration, wanted.positions) }
}

/// Makes a straight rise through 0, or from or to 0, two rises: the acceleration may pause at 0.
fn split_at_0<R: Real>(border: &Border<R>, profile: &mut Profile<R>) {
    let is_straight = profile.fall == R::ZERO && profile.top + profile.bottom == R::ZERO;
    if is_straight && border.a0 <= R::ZERO && border.a1 >= R::ZERO {
        (profile.first, profile.last) = (-border.a0, border.a1);
        (profile.peak, profile.trough) = (R::ZERO, R::ZERO);
    }
}

/// The first motion of the border over `h`: it gets `lacks` farther than `base`. A gap may come first where the acceleration keeps its sign in mid-motion.
fn crossing_after<R: Real>(border: &Border<R>, base: Profile<R>, h: R, lacks: R) -> Crossing<R> {
    let keeps_sign = base.trough > R::ZERO || base.peak < R::ZERO;
    let found = if keeps_sign { before_gap(border, base, lacks) } else { Err((base, lacks)) };
    found.unwrap_or_else(|(base, lacks)| Crossing::At(turning(border, base, h, lacks)))
}

/// The part of the border in which the acceleration keeps its sign in the middle of the motion.
fn before_gap<R: Real>(border: &Border<R>, base: Profile<R>, lacks: R) -> Result<Crossing<R>, Lacking<R>> {
    if base.trough > R::ZERO {
        return easing(border, base, lacks);
    }
    let found = easing(&border.reversed(), base.reversed(), lacks);
    found.map(|crossing| crossing.map(Profile::reversed)).map_err(|(last, lacks)| (last.reversed(), lacks))
}

/// The part of the border in which the acceleration stays positive, and eases more and more in the middle of the motion.
fn easing<R: Real>(border: &Border<R>, mut base: Profile<R>, mut lacks: R) -> Result<Crossing<R>, Lacking<R>> {
    for _ in 0..EASING_PIECES {
        let piece = Piece::of(border, &base, base.top > R::ZERO);
        let (end, what) = piece.end_of_easing(border.a0);
        match piece.find_crossing(lacks, end, false) {
            Ok(x) => return Ok(Crossing::At(piece.profile(x))),
            Err(beyond) => lacks = beyond,
        }
        base = piece.profile(end);
        match what {
            Easing::HoldEnds => base.top = R::ZERO,
            Easing::Vanishes => {
                // Exact, where the digits of high accelerations cancel.
                (base.peak, base.trough) = (base.fall, R::ZERO);
                return Err((base, lacks));
            }
            Easing::IsFollowedByGap => {
                base.last = base.last + base.first;
                base.trough = base.trough - base.first;
                (base.first, base.peak) = (R::ZERO, border.a0);
                break;
            }
        }
    }
    Ok(Crossing::GapAfter(base))
}

/// The first motion over `h` on the part of the border in which the acceleration changes its sign in the middle of the motion: it
/// gets `lacks` farther than `base`.
fn turning<R: Real>(border: &Border<R>, mut base: Profile<R>, h: R, mut lacks: R) -> Profile<R> {
    let ramps @ [up, down] = border.ramps_to_vmax();
    let while_up = up.passed(border.v0, border.a0, R::ZERO, border.per_jerk).displacement;
    let while_down = down.passed(border.v1, -border.a1, R::ZERO, border.per_jerk).displacement;
    let displacement = while_up + while_down;
    if h >= displacement {
        return Border::by_way_of_vmax(ramps, (h - displacement) / border.limits.vmax);
    }
    if !(base.top > R::ZERO || base.bottom > R::ZERO) {
        let piece = Piece::of(border, &base, false);
        let end = until_hold(border, &base);
        if end > R::ZERO {
            match piece.find_crossing(lacks, end, true) {
                Ok(x) => return piece.profile(x),
                Err(beyond) => lacks = beyond,
            }
            base = piece.profile(end);
        }
    }
    let holds = base.top > R::ZERO || base.bottom > R::ZERO;
    let (bu, bd) = (border.limits.amax, -border.limits.amin);
    let nearer = bu - base.peak <= bd + base.trough;
    if base.top > R::ZERO || !holds && nearer {
        holding(border, base, lacks)
    } else {
        holding(&border.reversed(), base.reversed(), lacks).reversed()
    }
}

/// How much more the acceleration falls until a hold begins. The peak is not below 0 and the trough not above, so no digits cancel.
fn until_hold<R: Real>(border: &Border<R>, base: &Profile<R>) -> R {
    let Profile { peak, trough, .. } = *base;
    let until = |limit: R, reached: R, opposite: R| {
        let remains = limit - reached;
        let beyond = remains * (limit + reached);
        if !beyond.is_finite() {
            R::INFINITY
        } else if beyond > R::ZERO {
            remains + beyond / (opposite + (opposite * opposite + beyond).sqrt())
        } else {
            // A ramp that just reaches a limit may pass the limit by a rounding.
            R::ZERO
        }
    };
    let top = until(border.limits.amax, peak, -trough);
    let bottom = until(-border.limits.amin, -trough, peak);
    top.at_most(bottom)
}

/// The highest acceleration holds, and at last the lowest one too.
fn holding<R: Real>(border: &Border<R>, mut base: Profile<R>, lacks: R) -> Profile<R> {
    base.peak = border.limits.amax;
    let piece = Piece::of(border, &base, true);
    let end = (base.trough - border.limits.amin).at_least(R::ZERO);
    match piece.find_crossing(lacks, end, true) {
        Ok(x) => piece.profile(x),
        Err(lacks) => both_hold(border, piece.profile(end), lacks),
    }
}

/// Both accelerations hold, and the displacement is a quadratic.
fn both_hold<R: Real>(border: &Border<R>, base: Profile<R>, lacks: R) -> Profile<R> {
    let (bu, bd) = (border.limits.amax, -border.limits.amin);
    let sum = bu + bd;
    let curvature = bu * bd / sum;
    let slope = border.slope(&base);
    let longer = larger_root(slope / curvature, -(lacks + lacks) / curvature);
    Profile { top: base.top + bd / sum * longer, trough: -bd, bottom: base.bottom + bu / sum * longer, ..base }
}
