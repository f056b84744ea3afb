//! Does a shaper leave a load at rest, as much as its published sensitivity curve says, within the limits of the move?

use std::f64::consts::PI;
use support::prelude::*;
use support::read;

const KINDS: [ShaperKind; 5] = [ShaperKind::Zv, ShaperKind::Mzv, ShaperKind::Zvd, ShaperKind::Ei, ShaperKind::Ei2];
type Swing = [f64; 2]; // a complex number

fn product(a: Swing, b: Swing) -> Swing {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

fn power(exponent: Swing) -> Swing {
    let size = exponent[0].exp();
    [size * exponent[1].cos(), size * exponent[1].sin()]
}

/// How much a load swings when a motion is over, in the unit of velocity. It has this frequency and damping, and the motion moves what carries it.
/// The motion is the sum of jerks: `acceleration` is piecewise linear and continuous, and `times` has its corners.
fn residual(times: &[f64], acceleration: impl Fn(f64) -> f64, load: [f64; 2]) -> f64 {
    let [frequency, damping] = load;
    let omega = 2.0 * PI * frequency;
    let pole = [-damping * omega, omega * (1.0 - damping * damping).sqrt()];
    let end = times.last().expect("a time");
    let scale = 1.0 / (pole[0] * pole[0] + pole[1] * pole[1]);
    let inverse = [pole[0] * scale, -pole[1] * scale];
    let mut swing = [0.0, 0.0];
    for pair in times.windows(2).filter(|pair| pair[1] > pair[0]) {
        let d = pair[1] - pair[0];
        // Two times inside, because a jump at a corner belongs to neither side.
        let [one, other] = [0.25, 0.75].map(|part| acceleration(pair[0] + part * d));
        let (jerk, a) = ((other - one) / (0.5 * d), 1.5 * one - 0.5 * other);
        // The integral of (a + j z) e^(pole (d - z)).
        let grown = power([pole[0] * d, pole[1] * d]);
        let moved = product([grown[0] - 1.0, grown[1]], inverse);
        let bent = product([moved[0] - d, moved[1]], inverse);
        let driven = [a * moved[0] + jerk * bent[0], a * moved[1] + jerk * bent[1]];
        let part = product(driven, power([pole[0] * (end - pair[1]), pole[1] * (end - pair[1])]));
        swing = [swing[0] + part[0], swing[1] + part[1]];
    }
    swing[0].hypot(swing[1])
}

/// The weights of the impulses without damping, and their spacing in periods, as the papers have them.
fn impulses(kind: ShaperKind) -> (Vec<f64>, f64) {
    let v = 0.05_f64;
    let x = (v * v * ((1.0 - v * v).sqrt() + 1.0)).cbrt();
    let two_humps = (3.0 * x * x + 2.0 * x + 3.0 * v * v) / (16.0 * x);
    match kind {
        ShaperKind::Zv => (vec![0.5, 0.5], 0.5),
        ShaperKind::Zvd => (vec![0.25, 0.5, 0.25], 0.5),
        ShaperKind::Mzv => {
            let outer = 1.0 - 0.5_f64.sqrt();
            (vec![outer, 2.0_f64.sqrt() - 1.0, outer], 0.375)
        }
        ShaperKind::Ei => (vec![0.25 * (1.0 + v), 0.5 * (1.0 - v), 0.25 * (1.0 + v)], 0.5),
        ShaperKind::Ei2 => (vec![two_humps, 0.5 - two_humps, 0.5 - two_humps, two_humps], 0.5),
    }
}

/// What the papers say a shaper leaves of the vibration of a load, seen when the shaped motion is over: Singer & Seering 1990, equation 2.
fn published(kind: ShaperKind, designed: [f64; 2], load: [f64; 2]) -> f64 {
    let [frequency, damping] = designed;
    let swing = (1.0 - damping * damping).sqrt();
    let period = 1.0 / (frequency * swing);
    let (undamped, spacing) = impulses(kind);
    let decay = (-2.0 * PI * spacing * damping / swing).exp();
    let weights: Vec<f64> = undamped.iter().enumerate().map(|(k, a)| a * decay.powi(k as i32)).collect();
    let sum: f64 = weights.iter().sum();
    let omega = 2.0 * PI * load[0];
    let pole = [-load[1] * omega, omega * (1.0 - load[1] * load[1]).sqrt()];
    let last = (weights.len() - 1) as f64;
    let mut left = [0.0, 0.0];
    for (k, weight) in weights.iter().enumerate() {
        let before = (last - k as f64) * spacing * period;
        let part = power([pole[0] * before, pole[1] * before]);
        left = [left[0] + weight / sum * part[0], left[1] + weight / sum * part[1]];
    }
    left[0].hypot(left[1])
}

/// When the phases of a move begin, and its end, s.
fn borders<R: Real>(planned: &Move<R>) -> Vec<f64> {
    planned.phase[..=planned.phases().len()].iter().map(|phase| phase.start.widen()).collect()
}

fn corners(borders: &[f64], delays: &[f64]) -> Vec<f64> {
    let mut corners: Vec<f64> = delays.iter().flat_map(|delay| borders.iter().map(move |x| x + delay)).collect();
    corners.sort_by(f64::total_cmp);
    corners
}

fn delays(kind: ShaperKind, [frequency, damping]: [f64; 2]) -> Vec<f64> {
    let period = 1.0 / (frequency * (1.0 - damping * damping).sqrt());
    let (weights, spacing) = impulses(kind);
    (0..weights.len()).map(|k| k as f64 * spacing * period).collect()
}

fn rest_to_rest<R: Real>(random: &mut Random) -> Move<R> {
    let limits = online::limits(random);
    let [from, to] = [(); 2].map(|()| State::at(R::of(random.sign() * random.magnitude(-2.0, 1.0))));
    online::plan(&limits, from, to)
}

/// Loads of 0.5 to 50 Hz with a damping of 0 to 0.2, and a frequency that is wrong by up to 20 %: what is left is on the curve.
fn loads_are_left_as_published<R: Real>() {
    let mut random = Random::seeded(6);
    let mut worst = [0.0_f64; 5];
    for number in 0..2_000 {
        let planned = rest_to_rest::<R>(&mut random);
        let designed = [0.5 * random.magnitude(0.0, 2.0), random.between(0.0, 0.2)].map(|x| R::of(x).widen());
        let load = [designed[0] * random.between(0.8, 1.2), designed[1]];
        let borders = borders(&planned);
        let unshaped = residual(&borders, |x| planned.acceleration(R::of(x)).widen(), load);
        let [_, _, peak] = online::largest(planned.extremes());
        for (worst, kind) in worst.iter_mut().zip(KINDS) {
            let shaper = Shaper::new(kind, R::of(designed[0]), R::of(designed[1])).expect("a shaper");
            let times = corners(&borders, &delays(kind, designed));
            let shaped = residual(&times, |x| shaper.state(&planned, R::of(x)).acceleration.widen(), load);
            // The load forgets what is older than its decay, so a slow move leaves nothing but its roundings.
            let wanted = unshaped * published(kind, designed, load);
            let rounding = 256.0 * R::MACHINE_EPSILON.widen() * peak * (planned.t.widen() + 1.0 / load[0]);
            let off = (shaped - wanted).abs();
            assert!(off <= rounding, "move {number}, {kind:?}, {load:?}: {shaped:e} {wanted:e} {rounding:e}");
            *worst = worst.max(published(kind, designed, load));
        }
    }
    println!("{}: at most left, frequency wrong by 20 %: {KINDS:?} {worst:.3?}", R::NAME);
}

/// The ranges of frequencies around that of the shaper in which less than 5 % is left: where the published curve of a kind passes 5 %, and a simulated load with
/// these frequencies is on the curve. The page has what this prints.
#[test]
fn insensitivities_are_those_of_the_curves() {
    // A short move shows the impulses alone.
    let planned = online::plan(&Limits::symmetric(f64::INFINITY, 1e4, 1e4), State::at(0.0), State::at(0.25));
    let borders = [0.0, 0.5 * planned.t, planned.t];
    let page = read("docs/machine.md");
    for kind in KINDS {
        let shaper = Shaper::new(kind, 1.0, 0.0).expect("a shaper");
        let times = corners(&borders, &delays(kind, [1.0, 0.0]));
        let simulated = |frequency: f64| {
            let load = [frequency, 0.0];
            residual(&times, |x| shaper.state(&planned, x).acceleration, load)
                / residual(&borders, |x| planned.acceleration(x), load)
        };
        // EI touches 5 % at its frequency, so a rounding is no passage.
        let is_good = |wrong: f64| published(kind, [1.0, 0.0], [1.0 + wrong, 0.0]) <= 0.05 + 1e-9;
        let passage = |direction: f64| {
            let step = direction * 1e-5;
            step * f64::from((1..100_000).find(|k| !is_good(step * f64::from(*k))).expect("a passage"))
        };
        let ends = [-1.0, 1.0].map(passage);
        for end in ends {
            let left = simulated(1.0 + end);
            assert!((left - 0.05).abs() < 1e-4, "{kind:?} at {end}: {left}");
        }
        let [low, high] = ends.map(|end| format!("{:.1} %", 100.0 * end.abs()));
        println!("{kind:?}: too low by {low}, too high by {high}");
        let name = format!("| {}:", format!("{kind:?}").to_uppercase());
        let row = page.lines().find(|line| line.starts_with(&name)).expect(&name);
        assert!(row.contains(&format!("| {low} | {high} |")), "{row}");
    }
}

fn limits_are_kept<R: Real>() {
    let mut random = Random::seeded(7);
    let (zero, epsilon) = (R::ZERO, R::MACHINE_EPSILON.widen());
    for number in 0..2_000 {
        let planned = rest_to_rest::<R>(&mut random);
        let time = planned.t.widen() * random.magnitude(-3.0, 0.5);
        let time = random.pick(&[0.0, time]);
        let mut shaper = Shaper::smooth(R::of(time)).expect("a time");
        for _ in 0..random.below(3) {
            let kind = random.pick(&KINDS);
            let (frequency, damping) = (random.magnitude(-1.0, 1.5), random.between(0.0, 0.9));
            shaper.add(kind, R::of(frequency), R::of(damping)).expect("two frequencies");
        }
        let (start, end) = (planned.state_at(zero), planned.state_at(planned.t));
        let last = R::of((planned.t.widen() + shaper.duration().widen()) * (1.0 + 4.0 * epsilon));
        assert_eq!(shaper.state(&planned, zero), start, "move {number}");
        assert_eq!(shaper.state(&planned, last), end, "move {number}");
        assert_eq!(shaper.state(&planned, R::NAN), end, "move {number}");
        assert_eq!(shaper.state(&planned, R::INFINITY), end, "move {number}");
        assert_eq!(shaper.state(&planned, -R::INFINITY), start, "move {number}");
        let reached = planned.extremes();
        let [p, v, a] = online::largest(reached);
        let scale = [p + v * last.widen(), v, a];
        let jerk = planned.phases().iter().map(|phase| phase.jerk.widen().abs()).fold(0.0, f64::max);
        let parts = online::numbers_of_state::<R>;
        let (lowest, highest) = (parts(reached.lowest), parts(reached.highest));
        let slack = scale.map(|scale| 64.0 * epsilon * scale);
        for _ in 0..40 {
            let x = last.widen() * random.between(0.0, 1.0);
            let now = parts(shaper.state(&planned, R::of(x)));
            for k in 0..3 {
                let inside = now[k] >= lowest[k] - slack[k] && now[k] <= highest[k] + slack[k];
                assert!(inside, "move {number}, {k}: {now:?} {lowest:?} {highest:?} {shaper:?}");
            }
            if size_of::<R>() == 8 {
                let h = 1e-6 * last.widen();
                let [early, late] = [x - h, x + h].map(|x| parts(shaper.state(&planned, R::of(x))));
                for (k, bend) in [(0, scale[2]), (1, jerk)] {
                    let slope = (late[k] - early[k]) / (2.0 * h);
                    let off = (slope - now[k + 1]).abs();
                    assert!(off <= h * bend + slack[k] / h, "move {number}, {k}: {slope} {now:?}");
                }
            }
        }
    }
}

/// A double-S and the move with its phases are shaped alike, from standstill to standstill and in motion.
fn a_bell_is_shaped_as_a_move<R: Real>() {
    let [jerk, acceleration, velocity] = [30.0, 10.0, 5.0].map(R::of);
    let limits = Limits::symmetric(jerk, acceleration, velocity);
    let moving = |position, velocity| State { velocity, ..State::at(position) };
    for ends in [[0.0, 0.0], [1.0, 2.0]] {
        let ([p0, p1], [v0, v1]) = ([1.0, 11.0].map(R::of), ends.map(R::of));
        let bell = Bell::fastest(jerk, acceleration, velocity, Boundary { p0, p1, v0, v1 }).expect("a plan");
        let planned = online::plan(&limits, moving(p0, v0), moving(p1, v1));
        for (kind, smoothing) in KINDS.into_iter().zip([0.0, 0.1, 0.5, 2.0, 5.0]) {
            let mut shaper = Shaper::smooth(R::of(smoothing)).expect("a time");
            shaper.add(kind, R::of(3.0), R::of(0.1)).expect("a shaper");
            for k in -10..500 {
                let x = R::of(f64::from(k) * 0.02);
                let states = [shaper.bell_state(&bell, x), shaper.state(&planned, x)];
                let [one, other] = states.map(online::numbers_of_state);
                let off: f64 = one.iter().zip(other).map(|(one, other)| (one - other).abs()).sum();
                assert!(off < 4e3 * R::MACHINE_EPSILON.widen(), "{kind:?} at {x:e}: {states:?}");
            }
        }
    }
}

/// The axis of `python/examples/vibration.py`: its fastest move with this jerk, and what it leaves of a vibration in m.
fn servo(jerk: f64, kind: Option<ShaperKind>, wrong: f64) -> (f64, f64) {
    let planned = online::plan(&Limits::symmetric(jerk, 4.0, 1.0), State::at(0.0), State::at(0.5));
    let shaper = kind.map_or(Shaper::default(), |kind| Shaper::new(kind, 5.0, 0.01).expect("a shaper"));
    let times = corners(&borders(&planned), &kind.map_or(vec![0.0], |kind| delays(kind, [5.0, 0.01])));
    let mut worst = 0.0_f64;
    for k in -10..=10 {
        let load = [5.0 * (1.0 + 0.1 * wrong * f64::from(k)), 0.01];
        let swing = 2.0 * PI * load[0] * (1.0_f64 - load[1] * load[1]).sqrt();
        worst = worst.max(residual(&times, |x| shaper.state(&planned, x).acceleration, load) / swing);
    }
    (planned.t + shaper.duration(), worst)
}

/// For the same residual vibration a lower jerk takes longer than a shaper, if the frequency may be wrong.
#[test]
fn a_lower_jerk_costs_more() {
    for wrong in [0.05, 0.2] {
        let (alone, swings) = servo(f64::INFINITY, None, wrong);
        println!("without: {alone:.3} s, {:.2} mm, wrong by {wrong}", 1e3 * swings);
        for kind in KINDS {
            let (shaped, left) = servo(f64::INFINITY, Some(kind), wrong);
            // Every lower jerk is tried, because what is left does not fall evenly.
            let jerks = (0..2500).map(|k| 4000.0 * 0.995_f64.powi(k));
            let lower = jerks.map(|jerk| servo(jerk, None, wrong)).find(|found| found.1 <= left);
            let (slowed, _) = lower.expect("a slow move swings little");
            println!("{kind:?}: {shaped:.3} s, {:.2} mm; lower jerk: {slowed:.3} s", 1e3 * left);
            assert!(left < swings && slowed > 0.9 * shaped, "{kind:?}");
        }
    }
}

/// An impulse that has not begun sees an axis that goes on with its velocity, so it adds no acceleration: at the start, one of two has begun.
fn before_its_start_an_axis_keeps_its_velocity<R: Real>() {
    let moving = State { position: R::ZERO, velocity: R::ONE, acceleration: R::of(4.0) };
    let planned = online::plan(&online::symmetric(30.0, 10.0, 5.0), moving, State::at(R::of(10.0)));
    let shaper = Shaper::new(ShaperKind::Zv, R::of(2.0), R::ZERO).expect("a shaper");
    // The mean of the start and of the axis a quarter of a second before it.
    let shaped = State { position: R::of(-0.125), acceleration: R::of(2.0), ..moving };
    assert_eq!(shaper.state(&planned, R::ZERO), shaped);
}

/// A refusal leaves the shaper.
fn nonsense_is_refused<R: Real>() {
    let before = Shaper::new(ShaperKind::Ei2, R::of(2.0), R::of(0.1)).expect("a shaper");
    let mut shaper = before;
    let [good, none, endless] = [0.1, f64::NAN, f64::INFINITY].map(R::of);
    for frequency in [R::ZERO, R::of(-1.0), none, endless, -endless, R::of(1e-320)] {
        assert_eq!(shaper.add(ShaperKind::Zv, frequency, good), Err(Error::Duration), "{frequency:e}");
    }
    for damping in [R::of(-0.1), R::ONE, none, endless, -endless] {
        assert_eq!(shaper.add(ShaperKind::Zv, R::ONE, damping), Err(Error::Limits), "{damping:e}");
    }
    for time in [-good, none, endless, -endless] {
        assert_eq!(Shaper::smooth(time), Err(Error::Duration), "{time:e}");
    }
    assert_eq!(shaper, before);
    assert_eq!(shaper.add(ShaperKind::Ei2, R::of(3.0), good), Ok(()));
    let full = shaper;
    assert_eq!(shaper.add(ShaperKind::Zv, R::of(5.0), good), Err(Error::Limits));
    assert_eq!(shaper, full);
}

test_both_reals!(
    loads_are_left_as_published, limits_are_kept, a_bell_is_shaped_as_a_move,
    before_its_start_an_axis_keeps_its_velocity, nonsense_is_refused
);
