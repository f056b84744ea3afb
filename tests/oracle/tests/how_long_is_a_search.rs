//! How many rounds can the search without cruise take?

use oracle::liba::{Case, MOMENTS, Moment, Original, Report};
use support::family::{MOST_ARGUMENTS, MOST_FIELDS};
use support::{Family, Ours};

fn rounds<R: Original>(am: R, p1: R) -> u32 {
    let mut arguments = [R::ZERO; MOST_ARGUMENTS];
    arguments[..7].copy_from_slice(&[R::ONE, am, R::ONE, R::ZERO, p1, R::ONE, R::ONE]);
    let (before, moments) = ([R::ZERO; MOST_FIELDS], [Moment::Fraction(R::of(0.5)); MOMENTS]);
    let case = Case { family: Family::Bell, arguments, before, planned: true, moments };
    let mut report = Report::default();
    report.compare(&Ours, &R::ORIGINAL, &case);
    report.assert_same();
    report.most_rounds
}

/// The step begins at `am`, ends at epsilon, and halves in every round. Most rounds take searches in which no trial fits; half the `am` is one less.
fn bound<R: Original>(largest: R, most: u32) {
    assert_eq!(R::MOST_ROUNDS, most);
    let nowhere = R::NAN;
    assert_eq!([rounds(largest, nowhere), rounds(largest * R::of(0.5), nowhere)], [most, most - 1]);
    assert_eq!(rounds(R::INFINITY, nowhere), 0);
    assert_eq!(rounds(nowhere, nowhere), 1);
}

#[test]
fn at_most_so_many_rounds() {
    bound(f64::MAX, 1076);
    bound(f32::MAX, 151);
}
