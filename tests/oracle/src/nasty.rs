//! Nasty problems for the planners of the fastest moves, in kinds. The same seed gives the same problems.

use crate::referee::Motion;
use atraj::{Bell, Boundary, Trap};
use support::{Family, Random, Real};

/// What is nasty about a problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// At rest at both ends.
    Rest,
    /// Velocities at both ends, in any direction.
    Moving,
    /// The target is the start.
    NoDisplacement,
    /// The target is the end of the direct ramp, or a few representable numbers beside it.
    StoppingDistance,
    /// Both velocities are at the limit.
    FullVelocity,
    /// Both velocities are equal.
    EqualVelocities,
    /// The velocities are opposite.
    OppositeVelocities,
    /// A velocity is far beyond the limit, to which it is limited.
    BeyondTheLimit,
    /// The acceleration never reaches its limit.
    NoHold,
    /// The jerk is huge against the acceleration.
    HugeJerk,
    /// The jerk has no limit.
    InfiniteJerk,
    /// The acceleration has no limit. A trapezoid's acceleration is huge.
    InfiniteAcceleration,
    /// The velocity has no limit.
    InfiniteVelocity,
    /// Lengths and times of any size.
    ExtremeScale,
    /// A position far from 0.
    Offset,
    /// Every argument has a magnitude of its own.
    TinyAgainstLarge,
    /// Equal high velocities, a short way, weak limits.
    WeakLimits,
    /// The displacement just lets the move cruise, or just does not.
    BorderOfCruise,
    /// A change of velocity just reaches the limit of the acceleration, or just does not.
    BorderOfHold,
    /// A tiny displacement between low velocities.
    Tiny,
    /// The rest of a planned move, from one of its states.
    Remainder,
}

impl Kind {
    /// Every kind.
    pub const ALL: [Self; 21] = [
        Self::Rest,
        Self::Moving,
        Self::NoDisplacement,
        Self::StoppingDistance,
        Self::FullVelocity,
        Self::EqualVelocities,
        Self::OppositeVelocities,
        Self::BeyondTheLimit,
        Self::NoHold,
        Self::HugeJerk,
        Self::InfiniteJerk,
        Self::InfiniteAcceleration,
        Self::InfiniteVelocity,
        Self::ExtremeScale,
        Self::Offset,
        Self::TinyAgainstLarge,
        Self::WeakLimits,
        Self::BorderOfCruise,
        Self::BorderOfHold,
        Self::Tiny,
        Self::Remainder,
    ];
}

/// A move to plan.
#[derive(Clone, Copy, Debug)]
pub struct Problem<R> {
    /// What is nasty about it.
    pub kind: Kind,
    /// The bell or the trapezoid.
    pub family: Family,
    /// Arguments of the family's `gen`.
    pub arguments: [R; 7],
}

/// A problem before it is rounded.
struct Draft {
    jerk: f64,
    rise: f64,
    fall: f64,
    vm: f64,
    p0: f64,
    h: f64,
    v0: f64,
    v1: f64,
}

/// An endless sequence of problems. The kinds take turns, a bell and a trapezoid of each.
pub struct Problems<R> {
    random: Random,
    turn: usize,
    real: std::marker::PhantomData<R>,
}

impl<R: Real> Problems<R> {
    /// The sequence that belongs to `seed`.
    pub fn new(seed: u64) -> Self {
        Self {
            random: Random::seeded(seed),
            turn: 0,
            real: std::marker::PhantomData,
        }
    }

    /// Half as many decimal digits as the real type has, more or less.
    fn wide() -> f64 {
        if size_of::<R>() == 8 { 12.0 } else { 6.0 }
    }

    fn problem(&mut self, kind: Kind, family: Family) -> Problem<R> {
        let mut draft = self.ordinary();
        self.make_nasty(kind, &mut draft);
        let mut arguments = self.round(family, &draft);
        match kind {
            Kind::StoppingDistance => arguments = self.aimed(family, arguments, direct),
            Kind::BorderOfCruise => arguments = self.aimed(family, arguments, by_way_of_vm),
            Kind::Remainder => self.remainder(family, &mut arguments),
            _ => {}
        }
        Problem {
            kind,
            family,
            arguments,
        }
    }

    fn ordinary(&mut self) -> Draft {
        let random = &mut self.random;
        let vm = random.magnitude(-2.0, 2.0);
        let mut velocity = || {
            let v = vm * random.between(-1.0, 1.0);
            if random.one_in(4) { 0.0 } else { v }
        };
        let (v0, v1) = (velocity(), velocity());
        Draft {
            jerk: random.magnitude(-2.0, 3.0),
            rise: random.magnitude(-2.0, 2.0),
            fall: random.magnitude(-2.0, 2.0),
            vm,
            p0: random.between(-10.0, 10.0),
            h: random.sign() * random.magnitude(-3.0, 3.0),
            v0,
            v1,
        }
    }

    fn make_nasty(&mut self, kind: Kind, draft: &mut Draft) {
        let wide = Self::wide();
        let random = &mut self.random;
        match kind {
            Kind::Rest => (draft.v0, draft.v1) = (0.0, 0.0),
            Kind::NoDisplacement => draft.h = 0.0,
            Kind::FullVelocity => {
                draft.v0 = random.sign() * draft.vm;
                draft.v1 = random.sign() * draft.vm;
            }
            Kind::EqualVelocities => draft.v1 = draft.v0,
            Kind::OppositeVelocities => draft.v1 = -draft.v0,
            Kind::BeyondTheLimit => draft.v0 *= random.magnitude(0.0, wide),
            Kind::NoHold => {
                let many = random.magnitude(2.0, wide / 2.0);
                (draft.rise, draft.fall) = (draft.rise * many, draft.fall * many);
            }
            Kind::HugeJerk => draft.jerk = random.magnitude(3.0, wide),
            Kind::InfiniteJerk => draft.jerk = f64::INFINITY,
            Kind::InfiniteAcceleration => (draft.rise, draft.fall) = (f64::INFINITY, f64::INFINITY),
            Kind::InfiniteVelocity => draft.vm = f64::INFINITY,
            Kind::ExtremeScale => {
                let length = random.magnitude(-wide, wide);
                let time = if random.one_in(2) {
                    random.magnitude(-wide / 3.0, wide / 3.0)
                } else {
                    1.0
                };
                draft.scale(length, time);
            }
            Kind::Offset => draft.p0 *= 1e5 * random.between(0.5, 2.0),
            Kind::TinyAgainstLarge => {
                let mut own = || random.magnitude(-wide / 2.0, wide / 2.0);
                let Draft {
                    jerk,
                    rise,
                    fall,
                    vm,
                    p0,
                    h,
                    v0,
                    v1,
                } = draft;
                for x in [jerk, rise, fall, vm, p0, h, v0, v1] {
                    *x = own().copysign(*x);
                }
            }
            Kind::WeakLimits => {
                draft.vm = random.magnitude(1.0, 4.0);
                draft.v0 = random.sign() * draft.vm * random.between(0.5, 1.0);
                draft.v1 = draft.v0;
                draft.jerk = random.magnitude(-4.0, -1.0);
                draft.rise = random.magnitude(-4.0, -1.0);
                draft.fall = random.magnitude(-4.0, -1.0);
                draft.h = random.sign() * random.magnitude(-4.0, 1.0);
            }
            Kind::BorderOfHold => {
                let reached = draft.rise * draft.rise / draft.jerk;
                draft.vm = draft.vm.max(1.5 * reached);
                (draft.v0, draft.v1) = if random.one_in(2) {
                    (0.0, reached)
                } else {
                    (-reached, 0.0)
                };
            }
            Kind::Tiny => {
                let small = random.magnitude(-wide / 2.0, -1.0);
                draft.h *= small;
                draft.v0 *= small;
                draft.v1 *= random.pick(&[0.0, small, 1.0]);
            }
            Kind::Remainder if random.one_in(2) => draft.p0 *= 1e5,
            Kind::Moving | Kind::StoppingDistance | Kind::BorderOfCruise | Kind::Remainder => {}
        }
    }

    fn round(&mut self, family: Family, draft: &Draft) -> [R; 7] {
        let p0 = if self.random.one_in(4) { 0.0 } else { draft.p0 };
        let p1 = p0 + draft.h;
        let &Draft {
            jerk,
            rise,
            fall,
            vm,
            v0,
            v1,
            ..
        } = draft;
        match family {
            Family::Bell => [jerk, rise, vm, p0, p1, v0, v1].map(R::of),
            _ => {
                // The C library wants the acceleration before the deceleration of the direction.
                let [rise, fall] = [rise, fall].map(|x| if x.is_finite() { x } else { 1e6 });
                let [ac, de] = if p1 < p0 {
                    [-fall, rise]
                } else {
                    [rise, -fall]
                };
                [vm, ac, de, p0, p1, v0, v1].map(R::of)
            }
        }
    }

    /// The move with its target at this displacement, or a few representable numbers beside it.
    fn aimed(
        &mut self,
        family: Family,
        arguments: [R; 7],
        displacement: fn(Family, &[R; 7]) -> f64,
    ) -> [R; 7] {
        let [x, mut y, mut z, mut p0, _, v0, v1] = arguments;
        if self.random.one_in(2) {
            p0 = R::of(0.0);
        }
        let mut p1 = R::of(p0.widen() + displacement(family, &arguments));
        // The neighbours of 0 are too small to compute with.
        if p1 != R::of(0.0) {
            p1 = p1.neighbour(self.random.steps(4));
        }
        if family == Family::Trap && (p1 < p0) != (y < z) {
            (y, z) = (z, y);
        }
        [x, y, z, p0, p1, v0, v1]
    }

    /// Replaces the start by a state of the planned move: one without acceleration, or any state of a trapezoid.
    fn remainder(&mut self, family: Family, arguments: &mut [R; 7]) {
        let fraction = R::of(self.random.unit());
        let &mut [x, y, z, p0, p1, v0, v1] = arguments;
        let boundary = Boundary { p0, p1, v0, v1 };
        let start = match family {
            Family::Bell => Bell::fastest(x, y, z, boundary)
                .map(|bell| {
                    let x = bell.ta + fraction * bell.tv;
                    (bell.position(x), bell.velocity(x))
                })
                .ok(),
            _ => Trap::fastest(x, y, z, boundary)
                .map(|trap| {
                    let x = fraction * trap.t;
                    (trap.position(x), trap.velocity(x))
                })
                .ok(),
        };
        if let Some((p0, v0)) = start {
            (arguments[3], arguments[5]) = (p0, v0);
        }
    }
}

impl Draft {
    fn scale(&mut self, length: f64, time: f64) {
        self.jerk *= length / (time * time * time);
        self.rise *= length / (time * time);
        self.fall *= length / (time * time);
        for velocity in [&mut self.vm, &mut self.v0, &mut self.v1] {
            *velocity *= length / time;
        }
        self.p0 *= length;
        self.h *= length;
    }
}

/// The displacement of the direct ramp.
fn direct<R: Real>(family: Family, arguments: &[R; 7]) -> f64 {
    let motion = Motion::of(family, arguments);
    let [_, _, _, vm] = motion.limits;
    let [_, _, v0, v1] = motion.ends;
    ramp(&motion, v0.clamp(-vm, vm), v1.clamp(-vm, vm))
}

/// The displacement of both ramps by way of the highest velocity.
fn by_way_of_vm<R: Real>(family: Family, arguments: &[R; 7]) -> f64 {
    let motion = Motion::of(family, arguments);
    let [_, _, _, vm] = motion.limits;
    let [p0, p1, v0, v1] = motion.ends;
    let vm = if p1 < p0 { -vm } else { vm };
    ramp(&motion, v0, vm) + ramp(&motion, vm, v1)
}

fn ramp(motion: &Motion, from: f64, to: f64) -> f64 {
    let [jerk, rise, fall, _] = motion.limits;
    let limit = if to > from { rise } else { fall };
    let change = (to - from).abs();
    let duration = if change * jerk < limit * limit {
        2.0 * (change / jerk).sqrt()
    } else {
        limit / jerk + change / limit
    };
    0.5 * (from + to) * duration
}

impl<R: Real> Iterator for Problems<R> {
    type Item = Problem<R>;

    fn next(&mut self) -> Option<Problem<R>> {
        let kind = Kind::ALL[self.turn / 2 % Kind::ALL.len()];
        let family = [Family::Bell, Family::Trap][self.turn % 2];
        self.turn += 1;
        Some(self.problem(kind, family))
    }
}
