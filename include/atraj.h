/*!
 @file atraj.h
 @brief whole moves and whole states in one call
 @details What liba does not have, on the structs that it has. Every value has the bits of the single functions. An array
 that is NULL is left out; the others may not overlap each other or the trajectory.
*/

#ifndef ATRAJ_H
#define ATRAJ_H

#include "a/trajbell.h"
#include "a/trajtrap.h"
#include "a/trajpoly3.h"
#include "a/trajpoly5.h"
#include "a/trajpoly7.h"

#if defined(__cplusplus)
extern "C" {
#endif /* __cplusplus */

/**
 * @brief Sample a bell-shaped velocity trajectory: positions, velocities, accelerations and jerks at evenly spaced times.
 *
 * Sample `k` is taken at `x0 + k*dt` and has the bits of the single functions at that time.
 * @param ctx points to a planned instance of bell-shaped velocity trajectory
 * @param x0 time of sample 0 since the start, s
 * @param dt from one sample to the next, s; may be 0 or negative
 * @param n number of samples
 * @param pos position, unit: NULL or an array of `n`
 * @param vel velocity, unit/s: NULL or an array of `n`
 * @param acc acceleration, unit/s^2: NULL or an array of `n`
 * @param jer jerk, unit/s^3: NULL or an array of `n`
 * @return number of samples written: `n`, at most 2147483647; 0 if `ctx` is NULL
 */
A_EXTERN
size_t atraj_bell_sample(const a_trajbell *ctx,
                         a_float x0,
                         a_float dt,
                         size_t n,
                         a_float *pos,
                         a_float *vel,
                         a_float *acc,
                         a_float *jer);

/**
 * @brief State of a bell-shaped velocity trajectory: position, velocity, acceleration and jerk at one time, found together.
 *
 * They have the bits of the single functions.
 * @param ctx points to a planned instance of bell-shaped velocity trajectory; all are NaN if it is NULL
 * @param x time since the start, s
 * @param pos position, unit: NULL or where to write it
 * @param vel velocity, unit/s: NULL or where to write it
 * @param acc acceleration, unit/s^2: NULL or where to write it
 * @param jer jerk, unit/s^3: NULL or where to write it
 */
A_EXTERN
void atraj_bell_state(const a_trajbell *ctx,
                      a_float x,
                      a_float *pos,
                      a_float *vel,
                      a_float *acc,
                      a_float *jer);

/**
 * @brief Sample a trapezoidal velocity trajectory: positions, velocities and accelerations at evenly spaced times.
 *
 * Sample `k` is taken at `x0 + k*dt` and has the bits of the single functions at that time.
 * @param ctx points to a planned instance of trapezoidal velocity trajectory
 * @param x0 time of sample 0 since the start, s
 * @param dt from one sample to the next, s; may be 0 or negative
 * @param n number of samples
 * @param pos position, unit: NULL or an array of `n`
 * @param vel velocity, unit/s: NULL or an array of `n`
 * @param acc acceleration, unit/s^2: NULL or an array of `n`
 * @return number of samples written: `n`, at most 2147483647; 0 if `ctx` is NULL
 */
A_EXTERN
size_t atraj_trap_sample(const a_trajtrap *ctx,
                         a_float x0,
                         a_float dt,
                         size_t n,
                         a_float *pos,
                         a_float *vel,
                         a_float *acc);

/**
 * @brief State of a trapezoidal velocity trajectory: position, velocity and acceleration at one time, found together.
 *
 * They have the bits of the single functions.
 * @param ctx points to a planned instance of trapezoidal velocity trajectory; all are NaN if it is NULL
 * @param x time since the start, s
 * @param pos position, unit: NULL or where to write it
 * @param vel velocity, unit/s: NULL or where to write it
 * @param acc acceleration, unit/s^2: NULL or where to write it
 */
A_EXTERN void atraj_trap_state(const a_trajtrap *ctx, a_float x, a_float *pos, a_float *vel, a_float *acc);

/**
 * @brief Sample a cubic polynomial trajectory: positions, velocities and accelerations at evenly spaced times.
 *
 * Sample `k` is taken at `x0 + k*dt` and has the bits of the single functions at that time.
 *
 * What the struct has no coefficients of, for they are above its level, is found from those of position.
 * @param ctx points to a planned instance of cubic polynomial trajectory
 * @param x0 time of sample 0 since the start, s
 * @param dt from one sample to the next, s; may be 0 or negative
 * @param n number of samples
 * @param pos position, unit: NULL or an array of `n`
 * @param vel velocity, unit/s: NULL or an array of `n`
 * @param acc acceleration, unit/s^2: NULL or an array of `n`
 * @return number of samples written: `n`, at most 2147483647; 0 if `ctx` is NULL
 */
A_EXTERN
size_t atraj_poly3_sample(const a_trajpoly3 *ctx,
                          a_float x0,
                          a_float dt,
                          size_t n,
                          a_float *pos,
                          a_float *vel,
                          a_float *acc);

/**
 * @brief State of a cubic polynomial trajectory: position, velocity and acceleration at one time, found together.
 *
 * They have the bits of the single functions.
 *
 * What the struct has no coefficients of, for they are above its level, is found from those of position.
 * @param ctx points to a planned instance of cubic polynomial trajectory; all are NaN if it is NULL
 * @param x time since the start, s
 * @param pos position, unit: NULL or where to write it
 * @param vel velocity, unit/s: NULL or where to write it
 * @param acc acceleration, unit/s^2: NULL or where to write it
 */
A_EXTERN void atraj_poly3_state(const a_trajpoly3 *ctx, a_float x, a_float *pos, a_float *vel, a_float *acc);

/**
 * @brief Sample a quintic polynomial trajectory: positions, velocities and accelerations at evenly spaced times.
 *
 * Sample `k` is taken at `x0 + k*dt` and has the bits of the single functions at that time.
 *
 * What the struct has no coefficients of, for they are above its level, is found from those of position.
 * @param ctx points to a planned instance of quintic polynomial trajectory
 * @param x0 time of sample 0 since the start, s
 * @param dt from one sample to the next, s; may be 0 or negative
 * @param n number of samples
 * @param pos position, unit: NULL or an array of `n`
 * @param vel velocity, unit/s: NULL or an array of `n`
 * @param acc acceleration, unit/s^2: NULL or an array of `n`
 * @return number of samples written: `n`, at most 2147483647; 0 if `ctx` is NULL
 */
A_EXTERN
size_t atraj_poly5_sample(const a_trajpoly5 *ctx,
                          a_float x0,
                          a_float dt,
                          size_t n,
                          a_float *pos,
                          a_float *vel,
                          a_float *acc);

/**
 * @brief State of a quintic polynomial trajectory: position, velocity and acceleration at one time, found together.
 *
 * They have the bits of the single functions.
 *
 * What the struct has no coefficients of, for they are above its level, is found from those of position.
 * @param ctx points to a planned instance of quintic polynomial trajectory; all are NaN if it is NULL
 * @param x time since the start, s
 * @param pos position, unit: NULL or where to write it
 * @param vel velocity, unit/s: NULL or where to write it
 * @param acc acceleration, unit/s^2: NULL or where to write it
 */
A_EXTERN void atraj_poly5_state(const a_trajpoly5 *ctx, a_float x, a_float *pos, a_float *vel, a_float *acc);

/**
 * @brief Sample a septic polynomial trajectory: positions, velocities, accelerations and jerks at evenly spaced times.
 *
 * Sample `k` is taken at `x0 + k*dt` and has the bits of the single functions at that time.
 *
 * What the struct has no coefficients of, for they are above its level, is found from those of position.
 * @param ctx points to a planned instance of septic polynomial trajectory
 * @param x0 time of sample 0 since the start, s
 * @param dt from one sample to the next, s; may be 0 or negative
 * @param n number of samples
 * @param pos position, unit: NULL or an array of `n`
 * @param vel velocity, unit/s: NULL or an array of `n`
 * @param acc acceleration, unit/s^2: NULL or an array of `n`
 * @param jer jerk, unit/s^3: NULL or an array of `n`
 * @return number of samples written: `n`, at most 2147483647; 0 if `ctx` is NULL
 */
A_EXTERN
size_t atraj_poly7_sample(const a_trajpoly7 *ctx,
                          a_float x0,
                          a_float dt,
                          size_t n,
                          a_float *pos,
                          a_float *vel,
                          a_float *acc,
                          a_float *jer);

/**
 * @brief State of a septic polynomial trajectory: position, velocity, acceleration and jerk at one time, found together.
 *
 * They have the bits of the single functions.
 *
 * What the struct has no coefficients of, for they are above its level, is found from those of position.
 * @param ctx points to a planned instance of septic polynomial trajectory; all are NaN if it is NULL
 * @param x time since the start, s
 * @param pos position, unit: NULL or where to write it
 * @param vel velocity, unit/s: NULL or where to write it
 * @param acc acceleration, unit/s^2: NULL or where to write it
 * @param jer jerk, unit/s^3: NULL or where to write it
 */
A_EXTERN
void atraj_poly7_state(const a_trajpoly7 *ctx,
                       a_float x,
                       a_float *pos,
                       a_float *vel,
                       a_float *acc,
                       a_float *jer);

#if defined(__cplusplus)
} /* extern "C" */
#endif /* __cplusplus */

#endif /* ATRAJ_H */
