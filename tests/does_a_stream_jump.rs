//! Does a stream of states jump, leave its limits or lose a step, when it is shaped and stepped, whatever the source does?

use std::f64::consts::PI;
use support::online::numbers_of_state as numbers;
use support::prelude::*;

const KINDS: [ShaperKind; 5] = [ShaperKind::Zv, ShaperKind::Mzv, ShaperKind::Zvd, ShaperKind::Ei, ShaperKind::Ei2];

const SOURCES: usize = if support::BRIEF { 40 } else { 400 };

/// An axis that is planned again in mid-motion, stops, goes on at a velocity, and stands.
struct Source<R> {
    limits: Limits<R>,
    period: R,
    move_in_force: Move<R>,
    ticks: u32,
}

impl<R: Real> Source<R> {
    fn new(random: &mut Random) -> Self {
        let limits = online::limits(random);
        let period = R::of(random.pick(&[1.25e-4, 1e-3, 4e-3]));
        let start = State::at(R::of(random.between(-1.0, 1.0)));
        let move_in_force = online::plan(&limits, start, start);
        Self { limits, period, move_in_force, ticks: 0 }
    }

    fn now(&self) -> State<R> {
        self.move_in_force.state_at(self.after(self.ticks))
    }

    fn after(&self, ticks: u32) -> R {
        R::of(f64::from(ticks) * self.period.widen())
    }

    fn tick(&mut self) -> State<R> {
        self.ticks += 1;
        self.now()
    }

    fn plan_again(&mut self, random: &mut Random) {
        let (from, limits) = (self.now(), self.limits);
        let to = online::inside(random, &limits);
        let next = &mut self.move_in_force;
        match random.below(4) {
            0 => next.stop(&limits, from),
            1 => next.reach(&limits, from, R::HALF * to.velocity, R::ZERO),
            _ => next.plan(&limits, from, State::at(to.position)),
        }
        .expect("a plan");
        self.ticks = 0;
    }

    /// The highest velocity, acceleration and jerk, in whichever direction.
    fn highest(&self) -> [f64; 3] {
        let [vmax, vmin, amax, amin, jmax, jmin] = online::numbers_of(&self.limits).map(R::widen);
        [vmax.max(-vmin), amax.max(-amin), jmax.max(-jmin)]
    }
}

fn shaper<R: Real>(random: &mut Random, period: f64) -> Shaper<R> {
    let smoothing = if random.one_in(2) { period * random.magnitude(-1.0, 2.0) } else { 0.0 };
    let mut shaper = Shaper::smooth(R::of(smoothing)).expect("a time");
    for _ in 0..random.below(3) {
        let frequency = 1.0 / (period * random.magnitude(0.5, 2.5));
        let kind = random.pick(&KINDS);
        shaper.add(kind, R::of(frequency), R::of(random.between(0.0, 0.3))).expect("two frequencies");
    }
    shaper
}

/// A stream that begins at this state, and its delay line.
fn stream<R: Real>(shaper: &Shaper<R>, period: R, start: State<R>) -> (ShaperStream<R>, Vec<R>) {
    let mut line = vec![R::NAN; shaper.size(period).expect("a short shaper")];
    (ShaperStream::new(shaper, period, start, &mut line).expect("a stream"), line)
}

/// The impulses of a shaper, from what it makes of a step of the velocity: an axis that starts at a velocity of 1 at once.
fn impulses<R: Real>(shaper: &Shaper<R>, period: f64) -> Vec<f64> {
    let (mut stream, mut line) = stream(shaper, R::of(period), State::at(R::ZERO));
    let one = State { velocity: R::ONE, ..State::at(R::ZERO) };
    let mut before = 0.0;
    let response = line.clone().into_iter().map(|_| {
        let velocity = stream.tick(one, &mut line).expect("a state").velocity.widen();
        let weight = velocity - before;
        before = velocity;
        weight
    });
    response.collect()
}

/// The shaped state is the mean of the states before, with weights that are not negative, have the sum 1 and the mean delay of the shaper.
fn a_shaped_state_is_the_mean_of_the_past<R: Real>() {
    let mut random = Random::seeded(381);
    let epsilon = R::MACHINE_EPSILON.widen();
    for number in 0..SOURCES {
        let mut source = Source::<R>::new(&mut random);
        let period = source.period.widen();
        let shaper = shaper::<R>(&mut random, period);
        let weights = impulses(&shaper, period);
        let sum: f64 = weights.iter().sum();
        assert!((sum - 1.0).abs() < 64.0 * epsilon && weights.iter().all(|w| *w > -64.0 * epsilon), "{weights:?}");
        let last = weights.iter().rposition(|w| *w > 64.0 * epsilon).expect("a weight");
        assert!((last as f64 - shaper.duration().widen() / period).abs() <= 1.5, "{number}: {last} {shaper:?}");

        let (mut stream, mut line) = stream(&shaper, source.period, source.now());
        let mut past = vec![numbers(source.now()); weights.len()];
        let [v, a, j] = source.highest();
        let mut before = numbers(source.now());
        for tick in 0..4_000 {
            if random.one_in(300) {
                source.plan_again(&mut random);
            }
            let now = source.tick();
            past.insert(0, numbers(now));
            past.truncate(weights.len());
            let shaped = numbers(stream.tick(now, &mut line).expect("a state"));
            let farthest = past.iter().map(|state| state[0].abs()).fold(0.0, f64::max);
            let rounding = 64.0 * epsilon * (1.0 + weights.len() as f64 * epsilon.sqrt());
            for (k, size) in [farthest, v, a].into_iter().enumerate() {
                let mean: f64 = weights.iter().zip(&past).map(|(weight, state)| weight * state[k]).sum();
                let off = (shaped[k] - mean).abs();
                let most = rounding * size * (weights.len() as f64).sqrt();
                assert!(off <= most, "{number}, {tick}, {k}: {off:e} {shaper:?}");
            }
            // No limit is exceeded, and nothing jumps: a stream of states is no faster than the jerk allows.
            let slack = 1.0 + 1024.0 * epsilon;
            assert!(shaped[1].abs() <= slack * v && shaped[2].abs() <= slack * a, "{number}, {tick}: {shaped:?}");
            let jump = (shaped[2] - before[2]).abs();
            let late = 2.0 * epsilon * period * f64::from(source.ticks); // the times of two ticks have roundings
            assert!(jump <= slack * j * (period + late) + 64.0 * epsilon * a, "{number}, {tick}: {jump:e}");
            let moved = shaped[0] - before[0] - 0.5 * period * (shaped[1] + before[1]);
            let most = 0.1 * j * period.powi(3) + 8.0 * epsilon * (32.0 + v * period * f64::from(source.ticks));
            assert!(moved.abs() <= most, "{number}, {tick}: {moved:e}");
            before = shaped;
        }
        // An axis that stands is shaped exactly, whatever was before.
        let stands = State::at(source.now().position);
        for _ in 0..2 * weights.len() {
            stream.tick(stands, &mut line).expect("a state");
        }
        assert_eq!(stream.tick(stands, &mut line), Ok(stands), "{number}");
    }
}

/// How far a load swings after it followed these positions, one a period: an undamped load of this frequency, from standstill.
fn swing(accelerations: &[f64], period: f64, frequency: f64) -> f64 {
    let omega = 2.0 * PI * frequency;
    let (mut cos, mut sin) = (0.0, 0.0);
    for (tick, a) in accelerations.iter().enumerate() {
        let angle = omega * period * tick as f64;
        cos += a * angle.cos() * period;
        sin += a * angle.sin() * period;
    }
    f64::hypot(cos, sin)
}

/// A load that swings at the frequency of the shaper is left at rest after retargets in mid-motion too: at most 1 % of the swing without it.
fn a_retarget_leaves_a_load_at_rest<R: Real>() {
    let mut random = Random::seeded(382);
    let (mut left, mut swung) = (0.0, 0.0);
    for _ in 0..50 {
        let limits = online::symmetric(2_000.0, 10.0, 1.0);
        let (period, frequency) = (1e-3, random.between(3.0, 30.0));
        let kind = random.pick(&[ShaperKind::Zv, ShaperKind::Zvd, ShaperKind::Mzv]);
        let shaper = Shaper::new(kind, R::of(frequency), R::ZERO).expect("a shaper");
        let mut now = State::at(R::ZERO);
        let (mut stream, mut line) = stream(&shaper, R::of(period), now);
        let (mut inputs, mut outputs) = (Vec::new(), Vec::new());
        for target in [0.5, -0.3, 0.1] {
            let planned = online::plan(&limits, now, State::at(R::of(target)));
            let ticks = if target == 0.1 { 3_000 } else { 50 + random.below(300) };
            for tick in 1..=ticks {
                now = planned.state_at(R::of(tick as f64 * period));
                inputs.push(now.acceleration.widen());
                outputs.push(stream.tick(now, &mut line).expect("a state").acceleration.widen());
            }
        }
        swung += swing(&inputs, period, frequency);
        left += swing(&outputs, period, frequency);
    }
    println!("{}: a load that swings by {swung:.3} m/s in all is left with {left:.4}", R::NAME);
    assert!(left < 0.01 * swung && swung > 1.0, "{left} {swung}");
}

/// The kind and the frequency change while the axis stands. Else the answer says no, and the stream goes on.
fn a_shaper_changes_at_rest_only<R: Real>() {
    let [zero, one, period] = [0.0, 1.0, 0.001].map(R::of);
    let slow = Shaper::new(ShaperKind::Ei2, R::of(5.0), zero).expect("a shaper");
    let fast = Shaper::new(ShaperKind::Zv, R::of(50.0), zero).expect("a shaper");
    let mut line = vec![zero; slow.size(period).expect("a short shaper")];
    let mut stream = ShaperStream::new(&fast, period, State::at(one), &mut line).expect("a stream");
    assert_eq!(stream.change(&slow, &mut line), Ok(()));
    let moving = State { velocity: one, ..State::at(one) };
    stream.tick(moving, &mut line).expect("a state");
    let before = stream;
    assert_eq!(stream.change(&fast, &mut line), Err(Error::Moving));
    assert_eq!(stream.advance(one), Err(Error::Moving));
    assert_eq!(stream, before);
    let needed = 302;
    assert_eq!(slow.size(period), Some(3 * (needed + 1)));
    for tick in 0..2 * needed {
        assert_eq!(stream.change(&fast, &mut line).is_ok(), tick >= needed, "{tick}");
        if tick >= needed {
            break;
        }
        stream.tick(State::at(one), &mut line).expect("a state");
    }
    assert_eq!(stream.tick(State::at(one), &mut line), Ok(State::at(one)));
    // A longer shaper does not fit into a shorter line.
    let before = stream;
    let mut line = vec![zero; fast.size(period).expect("a short shaper")];
    assert_eq!(stream.change(&slow, &mut line), Err(Error::Axes));
    assert_eq!(stream.tick(State::at(one), &mut line[1..]), Err(Error::Axes));
    for bad in [f64::NAN, f64::INFINITY].map(R::of) {
        assert_eq!(stream.tick(State { velocity: bad, ..State::at(one) }, &mut line), Err(Error::NotFinite));
        assert_eq!(stream.advance(bad), Err(Error::NotFinite));
        assert_eq!(fast.size(bad), None);
    }
    assert_eq!(stream, before);
    for bad in [zero, -one, R::of(1e-12)] {
        assert_eq!(ShaperStream::new(&slow, bad, State::at(one), &mut line), Err(Error::Duration));
    }
}

/// The advance adds the velocity to the position, and the derivatives are those of the sum.
fn an_extruder_is_advanced<R: Real>() {
    let [period, advance] = [0.001, 0.05].map(R::of);
    let shaper = Shaper::smooth(R::of(0.02)).expect("a time");
    let rest = State::at(R::ZERO);
    let [(mut plain, mut a), (mut advanced, mut b)] = [(); 2].map(|()| stream(&shaper, period, rest));
    advanced.advance(advance).expect("it stands");
    let limits = online::symmetric(500.0, 20.0, 2.0);
    let planned = online::plan(&limits, rest, State::at(R::ONE));
    let mut before = [0.0; 3];
    for tick in 1..1_500 {
        let now = planned.state_at(R::of(f64::from(tick) * 0.001));
        let one = numbers(plain.tick(now, &mut a).expect("a state"));
        let other = numbers(advanced.tick(now, &mut b).expect("a state"));
        let jerk = (one[2] - before[2]) / 0.001;
        for (k, slope) in [one[1], one[2], jerk].into_iter().enumerate() {
            let off = (other[k] - one[k] - 0.05 * slope).abs();
            assert!(off < 1e4 * R::MACHINE_EPSILON.widen() * [1.0, 20.0, 2e4][k], "{tick}, {k}: {off:e}");
        }
        before = one;
    }
    assert_eq!(advanced.tick(State::at(R::ONE), &mut b), Ok(State::at(R::ONE)));
}

/// At each tick the motor is within half a step of the axis, each step comes when the axis passes its line, and steps are in order.
fn no_step_is_lost<R: Real>() {
    let mut random = Random::seeded(383);
    let epsilon = R::MACHINE_EPSILON.widen();
    let (mut steps, mut reversals) = (0_u64, 0_u64);
    for number in 0..SOURCES {
        let mut source = Source::<R>::new(&mut random);
        let period = source.period.widen();
        let [v, _, j] = source.highest();
        let step = (v * period * random.magnitude(-1.0, 1.0)).max(64.0 * epsilon * 32.0);
        let mut motor = StepStream::new(R::of(step), source.period, source.now()).expect("a motor");
        let mut direction = 0;
        for tick in 0..4_000 {
            if random.one_in(300) {
                source.plan_again(&mut random);
            }
            let begin = source.ticks;
            let now = source.tick();
            motor.tick(now).expect("a state");
            let (mut last, mut line) = (0.0, f64::from(motor.count()));
            while let Some(taken) = motor.next() {
                let time = taken.time.widen();
                assert!(time >= last && time <= period, "{number}, {tick}: {time} after {last}");
                let passed = (line + 0.5 * f64::from(taken.direction)) * step;
                let at = source.move_in_force.position(R::of(f64::from(begin) * period + time)).widen();
                // A position has the roundings of the farthest one of its move, 32 at most, and of the time.
                let rounding = 8.0 * epsilon * (32.0 + v * period * f64::from(begin + 1));
                assert!((at - passed).abs() <= 0.05 * j * period.powi(3) + rounding, "{number}, {tick}: {at} {passed}");
                last = time;
                line += f64::from(taken.direction);
                reversals += u64::from(taken.direction == -direction);
                (steps, direction) = (steps + 1, taken.direction);
            }
            let off = (f64::from(motor.count()) * step - now.position.widen()).abs();
            assert!(off <= 0.5 * step + 8.0 * epsilon * now.position.widen().abs(), "{number}, {tick}: {off} {step}");
        }
    }
    assert!(steps > 250 * SOURCES as u64 && reversals > SOURCES as u64 / 4, "{steps} {reversals}");
}

/// A driver gets the time that it asks for between two steps, before a reversal, and before the first step. No step is lost.
fn a_driver_gets_its_time<R: Real>() {
    let mut random = Random::seeded(384);
    for number in 0..SOURCES / 4 {
        let mut source = Source::<R>::new(&mut random);
        let period = source.period.widen();
        let [v, ..] = source.highest();
        let step = v * period * random.magnitude(-0.5, 0.5);
        let mut motor = StepStream::new(R::of(step), source.period, source.now()).expect("a motor");
        // Up to ten times the period, so that steps wait for later ticks; the highest speed needs a step every `step / v`.
        let between = random.between(0.0, 0.5) * step / v;
        let reversal = period * random.magnitude(-1.0, 1.0);
        motor.wait(R::of(between), R::of(reversal)).expect("two times");
        let (mut last, mut direction) = (0.0, 0);
        for tick in 0..6_000 {
            if tick < 4_000 && random.one_in(200) {
                source.plan_again(&mut random);
            }
            // At last it stands.
            let now = if tick < 4_000 { source.tick() } else { State::at(source.now().position) };
            motor.tick(now).expect("a state");
            while let Some(taken) = motor.next() {
                let time = f64::from(tick) * period + taken.time.widen();
                let wait = if taken.direction == direction { between } else { reversal.max(between) };
                let slack = 64.0 * R::MACHINE_EPSILON.widen() * (period + reversal);
                assert!(time >= last + wait - slack - 1e-12, "{number}, {tick}: {time} {last} {wait}");
                (last, direction) = (time, taken.direction);
            }
        }
        let position = source.now().position.widen();
        let off = (f64::from(motor.count()) * step - position).abs();
        assert!(off <= 0.5 * step + 8.0 * R::MACHINE_EPSILON.widen() * position.abs(), "{number}: {off} {step}");
    }
}

/// Steps that nobody asks for in their tick come in the next one. Bad numbers are refused, and nothing changes.
fn a_tick_without_questions_loses_nothing<R: Real>() {
    let [zero, one, tenth, period] = [0.0, 1.0, 0.1, 0.001].map(R::of);
    let mut motor = StepStream::new(tenth, period, State::at(zero)).expect("a motor");
    motor.tick(State::at(one)).expect("a state");
    motor.tick(State::at(one)).expect("a state");
    let all: Vec<_> = std::iter::from_fn(|| motor.next()).collect();
    assert!(all.len() == 10 && all.iter().all(|step| step.time == zero && step.direction == 1), "{all:?}");
    let mut later = StepStream::new(tenth, period, State::at(zero)).expect("a motor");
    later.wait(zero, R::of(0.0015)).expect("a time");
    let first = [(); 2].map(|()| later.tick(State::at(one)).ok().and_then(|()| later.next()));
    assert!(first[0].is_none() && first[1].is_some_and(|step| (step.time.widen() - 0.0005).abs() < 1e-9), "{first:?}");
    let before = motor;
    let moving = |velocity| State { velocity, ..State::at(one) };
    for bad in [moving(R::NAN), State::at(R::INFINITY), State::at(R::of(2e8))] {
        assert_eq!(motor.tick(bad), Err(Error::NotFinite));
    }
    assert_eq!(motor.wait(-one, zero), Err(Error::Duration));
    assert_eq!(motor.wait(zero, R::NAN), Err(Error::Duration));
    assert_eq!(motor, before);
    assert_eq!(StepStream::new(zero, period, State::at(zero)), Err(Error::Limits));
    assert_eq!(StepStream::new(R::NAN, period, State::at(zero)), Err(Error::NotFinite));
    assert_eq!(StepStream::new(tenth, zero, State::at(zero)), Err(Error::Duration));
    assert_eq!(StepStream::new(tenth, period, State::at(R::NAN)), Err(Error::NotFinite));
}

/// An axis that creeps over a line in one direction steps over it once, though the positions of two ticks differs by rounding.
#[test]
fn a_slow_axis_does_not_chatter() {
    let mut motor = StepStream::new(0.01_f32, 1e-3, State::at(1000.0)).expect("a motor");
    let (mut taken, mut forward) = (0, true);
    for tick in 1..=200_000 {
        // 0.05 mm/s at 1 m: a tick moves less than a rounding of the position.
        let position = (1000.0 + 5e-5 * f64::from(tick)) as f32;
        motor.tick(State { velocity: 0.05, ..State::at(position) }).expect("a state");
        while let Some(step) = motor.next() {
            forward &= step.direction == 1;
            taken += 1;
        }
    }
    assert!(forward && taken == 1000, "{taken}");
}

test_both_reals!(
    a_shaped_state_is_the_mean_of_the_past, a_retarget_leaves_a_load_at_rest, a_shaper_changes_at_rest_only,
    an_extruder_is_advanced, no_step_is_lost, a_driver_gets_its_time, a_tick_without_questions_loses_nothing
);
