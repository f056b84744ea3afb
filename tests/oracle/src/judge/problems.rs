//! Adversarial problems for every planner, in kinds. The same seed gives the same problems.

use super::solver::Motion;
use super::{Fastest, POWERS_OF_TIME, Planner, Problem, Request, beyond_legal, parts};
use atraj::State;
use support::{Family, Random, Real};

impl Kind {
    /// The kinds that a profile can have, which has no acceleration at its ends.
    #[rustfmt::skip]
    pub const OF_PROFILES: [Self; 23] = [
        Self::Rest, Self::Moving, Self::OutsideVelocity, Self::FarOutside, Self::InfiniteVelocity,
        Self::InfiniteAcceleration, Self::InfiniteJerk, Self::HugeJerk, Self::ExtremeScale,
        Self::NoDisplacement, Self::DirectTie, Self::BorderOfCruise, Self::BorderOfShape, Self::BorderOfHold,
        Self::FullVelocity, Self::OppositeVelocities, Self::EqualVelocities, Self::Tiny, Self::Offset,
        Self::TinyAgainstHuge, Self::NoHold, Self::WeakLimits, Self::Remainder,
    ];
}

listed! {
    pub enum Kind {
        Rest, // at rest at both ends
        Moving, // velocities at both ends, in any direction
        AcceleratedStart, // the start is accelerated
        AcceleratedTarget, // the target is accelerated
        Accelerated, // both ends are accelerated
        Asymmetric, // the limits of velocity, acceleration and jerk depend on the direction
        OutsideVelocity, // the velocity is outside at the start
        OutsideAcceleration, // the acceleration is outside at the start
        BoundToLeave, // the velocity is inside at the start, but the acceleration will bring it outside
        FarOutside, // the start is far outside
        ComingInside, // the start is outside, and its acceleration brings it inside
        InfiniteVelocity, // the velocity has no limit
        InfiniteAcceleration, // the acceleration has no limit
        OneInfiniteJerk, // the jerk has no limit in one direction
        InfiniteJerk, // the jerk has no limit
        HugeJerk, // the jerk is huge
        ExtremeScale, // lengths and times of any size
        NoDisplacement, // the target is the start
        DirectTie, // the target is the end of the direct ramp, or a few representable numbers off it
        BorderOfCruise, // the displacement just lets the axis cruise, or just does not
        BorderOfShape, // the displacement is where the motion gets another shape
        BorderOfHold, // the change of velocity just needs a hold, or just does not
        BorderOfGap, // the displacement is where the durations begin or end in which the target can not be reached
        Lens, // both accelerations point the same way, and the velocities let the axis ease in between
        Straight, // the acceleration goes straight from one end to the other
        RiseAndFall, // a part of the border rises, falls and rises again
        FullVelocity, // the velocities are at their limits
        OppositeVelocities, // the velocities are opposite
        EqualVelocities, // the velocities are equal, or nearly so
        EqualAccelerations, // the accelerations are equal, or nearly so
        FullAcceleration, // the accelerations are at their limits
        TinyAcceleration, // the accelerations are tiny
        /// The target is just what an axis can have reached. Its acceleration may carry the axis beyond a limit afterwards.
        TargetOnTheBoundary,
        Tiny, // a tiny displacement between low velocities
        Offset, // a position far from 0
        TinyAgainstHuge, // every number has a magnitude of its own
        NeverReached, // the limits are never reached
        WeakLimits, // equal high velocities, a short way, weak limits
        Remainder, // the rest of a planned move, from one of its states
        NextCycle, // the rest of a planned remainder, a short time later
        Reach, // a velocity and an acceleration are wanted, a position is not
        Stop, // a stop is wanted
        Meet, // the target moves on
        NoHold, // the limit of the acceleration is never reached, without acceleration at the ends
    }
}

/// A problem before it is rounded: highest and lowest velocity, acceleration and jerk; position, velocity and acceleration at both ends.
#[derive(Clone, Copy, Debug)]
#[rustfmt::skip]
struct Draft { vmax: f64, vmin: f64, amax: f64, amin: f64, jmax: f64, jmin: f64, p0: f64, v0: f64, a0: f64, p1: f64, v1: f64, a1: f64 }

pub struct Problems<R> {
    random: Random,
    turn: usize,
    of_profiles: bool,
    real: std::marker::PhantomData<R>,
}

impl<R: Real> Problems<R> {
    pub fn new(seed: u64) -> Self {
        Self { random: Random::seeded(seed), turn: 0, of_profiles: false, real: std::marker::PhantomData }
    }

    /// The sequence of problems without acceleration at their ends. Of each kind follow a double-S, a trapezoid and a `Move`.
    pub fn of_profiles(seed: u64) -> Self {
        Self { of_profiles: true, ..Self::new(seed) }
    }

    /// Half as many decimal digits as the real type has, more or less.
    fn wide() -> f64 {
        if size_of::<R>() == 8 { 12.0 } else { 6.0 }
    }

    pub fn of_kind(&mut self, kind: Kind) -> Problem<R> {
        let request = match kind {
            Kind::Reach => Request::Reach,
            Kind::Stop => Request::Stop,
            Kind::Meet => Request::Meet,
            _ => Request::Plan,
        };
        self.problem(kind, request)
    }

    fn problem(&mut self, kind: Kind, request: Request) -> Problem<R> {
        // A problem in which something is special is adversarial in another way too.
        let adversarial = match kind {
            Kind::Remainder if self.of_profiles => self.random.pick(&Kind::OF_PROFILES),
            Kind::Reach | Kind::Stop | Kind::Meet | Kind::Remainder | Kind::NextCycle => {
                Kind::ALL[self.random.below(Kind::NeverReached as usize)]
            }
            _ => kind,
        };
        let mut draft = self.ordinary();
        if self.of_profiles {
            draft.fit(request);
        }
        self.make_adversarial(adversarial, &mut draft);
        if self.of_profiles {
            draft.fit(request);
        }
        let is_boundary = adversarial == Kind::TargetOnTheBoundary;
        draft.make_target_legal(is_boundary.then_some(self.random.one_in(2)));
        match request {
            Request::Stop => (draft.v1, draft.a1) = (0.0, 0.0),
            Request::Meet => {
                draft.a1 = 0.0;
                draft.v1 *= 0.9;
            }
            _ => {}
        }
        let mut problem = Self::rounded(kind, request, draft);
        self.aim(adversarial, &mut problem);
        match kind {
            Kind::Remainder => self.advance(&mut problem, 1.0),
            Kind::NextCycle => {
                self.advance(&mut problem, 1.0);
                let cycle = self.random.magnitude(-6.0, -1.0);
                self.advance(&mut problem, cycle);
            }
            _ => {}
        }
        problem
    }

    fn ordinary(&mut self) -> Draft {
        let random = &mut self.random;
        let mut pair = |lo, hi, equal| {
            let high = random.magnitude(lo, hi);
            let low = if random.one_in(equal) { high * random.magnitude(-1.0, 1.0) } else { high };
            (high, -low)
        };
        let (vmax, vmin) = pair(-2.0, 2.0, 3);
        let (amax, amin) = pair(-2.0, 2.0, 3);
        let (jmax, jmin) = pair(-2.0, 3.0, 4);
        let p0 = if random.one_in(2) { 0.0 } else { random.between(-10.0, 10.0) };
        let [v0, a0] = [(vmin, vmax), (amin, amax)].map(|(low, high)| random.between(low, high));
        let p1 = p0 + random.sign() * random.magnitude(-3.0, 3.0);
        let [v1, a1] = [(vmin, vmax), (amin, amax)].map(|(low, high)| random.between(low, high));
        let mut draft = Draft { vmax, vmin, amax, amin, jmax, jmin, p0, v0, a0, p1, v1, a1 };
        for (x, of) in [(&mut draft.v0, 4), (&mut draft.v1, 3), (&mut draft.a0, 2), (&mut draft.a1, 2)] {
            if random.one_in(of) {
                *x = 0.0;
            }
        }
        draft.make_start_legal();
        draft
    }

    fn make_adversarial(&mut self, kind: Kind, draft: &mut Draft) {
        let wide = Self::wide();
        let random = &mut self.random;
        let Draft { vmax, vmin, amax, amin, jmax, jmin, .. } = *draft;
        match kind {
            Kind::Rest => draft.stop(),
            Kind::Moving => (draft.a0, draft.a1) = (0.0, 0.0),
            Kind::AcceleratedStart => draft.a1 = 0.0,
            Kind::AcceleratedTarget => draft.a0 = 0.0,
            Kind::Accelerated => draft.accelerate(random),
            Kind::Asymmetric => {
                for limit in draft.limits() {
                    *limit *= random.magnitude(-1.0, 1.0);
                }
                draft.make_start_legal();
            }
            Kind::OutsideVelocity => draft.v0 = (1.0 + random.magnitude(-3.0, 0.5)) * draft.velocity_limit(random),
            Kind::OutsideAcceleration => {
                draft.a0 = (1.0 + random.magnitude(-3.0, 0.5)) * draft.acceleration_limit(random);
            }
            Kind::BoundToLeave => {
                let (v, a, jerk) = if random.one_in(2) { (vmax, amax, -jmin) } else { (vmin, amin, jmax) };
                draft.a0 = a * random.between(0.0, 1.0);
                let sure = 0.5 * draft.a0 * draft.a0.abs() / jerk;
                draft.v0 = v - sure * random.between(0.0, 1.0);
            }
            Kind::FarOutside => {
                draft.v0 = random.sign() * draft.vmax * random.magnitude(0.0, wide / 3.0);
                draft.a0 = random.sign() * draft.amax * random.magnitude(-1.0, wide / 3.0);
            }
            Kind::ComingInside => {
                let (v, a, jerk) = if random.sign() > 0.0 { (vmax, amin, jmax) } else { (vmin, amax, jmin) };
                draft.a0 = a * random.between(0.0, 1.0);
                let at_zero_a = 0.5 * draft.a0 * draft.a0 / jerk;
                draft.v0 = v + at_zero_a * random.pick(&[0.0, 0.5, 1.0]);
            }
            Kind::InfiniteVelocity => make_infinite([&mut draft.vmax, &mut draft.vmin], random),
            Kind::InfiniteAcceleration => make_infinite([&mut draft.amax, &mut draft.amin], random),
            Kind::OneInfiniteJerk => {
                let [_, _, _, _, jmax, jmin] = draft.limits();
                *[jmax, jmin][random.pick(&[0, 1])] *= f64::INFINITY;
            }
            Kind::InfiniteJerk => {
                (draft.jmax, draft.jmin) = (f64::INFINITY, f64::NEG_INFINITY);
                if random.one_in(4) {
                    draft.vmax = f64::INFINITY;
                }
            }
            Kind::HugeJerk => (draft.jmax, draft.jmin) = (random.magnitude(3.0, wide), -random.magnitude(3.0, wide)),
            Kind::ExtremeScale => {
                let length = random.magnitude(-wide, wide);
                let time = if random.one_in(2) { random.magnitude(-wide / 3.0, wide / 3.0) } else { 1.0 };
                draft.scale(length, time);
            }
            Kind::NoDisplacement => draft.p1 = draft.p0,
            Kind::BorderOfHold => {
                // The jerk alone changes the velocity by this much within the limit of the acceleration.
                let both = 0.5 / draft.jmax - 0.5 / draft.jmin;
                let (up, down) = (draft.amax * draft.amax, -draft.amin * draft.amin);
                let reached = both * random.pick(&[up, down]);
                draft.vmax = draft.vmax.max(1.5 * reached.abs());
                draft.vmin = draft.vmin.min(-1.5 * reached.abs());
                (draft.a0, draft.a1) = (0.0, 0.0);
                (draft.v0, draft.v1) = if random.one_in(2) { (0.0, reached) } else { (-reached, 0.0) };
            }
            Kind::BorderOfGap | Kind::Lens => Self::open_lens(draft, random),
            Kind::Straight => {
                draft.accelerate(random);
                draft.v1 = draft.v0 + draft.straight();
            }
            Kind::RiseAndFall => {
                // A weak acceleration that keeps its sign, against low virtual velocities.
                Self::open_lens(draft, random);
                let weak = random.magnitude(-2.0, 0.0);
                draft.v0 = random.sign() * draft.vmax.min(-draft.vmin) * weak;
                draft.v1 = draft.v0 + draft.straight() * random.between(0.5, 1.5);
                draft.make_start_legal();
                draft.p1 = draft.p0 + random.sign() * random.magnitude(-5.0, 1.0);
            }
            Kind::FullVelocity => {
                (draft.v0, draft.v1) = (draft.velocity_limit(random), draft.velocity_limit(random));
                (draft.a0, draft.a1) = (0.0, 0.0);
            }
            Kind::OppositeVelocities => draft.v1 = -draft.v0,
            Kind::EqualVelocities => {
                draft.v1 = draft.v0 * random.pick(&[1.0, 1.0, 1.0 + 1e-6, 1.0 - 1e-6, 1.001]);
                if random.one_in(2) {
                    (draft.a0, draft.a1) = (0.0, 0.0);
                }
            }
            Kind::EqualAccelerations => {
                draft.a0 = random.between(draft.amin, draft.amax);
                draft.make_start_legal();
                draft.a1 = draft.a0 * random.pick(&[1.0, 1.0, 1.0 + 1e-6, 0.999]);
                if random.one_in(2) {
                    draft.v1 = draft.v0;
                }
            }
            Kind::FullAcceleration => {
                draft.a0 = draft.acceleration_limit(random);
                if random.one_in(2) {
                    draft.a1 = draft.acceleration_limit(random);
                }
                if random.one_in(2) {
                    draft.make_start_legal();
                }
            }
            Kind::TinyAcceleration => {
                draft.a1 = random.sign() * random.magnitude(-wide, -2.0);
                if random.one_in(2) {
                    draft.a0 = random.sign() * random.magnitude(-wide, -2.0);
                }
                draft.make_start_legal();
            }
            Kind::TargetOnTheBoundary => draft.a1 = random.between(draft.amin, draft.amax),
            Kind::Tiny => {
                let small = random.magnitude(-wide / 2.0, -1.0);
                draft.p1 = draft.p0 + (draft.p1 - draft.p0) * small;
                draft.v0 *= small;
                draft.a0 *= small;
                draft.v1 *= random.pick(&[0.0, small, 1.0]);
                draft.a1 *= random.pick(&[0.0, small, 1.0]);
            }
            Kind::Offset => {
                let offset = random.sign() * random.magnitude(5.0, 6.0);
                draft.p0 += offset;
                draft.p1 += offset;
            }
            Kind::TinyAgainstHuge => {
                let mut own = || random.magnitude(-wide / 2.0, wide / 2.0);
                for x in draft.all() {
                    *x = own().copysign(*x);
                }
            }
            Kind::NeverReached => {
                let many = random.magnitude(2.0, wide / 2.0);
                for limit in &mut draft.limits()[..4] {
                    **limit *= many;
                }
            }
            Kind::NoHold => {
                let many = random.magnitude(2.0, wide / 2.0);
                (draft.amax, draft.amin) = (many * draft.amax, many * draft.amin);
            }
            Kind::WeakLimits => {
                draft.vmax = random.magnitude(1.0, 4.0);
                draft.vmin = -draft.vmax;
                draft.v0 = random.sign() * draft.vmax * random.between(0.5, 1.0);
                draft.v1 = draft.v0;
                (draft.a0, draft.a1) = (0.0, 0.0);
                let [_, _, weak @ ..] = draft.limits();
                for limit in weak {
                    *limit = random.magnitude(-4.0, -1.0).copysign(*limit);
                }
                draft.p1 = draft.p0 + random.sign() * random.magnitude(-4.0, 1.0);
            }
            _ => {}
        }
    }

    /// Both accelerations point the same way, and the change of velocity is near the straight one.
    fn open_lens(draft: &mut Draft, random: &mut Random) {
        let limit = draft.acceleration_limit(random);
        draft.a0 = limit * random.between(0.0, 1.0);
        draft.a1 = limit * random.between(0.0, 1.0);
        if random.one_in(3) {
            draft.a1 = draft.a0;
        }
        draft.make_start_legal();
        let both = 0.5 / draft.jmax - 0.5 / draft.jmin;
        let least = draft.a0.abs().min(draft.a1.abs());
        // At 1 the gap is closed: the axis eases to no acceleration.
        let part = random.pick(&[0.0, 1e-9, 1e-3, 0.1, 0.5, 0.9, 1.0, 1.0 - 1e-9, 1.1]);
        draft.v1 = draft.v0 + draft.straight() + part * both * least * least.copysign(limit);
        draft.p1 = draft.p0 + random.magnitude(-3.0, 1.0) * random.sign();
    }

    /// Rounds a draft. The target stays legal: it is moved by a rounding or two.
    fn rounded(kind: Kind, request: Request, draft: Draft) -> Problem<R> {
        let mut problem = Problem::of(kind, request, draft.numbers().map(R::of));
        let limits = problem.limits;
        let to = &mut problem.to;
        let boundary = kind == Kind::TargetOnTheBoundary;
        for _ in 0..64 {
            let beyond = beyond_legal(&limits, *to);
            let of_velocity = 2.0 * R::MACHINE_EPSILON.widen() * limits.vmax.widen().min(-limits.vmin.widen());
            let rounding = if boundary { of_velocity } else { 0.0 };
            if beyond <= rounding {
                break;
            }
            // Towards the middle, where accelerations are legal.
            to.velocity = R::of(to.velocity.widen() * 0.999);
            to.acceleration = R::of(to.acceleration.widen() * 0.999);
        }
        if beyond_legal(&limits, *to) > R::MACHINE_EPSILON.widen() * to.velocity.widen().abs() {
            (to.velocity, to.acceleration) = (R::ZERO, R::ZERO);
        }
        problem
    }

    /// Puts the target where the motion changes, or a few representable numbers off it.
    fn aim(&mut self, kind: Kind, problem: &mut Problem<R>) {
        let motion = Motion::of(problem);
        let h = motion.target[0] - motion.start[0];
        let random = &mut self.random;
        let best_with_gap = || Some(motion.best()).filter(|best| !best.gap_ends.is_infinite());
        let displacement = match kind {
            Kind::DirectTie => h - motion.best().past_direct,
            Kind::BorderOfGap => {
                let Some(best) = best_with_gap() else { return };
                h - random.pick(&[best.past_begin, best.past_end, best.past_direct])
            }
            Kind::Lens if random.one_in(2) => {
                // Somewhere among the displacements that can be reached before the gap.
                let Some(best) = best_with_gap() else { return };
                let duration = random.between(best.direct, best.gap_begins);
                let Some([lowest, highest]) = motion.interval(duration) else { return };
                random.pick(&[lowest, highest, 0.5 * (lowest + highest)])
            }
            Kind::RiseAndFall if random.one_in(2) => {
                let duration = motion.best().direct * (1.0 + random.magnitude(-6.0, 0.5));
                let Some(interval) = motion.interval(duration) else { return };
                random.pick(&interval)
            }
            Kind::BorderOfShape | Kind::BorderOfCruise => {
                let knees = motion.knees(random.one_in(2));
                match (kind, knees.last()) {
                    (_, None) => return,
                    (Kind::BorderOfCruise, Some(&knee)) => knee,
                    _ => random.pick(&knees),
                }
            }
            _ => return,
        };
        if !displacement.is_finite() {
            return;
        }
        if random.one_in(2) {
            problem.from.position = R::ZERO;
        }
        let p1 = R::of(problem.from.position.widen() + displacement);
        // The neighbours of 0 are too small to compute with.
        let steps = if p1 == R::ZERO { 0 } else { random.steps(4) };
        problem.to.position = p1.neighbour(steps);
    }

    /// Replaces the start by a state of the planned move, within this fraction of its duration.
    fn advance(&mut self, problem: &mut Problem<R>, fraction: f64) {
        let Ok(plan) = Fastest.plan(problem) else { return };
        let part = fraction * self.random.unit();
        let x = match problem.request {
            // It starts without acceleration: in the cruise.
            Request::Bell => plan.planned.phase[3].start + R::of(part) * plan.planned.phase[3].duration,
            _ => R::of(plan.planned.t.widen() * part),
        };
        let [position, velocity, mut acceleration, _] = plan.state(x);
        if self.of_profiles {
            acceleration = R::ZERO;
        }
        let from = State { position, velocity, acceleration };
        if parts(from).iter().all(|x| x.widen().is_finite()) {
            problem.from = from;
        }
    }
}

fn make_infinite(limits: [&mut f64; 2], random: &mut Random) {
    let spared = random.pick(&[0, 1, 2]);
    for (index, limit) in limits.into_iter().enumerate() {
        if index != spared {
            *limit *= f64::INFINITY;
        }
    }
}

impl Draft {
    fn fit(&mut self, request: Request) {
        (self.a0, self.a1) = (0.0, 0.0);
        let Some(profile) = request.profile() else { return };
        let widen = |high: &mut f64, low: &mut f64| {
            *high = high.max(-*low);
            *low = -*high;
        };
        widen(&mut self.vmax, &mut self.vmin);
        widen(&mut self.jmax, &mut self.jmin);
        if profile == Family::Bell {
            widen(&mut self.amax, &mut self.amin);
        }
        for limit in [&mut self.amax, &mut self.amin] {
            // Velocities of a trapezoid would jump.
            if profile == Family::Trap && limit.is_infinite() {
                *limit = 1e6f64.copysign(*limit);
            }
        }
    }

    fn numbers(mut self) -> [f64; 12] {
        self.all().map(|x| *x)
    }

    fn all(&mut self) -> [&mut f64; 12] {
        let Self { vmax, vmin, amax, amin, jmax, jmin, p0, v0, a0, p1, v1, a1 } = self;
        [vmax, vmin, amax, amin, jmax, jmin, p0, v0, a0, p1, v1, a1]
    }

    fn limits(&mut self) -> [&mut f64; 6] {
        let [vmax, vmin, amax, amin, jmax, jmin, ..] = self.all();
        [vmax, vmin, amax, amin, jmax, jmin]
    }

    fn stop(&mut self) {
        (self.v0, self.a0, self.v1, self.a1) = (0.0, 0.0, 0.0, 0.0);
    }

    fn velocity_limit(&self, random: &mut Random) -> f64 {
        random.pick(&[self.vmax, self.vmin])
    }

    fn acceleration_limit(&self, random: &mut Random) -> f64 {
        random.pick(&[self.amax, self.amin])
    }

    fn accelerate(&mut self, random: &mut Random) {
        (self.a0, self.a1) = (random.between(self.amin, self.amax), random.between(self.amin, self.amax));
        self.make_start_legal();
    }

    fn straight(&self) -> f64 {
        let jerk = if self.a1 > self.a0 { self.jmax } else { self.jmin };
        0.5 * (self.a1 + self.a0) * (self.a1 - self.a0) / jerk
    }

    fn make_start_legal(&mut self) {
        self.a0 = self.a0.clamp(self.amin, self.amax);
        let jerk = if self.a0 > 0.0 { self.jmin } else { self.jmax };
        let most = 0.5 * (self.vmax - self.vmin) * jerk.abs();
        self.a0 = self.a0.clamp(-most.sqrt(), most.sqrt());
        let change = 0.5 * self.a0 * self.a0 / jerk;
        let low = if change > 0.0 { self.vmin + change } else { self.vmin };
        let high = if change < 0.0 { self.vmax + change } else { self.vmax };
        self.v0 = self.v0.max(low).min(high);
    }

    fn make_target_legal(&mut self, side: Option<bool>) {
        self.a1 = self.a1.clamp(self.amin, self.amax);
        let jerk = if self.a1 > 0.0 { self.jmax } else { -self.jmin };
        let most = (2.0 * (self.vmax - self.vmin) * jerk).sqrt();
        self.a1 = self.a1.clamp(-most, most);
        let built_up = 0.5 * self.a1 * self.a1.abs() / jerk;
        let low = (self.vmin + built_up.max(0.0)).min(self.vmax);
        let high = (self.vmax + built_up.min(0.0)).max(self.vmin);
        self.v1 = self.v1.max(low).min(high);
        if let (Some(side), true) = (side, low.is_finite() && high.is_finite()) {
            self.v1 = if side { high } else { low };
        }
    }

    fn scale(&mut self, length: f64, time: f64) {
        for (x, power) in self.all().into_iter().zip(POWERS_OF_TIME) {
            *x *= length / time.powi(power.into());
        }
    }
}

impl<R: Real> Iterator for Problems<R> {
    type Item = Problem<R>;

    fn next(&mut self) -> Option<Problem<R>> {
        let turn = self.turn;
        self.turn += 1;
        let kinds = &Kind::OF_PROFILES;
        Some(match [Request::Bell, Request::Trap, Request::Plan][turn % 3] {
            request if self.of_profiles => self.problem(kinds[turn / 3 % kinds.len()], request),
            _ => self.of_kind(Kind::ALL[turn % Kind::NoHold as usize]),
        })
    }
}
