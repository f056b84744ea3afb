//! Random paths, in families. The same seed gives the same paths.

use support::online::{limits_of, numbers_of, numbers_of_state, state_of, symmetric};
use support::prelude::*;

listed! {
    /// What is adversarial about a path.
    pub enum Family {
        AtRest, // from rest to rest
        OnePoint, // one waypoint
        UnequalLimits, // all limits differ
        InMotion, // the start is in motion
        OnTheLimits, // start and end are on their limits
        Outside, // the start is outside the limits
        Zones, // limits for every section
        ToAndFro, // every axis turns at every point
        Many, // many axes or many points
        UnlikeAxes, // the limits of the axes are a factor of 1000 apart
        UnevenWays, // ways of 0.01 to 30
        NastyWays, // ways of 0.0001 to 1000
        OneDirection, // ways of 0.0001 to 1000 in one direction
        Staying, // axes that stay in some sections
        Repeating, // points that repeat
        Dense, // rows of close points
        Unlimited, // some limits are infinite
        NoPoint, // no waypoint
    }
}

#[derive(Clone, Debug)]
pub struct Chain<R> {
    pub family: Family,
    pub axes: usize,            // how many axes it has
    pub limits: Vec<Limits<R>>, // of the axes, or of the axes section by section
    pub states: Vec<State<R>>,  // point by point; between start and end the positions alone count
}

impl<R: Real> Chain<R> {
    /// A path through these positions, point by point, from rest to rest.
    pub fn at_rest(limits: Vec<Limits<R>>, positions: impl Iterator<Item = f64>) -> Self {
        let states = positions.map(|position| State::at(R::of(position))).collect();
        Self { family: Family::AtRest, axes: limits.len(), limits, states }
    }

    pub fn sections(&self) -> usize {
        self.states.len() / self.axes - 1
    }

    pub fn limits(&self, section: usize) -> &[Limits<R>] {
        let first = if self.limits.len() == self.axes { 0 } else { section * self.axes };
        &self.limits[first..first + self.axes]
    }

    /// Position, velocity and acceleration of every state times these factors, and the limits to match.
    pub fn scaled(&self, length: f64, time: f64) -> Self {
        let mut scaled = self.clone();
        let [p, v, a, j] = [0, 1, 2, 3].map(|power| R::of(length / time.powi(power)));
        for state in &mut scaled.states {
            *state = scale(state, [p, v, a]);
        }
        for limits in &mut scaled.limits {
            let [vmax, vmin, amax, amin, jmax, jmin] = numbers_of(limits);
            *limits = limits_of([vmax * v, vmin * v, amax * a, amin * a, jmax * j, jmin * j]);
        }
        scaled
    }

    /// The path with the axes mirrored from the axis `first` on.
    pub fn mirrored(&self, first: usize) -> Self {
        let (mut mirrored, other) = (self.clone(), self.scaled(-1.0, 1.0));
        let is_mirrored = |k: usize| k % self.axes >= first;
        for (k, state) in mirrored.states.iter_mut().enumerate() {
            if is_mirrored(k) {
                *state = other.states[k];
            }
        }
        for (k, limits) in mirrored.limits.iter_mut().enumerate() {
            if is_mirrored(k) {
                let [vmax, vmin, amax, amin, jmax, jmin] = numbers_of(&other.limits[k]);
                *limits = limits_of([vmin, vmax, amin, amax, jmin, jmax]);
            }
        }
        mirrored
    }
}

pub fn scale<R: Real>(state: &State<R>, [p, v, a]: [R; 3]) -> State<R> {
    let State { position, velocity, acceleration } = *state;
    State { position: position * p, velocity: velocity * v, acceleration: acceleration * a }
}

/// Waypoints that the documentation of Ruckig plans in its example 3.
pub fn example_of_ruckig<R: Real>() -> Chain<R> {
    let points =
        [[0.2, 0.0, -0.3], [1.4, -1.6, 1.0], [-0.6, -0.5, 0.4], [-0.4, -0.35, 0.0], [0.8, 1.8, -0.1], [0.5, 1.0, 0.0]];
    let limits = [[6.0, 3.0, 1.0], [10.0, 2.0, 2.0], [20.0, 2.0, 1.0]];
    let mut chain = Chain::at_rest(limits.map(|[j, a, v]| symmetric(j, a, v)).into(), points.into_iter().flatten());
    for (k, velocity, acceleration) in [(1, 0.2, 0.6), (15, 0.2, 0.0), (16, 0.0, 0.1), (17, 0.3, -0.1)] {
        (chain.states[k].velocity, chain.states[k].acceleration) = (R::of(velocity), R::of(acceleration));
    }
    chain
}

/// An endless sequence of paths. The families take turns.
pub struct Chains {
    random: Random,
    turn: usize,
}

impl Chains {
    pub fn new(seed: u64) -> Self {
        Self { random: Random::seeded(seed ^ 0xc4a1), turn: 0 }
    }

    pub fn draw<R: Real>(&mut self) -> Chain<R> {
        let family = Family::ALL[self.turn % Family::ALL.len()];
        self.turn += 1;
        self.of(family)
    }

    pub fn of<R: Real>(&mut self, family: Family) -> Chain<R> {
        let random = &mut self.random;
        let (mut axes, mut points) = (1 + random.below(4), 1 + random.below(5));
        match family {
            Family::OnePoint => points = 1,
            Family::NoPoint => points = 0,
            Family::Many => (axes, points) = random.pick(&[(12, 8), (1, 40), (6, 16), (2, 30)]),
            Family::Dense => (axes, points) = (1 + random.below(3), random.pick(&[10, 20, 40])),
            _ => {}
        }
        let unequal = !matches!(family, Family::AtRest | Family::Dense | Family::OnePoint) || random.one_in(2);
        let sets = if family == Family::Zones { points + 1 } else { 1 };
        let mut limits: Vec<Limits<f64>> = Vec::new();
        for _ in 0..sets * axes {
            let scale = if family == Family::UnlikeAxes { random.magnitude(-1.5, 1.5) } else { 1.0 };
            limits.push(random_limits(random, scale, unequal));
        }
        if family == Family::Unlimited {
            limits.iter_mut().for_each(|limits| unlimited(random, limits));
        }
        let mut states = vec![State::at(0.0); (points + 2) * axes];
        for axis in 0..axes {
            let ways = ways(random, family, points + 1, &limits[axis]);
            let mut position = if random.one_in(2) { 0.0 } else { random.between(-3.0, 3.0) };
            for (point, way) in [0.0].into_iter().chain(ways).enumerate() {
                position += way;
                states[point * axes + axis].position = position;
            }
            let last = limits.len() - axes + axis;
            ends(random, family, [&limits[axis], &limits[last]], &mut states, [axis, (points + 1) * axes + axis]);
        }
        let is_dropped = matches!(family, Family::Staying | Family::Repeating);
        for point in 1..points + 2 {
            for axis in 0..axes {
                let all = family == Family::Repeating && point % 3 == 1;
                if is_dropped && (all || family == Family::Staying && random.one_in(2)) {
                    states[point * axes + axis].position = states[(point - 1) * axes + axis].position;
                }
            }
        }
        Chain {
            family,
            axes,
            limits: limits.iter().map(|limits| rounded(limits)).collect(),
            states: states.iter().map(|state| state_of(numbers_of_state(*state))).collect(),
        }
    }
}

fn rounded<R: Real>(limits: &Limits<f64>) -> Limits<R> {
    limits_of(numbers_of(limits).map(R::of))
}

fn random_limits(random: &mut Random, scale: f64, unequal: bool) -> Limits<f64> {
    let [v, a, j] = [(-0.5, 0.5), (0.0, 1.0), (0.5, 2.0)].map(|(lo, hi)| scale * random.magnitude(lo, hi));
    let mut limits = Limits::symmetric(j, a, v);
    if unequal && random.one_in(2) {
        limits.vmin *= random.magnitude(-0.5, 0.5);
        limits.amin *= random.magnitude(-0.5, 0.5);
        limits.jmin *= random.magnitude(-0.5, 0.5);
    }
    limits
}

fn unlimited(random: &mut Random, limits: &mut Limits<f64>) {
    let endless = f64::INFINITY;
    match random.below(4) {
        0 => (limits.vmax, limits.vmin) = (endless, -endless),
        1 => (limits.amax, limits.amin) = (endless, -endless),
        2 => (limits.jmax, limits.jmin) = (endless, -endless),
        _ => limits.jmax = endless,
    }
}

fn ways(random: &mut Random, family: Family, sections: usize, limits: &Limits<f64>) -> Vec<f64> {
    let turn = random.sign();
    let spacing = random.magnitude(-4.0, -1.5);
    let straight = random.one_in(2);
    let mut way = |k: usize| match family {
        Family::UnevenWays => random.sign() * random.magnitude(-2.0, 1.5),
        Family::NastyWays => random.sign() * random.magnitude(-4.0, 3.0),
        Family::OneDirection => turn * random.magnitude(-4.0, 3.0),
        Family::ToAndFro => (if k.is_multiple_of(2) { turn } else { -turn }) * random.magnitude(-1.0, 0.5),
        Family::Dense if straight => turn * spacing,
        Family::Dense => turn * spacing * (0.1 * k as f64).cos(),
        // The way in which the axis reaches its highest velocity is about this long.
        Family::Unlimited if limits.vmax.is_infinite() => random.between(-3.0, 3.0),
        _ => random.between(-2.0, 2.0),
    };
    (0..sections).map(&mut way).collect()
}

fn ends(random: &mut Random, family: Family, limits: [&Limits<f64>; 2], states: &mut [State<f64>], ends: [usize; 2]) {
    use Family::*;
    let part = match family {
        InMotion | Zones | Unlimited | Repeating | Staying | NoPoint if random.one_in(2) => 0.9,
        Many | UnequalLimits if random.one_in(4) => 0.5,
        OnTheLimits => 1.0,
        Outside => 1.5,
        _ => return,
    };
    for (which, (limits, end)) in limits.into_iter().zip(ends).enumerate() {
        let state = &mut states[end];
        let part = if which == 1 { f64::min(part, 1.0) } else { part };
        let finite = |limit: f64, otherwise: f64| if limit.is_finite() { limit } else { otherwise };
        let share = |random: &mut Random, high: f64, low: f64, otherwise: f64| {
            let share = if part == 1.0 { 1.0 } else { random.between(0.0, part) };
            share * if random.one_in(2) { finite(high, otherwise) } else { finite(low, -otherwise) }
        };
        match random.below(3) {
            0 => state.velocity = share(random, limits.vmax, limits.vmin, 2.0),
            1 => state.acceleration = share(random, limits.amax, limits.amin, 3.0),
            _ => {
                state.velocity = 0.5 * share(random, limits.vmax, limits.vmin, 2.0);
                state.acceleration = 0.5 * share(random, limits.amax, limits.amin, 3.0);
            }
        }
        // An acceleration that must have left the velocities, or will. The end of a path may leave them afterwards.
        let half_square = 0.5 * state.acceleration * state.acceleration;
        let above = state.velocity - half_square / limits.jmin > limits.vmax;
        let below = state.velocity - half_square / limits.jmax < limits.vmin;
        let before = if state.acceleration > 0.0 { below } else { above };
        let beyond = if which == 0 { above || below } else { before };
        if beyond && (which == 1 || family != Outside) {
            state.acceleration = 0.0;
        }
    }
}
