//! Following a signal: the plan of one tick.

use super::blend::Blend;
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::online::Move;
use crate::online::problem::Problem;
use crate::real::Real;
use crate::state::State;

impl<R: Real> Move<R> {
    /// Plans the motion of one tick of an axis that follows a signal. Call it in every tick with the state of the axis and with the position,
    /// velocity and acceleration of the signal, drive one tick of the plan, and call it again.
    ///
    /// The signal is taken to go on with its acceleration. Where the axis can be beside the signal after the time `horizon`, s, it gets there
    /// in just this time, and `t` is `horizon`: the answer changes evenly with the signal, so noise does not switch the jerk. Where the signal
    /// is farther, the axis meets it as fast as it can, as [`Move::meet`] does. A signal beyond the limits is followed as well as
    /// they allow.
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
    ///     axis.track(&limits, now, signal, 0.03)?;
    ///     now = axis.state_at(0.001); // one tick later
    /// }
    /// assert!((now.position - 6.0_f64.sin()).abs() < 1e-5);
    /// # Ok::<(), atraj::Error>(())
    /// ```
    pub fn track(
        &mut self,
        limits: &Limits<R>,
        from: State<R>,
        signal: State<R>,
        horizon: R,
    ) -> Result<Findings, Error> {
        if !(horizon > R::ZERO && horizon.is_finite()) {
            return Err(Error::Duration);
        }
        limits.check(from, State::at(signal.position))?;
        if !signal.is_finite() {
            return Err(Error::NotFinite);
        }
        let uniform = State {
            acceleration: R::ZERO,
            ..signal
        };
        for signal in [signal, uniform] {
            if let Some(found) = self.be_beside(limits, from, signal, horizon) {
                return Ok(found);
            }
        }
        // A signal on a limit, or beyond it, cannot be met.
        let fastest = State {
            velocity: signal.velocity.at_least(limits.vmin).at_most(limits.vmax),
            ..uniform
        };
        self.meet(limits, from, uniform)
            .or_else(|_| self.plan(limits, from, fastest))
    }

    /// Plans to be beside the signal after the time `horizon`, if this is possible.
    fn be_beside(
        &mut self,
        limits: &Limits<R>,
        from: State<R>,
        signal: State<R>,
        horizon: R,
    ) -> Option<Findings> {
        let to = signal.after(horizon);
        limits.check(from, to).ok()?;
        let problem = Problem::new(limits, from, to);
        let mut planned = Self::default();
        Blend::within(&problem, horizon)?.write(&problem, &mut planned, horizon);
        if !planned.is_finite() {
            return None;
        }
        *self = planned;
        Some(problem.findings(self))
    }
}
