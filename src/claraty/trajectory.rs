//! A trajectory in time: start, stop, reset, and the setpoint of the leg that the time falls into.

use super::{OutOfRange, Profile, Route, Target, Warnings};
use crate::state::State;

/// The profile that a trajectory follows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// The motion that CLARAty's class documents.
    #[default]
    Corrected = 0,
    /// The motion that CLARAty's published listing computes, infinite and NaN setpoints included. The listing leaves waypoints
    /// empty; here their legs are corrected motions.
    Listing = 1,
}

/// The clock still resolves a tenth of a nanosecond after an advance of this length, s. A restart drops a longer one.
const LONGEST_ADVANCE: f64 = 1e6;

/// The motion of one axis. `now` is always a finite reading of the same clock, in seconds.
#[derive(Clone, Copy, Debug, Default)]
pub struct Trajectory<'w> {
    mode: Mode,
    motion_mode: Mode,
    route: Route<'w>,
    /// What the clock showed, advances included, when the timer was at zero, s.
    origin: f64,
    /// Time added by hand, s: a clock that stands still and is advanced gives the bits of a clock that runs.
    advanced: f64,
    started: bool,
    /// Where the motion began. The route is walked again from here when time goes back.
    departure: State<f64>,
    /// Whether the motion follows `route`. If not, the motion is the leg in hand.
    on_route: bool,
    leg: usize,
    leg_start: f64,
    profile: Profile,
    duration: f64,
}

impl<'w> Trajectory<'w> {
    /// The trajectory is not started, at position 0, with the timer at zero.
    pub fn new(mode: Mode, now: f64) -> Self {
        let mut trajectory = Self { mode, motion_mode: mode, ..Self::default() };
        trajectory.restart(now);
        trajectory
    }

    /// The mode of the following starts and stops.
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// The mode of the motion under way. If no motion is under way, it is the mode of the following starts and stops.
    pub fn motion_mode(&self) -> Mode {
        self.motion_mode
    }

    /// Chooses the mode of the following starts and stops. A motion under way keeps its mode.
    pub fn set_mode(&mut self, mode: Mode) {
        self.mode = mode;
        if !self.started {
            self.motion_mode = mode;
        }
    }

    /// Stores where to go next. Nothing moves before [`Self::start`]. A motion along waypoints lets go of the waypoints: it ends at
    /// rest at the waypoint ahead.
    ///
    /// A number beyond [`LARGEST`](super::LARGEST), infinite or NaN is refused, and the trajectory stays as it was.
    pub fn set(&mut self, route: Route<'w>, now: f64) -> Result<(), OutOfRange> {
        route.check_range()?;
        self.seek(self.elapsed(now));
        self.duration = self.leg_start + self.profile.tf;
        self.on_route = false;
        self.leg = 0;
        self.route = route;
        Ok(())
    }

    /// Sets off with the timer at zero. The motion begins at the setpoint if a motion is under way, else at rest at 0.
    pub fn start(&mut self, now: f64) -> Warnings {
        self.departure = self.under_way(now).unwrap_or_default();
        self.restart(now);
        self.motion_mode = self.mode;
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

    /// Brakes a motion under way. The timer is set to zero also if no motion is under way.
    pub fn stop(&mut self, now: f64) -> Warnings {
        let under_way = self.under_way(now);
        self.restart(now);
        let (Some(state), Some(limits)) = (under_way, self.route.target(self.leg)) else { return Warnings::default() };
        self.motion_mode = self.mode;
        self.started = true;
        self.on_route = false;
        self.leg_start = 0.0;
        let here = Target { position: state.position, velocity: state.velocity, ..limits };
        let warnings = match self.mode {
            Mode::Listing => self.profile.plan_listing(state, here),
            Mode::Corrected => self.profile.plan_stop(state, here),
        };
        self.duration = self.profile.tf;
        warnings
    }

    /// Forgets the motion and sets the timer to zero. The last profile stays readable. If `now` is not finite, the timer goes on unchanged.
    pub fn reset(&mut self, now: f64) {
        self.started = false;
        self.restart(now);
    }

    /// Whether a motion is under way: from the start until a setpoint after the end has been read.
    pub fn is_started(&self) -> bool {
        self.started
    }

    /// Time since the last start, stop or reset, s.
    pub fn elapsed(&self, now: f64) -> f64 {
        now + self.advanced - self.origin
    }

    /// Adds `seconds` to what the clock shows. An advance that overflows is ignored. The next start, stop or reset drops an advance
    /// of more than 10<sup>6</sup> s, because the clock would lose digits next to it.
    pub fn advance_timer_by(&mut self, seconds: f64) {
        let advanced = self.advanced + seconds;
        if advanced.is_finite() {
            self.advanced = advanced;
        }
    }

    /// Another clock, which shows `instead`, replaces the clock that shows `now`. A motion under way goes on where it is. If no
    /// motion is under way, or if a reading is not finite, the change is a [`Self::reset`].
    pub fn change_clock(&mut self, now: f64, instead: f64) {
        let elapsed = self.elapsed(now);
        if self.started && elapsed.is_finite() && instead.is_finite() {
            self.restart(instead);
            self.origin -= elapsed;
        } else {
            self.reset(instead);
        }
    }

    /// Time from the start to rest, over all legs, s. It is 0 before the first start.
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// The profile of the last start or stop. Along waypoints it is the profile of the leg last looked at, and its times count from the start of this leg.
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// The setpoint now. A reading after the end of the motion ends the motion.
    pub fn setpoint(&mut self, now: f64) -> State<f64> {
        let t = self.elapsed(now);
        let setpoint = self.look(t);
        self.started &= !self.leg_is_over(t);
        setpoint
    }

    /// The setpoint at time `t` after the start, s. In a corrected motion a look changes nothing. In a motion of the listing a look
    /// beyond the end ends the motion, as in the listing.
    pub fn setpoint_at(&mut self, t: f64) -> State<f64> {
        let setpoint = self.look(t);
        if self.motion_mode == Mode::Listing {
            self.started &= !self.leg_is_over(t);
        }
        setpoint
    }

    /// Sets the timer to zero. If `now` is not finite, the timer goes on unchanged.
    fn restart(&mut self, now: f64) {
        if !now.is_finite() {
            return;
        }
        if self.advanced.abs() > LONGEST_ADVANCE {
            self.advanced = 0.0;
        }
        self.origin = now + self.advanced;
    }

    fn under_way(&mut self, now: f64) -> Option<State<f64>> {
        let was_started = self.started;
        let setpoint = self.setpoint(now);
        let under_way = match self.mode {
            // Sic: the listing carries on from the end of a motion if nobody has read a setpoint since.
            Mode::Listing => was_started,
            Mode::Corrected => self.started,
        };
        // The acceleration of a trapezoid may jump, so the next motion does not continue it.
        under_way.then_some(State { acceleration: 0.0, ..setpoint })
    }

    fn look(&mut self, t: f64) -> State<f64> {
        if self.motion_mode == Mode::Listing && t < 0.0 {
            return State::default();
        }
        self.seek(t);
        self.profile.setpoint(t - self.leg_start)
    }

    fn leg_is_over(&self, t: f64) -> bool {
        self.profile.is_over(t - self.leg_start)
    }

    /// Takes the leg in hand into which `t` falls.
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
        match (&self.route, self.motion_mode) {
            (&Route::Target(target), Mode::Listing) => self.profile.plan_listing(self.departure, target),
            (route, _) => self.profile.plan_corrected(self.departure, route.target(0).unwrap_or_default()),
        }
    }

    /// Takes the next leg in hand, from rest at the end of the present leg. The result is `None` after the last leg.
    fn next_leg(&mut self) -> Option<Warnings> {
        let target = self.route.target(self.leg + 1)?;
        let rest = State { position: self.profile.final_position, ..State::default() };
        self.leg += 1;
        self.leg_start += self.profile.tf;
        Some(self.profile.plan_corrected(rest, target))
    }
}
