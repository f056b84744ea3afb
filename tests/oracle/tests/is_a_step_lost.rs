//! Is a step of a motor lost, doubled, late or early, in moves with reversals? A search in 80 bits answers.

use oracle::judge::steps::{all, wrong};
use support::prelude::*;

const MOVES: usize = if support::BRIEF { 10_000 } else { 100_000 };

fn problem<R: Real>(random: &mut Random) -> (Move<R>, [R; 2]) {
    let (_, from, planned) = online::planned::<R>(random);
    let reached = planned.extremes();
    let span = reached.highest.position.widen() - reached.lowest.position.widen();
    let size = from.position.widen().abs() + span;
    let step = span.max(1e-3 * size) * random.magnitude(-2.5, 0.3);
    let offset = match random.below(8) {
        0 => from.position,
        1 => planned.position(planned.t),
        2 => reached.highest.position, // a line at the turn
        _ => R::of(random.between(-step, step)),
    };
    (planned, [offset, R::of(step)])
}

fn no_step_is_lost<R: Real>() {
    let mut random = Random::seeded(27);
    let (mut count, mut reversals, mut back) = (0_usize, 0_usize, 0_usize);
    for number in 0..MOVES {
        let (planned, lines @ [offset, step]) = problem::<R>(&mut random);
        let motor = Steps::new(&planned, offset, step).expect("few steps");
        let mut end = motor;
        while end.next(&planned).is_some() {}
        let steps = all(&planned, motor);
        assert_eq!(wrong(&planned, lines, motor.count(), &steps), None, "move {number}: {lines:?} {planned:?}");
        // The motor is at the line of the end, also where another motor begins there.
        let sum: i32 = steps.iter().map(|step| step.direction).sum();
        assert_eq!(motor.count() + sum, end.count(), "move {number}");
        let mut there = Move::default();
        there.phase[0].position = planned.position(planned.t);
        assert_eq!(end.count(), Steps::new(&there, offset, step).expect("a line").count(), "move {number}");
        count += steps.len();
        back += usize::from(sum != 0 && steps.len() > sum.unsigned_abs() as usize);
        let turns = |pair: &&[Step<R>]| pair[0].direction != pair[1].direction;
        reversals += steps.windows(2).filter(turns).count();
    }
    println!("{}: {count} steps of {MOVES} moves, {reversals} reversals", R::NAME);
    assert!(count > 20 * MOVES && back > MOVES / 20);
}

/// A motor begins at the last line that is not above the start.
fn starts_on_lines<R: Real>() {
    for line in -4..=4_i8 {
        let start = R::of(f64::from(line));
        for (offset, expected) in [(0.0, line), (1e-3, line - 1), (-1e-3, line)] {
            let mut there = Move::default();
            there.phase[0].position = start;
            let motor = Steps::new(&there, R::of(offset), R::ONE).expect("a line");
            assert_eq!(motor.count(), expected.into(), "{line} {offset}");
        }
    }
}

/// The judge must see a step that is lost, doubled, later or earlier, and two that are exchanged.
fn faults_are_seen<R: Real>() {
    let mut random = Random::seeded(28);
    let mut planted = 0;
    while planted < 1_000 {
        let (planned, lines @ [offset, step]) = problem::<R>(&mut random);
        let motor = Steps::new(&planned, offset, step).expect("few steps");
        let steps = all(&planned, motor);
        if steps.len() < 20 {
            continue;
        }
        planted += 1;
        let at = 5 + random.below(steps.len() - 10);
        let apart = steps[at + 1].time.widen() - steps[at].time.widen();
        let moved = |by: f64| {
            let mut moved = steps.clone();
            moved[at].time = R::of(moved[at].time.widen() + by);
            moved
        };
        let without = [&steps[..at], &steps[at + 1..]].concat();
        let doubled = [&steps[..at], &steps[at..=at], &steps[at..]].concat();
        let mut turned = steps.clone();
        turned[at].direction = -turned[at].direction;
        let distinct = apart > 1e-3 * planned.t.widen();
        let late = distinct.then(|| moved(0.5 * apart));
        let early = distinct.then(|| moved(-0.5 * apart));
        for fault in [Some(without), Some(doubled), Some(turned), late, early].iter().flatten() {
            assert!(wrong(&planned, lines, motor.count(), fault).is_some(), "step {at}: {lines:?} {planned:?}");
        }
    }
}

test_both_reals!(no_step_is_lost, faults_are_seen, starts_on_lines);
