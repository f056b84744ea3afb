//! `soak [first seed] [seeds]`: a million calls per seed and real type against the original. An interrupted run goes on from
//! the seed after the one in its last progress line.

use oracle::abi::Original;
use oracle::comparison::Report;
use oracle::volume::run_seed;
use std::io::{IsTerminal, Write, stderr};
use std::ops::Range;
use std::process::ExitCode;
use std::time::Instant;
use support::Ours;

fn main() -> ExitCode {
    let mut numbers = std::env::args()
        .skip(1)
        .map(|number| number.parse::<u64>().expect("a number"));
    let first = numbers.next().unwrap_or(0);
    let seeds = first..first + numbers.next().unwrap_or(1000);
    let same = [soak::<f64>(seeds.clone()), soak::<f32>(seeds)];
    ExitCode::from(u8::from(same.contains(&false)))
}

fn soak<R: Original>(seeds: Range<u64>) -> bool {
    let start = Instant::now();
    let mut total = Report::default();
    for seed in seeds.clone() {
        total.add(run_seed::<R>(&Ours, &R::ORIGINAL, seed));
        let end = if stderr().is_terminal() { "\r" } else { "\n" };
        if stderr().is_terminal() || seed % 100 == 99 {
            let seconds = start.elapsed().as_secs_f64();
            let million = total.calls as f64 * 1e-6;
            let name = R::NAME;
            eprint!(
                "{name}: seed {seed} done, {million:.0} million calls, {} differing, {:.1} million calls/s{end}",
                total.differing,
                million / seconds
            );
            let _ = stderr().flush();
        }
    }
    println!(
        "{}: seeds {seeds:?}, {:.0} s: {total}",
        R::NAME,
        start.elapsed().as_secs_f64()
    );
    for example in total.examples.iter().take(10) {
        println!("{example}");
    }
    total.values > 0 && total.differing == 0
}
