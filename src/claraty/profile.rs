//! One motion from a position and a velocity to rest. The listing's profile is written operation by operation. The corrected
//! profile keeps the listing's operations wherever they give the right motion.

use super::Target;
use crate::findings::set;
use crate::real::Operations;
use crate::state::State;

/// The smallest limit. A smaller limit is raised to it, and the listing does not move over a smaller distance. The listing leaves
/// the constant undefined; the value is this project's choice.
pub const EPS: f64 = 1e-10;

/// Every motion ends at rest. The listing's sums with this zero decide the sign of other zeros.
const FINAL_VELOCITY: f64 = 0.0;

/// A peak velocity exceeds its limit only beyond this factor. Rounding alone stays below it.
const PEAK_ROUNDING: f64 = 1.0 + 1e-9;

/// Shape of the velocity over time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// Does not cruise at the maximum velocity.
    #[default]
    Triangular = 0,
    /// Cruises at the maximum velocity.
    Trapezoidal = 1,
}

set! {
    /// What a plan had to change or could not do, as a set.
    Warnings {
        ACCELERATION = 1: "the acceleration was below 1e-10 and was raised to it",
        DECELERATION = 2: "the deceleration was below 1e-10 and was raised to it",
        VELOCITY = 4: "the maximum velocity was below 1e-10 and was raised to it",
        SWITCH = 8: "the listing found no instant to switch from acceleration to deceleration, and its motion is wrong",
    }
}

/// Acceleration until `t1`, cruise until `t2`, deceleration until `tf`. Times are in seconds from the start of the motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Profile {
    /// End of the acceleration phase, s.
    pub t1: f64,
    /// Start of the deceleration phase, s.
    pub t2: f64,
    /// End of the motion, s.
    pub tf: f64,
    /// Position at `t1`.
    pub p_at_t1: f64,
    /// Position at `t2`.
    pub p_at_t2: f64,
    /// Position at `tf` and later.
    pub final_position: f64,
    /// Velocity between `t1` and `t2`, signed.
    pub velocity: f64,
    /// Acceleration before `t1`, signed.
    pub acceleration: f64,
    /// Acceleration after `t2`, signed.
    pub deceleration: f64,
    /// Whether there is a cruise phase.
    pub kind: Kind,
    start: State<f64>,
    /// Position at time 0 on the line of the cruise phase.
    cruise_origin: f64,
}

/// The target with limits that are magnitudes of at least [`EPS`].
fn limited(target: Target) -> (Target, Warnings) {
    let mut warnings = Warnings::default();
    let mut magnitude = |x: f64, warning| {
        let x = x.abs();
        if x < EPS {
            warnings |= warning;
            EPS
        } else {
            x
        }
    };
    let limits = Target {
        velocity: magnitude(target.velocity, Warnings::VELOCITY),
        acceleration: magnitude(target.acceleration, Warnings::ACCELERATION),
        deceleration: magnitude(target.deceleration, Warnings::DECELERATION),
        ..target
    };
    (limits, warnings)
}

impl Profile {
    /// The published listing's motion. A move shorter than [`EPS`] leaves `kind` unchanged.
    pub fn plan_listing(&mut self, start: State<f64>, target: Target) -> Warnings {
        let (limits, mut warnings) = limited(target);
        self.start = start;
        self.final_position = target.position;
        let v0 = start.velocity;
        let stopping = sgn(v0) * (0.5 * sq(v0) / limits.acceleration);
        // Sic: an absolute position against a relative distance. This is where most of its wrong motions begin.
        let cruise = self.plan_ramps(sgn(target.position - stopping), limits);
        if (target.position - start.position).abs() < EPS {
            self.final_position = target.position + stopping;
            (self.t1, self.t2) = (0.0, 0.0);
            self.tf = (v0 / self.deceleration).abs();
            (self.p_at_t1, self.p_at_t2) = (0.0, 0.0);
        } else if cruise <= 0.0 {
            match self.switching_time() {
                Some(t1) => self.t1 = t1,
                None => warnings |= Warnings::SWITCH,
            }
            self.finish_triangle(self.t1 * self.acceleration + v0);
        } else {
            self.finish(Kind::Trapezoidal, cruise);
        }
        warnings
    }

    /// The right motion from `start` to rest at the target. Its setpoints are finite if no argument exceeds [`LARGEST`](super::LARGEST).
    pub fn plan_corrected(&mut self, start: State<f64>, target: Target) -> Warnings {
        let (limits, warnings) = limited(target);
        self.clear_phases(start, target.position);
        let distance = target.position - start.position;
        if distance != 0.0 || start.velocity != 0.0 {
            let direction = sgn(if start.velocity != 0.0 { start.velocity } else { distance });
            if !self.advance(direction, limits) && !self.brake(direction, limits) {
                self.return_to_target(-direction, limits);
            }
        }
        warnings
    }

    /// Brakes at the target's deceleration. The position and the velocity of the target are ignored.
    pub fn plan_stop(&mut self, start: State<f64>, target: Target) -> Warnings {
        let (limits, warnings) = limited(Target { velocity: EPS, ..target });
        let v0 = start.velocity;
        let deceleration = limits.deceleration;
        let way = sgn(v0) * (0.5 * sq(v0) / deceleration);
        self.clear_phases(start, start.position + way);
        self.velocity = v0;
        self.deceleration = -sgn(v0) * deceleration;
        self.acceleration = self.deceleration;
        self.tf = (v0 / deceleration).abs();
        warnings
    }

    /// Position, velocity and acceleration at time `t`, s. Before the motion it is the start without acceleration; after the motion
    /// it is rest at the final position.
    pub fn setpoint(&self, t: f64) -> State<f64> {
        let State { position, velocity, .. } = self.start;
        let (position, velocity, acceleration) = if self.is_over(t) {
            (self.final_position, 0.0, 0.0)
        } else if t < 0.0 {
            (position, velocity, 0.0)
        } else if t <= self.t1 {
            let a = self.acceleration;
            (0.5 * a * sq(t) + velocity * t + position, a * t + velocity, a)
        } else if t <= self.t2 {
            (self.velocity * t + self.cruise_origin, self.velocity, 0.0)
        } else {
            let d = self.deceleration;
            let z = t - self.tf;
            (0.5 * d * sq(z) + FINAL_VELOCITY * z + self.final_position, d * z + FINAL_VELOCITY, d)
        };
        State { position, velocity, acceleration }
    }

    /// Whether the motion has ended at time `t`. A NaN is after the end. The listing may plan a phase that ends at a NaN; the motion skips such a phase.
    pub fn is_over(&self, t: f64) -> bool {
        !(t < 0.0 || [self.t1, self.t2, self.tf].iter().any(|&end| t <= end))
    }

    /// Makes a motion without phases, at rest at `final_position` from the first instant.
    fn clear_phases(&mut self, start: State<f64>, final_position: f64) {
        let [p_at_t1, p_at_t2, cruise_origin] = [start.position; 3];
        *self = Self { start, final_position, p_at_t1, p_at_t2, cruise_origin, ..Self::default() };
    }

    /// Goes to the target without turning: a trapezoid, or a triangle if the start velocity is below the limit. The result is false
    /// if no such motion exists.
    fn advance(&mut self, direction: f64, limits: Target) -> bool {
        let cruise = self.plan_ramps(direction, limits);
        if cruise > 0.0 {
            self.finish(Kind::Trapezoidal, cruise);
            return true;
        }
        if direction * self.acceleration <= 0.0 {
            return false;
        }
        let Some(t1) = self.switching_time() else { return false };
        self.peak_at(t1, t1 * self.acceleration + self.start.velocity, limits);
        self.close_seam(direction, limits);
        true
    }

    /// Joins the phases of a triangle. If the axis hardly accelerates, the root of [`Self::switching_time`] cancels, and the
    /// phases miss each other at `t1`. The peak velocity from the remaining room has no cancellation.
    fn close_seam(&mut self, direction: f64, limits: Target) {
        let Target { acceleration: a, deceleration: d, .. } = limits;
        let State { position: p0, velocity: v0, .. } = self.start;
        let distance = self.final_position - p0;
        let before = 0.5 * self.acceleration * sq(self.t1) + v0 * self.t1 + p0;
        let after = 0.5 * self.deceleration * sq(self.t1 - self.tf) + self.final_position;
        let rounding = 1e-9 * distance.abs() + 1e-15 * (p0.abs() + self.final_position.abs());
        let room = (direction * distance - 0.5 * sq(v0) / d) * (2.0 * (a * (d / (a + d))));
        if (before - after).abs() > rounding && room > 0.0 {
            let peak = Operations::sqrt(sq(v0) + room);
            self.peak_at(room / (a * (v0.abs() + peak)), direction * peak, limits);
        }
    }

    /// Brakes without room to accelerate: at the acceleration first, then at the deceleration. The rates switch at the velocity
    /// that lands on the target. The result is false if neither rate stops the axis before the target.
    fn brake(&mut self, direction: f64, limits: Target) -> bool {
        let Target { acceleration: a, deceleration: d, .. } = limits;
        let speed = self.start.velocity.abs();
        let energy = sq(self.start.velocity);
        let distance = direction * (self.final_position - self.start.position);
        let beyond_a = distance - 0.5 * energy / a;
        let beyond_d = distance - 0.5 * energy / d;
        // A caller who computes `p + v*v/(2*d)` rounds to the nearest number, which often lies short of the stopping distance. The
        // motion then ends where braking ends, this far from the target at most.
        let tie = 8.0 * f64::EPSILON * (self.start.position.abs() + self.final_position.abs());
        if !(beyond_a >= -tie || beyond_d >= -tie) {
            return false;
        }
        let (mut t1, mut switch) = (0.0, speed);
        if a > d {
            let left = beyond_a * (2.0 * (a * (d / (a - d))));
            switch = if left > 0.0 { Operations::sqrt(left).at_most(speed) } else { 0.0 };
            t1 = (speed - switch) / a;
        } else if a < d {
            let lost = (beyond_d * (2.0 * (a * (d / (d - a))))).at_most(energy);
            if lost > 0.0 {
                switch = Operations::sqrt(energy - lost);
                t1 = lost / (a * (speed + switch));
            }
        }
        self.acceleration = -direction * if t1 == 0.0 { d } else { a };
        self.deceleration = -direction * d;
        self.peak_at(t1, direction * switch, limits);
        true
    }

    /// Stops beyond the target and comes back, towards `direction`. The axis is too fast to stop before the target, or moves away from it.
    fn return_to_target(&mut self, direction: f64, limits: Target) {
        let cruise = self.plan_ramps(direction, limits);
        let v0 = self.start.velocity;
        if cruise > 0.0 {
            self.finish(Kind::Trapezoidal, cruise);
        } else if let Some(t1) = self.switching_time() {
            self.peak_at(t1, t1 * self.acceleration + v0, limits);
        } else {
            let Target { acceleration: a, deceleration: d, .. } = limits;
            let distance = direction * (self.final_position - self.start.position);
            let way_back = 0.5 * sq(v0) / a + distance;
            let peak = Operations::sqrt(way_back * (2.0 * (a * (d / (a + d)))));
            self.peak_at((v0.abs() + peak) / a, direction * peak, limits);
        }
    }

    /// Signs the limits for a cruise towards `direction` and plans both ramps. The result is the time between the ramps, s. It is
    /// not positive if the ramps meet.
    fn plan_ramps(&mut self, direction: f64, limits: Target) -> f64 {
        self.velocity = direction * limits.velocity;
        self.acceleration = sgn(self.velocity - self.start.velocity) * limits.acceleration;
        self.deceleration = -sgn(self.velocity - FINAL_VELOCITY) * limits.deceleration;
        self.t1 = (self.velocity - self.start.velocity) / self.acceleration;
        self.p_at_t1 = self.position_at(self.velocity);
        let stopping = 0.5 * (sq(FINAL_VELOCITY) - sq(self.velocity)) / self.deceleration;
        self.p_at_t2 = self.final_position - stopping;
        (self.p_at_t2 - self.p_at_t1) / self.velocity
    }

    /// Position at which the acceleration phase reaches a velocity.
    fn position_at(&self, velocity: f64) -> f64 {
        let State { position: p0, velocity: v0, .. } = self.start;
        0.5 * (sq(velocity) - sq(v0)) / self.acceleration + p0
    }

    /// Time at which a motion without cruise switches from acceleration to deceleration, s: the positive root, if the other root is negative.
    fn switching_time(&self) -> Option<f64> {
        let (a, d) = (self.acceleration, self.deceleration);
        let State { position: p0, velocity: v0, .. } = self.start;
        let c = (0.5 * (sq(FINAL_VELOCITY) - sq(v0)) + d * (p0 - self.final_position)) / (d - a);
        let half = Operations::sqrt(sq(v0) - 2.0 * a * c) / a;
        match (-v0 / a + half, -v0 / a - half) {
            (root, other) | (other, root) if root > 0.0 && other < 0.0 => Some(root),
            _ => None,
        }
    }

    /// Makes a triangle that switches at `t1`. A peak above both the limit and the start velocity is cut to the limit.
    fn peak_at(&mut self, t1: f64, mut peak: f64, limits: Target) {
        let v0 = self.start.velocity;
        let over_start = peak.abs() > v0.abs() * PEAK_ROUNDING;
        self.t1 = t1;
        if over_start && peak.abs() > limits.velocity * PEAK_ROUNDING {
            peak = sgn(peak) * limits.velocity;
            self.t1 = (peak - v0) / self.acceleration;
        }
        self.finish_triangle(peak);
    }

    fn finish_triangle(&mut self, peak: f64) {
        self.velocity = peak;
        self.p_at_t1 = self.position_at(peak);
        self.p_at_t2 = self.p_at_t1;
        self.finish(Kind::Triangular, 0.0);
    }

    fn finish(&mut self, kind: Kind, cruise: f64) {
        self.kind = kind;
        self.t2 = self.t1 + cruise;
        self.tf = self.t2 - (self.velocity - FINAL_VELOCITY) / self.deceleration;
        self.cruise_origin = self.p_at_t1 - self.velocity * self.t1;
    }
}

/// -1 below zero, else +1, also for `-0.0`.
fn sgn(x: f64) -> f64 {
    if x < 0.0 { -1.0 } else { 1.0 }
}

fn sq(x: f64) -> f64 {
    x * x
}
