// Plans of Ruckig's C++ library for the benchmark, one function for each number of axes. tests/ruckig.sh compiles this file.
#include <cstddef>
#include <ruckig/ruckig.hpp>

namespace {

// The numbers of an axis: limits, start and target, each in the order of position, velocity, acceleration.
struct Axis {
    double vmax, vmin, amax, amin, jmax;
    double p0, v0, a0, p1, v1, a1;
};

// Like a control loop, each plan overwrites the last one. Returns the duration, s; negative on an error.
template<std::size_t N> double plan(const Axis *axes) {
    static ruckig::Ruckig<N> planner;
    static ruckig::InputParameter<N> input;
    static ruckig::Trajectory<N> trajectory;
    input.min_velocity.emplace();
    input.min_acceleration.emplace();
    for (std::size_t k = 0; k < N; ++k) {
        const Axis &axis = axes[k];
        input.max_velocity[k] = axis.vmax;
        (*input.min_velocity)[k] = axis.vmin;
        input.max_acceleration[k] = axis.amax;
        (*input.min_acceleration)[k] = axis.amin;
        input.max_jerk[k] = axis.jmax;
        input.current_position[k] = axis.p0;
        input.current_velocity[k] = axis.v0;
        input.current_acceleration[k] = axis.a0;
        input.target_position[k] = axis.p1;
        input.target_velocity[k] = axis.v1;
        input.target_acceleration[k] = axis.a1;
    }
    return planner.calculate(input, trajectory) < 0 ? -1.0 : trajectory.get_duration();
}

} // namespace

extern "C" {
double ruckig_plan_1(const Axis *axes) { return plan<1>(axes); }
double ruckig_plan_3(const Axis *axes) { return plan<3>(axes); }
double ruckig_plan_6(const Axis *axes) { return plan<6>(axes); }
double ruckig_plan_12(const Axis *axes) { return plan<12>(axes); }
}
