//! The moves from any state to any state: planned next to the crate rsruckig and Ruckig's C++, evaluated next to the double-S, in the same
//! rounds. Then several axes that arrive together, next to both with as many axes.
//!
//! Their limit of the jerk is the same in both directions, so ours is here too.

#![allow(clippy::useless_conversion)] // a_float may be f32

use crate::race::{Pass, Race, Tally};
use crate::ruckig;
use crate::{README, REAL, Row, Samples, WARM, align_code, instructions, sample_all, sampling, state_all, times};
use atraj::capi::a_float;
use atraj::capi::atraj::*;
use atraj::capi::trajbell::*;
use rsruckig::prelude::*;
use std::array::from_fn;
use std::hint::black_box;
use std::mem::MaybeUninit;
use std::rc::Rc;
use support::{Random, Real};

fn first() -> usize {
    crate::rows(WARM).len() + crate::fastest::rows().len()
}

const OURS: usize = 0; // the libraries of a race; 1 is Ruckig's C++
const RSRUCKIG: usize = 2;

pub fn print_plans() {
    let has_ruckig = ruckig::plan(1).is_some();
    if !has_ruckig {
        eprintln!("SKIPPED: Ruckig's C++ is not measured. RUCKIG=$(tests/ruckig.sh) builds it.");
    }
    println!(
        "real,function,case,ours ns,rsruckig ns,Ruckig ns,rsruckig/ours,Ruckig/ours,ours worst ns,rsruckig worst ns,ours worst/mean,\
         ours instructions,rsruckig instructions,rsruckig errors,rsruckig slower"
    );
    let (races, evaluations) = (races(), evaluations().len());
    let together = first() + races.len() + evaluations;
    for (index, mut race) in (first()..).zip(races).chain((together..).zip(self::together())) {
        let tally = (race.compare)();
        let (ns, ratios) = times::<3>(&mut race.row);
        let worst = [OURS, RSRUCKIG].map(|library| race.worst(library));
        let counts = [OURS, RSRUCKIG].map(|library| instructions(index, library, race.row.calls));
        let of_ruckig = |x: f64| {
            if has_ruckig { format!("{x:.2}") } else { "skipped".into() }
        };
        let (Row { function, case, .. }, Tally { errors, slower }) = (&race.row, tally);
        let ([ours, ruckig, theirs], [_, ruckig_ratio, ratio], [worst, worst_of_theirs]) = (ns, ratios, worst);
        let [ruckig, ruckig_ratio] = [ruckig, ruckig_ratio].map(of_ruckig);
        print!("{REAL},{function},\"{case}\",{ours:.2},{theirs:.2},{ruckig},{ratio:.2},{ruckig_ratio},");
        let [count, count_of_theirs] = counts;
        println!("{worst:.0},{worst_of_theirs:.0},{:.2},{count},{count_of_theirs},{errors},{slower}", worst / ours);
    }
}

pub fn print_evaluations() {
    println!("real,function,case,ours ns,double-S ns,double-S/ours,ours instructions,double-S instructions");
    for (index, mut row) in (first() + races().len()..).zip(evaluations()) {
        let ([ours, bell], [_, ratio]) = times(&mut row);
        let counts = [0, 1].map(|library| instructions(index, library, row.calls));
        println!("{REAL},{},\"{}\",{ours:.2},{bell:.2},{ratio:.2},{},{}", row.function, row.case, counts[0], counts[1],);
    }
}

pub fn rows() -> Vec<Row> {
    let of = |races: Vec<Race>| races.into_iter().map(|race| race.row);
    of(races()).chain(evaluations()).chain(of(together())).chain(alone()).chain(machine()).collect()
}

/// Planners that have no rival. Their instructions are counted, and no table has them.
fn alone() -> Vec<Row> {
    const FAR: a_float = a_float::INFINITY;
    let mut random = Random::seeded(4);
    let [_, _, _, (name, case), ..] = CASES;
    let one = case.problems::<1>(WARM / 4, &mut random);
    let three = case.problems::<3>(WARM / 4, &mut random);
    let start = atraj_state { p: 0.0, v: 0.0, a: 0.0 };
    let mut axis = MaybeUninit::uninit();
    // SAFETY: both pointers point to their structs, and the function writes the axis.
    let mut axis = unsafe {
        assert_eq!(atraj_axis_init(axis.as_mut_ptr(), 0.001, &start), 0);
        axis.assume_init()
    };
    // SAFETY of each call: all pointers point to as many structs and numbers as the planner takes.
    vec![
        lone("atraj_move_within", name.into(), &one, |ctx, l, from, to| unsafe {
            atraj_move_within(ctx, l, from, to, -FAR, FAR)
        }),
        lone("atraj_move_track", name.into(), &one, |ctx, l, from, to| unsafe {
            atraj_move_track(ctx, l, from, to, 0.0, 0.125)
        }),
        lone("atraj_axis_track", name.into(), &one, move |_, l, _, to| unsafe {
            atraj_axis_track(&mut axis, l, to, 0.0, 0.125, 1)
        }),
        lone("atraj_moves_sync_within", format!("3 axes, {name}"), &three, |ctx, l, from, to| unsafe {
            let (low, high) = ([-FAR; 3], [FAR; 3]);
            atraj_moves_sync_within(ctx, l, from, to, low.as_ptr(), high.as_ptr(), 3, 0.0, 0.0)
        }),
    ]
}

fn lone<const N: usize>(
    function: &str, case: String, problems: &Rc<[Problem<N>]>,
    mut plan: impl FnMut(Ctx, Limits, State, State) -> i32 + 'static,
) -> Row {
    let problems = problems.clone();
    Row::new(function, case, problems.len(), move |_| {
        let mut axes = MaybeUninit::uninit();
        for problem in &*problems {
            black_box(problem.plan(&mut plan, &mut axes));
        }
    })
}

struct Problem<const N: usize> {
    limits: [atraj_limits; N],
    from: [atraj_state; N],
    to: [atraj_state; N],
}

/// Each case has what the one before has, but the last has symmetric limits.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Case {
    AtRest,
    Moving,
    AcceleratedStart,
    AcceleratedTarget,
    Asymmetric,
    Outside,
}

const CASES: [(&str, Case); 6] = [
    ("at rest", Case::AtRest),
    ("moving", Case::Moving),
    ("accelerated start", Case::AcceleratedStart),
    ("accelerated start and target", Case::AcceleratedTarget),
    ("asymmetric", Case::Asymmetric),
    ("outside", Case::Outside),
];

impl Case {
    fn axis(self, random: &mut Random) -> (atraj_limits, atraj_state, atraj_state) {
        let [jm, am, vm] = [(10.0, 50.0), (4.0, 12.0), (2.0, 6.0)].map(|(lo, hi)| random.between(lo, hi));
        let mut part = || {
            if self == Self::Asymmetric { random.between(0.3, 1.0) } else { 1.0 }
        };
        let (amin, vmin) = (-am * part(), -vm * part());
        let mut state = |accelerated: bool, factor: f64| {
            let (mut a, mut v) = (0.0, 0.0);
            if accelerated {
                let most = am.min(-amin).min((jm * vm.min(-vmin)).sqrt());
                a = random.between(-0.9, 0.9) * most;
            }
            if self >= Self::Moving {
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
        let from = state(self >= Self::AcceleratedStart, if self == Self::Outside { 1.7 } else { 1.0 });
        let mut to = state(self >= Self::AcceleratedTarget, 1.0);
        to.p = from.p + (random.sign() * random.between(0.1, 15.0)) as a_float;
        let [vmax, vmin, amax, amin, jmax, jmin] = [vm, vmin, am, amin, jm, -jm].map(|limit| limit as a_float);
        (atraj_limits { vmax, vmin, amax, amin, jmax, jmin }, from, to)
    }

    fn problems<const N: usize>(self, count: usize, random: &mut Random) -> Rc<[Problem<N>]> {
        let mut problem = || {
            let (limits, from, to): (Vec<_>, Vec<_>, Vec<_>) = (0..N).map(|_| self.axis(random)).collect();
            Problem { limits: array(limits), from: array(from), to: array(to) }
        };
        (0..count).map(|_| problem()).collect()
    }
}

fn array<T, const N: usize>(all: Vec<T>) -> [T; N] {
    all.try_into().ok().expect("so many")
}

fn races() -> Vec<Race> {
    type Plan = unsafe extern "C" fn(Ctx, Limits, State, State) -> i32;
    let mut random = Random::seeded(1);
    let plan = black_box(atraj_move_plan as Plan);
    let race = |(name, case): (&str, Case)| {
        let problems = case.problems::<1>(WARM, &mut random);
        // SAFETY: all pointers point to their structs.
        race("atraj_move_plan", name.into(), problems, move |ctx, l, from, to| unsafe { plan(ctx, l, from, to) })
    };
    CASES.map(race).into()
}

fn together() -> Vec<Race> {
    let mut random = Random::seeded(3);
    let [rest, _, _, accelerated, ..] = CASES;
    let mut of = |case| [sync::<3>(case, &mut random), sync::<6>(case, &mut random), sync::<12>(case, &mut random)];
    [rest, accelerated].into_iter().flat_map(&mut of).collect()
}

fn sync<const N: usize>((name, case): (&str, Case), random: &mut Random) -> Race {
    type Plan = unsafe extern "C" fn(Ctx, Limits, State, State, usize, a_float, a_float) -> i32;
    let plan = black_box(atraj_moves_sync as Plan);
    let problems = case.problems::<N>(WARM / 4, random);
    let case = format!("{N} axes, {name}");
    // SAFETY: all pointers point to `N` structs.
    race("atraj_moves_sync", case, problems, move |ctx, l, from, to| unsafe { plan(ctx, l, from, to, N, 0.0, 0.0) })
}

type Ctx = *mut atraj_move;
type Limits = *const atraj_limits;
type State = *const atraj_state;

fn race<const N: usize>(
    function: &str, case: String, problems: Rc<[Problem<N>]>,
    plan: impl Fn(Ctx, Limits, State, State) -> i32 + Copy + 'static,
) -> Race {
    let ours: Pass<Problem<N>> = Box::new(move |problems| plan_ours(problems, plan));
    let duration = move |problem: &Problem<N>| {
        let mut axes = MaybeUninit::uninit();
        let returned = problem.plan(plan, &mut axes);
        assert!(returned >= 0, "{returned}: {:?}", problem.axes());
        // SAFETY: the plan is no error, so it has written the structs.
        let axes = unsafe { axes.assume_init() };
        axes[0].t.widen()
    };
    let ruckig: Pass<Problem<N>> = match ruckig::plan(N) {
        Some(plan) => Box::new(move |problems| plan_ruckig(problems, plan)),
        None => Box::new(|_| ()),
    };
    Race::new(function, case, problems, vec![ours, ruckig], duration, Problem::ask)
}

#[inline(never)]
fn plan_ours<const N: usize>(problems: &[Problem<N>], plan: impl Fn(Ctx, Limits, State, State) -> i32 + Copy) {
    let mut axes = MaybeUninit::uninit();
    align_code();
    for problem in problems {
        black_box(problem.plan(plan, &mut axes));
    }
}

#[inline(never)]
fn plan_ruckig<const N: usize>(problems: &[Problem<N>], plan: ruckig::Plan) {
    for problem in problems {
        let axes = problem.axes();
        // SAFETY: the function takes `N` axes.
        black_box(unsafe { plan(axes.as_ptr()) });
    }
}

impl<const N: usize> Problem<N> {
    #[inline(always)]
    fn plan(
        &self, plan: impl FnOnce(Ctx, Limits, State, State) -> i32, axes: &mut MaybeUninit<[atraj_move; N]>,
    ) -> i32 {
        let [from, to] = [&self.from, &self.to].map(|states| states.as_ptr());
        plan(axes.as_mut_ptr().cast(), self.limits.as_ptr(), from, to)
    }

    fn ask(&self, input: &mut InputParameter<N>) {
        let Self { limits, from, to } = self;
        let all = |low: fn(&atraj_limits) -> a_float| Some(DataArrayOrVec::Stack(from_fn(|k| low(&limits[k]).into())));
        input.min_velocity = all(|limits| limits.vmin);
        input.min_acceleration = all(|limits| limits.amin);
        for k in 0..N {
            input.max_velocity[k] = limits[k].vmax.into();
            input.max_acceleration[k] = limits[k].amax.into();
            input.max_jerk[k] = limits[k].jmax.into();
            input.current_position[k] = from[k].p.into();
            input.current_velocity[k] = from[k].v.into();
            input.current_acceleration[k] = from[k].a.into();
            input.target_position[k] = to[k].p.into();
            input.target_velocity[k] = to[k].v.into();
            input.target_acceleration[k] = to[k].a.into();
        }
    }

    fn axes(&self) -> [ruckig::Axis; N] {
        from_fn(|k| {
            let (l, from, to) = (&self.limits[k], &self.from[k], &self.to[k]);
            [l.vmax, l.vmin, l.amax, l.amin, l.jmax, from.p, from.v, from.a, to.p, to.v, to.a].map(f64::from)
        })
    }
}

const EVALUATED: usize = 512; // few enough that all moves stay in the cache

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

type Moment = (usize, a_float); // a move by its number, and a time
type Evaluate<C> = unsafe extern "C" fn(*const C, a_float) -> a_float;
const QUANTITIES: [(&str, Evaluate<atraj_move>, Evaluate<a_trajbell>); 4] = [
    ("atraj_move_pos", atraj_move_pos, a_trajbell_pos),
    ("atraj_move_vel", atraj_move_vel, a_trajbell_vel),
    ("atraj_move_acc", atraj_move_acc, a_trajbell_acc),
    ("atraj_move_jer", atraj_move_jer, a_trajbell_jer),
];

fn evaluations() -> Vec<Row> {
    let mut random = Random::seeded(2);
    let plans = (0..EVALUATED).map(|_| crate::fastest::with_any_ends(&mut random));
    let arguments: Vec<_> = plans.map(|plan| plan[..].try_into().expect("7 arguments")).collect();
    let both = Rc::new(Both::plan(&arguments));
    let at_random: Rc<[Moment]> =
        (0..EVALUATED).map(|k| (k, both.moves[k].t * random.between(0.0, 1.0) as a_float)).collect();
    let step = both.moves[0].t / EVALUATED as a_float;
    let sweep: Rc<[Moment]> = (0..EVALUATED).map(|k| (0, k as a_float * step)).collect();
    let mut rows = Vec::new();
    for (case, moments) in [("random", at_random), ("sweep", sweep)] {
        for (function, ours, bell) in QUANTITIES {
            let (both, moments) = (both.clone(), moments.clone());
            rows.push(Row::new(function, case, EVALUATED, move |library| match library {
                0 => evaluate_all(ours, &both.moves, &moments),
                _ => evaluate_all(bell, &both.bells, &moments),
            }));
        }
    }
    rows.extend(at_n_times(1024));
    rows
}

/// The steps of a motor, and a shaper of three impulses, over the move of the README. There is no other library.
fn machine() -> [Row; 2] {
    const STEPS: usize = 1024;
    let both = Rc::new(Both::plan(&[README]));
    let planned = both.clone();
    let steps = Row::new("atraj_steps_next", "1024 steps", STEPS, move |_| {
        let (of, mut steps, mut time) = (&planned.moves[0], MaybeUninit::uninit(), 0.0);
        let step = (of.phase[of.phases as usize].p - of.phase[0].p) / STEPS as a_float;
        // SAFETY: all pointers point to their structs, and `init` fills the steps.
        unsafe {
            atraj_steps_init(steps.as_mut_ptr(), of, of.phase[0].p, step);
            while black_box(atraj_steps_next(steps.as_mut_ptr(), of, &mut time)) != 0 {}
        }
    });
    let shaped = Row::new("atraj_shaper_state", "3 impulses, 1024 times", STEPS, move |_| {
        let (of, mut shaper, mut now) = (&both.moves[0], MaybeUninit::uninit(), MaybeUninit::uninit());
        let kind = atraj_shaper_kind::ATRAJ_SHAPER_EI as i32;
        // SAFETY: all pointers point to their structs, and `init` fills the shaper.
        unsafe {
            atraj_shaper_init(shaper.as_mut_ptr(), kind, 5.0, 0.0);
            for k in 0..STEPS {
                let x = of.t * k as a_float / STEPS as a_float;
                atraj_shaper_state(shaper.as_ptr(), of, x, now.as_mut_ptr());
                black_box(&now);
            }
        }
    });
    [steps, shaped]
}

#[inline(never)]
fn evaluate_all<C>(evaluate: Evaluate<C>, contexts: &[C], moments: &[Moment]) {
    let evaluate = black_box(evaluate);
    align_code();
    for &(context, x) in moments {
        // SAFETY: the function takes this struct.
        black_box(unsafe { evaluate(&contexts[context], x) });
    }
}

/// All four quantities at `n` times, one call for each time, and all in one call.
fn at_n_times(n: usize) -> [Row; 2] {
    let ours: AtOnce = |both, dt, out| state_all(atraj_move_state, &both.moves[0], dt, out);
    let states =
        at_once("atraj_move_state", n, ours, |both, dt, out| state_all(atraj_bell_state, &both.bells[0], dt, out));
    let ours: AtOnce = |both, dt, out| sample_all(atraj_move_sample, &both.moves[0], dt, out);
    let samples =
        at_once("atraj_move_sample", n, ours, |both, dt, out| sample_all(atraj_bell_sample, &both.bells[0], dt, out));
    [states, samples]
}

type AtOnce = fn(&Both, a_float, Samples);

fn at_once(function: &str, n: usize, ours: AtOnce, bell: AtOnce) -> Row {
    let both = Both::plan(&[README]);
    sampling(function, n, both.moves[0].t, move |library, dt, out| {
        [ours, bell][library](&both, dt, out);
    })
}
