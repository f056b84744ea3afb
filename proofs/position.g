# The position, in units of its scale: |p| + |z v| + z²|a|/2 + |z|³|j|/6, or the scale of the check.
#
# source: src/online/phase.rs
#   pub(crate) fn position(&self, z: R) -> R {
#   let Self { position, velocity, acceleration, jerk, .. } = *self;
#   position + z * (velocity + z * (R::HALF * acceleration + z * jerk * R::SIXTH))
#   }
#
# J is the exact term z³j/6. Y1, Y2 and Y3 are it and what follows: z²a/2, z v and p. J1 … X3 are the same in the order of the code.
# Each r is one rounding, from -1 to 1. Each h is an underflow in units of TINIER. rz is the rounding of the time in the phase.
A = Y1 - J;
V = Y2 - Y1;
P = Y3 - Y2;
u = UNIT;
w = TINIER;

J1 = J * (1 + u * rz) * (1 + u * r1) + w * h1;
J2 = J1 * (1 + u * c) * (1 + u * r2) + w * h2;
X1 = (A + J2 + w * h3) * (1 + u * r3) + w * h4;
Z1 = X1 * (1 + u * rz) * (1 + u * r4) + w * h5;
X2 = (V + Z1) * (1 + u * r5) + w * h6;
Z2 = X2 * (1 + u * rz) * (1 + u * r6) + w * h7;
X3 = (P + Z2) * (1 + u * r7) + w * h8;
error = X3 - Y3;

{
    J in [-1.0001, 1.0001] /\ Y1 in [-1.0001, 1.0001] /\ Y2 in [-1.0001, 1.0001] /\ Y3 in [-1.0001, 1.0001]
    /\ c in [-0.5, 0.5] /\ r1 in [-1, 1] /\ r2 in [-1, 1] /\ r3 in [-1, 1] /\ r4 in [-1, 1] /\ r5 in [-1, 1] /\ r6 in [-1, 1]
    /\ r7 in [-1, 1] /\ rz in [-1, 1] /\ h1 in [-1, 1] /\ h2 in [-1, 1] /\ h3 in [-1, 1] /\ h4 in [-1, 1] /\ h5 in [-1, 1]
    /\ h6 in [-1, 1] /\ h7 in [-1, 1] /\ h8 in [-1, 1]
    ->
    |error / EPSILON| <= 5.26 # k position from the exact one | |p| + |z v| + z²|a|/2 + |z|³|j|/6
}

J1 - J -> J * (u * rz * (1 + u * r1) + u * r1) + w * h1;
J2 - J -> (J1 - J) + J1 * (u * c * (1 + u * r2) + u * r2) + w * h2;
X1 - Y1 -> (J2 - J) + w * h3 + (Y1 + (J2 - J) + w * h3) * (u * r3) + w * h4;
Z1 - Y1 -> (X1 - Y1) + X1 * (u * rz * (1 + u * r4) + u * r4) + w * h5;
X2 - Y2 -> (Z1 - Y1) + (Y2 + (Z1 - Y1)) * (u * r5) + w * h6;
Z2 - Y2 -> (X2 - Y2) + X2 * (u * rz * (1 + u * r6) + u * r6) + w * h7;
error -> (Z2 - Y2) + (Y3 + (Z2 - Y2)) * (u * r7) + w * h8;
