//! Motion profiles for one axis, with the bits of the C library liba.
//!
//! | profile | what it limits | use it when |
//! |---|---|---|
//! | [`Bell`] | jerk, acceleration, velocity | the load must not be shaken: double-S, seven phases |
//! | [`Trap`] | acceleration, velocity | the shortest move counts and the mechanics take the jerk |
//! | [`Poly3`], [`Poly5`], [`Poly7`] | nothing; the duration is given | the ends of a move are prescribed up to velocity, acceleration or jerk |
//!
//! Positions, velocities, accelerations and jerks are in any consistent unit (m, m/s, m/s², m/s³; rad, …); times are
//! in seconds from the start of the move. Every operation is rounded once, in the order the numerical contract gives,
//! so that `f64` and `f32` results equal the C library's to the last bit.
#![no_std]
#![deny(unsafe_code)]

mod bell;
mod boundary;
#[cfg(feature = "capi")]
#[allow(unsafe_code)]
pub mod capi;
mod poly;
mod real;
mod sample;
mod trap;

pub use bell::Bell;
pub use boundary::Boundary;
pub use poly::{Poly3, Poly5, Poly7};
pub use real::Real;
pub use trap::Trap;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
