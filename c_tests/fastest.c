/*
 Tests the answers of the plans that never fail and of the judge of plans to arguments that are none: a NULL context, NaN, limits of 0,
 accelerations of one sign. Shows every finding of the judge, and what a move reaches.
 Prints the line of the first broken promise and fails.
*/
#include "atraj.h"
#include "promise.h"

/* The answer is NaN, and the context keeps its bytes. */
#define REFUSED(type, gen, a, b, c, p0, p1, v0, v1) \
    do { \
        type before, ctx; \
        memset(&before, 0x55, sizeof(before)); \
        ctx = before; \
        PROMISE(isnan(gen(&ctx, a, b, c, p0, p1, v0, v1))); \
        PROMISE(memcmp(&ctx, &before, sizeof(ctx)) == 0); \
    } while (0)
#define NO_BELL(...) REFUSED(a_trajbell, atraj_bell_gen, __VA_ARGS__)
#define NO_TRAP(...) REFUSED(a_trajtrap, atraj_trap_gen, __VA_ARGS__)

static int refused_arguments(void)
{
    PROMISE(isnan(atraj_bell_gen(A_NULL, 1, 1, 1, 0, 1, 0, 0)));
    PROMISE(isnan(atraj_trap_gen(A_NULL, 1, 1, -1, 0, 1, 0, 0)));

    NO_BELL(none, 1, 1, 0, 1, 0, 0);
    NO_BELL(1, none, 1, 0, 1, 0, 0);
    NO_BELL(1, 1, none, 0, 1, 0, 0);
    NO_BELL(1, 1, 1, none, 1, 0, 0);
    NO_BELL(1, 1, 1, 0, none, 0, 0);
    NO_BELL(1, 1, 1, 0, 1, none, 0);
    NO_BELL(1, 1, 1, 0, 1, 0, none);
    NO_BELL(0, 1, 1, 0, 1, 0, 0);
    NO_BELL(1, 0, 1, 0, 1, 0, 0);
    NO_BELL(1, 1, 0, 0, 1, 0, 0);
    NO_BELL(1, 1, 1, endless, 1, 0, 0);
    NO_BELL(1, 1, 1, 0, -endless, 0, 0);
    NO_BELL(endless, endless, 1, 0, 1, 0, 0);

    NO_TRAP(none, 1, -1, 0, 1, 0, 0);
    NO_TRAP(1, none, -1, 0, 1, 0, 0);
    NO_TRAP(1, 1, none, 0, 1, 0, 0);
    NO_TRAP(1, 1, -1, none, 1, 0, 0);
    NO_TRAP(1, 1, -1, 0, none, 0, 0);
    NO_TRAP(1, 1, -1, 0, 1, none, 0);
    NO_TRAP(1, 1, -1, 0, 1, 0, none);
    NO_TRAP(0, 1, -1, 0, 1, 0, 0);
    NO_TRAP(1, 0, -1, 0, 1, 0, 0);
    NO_TRAP(1, 1, 0, 0, 1, 0, 0);
    NO_TRAP(1, 1, 1, 0, 1, 0, 0);
    NO_TRAP(1, -1, -1, 0, 1, 0, 0);
    NO_TRAP(1, 1, -endless, 0, 1, 0, 0);
    NO_TRAP(1, 1, -1, endless, 1, 0, 0);
    return 0;
}

/* What liba refuses is planned: a target behind the way to stop, no displacement, no limit. */
static int plans(void)
{
    a_trajbell bell;
    a_trajtrap trap;
    a_float t = atraj_bell_gen(&bell, 30, 10, 5, 0, A_FLOAT_C(0.125), 2, 0);
    PROMISE(t > 0 && t == bell.t && bell.jm < 0);
    PROMISE(a_trajbell_pos(&bell, t) == A_FLOAT_C(0.125) && a_trajbell_vel(&bell, t) == 0);
    PROMISE(atraj_bell_check(&bell, 30, 10, 5) == ATRAJ_OVERSHOOTS);
    PROMISE(atraj_bell_gen(&bell, -30, -10, -5, 0, A_FLOAT_C(0.125), 2, 0) == t);
    PROMISE(atraj_bell_gen(&bell, 30, 10, 5, 1, 1, 0, 0) == 0 && bell.t == 0);
    PROMISE(atraj_bell_gen(&bell, 1, endless, endless, 0, 2, 0, 0) == 4);
    PROMISE(atraj_bell_check(&bell, 1, endless, endless) == 0);
    PROMISE(atraj_bell_gen(&bell, endless, 1, 1, 0, 2, 0, 0) >= 3);

    t = atraj_trap_gen(&trap, 5, 4, -2, 0, 1, 4, 0);
    PROMISE(t > 0 && t == trap.t);
    PROMISE(a_trajtrap_pos(&trap, t) == 1 && a_trajtrap_vel(&trap, t) == 0);
    PROMISE(atraj_trap_check(&trap, 5, 4, -2) == ATRAJ_OVERSHOOTS);
    PROMISE(atraj_trap_gen(&trap, 5, -2, 4, 0, 1, 4, 0) == t);
    PROMISE(atraj_trap_gen(&trap, 5, 4, -2, 1, 1, 0, 0) == 0 && trap.t == 0);
    PROMISE(atraj_trap_gen(&trap, endless, 1, -1, 0, 1, 0, 0) == 2);
    return 0;
}

/* Every finding, each in a struct that has been planned well and then lost one of its virtues. */
static int findings(void)
{
    a_trajbell bell, broken;
    a_trajtrap trap, spoilt;
    PROMISE(atraj_bell_check(A_NULL, 30, 10, 5) == ATRAJ_ERR_NULL && ATRAJ_ERR_NULL == -1);
    PROMISE(atraj_trap_check(A_NULL, 5, 4, -2) == ATRAJ_ERR_NULL);

    PROMISE(atraj_bell_gen(&bell, 30, 10, 5, 0, 10, 1, 0) > 0);
    PROMISE(atraj_bell_check(&bell, 30, 10, 5) == 0);
    PROMISE(atraj_bell_check(&bell, -30, -10, -5) == 0);
    PROMISE(atraj_bell_check(&bell, 29, 10, 5) == 1);
    PROMISE(atraj_bell_check(&bell, 30, 9, 5) == 2);
    PROMISE(atraj_bell_check(&bell, 30, 10, 4) == 4);
    PROMISE(atraj_bell_check(&bell, 29, 9, 4) == 7);
    broken = bell;
    broken.p1 += 1;
    PROMISE(atraj_bell_check(&broken, 30, 10, 5) == 8);
    broken = bell;
    broken.td += A_FLOAT_C(0.25);
    PROMISE(atraj_bell_check(&broken, 30, 10, 5) & 8);
    PROMISE(atraj_bell_gen(&broken, 30, 10, 5, 0, 10, -1, 0) > 0);
    PROMISE(atraj_bell_check(&broken, 30, 10, 5) == 16);
    broken = bell;
    broken.am = none;
    PROMISE(atraj_bell_check(&broken, 30, 10, 5) == ATRAJ_ERR_NOT_FINITE && ATRAJ_ERR_NOT_FINITE == -2);
    broken = bell;
    broken.t = endless;
    PROMISE(atraj_bell_check(&broken, 30, 10, 5) == -2);
    PROMISE(atraj_bell_check(&bell, 30, none, 5) == -2);

    PROMISE(atraj_trap_gen(&trap, 5, 4, -2, 0, 50, 1, 0) > 0);
    PROMISE(atraj_trap_check(&trap, 5, 4, -2) == 0);
    PROMISE(atraj_trap_check(&trap, 5, -2, 4) == 0);
    PROMISE(atraj_trap_check(&trap, 5, 3, -2) == 2);
    PROMISE(atraj_trap_check(&trap, 5, 4, -1) == 2);
    PROMISE(atraj_trap_check(&trap, 4, 4, -2) == 4);
    spoilt = trap;
    spoilt.pd += 1;
    PROMISE(atraj_trap_check(&spoilt, 5, 4, -2) == 8);
    PROMISE(atraj_trap_gen(&spoilt, 5, 4, -2, 0, 50, -1, 0) > 0);
    PROMISE(atraj_trap_check(&spoilt, 5, 4, -2) == 16);
    spoilt = trap;
    spoilt.vc = none;
    PROMISE(atraj_trap_check(&spoilt, 5, 4, -2) == -2);
    PROMISE(atraj_trap_check(&trap, none, 4, -2) == -2);
    return 0;
}

static int extremes(void)
{
    a_float lowest[3], highest[3];
    a_trajbell bell;
    a_trajtrap trap;
    a_trajpoly3 poly3;
    a_trajpoly5 poly5;
    a_trajpoly7 poly7;
    memset(lowest, 0x55, sizeof(lowest));
    memcpy(highest, lowest, sizeof(highest));
    atraj_bell_extremes(A_NULL, lowest, highest);
    atraj_trap_extremes(A_NULL, lowest, highest);
    atraj_poly3_extremes(A_NULL, 1, lowest, highest);
    atraj_poly5_extremes(A_NULL, 1, lowest, highest);
    atraj_poly7_extremes(A_NULL, 1, lowest, highest);
    PROMISE(memcmp(lowest, highest, sizeof(lowest)) == 0);

    PROMISE(atraj_bell_gen(&bell, 30, 10, 5, 0, 10, 0, 0) > 0);
    atraj_bell_extremes(&bell, A_NULL, A_NULL);
    atraj_bell_extremes(&bell, lowest, A_NULL);
    atraj_bell_extremes(&bell, A_NULL, highest);
    PROMISE(lowest[0] == 0 && lowest[1] == 0 && lowest[2] == -10);
    PROMISE(highest[0] == 10 && highest[1] == 5 && highest[2] == 10);

    PROMISE(atraj_trap_gen(&trap, 5, 4, -2, 0, 1, 4, 0) > 0);
    atraj_trap_extremes(&trap, lowest, highest);
    PROMISE(lowest[0] == 0 && highest[0] > 1 && lowest[1] < 0 && highest[1] == 4);
    PROMISE(lowest[2] == -2 && highest[2] == 4);

    a_trajpoly3_gen(&poly3, 2, 0, 4, 0, 0);
    atraj_poly3_extremes(&poly3, 2, lowest, highest);
    PROMISE(lowest[0] == 0 && highest[0] == 4 && lowest[1] == 0 && highest[1] == 3);
    PROMISE(lowest[2] == -6 && highest[2] == 6);
    a_trajpoly5_gen(&poly5, 2, 0, 4, 0, 0, 0, 0);
    atraj_poly5_extremes(&poly5, 2, lowest, highest);
    PROMISE(highest[1] == A_FLOAT_C(3.75));
    a_trajpoly7_gen(&poly7, 2, 0, 4, 0, 0, 0, 0, 0, 0);
    atraj_poly7_extremes(&poly7, 2, lowest, highest);
    PROMISE(A_ABS(highest[1] - A_FLOAT_C(4.375)) < 8 * A_FLOAT_C(4.375) * A_FLOAT_EPSILON);
    return 0;
}

int main(void)
{
    return refused_arguments() || plans() || findings() || extremes();
}
