//! Does a contour stay within its tolerance of the lines between the given points, in its room, within all limits and its feed?

use oracle::judge::Check;
use oracle::judge::path::contour::{Planned, contour};
use oracle::judge::path::{Chain, Chains, Family, Paths, Planner, check, distance};
use oracle::liba::Original;
use support::prelude::*;

const PATHS: usize = if support::BRIEF { 100 } else { 1_000 };

fn zones<R: Real>(chain: &Chain<R>) -> Vec<Limits<R>> {
    (0..chain.sections()).flat_map(|section| chain.limits(section).to_vec()).collect()
}

fn positions<R: Real>(states: &[State<R>], axes: usize, point: usize) -> Vec<f64> {
    states[point * axes..][..axes].iter().map(|state| state.position.widen()).collect()
}

/// What is wrong with a contour through the points of `given`, if something is.
fn check_contour<R: Original>(
    given: &Chain<R>, planned: &Planned<R>, tolerance: f64, random: &mut Random,
) -> Check<String> {
    let Planned { answer, chain, path, moves, places } = planned;
    let axes = given.axes;
    let (again, found) = path.moves(chain).map_err(|error| format!("no moves: {error:?}"))?;
    let phases = |moves: &[Move<R>]| moves.iter().flat_map(|axis| axis.phases().to_vec()).collect::<Vec<_>>();
    if phases(&again) != phases(moves) || answer.is_ok_and(|answer| answer != found) {
        return Err("the moves are not those of the path".into());
    }
    check(chain, path, found, random)?;
    let farthest = path.states.iter().map(|state| state.position.widen().abs()).fold(0.0, f64::max);
    let rounding = 64.0 * axes as f64 * R::MACHINE_EPSILON.widen() * farthest;
    for (part, places) in places.windows(2).enumerate() {
        let ends = [part, part + 1].map(|point| positions(&given.states, axes, point));
        let ends = [&ends[0][..], &ends[1][..]];
        if positions(&path.states, axes, places[0]) != ends[0] || positions(&path.states, axes, places[1]) != ends[1] {
            return Err(format!("part {part} has other ends"));
        }
        for section in places[0]..places[1] {
            if distance(&positions(&path.states, axes, section), ends) > rounding {
                return Err(format!("point {section} is off its line"));
            }
            let moves = &moves[section * axes..][..axes];
            for k in (0..=200).filter(|_| answer.is_ok()) {
                let t = R::of(f64::from(k) / 200.0) * moves[0].t;
                let now: Vec<_> = moves.iter().map(|axis| axis.position(t).widen()).collect();
                let off = distance(&now, ends);
                if off > tolerance + rounding {
                    return Err(format!("it is {off:e} off the line in section {section}"));
                }
            }
        }
    }
    Ok(())
}

/// Contours of all families: most end within their tolerance, and the others say so and are paths all the same.
fn contours_stay_near<R: Original>() {
    let (mut chains, mut random) = (Chains::new(31), Random::seeded(31));
    let (mut bad, mut near, mut added) = (Vec::new(), 0, 0);
    for k in 0..PATHS {
        let chain = chains.draw::<R>();
        let lines = (0..chain.sections()).map(|section| {
            let [from, to] = [section, section + 1].map(|point| positions(&chain.states, chain.axes, point));
            from.iter().zip(&to).map(|(from, to)| (to - from) * (to - from)).sum::<f64>().sqrt()
        });
        let tolerance = R::of((random.magnitude(-2.5, -1.0) * lines.fold(0.0, f64::max)).max(1e-3)).widen();
        let planned = contour(&chain, tolerance, 5 * chain.sections() + 20, 16);
        let deviation = path_deviation(&planned.moves, chain.axes).widen();
        let what = match planned.answer {
            Ok(_) => {
                (near, added) = (near + 1, added + planned.chain.sections() - chain.sections());
                (deviation > tolerance).then(|| format!("its deviation is {deviation:e}"))
            }
            Err(Error::Position) => (deviation < 0.99 * tolerance).then(|| format!("{deviation:e} is near enough")),
            Err(error) => Some(format!("{error:?}")),
        };
        let what = what.or_else(|| check_contour(&chain, &planned, tolerance, &mut random).err());
        bad.extend(what.map(|what| format!("{k} {:?}: {what}, within {tolerance:e}", chain.family)));
    }
    assert!(bad.is_empty() && 2 * near > PATHS && added > PATHS, "{near} {added} {bad:#?}");
}

/// A room that is one section too small leaves the path of the round before, and one that is just large enough the whole.
fn the_room_counts<R: Original>() {
    let (mut chains, mut random) = (Chains::new(32), Random::seeded(32));
    for k in 0..PATHS / 20 {
        let chain = chains.of::<R>(Family::AtRest);
        let whole = contour(&chain, 0.05, 200, 16);
        assert!(whole.answer.is_ok(), "{k}: {:?}", whole.answer);
        let sections = whole.chain.sections();
        let just = contour(&chain, 0.05, sections, 16);
        assert!(just.answer == whole.answer && just.moves == whole.moves, "{k}");
        if sections > chain.sections() {
            let short = contour(&chain, 0.05, sections - 1, 16);
            assert_eq!(short.answer, Err(Error::Position), "{k}");
            assert!(short.chain.sections() < sections && path_deviation(&short.moves, chain.axes).widen() > 0.049);
            assert_eq!(check_contour(&chain, &short, 0.05, &mut random), Ok(()), "{k}");
        }
    }
}

fn use_of_feed<R: Real>(moves: &[Move<R>], feed: f64) -> f64 {
    let speed = |k: u32| {
        let t = R::of(f64::from(k) / 200.0) * moves[0].t;
        moves.iter().map(|axis| axis.velocity(t).widen().powi(2)).sum::<f64>().sqrt() / feed
    };
    (0..=200).map(speed).fold(0.0, f64::max)
}

/// Paths through points, paths through zones and contours keep a feed of their own in each section.
fn feeds_are_kept<R: Original>() {
    let (mut chains, mut random) = (Chains::new(33), Random::seeded(33));
    let (mut used, mut count) = (0.0, 0);
    for k in 0..PATHS / 2 {
        let family =
            random.pick(&[Family::AtRest, Family::UnequalLimits, Family::Zones, Family::Dense, Family::Staying]);
        let mut chain = chains.of::<R>(family);
        for state in &mut chain.states {
            *state = State::at(state.position);
        }
        let axes = chain.axes;
        let feeds: Vec<R> = (0..chain.sections()).map(|_| R::of(random.magnitude(-1.5, 1.0))).collect();
        let before = zones(&chain);
        chain.limits = before.clone();
        limit_feed(&mut chain.limits, &chain.states, &feeds, axes).expect("limits");
        assert!(before.iter().zip(&chain.limits).all(|(old, new)| new.vmax <= old.vmax && new.vmin >= old.vmin));
        let most = 1.0 + 64.0 * R::MACHINE_EPSILON.widen();
        let mut judge = |moves: &[Move<R>], places: &[usize]| {
            for (part, ends) in places.windows(2).enumerate() {
                for section in ends[0]..ends[1] {
                    let part = use_of_feed(&moves[section * axes..][..axes], feeds[part].widen());
                    assert!(part <= most, "{k} {family:?}, section {section}: {part}");
                    (used, count) = (f64::max(used, part), count + 1);
                }
            }
        };
        let each: Vec<_> = (0..=chain.sections()).collect();
        let tolerances = vec![R::of(0.125); axes * (chain.sections() - 1)];
        for planned in [Paths.plan(&chain, 0), Paths.plan_near(&chain, &tolerances, 0)] {
            let (moves, _) = planned.expect("a path").0.moves(&chain).expect("moves");
            judge(&moves, &each);
        }
        let planned = contour(&chain, 0.05, 5 * chain.sections() + 40, 16);
        judge(&planned.moves, &planned.places);
    }
    println!("{}: {count} sections use {used:.4} of their feeds at most", R::NAME);
    assert!(used > 0.99);
}

/// A long line is followed at its feed, but for a 32nd.
fn a_line_has_its_feed<R: Original>() {
    let mut random = Random::seeded(34);
    for axes in 1..=6 {
        let limits = vec![online::symmetric(1e4, 1e3, 100.0); axes];
        let mut chain = Chain::at_rest(limits, (0..2 * axes).map(|_| random.between(-50.0, 50.0)));
        limit_feed(&mut chain.limits, &chain.states, &[R::of(2.0)], axes).expect("limits");
        let (path, _) = Paths.plan(&chain, 0).expect("a path");
        let [from, to] = [0, 1].map(|point| positions(&chain.states, axes, point));
        let length = from.iter().zip(&to).map(|(from, to)| (to - from) * (to - from)).sum::<f64>().sqrt();
        let part = length / (2.0 * path.duration());
        assert!(length < 10.0 || (0.95..=1.0).contains(&part), "{axes} axes: {part}");
    }
}

test_both_reals!(contours_stay_near, the_room_counts, feeds_are_kept, a_line_has_its_feed);
