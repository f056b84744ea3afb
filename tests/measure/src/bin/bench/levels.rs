//! Samples from the shared library of each level of x86-64, as the loader takes them. They stand beside the original and beside the
//! least that memory allows: filling the four arrays with a constant.

use crate::{REAL, Row, Sample, Samples, at_once, instructions_of, measure, median, sampled};
use atraj::capi::a_float;
use libloading::Library;
use std::hint::black_box;
use support::repository::root;

struct Level {
    name: &'static str,
    folder: &'static str,
    is_here: fn() -> bool,
    fill: unsafe fn(Samples, a_float),
}

const LEVELS: [Level; 3] = [
    Level { name: "default", folder: "", is_here: || true, fill: fill_default },
    Level {
        name: "x86-64-v3",
        folder: "glibc-hwcaps/x86-64-v3/",
        is_here: || is_x86_feature_detected!("avx2"),
        fill: fill_v3,
    },
    Level {
        name: "x86-64-v4",
        folder: "glibc-hwcaps/x86-64-v4/",
        is_here: || is_x86_feature_detected!("avx512vl"),
        fill: fill_v4,
    },
];

pub fn print_table() {
    println!("real,level,case,ours ns,-O2 ns,fill ns,-O2/ours,ours/fill,ours instructions");
    for (index, row) in rows().iter_mut().enumerate() {
        let level = &LEVELS[index % LEVELS.len()];
        let start = format!("{REAL},{},\"{}\",", level.name, row.case);
        if (level.is_here)() {
            let rounds = measure::<3>(row);
            let [ns, o2, fill] = [0, 1, 2].map(|k| median(rounds.iter().map(|turns| turns[k])));
            let o2_ratio = median(rounds.iter().map(|[ours, o2, _]| o2 / ours));
            let fill_ratio = median(rounds.iter().map(|[ours, _, fill]| ours / fill));
            let count = instructions_of("count-levels", index, 0, row.calls);
            println!("{start}{ns:.2},{o2:.2},{fill:.2},{o2_ratio:.2},{fill_ratio:.2},{count}");
        } else {
            println!("{start}this processor lacks it,,,,,");
        }
    }
}

pub fn rows() -> Vec<Row> {
    let cases = [256, 1024, 16_384].into_iter().flat_map(|n| LEVELS.iter().map(move |level| (n, level)));
    cases.map(|(n, level)| samples(n, level)).collect()
}

fn samples(n: usize, level: &'static Level) -> Row {
    let fill = |_: &[a_float], _: a_float, out: Samples| {
        // SAFETY: a row runs only if the processor has its level.
        unsafe { (level.fill)(out, black_box(1.0)) };
    };
    at_once(level.name, n, sampled(loaded(level)), fill)
}

fn loaded(level: &Level) -> Sample {
    let name = if REAL == "float" { "-float" } else { "" };
    let folder = format!("target/dist{name}/lib/{}", level.folder);
    let file = root().join(folder).join(format!("libatraj{name}.so.0"));
    // SAFETY: our library runs nothing when it is loaded, the function has this type, and nothing unloads the library.
    unsafe {
        let library = Library::new(&file).unwrap_or_else(|e| panic!("{e}: run `make dist`"));
        let sample = *library.get::<Sample>(b"atraj_bell_sample").expect("ours");
        std::mem::forget(library);
        sample
    }
}

fn fill_default(out: Samples, value: a_float) {
    fill(out, value);
}

#[target_feature(enable = "avx2")]
fn fill_v3(out: Samples, value: a_float) {
    fill(out, value);
}

#[target_feature(enable = "avx512vl")]
fn fill_v4(out: Samples, value: a_float) {
    fill(out, value);
}

#[inline(always)]
fn fill(out: Samples, value: a_float) {
    for row in out {
        row.fill(value);
    }
}
