# One operation, and the constants. UNIT is half of EPSILON. NORMAL is twice the smallest normal number, and TINY the smallest number.
#
# source: src/real/primitives.rs
#   const SIXTH: Self = 1.0 / 6.0;
#   const HALF: Self = 0.5;
#   const ONE: Self = 1.0;
#   const EPSILON: Self = $R::EPSILON;
#   const DOUBT: Self = 64.0 * $R::EPSILON;

@rnd = float<FORMAT, ne>;
sixth = rnd(1 / 6);
s = rnd(number);
product = DOUBT * s;

{
    |m| in [NORMAL, HIGHEST] /\ n in [-NORMAL, NORMAL] /\ |s| in [LOW, HIGH]
    ->
    # A result that is not tiny has an error of half an EPSILON of itself.
    rnd(m) -/ m in [-UNIT, UNIT]
    # A tiny one has an error below the smallest number.
    /\ rnd(n) - n in [-TINY, TINY]
    # SIXTH is right up to a quarter of an EPSILON. position.g uses this.
    /\ (6 * sixth - 1) / EPSILON in [-0.25, 0.25]
    # DOUBT, and its product with a scale, are exact.
    /\ rnd(DOUBT) - DOUBT in [0, 0]
    /\ rnd(product) - product in [0, 0]
}
