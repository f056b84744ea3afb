//! The tests of the library, of the oracle and of the C functions as one program, on fewer problems: `make mutants` and `make coverage` run it.
//! `build.rs` lists what is in it if the variable `BRIEF` is set.

/// Calls the `main` of a C program, which answers 0. Those that replay the golden data take its folder.
macro_rules! program {
    ($main:ident) => {
        #[test]
        fn $main() {
            use std::ffi::{CString, c_char, c_int};
            unsafe extern "C" {
                fn $main(argc: c_int, argv: *const *const c_char) -> c_int;
            }
            let golden = CString::new(support::golden::directory().to_str().unwrap()).unwrap();
            let argv = [c"program".as_ptr(), golden.as_ptr()];
            // SAFETY: a program reads its two arguments at most.
            assert_eq!(unsafe { $main(2, argv.as_ptr()) }, 0);
        }
    };
}

include!(concat!(env!("OUT_DIR"), "/brief.rs"));
