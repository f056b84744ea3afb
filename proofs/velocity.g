# The velocity, in units of its scale: |v| + |z a| + z²|j|/2, or the scale of the check.
#
# source: src/online/phase.rs
#   pub(crate) fn velocity(&self, z: R) -> R {
#   let Self { velocity, acceleration, jerk, .. } = *self;
#   velocity + z * (acceleration + R::HALF * z * jerk)
#   }

u = UNIT;
w = TINIER;

# The evaluation. J is the exact term z²j/2. Y1 and Y2 are it and what follows: z a and v. J1 … X2 are the same in the order of the code.
# Each r is one rounding, from -1 to 1. Each h is an underflow in units of TINIER. rz is the rounding of the time in the phase.
A = Y1 - J;
V = Y2 - Y1;
J1 = J * (1 + u * rz) * (1 + u * r1) + w * h1;
X1 = (A + J1) * (1 + u * r2) + w * h2;
Z1 = X1 * (1 + u * rz) * (1 + u * r3) + w * h3;
X2 = (V + Z1) * (1 + u * r4) + w * h4;
error = X2 - Y2;

{
    J in [-1.0001, 1.0001] /\ Y1 in [-1.0001, 1.0001] /\ Y2 in [-1.0001, 1.0001]
    /\ r1 in [-1, 1] /\ r2 in [-1, 1] /\ r3 in [-1, 1] /\ r4 in [-1, 1] /\ rz in [-1, 1]
    /\ h1 in [-1, 1] /\ h2 in [-1, 1] /\ h3 in [-1, 1] /\ h4 in [-1, 1]
    ->
    |error / EPSILON| <= 3.01 # k velocity from the exact one | |v| + |z a| + z²|j|/2
}

J1 - J -> J * (u * rz * (1 + u * r1) + u * r1) + w * h1;
X1 - Y1 -> (J1 - J) + (Y1 + (J1 - J)) * (u * r2) + w * h2;
Z1 - Y1 -> (X1 - Y1) + X1 * (u * rz * (1 + u * r3) + u * r3) + w * h3;
error -> (Z1 - Y1) + (Y2 + (Z1 - Y1)) * (u * r4) + w * h4;
