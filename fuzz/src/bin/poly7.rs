//! Does `poly7` give the bits of the original for any move at any time?
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| oracle::bytes::compare(oracle::Family::Poly7, bytes));
