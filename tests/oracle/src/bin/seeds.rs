//! `seeds <directory>`: the golden moves as a fuzzer's first corpus, in one subdirectory for each family, and nasty problems in
//! another, random problems of `Move` in a third, of several axes in a fourth, of way points in a fifth, and requests to an axis in a sixth.

use atraj::State;
use oracle::bytes::{PLANNERS, PLANNERS_OF_AXES, REQUESTS, encode};
use oracle::judge::problems::{Kind, Problems};
use oracle::liba::abi::Original;
use std::io::Result;
use std::path::{Path, PathBuf};
use support::{Family, Random, Real, golden, online};

fn main() -> Result<()> {
    let directory = PathBuf::from(std::env::args_os().nth(1).expect("a directory"));
    for family in Family::ALL {
        write::<f64>(family, &directory.join(family.name()))?;
        write::<f32>(family, &directory.join(family.name()))?;
    }
    write_problems::<f64>(&directory.join("fastest"))?;
    write_problems::<f32>(&directory.join("fastest"))?;
    write_moves::<f64>(&directory.join("move"))?;
    write_moves::<f32>(&directory.join("move"))?;
    write_axes::<f64>(&directory.join("axes"))?;
    write_axes::<f32>(&directory.join("axes"))?;
    write_paths::<f64>(&directory.join("path"))?;
    write_paths::<f32>(&directory.join("path"))?;
    write_requests::<f64>(&directory.join("axis"))?;
    write_requests::<f32>(&directory.join("axis"))?;
    write_machines::<f64>(&directory.join("machine"))?;
    write_machines::<f32>(&directory.join("machine"))
}

/// Requests to an axis: period, start and limits, then a byte for each request and its lead or ticks, and its numbers.
fn write_requests<R: Real>(directory: &Path) -> Result<()> {
    std::fs::create_dir_all(directory)?;
    let mut random = Random::seeded(3);
    for case in 0..32 {
        let limits = online::limits::<R>(&mut random);
        let start = online::anywhere(&mut random, &limits);
        let mut bytes = encode(&[R::of(0.001)], &[]);
        bytes.extend(&encode(&numbers_of_state(start), &[])[1..]);
        bytes.extend(&encode(&online::numbers_of(&limits), &[])[1..]);
        for _ in 0..10 {
            let request = random.below(usize::from(REQUESTS)) as u8;
            let other = online::limits::<R>(&mut random);
            let target = online::inside(&mut random, &limits);
            bytes.push(request + REQUESTS * random.pick(&[0, 1, 2, 5, 40]));
            let numbers = match request {
                0..3 => numbers_of_state(target),
                3 => [numbers_of_state(target), vec![R::of(0.1)]].concat(),
                4 => online::numbers_of(&other).to_vec(),
                _ => Vec::new(),
            };
            bytes.extend(&encode(&numbers, &[])[1..]);
        }
        std::fs::write(directory.join(format!("random-{}-{case}", R::NAME)), bytes)?;
    }
    Ok(())
}

fn numbers_of_state<R: Real>(state: State<R>) -> Vec<R> {
    vec![state.position, state.velocity, state.acceleration]
}

/// Moves with steps and shapers: the first byte holds the kind of the shaper above the real type.
fn write_machines<R: Real>(directory: &Path) -> Result<()> {
    std::fs::create_dir_all(directory)?;
    let mut random = Random::seeded(3);
    for case in 0..48 {
        let limits = online::limits::<R>(&mut random);
        let from = online::anywhere(&mut random, &limits);
        let to = online::inside(&mut random, &limits);
        let mut numbers = [0.1, 0.25, random.magnitude(-1.0, 1.0), 0.05, 0.1]
            .map(R::of)
            .to_vec();
        numbers.extend(online::numbers_of(&limits));
        for state in [from, to] {
            numbers.extend(numbers_of_state(state));
        }
        let mut bytes = encode(&numbers, &[]);
        bytes[0] += 2 * (case % 25);
        std::fs::write(directory.join(format!("random-{}-{case}", R::NAME)), bytes)?;
    }
    Ok(())
}

/// Way points of one or two axes: the first byte holds the number of axes and that of sections above the real type.
fn write_paths<R: Real>(directory: &Path) -> Result<()> {
    std::fs::create_dir_all(directory)?;
    let mut random = Random::seeded(2);
    for case in 0..48 {
        let [axes, sections] = [1 + case % 2, 1 + case / 2 % 4];
        let mut numbers = Vec::new();
        let mut ends = [Vec::new(), Vec::new()];
        for _ in 0..axes {
            let limits = online::limits::<R>(&mut random);
            numbers.extend(online::numbers_of(&limits));
            let states = [
                online::anywhere(&mut random, &limits),
                online::inside(&mut random, &limits),
            ];
            for (end, state) in ends.iter_mut().zip(states) {
                end.extend(numbers_of_state(state));
            }
        }
        numbers.extend(ends.concat());
        numbers.extend((0..axes * (sections - 1)).map(|_| R::of(random.between(-10.0, 10.0))));
        let mut bytes = encode(&numbers, &[]);
        bytes[0] += 2 * (axes - 1 + 2 * (sections - 1));
        std::fs::write(directory.join(format!("random-{}-{case}", R::NAME)), bytes)?;
    }
    Ok(())
}

/// Problems of each planner of `Move`: the first byte holds its number above the real type.
fn write_moves<R: Real>(directory: &Path) -> Result<()> {
    std::fs::create_dir_all(directory)?;
    let mut random = Random::seeded(0);
    for case in 0..64 {
        let limits = online::limits::<R>(&mut random);
        let from = online::anywhere(&mut random, &limits);
        let to = online::inside(&mut random, &limits);
        let mut numbers = online::numbers_of(&limits).to_vec();
        for state in [from, to] {
            numbers.extend(numbers_of_state(state));
        }
        // Positions between which a move stays; the second one is no horizon for a signal, the first one often is.
        numbers.extend([R::of(0.5), R::of(50.0)]);
        let mut bytes = encode(&numbers, &[]);
        bytes[0] += 2 * (case % PLANNERS);
        let file = directory.join(format!("random-{}-{case}", R::NAME));
        std::fs::write(file, bytes)?;
    }
    Ok(())
}

/// Problems of each planner of one to three axes: the first byte holds both above the real type. At rest every line can be planned.
fn write_axes<R: Real>(directory: &Path) -> Result<()> {
    std::fs::create_dir_all(directory)?;
    let mut random = Random::seeded(1);
    for case in 0..48 {
        let [planner, more] = [case % PLANNERS_OF_AXES, case / PLANNERS_OF_AXES % 3];
        let zero = R::of(0.0);
        let mut numbers = vec![zero, R::of(random.pick(&[0.0, 0.001]))];
        for _ in 0..=more {
            let limits = online::limits::<R>(&mut random);
            let from = online::anywhere(&mut random, &limits);
            let to = online::inside(&mut random, &limits);
            numbers.extend(online::numbers_of(&limits));
            for state in [from, to] {
                let of = |x: R| if planner == 1 { zero } else { x };
                numbers.extend([state.position, of(state.velocity), of(state.acceleration)]);
            }
            let (p0, p1) = (from.position, to.position);
            let (low, high) = if p0 < p1 { (p0, p1) } else { (p1, p0) };
            let beside = R::of(random.magnitude(-3.0, 2.0));
            numbers.extend([low - beside, high + beside]);
        }
        let mut bytes = encode(&numbers, &[]);
        bytes[0] += 2 * (planner + PLANNERS_OF_AXES * more);
        std::fs::write(directory.join(format!("random-{}-{case}", R::NAME)), bytes)?;
    }
    Ok(())
}

fn write_problems<R: Original>(directory: &Path) -> Result<()> {
    std::fs::create_dir_all(directory)?;
    let problems = Problems::<R>::of_profiles(0).take(6 * Kind::OF_PROFILES.len());
    for (case, problem) in problems.enumerate() {
        let file = directory.join(format!("nasty-{}-{case}", R::NAME));
        std::fs::write(file, encode(&problem.arguments(), &[]))?;
    }
    Ok(())
}

fn write<R: Real>(family: Family, directory: &Path) -> Result<()> {
    std::fs::create_dir_all(directory)?;
    let evaluations = golden::evaluations::<R>(family);
    for (case, golden) in golden::moves::<R>(family).iter().enumerate() {
        let times = evaluations.iter().filter(|golden| golden.case == case);
        let times: Vec<_> = times.map(|golden| golden.x).collect();
        let file = directory.join(format!("golden-{}-{case}", R::NAME));
        std::fs::write(file, encode(&golden.arguments, &times))?;
    }
    Ok(())
}
