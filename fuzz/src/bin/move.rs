//! Are any bytes, as limits and states, refused or planned as a move that keeps its contract, without a panic?
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| oracle::bytes::move_from_any_state(bytes));
