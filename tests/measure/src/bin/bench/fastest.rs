//! The plans that never fail, next to the original's plans and to those of the crate rsruckig: the same moves in the same rounds.
//!
//! rsruckig plans one axis by its position interface, from the same ends and within the same limits. It computes in binary64 always.
//! Its trapezoid has an infinite jerk.

#![allow(clippy::useless_conversion)] // a_float may be f32

use crate::race::{Pass, Race};
use crate::{OPTIMISED, REAL, Row, WARM, bells, instructions, plan_all, times, trap};
use atraj::capi::a_float;
use oracle::liba::FASTEST;
use rsruckig::prelude::*;
use std::cell::RefCell;
use support::{Family, Random, Real};

pub fn print_table() {
    println!(
        "real,function,case,ours ns,-O2 ns,rsruckig ns,-O2/ours,rsruckig/ours,ours worst ns,-O2 worst ns,rsruckig worst ns,\
         ours worst/mean,ours instructions,-O2 instructions,rsruckig instructions"
    );
    let first = crate::rows(WARM).len();
    for (index, mut race) in (first..).zip(races()) {
        // Both plan the fastest move, so both take the same time: a difference would be a mistake of this benchmark.
        let tally = (race.compare)();
        assert_eq!((tally.errors, tally.slower), (0, 0), "{}", race.row.case);
        let ([ns, o2, ruckig], [_, o2_ratio, ruckig_ratio]) = times(&mut race.row);
        let [worst, worst_o2, worst_ruckig] = [0, 1, 2].map(|library| race.worst(library));
        let [count, count_o2, count_ruckig] = [0, 1, 2].map(|library| instructions(index, library, race.row.calls));
        let Row { function, case, .. } = &race.row;
        print!("{REAL},{function},\"{case}\",{ns:.2},{o2:.2},{ruckig:.2},{o2_ratio:.2},{ruckig_ratio:.2},");
        let of_mean = worst / ns;
        println!("{worst:.0},{worst_o2:.0},{worst_ruckig:.0},{of_mean:.2},{count},{count_o2},{count_ruckig}");
    }
}

pub fn rows() -> Vec<Row> {
    races().into_iter().map(|race| race.row).collect()
}

/// On the moves of `a_trajbell_gen` and of `a_trajtrap_gen`, and on moves whose ends have any velocity.
fn races() -> Vec<Race> {
    let mut random = Random(1);
    let bells = bells(WARM, &mut random);
    let traps = (0..WARM).map(|_| trap(&mut random)).collect();
    let any = (0..WARM).map(|_| with_any_ends(&mut random)).collect();
    let of_bells = bells.into_iter().chain([("any v0 and v1", any)]);
    let of_bells = of_bells.map(|(case, plans)| race(Family::Bell, case, plans));
    of_bells.chain([race(Family::Trap, "as a_trajtrap_gen", traps)]).collect()
}

pub fn with_any_ends(random: &mut Random) -> Vec<a_float> {
    let [jm, am, vm] = [(10.0, 50.0), (4.0, 12.0), (2.0, 6.0)].map(|(lo, hi)| random.between(lo, hi));
    let p1 = random.between(-15.0, 15.0);
    let [v0, v1] = [(); 2].map(|()| random.between(-vm, vm));
    [jm, am, vm, 0.0, p1, v0, v1].map(|x| x as a_float).to_vec()
}

fn race(family: Family, case: &str, plans: Vec<Vec<a_float>>) -> Race {
    let is_bell = family == Family::Bell;
    let (ours, original) = if is_bell { (FASTEST[0], OPTIMISED[0].bell) } else { (FASTEST[1], OPTIMISED[0].trap) };
    let plans = plans.iter().map(|p| p[..].try_into().expect("7 arguments"));
    let fields = || RefCell::new(vec![[0.0; 14]; WARM]);
    let [of_ours, of_original] = [fields(), fields()];
    let passes: Vec<Pass<[a_float; 7]>> = vec![
        Box::new(move |plans| plan_all::<0>(ours, plans, &mut of_ours.borrow_mut())),
        Box::new(move |plans| plan_all::<1>(original, plans, &mut of_original.borrow_mut())),
    ];
    let duration = move |&[a, b, c, d, e, f, g]: &[a_float; 7]| {
        let mut fields = [0.0; 14];
        // SAFETY: no struct has more than 14 reals.
        unsafe { ours(fields.as_mut_ptr(), a, b, c, d, e, f, g) }.widen()
    };
    let ask = move |plan: &[a_float; 7], input: &mut InputParameter<1>| {
        let [first, second, third, p0, p1, v0, v1] = plan.map(f64::from);
        if is_bell {
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
    };
    Race::new(&format!("atraj_{}_gen", family.name()), case.into(), plans.collect(), passes, duration, ask)
}
