/*!
 @file trajpoly3.h
 @brief cubic polynomial trajectory
 @details Prescribed position and velocity at both ends of a move of prescribed duration; Biagotti & Melchiorri,
 Trajectory Planning for Automatic Machines and Robots, section 2.1. Any consistent unit of length or angle; times in
 seconds from the start of the move.
*/

#ifndef LIBA_TRAJPOLY3_H
#define LIBA_TRAJPOLY3_H

#include "a.h"

/*! How many of the coefficient arrays p v a j the struct holds: 1 .. 3. It must be what the archive was built with. */
#if !defined(A_TRAJPOLY3)
#if defined(ATRAJ_TRAJPOLY3)
#define A_TRAJPOLY3 ATRAJ_TRAJPOLY3
#else
#define A_TRAJPOLY3 3
#endif
#endif
#if (A_TRAJPOLY3 + 0 < 1) || (A_TRAJPOLY3 + 0 > 3)
#error "A_TRAJPOLY3 does not exist at this level: define it as 1 .. 3 or leave it undefined."
#endif
#if defined(A_TRAJPOLY_COMPACT) && (A_TRAJPOLY3 + 0 != 3)
#error "The structs of A_TRAJPOLY_COMPACT have no levels: leave A_TRAJPOLY3 undefined."
#endif
#if defined(ATRAJ_TRAJPOLY3) && (A_TRAJPOLY3 + 0 != ATRAJ_TRAJPOLY3)
#error "A_TRAJPOLY3 differs from the archive beside this header: rebuild it with A_TRAJPOLY3=... make dist, or leave it undefined."
#endif

typedef struct a_trajpoly3 a_trajpoly3;

#if defined(__cplusplus)
extern "C" {
#endif /* __cplusplus */

/**
 * @brief Plan a cubic polynomial trajectory: all coefficients that the struct holds.
 *
 * A duration of 0, an infinity or a NaN gives coefficients that are not finite. Nothing happens if `ctx` is NULL.
 * @param ctx points to an instance of cubic polynomial trajectory, which need not be initialised
 * @param ts duration, s, other than 0
 * @param p0 initial position, unit
 * @param p1 final position, unit
 * @param v0 initial velocity, unit/s
 * @param v1 final velocity, unit/s
 */
A_EXTERN void a_trajpoly3_gen(struct a_trajpoly3 *ctx, a_float ts, a_float p0, a_float p1, a_float v0, a_float v1);

#if !defined(A_TRAJPOLY_COMPACT)
/**
 * @brief Coefficients of position of a cubic polynomial trajectory.
 *
 * A duration of 0, an infinity or a NaN gives coefficients that are not finite. Nothing happens if `ctx` is NULL.
 * @param ctx points to an instance of cubic polynomial trajectory, which need not be initialised
 * @param ts duration, s, other than 0
 * @param p0 initial position, unit
 * @param p1 final position, unit
 * @param v0 initial velocity, unit/s
 * @param v1 final velocity, unit/s
 */
A_EXTERN void a_trajpoly3_gen0(struct a_trajpoly3 *ctx, a_float ts, a_float p0, a_float p1, a_float v0, a_float v1);
#endif

#if (!defined(A_TRAJPOLY_COMPACT) && A_TRAJPOLY3 + 0 > 1)
/**
 * @brief Coefficients of velocity, from those of position: `v[i] = p[i+1]*(i+1)`.
 * @param ctx points to an instance of cubic polynomial trajectory; nothing happens if it is NULL
 */
A_EXTERN void a_trajpoly3_gen1(struct a_trajpoly3 *ctx);
#endif

#if (!defined(A_TRAJPOLY_COMPACT) && A_TRAJPOLY3 + 0 > 2)
/**
 * @brief Coefficients of acceleration, from those of velocity: `a[i] = v[i+1]*(i+1)`.
 * @param ctx points to an instance of cubic polynomial trajectory; nothing happens if it is NULL
 */
A_EXTERN void a_trajpoly3_gen2(struct a_trajpoly3 *ctx);
#endif

#if defined(A_TRAJPOLY_COMPACT)
/**
 * @brief Copy the coefficients of position out.
 * @param ctx points to a planned instance of cubic polynomial trajectory
 * @param c0 array of 4, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
 */
A_EXTERN void a_trajpoly3_c0(const struct a_trajpoly3 *ctx, a_float *c0);
#endif

#if defined(A_TRAJPOLY_COMPACT)
/**
 * @brief Copy the coefficients of velocity out.
 * @param ctx points to a planned instance of cubic polynomial trajectory
 * @param c1 array of 3, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
 */
A_EXTERN void a_trajpoly3_c1(const struct a_trajpoly3 *ctx, a_float *c1);
#endif

#if defined(A_TRAJPOLY_COMPACT)
/**
 * @brief Copy the coefficients of acceleration out.
 * @param ctx points to a planned instance of cubic polynomial trajectory
 * @param c2 array of 2, which may lie inside `ctx`; nothing happens if it or `ctx` is NULL
 */
A_EXTERN void a_trajpoly3_c2(const struct a_trajpoly3 *ctx, a_float *c2);
#endif

/**
 * @brief Position of a cubic polynomial trajectory, by Horner's rule.
 * @param ctx points to a planned instance of cubic polynomial trajectory
 * @param x time since the start, s; the polynomial goes on outside the move
 * @return position, unit; NaN if `ctx` is NULL
 */
A_EXTERN a_float a_trajpoly3_pos(const struct a_trajpoly3 *ctx, a_float x);

#if A_TRAJPOLY3 + 0 > 1
/**
 * @brief Velocity of a cubic polynomial trajectory, by Horner's rule.
 * @param ctx points to a planned instance of cubic polynomial trajectory
 * @param x time since the start, s; the polynomial goes on outside the move
 * @return velocity, unit/s; NaN if `ctx` is NULL
 */
A_EXTERN a_float a_trajpoly3_vel(const struct a_trajpoly3 *ctx, a_float x);
#endif

#if A_TRAJPOLY3 + 0 > 2
/**
 * @brief Acceleration of a cubic polynomial trajectory, by Horner's rule.
 * @param ctx points to a planned instance of cubic polynomial trajectory
 * @param x time since the start, s; the polynomial goes on outside the move
 * @return acceleration, unit/s^2; NaN if `ctx` is NULL
 */
A_EXTERN a_float a_trajpoly3_acc(const struct a_trajpoly3 *ctx, a_float x);
#endif

#if defined(__cplusplus)
} /* extern "C" */
namespace a
{
typedef struct a_trajpoly3 trajpoly3;
} /* namespace a */
#endif /* __cplusplus */

#if !defined(A_TRAJPOLY_COMPACT)
/**
 * @brief Cubic polynomial trajectory.
 *
 * Coefficients stand in ascending powers of time: `p[0] + p[1]*x + ...`. `A_TRAJPOLY3` arrays are stored.
 */
struct a_trajpoly3 {
    /**
     * coefficients of position
     */
    a_float p[4];
#if A_TRAJPOLY3 + 0 > 1
    /**
     * coefficients of velocity
     */
    a_float v[3];
#endif
#if A_TRAJPOLY3 + 0 > 2
    /**
     * coefficients of acceleration
     */
    a_float a[2];
#endif
#if defined(__cplusplus)
    void gen(a_float ts, a_float p0, a_float p1,
             a_float v0 = 0, a_float v1 = 0)
    {
        a_trajpoly3_gen(this, ts, p0, p1, v0, v1);
    }
#if defined(A_TRAJPOLY_COMPACT)
    void c0(a_float *c0_) const { a_trajpoly3_c0(this, c0_); }
    void c1(a_float *c1_) const { a_trajpoly3_c1(this, c1_); }
    void c2(a_float *c2_) const { a_trajpoly3_c2(this, c2_); }
#else
    void gen0(a_float ts, a_float p0, a_float p1,
              a_float v0 = 0, a_float v1 = 0)
    {
        a_trajpoly3_gen0(this, ts, p0, p1, v0, v1);
    }
#if A_TRAJPOLY3 + 0 > 1
    void gen1() { a_trajpoly3_gen1(this); }
#endif
#if A_TRAJPOLY3 + 0 > 2
    void gen2() { a_trajpoly3_gen2(this); }
#endif
#endif
    a_float pos(a_float x) const { return a_trajpoly3_pos(this, x); }
#if A_TRAJPOLY3 + 0 > 1
    a_float vel(a_float x) const { return a_trajpoly3_vel(this, x); }
#endif
#if A_TRAJPOLY3 + 0 > 2
    a_float acc(a_float x) const { return a_trajpoly3_acc(this, x); }
#endif
#endif /* __cplusplus */
};
#endif

#if defined(A_TRAJPOLY_COMPACT)
/**
 * @brief Cubic polynomial trajectory.
 *
 * Coefficients stand in ascending powers of time: `c[0] + c[1]*x + ...`.
 */
struct a_trajpoly3 {
    /**
     * coefficients of position
     */
    a_float c[4];
#if defined(__cplusplus)
    void gen(a_float ts, a_float p0, a_float p1,
             a_float v0 = 0, a_float v1 = 0)
    {
        a_trajpoly3_gen(this, ts, p0, p1, v0, v1);
    }
#if defined(A_TRAJPOLY_COMPACT)
    void c0(a_float *c0_) const { a_trajpoly3_c0(this, c0_); }
    void c1(a_float *c1_) const { a_trajpoly3_c1(this, c1_); }
    void c2(a_float *c2_) const { a_trajpoly3_c2(this, c2_); }
#else
    void gen0(a_float ts, a_float p0, a_float p1,
              a_float v0 = 0, a_float v1 = 0)
    {
        a_trajpoly3_gen0(this, ts, p0, p1, v0, v1);
    }
#if A_TRAJPOLY3 + 0 > 1
    void gen1() { a_trajpoly3_gen1(this); }
#endif
#if A_TRAJPOLY3 + 0 > 2
    void gen2() { a_trajpoly3_gen2(this); }
#endif
#endif
    a_float pos(a_float x) const { return a_trajpoly3_pos(this, x); }
#if A_TRAJPOLY3 + 0 > 1
    a_float vel(a_float x) const { return a_trajpoly3_vel(this, x); }
#endif
#if A_TRAJPOLY3 + 0 > 2
    a_float acc(a_float x) const { return a_trajpoly3_acc(this, x); }
#endif
#endif /* __cplusplus */
};
#endif

#endif /* LIBA_TRAJPOLY3_H */
