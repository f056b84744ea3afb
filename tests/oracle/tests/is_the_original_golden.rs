//! Is the original that is compiled here the one that the golden data were taken from?

use oracle::liba::abi::{Abi, Original};
use support::{Comparison, Family, golden};

fn original_gives_the_golden_data<R: Original>() {
    let original: Abi<R> = R::ORIGINAL;
    let mut comparison = Comparison::default();
    for family in Family::ALL {
        golden::compare(&mut comparison, &original, family);
    }
    comparison.finish(R::NAME);
}

#[test]
fn f64() {
    original_gives_the_golden_data::<f64>();
}

#[test]
fn f32() {
    original_gives_the_golden_data::<f32>();
}
