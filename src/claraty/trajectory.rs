//! A trajectory in time: start, stop, reset, and the setpoint of whichever leg the time falls into.

use super::{Profile, Route, Target, Timer, Warnings};
use crate::state::State;

/// Which profile a trajectory follows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// What CLARAty's class documents.
    #[default]
    Corrected = 0,
    /// What its published listing computes. Waypoints, which the listing leaves empty, follow corrected profiles.
    Listing = 1,
}

/// The motion of one axis. `now` is always a reading of the same clock, in seconds.
#[derive(Clone, Copy, Debug, Default)]
pub struct Trajectory<'w> {
    mode: Mode,
    route: Route<'w>,
    timer: Timer,
    started: bool,
    /// Where the motion began, to walk the route again when time goes back.
    departure: State<f64>,
    /// Whether the motion follows `route`; else it is the one leg in hand.
    on_route: bool,
    leg: usize,
    leg_start: f64,
    profile: Profile,
    duration: f64,
}

impl<'w> Trajectory<'w> {
    /// Not started, at position 0, with the timer at zero.
    pub fn new(mode: Mode, now: f64) -> Self {
        let mut trajectory = Self {
            mode,
            ..Self::default()
        };
        trajectory.timer.restart(now);
        trajectory
    }

    /// The profile of the following starts and stops.
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// Chooses the profile of the following starts and stops.
    pub fn set_mode(&mut self, mode: Mode) {
        self.mode = mode;
    }

    /// Stores where to go next; it moves nothing before [`Self::start`]. A motion along waypoints lets go of them here: it
    /// ends at rest at the waypoint it is heading for.
    pub fn set(&mut self, route: Route<'w>, now: f64) {
        self.seek(self.elapsed(now));
        self.duration = self.leg_start + self.profile.tf;
        self.on_route = false;
        self.leg = 0;
        self.route = route;
    }

    /// Sets off, timer at zero: from the setpoint if a motion is under way, else from rest at 0.
    pub fn start(&mut self, now: f64) -> Warnings {
        self.departure = self.under_way(now).unwrap_or_default();
        self.timer.restart(now);
        self.started = true;
        self.on_route = true;
        let mut warnings = self.first_leg();
        while let Some(more) = self.next_leg() {
            warnings |= more;
        }
        self.duration = self.leg_start + self.profile.tf;
        self.seek(0.0);
        warnings
    }

    /// Brakes a motion under way; sets the timer to zero either way.
    pub fn stop(&mut self, now: f64) -> Warnings {
        let under_way = self.under_way(now);
        self.timer.restart(now);
        let (Some(state), Some(limits)) = (under_way, self.route.target(self.leg)) else {
            return Warnings::default();
        };
        self.started = true;
        self.on_route = false;
        self.leg_start = 0.0;
        let warnings = match self.mode {
            Mode::Listing => {
                let here = Target {
                    position: state.position,
                    velocity: state.velocity,
                    ..limits
                };
                self.profile.plan_listing(state, here)
            }
            Mode::Corrected => self.profile.plan_stop(state, limits),
        };
        self.duration = self.profile.tf;
        warnings
    }

    /// Forgets that a motion is under way and sets the timer to zero; the last profile stays readable.
    pub fn reset(&mut self, now: f64) {
        self.started = false;
        self.timer.restart(now);
    }

    /// Whether a motion is under way. Stays true after its end until the setpoint has been read there.
    pub fn is_started(&self) -> bool {
        self.started
    }

    /// Time since the last start, stop or reset, s.
    pub fn elapsed(&self, now: f64) -> f64 {
        self.timer.elapsed(now)
    }

    /// Moves the timer forward (or back) against its clock.
    pub fn advance_timer_by(&mut self, seconds: f64) {
        self.timer.advance_by(seconds);
    }

    /// Goes over to a clock that shows `instead` at the moment the present one shows `now`. A motion under way goes on
    /// from where it is; otherwise the timer starts from zero.
    pub fn change_clock(&mut self, now: f64, instead: f64) {
        if self.started {
            self.timer.change_clock(now, instead);
        } else {
            self.timer.restart(instead);
        }
    }

    /// Time from start to rest, all legs together, s; 0 before the first start.
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// The profile of the last start or stop; along waypoints that of the leg last looked at, its times counted from the
    /// start of the leg.
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// The setpoint now. Reading it after the end of the motion ends the motion.
    pub fn setpoint(&mut self, now: f64) -> State<f64> {
        let t = self.elapsed(now);
        let setpoint = self.look(t);
        self.end_at(t);
        setpoint
    }

    /// The setpoint at time `t` after the start, s. In listing mode a look beyond the end ends the motion, as the listing
    /// has it; else a look changes nothing.
    pub fn setpoint_at(&mut self, t: f64) -> State<f64> {
        let setpoint = self.look(t);
        if self.mode == Mode::Listing {
            self.end_at(t);
        }
        setpoint
    }

    /// The state to carry on from.
    fn under_way(&mut self, now: f64) -> Option<State<f64>> {
        let was_started = self.started;
        let setpoint = self.setpoint(now);
        let under_way = match self.mode {
            // Sic: the listing carries on from a motion that is over if nobody has looked since.
            Mode::Listing => was_started,
            Mode::Corrected => self.started,
        };
        // The acceleration of a trapezoid may jump, so the motion does not carry it on.
        under_way.then_some(State {
            acceleration: 0.0,
            ..setpoint
        })
    }

    fn look(&mut self, t: f64) -> State<f64> {
        if self.mode == Mode::Listing && t < 0.0 {
            return State::default();
        }
        self.seek(t);
        self.profile.setpoint(t - self.leg_start)
    }

    fn end_at(&mut self, t: f64) {
        if self.leg_is_over(t) {
            self.started = false;
        }
    }

    fn leg_is_over(&self, t: f64) -> bool {
        self.profile.is_over(t - self.leg_start)
    }

    /// Takes the leg in hand that `t` falls into.
    fn seek(&mut self, t: f64) {
        if !self.on_route {
            return;
        }
        if t < self.leg_start && self.leg > 0 {
            self.first_leg();
        }
        while self.leg_is_over(t) && self.next_leg().is_some() {}
    }

    fn first_leg(&mut self) -> Warnings {
        self.leg = 0;
        self.leg_start = 0.0;
        match (&self.route, self.mode) {
            (&Route::Target(target), Mode::Listing) => {
                self.profile.plan_listing(self.departure, target)
            }
            (route, _) => {
                let target = route.target(0).unwrap_or_default();
                self.profile.plan_corrected(self.departure, target)
            }
        }
    }

    /// From rest at the end of the leg in hand; `None` after the last leg.
    fn next_leg(&mut self) -> Option<Warnings> {
        let target = self.route.target(self.leg + 1)?;
        let rest = State {
            position: self.profile.final_position,
            ..State::default()
        };
        self.leg += 1;
        self.leg_start += self.profile.tf;
        Some(self.profile.plan_corrected(rest, target))
    }
}
