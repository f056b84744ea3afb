/*!
 @file atraj_check.h
 @brief refuses a program that differs from the archive of these headers
 @details Every trajectory header includes this file after `a.h`. Where liba's own `a.h` came first, ours is left out, so the
 choices are made and checked here: the real type, the generation of the polynomial structs and their levels.
*/

#ifndef ATRAJ_CHECK_H
#define ATRAJ_CHECK_H

/* The build writes it: make dist. */
#include "atraj_config.h"

/* liba since 2025 has only this name. */
#if defined(A_REAL_TYPE) && !defined(A_FLOAT_TYPE)
#define A_FLOAT_TYPE A_REAL_TYPE
typedef a_real a_float;
#endif

#if (A_FLOAT_TYPE + 0 == 4) && (ATRAJ_SIZE_FLOAT != 4)
#error "The archive of this header computes in double: define A_SIZE_FLOAT (A_SIZE_REAL) as 8, or use the archive of make dist REAL=float."
#elif (A_FLOAT_TYPE + 0 != 4) && (ATRAJ_SIZE_FLOAT == 4)
#error "The archive of this header computes in float: define A_SIZE_FLOAT (A_SIZE_REAL) as 4, or use the archive of make dist."
#endif
/*! @cond
 fails if #a_float is another type than the archive's, however it was chosen */
typedef char atraj_a_float_is_not_the_archives[sizeof(a_float) == ATRAJ_SIZE_FLOAT ? 1 : -1];
/*! @endcond */

/* With A_TRAJPOLY_COMPACT the polynomial structs have one coefficient array, as in liba since 2025-03. */
#if ATRAJ_TRAJPOLY_COMPACT && !defined(A_TRAJPOLY_COMPACT)
#define A_TRAJPOLY_COMPACT
#elif !ATRAJ_TRAJPOLY_COMPACT && defined(A_TRAJPOLY_COMPACT)
#error "The archive of this header has no compact polynomials: leave A_TRAJPOLY_COMPACT undefined, or use the archive of make dist POLY=compact."
#endif

/*! @name levels of the older polynomial structs
 how many of the coefficient arrays p v a j a struct holds
 @{ */
/*! level of #a_trajpoly3; the archive's unless it is defined */
#if !defined(A_TRAJPOLY3)
#define A_TRAJPOLY3 ATRAJ_TRAJPOLY3
#elif A_TRAJPOLY3 + 0 != ATRAJ_TRAJPOLY3
#error "A_TRAJPOLY3 differs from the archive of this header: leave it undefined, or use the archive of make dist A_TRAJPOLY3=1..3."
#endif
/*! level of #a_trajpoly5; the archive's unless it is defined */
#if !defined(A_TRAJPOLY5)
#define A_TRAJPOLY5 ATRAJ_TRAJPOLY5
#elif A_TRAJPOLY5 + 0 != ATRAJ_TRAJPOLY5
#error "A_TRAJPOLY5 differs from the archive of this header: leave it undefined, or use the archive of make dist A_TRAJPOLY5=1..3."
#endif
/*! level of #a_trajpoly7; the archive's unless it is defined */
#if !defined(A_TRAJPOLY7)
#define A_TRAJPOLY7 ATRAJ_TRAJPOLY7
#elif A_TRAJPOLY7 + 0 != ATRAJ_TRAJPOLY7
#error "A_TRAJPOLY7 differs from the archive of this header: leave it undefined, or use the archive of make dist A_TRAJPOLY7=1..4."
#endif
/*! @} */

#endif /* ATRAJ_CHECK_H */
