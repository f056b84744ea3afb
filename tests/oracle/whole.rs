//! The tests of the oracle that run no other program, as one program: `make check` compiles the library once for all of them.

#[path = "tests"]
mod tests {
    mod are_bad_requests_refused;
    mod do_axes_arrive_together;
    mod do_axes_stay_inside;
    mod do_loops_arrive;
    mod do_random_moves_agree;
    mod do_special_values_agree;
    mod do_units_change_a_move;
    mod does_a_group_move_as_planned;
    mod does_a_move_stay_inside;
    mod does_a_path_move_as_planned;
    mod does_a_path_pass_its_points;
    mod does_a_path_stay_near_its_lines;
    mod does_every_plan_pass;
    mod does_the_c_abi_agree;
    mod does_the_clock_keep_the_limits;
    mod how_long_is_a_search;
    mod is_a_difference_seen;
    mod is_a_path_nearly_the_shortest;
    mod is_a_signal_followed_as_near;
    mod is_a_step_lost;
    mod is_a_wrong_motion_seen;
    mod is_each_phase_exact;
    mod is_the_fastest_motion_right;
    mod is_the_original_golden;
    mod is_the_solver_right;
    mod what_does_the_original_break;
}
