//! Faults planted into ours, each as small as a fault can be. They show whether the comparison sees a fault.

use support::profiles::{bell, bell_fields, trap};
use support::{Family, Implementation, Ours, Real};

listed! {
    pub enum Fault {
        OperandOrder, // the bell's duration adds its operands in another order: `ta + (tv + td)`
        ProductWithSixth, // the bell's position multiplies by 1/6 instead of dividing by 6, in the first phase alone
        FusedMultiplyAdd, // a cubic's position multiplies and adds in one rounding
        LessOrEqual, // the trapezoid's acceleration phase ends with `x <= ta` instead of `x < ta`
    }
}

impl<R: Real> Implementation<R> for Fault {
    fn plan(&self, family: Family, arguments: &[R], fields: &mut [R]) -> R {
        let duration = Ours.plan(family, arguments, fields);
        match (self, family) {
            (Self::OperandOrder, Family::Bell) => {
                let mut bell = bell(fields);
                if duration > R::ZERO {
                    bell.t = bell.ta + (bell.tv + bell.td);
                }
                fields.copy_from_slice(&bell_fields(&bell));
                bell.t
            }
            _ => duration,
        }
    }

    fn evaluate(&self, family: Family, fields: &[R], x: R) -> [R; 4] {
        let [mut position, velocity, mut acceleration, jerk] = Ours.evaluate(family, fields, x);
        match (self, family, fields) {
            (Self::ProductWithSixth, Family::Bell, _) => {
                let b = bell(fields);
                if b.p0 <= b.p1 && R::ZERO < x && x < b.taj && x < b.ta {
                    position = b.p0 + b.v0 * x + b.jm * x * x * x * (R::ONE / R::of(6.0));
                }
            }
            (Self::FusedMultiplyAdd, Family::Poly3, &[c0, c1, c2, c3, ..]) => {
                position = c3.fused(x, c2).fused(x, c1).fused(x, c0);
            }
            (Self::LessOrEqual, Family::Trap, _) => {
                let trap = trap(fields);
                if x == trap.ta && x >= R::ZERO {
                    acceleration = trap.a0;
                }
            }
            _ => {}
        }
        [position, velocity, acceleration, jerk]
    }
}
