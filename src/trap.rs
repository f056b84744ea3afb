//! Trapezoidal velocity profile with the operations and the rounding of liba's `a_trajtrap_*`; Biagotti & Melchiorri,
//! *Trajectory Planning for Automatic Machines and Robots*, section 3.2.

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
        let p = boundary.p1 - boundary.p0;
        let p2 = R::from(2) * p;
        let signed = |v: R| if p < zero { -v } else { v };
        if ac == de {
            return None;
        }
        let vm = velocity.magnitude();
        // Their squares need not wait for the limits: rounding is monotone, so the limited square is that of the limited.
        let highest = velocity * velocity;
        let a = (boundary.v0 * boundary.v0).at_most(highest);
        let b = (boundary.v1 * boundary.v1).at_most(highest);
        let Boundary { p0, p1, v0, v1 } = boundary.limit_velocities(vm);
        (self.p0, self.p1) = (p0, p1);
        (self.v0, self.v1) = (v0, v1);

        // Squared velocity at which the acceleration line meets the deceleration line.
        let c = (b * ac - a * de - p2 * ac * de) / (ac - de);
        let covered = |t: R| p0 + v0 * t + R::HALF * ac * t * t;
        if c > highest {
            self.vc = signed(vm);
            self.ta = (self.vc - v0) / ac;
            let t = (v1 - self.vc) / de;
            self.pa = covered(self.ta);
            self.pd = p1 - self.vc * t - R::HALF * de * t * t;
            self.td = self.ta + (self.pd - self.pa) / self.vc;
            self.t = t + self.td;
        } else if c <= zero {
            return None;
        } else if (c > a) != (c > b) {
            // Too short to reach v1, or to come down to it: one slope all the way. (Not if c is NaN.)
            let is_up = c > a;
            let slope = if is_up { ac } else { de };
            let square = a + p2 * slope;
            if square < zero {
                return None;
            }
            self.v1 = signed(square.sqrt());
            self.t = (self.v1 - v0) / slope;
            if is_up {
                self.vc = self.v1;
                self.ta = self.t;
                self.td = self.t;
                self.pa = covered(self.t);
                self.pd = p1;
            } else {
                self.vc = v0;
                self.ta = zero;
                self.td = zero;
                self.pa = p0;
                self.pd = p0;
            }
        } else {
            self.vc = signed(c.sqrt());
            self.ta = (self.vc - v0) / ac;
            self.td = self.ta;
            self.pa = covered(self.ta);
            self.t = self.ta + (v1 - self.vc) / de;
            self.pd = self.pa;
        }
        self.ac = ac;
        self.de = de;
        Some(self.t)
    }

    /// Position at time `x`, s. Before the start and for a NaN it is `p0`, after the end `p1`.
    pub fn position(&self, x: R) -> R {
        self.position_in(self.phase(x), x)
    }

    #[inline(always)]
    fn position_in(&self, phase: Phase, x: R) -> R {
        let Self {
            p0,
            p1,
            v0,
            vc,
            ta,
            td,
            pa,
            pd,
            ac,
            de,
            ..
        } = *self;
        match phase {
            Phase::Before => p0,
            Phase::Accelerate => p0 + v0 * x + R::HALF * ac * x * x,
            Phase::Cruise => pa + vc * (x - ta),
            Phase::Decelerate => {
                let z = x - td;
                pd + vc * z + R::HALF * de * z * z
            }
            Phase::After => p1,
        }
    }

    /// Velocity at time `x`, s. Before the start and for a NaN it is `v0`, after the end `v1`.
    pub fn velocity(&self, x: R) -> R {
        self.velocity_in(self.phase(x), x)
    }

    #[inline(always)]
    fn velocity_in(&self, phase: Phase, x: R) -> R {
        let Self {
            v0,
            v1,
            vc,
            td,
            ac,
            de,
            ..
        } = *self;
        match phase {
            Phase::Before => v0,
            Phase::Accelerate => v0 + ac * x,
            Phase::Cruise => vc,
            Phase::Decelerate => vc + de * (x - td),
            Phase::After => v1,
        }
    }

    /// Acceleration at time `x`, s, both ends included. Outside the move and for a NaN it is 0.
    pub fn acceleration(&self, x: R) -> R {
        let Self {
            t, ta, td, ac, de, ..
        } = *self;
        let zero = R::from(0);
        if x < ta {
            if x >= zero { ac } else { zero }
        } else if x >= td && x <= t {
            de
        } else {
            zero
        }
    }

    /// Position, velocity and acceleration at time `x`, s.
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
        Sweep { x0, dt }.sample(self.borders(), outputs, |run| self.sample_run(run))
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
    fn phase(&self, x: R) -> Phase {
        let Self { t, ta, td, .. } = *self;
        if x >= ta {
            if x < td {
                Phase::Cruise
            } else if x < t {
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

/// The three phases in order of time, and the standstill around them.
#[derive(Clone, Copy)]
enum Phase {
    Before,
    Accelerate,
    Cruise,
    Decelerate,
    After,
}
