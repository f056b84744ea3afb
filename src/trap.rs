//! Trapezoidal velocity profile with the operations and the rounding of liba's `a_trajtrap_*`; Biagotti & Melchiorri,
//! *Trajectory Planning for Automatic Machines and Robots*, section 3.2.

use crate::real::{keep_branch_on_bare_metal, leave_apart_on_hosts};
use crate::sample::{Border, Run, Sweep, in_phase};
use crate::{Boundary, Real};

/// Trapezoidal velocity profile: acceleration and velocity are limited; acceleration, cruise and deceleration follow
/// each other.
///
/// Fields carry the book's symbols and are signed: for a move towards smaller positions `vc` and `ac` are negative.
///
/// ```
/// use atraj::{Boundary, Trap};
/// let trap = Trap::new(5.0, 4.0, -2.0, Boundary::rest_to_rest(0.0, 50.0)).expect("a feasible move");
/// assert_eq!((trap.ta, trap.td, trap.t), (1.25, 9.375, 11.875));
/// assert_eq!(trap.velocity(5.0), 5.0);
/// assert_eq!(trap.position(trap.t), 50.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Trap<R> {
    /// Total duration, s.
    pub t: R,
    /// Initial position.
    pub p0: R,
    /// Final position.
    pub p1: R,
    /// Initial velocity, limited to the maximum velocity.
    pub v0: R,
    /// Final velocity: the demanded one limited to the maximum velocity, or what can be reached on the way.
    pub v1: R,
    /// Constant (cruise) velocity, or the highest reached.
    pub vc: R,
    /// Time at which the acceleration phase ends, s.
    pub ta: R,
    /// Time at which the deceleration phase starts, s.
    pub td: R,
    /// Position at `ta`.
    pub pa: R,
    /// Position at `td`.
    pub pd: R,
    /// Acceleration before `ta`.
    pub ac: R,
    /// Acceleration after `td`.
    pub de: R,
}

impl<R: Real> Trap<R> {
    /// Plans a move with the highest velocity `velocity` (its sign is ignored), acceleration `ac` and deceleration `de`.
    ///
    /// `ac` and `de` are signed: a forward move has `ac > 0` and `de < 0`, a backward one the opposite. Boundary
    /// velocities beyond `±velocity` are limited to it; a final velocity out of reach is replaced by the one that is
    /// reached. `None` if no such move exists, if it would take no time, or if a NaN among the arguments leaves its
    /// duration undefined.
    pub fn new(velocity: R, ac: R, de: R, boundary: Boundary<R>) -> Option<Self>
    where
        Self: Default,
    {
        let mut trap = Self::default();
        let duration = trap.plan(velocity, ac, de, boundary)?;
        (duration > R::from(0)).then_some(trap)
    }

    /// [`Trap::new`] in place and literally the C function: the duration, also if it is NaN, or `None` where the C
    /// function gives up. What a failed plan does not reach keeps its old value.
    pub fn plan(&mut self, velocity: R, ac: R, de: R, boundary: Boundary<R>) -> Option<R> {
        let zero = R::from(0);
        if ac == de {
            return None;
        }
        (self.p0, self.p1) = (boundary.p0, boundary.p1);
        let p = self.p1 - self.p0;
        let two_p = p * R::from(2);
        let vm = velocity.magnitude();
        let Boundary { v0, v1, .. } = boundary.limit_velocities(vm);
        (self.v0, self.v1) = (v0, v1);

        // Squared velocity at which the acceleration line meets the deceleration line.
        let a = v0 * v0;
        let b = v1 * v1;
        let c = b * ac - a * de;
        let c = (c - two_p * ac * de) / (ac - de);
        if c <= zero {
            return None;
        }
        let shape = if c > vm * vm {
            Shape::Cruise
        } else if c > a && c <= b {
            Shape::UpOnly
        } else if c <= a && c > b {
            Shape::DownOnly
        } else {
            Shape::Peak
        };
        let magnitude = match shape {
            Shape::Cruise => vm,
            _ => {
                // Squared velocity that is reached.
                let reached = match shape {
                    Shape::UpOnly => two_p * ac + a,
                    Shape::DownOnly => two_p * de + a,
                    _ => c,
                };
                if reached < zero {
                    return None;
                }
                reached.sqrt()
            }
        };
        let v = if p < zero {
            keep_branch_on_bare_metal();
            -magnitude
        } else {
            magnitude
        };

        self.ac = ac;
        self.de = de;
        if matches!(shape, Shape::DownOnly) {
            self.v1 = v;
            self.vc = v0;
            self.t = (v - v0) / de;
            (self.ta, self.td) = (zero, zero);
            (self.pa, self.pd) = (self.p0, self.p0);
            return Some(self.t);
        }
        self.vc = v;
        let ta = (v - v0) / ac;
        self.ta = ta;
        let line = v0 * ta + self.p0;
        self.pa = ac * R::HALF * ta * ta + line;
        match shape {
            Shape::UpOnly => {
                self.v1 = v;
                self.t = ta;
                self.td = ta;
                self.pd = self.p1;
            }
            Shape::Peak => {
                self.td = ta;
                self.pd = self.pa;
                self.t = (v1 - v) / de + ta;
            }
            _ => {
                let t = (v1 - v) / de;
                let line = -(v * t) + self.p1;
                self.pd = -(de * R::HALF * t * t) + line;
                self.td = (self.pd - self.pa) / v + ta;
                self.t = t + self.td;
            }
        }
        Some(self.t)
    }

    /// Position at time `x`, s. Before the start and for a NaN it is `p0`, after the end `p1`.
    pub fn position(&self, x: R) -> R {
        let phase = self.phase(x);
        let y = self.position_in(phase, x);
        leave_apart_on_hosts(matches!(phase, Phase::Accelerate));
        y
    }

    #[inline(always)]
    fn position_in(&self, phase: Phase, x: R) -> R {
        match phase {
            Phase::Before => self.p0,
            Phase::Accelerate => {
                let line = self.v0 * x + self.p0;
                self.ac * R::HALF * x * x + line
            }
            Phase::Cruise => (x - self.ta) * self.vc + self.pa,
            Phase::Decelerate => {
                let z = x - self.td;
                let line = self.vc * z + self.pd;
                self.de * R::HALF * z * z + line
            }
            Phase::After => self.p1,
        }
    }

    /// Velocity at time `x`, s. Before the start and for a NaN it is `v0`, after the end `v1`.
    pub fn velocity(&self, x: R) -> R {
        self.velocity_in(self.phase(x), x)
    }

    #[inline(always)]
    fn velocity_in(&self, phase: Phase, x: R) -> R {
        match phase {
            Phase::Before => self.v0,
            Phase::Accelerate => self.ac * x + self.v0,
            Phase::Cruise => self.vc,
            Phase::Decelerate => (x - self.td) * self.de + self.vc,
            Phase::After => self.v1,
        }
    }

    /// Acceleration at time `x`, s, both ends included. Outside the move and for a NaN it is 0.
    #[inline(always)]
    pub fn acceleration(&self, x: R) -> R {
        let zero = R::from(0);
        if x < self.ta {
            if x >= zero { self.ac } else { zero }
        } else if x >= self.td && x <= self.t {
            self.de
        } else {
            zero
        }
    }

    /// Position, velocity and acceleration at time `x`, s.
    #[inline(always)]
    pub fn state(&self, x: R) -> [R; 3] {
        in_phase!(self.phase(x), PHASE of Before Accelerate Cruise Decelerate After => [
            self.position_in(PHASE, x),
            self.velocity_in(PHASE, x),
            self.acceleration(x),
        ])
    }

    /// The states at the times `x0`, `x0 + dt`, `x0 + 2*dt`, …, s.
    pub fn states(&self, x0: R, dt: R) -> impl Iterator<Item = [R; 3]> {
        Sweep { x0, dt }.states(|x| self.state(x))
    }

    /// Writes positions, velocities and accelerations at the times `x0`, `x0 + dt`, `x0 + 2*dt`, …, s, with the bits of
    /// the single calls. Each output is filled to its own end and may be empty.
    ///
    /// Returns the number of samples: the length of the longest output, but at most `i32::MAX`.
    pub fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; 3]) -> usize {
        let state = |x| self.state(x);
        Sweep { x0, dt }.sample(self.borders(), outputs, state, |run| self.sample_run(run))
    }

    fn sample_run(&self, run: Run<'_, R, 3>) {
        let x = run.x;
        self.sample_phase(self.phase(x), self.acceleration(x), run);
    }

    #[inline(never)]
    fn sample_phase(&self, phase: Phase, acceleration: R, run: Run<'_, R, 3>) {
        let trap = *self;
        in_phase!(phase, PHASE of Before Accelerate Cruise Decelerate After => run.fill(|x| [
            trap.position_in(PHASE, x),
            trap.velocity_in(PHASE, x),
            acceleration,
        ]))
    }

    /// What times are compared with; the last tells a NaN, which counts as before the start, from a time after the end.
    fn borders(&self) -> [Border<R>; 7] {
        let Self { t, ta, td, .. } = *self;
        [
            Border::Below(R::from(0)),
            Border::UpTo(R::from(0)),
            Border::Below(ta),
            Border::Below(td),
            Border::Below(t),
            Border::UpTo(t),
            Border::UpTo(R::INFINITY),
        ]
    }

    /// The phase of position and velocity at `x`.
    #[inline(always)] // the phase becomes a place in the code, not a value
    fn phase(&self, x: R) -> Phase {
        if x >= self.ta {
            if x < self.td {
                Phase::Cruise
            } else if x < self.t {
                Phase::Decelerate
            } else {
                Phase::After
            }
        } else if x > R::from(0) {
            Phase::Accelerate
        } else {
            Phase::Before
        }
    }
}

/// How the velocity runs.
enum Shape {
    /// Up to the highest velocity, and down.
    Cruise,
    /// Up and down.
    Peak,
    /// Too short to reach the final velocity.
    UpOnly,
    /// Too short to come down to the final velocity.
    DownOnly,
}

/// The three phases in order of time, and the standstill around them.
#[derive(Clone, Copy)]
enum Phase {
    Before,
    Accelerate,
    Cruise,
    Decelerate,
    After,
}
