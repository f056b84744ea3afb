//! Waypoints without stops, through the C ABI, next to the crate rsruckig: the same paths in the same rounds.

use crate::{REAL, median};
use atraj::capi::a_float;
use atraj::capi::atraj::{atraj_path_plan, atraj_path_size};
use oracle::judge::path::{Chain, Chains, Family, Paths, Planner};
use oracle::judge::rivals::{path_fits_ruckig, ruckig_path};
use std::hint::black_box;
use std::time::Instant;
use support::Real;

const PATHS: usize = 8;
const ROUNDS: usize = 9; // rsruckig takes milliseconds for a path
const REPEATS: usize = 20; // plans of ours in a turn

pub fn print_table() {
    println!("real,function,case,ours µs,rsruckig µs,ours/rsruckig,rsruckig duration/ours");
    for (axes, points) in [(1, 4), (3, 2), (3, 4), (4, 5)] {
        print_row(axes, points, &chains(axes, points));
    }
}

fn chains(axes: usize, points: usize) -> Vec<Chain<a_float>> {
    let mut chains = Chains::new(0);
    let all = std::iter::from_fn(|| Some(chains.of::<a_float>(Family::AtRest)));
    let fits = |chain: &Chain<a_float>| chain.axes == axes && chain.sections() == points + 1 && path_fits_ruckig(chain);
    all.filter(fits).take(PATHS).collect()
}

fn print_row(axes: usize, points: usize, chains: &[Chain<a_float>]) {
    let rounds: Vec<_> = (0..ROUNDS).map(|_| [ours(chains), theirs(chains)]).collect();
    let [ours, theirs] = [0, 1].map(|library| median(rounds.iter().map(|turns| turns[library])));
    let part = median(rounds.iter().map(|[ours, theirs]| ours / theirs));
    let longer = chains.iter().map(|chain| {
        let (path, _) = Paths.plan(chain, 0).expect("a plan");
        ruckig_path(chain).unwrap_or(f64::NAN) / path.duration()
    });
    let longer = longer.sum::<f64>() / chains.len() as f64;
    println!("{REAL},atraj_path_plan,\"{axes} axes, {points} waypoints\",{ours:.1},{theirs:.1},{part:.4},{longer:.4}");
}

fn ours(chains: &[Chain<a_float>]) -> f64 {
    let plan = black_box(atraj_path_plan);
    let mut states: Vec<_> = chains.iter().map(|chain| chain.states.clone()).collect();
    let (axes, sections) = (chains[0].axes, chains[0].sections());
    let mut durations = vec![0.0; sections];
    let mut work = vec![0.0; atraj_path_size(axes, sections)];
    let start = Instant::now();
    for _ in 0..REPEATS {
        for (chain, states) in chains.iter().zip(&mut states) {
            // SAFETY: the arrays have as many numbers as the header says, and the structs have the same layout.
            let planned = unsafe {
                let (states, limits) = (states.as_mut_ptr().cast(), chain.limits.as_ptr().cast());
                plan(states, durations.as_mut_ptr(), limits, axes, sections, 0, work.as_mut_ptr())
            };
            assert!(planned >= 0 && durations[0].widen() > 0.0);
        }
    }
    start.elapsed().as_secs_f64() * 1e6 / (REPEATS * chains.len()) as f64
}

fn theirs(chains: &[Chain<a_float>]) -> f64 {
    let start = Instant::now();
    chains.iter().for_each(|chain| {
        black_box(ruckig_path(chain));
    });
    start.elapsed().as_secs_f64() * 1e6 / chains.len() as f64
}
