//! Are any numbers planned as a bell and as a trapezoid, without a panic, and is the motion clean?
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| oracle::bytes::plan(bytes));
