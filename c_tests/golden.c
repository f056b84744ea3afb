/*
 Replays every golden row of liba through the C ABI and compares bits. A compact build replays the plans of the newest liba too.
 usage: golden DIRECTORY
 Prints a line `function rows differing` for each function. Fails on a difference, or on a file without rows.

 It calls only the functions that liba's own headers declare too. `sample.c` compares the others with them.
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

static bits bits_of(a_float x)
{
    bits b;
    memcpy(&b, &x, sizeof(b));
    return b;
}

static a_float real_of(const char *hex)
{
    bits b = (bits)strtoull(hex, NULL, 16);
    a_float x;
    if (strcmp(hex, "nan") == 0) { return (a_float)NAN; }
    memcpy(&x, &b, sizeof(x));
    return x;
}

static struct table open_table(const char *directory, const char *family)
{
    char name[64];
    snprintf(name, sizeof(name), "%s_%s.csv", family, suffix);
    return open_golden(directory, name);
}

/* The number of the move that an evaluation row belongs to. */
static int move_of(const struct table *table, int moves)
{
    int move = atoi(table->cells[0]);
    if (move < 0 || move >= moves)
    {
        fprintf(stderr, "%s:%d: no move %d\n", table->name, table->line, move);
        exit(2);
    }
    return move;
}

static void reals(const struct table *table, int first, int count, a_float *out)
{
    int i;
    for (i = 0; i < count; ++i) { out[i] = real_of(table->cells[first + i]); }
}

/* Whether some of `count` values differ from the golden bits. Prints each value that differs. */
static int differs(const struct table *table, const char *function, int first, const a_float *got, int count)
{
    int i, bad = 0;
    for (i = 0; i < count; ++i)
    {
        a_float want = real_of(table->cells[first + i]);
        if (bits_of(got[i]) == bits_of(want) || (isnan(got[i]) && isnan(want))) { continue; }
        printf("%s:%d: %s, column %d: %.17g (%llx), golden %.17g (%llx)\n", table->name, table->line, function,
               first + i, (double)got[i], (unsigned long long)bits_of(got[i]), (double)want,
               (unsigned long long)bits_of(want));
        bad = 1;
    }
    return bad;
}

static void report(const char *function, int rows, int differing)
{
    printf("%-20s %6d %6d\n", function, rows, differing);
    failed |= differing != 0 || rows == 0;
}

/* Checks one column of an evaluation table with the function `evaluate`, on `moves` contexts of `size` bytes. */
static void replay(const char *directory, const char *family, const char *function, int columns, int column,
                   a_float (*evaluate)(const void *ctx, a_float x), const void *contexts, a_size size, int moves)
{
    struct table table = open_table(directory, family);
    int rows = 0, differing = 0;
    while (next_row(&table, columns))
    {
        const char *ctx = (const char *)contexts + size * (a_size)move_of(&table, moves);
        a_float y = evaluate(ctx, real_of(table.cells[1]));
        differing += differs(&table, function, column, &y, 1);
        ++rows;
    }
    report(function, rows, differing);
}

#define EVALUATE(f) \
    static a_float f(const void *ctx, a_float x) { return a_##f(ctx, x); }
#define REPLAY(family, columns, column, f, contexts, moves) \
    replay(directory, family, "a_" #f, columns, column, f, contexts, sizeof((contexts)[0]), moves)

/* Whether liba since 2025 saturates a velocity in another way than 0.1.15 does. */
static int depends_on_generation(a_float vm, a_float v0, a_float v1)
{
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
static int plan(const char *directory, const struct limited *family, int newest, a_float *moves, int *differing)
{
    struct table table = open_table(directory, newest ? family->newest : family->name);
    const a_size size = (a_size)family->fields * sizeof(a_float);
    int n = 0;
    for (; next_row(&table, 2 + 7 + 1 + family->fields) && n < MAX_MOVES; ++n, moves += family->fields)
    {
        a_float a[7], out[MAX_CELLS];
        reals(&table, 2, 7, a);
        if (newest != is_newest && depends_on_generation(a[family->vm], a[5], a[6]))
        {
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

/* Checks gen on all moves, and leaves the moves of 0.1.15 in `moves`. Returns their number. */
static int plans(const char *directory, const struct limited *family, void *moves)
{
    int differing = 0;
    int newest = is_newest ? plan(directory, family, 1, moves, &differing) : 0;
    int n = plan(directory, family, 0, moves, &differing);
    report(family->function, newest + n, differing);
    return n;
}

static a_float gen_bell(void *ctx, const a_float *a) { return a_trajbell_gen(ctx, a[0], a[1], a[2], a[3], a[4], a[5], a[6]); }
static a_float gen_trap(void *ctx, const a_float *a) { return a_trajtrap_gen(ctx, a[0], a[1], a[2], a[3], a[4], a[5], a[6]); }

EVALUATE(trajbell_pos)
EVALUATE(trajbell_vel)
EVALUATE(trajbell_acc)
EVALUATE(trajbell_jer)

static void bell(const char *directory)
{
    static const struct limited family = {"bell_gen", "newest_bell_gen", "a_trajbell_gen", 2, 14, gen_bell};
    static a_trajbell moves[MAX_MOVES];
    int n = plans(directory, &family, moves);
    REPLAY("bell_eval", 6, 2, trajbell_pos, moves, n);
    REPLAY("bell_eval", 6, 3, trajbell_vel, moves, n);
    REPLAY("bell_eval", 6, 4, trajbell_acc, moves, n);
    REPLAY("bell_eval", 6, 5, trajbell_jer, moves, n);
}

EVALUATE(trajtrap_pos)
EVALUATE(trajtrap_vel)
EVALUATE(trajtrap_acc)

static void trap(const char *directory)
{
    static const struct limited family = {"trap_gen", "newest_trap_gen", "a_trajtrap_gen", 0, 12, gen_trap};
    static a_trajtrap moves[MAX_MOVES];
    int n = plans(directory, &family, moves);
    REPLAY("trap_eval", 5, 2, trajtrap_pos, moves, n);
    REPLAY("trap_eval", 5, 3, trajtrap_vel, moves, n);
    REPLAY("trap_eval", 5, 4, trajtrap_acc, moves, n);
}

/*
 A polynomial family. A golden row has the `arguments` of gen, then the coefficients of `orders` derivatives; `levels` of these
 exist in this build. The highest power of position is `degree`. `coefficients` writes the coefficients of one order, by the
 function for this order alone.
*/
struct poly {
    int degree, arguments, orders, levels;
    void (*gen)(void *ctx, const a_float *a);
    void (*coefficients)(void *ctx, const a_float *a, int order, a_float *out);
};

#if defined(A_TRAJPOLY_COMPACT)
static const char part[] = "c";
#else
static const char part[] = "gen";
#endif

/* Checks gen on all moves, then each array. Leaves the moves planned and returns their number. */
static int poly(const char *directory, const struct poly *poly, void *moves, a_size size)
{
    char family[16], function[32];
    int order, first = 1 + poly->arguments, columns = first, moves_read = 0;
    snprintf(family, sizeof(family), "poly%d_gen", poly->degree);
    for (order = 0; order < poly->orders; ++order) { columns += poly->degree + 1 - order; }
    for (order = -1; order < poly->levels; ++order)
    {
        struct table table = open_table(directory, family);
        int n, differing = 0, width = poly->degree + 1 - order;
        if (order < 0) { snprintf(function, sizeof(function), "a_trajpoly%d_gen", poly->degree); }
        else { snprintf(function, sizeof(function), "a_trajpoly%d_%s%d", poly->degree, part, order); }
        for (n = 0; next_row(&table, columns) && n < MAX_MOVES; ++n)
        {
            void *ctx = (char *)moves + size * (a_size)n;
            a_float a[9], out[MAX_CELLS];
            reals(&table, 1, poly->arguments, a);
            if (order < 0)
            {
                poly->gen(ctx, a);
                memcpy(out, ctx, size);
                differing += differs(&table, function, first, out, (int)(size / sizeof(a_float)));
            }
            else
            {
                poly->coefficients(ctx, a, order, out);
                differing += differs(&table, function, first, out, width);
            }
        }
        report(function, n, differing);
        moves_read = n;
        if (order >= 0) { first += width; }
    }
    return moves_read;
}

/* Write the coefficients of one order, by the function for this order alone. The array that it must fill is poisoned before. */
#if defined(A_TRAJPOLY_COMPACT)
#define FIRST(n, array, arguments) \
    a_trajpoly##n##_gen arguments; \
    a_trajpoly##n##_c0(ctx, out)
#define NEXT(n, order, array) a_trajpoly##n##_c##order(ctx, out)
#else
#define FIRST(n, array, arguments) \
    memset(ctx->array, 0xFF, sizeof(ctx->array)); \
    a_trajpoly##n##_gen0 arguments; \
    memcpy(out, ctx->array, sizeof(ctx->array))
#define NEXT(n, order, array) \
    memset(ctx->array, 0xFF, sizeof(ctx->array)); \
    a_trajpoly##n##_gen##order(ctx); \
    memcpy(out, ctx->array, sizeof(ctx->array))
#endif

#define ARGUMENTS3 (ctx, a[0], a[1], a[2], a[3], a[4])
#define ARGUMENTS5 (ctx, a[0], a[1], a[2], a[3], a[4], a[5], a[6])
#define ARGUMENTS7 (ctx, a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8])

static void gen3(void *ctx, const a_float *a) { a_trajpoly3_gen ARGUMENTS3; }
static void gen5(void *ctx, const a_float *a) { a_trajpoly5_gen ARGUMENTS5; }
static void gen7(void *ctx, const a_float *a) { a_trajpoly7_gen ARGUMENTS7; }

static void coefficients3(void *context, const a_float *a, int order, a_float *out)
{
    a_trajpoly3 *ctx = context;
    if (order == 0) { FIRST(3, p, ARGUMENTS3); }
#if A_TRAJPOLY3 > 1
    if (order == 1) { NEXT(3, 1, v); }
#endif
#if A_TRAJPOLY3 > 2
    if (order == 2) { NEXT(3, 2, a); }
#endif
}

static void coefficients5(void *context, const a_float *a, int order, a_float *out)
{
    a_trajpoly5 *ctx = context;
    if (order == 0) { FIRST(5, p, ARGUMENTS5); }
#if A_TRAJPOLY5 > 1
    if (order == 1) { NEXT(5, 1, v); }
#endif
#if A_TRAJPOLY5 > 2
    if (order == 2) { NEXT(5, 2, a); }
#endif
}

static void coefficients7(void *context, const a_float *a, int order, a_float *out)
{
    a_trajpoly7 *ctx = context;
    if (order == 0) { FIRST(7, p, ARGUMENTS7); }
#if A_TRAJPOLY7 > 1
    if (order == 1) { NEXT(7, 1, v); }
#endif
#if A_TRAJPOLY7 > 2
    if (order == 2) { NEXT(7, 2, a); }
#endif
#if A_TRAJPOLY7 > 3
    if (order == 3) { NEXT(7, 3, j); }
#endif
}

EVALUATE(trajpoly3_pos)
EVALUATE(trajpoly5_pos)
EVALUATE(trajpoly7_pos)
#if A_TRAJPOLY3 > 1
EVALUATE(trajpoly3_vel)
#endif
#if A_TRAJPOLY3 > 2
EVALUATE(trajpoly3_acc)
#endif
#if A_TRAJPOLY5 > 1
EVALUATE(trajpoly5_vel)
#endif
#if A_TRAJPOLY5 > 2
EVALUATE(trajpoly5_acc)
#endif
#if A_TRAJPOLY7 > 1
EVALUATE(trajpoly7_vel)
#endif
#if A_TRAJPOLY7 > 2
EVALUATE(trajpoly7_acc)
#endif
#if A_TRAJPOLY7 > 3
EVALUATE(trajpoly7_jer)
#endif

static void poly3(const char *directory)
{
    static const struct poly family = {3, 5, 3, A_TRAJPOLY3, gen3, coefficients3};
    static a_trajpoly3 moves[MAX_MOVES];
    int n = poly(directory, &family, moves, sizeof(moves[0]));
    REPLAY("poly3_eval", 5, 2, trajpoly3_pos, moves, n);
#if A_TRAJPOLY3 > 1
    REPLAY("poly3_eval", 5, 3, trajpoly3_vel, moves, n);
#endif
#if A_TRAJPOLY3 > 2
    REPLAY("poly3_eval", 5, 4, trajpoly3_acc, moves, n);
#endif
}

static void poly5(const char *directory)
{
    static const struct poly family = {5, 7, 3, A_TRAJPOLY5, gen5, coefficients5};
    static a_trajpoly5 moves[MAX_MOVES];
    int n = poly(directory, &family, moves, sizeof(moves[0]));
    REPLAY("poly5_eval", 5, 2, trajpoly5_pos, moves, n);
#if A_TRAJPOLY5 > 1
    REPLAY("poly5_eval", 5, 3, trajpoly5_vel, moves, n);
#endif
#if A_TRAJPOLY5 > 2
    REPLAY("poly5_eval", 5, 4, trajpoly5_acc, moves, n);
#endif
}

static void poly7(const char *directory)
{
    static const struct poly family = {7, 9, 4, A_TRAJPOLY7, gen7, coefficients7};
    static a_trajpoly7 moves[MAX_MOVES];
    int n = poly(directory, &family, moves, sizeof(moves[0]));
    REPLAY("poly7_eval", 6, 2, trajpoly7_pos, moves, n);
#if A_TRAJPOLY7 > 1
    REPLAY("poly7_eval", 6, 3, trajpoly7_vel, moves, n);
#endif
#if A_TRAJPOLY7 > 2
    REPLAY("poly7_eval", 6, 4, trajpoly7_acc, moves, n);
#endif
#if A_TRAJPOLY7 > 3
    REPLAY("poly7_eval", 6, 5, trajpoly7_jer, moves, n);
#endif
}

int main(int argc, char **argv)
{
    if (argc != 2)
    {
        fprintf(stderr, "usage: %s DIRECTORY\n", argv[0]);
        return 2;
    }
    bell(argv[1]);
    trap(argv[1]);
    poly3(argv[1]);
    poly5(argv[1]);
    poly7(argv[1]);
    return failed;
}
