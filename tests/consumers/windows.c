/* A program without a C library: whether a planned move arrives is its exit code. tests/release.sh links it. */
#include "atraj/move.h"

__declspec(dllimport) void __stdcall ExitProcess(unsigned);
int _fltused; /* Microsoft's compilers ask for it where a program has floating-point numbers. */

void start(void) {
    atraj_limits limits;
    atraj_state const here = {0, 1, 2}, there = {10, 0, 0};
    atraj_move move;
    atraj_limits_init(&limits, 30, 10, 5);
    if (atraj_move_plan(&move, &limits, &here, &there) < 0) { ExitProcess(1); }
    ExitProcess(atraj_move_pos(&move, 0) == 0 && atraj_move_pos(&move, move.t) == 10 ? 42 : 2);
}
