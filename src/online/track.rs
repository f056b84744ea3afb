//! Following a signal: the plan of the next moments.
//!
//! All is planned for the distance `e = x - s` of the axis `x` from the signal `s`, which is to come to rest at 0. The signal goes on with its jerk,
//! so nothing disturbs the next plan, and an axis without a distance keeps none. `docs/planner.md` has the theory, in "Following a signal".

use super::motion::Move;
use super::phase::Phase;
use super::problem::Problem;
use super::write::Writer;
use crate::findings::{Error, Findings};
use crate::interval::{profile::Segment, rounding::of_formula};
use crate::limits::Limits;
use crate::real::Real;
use crate::state::State;

impl<R: Real> Move<R> {
    /// Plans the next moments of an axis that follows a signal. Call it in every tick with the state of the axis and of the signal, drive one tick
    /// of the plan, and call it again. `jerk` is the jerk of the signal, 0 if nobody knows it.
    ///
    /// The signal is taken to go on with its jerk for the time `horizon`, s. If the axis can meet it after this time, the move lasts exactly this long
    /// and varies smoothly with the signal, so noise does not make the jerk chatter. An axis that is on a signal at rest or at a constant velocity
    /// stays on it. A signal that is farther away is chased with whatever limits the signal leaves over.
    ///
    /// The plan of an axis next to the signal lasts for `horizon`, s. It keeps the limits, and the axis can keep them from then on. The plan of a chase
    /// lasts longer: until the axis is on a signal of constant velocity, or has stopped. A signal beyond the limits is followed as well as they allow;
    /// the plan then lasts as long as [`Move::plan`] takes to where the signal is now. A longer horizon smooths more. A jerk that is
    /// estimated from noisy data must be filtered first.
    ///
    /// It returns the findings of [`Move::plan`]. [`Error::Duration`] if `horizon` is not above 0 and finite, [`Error::Limits`] and
    /// [`Error::NotFinite`] as in [`Move::plan`]. Any other signal is followed. On an error the move stays as it is.
    ///
    /// ```
    /// use atraj::online::{Limits, Move, State};
    /// let limits = Limits::symmetric(150.0, 15.0, 3.0);
    /// let (mut axis, mut now) = (Move::default(), State::at(0.0));
    /// for tick in 0..3000 {
    ///     let t = f64::from(tick) * 0.001;
    ///     let (sin, cos) = (2.0 * t).sin_cos();
    ///     let signal = State { position: sin, velocity: 2.0 * cos, acceleration: -4.0 * sin };
    ///     axis.track(&limits, now, signal, -8.0 * cos, 0.03)?;
    ///     now = axis.state_at(0.001); // one tick later
    /// }
    /// assert!((now.position - 6.0_f64.sin()).abs() < 1e-6);
    /// # Ok::<(), atraj::Error>(())
    /// ```
    pub fn track(
        &mut self, limits: &Limits<R>, from: State<R>, signal: State<R>, jerk: R, horizon: R,
    ) -> Result<Findings, Error> {
        Error::Duration.unless(horizon > R::ZERO && horizon.is_finite())?;
        limits.check(from, State::at(signal.position))?;
        Error::NotFinite.unless(signal.is_finite() && jerk.is_finite())?;
        let State { position, velocity: v, acceleration: a } = signal;
        // A signal on a limit of the velocity, or beyond it, leaves nothing. A little less leaves enough to stay on it.
        let most = R::ONE - R::SIXTEENTH * R::SIXTEENTH * R::SIXTEENTH;
        let slower = v.at_least(most * limits.vmin).at_most(most * limits.vmax);
        let zero = R::ZERO;
        for (velocity, acceleration, jerk) in [(v, a, jerk), (v, a, zero), (v, zero, zero), (slower, zero, zero)] {
            let signal = Phase { position, velocity, acceleration, jerk, ..Phase::default() };
            let approach = Approach { limits, from, signal, horizon };
            let near = approach.near();
            let planned = if near.keeps(limits) { Some(near) } else { approach.chase() };
            if let Some(planned) = planned {
                *self = planned;
                return Ok(self.turn_findings());
            }
        }
        self.plan(limits, from, State { position, velocity: slower, acceleration: zero })
    }

    /// Whether the move keeps the limits, up to the rounding errors of its highest velocity and acceleration, and can keep them from then on.
    fn keeps(&self, limits: &Limits<R>) -> bool {
        let reached = self.extremes();
        let within = |x: R, low: R, high: R, size: R| (low - x).at_least(x - high) <= R::DOUBT * size;
        let [speed, acceleration] = [reached.speed(), reached.acceleration()];
        // The states of a tracked move are sums from the start.
        self.end().is_finite()
            && self.is_finite()
            && self.phases().iter().all(|phase| within(phase.jerk, limits.jmin, limits.jmax, phase.jerk.abs()))
            && [reached.lowest, reached.highest].into_iter().all(|state| {
                within(state.velocity, limits.vmin, limits.vmax, speed)
                    && within(state.acceleration, limits.amin, limits.amax, acceleration)
            })
            && !limits.are_left_after(self.end())
    }
}

/// The approach of an axis to a signal that goes on with its jerk.
struct Approach<'a, R> {
    limits: &'a Limits<R>,
    from: State<R>,
    signal: Phase<R>,
    /// s
    horizon: R,
}

impl<R: Real> Approach<'_, R> {
    /// The distance at the start, with its derivatives.
    fn distance(&self) -> State<R> {
        let (from, signal) = (self.from, self.signal.state());
        State {
            position: from.position - signal.position,
            velocity: from.velocity - signal.velocity,
            acceleration: from.acceleration - signal.acceleration,
        }
    }

    /// The distance comes to rest after the horizon, by three jerks of equal duration. They are linear in the distance, so noise does not switch them.
    fn near(&self) -> Move<R> {
        let distance = self.distance();
        let third = self.horizon / R::from(3);
        // With the time in thirds of the horizon.
        let a = distance.acceleration / third * R::SIXTH;
        let v = distance.velocity / third / third;
        let x = distance.position / third / third / third;
        let [two, three] = [2, 3].map(R::from);
        let jerks = [-(x + two * v + R::from(11) * a), two * x + three * v + R::from(7) * a, -(x + v + two * a)];
        let [first, _, last] = jerks;
        let accelerations = [distance.acceleration, distance.acceleration + third * first, -third * last];
        let mut planned = Move::default();
        let mut writer = Writer::new(&mut planned, distance);
        for (from, jerk) in accelerations.into_iter().zip(jerks) {
            writer.write(&Segment::new(from, jerk, third));
        }
        writer.end(State::at(R::ZERO));
        planned.end_at(self.horizon);
        planned.add(&self.signal, self.from);
        planned
    }

    /// The distance comes to rest as fast as it can within what the signal leaves of the limits. `None` if it leaves nothing, or too little. Where the
    /// signal accelerates, the axis stops after the horizon: nobody knows what the signal does by then, and a late next plan must not let the axis go on.
    fn chase(&self) -> Option<Move<R>> {
        let left = self.left();
        left.are_limits().ok()?;
        let positions = self.from.position.abs() + self.signal.position.abs();
        let distance = self.distance();
        let mut planned = Move::default();
        // An axis that comes to rest within 8 ulps of the signal stays: where a tick's way is a rounding error, it would set off again and again.
        if State::at(distance.position) == distance && distance.position.abs() <= of_formula(positions + positions) {
            planned.stay(distance);
        } else {
            let problem =
                Problem::new(&left, &distance, &State::at(R::ZERO)).with_positions(R::HALF * R::HALF * positions);
            problem.write(&mut planned, &problem.fastest()).ok()?;
        }
        let is_uniform = self.signal.acceleration == R::ZERO && self.signal.jerk == R::ZERO;
        let arrives = planned.t <= self.horizon;
        planned.cut(if is_uniform { planned.t.at_least(self.horizon) } else { self.horizon });
        planned.add(&self.signal, self.from);
        if !(is_uniform || arrives) {
            let mut stop = Move::default();
            stop.stop(self.limits, planned.end()).ok()?;
            planned.append(&stop).ok()?;
        }
        planned.keeps(self.limits).then_some(planned)
    }

    /// What the signal leaves of the limits until the horizon, and not all of it: the more the signal needs now, the less, but at least a half of a
    /// limit. The signal needs more at other times, and a distance that had used all could not stop then.
    fn left(&self) -> Limits<R> {
        let Self { limits, signal, horizon, .. } = *self;
        let Phase { velocity: v, acceleration: a, jerk, .. } = signal;
        let (to_v, to_a, peak) = (signal.velocity(horizon), signal.acceleration(horizon), -a / jerk);
        let peak = if peak > R::ZERO && peak < horizon { signal.velocity(peak) } else { v };
        let (least_a, least_j) = (limits.amax.at_most(-limits.amin), limits.jmax.at_most(-limits.jmin));
        let need = (a.abs() / least_a).at_least(jerk.abs() / least_j);
        let share = R::ONE - (need + need).at_most(R::HALF);
        let above = |limit: R, most: R| (limit - most).at_most(share * limit);
        let below = |limit: R, least: R| (limit - least).at_least(share * limit);
        Limits {
            vmax: limits.vmax - v.at_least(to_v).at_least(peak),
            vmin: limits.vmin - v.at_most(to_v).at_most(peak),
            amax: above(limits.amax, a.at_least(to_a)),
            amin: below(limits.amin, a.at_most(to_a)),
            jmax: above(limits.jmax, jerk),
            jmin: below(limits.jmin, jerk),
        }
    }
}
