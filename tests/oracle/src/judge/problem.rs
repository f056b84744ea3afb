//! A motion to plan, the same motion seen from elsewhere, and numbers as round as a fault allows.

use super::Kind;
use atraj::online::{Limits, State};
use std::fmt::{Display, Formatter, Result as Written};
use support::online::{limits_of, numbers_of};
use support::{Family, Real};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Request {
    Plan,  // the fastest motion to a state
    Reach, // the fastest motion to a velocity and an acceleration
    Stop,  // the fastest stop
    Meet,  // the fastest motion to a target that moves on
    Bell,  // the fastest double-S
    Trap,  // the fastest trapezoid
}

impl Request {
    pub fn profile(self) -> Option<Family> {
        match self {
            Self::Bell => Some(Family::Bell),
            Self::Trap => Some(Family::Trap),
            _ => None,
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Problem<R> {
    pub kind: Kind,        // what is adversarial about it
    pub request: Request,  // what is asked for
    pub limits: Limits<R>, // what the axis can do
    pub from: State<R>,    // the start
    pub to: State<R>,      // The target. Its position does not count if a velocity is asked for.
}

pub const POWERS_OF_TIME: [i8; 12] = [1, 1, 2, 2, 3, 3, 0, 1, 2, 0, 1, 2];

pub fn widened<R: Real>(limits: &Limits<R>) -> [f64; 6] {
    numbers_of(limits).map(R::widen)
}

/// How much faster a target is than one that can have been reached within the limits; not above 0 if it is legal. Its acceleration was built
/// up from 0. The velocities after the target do not count.
pub fn beyond_legal<R: Real>(limits: &Limits<R>, to: State<R>) -> f64 {
    let [vmax, vmin, amax, amin, jmax, jmin] = widened(limits);
    let [v, a] = [to.velocity, to.acceleration].map(R::widen);
    let before = v - 0.5 * a * a.abs() / if a > 0.0 { jmax } else { -jmin };
    if a > amax || a < amin { f64::INFINITY } else { (v.max(before) - vmax).max(vmin - v.min(before)) }
}

impl<R: Real> Problem<R> {
    /// The problem of these numbers: highest and lowest velocity, acceleration and jerk; position, velocity and acceleration at both ends. The limits
    /// of a double-S are the highest ones in both directions, a trapezoid has no limit of the jerk, and both have no acceleration at their ends.
    pub fn of(kind: Kind, request: Request, numbers: [R; 12]) -> Self {
        let [vmax, mut vmin, amax, mut amin, mut jmax, mut jmin, ends @ ..] = numbers;
        let [p0, v0, mut a0, p1, v1, mut a1] = ends;
        if let Some(profile) = request.profile() {
            vmin = -vmax;
            (a0, a1) = (R::ZERO, R::ZERO);
            if profile == Family::Bell {
                (amin, jmin) = (-amax, -jmax);
            } else {
                (jmax, jmin) = (R::INFINITY, -R::INFINITY);
            }
        }
        let state = |position, velocity, acceleration| State { position, velocity, acceleration };
        let limits = limits_of([vmax, vmin, amax, amin, jmax, jmin]);
        Self { kind, request, limits, from: state(p0, v0, a0), to: state(p1, v1, a1) }
    }

    pub fn of_arguments(request: Request, arguments: [R; 7]) -> Self {
        let [x, y, z, p0, p1, v0, v1] = arguments;
        let [v, high, low, j] = match request {
            Request::Bell => [z.abs(), y.abs(), R::ZERO, x.abs()],
            _ if y > z => [x.abs(), y, z, R::ZERO],
            _ => [x.abs(), z, y, R::ZERO],
        };
        Self::of(Kind::TinyAgainstHuge, request, [v, R::ZERO, high, low, j, R::ZERO, p0, v0, R::ZERO, p1, v1, R::ZERO])
    }

    /// The arguments of the profile's `gen`: limits in the direction of the way, and of a trapezoid the other acceleration behind it.
    pub fn arguments(&self) -> [R; 7] {
        let [vmax, vmin, amax, amin, jmax, jmin, ends @ ..] = self.numbers();
        let [p0, v0, _, p1, v1, _] = ends;
        let [v, along, against, j] = if p1 < p0 { [vmin, amin, amax, jmin] } else { [vmax, amax, amin, jmax] };
        match self.request {
            Request::Bell => [j, along, v, p0, p1, v0, v1],
            _ => [v, along, against, p0, p1, v0, v1],
        }
    }

    pub fn numbers(&self) -> [R; 12] {
        let Limits { vmax, vmin, amax, amin, jmax, jmin } = self.limits;
        let [[p0, v0, a0], [p1, v1, a1]] = [self.from, self.to].map(parts);
        [vmax, vmin, amax, amin, jmax, jmin, p0, v0, a0, p1, v1, a1]
    }

    fn with(&self, numbers: [R; 12]) -> Self {
        Self::of(self.kind, self.request, numbers)
    }

    pub fn ends(&self) -> [State<R>; 2] {
        let vmax = self.limits.vmax.widen();
        let limit = |end: State<R>| State { velocity: R::of(end.velocity.widen().clamp(-vmax, vmax)), ..end };
        let ends = [self.from, self.to];
        if self.request.profile().is_none() { ends } else { ends.map(limit) }
    }

    pub fn mirrored(&self) -> Self {
        let [vmax, vmin, amax, amin, jmax, jmin, ends @ ..] = self.numbers();
        let [p0, v0, a0, p1, v1, a1] = ends;
        self.with([vmin, vmax, amin, amax, jmin, jmax, p0, v0, a0, p1, v1, a1].map(|x| -x))
    }

    pub fn scaled(&self, length: i8, time: i8) -> Self {
        let mut numbers = self.numbers();
        for (x, power) in numbers.iter_mut().zip(POWERS_OF_TIME) {
            *x = R::of(x.widen() * f64::from(length - power * time).exp2());
        }
        self.with(numbers)
    }

    /// The problem with the roundest numbers at which it is still bad.
    pub fn simplified(&self, is_bad: impl Fn(&Self) -> bool) -> Self {
        const ORDER: [usize; 12] = [6, 9, 11, 8, 10, 7, 0, 1, 2, 3, 4, 5]; // ends first, positions before the others
        const ROUNDS: usize = 4;
        let mut numbers = self.numbers();
        if !is_bad(self) {
            return *self;
        }
        for _ in 0..ROUNDS {
            let before = numbers;
            for index in ORDER {
                let x = numbers[index];
                let digits = [0, 1, 2, 3, 4, 6].map(|digits| rounded(x, digits));
                let candidates = [R::ZERO, R::of(1.0f64.copysign(x.widen()))].into_iter().chain(digits);
                for candidate in candidates.take_while(|candidate| *candidate != x) {
                    let mut tried = numbers;
                    tried[index] = candidate;
                    let problem = self.with(tried);
                    if beyond_legal(&problem.limits, problem.to) <= 0.0 && is_bad(&problem) {
                        numbers = tried;
                        break;
                    }
                }
            }
            if before == numbers {
                break;
            }
        }
        self.with(numbers)
    }
}

pub fn parts<R>(state: State<R>) -> [R; 3] {
    [state.position, state.velocity, state.acceleration]
}

fn rounded<R: Real>(x: R, digits: usize) -> R {
    R::of(format!("{:.digits$e}", x.widen()).parse().expect("a number"))
}

impl<R: Real> Display for Problem<R> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        let [vmax, vmin, amax, amin, jmax, jmin, from @ .., p1, v1, a1] = self.numbers();
        let limits = [vmax, vmin, amax, amin, jmax, jmin];
        let to = [p1, v1, a1];
        write!(f, "{} {:?} {:?} limits {limits:?} from {from:?} to {to:?}", R::NAME, self.kind, self.request)
    }
}
