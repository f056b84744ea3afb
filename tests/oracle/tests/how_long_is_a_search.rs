//! How long can the search without cruise take?

use oracle::abi::Original;
use oracle::comparison::{Case, MOMENTS, Moment, Report};
use oracle::family::{Family, MOST_ARGUMENTS, MOST_FIELDS};
use oracle::ours::Ours;

fn rounds<R: Original>(am: R, p1: R) -> u32 {
    let one = R::from(1);
    let mut arguments = [R::from(0); MOST_ARGUMENTS];
    arguments[..7].copy_from_slice(&[one, am, one, R::from(0), p1, one, one]);
    let case = Case {
        family: Family::Bell,
        arguments,
        before: [R::from(0); MOST_FIELDS],
        planned: true,
        moments: [Moment::Fraction(R::HALF); MOMENTS],
    };
    let mut report = Report::default();
    report.compare(&Ours, &R::ORIGINAL, &case);
    report.assert_same();
    report.most_rounds
}

/// The step begins at `am` and ends at epsilon, and every round halves it: the bound is attained where no trial ever fits,
/// and one halving of `am` less is one round less.
fn bound<R: Original>(largest: R) {
    let nowhere = R::from_low_bits(u64::MAX); // NaN
    assert_eq!(rounds(largest, nowhere), R::MOST_ROUNDS);
    assert_eq!(rounds(largest * R::HALF, nowhere), R::MOST_ROUNDS - 1);
    assert_eq!(rounds(R::INFINITY, nowhere), 0);
    assert_eq!(rounds(nowhere, nowhere), 1);
}

#[test]
fn at_most_1076_rounds_in_f64() {
    assert_eq!(<f64 as oracle::real::OracleReal>::MOST_ROUNDS, 1076);
    bound(f64::MAX);
}

#[test]
fn at_most_151_rounds_in_f32() {
    assert_eq!(<f32 as oracle::real::OracleReal>::MOST_ROUNDS, 151);
    bound(f32::MAX);
}
