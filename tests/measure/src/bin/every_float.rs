//! `every_float [n]`: every n-th binary32 number as the argument of each function of one argument that is the library's own. Is its error within
//! what its description promises? It prints the rows of docs/data/every-float.csv. Without `n` it asks all 2^32.

#![allow(dead_code, missing_docs, unexpected_cfgs)]

#[path = "../../../../src/real/mod.rs"]
mod real;

use real::Operations;
use std::process::ExitCode;
use std::thread::scope;

const EPSILON: f64 = f32::EPSILON as f64;

struct Function {
    name: &'static str,
    ours: fn(f32) -> f32,
    exact: fn(f64) -> f64,        // in binary64, whose own error is far below an ulp of binary32
    takes: fn(f32) -> bool,       // the arguments that its description allows
    allowed: fn(f64, f64) -> f64, // by how much it may be off at an argument, by its value there
    may_be_below: bool,           // whether it may be too small
}

#[rustfmt::skip]
const FUNCTIONS: [Function; 5] = [
    // Half an ulp, at most, of the power of two below.
    Function { name: "square root", ours: Operations::sqrt, exact: f64::sqrt, takes: |_| true, may_be_below: true,
        allowed: |_, exact| 0.5 * EPSILON * exact.max(f64::from(f32::MIN_POSITIVE)) },
    Function { name: "cube root from above", ours: Operations::cube_root_above, exact: f64::cbrt, takes: |x| x == 0.0 || has_root(x),
        may_be_below: false, allowed: |_, exact| 1e-4 * exact },
    Function { name: "cube root", ours: Operations::cube_root, exact: f64::cbrt, takes: has_root, may_be_below: true,
        allowed: |_, exact| EPSILON * exact },
    Function { name: "logarithm", ours: Operations::ln, exact: f64::ln, takes: |x| x > 0.0 && x.is_normal(), may_be_below: true,
        allowed: |_, exact| 1e-8 + 6.0 * EPSILON * exact.abs() },
    // A tiny result has the roundings of the smallest normal number.
    Function { name: "exponential of a negative number", ours: Operations::exp_of_negative, exact: |x| (-x).exp(), takes: |x| x >= 0.0,
        may_be_below: true, allowed: |x, exact| (12.0 + x.min(200.0)) * EPSILON * exact.max(f64::from(f32::MIN_POSITIVE)) },
];

fn has_root(x: f32) -> bool {
    x.is_normal() && x > 0.0 && x <= f32::MAX / 4.0
}

/// What was found in arguments of a function: how many, the largest error in ulps of its value, where it is, and the first broken promise.
#[derive(Clone, Copy, Default)]
struct Found {
    arguments: u64,
    worst: f64,
    at: f32,
    broken: Option<f32>,
}

impl Found {
    fn note(&mut self, function: &Function, x: f32) {
        if !(function.takes)(x) {
            return;
        }
        self.arguments += 1;
        let (ours, exact) = (f64::from((function.ours)(x)), (function.exact)(f64::from(x)));
        if ours == exact || ours.is_nan() && exact.is_nan() {
            return;
        }
        let error = (ours - exact).abs();
        let ulps = error / (EPSILON * exact.abs().max(f64::from(f32::MIN_POSITIVE)));
        if ulps > self.worst {
            (self.worst, self.at) = (ulps, x);
        }
        let is_kept = error <= (function.allowed)(f64::from(x), exact) && (function.may_be_below || ours >= exact);
        if !is_kept {
            self.broken = self.broken.or(Some(x));
        }
    }

    fn and(self, other: Self) -> Self {
        let (worse, better) = if other.worst > self.worst { (other, self) } else { (self, other) };
        Self { arguments: worse.arguments + better.arguments, broken: worse.broken.or(better.broken), ..worse }
    }
}

fn ask(function: &Function, n: u64) -> Found {
    let threads = std::thread::available_parallelism().map_or(1, usize::from) as u64;
    let part = |thread: u64| {
        let mut found = Found::default();
        for bits in (thread * n..1 << 32).step_by((threads * n) as usize) {
            found.note(function, f32::from_bits(bits as u32));
        }
        found
    };
    scope(|scope| {
        let parts: Vec<_> = (0..threads).map(|thread| scope.spawn(move || part(thread))).collect();
        parts.into_iter().map(|part| part.join().expect("a part")).fold(Found::default(), Found::and)
    })
}

fn main() -> ExitCode {
    let n = std::env::args().nth(1).map_or(Ok(1), |n| n.parse()).expect("a number");
    let mut are_kept = true;
    println!("function,arguments,worst error in ulps,at");
    for function in &FUNCTIONS {
        let Found { arguments, worst, at, broken } = ask(function, n);
        println!("{},{arguments},{worst:.2},{at:e}", function.name);
        if let Some(x) = broken {
            eprintln!("{} of {x:e}: the error is not within what its description promises", function.name);
            are_kept = false;
        }
    }
    ExitCode::from(u8::from(!are_kept))
}
