//! What the tests share, here and in `tests/oracle`. The families of profiles are described here and nowhere else.

pub mod claraty;
pub mod comparison;
pub mod documents;
pub mod each_family;
pub mod family;
pub mod golden;
pub mod implementation;
pub mod online;
pub mod ours;
pub mod prelude;
pub mod profiles;
pub mod random;
pub mod real;
pub mod reference;
pub mod repository;
pub mod tools;
pub mod variant;

/// Whether tests take fewer problems, because they run once for each mutant.
pub const BRIEF: bool = option_env!("BRIEF").is_some();

pub use comparison::Comparison;
pub use documents::blocks;
pub use family::Family;
pub use implementation::Implementation;
pub use ours::{Ours, OursNewest};
pub use random::Random;
pub use real::Real;
pub use repository::{names, read, root};
pub use tools::{Language, abidiff, compilers, has_tool, identify, lines, printed, run};
