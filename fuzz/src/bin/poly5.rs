//! Does `poly5` give the bits of the original for any move at any time?
#![no_main]
use oracle::{Family, bytes::compare};
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| compare(Family::Poly5, bytes));
