//! Do several axes arrive together, as early as they can, or stay on a straight line, in 20,000 sets of axes per real type?

use atraj::online::Move;
use oracle::judge::axes::faults::Fault;
use oracle::judge::axes::several::{self, Bad, Planner, Together};
use oracle::judge::axes::{Family, Set, Sets, line, of_seed};
use oracle::judge::{Check, Kind, Problem, Request, Tallies};
use oracle::liba::Original;
use support::{Random, Real, online, test_both_reals};

const SEEDS: u64 = if support::BRIEF { 1 } else { 4 };
const SETS: usize = if support::BRIEF { 1_000 } else { 5_000 };

fn axes_arrive_together<R: Original>() {
    Tallies::assert_good(R::NAME, SEEDS, SETS, |seed, sets| of_seed::<R>(&Together, seed, sets));
}

fn every_fault_is_seen<R: Original>() {
    for fault in Fault::ALL {
        let tally = of_seed::<R>(&fault, 0, 1_000).total();
        let (bad, sets) = (tally.bad(), tally.problems);
        let few = if matches!(fault, Fault::Waits) { 50 } else { 20 }; // few sets have an axis that waits
        assert!(bad * few >= sets, "{fault:?} in {}: {bad} of {sets}", R::NAME);
    }
}

/// The widest gap between the end of a phase and the start of the next one, in ulps of the duration.
fn gap<R: Real>(axis: &Move<R>) -> f64 {
    let phases = &axis.phase[..=axis.count as usize];
    let gaps = phases.windows(2).map(|pair| {
        let end = pair[0].start.widen() + pair[0].duration.widen();
        (pair[1].start.widen() - end).abs()
    });
    gaps.fold(0.0, f64::max) / (R::MACHINE_EPSILON.widen() * axis.t.widen())
}

/// An axis takes the common duration without a shift in time if both differ by 6 ulps at most. The start of a phase is rounded too. Of 50,000 sets
/// in binary32, 2 had a gap of more than 8 ulps.
fn phases_follow_each_other<R: Real>() {
    let mut widest: f64 = 0.0;
    for set in Sets::<R>::new(26).take(50_000) {
        let mut axes = vec![Move::default(); set.axes.len()];
        let planned = Together.synchronise(&set, &mut axes);
        assert!(planned.is_ok(), "{planned:?}: {}", set.show());
        for axis in axes.iter().filter(|axis| axis.t.widen() > 0.0) {
            let gap = gap(axis);
            assert!(gap <= 7.0, "{gap} ulps: {}", set.show());
            widest = widest.max(gap);
        }
    }
    assert!(widest > 0.0, "{widest}");
}

type Row = [f64; 12]; // an axis: its limits, its start and its end

fn axes<R: Real>(cycle: f64, rows: &[Row]) -> Set<R> {
    let axis = |row: &Row| Problem::of(Kind::Moving, Request::Plan, row.map(R::of));
    Set { family: Family::Moves, axes: rows.iter().map(axis).collect(), duration: R::ZERO, cycle: R::of(cycle) }
}

fn apart(cycle: f64, rows: &[Row]) -> Check<Bad> {
    several::judge(&Together, &axes::<f64>(cycle, rows), &mut Random::seeded(0))
}

fn of_line(set: &Set<f64>) -> f64 {
    let (limits, from, to) = set.columns();
    online::straight(&limits, &from, &to)[0].t
}

/// The first axis goes a little farther. So far from 0 rounding changes its displacement, and it must not lead.
#[test]
fn an_uncertain_axis_does_not_lead() {
    for far in [1e15_f64, 1e16, 3e16] {
        let row = |from, velocity, to| [8.0, -8.0, 20.0, -20.0, 100.0, -100.0, from, velocity, 0.0, to, 0.0, 0.0];
        let t = of_line(&axes(0.0, &[row(far, 3.55, far + 7.1), row(0.0, 3.195, 6.39)]));
        assert!((t - 1.3050078125).abs() < 1e-9, "{far}: {t} s");
    }
}

/// Both axes go as far, and 128 ulps of 1 less far than the ramp between their velocities. This is rounding for the first axis, but not for the
/// second one, which leads. So they brake and go back.
#[test]
fn of_two_axes_that_go_as_far_the_finer_one_leads() {
    let (jerk, way) = (f64::INFINITY, 0.625 - 128.0 * f64::EPSILON);
    let row = |from| [9.0, -9.0, 1.0, -1.0 / 64.0, jerk, -jerk, from, 1.0, 0.0, from + way, 1.5, 0.0];
    let t = of_line(&axes(0.0, &[row(7.0), row(0.0)]));
    assert!(t > 130.0, "{t} s");
}

/// Sets of axes in which the judge was wrong, or the plan was.
#[test]
#[rustfmt::skip]
fn known_sets_are_good() {
    let of_line = |set: Set<f32>| assert_eq!(line::judge(&Together, &set, &mut Random::seeded(0)), Ok(()));
    // A line is counted from its end, so an axis that is shifted in time has the phases of its fastest move up to rounding: the judge saw a jump.
    of_line(axes(0.0002649748, &[
        [570.6762, -683.005, 0.0015765755, -0.34183756, 0.00022960664, -0.00011802478, 5.1351995, -64.6683, 0.0, 5.118261, -64.6683, 0.0],
        [100.61523, -100.61523, 0.053813163, -0.00036121882, 0.00011307208, -0.00010227046, 4.1300793, 64.6683, 0.0, 4.147018, 64.6683, 0.0],
    ]));
    // Of two axes that go as far, the judge let the one lead whose positions are far from 0, and its fastest move had large roundings.
    of_line(axes(8.467512e-9, &[
        [1.5089617, -0.9301958, 0.56556946, -0.56556946, 680.40674, -80.83802, 0.29599607, 0.049285777, 0.019426448, 0.29599616, 0.049285777, 0.019426448],
        [8.086602, -6.000829, 1.6318153, -1.3454347, 885.46893, -179.05002, 0.0, 0.049285777, 0.019426448, 8.940697e-8, 0.049285777, 0.019426448],
    ]));
    // A ramp joins both ends up to rounding. The reference solver tries some of these ends only, and the judge called its duration impossible.
    let ramp = axes(0.0, &[
        [28.391020588992827, -28.391020588992827, 161.6011401515295, -37.45933811048514, 33.247303717053164, -11.378379200431727,
         0.0, 11.9558487703089, -0.7271642198254368, 5.127720470454733e-10, 11.955848770277713, -0.7271642198254368],
    ]);
    assert_eq!(line::judge::<f64>(&Together, &ramp, &mut Random::seeded(0)), Ok(()));
    // An axis is shifted in time at its start and at its end. Each is within its roundings, and the judge allowed those of one end.
    assert_eq!(apart(3.674447319727584e-13, &[
        [0.07560695002629314, -0.1960165993807255, 0.2177562829843771, -0.2177562829843771, 0.07902598402106711, -0.07902598402106711,
         -5.314358103161447, 0.024209434683268152, -0.034392874159650484, -5.314358103153544, 0.02420943467204031, -0.0343928741510563],
    ]), Ok(()));
    // An axis has 1,000 times as long as it needs. In the mean of motions at its limits rounding errors let its position jump.
    assert_eq!(apart(375.524990440379, &[
        [2.1137054399908717, -2.1137054399908717, 0.38359803842883605, -0.38359803842883605, 74.70198582519306, -74.70198582519306,
         0.0, 0.0, -0.10913559403318034, -1.1646755558612535e-25, -1.5944124849433836e-13, -0.10913559403318034],
    ]), Ok(()));
}

/// Each of four axes is a slower copy of the one before, and the end of its gap lies in the gap of the next one. So four gaps are passed.
#[test]
#[rustfmt::skip]
fn each_gap_leads_to_the_next_one() {
    let rows: Vec<Row> = [1.0_f64, 1.3, 1.69, 2.197].map(|slower| {
        let [v, a, j] = [1, 2, 3].map(|order| slower.powi(-order));
        [50.0 * v, -50.0 * v, 100.0 * a, -a, 1e4 * j, -1e4 * j, 0.0, v, 0.0, 0.49, v, 0.0]
    }).into();
    assert_eq!(apart(0.0, &rows), Ok(()));
    let [alone, all] = [&rows[3..], &rows].map(|rows| {
        let (limits, from, to) = axes(0.0, rows).columns();
        online::together(&limits, &from, &to, 0.0)[0].t
    });
    // The gap of the slowest axis: its moves last up to 0.82 of the times, and from 1.21 on.
    assert!(alone < 0.41 * 2.197 && all > 1.21 * 2.197, "{alone} {all}");
}

test_both_reals!(axes_arrive_together, every_fault_is_seen, phases_follow_each_other);
