//! Motion profiles for one axis, with the bits of the C library liba.
//!
//! A motion profile says where an axis shall be at every instant of a move, so that a drive can follow without being
//! asked for more than it can do. Plan once, then read off the set-point in every control cycle:
//!
//! ```
//! use atraj::{Bell, Boundary};
//!
//! // 10 m from rest to rest within 30 m/s³, 10 m/s² and 5 m/s.
//! let axis = Bell::new(30.0, 10.0, 5.0, Boundary::rest_to_rest(0.0, 10.0)).expect("the limits allow this move");
//! let mut x = 0.0; // s since the start
//! while x < axis.t {
//!     let (_position, velocity) = (axis.position(x), axis.velocity(x));
//!     assert!((0.0..=5.0_f64).contains(&velocity));
//!     x += 0.001;
//! }
//! assert_eq!(axis.position(x), 10.0);
//! ```
//!
//! Positions, velocities, accelerations and jerks are in any consistent unit (m, m/s, m/s², m/s³; rad, …), times in
//! seconds from the start of the move. `f64` and `f32` are supported; every operation is rounded once, in the order of
//! the original, so that results equal the C library's to the last bit. Nothing here allocates, panics or keeps state.
//!
//! # Which profile
//!
//! | profile | what it limits | use it when |
//! |---|---|---|
//! | [`Bell`] | jerk, acceleration, velocity | the load must not be shaken: double-S, seven phases |
//! | [`Trap`] | acceleration, velocity | the shortest move counts and the mechanics take the jerk |
//! | [`Poly3`], [`Poly5`], [`Poly7`] | nothing; the duration is given | the ends of a move are prescribed up to velocity, acceleration or jerk |
//! | [`claraty::Trajectory`] | acceleration, deceleration, velocity | the target may change in mid-motion, or the motion must stop at once |
//!
//! ## Double-S: [`Bell`]
//!
//! Acceleration rises and falls in ramps of constant jerk, so nothing jumps but the jerk. The gentlest of the limited
//! profiles, and the choice for anything that can swing, spill or resonate.
//!
#![doc = include_str!("../docs/img/double-s-with-cruise.svg")]
//!
//! ## Trapezoid: [`Trap`]
//!
//! Full acceleration, cruise, full deceleration. No profile within the same velocity and acceleration is faster, but the
//! acceleration jumps at every border.
//!
#![doc = include_str!("../docs/img/trapezoid-with-cruise.svg")]
//!
//! ## Polynomials: [`Poly3`], [`Poly5`], [`Poly7`]
//!
//! The move takes exactly the time that is asked for, which keeps several axes in step. A cubic meets position and
//! velocity at both ends, a quintic also acceleration, a septic also jerk. What happens between the ends is not limited.
//!
#![doc = include_str!("../docs/img/septic-polynomial.svg")]
//!
//! # Features
//!
//! The core needs none; `std` alone is on by default. The crate is `no_std` with every one of them.
//!
//! | feature | adds |
//! |---|---|
//! | `std` | the clock of the system for the C handle of CLARAty's trapezoid |
//! | `capi` | the C functions and structs, module `capi` |
//! | `float` | makes the C ABI's real type `float` |
//! | `poly-compact` | gives the C ABI the polynomial structs of liba since 2025-03, and its [`Saturation::Numbers`] |
#![no_std]
#![cfg_attr(atraj_unstable_core, feature(core_float_math))]
#![deny(unsafe_code)]

mod bell;
#[cfg(feature = "capi")]
#[allow(unsafe_code)]
pub mod capi;
pub mod claraty;
mod poly;
mod real;
mod sampling;
mod state;
mod trap;

pub use bell::Bell;
pub use poly::{Poly, Poly3, Poly5, Poly7};
pub use real::Real;
pub use state::{Boundary, Saturation, State};
pub use trap::Trap;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
