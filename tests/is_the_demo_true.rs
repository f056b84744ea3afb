//! Does `make demo` prove and draw what it says, and does its parity table show a wrong bit?

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::LazyLock;
use support::golden;
use support::repository::root;

/// What `make demo` printed. It runs once for all tests of this file.
static DEMO: LazyLock<String> = LazyLock::new(|| {
    let mut make = Command::new("make");
    let choices = "MAKEFLAGS REAL POLY A_TRAJPOLY3 A_TRAJPOLY5 A_TRAJPOLY7";
    for choice in choices.split(' ') {
        make.env_remove(choice);
    }
    let output = make.arg("demo").current_dir(root()).output().unwrap();
    let printed = printed(&output);
    assert!(output.status.success(), "{printed}");
    printed
});

#[test]
fn every_golden_row_passes_the_servo_program() {
    for table in ["bell", "trap", "poly7"] {
        let gen_rows = rows(&format!("{table}_gen"));
        assert_parity(&format!("a_traj{table}_gen"), gen_rows.len() - 1);
        let eval_rows = rows(&format!("{table}_eval"));
        for column in eval_rows[0].split(',').skip(2) {
            assert_parity(&format!("a_traj{table}_{column}"), eval_rows.len() - 1);
        }
    }
    assert_eq!(line(&DEMO, "total")[1], "0");
}

fn rows(table: &str) -> Vec<String> {
    let file = golden::directory().join(format!("{table}_f64.csv"));
    let csv = fs::read_to_string(file).unwrap();
    csv.lines().map(str::to_owned).collect()
}

fn assert_parity(function: &str, rows: usize) {
    let want = [rows.to_string(), "0".into()];
    assert_eq!(line(&DEMO, function), want, "{function}");
}

#[test]
fn one_wrong_bit_fails() {
    // The servo's first answer, one bit above the golden duration 2.71 s.
    let output = parity("one-bit", "sed '1s/^2.71 /2.7100000000000004 /'");
    let table = printed(&output);
    assert!(!output.status.success(), "{table}");
    assert_eq!(line(&table, "a_trajbell_gen")[1], "1");
    assert_eq!(line(&table, "total")[1], "1");
    let place = "bell_gen_f64.csv:2: a_trajbell_gen is";
    assert!(table.contains(place), "{table}");
}

#[test]
fn missing_answers_fail() {
    for (name, filter) in [("cut", "head -n 1000"), ("silent", "sed d")] {
        let output = parity(name, filter);
        assert!(!output.status.success(), "{}", printed(&output));
    }
}

#[test]
fn one_prefix_further_no_move_fails() {
    for planner in ["atraj_bell_gen", "atraj_trap_gen"] {
        assert_eq!(line(&DEMO, planner), ["0", "0", "0", "0"], "{planner}");
    }
    let (_, table) = DEMO.split_once("of 100000 moves").unwrap();
    let of_liba = |planner| -> [u32; 4] {
        let counts: Vec<_> = line(table, planner)
            .iter()
            .map(|n| n.parse().unwrap())
            .collect();
        counts.try_into().unwrap()
    };
    // The original has every fault that the table counts, but a trapezoid that exists is the fastest.
    let [refused, broken, missed, longer] = of_liba("a_trajbell_gen");
    assert!(refused > 1000 && broken > 100 && missed == 0 && longer > 1000);
    let [refused, _, missed, longer] = of_liba("a_trajtrap_gen");
    assert!(refused > 1000 && missed > 1000 && longer == 0);
}

struct Example {
    name: String,
    /// What it prints in `make demo`: every setpoint.
    output: String,
    picture: String,
    svg: String,
}

/// What `make demo` draws, in its order: the examples, then what a shaper leaves of a vibration.
static EXAMPLES: LazyLock<Vec<Example>> = LazyLock::new(|| {
    let expected = fs::read_dir(root().join("examples/expected")).unwrap();
    let names = expected.map(|file| file.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> = names.collect();
    names.sort();
    names.push("sensitivity.txt".into());
    let pictures: Vec<_> = DEMO.lines().filter(|line| line.ends_with(".svg")).collect();
    assert!(names.len() > 10 && pictures.len() == names.len());
    let examples = names
        .into_iter()
        .zip(pictures)
        .map(|(name, picture)| Example {
            output: fs::read_to_string(demo_dir().join(&name)).unwrap(),
            name: name.replace(".txt", ""),
            picture: picture.rsplit('/').next().unwrap().to_owned(),
            svg: fs::read_to_string(root().join(picture)).unwrap(),
        });
    examples.collect()
});

/// What the example of this number printed.
fn output(number: usize) -> &'static str {
    &EXAMPLES[number - 1].output
}

/// The numbers of an example's setpoints: the time, then the quantities in the order in which they are printed.
fn setpoints(output: &str) -> Vec<Vec<f64>> {
    let lines = output.lines().filter(|line| line.contains(" s: "));
    let numbers = |line: &str| {
        let words = line.split([' ', ',']);
        words.filter_map(|word| word.parse().ok()).collect()
    };
    lines.map(numbers).collect()
}

/// The largest limit of this unit that an example prints, if there is one.
fn limit(output: &str, unit: &str) -> Option<f64> {
    let limits = output.lines().filter_map(|line| line.split_once("within "));
    let limits = limits.flat_map(|(_, limits)| limits.split(", "));
    let sizes = limits.filter_map(|limit| limit.strip_suffix(&format!(" {unit}")));
    let sizes = sizes.map(|size| size.parse::<f64>().unwrap().abs());
    sizes.max_by(f64::total_cmp)
}

/// Half a unit of the last of four digits, of two numbers.
const DIGIT: f64 = 1.01e-4;

#[test]
fn the_motions_are_smooth_and_keep_their_limits() {
    for example in [2, 3, 6, 7, 8, 11, 15, 16, 17, 18] {
        let output = output(example);
        let points = setpoints(output);
        assert!(points.len() > 900, "{example}");
        let passed = points.last().unwrap()[0] / (points.len() - 1) as f64;
        let [v, a, j] = ["m/s", "m/s^2", "m/s^3"].map(|unit| limit(output, unit));
        let [v, a, j] = [v.unwrap(), a.unwrap(), j.unwrap_or(f64::INFINITY)];
        // An acceleration that bends by the jerk, or jumps, makes the mean wrong by this much.
        let bend = [a * passed * passed, f64::min(j * passed, 2.0 * a) * passed];
        for pair in points.windows(2) {
            let [before, now] = [&pair[0], &pair[1]];
            assert!(now[2].abs() <= v && now[3].abs() <= a, "{example}: {now:?}");
            for (quantity, limit) in [(1, v), (2, a), (3, j)] {
                let step = now[quantity] - before[quantity];
                assert!(step.abs() <= limit * passed + DIGIT, "{example}: {now:?}");
                if quantity < 3 {
                    let mean = 0.5 * (before[quantity + 1] + now[quantity + 1]);
                    let error = (step - mean * passed).abs();
                    assert!(error <= bend[quantity - 1] + DIGIT, "{example}: {now:?}");
                }
            }
        }
    }
}

#[test]
fn the_original_breaks_the_limit_in_the_picture_and_ours_keeps_it() {
    let output = output(5);
    let limit = limit(output, "m/s^2").unwrap();
    let steepest = |column: usize| {
        let points = setpoints(output).into_iter();
        points.map(|point| point[column].abs()).fold(0.0, f64::max)
    };
    assert!(steepest(3) <= limit, "{}", steepest(3));
    assert!(steepest(6) > 2.0 * limit, "{}", steepest(6));
}

#[test]
fn the_retargeted_axis_turns_back_and_stops() {
    let points = setpoints(output(6));
    let farthest = points.iter().map(|point| point[1]).fold(0.0, f64::max);
    let last = points.last().unwrap();
    assert!(0.0 < last[1] && last[1] < farthest && farthest < 5.0);
    assert_eq!(last[2..], [0.0, 0.0, 0.0], "{last:?}");
}

#[test]
fn the_axis_follows_the_sensor() {
    let points = setpoints(output(7));
    let jumps = |p: &&[Vec<f64>]| (p[1][4] - p[0][4]).abs() > 0.1;
    assert_eq!(points.windows(2).filter(jumps).count(), 1);
    // Soon after the start and after the jump, the axis is near, and the noise does not switch its jerk to and fro between its limits.
    for pair in points.windows(2) {
        let [before, now] = pair else { unreachable!() };
        let settled = (0.5..1.5).contains(&now[0]) || now[0] > 2.2;
        let jerk = (now[3] - before[3]) / (now[0] - before[0]);
        assert!(!settled || (now[1] - now[4]).abs() < 4e-3, "{now:?}");
        assert!(!settled || jerk.abs() < 0.5 * 200.0, "{jerk} {now:?}");
    }
}

#[test]
fn the_axis_meets_the_part_rides_and_goes_home() {
    let points = setpoints(output(8));
    let beside = |p: &&Vec<f64>| p[1] == p[4] && p[2] == p[5];
    assert!(points.iter().filter(beside).count() > 500);
    assert_eq!(points.last().unwrap()[1..4], [0.0, 0.0, 0.0]);
}

#[test]
fn only_the_straight_line_is_straight() {
    let output = output(9);
    let (bow, line) = output.split_once("on a straight line:").unwrap();
    let off_line = |text: &str| {
        let points = setpoints(text);
        assert!(points.len() > 1000);
        assert_eq!(points[0][1..], [0.0; 6]);
        assert_eq!(points.last().unwrap()[1..], [0.8, 0.4, 0.0, 0.0, 0.0, 0.0]);
        let off = points.iter().map(|p| (p[2] - 0.5 * p[1]).abs());
        off.fold(0.0, f64::max)
    };
    assert!(off_line(bow) > 0.01, "{}", off_line(bow));
    assert!(off_line(line) < DIGIT, "{}", off_line(line));
}

#[test]
fn the_joints_of_the_arm_stop_together() {
    let output = output(10);
    assert_joints_keep_their_limits(output);
    let after: Vec<_> = output.split(" -> ").skip(1).collect();
    assert_eq!(after.len(), 4);
    for text in &after[..3] {
        assert_eq!(setpoints(text)[0][7..], [0.0; 6], "no stop");
    }
}

#[test]
fn the_arm_passes_its_way_points_sooner() {
    let output = output(12);
    assert_joints_keep_their_limits(output);
    let after: Vec<_> = output.split(" -> ").skip(1).collect();
    assert_eq!(after.len(), 4);
    for text in &after[..3] {
        let velocities = &setpoints(text)[0][7..];
        assert!(velocities.iter().any(|v| v.abs() > 5.0), "a stop");
    }
    let last = output.lines().last().unwrap();
    let words: Vec<_> = last.split(' ').collect();
    let [stopping, passing] = [words[0], words[8]].map(|word| word.parse::<f64>().unwrap());
    let saved = format!("{:.0} %", 100.0 * (1.0 - passing / stopping));
    assert!(last.ends_with(&format!("{saved} saved")), "{last}");
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let row = format!("an arm arrives {saved} sooner");
    assert!(readme.contains(&row), "{row}");
}

#[test]
fn the_gantry_goes_round_the_obstacle() {
    let (_, paths) = output(13).split_once("with stops:").unwrap();
    let (stops, passes) = paths.split_once("without stops:").unwrap();
    let is_inside = |p: &Vec<f64>| p[1] > 0.4 && p[1] < 0.6 && p[2] < 0.3;
    let ends = [stops, passes].map(|path| {
        let points = setpoints(path);
        assert!(points.len() > 1500 && !points.iter().any(is_inside));
        let last = points.last().unwrap().clone();
        assert_eq!(last[1..], [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        last[0]
    });
    assert!(ends[1] < 0.75 * ends[0], "{ends:?}");
    // In the middle of the path, both pass above the obstacle.
    assert!(setpoints(passes).iter().any(|p| p[1] > 0.45 && p[1] < 0.55));
}

#[test]
fn each_axis_of_the_gantry_keeps_limits_of_its_own() {
    for (example, limits) in [
        (9, [[1.0, 4.0], [0.6, 1.0]]),
        (13, [[1.0, 4.0], [0.8, 2.0]]),
    ] {
        let output = output(example);
        for (axis, [v, a]) in ["x", "y"].iter().zip(limits) {
            assert!(output.contains(&format!("\n{axis} within {v} m/s, {a} m/s^2\n")));
        }
        for point in setpoints(output).iter().filter(|point| point.len() > 3) {
            for (axis, [v, a]) in limits.into_iter().enumerate() {
                let (velocity, acceleration) = (point[axis + 3].abs(), point[axis + 5].abs());
                assert!(velocity <= v && acceleration <= a, "{example}: {point:?}");
            }
        }
    }
}

#[test]
fn the_obstacle_is_drawn_in_its_plane_with_the_limits_of_each_axis_below() {
    let svg = &EXAMPLES[12].svg;
    let obstacle = &lines_of(svg, "#1F5AA6", 10)[0];
    let [foot, top, corner, _] = obstacle[..] else {
        panic!("{obstacle:?}");
    };
    // 0.2 m wide and 0.3 m high.
    let ratio = (foot.1 - top.1) / (corner.0 - top.0);
    assert!((ratio - 1.5).abs() < 0.01, "{ratio}");
    for label in [
        "y [m]",
        "x [m]",
        "velocity [m/s]",
        "acceleration [m/s²]",
        "time [s]",
    ] {
        assert_eq!(
            svg.lines().filter(|line| *line == label).count(),
            1,
            "{label}"
        );
    }
    // Two axes have two limits each, in both directions, and each line has the name of its axis.
    let limits = lines_of(svg, "#C81E32", 4);
    assert_eq!(limits.len(), 8);
    for axis in ["x", "y"] {
        let names = svg.lines().collect::<Vec<_>>();
        let named = names
            .windows(2)
            .filter(|pair| pair[0].contains("#C81E32") && pair[1] == axis);
        assert_eq!(named.count(), 4, "{axis}");
    }
    let points = svg.lines().filter(|line| line.starts_with("<circle"));
    assert!(points.count() >= 2);
    for point in ["point 1", "point 2"] {
        assert!(svg.lines().any(|line| line == point));
    }
}

/// How much lighter one colour is than the other, as WCAG 2 defines it: 1 to 21.
fn contrast(colors: [&str; 2]) -> f64 {
    let light = colors.map(|color| {
        let part =
            |at: usize| f64::from(u8::from_str_radix(&color[at..at + 2], 16).unwrap()) / 255.0;
        let linear = |part: f64| match part {
            0.0..=0.04045 => part / 12.92,
            _ => ((part + 0.055) / 1.055).powf(2.4),
        };
        0.2126 * linear(part(1)) + 0.7152 * linear(part(3)) + 0.0722 * linear(part(5)) + 0.05
    });
    light[0].max(light[1]) / light[0].min(light[1])
}

#[test]
fn pictures_read_on_light_and_on_dark_pages() {
    for Example { name, svg, .. } in EXAMPLES.iter() {
        assert!(!svg.contains("<rect"), "{name} has a background");
        let (style, picture) = svg.split_once("</style>").unwrap();
        let (_, dark) = style.split_once("(prefers-color-scheme: dark)").unwrap();
        for element in picture.lines().filter(|line| line.starts_with('<')) {
            for attribute in ["fill", "stroke"] {
                let color = element.split(&format!(" {attribute}=\"")).nth(1);
                let color = color.and_then(|rest| rest.split('"').next());
                let Some(color) = color.filter(|color| color.starts_with('#')) else {
                    continue;
                };
                let rule = format!("[{attribute}=\"{color}\"]{{{attribute}:");
                let instead = dark.split(&rule).nth(1).and_then(|rest| rest.get(..7));
                let instead = instead.unwrap_or_else(|| panic!("{name}: no dark {color}"));
                let least = if element.starts_with("<text") {
                    4.5
                } else {
                    3.0
                };
                for pair in [[color, "#FFFFFF"], [instead, "#0D1117"]] {
                    assert!(
                        contrast(pair) >= least,
                        "{name}: {pair:?} {}",
                        contrast(pair)
                    );
                }
            }
        }
    }
}

#[test]
fn the_texts_of_near_marks_lead_away_from_each_other() {
    let text = "near\n1 s -> one\n1.01 s -> two\n2 s -> far\n0 s: 0 m\n3 s: 1 m\n";
    let svg = draw("near", text);
    let lines: Vec<_> = svg.lines().collect();
    let anchor = |text: &str| {
        let [element, _] = lines.windows(2).find(|pair| pair[1] == text).unwrap() else {
            unreachable!()
        };
        element
            .split("text-anchor=\"")
            .nth(1)
            .unwrap()
            .split('"')
            .next()
            .unwrap()
            .to_owned()
    };
    assert_eq!(
        ["one", "two", "far"].map(anchor),
        ["end", "start", "middle"]
    );
}

#[test]
fn the_horizon_moves_on_and_passes_its_points() {
    let points = setpoints(output(14));
    for pair in points.windows(2) {
        let passed = pair[1][0] - pair[0][0];
        for axis in 1..=2 {
            let step = pair[1][axis] - pair[0][axis];
            let mean = (pair[1][axis + 2] + pair[0][axis + 2]) / 2.0;
            assert!((step - mean * passed).abs() < DIGIT, "{:?}", pair[1]);
            assert!(pair[1][axis + 2].abs() <= 0.42 && pair[1][axis + 4].abs() <= 8.0);
        }
    }
    // A setpoint lies within half a millisecond of each point.
    for k in 0..=60 {
        let (x, u) = (0.02 * f64::from(k), f64::from(k % 20) / 20.0);
        let side = if k / 20 % 2 == 1 { -0.16 } else { 0.16 };
        let y = side * u * (1.0 - u);
        let near = |p: &Vec<f64>| (p[1] - x).abs() < 3e-4 && (p[2] - y).abs() < 3e-4;
        assert!(points.iter().any(near), "point {k}");
    }
}

#[test]
fn the_jog_stands_at_the_soft_stops() {
    let points = setpoints(output(15));
    assert!(points.iter().all(|p| (-0.2..=1.0).contains(&p[1])));
    for stop in [0.4, 1.0, -0.2] {
        let stands = |p: &&Vec<f64>| p[1] == stop && p[2..] == [0.0, 0.0];
        assert!(points.iter().filter(stands).count() > 300, "{stop}");
    }
}

#[test]
fn the_switch_is_found_slowly() {
    let output = output(16);
    let times = output.lines().filter_map(|line| line.split_once(" s -> "));
    let times: Vec<f64> = times.map(|(time, _)| time.parse().unwrap()).collect();
    let points = setpoints(output);
    let at = |time: f64| points.iter().find(|p| p[0] == time).unwrap();
    let velocities = [at(times[0])[2], at(times[1])[2], at(times[2])[2]];
    assert_eq!(velocities, [-0.2, 0.05, -0.01]);
    assert!(output.contains("the switch is at -0.31274 m"));
    assert_eq!(points.last().unwrap()[1..], [-0.2127, 0.0, 0.0]);
}

#[test]
fn the_limit_switch_stops_harder_than_the_work() {
    let points = setpoints(output(17));
    let farthest = points.iter().map(|p| p[1]).fold(0.0, f64::max);
    assert!(farthest > 0.8 && farthest < 0.86, "{farthest}");
    let hardest = |p: &&Vec<f64>| p[3] < -10.0 && p[1] > 0.8;
    assert!(points.iter().filter(hardest).count() > 20);
    assert_eq!(points.last().unwrap()[1..], [0.7, 0.0, 0.0]);
}

#[test]
fn the_feed_is_overridden_and_held() {
    let points = setpoints(output(18));
    for feed in [0.5, 0.2, 0.6, 0.0] {
        let runs = |p: &&Vec<f64>| p[2] == feed && p[4] == feed;
        assert!(points.iter().filter(runs).count() > 400, "{feed}");
    }
    // Soon after each turn of the knob, the axis is no faster than it may be.
    let turned = |time: f64| [1.0, 3.2].iter().any(|t| (*t..t + 0.4).contains(&time));
    assert!(points.iter().all(|p| turned(p[0]) || p[2] <= p[4]));
    assert_eq!(points.last().unwrap()[1..4], [2.0, 0.0, 0.0]);
}

#[test]
fn each_step_has_its_pulse() {
    let points = setpoints(output(19));
    let steps: Vec<_> = points.iter().map(|p| (p[1] / 1.8).round()).collect();
    let there_and_back: Vec<_> = (1..=100).chain((50..100).rev()).map(f64::from).collect();
    assert_eq!(steps, there_and_back);
    assert!(points.windows(2).all(|pair| pair[0][0] < pair[1][0]));
    let fastest = points.iter().map(|p| p[2].abs()).fold(0.0, f64::max);
    assert!(fastest > 999.0 && fastest <= 1000.0, "{fastest}");
}

fn assert_joints_keep_their_limits(output: &str) {
    let points = setpoints(output);
    for pair in points.windows(2) {
        let passed = pair[1][0] - pair[0][0];
        for joint in 1..=6 {
            let limit = if joint <= 3 { 120.0 } else { 250.0 };
            let step = (pair[1][joint] - pair[0][joint]).abs();
            assert!(pair[1][joint + 6].abs() <= limit, "{:?}", pair[1]);
            assert!(step <= limit * passed + 0.011, "{:?}", pair[1]);
        }
    }
}

#[test]
fn the_controller_turns_back_holds_and_arrives() {
    let points = setpoints(output(11));
    assert!(points.iter().any(|point| point[2] < -0.4), "no way back");
    let held = |point: &&Vec<f64>| point[2] == 0.0 && (0.11..0.59).contains(&point[1]);
    assert!(points.iter().filter(held).count() > 100, "no feed hold");
    assert_eq!(points.last().unwrap()[1..3], [0.1, 0.0]);
}

#[test]
fn an_example_is_drawn_as_it_is_printed() {
    let readme = fs::read_to_string(root().join("examples/README.md")).unwrap();
    let beside = "a_trajbell_gen,sensor,part,synchronised,on a straight line";
    let (_, examples) = EXAMPLES.split_last().unwrap();
    for example in examples {
        let (name, output, svg) = (&example.name, &example.output, &example.svg);
        let expected = root().join(format!("examples/expected/{name}.txt"));
        let mut all = output.lines();
        for line in fs::read_to_string(expected).unwrap().lines() {
            assert!(all.any(|drawn| drawn == line), "{name}: {line}");
        }
        let has_text = |text: &str| svg.lines().any(|line| line == text);
        let title = output.split([':', '\n']).next().unwrap();
        let marks = output.lines().filter_map(|line| line.split_once(" -> "));
        for text in marks.map(|(_, mark)| mark).chain([title]) {
            assert!(has_text(text), "{name}: {text}");
        }
        for curve in beside.split(',') {
            let given = output.contains(curve);
            assert_eq!(has_text(curve), given, "{name}: {curve}");
        }
        let setpoints: Vec<_> = output
            .lines()
            .filter(|line| line.contains(" s: "))
            .collect();
        for unit in ["m", "deg", "m/s", "deg/s", "m/s^2", "m/s^3"] {
            let mut words = setpoints
                .iter()
                .flat_map(|setpoint| setpoint.split([' ', ',']));
            let given = words.any(|word| word == unit);
            let label = format!("[{}]", unit.replace("^2", "²").replace("^3", "³"));
            assert_eq!(svg.contains(&label), given, "{name}: {label}");
        }
        let row = format!("| `{name}` |");
        let mut rows = readme.lines().filter(|line| line.starts_with(&row));
        assert!(rows.any(|row| row.contains(&example.picture)), "{row}");
    }
}

/// The points of each line of this colour and width: thin limits and marks, thick curves.
fn lines_of(svg: &str, color: &str, width: u32) -> Vec<Vec<(f64, f64)>> {
    let style = format!("stroke=\"{color}\" stroke-width=\"{width}\" points=\"");
    let lines = svg.lines().filter(|line| line.starts_with("<polyline"));
    let points = lines.filter_map(|line| line.split_once(&style)?.1.split('"').next());
    let point = |text: &str| {
        let (x, y) = text.split_once(',').unwrap();
        (x.parse().unwrap(), y.parse().unwrap())
    };
    let line = |points: &str| points.split_whitespace().map(point).collect();
    points.map(line).collect()
}

#[test]
fn limits_are_level_lines_on_the_side_of_the_curve() {
    let limits = |svg: &str| lines_of(svg, "#C81E32", 4);
    for Example { output, svg, .. } in EXAMPLES.iter() {
        assert_eq!(limits(svg).is_empty(), !output.contains("within "));
        assert!(limits(svg).iter().all(|line| line[0].1 == line[1].1));
    }
    let heights = |name: &str, setpoints: &str| {
        let svg = draw(
            name,
            &format!("{name}\nwithin 2 m/s, +3 m/s^2\n{setpoints}\n"),
        );
        let heights = limits(&svg).into_iter().map(|line| line[0].1 as u32);
        heights.collect::<BTreeSet<_>>().len()
    };
    let back = "0 s: 0 m, -1 m/s, 2 m/s^2\n1 s: 0 m, 1 m/s, -2 m/s^2";
    assert_eq!(heights("back", back), 3);
    assert_eq!(heights("ahead", "0 s: 0 m, 0 m/s\n1 s: 1 m, 1 m/s"), 1);
}

#[test]
fn the_plane_has_one_scale() {
    let lines = lines_of(&EXAMPLES[8].svg, "#18804E", 10);
    let ends = |line: &Vec<(f64, f64)>| (line[0], line[line.len() - 1]);
    let slope = |((x0, y0), (x1, y1))| (y0 - y1) / (x1 - x0);
    let slope = slope(ends(&lines[0]));
    assert!((slope - 0.5).abs() < 0.002, "{slope}");
}

/// Pictures that `make demo` does not draw. python/tests/test_vibration.py compares the first two. The third is a screenshot of the playground,
/// whose bits depend on the browser.
const OTHERS: [&str; 3] = ["vibration.svg", "shaper-or-jerk.svg", "playground.png"];

#[test]
fn pictures_in_the_documentation_are_fresh() {
    for Example { picture, svg, .. } in EXAMPLES.iter() {
        let committed = fs::read_to_string(root().join("docs/img").join(picture));
        let is_fresh = committed.is_ok_and(|committed| committed == *svg);
        assert!(is_fresh, "copy {picture} from target/demo to docs/img");
    }
    for file in fs::read_dir(root().join("docs/img")).unwrap() {
        let name = file.unwrap().file_name().into_string().unwrap();
        let mut known = EXAMPLES
            .iter()
            .map(|example| &*example.picture)
            .chain(OTHERS);
        assert!(known.any(|known| known == name), "nothing draws {name}");
    }
}

#[test]
fn no_label_is_minus_zero() {
    // From -0.3 to 0.1, so a tick lies a rounding below zero.
    let drawn = draw("zero", "zero\n0 s: -0.3 m\n1 s: 0.1 m\n");
    for svg in EXAMPLES.iter().map(|example| &example.svg).chain([&drawn]) {
        let labels = svg.lines().filter(|line| !line.starts_with('<'));
        let zeros: Vec<_> = labels.filter(|text| text.parse() == Ok(0.0)).collect();
        assert!(!zeros.is_empty());
        assert!(zeros.iter().all(|text| !text.starts_with('-')), "{zeros:?}");
    }
}

#[test]
fn jerk_steps_are_vertical() {
    let svg = fs::read_to_string(demo_dir().join("double-s-with-cruise.svg")).unwrap();
    let jerk = &lines_of(&svg, "#8C2882", 10)[0];
    let steps: Vec<_> = jerk.windows(2).filter(|p| p[0].1 != p[1].1).collect();
    // Seven phases have six borders between them. A setpoint is a third of a pixel, or 1.2 units, from the next.
    assert_eq!(steps.len(), 6, "{steps:?}");
    assert!(steps.iter().all(|p| p[1].0 - p[0].0 <= 2.0), "{steps:?}");
}

/// The run of the plot program on these files.
fn plot(files: &[&Path]) -> Output {
    let directory = demo_dir().join("drawn");
    example("plot").arg(directory).args(files).output().unwrap()
}

/// The run of the plot program on what an example may have printed.
fn plot_text(name: &str, text: &str) -> Output {
    let file = demo_dir().join(format!("{name}.txt"));
    fs::write(&file, text).unwrap();
    plot(&[&file])
}

/// The picture of an example that has this name as its title.
fn draw(name: &str, text: &str) -> String {
    let output = plot_text(name, text);
    assert!(output.status.success(), "{}", printed(&output));
    fs::read_to_string(demo_dir().join(format!("drawn/{name}.svg"))).unwrap()
}

#[test]
fn nothing_to_draw_fails() {
    for text in [
        "",
        "empty\n",
        "infinite\n0 s: inf m\n",
        "uneven\n0 s: 0 m, 1 m/s\n1 s: 0 m\n",
        "no number\n0 s: m\n",
        "no unit\n0 s: 0\n",
        "no time\nnow s: 0 m\n",
        "long\n0 s: 0 m, 0 m/s, 0 m/s^2, 0 m/s^3, 0 m/s^4\n",
        "axes\n0 s: 0 0 0 0 0 0 0 m\n",
        "path\nthree:\n0 s: x 0 m, y 0 m, z 0 m\n",
        "path\nempty:\n",
        "path\nno place:\n0 s: 1 2 m/s\n",
        "limit\nwithin fast m\n0 s: 0 m\n1 s: 1 m\n",
    ] {
        let output = plot_text("nothing", text);
        assert!(!output.status.success(), "{text:?}: {}", printed(&output));
    }
    let file = demo_dir().join(format!("{}.txt", EXAMPLES[0].name));
    assert!(plot(&[&file]).status.success());
    assert!(!plot(&[&file, &file]).status.success() && !plot(&[]).status.success());
}

fn demo_dir() -> PathBuf {
    LazyLock::force(&DEMO);
    root().join("target/demo")
}

/// The parity run on a servo whose answers pass through a shell filter.
fn parity(name: &str, filter: &str) -> Output {
    let directory = demo_dir().join(name);
    let script = directory.join("servo.sh");
    fs::create_dir_all(&directory).unwrap();
    let pipe = format!("#!/bin/sh\ntarget/demo/servo | {filter}\n");
    fs::write(&script, pipe).unwrap();
    let chmod = Command::new("chmod").arg("+x").arg(&script).status();
    assert!(chmod.unwrap().success());
    example("parity").arg(script).output().unwrap()
}

fn example(name: &str) -> Command {
    let mut cargo = Command::new(env!("CARGO"));
    cargo
        .args(["run", "--quiet", "--example", name])
        .current_dir(root())
        .stdin(Stdio::null());
    cargo
}

/// The numbers behind the name of a function in the parity table.
fn line(table: &str, function: &str) -> Vec<String> {
    let is_found = |line: &&str| line.split_whitespace().next() == Some(function);
    let line = table
        .lines()
        .find(is_found)
        .unwrap_or_else(|| panic!("no {function} in:\n{table}"));
    line.split_whitespace().skip(1).map(str::to_owned).collect()
}

fn printed(output: &Output) -> String {
    let both = [&output.stdout, &output.stderr];
    both.map(|text| String::from_utf8_lossy(text)).concat()
}
