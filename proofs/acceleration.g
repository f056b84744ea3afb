# The acceleration, in units of its scale: |a| + |z j|, or the scale of the check.
#
# source: src/online/phase.rs
#   pub(crate) fn acceleration(&self, z: R) -> R {
#   self.acceleration + z * self.jerk
#   }

u = UNIT;
w = TINIER;

# J is the exact term z j, and Y the exact sum with a. J1 and X are the same in the order of the code.
# Each r is one rounding, from -1 to 1. Each h is an underflow in units of TINIER. rz is the rounding of the time in the phase.
A = Y - J;
J1 = J * (1 + u * rz) * (1 + u * r1) + w * h1;
X = (A + J1) * (1 + u * r2) + w * h2;
error = X - Y;

{
    J in [-1.0001, 1.0001] /\ Y in [-1.0001, 1.0001] /\ r1 in [-1, 1] /\ r2 in [-1, 1] /\ rz in [-1, 1]
    /\ h1 in [-1, 1] /\ h2 in [-1, 1]
    ->
    |error / EPSILON| <= 1.51 # k acceleration from the exact one | |a| + |z j|
}

J1 - J -> J * (u * rz * (1 + u * r1) + u * r1) + w * h1;
error -> (J1 - J) + (Y + (J1 - J)) * (u * r2) + w * h2;
