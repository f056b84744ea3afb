/* Prints moves that this host plans, in the form of the golden tables: moves TABLE > FILE. The tables `bell` and `trap` are plans of
 * atraj.h. The tables `move`, `phase` and `eval` are plans of atraj/move.h, their phases and their evaluations. The table `machine` has their steps, shaped states and holds. The tables `axes` and `stretched`
 * are sets of axes and the phases of their plans. The table `path` has paths through waypoints. The firmware must compute the same
 * bits. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "atraj.h"
#include "problem.h"

enum { FAMILIES = 6, MOVES = 40 * FAMILIES };

static double random_between(double low, double high) {
    static uint32_t state = 1;
    state = state * 1664525u + 1013904223u;
    return low + (high - low) * (state / 4294967296.0);
}

/* How far an axis goes from the velocity v until it stops. */
static double way_to_stop(double jm, double am, double v) {
    double const ramp = fabs(v) < am * am / jm ? 2 * sqrt(fabs(v) / jm) : am / jm + fabs(v) / am;
    return 0.5 * v * ramp;
}

/* Displacement and velocities at both ends, for one move of a family. */
static void ends(unsigned family, double jm, double am, double vm, double *h, double *v0, double *v1) {
    *h = random_between(-1, 1) * random_between(0, 15);
    *v0 = random_between(-vm, vm);
    *v1 = random_between(-vm, vm);
    switch (family) {
    case 0: *v0 = *v1 = 0; break; /* at rest */
    case 1: break; /* moving ends */
    case 2: *h = copysign(random_between(0, 0.9), *v0) * fabs(way_to_stop(jm, am, *v0)), *v1 = 0; break; /* too near to stop */
    case 3: *h = 0; break; /* to where it is */
    case 4: *h = way_to_stop(jm, am, *v0), *v1 = 0; break; /* at the way to stop, up to rounding */
    default: *v1 = *v0, *h *= 1e-3; break; /* a small step at full speed */
    }
}

static void print_reals(a_float const *value, a_size count) {
    for (a_size i = 0; i != count; ++i) {
        unsigned char bytes[sizeof(a_float)];
        memcpy(bytes, value + i, sizeof(bytes));
        putchar(',');
        for (a_size k = sizeof(bytes); k--;) { printf("%02x", bytes[k]); }
    }
}

static void print_profiles(int bell) {
    puts(bell ? "case,jm,am,vm,p0,p1,v0,v1,duration,t,tv,ta,td,taj,tdj,p0,p1,v0,v1,vm,jm,am,dm"
              : "case,vm,ac,de,p0,p1,v0,v1,duration,t,p0,p1,v0,v1,vc,ta,td,pa,pd,ac,de");
    for (unsigned move = 0; move != MOVES; ++move) {
        double const jm = random_between(10, 50), am = random_between(4, 12), vm = random_between(2, 6);
        double const p0 = random_between(-5, 5);
        double h, v0, v1;
        /* Four moves in a row are of one family, so a board with room for every ninth move meets each family too. */
        ends(move / 4 % FAMILIES, bell ? jm : INFINITY, am, vm, &h, &v0, &v1);
        double const arguments[2][7] = {{vm, 0.5 * jm, -am, p0, p0 + h, v0, v1}, {jm, am, vm, p0, p0 + h, v0, v1}};
        a_float a[7];
        for (int i = 0; i != 7; ++i) { a[i] = (a_float)arguments[bell][i]; }
        a_trajbell b;
        a_trajtrap c;
        a_float const t = bell ? atraj_bell_gen(&b, a[0], a[1], a[2], a[3], a[4], a[5], a[6])
                               : atraj_trap_gen(&c, a[0], a[1], a[2], a[3], a[4], a[5], a[6]);
        printf("%u", move);
        print_reals(a, 7);
        print_reals(&t, 1);
        print_reals(bell ? (a_float *)&b : (a_float *)&c, (bell ? sizeof(b) : sizeof(c)) / sizeof(a_float));
        putchar('\n');
    }
}

/* The families of problems for atraj/move.h. Each one has what the families before it have, where the text does not say otherwise. */
enum {
    AT_REST,
    MOVING,
    ACCELERATED_START,
    ACCELERATED_TARGET,
    ASYMMETRIC_VELOCITY,     /* the other limits are the same in both directions */
    ASYMMETRIC_ACCELERATION,
    ASYMMETRIC_JERK,
    OUTSIDE,                 /* often starts outside the limits; all limits are asymmetric from here on */
    REACHES,
    STOPS,
    MEETS,                   /* the target does not accelerate */
    STAYS_INSIDE,            /* between two positions, or refused */
    TRACKS,                  /* the signal is near the axis */
    KINDS
};
enum { PROBLEMS = 20 * KINDS };

/* A lower limit, which is nearer to 0 than the upper one if it is asymmetric. */
static double below(double upper, int asymmetric) {
    double const part = random_between(0.3, 1);
    return asymmetric ? -part * upper : -upper;
}

/* A state of which nothing leaves the limits: the velocity keeps room for the acceleration to come from 0 and to go back to 0. */
static atraj_state inside(atraj_limits const *l, int accelerated) {
    double const j = fmin(l->jmax, -l->jmin), a = fmin(l->amax, -l->amin), v = fmin(l->vmax, -l->vmin);
    double const acceleration = accelerated * random_between(-0.9, 0.9) * fmin(a, sqrt(j * v));
    double const room = 1.001 * acceleration * acceleration / (2 * j);
    atraj_state state;
    state.p = (a_float)random_between(-5, 5);
    state.v = (a_float)random_between(l->vmin + room, l->vmax - room);
    state.a = (a_float)acceleration;
    return state;
}

static problem problem_of(unsigned kind) {
    static unsigned const functions[KINDS] = {
        [REACHES] = REACH, [STOPS] = STOP, [MEETS] = MEET, [STAYS_INSIDE] = WITHIN, [TRACKS] = TRACK, /* else PLAN */
    };
    problem q;
    int const any = kind >= OUTSIDE;
    double const jm = random_between(10, 50), am = random_between(4, 12), vm = random_between(2, 6);
    atraj_limits_init(&q.limits, (a_float)jm, (a_float)am, (a_float)vm);
    q.limits.vmin = (a_float)below(vm, any || kind == ASYMMETRIC_VELOCITY);
    q.limits.amin = (a_float)below(am, any || kind == ASYMMETRIC_ACCELERATION);
    q.limits.jmin = (a_float)below(jm, any || kind == ASYMMETRIC_JERK);
    q.from = inside(&q.limits, kind >= ACCELERATED_START);
    q.to = inside(&q.limits, kind >= ACCELERATED_TARGET && kind != MEETS);
    q.to.p = q.from.p + (a_float)(random_between(-1, 1) * random_between(0, 15));
    if (kind == AT_REST) { q.from.v = q.to.v = 0; }
    if (kind == TRACKS) {
        q.to = q.from;
        q.to.p += (a_float)random_between(-0.01, 0.01);
        q.to.v += (a_float)random_between(-0.05, 0.05);
    } else if (any) {
        q.from.v *= (a_float)1.6, q.from.a *= (a_float)1.8;
    }
    q.function = functions[kind];
    return q;
}

/* The problem, what the planner returned, the duration, the number of phases, the lowest state and the highest one. */
static void print_move(unsigned number, problem const *q, int returned, atraj_move const *m) {
    a_float const function = (a_float)q->function, result[] = {(a_float)returned, m->t, (a_float)m->phases};
    atraj_state extremes[2];
    atraj_move_extremes(m, &extremes[0], &extremes[1]);
    printf("%u", number);
    print_reals(&function, 1);
    print_reals((a_float const *)&q->limits, 6);
    print_reals((a_float const *)&q->from, 3);
    print_reals((a_float const *)&q->to, 3);
    print_reals(result, 3);
    print_reals((a_float const *)extremes, 6);
    putchar('\n');
}

/* The phase behind the last one too. */
static void print_phases(unsigned number, atraj_move const *m) {
    for (unsigned i = 0; i <= m->phases; ++i) {
        printf("%u", number);
        print_reals((a_float const *)&m->phase[i], 6);
        putchar('\n');
    }
}

/* Evaluates a move at some times, some of them before the start and after the end. */
static void print_evaluations(unsigned number, atraj_move const *m) {
    for (int i = 0; i != 5; ++i) {
        a_float const x = (a_float)random_between(-0.1, 1.1) * m->t, p = atraj_move_pos(m, x);
        a_float const row[] = {x, p, atraj_move_vel(m, x), atraj_move_acc(m, x), atraj_move_jer(m, x), atraj_move_time_at(m, p)};
        printf("%u", number);
        print_reals(row, 6);
        putchar('\n');
    }
}

static void print_machine(unsigned number, problem const *q, atraj_move const *m) {
    a_float results[MACHINE];
    run_machine(number, q, m, results);
    printf("%u", number);
    print_reals(results, MACHINE);
    putchar('\n');
}

/* Every table plans the same moves, because evaluations draw random numbers after all problems. */
static void print_moves(char const *table) {
    static problem problems[PROBLEMS];
    for (unsigned i = 0; i != PROBLEMS; ++i) { problems[i] = problem_of(i / 4 % KINDS); }
    puts(!strcmp(table, "machine") ? "case,returned,steps,line,last,sum,p,v,a,p,v,a,p,v,a,p,v,a,returned,until,p,v,a,j,returned,until"
         : !strcmp(table, "move") ? "case,function,vmax,vmin,amax,amin,jmax,jmin,p0,v0,a0,p1,v1,a1,returned,t,phases,"
                                  "lowest p,lowest v,lowest a,highest p,highest v,highest a"
         : !strcmp(table, "phase") ? "case,t,duration,p,v,a,j" : "case,x,pos,vel,acc,jer,time_at");
    for (unsigned i = 0; i != PROBLEMS; ++i) {
        atraj_move m = {0};
        int const returned = solve(&problems[i], &m);
        if (!strcmp(table, "move")) {
            print_move(i, &problems[i], returned, &m);
        } else if (!strcmp(table, "machine")) {
            print_machine(i, &problems[i], &m);
        } else if (!strcmp(table, "phase")) {
            print_phases(i, &m);
        } else {
            print_evaluations(i, &m);
        }
    }
}

enum { PAIRS = 28, SETS = PAIRS + 14 };

/* Axes that move together, some of them for a given duration and on a clock. Of each pair of sets, one lies on a straight line. The last sets
 * stay between two positions. */
static axes_problem axes_of(unsigned number) {
    static unsigned const kinds[] = {AT_REST, MOVING, ACCELERATED_TARGET, OUTSIDE};
    axes_problem q;
    problem const lead = problem_of(kinds[number / 2 % 4]);
    q.function = number >= PAIRS ? SYNC_WITHIN : number % 2 ? LINE : SYNC;
    q.duration = number % 3 ? 0 : (a_float)random_between(1, 20);
    q.cycle = number % 4 < 2 ? 0 : (a_float)0.001;
    for (int i = 0; i != AXES; ++i) {
        problem axis = i ? problem_of(kinds[number / 2 % 4]) : lead;
        a_float const part = i == 0 ? 1 : i == 1 ? (a_float)-0.5 : (a_float)0.25;
        if (q.function == LINE) {
            axis = lead;
            axis.from.v *= part, axis.from.a *= part, axis.to.v *= part, axis.to.a *= part;
            axis.from.p = i ? 0 : lead.from.p;
            axis.to.p = axis.from.p + part * (lead.to.p - lead.from.p);
        }
        q.limits[i] = axis.limits, q.from[i] = axis.from, q.to[i] = axis.to;
    }
    return q;
}

/* The problem, what the planner returned, the duration, the number of phases. */
static void print_axes(unsigned number, axes_problem const *q, int returned, atraj_move const *axes) {
    a_float const times[] = {(a_float)q->function, q->duration, q->cycle};
    printf("%u", number);
    print_reals(times, 3);
    for (int i = 0; i != AXES; ++i) {
        print_reals((a_float const *)&q->limits[i], 6);
        print_reals((a_float const *)&q->from[i], 3);
        print_reals((a_float const *)&q->to[i], 3);
    }
    a_float const result[] = {(a_float)returned, axes->t};
    print_reals(result, 2);
    putchar('\n');
}

static void print_sets(int phases) {
    printf(phases ? "case,t,duration,p,v,a,j\n" : "case,function,duration,cycle");
    for (int i = 0; !phases && i != AXES; ++i) { printf(",vmax,vmin,amax,amin,jmax,jmin,p0,v0,a0,p1,v1,a1"); }
    if (!phases) { puts(",returned,t"); }
    for (unsigned number = 0; number != SETS; ++number) {
        static atraj_move axes[AXES];
        axes_problem const q = axes_of(number);
        memset(axes, 0, sizeof(axes)); /* a refused set writes no axis */
        int const returned = solve_axes(&q, axes);
        if (!phases) { print_axes(number, &q, returned, axes); }
        for (int i = 0; phases && i != AXES; ++i) { print_phases(number, &axes[i]); }
    }
}

/* What the planner and the window answer, and every number of both plans. */
static void print_paths(void) {
    static path_problem q;
    printf("case,returned");
    for (int i = 0; i != SECTIONS; ++i) { printf(",duration"); }
    for (int i = 0; i != (SECTIONS + 1) * AXES; ++i) { printf(",p,v,a"); }
    printf(",returned");
    for (int i = 0; i != WINDOW; ++i) { printf(",duration"); }
    for (int i = 0; i != (WINDOW + 1) * AXES; ++i) { printf(",p,v,a"); }
    putchar('\n');
    for (unsigned number = 0; number != PATHS; ++number) {
        printf("%u", number);
        pose_path(&q, number);
        a_float returned = (a_float)plan_path(&q);
        print_reals(&returned, 1);
        print_reals(q.durations, SECTIONS);
        print_reals((a_float const *)q.states, 3 * (SECTIONS + 1) * AXES);
        move_window(&q, number);
        returned = (a_float)improve_path(&q);
        print_reals(&returned, 1);
        print_reals(q.durations, WINDOW);
        print_reals((a_float const *)q.states, 3 * (WINDOW + 1) * AXES);
        putchar('\n');
    }
}

int main(int argc, char *argv[]) {
    if (argc != 2) { return 1; }
    if (!strcmp(argv[1], "bell") || !strcmp(argv[1], "trap")) {
        print_profiles(*argv[1] == 'b');
    } else if (!strcmp(argv[1], "axes") || !strcmp(argv[1], "stretched")) {
        print_sets(*argv[1] == 's');
    } else if (!strcmp(argv[1], "path")) {
        print_paths();
    } else {
        print_moves(argv[1]);
    }
    return 0;
}
