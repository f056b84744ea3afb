//! Double-S (bell-shaped velocity) profile, after Biagotti & Melchiorri, *Trajectory Planning for Automatic Machines
//! and Robots*, section 3.4, with the operations and the rounding of liba's `a_trajbell_*`.

use crate::real::{keep_branch_on_bare_metal, leave_apart_on_hosts};
use crate::sample::{Border, Run, Sweep, in_phase};
use crate::{Boundary, Real};

/// Double-S velocity profile: jerk, acceleration and velocity are limited, and seven phases follow each other.
///
/// Jerk is piecewise constant, acceleration trapezoidal, velocity bell-shaped. Fields carry the book's symbols. The
/// stored limits are magnitudes; for a move towards smaller positions (`p0 > p1`) they hold in the mirrored axis.
///
/// ```
/// use atraj::{Bell, Boundary};
/// let boundary = Boundary { p0: 0.0, p1: 10.0, v0: 1.0, v1: 0.0 };
/// let bell = Bell::new(30.0, 10.0, 5.0, boundary).expect("the limits allow this move");
/// assert!((bell.t - 2.71_f64).abs() < 1e-12);
/// assert_eq!(bell.position(0.0), 0.0);
/// assert_eq!(bell.velocity(bell.ta), 5.0);
/// assert_eq!(bell.position(bell.t), 10.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Bell<R> {
    /// Total duration, s.
    pub t: R,
    /// Duration of the constant-velocity (cruise) phase, s; 0 if there is none.
    pub tv: R,
    /// Duration of the acceleration phase, s.
    pub ta: R,
    /// Duration of the deceleration phase, s.
    pub td: R,
    /// Duration of each constant-jerk part of the acceleration phase, s.
    pub taj: R,
    /// Duration of each constant-jerk part of the deceleration phase, s.
    pub tdj: R,
    /// Initial position.
    pub p0: R,
    /// Final position.
    pub p1: R,
    /// Initial velocity, limited to the maximum velocity.
    pub v0: R,
    /// Final velocity, limited to the maximum velocity.
    pub v1: R,
    /// Highest velocity reached.
    pub vm: R,
    /// Jerk.
    pub jm: R,
    /// Highest acceleration reached.
    pub am: R,
    /// Highest deceleration reached, negative.
    pub dm: R,
}

impl<R: Real> Bell<R> {
    /// Plans a move within the magnitudes of `jerk`, `acceleration` and `velocity`; their signs are ignored.
    ///
    /// Boundary velocities beyond `±velocity` are limited to it. `None` if no such move exists, if it would take no
    /// time, or if a NaN among the arguments leaves its duration undefined.
    pub fn new(jerk: R, acceleration: R, velocity: R, boundary: Boundary<R>) -> Option<Self>
    where
        Self: Default,
    {
        let mut bell = Self::default();
        let duration = bell.plan(jerk, acceleration, velocity, boundary)?;
        (duration > R::from(0)).then_some(bell)
    }

    /// [`Bell::new`] in place and literally the C function: the duration, also if it is NaN, or `None` where the C
    /// function gives up. What a failed plan does not reach keeps its old value.
    pub fn plan(
        &mut self,
        jerk: R,
        acceleration: R,
        velocity: R,
        boundary: Boundary<R>,
    ) -> Option<R> {
        (self.p0, self.p1) = (boundary.p0, boundary.p1);
        self.jm = jerk.magnitude();
        let vm = velocity.magnitude();
        self.vm = vm;
        (self.v0, self.v1) = (boundary.v0.limit(vm), boundary.v1.limit(vm));
        let am = acceleration.magnitude();
        // In the axis that makes the move go forward. The difference of the positions is not 0 if that is the other axis.
        let p = self.p1 - self.p0;
        let [p, v0, v1] = R::forward(p, self.v0, self.v1);

        // Hosts divide ahead, which saves a branch; microcontrollers, when a ramp asks for it.
        let mut full_tj = if cfg!(target_os = "none") {
            None
        } else {
            Some(am / self.jm)
        };
        (self.taj, self.ta, self.am) = self.ramp(vm - v0, am, &mut full_tj);
        if R::CHEAP_ROOT {
            full_tj = None; // Cheaper to divide again than to ask.
        }
        (self.tdj, self.td, self.dm) = self.ramp(vm - v1, am, &mut full_tj);
        self.dm = -self.dm;

        let one = R::from(1);
        self.tv =
            p / vm - self.ta * R::HALF * (v0 / vm + one) - self.td * R::HALF * (v1 / vm + one);
        let planned = self.tv > R::from(0) || self.plan_without_cruise(am, p, v0, v1);
        self.t = if planned {
            self.ta + self.tv + self.td
        } else {
            R::from(0)
        };
        planned.then_some(self.t)
    }

    /// A velocity change of `dv`: duration of its jerk part, duration of the whole ramp, acceleration reached. `full_tj`
    /// keeps the jerk part of a ramp that reaches `am`, so that a second one needs no division.
    fn ramp(&self, dv: R, am: R, full_tj: &mut Option<R>) -> (R, R, R) {
        if dv * self.jm < am * am {
            let tj = (dv / self.jm).sqrt();
            (tj, tj * R::from(2), self.jm * tj)
        } else {
            let tj = *full_tj.get_or_insert_with(|| am / self.jm);
            (tj, dv / am + tj, am)
        }
    }

    /// No room to cruise: two ramps meet, or one covers the whole distance `p`. `false` if there is no such move.
    // Apart, as its many variables would slow down plans with a cruise phase.
    #[inline(never)]
    fn plan_without_cruise(&mut self, am: R, p: R, v0: R, v1: R) -> bool {
        self.tv = R::from(0);
        self.am = am;
        self.dm = am * R::SIXTEENTH;
        // The one divergence: here the C function halves an infinite step for ever.
        if am == R::INFINITY {
            return false;
        }
        match self.search(am, p, v0, v1) {
            Fit::Both => true,
            Fit::TooSteep => false,
            single => self.plan_single_ramp(matches!(single, Fit::DownOnly), p, v0, v1),
        }
    }

    /// Looks for the highest acceleration whose two ramps fit into the distance `p`, by halving a step from `am` down.
    /// Writes two ramps if both fit, and tells which do.
    ///
    /// At most 1076 rounds for `f64` and 151 for `f32`: the step is halved in every round and starts finite.
    fn search(&mut self, am: R, p: R, v0: R, v1: R) -> Fit {
        let zero = R::from(0);
        let two = R::from(2);
        let s = v0 + v1;
        let q = (v0 * v0 + v1 * v1) * two;
        let Plain {
            mut trial,
            mut step,
            single,
        } = self.skip_plain_rounds(am, p, v0, v1, s, q);
        if single {
            // Of the durations of this round these are all that the single ramp may keep.
            self.taj = trial / self.jm;
            self.tdj = self.taj;
            return if v0 > v1 { Fit::DownOnly } else { Fit::UpOnly };
        }
        let minus_s = -s;
        let (two_v0, two_v1) = (v0 * two, v1 * two);
        let four_p = p * R::from(4);
        let mut td = self.td;
        let (fit, tj, ta) = loop {
            let tj = trial / self.jm;
            let tj2 = tj * two;
            let k = trial * tj;
            // (k*k + q) + (4p - tj2*s)*trial
            let kk_q = k * k + q;
            let r = (tj2 * minus_s + four_p) * trial + kk_q;
            let k = r.sqrt() + k;
            let den = trial * two;
            let ta = (k - two_v0) / den;
            let fit = if ta < zero {
                Fit::DownOnly
            } else {
                td = (k - two_v1) / den;
                if td < zero {
                    Fit::UpOnly
                } else if ta >= tj2 && td >= tj2 {
                    Fit::Both
                } else {
                    Fit::TooSteep
                }
            };
            let next = step * R::HALF;
            if matches!(fit, Fit::TooSteep) {
                trial = trial - next;
            } else if !(trial == am || step < self.dm) {
                trial = trial + next;
            } else {
                break (fit, tj, ta);
            }
            step = next;
            // A NaN step ends the search too.
            if step > R::EPSILON {
                continue;
            }
            break (Fit::TooSteep, tj, ta);
        };
        (self.taj, self.tdj) = (tj, tj);
        (self.ta, self.td) = (ta, td);
        if matches!(fit, Fit::Both) {
            self.am = trial;
            self.dm = -trial;
            self.vm = (ta - tj) * trial + v0;
        }
        fit
    }

    /// Passes over the rounds whose outcome is plain. With `s = v0 + v1` and `q = 2 (v0^2 + v1^2)`.
    ///
    /// A round that goes on needs only its verdict. With `k = am^2/jm` and `w = |v0 - v1|` its root is that of
    /// `r = (k - s)^2 + w^2 + 4 p am`, and its shorter ramp lasts `(k + sqrt(r) - (s + w)) / (2 am)`, which is too steep from 0
    /// to below `2 am/jm`. So `sqrt(r)` is compared with `x = s + w - k` and `x = s + w + 3 k`, or, as `r >= x^2` where `x < 0`,
    /// just `r` with `x^2`: too steep is `-w k <= 2 p am - w s < k (4 k + 4 s + 3 w)`. This takes no root, and one division
    /// for all rounds.
    ///
    /// With `size = 2 p am + 4 k^2 + q` and `u = EPSILON/2`, rounding moves these comparisons by at most 31 `u size` in the
    /// round itself and 20 `u size` here: a difference of more than 128 `u size` is beyond doubt. The guards keep off overflow
    /// and what underflow could move. `docs/search.md` has the proof.
    fn skip_plain_rounds(&self, am: R, p: R, v0: R, v1: R, s: R, q: R) -> Plain<R> {
        let (mut trial, mut step) = (am, am);
        // So long a search is settled when its step runs out, so its last round writes all durations.
        let long = am >= R::DOUBT;
        if R::CHEAP_ROOT || !(long && p >= R::EPSILON) {
            return Plain {
                trial,
                step,
                single: false,
            };
        }
        let two = R::from(2);
        let w = (v0 - v1).abs();
        let half_w = w * R::HALF;
        let slope = w + half_w + s * two;
        let ws = w * s;
        let two_p = p * two;
        let two_per_jm = two / self.jm;
        loop {
            let next = step * R::HALF;
            let distance = trial * two_p;
            let k2 = trial * two_per_jm * trial;
            let size = k2 * k2 + distance + q;
            let doubt = size * R::DOUBT;
            let excess = distance - ws;
            let above_shortest = k2 * half_w + excess;
            let below_longest = (k2 + slope) * k2 - excess;
            let margin = if below_longest < above_shortest {
                below_longest
            } else {
                above_shortest
            };
            let clear = size < R::HUGE && next > R::EPSILON;
            if clear && margin > doubt {
                trial = trial - next;
            } else if clear && margin < -doubt && trial != am && step >= self.dm {
                trial = trial + next;
            } else {
                return Plain {
                    trial,
                    step,
                    single: clear && above_shortest < -doubt,
                };
            }
            step = next;
        }
    }

    /// One ramp covers the whole distance `p`: deceleration if `down`, else acceleration.
    fn plan_single_ramp(&mut self, down: bool, p: R, v0: R, v1: R) -> bool {
        let zero = R::from(0);
        let s = v0 + v1;
        let dv = if down { v1 - v0 } else { v0 - v1 };
        let jm = self.jm;
        let duration = p * R::from(2) / s;
        let m = jm * p;
        let w = dv * s * s;
        let w = (m * p + w) * jm;
        if down {
            (self.ta, self.taj, self.td) = (zero, zero, duration);
        } else {
            (self.td, self.tdj, self.ta) = (zero, zero, duration);
        }
        // Not `w >= 0`: a NaN goes on, as in the C function.
        if w < zero {
            return false;
        }
        let tj = (m - w.sqrt()) / (jm * s);
        let reached = jm * tj;
        if down {
            (self.tdj, self.am, self.dm, self.vm) = (tj, zero, -reached, v0);
        } else {
            (self.taj, self.am, self.dm) = (tj, reached, zero);
            self.vm = (duration - tj) * reached + v0;
        }
        true
    }

    /// Position at time `x`, s. Before the start it is `p0`, after the end and for a NaN `p1`.
    pub fn position(&self, x: R) -> R {
        let Self { p0, p1, v0, v1, .. } = *self;
        // Mirroring twice is exact, so `p0` and `p1` come back as they stand.
        if self.is_backward() {
            -self.forward_position(-p0, -p1, -v0, -v1, x)
        } else {
            self.forward_position(p0, p1, v0, v1, x)
        }
    }

    #[cfg_attr(target_os = "none", inline(never))] // one copy for both directions, where flash is dear
    fn forward_position(&self, p0: R, p1: R, v0: R, v1: R, x: R) -> R {
        self.position_in(self.phase(x), x, Boundary { p0, p1, v0, v1 })
    }

    /// In the axis of `forward`, like `velocity_in`.
    #[inline(always)]
    fn position_in(&self, (phase, braking): (Phase, R), x: R, forward: Boundary<R>) -> R {
        let Boundary { p0, p1, v0, v1 } = forward;
        let cruise_line = |p, v, ramp, z| {
            let start = (v + self.vm) * R::HALF * ramp + p;
            self.vm * z + start
        };
        match phase {
            Phase::Before => p0,
            Phase::JerkUp | Phase::EaseDown => {
                let (p, v, z) = match phase {
                    Phase::JerkUp => (p0, v0, x),
                    _ => (p1, v1, x - self.t),
                };
                let line = v * z + p;
                jerk_distance(self.jm, z) + line
            }
            Phase::Accelerate => {
                let line = v0 * x + p0;
                ramp_distance(self.am, x, self.taj) + line
            }
            Phase::Cruise => cruise_line(p0, v0, self.ta, x - self.ta),
            Phase::EaseUp => {
                let z = x - self.ta;
                let curve = jerk_distance(-self.jm, z);
                cruise_line(p0, v0, self.ta, z) + curve
            }
            Phase::JerkDown | Phase::Decelerate => {
                let z = x - braking;
                let curve = match phase {
                    Phase::JerkDown => jerk_distance(-self.jm, z),
                    _ => ramp_distance(self.dm, z, self.tdj),
                };
                cruise_line(p1, v1, -self.td, z) + curve
            }
            Phase::After => p1,
        }
    }

    /// Velocity at time `x`, s. Before the start it is `v0`, after the end and for a NaN `v1`.
    pub fn velocity(&self, x: R) -> R {
        let Self { p0, p1, v0, v1, .. } = *self;
        if self.is_backward() {
            -self.forward_velocity(-v0, -v1, -p0, -p1, x)
        } else {
            self.forward_velocity(v0, v1, p0, p1, x)
        }
    }

    #[cfg_attr(target_os = "none", inline(never))] // one copy for both directions, where flash is dear
    fn forward_velocity(&self, v0: R, v1: R, p0: R, p1: R, x: R) -> R {
        self.velocity_in(self.phase(x), x, Boundary { p0, p1, v0, v1 })
    }

    #[inline(always)]
    fn velocity_in(&self, (phase, braking): (Phase, R), x: R, forward: Boundary<R>) -> R {
        let Boundary { v0, v1, .. } = forward;
        match phase {
            Phase::Before => v0,
            Phase::JerkUp => jerk_velocity(self.jm, x) + v0,
            Phase::Accelerate => (x - self.taj * R::HALF) * self.am + v0,
            Phase::EaseUp => jerk_velocity(-self.jm, x - self.ta) + self.vm,
            Phase::Cruise => self.vm,
            Phase::JerkDown => jerk_velocity(-self.jm, x - braking) + self.vm,
            Phase::Decelerate => {
                let half_tj = self.tdj * R::HALF;
                (x - self.t + self.td - half_tj) * self.dm + self.vm
            }
            Phase::EaseDown => jerk_velocity(self.jm, x - self.t) + v1,
            Phase::After => v1,
        }
    }

    /// Acceleration at time `x`, s. Outside the move and for a NaN it is 0.
    #[inline(always)]
    pub fn acceleration(&self, x: R) -> R {
        let turn = self.turn();
        let (phase, _) = self.acceleration_phase(x);
        let y = self.acceleration_in(phase, x, turn);
        leave_apart_on_hosts(phase == Phase::Accelerate);
        y
    }

    #[inline(always)]
    fn acceleration_in(&self, phase: Phase, x: R, turn: impl Fn(R) -> R) -> R {
        let y = match phase {
            Phase::Before | Phase::Cruise | Phase::After => return R::from(0),
            Phase::JerkUp => self.jm * x,
            Phase::Accelerate => self.am,
            Phase::EaseUp => (x - self.ta) * -self.jm,
            Phase::JerkDown => (x - self.t + self.td) * -self.jm,
            Phase::Decelerate => self.dm,
            Phase::EaseDown => (x - self.t) * self.jm,
        };
        turn(y)
    }

    /// Jerk at time `x`, s, both ends included. Outside the move and for a NaN it is 0.
    #[inline(always)]
    pub fn jerk(&self, x: R) -> R {
        self.jerk_turned(x, self.turn())
    }

    #[inline(always)]
    fn jerk_turned(&self, x: R, turn: impl Fn(R) -> R) -> R {
        let zero = R::from(0);
        let y = if x < self.ta {
            if x >= self.ta - self.taj {
                -self.jm
            } else if x < self.taj && x >= zero {
                self.jm
            } else {
                return zero;
            }
        } else if x < self.t - self.td + self.tdj {
            if x >= self.ta + self.tv {
                -self.jm
            } else {
                return zero;
            }
        } else if x <= self.t && x >= self.t - self.tdj {
            self.jm
        } else {
            return zero;
        };
        turn(y)
    }

    /// Position, velocity, acceleration and jerk at time `x`, s.
    #[inline(always)]
    pub fn state(&self, x: R) -> [R; 4] {
        if cfg!(target_os = "none") {
            self.forward_state(x, self.forward()) // one copy for both directions, where flash is dear
        } else if self.is_backward() {
            self.forward_state(x, self.boundary().mirrored())
        } else {
            self.forward_state(x, self.boundary())
        }
    }

    #[inline(always)]
    fn forward_state(&self, x: R, forward: Boundary<R>) -> [R; 4] {
        let (phase, braking) = self.phase(x);
        in_phase!(phase, PHASE of
            Before JerkUp Accelerate EaseUp Cruise JerkDown Decelerate EaseDown After => [
            self.orient(self.position_in((PHASE, braking), x, forward)),
            self.orient(self.velocity_in((PHASE, braking), x, forward)),
            self.acceleration_in_state(x),
            self.jerk_in_state(x),
        ])
    }

    // One copy for all phases, where flash is dear.
    #[cfg_attr(target_os = "none", inline(never))]
    fn acceleration_in_state(&self, x: R) -> R {
        let (phase, _) = self.acceleration_phase(x);
        self.acceleration_in(phase, x, |y| self.orient(y))
    }

    // One copy for all phases, where flash is dear.
    #[cfg_attr(target_os = "none", inline(never))]
    fn jerk_in_state(&self, x: R) -> R {
        self.jerk_turned(x, |y| self.orient(y))
    }

    /// The states at the times `x0`, `x0 + dt`, `x0 + 2*dt`, …, s.
    pub fn states(&self, x0: R, dt: R) -> impl Iterator<Item = [R; 4]> {
        Sweep { x0, dt }.states(|x| self.state(x))
    }

    /// Writes positions, velocities, accelerations and jerks at the times `x0`, `x0 + dt`, `x0 + 2*dt`, …, s, with the
    /// bits of the single calls. Each output is filled to its own end and may be empty.
    ///
    /// Returns the number of samples: the length of the longest output, but at most `i32::MAX`.
    ///
    /// ```
    /// use atraj::{Bell, Boundary};
    /// let bell = Bell::new(30.0, 10.0, 5.0, Boundary::rest_to_rest(0.0, 10.0)).expect("the limits allow this move");
    /// let (mut p, mut v) = ([0.0; 100], [0.0; 100]);
    /// assert_eq!(bell.sample_into(0.5, 0.001, [&mut p, &mut v, &mut [], &mut []]), 100);
    /// assert_eq!((p[7], v[7]), (bell.position(0.5 + 7.0 * 0.001), bell.velocity(0.5 + 7.0 * 0.001)));
    /// ```
    pub fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; 4]) -> usize {
        let state = |x| self.state(x);
        Sweep { x0, dt }.sample(self.borders(), outputs, state, |run| self.sample_run(run))
    }

    fn sample_run(&self, run: Run<'_, R, 4>) {
        let x = run.x;
        let (phase, _) = self.phase(x);
        let (acceleration_phase, _) = self.acceleration_phase(x);
        let jerk = self.jerk_turned(x, |y| self.orient(y));
        if phase == acceleration_phase {
            return self.sample_phase(phase, jerk, run);
        }
        let [position, velocity, acceleration, jerks] = run.outputs;
        let outputs = [position, velocity, &mut [], jerks];
        self.sample_phase(phase, jerk, Run { outputs, ..run });
        let outputs = [&mut [], &mut [], acceleration, &mut []];
        self.sample_phase(acceleration_phase, jerk, Run { outputs, ..run });
    }

    /// `jerk`, whose borders are its own, is the same in the whole run.
    #[inline(never)]
    fn sample_phase(&self, phase: Phase, jerk: R, run: Run<'_, R, 4>) {
        let bell = *self;
        let forward = bell.forward();
        let braking = bell.t - bell.td;
        in_phase!(phase, PHASE of
            Before JerkUp Accelerate EaseUp Cruise JerkDown Decelerate EaseDown After => run.fill(|x| [
            bell.orient(bell.position_in((PHASE, braking), x, forward)),
            bell.orient(bell.velocity_in((PHASE, braking), x, forward)),
            bell.acceleration_in(PHASE, x, |y| bell.orient(y)),
            jerk,
        ]))
    }

    /// What times are compared with.
    fn borders(&self) -> [Border<R>; 10] {
        let Self {
            t,
            tv,
            ta,
            td,
            taj,
            tdj,
            ..
        } = *self;
        let zero = R::from(0);
        [
            Border::Below(zero),
            Border::UpTo(zero),
            Border::Below(taj),
            Border::Below(ta - taj),
            Border::Below(ta),
            Border::Below(ta + tv),
            Border::Below(t - td + tdj),
            Border::Below(t - tdj),
            Border::Below(t),
            Border::UpTo(t),
        ]
    }

    /// The phase of position and velocity at `x`, and from cruise on the time at which deceleration begins. The phase of jerk
    /// is found in another order, which matters where rounding has made neighbouring borders cross.
    #[inline(always)]
    fn phase(&self, x: R) -> (Phase, R) {
        self.phase_by(x, |x, border| x < border)
    }

    /// The phase of acceleration at `x`: the same unless a border is NaN.
    #[inline(always)]
    fn acceleration_phase(&self, x: R) -> (Phase, R) {
        #[expect(clippy::neg_cmp_op_on_partial_ord, reason = "a NaN border is ahead")]
        self.phase_by(x, |x, border| !(x >= border))
    }

    #[inline(always)] // the phase becomes a place in the code, not a value
    fn phase_by(&self, x: R, is_ahead: impl Fn(R, R) -> bool) -> (Phase, R) {
        if x < self.ta {
            let phase = if is_ahead(x, self.taj) {
                if x <= R::from(0) {
                    Phase::Before
                } else {
                    Phase::JerkUp
                }
            } else if x < self.ta - self.taj {
                Phase::Accelerate
            } else {
                Phase::EaseUp
            };
            return (phase, R::from(0));
        }
        let braking = self.t - self.td;
        let phase = if x < braking + self.tdj {
            if is_ahead(x, self.ta + self.tv) {
                Phase::Cruise
            } else {
                Phase::JerkDown
            }
        } else if x < self.t {
            if x < self.t - self.tdj {
                Phase::Decelerate
            } else {
                Phase::EaseDown
            }
        } else {
            Phase::After
        };
        (phase, braking)
    }

    /// The boundary conditions in the axis that makes the move go forward.
    fn forward(&self) -> Boundary<R> {
        if self.is_backward() {
            self.boundary().mirrored()
        } else {
            self.boundary()
        }
    }

    fn boundary(&self) -> Boundary<R> {
        let Self { p0, p1, v0, v1, .. } = *self;
        Boundary { p0, p1, v0, v1 }
    }

    /// A value computed in the forward axis, back in the caller's.
    fn orient(&self, y: R) -> R {
        if self.is_backward() {
            keep_branch_on_bare_metal();
            -y
        } else {
            y
        }
    }

    /// `orient` for a single value: hosts find the factor before it, so that little is left to do after a branch.
    #[inline(always)]
    fn turn(&self) -> impl Fn(R) -> R {
        let side = if cfg!(target_os = "none") {
            R::from(1)
        } else {
            R::side(self.p1 - self.p0)
        };
        move |y| {
            if cfg!(target_os = "none") {
                self.orient(y)
            } else {
                y * side
            }
        }
    }

    fn is_backward(&self) -> bool {
        self.p0 > self.p1
    }
}

/// The seven phases in order of time, and the standstill around them.
#[derive(Clone, Copy, PartialEq)]
enum Phase {
    Before,
    JerkUp,
    Accelerate,
    EaseUp,
    Cruise,
    JerkDown,
    Decelerate,
    EaseDown,
    After,
}

/// What one trial acceleration of the search means for the two ramps.
enum Fit {
    DownOnly,
    UpOnly,
    Both,
    TooSteep,
}

// The original has the time until the end of a ramp in the place of a negative `z` here, and subtracts instead of adding
// something negative. The bits are the same, since rounding knows no sign and neither time is 0.

/// Distance that the jerk `j` adds in the time `z`.
fn jerk_distance<R: Real>(j: R, z: R) -> R {
    j * z * z * z / R::from(6)
}

/// Velocity that the jerk `j` adds in the time `z`.
fn jerk_velocity<R: Real>(j: R, z: R) -> R {
    j * R::HALF * z * z
}

/// Distance that a ramp with the acceleration `a` adds in the time `z`, of which its jerk part took `tj`.
fn ramp_distance<R: Real>(a: R, z: R, tj: R) -> R {
    let three_z = z * R::from(3);
    let from_tj = three_z * tj;
    let excess = three_z * z - from_tj;
    (tj * tj + excess) * a / R::from(6)
}

/// How far the search from `am` comes in plain rounds.
struct Plain<R> {
    /// Acceleration that has to be looked at closely.
    trial: R,
    /// Step that led to it.
    step: R,
    /// It is just as plain that the search ends there with a single ramp.
    single: bool,
}
