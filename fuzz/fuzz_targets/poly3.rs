//! `poly3` against the original: any move, any time, the same bits.
#![no_main]

use oracle::{Family, bytes::compare};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| compare(Family::Poly3, bytes));
