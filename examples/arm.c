/*
 An arm with six axes follows way points and stops at each. The axes have limits of their own, arrive at a way point together, and
 stretch their moves to the slowest axis. The clock of the drives ticks every 4 ms, and every move ends on a tick.

     make dist
     cc -Itarget/dist/include examples/arm.c target/dist/lib/libatraj.a -lm -o arm
*/
#include "atraj/move.h"
#include <stdio.h>

#define CYCLE 0.004 /* s */
enum { AXES = 6, LEGS = 4 };

static atraj_state const points[LEGS + 1][AXES] = {
    {{0, 0, 0}, {-90, 0, 0}, {90, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, /* degrees, and at rest */
    {{30, 0, 0}, {-60, 0, 0}, {70, 0, 0}, {0, 0, 0}, {-40, 0, 0}, {90, 0, 0}},
    {{30, 0, 0}, {-50, 0, 0}, {75, 0, 0}, {0, 0, 0}, {-55, 0, 0}, {90, 0, 0}}, /* down */
    {{-45, 0, 0}, {-70, 0, 0}, {80, 0, 0}, {20, 0, 0}, {-30, 0, 0}, {-90, 0, 0}},
    {{0, 0, 0}, {-90, 0, 0}, {90, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, /* home */
};

int main(void)
{
    atraj_limits limits[AXES];
    for (int i = 0; i < AXES; ++i) { atraj_limits_init(&limits[i], i < 3 ? 4000 : 9000, i < 3 ? 500 : 1000, i < 3 ? 120 : 250); }
    double start = 0;
    for (int leg = 0; leg < LEGS; ++leg) {
        atraj_state const *const from = points[leg], *const to = points[leg + 1];
        atraj_move axes[AXES];
        if (atraj_moves_sync(axes, limits, from, to, AXES, 0, CYCLE) < 0) { return 1; }
        double const t = axes[0].t;
        int const ticks = (int)(t / CYCLE + 0.5);
        printf("way point %d after %.3f s, %d ticks\n", leg + 1, start + t, ticks);
        for (int quarter = 1; quarter <= 4; ++quarter) {
            double const x = ticks * quarter / 4 * CYCLE;
            printf("  %.3f s:", start + x);
            for (int i = 0; i < AXES; ++i) { printf(" %7.2f", atraj_move_pos(&axes[i], x)); }
            printf("\n");
        }
        for (int i = 0; i < AXES; ++i) {
            atraj_state end;
            atraj_move_state(&axes[i], ticks * CYCLE, &end.p, &end.v, &end.a, NULL);
            if (!(axes[i].t == t && end.p == to[i].p && end.v == 0 && end.a == 0)) { return 1; }
        }
        start += t;
    }
    return 0;
}
