//! Tests in both real types.

/// Makes the tests `bell::f32`, `bell::f64`, … of a function `fn check<R: Real>(family: Family)`.
#[macro_export]
macro_rules! test_each_family {
    ($check:ident) => {
        $crate::test_each_family!($check: bell Bell, trap Trap, poly3 Poly3, poly5 Poly5, poly7 Poly7);
    };
    ($check:ident: $($name:ident $family:ident),*) => {
        $($crate::test_both_reals!(@ $name: $check($crate::Family::$family));)*
    };
}

/// Makes the tests `check::f32` and `check::f64` of each function `fn check<R: Real>()`.
#[macro_export]
macro_rules! test_both_reals {
    ($($check:ident),*) => {
        $($crate::test_both_reals!(@ $check: $check());)*
    };
    (@ $name:ident: $check:ident($($family:expr)?)) => {
        mod $name {
            #[test]
            fn f32() {
                super::$check::<f32>($($family)?);
            }
            #[test]
            fn f64() {
                super::$check::<f64>($($family)?);
            }
        }
    };
}
