//! Is a path nearly the shortest: next to rsruckig's, to long runs from random starts, to moves, and after improvements?

use oracle::judge::path::{Chain, Chains, Family, Path, Paths, Planner, check, example_of_ruckig, under_way, windows};
use oracle::judge::rivals::{path_fits_ruckig, ruckig_path};
use oracle::liba::Original;
use support::online::{limits_of, state_of};
use support::prelude::*;

fn duration<R: Real>(chain: &Chain<R>, steps: u32) -> f64 {
    Paths.plan(chain, steps).expect("a plan").0.duration()
}

/// Ruckig's own plan takes 7.832 s, by the picture next to the example.
#[test]
fn compared_with_the_example_of_ruckig() {
    let theirs = ruckig_path(&example_of_ruckig::<f64>());
    let ours = [duration(&example_of_ruckig::<f64>(), 0), duration(&example_of_ruckig::<f32>(), 0)];
    println!("{ours:.4?} s, rsruckig {theirs:.4?}");
    assert!(ours.iter().all(|&duration| duration < 7.74 && duration > 7.73));
    assert!(theirs.is_some_and(|theirs| theirs > 8.0));
}

const ASKED: usize = 200; // how many paths rsruckig is asked: it takes about 10 ms for one

#[test]
fn compared_with_rsruckig() {
    let mut chains = Chains::new(2);
    let (mut asked, mut refused, mut shorter) = (0, 0, 0);
    let (mut most, mut least, mut sum) = (0.0, f64::INFINITY, 0.0);
    while asked < ASKED {
        let chain = chains.draw::<f64>();
        if !path_fits_ruckig(&chain) || chain.sections() > 6 || chain.sections() < 2 {
            continue;
        }
        asked += 1;
        let Some(theirs) = ruckig_path(&chain) else {
            refused += 1;
            continue;
        };
        let part = theirs / duration(&chain, 0);
        shorter += usize::from(part < 1.0);
        (most, least, sum) = (f64::max(most, part), f64::min(least, part), sum + part);
    }
    let mean = sum / (asked - refused) as f64;
    println!(
        "{asked} paths: rsruckig refuses {refused}, is shorter in {shorter}, and takes {mean:.4} times as long: {least:.6} to {most:.3}"
    );
    // Ours ends a little above the shortest path, where the weight of the logarithms ends.
    assert!(least > 1.0 - 5e-4 && mean > 1.01);
}

fn random_path<R: Real>(chain: &Chain<R>, planned: &Path<R>, random: &mut Random) -> Path<R> {
    let mut path = planned.clone();
    let slow = random.magnitude(0.0, 1.0);
    path.durations.iter_mut().for_each(|t| *t = *t * R::of(slow));
    for (k, state) in path.states[chain.axes..chain.sections() * chain.axes].iter_mut().enumerate() {
        let Limits { vmax, amax, .. } = chain.limits[k % chain.axes];
        state.velocity = vmax * R::of(random.between(-1.0, 1.0) / slow);
        state.acceleration = amax * R::of(random.between(-1.0, 1.0) / (slow * slow));
    }
    path
}

/// The families whose best paths long runs find.
const SAMPLED: [Family; 8] = {
    use Family::*;
    [AtRest, OnePoint, UnequalLimits, InMotion, OnTheLimits, Zones, ToAndFro, UnlikeAxes]
};

fn mean_and_worst(parts: &[f64]) -> [f64; 2] {
    [parts.iter().sum::<f64>() / parts.len() as f64, parts.iter().copied().fold(0.0, f64::max)]
}

/// Prints the number, the mean and the worst of these parts, and asserts that they are below `most`.
#[track_caller]
fn assert_parts(what: &str, parts: &[f64], most: [f64; 2]) {
    let [mean, worst] = mean_and_worst(parts);
    println!("{} {what}: mean {mean:.6}, worst {worst:.6}", parts.len());
    assert!(mean < most[0] && worst < most[1], "{what}");
}

#[test]
fn compared_with_random_starts() {
    let (mut chains, mut random) = (Chains::new(3), Random::seeded(3));
    let mut parts = Vec::new();
    for k in 0..80 {
        let chain = chains.of::<f64>(SAMPLED[k % SAMPLED.len()]);
        let planned = Paths.plan(&chain, 0).expect("a plan").0;
        let runs = (0..12).map(|_| {
            let mut path = random_path(&chain, &planned, &mut random);
            Paths.improve(&chain, &mut path, 64).expect("a plan");
            path.duration()
        });
        parts.push(planned.duration() / runs.fold(f64::INFINITY, f64::min));
    }
    assert_parts("paths next to the best of 12 random starts", &parts, [1.0001, 1.005]);
}

/// Fresh paths of the same families with 16 steps, over the best of long runs.
#[test]
fn sixteen_steps_are_nearly_enough() {
    let mut chains = Chains::new(400);
    let mut parts: Vec<_> = (0..400)
        .map(|k| {
            let chain = chains.of::<f64>(SAMPLED[k % SAMPLED.len()]);
            let [few, many, most] = [16, 100, 400].map(|steps| duration(&chain, steps));
            few / few.min(many).min(most)
        })
        .collect();
    parts.sort_by(f64::total_cmp);
    println!("99 % of paths with 16 steps take {:.5} of the best", parts[395]);
    assert_parts("paths with 16 steps", &parts, [1.0001, 1.005]);
}

/// Plans of the default number of steps next to plans of many steps, family by family.
fn compared_with_more_steps<R: Original>() {
    let mut chains = Chains::new(5);
    let mut sum = 0.0;
    for family in Family::ALL {
        let part = |chain: Chain<R>| {
            let [default, more, most] = [0, 96, 200].map(|steps| duration(&chain, steps));
            let best = default.min(more).min(most);
            if best == 0.0 { 1.0 } else { default / best }
        };
        let parts: Vec<_> = (0..40).map(|_| part(chains.of(family))).collect();
        let [mean, worst] = mean_and_worst(&parts);
        println!("{} {family:?}: mean {mean:.5}, worst {worst:.4} of the best", R::NAME);
        sum += mean;
    }
    let mean = sum / Family::ALL.len() as f64;
    println!("{}: mean {mean:.5}", R::NAME);
    assert!(mean < 1.003);
}

fn improvements_shorten<R: Original>() {
    let (mut chains, mut random) = (Chains::new(4), Random::seeded(4));
    let mut shorter = 0;
    for k in 0..400 {
        let chain = chains.draw::<R>();
        let (mut path, mut found) = Paths.plan(&chain, 4).expect("a plan");
        for steps in [1, 2, 4, 8] {
            let before = path.duration();
            found = Paths.improve(&chain, &mut path, steps).expect("a plan");
            let (after, what) = (path.duration(), check(&chain, &path, found, &mut random));
            let is_no_longer = after <= before * (1.0 + 4.0 * R::MACHINE_EPSILON.widen());
            assert!(what.is_ok() && is_no_longer, "{k} {:?}: {what:?}, {after} after {before}", chain.family);
            shorter += usize::from(after < before);
        }
        goes_on(chain, path, found, &mut random);
    }
    assert!(shorter > 800, "{shorter} of 1,600");
}

fn goes_on<R: Original>(mut chain: Chain<R>, mut path: Path<R>, found: atraj::Findings, random: &mut Random) {
    let axes = chain.axes;
    let is_at_rest = path.states[chain.sections() * axes..].iter().all(|end| *end == State::at(end.position));
    if chain.limits.len() > axes || !is_at_rest {
        return;
    }
    path.states.drain(..axes);
    path.durations.remove(0);
    for axis in 0..axes {
        let last = path.states[path.states.len() - axes];
        let way = R::of(random.between(-1.0, 1.0));
        path.states.push(State::at(last.position + if axis == 0 { way } else { R::ZERO }));
    }
    path.durations.push(R::ZERO);
    chain.states.clone_from(&path.states);
    let improved = Paths.improve(&chain, &mut path, 4).expect("a plan");
    let what = check(&chain, &path, improved, random);
    assert!(what.is_ok(), "{:?} {found:?}: {what:?}", chain.family);
}

fn after_first<R: Original>(chain: &Chain<R>, path: &Path<R>) -> (Chain<R>, Path<R>) {
    let path = Path { states: path.states[chain.axes..].to_vec(), durations: path.durations[1..].to_vec() };
    (Chain { states: path.states.clone(), ..chain.clone() }, path)
}

/// Improves a path that is followed. It gets no longer, and the motions after the section under way are possible.
fn follow<R: Original>(limits: &[Limits<R>], path: &mut Path<R>, random: &mut Random) -> bool {
    let before = path.duration();
    let axes = limits.len();
    let chain = Chain { family: Family::AtRest, axes, limits: limits.to_vec(), states: path.states.clone() };
    let found = Paths.improve(&chain, path, 8).expect("a plan");
    let after = path.duration();
    assert!(after <= before * (1.0 + 4.0 * R::MACHINE_EPSILON.widen()), "{after} after {before}: {chain:?}");
    let (chain, rest) = after_first(&chain, path);
    let what = check(&chain, &rest, found, random);
    assert!(what.is_ok(), "{what:?}: {chain:?}");
    after < before
}

/// A waypoint is near: the rounding errors of the state are as large as what the section has left.
fn an_update_before_a_waypoint_gets_no_longer<R: Original>() {
    let mut random = Random::seeded(12);
    let (mut updates, mut shorter) = (0, 0);
    for k in 0..120 {
        let axes = [1, 3, 6][k % 3];
        let limits = |random: &mut Random| {
            let [j, a, v] = [(0.5, 2.0), (0.0, 1.0), (-0.5, 0.5)].map(|(lo, hi)| R::of(random.magnitude(lo, hi)));
            let limits = Limits::symmetric(j, a, v);
            let less = [(); 2].map(|()| R::of(random.magnitude(-0.5, 0.0)));
            let unequal = Limits { amin: limits.amin * less[0], jmin: limits.jmin * less[1], ..limits };
            if random.one_in(2) { unequal } else { limits }
        };
        let limits: Vec<_> = (0..axes).map(|_| limits(&mut random)).collect();
        let points = 4 + random.below(4);
        let mut chain = Chain::at_rest(limits, (0..points * axes).map(|_| random.between(-1.0, 1.0)));
        let mut path = Paths.plan(&chain, 0).expect("a plan").0;
        while path.durations.len() > 1 {
            for left in [5e-5, 2e-4, 1e-3, 3e-3, 2e-2] {
                if left < 0.9 * path.durations[0].widen() {
                    let mut rest = under_way(&chain.limits, &path, R::of(left));
                    shorter += usize::from(follow(&chain.limits, &mut rest, &mut random));
                    updates += 1;
                }
            }
            (chain, path) = after_first(&chain, &path);
        }
    }
    println!("{}: {updates} updates before a waypoint, {shorter} shorten the path", R::NAME);
    assert!(updates > 1_500);
}

/// A path under way is improved shortly before its first waypoint, as it is without a copy of its start that has next to no time left.
#[test]
fn a_repeated_start_changes_no_improvement() {
    let mut chains = Chains::new(41);
    for _ in 0..4 {
        let chain = chains.of::<f64>(Family::Many);
        let mut rest = under_way(&chain.limits, &Paths.plan(&chain, 1).expect("a plan").0, 1e-3);
        let (before, mut twice) = (rest.duration(), rest.clone());
        twice.states.splice(..0, rest.states[..chain.axes].to_vec());
        twice.durations.insert(0, f64::MIN_POSITIVE);
        for path in [&mut rest, &mut twice] {
            Paths.improve(&chain, path, 8).expect("a plan");
        }
        assert!(rest.duration() < before && twice.durations[1..] == rest.durations);
    }
}

/// A window over a stream of points, 20 times a second: the path under way gets no longer, and waypoints are passed in motion.
fn a_window_moves_along<R: Original>() {
    let mut random = Random::seeded(13);
    for axes in [1, 2, 3, 6] {
        let limits: Vec<_> = (0..axes).map(|_| online::symmetric(100.0, 5.0, 1.0)).collect();
        let mut point = || (0..axes).map(|_| State::at(R::of(random.between(-0.2, 0.2)))).collect::<Vec<_>>();
        let states = (0..8).flat_map(|_| point()).collect();
        let chain = Chain { family: Family::AtRest, axes, limits: limits.clone(), states };
        let mut stream: Vec<_> = (0..60).map(|_| point()).collect();
        let mut path = Paths.plan(&chain, 0).expect("a plan").0;
        let (mut updates, mut passed, mut judging) = (0, 0, Random::seeded(14));
        while let Some(next) = stream.pop() {
            let sections = path.durations.len();
            path = windows::after(&limits, path, 0.05);
            passed += sections - path.durations.len();
            while path.durations.len() < 7 {
                let last = path.states.len() - axes;
                for (axis, state) in next.iter().enumerate() {
                    path.states.push(State::at(path.states[last + axis].position + state.position));
                }
                path.durations.push(R::ZERO);
                Paths.improve(&Chain { states: path.states.clone(), ..chain.clone() }, &mut path, 1).expect("a plan");
            }
            follow(&limits, &mut path, &mut judging);
            updates += 1;
        }
        assert!(passed > 5, "{axes} axes: {passed} waypoints in {updates} updates");
    }
}

/// A window that lasts several times as long as a stop loses next to nothing, however close the points are. In a short one most sections are new,
/// and it loses more where the points bend.
#[test]
fn a_long_window_loses_little() {
    for (name, row) in windows::rows(400) {
        for (points, most) in [(16, 0.1), (32, 0.01), (128, 0.01)] {
            let loss = windows::through_window(&row, points).0 / windows::whole(&row) - 1.0;
            println!("{name}, {points} points: {:.3} %", 100.0 * loss);
            assert!(loss < most, "{name}");
        }
    }
}

/// An axis that is too fast to stop at its waypoints, and a quick one next to it that moves either way: the path takes as long as the move
/// without waypoints, which passes them. A plan that turns takes far longer.
fn compared_with_the_move<R: Original>() {
    let mut random = Random::seeded(6);
    let mut worst = [1.0; 2];
    for _ in 0..200 {
        let [jerk, acceleration, velocity] = [(); 3].map(|()| random.magnitude(-1.0, 1.0));
        let limits = [1.0, 1e3].map(|more| online::symmetric::<R>(more * jerk, more * acceleration, velocity));
        let speed = random.sign() * velocity * random.between(0.5, 1.0);
        let start = state_of([random.between(-1.0, 1.0), speed, 0.0]);
        let axis = online::stop(&limits[0], start);
        let [p, end] = [start, axis.state_at(axis.t)].map(|state| state.position.widen());
        let stop = end - p;
        let places = [random.between(0.1, 0.4), random.between(0.5, 0.9), random.between(2.0, 8.0)];
        let place_of_other = random.sign() * random.between(1.0, 2.0);
        let mut states = vec![start, State::at(R::of(place_of_other))];
        for (place, side) in places.iter().zip([random.sign(), 0.0, random.sign()]) {
            states.push(State::at(R::of(p + place * stop)));
            states.push(State::at(R::of(place_of_other + 1e-3 * side * stop)));
        }
        let fastest = online::plan(&limits[0], start, states[6]).t.widen();
        let chain = Chain { family: Family::InMotion, axes: 2, limits: limits.into(), states };
        for (worst, steps) in worst.iter_mut().zip([0, 200]) {
            *worst = f64::max(*worst, duration(&chain, steps) / fastest);
        }
    }
    println!("{}: at most {worst:.5?} of the move, by default and with 200 steps", R::NAME);
    let rounding = if size_of::<R>() == 8 { 1e-4 } else { 1e-3 };
    assert!(worst[0] < 1.1 && worst[1] < 1.0 + rounding);
}

/// Rows of one axis whose single move passes the points in order, and what is found in it: over this move.
fn rows_over_the_move(rows: usize, found: Findings) -> Vec<f64> {
    let (mut random, mut parts) = (Random::seeded(9), Vec::new());
    while parts.len() < rows {
        let limits =
            Limits::symmetric(random.magnitude(-1.0, 2.0), random.magnitude(-1.0, 1.0), random.magnitude(-1.0, 1.0));
        let (sections, scale, uneven) =
            (2 + random.below(15), random.magnitude(-1.5, 0.5), random.pick(&[0.0, -1.0, -2.0, -3.0]));
        let mut points = vec![0.0];
        (0..sections).for_each(|k| points.push(points[k] + scale * random.magnitude(uneven, 0.0)));
        let mut speed = || random.pick(&[-1.0, 1.0, 0.0]) * limits.vmax * random.between(0.01, 0.95);
        let (first, last) = (speed(), speed());
        let mut states: Vec<_> = points.iter().copied().map(State::at).collect();
        (states[0].velocity, states[sections].velocity) = (first, last);
        let single = online::plan(&limits, states[0], states[sections]);
        let times: Vec<_> = points[1..sections].iter().filter_map(|point| single.time_at(*point)).collect();
        if times.len() == sections - 1 && times.is_sorted() && single.check(&limits) == Ok(found) {
            let chain = Chain { family: Family::InMotion, axes: 1, limits: vec![limits], states };
            parts.push(duration(&chain, 0) / single.t);
        }
    }
    parts
}

/// The move turns at an end, or comes back to it. A plan that stops before such an end took up to 4.7 times as long.
#[test]
fn ends_that_turn_cost_little() {
    assert_parts(
        "rows with ends that turn, over the move",
        &rows_over_the_move(400, Findings::OVERSHOOTS),
        [1.001, 1.01],
    );
}

/// The move does not turn, so no path is faster. One that turned back took up to 9 times as long.
#[test]
fn a_move_that_passes_the_points_is_the_path() {
    assert_parts("rows ahead, over the move", &rows_over_the_move(4_000, Findings::default()), [1.0002, 1.004]);
}

/// A path is followed a tenth slower than it could be, and planned again at a random time: it takes no longer than what is left. An axis that
/// cannot stop before the next point must not turn and come back.
fn a_path_planned_again_under_way_gets_no_longer<R: Original>() {
    let (mut chains, mut random, mut longer, mut sum) = (Chains::new(40), Random::seeded(40), 0, 0.0);
    let families = [Family::AtRest, Family::Many, Family::UnevenWays, Family::OneDirection, Family::Dense];
    for k in 0..200 {
        let chain = chains.of::<R>(families[k % 5]);
        let mut slow = chain.scaled(1.0, 1.1);
        let mut path = Paths.plan(&slow, 0).expect("a plan").0;
        for _ in 0..random.below(chain.sections()) {
            (slow, path) = after_first(&slow, &path);
        }
        let rest = under_way(&slow.limits, &path, R::of(random.unit()) * path.durations[0]);
        let again = Chain { states: rest.states.clone(), ..chain };
        let (planned, found) = Paths.plan(&again, 0).expect("a plan");
        let what = check(&again, &planned, found, &mut random);
        assert!(what.is_ok(), "{what:?}: {again:?}");
        let part = planned.duration() / rest.duration();
        longer += usize::from(part > 1.0);
        sum += part;
    }
    let mean = sum / 200.0;
    println!("{}: {longer} of 200 get longer, {mean:.4} of what is left in the mean", R::NAME);
    let most = if size_of::<R>() == 8 { 4 } else { 12 };
    assert!(longer <= most && mean < 1.0);
}

/// By default a path of 10 sections gets 48 steps, as `docs/path-theory.md` says, and a shorter one fewer.
#[test]
fn ten_sections_get_all_steps() {
    let mut chains = Chains::new(7);
    let mut fewer = 0;
    for _ in 0..10 {
        let mut chain = chains.of::<f64>(Family::Dense);
        let mut gets_all = |sections: usize| {
            chain.states.truncate((sections + 1) * chain.axes);
            let [default, all] = [0, 48].map(|steps| Paths.plan(&chain, steps).expect("a plan").0);
            default.durations == all.durations
        };
        assert!(gets_all(10));
        fewer += usize::from(!gets_all(9));
    }
    assert!(fewer > 5);
}

/// How long the default plan of one axis through these positions takes, s. It is in motion at both ends.
fn duration_of<R: Original>(limits: [f64; 6], positions: &[f64], [v0, v1]: [f64; 2]) -> f64 {
    let mut chain = Chain::at_rest(vec![limits_of(limits.map(R::of))], positions.iter().copied());
    chain.states[0].velocity = R::of(v0);
    chain.states[positions.len() - 1].velocity = R::of(v1);
    duration(&chain, 0)
}

/// While the weight of the logarithms is large, the plan must stay near the centre: this path ends in 5.6233 s otherwise.
#[test]
fn the_first_falls_wait_for_the_centre() {
    let mut chains = Chains::new(3);
    let chains = (0..276).map(|_| chains.of::<f64>(Family::ToAndFro));
    let duration = duration(&chains.last().expect("a path"), 0);
    assert!(duration < 5.604, "{duration} s");
}

/// A path of `known_paths.csv`: one axis in motion, and what its plan may take, s.
fn assert_short<R: Original>(row: &str) {
    let cells: Vec<_> = row.splitn(14, ',').collect();
    let number = |k: usize| cells[k].parse::<f64>().expect("a number");
    let positions: Vec<f64> = cells[12].split(' ').map(|position| position.parse().expect("a position")).collect();
    let limits = [3, 4, 5, 6, 7, 8].map(|k| R::of(number(k)));
    let mut chain = Chain::at_rest(vec![limits_of(limits)], positions.iter().copied());
    let [start, .., end] = &mut chain.states[..] else { panic!("no section") };
    [start.velocity, start.acceleration, end.velocity] = [9, 10, 11].map(|k| R::of(number(k)));
    let duration = duration(&chain, number(2) as u32);
    assert!(duration < number(0), "{duration} s: {row}");
}

#[test]
fn known_paths_are_short() {
    for row in include_str!("known_paths.csv").lines().skip(1) {
        if row.contains(",f32,") { assert_short::<f32>(row) } else { assert_short::<f64>(row) }
    }
}

/// A path of one limit from rest to rest.
fn between([jerk, acceleration, velocity]: [f64; 3], points: &[Vec<f64>]) -> Chain<f64> {
    let limits = vec![Limits::symmetric(jerk, acceleration, velocity); points[0].len()];
    Chain::at_rest(limits, points.iter().flatten().copied())
}

fn duration_between(limits: [f64; 3], points: &[Vec<f64>]) -> f64 {
    duration(&between(limits, points), 0)
}

/// Points on the way of a move that ends in motion: over the move without points, from rest and from motion. A few of the latter turn back, because a
/// row gets a little less than the limits.
#[test]
fn points_before_an_end_in_motion_cost_little() {
    let mut random = Random::seeded(50);
    for (fastest, most) in [(0.0, 0.0), (2.8, 0.01)] {
        let mut parts = vec![];
        while parts.len() < 300 {
            let positions = places(2 + random.below(4), [-1.0, 0.2], &mut random);
            let ends @ [v0, v1] = [fastest, 2.8].map(|fastest| random.between(0.0, fastest));
            let [start, end] = [(v0, 0.0), (v1, positions[positions.len() - 1])]
                .map(|(velocity, position)| State { velocity, ..State::at(position) });
            let alone = online::plan(&Limits::symmetric(3.0, 2.5, 5.0), start, end);
            if (0..100).all(|k| alone.velocity(0.01 * f64::from(k) * alone.t) >= 0.0) {
                parts.push(duration_of::<f64>([5.0, -5.0, 2.5, -2.5, 3.0, -3.0], &positions, ends) / alone.t);
            }
        }
        let long = parts.iter().filter(|part| **part > 1.001).count() as f64 / parts.len() as f64;
        println!("ends in motion: {long} of {} paths take over 1.001 of the move", parts.len());
        assert!(long <= most);
    }
}

/// Points on a line whose distances differ by factors of 10 and of 100: over the move without points. In binary32 rounding errors close narrow
/// sections, and the more there are, the slower is the path.
#[test]
fn uneven_points_on_a_line_cost_nothing() {
    let mut random = Random::seeded(37);
    let [jerk, acceleration, velocity] = [100.0, 5.0, 1.0];
    let limits = [velocity, -velocity, acceleration, -acceleration, jerk, -jerk];
    for (sections, rows, most_f32) in [(20, 20, 1.005), (40, 20, 1.02), (200, 10, 1.4), (1_000, 3, 1.7)] {
        for factor in [1.0, 2.0] {
            let mut parts = [vec![], vec![]];
            for _ in 0..rows {
                let positions = places(sections, [-4.0, factor - 4.0], &mut random);
                let end = State::at(positions[sections]);
                let alone = online::plan(&Limits::symmetric(jerk, acceleration, velocity), State::at(0.0), end);
                parts[0].push(duration_of::<f64>(limits, &positions, [0.0; 2]) / alone.t);
                parts[1].push(duration_of::<f32>(limits, &positions, [0.0; 2]) / alone.t);
            }
            let [[mean, worst], in_f32] = parts.map(|parts| mean_and_worst(&parts));
            println!(
                "{sections} sections over 1e{factor}: mean {mean:.5}, worst {worst:.5} of the move, {in_f32:.4?} in f32"
            );
            assert!(mean <= 1.001 && worst <= 1.01 && in_f32[0] <= most_f32);
        }
    }
}

/// A path that ends in motion takes as long as the same path back in time, which starts in motion.
#[test]
fn paths_back_in_time_take_as_long() {
    let mut random = Random::seeded(51);
    let mut sums = [0.0; 2];
    for _ in 0..100 {
        let coordinates = [(); 2].map(|()| places(4, [-1.0, 0.1], &mut random));
        let mut points: Vec<_> = (0..5).map(|k| coordinates.iter().map(|places| places[k]).collect()).collect();
        let mut way = between([3.0, 2.5, 5.0], &points);
        points.iter_mut().flatten().for_each(|position| *position = -*position);
        points.reverse();
        let mut back = between([3.0, 2.5, 5.0], &points);
        for axis in 0..2 {
            let velocity = random.between(0.0, 1.5);
            (way.states[8 + axis].velocity, back.states[axis].velocity) = (velocity, velocity);
        }
        for (sum, chain) in sums.iter_mut().zip([way, back]) {
            *sum += duration(&chain, 0);
        }
    }
    let part = sums[0] / sums[1];
    assert!((part - 1.0).abs() < 0.002, "{part} of the paths back in time");
}

/// What a path with corners takes longer to begin in motion, and what to end in motion: both at once are seldom dearer than their sum.
#[test]
fn motion_at_both_ends_costs_little_more_than_at_each() {
    let mut random = Random::seeded(52);
    for (axes, most) in [(1, 0.04), (2, 0.02), (3, 0.01)] {
        let mut dear = 0.0;
        for _ in 0..300 {
            let sections = 3 + random.below(4);
            let mut point = vec![0.0; axes];
            let mut next = || {
                point.iter_mut().for_each(|position| *position += random.between(-0.3, 1.2));
                point.clone()
            };
            let points: Vec<_> = (0..=sections).map(|_| next()).collect();
            let speeds = [(); 2].map(|()| random.between(0.0, 2.0));
            let duration = |speeds: [f64; 2]| {
                let mut chain = between([3.0, 2.5, 5.0], &points);
                for (speed, first, at) in [(speeds[0], 0, 0), (speeds[1], sections - 1, sections)] {
                    let way: Vec<_> = (0..axes).map(|axis| points[first + 1][axis] - points[first][axis]).collect();
                    let length = way.iter().map(|x| x * x).sum::<f64>().sqrt();
                    (0..axes).for_each(|axis| chain.states[at * axes + axis].velocity = speed * way[axis] / length);
                }
                duration(&chain, 0)
            };
            let at_rest = duration([0.0; 2]);
            let [more_at_start, more_at_end, more] =
                [[speeds[0], 0.0], [0.0, speeds[1]], speeds].map(|speeds| duration(speeds) - at_rest);
            dear += f64::from(u8::from(more - (more_at_start + more_at_end) > 0.1 * at_rest)) / 300.0;
        }
        println!("{axes} axes: {dear:.4} of 300 paths take over 10 % more to begin and end in motion");
        assert!(dear <= most);
    }
}

/// Distances over a factor of 300 along lines in several axes: over the move without points.
#[test]
fn uneven_points_on_a_line_in_space_cost_nothing() {
    let mut random = Random::seeded(40);
    let mut parts = vec![];
    for (k, sections) in (0..40).map(|k| 20 + 5 * k).chain([2_000, 8_000]).enumerate() {
        let axes = 2 + k % 3;
        let direction: Vec<_> = (0..axes).map(|_| random.between(-1.0, 1.0)).collect();
        let steepest = direction.iter().copied().map(f64::abs).fold(0.0, f64::max);
        let places = places(sections, [-3.0, -0.5], &mut random);
        let points: Vec<Vec<_>> = places.iter().map(|s| direction.iter().map(|slope| slope * s).collect()).collect();
        let end = State::at(steepest * places[places.len() - 1]);
        let alone = online::plan(&Limits::symmetric(50.0, 10.0, 5.0), State::at(0.0), end);
        parts.push(duration_between([50.0, 10.0, 5.0], &points) / alone.t);
    }
    println!("the dense lines take {:.5?} of the move", &parts[40..]);
    assert_parts("lines in 2 to 4 axes, over the move", &parts, [1.002, 1.025]);
}

/// Places along a line whose distances lie between these powers of ten, m.
fn places(sections: usize, [low, high]: [f64; 2], random: &mut Random) -> Vec<f64> {
    let mut place = 0.0;
    let next = || {
        place += random.magnitude(low, high);
        place
    };
    [0.0].into_iter().chain(std::iter::repeat_with(next).take(sections)).collect()
}

/// Distances over a factor of 300 along lines with corners, parabolas and ellipses: the default plan over one of 1,000 steps, from rest, and in the middle of a path
/// that is followed at 0.8 of the limits. The bars are what is measured, and a little.
#[test]
fn uneven_points_with_bends_cost_little() {
    let shapes: [(_, fn(&mut Random) -> _, _); 3] = [
        ("corners", with_corners, [1.06, 1.0]),
        ("parabolas", parabola, [1.08, 0.95]),
        ("ellipses", ellipse, [1.3, 1.0]),
    ];
    for (name, points_of, most) in shapes {
        let mut random = Random::seeded(41);
        let mut parts = [vec![], vec![]];
        for _ in 0..40 {
            let chain = between([64.0, 6.4, 1.6], &points_of(&mut random));
            parts[0].push(duration(&chain, 0) / duration(&chain, 1_000));
            let mut path = Paths.plan(&chain, 0).expect("a plan").0;
            let passed = 2 * chain.sections() / 5;
            path.states.drain(..2 * passed);
            path.durations.drain(..passed);
            let wide = vec![Limits::symmetric(125.0, 10.0, 2.0); 2];
            let rest = Chain { family: Family::InMotion, axes: 2, limits: wide, states: path.states.clone() };
            Paths.improve(&rest, &mut path, 200).expect("a plan");
            parts[1].push(duration(&rest, 0) / path.duration());
        }
        let [rest, motion] = parts.map(|parts| mean_and_worst(&parts));
        println!("uneven {name}: mean and worst {rest:.4?}, from motion {motion:.4?}");
        assert!(rest[0] <= most[0] && motion[0] <= most[1]);
    }
}

fn with_corners(random: &mut Random) -> Vec<Vec<f64>> {
    let mut corner = [0.0; 2];
    let mut points = vec![corner.to_vec()];
    for _ in 0..4 {
        let direction = [(); 2].map(|()| random.between(-1.0, 1.0));
        let places = places(15, [-3.0, -0.5], random);
        let along = |place: &f64| [0, 1].map(|axis| corner[axis] + direction[axis] * place);
        points.extend(places[1..].iter().map(|place| along(place).to_vec()));
        corner = along(&places[15]);
    }
    points
}

fn parabola(random: &mut Random) -> Vec<Vec<f64>> {
    let slopes = [(); 2].map(|()| random.between(-1.0, 1.0));
    let bends = [(); 2].map(|()| random.between(-0.1, 0.1));
    let point = |s: f64| [0, 1].map(|axis| slopes[axis] * s + bends[axis] * s * s).to_vec();
    places(80, [-3.0, -0.5], random).into_iter().map(point).collect()
}

fn ellipse(random: &mut Random) -> Vec<Vec<f64>> {
    let [wide, high] = [(); 2].map(|()| random.between(0.1, 1.0));
    let places = places(60, [-3.0, -0.5], random);
    let angle = |place: &f64| place / places[60] * std::f64::consts::TAU;
    places.iter().map(|place| vec![wide * angle(place).cos(), high * angle(place).sin()]).collect()
}

/// The densest circle takes as long as the coarsest one, nearly.
#[test]
fn dense_circles_do_not_stall() {
    for points in [64, 512, 2_048, 8_192] {
        let angles = (0..=points).map(|k| f64::from(k) / f64::from(points) * std::f64::consts::TAU);
        let points_of_circle: Vec<_> = angles.map(|angle| vec![0.1 * angle.cos(), 0.1 * angle.sin()]).collect();
        let duration = duration_between([30.0, 10.0, 5.0], &points_of_circle);
        println!("a circle of {points} points: {duration:.5} s");
        assert!(duration <= 1.2905);
    }
}

/// Short sections in which the axis must be slow, between long ones: no longer than the speeds of two passes without acceleration at the points.
#[test]
fn narrow_zones_do_not_stall() {
    let mut random = Random::seeded(38);
    let (mut positions, mut limits) = (vec![0.0], vec![]);
    for k in 0..40 {
        let mut add = |length: f64, velocity| {
            positions.push(positions[positions.len() - 1] + length);
            limits.push(Limits::symmetric(60_000.0, 3_000.0, velocity));
        };
        add(random.between(1.0, 10.0), 100.0);
        if k < 39 {
            add(0.001, random.between(5.0, 45.0));
        }
    }
    let states = positions.iter().map(|&p| State::at(p)).collect();
    let chain = Chain { family: Family::Many, axes: 1, limits, states };
    let [default, long] = [0, 400].map(|steps| duration(&chain, steps));
    println!("40 sections with zones between them: {default:.5} s, {long:.5} with 400 steps");
    assert!(default <= 1.005 * long);
}

/// The sections are so short that the axis gets nowhere near its highest velocities. The first plan knows that: one step is nearly enough.
#[test]
fn short_sections_need_few_steps() {
    let limits = [100.0, 10.0, 100.0].map(|jerk| Limits::symmetric(jerk, 0.5 * jerk, 10.0 * jerk)).into();
    let chain = Chain { family: Family::Zones, axes: 1, limits, states: [0.0, 1.0, 2.0, 3.0].map(State::at).into() };
    let [one, long] = [1, 200].map(|steps| duration(&chain, steps));
    assert!(one < 1.02 * long, "{one} s next to {long} s");
}

/// Long and short sections in turn along lines in several axes, each with a feed of its own: the default plan over one of 1,000 steps.
#[test]
fn feeds_along_lines_in_space_do_not_stall() {
    let mut random = Random::seeded(42);
    let mut parts = vec![];
    for k in 0..24 {
        let (axes, sections) = (2 + k % 2, 20 + 4 * k);
        let direction: Vec<_> = (0..axes).map(|_| random.between(-1.0, 1.0)).collect();
        let (mut place, mut states, mut feeds) = (0.0, vec![State::at(0.0); axes], vec![]);
        for section in 0..sections {
            place += if section % 2 == 0 { random.between(0.01, 0.3) } else { 0.001 };
            states.extend(direction.iter().map(|slope| State::at(slope * place)));
            feeds.push(random.between(0.1, 3.0));
        }
        let mut limits = vec![Limits::symmetric(50.0, 10.0, 5.0); axes * sections];
        limit_feed(&mut limits, &states, &feeds, axes).expect("limits");
        let chain = Chain { family: Family::Many, axes, limits, states };
        let [default, long] = [0, 1_000].map(|steps| duration(&chain, steps));
        parts.push(default / long);
    }
    assert_parts("lines in 2 and 3 axes with a feed for each section", &parts, [1.03, 1.1]);
}

/// How long the default path takes whose points all have this tolerance, compared with the path through them, s.
fn with_tolerance(chain: &Chain<f64>, tolerance: f64) -> [f64; 2] {
    let near = Paths.plan_near(chain, &vec![tolerance; chain.axes * (chain.sections() - 1)], 0).expect("a plan").0;
    [near.duration(), duration(chain, 0)]
}

/// Random points in a cube of side 1: the table of `docs/path.md`. The bars are what is measured, and a little.
#[test]
fn tolerances_save_time() {
    for (axes, most) in [(1, [0.985, 0.953, 0.83]), (3, [0.985, 0.953, 0.83]), (6, [0.985, 0.956, 0.84])] {
        for (tolerance, most) in [0.01, 0.03, 0.1].into_iter().zip(most) {
            let mut random = Random::seeded(39);
            let mut parts = 0.0;
            for _ in 0..20 {
                let mut point = || (0..axes).map(|_| random.between(0.0, 1.0)).collect();
                let points: [Vec<_>; 10] = std::array::from_fn(|_| point());
                let [near, exact] = with_tolerance(&between([60.0, 10.0, 5.0], &points), tolerance);
                parts += near / exact;
            }
            println!("{axes} axes, tolerance {tolerance}: {:.3} of the path through the points", parts / 20.0);
            assert!(parts / 20.0 <= most);
        }
    }
}

/// Flowers of five leaves and close points. Zones of 10 mm overlap, so how long such a path takes differs from flower to flower.
#[test]
fn tolerances_smooth_a_flower() {
    let flower = |points: i32| {
        let point = |k: i32| {
            let angle = f64::from(k) / f64::from(points) * std::f64::consts::TAU;
            let radius = 0.1 + 0.04 * (5.0 * angle).cos();
            vec![radius * angle.cos(), radius * angle.sin()]
        };
        between([30.0, 10.0, 5.0], &(0..=points).map(point).collect::<Vec<_>>())
    };
    for (tolerance, most) in [(0.0, 3.450), (1e-5, 3.4465), (1e-4, 3.4236), (1e-3, 3.3225)] {
        let [near, exact] = with_tolerance(&flower(64), tolerance);
        println!("a flower, tolerance {tolerance}: {near:.4} s, {exact:.4} s through the points");
        assert!(near <= most);
    }
    let [mean, worst] = mean_and_worst(&[56, 60, 64, 68, 72].map(|points| with_tolerance(&flower(points), 1e-2)[0]));
    println!("flowers of 56 to 72 points, tolerance 0.01: {mean:.4} s, at most {worst:.4}");
    assert!(mean <= 2.76);
}

test_both_reals!(
    compared_with_more_steps, improvements_shorten, an_update_before_a_waypoint_gets_no_longer, a_window_moves_along,
    compared_with_the_move, a_path_planned_again_under_way_gets_no_longer
);
