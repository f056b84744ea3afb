//! Runs the tests with one mutant on after the other.

use crate::mutant::Mutant;
use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

/// Tests of one program: its name, and the part of it that runs.
type Step = (&'static str, &'static str);

/// Processor seconds that a test may take with a mutant: a fixed part, and a multiple of its time without one. A test that takes more hangs.
const ALLOWED: (f64, f64) = (5.0, 10.0);

/// The tests that can see a mutant of this storey, the fast ones first. The tests of the C functions and the unit tests take some milliseconds, so
/// they are first everywhere.
fn steps(storey: &str) -> Vec<Step> {
    let ours: &[Step] = match storey {
        "liba" => &[
            ("root", "is_golden_data_met"),
            ("root", "is_the_search_literal"),
            ("oracle", "do_special_values_agree"),
            ("oracle", "does_the_c_abi_agree"),
            ("root", "is_a_bad_move_seen"),
            ("root", "do_samples_equal_calls"),
            ("root", "is_an_extreme_missed"),
            ("root", "are_motion_laws_kept"),
            ("oracle", "how_long_is_a_search"),
        ],
        "claraty" => &[
            ("root", "is_golden_data_met"),
            ("root", "is_claraty_right_off_script"),
            ("root", "is_a_corrected_motion_wrong"),
        ],
        "fastest" => &[
            ("oracle", "is_a_wrong_motion_seen::without"),
            ("root", "is_a_bad_move_seen"),
            ("root", "do_known_defects_stay_fixed"),
            ("root", "are_motion_laws_kept"),
            ("root", "is_an_extreme_missed"),
            ("oracle", "is_the_fastest_motion_right"),
        ],
        "online" => ONLINE,
        "together" => TOGETHER,
        "together/path" => &[
            ("border", ""),
            ("oracle", "does_a_path_pass_its_points"),
            ("root", "do_known_defects_stay_fixed"),
            ("oracle", "are_bad_requests_refused"),
            (
                "oracle",
                "is_a_path_nearly_the_shortest::beside_the_example",
            ),
            ("oracle", "is_a_path_nearly_the_shortest::beside_the_move"),
            ("oracle", "is_a_path_nearly_the_shortest::beside_random"),
            ("oracle", "is_a_path_nearly_the_shortest::ten_sections"),
            ("oracle", "is_a_path_nearly_the_shortest::improvements"),
            ("oracle", "does_every_plan_pass"),
        ],
        "machine" => &[
            ("root", "is_a_load_left_at_rest"),
            ("oracle", "is_a_step_lost"),
            ("oracle", "does_the_clock_keep_the_limits"),
            ("root", "is_a_signal_followed"),
            ("root", "do_known_defects_stay_fixed"),
            ("root", "does_a_plan_take_over_in_time::in_its_own_tick"),
        ],
        _ => &[
            ("root", "is_golden_data_met"),
            ("root", "do_samples_equal_calls"),
            ("root", "is_a_load_left_at_rest"),
            ("oracle", "do_special_values_agree"),
            ("oracle", "does_the_c_abi_agree"),
        ],
    };
    let mut steps = vec![("c", ""), ("unit", "")];
    // Builds that hold other code.
    match storey {
        "capi" => steps.push(("compact", "")),
        "real" => steps.push(("soft", "")),
        _ => {}
    }
    steps.extend(ours);
    for &step in [ONLINE, TOGETHER].into_iter().flatten() {
        let is_later = matches!(storey, "real" | "capi" | "shared" | "online" | "fastest");
        if is_later && !steps.contains(&step) {
            steps.push(step);
        }
    }
    steps
}

const ONLINE: &[Step] = &[
    ("oracle", "is_a_wrong_motion_seen::without"),
    ("oracle", "are_bad_requests_refused"),
    ("root", "is_a_bad_move_seen"),
    ("root", "do_known_defects_stay_fixed"),
    ("root", "does_a_move_go_on"),
    ("root", "is_the_first_time_found"),
    ("root", "do_moves_have_few_phases"),
    ("oracle", "does_every_plan_pass::plans_of_one"),
    ("oracle", "does_a_replan_detour"),
    ("oracle", "does_a_move_stay_inside"),
    ("root", "are_motion_laws_kept"),
    ("root", "does_a_loop_arrive_in_time::plans"),
];

const TOGETHER: &[Step] = &[
    ("oracle", "do_axes_arrive_together::f"),
    ("oracle", "are_bad_requests_refused"),
    ("oracle", "does_every_plan_pass"),
    ("root", "do_known_defects_stay_fixed"),
    ("root", "does_a_stretched_axis_move_slowly"),
    ("root", "are_motion_laws_kept"),
    ("root", "does_a_line_stop_on_itself"),
    ("root", "is_a_signal_followed"),
    ("oracle", "do_axes_stay_inside"),
    ("root", "does_a_loop_arrive_in_time"),
];

/// Judges the mutants that have no line in the results, a line for each: storey, verdict, the test that saw it, seconds, name. Several
/// processes may do so at once: a file in `claims` tells whose a mutant is.
pub fn all(
    drawn: &[Mutant],
    left_out: &[(&'static str, BTreeSet<u32>)],
    programs: &Path,
    claims: &Path,
    results: &Path,
) {
    let known = fs::read_to_string(results).unwrap_or_default();
    let known: BTreeSet<_> = known
        .lines()
        .filter_map(|line| line.rsplit('\t').next())
        .collect();
    let mut file = OpenOptions::new()
        .create(true)
        .append(true)
        .open(results)
        .expect("results");
    let mut allowed = BTreeMap::new();
    for mutant in drawn
        .iter()
        .filter(|mutant| !known.contains(mutant.name().as_str()))
    {
        let claim = claims.join(mutant.number.to_string());
        if OpenOptions::new()
            .write(true)
            .create_new(true)
            .open(claim)
            .is_err()
        {
            continue;
        }
        let start = Instant::now();
        let reason = left_out
            .iter()
            .find(|(_, numbers)| numbers.contains(&mutant.number));
        let (verdict, by) = match reason {
            Some((reason, _)) => (*reason, String::new()),
            None => judge(mutant, programs, &mut allowed),
        };
        let seconds = start.elapsed().as_secs_f64();
        let line = format!(
            "{}\t{verdict}\t{by}\t{seconds:.1}\t{}\n",
            mutant.storey(),
            mutant.name()
        );
        file.write_all(line.as_bytes()).expect("results");
    }
}

fn judge(
    mutant: &Mutant,
    programs: &Path,
    allowed: &mut BTreeMap<Step, u64>,
) -> (&'static str, String) {
    for step in steps(mutant.storey()) {
        let limit = *allowed.entry(step).or_insert_with(|| {
            let start = Instant::now();
            assert_eq!(
                run(programs, step, 0, 3600),
                Some(0),
                "{step:?} fails without a mutant"
            );
            (ALLOWED.0 + ALLOWED.1 * start.elapsed().as_secs_f64()) as u64
        });
        let by = format!("{} {}", step.0, step.1);
        match run(programs, step, mutant.number, limit) {
            Some(0) => {}
            // The shell's sum for a process that used up its processor time.
            Some(152 | 137) => return ("timeout", by),
            _ => return ("killed", by),
        }
    }
    ("survived", String::new())
}

/// The exit code of these tests with a mutant on; none without one.
fn run(programs: &Path, (program, part): Step, number: u32, seconds: u64) -> Option<i32> {
    let mut shell = Command::new("sh");
    shell.args([
        "-c",
        "ulimit -c 0; ulimit -t \"$0\"; \"$@\"; exit $?",
        &seconds.to_string(),
    ]);
    shell.arg(programs.join(program));
    shell.args([part, "--test-threads=1", "-q"]);
    shell.env("MUTANT", number.to_string());
    shell
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    shell.status().expect("a shell").code()
}
