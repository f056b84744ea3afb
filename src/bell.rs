//! Double-S (bell-shaped velocity) profile, after Biagotti & Melchiorri, *Trajectory Planning for Automatic Machines
//! and Robots*, section 3.4, with the operations and the rounding of liba's `a_trajbell_*`.

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
        let jm = jerk.magnitude();
        let am = acceleration.magnitude();
        let vm = velocity.magnitude();
        let boundary = boundary.limit_velocities(vm);
        (self.p0, self.p1) = (boundary.p0, boundary.p1);
        (self.v0, self.v1) = (boundary.v0, boundary.v1);
        // In the axis that makes the move go forward. Turning the difference of positions is exact: it is not 0.
        let is_backward = self.is_backward();
        let p = (boundary.p1 - boundary.p0).negated_if(is_backward);
        let v0 = boundary.v0.negated_if(is_backward);
        let v1 = boundary.v1.negated_if(is_backward);

        self.vm = vm;
        self.jm = jm;
        let mut full_tj = None;
        (self.taj, self.ta, self.am) = ramp(vm - v0, jm, am, &mut full_tj);
        (self.tdj, self.td, self.dm) = ramp(vm - v1, jm, am, &mut full_tj);
        self.dm = -self.dm;

        let one = R::from(1);
        self.tv =
            p / vm - R::HALF * self.ta * (one + v0 / vm) - R::HALF * self.td * (one + v1 / vm);
        let planned = self.tv > R::from(0) || self.plan_without_cruise(am, p, v0, v1);
        self.t = if planned {
            self.ta + self.tv + self.td
        } else {
            R::from(0)
        };
        planned.then_some(self.t)
    }

    /// No room to cruise. Looks for the highest acceleration whose two ramps fit into the distance `p`, by
    /// halving a step from `am` down, and writes the ramps. `false` if there is none.
    ///
    /// At most 1076 rounds for `f64` and 151 for `f32`: the step is halved in every round and starts finite.
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

        let (trial, step, lone_ramp) = skip_plain_rounds(self.jm, am, p, v0, v1);
        let fit = if lone_ramp {
            // Of the durations of this round these are all that the lone ramp may keep.
            self.taj = trial / self.jm;
            self.tdj = self.taj;
            if v0 > v1 { Fit::DownOnly } else { Fit::UpOnly }
        } else {
            self.search(trial, step, p, v0, v1)
        };
        match fit {
            Fit::DownOnly => self.plan_down_only(p, v0, v1),
            Fit::UpOnly => self.plan_up_only(p, v0, v1),
            Fit::Both => true,
            Fit::TooSteep => false,
        }
    }

    /// The rounds from `trial` on. Writes two ramps if both fit, and tells which do.
    fn search(&mut self, mut trial: R, mut step: R, p: R, v0: R, v1: R) -> Fit {
        let zero = R::from(0);
        let two = R::from(2);
        let four = R::from(4);
        let Self {
            jm, am, dm: coarse, ..
        } = *self;
        let s = v0 + v1;
        let q = two * (v0 * v0 + v1 * v1);
        loop {
            let tj = trial / jm;
            let tj2 = two * tj;
            self.taj = tj;
            self.tdj = tj;
            let k = trial * tj;
            let k = k + (k * k + q + (four * p - tj2 * s) * trial).sqrt();
            let den = two * trial;
            self.ta = (k - two * v0) / den;
            let fit = if self.ta < zero {
                Fit::DownOnly
            } else {
                self.td = (k - two * v1) / den;
                if self.td < zero {
                    Fit::UpOnly
                } else if self.ta >= tj2 && self.td >= tj2 {
                    Fit::Both
                } else {
                    Fit::TooSteep
                }
            };

            let settled = trial == am || step < coarse;
            step = step * R::HALF;
            if matches!(fit, Fit::TooSteep) {
                trial = trial - step;
            } else if !settled {
                trial = trial + step;
            } else {
                if matches!(fit, Fit::Both) {
                    self.am = trial;
                    self.dm = -trial;
                    self.vm = v0 + trial * (self.ta - tj);
                }
                return fit;
            }
            // A NaN step ends the search too.
            if step > R::EPSILON {
                continue;
            }
            return Fit::TooSteep;
        }
    }

    /// The end is reached by braking alone: one deceleration ramp covers the whole distance `p`.
    fn plan_down_only(&mut self, p: R, v0: R, v1: R) -> bool {
        self.ta = R::from(0);
        self.taj = R::from(0);
        let (td, tdj) = only_ramp(self.jm, p, v0 + v1, v1 - v0);
        self.td = td;
        let Some(tdj) = tdj else { return false };
        self.tdj = tdj;
        self.am = R::from(0);
        self.dm = -self.jm * tdj;
        self.vm = v0;
        true
    }

    /// The end is reached by speeding up alone: one acceleration ramp covers the whole distance `p`.
    fn plan_up_only(&mut self, p: R, v0: R, v1: R) -> bool {
        self.td = R::from(0);
        self.tdj = R::from(0);
        let (ta, taj) = only_ramp(self.jm, p, v0 + v1, v0 - v1);
        self.ta = ta;
        let Some(taj) = taj else { return false };
        self.taj = taj;
        self.am = self.jm * taj;
        self.dm = R::from(0);
        self.vm = v0 + self.am * (ta - taj);
        true
    }

    /// Position at time `x`, s. Before the start it is `p0`, after the end and for a NaN `p1`.
    pub fn position(&self, x: R) -> R {
        let Self { p0, p1, v0, v1, .. } = *self;
        // Mirroring twice is exact, so `p0` and `p1` come back as they stand.
        if self.is_backward() {
            -self.forward_position(x, -p0, -p1, -v0, -v1)
        } else {
            self.forward_position(x, p0, p1, v0, v1)
        }
    }

    #[cfg_attr(target_os = "none", inline(never))] // one copy for both directions, where flash is dear
    fn forward_position(&self, x: R, p0: R, p1: R, v0: R, v1: R) -> R {
        self.position_in(self.phase(x), x, Boundary { p0, p1, v0, v1 })
    }

    /// In the axis of `forward`, like `velocity_in`.
    #[inline(always)]
    fn position_in(&self, phase: Phase, x: R, forward: Boundary<R>) -> R {
        let Self {
            t,
            ta,
            td,
            taj,
            tdj,
            vm,
            jm,
            am,
            dm,
            ..
        } = *self;
        let Boundary { p0, p1, v0, v1 } = forward;
        let three = R::from(3);
        let six = R::from(6);
        match phase {
            Phase::Before => p0,
            Phase::JerkUp => p0 + v0 * x + jm * x * x * x / six,
            Phase::Accelerate => {
                p0 + v0 * x + am * (three * x * x - three * x * taj + taj * taj) / six
            }
            Phase::EaseUp => {
                let z = ta - x;
                p0 + R::HALF * (vm + v0) * ta - vm * z + jm * z * z * z / six
            }
            Phase::Cruise => p0 + R::HALF * (vm + v0) * ta + vm * (x - ta),
            Phase::JerkDown => {
                let z = x - (t - td);
                p1 - R::HALF * (vm + v1) * td + vm * z - jm * z * z * z / six
            }
            Phase::Decelerate => {
                let z = x - (t - td);
                p1 - R::HALF * (vm + v1) * td
                    + vm * z
                    + dm * (three * z * z - three * z * tdj + tdj * tdj) / six
            }
            Phase::EaseDown => {
                let z = t - x;
                p1 - v1 * z - jm * z * z * z / six
            }
            Phase::After => p1,
        }
    }

    /// Velocity at time `x`, s. Before the start it is `v0`, after the end and for a NaN `v1`.
    pub fn velocity(&self, x: R) -> R {
        let Self { p0, p1, v0, v1, .. } = *self;
        if self.is_backward() {
            -self.forward_velocity(x, -p0, -p1, -v0, -v1)
        } else {
            self.forward_velocity(x, p0, p1, v0, v1)
        }
    }

    #[cfg_attr(target_os = "none", inline(never))] // one copy for both directions, where flash is dear
    fn forward_velocity(&self, x: R, p0: R, p1: R, v0: R, v1: R) -> R {
        self.velocity_in(self.phase(x), x, Boundary { p0, p1, v0, v1 })
    }

    #[inline(always)]
    fn velocity_in(&self, phase: Phase, x: R, forward: Boundary<R>) -> R {
        let Self {
            t,
            ta,
            td,
            taj,
            tdj,
            vm,
            jm,
            am,
            dm,
            ..
        } = *self;
        let Boundary { v0, v1, .. } = forward;
        match phase {
            Phase::Before => v0,
            Phase::JerkUp => v0 + R::HALF * jm * x * x,
            Phase::Accelerate => v0 + am * (x - R::HALF * taj),
            Phase::EaseUp => {
                let z = ta - x;
                vm - R::HALF * jm * z * z
            }
            Phase::Cruise => vm,
            Phase::JerkDown => {
                let z = x - (t - td);
                vm - R::HALF * jm * z * z
            }
            Phase::Decelerate => vm + dm * (x - t + td - R::HALF * tdj),
            Phase::EaseDown => {
                let z = t - x;
                v1 + R::HALF * jm * z * z
            }
            Phase::After => v1,
        }
    }

    /// Acceleration at time `x`, s. Outside the move and for a NaN it is 0.
    pub fn acceleration(&self, x: R) -> R {
        self.acceleration_in(self.acceleration_phase(x), x)
    }

    #[inline(always)]
    fn acceleration_in(&self, phase: Phase, x: R) -> R {
        let Self {
            t,
            ta,
            td,
            jm,
            am,
            dm,
            ..
        } = *self;
        let y = match phase {
            Phase::Before | Phase::Cruise | Phase::After => return R::from(0),
            Phase::JerkUp => jm * x,
            Phase::Accelerate => am,
            Phase::EaseUp => jm * (ta - x),
            Phase::JerkDown => -jm * (x - t + td),
            Phase::Decelerate => dm,
            Phase::EaseDown => -jm * (t - x),
        };
        self.orient(y)
    }

    /// Jerk at time `x`, s, both ends included. Outside the move and for a NaN it is 0.
    pub fn jerk(&self, x: R) -> R {
        let Self {
            t,
            tv,
            ta,
            td,
            taj,
            tdj,
            jm,
            ..
        } = *self;
        let zero = R::from(0);
        let y = if x < ta {
            if x >= ta - taj {
                -jm
            } else if x < taj && x >= zero {
                jm
            } else {
                return zero;
            }
        } else if x < t - td + tdj {
            if x >= ta + tv {
                -jm
            } else {
                return zero;
            }
        } else if x <= t && x >= t - tdj {
            jm
        } else {
            return zero;
        };
        self.orient(y)
    }

    /// Position, velocity, acceleration and jerk at time `x`, s.
    pub fn state(&self, x: R) -> [R; 4] {
        let Self { p0, p1, v0, v1, .. } = *self;
        let boundary = Boundary { p0, p1, v0, v1 };
        if cfg!(target_os = "none") {
            self.forward_state(x, self.forward()) // one copy for both directions, where flash is dear
        } else if self.is_backward() {
            self.forward_state(x, boundary.mirrored())
        } else {
            self.forward_state(x, boundary)
        }
    }

    #[inline(always)]
    fn forward_state(&self, x: R, forward: Boundary<R>) -> [R; 4] {
        in_phase!(self.phase(x), PHASE of
            Before JerkUp Accelerate EaseUp Cruise JerkDown Decelerate EaseDown After => [
            self.orient(self.position_in(PHASE, x, forward)),
            self.orient(self.velocity_in(PHASE, x, forward)),
            self.acceleration(x),
            self.jerk(x),
        ])
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
        Sweep { x0, dt }.sample(self.borders(), outputs, |run| self.sample_run(run))
    }

    fn sample_run(&self, run: Run<'_, R, 4>) {
        let x = run.x;
        let phase = self.phase(x);
        let acceleration_phase = self.acceleration_phase(x);
        let constant = [self.acceleration_in(acceleration_phase, x), self.jerk(x)];
        if phase == acceleration_phase {
            return self.sample_phase(phase, constant, run);
        }
        let [position, velocity, acceleration, jerk] = run.outputs;
        let outputs = [position, velocity, &mut [], jerk];
        self.sample_phase(phase, constant, Run { outputs, ..run });
        let outputs = [&mut [], &mut [], acceleration, &mut []];
        self.sample_phase(acceleration_phase, constant, Run { outputs, ..run });
    }

    /// `acceleration` is that of the phases in which it is constant.
    #[inline(never)]
    fn sample_phase(&self, phase: Phase, [acceleration, jerk]: [R; 2], run: Run<'_, R, 4>) {
        let bell = *self;
        let forward = bell.forward();
        in_phase!(phase, PHASE of
            Before JerkUp Accelerate EaseUp Cruise JerkDown Decelerate EaseDown After => run.fill(|x| [
            bell.orient(bell.position_in(PHASE, x, forward)),
            bell.orient(bell.velocity_in(PHASE, x, forward)),
            match PHASE {
                Phase::JerkUp | Phase::EaseUp | Phase::JerkDown | Phase::EaseDown => {
                    bell.acceleration_in(PHASE, x)
                }
                _ => acceleration,
            },
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

    /// The phase of position and velocity at `x`. That of jerk is found in another order, which matters where rounding
    /// has made neighbouring borders cross.
    #[inline(always)]
    fn phase(&self, x: R) -> Phase {
        self.phase_by(x, |x, border| x < border)
    }

    /// The phase of acceleration at `x`: the same unless a border is NaN.
    #[inline(always)]
    fn acceleration_phase(&self, x: R) -> Phase {
        #[expect(clippy::neg_cmp_op_on_partial_ord, reason = "a NaN border is ahead")]
        self.phase_by(x, |x, border| !(x >= border))
    }

    #[inline(always)] // the phase becomes a place in the code, not a value
    fn phase_by(&self, x: R, is_ahead: impl Fn(R, R) -> bool) -> Phase {
        let Self {
            t,
            tv,
            ta,
            td,
            taj,
            tdj,
            ..
        } = *self;
        if x < ta {
            if is_ahead(x, taj) {
                if x <= R::from(0) {
                    Phase::Before
                } else {
                    Phase::JerkUp
                }
            } else if x < ta - taj {
                Phase::Accelerate
            } else {
                Phase::EaseUp
            }
        } else if x < t - td + tdj {
            if is_ahead(x, ta + tv) {
                Phase::Cruise
            } else {
                Phase::JerkDown
            }
        } else if x < t {
            if x < t - tdj {
                Phase::Decelerate
            } else {
                Phase::EaseDown
            }
        } else {
            Phase::After
        }
    }

    /// The boundary conditions in the axis that makes the move go forward.
    fn forward(&self) -> Boundary<R> {
        let Self { p0, p1, v0, v1, .. } = *self;
        let boundary = Boundary { p0, p1, v0, v1 };
        if self.is_backward() {
            boundary.mirrored()
        } else {
            boundary
        }
    }

    /// A value computed in the forward axis, back in the caller's.
    fn orient(&self, y: R) -> R {
        if self.is_backward() { -y } else { y }
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

/// A velocity change of `dv`: duration of its jerk part, duration of the whole ramp, acceleration reached. `full_tj` keeps
/// the jerk part of a ramp that reaches `am`, so that a second one needs no division.
fn ramp<R: Real>(dv: R, jm: R, am: R, full_tj: &mut Option<R>) -> (R, R, R) {
    if dv * jm < am * am {
        let tj = (dv / jm).sqrt();
        (tj, R::from(2) * tj, jm * tj)
    } else {
        let tj = *full_tj.get_or_insert_with(|| am / jm);
        (tj, tj + dv / am, am)
    }
}

/// The trial acceleration and the step at which the search from `am` has to look closely, as the rounds before are plain,
/// and whether it is just as plain that it ends there with a single ramp.
///
/// A round that goes on needs only its verdict. With `k = am^2/jm`, `s = v0 + v1` and `w = |v0 - v1|` its root is that of
/// `r = (k - s)^2 + w^2 + 4 p am`, and its shorter ramp lasts `(k + sqrt(r) - (s + w)) / (2 am)`, which is too steep from 0
/// to below `2 am/jm`. So `sqrt(r)` is compared with `x = s + w - k` and `x = s + w + 3 k`, or, as `r >= x^2` where `x < 0`,
/// just `r` with `x^2`: too steep is `-w k <= 2 p am - w s < k (4 k + 4 s + 3 w)`. This takes no root, and one division
/// for all rounds.
///
/// With `size = 2 p am + 4 k^2 + 2 (v0^2 + v1^2)` and `u = EPSILON/2`, rounding moves these comparisons by at most
/// 31 `u size` in the round itself and 20 `u size` here: a difference of more than 128 `u size` is beyond doubt. The guards
/// keep off overflow and what underflow could move. `docs/search.md` has the proof.
fn skip_plain_rounds<R: Real>(jm: R, am: R, p: R, v0: R, v1: R) -> (R, R, bool) {
    let (mut trial, mut step) = (am, am);
    let coarse = am * R::SIXTEENTH;
    let eps = R::EPSILON;
    // So long a search is settled when its step runs out, so its last round writes all durations.
    let long = coarse >= R::from(4) * eps;
    if R::CHEAP_ROOT || !(long && p >= eps) {
        return (trial, step, false);
    }
    let two = R::from(2);
    let s = v0 + v1;
    let w = (v0 - v1).magnitude();
    let half_w = R::HALF * w;
    let ws = w * s;
    let slope = two * s + (w + half_w);
    let q = two * (v0 * v0 + v1 * v1);
    let two_p = two * p;
    let two_per_jm = two / jm;
    let huge = R::from(1) / (eps * eps * eps * eps);
    loop {
        let k2 = trial * two_per_jm * trial;
        let distance = two_p * trial;
        let size = distance + k2 * k2 + q;
        let doubt = R::from(64) * eps * size;
        let excess = distance - ws;
        let above_shortest = excess + half_w * k2;
        let below_longest = k2 * (k2 + slope) - excess;
        let margin = if below_longest < above_shortest {
            below_longest
        } else {
            above_shortest
        };
        let next = step * R::HALF;
        if !(size < huge && next > eps) {
            return (trial, step, false);
        }
        if margin > doubt {
            trial = trial - next;
        } else if margin < -doubt && trial != am && step >= coarse {
            trial = trial + next;
        } else {
            return (trial, step, above_shortest < -doubt);
        }
        step = next;
    }
}

/// A ramp that covers the distance `p` alone, with `s` the sum and `dv` the difference of its end velocities: its
/// duration, and the duration of its jerk part if there is a real one.
fn only_ramp<R: Real>(jm: R, p: R, s: R, dv: R) -> (R, Option<R>) {
    let duration = R::from(2) * p / s;
    let m = jm * p;
    let w = jm * (m * p + dv * s * s);
    // Not `w >= 0`: a NaN goes on, as in the C function.
    let tj = if w < R::from(0) {
        None
    } else {
        Some((m - w.sqrt()) / (jm * s))
    };
    (duration, tj)
}
