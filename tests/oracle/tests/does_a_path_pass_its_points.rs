//! Does a path pass its way points within all limits, in the promised durations, and never later than with stops, in 2,000 paths per real type?

use oracle::judge::path::faults::Fault;
use oracle::judge::path::problems::{Chain, Chains, Family};
use oracle::judge::path::{Path, Paths, Planner, judge};
use oracle::liba::abi::Original;
use std::collections::BTreeMap;
use std::time::Instant;
use support::{Random, Real};

const PATHS: usize = 2_000;

fn paths_pass_their_points<R: Original>() {
    let start = Instant::now();
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
        println!(
            "{:>14?} {:>5} paths, mean {mean:.3} of the path with stops",
            Family::ALL[*family],
            parts.len()
        );
    }
    println!(
        "{}: {} bad, {:.0} s",
        R::NAME,
        bad.len(),
        start.elapsed().as_secs_f64()
    );
    for example in bad.iter().take(20) {
        println!("{example}");
    }
    assert!(bad.is_empty());
}

#[test]
fn f64() {
    paths_pass_their_points::<f64>();
}

#[test]
fn f32() {
    paths_pass_their_points::<f32>();
}

/// Every number of a plan, as bits.
fn bits<R: Real>(path: &Path<R>) -> Vec<u64> {
    let states = path
        .states
        .iter()
        .flat_map(|s| [s.position, s.velocity, s.acceleration]);
    let numbers = states.chain(path.durations.iter().copied());
    // 0 has no direction.
    numbers.map(|x| (x + R::of(0.0)).low_bits()).collect()
}

fn units_change_no_bit<R: Original>() {
    let mut chains = Chains::new(1);
    for k in 0..PATHS / 4 {
        let chain = chains.draw::<R>();
        let plan = |chain: &Chain<R>| Paths.plan(chain, 0).expect("a plan").0;
        let path = plan(&chain);
        let other = plan(&chain.mirrored());
        let back = Chain {
            states: other.states,
            ..chain.clone()
        }
        .scaled(-1.0, 1.0);
        let back = Path {
            states: back.states,
            durations: other.durations,
        };
        assert!(
            bits(&path) == bits(&back),
            "{k} {:?}: mirrored",
            chain.family
        );
        for (length, time) in [(8.0, 1.0), (1.0, 0.25), (0.5, 2.0)] {
            let other = plan(&chain.scaled(length, time));
            let scaled = Chain {
                states: other.states,
                ..chain.clone()
            }
            .scaled(1.0 / length, 1.0 / time);
            let durations = other
                .durations
                .iter()
                .map(|&t| t * R::of(1.0 / time))
                .collect();
            let back = Path {
                states: scaled.states,
                durations,
            };
            assert!(
                bits(&path) == bits(&back),
                "{k} {:?}: {length} {time}",
                chain.family
            );
        }
    }
}

#[test]
fn units_change_no_bit_f64() {
    units_change_no_bit::<f64>();
}

#[test]
fn units_change_no_bit_f32() {
    units_change_no_bit::<f32>();
}

fn every_fault_is_seen<R: Original>() {
    for fault in Fault::ALL {
        let (mut chains, mut random) = (Chains::new(0), Random::seeded(0));
        let mut seen = 0;
        for _ in 0..180 {
            seen += usize::from(judge(&fault, &chains.draw::<R>(), &mut random).is_err());
        }
        println!("{} {fault:?}: {seen} of 180 paths seen", R::NAME);
        // One family has limits for every section, and one starts outside.
        let few = if matches!(fault, Fault::NoZones | Fault::Silent) {
            5
        } else {
            18
        };
        assert!(seen >= few, "{fault:?} in {}", R::NAME);
    }
}

#[test]
fn every_fault_is_seen_f64() {
    every_fault_is_seen::<f64>();
}

#[test]
fn every_fault_is_seen_f32() {
    every_fault_is_seen::<f32>();
}
