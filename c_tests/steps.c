/*
 Tests the contract of every function of atraj/steps.h. Each pointer is once NULL, each number once wrong; a refusal leaves the steps untouched.
 Then the steps of a move that turns, of moves that follow each other, and of a struct that no planner filled. `tests/oracle` judges the times.
 Prints the line of the first broken promise and fails.
*/
#include "atraj/steps.h"
#include "promise.h"

static const atraj_limits limits = {5, -4, 10, -9, 30, -20};
static const atraj_state start = {1, 0, 0}, fast = {1, 4, 0}, target = {0, 0, 0};
static const a_float step = A_FLOAT_C(0.125), half = A_FLOAT_C(0.0625);
static atraj_steps steps, before;

static int untouched(void) { return memcmp(&steps, &before, sizeof(steps)) == 0; }

static int refused(void)
{
    const a_float no_steps[] = {0, -(a_float)0, -step, -A_FLOAT_MIN, -endless}, no_numbers[] = {endless, -endless, none};
    atraj_move move, far;
    atraj_state end = target;
    a_float time = 7;
    int i;
    PROMISE(atraj_move_plan(&move, &limits, &start, &target) == 0);
    end.p = A_FLOAT_C(2e9) * step;
    PROMISE(atraj_move_plan(&far, &limits, &start, &end) == 0);
    memset(&before, 0x55, sizeof(before));
    steps = before;
    for (i = 0; i < (int)A_LEN(no_steps); ++i) { PROMISE(atraj_steps_init(&steps, &move, half, no_steps[i]) == ATRAJ_ERR_LIMITS); }
    for (i = 0; i < (int)A_LEN(no_numbers); ++i) { PROMISE(atraj_steps_init(&steps, &move, no_numbers[i], step) == ATRAJ_ERR_NOT_FINITE); }
    PROMISE(atraj_steps_init(&steps, &move, half, endless) == ATRAJ_ERR_NOT_FINITE);
    PROMISE(atraj_steps_init(&steps, &move, half, none) == ATRAJ_ERR_NOT_FINITE);
    PROMISE(atraj_steps_init(&steps, &far, half, step) == ATRAJ_ERR_NOT_FINITE);
    PROMISE(atraj_steps_init(&steps, &move, half, A_FLOAT_MIN) == ATRAJ_ERR_NOT_FINITE);
    PROMISE(atraj_steps_init(A_NULL, &move, half, step) == ATRAJ_ERR_NULL);
    PROMISE(atraj_steps_init(&steps, A_NULL, half, step) == ATRAJ_ERR_NULL);
    PROMISE(untouched());

    PROMISE(atraj_steps_init(&steps, &move, half, step) == 0 && steps.count == 7);
    before = steps;
    PROMISE(atraj_steps_follow(A_NULL, &move) == ATRAJ_ERR_NULL);
    PROMISE(atraj_steps_follow(&steps, A_NULL) == ATRAJ_ERR_NULL);
    PROMISE(atraj_steps_follow(&steps, &far) == ATRAJ_ERR_NOT_FINITE);
    PROMISE(atraj_steps_next(A_NULL, &move, &time) == 0);
    PROMISE(atraj_steps_next(&steps, A_NULL, &time) == 0);
    PROMISE(untouched() && time == 7);
    PROMISE(atraj_steps_next(&steps, &move, A_NULL) == -1 && steps.count == 6);
    return 0;
}

/* An axis in motion goes on, turns, and comes back behind its start. */
static int turns(void)
{
    atraj_move move;
    atraj_state highest;
    a_float time = -1, last = 0;
    int up = 0, down = 0, direction;
    PROMISE(atraj_move_plan(&move, &limits, &fast, &target) == ATRAJ_OVERSHOOTS);
    atraj_move_extremes(&move, A_NULL, &highest);
    PROMISE(atraj_steps_init(&steps, &move, half, step) == 0 && steps.count == 7);
    while ((direction = atraj_steps_next(&steps, &move, &time)) != 0)
    {
        const a_float line = half + step * (a_float)(direction > 0 ? steps.count : steps.count + 1);
        PROMISE(direction == 1 || direction == -1);
        PROMISE(time >= last && time <= move.t && fabs((double)(atraj_move_pos(&move, time) - line)) < 1e-5);
        PROMISE(direction > 0 ? !down : 1); /* it turns once */
        *(direction > 0 ? &up : &down) += 1;
        last = time;
    }
    PROMISE(up == (int)((highest.p - half) / step) - 7 && up > 5);
    PROMISE(steps.count == 7 + up - down && steps.count == -1);
    before = steps;
    PROMISE(atraj_steps_next(&steps, &move, &time) == 0 && time == last && steps.count == before.count);
    return 0;
}

/* A move begins where the other one was given up, beside the motor. */
static int follows(void)
{
    atraj_move move, next;
    atraj_state now = {2, 0, 0};
    a_float time = -1;
    int sum = 0;
    PROMISE(atraj_move_plan(&move, &limits, &start, &target) == 0);
    PROMISE(atraj_steps_init(&steps, &move, half, step) == 0 && steps.count == 7);
    PROMISE(atraj_move_plan(&next, &limits, &now, &target) == 0);
    PROMISE(atraj_steps_follow(&steps, &next) == 0 && steps.count == 7);
    PROMISE(atraj_steps_next(&steps, &next, &time) != 0);
    while (atraj_steps_next(&steps, &next, &time)) { ++sum; }
    PROMISE(steps.count == -1 && time <= next.t && sum > 0);
    return 0;
}

/* Whatever a struct holds, each call ends. */
static int foreign(void)
{
    const unsigned char patterns[] = {0x00, 0x3f, 0x40, 0x7f, 0x80, 0xbf, 0xff};
    atraj_move planned, move;
    int i, k;
    PROMISE(atraj_move_plan(&planned, &limits, &start, &target) == 0);
    for (i = 0; i < (int)A_LEN(patterns); ++i)
    {
        for (k = 0; k < 2; ++k)
        {
            memset(&move, patterns[i], sizeof(move));
            PROMISE(atraj_steps_init(&steps, &planned, half, step) == 0);
            if (k) { memset(&steps, patterns[i], sizeof(steps)); }
            for (int n = 0; n < 100 && atraj_steps_next(&steps, &move, A_NULL); ++n) {}
            for (int n = 0; n < 100 && atraj_steps_next(&steps, &planned, A_NULL); ++n) {}
        }
    }
    return 0;
}

int main(void) { return refused() || turns() || follows() || foreign(); }
