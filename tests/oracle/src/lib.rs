//! Two questions about atraj, each with its own directory.
//!
//! [`liba`]: does it give the bits of the original C library? The original comes from the `liba` crate. `build.rs` compiles it
//! under other names, so that both libraries are in one program and the linker cannot mistake one for the other.
//!
//! [`judge`]: are the motions of its own planners right and the fastest?

/// An enumeration that lists its values.
macro_rules! listed {
    ($(#[$doc:meta])* pub enum $name:ident { $($(#[$of:meta])* $value:ident,)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $name {
            $($(#[$of])* $value,)*
        }

        impl $name {
            /// Every value.
            pub const ALL: [Self; [$(stringify!($value)),*].len()] = [$(Self::$value),*];
        }
    };
}

pub mod bytes;
pub mod judge;
pub mod liba;

pub use support::Family;
