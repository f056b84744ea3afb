//! Where a trajectory goes: to one target, or along waypoints with rest at each.

use core::fmt;

/// The largest magnitude of a position, velocity or rate that [`Trajectory::set`](super::Trajectory::set) accepts. From such
/// numbers no corrected plan overflows, so each of its setpoints is finite.
pub const LARGEST: f64 = 1e60;

/// A position, velocity or rate is larger than [`LARGEST`], infinite or not a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutOfRange;

impl fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a number is larger than {LARGEST:e}, or is not a number")
    }
}

impl core::error::Error for OutOfRange {}

/// A final position, where the axis rests, and the limits on the way. The sign of a limit is ignored.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Target {
    /// Final position.
    pub position: f64,
    /// Maximum velocity.
    pub velocity: f64,
    /// Acceleration: the rate from the start velocity to the cruise velocity.
    pub acceleration: f64,
    /// Deceleration: the rate of the final stop.
    pub deceleration: f64,
}

/// Positions that the axis visits in order, with rest at each. Like a [`Target`] they are relative to the start of the trajectory.
#[derive(Clone, Copy, Debug)]
pub struct Waypoints<'w> {
    positions: &'w [f64],
    limits: LegLimits<'w>,
}

#[derive(Clone, Copy, Debug)]
enum LegLimits<'w> {
    Each { velocities: &'w [f64], accelerations: &'w [f64] },
    Same { velocity: f64, acceleration: f64 },
}

impl<'w> Waypoints<'w> {
    /// Each leg has its own maximum velocity and its own acceleration, which is its deceleration too. The result is `None` if
    /// there is no position, or if the slices differ in length.
    pub fn new(positions: &'w [f64], velocities: &'w [f64], accelerations: &'w [f64]) -> Option<Self> {
        let same_count = velocities.len() == positions.len() && accelerations.len() == positions.len();
        (same_count && !positions.is_empty())
            .then_some(Self { positions, limits: LegLimits::Each { velocities, accelerations } })
    }

    /// All legs have the same maximum velocity and acceleration. The result is `None` if there is no position.
    pub fn uniform(positions: &'w [f64], velocity: f64, acceleration: f64) -> Option<Self> {
        (!positions.is_empty()).then_some(Self { positions, limits: LegLimits::Same { velocity, acceleration } })
    }

    fn get(&self, index: usize) -> Option<Target> {
        let (velocity, acceleration) = match self.limits {
            LegLimits::Each { velocities, accelerations } => (*velocities.get(index)?, *accelerations.get(index)?),
            LegLimits::Same { velocity, acceleration } => (velocity, acceleration),
        };
        Some(Target { position: *self.positions.get(index)?, velocity, acceleration, deceleration: acceleration })
    }
}

/// The target or the waypoints of a trajectory.
#[derive(Clone, Copy, Debug)]
pub enum Route<'w> {
    /// One target.
    Target(Target),
    /// Several targets, borrowed from the caller.
    Waypoints(Waypoints<'w>),
}

impl Route<'_> {
    /// Refuses a number larger than [`LARGEST`], or NaN.
    pub(super) fn check_range(&self) -> Result<(), OutOfRange> {
        let is_in_range = |target: Target| {
            let Target { position, velocity, acceleration, deceleration } = target;
            [position, velocity, acceleration, deceleration].iter().all(|number| number.abs() <= LARGEST)
        };
        let mut targets = (0..usize::MAX).map_while(|leg| self.target(leg));
        targets.all(is_in_range).then_some(()).ok_or(OutOfRange)
    }

    /// The target of a leg. The first leg is leg 0; after the last leg the result is `None`.
    pub(super) fn target(&self, leg: usize) -> Option<Target> {
        match self {
            Self::Target(target) => (leg == 0).then_some(*target),
            Self::Waypoints(waypoints) => waypoints.get(leg),
        }
    }
}

impl Default for Route<'_> {
    fn default() -> Self {
        Self::Target(Target::default())
    }
}

impl From<Target> for Route<'_> {
    fn from(target: Target) -> Self {
        Self::Target(target)
    }
}

impl<'w> From<Waypoints<'w>> for Route<'w> {
    fn from(waypoints: Waypoints<'w>) -> Self {
        Self::Waypoints(waypoints)
    }
}
