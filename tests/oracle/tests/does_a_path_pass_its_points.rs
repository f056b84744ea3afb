//! Does a path pass its waypoints within all limits, in the promised durations, and never later than with stops, in 2,000 paths per real type?

use oracle::judge::path::faults::Fault;
use oracle::judge::path::{
    Chain, Chains, Family, Path, Paths, Planner, check_near, judge, judge_near, promised, stopping,
};
use oracle::liba::Original;
use std::collections::BTreeMap;
use support::online::state_of;
use support::prelude::*;

const PATHS: usize = if support::BRIEF { 200 } else { 2_000 };

fn paths_pass_their_points<R: Original>() {
    let (mut chains, mut random) = (Chains::new(0), Random::seeded(0));
    let mut parts: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
    let mut bad = Vec::new();
    for k in 0..PATHS {
        let chain = chains.draw::<R>();
        match judge(&Paths, &chain, &mut random) {
            Ok(part) => parts.entry(chain.family as usize).or_default().push(part),
            Err(what) => bad.push(format!("{k} {:?}: {what}", chain.family)),
        }
    }
    for (family, parts) in &parts {
        let mean = parts.iter().sum::<f64>() / parts.len() as f64;
        println!("{:>14?} {:>5} paths, mean {mean:.3} of the path with stops", Family::ALL[*family], parts.len());
    }
    assert!(bad.is_empty(), "{bad:#?}");
}

/// Any limits may be infinite that leave both accelerations or a jerk finite, in paths of 1 to 20 sections.
fn infinite_limits_are_planned<R: Original>() {
    let mut random = Random::seeded(15);
    let endless = f64::INFINITY;
    for mask in 0..64 {
        let is_endless = |limit: usize| mask >> limit & 1 == 1;
        if (is_endless(4) && is_endless(5)) && (is_endless(2) || is_endless(3)) {
            continue;
        }
        for sections in 1..=20 {
            let axes = 1 + random.below(2);
            let mut limit = |index: usize, [low, high]: [f64; 2]| {
                let limit = if is_endless(index) { endless } else { random.magnitude(low, high) };
                R::of(if index.is_multiple_of(2) { limit } else { -limit })
            };
            let mut of_axis = || {
                let [v, a, j] = [[-0.5, 0.5], [0.0, 1.0], [0.5, 2.0]];
                let [vmax, vmin, amax] = [limit(0, v), limit(1, v), limit(2, a)];
                let [amin, jmax, jmin] = [limit(3, a), limit(4, j), limit(5, j)];
                Limits { vmax, vmin, amax, amin, jmax, jmin }
            };
            let limits = (0..axes).map(|_| of_axis()).collect();
            let chain = Chain::at_rest(limits, (0..axes * (sections + 1)).map(|_| random.between(-1.0, 1.0)));
            let judged = judge(&Paths, &chain, &mut Random::seeded(mask as u64));
            assert!(judged.is_ok(), "{mask:06b}: {judged:?} {chain:?}");
        }
    }
}

/// Paths of 1,000 sections. Their memory grows with the sections, not with their square.
fn long_paths_are_planned<R: Original>() {
    let mut random = Random::seeded(16);
    for axes in [1, 2, 3] {
        let size = |sections| path_size(axes, sections).expect("a size");
        assert_eq!(size(65_536) - size(65_535), size(2) - size(1));
        let limits = vec![online::symmetric::<R>(30.0, 10.0, 2.0); axes];
        let chain = Chain::at_rest(limits, (0..axes * 1_001).map(|_| random.between(-1.0, 1.0)));
        let part = judge(&Paths, &chain, &mut random).expect("a path");
        assert!(part < 0.95, "{axes} axes: {part}");
    }
}

fn bits<R: Real>(path: &Path<R>) -> Vec<u64> {
    let states = path.states.iter().flat_map(|s| [s.position, s.velocity, s.acceleration]);
    let numbers = states.chain(path.durations.iter().copied());
    // 0 has no direction.
    numbers.map(|x| (x + R::ZERO).low_bits()).collect()
}

fn tolerances<R: Real>(chain: &Chain<R>, random: &mut Random) -> Vec<R> {
    let count = chain.axes * (chain.sections() - 1);
    (0..count).map(|_| R::of(if random.one_in(3) { 0.0 } else { random.magnitude(-4.0, 0.0) })).collect()
}

/// Paths through zones stay within them and within the limits, and are never longer than the paths through the points.
fn zones_are_kept<R: Original>() {
    let (mut chains, mut random) = (Chains::new(2), Random::seeded(2));
    let (mut bad, mut parts, mut unseen) = (Vec::new(), 0.0, 0);
    for k in 0..PATHS / 2 {
        let chain = chains.draw::<R>();
        let tolerances = tolerances(&chain, &mut random);
        match judge_near(&chain, &tolerances, &mut random) {
            Ok(part) => parts += part,
            Err(what) => bad.push(format!("{k} {:?}: {what}", chain.family)),
        }
        // Zones that are half as wide again: most paths leave the given ones.
        let wider: Vec<_> = tolerances.iter().map(|&r| R::of(1.5) * r).collect();
        let (path, found) = Paths.plan_near(&chain, &wider, 0).expect("a plan");
        let leaves = check_near(&chain, &tolerances, &path, found, &mut random).is_err();
        unseen += usize::from(!leaves && wider.iter().any(|r| r.widen() > 0.0));
    }
    let mean = parts / (PATHS / 2) as f64;
    println!("{}: {mean:.3} of the path through the points, {unseen} wider zones unseen", R::NAME);
    assert!(bad.is_empty() && unseen < PATHS / 6, "{bad:#?}");
}

fn units_change_no_bit<R: Original>() {
    let (mut chains, mut random) = (Chains::new(1), Random::seeded(1));
    for k in 0..PATHS / 4 {
        let chain = chains.draw::<R>();
        let near = k % 2 == 1;
        let tolerances = tolerances(&chain, &mut random);
        let plan_scaled = |chain: &Chain<R>, length: f64| {
            let tolerances: Vec<_> = tolerances.iter().map(|&r| R::of(length) * r).collect();
            let plan = if near { Paths.plan_near(chain, &tolerances, 0) } else { Paths.plan(chain, 0) };
            plan.expect("a plan").0
        };
        let plan = |chain: &Chain<R>| plan_scaled(chain, 1.0);
        let path = plan(&chain);
        for first in 0..chain.axes.min(2) {
            let other = plan(&chain.mirrored(first));
            let back = Chain { states: other.states, ..chain.clone() }.mirrored(first);
            let back = Path { states: back.states, durations: other.durations };
            assert!(bits(&path) == bits(&back), "{k} {:?}: mirrored from {first} on", chain.family);
        }
        for (length, time) in [(8.0, 1.0), (1.0, 0.25), (0.5, 2.0)] {
            let other = plan_scaled(&chain.scaled(length, time), length);
            let scaled = Chain { states: other.states, ..chain.clone() }.scaled(1.0 / length, 1.0 / time);
            let durations = other.durations.iter().map(|&t| t * R::of(1.0 / time)).collect();
            let back = Path { states: scaled.states, durations };
            assert!(bits(&path) == bits(&back), "{k} {:?}: {length} {time}", chain.family);
        }
    }
}

/// One axis moves and comes back to where it starts, the other one cannot stop before its waypoint: to both sides alike.
fn there_and_back<R: Original>() {
    let start = [[0.0, 0.05, -1.0], [0.0, 5.0, 0.0]];
    let behind = [[0.0; 3], [0.5, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
    let chain = Chain {
        family: Family::InMotion,
        axes: 2,
        limits: vec![online::symmetric::<R>(30.0, 10.0, 5.0); 2],
        states: start.into_iter().chain(behind).map(state_of).collect(),
    };
    to_both_sides_alike(&chain);
}

/// An axis cannot stop before its waypoints, and another one hardly gets to its own in time.
fn hardly_in_time<R: Original>() {
    let mut random = Random::seeded(7);
    for _ in 0..200 {
        let [jerk, acceleration, velocity] = [(); 3].map(|()| random.magnitude(-1.0, 1.0));
        let limits = online::symmetric(jerk, acceleration, velocity);
        let start = State { velocity: R::of(velocity * random.between(0.5, 1.0)), ..State::at(R::ZERO) };
        let axis = online::stop(&limits, start);
        let stop = axis.state_at(axis.t).position.widen();
        let (place, slower) = (random.between(0.1, 0.9), random.magnitude(-1.0, 0.0));
        let ways = [[0.0; 2], [place, slower * place], [2.0, slower], [3.0, 0.0]];
        let mut states: Vec<_> = ways.iter().flatten().map(|&part| State::at(R::of(part * stop))).collect();
        states[0] = start;
        to_both_sides_alike(&Chain { family: Family::InMotion, axes: 2, limits: vec![limits; 2], states });
    }
}

/// All axes mirrored, and the second one alone: the durations stay.
fn to_both_sides_alike<R: Original>(chain: &Chain<R>) {
    let durations = |chain: &Chain<R>| Paths.plan(chain, 0).expect("a plan").0.durations;
    for first in [0, 1] {
        assert_eq!(durations(chain), durations(&chain.mirrored(first)), "{chain:?}");
    }
}

fn with_a_copy<R: Real>(chain: &Chain<R>, point: usize) -> Chain<R> {
    let mut longer = chain.clone();
    let place = point * chain.axes;
    longer.states.splice(place..place, chain.states[place..place + chain.axes].to_vec());
    longer
}

/// A section in which no axis moves takes no time, and the other sections take the same time as without it.
fn repeated_points_take_no_time<R: Original>() {
    let mut chains = Chains::new(11);
    for _ in 0..100 {
        let chain = chains.of::<R>(Family::AtRest);
        let durations = |chain: &Chain<R>| Paths.plan(chain, 0).expect("a plan").0.durations;
        let plain = durations(&chain);
        for point in 0..chain.states.len() / chain.axes {
            let mut durations = durations(&with_a_copy(&chain, point));
            let of_copy = durations.remove(point.min(plain.len()));
            assert_eq!((of_copy, durations), (R::ZERO, plain.clone()), "{point}");
        }
    }
}

fn every_fault_is_seen<R: Original>() {
    for fault in Fault::ALL {
        let (mut chains, mut random) = (Chains::new(0), Random::seeded(0));
        let seen = (0..180).filter(|_| judge(&fault, &chains.draw::<R>(), &mut random).is_err()).count();
        // One family has limits for every section, and one starts outside.
        let few = if matches!(fault, Fault::NoZones | Fault::Silent) { 5 } else { 18 };
        assert!(seen >= few, "{fault:?} in {}: {seen} of 180", R::NAME);
    }
}

/// Two or three sections of one axis or two, whose numbers have any size up to 10 to the power of `most`.
fn of_size<R: Real>(random: &mut Random, most: f64) -> Chain<R> {
    let (axes, points) = (1 + random.below(2), 3 + random.below(2));
    let number = |random: &mut Random| R::of(random.sign() * random.magnitude(-most, most));
    let limit = |random: &mut Random, one_endless_in| {
        let limit = R::of(random.magnitude(-most, most));
        if random.one_in(one_endless_in) { R::INFINITY } else { limit }
    };
    let limits = (0..axes).map(|_| {
        let acceleration = R::of(random.magnitude(-most, most));
        Limits::symmetric(limit(random, 10), acceleration, limit(random, 5))
    });
    let limits = limits.collect();
    let mut states: Vec<_> = (0..axes * points).map(|_| State::at(number(random))).collect();
    for start in &mut states[..axes] {
        if random.one_in(2) {
            (start.velocity, start.acceleration) = (number(random), number(random));
        }
    }
    Chain { family: Family::InMotion, axes, limits, states }
}

/// How many paths are refused, and how many sections have motions that are. Every other section takes the promised time.
fn refused<R: Original>(most: f64) -> [usize; 2] {
    let mut random = Random::seeded(0);
    let (mut paths, mut sections) = (0, 0);
    for k in 0..10 * PATHS {
        let chain = of_size::<R>(&mut random, most);
        let planned = Paths.plan(&chain, 0);
        let Ok((path, _)) = planned else {
            assert_eq!(planned.err(), Some(Error::NotFinite), "{k}");
            paths += 1;
            continue;
        };
        for (section, &t) in path.durations.iter().enumerate() {
            let [from, to] = [section, section + 1].map(|point| &path.states[point * chain.axes..][..chain.axes]);
            let mut moves = vec![Move::default(); chain.axes];
            match synchronise(&mut moves, &chain.limits, from, to, t, R::ZERO) {
                Ok(_) => {
                    let off = moves[0].t.widen() / t.widen() - 1.0;
                    assert!(off.abs() <= promised::<R>(), "{k}: {off}");
                }
                Err(error) => {
                    assert_eq!(error, Error::NotFinite, "{k}");
                    sections += 1;
                }
            }
        }
        let part = path.duration() / stopping(&chain);
        let roundings = 64.0 * R::MACHINE_EPSILON.widen();
        assert!(part <= 1.0 + roundings, "{k}: {part}");
    }
    println!("{}, 1e{most:.0}: {paths} paths refused, {sections} sections", R::NAME);
    [paths, sections]
}

/// Paths are refused near the borders of the range only.
fn of_any_size<R: Original>() {
    let most = 0.02 * f64::from(R::EXPONENTS.1);
    assert_eq!(refused::<R>(most), [0; 2]);
    let [paths, sections] = refused::<R>(5.0 * most);
    assert!(paths < 5 * PATHS && sections < 2 * PATHS);
}

test_both_reals!(
    paths_pass_their_points, zones_are_kept, infinite_limits_are_planned, long_paths_are_planned, units_change_no_bit,
    repeated_points_take_no_time, every_fault_is_seen, of_any_size, there_and_back, hardly_in_time
);
