//! Golden data and bit-for-bit comparison, shared by the tests.
#![allow(dead_code)] // each test file uses a part of it

use std::fmt::{Debug, LowerExp};
use std::path::{Path, PathBuf};

/// A real type as the golden files write it.
pub trait GoldenReal: atraj::Real + Default + Debug + LowerExp {
    /// How the files of this type end.
    const SUFFIX: &'static str;
    /// The value of a hex bit pattern, or of `nan`.
    fn parse(text: &str) -> Option<Self>;
    /// Same bits, or both NaN.
    fn same(self, other: Self) -> bool;
    /// Value and bit pattern, for messages.
    fn show(self) -> String;
}

macro_rules! golden_real {
    ($real:ty, $bits:ty, $suffix:literal, $digits:literal) => {
        impl GoldenReal for $real {
            const SUFFIX: &'static str = $suffix;
            fn parse(text: &str) -> Option<Self> {
                if text == "nan" {
                    return Some(<$real>::NAN);
                }
                let bits = <$bits>::from_str_radix(text, 16).ok()?;
                (text.len() == $digits).then(|| <$real>::from_bits(bits))
            }
            fn same(self, other: Self) -> bool {
                self.to_bits() == other.to_bits() || (self.is_nan() && other.is_nan())
            }
            fn show(self) -> String {
                format!("{self:e} ({:0width$x})", self.to_bits(), width = $digits)
            }
        }
    };
}
golden_real!(f32, u32, "f32", 8);
golden_real!(f64, u64, "f64", 16);

/// One row of a golden file: where it stands and its numbers.
pub struct Row<R> {
    pub place: String,
    pub case: usize,
    pub values: Vec<R>,
}

impl<R: Copy> Row<R> {
    /// The first `N` numbers.
    pub fn head<const N: usize>(&self) -> [R; N] {
        self.values[..N].try_into().unwrap()
    }
}

/// All rows of `tests/golden/{table}_{f32|f64}.csv`; the first `text` columns are a case number and words, the rest are
/// `numbers` bit patterns. Panics if the file is missing, has no rows or a row that is not of this form.
pub fn golden<R: GoldenReal>(table: &str, text: usize, numbers: usize) -> Vec<Row<R>> {
    cells(&format!("{table}_{}.csv", R::SUFFIX), text + numbers)
        .into_iter()
        .map(|(place, cells)| {
            let case = cells[0].parse().unwrap_or_else(|e| panic!("{place}: {e}"));
            let values = cells[text..]
                .iter()
                .map(|cell| R::parse(cell).unwrap_or_else(|| panic!("{place}: {cell:?}")))
                .collect();
            Row {
                place,
                case,
                values,
            }
        })
        .collect()
}

/// Where each row of a golden file stands and its `columns` cells. Panics if the file is missing, has no rows or a row
/// of another length.
pub fn cells(name: &str, columns: usize) -> Vec<(String, Vec<String>)> {
    let path = golden_dir().join(name);
    let csv = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let rows: Vec<_> = csv
        .lines()
        .enumerate()
        .skip(1)
        .map(|(index, line)| {
            let place = format!("{name}:{}", index + 1);
            let cells: Vec<_> = line.split(',').map(str::to_owned).collect();
            assert_eq!(cells.len(), columns, "{place}: columns");
            (place, cells)
        })
        .collect();
    assert!(!rows.is_empty(), "{}: no rows", path.display());
    rows
}

pub fn golden_dir() -> PathBuf {
    root().join("tests/golden")
}

pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Counts compared values and keeps the differing ones.
#[derive(Default)]
pub struct Comparison {
    pub compared: usize,
    pub differences: Vec<String>,
}

impl Comparison {
    pub fn check<R: GoldenReal>(&mut self, place: &str, what: &str, got: R, want: R) {
        self.compared += 1;
        if !got.same(want) {
            self.differences.push(format!(
                "{place}: {what} is {}, golden {}",
                got.show(),
                want.show()
            ));
        }
    }

    /// Prints the count; panics with the first differences if there is one.
    pub fn finish(self, what: &str) {
        println!(
            "{what}: {} values, {} differing",
            self.compared,
            self.differences.len()
        );
        assert!(self.compared > 0, "{what}: nothing was compared");
        assert!(
            self.differences.is_empty(),
            "{what}: {} of {} values differ:\n{}",
            self.differences.len(),
            self.compared,
            self.differences[..self.differences.len().min(10)].join("\n")
        );
    }
}

/// The next larger number; the smallest positive one for what is not positive.
pub fn just_after(t: f64) -> f64 {
    let t = if t > 0.0 { t } else { 0.0 };
    f64::from_bits(t.to_bits() + 1)
}

/// SplitMix64: the same numbers from the same seed on every machine.
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Evenly spread over `lo..hi`.
    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// Evenly spread in its logarithm over `10^lo..10^hi`.
    pub fn magnitude(&mut self, lo: f64, hi: f64) -> f64 {
        10f64.powf(self.between(lo, hi))
    }

    /// -1 or +1.
    pub fn sign(&mut self) -> f64 {
        if self.bits() & 1 == 0 { -1.0 } else { 1.0 }
    }

    /// One of `choices`.
    pub fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[(self.bits() % choices.len() as u64) as usize]
    }
}
