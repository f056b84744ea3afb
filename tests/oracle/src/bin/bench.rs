//! `bench`: a table of ours against the original at `-O2` and `-O3`, all through the C ABI, in one process.
//! `bench samples`: its rows of sampling alone.
//! `bench instructions`: instructions of our functions, one line each, for the gate.
//! `bench count ROW LIBRARY`: runs one row once, in the function that callgrind counts.
//!
//! The libraries take short turns, many of them, and the shortest turn of each is what counts: whatever else the machine
//! does makes turns longer.

use atraj::capi::a_float;
use atraj::capi::atraj::{atraj_bell_sample, atraj_bell_state};
use oracle::abi::{Abi, Evaluate, Gen7, OURS, Original};
use oracle::common::random::Random;
use oracle::family::{Family, Implementation};
use std::hint::black_box;
use std::process::Command;
use std::time::Instant;

const WARM: usize = 4096;
const COLD: usize = 262_144;
const TURNS: usize = 60;
/// Calls in one turn, at least.
const CALLS: usize = 4096;

/// Something that three libraries do: ours, the original at `-O2`, and at `-O3`.
struct Row {
    function: String,
    case: String,
    /// What the times are divided by.
    calls: usize,
    run: [Box<dyn FnMut()>; 3],
}

static OPTIMISED: [Abi<a_float>; 2] = <a_float as Original>::OPTIMISED;
static LIBRARIES: [&Abi<a_float>; 3] = [&OURS, &OPTIMISED[0], &OPTIMISED[1]];

fn main() {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => print_table(|_| true),
        ["samples"] => print_table(is_sampling),
        ["instructions"] => print_instructions(),
        ["count", row, library] => {
            let row = rows(WARM).swap_remove(row.parse().expect("a row"));
            let [ours, o2, o3] = row.run;
            let mut run = [ours, o2, o3];
            counted(&mut *run[library.parse::<usize>().expect("a library")]);
        }
        _ => panic!("usage: bench [instructions | count ROW LIBRARY]"),
    }
}

fn is_sampling(row: &Row) -> bool {
    row.function.starts_with("atraj_")
}

fn print_table(wanted: fn(&Row) -> bool) {
    println!(
        "| function | case | ours ns | -O2 ns | -O3 ns | -O2/ours | -O3/ours | instructions ours | -O2 |"
    );
    println!("|---|---|---:|---:|---:|---:|---:|---:|---:|");
    for (index, row) in rows(WARM).iter_mut().enumerate() {
        if wanted(row) {
            let counts = [0, 1].map(|library| instructions(index, library, row.calls));
            print_row(row, &counts.map(|count| format!("{count:.1}")));
        }
    }
    for row in &mut rows(COLD) {
        if wanted(row) && !is_sampling(row) {
            print_row(row, &["", ""].map(str::to_owned));
        }
    }
}

fn print_row(row: &mut Row, [ours, original]: &[String; 2]) {
    let [ns, o2, o3] = measure(row);
    println!(
        "| `{}` | {} | {ns:.2} | {o2:.2} | {o3:.2} | {:.2} | {:.2} | {ours} | {original} |",
        row.function,
        row.case,
        o2 / ns,
        o3 / ns
    );
}

fn print_instructions() {
    for (index, row) in rows(WARM).iter().enumerate() {
        let count = instructions(index, 0, row.calls);
        println!("{}, {}: {count:.1}", row.function, row.case);
    }
}

/// Nanoseconds of a call to each library.
fn measure(row: &mut Row) -> [f64; 3] {
    let passes = CALLS.div_ceil(row.calls);
    let mut shortest = [f64::INFINITY; 3];
    for _ in 0..TURNS {
        for (run, shortest) in row.run.iter_mut().zip(&mut shortest) {
            let start = Instant::now();
            for _ in 0..passes {
                run();
            }
            *shortest = shortest.min(start.elapsed().as_secs_f64());
        }
    }
    shortest.map(|seconds| seconds * 1e9 / (passes * row.calls) as f64)
}

/// Instructions of a call, counted by callgrind in a process of its own.
fn instructions(row: usize, library: usize, calls: usize) -> f64 {
    let output = Command::new("valgrind")
        .args([
            "--tool=callgrind",
            "--callgrind-out-file=/dev/null",
            "--toggle-collect=counted",
        ])
        .arg(std::env::current_exe().expect("the path of this program"))
        .args(["count", &row.to_string(), &library.to_string()])
        .output()
        .expect("valgrind is installed");
    let text = String::from_utf8_lossy(&output.stderr);
    let collected = text
        .lines()
        .find_map(|line| line.split_once("Collected : "));
    let (_, count) = collected.unwrap_or_else(|| panic!("valgrind: {text}"));
    count.trim().parse::<f64>().expect("a number") / calls as f64
}

/// Under this name callgrind finds it.
#[inline(never)]
#[unsafe(no_mangle)]
extern "Rust" fn counted(run: &mut dyn FnMut()) {
    run();
}

/// All rows, over `count` moves; the samples are always those of one move.
fn rows(count: usize) -> Vec<Row> {
    let place = if count == WARM { "warm" } else { "cold" };
    let mut random = Random(1);
    let mut rows = Vec::new();
    for (case, plans) in bells(count, &mut random) {
        rows.push(gen7(
            "a_trajbell_gen",
            format!("{case}, {place}"),
            plans,
            |abi| abi.bell,
        ));
    }
    let plans = (0..count).map(|_| trap(&mut random)).collect();
    rows.push(gen7("a_trajtrap_gen", place.into(), plans, |abi| abi.trap));
    for family in [Family::Poly3, Family::Poly5, Family::Poly7] {
        rows.push(polynomials(family, place, count, &mut random));
    }
    let [_, _, (_, mixed)] = bells(count, &mut random);
    let moves = planned(Family::Bell, &mixed);
    evaluations(
        Family::Bell,
        place,
        &moves,
        |fields| fields[0],
        &mut random,
        &mut rows,
    );
    let traps: Vec<_> = (0..count).map(|_| trap(&mut random)).collect();
    let moves = planned(Family::Trap, &traps);
    evaluations(
        Family::Trap,
        place,
        &moves,
        |fields| fields[0],
        &mut random,
        &mut rows,
    );
    let septics: Vec<_> = (0..count).map(|_| septic(&mut random)).collect();
    let moves = planned(Family::Poly7, &septics);
    evaluations(
        Family::Poly7,
        place,
        &moves,
        |_| 2.0,
        &mut random,
        &mut rows,
    );
    for n in [256, 1024, 16_384] {
        rows.push(samples(n));
    }
    rows.push(states(1024));
    rows
}

type Plan = Vec<a_float>;

/// Random plans that cruise, that have no room to, and both with velocities at the ends.
fn bells(count: usize, random: &mut Random) -> [(&'static str, Vec<Plan>); 3] {
    let mut plans = |lo: f64, hi: f64, speed: f64| -> Vec<Plan> {
        let mut plan = || {
            let [jm, am, vm] =
                [(10.0, 50.0), (4.0, 12.0), (2.0, 6.0)].map(|(lo, hi)| random.between(lo, hi));
            let p0 = random.between(-5.0, 5.0);
            let p1 = p0 + random.sign() * random.between(lo, hi);
            let v = [(); 2].map(|()| (p1 - p0).signum() * random.between(0.0, speed));
            [jm, am, vm, p0, p1, v[0], v[1]]
                .map(|x| x as a_float)
                .to_vec()
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
    let p1 = random.between(1.0, 30.0);
    [vm, ac, -de, 0.0, p1, 0.0, random.between(0.0, 1.0)]
        .map(|x| x as a_float)
        .to_vec()
}

fn septic(random: &mut Random) -> Plan {
    let mut plan = vec![2.0];
    plan.extend((0..8).map(|_| random.between(-3.0, 3.0) as a_float));
    plan
}

/// The structs that ours makes of these plans.
fn planned(family: Family, plans: &[Plan]) -> Vec<Plan> {
    let plan = |arguments: &Plan| {
        let mut fields = vec![0.0; family.fields().len()];
        OURS.plan(family, arguments, &mut fields);
        fields
    };
    plans.iter().map(plan).collect()
}

fn gen7(
    function: &str,
    case: String,
    plans: Vec<Plan>,
    of: fn(&Abi<a_float>) -> Gen7<a_float>,
) -> Row {
    let plans: Vec<[a_float; 7]> = plans.iter().map(|p| p[..].try_into().expect("7")).collect();
    let run = LIBRARIES.map(|abi| -> Box<dyn FnMut()> {
        let plans = plans.clone();
        let mut fields = vec![[0.0 as a_float; 14]; plans.len()];
        let plan = black_box(of(abi));
        Box::new(move || {
            for (&[a, b, c, d, e, f, g], fields) in plans.iter().zip(&mut fields) {
                // SAFETY: no struct has more than 14 reals.
                black_box(unsafe { plan(fields.as_mut_ptr(), a, b, c, d, e, f, g) });
            }
        })
    });
    Row {
        function: function.into(),
        case,
        calls: plans.len(),
        run,
    }
}

fn polynomials(family: Family, place: &str, count: usize, random: &mut Random) -> Row {
    let mut plan = || {
        (0..family.arguments().len())
            .map(|_| random.between(0.5, 3.0) as a_float)
            .collect()
    };
    let plans: Vec<Plan> = (0..count).map(|_| plan()).collect();
    let run = LIBRARIES.map(|abi| -> Box<dyn FnMut()> {
        let plans = plans.clone();
        let mut fields = vec![0.0; family.fields().len()];
        let abi = black_box(abi);
        Box::new(move || {
            for plan in &plans {
                abi.plan(family, plan, &mut fields);
                black_box(&fields);
            }
        })
    });
    let function = format!("a_traj{}_gen", family.name());
    Row {
        function,
        case: place.into(),
        calls: plans.len(),
        run,
    }
}

/// Each evaluation function at random times of `moves`, and in a sweep over the first of them.
fn evaluations(
    family: Family,
    place: &str,
    moves: &[Plan],
    duration: fn(&[a_float]) -> a_float,
    random: &mut Random,
    rows: &mut Vec<Row>,
) {
    let moves: Vec<_> = moves
        .iter()
        .filter(|fields| duration(fields) > 0.0)
        .collect();
    let at_random: Vec<_> = moves
        .iter()
        .map(|fields| {
            (
                fields[..].into(),
                duration(fields) * random.between(0.0, 1.0) as a_float,
            )
        })
        .collect();
    let first: std::rc::Rc<[a_float]> = moves[0][..].into();
    let step = duration(&first) / moves.len() as a_float;
    let sweep = (0..moves.len())
        .map(|k| (first.clone(), k as a_float * step))
        .collect();
    for (case, moments) in [
        (format!("random, {place}"), at_random),
        (format!("sweep, {place}"), sweep),
    ] {
        for (index, name) in ["pos", "vel", "acc", "jer"]
            .iter()
            .enumerate()
            .take(family.functions().len())
        {
            rows.push(evaluation(
                format!("a_traj{}_{name}", family.name()),
                &case,
                &moments,
                |abi| abi.evaluations[family as usize][index],
            ));
        }
    }
}

type Moment = (std::rc::Rc<[a_float]>, a_float);

fn evaluation(
    function: String,
    case: &str,
    moments: &[Moment],
    of: impl Fn(&Abi<a_float>) -> Evaluate<a_float>,
) -> Row {
    let run = LIBRARIES.map(|abi| -> Box<dyn FnMut()> {
        let moments = moments.to_vec();
        let evaluate = black_box(of(abi));
        Box::new(move || {
            for (fields, x) in &moments {
                // SAFETY: the fields are those of the function's struct.
                black_box(unsafe { evaluate(fields.as_ptr(), *x) });
            }
        })
    });
    Row {
        function,
        case: case.into(),
        calls: moments.len(),
        run,
    }
}

/// The double-S of the README's table: from 0 to 10, with an initial velocity.
fn example() -> (Plan, a_float) {
    let fields = planned(Family::Bell, &[vec![30.0, 10.0, 5.0, 0.0, 10.0, 1.0, 0.0]]).remove(0);
    let duration = fields[0];
    (fields, duration)
}

/// `n` samples of all four quantities; the original's are four calls each.
fn samples(n: usize) -> Row {
    let (fields, duration) = example();
    let dt = duration / (n - 1) as a_float;
    let [_, o2, o3] = LIBRARIES;
    let four = |abi: &'static Abi<a_float>| four_calls(abi, fields.clone(), n, dt);
    let mut out = [const { Vec::new() }; 4].map(|_: Vec<a_float>| vec![0.0; n]);
    let (o2, o3) = (four(o2), four(o3));
    let ours = Box::new(move || {
        let [p, v, a, j] = out.each_mut().map(|out| out.as_mut_ptr());
        // SAFETY: the fields are those of a bell, and every output has `n` elements.
        unsafe { atraj_bell_sample(fields.as_ptr().cast(), 0.0, black_box(dt), n, p, v, a, j) };
        black_box(&out);
    });
    Row {
        function: "atraj_bell_sample".into(),
        case: format!("{n} samples"),
        calls: n,
        run: [ours, o2, o3],
    }
}

/// All four quantities at `n` times, a call each.
fn states(n: usize) -> Row {
    let (fields, duration) = example();
    let dt = duration / (n - 1) as a_float;
    let [_, o2, o3] = LIBRARIES;
    let (o2, o3) = (
        four_calls(o2, fields.clone(), n, dt),
        four_calls(o3, fields.clone(), n, dt),
    );
    let mut out = vec![[0.0 as a_float; 4]; n];
    let ours = Box::new(move || {
        for (k, [p, v, a, j]) in out.iter_mut().enumerate() {
            // SAFETY: the fields are those of a bell.
            unsafe { atraj_bell_state(fields.as_ptr().cast(), k as a_float * dt, p, v, a, j) };
        }
        black_box(&out);
    });
    Row {
        function: "atraj_bell_state".into(),
        case: format!("{n} samples"),
        calls: n,
        run: [ours, o2, o3],
    }
}

fn four_calls(abi: &Abi<a_float>, fields: Plan, n: usize, dt: a_float) -> Box<dyn FnMut()> {
    let functions: [Evaluate<a_float>; 4] = abi.evaluations[Family::Bell as usize]
        .try_into()
        .expect("four functions");
    let functions = black_box(functions);
    let mut out = [const { Vec::new() }; 4].map(|_: Vec<a_float>| vec![0.0; n]);
    Box::new(move || {
        let [p, v, a, j] = &mut out;
        let all = p.iter_mut().zip(v).zip(a).zip(j);
        for (k, (((p, v), a), j)) in all.enumerate() {
            let x = k as a_float * dt;
            for (y, function) in [p, v, a, j].into_iter().zip(functions) {
                // SAFETY: the fields are those of a bell.
                *y = unsafe { function(fields.as_ptr(), x) };
            }
        }
        black_box(&out);
    })
}
