//! What is wrong with axes on a straight line.

use super::judge::{Planner, Timing, Verdict, scale_of_short_ramps, tightest};
use super::problems::Set;
use crate::online::judge::{Scale, Trial, doubt};
use crate::online::problems::{Problem, Wish};
use atraj::Findings;
use atraj::online::Move;
use support::{Random, Real};

/// The shares of the axes in the longest way, and the axis that goes it.
fn shares<R: Real>(set: &Set<R>) -> (Vec<R>, usize) {
    let way = |axis: &Problem<R>| axis.to.position - axis.from.position;
    let mut lead = 0;
    for (k, axis) in set.axes.iter().enumerate() {
        if way(axis).widen().abs() > way(&set.axes[lead]).widen().abs() {
            lead = k;
        }
    }
    let longest = way(&set.axes[lead]);
    let is_still = longest.widen() == 0.0;
    let share = |axis| {
        if is_still {
            longest
        } else {
            way(axis) / longest
        }
    };
    (set.axes.iter().map(share).collect(), lead)
}

/// The lead within the tightest limits of all axes.
fn lead_of<R: Real>(set: &Set<R>, shares: &[R], lead: usize) -> Problem<R> {
    let axis = set.axes[lead];
    if shares[lead].widen() == 0.0 {
        return axis;
    }
    let state =
        |state: atraj::online::State<R>| [state.position, state.velocity, state.acceleration];
    let numbers = [
        &tightest(set, shares)[..],
        &state(axis.from),
        &state(axis.to),
    ]
    .concat();
    Problem::of(
        axis.kind,
        Wish::Plan,
        numbers.try_into().expect("12 numbers"),
    )
}

/// Judges axes on a straight line.
pub fn judge<R: Real>(
    planner: &impl Planner<R>,
    set: &Set<R>,
    random: &mut Random,
) -> Option<Verdict> {
    let mut axes = vec![Move::default(); set.axes.len()];
    let found = match planner.line(set, &mut axes) {
        Ok(found) => found,
        Err(error) => return Some(Verdict::Refused(error)),
    };
    // The lead comes inside within the tightest limits. So an axis may go further out than its own limits make unavoidable.
    let outside = found.bits() & Findings::STARTS_OUTSIDE.bits() != 0;
    let is_excused = |verdict: &Verdict| {
        outside && matches!(verdict, Verdict::Wrong(_, what) if what.ends_with("beyond its limit"))
    };
    let (shares, lead) = shares(set);
    let [duration, cycle] = [set.duration, set.cycle].map(R::widen);
    let timing = Timing {
        axes: &[Trial::new(lead_of(set, &shares, lead))],
        duration,
        cycle,
    };
    wrong_motions(set, &shares, lead, &axes, random)
        .filter(|verdict| !is_excused(verdict))
        .or_else(|| timing.wrong(axes[0].t.widen(), || None))
}

/// Whether a motion is none, or leaves the line.
fn wrong_motions<R: Real>(
    set: &Set<R>,
    shares: &[R],
    lead: usize,
    axes: &[Move<R>],
    random: &mut Random,
) -> Option<Verdict> {
    let t = axes[lead].t;
    let [p0, p1] = [set.axes[lead].from, set.axes[lead].to].map(|end| end.position.widen().abs());
    for (k, problem) in set.axes.iter().enumerate() {
        if axes[k].t.low_bits() != t.low_bits() {
            return Some(Verdict::Wrong(k, "the axes do not arrive together"));
        }
        let trial = Trial::new(*problem);
        // The positions of the lead are rounded too.
        let more = scale_of_short_ramps(&trial, t.widen()).and(&Scale {
            position: shares[k].widen().abs() * (p0 + p1),
            ..Scale::default()
        });
        let what = trial
            .wrong_states(&axes[k], &more, random)
            .or_else(|| leaves_line(set, [lead, k], shares[k], axes, random));
        if let Some(what) = what {
            return Some(Verdict::Wrong(k, what));
        }
    }
    None
}

/// Whether an axis is ever beside the straight line, seen from the lead.
fn leaves_line<R: Real>(
    set: &Set<R>,
    [lead, k]: [usize; 2],
    share: R,
    axes: &[Move<R>],
    random: &mut Random,
) -> Option<&'static str> {
    let end = |k: usize| set.axes[k].to.position.widen();
    let phases = |k: usize| &axes[k].phase[..=axes[k].phases as usize];
    let borders = phases(lead).iter().map(|phase| phase.t);
    let reach = |k: usize| {
        let positions = phases(k).iter().map(|phase| {
            let [p, v, a] = [phase.position, phase.velocity, phase.acceleration].map(R::widen);
            let t = phase.duration.widen();
            p.abs() + t * (v.abs() + t * a.abs())
        });
        positions.fold(0.0, f64::max)
    };
    let scale = reach(k) + share.widen().abs() * reach(lead);
    let within = [(); 4].map(|()| R::of(random.unit()) * axes[lead].t);
    let mut times = borders.chain(within);
    let is_beside = |x: R| {
        let [led, own] = [lead, k].map(|k| axes[k].position(x).widen());
        let beside = own - end(k) - share.widen() * (led - end(lead));
        beside.abs() > doubt::<R>() * scale
    };
    times.any(is_beside).then_some("it leaves the line")
}
