//! `times`: how long rows of many points take to plan, for each section: `docs/data/path-times.csv`.

use oracle::judge::path::windows::{rows, whole};
use std::time::Instant;

const ROUNDS: usize = 5;

fn main() {
    println!("row,points,whole s,µs a section");
    for count in [1_000, 8_000] {
        for (name, row) in rows(count) {
            let (mut time, mut least) = (0.0, f64::INFINITY);
            for _ in 0..ROUNDS {
                let start = Instant::now();
                time = whole(&row);
                least = least.min(start.elapsed().as_secs_f64());
            }
            println!("\"{name}\",{count},{time:.3},{:.1}", least * 1e6 / (count - 1) as f64);
        }
    }
}
