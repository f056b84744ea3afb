//! Does an axis tick between any requests as moves do that are planned one by one, without a panic and without a jump at a takeover?
#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| oracle::bytes::axis_in_a_machine(bytes));
