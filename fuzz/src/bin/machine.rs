//! Are any bytes, as a move that is stepped and shaped, refused without a trace or counted and shaped right, without a panic?
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| oracle::bytes::steps_and_shapes(bytes));
