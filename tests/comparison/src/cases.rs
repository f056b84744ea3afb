//! Points that others have published with their durations.

use atraj::State;
use atraj::online::Limits;
use oracle::judge::path::{Chain, example_of_ruckig};
use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};

pub struct Case {
    pub name: &'static str,      // what they are
    pub chains: Vec<Chain<f64>>, // one, or several, of which the table has the mean
}

pub fn cases() -> [Case; 5] {
    [
        Case { name: "Ruckig's example 3", chains: vec![example_of_ruckig()] },
        Case { name: "the same points, from rest to rest", chains: vec![at_rest(example_of_ruckig())] },
        Case { name: "0 10 10.01 20.01 20.02 30.02 mm", chains: vec![uneven()] },
        Case { name: "LinuxCNC's issue 4149", chains: vec![linuxcnc()] },
        Case { name: "COPP's test: 100 times 50 points, 7 axes", chains: random_splines() },
    ]
}

fn at_rest(chain: Chain<f64>) -> Chain<f64> {
    Chain { states: chain.states.iter().map(|state| State::at(state.position)).collect(), ..chain }
}

/// mm
fn uneven() -> Chain<f64> {
    Chain::at_rest(vec![Limits::symmetric(6e4, 3e3, 100.0)], [0.0, 10.0, 10.01, 20.01, 20.02, 30.02].into_iter())
}

/// mm
fn linuxcnc() -> Chain<f64> {
    let points = [0.0, 1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 2.0, 5.0, 8.0, 20.0, 50.0, 100.0, 200.0];
    Chain::at_rest(vec![Limits::symmetric(1e4, 1e3, 266.67)], points.into_iter())
}

/// The 100 paths of `test_random_spline.rs` in COPP, from the same seed.
fn random_splines() -> Vec<Chain<f64>> {
    let mut random = StdRng::seed_from_u64(20_260_414);
    (0..100).map(|_| random_spline(&mut random)).collect()
}

fn random_spline(random: &mut StdRng) -> Chain<f64> {
    let points: [[f64; 50]; 7] = std::array::from_fn(|_| std::array::from_fn(|_| random.random_range(-0.5..0.5)));
    let mut seven = |limit: f64| -> [f64; 7] { std::array::from_fn(|_| limit * random.random_range(0.9..1.1)) };
    let [vmax, vmin, amax, amin, jmax, jmin] = [1.0, -1.0, 5.0, -5.0, 50.0, -50.0].map(&mut seven);
    let limits =
        |k: usize| Limits { vmax: vmax[k], vmin: vmin[k], amax: amax[k], amin: amin[k], jmax: jmax[k], jmin: jmin[k] };
    Chain::at_rest((0..7).map(limits).collect(), (0..350).map(|k| points[k % 7][k / 7]))
}
