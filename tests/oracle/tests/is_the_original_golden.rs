//! Is the original that is compiled here the one the golden data were taken from?

use oracle::abi::{Abi, Original};
use oracle::common::{Comparison, golden};
use oracle::family::{Family, Implementation};

fn original_gives_the_golden_data<R: Original>() {
    let original: Abi<R> = R::ORIGINAL;
    let mut comparison = Comparison::default();
    for family in Family::ALL {
        let name = family.name();
        let [arguments, fields, functions] =
            [family.arguments(), family.fields(), family.functions()].map(<[_]>::len);
        let (text, returned) = family.golden_columns();
        let mut planned = Vec::new();
        for row in golden::<R>(&format!("{name}_gen"), text, arguments + returned + fields) {
            let mut got = vec![R::from(0); fields];
            let duration = original.plan(family, &row.values[..arguments], &mut got);
            let results = &row.values[arguments..];
            for &expected in &results[..returned] {
                comparison.check(&row.place, "returned", duration, expected);
            }
            for ((what, &got), &want) in family.fields().iter().zip(&got).zip(&results[returned..])
            {
                comparison.check(&row.place, what, got, want);
            }
            planned.push(got);
        }
        for row in golden::<R>(&format!("{name}_eval"), 1, 1 + functions) {
            let got = original.evaluate(family, &planned[row.case], row.values[0]);
            for ((what, got), &want) in family.functions().iter().zip(got).zip(&row.values[1..]) {
                comparison.check(&row.place, what, got, want);
            }
        }
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
