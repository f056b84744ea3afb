//! `atraj.h`: what liba does not have.

mod sample;

pub use sample::*;
