//! Does the Rust API give the bits of both generations of the original C library on every golden row?

use support::{Comparison, Family, Ours, OursNewest, Real, golden, names, read, test_both_reals, test_each_family};

fn meets_golden_data<R: Real>(family: Family) {
    let mut comparison = Comparison::default();
    golden::compare::<R>(&mut comparison, &Ours, family);
    comparison.finish(family.name());
}

test_each_family!(meets_golden_data);

fn newest<R: Real>() {
    for family in [Family::Bell, Family::Trap] {
        let moves = golden::moves_of::<R>(family, &format!("newest_{}", family.name()));
        let mut comparison = Comparison::default();
        golden::compare_plans(&mut comparison, &OursNewest, family, &moves);
        comparison.finish(&format!("newest {} {}", family.name(), R::NAME));

        let mut older = Comparison::default();
        golden::compare_plans(&mut older, &Ours, family, &moves);
        let (name, differing) = (family.name(), older.differences.len());
        assert!(differing > 100, "{name}: the generations hardly differ, in {differing} values");
    }
}

test_both_reals!(newest);

/// A stranger compares without reading our code.
#[test]
fn each_file_is_described() {
    let page = read("tests/golden/README.md");
    let mut files = 0;
    for name in names("tests/golden") {
        let Some(table) = name.strip_suffix(".csv") else { continue };
        let (table, _) = table.rsplit_once("_f").unwrap();
        assert!(page.contains(&format!("`{table}`")), "{name}");
        files += 1;
    }
    assert!(files > 20);
}

#[test]
#[should_panic(expected = "no_such_table_f64.csv")]
fn a_missing_golden_file_fails() {
    golden::rows::<f64>("no_such_table", 1, 1);
}

#[test]
#[should_panic(expected = "row 7: position is -0e0 (8000000000000000), golden 0e0 (0000000000000000)")]
fn a_differing_sign_of_zero_fails_and_shows_both() {
    let mut comparison = Comparison::default();
    comparison.check("row 7", "position", -0.0, 0.0);
    comparison.finish("self-check");
}

#[test]
#[should_panic(expected = "nothing was compared")]
fn comparing_nothing_fails() {
    Comparison::default().finish("self-check");
}
