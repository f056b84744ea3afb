/*!
 @file a.h
 @brief the prelude of the trajectory headers
 @details The part of liba's prelude that sources written against its trajectory headers lean on: the real type, the
 fixed-width names and a few macros. The real type is the archive's. A program may define `A_SIZE_FLOAT` (or `A_SIZE_REAL`)
 as 4 for float or as 8 for double; another type than the archive's is refused.
*/

#ifndef LIBA_A_H
#define LIBA_A_H

#include <float.h>
#include <limits.h>
#include <stddef.h>
#include <stdint.h>

/* How the archive was built: make dist writes this header. */
#include "atraj_config.h"

/* compiler */

/*! true from this version of GCC, or of a compiler that takes itself for it, on */
#if defined(__GNUC__) && defined(__GNUC_MINOR__)
#define A_PREREQ_GNUC(maj, min) ((__GNUC__ << 16) + __GNUC_MINOR__ >= ((maj) << 16) + (min))
#else
#define A_PREREQ_GNUC(maj, min) 0
#endif
/*! true from this version of Microsoft's compiler on */
#if defined(_MSC_VER)
#define A_PREREQ_MSVC(maj, min) (_MSC_VER >= (maj) * 100 + (min))
#else
#define A_PREREQ_MSVC(maj, min) 0
#endif
/*! @cond
 sources ask for clang's warnings without looking whether this compiler can tell */
#if !defined(__has_warning)
#define __has_warning(x) 0
#endif
/*! @endcond */

/*! check the arguments from `c` on against the format argument `b`, counted from 1, as those of `a`, as in printf */
#if A_PREREQ_GNUC(2, 7)
#define A_FORMAT(a, b, c) __attribute__((__format__(a, b, c)))
#else
#define A_FORMAT(a, b, c)
#endif

/*! visible outside the library */
#if defined(_WIN32) && defined(A_EXPORTS)
#define A_PUBLIC __declspec(dllexport)
#elif defined(_WIN32) && defined(A_IMPORTS)
#define A_PUBLIC __declspec(dllimport)
#elif A_PREREQ_GNUC(4, 0) && !defined(_WIN32)
#define A_PUBLIC __attribute__((visibility("default")))
#else
#define A_PUBLIC
#endif
/*! declares a function of the library */
#define A_EXTERN A_PUBLIC extern

/*! `inline`, or what the compiler has in its place */
#if defined(__cplusplus) || (defined(__STDC_VERSION__) && (__STDC_VERSION__ >= 199901L))
#define A_INLINE inline
#elif A_PREREQ_GNUC(2, 7) || defined(_MSC_VER)
#define A_INLINE __inline
#else
#define A_INLINE
#endif
/*! for a function in a header */
#define A_INTERN static A_INLINE

/*! the null pointer */
#if defined(__cplusplus) && (__cplusplus >= 201103L)
#define A_NULL nullptr
#else
#define A_NULL NULL
#endif

/*! fail the build unless the constant expression `x` is true; an expression of type void */
#define A_BUILD_ASSERT(x) ((void)sizeof(char[(x) ? 1 : -1]))

/* values: every argument may be evaluated more than once */

/*! number of elements of an array */
#define A_LEN(array) (sizeof(array) / sizeof((array)[0]))
/*! the lesser of two */
#define A_MIN(x, y) (((x) < (y)) ? (x) : (y))
/*! the greater of two */
#define A_MAX(x, y) (((x) > (y)) ? (x) : (y))
/*! the magnitude */
#define A_ABS(x) (((x) < 0) ? -(x) : (x))
/*! `x` limited to `min` .. `max` */
#define A_SAT(x, min, max) (((min) < (x)) ? (((x) < (max)) ? (x) : (max)) : (min))

/*! @name integers
 @{ */
/*! the C type of the same name, as liba calls it */
typedef size_t a_size;
typedef ptrdiff_t a_diff;
typedef int8_t a_i8;
typedef int16_t a_i16;
typedef int32_t a_i32;
typedef int64_t a_i64;
typedef intmax_t a_imax;
typedef intptr_t a_iptr;
typedef uint8_t a_u8;
typedef uint16_t a_u16;
typedef uint32_t a_u32;
typedef uint64_t a_u64;
typedef uintmax_t a_umax;
typedef uintptr_t a_uptr;
typedef unsigned char a_byte;
typedef float a_f32;
typedef double a_f64;
/*! @} */

/*! @name sizes of the real type
 @{ */
/*! a value of #A_SIZE_FLOAT */
#define A_FLOAT_SINGLE 0x04
#define A_FLOAT_DOUBLE 0x08
#define A_FLOAT_EXTEND 0x10
/*! @} */

/*! size of #a_float in bytes, 4 or 8; the archive's unless it is defined */
#if !defined(A_SIZE_FLOAT)
#if defined(A_SIZE_REAL)
#define A_SIZE_FLOAT A_SIZE_REAL
#else
#define A_SIZE_FLOAT ATRAJ_SIZE_FLOAT
#endif
#endif
/*! the name of #A_SIZE_FLOAT in liba since 2025 */
#if !defined(A_SIZE_REAL)
#define A_SIZE_REAL A_SIZE_FLOAT
#elif A_SIZE_REAL + 0 != A_SIZE_FLOAT + 0
#error "A_SIZE_FLOAT and A_SIZE_REAL differ: define one of them."
#endif

/*! @name properties of the real type
 @{ */
/*! of #a_float: its type, its constants, functions and formats, and its limits as in `<float.h>` */
#if A_SIZE_FLOAT + 0 == A_FLOAT_SINGLE
#define A_FLOAT_TYPE A_FLOAT_SINGLE
#define A_FLOAT float
#define A_FLOAT_C(X) X##F
#define A_FLOAT_F(F) F##f
#define A_FLOAT_PRI(F, C) "%" F C
#define A_FLOAT_SCN(F, C) "%" F C
#define A_FLOAT_DIG FLT_DIG
#define A_FLOAT_MANT_DIG FLT_MANT_DIG
#define A_FLOAT_EPSILON FLT_EPSILON
#define A_FLOAT_MIN FLT_MIN
#define A_FLOAT_MAX FLT_MAX
#define A_FLOAT_MIN_EXP FLT_MIN_EXP
#define A_FLOAT_MAX_EXP FLT_MAX_EXP
#define A_FLOAT_MIN_10_EXP FLT_MIN_10_EXP
#define A_FLOAT_MAX_10_EXP FLT_MAX_10_EXP
#elif A_SIZE_FLOAT + 0 == A_FLOAT_DOUBLE
#define A_FLOAT_TYPE A_FLOAT_DOUBLE
#define A_FLOAT double
#define A_FLOAT_C(X) X
#define A_FLOAT_F(F) F
#define A_FLOAT_PRI(F, C) "%" F C
#define A_FLOAT_SCN(F, C) "%" F "l" C
#define A_FLOAT_DIG DBL_DIG
#define A_FLOAT_MANT_DIG DBL_MANT_DIG
#define A_FLOAT_EPSILON DBL_EPSILON
#define A_FLOAT_MIN DBL_MIN
#define A_FLOAT_MAX DBL_MAX
#define A_FLOAT_MIN_EXP DBL_MIN_EXP
#define A_FLOAT_MAX_EXP DBL_MAX_EXP
#define A_FLOAT_MIN_10_EXP DBL_MIN_10_EXP
#define A_FLOAT_MAX_10_EXP DBL_MAX_10_EXP
#elif A_SIZE_FLOAT + 0 == A_FLOAT_EXTEND
#if LDBL_MANT_DIG != 53
#error "A_SIZE_FLOAT=16 needs a long double that is binary64, as on Arm EABI: define A_SIZE_FLOAT as 4 or 8."
#endif
#define A_FLOAT_TYPE A_FLOAT_EXTEND
#define A_FLOAT long double
#define A_FLOAT_C(X) X##L
#define A_FLOAT_F(F) F##l
#define A_FLOAT_PRI(F, C) "%" F "L" C
#define A_FLOAT_SCN(F, C) "%" F "L" C
#define A_FLOAT_DIG LDBL_DIG
#define A_FLOAT_MANT_DIG LDBL_MANT_DIG
#define A_FLOAT_EPSILON LDBL_EPSILON
#define A_FLOAT_MIN LDBL_MIN
#define A_FLOAT_MAX LDBL_MAX
#define A_FLOAT_MIN_EXP LDBL_MIN_EXP
#define A_FLOAT_MAX_EXP LDBL_MAX_EXP
#define A_FLOAT_MIN_10_EXP LDBL_MIN_10_EXP
#define A_FLOAT_MAX_10_EXP LDBL_MAX_10_EXP
#else
#error "A_SIZE_FLOAT selects the real type: define it as 4 (float) or 8 (double)."
#endif
/*! @} */

/*! real number of this build: float or double */
typedef A_FLOAT a_float;
/*! the name of `a_float` in liba since 2025 */
typedef a_float a_real;

/*! @name properties of the real type since 2025
 @{ */
/*! the name of its `A_FLOAT` twin in liba since 2025 */
#define A_REAL_SINGLE A_FLOAT_SINGLE
#define A_REAL_DOUBLE A_FLOAT_DOUBLE
#define A_REAL_EXTEND A_FLOAT_EXTEND
#define A_REAL_TYPE A_FLOAT_TYPE
#define A_REAL A_FLOAT
#define A_REAL_C(X) A_FLOAT_C(X)
#define A_REAL_F(F) A_FLOAT_F(F)
#define A_REAL_PRI(F, C) A_FLOAT_PRI(F, C)
#define A_REAL_SCN(F, C) A_FLOAT_SCN(F, C)
#define A_REAL_DIG A_FLOAT_DIG
#define A_REAL_MANT_DIG A_FLOAT_MANT_DIG
#define A_REAL_EPSILON A_FLOAT_EPSILON
#define A_REAL_MIN A_FLOAT_MIN
#define A_REAL_MAX A_FLOAT_MAX
#define A_REAL_MIN_EXP A_FLOAT_MIN_EXP
#define A_REAL_MAX_EXP A_FLOAT_MAX_EXP
#define A_REAL_MIN_10_EXP A_FLOAT_MIN_10_EXP
#define A_REAL_MAX_10_EXP A_FLOAT_MAX_10_EXP
/*! @} */

#include "atraj_check.h"

#endif /* LIBA_A_H */
