//! liba's headers.

mod poly;
pub mod trajbell;
pub mod trajpoly3;
pub mod trajpoly5;
pub mod trajpoly7;
pub mod trajtrap;
