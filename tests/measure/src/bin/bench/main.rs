//! Prints tables in CSV: `make bench` keeps them as docs/data/performance-*.csv.
//!
//! `bench`: a table of ours against the original at `-O2` and `-O3`, all through the C ABI, in one process.
//! `bench fastest`: a table of the plans that never fail, next to the original's at `-O2` and the crate rsruckig.
//! `bench moves`: a table of the moves from any state to any state, and of several axes that arrive together, next to rsruckig and Ruckig's C++.
//! `bench evaluations`: a table of evaluations of such moves, next to the double-S.
//! `bench path`: a table of paths through waypoints, next to the crate rsruckig.
//! `bench instructions`: the instructions of our functions, one line each, for `.ci/run`.
//! `bench count ROW LIBRARY`: runs one row once, in the function that callgrind counts.
//!
//! In each round every library has a short turn, over the same memory. The next round begins with the next library. The
//! result is the median of the ratios within a round. Other work on the machine slows neighbouring turns alike, and a single
//! lucky turn decides nothing. Each library has its own copy of the loop. If one call reached all libraries in turn, the
//! processor would look up its target, which costs some functions a nanosecond and others nothing.

mod fastest;
mod moves;
mod path;
mod race;
mod ruckig;

use atraj::capi::a_float;
use atraj::capi::atraj::{atraj_bell_sample, atraj_bell_state};
use oracle::liba::{Abi, Evaluate, Gen7, OURS, Original};
use std::array::from_fn;
use std::hint::black_box;
use std::process::Command;
use std::rc::Rc;
use std::time::Instant;
use support::{Family, Implementation, Random};

const REAL: &str = if size_of::<a_float>() == 4 { "float" } else { "double" };
const WARM: usize = 4096;
const COLD: usize = 262_144;
const ROUNDS: usize = 99;
const CALLS: usize = 4096; // the fewest calls in one turn

/// Calls that can go to three libraries: ours, the original at `-O2`, and the original at `-O3`. For a plan that never fails the
/// third one is rsruckig. A move from any state to any state is planned by ours, Ruckig's C++ and rsruckig, and evaluated by two.
struct Row {
    function: String,
    case: String,
    calls: usize,               // the number of calls that share the measured time
    run: Box<dyn FnMut(usize)>, // makes the calls to the library of this number
}

impl Row {
    fn new(
        function: impl Into<String>, case: impl Into<String>, calls: usize, run: impl FnMut(usize) + 'static,
    ) -> Self {
        Self { function: function.into(), case: case.into(), calls, run: Box::new(run) }
    }
}

static OPTIMISED: [Abi<a_float>; 2] = <a_float as Original>::OPTIMISED;
static LIBRARIES: [&Abi<a_float>; 3] = [&OURS, &OPTIMISED[0], &OPTIMISED[1]];

fn main() {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["instructions"] => print_instructions(),
        ["fastest"] => fastest::print_table(),
        ["moves"] => moves::print_plans(),
        ["evaluations"] => moves::print_evaluations(),
        ["path"] => path::print_table(),
        ["count", row, library] => count(warm_rows(), row, library),
        [] => print_table(),
        _ => panic!("no such table"),
    }
}

fn print_table() {
    println!("real,function,case,ours ns,-O2 ns,-O3 ns,-O2/ours,-O3/ours,ours instructions,-O2 instructions");
    for (index, row) in rows(WARM).iter_mut().enumerate() {
        print_row(row, &[0, 1].map(|library| instructions(index, library, row.calls)));
    }
    for row in &mut rows(COLD) {
        print_row(row, &["", ""].map(str::to_owned));
    }
}

fn print_row(row: &mut Row, [ours, original]: &[String; 2]) {
    let ([ns, o2, o3], [_, o2_ratio, o3_ratio]) = times(row);
    let Row { function, case, .. } = row;
    println!("{REAL},{function},\"{case}\",{ns:.2},{o2:.2},{o3:.2},{o2_ratio:.2},{o3_ratio:.2},{ours},{original}");
}

fn print_instructions() {
    for (index, row) in warm_rows().iter().enumerate() {
        let count = instructions(index, 0, row.calls);
        println!("{}, {}: {count}", row.function, row.case);
    }
}

fn measure<const LIBRARIES: usize>(row: &mut Row) -> [[f64; LIBRARIES]; ROUNDS] {
    let passes = CALLS.div_ceil(row.calls);
    let mut rounds = [[0.0; LIBRARIES]; ROUNDS];
    for (round, turns) in rounds.iter_mut().enumerate() {
        for turn in 0..LIBRARIES {
            let library = (round + turn) % LIBRARIES;
            let start = Instant::now();
            for _ in 0..passes {
                (row.run)(library);
            }
            turns[library] = start.elapsed().as_secs_f64() * 1e9 / (passes * row.calls) as f64;
        }
    }
    rounds
}

fn times<const LIBRARIES: usize>(row: &mut Row) -> ([f64; LIBRARIES], [f64; LIBRARIES]) {
    let rounds = measure::<LIBRARIES>(row);
    let ns = from_fn(|library| median(rounds.iter().map(|turns| turns[library])));
    (ns, from_fn(|library| median(rounds.iter().map(|turns| turns[library] / turns[0]))))
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<_> = values.collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Instructions of a call, counted by callgrind in a process of its own.
fn instructions(row: usize, library: usize, calls: usize) -> String {
    let mut valgrind = Command::new("valgrind");
    valgrind.args(["--tool=callgrind", "--callgrind-out-file=/dev/null", "--toggle-collect=counted"]);
    valgrind.arg(std::env::current_exe().expect("the path of this program"));
    let output = valgrind.args(["count", &row.to_string(), &library.to_string()]).output().expect("valgrind");
    let text = String::from_utf8_lossy(&output.stderr);
    let collected = text.lines().find_map(|line| line.split_once("Collected : "));
    let (_, count) = collected.unwrap_or_else(|| panic!("valgrind: {text}"));
    let count: f64 = count.trim().parse().expect("a number");
    format!("{:.1}", count / calls as f64)
}

fn count(mut rows: Vec<Row>, row: &str, library: &str) {
    let mut row = rows.swap_remove(row.parse().expect("a row"));
    let library = library.parse().expect("a library");
    counted(&mut || (row.run)(library));
}

#[inline(never)]
#[unsafe(no_mangle)]
extern "Rust" fn counted(run: &mut dyn FnMut()) {
    run();
}

fn warm_rows() -> Vec<Row> {
    rows(WARM).into_iter().chain(fastest::rows()).chain(moves::rows()).collect()
}

/// All rows of the first table, over `count` moves. The rows of samples use one move and come with the warm rows.
fn rows(count: usize) -> Vec<Row> {
    let place = if count == WARM { "warm" } else { "cold" };
    let mut random = Random(1);
    let mut rows = Vec::new();
    for (case, plans) in bells(count, &mut random) {
        rows.push(gen7("a_trajbell_gen", format!("{case}, {place}"), plans, |abi| abi.bell));
    }
    let plans = (0..count).map(|_| trap(&mut random)).collect();
    rows.push(gen7("a_trajtrap_gen", place.into(), plans, |abi| abi.trap));
    for family in [Family::Poly3, Family::Poly5, Family::Poly7] {
        rows.push(polynomials(family, place, count, &mut random));
    }
    let [_, _, (_, mixed)] = bells(count, &mut random);
    let first: Duration = |fields| fields[0];
    evaluations(Family::Bell, place, &mixed, first, &mut random, &mut rows);
    let traps: Vec<_> = (0..count).map(|_| trap(&mut random)).collect();
    evaluations(Family::Trap, place, &traps, first, &mut random, &mut rows);
    let septics: Vec<_> = (0..count).map(|_| septic(&mut random)).collect();
    evaluations(Family::Poly7, place, &septics, |_| 2.0, &mut random, &mut rows);
    if count == WARM {
        // These are the fields of a bell.
        let sample: AtOnce = |fields, dt, out| sample_all(atraj_bell_sample, fields.as_ptr().cast(), dt, out);
        let state: AtOnce = |fields, dt, out| state_all(atraj_bell_state, fields.as_ptr().cast(), dt, out);
        rows.extend([256, 1024, 16_384].map(|n| at_once("atraj_bell_sample", n, sample)));
        rows.push(at_once("atraj_bell_state", 1024, state));
    }
    rows
}

type Plan = Vec<a_float>;

fn bells(count: usize, random: &mut Random) -> [(&'static str, Vec<Plan>); 3] {
    let mut plans = |lo: f64, hi: f64, speed: f64| -> Vec<Plan> {
        let mut plan = || {
            let [jm, am, vm] = [(10.0, 50.0), (4.0, 12.0), (2.0, 6.0)].map(|(lo, hi)| random.between(lo, hi));
            let p0 = random.between(-5.0, 5.0);
            let p1 = p0 + random.sign() * random.between(lo, hi);
            let v = [(); 2].map(|()| (p1 - p0).signum() * random.between(0.0, speed));
            [jm, am, vm, p0, p1, v[0], v[1]].map(|x| x as a_float).to_vec()
        };
        (0..count).map(|_| plan()).collect()
    };
    [
        ("cruise", plans(40.0, 80.0, 0.0)),
        ("no cruise", plans(0.1, 1.0, 0.0)),
        ("mixed, v0 and v1", plans(1.0, 15.0, 1.0)),
    ]
}

fn trap(random: &mut Random) -> Plan {
    let [vm, ac, de] = [(2.0, 6.0), (2.0, 8.0), (2.0, 8.0)].map(|(lo, hi)| random.between(lo, hi));
    [vm, ac, -de, 0.0, random.between(1.0, 30.0), 0.0, random.between(0.0, 1.0)].map(|x| x as a_float).to_vec()
}

fn septic(random: &mut Random) -> Plan {
    let mut plan = vec![2.0];
    plan.extend((0..8).map(|_| random.between(-3.0, 3.0) as a_float));
    plan
}

fn planned(family: Family, plans: &[Plan]) -> Vec<Plan> {
    let plan = |arguments: &Plan| {
        let mut fields = vec![0.0; family.fields().len()];
        OURS.plan(family, arguments, &mut fields);
        fields
    };
    plans.iter().map(plan).collect()
}

fn gen7(function: &str, case: String, plans: Vec<Plan>, of: fn(&Abi<a_float>) -> Gen7<a_float>) -> Row {
    let plans: Vec<[a_float; 7]> = plans.iter().map(|p| p[..].try_into().expect("7")).collect();
    let calls = plans.len();
    let mut fields = vec![[0.0 as a_float; 14]; calls];
    Row::new(function, case, calls, move |library| {
        let pass = [plan_all::<0>, plan_all::<1>, plan_all::<2>][library];
        pass(of(LIBRARIES[library]), &plans, &mut fields);
    })
}

#[inline(never)]
fn plan_all<const LIBRARY: usize>(plan: Gen7<a_float>, plans: &[[a_float; 7]], fields: &mut [[a_float; 14]]) {
    let plan = black_box(plan);
    align_code();
    for (&[a, b, c, d, e, f, g], fields) in plans.iter().zip(fields) {
        // SAFETY: no struct has more than 14 reals.
        black_box(unsafe { plan(fields.as_mut_ptr(), a, b, c, d, e, f, g) });
    }
}

/// The code after the call begins a cache line, so that the copies of a loop differ in nothing.
#[inline(always)]
fn align_code() {
    // SAFETY: emits nothing but padding.
    unsafe { std::arch::asm!(".p2align 6", options(nomem, nostack, preserves_flags)) };
}

fn polynomials(family: Family, place: &str, count: usize, random: &mut Random) -> Row {
    let mut plan = || (0..family.arguments().len()).map(|_| random.between(0.5, 3.0) as a_float).collect();
    let plans: Vec<Plan> = (0..count).map(|_| plan()).collect();
    let mut fields = vec![0.0; family.fields().len()];
    let function = format!("a_{}_gen", family.c_name());
    Row::new(function, place, count, move |library| {
        let pass = [fit_all::<0>, fit_all::<1>, fit_all::<2>][library];
        pass(family, &plans, &mut fields);
    })
}

#[inline(never)]
fn fit_all<const LIBRARY: usize>(family: Family, plans: &[Plan], fields: &mut [a_float]) {
    let abi = black_box(LIBRARIES[LIBRARY]);
    align_code();
    for plan in plans {
        abi.plan(family, plan, fields);
        black_box(&fields);
    }
}

type Duration = fn(&[a_float]) -> a_float; // the duration of a move, of which these are the fields

fn evaluations(
    family: Family, place: &str, plans: &[Plan], duration: Duration, random: &mut Random, rows: &mut Vec<Row>,
) {
    let mut moves = planned(family, plans);
    moves.retain(|fields| duration(fields) > 0.0);
    let moment = |fields: &Plan| (fields[..].into(), duration(fields) * random.between(0.0, 1.0) as a_float);
    let at_random: Rc<[Moment]> = moves.iter().map(moment).collect();
    let first: Rc<[a_float]> = moves[0][..].into();
    let step = duration(&first) / moves.len() as a_float;
    let sweep: Rc<[Moment]> = (0..moves.len()).map(|k| (first.clone(), k as a_float * step)).collect();
    for (case, moments) in [(format!("random, {place}"), at_random), (format!("sweep, {place}"), sweep)] {
        for (index, quantity) in family.quantities().iter().enumerate() {
            let function = format!("a_{}_{}", family.c_name(), quantity.c);
            let moments = moments.clone();
            rows.push(Row::new(function, &case, moments.len(), move |library| {
                let pass = [evaluate_all::<0>, evaluate_all::<1>, evaluate_all::<2>][library];
                pass((family, index), &moments);
            }));
        }
    }
}

type Moment = (Rc<[a_float]>, a_float);

#[inline(never)]
fn evaluate_all<const LIBRARY: usize>((family, index): (Family, usize), moments: &[Moment]) {
    let evaluate = black_box(LIBRARIES[LIBRARY].evaluations[family as usize][index]);
    align_code();
    for (fields, x) in moments {
        // SAFETY: the function takes the struct of this family, and these are its fields.
        black_box(unsafe { evaluate(fields.as_ptr(), *x) });
    }
}

#[inline(never)]
fn sample_all<C>(sample: Sample<C>, context: *const C, dt: a_float, out: Samples) {
    let n = out[0].len();
    let [p, v, a, j] = out.map(|out| out.as_mut_ptr());
    // SAFETY: the function takes this struct, and every output has `n` elements.
    unsafe { black_box(sample)(context, 0.0, dt, n, p, v, a, j) };
}

#[inline(always)]
fn state_all<C>(state: State<C>, context: *const C, dt: a_float, [p, v, a, j]: Samples) {
    let state = black_box(state);
    align_code();
    for (k, (((p, v), a), j)) in p.iter_mut().zip(v).zip(a).zip(j).enumerate() {
        // SAFETY: the function takes this struct.
        unsafe { state(context, k as a_float * dt, p, v, a, j) };
    }
}

type Out = *mut a_float;
type Sample<C> = unsafe extern "C" fn(*const C, a_float, a_float, usize, Out, Out, Out, Out) -> usize;
type State<C> = unsafe extern "C" fn(*const C, a_float, Out, Out, Out, Out);

/// Rows of positions, velocities, accelerations and jerks. The first row begins at a cache line.
type Samples<'a> = [&'a mut [a_float]; 4];

/// The double-S of the README's table, from 0 to 10 with an initial velocity.
const README: [a_float; 7] = [30.0, 10.0, 5.0, 0.0, 10.0, 1.0, 0.0];

type AtOnce = fn(&[a_float], a_float, Samples);

/// `ours` against four calls of the original for each time.
fn at_once(function: &str, n: usize, ours: AtOnce) -> Row {
    let fields = planned(Family::Bell, &[README.to_vec()]).remove(0);
    sampling(function, n, fields[0], move |library, dt, out| match library {
        0 => ours(&fields, dt, out),
        1 => four_calls::<1>(&fields, dt, out),
        _ => four_calls::<2>(&fields, dt, out),
    })
}

fn sampling(function: &str, n: usize, duration: a_float, fill: impl Fn(usize, a_float, Samples) + 'static) -> Row {
    let dt = duration / (n - 1) as a_float;
    let mut memory = vec![0.0; 4 * n + 16];
    let start = memory.as_ptr().align_offset(64);
    Row::new(function, format!("{n} samples"), n, move |library| {
        let mut rows = memory[start..].chunks_exact_mut(n);
        fill(library, dt, [(); 4].map(|()| rows.next().expect("four rows")));
        black_box(&memory);
    })
}

#[inline(never)]
fn four_calls<const LIBRARY: usize>(fields: &[a_float], dt: a_float, [p, v, a, j]: Samples) {
    let functions = LIBRARIES[LIBRARY].evaluations[Family::Bell as usize];
    let functions: [Evaluate<a_float>; 4] = functions.try_into().expect("four functions");
    let [pos, vel, acc, jer] = black_box(functions);
    align_code();
    for (k, (((p, v), a), j)) in p.iter_mut().zip(v).zip(a).zip(j).enumerate() {
        let x = k as a_float * dt;
        for (y, function) in [(p, pos), (v, vel), (a, acc), (j, jer)] {
            // SAFETY: these are the fields of a bell.
            *y = unsafe { function(fields.as_ptr(), x) };
        }
    }
}
