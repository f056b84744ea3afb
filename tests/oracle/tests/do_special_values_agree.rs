//! Do ours and the original agree on special values: in every argument, in every pair of arguments, and as the time?

use oracle::liba::{Case, MOMENTS, Moment, Original, Report};
use support::family::{MOST_ARGUMENTS, MOST_FIELDS};
use support::{Family, Ours, test_both_reals};

const MOVES: [[f64; MOST_ARGUMENTS]; 3] = [
    [2.5, 2.0, -1.5, 0.5, 10.0, 0.25, 0.75, 1.0, -1.0],
    [2.0, 3.0, -4.0, 1.0, 1.125, 0.5, -0.25, 0.0, 2.0],
    [3.0, -2.0, 2.0, 7.0, -7.0, -0.5, 0.0, 1.0, 1.0],
];

fn pairs<R: Original>() {
    let mut report = Report::default();
    for family in Family::ALL {
        let count = family.arguments().len();
        for ordinary in MOVES {
            for (first, second) in (0..count).flat_map(|i| (0..=i).map(move |j| (i, j))) {
                for (n, a) in R::SPECIAL.into_iter().enumerate() {
                    for b in R::SPECIAL {
                        let mut arguments = ordinary.map(R::of);
                        arguments[second] = b;
                        arguments[first] = a;
                        let at = |i| Moment::At(R::SPECIAL[(MOMENTS * n + i) % R::SPECIAL.len()]);
                        let (before, moments) = ([R::of(3.0); MOST_FIELDS], std::array::from_fn(at));
                        let case = Case { family, arguments, before, planned: true, moments };
                        report.compare(&Ours, &R::ORIGINAL, &case);
                    }
                }
            }
        }
    }
    println!("{}: {report}", R::NAME);
    report.assert_same();
}

test_both_reals!(pairs);
