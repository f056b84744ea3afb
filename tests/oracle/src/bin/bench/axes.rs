//! Several axes that arrive together, planned beside the crate rsruckig with as many axes, in the same rounds.

#![allow(clippy::useless_conversion)] // a_float may be f32

use crate::fastest::Race;
use crate::moves::{Case, Compare, Problem, Tally, cases, print_race};
use crate::{Row, WARM, align_code};
use atraj::capi::a_float;
use atraj::capi::atraj::*;
use rsruckig::prelude::*;
use std::cell::RefCell;
use std::hint::black_box;
use std::mem::MaybeUninit;
use std::rc::Rc;
use support::{Random, Real};

/// The sets of axes that share the time.
const SETS: usize = WARM / 4;

pub fn print_table(first: usize) {
    println!(
        "| function | case | ours ns | rsruckig ns | rsruckig/ours | worst ours ns | rsruckig | worst/mean ours | \
         instructions ours | rsruckig | errors of rsruckig | slower |"
    );
    println!("|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
    for (index, (race, compare)) in (first..).zip(races()) {
        print_race(index, race, &compare());
    }
}

pub fn rows() -> Vec<Row> {
    races().into_iter().map(|(race, _)| race.row).collect()
}

/// The limits and the ends of several axes.
struct Set<const N: usize> {
    limits: Vec<atraj_limits>,
    from: Vec<atraj_state>,
    to: Vec<atraj_state>,
}

impl<const N: usize> Set<N> {
    fn random(case: Case, random: &mut Random) -> Self {
        let mut set = Self {
            limits: Vec::new(),
            from: Vec::new(),
            to: Vec::new(),
        };
        for _ in 0..N {
            let Problem { limits, from, to } = Problem::random(case, random);
            set.limits.push(limits);
            set.from.push(from);
            set.to.push(to);
        }
        set
    }

    #[inline(always)]
    fn plan(&self, plan: Plan, axes: &mut MaybeUninit<[atraj_move; N]>) -> i32 {
        let [from, to] = [&self.from, &self.to].map(|states| states.as_ptr());
        let axes = axes.as_mut_ptr().cast();
        // SAFETY: all pointers point to `N` structs.
        unsafe { plan(axes, self.limits.as_ptr(), from, to, N, 0.0, 0.0) }
    }
}

type Plan = unsafe extern "C" fn(
    *mut atraj_move,
    *const atraj_limits,
    *const atraj_state,
    *const atraj_state,
    usize,
    a_float,
    a_float,
) -> i32;

fn races() -> Vec<(Race, Compare)> {
    let mut random = Random::seeded(3);
    let cases = cases();
    let [rest, _, _, accelerated, ..] = cases;
    let mut races = Vec::new();
    for (name, case) in [rest, accelerated] {
        races.push(race::<3>(name, case, &mut random));
        races.push(race::<6>(name, case, &mut random));
        races.push(race::<12>(name, case, &mut random));
    }
    races
}

fn race<const N: usize>(name: &str, case: Case, random: &mut Random) -> (Race, Compare) {
    let sets: Rc<[Set<N>]> = (0..SETS).map(|_| Set::random(case, random)).collect();
    let ruckig = Rc::new(RefCell::new(Planner::<N>::new()));
    let compare = {
        let (sets, ruckig) = (sets.clone(), ruckig.clone());
        Box::new(move || ruckig.borrow_mut().compare(&sets))
    };
    let run = {
        let (sets, ruckig) = (sets.clone(), ruckig.clone());
        Box::new(move |library: usize| plan_all(library, &sets, &ruckig))
    };
    let race = Race {
        row: Row {
            function: "atraj_moves_sync".into(),
            case: format!("{N} axes, {name}"),
            calls: SETS,
            run,
        },
        one: Box::new(move |library, plan| plan_all(library, &sets[plan..=plan], &ruckig)),
    };
    (race, compare)
}

/// Like a control loop, each library overwrites its last plans.
fn plan_all<const N: usize>(library: usize, sets: &[Set<N>], ruckig: &RefCell<Planner<N>>) {
    if library == 0 {
        plan_ours(sets);
    } else {
        ruckig.borrow_mut().plan_all(sets);
    }
}

#[inline(never)]
fn plan_ours<const N: usize>(sets: &[Set<N>]) {
    let plan = black_box(atraj_moves_sync as Plan);
    let mut axes = MaybeUninit::uninit();
    align_code();
    for set in sets {
        black_box(set.plan(plan, &mut axes));
    }
}

/// rsruckig with several axes.
struct Planner<const N: usize> {
    ruckig: Ruckig<N, ThrowErrorHandler>,
    input: InputParameter<N>,
    trajectory: Trajectory<N>,
}

impl<const N: usize> Planner<N> {
    fn new() -> Self {
        Self {
            ruckig: Ruckig::new(None, 0.001),
            input: InputParameter::new(None),
            trajectory: Trajectory::new(None),
        }
    }

    #[inline(never)]
    fn plan_all(&mut self, sets: &[Set<N>]) {
        for set in sets {
            black_box(self.plan(set));
        }
    }

    /// The duration, or nothing for an error.
    fn plan(&mut self, set: &Set<N>) -> Option<f64> {
        let Set { limits, from, to } = set;
        let input = &mut self.input;
        let lowest = |low: fn(&atraj_limits) -> a_float| {
            let lows = std::array::from_fn(|k| low(&limits[k]).into());
            Some(DataArrayOrVec::Stack(lows))
        };
        input.min_velocity = lowest(|limits| limits.vmin);
        input.min_acceleration = lowest(|limits| limits.amin);
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
        match self.ruckig.calculate(input, &mut self.trajectory) {
            Ok(RuckigResult::Working | RuckigResult::Finished) => {
                Some(self.trajectory.get_duration())
            }
            _ => None,
        }
    }

    /// Our plan is never an error, and never slower.
    fn compare(&mut self, sets: &[Set<N>]) -> Tally {
        let mut tally = Tally::default();
        for set in sets {
            let mut axes = MaybeUninit::uninit();
            let returned = set.plan(atraj_moves_sync, &mut axes);
            assert!(returned >= 0, "{returned}");
            // SAFETY: the plan is no error, so it has written the structs.
            let ours = unsafe { axes.assume_init() }[0].t.widen();
            tally.note(ours, self.plan(set));
        }
        tally
    }
}
