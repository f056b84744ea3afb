/*!
 @file trajtrap.h
 @brief trapezoidal velocity trajectory
 @details Limited acceleration and velocity; Biagotti & Melchiorri, Trajectory Planning for Automatic Machines and
 Robots, section 3.2. Any consistent unit of length or angle; times in seconds from the start of the move.
*/

#ifndef LIBA_TRAJTRAP_H
#define LIBA_TRAJTRAP_H

#include "a.h"

typedef struct a_trajtrap a_trajtrap;

#if defined(__cplusplus)
extern "C" {
#endif /* __cplusplus */

/**
 * @brief Plan a trapezoidal velocity trajectory.
 *
 * With `c = (v1^2*ac - v0^2*de - 2*(p1-p0)*ac*de)/(ac-de)`, the squared velocity at which both slopes meet, the move
 * cruises at `vm` if `c > vm^2`, else it peaks at `sqrt(c)`, or only speeds up or slows down if the distance is too
 * short to reach `v1`; then `v1` is what is reached.
 * @param ctx points to an instance of trapezoidal velocity trajectory, which need not be initialised
 * @param vm maximum velocity, unit/s; its sign is ignored
 * @param ac acceleration before constant velocity, unit/s^2, signed
 * @param de acceleration after constant velocity, unit/s^2, signed, other than `ac`
 * @param p0 initial position, unit
 * @param p1 final position, unit
 * @param v0 initial velocity, unit/s, limited to -vm .. vm
 * @param v1 final velocity, unit/s, limited to -vm .. vm
 * @return total duration, s; 0 if no such trajectory exists or `ctx` is NULL. A NaN argument gives NaN or 0.
 */
A_EXTERN
a_float a_trajtrap_gen(struct a_trajtrap *ctx,
                       a_float vm,
                       a_float ac,
                       a_float de,
                       a_float p0,
                       a_float p1,
                       a_float v0,
                       a_float v1);

/**
 * @brief Position of a trapezoidal velocity trajectory.
 * @param ctx points to a planned instance of trapezoidal velocity trajectory
 * @param x time since the start, s
 * @return position, unit: `p0` before the start and for a NaN `x`, `p1` after the end; NaN if `ctx` is NULL
 */
A_EXTERN a_float a_trajtrap_pos(const struct a_trajtrap *ctx, a_float x);

/**
 * @brief Velocity of a trapezoidal velocity trajectory.
 * @param ctx points to a planned instance of trapezoidal velocity trajectory
 * @param x time since the start, s
 * @return velocity, unit/s: `v0` before the start and for a NaN `x`, `v1` after the end; NaN if `ctx` is NULL
 */
A_EXTERN a_float a_trajtrap_vel(const struct a_trajtrap *ctx, a_float x);

/**
 * @brief Acceleration of a trapezoidal velocity trajectory.
 * @param ctx points to a planned instance of trapezoidal velocity trajectory
 * @param x time since the start, s
 * @return acceleration, unit/s^2: 0 outside the move and for a NaN `x`; NaN if `ctx` is NULL
 */
A_EXTERN a_float a_trajtrap_acc(const struct a_trajtrap *ctx, a_float x);

#if defined(__cplusplus)
} /* extern "C" */
namespace a
{
typedef struct a_trajtrap trajtrap;
} /* namespace a */
#endif /* __cplusplus */

/**
 * @brief Trapezoidal velocity trajectory.
 *
 * Acceleration and velocity are limited. All values are signed: a deceleration is negative for a forward move, and
 * both rates change sign for a backward one.
 */
struct a_trajtrap {
    /**
     * total duration, s
     */
    a_float t;
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
     * final velocity, as far as it can be reached
     */
    a_float v1;
    /**
     * constant velocity, or the highest reached
     */
    a_float vc;
    /**
     * time before constant velocity, s
     */
    a_float ta;
    /**
     * time after constant velocity, s
     */
    a_float td;
    /**
     * position before constant velocity
     */
    a_float pa;
    /**
     * position after constant velocity
     */
    a_float pd;
    /**
     * acceleration before constant velocity
     */
    a_float ac;
    /**
     * acceleration after constant velocity
     */
    a_float de;
#if defined(__cplusplus)
    a_float gen(a_float vm, a_float ac_, a_float de_, a_float p0_, a_float p1_, a_float v0_ = 0, a_float v1_ = 0)
    {
        return a_trajtrap_gen(this, vm, ac_, de_, p0_, p1_, v0_, v1_);
    }
    a_float pos(a_float x) const { return a_trajtrap_pos(this, x); }
    a_float vel(a_float x) const { return a_trajtrap_vel(this, x); }
    a_float acc(a_float x) const { return a_trajtrap_acc(this, x); }
#endif /* __cplusplus */
};

#endif /* LIBA_TRAJTRAP_H */
