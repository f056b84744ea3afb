//! Motion profiles with the bits of the C library liba, and the fastest moves from any state to any state.
//!
//! A motion profile gives the setpoint of an axis for every instant of a move, within limits that the drive can keep. Plan a
//! move once. Then evaluate it in every control cycle:
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
//! Use any consistent unit of length or angle (m, m/s, m/s², m/s³; rad, …). Times are in seconds from the start of the move. The
//! profiles compute in `f64` or `f32`. Every operation rounds once, in the order of the original, so the results equal the C
//! library's to the last bit. Nothing here allocates, panics or keeps state.
//!
//! # Which profile
//!
//! | profile | what it limits | use it when |
//! |---|---|---|
//! | [`Bell`] | jerk, acceleration, velocity | a load must not shake: double-S, seven phases |
//! | [`Trap`] | acceleration, velocity | the shortest move counts, and the mechanics bear the jerk |
//! | [`Poly3`], [`Poly5`], [`Poly7`] | nothing: the duration is given | a move must take a given time, with given derivatives at its ends |
//! | [`online::Move`] | jerk, acceleration, velocity, each way | the axis is in motion, the target may change, or the limits differ each way |
//! | [`axes::synchronise`], [`axes::line`] | the same for each axis | several axes arrive together, or on a straight line |
//! | [`axes::plan_path`] | the same for each axis | several axes pass waypoints without stops |
//! | [`machine::Axis`] | the same | a timer interrupt needs a setpoint while the main loop plans |
//! | [`machine::Clock`] | the same, with a reserve | planned axes must hold, slow down or go back on their path |
//! | [`machine::Shaper`] | keeps the limits of a move | a load must not swing at a known frequency |
//! | [`machine::Steps`] | | a stepper motor follows a move |
//! | [`claraty::Trajectory`] | acceleration, deceleration, velocity | the target may change in mid-motion, or the axis must brake at any time |
//!
//! # Plans that never fail
//!
//! [`Bell::new`] and [`Trap::new`] plan as liba does, and refuse what liba refuses. [`Bell::fastest`] and [`Trap::fastest`] plan the
//! fastest move from any velocity to any other within the limits, and fill the same structs. They refuse only arguments that are not
//! numbers, and limits that limit no acceleration or allow none. `check` says what is wrong with a planned move, and `extremes` what it reaches.
//!
//! # Features
//!
//! The core needs no feature; `std` alone is on by default. The crate is `no_std` with every feature.
//!
//! | feature | adds |
//! |---|---|
//! | `std` | the clock of the system for the C handle of CLARAty's trapezoid |
//! | `capi` | the C functions and structs, module `capi` |
//! | `float` | makes the C ABI's real type `float` |
//! | `poly-compact` | gives the C ABI the polynomial structs of liba since 2025-03, and its [`Saturation::Numbers`] |
//!
//! By design, `capi` clashes with the crate `liba` in one program, because both define the same C functions: leave `capi` out
//! there, or link the archive of `make dist SYMBOL_PREFIX=x_`.
#![no_std]
#![cfg_attr(atraj_unstable_core, feature(core_float_math))]
#![deny(unsafe_code)]

pub mod axes {
    //! Several axes that move together: in the same time, on a straight line, or through waypoints.
    //! The programs of `docs/moves.md` and `docs/path.md` plan a line and a path.
    pub use crate::path::{
        Contour, improve_path, limit_feed, path_deviation, path_moves, path_size, path_size_near, plan_contour,
        plan_path, plan_path_near,
    };
    pub use crate::several::{line, line_stop, synchronise, synchronise_within};
}
#[cfg(feature = "capi")]
#[allow(unsafe_code)]
pub mod capi;
pub mod claraty;
mod fastest;
mod findings;
mod interval;
mod liba;
mod limits;
pub mod machine;
pub mod online;
mod path;
mod real;
mod roots;
mod sampling;
mod several;
mod state;
mod table;

pub use findings::{Error, Extremes, Findings};
pub use liba::{Bell, Poly, Poly3, Poly5, Poly7, Trap};
pub use real::Real;
pub use state::{Boundary, Saturation, State};

#[cfg(doctest)]
#[doc = include_str!("../docs/moves.md")]
#[doc = include_str!("../docs/path.md")]
#[doc = include_str!("../docs/machine.md")]
mod guides {}
