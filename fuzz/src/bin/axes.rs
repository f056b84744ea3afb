//! Are any bytes, as limits and states of several axes, refused without a trace or planned as moves that arrive together, without a panic?
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| oracle::bytes::several_axes(bytes));
