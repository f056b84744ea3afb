// Tests the C++ side of the headers: methods in the structs, default arguments, const, the namespace.
// With LIBA_HEADERS it calls only the methods that liba's own headers declare.
#include "a/trajbell.h"
#include "a/trajpoly3.h"
#include "a/trajpoly5.h"
#include "a/trajpoly7.h"
#include "a/trajtrap.h"
#if !defined(LIBA_HEADERS)
#include "atraj.h"
#endif
#include "promises.h"
#include <cstring>

namespace {
template <class T>
bool same(const T &x, const T &y) {
    return std::memcmp(&x, &y, sizeof(T)) == 0;
}

#if !defined(LIBA_HEADERS)
// Bytes between the members may be anything.
bool same(const atraj_move &x, const atraj_move &y) {
    return x.t == y.t && x.phases == y.phases && std::memcmp(x.phase, y.phase, sizeof(x.phase)) == 0;
}

bool same(const atraj_axis &x, const atraj_axis &y) {
    bool all = x.period == y.period && std::memcmp(x.words, y.words, sizeof(x.words)) == 0;
    for (int i = 0; i < 3; ++i) { all = all && same(x.moves[i], y.moves[i]); }
    return all;
}

bool same(const atraj_shaper &x, const atraj_shaper &y) {
    return x.t == y.t && x.smoothing == y.smoothing && x.count == y.count && std::memcmp(x.weights, y.weights, sizeof(x.weights)) == 0 &&
           std::memcmp(x.delays, y.delays, sizeof(x.delays)) == 0;
}

bool same(const atraj_steps &x, const atraj_steps &y) {
    return x.offset == y.offset && x.step == y.step && x.from == y.from && x.to == y.to && x.count == y.count && x.far == y.far && x.phase == y.phase;
}
#endif

// Two structs of zeros: one for the methods of C++, and one for the functions of C.
template <class T>
struct both {
    T method, function;
    both() {
        std::memset(&method, 0, sizeof(T));
        std::memset(&function, 0, sizeof(T));
    }
    bool agree() const { return same(method, function); }
};

void bell() {
    both<a::trajbell> b;
    a::trajbell &method = b.method, &function = b.function;
    PROMISE(method.gen(30, 10, 5, 0, 10) == a_trajbell_gen(&function, 30, 10, 5, 0, 10, 0, 0) && b.agree());
    PROMISE(method.gen(30, 10, 5, 0, 10, 1, 0) == a_trajbell_gen(&function, 30, 10, 5, 0, 10, 1, 0) && b.agree());
    const a::trajbell &planned = method;
    const a_float x = planned.t / 4;
    PROMISE(planned.pos(x) == a_trajbell_pos(&function, x) && planned.pos(x) > 0);
    PROMISE(planned.vel(x) == a_trajbell_vel(&function, x) && planned.vel(x) > 0);
    PROMISE(planned.acc(0.1f) == a_trajbell_acc(&function, 0.1f) && planned.acc(0.1f) > 0);
    PROMISE(planned.jer(0.1f) == a_trajbell_jer(&function, 0.1f) && planned.jer(0.1f) == 30);
}

void trap() {
    both<a::trajtrap> b;
    PROMISE(b.method.gen(5, 4, -2, 0, 50) == a_trajtrap_gen(&b.function, 5, 4, -2, 0, 50, 0, 0) && b.agree());
    const a::trajtrap &planned = b.method;
    PROMISE(planned.t == 11.875f && planned.pos(planned.t) == 50);
    PROMISE(planned.vel(5) == 5 && planned.acc(1) == 4 && planned.acc(10) == -2);
}

void polynomials() {
    a::trajpoly3 cubic;
    a::trajpoly5 quintic;
    a::trajpoly7 septic;
    cubic.gen(8, 0, 10);
    quintic.gen(8, 0, 10);
    septic.gen(8, 0, 10);
    const a::trajpoly3 &c = cubic;
    const a::trajpoly5 &q = quintic;
    const a::trajpoly7 &s = septic;
    PROMISE(c.pos(4) == 5 && q.pos(4) == 5 && s.pos(4) == 5);
    PROMISE(c.pos(8) == 10 && q.pos(8) == 10 && s.pos(8) == 10);
#if A_TRAJPOLY3 > 2 && A_TRAJPOLY5 > 2 && A_TRAJPOLY7 > 3
    PROMISE(c.vel(0) == 0 && q.vel(0) == 0 && s.vel(0) == 0);
    PROMISE(c.acc(4) == 0 && q.acc(0) == 0 && s.acc(0) == 0 && s.jer(0) == 0);
#endif
#if defined(A_TRAJPOLY_COMPACT)
    a_float part[8];
    c.c0(part);
    PROMISE(part[0] == 0 && part[2] == cubic.c[2]);
    q.c1(part);
    PROMISE(part[2] == 3 * quintic.c[3]);
    s.c3(part);
    PROMISE(part[1] == 24 * septic.c[4]);
#else
    a::trajpoly7 again;
    std::memset(&again, 0, sizeof(again));
    again.gen0(8, 0, 10);
    PROMISE(std::memcmp(again.p, septic.p, sizeof(again.p)) == 0);
#if A_TRAJPOLY7 > 3
    again.gen1();
    again.gen2();
    again.gen3();
    PROMISE(same(again, septic));
#endif
#endif
}

#if !defined(LIBA_HEADERS)
const atraj::limits limits = atraj::limits::symmetric(30, 10, 5);

// Each member does what its function does.
void move() {
    both<atraj::limits> l;
    l.method.init(30, 10, 5);
    atraj_limits_init(&l.function, 30, 10, 5);
    PROMISE(l.agree() && same(limits, l.function));

    const atraj::state from = {1, 2, 3}, to = {10, -1, 2}, part = {2, 1, 0};
    both<atraj::move> b;
    atraj::move &method = b.method, &function = b.function;
    PROMISE(method.plan(limits, from, to) == atraj_move_plan(&function, &limits, &from, &to) && b.agree());
    PROMISE(method.t > 0);
    PROMISE(method.reach(limits, from, -3, 2) == atraj_move_reach(&function, &limits, &from, -3, 2) && b.agree());
    PROMISE(method.vel(method.t) == -3 && method.acc(method.t) == 2);
    PROMISE(method.reach(limits, from, -3) == atraj_move_reach(&function, &limits, &from, -3, 0) && b.agree());
    PROMISE(method.acc(method.t) == 0);
    PROMISE(method.stop(limits, from) == atraj_move_stop(&function, &limits, &from) && b.agree());
    PROMISE(method.vel(method.t) == 0);
    PROMISE(method.within(limits, from, to, -9, 9) == atraj_move_within(&function, &limits, &from, &to, -9, 9));
    PROMISE(method.within(limits, from, to, -99, 99) == atraj_move_within(&function, &limits, &from, &to, -99, 99) && b.agree());
    PROMISE(method.check(limits) == atraj_move_check(&function, &limits) && method.check(limits) >= 0);
    PROMISE(method.track(limits, from, part, 1, a_float(0.5)) == atraj_move_track(&function, &limits, &from, &part, 1, a_float(0.5)) && b.agree());
    PROMISE(method.meet(limits, from, part) == atraj_move_meet(&function, &limits, &from, &part) && b.agree());
    PROMISE(method.vel(method.t) == 1);
    PROMISE(method.meet(limits, from, to) == ATRAJ_ERR_TARGET && b.agree());

    const atraj::move &planned = method;
    const a_float x = planned.t / 4;
    const atraj::state now = planned.state(x);
    PROMISE(now.p == planned.pos(x) && now.v == planned.vel(x) && now.a == planned.acc(x));
    PROMISE(planned.pos(x) == atraj_move_pos(&function, x) && planned.pos(x) > 0);
    PROMISE(planned.vel(x) == atraj_move_vel(&function, x) && planned.acc(x) == atraj_move_acc(&function, x));
    PROMISE(planned.jer(x) == atraj_move_jer(&function, x) && planned.jer(x) != 0);
    PROMISE(planned.time_at(now.p) == atraj_move_time_at(&function, now.p) && planned.time_at(now.p) > 0);

    const atraj::phase &first = planned.phase[0];
    PROMISE(first.p == from.p && first.v == from.v && first.a == from.a && first.t == 0);

    atraj::state lowest, highest;
    planned.extremes(lowest, highest);
    PROMISE(lowest.p == 1 && highest.p == planned.pos(planned.t) && highest.v >= from.v);
    a_float p[2], v[2], a[2], j[2];
    PROMISE(planned.sample(0, x, 2, p, v, a, j) == 2 && p[1] == now.p && v[1] == now.v && a[1] == now.a && j[1] == planned.jer(x));
}

// Members that liba does not have: one plan, one judge, one look each.
template <class Profile>
void is_seen_whole(const Profile &profile, const atraj::state &lowest, const atraj::state &highest) {
    PROMISE(lowest.p == 0 && highest.p == 10 && lowest.v == 0 && highest.v > 0 && highest.a > 0 && lowest.a < 0);
    const atraj::state now = profile.state(0.25f);
    PROMISE(now.p == profile.pos(0.25f) && now.p > 0 && now.p < 10);
    PROMISE(now.v > lowest.v && now.v <= highest.v && now.a >= lowest.a && now.a <= highest.a);
}

template <class Polynomial>
Polynomial polynomial() {
    Polynomial planned;
    atraj::state lowest, highest;
    planned.gen(2, 0, 10);
    planned.extremes(2, lowest, highest);
    is_seen_whole(planned, lowest, highest);
    return planned;
}

void profiles() {
    a_float p[2], v[2], a[2], j[2];
    atraj::state lowest, highest;

    a::trajbell bell;
    PROMISE(bell.fastest(30, 10, 5, 0, 10) == bell.t && bell.t > 0 && bell.check(30, 10, 5) == 0);
    PROMISE(bell.check(30, 9, 4) == ATRAJ_EXCEEDS_ACCELERATION + ATRAJ_EXCEEDS_VELOCITY);
    bell.extremes(lowest, highest);
    is_seen_whole(bell, lowest, highest);
    PROMISE(bell.sample(0, 0.5f, 2, p, v, a, j) == 2 && p[1] == bell.pos(0.5f) && j[1] == bell.jer(0.5f));
    PROMISE(bell.fastest(30, 10, 5, 0, 0.1f, 2) > 0 && bell.check(30, 10, 5) == ATRAJ_OVERSHOOTS);

    a::trajtrap trap;
    PROMISE(trap.fastest(5, 4, -2, 0, 10) == trap.t && trap.t > 0 && trap.check(5, 4, -2) == 0);
    trap.extremes(lowest, highest);
    is_seen_whole(trap, lowest, highest);
    PROMISE(trap.sample(0, 0.5f, 2, p, v, a) == 2 && p[1] == trap.pos(0.5f) && a[1] == trap.acc(0.5f));

    const a::trajpoly3 cubic = polynomial<a::trajpoly3>();
    const a::trajpoly5 quintic = polynomial<a::trajpoly5>();
    const a::trajpoly7 septic = polynomial<a::trajpoly7>();
    PROMISE(cubic.sample(0, 0.5f, 2, p, v, a) == 2 && p[1] == cubic.pos(0.5f));
    PROMISE(quintic.sample(0, 0.5f, 2, p, v, a) == 2 && p[1] == quintic.pos(0.5f));
    PROMISE(septic.sample(0, 0.5f, 2, p, v, a, j) == 2 && p[1] == septic.pos(0.5f));
}

void axes() {
    const atraj::limits limits[2] = {atraj::limits::symmetric(30, 10, 5), atraj::limits::symmetric(60, 20, 5)};
    const atraj::state from[2] = {{0, 0, 0}, {0, 0, 0}}, to[2] = {{10, 0, 0}, {-5, 0, 0}};
    atraj::move axes[2];
    PROMISE(atraj::sync(axes, limits, from, to, 2) == 0 && axes[0].t == axes[1].t);
    PROMISE(atraj::sync(axes, limits, from, to, 2, 4) == 0 && axes[0].t == 4);
    const a_float lowest[2] = {0, -5}, highest[2] = {10, 0};
    PROMISE(atraj::sync_within(axes, limits, from, to, lowest, highest, 2, 4) == 0 && axes[1].t == 4);
    PROMISE(atraj::sync_within(axes, limits, from, to, lowest, lowest, 2) == ATRAJ_ERR_LIMITS);
    PROMISE(atraj::line(axes, limits, from, to, 2, 4, 0.5f) == 0 && axes[0].pos(1) == -2 * axes[1].pos(1));
}

void axis() {
    const atraj::state from = {1, 0, 0}, to = {10, 0, 0};
    both<atraj::axis> b;
    atraj::axis &method = b.method, &function = b.function;
    PROMISE(method.init(0.001f, from) == 0 && atraj_axis_init(&function, 0.001f, &from) == 0 && b.agree());
    PROMISE(method.init(0, from) == ATRAJ_ERR_DURATION);
    PROMISE(method.go(limits, to, 2) == 0 && atraj_axis_go(&function, &limits, &to, 2) == 0 && b.agree());
    atraj::state now;
    for (int i = 0; i < 100; ++i) { atraj_axis_tick(&function, &now); }
    for (int i = 1; i < 100; ++i) { method.tick(); }
    PROMISE(same(method.tick(), now) && now.p > 1 && b.agree());
    PROMISE(method.reach(limits, -3, 2, 1) == atraj_axis_reach(&function, &limits, -3, 2, 1) && b.agree());
    PROMISE(method.stop(limits, 1) == atraj_axis_stop(&function, &limits, 1) && b.agree());
    PROMISE(method.track(limits, to, 2, 0.5f, 1) == atraj_axis_track(&function, &limits, &to, 2, 0.5f, 1) && b.agree());
    PROMISE(method.stop(limits, 0) == ATRAJ_ERR_LATE);
}

void steps() {
    const atraj::state from = {0, 0, 0}, to = {1, 0, 0};
    atraj::move move;
    PROMISE(move.plan(limits, from, to) == 0);
    both<atraj::steps> b;
    atraj::steps &method = b.method, &function = b.function;
    PROMISE(method.init(move, 0, 0.5f) == 0 && atraj_steps_init(&function, &move, 0, 0.5f) == 0 && b.agree());
    a_float time = 0, other = 0;
    PROMISE(method.next(move, time) == 1 && atraj_steps_next(&function, &move, &other) == 1 && time == other && b.agree());
    PROMISE(method.follow(move) == 0 && atraj_steps_follow(&function, &move) == 0 && b.agree());
    PROMISE(method.init(move, 0, 0) == ATRAJ_ERR_LIMITS);
}

void shaper() {
    const atraj::state from = {0, 0, 0}, to = {1, 0, 0};
    atraj::move move;
    a::trajbell bell;
    PROMISE(move.plan(limits, from, to) == 0 && bell.gen(30, 10, 5, 0, 1) > 0);
    both<atraj::shaper> b;
    atraj::shaper &method = b.method, &function = b.function;
    PROMISE(method.smooth(0.1f) == 0 && atraj_shaper_smooth(&function, 0.1f) == 0 && b.agree());
    PROMISE(method.add(ATRAJ_SHAPER_EI, 5, 0) == 0 && atraj_shaper_add(&function, ATRAJ_SHAPER_EI, 5, 0) == 0 && b.agree());
    atraj::state now;
    atraj_shaper_state(&function, &move, 0.3f, &now);
    PROMISE(same(method.state(move, 0.3f), now) && now.p > 0);
    atraj_shaper_bell_state(&function, &bell, 0.3f, &now);
    PROMISE(same(method.bell_state(bell, 0.3f), now) && now.p > 0);
    PROMISE(method.init(ATRAJ_SHAPER_ZV, 5, 0) == 0 && atraj_shaper_init(&function, ATRAJ_SHAPER_ZV, 5, 0) == 0 && b.agree());
}

void streams() {
    const atraj::state rest = {1, 0, 0}, moved = {1.1f, 0, 0};
    a_float line[2][400], time = 0;
    atraj::shaper shaper;
    PROMISE(shaper.init(ATRAJ_SHAPER_ZV, 5, 0) == 0 && shaper.size(0.001f) == atraj_shaper_size(&shaper, 0.001f) && shaper.size(0.001f) <= 400);
    atraj::shaper_stream method;
    atraj_shaper_stream function;
    PROMISE(method.init(shaper, 0.001f, rest, line[0], 400) == 0 && atraj_shaper_stream_init(&function, &shaper, 0.001f, &rest, line[1], 400) == 0);
    PROMISE(method.advance(0.1f) == 0 && atraj_shaper_stream_advance(&function, 0.1f) == 0);
    PROMISE(method.change(shaper, line[0], 400) == 0 && method.change(shaper, line[0], 3) == ATRAJ_ERR_NULL);
    atraj::state one, other;
    PROMISE(method.tick(moved, line[0], 400, one) == 0 && atraj_shaper_stream_tick(&function, &moved, line[1], 400, &other) == 0 && same(one, other) && one.p > 1);
    atraj::step_stream motor;
    PROMISE(motor.init(0.01f, 0.001f, rest) == 0 && motor.wait(0.0001f, 0.0002f) == 0 && motor.count() == 100);
    PROMISE(motor.tick(moved) == 0 && motor.next(time) == 1 && time > 0 && atraj_step_stream_count(&motor) == 101);
}

void clock_of_a_path() {
    const atraj::state from = {0, 0, 0}, to = {10, 0, 0};
    atraj::move move;
    PROMISE(move.plan(atraj::limits::symmetric(24, 8, 4), from, to) == 0);
    both<atraj::clock> b;
    atraj::clock &method = b.method, &function = b.function;
    method.start();
    atraj_clock_start(&function);
    PROMISE(method.rate(&move, &limits, 1, 1, 1, 0) == 0 && atraj_clock_rate(&function, &move, &limits, 1, 1, 1, 0) == 0);
    PROMISE(method.until() == atraj_clock_until(&function) && method.until() > 1);
    method.rebase(0.5f);
    atraj_clock_rebase(&function, 0.5f);
    PROMISE(method.until() == atraj_clock_until(&function) && method.until() > 0.5f);
    atraj::state now;
    atraj_clock_state(&function, &move, 1, 1, 1.5f, &now.p, &now.v, &now.a, A_NULL);
    PROMISE(same(method.state(&move, 1, 1, 1.5f), now));
    PROMISE(atraj::line_stop(&move, &limits, 1, 1) == 0 && move.vel(move.t) == 0);
}

void group() {
    const atraj::limits limits[2] = {atraj::limits::symmetric(30, 10, 5), atraj::limits::symmetric(30, 10, 5)};
    const atraj::state to[2] = {{10, 0, 0}, {-5, 0, 0}};
    atraj::state states[2][2] = {{{0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}}, one[2], other[2];
    atraj::move room[2][6], path[2];
    atraj::group method;
    atraj_group function;
    const a_float low[2] = {-1, -6}, high[2] = {11, 1};
    PROMISE(method.init(0.001f, states[0], room[0], 2) == 0 && atraj_group_init(&function, 0.001f, states[1], room[1], 2) == 0);
    PROMISE(method.within(low, high) == 0 && atraj_group_within(&function, low, high) == 0);
    PROMISE(method.line(limits, to, 1) == 0 && atraj_group_line(&function, limits, to, 1) == 0);
    for (int i = 0; i < 500; ++i) { PROMISE(method.tick(one) == atraj_group_tick(&function, other) && same(one[1], other[1])); }
    PROMISE(method.rate(limits, 0, 1) == 0 && atraj_group_rate(&function, limits, 0, 1) == 0 && method.stop(limits, 0) == ATRAJ_ERR_LATE);
    for (int i = 0; i < 2000; ++i) { PROMISE(method.tick(one) == atraj_group_tick(&function, other) && same(one[1], other[1])); }
    PROMISE(one[0].v == 0 && one[0].p > 0 && one[0].p < 10);
    PROMISE(method.go(limits, to, 1) == atraj_group_go(&function, limits, to, 1) && method.sync(limits, to, 1) == 0);
    PROMISE(atraj::sync(path, limits, one, to, 2) == 0 && method.path(limits, path, 1, 0, 1) == 0);
    for (int i = 0; i < 5000; ++i) { method.tick(one); }
    PROMISE(one[0].p == 10 && one[1].p == -5 && method.time(1) == atraj_group_time(&method, 1) && method.time(1) == path[0].t);
}

// Every finding and every error has a sentence of its own.
void messages() {
    for (int code = ATRAJ_ERR_MOVING; code <= ATRAJ_RATE_NOT_REACHED; ++code) {
        for (int other = ATRAJ_ERR_MOVING; other < code; ++other) {
            const bool differ = std::strcmp(atraj::message(code), atraj::message(other)) != 0;
            PROMISE(differ == (code <= 0 || other <= 0 || (code & -code) != (other & -other)));
        }
    }
    PROMISE(std::strcmp(atraj_message(256), "this code is unknown") == 0 && std::strcmp(atraj_message(-11), "this code is unknown") == 0);
    PROMISE(std::strcmp(atraj_message(ATRAJ_ERR_LATE), "the tick at which the plan was to take over has begun, or is too far ahead") == 0);
    PROMISE(std::strcmp(atraj_message(ATRAJ_JUMPS + ATRAJ_OVERSHOOTS), atraj_message(ATRAJ_JUMPS)) == 0);
}
#endif
} // namespace

int main() {
    bell(), trap(), polynomials();
#if !defined(LIBA_HEADERS)
    move(), profiles(), axes(), axis(), steps(), shaper(), streams(), clock_of_a_path(), group(), messages();
#endif
    return broken;
}
