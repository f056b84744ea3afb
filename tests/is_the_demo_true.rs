//! Does `make demo` prove and draw what it says, and does its parity table show a wrong bit?

use std::collections::BTreeSet;
use std::fs;
use std::process::{Command, Output};
use std::sync::LazyLock;
use support::{golden, names, printed, read, root};

/// What `make demo` printed. It runs once for all tests of this file.
static DEMO: LazyLock<String> = LazyLock::new(|| {
    let mut make = Command::new("make");
    for choice in ["MAKEFLAGS", "REAL", "POLY", "A_TRAJPOLY3", "A_TRAJPOLY5", "A_TRAJPOLY7"] {
        make.env_remove(choice);
    }
    let output = make.arg("demo").current_dir(root()).output().unwrap();
    assert!(output.status.success(), "{}", printed(&output));
    printed(&output)
});

fn line<'a>(table: &'a str, function: &str) -> Vec<&'a str> {
    let mut lines = table.lines().map(|line| line.split_whitespace().collect::<Vec<_>>());
    let line = lines.find(|line| line.first() == Some(&function));
    line.unwrap_or_else(|| panic!("no {function} in:\n{table}")).split_off(1)
}

#[test]
fn every_golden_row_passes_the_servo_program() {
    let assert_parity = |function: &str, rows: usize| {
        assert_eq!(line(&DEMO, function), [&*rows.to_string(), "0"], "{function}");
    };
    for table in ["bell", "trap", "poly7"] {
        let csv = |kind| read(golden::directory().join(format!("{table}_{kind}_f64.csv")));
        assert_parity(&format!("a_traj{table}_gen"), csv("gen").lines().count() - 1);
        let evaluations = csv("eval");
        for column in evaluations.lines().next().unwrap().split(',').skip(2) {
            assert_parity(&format!("a_traj{table}_{column}"), evaluations.lines().count() - 1);
        }
    }
    assert_eq!(line(&DEMO, "total")[1], "0");
}

fn parity(name: &str, filter: &str) -> Output {
    LazyLock::force(&DEMO);
    let directory = root().join("target/demo").join(name);
    fs::create_dir_all(&directory).unwrap();
    let script = directory.join("servo.sh");
    fs::write(&script, format!("#!/bin/sh\ntarget/demo/servo | {filter}\n")).unwrap();
    assert!(Command::new("chmod").arg("+x").arg(&script).status().unwrap().success());
    let arguments = ["run", "--quiet", "--locked", "-p", "demo", "--bin", "parity"];
    Command::new(env!("CARGO")).args(arguments).arg(script).current_dir(root()).output().unwrap()
}

#[test]
fn one_wrong_bit_fails_and_so_do_missing_answers() {
    // The servo's first answer, one bit above the golden duration 2.71 s.
    let output = parity("one-bit", "sed '1s/^2.71 /2.7100000000000004 /'");
    let table = printed(&output);
    assert!(!output.status.success(), "{table}");
    assert_eq!([line(&table, "a_trajbell_gen")[1], line(&table, "total")[1]], ["1", "1"]);
    assert!(table.contains("bell_gen_f64.csv:2: a_trajbell_gen is"), "{table}");
    for (name, filter) in [("cut", "head -n 1000"), ("silent", "sed d")] {
        assert!(!parity(name, filter).status.success(), "{name}");
    }
}

#[test]
fn the_originals_fail_where_ours_do_not() {
    let (_, table) = DEMO.split_once("of 100000 moves").unwrap();
    let page = read("docs/migrating.md").replace(',', "");
    // Refused, broken, missed and lengthened moves. A trapezoid of the original that exists is the fastest.
    for planner in ["a_trajbell_gen", "atraj_bell_gen", "a_trajtrap_gen", "atraj_trap_gen"] {
        let counts = line(table, planner);
        assert!(page.contains(&format!("| `{planner}` | {} |", counts.join(" | "))), "{planner}: {counts:?}");
        assert_eq!(planner.starts_with("atraj"), counts == ["0"; 4], "{planner}");
    }
}

/// `examples/expected` has the ends of the motions, and the programs fail if they miss them. A picture is drawn from all setpoints.
#[test]
fn each_example_has_its_picture_and_the_pages_show_it() {
    // python/examples/vibration.py draws the first two. The third is a screenshot of the playground, whose bits depend on the browser.
    let mut known = BTreeSet::from(["vibration.svg", "shaper-or-jerk.svg", "playground.png"].map(str::to_owned));
    let readme = read("examples/README.md");
    let examples = names("examples/expected").into_iter().map(|file| file.replace(".txt", ""));
    for name in examples.collect::<BTreeSet<_>>().iter().map(|name| &**name).chain(["sensitivity"]) {
        let start = format!("{name}: ");
        let picture = DEMO.lines().find_map(|line| line.strip_prefix(&start)).expect(&start);
        let file = picture.replace("target/demo/", "");
        let [drawn, shown] = [root().join(picture), root().join("docs/img").join(&file)].map(fs::read_to_string);
        assert!(drawn.unwrap() == shown.unwrap_or_default(), "copy {picture} to docs/img");
        assert!(known.insert(file.clone()), "{name} has the title of another example");
        if name != "sensitivity" {
            let (row, end) = (format!("| `{name}` |"), format!("(../docs/img/{file}) |"));
            let rows = readme.lines().filter(|line| line.starts_with(&row) && line.ends_with(&end));
            assert_eq!(rows.count(), 1, "{row}");
            let text = read(format!("target/demo/{name}.txt"));
            let expected = read(format!("examples/expected/{name}.txt"));
            let mut printed = text.lines();
            assert!(expected.lines().all(|line| printed.any(|other| other == line)), "{name} prints other setpoints");
        }
    }
    let arm = read("examples/expected/12_waypoints.txt");
    let saved = arm.trim_end().rsplit(": ").next().unwrap().replace(" saved", "");
    assert!(read("README.md").contains(&format!("an arm arrives {saved} sooner")), "{saved}");
    for name in names("docs/img") {
        assert!(known.contains(&name), "nothing draws {name}");
    }
}
