//! The few operations of a real type that are not the processor's own, against those of the standard library.

use atraj::Real;
use support::{Random, Real as _};

fn any<R: Real>(of_bits: fn(u64) -> R, special: &[R]) -> Vec<R> {
    let mut random = Random(1);
    let numbers = (0..200_000).map(|_| of_bits(random.bits()));
    special.iter().copied().chain(numbers).collect()
}

macro_rules! tests {
    ($R:ident, $of_bits:expr) => {
        mod $R {
            use super::*;

            const SPECIAL: [$R; 9] = [
                0.0,
                -0.0,
                1.0,
                -1.0,
                $R::MIN_POSITIVE / 4.0,
                -$R::MIN_POSITIVE / 4.0,
                $R::INFINITY,
                $R::NEG_INFINITY,
                $R::NAN,
            ];

            #[test]
            fn roots() {
                for x in any($of_bits, &SPECIAL) {
                    let root = Real::sqrt(x);
                    assert!(root.same(x.sqrt()), "sqrt({x:e}) = {root:e}");
                }
            }

            #[test]
            fn moves_are_turned_forward() {
                for p in any($of_bits, &SPECIAL) {
                    let [v0, v1] = [1.5, -0.0];
                    let turned = Real::forward(p, v0, v1);
                    let expected = if p < 0.0 { [-p, -v0, -v1] } else { [p, v0, v1] };
                    for (x, y) in turned.into_iter().zip(expected) {
                        assert!(x.same(y), "{p:e} makes {x:e} where {y:e} is due");
                    }
                }
            }
        }
    };
}

tests!(f32, |bits| f32::from_bits(bits as u32));
tests!(f64, f64::from_bits);
