//! Faults planted into ours, each as small as a fault can be. They show whether the comparison, or the judge, sees a fault.

use crate::judge::{Fastest, Fields, Planner};
use support::profiles::{bell, bell_fields, trap};
use support::{Family, Implementation, Ours, Real};

/// Ours with one fault.
#[derive(Clone, Copy, Debug)]
pub enum Fault {
    /// The bell's duration adds its operands in another order: `ta + (tv + td)`.
    OperandOrder,
    /// The bell's position multiplies by 1/6 instead of dividing by 6, in the first phase alone.
    ProductWithSixth,
    /// A cubic's position multiplies and adds in one rounding.
    FusedMultiplyAdd,
    /// The trapezoid's acceleration phase ends with `x <= ta` instead of `x < ta`.
    LessOrEqual,
}

impl Fault {
    /// Every fault.
    pub const ALL: [Self; 4] = [
        Self::OperandOrder,
        Self::ProductWithSixth,
        Self::FusedMultiplyAdd,
        Self::LessOrEqual,
    ];
}

impl<R: Real> Implementation<R> for Fault {
    fn plan(&self, family: Family, arguments: &[R], fields: &mut [R]) -> R {
        let duration = Ours.plan(family, arguments, fields);
        match (self, family) {
            (Self::OperandOrder, Family::Bell) => {
                let mut bell = bell(fields);
                if duration > R::of(0.0) {
                    bell.t = bell.ta + (bell.tv + bell.td);
                }
                fields.copy_from_slice(&bell_fields(&bell));
                bell.t
            }
            _ => duration,
        }
    }

    fn evaluate(&self, family: Family, fields: &[R], x: R) -> [R; 4] {
        let zero = R::of(0.0);
        let [mut position, velocity, mut acceleration, jerk] = Ours.evaluate(family, fields, x);
        match (self, family, fields) {
            (Self::ProductWithSixth, Family::Bell, _) => {
                let b = bell(fields);
                if b.p0 <= b.p1 && zero < x && x < b.taj && x < b.ta {
                    let sixth = R::of(1.0) / R::of(6.0);
                    position = b.p0 + b.v0 * x + b.jm * x * x * x * sixth;
                }
            }
            (Self::FusedMultiplyAdd, Family::Poly3, &[c0, c1, c2, c3, ..]) => {
                position = c3.fused(x, c2).fused(x, c1).fused(x, c0);
            }
            (Self::LessOrEqual, Family::Trap, _) => {
                let trap = trap(fields);
                if x == trap.ta && x >= zero {
                    acceleration = trap.ac;
                }
            }
            _ => {}
        }
        [position, velocity, acceleration, jerk]
    }
}

/// The planner of the fastest moves with one fault.
#[derive(Clone, Copy, Debug)]
pub enum PlanFault {
    /// It refuses a move without displacement.
    Refuses,
    /// The ramps go to the wrong side.
    WrongDirection,
    /// A correct motion within limits that are a little too low.
    Lengthened,
    /// The duration alone is a little too short.
    Shortened,
    /// The acceleration is a little above its limit.
    AboveTheLimit,
    /// The move ends 100 roundings beside the target.
    EndOff,
    /// The move jumps 100 roundings on its way to the target.
    Jump,
    /// A move towards smaller positions takes a rounding longer.
    Direction,
}

impl PlanFault {
    /// Every fault.
    pub const ALL: [Self; 8] = [
        Self::Refuses,
        Self::WrongDirection,
        Self::Lengthened,
        Self::Shortened,
        Self::AboveTheLimit,
        Self::EndOff,
        Self::Jump,
        Self::Direction,
    ];

    /// The arguments that the planner gets.
    fn change_arguments<R: Real>(self, family: Family, arguments: &mut [R; 7]) {
        let limits = match family {
            Family::Bell => &mut arguments[1..2],
            _ => &mut arguments[1..3],
        };
        match self {
            // Durations grow by a few times what the judge tolerates.
            Self::Lengthened => {
                let less = R::of(1.0 - if size_of::<R>() == 8 { 4e-8 } else { 4e-4 });
                arguments[..3].iter_mut().for_each(|x| *x = *x * less);
            }
            Self::AboveTheLimit => {
                let more = R::of(1.0 + if size_of::<R>() == 8 { 1e-9 } else { 1e-5 });
                limits.iter_mut().for_each(|x| *x = *x * more);
            }
            _ => {}
        }
    }

    /// What becomes of a correct plan.
    fn change_plan<R: Real>(self, family: Family, fields: &mut Fields<R>) {
        // `first` is where a part of the move begins that is not measured from its end.
        let (p0, p1, speed, directed, first) = match family {
            Family::Bell => (6, 7, 10, 10..14, 6),
            _ => (1, 2, 5, 10..12, 9),
        };
        let duration = fields[0];
        let way = fields[p0].widen().abs() + fields[p1].widen().abs();
        let scale = way + fields[speed].widen().abs() * duration.widen();
        let off = R::of(100.0 * R::MACHINE_EPSILON.widen() * scale);
        match self {
            Self::WrongDirection => fields[directed].iter_mut().for_each(|x| *x = -*x),
            Self::Shortened => {
                let less = R::of(1.0 - if size_of::<R>() == 8 { 1e-8 } else { 1e-4 });
                fields[0] = duration * less;
            }
            Self::EndOff => fields[p1] = fields[p1] + off,
            Self::Jump => fields[first] = fields[first] + off,
            Self::Direction if fields[p0] > fields[p1] => fields[0] = duration.neighbour(1),
            _ => {}
        }
    }
}

impl<R: Real> Planner<R> for PlanFault {
    fn plan(&self, family: Family, arguments: &[R; 7]) -> Option<Fields<R>> {
        let mut changed = *arguments;
        self.change_arguments(family, &mut changed);
        let [_, _, _, p0, p1, ..] = changed;
        if matches!(self, Self::Refuses) && p0 == p1 {
            return None;
        }
        let mut fields = Fastest.plan(family, &changed)?;
        self.change_plan(family, &mut fields);
        Some(fields)
    }
}
