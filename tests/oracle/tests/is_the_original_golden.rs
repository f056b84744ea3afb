//! Is the original that is compiled here the one that the golden data were taken from?

use oracle::liba::{Abi, Original};
use support::{Comparison, Family, golden, test_both_reals};

fn original_gives_the_golden_data<R: Original>() {
    let original: Abi<R> = R::ORIGINAL;
    let mut comparison = Comparison::default();
    for family in Family::ALL {
        golden::compare(&mut comparison, &original, family);
    }
    comparison.finish(R::NAME);
}

test_both_reals!(original_gives_the_golden_data);
