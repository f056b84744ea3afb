//! The timer of a trajectory, over whatever clock the caller reads.

/// Seconds since the last restart. Time added by hand counts as time on the clock, so that a clock that stands still and is
/// advanced gives the bits of one that runs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Timer {
    origin: f64,
    advanced: f64,
}

impl Timer {
    /// Reads zero at `now`.
    pub fn restart(&mut self, now: f64) {
        self.origin = now + self.advanced;
    }

    /// Time shown at `now`, s.
    pub fn elapsed(&self, now: f64) -> f64 {
        now + self.advanced - self.origin
    }

    /// Adds `seconds` to what the clock gives.
    pub fn advance_by(&mut self, seconds: f64) {
        self.advanced += seconds;
    }

    /// Goes on at the same reading when the clock that shows `now` is replaced by one that shows `instead`.
    pub fn change_clock(&mut self, now: f64, instead: f64) {
        let elapsed = self.elapsed(now);
        self.restart(instead);
        self.origin -= elapsed;
    }
}
