//! Where a trajectory goes: one target, or waypoints with rest at each.

/// A final position, reached at rest, and the limits on the way. Limits count by magnitude.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Target {
    /// Final position.
    pub position: f64,
    /// Maximum velocity.
    pub velocity: f64,
    /// Acceleration, for the change from the present to the maximum velocity.
    pub acceleration: f64,
    /// Deceleration, for the final stop.
    pub deceleration: f64,
}

/// Positions to visit one after the other, at rest at each, relative to the start of the trajectory as a [`Target`] is.
#[derive(Clone, Copy, Debug)]
pub struct Waypoints<'w> {
    positions: &'w [f64],
    limits: LegLimits<'w>,
}

#[derive(Clone, Copy, Debug)]
enum LegLimits<'w> {
    Each {
        velocities: &'w [f64],
        accelerations: &'w [f64],
    },
    Same {
        velocity: f64,
        acceleration: f64,
    },
}

impl<'w> Waypoints<'w> {
    /// Waypoints with a maximum velocity and an acceleration (also the deceleration) each; `None` unless there are as
    /// many of these as positions, and at least one.
    pub fn new(
        positions: &'w [f64],
        velocities: &'w [f64],
        accelerations: &'w [f64],
    ) -> Option<Self> {
        let same_count =
            velocities.len() == positions.len() && accelerations.len() == positions.len();
        (same_count && !positions.is_empty()).then_some(Self {
            positions,
            limits: LegLimits::Each {
                velocities,
                accelerations,
            },
        })
    }

    /// Waypoints with one maximum velocity and one acceleration for all; `None` without a position.
    pub fn uniform(positions: &'w [f64], velocity: f64, acceleration: f64) -> Option<Self> {
        (!positions.is_empty()).then_some(Self {
            positions,
            limits: LegLimits::Same {
                velocity,
                acceleration,
            },
        })
    }

    fn get(&self, index: usize) -> Option<Target> {
        let (velocity, acceleration) = match self.limits {
            LegLimits::Each {
                velocities,
                accelerations,
            } => (*velocities.get(index)?, *accelerations.get(index)?),
            LegLimits::Same {
                velocity,
                acceleration,
            } => (velocity, acceleration),
        };
        Some(Target {
            position: *self.positions.get(index)?,
            velocity,
            acceleration,
            deceleration: acceleration,
        })
    }
}

/// What a trajectory is set to.
#[derive(Clone, Copy, Debug)]
pub enum Route<'w> {
    /// One target.
    Target(Target),
    /// Several, borrowed from the caller.
    Waypoints(Waypoints<'w>),
}

impl Route<'_> {
    /// The target of a leg, counted from 0; `None` after the last.
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
