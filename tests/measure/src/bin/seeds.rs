//! `seeds <directory>`: the golden moves as a fuzzer's first corpus, in one subdirectory for each family, and adversarial problems in
//! another, random problems of `Move` in a third, of several axes in a fourth, of waypoints in a fifth, and requests to an axis in a sixth.

use oracle::bytes::{PLANNERS, PLANNERS_OF_AXES, REQUESTS, encode};
use oracle::judge::{Kind, Problems, parts};
use oracle::liba::Original;
use std::io::Result;
use std::path::{Path, PathBuf};
use support::{Family, Random, Real, golden, online};

fn main() -> Result<()> {
    let directory = PathBuf::from(std::env::args_os().nth(1).expect("a directory"));
    write::<f64>(&directory)?;
    write::<f32>(&directory)
}

fn write<R: Original>(directory: &Path) -> Result<()> {
    for family in Family::ALL {
        write_golden::<R>(family, directory)?;
    }
    let problems = Problems::<R>::of_profiles(0).take(6 * Kind::OF_PROFILES.len());
    let problems = problems.map(|problem| encode(&problem.arguments(), &[]));
    write_corpus::<R>(&directory.join("fastest"), "adversarial", problems)?;
    let [mut moves, mut axes, mut paths, mut requests, mut machines] = [0, 1, 2, 3, 3].map(Random::seeded);
    let write = |name, all: &mut dyn Iterator<Item = Vec<u8>>| write_corpus::<R>(&directory.join(name), "random", all);
    write("move", &mut (0..64).map(|case| of_move::<R>(case, &mut moves)))?;
    write("axes", &mut (0..48).map(|case| of_axes::<R>(case, &mut axes)))?;
    write("path", &mut (0..48).map(|case| of_path::<R>(case, &mut paths)))?;
    write("axis", &mut (0..32).map(|_| of_requests::<R>(&mut requests)))?;
    write("machine", &mut (0..48).map(|case| of_machine::<R>(case, &mut machines)))
}

fn write_corpus<R: Real>(directory: &Path, name: &str, cases: impl Iterator<Item = Vec<u8>>) -> Result<()> {
    std::fs::create_dir_all(directory)?;
    for (case, bytes) in cases.enumerate() {
        std::fs::write(directory.join(format!("{name}-{}-{case}", R::NAME)), bytes)?;
    }
    Ok(())
}

/// Requests to an axis: period, start and limits, then a byte for each request and its lead or ticks, and its numbers.
fn of_requests<R: Real>(random: &mut Random) -> Vec<u8> {
    let limits = online::limits::<R>(random);
    let start = online::anywhere(random, &limits);
    let numbers = [&[R::of(0.001)], &parts(start)[..], &online::numbers_of(&limits)];
    let mut bytes = encode(&numbers.concat(), &[]);
    for _ in 0..10 {
        let request = random.below(usize::from(REQUESTS)) as u8;
        let other = online::limits::<R>(random);
        let target = online::inside(random, &limits);
        bytes.push(request + REQUESTS * random.pick(&[0, 1, 2, 5, 40]));
        let numbers = match request {
            0..3 => parts(target).to_vec(),
            3 => [&parts(target)[..], &[R::of(0.1)]].concat(),
            4 => online::numbers_of(&other).to_vec(),
            _ => Vec::new(),
        };
        bytes.extend(&encode(&numbers, &[])[1..]);
    }
    bytes
}

/// The numbers of a problem: its limits, its start and its target.
fn problem<R: Real>(random: &mut Random) -> [Vec<R>; 3] {
    let limits = online::limits(random);
    let [from, to] = [online::anywhere(random, &limits), online::inside(random, &limits)];
    [online::numbers_of(&limits).to_vec(), parts(from).to_vec(), parts(to).to_vec()]
}

/// The numbers as bytes. The first byte holds the kind above the real type.
fn with_kind<R: Real>(numbers: &[R], kind: u8) -> Vec<u8> {
    let mut bytes = encode(numbers, &[]);
    bytes[0] += 2 * kind;
    bytes
}

/// Moves with steps and shapers: the first byte holds the kind of the shaper above the real type.
fn of_machine<R: Real>(case: u8, random: &mut Random) -> Vec<u8> {
    let problem = problem::<R>(random).concat();
    let mut numbers = [0.1, 0.25, random.magnitude(-1.0, 1.0), 0.05, 0.1].map(R::of).to_vec();
    numbers.extend(problem);
    with_kind(&numbers, case % 25)
}

/// Waypoints of one or two axes: the first byte holds the number of axes and that of sections above the real type.
fn of_path<R: Real>(case: u8, random: &mut Random) -> Vec<u8> {
    let [axes, sections] = [1 + case % 2, 1 + case / 2 % 4];
    let mut numbers = Vec::new();
    let mut ends = [Vec::new(), Vec::new()];
    for _ in 0..axes {
        let [limits, from, to] = problem::<R>(random);
        numbers.extend(limits);
        ends[0].extend(from);
        ends[1].extend(to);
    }
    numbers.extend(ends.concat());
    numbers.extend((0..axes * (sections - 1)).map(|_| R::of(random.between(-10.0, 10.0))));
    with_kind(&numbers, axes - 1 + 2 * (sections - 1))
}

/// Problems of each planner of `Move`: the first byte holds its number above the real type.
fn of_move<R: Real>(case: u8, random: &mut Random) -> Vec<u8> {
    let mut numbers = problem::<R>(random).concat();
    // Positions between which a move stays; the second one is no horizon for a signal, the first one often is.
    numbers.extend([R::of(0.5), R::of(50.0)]);
    with_kind(&numbers, case % PLANNERS)
}

/// Problems of each planner of one to three axes: the first byte holds both above the real type. At rest every line can be planned.
fn of_axes<R: Real>(case: u8, random: &mut Random) -> Vec<u8> {
    let [planner, more] = [case % PLANNERS_OF_AXES, case / PLANNERS_OF_AXES % 3];
    let mut numbers = vec![R::ZERO, R::of(random.pick(&[0.0, 0.001]))];
    for _ in 0..=more {
        let [limits, mut from, mut to] = problem::<R>(random);
        if planner == 1 {
            from[1..].fill(R::ZERO);
            to[1..].fill(R::ZERO);
        }
        let (p0, p1) = (from[0], to[0]);
        numbers.extend([limits, from, to].concat());
        let (low, high) = if p0 < p1 { (p0, p1) } else { (p1, p0) };
        let margin = R::of(random.magnitude(-3.0, 2.0));
        numbers.extend([low - margin, high + margin]);
    }
    with_kind(&numbers, planner + PLANNERS_OF_AXES * more)
}

fn write_golden<R: Real>(family: Family, directory: &Path) -> Result<()> {
    let evaluations = golden::evaluations::<R>(family);
    let cases = golden::moves::<R>(family).into_iter().enumerate().map(|(case, golden)| {
        let times = evaluations.iter().filter(|golden| golden.case == case).map(|golden| golden.x);
        encode(&golden.arguments, &times.collect::<Vec<_>>())
    });
    write_corpus::<R>(&directory.join(family.name()), "golden", cases)
}
