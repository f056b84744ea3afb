//! The double-S plan written a second time, step by step as the numerical contract has it, and never optimised. It counts
//! the rounds of the search without cruise, which no library tells.

use crate::profiles::{bell, bell_fields};
use crate::real::Real;
use atraj::Bell;

#[derive(Clone, Copy, Debug)]
pub struct Plan<R> {
    pub duration: R,   // the duration; 0 where the plan fails
    pub rounds: u32,   // rounds of the search; 0 with a cruise phase or if [`Plan::endless`]
    pub endless: bool, // the original would never return: `am` is infinite and there is no cruise phase
}

pub fn plan<R: Real>(arguments: &[R], fields: &mut [R]) -> Plan<R> {
    let mut bell = bell(fields);
    let plan = steps(&mut bell, arguments.try_into().expect("seven arguments"));
    fields.copy_from_slice(&bell_fields(&bell));
    plan
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
    bell.p0 = p0;
    bell.p1 = p1;
    bell.v0 = v0;
    bell.v1 = v1;

    // 2
    if p0 > p1 {
        p0 = -p0;
        p1 = -p1;
        v0 = -v0;
        v1 = -v1;
    }
    bell.vm = vm;
    bell.jm = jm;
    let a = am * am;

    // 3
    let d = vm - v0;
    if d * jm < a {
        bell.taj = (d / jm).square_root();
        bell.ta = two * bell.taj;
        bell.am = jm * bell.taj;
    } else {
        bell.taj = am / jm;
        bell.ta = bell.taj + d / am;
        bell.am = am;
    }

    // 4
    let e = vm - v1;
    if e * jm < a {
        bell.tdj = (e / jm).square_root();
        bell.td = two * bell.tdj;
        bell.dm = (-jm) * bell.tdj;
    } else {
        bell.tdj = am / jm;
        bell.td = bell.tdj + e / am;
        bell.dm = -am;
    }

    // 5
    let p = p1 - p0;
    bell.tv = ((p / vm) - ((half * bell.ta) * (one + v0 / vm))) - ((half * bell.td) * (one + v1 / vm));

    // 6
    let mut rounds = 0;
    let mut planned = true;
    let mut endless = false;
    let cruise = bell.tv > zero;
    if !cruise {
        bell.tv = zero;
        bell.am = am;
        bell.dm = am * R::of(1.0 / 16.0);
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
        let raise = if bell.ta < zero {
            if settled {
                return (down_only(bell, p, v0, v1), rounds);
            }
            true
        } else {
            bell.td = (k - a2v1) / den;
            if bell.td < zero {
                if settled {
                    return (up_only(bell, p, v0, v1), rounds);
                }
                true
            } else if bell.ta >= tj2 && bell.td >= tj2 {
                if settled {
                    bell.am = am;
                    bell.dm = -am;
                    bell.vm = v0 + bell.am * (bell.ta - tj);
                    return (true, rounds);
                }
                true
            } else {
                false
            }
        };
        step = step * R::of(0.5);
        am = if raise { am + step } else { am - step };
        let go_on = step > R::MACHINE_EPSILON;
        if !go_on {
            return (false, rounds);
        }
    }
}

fn down_only<R: Real>(bell: &mut Bell<R>, p: R, v0: R, v1: R) -> bool {
    let zero = R::of(0.0);
    let s = v0 + v1;
    bell.ta = zero;
    bell.taj = zero;
    bell.td = (R::of(2.0) * p) / s;
    let m = bell.jm * p;
    let w = bell.jm * (m * p + ((v1 - v0) * s) * s);
    if w < zero {
        return false;
    }
    bell.tdj = (m - w.square_root()) / (bell.jm * s);
    bell.am = zero;
    bell.dm = (-bell.jm) * bell.tdj;
    bell.vm = v0;
    true
}

fn up_only<R: Real>(bell: &mut Bell<R>, p: R, v0: R, v1: R) -> bool {
    let zero = R::of(0.0);
    let s = v0 + v1;
    bell.td = zero;
    bell.tdj = zero;
    bell.ta = (R::of(2.0) * p) / s;
    let m = bell.jm * p;
    let w = bell.jm * (m * p + ((v0 - v1) * s) * s);
    if w < zero {
        return false;
    }
    bell.taj = (m - w.square_root()) / (bell.jm * s);
    bell.am = bell.jm * bell.taj;
    bell.dm = zero;
    bell.vm = v0 + bell.am * (bell.ta - bell.taj);
    true
}

fn negate_if_negative<R: Real>(x: R) -> R {
    if x < R::of(0.0) { -x } else { x }
}

fn clamp<R: Real>(x: R, lo: R, hi: R) -> R {
    if lo < x { if x < hi { x } else { hi } } else { lo }
}
