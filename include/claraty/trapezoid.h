/*!
 @file trapezoid.h
 @brief CLARAty's trapezoid: a target, start and stop at any time, a setpoint whenever the controller asks
 @details Any consistent unit of length or angle; times in seconds; positions and velocities signed, limits by magnitude.
 The handle is the caller's; nothing is allocated. A handle may be used by one thread at a time. A function refuses an
 argument that is not finite and leaves the handle as it was; on a NULL handle it returns CLARATY_ERR_NULL or NaN or
 does nothing.
*/

#ifndef CLARATY_TRAPEZOID_H
#define CLARATY_TRAPEZOID_H

#include <stddef.h>
#include <stdint.h>

/**
 * Which motion a handle plans.
 */
typedef enum claraty_mode {
    /**
     * from any position and velocity to rest at the target, without a jump and without a needless overshoot
     */
    CLARATY_CORRECTED = 0,
    /**
     * what CLARAty's published listing computes, bit for bit
     */
    CLARATY_LISTING = 1
} claraty_mode;

/**
 * Shape of the velocity over time.
 */
typedef enum claraty_type {
    /**
     * no phase at the maximum velocity
     */
    CLARATY_TRIANGULAR = 0,
    /**
     * cruises at the maximum velocity
     */
    CLARATY_TRAPEZOIDAL = 1
} claraty_type;

/**
 * Bits of what a plan had to put up with.
 */
typedef enum claraty_warning {
    /**
     * the acceleration was below 1e-10 and was raised to it
     */
    CLARATY_WARN_ACCEL = 1,
    /**
     * the deceleration was
     */
    CLARATY_WARN_DECEL = 2,
    /**
     * the maximum velocity was
     */
    CLARATY_WARN_VELOCITY = 4,
    /**
     * listing mode only: no instant to switch from acceleration to deceleration, the motion is wrong
     */
    CLARATY_WARN_SWITCH = 8
} claraty_warning;

/**
 * What a function returns that can fail.
 */
typedef enum claraty_result {
    /**
     * done
     */
    CLARATY_OK = 0,
    /**
     * the handle or an array is NULL
     */
    CLARATY_ERR_NULL = -1,
    /**
     * an argument or the clock is infinite or not a number
     */
    CLARATY_ERR_NOT_FINITE = -2,
    /**
     * not one of `claraty_mode`
     */
    CLARATY_ERR_MODE = -3,
    /**
     * no waypoints, or more than an array can hold
     */
    CLARATY_ERR_WAYPOINTS = -4
} claraty_result;

/**
 * One axis. The caller owns it: on the stack, static or on the heap; there is nothing to release. Without waypoints it
 * may be copied at any time, and the copy runs on its own; with waypoints the copy reads the same arrays.
 */
typedef struct claraty_trapezoid {
    /**
     * not for the caller
     */
    uint64_t opaque[34];
} claraty_trapezoid;

/**
 * Monotonic seconds from any fixed origin. It must not use the handle that it is the clock of.
 */
typedef double (*claraty_clock)(void *user);

/**
 * A planned motion: acceleration up to `t1`, cruise up to `t2`, deceleration up to `tf`. Times in seconds from its start.
 */
typedef struct claraty_profile {
    /**
     * end of the acceleration, s
     */
    double t1;
    /**
     * start of the deceleration, s
     */
    double t2;
    /**
     * end of the motion, s
     */
    double tf;
    /**
     * position at `t1`
     */
    double p_at_t1;
    /**
     * position at `t2`
     */
    double p_at_t2;
    /**
     * position at `tf` and later
     */
    double final_position;
    /**
     * velocity between `t1` and `t2`, signed
     */
    double velocity;
    /**
     * acceleration before `t1`, signed
     */
    double accel;
    /**
     * acceleration after `t2`, signed
     */
    double decel;
    /**
     * `CLARATY_TRIANGULAR` or `CLARATY_TRAPEZOIDAL`
     */
    int type;
} claraty_profile;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/**
 * Makes a handle out of storage, which need not be initialised: at rest at 0, timer at 0, `CLARATY_CORRECTED`, on the
 * monotonic clock of the system; where there is none, on the manual one.
 * @param h the handle
 */
void claraty_trapezoid_init(struct claraty_trapezoid *h);

/**
 * Chooses what the following starts and stops plan.
 * @param h the handle
 * @param mode one of `claraty_mode`
 * @return `CLARATY_OK`, `CLARATY_ERR_NULL` or `CLARATY_ERR_MODE`
 */
int claraty_trapezoid_set_mode(struct claraty_trapezoid *h, int mode);

/**
 * Goes over to another clock; a motion under way goes on from where it is. With a NULL `clock` the clock is manual: it
 * stands still, and only `claraty_trapezoid_advance_timer_by` moves it.
 * @param h the handle
 * @param clock monotonic seconds; NULL for the manual clock, which stands still
 * @param user is given to `clock` with every call
 */
void claraty_trapezoid_set_clock(struct claraty_trapezoid *h, claraty_clock clock, void *user);

/**
 * Stores where to go next; it moves nothing before `claraty_trapezoid_start`. Waypoints of an earlier set are let go: a
 * motion along them ends at rest at the one it is heading for.
 * @param h the handle
 * @param final_position relative to the start of the trajectory, unit
 * @param max_velocity magnitude, unit/s
 * @param accel magnitude of the change from the present velocity to `max_velocity`, unit/s^2
 * @param decel magnitude of the final stop, unit/s^2
 * @return `CLARATY_OK`, `CLARATY_ERR_NULL` or `CLARATY_ERR_NOT_FINITE`
 */
int claraty_trapezoid_set(struct claraty_trapezoid *h,
                          double final_position,
                          double max_velocity,
                          double accel,
                          double decel);

/**
 * Stores a way along `n` positions with rest at each; for the rest as `claraty_trapezoid_set`. In both modes the legs
 * are corrected motions; the first sets off from the present one. The arrays must stay as they are until the next set.
 * @param h the handle
 * @param n number of waypoints
 * @param positions relative to the start of the trajectory, unit
 * @param velocities maximum velocity of the leg to each position, unit/s
 * @param accels acceleration and deceleration of the leg to each position, unit/s^2
 * @return `CLARATY_OK`, `CLARATY_ERR_NULL`, `CLARATY_ERR_NOT_FINITE` or `CLARATY_ERR_WAYPOINTS`
 */
int claraty_trapezoid_set_waypoints(struct claraty_trapezoid *h,
                                    const double *positions,
                                    const double *velocities,
                                    const double *accels,
                                    size_t n);

/**
 * `claraty_trapezoid_set_waypoints` with one velocity and one acceleration for all legs.
 * @param h the handle
 * @param positions one for each waypoint, relative to the start of the trajectory, unit
 * @param n number of waypoints
 * @param max_velocity for every waypoint, unit/s
 * @param accel for every waypoint, unit/s^2
 * @return `CLARATY_OK`, `CLARATY_ERR_NULL`, `CLARATY_ERR_NOT_FINITE` or `CLARATY_ERR_WAYPOINTS`
 */
int claraty_trapezoid_set_uniform_waypoints(struct claraty_trapezoid *h,
                                            const double *positions,
                                            size_t n,
                                            double max_velocity,
                                            double accel);

/**
 * Sets off, timer at 0: from the present motion, or from rest at 0 if there is none.
 * @param h the handle
 * @return the sum of `claraty_warning` bits, or `CLARATY_ERR_NULL` or `CLARATY_ERR_NOT_FINITE`
 */
int claraty_trapezoid_start(struct claraty_trapezoid *h);

/**
 * Brakes the present motion to rest; sets the timer to 0 also if there is none.
 * @param h the handle
 * @return the sum of `claraty_warning` bits, or `CLARATY_ERR_NULL` or `CLARATY_ERR_NOT_FINITE`
 */
int claraty_trapezoid_stop(struct claraty_trapezoid *h);

/**
 * Forgets the present motion and sets the timer to 0. The axis is not braked; the last profile can still be read.
 * @param h the handle
 */
void claraty_trapezoid_reset(struct claraty_trapezoid *h);

/**
 * Whether a motion is under way: from the start until the setpoint has been read after the end.
 * @param h the handle
 * @return 1, 0 or `CLARATY_ERR_NULL`
 */
int claraty_trapezoid_is_started(const struct claraty_trapezoid *h);

/**
 * Adds to what the clock gives, whichever clock it is. A number that is not finite adds nothing.
 * @param h the handle
 * @param seconds to add, s; may be negative
 */
void claraty_trapezoid_advance_timer_by(struct claraty_trapezoid *h, double seconds);

/**
 * @param h the handle
 * @return time since the last start, stop or reset, s; NaN if `h` is NULL
 */
double claraty_trapezoid_elapsed(const struct claraty_trapezoid *h);

/**
 * @param h the handle
 * @return time from the start to rest, all legs together, s; 0 before the first start; NaN if `h` is NULL
 */
double claraty_trapezoid_duration(const struct claraty_trapezoid *h);

/**
 * What the axis shall do now. Reading it after the end of the motion ends the motion.
 * @param h the handle
 * @param position NULL, or where to write the position, unit
 * @param velocity NULL, or where to write the velocity, unit/s
 * @param accel NULL, or where to write the acceleration, unit/s^2
 * @return `CLARATY_OK`, `CLARATY_ERR_NULL` or `CLARATY_ERR_NOT_FINITE`
 */
int claraty_trapezoid_get_setpoint(struct claraty_trapezoid *h, double *position, double *velocity, double *accel);

/**
 * The same at a time after the start, before or after now. In listing mode a look beyond the end ends the motion, and
 * before the start all is 0, as in the listing; a time that is not finite is looked up there too.
 * @param h the handle
 * @param time since the start, s
 * @param position NULL, or where to write the position, unit
 * @param velocity NULL, or where to write the velocity, unit/s
 * @param accel NULL, or where to write the acceleration, unit/s^2
 * @return `CLARATY_OK`, `CLARATY_ERR_NULL` or `CLARATY_ERR_NOT_FINITE`
 */
int claraty_trapezoid_get_setpoint_at(struct claraty_trapezoid *h,
                                      double time,
                                      double *position,
                                      double *velocity,
                                      double *accel);

/**
 * @param h the handle
 * @return position now, unit; NaN where `claraty_trapezoid_get_setpoint` fails
 */
double claraty_trapezoid_get_position(struct claraty_trapezoid *h);

/**
 * @param h the handle
 * @return velocity now, unit/s; NaN where `claraty_trapezoid_get_setpoint` fails
 */
double claraty_trapezoid_get_velocity(struct claraty_trapezoid *h);

/**
 * @param h the handle
 * @return acceleration now, unit/s^2; NaN where `claraty_trapezoid_get_setpoint` fails
 */
double claraty_trapezoid_get_acceleration(struct claraty_trapezoid *h);

/**
 * @param h the handle
 * @param time since the start, s
 * @return position at a time after the start, unit; NaN where `claraty_trapezoid_get_setpoint_at` fails
 */
double claraty_trapezoid_get_position_at(struct claraty_trapezoid *h, double time);

/**
 * @param h the handle
 * @param time since the start, s
 * @return velocity at a time after the start, unit/s; NaN where `claraty_trapezoid_get_setpoint_at` fails
 */
double claraty_trapezoid_get_velocity_at(struct claraty_trapezoid *h, double time);

/**
 * @param h the handle
 * @param time since the start, s
 * @return acceleration at a time after the start, unit/s^2; NaN where `claraty_trapezoid_get_setpoint_at` fails
 */
double claraty_trapezoid_get_acceleration_at(struct claraty_trapezoid *h, double time);

/**
 * The profile of the last start or stop, all 0 before; along waypoints that of the leg last looked at, with times from
 * the start of the leg.
 * @param h the handle
 * @param out NULL, or where to write it
 * @return `CLARATY_OK` or `CLARATY_ERR_NULL`
 */
int claraty_trapezoid_get_profile(const struct claraty_trapezoid *h, struct claraty_profile *out);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* CLARATY_TRAPEZOID_H */
