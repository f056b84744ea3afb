//! Are any bytes, as limits and waypoints, refused without a trace or planned as a path that is possible, without a panic?
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| oracle::bytes::waypoints(bytes));
