//! Do our C functions, in this build's real type and polynomial layout, give the bits of the original's?

use atraj::capi::a_float;
use oracle::abi::{OURS, Original};
use oracle::comparison::{Case, Report};
use oracle::moves::Moves;
use oracle::together::Together;
use oracle::volume::run_seed;
use support::Implementation;

#[test]
fn ours_is_the_original() {
    let report = run_seed::<a_float>(&OURS, &a_float::ORIGINAL, 1_000_000);
    println!("{}: {report}", std::any::type_name::<a_float>());
    report.assert_same();
}

#[test]
fn ours_together_is_the_original() {
    run_seed::<a_float>(&Together, &a_float::ORIGINAL, 4_000_000).assert_same();
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
    planned_array_by_array(&oracle::abi::OURS_STEPWISE);
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
