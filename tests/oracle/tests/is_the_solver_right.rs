//! Is the reference solver right? Its motions are possible, and no motion is faster: neither a random one nor one of rsruckig. A bisection of
//! the peak velocity, which knows no border, finds the same durations of motions without acceleration at their ends.

use oracle::judge::rivals::Theirs;
use oracle::judge::solver::Walk;
use oracle::judge::{Fastest, Kind, Problem, Problems, Request, Trial, Verdict, beyond_legal, widened};
use support::online::state_of;
use support::prelude::*;

const MOTIONS: u32 = 100_000;
const PROBLEMS: usize = 200_000;

/// A motion of random jerks, each the highest, the lowest or none, within random limits. `None` if it leaves them.
fn motion(random: &mut Random) -> Option<(Problem<f64>, f64)> {
    let [vmax, vmin, amax, amin] = [1.0, -1.0, 1.0, -1.0].map(|x| x * random.magnitude(-1.0, 1.0));
    let [jmax, jmin] = [1.0, -1.0].map(|x| x * random.magnitude(-0.5, 0.5));
    let limits = Limits { vmax, vmin, amax, amin, jmax, jmin };
    let within = random.between(amin, amax);
    let from: State<f64> = state_of([0.0, random.between(vmin, vmax), random.pick(&[0.0, amin, amax, within])]);
    let mut planned = Move::default();
    let mut acceleration = from.acceleration;
    planned.count = 2 + random.below(6) as u32;
    let mut sign = random.sign();
    for phase in &mut planned.phase[..planned.count as usize] {
        let jerk = match random.below(4) {
            0 => 0.0,
            1 => random.between(jmin, jmax),
            _ if sign > 0.0 => jmax,
            _ => jmin,
        };
        sign = -sign;
        let room = if jerk > 0.0 { (amax - acceleration) / jerk } else { (amin - acceleration) / jerk };
        let limited = if jerk == 0.0 { 1.0 } else { room };
        let part = random.unit();
        let duration = limited * random.pick(&[1.0, part, part]);
        *phase = Phase { duration, acceleration, jerk, ..Phase::default() };
        acceleration += jerk * duration;
        planned.t += duration;
    }
    let end = planned.count as usize;
    planned.phase[end].acceleration = acceleration;
    let walk = Walk::of(from, &planned);
    let [position, velocity, acceleration] = walk.borders[end];
    let to = State { position, velocity, acceleration: acceleration.clamp(amin, amax) };
    let inside = walk.knots.iter().all(|&[_, _, v, _]| v <= vmax && v >= vmin);
    let at_zero_a = from.velocity
        - 0.5 * from.acceleration * from.acceleration.abs() / if from.acceleration > 0.0 { jmin } else { -jmax };
    let legal = beyond_legal(&limits, to) <= 0.0 && at_zero_a <= vmax && at_zero_a >= vmin;
    let problem = Problem { kind: Kind::Moving, request: Request::Plan, limits, from, to };
    (inside && legal).then_some((problem, planned.t))
}

/// No random motion is faster than the fastest one, or gets farther than the border of its duration.
#[test]
fn no_random_motion_is_faster() {
    let mut random = Random::seeded(7);
    let (mut motions, mut fastest) = (0, 0);
    while motions < MOTIONS {
        let Some((problem, t)) = motion(&mut random) else { continue };
        motions += 1;
        let trial = Trial::new(problem);
        let best = trial.best;
        let least = best.duration;
        let is_slower = t >= least * (1.0 - 1e-9) || !matches!(trial.duration_near(t, 1e-12), Verdict::Shorter(_));
        assert!(is_slower, "{t:e} is faster than {best:?}: {}", problem);
        fastest += u32::from(t <= least * (1.0 + 1e-6));
        if let Some([lowest, highest]) = trial.motion.interval(t) {
            let h = problem.to.position;
            let slack = 1e-12 * (1.0 + t * t);
            let is_in = h >= lowest - slack && h <= highest + slack;
            assert!(is_in, "{h:e} is not in {lowest:e}..{highest:e} in {t:e} s: {problem}");
        }
    }
    assert!(fastest > motions / 100, "{fastest} of {motions} are the fastest");
}

/// A start beyond a velocity recovers with an acceleration. It eases in the middle of the motion, and its border rises, falls and rises
/// again. The fastest motion is below the first top, which the reference solver passed over.
#[test]
fn a_start_beyond_the_velocity_eases() {
    let rows = [
        ([0.01, -6.13, 1.0, -16.7, 62.4, -32.0], [-0.07, 5.2], [0.03, -6.13]),
        ([0.03, -40.0, 1.0, -0.9214, 0.3434, -0.227], [0.0, 5.04], [-105.8, -14.27]),
    ];
    for ([vmax, vmin, amax, amin, jmax, jmin], [p0, v0], [p1, v1]) in rows {
        let numbers = [vmax, vmin, amax, amin, jmax, jmin, p0, v0, 0.0, p1, v1, 0.0];
        let problem = Problem::of(Kind::FarOutside, Request::Plan, numbers);
        let verdict = Trial::new(problem).judge(&Fastest, &mut Random::seeded(0));
        assert!(matches!(verdict, Verdict::Good { error, .. } if error < 1e-12), "{verdict:?}: {problem}");
    }
}

/// The reference solver's motions end where they should, keep the limits, and have no phase of negative duration.
#[test]
fn its_motions_are_possible() {
    for problem in Problems::<f64>::new(5).take(PROBLEMS) {
        let best = Trial::new(problem).best;
        // The border is counted from a straight rise from end to end. Digits cancel where this rise changes the velocity by far more than
        // the motion does: before a target behind which the axis goes far beyond its limits.
        let [.., jmax, jmin] = widened(&problem.limits);
        let [a0, a1] = [problem.from, problem.to].map(|end| end.acceleration);
        let rise = 0.5 * (a1 * a1 - a0 * a0).abs() / jmax.min(-jmin);
        let cancelled = 1e-19 * rise / best.speed.max(f64::MIN_POSITIVE);
        assert!(best.wrong < cancelled.max(1e-9), "{best:?}: {}", problem);
    }
}

#[test]
fn rsruckig_is_no_faster() {
    let mut theirs = Theirs::default();
    for problem in Problems::<f64>::new(6).take(PROBLEMS) {
        theirs.ask(&problem, &Trial::new(problem));
        assert_eq!(theirs.shorter, 0, "{problem}");
    }
    assert!(theirs.asked > PROBLEMS as u64 / 4, "{theirs:?}");
}

struct ByBisection {
    jerk: f64,
    rise: f64,
    fall: f64,
    vmax: f64,
    way: f64,
    ends: [f64; 2],
}

impl ByBisection {
    /// The axis, seen from the side on which the motion first accelerates upwards.
    fn of(problem: &Problem<f64>) -> Self {
        let limits = problem.limits;
        let [from, to] = problem.ends();
        let Limits { vmax, amax: rise, amin, jmax: jerk, .. } = limits;
        let (way, ends) = (to.position - from.position, [from.velocity, to.velocity]);
        let mut axis = Self { jerk, rise, fall: -amin, vmax, way, ends };
        if axis.by_way_of(0.0)[1] > axis.way {
            (axis.rise, axis.fall, axis.way) = (axis.fall, axis.rise, -axis.way);
            axis.ends = axis.ends.map(|v| -v);
        }
        axis
    }

    fn ramp(&self, change: f64, a: f64) -> f64 {
        if change * self.jerk < a * a { 2.0 * (change / self.jerk).sqrt() } else { a / self.jerk + change / a }
    }

    /// Duration and displacement without a cruise. A ramp covers its mean velocity times its duration.
    fn by_way_of(&self, q: f64) -> [f64; 2] {
        let [v0, v1] = self.ends;
        let (up, down) = (q + (v1 - v0).max(0.0), q + (v0 - v1).max(0.0));
        let (t0, t1) = (self.ramp(up, self.rise), self.ramp(down, self.fall));
        [t0 + t1, (v0 * t0 + v1 * t1) + (up * t0 + down * t1) / 2.0]
    }

    /// The displacement begins below `way` at `q = 0` and crosses it once.
    fn duration(&self) -> f64 {
        let [v0, v1] = self.ends;
        let room = self.vmax - v0.max(v1);
        let gets_there = |q| self.by_way_of(q)[1] >= self.way;
        if room.is_finite() && !gets_there(room) {
            let [duration, covered] = self.by_way_of(room);
            return duration + (self.way - covered) / self.vmax;
        }
        // A number is as many steps from 0 as its bits say.
        let (mut low, mut high) = (0, room.min(f64::MAX).to_bits());
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            (low, high) = if gets_there(f64::from_bits(middle)) { (low, middle) } else { (middle, high) };
        }
        self.by_way_of(f64::from_bits(low))[0]
    }
}

#[test]
fn a_bisection_finds_the_same() {
    let mut same = 0;
    for problem in Problems::<f64>::of_profiles(8).take(PROBLEMS) {
        if problem.request.profile().is_none() {
            continue;
        }
        let t = ByBisection::of(&problem).duration();
        let verdict = Trial::new(problem).duration(t);
        assert!(matches!(verdict, Verdict::Good { .. }), "{t:e}: {verdict:?}: {problem}");
        same += 1;
    }
    assert!(same > PROBLEMS / 2, "{same}");
}
