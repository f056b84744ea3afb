//! Do our C functions, in this build's real type and polynomial layout, give the bits of the original's?

use atraj::capi::a_float;
use oracle::liba::moves::Moves;
use oracle::liba::together::Together;
use oracle::liba::{Case, OURS, Original, Report, run_seed_of};
use support::Implementation;

/// Whether this build saturates the velocities of the case as the original, liba 0.1.15, does. The compact build does so except for
/// a NaN, and for a zero within a limit of 0; the golden data of the newest liba has such moves.
fn is_saturated_alike(case: &Case<a_float>) -> bool {
    let argument = |name| {
        let index = case.family.arguments().iter().position(|n| *n == name);
        index.map_or(1.0, |index| case.arguments[index])
    };
    let [vm, v0, v1] = ["vm", "v0", "v1"].map(argument);
    let is_special = [vm, v0, v1].iter().any(|v| v.is_nan()) || vm == 0.0 && (v0 == 0.0 || v1 == 0.0);
    !(cfg!(feature = "poly-compact") && case.planned && is_special) || is_polynomial(case)
}

#[test]
fn ours_is_the_original() {
    let report = run_seed_of::<a_float>(&OURS, &a_float::ORIGINAL, 1_000_000, is_saturated_alike);
    println!("{}: {report}", std::any::type_name::<a_float>());
    report.assert_same();
}

#[test]
fn ours_together_is_the_original() {
    run_seed_of::<a_float>(&Together, &a_float::ORIGINAL, 4_000_000, is_saturated_alike).assert_same();
}

fn is_polynomial(case: &Case<a_float>) -> bool {
    case.family.is_polynomial()
}

fn planned_array_by_array(stepwise: &impl Implementation<a_float>) {
    let mut report = Report::default();
    for case in Moves::new(2_000_000).filter(is_polynomial).take(100_000) {
        report.compare(stepwise, &a_float::ORIGINAL, &case);
    }
    report.assert_same();
}

#[test]
fn original_is_the_same_array_by_array() {
    planned_array_by_array(&a_float::ORIGINAL_STEPWISE);
}

#[cfg(not(feature = "poly-compact"))]
#[test]
fn ours_is_the_same_array_by_array() {
    planned_array_by_array(&oracle::liba::abi::OURS_STEPWISE);
}

/// Each quantity of a stored polynomial comes from one coefficient array, whatever the other arrays hold.
#[cfg(not(feature = "poly-compact"))]
#[test]
fn any_struct_is_evaluated_alike() {
    let mut report = Report::default();
    for mut case in Moves::<a_float>::new(3_000_000).take(100_000) {
        case.planned = false;
        report.compare(&OURS, &a_float::ORIGINAL, &case);
        report.compare(&Together, &a_float::ORIGINAL, &case);
    }
    report.assert_same();
}
