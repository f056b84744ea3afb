//! The plans that never fail, beside the original's plans and beside those of the crate rsruckig: the same moves in the same
//! rounds.
//!
//! rsruckig plans one axis by its position interface, from the same ends and within the same limits. It computes in binary64 always.
//! Its trapezoid has an infinite jerk.

#![allow(clippy::useless_conversion)] // a_float may be f32

use crate::{OPTIMISED, Row, WARM, bells, instructions, measure, median, plan_all, trap};
use atraj::capi::a_float;
use oracle::liba::abi::{FASTEST, Gen7};
use rsruckig::prelude::*;
use std::cell::RefCell;
use std::hint::black_box;
use std::rc::Rc;
use std::time::Instant;
use support::{Family, Random, Real};

/// How often each plan is timed alone. The shortest time counts, so no other work on the machine does.
const REPEATS: usize = 41;

/// A row, and its plans one by one.
pub struct Race {
    pub row: Row,
    /// Lets the library of this number make the plan of this number.
    pub one: Box<dyn FnMut(usize, usize)>,
}

pub fn print_table() {
    println!(
        "| function | case | ours ns | -O2 ns | rsruckig ns | -O2/ours | rsruckig/ours | worst ours ns | -O2 | rsruckig | \
         worst/mean ours | instructions ours | -O2 | rsruckig |"
    );
    println!("|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
    let all = races();
    let first = crate::rows(WARM).len();
    for (index, (mut race, assert_agrees)) in (first..).zip(all) {
        assert_agrees();
        let rounds = measure::<3>(&mut race.row);
        let [ns, o2, ruckig] =
            [0, 1, 2].map(|library| median(rounds.iter().map(|turns| turns[library])));
        let [o2_ratio, ruckig_ratio] =
            [1, 2].map(|library| median(rounds.iter().map(|turns| turns[library] / turns[0])));
        let worst = [0, 1, 2].map(|library| race.worst(library));
        let counts = [0, 1, 2].map(|library| instructions(index, library, race.row.calls));
        println!(
            "| `{}` | {} | {ns:.2} | {o2:.2} | {ruckig:.2} | {o2_ratio:.2} | {ruckig_ratio:.2} | {:.0} | {:.0} | {:.0} | {:.2} | \
             {} | {} | {} |",
            race.row.function,
            race.row.case,
            worst[0],
            worst[1],
            worst[2],
            worst[0] / ns,
            counts[0],
            counts[1],
            counts[2],
        );
    }
}

pub fn rows() -> Vec<Row> {
    races().into_iter().map(|(race, _)| race.row).collect()
}

/// Fails if rsruckig's plans take another time than ours. It takes too long for every run under callgrind.
type AssertAgrees = Box<dyn FnOnce()>;

/// On the moves of `a_trajbell_gen` and of `a_trajtrap_gen`, and on moves whose ends have any velocity.
fn races() -> Vec<(Race, AssertAgrees)> {
    let mut random = Random(1);
    let bells = bells(WARM, &mut random);
    let traps = (0..WARM).map(|_| trap(&mut random)).collect();
    let any = (0..WARM).map(|_| with_any_ends(&mut random)).collect();
    let mut races: Vec<_> = bells
        .into_iter()
        .chain([("any v0 and v1", any)])
        .map(|(case, plans)| race(Family::Bell, case, plans))
        .collect();
    races.push(race(Family::Trap, "as a_trajtrap_gen", traps));
    races
}

/// A double-S between any two velocities within the limit. The original refuses some.
pub fn with_any_ends(random: &mut Random) -> Vec<a_float> {
    let [jm, am, vm] =
        [(10.0, 50.0), (4.0, 12.0), (2.0, 6.0)].map(|(lo, hi)| random.between(lo, hi));
    let p1 = random.between(-15.0, 15.0);
    let [v0, v1] = [(); 2].map(|()| random.between(-vm, vm));
    [jm, am, vm, 0.0, p1, v0, v1].map(|x| x as a_float).to_vec()
}

fn race(family: Family, case: &str, plans: Vec<Vec<a_float>>) -> (Race, AssertAgrees) {
    let (ours, original) = match family {
        Family::Bell => (FASTEST[0], OPTIMISED[0].bell),
        _ => (FASTEST[1], OPTIMISED[0].trap),
    };
    let plans: Rc<[[a_float; 7]]> = plans
        .iter()
        .map(|plan| plan[..].try_into().expect("7 arguments"))
        .collect();
    let ruckig = Rc::new(RefCell::new(Planner::new(family)));
    let assert_agrees = {
        let (plans, ruckig) = (plans.clone(), ruckig.clone());
        Box::new(move || ruckig.borrow_mut().assert_agrees(ours, &plans))
    };
    let calls = plans.len();
    let run = {
        let (plans, ruckig) = (plans.clone(), ruckig.clone());
        let mut fields = vec![[0.0; 14]; calls];
        Box::new(move |library: usize| match library {
            0 => plan_all::<0>(ours, &plans, &mut fields),
            1 => plan_all::<1>(original, &plans, &mut fields),
            _ => ruckig.borrow_mut().plan_all(&plans),
        })
    };
    let mut fields = [[0.0; 14]];
    let race = Race {
        row: Row {
            function: format!("atraj_{}_gen", family.name()),
            case: case.into(),
            calls,
            run,
        },
        one: Box::new(move |library, plan| {
            let plan = &plans[plan..=plan];
            match library {
                0 => plan_all::<0>(ours, plan, &mut fields),
                1 => plan_all::<1>(original, plan, &mut fields),
                _ => ruckig.borrow_mut().plan_all(plan),
            }
        }),
    };
    (race, assert_agrees)
}

impl Race {
    /// Nanoseconds of the longest of the plans. Passes over all plans time each one alone, so the processor cannot learn its
    /// branches.
    pub fn worst(&mut self, library: usize) -> f64 {
        let mut shortest = vec![f64::INFINITY; self.row.calls];
        for _ in 0..REPEATS {
            for (plan, shortest) in shortest.iter_mut().enumerate() {
                let start = Instant::now();
                (self.one)(library, plan);
                *shortest = shortest.min(start.elapsed().as_secs_f64() * 1e9);
            }
        }
        shortest.into_iter().fold(0.0, f64::max) - clock()
    }
}

/// Nanoseconds that reading the clock adds.
fn clock() -> f64 {
    (0..10_000)
        .map(|_| Instant::now().elapsed().as_secs_f64() * 1e9)
        .fold(f64::INFINITY, f64::min)
}

/// rsruckig with one axis.
struct Planner {
    family: Family,
    ruckig: Ruckig<1, ThrowErrorHandler>,
    input: InputParameter<1>,
    trajectory: Trajectory<1>,
}

impl Planner {
    fn new(family: Family) -> Self {
        Self {
            family,
            ruckig: Ruckig::new(None, 0.001),
            input: InputParameter::new(None),
            trajectory: Trajectory::new(None),
        }
    }

    #[inline(never)]
    fn plan_all(&mut self, plans: &[[a_float; 7]]) {
        for plan in plans {
            black_box(self.plan(plan));
        }
    }

    /// The duration.
    fn plan(&mut self, plan: &[a_float; 7]) -> f64 {
        let [first, second, third, p0, p1, v0, v1] = plan.map(f64::from);
        let input = &mut self.input;
        if self.family == Family::Bell {
            (input.max_jerk[0], input.max_acceleration[0]) = (first, second);
            input.max_velocity[0] = third;
        } else {
            input.max_velocity[0] = first;
            input.max_jerk[0] = f64::INFINITY;
            input.max_acceleration[0] = second;
            input.min_acceleration = Some(DataArrayOrVec::Stack([third]));
        }
        (input.current_position[0], input.target_position[0]) = (p0, p1);
        (input.current_velocity[0], input.target_velocity[0]) = (v0, v1);
        self.ruckig
            .calculate(input, &mut self.trajectory)
            .expect("a plan");
        self.trajectory.get_duration()
    }

    /// Both plan the fastest move, so both take the same time: a difference would be a mistake of this benchmark.
    fn assert_agrees(&mut self, ours: Gen7<a_float>, plans: &[[a_float; 7]]) {
        for plan in plans {
            let &[a, b, c, d, e, f, g] = plan;
            let mut fields = [0.0; 14];
            // SAFETY: no struct has more than 14 reals.
            let duration = unsafe { ours(fields.as_mut_ptr(), a, b, c, d, e, f, g) };
            let difference = self.plan(plan) - duration.widen();
            let rounding = a_float::EPSILON.widen().sqrt() * duration.widen();
            assert!(difference.abs() <= rounding, "{plan:?}: {difference:e}");
        }
    }
}
