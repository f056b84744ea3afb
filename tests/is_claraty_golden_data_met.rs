//! Does the listing's mode give every profile, setpoint, warning and *started* of the golden data, script by script and bit
//! for bit?

use atraj::State;
use atraj::claraty::{Mode, Target, Trajectory, Warnings};
use support::golden::cells;
use support::{Comparison, Real};

const SCRIPTS: usize = 270;
const PROFILE: [&str; 9] = [
    "t1", "t2", "tf", "p_at_t1", "p_at_t2", "p_f", "v_m", "a", "d",
];
const SETPOINT: [&str; 3] = ["position", "velocity", "acceleration"];

/// Scripts run one after the other on a clock that stands still. Nothing but the timer moves.
const NOW: f64 = 0.0;

/// A golden row: the script, an operation with its arguments, and the outcome.
struct Row {
    place: String,
    cells: Vec<String>,
}

/// What an operation gave.
enum Outcome {
    Nothing,
    Warnings(Warnings),
    Setpoint(State<f64>),
}

impl Row {
    fn bits(&self, column: usize) -> f64 {
        let cell = &self.cells[column];
        f64::parse(cell).unwrap_or_else(|| panic!("{}: column {column}", self.place))
    }

    /// Does the operation.
    fn run(&self, axis: &mut Trajectory) -> Outcome {
        match self.cells[1].as_str() {
            "set" => axis.set(self.target().into(), NOW).unwrap(),
            "start" => return Outcome::Warnings(axis.start(NOW)),
            "stop" => return Outcome::Warnings(axis.stop(NOW)),
            "reset" => axis.reset(NOW),
            "advance" => axis.advance_timer_by(self.bits(2)),
            "get" => return Outcome::Setpoint(axis.setpoint(NOW)),
            "get_at" => return Outcome::Setpoint(axis.setpoint_at(self.bits(2))),
            other => panic!("{}: unknown operation {other:?}", self.place),
        }
        Outcome::Nothing
    }

    fn target(&self) -> Target {
        Target {
            position: self.bits(2),
            velocity: self.bits(3),
            acceleration: self.bits(4),
            deceleration: self.bits(5),
        }
    }

    fn compare(&self, axis: &Trajectory, outcome: Outcome, comparison: &mut Comparison) {
        let [place, operation] = [&self.place, &self.cells[1]];
        let [has_profile, has_setpoint] = [6, 18].map(|column| !self.cells[column].is_empty());
        let plans = operation == "start" || (operation == "stop" && axis.is_started());
        assert_eq!(has_profile, plans, "{place}: golden profile");
        let gives_setpoint = matches!(outcome, Outcome::Setpoint(_));
        assert_eq!(has_setpoint, gives_setpoint, "{place}: setpoint");
        let started = u8::from(axis.is_started());
        assert_eq!(started.to_string(), self.cells[16], "{place}: started");
        match outcome {
            Outcome::Warnings(warnings) if plans => {
                self.compare_profile(axis, warnings, comparison);
            }
            Outcome::Setpoint(setpoint) => self.compare_setpoint(setpoint, comparison),
            _ => {}
        }
    }

    fn compare_profile(&self, axis: &Trajectory, warnings: Warnings, comparison: &mut Comparison) {
        let place = &self.place;
        for (i, (name, got)) in PROFILE.into_iter().zip(profile(axis)).enumerate() {
            comparison.check(place, name, got, self.bits(6 + i));
        }
        let kind = axis.profile().kind as u8;
        assert_eq!(kind.to_string(), self.cells[15], "{place}: type");
        assert_eq!(
            warnings.bits().to_string(),
            self.cells[17],
            "{place}: warnings"
        );
    }

    fn compare_setpoint(&self, setpoint: State<f64>, comparison: &mut Comparison) {
        let setpoint = [setpoint.position, setpoint.velocity, setpoint.acceleration];
        for (i, (name, got)) in SETPOINT.into_iter().zip(setpoint).enumerate() {
            comparison.check(&self.place, name, got, self.bits(18 + i));
        }
    }
}

fn profile(axis: &Trajectory) -> [f64; 9] {
    let p = axis.profile();
    [
        p.t1,
        p.t2,
        p.tf,
        p.p_at_t1,
        p.p_at_t2,
        p.final_position,
        p.velocity,
        p.acceleration,
        p.deceleration,
    ]
}

#[test]
fn listing() {
    let mut comparison = Comparison::default();
    let mut axis = Trajectory::default();
    let mut script = None;
    let mut scripts = 0;
    for (place, cells) in cells("claraty_listing_f64.csv", 21) {
        let row = Row { place, cells };
        if script.as_ref() != Some(&row.cells[0]) {
            script = Some(row.cells[0].clone());
            scripts += 1;
            axis = Trajectory::new(Mode::Listing, NOW);
        }
        let outcome = row.run(&mut axis);
        row.compare(&axis, outcome, &mut comparison);
    }
    assert_eq!(scripts, SCRIPTS);
    comparison.finish("listing");
}
