/*
 Tests the answers of the plans that never fail and of the judge of plans to arguments that are none: a NULL context, NaN, limits of 0,
 accelerations of one sign. Shows every finding of the judge, and what a move reaches.
 Prints the line of the first broken promise and fails.
*/
#include "atraj.h"
#include "promise.h"

/* Whether a bell or a trapezoid with one of its seven arguments replaced has the answer NaN, and the context keeps its bytes. */
static int refused(int is_trap, int argument, a_float value)
{
    a_float a[7] = {1, 1, 1, 0, 1, 0, 0};
    unsigned char before[sizeof(a_trajbell)], bell[sizeof(a_trajbell)];
    a_float answer;
    a[2] = (a_float)(is_trap ? -1 : 1);
    a[argument] = value;
    memset(before, 0x55, sizeof(before));
    memcpy(bell, before, sizeof(before));
    answer = is_trap ? atraj_trap_gen((void *)bell, a[0], a[1], a[2], a[3], a[4], a[5], a[6])
                     : atraj_bell_gen((void *)bell, a[0], a[1], a[2], a[3], a[4], a[5], a[6]);
    return isnan(answer) && memcmp(bell, before, sizeof(before)) == 0;
}

static int refused_arguments(void)
{
    a_trajbell bell;
    int i;
    PROMISE(isnan(atraj_bell_gen(A_NULL, 1, 1, 1, 0, 1, 0, 0)) && isnan(atraj_trap_gen(A_NULL, 1, 1, -1, 0, 1, 0, 0)));
    for (i = 0; i < 7; ++i)
    {
        PROMISE(refused(0, i, none) && refused(1, i, none));
        PROMISE(i > 2 || (refused(0, i, 0) && refused(1, i, 0)));
        PROMISE((i != 3 && i != 4) || (refused(0, i, endless) && refused(1, i, -endless))); /* a velocity is clamped */
    }
    PROMISE(isnan(atraj_bell_gen(&bell, endless, endless, 1, 0, 1, 0, 0)));
    PROMISE(refused(1, 1, -1) && refused(1, 2, 1) && refused(1, 2, -endless));
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
    PROMISE(atraj_trap_check(&trap, 5, 4, 2) == ATRAJ_ERR_LIMITS);
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
