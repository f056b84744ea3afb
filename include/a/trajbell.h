/*!
 @file trajbell.h
 @brief bell-shaped (double-S) velocity trajectory
 @details Limited jerk, acceleration and velocity; Biagotti & Melchiorri, Trajectory Planning for Automatic Machines and
 Robots, section 3.4. Any consistent unit of length or angle; times in seconds from the start of the move.
*/

#ifndef LIBA_TRAJBELL_H
#define LIBA_TRAJBELL_H

#include "a.h"

typedef struct a_trajbell a_trajbell;

#if defined(__cplusplus)
extern "C" {
#endif /* __cplusplus */

/**
 * @brief Plan a bell-shaped velocity trajectory.
 *
 * With room to cruise, `D = vm - v0` is reached with `taj = am/jm`, `ta = taj + D/am`, or, where `D*jm < am^2`, with
 * `taj = sqrt(D/jm)`, `ta = 2*taj`; the same backwards from `v1`; `tv = (p1-p0)/vm - ta/2*(1+v0/vm) - td/2*(1+v1/vm)`.
 * Without, the acceleration is halved down to the highest one whose ramps fit into the distance.
 * @param ctx points to an instance of bell-shaped velocity trajectory, which need not be initialised
 * @param jm maximum jerk, unit/s^3; its sign is ignored
 * @param am maximum acceleration, unit/s^2; its sign is ignored
 * @param vm maximum velocity, unit/s; its sign is ignored
 * @param p0 initial position, unit
 * @param p1 final position, unit
 * @param v0 initial velocity, unit/s, limited to -vm .. vm
 * @param v1 final velocity, unit/s, limited to -vm .. vm
 * @return total duration, s; 0 if no such trajectory exists or `ctx` is NULL. A NaN argument gives NaN or 0.
 */
A_EXTERN
a_float a_trajbell_gen(struct a_trajbell *ctx,
                       a_float jm,
                       a_float am,
                       a_float vm,
                       a_float p0,
                       a_float p1,
                       a_float v0,
                       a_float v1);

/**
 * @brief Position of a bell-shaped velocity trajectory.
 * @param ctx points to a planned instance of bell-shaped velocity trajectory
 * @param x time since the start, s
 * @return position, unit: `p0` before the start, `p1` after the end and for a NaN `x`; NaN if `ctx` is NULL
 */
A_EXTERN a_float a_trajbell_pos(const struct a_trajbell *ctx, a_float x);

/**
 * @brief Velocity of a bell-shaped velocity trajectory.
 * @param ctx points to a planned instance of bell-shaped velocity trajectory
 * @param x time since the start, s
 * @return velocity, unit/s: `v0` before the start, `v1` after the end and for a NaN `x`; NaN if `ctx` is NULL
 */
A_EXTERN a_float a_trajbell_vel(const struct a_trajbell *ctx, a_float x);

/**
 * @brief Acceleration of a bell-shaped velocity trajectory.
 * @param ctx points to a planned instance of bell-shaped velocity trajectory
 * @param x time since the start, s
 * @return acceleration, unit/s^2: 0 outside the move and for a NaN `x`; NaN if `ctx` is NULL
 */
A_EXTERN a_float a_trajbell_acc(const struct a_trajbell *ctx, a_float x);

/**
 * @brief Jerk of a bell-shaped velocity trajectory.
 * @param ctx points to a planned instance of bell-shaped velocity trajectory
 * @param x time since the start, s
 * @return jerk, unit/s^3: 0 outside the move and for a NaN `x`; NaN if `ctx` is NULL
 */
A_EXTERN a_float a_trajbell_jer(const struct a_trajbell *ctx, a_float x);

#if defined(__cplusplus)
} /* extern "C" */
namespace a
{
typedef struct a_trajbell trajbell;
} /* namespace a */
#endif /* __cplusplus */

/**
 * @brief Bell-shaped (double-S) velocity trajectory.
 *
 * Jerk, acceleration and velocity are limited. For a move towards smaller positions (`p0 > p1`) the velocities,
 * accelerations and jerks stored here are those of the mirrored axis; `v0` and `v1` are always the caller's.
 */
struct a_trajbell {
    /**
     * total duration, s
     */
    a_float t;
    /**
     * constant velocity phase, s
     */
    a_float tv;
    /**
     * acceleration phase, s
     */
    a_float ta;
    /**
     * deceleration phase, s
     */
    a_float td;
    /**
     * time-interval in which the jerk is constant (j max or j min) during the acceleration phase, s
     */
    a_float taj;
    /**
     * time-interval in which the jerk is constant (j max or j min) during the deceleration phase, s
     */
    a_float tdj;
    /**
     * initial position
     */
    a_float p0;
    /**
     * final position
     */
    a_float p1;
    /**
     * initial velocity
     */
    a_float v0;
    /**
     * final velocity
     */
    a_float v1;
    /**
     * highest velocity reached
     */
    a_float vm;
    /**
     * jerk
     */
    a_float jm;
    /**
     * highest acceleration reached
     */
    a_float am;
    /**
     * highest deceleration reached, negative
     */
    a_float dm;
#if defined(__cplusplus)
    a_float gen(a_float jm_, a_float am_, a_float vm_, a_float p0_, a_float p1_, a_float v0_ = 0, a_float v1_ = 0)
    {
        return a_trajbell_gen(this, jm_, am_, vm_, p0_, p1_, v0_, v1_);
    }
    a_float pos(a_float x) const { return a_trajbell_pos(this, x); }
    a_float vel(a_float x) const { return a_trajbell_vel(this, x); }
    a_float acc(a_float x) const { return a_trajbell_acc(this, x); }
    a_float jer(a_float x) const { return a_trajbell_jer(this, x); }
#endif /* __cplusplus */
};

#endif /* LIBA_TRAJBELL_H */
