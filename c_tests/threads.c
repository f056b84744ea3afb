/*
 Two threads share an axis, or with GROUP a group of two: one plans at random, and one ticks and watches every setpoint, as fast as they can.
 Prints what they counted, and fails if a setpoint jumps, or if the axis does not come to its last target.
*/
#include "watch.h"
#include <pthread.h>
#include <sched.h>
#include <stdio.h>

enum { PLANS = 200000, LEAD = 200 };

static int is_over; /* both threads use it */

static void *tick_on(void *unused) {
    unsigned left = SETTLED + 2 * LEAD;
    for (; left; left -= (unsigned)__atomic_load_n(&is_over, __ATOMIC_ACQUIRE)) { interrupt(); }
    return unused;
}

int main(void) {
    pthread_t ticker;
    if (init() != 0 || pthread_create(&ticker, A_NULL, tick_on, A_NULL) != 0) { return 2; }
    for (unsigned planned = 0; planned != PLANS; planned = answers.accepted) {
        unsigned const late = answers.late;
        plan(LEAD);
        if (answers.late != late) { sched_yield(); }
    }
    while (go(last_target, LEAD) < 0) {}
    __atomic_store_n(&is_over, 1, __ATOMIC_RELEASE);
    pthread_join(ticker, A_NULL);
    printf("%u ticks, %u plans in time, %u late, %u refused, %u jumps\n", watch.ticks, answers.accepted, answers.late, answers.refused,
           watch.jumps);
    return !is_good();
}
