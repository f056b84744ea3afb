//! The double-S plan written a second time, step by step as the numerical contract has it, and never optimised. It counts
//! the rounds of the search without cruise, which no library tells.

use crate::prelude::*;
use crate::profiles::bell_planned;

#[derive(Clone, Copy, Debug)]
pub struct Plan<R> {
    pub duration: R,   // the duration; 0 where the plan fails
    pub rounds: u32,   // rounds of the search; 0 with a cruise phase or if [`Plan::endless`]
    pub endless: bool, // the original would never return: `am` is infinite and there is no cruise phase
}

pub fn plan<R: Real>(arguments: &[R], fields: &mut [R]) -> Plan<R> {
    bell_planned(fields, |bell| steps(bell, arguments.try_into().expect("seven arguments")))
}

fn steps<R: Real>(bell: &mut Bell<R>, arguments: [R; 7]) -> Plan<R> {
    let [jm, am, vm, mut p0, mut p1, v0, v1] = arguments;
    let [zero, half, one, two] = [0.0, 0.5, 1.0, 2.0].map(R::of);

    // 1
    let jm = negate_if_negative(jm);
    let am = negate_if_negative(am);
    let vm = negate_if_negative(vm);
    let mut v0 = clamp(v0, -vm, vm);
    let mut v1 = clamp(v1, -vm, vm);
    (bell.p0, bell.p1, bell.v0, bell.v1) = (p0, p1, v0, v1);

    // 2
    if p0 > p1 {
        (p0, p1, v0, v1) = (-p0, -p1, -v0, -v1);
    }
    bell.vm = vm;
    bell.jm = jm;
    let a = am * am;

    // 3, 4
    let ramp = |change: R| {
        if change * jm < a {
            let tj = (change / jm).square_root();
            (tj, two * tj, jm * tj)
        } else {
            let tj = am / jm;
            (tj, tj + change / am, am)
        }
    };
    let deceleration;
    (bell.taj, bell.ta, bell.am) = ramp(vm - v0);
    (bell.tdj, bell.td, deceleration) = ramp(vm - v1);
    bell.dm = -deceleration;

    // 5
    let p = p1 - p0;
    bell.tv = ((p / vm) - ((half * bell.ta) * (one + v0 / vm))) - ((half * bell.td) * (one + v1 / vm));

    // 6
    let mut rounds = 0;
    let mut planned = true;
    let mut endless = false;
    let cruise = bell.tv > zero;
    if !cruise {
        (bell.tv, bell.am, bell.dm) = (zero, am, am * R::of(1.0 / 16.0));
        endless = am == R::of(f64::INFINITY);
        (planned, rounds) = if endless { (false, 0) } else { search(bell, am, p, v0, v1) };
    }

    // 7, 8
    bell.t = if planned { (bell.ta + bell.tv) + bell.td } else { zero };
    Plan { duration: bell.t, rounds, endless }
}

/// The search of step 6 for an acceleration whose two ramps fit into the distance `p`, beginning at `am`: whether it is
/// found, and after how many rounds. The fields `am` and `dm` of `bell` hold `am` and `am/16`.
fn search<R: Real>(bell: &mut Bell<R>, mut am: R, p: R, v0: R, v1: R) -> (bool, u32) {
    let [zero, two, four] = [0.0, 2.0, 4.0].map(R::of);
    let jm = bell.jm;
    let a2v0 = two * v0;
    let a2v1 = two * v1;
    let s = v0 + v1;
    let q = two * (v0 * v0 + v1 * v1);
    let mut step = am;
    let mut rounds = 0;
    loop {
        rounds += 1;
        let settled = am == bell.am || step < bell.dm;
        let tj = am / jm;
        let tj2 = two * tj;
        bell.taj = tj;
        bell.tdj = tj;
        let k = am * tj;
        let r = (k * k + q) + (four * p - tj2 * s) * am;
        let k = k + r.square_root();
        let den = two * am;
        bell.ta = (k - a2v0) / den;
        let is_down = bell.ta < zero;
        if !is_down {
            bell.td = (k - a2v1) / den;
        }
        let is_up = !is_down && bell.td < zero;
        let fits = !is_down && !is_up && bell.ta >= tj2 && bell.td >= tj2;
        if settled && is_down {
            return (down_only(bell, p, v0, v1), rounds);
        } else if settled && is_up {
            return (up_only(bell, p, v0, v1), rounds);
        } else if settled && fits {
            (bell.am, bell.dm) = (am, -am);
            bell.vm = v0 + bell.am * (bell.ta - tj);
            return (true, rounds);
        }
        step = step * R::of(0.5);
        am = if is_down || is_up || fits { am + step } else { am - step };
        let go_on = step > R::MACHINE_EPSILON;
        if !go_on {
            return (false, rounds);
        }
    }
}

/// The one ramp of a move that only brakes or only accelerates, by `rise` over the displacement `p`: the time of its jerk, if there is one.
fn jerk_of_one_ramp<R: Real>(jm: R, p: R, s: R, rise: R) -> Option<R> {
    let m = jm * p;
    let w = jm * (m * p + (rise * s) * s);
    if w < R::ZERO { None } else { Some((m - w.square_root()) / (jm * s)) }
}

fn down_only<R: Real>(bell: &mut Bell<R>, p: R, v0: R, v1: R) -> bool {
    let s = v0 + v1;
    (bell.ta, bell.taj, bell.td) = (R::ZERO, R::ZERO, (R::of(2.0) * p) / s);
    let Some(tdj) = jerk_of_one_ramp(bell.jm, p, s, v1 - v0) else { return false };
    (bell.tdj, bell.am, bell.dm) = (tdj, R::ZERO, (-bell.jm) * tdj);
    bell.vm = v0;
    true
}

fn up_only<R: Real>(bell: &mut Bell<R>, p: R, v0: R, v1: R) -> bool {
    let s = v0 + v1;
    (bell.td, bell.tdj, bell.ta) = (R::ZERO, R::ZERO, (R::of(2.0) * p) / s);
    let Some(taj) = jerk_of_one_ramp(bell.jm, p, s, v0 - v1) else { return false };
    (bell.taj, bell.am, bell.dm) = (taj, bell.jm * taj, R::ZERO);
    bell.vm = v0 + bell.am * (bell.ta - bell.taj);
    true
}

fn negate_if_negative<R: Real>(x: R) -> R {
    if x < R::of(0.0) { -x } else { x }
}

fn clamp<R: Real>(x: R, lo: R, hi: R) -> R {
    if lo < x { if x < hi { x } else { hi } } else { lo }
}
