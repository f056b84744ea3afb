//! What is wrong with axes on a straight line.

use super::Set;
use super::several::{Bad, Planner, Timing, plan_of, scale_of_a_shift, scale_of_short_ramps, time_shift, wrong};
use crate::judge::{Check, Problem, Scale, Trial, Verdict, doubt, parts, widened};
use crate::liba::Original;
use support::prelude::*;

/// The shares of the axes in the longest way, and the axis that goes it. Of ways that are as long, the one with the finest roundings tells the
/// fastest motion best. In the roundings of another one, a slow axis may arrive many ticks earlier or later.
fn shares<R: Real>(set: &Set<R>) -> (Vec<R>, usize) {
    let way = |axis: &Problem<R>| axis.to.position - axis.from.position;
    let length = |axis: &Problem<R>| way(axis).widen().abs();
    let positions = |axis: &Problem<R>| axis.from.position.widen().abs() + axis.to.position.widen().abs();
    let mut lead = 0;
    for (k, axis) in set.axes.iter().enumerate() {
        let leading = &set.axes[lead];
        let as_long = length(axis) == length(leading);
        if length(axis) > length(leading) || as_long && positions(axis) < positions(leading) {
            lead = k;
        }
    }
    let longest = way(&set.axes[lead]);
    let is_still = longest.widen() == 0.0;
    let share = |axis| {
        if is_still { longest } else { way(axis) / longest }
    };
    (set.axes.iter().map(share).collect(), lead)
}

fn lead_of<R: Real>(set: &Set<R>, shares: &[R], lead: usize) -> Problem<R> {
    let axis = set.axes[lead];
    if shares[lead].widen() == 0.0 {
        return axis;
    }
    let numbers = [&tightest(set, shares)[..], &parts(axis.from), &parts(axis.to)].concat();
    Problem::of(axis.kind, axis.request, numbers.try_into().expect("12 numbers"))
}

fn tightest<R: Real>(set: &Set<R>, shares: &[R]) -> [R; 6] {
    let mut tightest = [R::INFINITY, -R::INFINITY].repeat(3);
    for (axis, &share) in set.axes.iter().zip(shares) {
        if share.widen() == 0.0 {
            continue;
        }
        let limits = widened(&axis.limits).map(R::of);
        for k in 0..6 {
            let seen = limits[if share.widen() > 0.0 { k } else { k ^ 1 }] / share;
            let is_tighter = seen.widen().abs() < tightest[k].widen().abs();
            tightest[k] = if is_tighter { seen } else { tightest[k] };
        }
    }
    tightest.try_into().expect("six limits")
}

pub fn judge<R: Original>(planner: &impl Planner<R>, set: &Set<R>, random: &mut Random) -> Check<Bad> {
    let mut axes = vec![Move::default(); set.axes.len()];
    let found = planner.line(set, &mut axes).map_err(|error| (0, Verdict::Refused(error)))?;
    // The lead recovers within the tightest limits. So an axis may go further out than its own limits make unavoidable.
    let outside = found.bits() & Findings::STARTS_OUTSIDE.bits() != 0;
    let is_excused =
        |(_, verdict): &Bad| outside && matches!(verdict, Verdict::Wrong(what) if what.ends_with("beyond its limit"));
    let (shares, lead) = shares(set);
    let [duration, cycle] = [set.duration, set.cycle].map(R::widen);
    let of_lead = Trial::new(lead_of(set, &shares, lead));
    let shift = time_shift(&of_lead.problem, &axes[lead]);
    let scales = [Scale::of(&of_lead.problem, &plan_of(&axes[lead])), scale_of_a_shift(&of_lead, &axes[lead], shift)];
    let timing = Timing { axes: &[of_lead], shifts: &[shift], planned: &axes[lead..=lead], duration, cycle };
    match check_motions(set, &scales, (&shares, lead), &axes, random) {
        Err(bad) if !is_excused(&bad) => Err(bad),
        _ => timing.check(axes[0].t.widen(), || None),
    }
}

fn check_motions<R: Original>(
    set: &Set<R>, [of_lead, of_shift]: &[Scale; 2], (shares, lead): (&[R], usize), axes: &[Move<R>],
    random: &mut Random,
) -> Check<Bad> {
    let t = axes[lead].t;
    let [p0, p1] = [set.axes[lead].from, set.axes[lead].to].map(|end| end.position.widen().abs());
    for (k, problem) in set.axes.iter().enumerate() {
        if axes[k].t.low_bits() != t.low_bits() {
            return wrong(k, "the axes do not arrive together");
        }
        let trial = Trial::new(*problem);
        let positions = Scale { position: p0 + p1, ..Scale::default() }; // the positions of the lead are rounded too
        // The lead is planned within the tightest limits, under which its numbers may be larger than those of an axis with sharper ones.
        let share = shares[k].widen().abs();
        let larger = of_lead.times(share).beyond(&Scale::of(problem, &plan_of(&axes[k])));
        let more = of_shift.and(&positions).times(share).and(&larger);
        let more = scale_of_short_ramps(&trial, t.widen()).and(&more);
        trial.check_states(&plan_of(&axes[k]), &more, random).or_else(|what| wrong(k, what))?;
        if leaves_line(set, [lead, k], shares[k], axes, random) {
            return wrong(k, "it leaves the line");
        }
    }
    Ok(())
}

fn leaves_line<R: Real>(set: &Set<R>, [lead, k]: [usize; 2], share: R, axes: &[Move<R>], random: &mut Random) -> bool {
    let end = |k: usize| set.axes[k].to.position.widen();
    let phases = |k: usize| &axes[k].phase[..=axes[k].count as usize];
    let borders = phases(lead).iter().map(|phase| phase.start);
    let reach = |k: usize| {
        let positions = phases(k).iter().map(|phase| {
            let [p, v, a] = [phase.position, phase.velocity, phase.acceleration].map(R::widen);
            let t = phase.duration.widen();
            p.abs() + t * (v.abs() + t * a.abs())
        });
        positions.fold(0.0, f64::max)
    };
    let scale = reach(k) + share.widen().abs() * reach(lead);
    let mut times = borders.chain([(); 4].map(|()| R::of(random.unit()) * axes[lead].t));
    let is_off = |x: R| {
        let [led, own] = [lead, k].map(|k| axes[k].position(x).widen());
        let off = own - end(k) - share.widen() * (led - end(lead));
        off.abs() > doubt::<R>() * scale
    };
    times.any(is_off)
}
