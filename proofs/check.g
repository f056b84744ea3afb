# What the check allows, and what the state can be then. Each quantity is in units of its scale, times are in units of the duration T.

u = UNIT;

# A limit plus DOUBT of the scale, as the check rounds it. The scale is at least the limit, or nothing is beyond the limit.
over = (limit + DOUBT) * (1 + u * r1) - limit;

# The next phase begins at most DOUBT away from the end of this one.
jump = DOUBT * g1;

# The velocity turns at c = -a/j. The check looks at the rounded c. There the velocity is |j|/2 (error of c)² short of its extreme.
short = turn / 2 * (u * r2) * (u * r2) + TINIER * h;

# From the state to its polynomial, to the extreme or the end, to the velocity that the check computes there, to the limit.
velocity = EPSILON * (v1 + v2) + short + over;

# The jerk, in units of its limit.
jerk = (1 + DOUBT) * (1 + u * r3) - 1;

# A phase that lasts ends at s + d, which is rounded, and the next one begins at b, at most DOUBT away. The last time before b is at most an
# EPSILON before it. The time in the phase is this time minus s, rounded. So the phase is left early: it is cut.
b = until * (1 + u * r4) + DOUBT * g2;
cut = until - (b - EPSILON * g3) + elapsed * (u * r5);

step_of_position = EPSILON * (p1 + p2) + cut * g4 + jump;
step_of_velocity = EPSILON * (v1 + v2) + cut * g4 + jump;
step_of_acceleration = EPSILON * (a1 + a2) + cut * g4 + jump;

{
    # 1.0001 covers the roundings of a scale, which is a sum of at most 24 roundings, and of differences.
    limit in [-1.0001, 1.0001] /\ turn in [0, 1.0001] /\ until in [0, 1.0001] /\ elapsed in [0, 1.0001]
    /\ r1 in [-1, 1] /\ r2 in [-1, 1] /\ r3 in [-1, 1] /\ r4 in [-1, 1] /\ r5 in [-1, 1] /\ h in [-1, 1]
    /\ g1 in [-1.0001, 1.0001] /\ g2 in [-1.0001, 1.0001] /\ g3 in [0, 1.0001] /\ g4 in [-1.0001, 1.0001]
    # Errors of the evaluation. run.sh writes the k of position.g, velocity.g and acceleration.g here.
    /\ p1 in [-POSITION, POSITION] /\ p2 in [-POSITION, POSITION] /\ v1 in [-VELOCITY, VELOCITY] /\ v2 in [-VELOCITY, VELOCITY]
    /\ a1 in [-ACCELERATION, ACCELERATION] /\ a2 in [-ACCELERATION, ACCELERATION]
    ->
    velocity / EPSILON <= 70.6 # k velocity above its limit | S_v
    /\ over / EPSILON <= 64.6 # k acceleration above its limit | S_a
    /\ jerk / EPSILON <= 64.6 # k jerk above its limit | the limit
    /\ |step_of_position / EPSILON| <= 140.6 # k step of the position between phases | S_p
    /\ |step_of_velocity / EPSILON| <= 136.1 # k step of the velocity between phases | S_v + T S_a
    /\ |step_of_acceleration / EPSILON| <= 133.1 # k step of the acceleration between phases | S_a + T J
    /\ cut / EPSILON <= 66.1 # k a phase is left early | T
}

over -> DOUBT + (limit + DOUBT) * (u * r1);
jerk -> DOUBT + (1 + DOUBT) * (u * r3);
cut -> EPSILON * g3 + elapsed * (u * r5) - until * (u * r4) - DOUBT * g2;
