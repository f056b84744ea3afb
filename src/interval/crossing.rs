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
use core::slice;

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

/// Whether a motion gets as far as wanted.
#[derive(Clone, Copy, PartialEq)]
enum Crossing {
    /// It is the first one that does.
    Here,
    /// It is the last one before a gap: durations in which the end cannot be reached.
    BehindGap,
    /// It is the last one of its part of the border.
    Later,
}

/// The fastest motion over a displacement.
pub(crate) fn fastest<R: Real>(border: &Border<R>, wanted: Displacement<R>) -> Profile<R> {
    if border.a0 == R::ZERO && border.a1 == R::ZERO && border.dv == R::ZERO {
        return from_steady(border, wanted.h, border.rounding_of_displacement(R::ZERO, wanted.positions));
    }
    let beyond = border.beyond_straight();
    // What is left of a move may be a straight change of the acceleration, up to rounding.
    if beyond != R::ZERO && border.is_left_over(beyond) {
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
    let mut crossing = Crossing::Here;
    let mut motion = crossing_after_ramp(border, &direct, wanted.h, of_direct, &mut crossing);
    if crossing == Crossing::Here {
        without_overshoot(border, &mut motion, &direct, of_direct.lacks, wanted);
        return motion;
    }
    let last_before_gap = motion.as_ramp();
    if shortfall(border, &last_before_gap, wanted).is_rounding() {
        return border.profile(&last_before_gap);
    }
    let after = border.after_gap();
    motion = crossing_after_ramp(border, &after, wanted.h, shortfall(border, &after, wanted), &mut crossing);
    if crossing != Crossing::Here {
        motion = border.profile(&after);
    }
    // The fastest ramp is the last one that is tried.
    for ramp in [&after, &last_before_gap, &direct] {
        without_overshoot(border, &mut motion, ramp, shortfall(border, ramp, wanted).lacks, wanted);
    }
    motion
}

/// The first motion over `h` from the duration of a ramp on, or the last one before a gap: `crossing` tells. This duration allows one displacement
/// only, whose shortfall is given.
fn crossing_after_ramp<R: Real>(
    border: &Border<R>, ramp: &Ramp<R>, h: R, shortfall: Shortfall<R>, crossing: &mut Crossing,
) -> Profile<R> {
    let lacks = shortfall.lacks;
    if shortfall.is_rounding() && shortfall.tie.is_finite() {
        let fitted = if ramp.is_straight() { None } else { border.fitted(ramp, lacks) };
        *crossing = Crossing::Here;
        return border.profile(&fitted.map_or(*ramp, |fitted| fitted.ramp));
    }
    let mirrored = lacks < R::ZERO;
    let axis = border.mirrored_if(mirrored);
    let mut motion = axis.profile(&ramp.mirrored_if(mirrored));
    split_at_0(&axis, &mut motion);
    *crossing = go_on(&axis, &mut motion, h.negate_if(mirrored), lacks.abs());
    motion.mirrored = mirrored;
    motion
}

/// Makes the motion the ramp, if it overshoots only because of rounding errors of the velocities: with a change of the velocity at the start
/// by its rounding error, the ramp, whose displacement lacks `lacks` of `h`, is the motion.
fn without_overshoot<R: Real>(
    border: &Border<R>, motion: &mut Profile<R>, ramp: &Ramp<R>, lacks: R, wanted: Displacement<R>,
) {
    let sides;
    let ramps = if ramp.is_straight() {
        // The ramp grows to one side, or to the other one if its acceleration is at a limit.
        let below = lacks < R::ZERO;
        sides = [below, !below].map(|mirrored| border.straight(mirrored));
        &sides
    } else {
        slice::from_ref(ramp)
    };
    for Fitted { ramp, faster } in ramps.iter().filter_map(|ramp| border.fitted(ramp, lacks)) {
        let Passed { duration, displacement } = border.passed(&ramp);
        let lacks = wanted.h - (displacement - faster * duration);
        if lacks.abs() <= border.rounding_of_displacement(duration, wanted.positions) {
            if motion.duration(border.per_jerk.mirrored_if(motion.mirrored)) > duration {
                *motion = border.profile(&ramp);
            }
            return;
        }
    }
}

/// The fastest motion over `h` between equal velocities without acceleration: the direct ramp has no duration.
fn from_steady<R: Real>(border: &Border<R>, h: R, tie: R) -> Profile<R> {
    let mirrored = h < R::ZERO;
    let distance = h.abs();
    let mut motion = border.profile(&Ramp::straight(border.a0, border.a1));
    if distance > tie {
        turning(&border.mirrored_if(mirrored), &mut motion, distance, distance);
        motion.mirrored = mirrored;
    }
    motion
}

/// The shortest duration from `t` on in which the displacement `h` is possible; if that is after `latest`, any after it; infinite beyond the range.
pub(crate) fn next_duration<R: Real>(
    border: &Border<R>, mut t: R, latest: R, Displacement { h, positions }: Displacement<R>,
) -> R {
    let after_gap = || border.passed(&border.after_gap()).duration;
    // At its end a gap may seem to be still ahead. A little later it does not.
    let later = |t: R, than: R| if t > than { t } else { than + of_state(than) };
    for _ in 0..MOST_DELAYS {
        if t > latest {
            break;
        }
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
        let (axis, h, mut motion, lacks) = if lacks > tie {
            (border, h, farthest, lacks)
        } else if exceeds > tie {
            (&mirrored, -h, nearest, exceeds)
        } else {
            return t;
        };
        let crossing = go_on(axis, &mut motion, h, lacks);
        let is_there = crossing == Crossing::Here || h - axis.displacement(&motion) <= tie;
        let next = is_there.then(|| motion.duration(axis.per_jerk));
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

/// Goes on along the border to the first motion over `h`, which gets `lacks` farther, or to the last one before a gap. A gap may come first where the
/// acceleration keeps its sign in mid-motion.
#[inline] // a call less in each plan
fn go_on<R: Real>(border: &Border<R>, motion: &mut Profile<R>, h: R, mut lacks: R) -> Crossing {
    let crossing = if motion.trough > R::ZERO {
        easing(border, motion, &mut lacks)
    } else if motion.peak < R::ZERO {
        motion.reverse();
        let crossing = easing(&border.reversed(), motion, &mut lacks);
        motion.reverse();
        crossing
    } else {
        Crossing::Later
    };
    if crossing == Crossing::Later {
        turning(border, motion, h, lacks);
        return Crossing::Here;
    }
    crossing
}

/// The part of the border in which the acceleration stays positive, and eases more and more in the middle of the motion.
fn easing<R: Real>(border: &Border<R>, motion: &mut Profile<R>, lacks: &mut R) -> Crossing {
    for _ in 0..EASING_PIECES {
        let holds = motion.top > R::ZERO;
        let mut piece = Piece::of(border, motion, holds);
        let (end, what) = piece.end_of_easing(border.a0);
        let Some(beyond) = piece.go_on(*lacks, end, false) else { return Crossing::Here };
        *lacks = beyond;
        match what {
            Easing::HoldEnds => motion.top = R::ZERO,
            Easing::Vanishes => {
                // Exact, where the digits of high accelerations cancel.
                (motion.peak, motion.trough) = (motion.fall, R::ZERO);
                return Crossing::Later;
            }
            Easing::IsFollowedByGap => {
                motion.last = motion.last + motion.first;
                motion.trough = motion.trough - motion.first;
                (motion.first, motion.peak) = (R::ZERO, border.a0);
                break;
            }
        }
    }
    Crossing::BehindGap
}

/// The part of the border in which the acceleration changes its sign in the middle of the motion: goes on to the first motion over `h`, which gets
/// `lacks` farther.
fn turning<R: Real>(border: &Border<R>, motion: &mut Profile<R>, h: R, mut lacks: R) {
    let ramps @ [up, down] = border.ramps_to_vmax();
    let while_up = up.passed(border.v0, border.a0, R::ZERO, border.per_jerk).displacement;
    let while_down = down.passed(border.v1, -border.a1, R::ZERO, border.per_jerk).displacement;
    let displacement = while_up + while_down;
    if h >= displacement {
        *motion = Border::by_way_of_vmax(ramps, (h - displacement) / border.limits.vmax);
        return;
    }
    if !(motion.top > R::ZERO || motion.bottom > R::ZERO) {
        let end = until_hold(border, motion);
        if end > R::ZERO {
            let Some(beyond) = Piece::of(border, motion, false).go_on(lacks, end, true) else { return };
            lacks = beyond;
        }
    }
    let holds = motion.top > R::ZERO || motion.bottom > R::ZERO;
    let (bu, bd) = (border.limits.amax, -border.limits.amin);
    let nearer = bu - motion.peak <= bd + motion.trough;
    if motion.top > R::ZERO || !holds && nearer {
        holding(border, motion, lacks);
    } else {
        motion.reverse();
        holding(&border.reversed(), motion, lacks);
        motion.reverse();
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
fn holding<R: Real>(border: &Border<R>, motion: &mut Profile<R>, lacks: R) {
    motion.peak = border.limits.amax;
    let end = (motion.trough - border.limits.amin).at_least(R::ZERO);
    if let Some(lacks) = Piece::of(border, motion, true).go_on(lacks, end, true) {
        both_hold(border, motion, lacks);
    }
}

/// Both accelerations hold, and the displacement is a quadratic.
fn both_hold<R: Real>(border: &Border<R>, motion: &mut Profile<R>, lacks: R) {
    let (bu, bd) = (border.limits.amax, -border.limits.amin);
    let sum = bu + bd;
    // Quotients first: the product of both limits may be out of range.
    let [part_up, part_down] = [bd / sum, bu / sum];
    let curvature = bu * part_up;
    let slope = border.slope(motion);
    let longer = larger_root(slope / curvature, -(lacks + lacks) / curvature);
    motion.top = motion.top + part_up * longer;
    motion.trough = -bd;
    motion.bottom = motion.bottom + part_down * longer;
}
