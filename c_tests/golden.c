/*
 Replays every golden row of liba through the C ABI and compares bits. A compact build replays the plans of the newest liba too.
 usage: golden DIRECTORY
 Prints a line `function rows differing` for each function. Fails on a difference, or on a file without rows.

 It calls only the functions that liba's own headers declare too. `calls.c` compares the others with them.
*/
#include "a/trajbell.h"
#include "a/trajpoly3.h"
#include "a/trajpoly5.h"
#include "a/trajpoly7.h"
#include "a/trajtrap.h"
#include "table.h"
#include <math.h>

enum { MAX_MOVES = 4096 };

#if A_SIZE_FLOAT == 4
typedef a_u32 bits;
static const char suffix[] = "f32";
#else
typedef a_u64 bits;
static const char suffix[] = "f64";
#endif

static int failed;

static bits bits_of(a_float x) {
    bits b;
    memcpy(&b, &x, sizeof(b));
    return b;
}

static a_float real_of(const char *hex) {
    bits b = (bits)strtoull(hex, NULL, 16);
    a_float x;
    if (strcmp(hex, "nan") == 0) { return (a_float)NAN; }
    memcpy(&x, &b, sizeof(x));
    return x;
}

static struct table open_table(const char *directory, const char *family) {
    char name[64];
    snprintf(name, sizeof(name), "%s_%s.csv", family, suffix);
    return open_golden(directory, name);
}

/* The number of the move that an evaluation row belongs to. */
static int move_of(const struct table *table, int moves) {
    int move = atoi(table->cells[0]);
    if (move < 0 || move >= moves) {
        fprintf(stderr, "%s:%d: no move %d\n", table->name, table->line, move);
        exit(2);
    }
    return move;
}

static void reals(const struct table *table, int first, int count, a_float *out) {
    int i;
    for (i = 0; i < count; ++i) { out[i] = real_of(table->cells[first + i]); }
}

/* Whether some of `count` values differ from the golden bits. Prints each value that differs. */
static int differs(const struct table *table, const char *function, int first, const a_float *got, int count) {
    int i, bad = 0;
    for (i = 0; i < count; ++i) {
        a_float want = real_of(table->cells[first + i]);
        if (bits_of(got[i]) == bits_of(want) || (isnan(got[i]) && isnan(want))) { continue; }
        printf("%s:%d: %s, column %d: %.17g (%llx), golden %.17g (%llx)\n", table->name, table->line, function,
               first + i, (double)got[i], (unsigned long long)bits_of(got[i]), (double)want,
               (unsigned long long)bits_of(want));
        bad = 1;
    }
    return bad;
}

static void report(const char *function, int rows, int differing) {
    printf("%-20s %6d %6d\n", function, rows, differing);
    failed |= differing != 0 || rows == 0;
}

/* A function of a struct and a time, which computes a column of an evaluation table. */
struct evaluation {
    const char *name;
    a_float (*evaluate)(const void *ctx, a_float x);
};

/* Checks the first `count` of the `quantities` in an evaluation table, on `moves` contexts of `size` bytes. */
static void replay(const char *directory, const char *family, int quantities, const struct evaluation *evaluations, int count,
                   const void *contexts, a_size size, int moves) {
    int i;
    for (i = 0; i < count; ++i) {
        struct table table = open_table(directory, family);
        int rows = 0, differing = 0;
        while (next_row(&table, 2 + quantities)) {
            const char *ctx = (const char *)contexts + size * (a_size)move_of(&table, moves);
            a_float y = evaluations[i].evaluate(ctx, real_of(table.cells[1]));
            differing += differs(&table, evaluations[i].name, 2 + i, &y, 1);
            ++rows;
        }
        report(evaluations[i].name, rows, differing);
    }
}

/* What exists at each level of a family `t`, for the macro X: the order of the derivative, its coefficients in the struct of a
   polynomial, its function, and the arguments that compute the coefficients. */
#define LEVEL1(t, X) X(t, 0, p, pos, ARGUMENTS_##t)
#define LEVEL2(t, X) LEVEL1(t, X) X(t, 1, v, vel, (ctx))
#define LEVEL3(t, X) LEVEL2(t, X) X(t, 2, a, acc, (ctx))
#define LEVEL4(t, X) LEVEL3(t, X) X(t, 3, j, jer, (ctx))
#define EVALUATE(t, order, array, f, arguments) \
    static a_float t##_##f(const void *ctx, a_float x) { return a_##t##_##f(ctx, x); }
#define NAMED(t, order, array, f, arguments) {"a_" #t "_" #f, t##_##f},
#define EVALUATIONS(t, levels) \
    levels(t, EVALUATE) static const struct evaluation t##_evaluations[] = {levels(t, NAMED)};

/* Whether liba since 2025 saturates a velocity in another way than 0.1.15 does. */
static int depends_on_generation(a_float vm, a_float v0, a_float v1) {
    return isnan(vm) || isnan(v0) || isnan(v1) || (vm == 0 && (v0 == 0 || v1 == 0));
}

/* Whether this build has the plans of the newest liba. It takes the fields of such a golden plan of 0.1.15 as they are, and evaluates
   them. */
#if defined(A_TRAJPOLY_COMPACT)
static const int is_newest = 1;
#else
static const int is_newest = 0;
#endif

/* A family whose gen has seven arguments and returns a duration. It saturates a velocity at the limit whose index is `vm`. */
struct limited {
    const char *name, *newest, *function;
    int vm, fields;
    a_float (*gen)(void *ctx, const a_float *a);
};

/* Plans the moves of a table from all-zero structs and leaves them in `moves`. Returns their number. */
static int plan(const char *directory, const struct limited *family, int newest, a_float *moves, int *differing) {
    struct table table = open_table(directory, newest ? family->newest : family->name);
    const a_size size = (a_size)family->fields * sizeof(a_float);
    int n = 0;
    for (; next_row(&table, 2 + 7 + 1 + family->fields) && n < MAX_MOVES; ++n, moves += family->fields) {
        a_float a[7], out[MAX_CELLS];
        reals(&table, 2, 7, a);
        if (newest != is_newest && depends_on_generation(a[family->vm], a[5], a[6])) {
            reals(&table, 10, family->fields, moves);
            continue;
        }
        memset(moves, 0, size);
        out[0] = family->gen(moves, a);
        memcpy(out + 1, moves, size);
        *differing += differs(&table, family->function, 9, out, 1 + family->fields);
    }
    return n;
}

/* Checks gen on all moves of a family, then each evaluation on the moves of 0.1.15. */
static void limited(const char *directory, const struct limited *family, const char *evaluated,
                    const struct evaluation *evaluations, int count) {
    static a_float moves[MAX_MOVES * 14];
    int differing = 0;
    int newest = is_newest ? plan(directory, family, 1, moves, &differing) : 0;
    int n = plan(directory, family, 0, moves, &differing);
    report(family->function, newest + n, differing);
    replay(directory, evaluated, count, evaluations, count, moves, (a_size)family->fields * sizeof(a_float), n);
}

static a_float gen_bell(void *ctx, const a_float *a) { return a_trajbell_gen(ctx, a[0], a[1], a[2], a[3], a[4], a[5], a[6]); }
static a_float gen_trap(void *ctx, const a_float *a) { return a_trajtrap_gen(ctx, a[0], a[1], a[2], a[3], a[4], a[5], a[6]); }
static const struct limited bell = {"bell_gen", "newest_bell_gen", "a_trajbell_gen", 2, 14, gen_bell};
static const struct limited trap = {"trap_gen", "newest_trap_gen", "a_trajtrap_gen", 0, 12, gen_trap};
EVALUATIONS(trajbell, LEVEL4)
EVALUATIONS(trajtrap, LEVEL3)

/*
 A polynomial family. A golden row has the `arguments` of gen, then the coefficients of `orders` derivatives; `levels` of these
 exist in this build. The highest power of position is `degree`. `write` writes the coefficients of one order, by the function for
 this order alone; for the order -1 it plans and writes the whole struct of `size` bytes.
*/
struct poly {
    int degree, arguments, orders, levels;
    a_size size;
    void (*write)(void *ctx, const a_float *a, int order, a_float *out);
    const struct evaluation *evaluations;
};

/* The array that a function must fill is poisoned before. */
#if defined(A_TRAJPOLY_COMPACT)
static const char part[] = "c";
#define WRITE(t, order, array, f, arguments) \
    case order: a_##t##_c##order(ctx, out); break;
#else
static const char part[] = "gen";
#define WRITE(t, order, array, f, arguments) \
    case order: \
        memset(ctx->array, 0xFF, sizeof(ctx->array)); \
        a_##t##_gen##order arguments; \
        memcpy(out, ctx->array, sizeof(ctx->array)); \
        break;
#endif

/* Checks gen on all moves, then each array, then each evaluation. */
static void poly(const char *directory, const struct poly *poly) {
    static a_float moves[MAX_MOVES * MAX_CELLS];
    char family[16], function[32];
    int order, n = 0, first = 1 + poly->arguments, columns = first;
    snprintf(family, sizeof(family), "poly%d_gen", poly->degree);
    snprintf(function, sizeof(function), "a_trajpoly%d_gen", poly->degree);
    for (order = 0; order < poly->orders; ++order) { columns += poly->degree + 1 - order; }
    for (order = -1; order < poly->levels; ++order) {
        struct table table = open_table(directory, family);
        int differing = 0, width = order < 0 ? (int)(poly->size / sizeof(a_float)) : poly->degree + 1 - order;
        if (order >= 0) { snprintf(function, sizeof(function), "a_trajpoly%d_%s%d", poly->degree, part, order); }
        for (n = 0; next_row(&table, columns) && n < MAX_MOVES; ++n) {
            a_float a[9], out[MAX_CELLS];
            reals(&table, 1, poly->arguments, a);
            poly->write((char *)moves + poly->size * (a_size)n, a, order, out);
            differing += differs(&table, function, first, out, width);
        }
        report(function, n, differing);
        if (order >= 0) { first += width; }
    }
    snprintf(family, sizeof(family), "poly%d_eval", poly->degree);
    replay(directory, family, poly->orders, poly->evaluations, poly->levels, moves, poly->size, n);
}

#define POLY(t, levels) \
    EVALUATIONS(t, levels) \
    static void t##_write(void *context, const a_float *a, int order, a_float *out) { \
        a_##t *ctx = context; \
        switch (order) { \
            levels(t, WRITE) \
        default: \
            a_##t##_gen ARGUMENTS_##t; \
            memcpy(out, ctx, sizeof(*ctx)); \
        } \
    }
#define ARGUMENTS_trajpoly3 (ctx, a[0], a[1], a[2], a[3], a[4])
#define ARGUMENTS_trajpoly5 (ctx, a[0], a[1], a[2], a[3], a[4], a[5], a[6])
#define ARGUMENTS_trajpoly7 (ctx, a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8])
#define LEVEL(n) LEVEL_(n)
#define LEVEL_(n) LEVEL##n
POLY(trajpoly3, LEVEL(A_TRAJPOLY3))
POLY(trajpoly5, LEVEL(A_TRAJPOLY5))
POLY(trajpoly7, LEVEL(A_TRAJPOLY7))
static const struct poly polys[] = {
    {3, 5, 3, A_TRAJPOLY3, sizeof(a_trajpoly3), trajpoly3_write, trajpoly3_evaluations},
    {5, 7, 3, A_TRAJPOLY5, sizeof(a_trajpoly5), trajpoly5_write, trajpoly5_evaluations},
    {7, 9, 4, A_TRAJPOLY7, sizeof(a_trajpoly7), trajpoly7_write, trajpoly7_evaluations},
};

int main(int argc, char **argv) {
    int i;
    if (argc != 2) {
        fprintf(stderr, "usage: %s DIRECTORY\n", argv[0]);
        return 2;
    }
    limited(argv[1], &bell, "bell_eval", trajbell_evaluations, 4);
    limited(argv[1], &trap, "trap_eval", trajtrap_evaluations, 3);
    for (i = 0; i < 3; ++i) { poly(argv[1], &polys[i]); }
    return failed;
}
