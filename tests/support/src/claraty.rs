//! Moves of CLARAty's trapezoid, in few words.

use atraj::State;
use atraj::claraty::{Profile, Target, Warnings};

pub fn target([position, velocity, acceleration, deceleration]: [f64; 4]) -> Target {
    Target { position, velocity, acceleration, deceleration }
}

pub fn moving(position: f64, velocity: f64) -> State<f64> {
    State { velocity, ..State::at(position) }
}

pub fn corrected(start: State<f64>, target: Target) -> (Profile, Warnings) {
    let mut profile = Profile::default();
    let warnings = profile.plan_corrected(start, target);
    (profile, warnings)
}

pub fn borders(profile: &Profile) -> [f64; 3] {
    [profile.t1, profile.t2, profile.tf]
}
