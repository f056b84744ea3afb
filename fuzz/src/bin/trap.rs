//! Does `trap` give the bits of the original for any move at any time?
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| oracle::bytes::compare(oracle::Family::Trap, bytes));
