//! Does a control loop that plans anew at every tick arrive when its first plan said? Targets are passed in motion, where an axis that is late
//! by a rounding has a detour before it.

use atraj::axes::{line, synchronise};
use atraj::online::{Limits, Move};
use atraj::{Error, Findings, State};
use support::{Random, Real, test_both_reals};

fn loops() -> usize {
    std::env::var("LOOPS").map_or(300, |x| x.parse().unwrap())
}
/// s
const CYCLE: f64 = 1e-3;
/// How many ticks later than the first plan a loop may arrive.
const SPARE: usize = 2;

/// How a loop plans.
type Plan<R> =
    fn(&mut [Move<R>], &[Limits<R>], &[State<R>], &[State<R>]) -> Result<Findings, Error>;

struct Problem<R> {
    limits: Vec<Limits<R>>,
    from: Vec<State<R>>,
    to: Vec<State<R>>,
}

fn single<R: Real>(
    axes: &mut [Move<R>],
    limits: &[Limits<R>],
    from: &[State<R>],
    to: &[State<R>],
) -> Result<Findings, Error> {
    axes[0].plan(&limits[0], from[0], to[0])
}

fn together<R: Real>(
    axes: &mut [Move<R>],
    limits: &[Limits<R>],
    from: &[State<R>],
    to: &[State<R>],
) -> Result<Findings, Error> {
    synchronise(axes, limits, from, to, R::of(0.0), R::of(CYCLE))
}

fn straight<R: Real>(
    axes: &mut [Move<R>],
    limits: &[Limits<R>],
    from: &[State<R>],
    to: &[State<R>],
) -> Result<Findings, Error> {
    line(axes, limits, from, to, R::of(0.0), R::of(CYCLE))
}

/// What the ends of a problem are like.
#[derive(Clone, Copy, Debug)]
enum Ends {
    /// The target has a velocity.
    Moving,
    /// The same, at the position 0, where positions have the finest roundings.
    AtZero,
    /// The target has a velocity and an acceleration.
    Accelerated,
}

/// One axis of a problem.
fn axis<R: Real>(random: &mut Random, ends: Ends) -> (Limits<R>, State<R>, State<R>) {
    let mut pair = |low: f64, high: f64| {
        let most = random.between(low, high);
        let least = if random.one_in(2) {
            most
        } else {
            random.between(low, high)
        };
        (most, -least)
    };
    let ((vmax, vmin), (amax, amin), (jmax, jmin)) =
        (pair(1.0, 5.0), pair(1.0, 10.0), pair(1.0, 60.0));
    let limits = Limits {
        vmax,
        vmin,
        amax,
        amin,
        jmax,
        jmin,
    };
    let mut state = |accelerated: bool| {
        let a = if accelerated {
            random.between(amin, amax)
        } else {
            0.0
        };
        let (above, below) = (0.51 * a * a / -jmin, 0.51 * a * a / jmax);
        let (a, above, below) = if vmin + below < vmax - above {
            (a, above, below)
        } else {
            (0.0, 0.0, 0.0)
        };
        let velocity = random.between(vmin + below, vmax - above);
        (random.between(-1.0, 1.0), velocity, a)
    };
    let from = state(true);
    let mut to = state(matches!(ends, Ends::Accelerated));
    if matches!(ends, Ends::AtZero) {
        to.0 = 0.0;
    }
    let real = |(p, v, a): (f64, f64, f64)| State {
        position: R::of(p),
        velocity: R::of(v),
        acceleration: R::of(a),
    };
    let of = |limits: Limits<f64>| {
        let Limits {
            vmax,
            vmin,
            amax,
            amin,
            jmax,
            jmin,
        } = limits;
        Limits {
            vmax: R::of(vmax),
            vmin: R::of(vmin),
            amax: R::of(amax),
            amin: R::of(amin),
            jmax: R::of(jmax),
            jmin: R::of(jmin),
        }
    };
    (of(limits), real(from), real(to))
}

/// Axes of their own.
fn free<R: Real>(random: &mut Random, ends: Ends, count: usize) -> Problem<R> {
    let axes: Vec<_> = (0..count).map(|_| axis(random, ends)).collect();
    Problem {
        limits: axes.iter().map(|axis| axis.0).collect(),
        from: axes.iter().map(|axis| axis.1).collect(),
        to: axes.iter().map(|axis| axis.2).collect(),
    }
}

/// Axes on a line, each with limits of its own.
fn on_a_line<R: Real>(random: &mut Random, ends: Ends, count: usize) -> Problem<R> {
    let (limits, from, to) = axis::<R>(random, ends);
    let shares: Vec<f64> = (0..count)
        .map(|index| {
            if index == 0 {
                1.0
            } else {
                random.between(-1.0, 1.0)
            }
        })
        .collect();
    let scaled = |state: State<R>| {
        shares
            .iter()
            .map(|share| {
                let times = |x: R| R::of(share * x.widen());
                State {
                    position: times(state.position),
                    velocity: times(state.velocity),
                    acceleration: times(state.acceleration),
                }
            })
            .collect::<Vec<_>>()
    };
    Problem {
        limits: vec![limits; count],
        from: scaled(from),
        to: scaled(to),
    }
}

/// How many ticks a loop takes longer than its first plan said. `None` if a plan is refused.
fn late<R: Real>(plan: Plan<R>, problem: &Problem<R>) -> Option<usize> {
    let Problem { limits, from, to } = problem;
    let mut from = from.clone();
    let mut axes = vec![Move::default(); from.len()];
    let mut promised = 0;
    for tick in 0.. {
        if let Err(error) = plan(&mut axes, limits, &from, to) {
            if tick > 0 && std::env::var("SHOW").is_ok() {
                println!("  {error:?} at {tick} of {promised}: {limits:?} {from:?} {to:?}");
            }
            return None;
        }
        if tick == 0 {
            promised = (axes[0].t.widen() / CYCLE).ceil() as usize;
        }
        if tick > promised + SPARE || axes[0].t.widen() <= 1.01 * CYCLE {
            return Some((tick + 1).saturating_sub(promised));
        }
        if std::env::var("SHOW").is_ok() {
            let left = axes[0].t.widen() / CYCLE + tick as f64 - promised as f64;
            if left > 2.0 {
                if std::env::var("SHOW").unwrap() == "2" {
                    println!("  tick {limits:?} {:?} {to:?}", problem.from);
                    return Some(3);
                }

                println!("  tick {tick} of {promised}: {left} late: {limits:?} {from:?} {to:?}");
                return Some(3);
            }
        }
        for (from, axis) in from.iter_mut().zip(&axes) {
            *from = axis.state_at(R::of(CYCLE));
        }
    }
    None
}

fn loops_arrive_in_time<R: Real>() {
    let mut random = Random::seeded(24);
    let mut bad = 0;
    for ends in [Ends::Moving, Ends::AtZero, Ends::Accelerated] {
        let plans: [(&str, Plan<R>, &[usize]); 3] = [
            ("plan", single, &[1]),
            ("together", together, &[1, 3, 6]),
            ("line", straight, &[1, 3, 6]),
        ];
        for (name, plan, counts) in plans {
            for &count in counts {
                if std::env::var("ONLY").is_ok_and(|only| only != format!("{name}{count}")) {
                    continue;
                }
                let (mut refused, mut too_late) = (0, 0);
                let mut worst = 0;
                for _ in 0..loops() {
                    let problem = if name == "line" {
                        on_a_line(&mut random, ends, count)
                    } else {
                        free(&mut random, ends, count)
                    };
                    let mut axes = vec![Move::default(); count];
                    let Problem { limits, from, to } = &problem;
                    if plan(&mut axes, limits, from, to).is_err() || axes[0].t.widen() > 1.5 {
                        continue;
                    }
                    match late(plan, &problem) {
                        None => refused += 1,
                        Some(ticks) if ticks > SPARE => {
                            too_late += 1;
                            worst = worst.max(ticks);
                        }
                        Some(_) => {}
                    }
                }
                println!(
                    "{ends:?} {name} {count}: {refused} refused, {too_late} late of {}",
                    loops()
                );
                bad += refused + too_late;
            }
        }
    }
    assert_eq!(bad, 0);
}

test_both_reals!(loops_arrive_in_time);
