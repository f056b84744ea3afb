//! Are any bytes, as limits and states, refused or planned as a move that keeps its contract, without a panic?
#![no_main]
use oracle::bytes::move_from_any_state;
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| move_from_any_state(bytes));
