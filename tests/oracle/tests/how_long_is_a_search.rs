//! How many rounds can the search without cruise take?

use oracle::liba::abi::Original;
use oracle::liba::comparison::{Case, MOMENTS, Moment, Report};
use support::family::{MOST_ARGUMENTS, MOST_FIELDS};
use support::{Family, Ours, Real};

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
fn bound<R: Original>(largest: R) {
    let nowhere = R::of(f64::NAN);
    assert_eq!(rounds(largest, nowhere), R::MOST_ROUNDS);
    assert_eq!(rounds(largest * R::of(0.5), nowhere), R::MOST_ROUNDS - 1);
    assert_eq!(rounds(R::of(f64::INFINITY), nowhere), 0);
    assert_eq!(rounds(nowhere, nowhere), 1);
}

#[test]
fn at_most_1076_rounds_in_f64() {
    assert_eq!(<f64 as Real>::MOST_ROUNDS, 1076);
    bound(f64::MAX);
}

#[test]
fn at_most_151_rounds_in_f32() {
    assert_eq!(<f32 as Real>::MOST_ROUNDS, 151);
    bound(f32::MAX);
}
