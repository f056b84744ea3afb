//! Trapezoidal velocity profile with the operations and the rounding of liba's `a_trajtrap_*`; Biagotti & Melchiorri,
//! *Trajectory Planning for Automatic Machines and Robots*, section 3.2.

use crate::bell::border::dips;
use crate::check::{Extremes, Findings};
use crate::real::Real;
use crate::roots::larger_root;
use crate::sampling::{Border, Profile, Run, Sweep, in_phase};
use crate::state::{Boundary, Saturation, State};

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

/// How the velocity runs.
enum Shape {
    /// Up to the highest velocity, and down.
    Cruise,
    /// Up and down.
    Peak,
    /// Too short to reach the demanded final velocity: the reached one takes its place.
    UpOnly,
    /// Too short to come down to the demanded final velocity: the reached one takes its place.
    DownOnly,
}

/// The three phases in order of time, each with its interval, and the standstill around them.
#[derive(Clone, Copy)]
enum Phase {
    /// `x <= 0`.
    Before,
    /// `0 < x < ta`.
    Accelerate,
    /// `ta <= x < td`.
    Cruise,
    /// `td <= x < t`.
    Decelerate,
    /// `x >= t`.
    After,
}

impl<R: Real> Trap<R> {
    /// Plans a move with the highest velocity `velocity` (its sign is ignored), acceleration `ac` and deceleration `de`.
    ///
    /// `ac` and `de` are signed: a forward move has `ac > 0` and `de < 0`, a backward one the opposite. Boundary
    /// velocities beyond `±velocity` are limited to it; a final velocity out of reach is replaced by the one that is
    /// reached. `None` if no such move exists, if it would take no time, or if a NaN among the arguments leaves its
    /// duration undefined.
    pub fn new(velocity: R, ac: R, de: R, boundary: Boundary<R>) -> Option<Self> {
        let mut trap = Self::default();
        let duration = trap.plan(velocity, ac, de, boundary)?;
        (duration > R::ZERO).then_some(trap)
    }

    /// [`Trap::new`] in place and literally the C function: the duration, also if it is NaN, or `None` where the C
    /// function gives up. What a failed plan does not reach keeps its old value.
    pub fn plan(&mut self, velocity: R, ac: R, de: R, boundary: Boundary<R>) -> Option<R> {
        self.plan_saturated(velocity, ac, de, boundary, Saturation::Everything)
    }

    /// [`Trap::plan`] with the saturation of either generation of liba.
    pub fn plan_saturated(
        &mut self,
        velocity: R,
        ac: R,
        de: R,
        boundary: Boundary<R>,
        saturation: Saturation,
    ) -> Option<R> {
        if ac == de {
            return None;
        }
        let vm = velocity.magnitude();
        let Boundary { p0, p1, v0, v1 } = boundary.limit_velocities(vm, saturation);
        (self.p0, self.p1, self.v0, self.v1) = (p0, p1, v0, v1);
        let h = p1 - p0;
        let two_h = R::from(2) * h;

        // Squared velocity at which the acceleration line meets the deceleration line.
        let (a, b) = (v0 * v0, v1 * v1);
        let c = (b * ac - a * de - two_h * ac * de) / (ac - de);
        if c <= R::ZERO {
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
        let speed = match shape {
            Shape::Cruise => vm,
            Shape::UpOnly => root(a + two_h * ac)?,
            Shape::DownOnly => root(a + two_h * de)?,
            Shape::Peak => c.sqrt(),
        };
        let v = speed.negate_if(h < R::ZERO);
        (self.ac, self.de) = (ac, de);
        if matches!(shape, Shape::DownOnly) {
            self.v1 = v;
            self.vc = v0;
            self.t = (v - v0) / de;
            (self.ta, self.td) = (R::ZERO, R::ZERO);
            (self.pa, self.pd) = (p0, p0);
            return Some(self.t);
        }
        self.vc = v;
        self.ta = (v - v0) / ac;
        self.pa = p0 + v0 * self.ta + R::HALF * ac * self.ta * self.ta;
        if matches!(shape, Shape::UpOnly) {
            self.v1 = v;
            (self.t, self.td) = (self.ta, self.ta);
            self.pd = p1;
            return Some(self.t);
        }
        // Duration of the deceleration.
        let t = (v1 - v) / de;
        if matches!(shape, Shape::Cruise) {
            self.pd = p1 - v * t - R::HALF * de * t * t;
            self.td = self.ta + (self.pd - self.pa) / v;
        } else {
            self.pd = self.pa;
            self.td = self.ta;
        }
        self.t = self.td + t;
        Some(self.t)
    }

    /// Plans the fastest move there is within the magnitude of `velocity` and two accelerations of opposite signs, in either order: the
    /// positive one limits the acceleration towards larger positions, the negative one the acceleration towards smaller ones.
    ///
    /// Boundary velocities beyond `±velocity` are limited to it. An infinite velocity means no limit. A target behind, or nearer than
    /// the way to stop, is reached by turning. `None` if a limit is 0 or both accelerations have one sign, if an acceleration is
    /// infinite, for velocities would jump, or if an argument is not a number, or a position infinite; nothing else fails. A move
    /// without displacement and without velocity has the duration 0.
    ///
    /// ```
    /// use atraj::{Boundary, Trap};
    /// // 1 m to go at 4 m/s: too near to stop, so the axis passes the target and comes back.
    /// let trap = Trap::fastest(5.0, 4.0, -2.0, Boundary { p0: 0.0, p1: 1.0, v0: 4.0, v1: 0.0 }).expect("numbers");
    /// assert_eq!((trap.ac, trap.de), (-2.0, 4.0));
    /// assert_eq!((trap.position(trap.t), trap.velocity(trap.t)), (1.0, 0.0));
    /// ```
    #[inline(always)] // saves a copy of the struct, and the double-S, which wants the duration alone, the rest of the plan
    pub fn fastest(velocity: R, ac: R, de: R, boundary: Boundary<R>) -> Option<Self> {
        let vm = velocity.magnitude();
        let (rise, fall) = if ac > R::ZERO { (ac, -de) } else { (de, -ac) };
        let Boundary { p0, p1, v0, v1 } = boundary.limit_velocities(vm, Saturation::Numbers);
        let limits = vm > R::ZERO && rise > R::ZERO && fall > R::ZERO;
        if !(limits && boundary.is_numbers() && rise.is_finite() && fall.is_finite()) {
            return None;
        }
        let (h, dv) = (p1 - p0, v1 - v0);
        // The ramp that leads from the start straight to the end.
        let direct = (v0 + R::HALF * dv) * (dv.abs() / if dv < R::ZERO { fall } else { rise });
        let down_first = dips(h, direct, p0.abs() + p1.abs(), [v0, v1]);

        // In the axis in which the first ramp goes up.
        let [h, v0_up, dv] = [h, v0, dv].map(|x| x.negate_if(down_first));
        let (first, second) = if down_first {
            (fall, rise)
        } else {
            (rise, fall)
        };
        let mut up = (vm - v0_up) / first;
        let mut down = (vm - v0_up - dv).at_least(R::ZERO) / second;
        let by_way_of_vm = R::HALF * (v0_up + vm) * up + R::HALF * (v0_up + dv + vm) * down;
        let (cruise, peak) = if h >= by_way_of_vm {
            ((h - by_way_of_vm) / vm, vm)
        } else {
            // The longer ramp is the unknown: the other one follows without losing digits.
            [up, down] = if first < second {
                meeting_ramps(h, v0_up, dv, first, second)
            } else {
                let [down, up] = meeting_ramps(h, v0_up + dv, -dv, second, first);
                [up, down]
            };
            (R::ZERO, v0_up + first * up)
        };
        let [vc, ac, de] = [peak, first, -second].map(|x| x.negate_if(down_first));
        let trap = Self {
            t: up + cruise + down,
            p0,
            p1,
            v0,
            v1,
            vc,
            ta: up,
            td: up + cruise,
            pa: p0 + v0 * up + R::HALF * ac * up * up,
            pd: p1 - vc * down - R::HALF * de * down * down,
            ac,
            de,
        };
        trap.t.is_finite().then_some(trap)
    }

    /// Examines the move against the magnitude of `velocity` and two accelerations of opposite signs, in either order; an infinite limit
    /// is no limit. Any plan may be examined, a plan of the C library's too. `None` if a field is not finite or a limit is NaN.
    ///
    /// Up to 64 roundings are allowed: of |p| + |v| T for positions, of |v| + |a| T for velocities, of the limits for acceleration.
    pub fn check(&self, velocity: R, ac: R, de: R) -> Option<Findings> {
        let Self {
            t,
            p0,
            p1,
            v0,
            v1,
            vc,
            ta,
            td,
            pa,
            pd,
            ..
        } = *self;
        let (rise, fall) = if ac > R::ZERO { (ac, -de) } else { (de, -ac) };
        let vm = velocity.abs();
        let fields = [t, p0, p1, v0, v1, vc, ta, td, pa, pd, self.ac, self.de];
        if !(fields.iter().all(|x| x.is_finite()) && [vm, rise, fall].iter().all(|&x| x >= R::ZERO))
        {
            return None;
        }
        let reached = self.extremes();
        let few = R::DOUBT; // 64 roundings
        // The clock may pass a short ramp in no time, so the ramp counts though it is not among the extremes.
        let steepest = self.ac.abs().at_least(self.de.abs());
        let of_velocity = few * (reached.speed() + steepest * t);
        let of_position = few * (p0.abs() + p1.abs() + reached.speed() * t);
        let State {
            acceleration: lowest,
            ..
        } = reached.lowest;
        let State {
            acceleration: highest,
            ..
        } = reached.highest;
        let steep = highest > rise + few * rise || -lowest > fall + few * fall;
        Some(
            Findings::EXCEEDS_ACCELERATION.when(steep)
                | Findings::EXCEEDS_VELOCITY.when(reached.speed() > vm + of_velocity)
                | Findings::JUMPS.when(self.jumps(of_position, of_velocity))
                | Findings::OVERSHOOTS.when(reached.overshoots(p0, p1, of_position)),
        )
    }

    /// The lowest and the highest position, velocity and acceleration between 0 and `t`.
    pub fn extremes(&self) -> Extremes<R> {
        let Self {
            t, v0, vc, ta, td, ..
        } = *self;
        let mut reached = Extremes::of(State {
            position: self.p0,
            velocity: v0,
            acceleration: if ta > R::ZERO {
                self.ac
            } else {
                self.acceleration(R::ZERO)
            },
        });
        reached.include_position(self.p1);
        reached.include_velocity(vc);
        reached.include_velocity(self.v1);
        if td > ta {
            reached.include_acceleration(R::ZERO);
        }
        reached.include_acceleration(self.acceleration(t));
        // Where the velocity passes through 0 the axis turns.
        for (x, from, to) in [(-v0 / self.ac, R::ZERO, ta), (td - vc / self.de, td, t)] {
            if x > from && x < to {
                reached.include_position(self.position(x));
            }
        }
        reached
    }

    /// Whether two phases disagree at their border by more than these roundings, or the borders are not in order.
    fn jumps(&self, of_position: R, of_velocity: R) -> bool {
        let late = R::DOUBT * self.t;
        let in_order = self.ta >= R::ZERO && self.ta <= self.td + late && self.td <= self.t + late;
        let at = |phase, x| (self.position_in(phase, x), self.velocity_in(phase, x));
        let fits = |before, after, x| {
            let ((p, v), (q, w)) = (at(before, x), at(after, x));
            (p - q).abs() <= of_position && (v - w).abs() <= of_velocity
        };
        !(in_order
            && fits(Phase::Before, Phase::Accelerate, R::ZERO)
            && fits(Phase::Accelerate, Phase::Cruise, self.ta)
            && fits(Phase::Cruise, Phase::Decelerate, self.td)
            && fits(Phase::Decelerate, Phase::After, self.t))
    }

    /// Position at time `x`, s. Before the start and for a NaN it is `p0`, after the end `p1`.
    pub fn position(&self, x: R) -> R {
        self.position_in(self.phase(x), x)
    }

    /// Velocity at time `x`, s. Before the start and for a NaN it is `v0`, after the end `v1`.
    pub fn velocity(&self, x: R) -> R {
        self.velocity_in(self.phase(x), x)
    }

    /// Acceleration at time `x`, s, both ends included. Outside the move and for a NaN it is 0.
    pub fn acceleration(&self, x: R) -> R {
        if x < self.ta {
            if x >= R::ZERO { self.ac } else { R::ZERO }
        } else if x >= self.td && x <= self.t {
            self.de
        } else {
            R::ZERO
        }
    }

    /// Position, velocity and acceleration at time `x`, s.
    pub fn state(&self, x: R) -> [R; 3] {
        Profile::state(self, x)
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
        Sweep { x0, dt }.sample(self, outputs)
    }

    /// The phase of position and velocity at `x`.
    #[inline(always)]
    fn phase(&self, x: R) -> Phase {
        if x >= self.ta {
            if x < self.td {
                Phase::Cruise
            } else if x < self.t {
                Phase::Decelerate
            } else {
                Phase::After
            }
        } else if x > R::ZERO {
            Phase::Accelerate
        } else {
            Phase::Before
        }
    }

    #[inline(always)]
    fn position_in(&self, phase: Phase, x: R) -> R {
        match phase {
            Phase::Before => self.p0,
            Phase::Accelerate => self.p0 + self.v0 * x + R::HALF * self.ac * x * x,
            Phase::Cruise => self.pa + self.vc * (x - self.ta),
            Phase::Decelerate => {
                let z = x - self.td;
                self.pd + self.vc * z + R::HALF * self.de * z * z
            }
            Phase::After => self.p1,
        }
    }

    #[inline(always)]
    fn velocity_in(&self, phase: Phase, x: R) -> R {
        match phase {
            Phase::Before => self.v0,
            Phase::Accelerate => self.v0 + self.ac * x,
            Phase::Cruise => self.vc,
            Phase::Decelerate => self.vc + self.de * (x - self.td),
            Phase::After => self.v1,
        }
    }
}

/// Durations of two ramps that meet at their highest velocity and together cover the displacement `h`: the first one from the
/// velocity `v` at the acceleration `first`, the second one to the velocity `v + dv` at the deceleration `second`. The duration of
/// the first ramp is the root of a quadratic.
fn meeting_ramps<R: Real>(h: R, v: R, dv: R, first: R, second: R) -> [R; 2] {
    let ratio = first / second;
    let offset = dv / second;
    let beyond = h + offset * (v + R::HALF * dv);
    let t = larger_root(v / first, -(beyond + beyond) / (first * (R::ONE + ratio)));
    // Where the first ramp is the direct one, the root may come out shorter than the ramp by rounding.
    let t = t.at_least((dv / first).at_least(R::ZERO));
    [t, (ratio * t - offset).at_least(R::ZERO)]
}

/// The root of a squared velocity; `None` below 0.
fn root<R: Real>(squared: R) -> Option<R> {
    // Not `squared >= 0`: a NaN goes on, as in the C function.
    if squared < R::ZERO {
        None
    } else {
        Some(squared.sqrt())
    }
}

impl<R: Real> Profile<R, 3, 7> for Trap<R> {
    fn borders(&self) -> [Border<R>; 7] {
        let Self { t, ta, td, .. } = *self;
        [
            Border::Below(R::ZERO),
            Border::UpTo(R::ZERO),
            Border::Below(ta),
            Border::Below(td),
            Border::Below(t),
            Border::UpTo(t),
            // A NaN counts as before the start, and this border tells it from a time after the end.
            Border::UpTo(R::INFINITY),
        ]
    }

    fn each(&self, x: R) -> [R; 3] {
        [self.position(x), self.velocity(x), self.acceleration(x)]
    }

    fn together(&self, x: R) -> [R; 3] {
        let acceleration = self.acceleration(x);
        in_phase!(self.phase(x), PHASE of Before Accelerate Cruise Decelerate After => [
            self.position_in(PHASE, x),
            self.velocity_in(PHASE, x),
            acceleration,
        ])
    }

    fn fill(&self, run: Run<'_, R, 3>) {
        let trap = *self;
        let acceleration = trap.acceleration(run.x);
        in_phase!(trap.phase(run.x), PHASE of Before Accelerate Cruise Decelerate After => run.fill(|x| [
            trap.position_in(PHASE, x),
            trap.velocity_in(PHASE, x),
            acceleration,
        ]))
    }
}
