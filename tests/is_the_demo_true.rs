//! Does `make demo` prove and draw what it says, and does its parity table show a wrong bit?

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};
use std::sync::LazyLock;
use support::golden;
use support::repository::root;
use support::tools::has_tool;

/// What `make demo` printed. It runs once for all tests of this file.
static DEMO: LazyLock<String> = LazyLock::new(|| {
    let mut make = Command::new("make");
    for choice in [
        "MAKEFLAGS",
        "REAL",
        "POLY",
        "A_TRAJPOLY3",
        "A_TRAJPOLY5",
        "A_TRAJPOLY7",
    ] {
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
    assert_eq!(
        line(&DEMO, function),
        [rows.to_string(), "0".into()],
        "{function}"
    );
}

#[test]
fn one_wrong_bit_fails() {
    // The servo's first answer, one bit above the golden duration 2.71 s.
    let output = parity("one-bit", "sed '2s/^plan 2.71 /plan 2.7100000000000004 /'");
    let table = printed(&output);
    assert!(!output.status.success(), "{table}");
    assert_eq!(line(&table, "a_trajbell_gen")[1], "1");
    assert_eq!(line(&table, "total")[1], "1");
    assert!(
        table.contains("bell_gen_f64.csv:2: a_trajbell_gen is"),
        "{table}"
    );
}

#[test]
fn missing_answers_fail() {
    for (name, filter) in [("cut", "head -n 1000"), ("silent", "sed d")] {
        let output = parity(name, filter);
        assert!(!output.status.success(), "{}", printed(&output));
    }
}

#[test]
fn every_move_is_drawn() {
    let setpoints = fs::read_to_string(demo_dir().join("setpoints.txt")).unwrap();
    let setpoints = setpoints.replace("\npath ", "\nmove path ");
    let moves: Vec<_> = setpoints.split("move ").skip(1).collect();
    let pictures: Vec<_> = DEMO.lines().filter(|line| line.ends_with(".svg")).collect();
    assert!(!moves.is_empty());
    assert_eq!(pictures.len(), moves.len());
    for (motion, picture) in moves.iter().zip(pictures) {
        let svg = fs::read_to_string(root().join(picture)).unwrap();
        for curve in motion
            .lines()
            .filter_map(|line| line.strip_prefix("curve "))
        {
            assert!(svg.contains(curve), "{picture}: {curve}");
        }
        if let Some(path) = motion.strip_prefix("path ") {
            let title = path.split([':', '\n']).next().unwrap();
            for label in [title, "x [m]", "y [m]"] {
                assert!(svg.contains(label), "{picture}: {label}");
            }
            continue;
        }
        let (motion, _) = motion.split_once("\nbeside ").unwrap_or((motion, ""));
        let mut setpoints = motion.lines().filter(|line| line.starts_with("at "));
        let last = setpoints.next_back().unwrap();
        for (quantity, label) in [
            "position [m]",
            "velocity [m/s]",
            "acceleration [m/s²]",
            "jerk [m/s³]",
        ]
        .iter()
        .enumerate()
        {
            let given = last.split(' ').count() > 2 + quantity;
            assert_eq!(svg.contains(label), given, "{picture}: {label}");
        }
        let title = motion.split([':', '\n']).next().unwrap();
        assert!(svg.contains(title), "{picture}: {title}");
        assert!(svg.contains("time [s]"), "{picture}");
    }
}

#[test]
fn one_prefix_further_no_move_fails() {
    for planner in ["atraj_bell_gen", "atraj_trap_gen"] {
        assert_eq!(line(&DEMO, planner), ["0", "0", "0", "0"], "{planner}");
    }
    let of_liba = |planner: &str| -> Vec<u32> {
        let (_, table) = DEMO.split_once("of 100000 moves").unwrap();
        let counts = line(table, planner);
        counts.iter().map(|count| count.parse().unwrap()).collect()
    };
    // The original has every fault that the table counts, but a trapezoid that exists is the fastest.
    let [refused, broken, missed, longer] = of_liba("a_trajbell_gen")[..] else {
        panic!("four counts")
    };
    assert!(refused > 1000 && broken > 100 && missed == 0 && longer > 1000);
    let [refused, _, missed, longer] = of_liba("a_trajtrap_gen")[..] else {
        panic!("four counts")
    };
    assert!(refused > 1000 && missed > 1000 && longer == 0);
}

#[test]
fn the_original_breaks_the_limit_in_the_picture_and_ours_keeps_it() {
    let setpoints = fs::read_to_string(demo_dir().join("setpoints.txt")).unwrap();
    let (_, motion) = setpoints.split_once("move Too near to stop").unwrap();
    let (ours, original) = motion.split_once("beside a_trajbell_gen").unwrap();
    let steepest = |setpoints: &str| {
        setpoints
            .lines()
            .filter_map(|line| line.strip_prefix("at ")?.split(' ').nth(3))
            .map(|acceleration| acceleration.parse::<f64>().unwrap().abs())
            .fold(0.0, f64::max)
    };
    assert!(steepest(ours) <= 2.5, "{}", steepest(ours));
    assert!(steepest(original) > 5.0, "{}", steepest(original));
    let svg = fs::read_to_string(demo_dir().join("too-near-to-stop.svg")).unwrap();
    assert!(svg.contains("a_trajbell_gen"));
}

#[test]
fn no_plan_in_motion_fails() {
    let counts = |name: &str| -> Vec<u32> {
        let row = DEMO.lines().find_map(|line| line.strip_prefix(name));
        let row = row.unwrap_or_else(|| panic!("no {name} in:\n{}", *DEMO));
        row.split_whitespace()
            .map(|count| count.parse().unwrap())
            .collect()
    };
    for (name, plans) in [
        ("retargeted and stopped", 3),
        ("following a sensor", 3001),
        ("meeting a part", 2),
    ] {
        // Nothing refused, no jump, no limit exceeded, no start outside.
        assert_eq!(counts(name)[..5], [plans, 0, 0, 0, 0], "{name}");
    }
    let random = counts("random");
    assert_eq!(random[..4], [100_000, 0, 0, 0], "random");
    assert!(random[4] > 1000 && random[5] > 1000, "{random:?}");
}

/// The setpoints of the move whose title begins so: time, position, velocity, acceleration and what else is given; and those beside.
fn points(title: &str) -> [Vec<Vec<f64>>; 2] {
    let setpoints = fs::read_to_string(demo_dir().join("setpoints.txt")).unwrap();
    let (_, motion) = setpoints.split_once(&format!("move {title}")).unwrap();
    let motion = motion.split("\nmove ").next().unwrap();
    let (motion, beside) = motion.split_once("\nbeside ").unwrap_or((motion, ""));
    [motion, beside].map(|text| {
        text.lines()
            .filter_map(|line| line.strip_prefix("at "))
            .map(|line| line.split(' ').map(|x| x.parse().unwrap()).collect())
            .collect()
    })
}

/// The setpoints are a period apart. Velocity, acceleration and jerk keep these limits, and each quantity is the slope of the one before.
fn assert_smooth(points: &[Vec<f64>], period: f64, [v, a, j]: [f64; 3]) {
    for pair in points.windows(2) {
        let [before, now] = [&pair[0], &pair[1]];
        let passed = now[0] - before[0];
        assert!((passed - period).abs() < 1e-12, "{now:?}");
        for (quantity, limit) in [(1, v), (2, a), (3, j)] {
            let step = now[quantity] - before[quantity];
            assert!(step.abs() <= limit * passed * (1.0 + 1e-9), "{now:?}");
            if quantity < 3 {
                let mean = 0.5 * (before[quantity + 1] + now[quantity + 1]);
                // An acceleration that bends by the jerk makes the mean wrong by this much.
                let bend = j * passed * passed;
                assert!((step - mean * passed).abs() <= bend, "{now:?}");
            }
        }
    }
}

#[test]
fn the_retargeted_axis_turns_back_and_stops() {
    let [points, first] = points("Retargeted and stopped");
    assert_smooth(&points, 2e-3, [4.6, 9.0, 28.0]);
    assert_eq!(first.last().unwrap()[1].round(), 10.0);
    let farthest = points.iter().map(|point| point[1]).fold(0.0, f64::max);
    let last = points.last().unwrap();
    assert!(0.0 < last[1] && last[1] < farthest && farthest < 5.0);
    assert_eq!(last[2..4], [0.0, 0.0], "{last:?}");
}

#[test]
fn the_axis_follows_the_sensor() {
    let [points, sensor] = points("Following a sensor");
    assert_smooth(&points, 1e-3, [1.0, 10.0, 200.0]);
    assert_eq!(points.len(), sensor.len());
    let jumps = sensor
        .windows(2)
        .filter(|p| (p[1][1] - p[0][1]).abs() > 0.1);
    assert_eq!(jumps.count(), 1);
    // Half a second after the start and after the jump, the axis is near.
    for (point, sensor) in points.iter().zip(&sensor) {
        let settled = (0.5..1.5).contains(&point[0]) || point[0] > 2.0;
        assert!(!settled || (point[1] - sensor[1]).abs() < 0.1, "{point:?}");
    }
}

#[test]
fn the_axis_meets_the_part_rides_and_goes_home() {
    let [points, part] = points("Meeting a part on a conveyor");
    assert_smooth(&points, 1e-3, [3.0, 5.0, 50.0]);
    let beside = |point: &&Vec<f64>| {
        let there = part[0][1] + part[0][2] * point[0];
        (point[1] - there).abs() < 1e-9 && point[2] == part[0][2]
    };
    assert!(points.iter().filter(beside).count() > 500);
    assert_eq!(points.last().unwrap()[1..4], [0.0, 0.0, 0.0]);
}

/// The curves of the move or of the path whose title begins so, each with its setpoints.
fn curves(title: &str) -> Vec<Vec<Vec<f64>>> {
    let setpoints = fs::read_to_string(demo_dir().join("setpoints.txt")).unwrap();
    let (_, motion) = setpoints.split_once(title).unwrap();
    let motion = motion.split("\nmove ").next().unwrap();
    let motion = motion.split("\npath ").next().unwrap();
    let curves = motion.split("\ncurve ").skip(1).map(|text| {
        text.lines()
            .filter_map(|line| line.strip_prefix("at "))
            .map(|line| line.split(' ').map(|x| x.parse().unwrap()).collect())
            .collect()
    });
    curves.collect()
}

#[test]
fn the_axes_of_the_gantry_arrive_together() {
    for title in ["Gantry synchronised", "Gantry on a straight line"] {
        let axes = curves(title);
        let (limits, target) = (
            [[1.0, 4.0, 20.0], [0.8, 2.0, 10.0], [2.0, 8.0, 80.0]],
            [0.8, 0.4, 0.3],
        );
        assert_eq!(axes.len(), 3, "{title}");
        let end = axes[0].last().unwrap()[0];
        for ((points, limits), target) in axes.iter().zip(limits).zip(target) {
            assert_smooth(points, 2e-3, limits);
            assert_eq!(points.last().unwrap()[..], [end, target, 0.0, 0.0]);
            let before = &points[points.len() - 2];
            assert!(before[1] != target, "{title}: an axis waits");
        }
        let row = DEMO.lines().filter(|line| line.starts_with("gantry, "));
        assert_eq!(row.filter(|line| line.ends_with(" 0")).count(), 2);
    }
}

#[test]
fn only_the_straight_line_is_straight() {
    let paths = curves("Gantry in the plane");
    let off_line = |path: &[Vec<f64>]| {
        let off = path.iter().map(|p| (p[1] - 0.5 * p[0]).abs());
        off.fold(0.0, f64::max)
    };
    assert_eq!(paths.len(), 2);
    for path in &paths {
        assert!(path.len() > 100);
        assert_eq!(path[0], [0.0, 0.0]);
        assert_eq!(*path.last().unwrap(), [0.8, 0.4]);
    }
    assert!(off_line(&paths[0]) > 0.005, "{}", off_line(&paths[0]));
    assert!(off_line(&paths[1]) < 1e-15, "{}", off_line(&paths[1]));
}

#[test]
fn the_joints_of_the_arm_stop_together() {
    let mut joints = curves("Arm over way points");
    assert_eq!(joints.len(), 6);
    let stops = |points: &[Vec<f64>]| -> Vec<f64> {
        let borders = points.windows(2).filter(|pair| pair[0][0] == pair[1][0]);
        borders
            .map(|pair| {
                assert_eq!(pair[0], pair[1], "a jump");
                assert_eq!(pair[0][2..], [0.0, 0.0], "no stop");
                pair[0][0]
            })
            .collect()
    };
    let first = stops(&joints[0]);
    assert_eq!(first.len(), 3);
    for (joint, points) in joints.iter_mut().enumerate() {
        assert_eq!(stops(points), first, "joint {joint}");
        points.dedup_by(|now, before| now[0] == before[0]);
        let limits = if joint < 3 {
            [2.0, 9.0, 70.0]
        } else {
            [4.0, 18.0, 160.0]
        };
        assert_smooth(points, 4e-3, limits);
        let [start, end] = [&points[0], points.last().unwrap()];
        assert_eq!(start[1..], end[1..], "joint {joint} is not home");
    }
}

#[test]
fn the_controller_turns_back_holds_and_arrives() {
    if !has_tool("c++") {
        return;
    }
    let [points, _] = points("Retarget and feed hold");
    for pair in points.windows(2) {
        let [before, now] = [&pair[0], &pair[1]];
        let passed = now[0] - before[0];
        assert!((passed - 1e-3).abs() < 1e-12, "{now:?}");
        assert!(
            (now[2] - before[2]).abs() <= 1.0 * passed + 1e-12,
            "{now:?}"
        );
        let mean = 0.5 * (before[2] + now[2]);
        assert!(
            (now[1] - before[1] - mean * passed).abs() <= 1e-6,
            "{now:?}"
        );
    }
    assert!(points.iter().any(|point| point[2] < -0.4), "no way back");
    let held = |point: &&Vec<f64>| point[2] == 0.0 && (0.11..0.59).contains(&point[1]);
    assert!(points.iter().filter(held).count() > 100, "no feed hold");
    let last = points.last().unwrap();
    assert!((last[1] - 0.1).abs() < 1e-12 && last[2] == 0.0, "{last:?}");
}

/// Pictures that `make demo` does not draw. python/tests/test_vibration.py compares the first. The second is a screenshot of the playground,
/// whose bits depend on the browser.
const OTHERS: [&str; 2] = ["vibration.svg", "playground.png"];

#[test]
fn pictures_in_the_documentation_are_fresh() {
    let drawn_by_demo = demo_dir();
    let pictures: Vec<_> = fs::read_dir(root().join("docs/img")).unwrap().collect();
    assert!(!pictures.is_empty());
    for picture in pictures {
        let committed = picture.unwrap();
        if OTHERS.iter().any(|other| committed.file_name() == *other) {
            continue;
        }
        let drawn = drawn_by_demo.join(committed.file_name());
        assert!(
            fs::read(committed.path()).unwrap() == fs::read(&drawn).unwrap(),
            "copy {} to docs/img",
            drawn.display()
        );
    }
}

#[test]
fn no_label_is_minus_zero() {
    // From -0.1 to 0.2, so a tick lies at zero.
    let drawn = draw("zero", "move zero\nat 0 -0.1 -1\nat 1 0.2 2\n");
    for svg in demo_pictures().into_iter().chain([drawn]) {
        let labels = svg.lines().filter(|line| !line.starts_with('<'));
        let zeros: Vec<_> = labels.filter(|text| text.parse() == Ok(0.0)).collect();
        assert!(!zeros.is_empty());
        assert!(zeros.iter().all(|text| !text.starts_with('-')), "{zeros:?}");
    }
}

#[test]
fn jerk_steps_are_vertical() {
    let double_s = fs::read_to_string(demo_dir().join("double-s-with-cruise.svg")).unwrap();
    let jerk = double_s.lines().find(|line| {
        line.starts_with("<polyline") && line.contains("#8C2882") && line.len() > 1000
    });
    let (_, points) = jerk.unwrap().split_once("points=\"").unwrap();
    let (points, _) = points.split_once('"').unwrap();
    let points: Vec<(i32, i32)> = points
        .split_whitespace()
        .map(|point| {
            let (x, y) = point.split_once(',').unwrap();
            (x.parse().unwrap(), y.parse().unwrap())
        })
        .collect();
    let steps: Vec<_> = points.windows(2).filter(|p| p[0].1 != p[1].1).collect();
    // Seven phases have six borders between them.
    assert_eq!(steps.len(), 6, "{steps:?}");
    assert!(steps.iter().all(|p| p[0].0 == p[1].0), "{steps:?}");
}

#[test]
fn braking_before_a_reversal_is_not_painted_as_acceleration() {
    let reversal = "move back\nphase 0 2 accelerate\nat 0 0 1 -1\nat 1 0.5 0 -1\nat 2 0 -1 -1\n";
    let svg = draw("back", reversal);
    let painted = |color| -> Vec<(i32, i32)> {
        let rectangles = svg
            .lines()
            .filter(|line| line.starts_with("<rect") && line.contains(color));
        let number = |line: &str, name: &str| -> i32 {
            let (_, rest) = line.split_once(&format!(" {name}=\"")).unwrap();
            rest.split_once('"').unwrap().0.parse().unwrap()
        };
        rectangles
            .map(|line| (number(line, "x"), number(line, "x") + number(line, "width")))
            .collect()
    };
    // Three panels and the legend.
    let (brakes, speeds_up) = (painted("#FCE6DE"), painted("#DEF0E2"));
    assert_eq!((brakes.len(), speeds_up.len()), (4, 4), "{svg}");
    for (before, after) in brakes.iter().zip(&speeds_up).take(3) {
        assert!(before.0 < before.1 && before.1 <= after.0 && after.0 < after.1);
    }
}

fn demo_pictures() -> Vec<String> {
    let pictures = DEMO.lines().filter(|line| line.ends_with(".svg"));
    pictures
        .map(|picture| fs::read_to_string(root().join(picture)).unwrap())
        .collect()
}

/// The picture of the one move in `setpoints`, whose title is `name`.
fn draw(name: &str, setpoints: &str) -> String {
    let directory = demo_dir().join("drawn");
    fs::create_dir_all(&directory).unwrap();
    let input = directory.join(format!("{name}.txt"));
    fs::write(&input, setpoints).unwrap();
    let output = example("plot")
        .arg(&directory)
        .stdin(fs::File::open(input).unwrap())
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", printed(&output));
    fs::read_to_string(directory.join(format!("{name}.svg"))).unwrap()
}

#[test]
fn nothing_to_draw_fails() {
    for input in [
        "",
        "move empty\n",
        "at 0 1 2 3\n",
        "move bad\nat 0 inf 0 0\n",
        "move twice\nat 0 1 0 0\nmove twice\nat 0 1 0 0\n",
        "move beside\nat 0 1 0 0\nbeside long\nat 0 1 0 0 0\n",
        "move beside\nat 0 1 0 0\nbeside uneven\nat 0 1 0\nat 1 1\n",
        "move beside\nat 0 1 0 0\nbeside nothing\n",
        "move curves\ncurve none\n",
        "move curves\ncurve short\nat 0 1\ncurve long\nat 0 1 0\n",
        "path long\ncurve long\nat 0 1 2\n",
    ] {
        let file = demo_dir().join("nothing.txt");
        fs::write(&file, input).unwrap();
        let output = example("plot")
            .arg(demo_dir().join("nothing"))
            .stdin(fs::File::open(file).unwrap())
            .output()
            .unwrap();
        assert!(!output.status.success(), "{input:?}: {}", printed(&output));
    }
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
    fs::write(
        &script,
        format!("#!/bin/sh\ntarget/demo/servo \"$1\" | {filter}\n"),
    )
    .unwrap();
    let chmod = Command::new("chmod")
        .arg("+x")
        .arg(&script)
        .status()
        .unwrap();
    assert!(chmod.success());
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
    let mut found = table
        .lines()
        .filter(|line| line.split_whitespace().next() == Some(function));
    let line = found
        .next()
        .unwrap_or_else(|| panic!("no {function} in:\n{table}"));
    line.split_whitespace().skip(1).map(str::to_owned).collect()
}

fn printed(output: &Output) -> String {
    [&output.stdout, &output.stderr]
        .map(|text| String::from_utf8_lossy(text))
        .concat()
}
