//! How many rounds can the search without cruise take?

use oracle::liba::abi::Original;
use oracle::liba::comparison::{Case, MOMENTS, Moment, Report};
use support::family::{MOST_ARGUMENTS, MOST_FIELDS};
use support::{Family, Ours};

fn rounds<R: Original>(am: R, p1: R) -> u32 {
    let [zero, one] = [0.0, 1.0].map(R::of);
    let mut arguments = [zero; MOST_ARGUMENTS];
    arguments[..7].copy_from_slice(&[one, am, one, zero, p1, one, one]);
    let (before, moments) = ([zero; MOST_FIELDS], [Moment::Fraction(R::of(0.5)); MOMENTS]);
    let case = Case { family: Family::Bell, arguments, before, planned: true, moments };
    let mut report = Report::default();
    report.compare(&Ours, &R::ORIGINAL, &case);
    report.assert_same();
    report.most_rounds
}

/// The step begins at `am`, ends at epsilon, and halves in every round. Most rounds take searches in which no trial fits; half the `am` is one less.
fn bound<R: Original>(largest: R, most: u32) {
    assert_eq!(R::MOST_ROUNDS, most);
    let nowhere = R::of(f64::NAN);
    assert_eq!([rounds(largest, nowhere), rounds(largest * R::of(0.5), nowhere)], [most, most - 1]);
    assert_eq!(rounds(R::of(f64::INFINITY), nowhere), 0);
    assert_eq!(rounds(nowhere, nowhere), 1);
}

#[test]
fn at_most_1076_rounds_in_f64() {
    bound(f64::MAX, 1076);
}

#[test]
fn at_most_151_rounds_in_f32() {
    bound(f32::MAX, 151);
}
