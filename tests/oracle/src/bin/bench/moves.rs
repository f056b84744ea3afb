//! The moves from any state to any state: planned beside the crate rsruckig, evaluated beside the double-S, in the same rounds.
//!
//! rsruckig plans one axis by its position interface, and computes in binary64 always. Its limit of the jerk is the same in both
//! directions, so ours is here too.

#![allow(clippy::useless_conversion)] // a_float may be f32

use crate::fastest::Race;
use crate::{Row, WARM, align_code, instructions, measure, median};
use atraj::capi::a_float;
use atraj::capi::atraj::*;
use atraj::capi::trajbell::*;
use rsruckig::prelude::*;
use std::cell::RefCell;
use std::hint::black_box;
use std::mem::MaybeUninit;
use std::rc::Rc;
use support::{Random, Real};

pub fn print_tables() {
    let first = crate::rows(WARM).len() + crate::fastest::rows().len();
    let races = races();
    let evaluations = first + races.len();
    print_plans(first, races);
    println!();
    print_evaluations(evaluations);
    println!();
    crate::axes::print_table(first + rows().len());
}

fn print_plans(first: usize, races: Vec<(Race, Compare)>) {
    println!(
        "| function | case | ours ns | rsruckig ns | rsruckig/ours | worst ours ns | rsruckig | worst/mean ours | \
         instructions ours | rsruckig | errors of rsruckig | slower |"
    );
    println!("|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
    for (index, (race, compare)) in (first..).zip(races) {
        print_race(index, race, &compare());
    }
}

/// A row of a table of plans.
pub fn print_race(index: usize, mut race: Race, tally: &Tally) {
    let ([ours, ruckig], ratio) = times(&mut race.row);
    let worst = [0, 1].map(|library| race.worst(library));
    let counts = [0, 1].map(|library| instructions(index, library, race.row.calls));
    println!(
        "| `{}` | {} | {ours:.2} | {ruckig:.2} | {ratio:.2} | {:.0} | {:.0} | {:.2} | {} | {} | {} | {} |",
        race.row.function,
        race.row.case,
        worst[0],
        worst[1],
        worst[0] / ours,
        counts[0],
        counts[1],
        tally.errors,
        tally.slower,
    );
}

fn print_evaluations(first: usize) {
    println!(
        "| function | case | ours ns | double-S ns | double-S/ours | instructions ours | double-S |"
    );
    println!("|---|---|---:|---:|---:|---:|---:|");
    for (index, mut row) in (first..).zip(evaluations()) {
        let ([ours, bell], ratio) = times(&mut row);
        let counts = [0, 1].map(|library| instructions(index, library, row.calls));
        println!(
            "| `{}` | {} | {ours:.2} | {bell:.2} | {ratio:.2} | {} | {} |",
            row.function, row.case, counts[0], counts[1],
        );
    }
}

/// Nanoseconds of both, and the second one divided by ours.
fn times(row: &mut Row) -> ([f64; 2], f64) {
    let rounds = measure::<2>(row);
    let ns = [0, 1].map(|library| median(rounds.iter().map(|turns| turns[library])));
    (ns, median(rounds.iter().map(|[ours, other]| other / ours)))
}

pub fn rows() -> Vec<Row> {
    let plans = races().into_iter().map(|(race, _)| race.row);
    plans.chain(evaluations()).collect()
}

pub struct Problem {
    pub limits: atraj_limits,
    pub from: atraj_state,
    pub to: atraj_state,
}

/// What problems have besides displacements.
#[derive(Clone, Copy, Default)]
pub struct Case {
    moving: bool,
    accelerated_start: bool,
    accelerated_target: bool,
    asymmetric: bool,
    outside: bool,
}

pub fn cases() -> [(&'static str, Case); 6] {
    let rest = Case::default();
    let moving = Case {
        moving: true,
        ..rest
    };
    let start = Case {
        accelerated_start: true,
        ..moving
    };
    let target = Case {
        accelerated_target: true,
        ..start
    };
    let asymmetric = Case {
        asymmetric: true,
        ..target
    };
    let outside = Case {
        outside: true,
        ..target
    };
    [
        ("at rest", rest),
        ("moving", moving),
        ("accelerated start", start),
        ("accelerated start and target", target),
        ("asymmetric", asymmetric),
        ("outside", outside),
    ]
}

impl Problem {
    pub fn random(case: Case, random: &mut Random) -> Self {
        let [jm, am, vm] =
            [(10.0, 50.0), (4.0, 12.0), (2.0, 6.0)].map(|(lo, hi)| random.between(lo, hi));
        let mut part = || {
            if case.asymmetric {
                random.between(0.3, 1.0)
            } else {
                1.0
            }
        };
        let (amin, vmin) = (-am * part(), -vm * part());
        let mut state = |accelerated: bool, factor: f64| {
            let (mut a, mut v) = (0.0, 0.0);
            if accelerated {
                let most = am.min(-amin).min((jm * vm.min(-vmin)).sqrt());
                a = random.between(-0.9, 0.9) * most;
            }
            if case.moving {
                // So the velocity stays inside while the acceleration comes from 0 or goes back to 0.
                let room = 1.001 * a * a / (2.0 * jm);
                v = random.between(vmin + room, vm - room);
            }
            atraj_state {
                p: random.between(-5.0, 5.0) as a_float,
                v: (factor * v) as a_float,
                a: (factor * a) as a_float,
            }
        };
        let from = state(case.accelerated_start, if case.outside { 1.7 } else { 1.0 });
        let mut to = state(case.accelerated_target, 1.0);
        to.p = from.p + (random.sign() * random.between(0.1, 15.0)) as a_float;
        let [vmax, vmin, amax, amin, jmax, jmin] =
            [vm, vmin, am, amin, jm, -jm].map(|limit| limit as a_float);
        let limits = atraj_limits {
            vmax,
            vmin,
            amax,
            amin,
            jmax,
            jmin,
        };
        Self { limits, from, to }
    }

    #[inline(always)]
    fn plan(&self, plan: Plan, ctx: &mut MaybeUninit<atraj_move>) -> i32 {
        // SAFETY: all pointers point to their structs.
        unsafe { plan(ctx.as_mut_ptr(), &self.limits, &self.from, &self.to) }
    }
}

type Plan = unsafe extern "C" fn(
    *mut atraj_move,
    *const atraj_limits,
    *const atraj_state,
    *const atraj_state,
) -> i32;

/// Plans of rsruckig that are errors, and plans that take longer than ours.
#[derive(Default)]
pub struct Tally {
    errors: usize,
    slower: usize,
}

impl Tally {
    /// Notes our duration and that of rsruckig, which is nothing for an error. Ours is never longer.
    pub fn note(&mut self, ours: f64, ruckig: Option<f64>) {
        let Some(duration) = ruckig else {
            self.errors += 1;
            return;
        };
        let rounding = a_float::EPSILON.widen().sqrt() * duration;
        assert!(ours <= duration + rounding, "{ours:e} > {duration:e}");
        self.slower += usize::from(duration > ours + rounding);
    }
}

/// Plans with both. It takes too long for every run under callgrind.
pub type Compare = Box<dyn FnOnce() -> Tally>;

fn races() -> Vec<(Race, Compare)> {
    let mut random = Random::seeded(1);
    cases()
        .into_iter()
        .map(|(name, case)| {
            let problems = (0..WARM)
                .map(|_| Problem::random(case, &mut random))
                .collect();
            race(name, problems)
        })
        .collect()
}

fn race(case: &str, problems: Rc<[Problem]>) -> (Race, Compare) {
    let ruckig = Rc::new(RefCell::new(Planner::new()));
    let compare = {
        let (problems, ruckig) = (problems.clone(), ruckig.clone());
        Box::new(move || ruckig.borrow_mut().compare(&problems))
    };
    let calls = problems.len();
    let run = {
        let (problems, ruckig) = (problems.clone(), ruckig.clone());
        Box::new(move |library: usize| plan_all(library, &problems, &ruckig))
    };
    let race = Race {
        row: Row {
            function: "atraj_move_plan".into(),
            case: case.into(),
            calls,
            run,
        },
        one: Box::new(move |library, plan| plan_all(library, &problems[plan..=plan], &ruckig)),
    };
    (race, compare)
}

/// Like a control loop, each library overwrites its last plan.
fn plan_all(library: usize, problems: &[Problem], ruckig: &RefCell<Planner>) {
    if library == 0 {
        plan_ours(problems);
    } else {
        ruckig.borrow_mut().plan_all(problems);
    }
}

#[inline(never)]
fn plan_ours(problems: &[Problem]) {
    let plan = black_box(atraj_move_plan as Plan);
    let mut ctx = MaybeUninit::uninit();
    align_code();
    for problem in problems {
        black_box(problem.plan(plan, &mut ctx));
    }
}

/// rsruckig with one axis.
struct Planner {
    ruckig: Ruckig<1, ThrowErrorHandler>,
    input: InputParameter<1>,
    trajectory: Trajectory<1>,
}

impl Planner {
    fn new() -> Self {
        Self {
            ruckig: Ruckig::new(None, 0.001),
            input: InputParameter::new(None),
            trajectory: Trajectory::new(None),
        }
    }

    #[inline(never)]
    fn plan_all(&mut self, problems: &[Problem]) {
        for problem in problems {
            black_box(self.plan(problem));
        }
    }

    /// The duration, or nothing for an error.
    fn plan(&mut self, problem: &Problem) -> Option<f64> {
        let Problem { limits, from, to } = problem;
        let input = &mut self.input;
        input.max_velocity[0] = limits.vmax.into();
        input.min_velocity = Some(DataArrayOrVec::Stack([limits.vmin.into()]));
        input.max_acceleration[0] = limits.amax.into();
        input.min_acceleration = Some(DataArrayOrVec::Stack([limits.amin.into()]));
        input.max_jerk[0] = limits.jmax.into();
        input.current_position[0] = from.p.into();
        input.current_velocity[0] = from.v.into();
        input.current_acceleration[0] = from.a.into();
        input.target_position[0] = to.p.into();
        input.target_velocity[0] = to.v.into();
        input.target_acceleration[0] = to.a.into();
        match self.ruckig.calculate(input, &mut self.trajectory) {
            Ok(RuckigResult::Working | RuckigResult::Finished) => {
                Some(self.trajectory.get_duration())
            }
            _ => None,
        }
    }

    /// Our plan is never an error, and never slower.
    fn compare(&mut self, problems: &[Problem]) -> Tally {
        let mut tally = Tally::default();
        for problem in problems {
            let mut ctx = MaybeUninit::uninit();
            let returned = problem.plan(atraj_move_plan, &mut ctx);
            assert!(returned >= 0, "{returned}: {problem:?}");
            // SAFETY: the plan is no error, so it has written the struct.
            let ours = unsafe { ctx.assume_init() }.t.widen();
            tally.note(ours, self.plan(problem));
        }
        tally
    }
}

impl std::fmt::Debug for Problem {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let l = &self.limits;
        write!(
            f,
            "limits {:?}",
            [l.vmax, l.vmin, l.amax, l.amin, l.jmax, l.jmin]
        )?;
        [("from", &self.from), ("to", &self.to)]
            .iter()
            .try_for_each(|(name, s)| write!(f, ", {name} {:?}", [s.p, s.v, s.a]))
    }
}

/// Few enough that all moves stay in the cache.
const EVALUATED: usize = 512;

/// The same motion as a move and as a double-S.
struct Both {
    moves: Vec<atraj_move>,
    bells: Vec<a_trajbell>,
}

impl Both {
    fn plan(arguments: &[[a_float; 7]]) -> Self {
        let plan = |&[jm, am, vm, p0, p1, v0, v1]: &[a_float; 7]| {
            let (mut limits, mut ctx) = (MaybeUninit::uninit(), MaybeUninit::uninit());
            let mut bell = MaybeUninit::uninit();
            let [from, to] = [(p0, v0), (p1, v1)].map(|(p, v)| atraj_state { p, v, a: 0.0 });
            // SAFETY: all pointers point to their structs, and the plans write them.
            unsafe {
                atraj_limits_init(limits.as_mut_ptr(), jm, am, vm);
                let limits = limits.assume_init();
                assert!(atraj_move_plan(ctx.as_mut_ptr(), &limits, &from, &to) >= 0);
                atraj_bell_gen(bell.as_mut_ptr(), jm, am, vm, p0, p1, v0, v1);
                (ctx.assume_init(), bell.assume_init())
            }
        };
        let (moves, bells) = arguments.iter().map(plan).unzip();
        Self { moves, bells }
    }
}

/// A move by its number, and a time.
type Moment = (usize, a_float);
type Evaluate<C> = unsafe extern "C" fn(*const C, a_float) -> a_float;
type State<C> =
    unsafe extern "C" fn(*const C, a_float, *mut a_float, *mut a_float, *mut a_float, *mut a_float);
type Sample<C> = unsafe extern "C" fn(
    *const C,
    a_float,
    a_float,
    usize,
    *mut a_float,
    *mut a_float,
    *mut a_float,
    *mut a_float,
) -> usize;

const QUANTITIES: [(&str, Evaluate<atraj_move>, Evaluate<a_trajbell>); 4] = [
    ("atraj_move_pos", atraj_move_pos, a_trajbell_pos),
    ("atraj_move_vel", atraj_move_vel, a_trajbell_vel),
    ("atraj_move_acc", atraj_move_acc, a_trajbell_acc),
    ("atraj_move_jer", atraj_move_jer, a_trajbell_jer),
];

fn evaluations() -> Vec<Row> {
    let mut random = Random::seeded(2);
    let arguments: Vec<_> = (0..EVALUATED)
        .map(|_| crate::fastest::with_any_ends(&mut random))
        .map(|plan| plan[..].try_into().expect("7 arguments"))
        .collect();
    let both = Rc::new(Both::plan(&arguments));
    let at_random: Rc<[Moment]> = (0..EVALUATED)
        .map(|k| (k, both.moves[k].t * random.between(0.0, 1.0) as a_float))
        .collect();
    let step = both.moves[0].t / EVALUATED as a_float;
    let sweep: Rc<[Moment]> = (0..EVALUATED).map(|k| (0, k as a_float * step)).collect();
    let mut rows = Vec::new();
    for (case, moments) in [("random", at_random), ("sweep", sweep)] {
        for (function, ours, bell) in QUANTITIES {
            let (both, moments) = (both.clone(), moments.clone());
            let run = Box::new(move |library: usize| match library {
                0 => evaluate_all(ours, &both.moves, &moments),
                _ => evaluate_all(bell, &both.bells, &moments),
            });
            rows.push(Row {
                function: function.into(),
                case: case.into(),
                calls: EVALUATED,
                run,
            });
        }
    }
    rows.extend([states(1024), samples(1024)]);
    rows
}

/// Each library has its own copy of this loop.
#[inline(never)]
fn evaluate_all<C>(evaluate: Evaluate<C>, contexts: &[C], moments: &[Moment]) {
    let evaluate = black_box(evaluate);
    align_code();
    for &(context, x) in moments {
        // SAFETY: the function takes this struct.
        black_box(unsafe { evaluate(&contexts[context], x) });
    }
}

/// All four quantities at `n` times, one call for each time.
fn states(n: usize) -> Row {
    at_once(
        "atraj_move_state",
        n,
        |both, dt, out| state_all(atraj_move_state, &both.moves[0], dt, out),
        |both, dt, out| state_all(atraj_bell_state, &both.bells[0], dt, out),
    )
}

#[inline(never)]
fn state_all<C>(state: State<C>, context: &C, dt: a_float, [p, v, a, j]: [&mut [a_float]; 4]) {
    let state = black_box(state);
    align_code();
    let all = p.iter_mut().zip(v).zip(a).zip(j);
    for (k, (((p, v), a), j)) in all.enumerate() {
        // SAFETY: the function takes this struct.
        unsafe { state(context, k as a_float * dt, p, v, a, j) };
    }
}

/// All four quantities at `n` times in one call.
fn samples(n: usize) -> Row {
    at_once(
        "atraj_move_sample",
        n,
        |both, dt, out| sample_all(atraj_move_sample, &both.moves[0], dt, out),
        |both, dt, out| sample_all(atraj_bell_sample, &both.bells[0], dt, out),
    )
}

#[inline(never)]
fn sample_all<C>(sample: Sample<C>, context: &C, dt: a_float, out: [&mut [a_float]; 4]) {
    let n = out[0].len();
    let [p, v, a, j] = out.map(|out| out.as_mut_ptr());
    // SAFETY: the function takes this struct, and every output has `n` elements.
    unsafe { black_box(sample)(context, 0.0, dt, n, p, v, a, j) };
}

type AtOnce = fn(&Both, a_float, [&mut [a_float]; 4]);

/// The double-S of the README's table, from 0 to 10 with an initial velocity, into arrays that begin at cache lines.
fn at_once(function: &str, n: usize, ours: AtOnce, bell: AtOnce) -> Row {
    let both = Both::plan(&[[30.0, 10.0, 5.0, 0.0, 10.0, 1.0, 0.0]]);
    let dt = both.moves[0].t / (n - 1) as a_float;
    let mut memory = vec![0.0; 4 * n + 16];
    let start = memory.as_ptr().align_offset(64);
    let run = Box::new(move |library: usize| {
        let mut rows = memory[start..].chunks_exact_mut(n);
        let out = [(); 4].map(|()| rows.next().expect("four rows"));
        [ours, bell][library](&both, dt, out);
        black_box(&memory);
    });
    Row {
        function: function.into(),
        case: format!("{n} samples"),
        calls: n,
        run,
    }
}
