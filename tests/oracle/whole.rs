//! The tests of the oracle that run no other program, as one program: `make check` compiles the library once for all of them.

#[path = "tests/are_bad_requests_refused.rs"]
mod are_bad_requests_refused;
#[path = "tests/do_axes_arrive_together.rs"]
mod do_axes_arrive_together;
#[path = "tests/do_axes_stay_inside.rs"]
mod do_axes_stay_inside;
#[path = "tests/do_loops_arrive.rs"]
mod do_loops_arrive;
#[path = "tests/do_random_moves_agree.rs"]
mod do_random_moves_agree;
#[path = "tests/do_special_values_agree.rs"]
mod do_special_values_agree;
#[path = "tests/do_units_change_a_move.rs"]
mod do_units_change_a_move;
#[path = "tests/does_a_group_move_as_planned.rs"]
mod does_a_group_move_as_planned;
#[path = "tests/does_a_move_stay_inside.rs"]
mod does_a_move_stay_inside;
#[path = "tests/does_a_path_move_as_planned.rs"]
mod does_a_path_move_as_planned;
#[path = "tests/does_a_path_pass_its_points.rs"]
mod does_a_path_pass_its_points;
#[path = "tests/does_every_plan_pass.rs"]
mod does_every_plan_pass;
#[path = "tests/does_the_c_abi_agree.rs"]
mod does_the_c_abi_agree;
#[path = "tests/does_the_clock_keep_the_limits.rs"]
mod does_the_clock_keep_the_limits;
#[path = "tests/how_long_is_a_search.rs"]
mod how_long_is_a_search;
#[path = "tests/is_a_difference_seen.rs"]
mod is_a_difference_seen;
#[path = "tests/is_a_path_nearly_the_shortest.rs"]
mod is_a_path_nearly_the_shortest;
#[path = "tests/is_a_signal_followed_as_near.rs"]
mod is_a_signal_followed_as_near;
#[path = "tests/is_a_step_lost.rs"]
mod is_a_step_lost;
#[path = "tests/is_a_wrong_motion_seen.rs"]
mod is_a_wrong_motion_seen;
#[path = "tests/is_each_phase_exact.rs"]
mod is_each_phase_exact;
#[path = "tests/is_the_fastest_motion_right.rs"]
mod is_the_fastest_motion_right;
#[path = "tests/is_the_original_golden.rs"]
mod is_the_original_golden;
#[path = "tests/is_the_solver_right.rs"]
mod is_the_solver_right;
#[path = "tests/what_does_the_original_break.rs"]
mod what_does_the_original_break;
