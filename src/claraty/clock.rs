//! The timer of a trajectory. The caller reads the clock.

/// Seconds since the last restart.
///
/// Time added by hand counts as time on the clock: a clock that stands still and is advanced gives the bits of a clock that runs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Timer {
    origin: f64,
    advanced: f64,
}

/// An `f64` of this size still resolves a tenth of a nanosecond. A restart drops a longer advance, because the sum of the advance
/// and the clock would lose digits of the clock.
const LONGEST_ADVANCE: f64 = 1e6;

impl Timer {
    /// The timer shows zero at `now`. If `now` is not finite, the timer goes on unchanged.
    pub fn restart(&mut self, now: f64) {
        if !now.is_finite() {
            return;
        }
        if self.advanced.abs() > LONGEST_ADVANCE {
            self.advanced = 0.0;
        }
        self.origin = now + self.advanced;
    }

    /// Time shown at `now`, s.
    pub fn elapsed(&self, now: f64) -> f64 {
        now + self.advanced - self.origin
    }

    /// Adds `seconds` to what the clock shows, until the next restart at least. An advance that overflows is ignored.
    pub fn advance_by(&mut self, seconds: f64) {
        let advanced = self.advanced + seconds;
        if advanced.is_finite() {
            self.advanced = advanced;
        }
    }

    /// Another clock, which shows `instead`, replaces the clock that shows `now`. The timer goes on at the same reading.
    pub fn change_clock(&mut self, now: f64, instead: f64) {
        let elapsed = self.elapsed(now);
        self.restart(instead);
        self.origin -= elapsed;
    }
}
