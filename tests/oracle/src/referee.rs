//! The referee of the fastest plans, which is in C because Rust has no `long double`: `c/referee.c`.

use support::{Family, Real};

/// A move as the referee takes it, exact in binary64.
#[derive(Clone, Copy, Debug)]
pub struct Motion {
    /// Jerk, acceleration towards larger positions, acceleration towards smaller positions, velocity.
    pub limits: [f64; 4],
    /// `p0`, `p1`, `v0`, `v1`.
    pub ends: [f64; 4],
}

/// What the referee finds.
#[derive(Clone, Copy, Debug)]
pub struct Best {
    /// The least duration.
    pub duration: f64,
    /// The highest speed of the fastest move.
    pub speed: f64,
    /// The duration of the ramp that leads from the start straight to the final velocity.
    pub direct_duration: f64,
    /// How much further than the end of the direct ramp the target is.
    pub beside_direct: f64,
}

unsafe extern "C" {
    safe fn referee_fastest(
        limits: &[f64; 4],
        ends: &[f64; 4],
        beside: f64,
        results: &mut [f64; 4],
    );
    safe fn referee_bell_state(ctx: &[f64; 14], x: f64, out: &mut [f64; 3]);
    safe fn referee_trap_state(ctx: &[f64; 12], x: f64, out: &mut [f64; 3]);
}

impl Motion {
    /// The move that these arguments of the family's `gen` ask for.
    pub fn of<R: Real>(family: Family, arguments: &[R; 7]) -> Self {
        let [x, y, z, p0, p1, v0, v1] = arguments.map(R::widen);
        let limits = match family {
            Family::Bell => [x.abs(), y.abs(), y.abs(), z.abs()],
            Family::Trap => [f64::INFINITY, y.max(z), -y.min(z), x.abs()],
            _ => panic!("{family:?} has no fastest plan"),
        };
        let ends = [p0, p1, v0, v1];
        Self { limits, ends }
    }

    /// The fastest move to a target `beside` further than `p1`.
    pub fn best(&self, beside: f64) -> Best {
        let mut results = [0.0; 4];
        referee_fastest(&self.limits, &self.ends, beside, &mut results);
        let [duration, speed, direct_duration, beside_direct] = results;
        Best {
            duration,
            speed,
            direct_duration,
            beside_direct,
        }
    }
}

/// Position, velocity and acceleration of a planned struct at the time `x`, integrated from its start.
pub fn state<R: Real>(family: Family, fields: &[R; MOST_PLANNED], x: R) -> [f64; 3] {
    let fields = fields.map(R::widen);
    let mut out = [0.0; 3];
    match family {
        Family::Bell => referee_bell_state(&fields, x.widen(), &mut out),
        _ => {
            let fields = fields.first_chunk().expect("the family's fields");
            referee_trap_state(fields, x.widen(), &mut out);
        }
    }
    out
}

/// The most reals of a struct that is planned for the least time: those of the bell.
pub const MOST_PLANNED: usize = 14;
