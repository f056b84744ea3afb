//! Are the motions of a path those of its sections, and is the bound of their deviation from the straight lines right and close?

use oracle::judge::path::{Chain, Chains, Path, Paths, Planner, distance};
use support::prelude::*;

const PATHS: usize = if support::BRIEF { 100 } else { 1_000 };

fn moves_of<R: Real>(chain: &Chain<R>, path: &Path<R>) -> (Result<atraj::Findings, Error>, Vec<Move<R>>) {
    let mut moves = vec![Move::default(); chain.axes * chain.sections()];
    (path_moves(&mut moves, &chain.limits, &path.states, &path.durations, chain.axes), moves)
}

fn bits<R: Real>(moves: &[Move<R>]) -> Vec<u64> {
    let of_phase = |phase: &Phase<R>| online::numbers_of_phase(phase).map(R::low_bits);
    let of_move = |axis: &Move<R>| {
        let phases = axis.phases().len();
        std::iter::once(axis.t.low_bits()).chain(axis.phase[..=phases].iter().flat_map(of_phase)).collect::<Vec<_>>()
    };
    moves.iter().flat_map(of_move).collect()
}

/// Each section is the one that is planned alone, and begins with the states in which the section before ends.
fn sections_are_those_planned_by_hand<R: Real>() {
    let mut chains = Chains::new(21);
    for k in 0..PATHS {
        let chain = chains.draw::<R>();
        let Ok((path, _)) = Paths.plan(&chain, 0) else { continue };
        let (made, moves) = moves_of(&chain, &path);
        let mut found = atraj::Findings::default();
        let mut by_hand = vec![Move::default(); chain.axes];
        for (section, moves) in moves.chunks_exact(chain.axes).enumerate() {
            let [from, to] = [section, section + 1].map(|point| &path.states[point * chain.axes..][..chain.axes]);
            let limits = chain.limits(section);
            found |= synchronise(&mut by_hand, limits, from, to, path.durations[section], R::ZERO).expect("moves");
            let what = format!("{k} {:?}, section {section}", chain.family);
            assert_eq!(bits(moves), bits(&by_hand), "{what}");
            let starts = moves.iter().map(|axis| axis.state_at(R::ZERO));
            let ends = moves.iter().map(|axis| axis.state_at(axis.t));
            assert!(starts.eq(from.iter().copied()) || path.durations[section] == R::ZERO, "{what}");
            assert!(ends.eq(to.iter().copied()), "{what}");
        }
        assert_eq!(made, Ok(found));
    }
}

fn wrong_durations_are_refused<R: Real>() {
    let mut chains = Chains::new(22);
    let mut refused = 0;
    for k in 0..PATHS {
        let chain = chains.draw::<R>();
        let Ok((mut path, _)) = Paths.plan(&chain, 0) else { continue };
        let section = k % chain.sections();
        let planned = path.durations[section];
        path.durations[section] = planned * R::of(0.9);
        let (made, moves) = moves_of(&chain, &path);
        let lasts = moves[section * chain.axes].t.widen();
        let part = (lasts - path.durations[section].widen()) / path.duration() / R::MACHINE_EPSILON.widen().sqrt();
        if made.is_ok() {
            assert!(part < 1.01, "{k} {:?}: {part}", chain.family); // its axes can be faster, or nobody could tell
            continue;
        }
        let written = moves.iter().take_while(|axis| **axis != Move::default()).count();
        let what = (made, written);
        let is_told = what == (Err(Error::Duration), (section + 1) * chain.axes);
        assert!(part > 0.99 && is_told, "{k} {:?}: {part} {what:?}", chain.family);
        refused += 1;
    }
    assert!(2 * refused > PATHS, "{refused} of {PATHS}");
}

/// Durations that are a little too short: a path whose motions can be planned does not get longer. A third of them did.
fn late_sections_stay<R: Real>() {
    let (mut chains, mut random, mut longer, mut asked) = (Chains::new(25), Random::seeded(25), 0, 0);
    for _ in 0..PATHS {
        let chain = chains.draw::<R>();
        let Ok((mut path, _)) = Paths.plan(&chain, 0) else { continue };
        path.durations.iter_mut().for_each(|t| *t = *t * R::of(1.0 - random.magnitude(-15.0, -3.0)));
        if moves_of(&chain, &path).0.is_ok() {
            let before = path.duration();
            Paths.improve(&chain, &mut path, 0).expect("a plan");
            longer += usize::from(path.duration() > before * (1.0 + 16.0 * R::MACHINE_EPSILON.widen()));
            asked += 1;
        }
    }
    let most = if size_of::<R>() == 8 { 0 } else { asked / 100 };
    assert!(longer <= most && 4 * asked > PATHS, "{}: {longer} of {asked} of {PATHS}", R::NAME);
}

/// How far the axes are from the straight line of their section.
fn off_line<R: Real>(moves: &[Move<R>], x: f64) -> f64 {
    let at = |x: &dyn Fn(&Move<R>) -> R| moves.iter().map(|axis| axis.position(x(axis)).widen()).collect::<Vec<_>>();
    distance(&at(&|_| R::of(x)), [&at(&|_| R::ZERO), &at(&|axis| axis.t)])
}

/// The greatest distance of a section, unit: from samples, and steps uphill from the best of them.
fn farthest<R: Real>(section: &[Move<R>]) -> f64 {
    let t = section[0].t.widen();
    let grid = (0..=1_000).map(|k| [t * f64::from(k) / 1e3, t / 1e3]);
    // An axis that turns next to a border may do so in a short time.
    let near = (0..45).flat_map(|k| [-1.0, 1.0].map(|sign| sign * t * f64::exp2(-f64::from(k))));
    let borders = section.iter().flat_map(|axis| axis.phases().iter().map(|phase| phase.start.widen()));
    let mut borders: Vec<_> = borders.chain([t]).collect();
    borders.sort_by(f64::total_cmp);
    let within = borders.windows(2).flat_map(|piece| {
        let part = (piece[1] - piece[0]) / 32.0;
        (1..32).map(move |k| [piece[0] + part * f64::from(k), part])
    });
    let near = borders.iter().flat_map(|x| near.clone().map(move |more| [x + more, more / 2.0]));
    let clamped = grid.chain(within).chain(near).map(|[x, step]| [x.clamp(0.0, t), step]);
    let samples = clamped.map(|[x, step]| (off_line(section, x), x, step));
    let (mut most, mut x, mut step) = samples.max_by(|one, other| one.0.total_cmp(&other.0)).expect("a sample");
    for _ in 0..40 {
        let tried = [x - step, x + step].map(|x| x.clamp(0.0, t)).map(|x| (off_line(section, x), x));
        match tried.into_iter().find(|(distance, _)| *distance > most) {
            Some(farther) => (most, x) = farther,
            None => step /= 2.0,
        }
    }
    most
}

/// The greatest distance of all sections, and what positions have for rounding errors, unit.
fn sampled<R: Real>(moves: &[Move<R>], axes: usize) -> [f64; 2] {
    let (mut most, mut size): (f64, f64) = (0.0, 0.0);
    for section in moves.chunks_exact(axes) {
        most = most.max(farthest(section));
        let sizes = section.iter().map(|axis| {
            let [position, velocity, _] = online::largest(axis.extremes());
            position + velocity * axis.t.widen()
        });
        size = size.max(sizes.sum());
    }
    [most, 64.0 * R::MACHINE_EPSILON.widen() * size]
}

/// The bound is not below the samples, and not above them by more than 1 %.
fn deviations_are_bounded_closely<R: Real>() {
    let mut chains = Chains::new(23);
    let (mut close, mut least, mut greatest): (usize, f64, f64) = (0, f64::INFINITY, 0.0);
    for k in 0..PATHS {
        let chain = chains.draw::<R>();
        let Ok((path, _)) = Paths.plan(&chain, 0) else { continue };
        let (made, moves) = moves_of(&chain, &path);
        assert!(made.is_ok());
        let bound = path_deviation(&moves, chain.axes).widen();
        let [most, rounding] = sampled(&moves, chain.axes);
        let what = format!("{k} {:?}: {bound:e} next to {most:e}, roundings {rounding:e}", chain.family);
        assert!(bound >= most - rounding && bound <= 1.01 * most + rounding, "{what}");
        if most > 1e2 * rounding {
            (close, least, greatest) = (close + 1, least.min(bound / most), greatest.max(bound / most));
        }
    }
    println!("{}: {close} paths, bound over samples {least:.6} to {greatest:.6}", R::NAME);
    assert!(2 * close > PATHS / 2);
}

fn a_straight_line_is_kept<R: Real>() {
    let mut random = Random::seeded(24);
    for axes in 1..=6 {
        for _ in 0..50 {
            let limits = vec![online::symmetric(30.0, 10.0, 5.0); axes];
            let [from, to] =
                [(); 2].map(|()| (0..axes).map(|_| State::at(R::of(random.between(-1.0, 1.0)))).collect::<Vec<_>>());
            let bound = path_deviation(&online::straight(&limits, &from, &to), axes).widen();
            assert!(bound <= 16.0 * R::MACHINE_EPSILON.widen() * axes as f64, "{axes} axes: {bound:e}");
        }
    }
}

test_both_reals!(
    sections_are_those_planned_by_hand, wrong_durations_are_refused, late_sections_stay,
    deviations_are_bounded_closely, a_straight_line_is_kept
);
