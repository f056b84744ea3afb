//! The listing's behaviour, script by script: every profile, setpoint, warning and *started* of the golden data, bit for
//! bit.

use atraj::claraty::{Mode, Target, Trajectory, Warnings};
use support::golden::cells;
use support::{Comparison, Real};

const SCRIPTS: usize = 270;
const PROFILE: [&str; 9] = [
    "t1", "t2", "tf", "p_at_t1", "p_at_t2", "p_f", "v_m", "a", "d",
];
const SETPOINT: [&str; 3] = ["position", "velocity", "acceleration"];

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
    // Scripts run one after the other on a clock that stands still; only the timer moves.
    let now = 0.0;
    for (place, row) in cells("claraty_listing_f64.csv", 21) {
        let bits = |column: usize| {
            f64::parse(&row[column]).unwrap_or_else(|| panic!("{place}: column {column}"))
        };
        if script.as_ref() != Some(&row[0]) {
            script = Some(row[0].clone());
            scripts += 1;
            axis = Trajectory::new(Mode::Listing, now);
        }
        let mut warnings = Warnings::default();
        let mut setpoint = None;
        match row[1].as_str() {
            "set" => {
                let target = Target {
                    position: bits(2),
                    velocity: bits(3),
                    acceleration: bits(4),
                    deceleration: bits(5),
                };
                axis.set(target.into(), now);
            }
            "start" => warnings = axis.start(now),
            "stop" => warnings = axis.stop(now),
            "reset" => axis.reset(now),
            "advance" => axis.advance_timer_by(bits(2)),
            "get" => setpoint = Some(axis.setpoint(now)),
            "get_at" => setpoint = Some(axis.setpoint_at(bits(2))),
            other => panic!("{place}: unknown operation {other:?}"),
        }
        let mut compare = |what: &str, got: f64, column: usize| {
            comparison.check(&place, what, got, bits(column));
        };
        let planned = !row[6].is_empty();
        let plans = row[1] == "start" || (row[1] == "stop" && axis.is_started());
        assert_eq!(planned, plans, "{place}: golden profile");
        if planned {
            for (i, name) in PROFILE.iter().enumerate() {
                compare(name, profile(&axis)[i], 6 + i);
            }
            let kind = axis.profile().kind as u8;
            assert_eq!(kind.to_string(), row[15], "{place}: type");
            assert_eq!(warnings.bits().to_string(), row[17], "{place}: warnings");
        }
        assert_eq!(
            u8::from(axis.is_started()).to_string(),
            row[16],
            "{place}: started"
        );
        assert_eq!(setpoint.is_some(), !row[18].is_empty(), "{place}: setpoint");
        if let Some(s) = setpoint {
            for (i, got) in [s.position, s.velocity, s.acceleration]
                .into_iter()
                .enumerate()
            {
                compare(SETPOINT[i], got, 18 + i);
            }
        }
    }
    assert_eq!(scripts, SCRIPTS);
    comparison.finish("listing");
}
