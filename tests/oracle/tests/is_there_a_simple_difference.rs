//! Is there a simple move on which ours and the original differ?
//!
//! proptest makes the moves, and of a move that shows a difference it makes the simplest one.

use oracle::liba::abi::Original;
use oracle::liba::comparison::{Case, MOMENTS, Moment, Report};
use oracle::liba::faults::Fault;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestError, TestRunner};
use support::family::{MOST_ARGUMENTS, MOST_BORDERS, MOST_FIELDS};
use support::{Family, Implementation, Ours};

/// An ordinary number, which shrinks to a small integer, a special number, or any bit pattern.
fn real<R: Original>() -> impl Strategy<Value = R> {
    prop_oneof![
        4 => (-64..64_i16).prop_map(|n| R::of(f64::from(n))),
        4 => (-100.0..100.0).prop_map(R::of),
        1 => prop::sample::select(R::SPECIAL.to_vec()),
        1 => any::<u64>().prop_map(R::from_low_bits),
    ]
}

fn moment<R: Original>() -> impl Strategy<Value = Moment<R>> {
    prop_oneof![
        (0..MOST_BORDERS, -2..=2_i8).prop_map(|(index, steps)| Moment::Border { index, steps }),
        (-0.1..1.1).prop_map(|fraction| Moment::Fraction(R::of(fraction))),
        real().prop_map(Moment::At),
    ]
}

fn case<R: Original>() -> impl Strategy<Value = Case<R>> {
    (
        prop::sample::select(Family::ALL.to_vec()),
        prop::array::uniform9(real()),
        prop::array::uniform4(moment()),
    )
        .prop_map(
            |(family, arguments, moments): (_, [_; MOST_ARGUMENTS], [_; MOMENTS])| Case {
                family,
                arguments,
                before: [R::of(0.0); MOST_FIELDS],
                planned: true,
                moments,
            },
        )
}

/// The simplest case in which `ours` and the original differ.
fn difference<R: Original>(ours: impl Implementation<R>) -> Option<Case<R>> {
    let config = Config {
        cases: 50_000,
        failure_persistence: None,
        ..Config::default()
    };
    let outcome = TestRunner::new(config).run(&case::<R>(), |case| {
        let mut report = Report::default();
        report.compare(&ours, &R::ORIGINAL, &case);
        prop_assert!(report.differing == 0, "{}", report.examples.join("\n"));
        Ok(())
    });
    match outcome {
        Ok(()) => None,
        Err(TestError::Fail(reason, case)) => {
            println!("{reason}\n{case:?}");
            Some(case)
        }
        Err(abort) => panic!("{abort}"),
    }
}

#[test]
fn ours_never_differs() {
    assert!(difference::<f64>(Ours).is_none());
    assert!(difference::<f32>(Ours).is_none());
}

#[test]
fn a_fault_shrinks_to_a_readable_case() {
    let case = difference::<f64>(Fault::FusedMultiplyAdd).expect("the fault is found");
    assert_eq!(case.family, Family::Poly3);
    let plain = |x: &f64| x.fract() == 0.0 && x.abs() <= 64.0;
    let plain = case.arguments.iter().filter(|x| plain(x)).count();
    assert!(plain >= MOST_ARGUMENTS - 4, "{case:?}");
}
