//! Plans in liba's structs that never fail, and what is wrong with any other plan.

mod bell;
mod border;
mod check;
mod trap;
