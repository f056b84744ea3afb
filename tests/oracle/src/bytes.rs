//! Cases as strings of bytes, which is what a fuzzer changes.
//!
//! The first byte is the real type: odd for `f32`. The arguments of the family's `gen` follow in little endian, and then a
//! byte and a number for each time. Missing bytes are 0. A problem for the planners of the fastest moves has no times.

use crate::abi::Original;
use crate::comparison::{Case, MOMENTS, Moment, Report};
use crate::judge::{Duration, Fastest, Planner, Trial};
use support::family::{MOST_ARGUMENTS, MOST_FIELDS};
use support::{Family, Ours, Random, Real};

/// Puts the case through ours and the original. Panics if they differ.
pub fn compare(family: Family, bytes: &[u8]) {
    match bytes.split_first() {
        Some((real, case)) if real % 2 == 1 => compare_as::<f32>(family, case),
        Some((_, case)) => compare_as::<f64>(family, case),
        None => {}
    }
}

fn compare_as<R: Original>(family: Family, bytes: &[u8]) {
    let mut report = Report::default();
    report.compare(&Ours, &R::ORIGINAL, &decode(family, bytes));
    report.assert_same();
}

/// Plans the move for the least time as a bell and as a trapezoid. Panics if numbers are refused, or if the motion is wrong.
pub fn plan(bytes: &[u8]) {
    match bytes.split_first() {
        Some((real, case)) if real % 2 == 1 => plan_as::<f32>(case),
        Some((_, case)) => plan_as::<f64>(case),
        None => {}
    }
}

fn plan_as<R: Original>(mut bytes: &[u8]) {
    let arguments: [R; 7] = std::array::from_fn(|_| number(&mut bytes));
    let mut random = Random::seeded(0);
    for family in [Family::Bell, Family::Trap] {
        // Any bits must not panic. Only moves whose powers of time the real type can hold must be planned.
        let plan = Fastest.plan(family, &arguments);
        let Some(trial) = Trial::of_any(family, &arguments) else {
            continue;
        };
        let plan = plan.unwrap_or_else(|| panic!("{family:?} {arguments:?} is refused"));
        let wrong = trial.wrong_motion(&plan, &mut random);
        assert!(wrong.is_none(), "{family:?} {arguments:?}: {wrong:?}");
        let duration = trial.duration(plan[0].widen());
        let least = matches!(duration, Duration::Least(_));
        assert!(least, "{family:?} {arguments:?}: {duration:?}");
    }
}

fn decode<R: Real>(family: Family, mut bytes: &[u8]) -> Case<R> {
    let mut arguments = [R::of(0.0); MOST_ARGUMENTS];
    for argument in arguments.iter_mut().take(family.arguments().len()) {
        *argument = number(&mut bytes);
    }
    let mut moment = || {
        let kind = take(&mut bytes, 1) as usize;
        let number = number::<R>(&mut bytes);
        match kind % 3 {
            0 => Moment::At(number),
            1 => Moment::Fraction(number),
            _ => Moment::Border {
                index: kind / 3,
                steps: kind as i8 / 43,
            },
        }
    };
    Case {
        family,
        arguments,
        before: [R::of(0.0); MOST_FIELDS],
        planned: true,
        moments: [(); MOMENTS].map(|()| moment()),
    }
}

fn number<R: Real>(bytes: &mut &[u8]) -> R {
    R::from_low_bits(take(bytes, size_of::<R>()))
}

/// The next `count` bytes.
fn take(bytes: &mut &[u8], count: usize) -> u64 {
    let (taken, rest) = bytes.split_at(count.min(bytes.len()));
    *bytes = rest;
    taken
        .iter()
        .rev()
        .fold(0, |number, &byte| number << 8 | u64::from(byte))
}

/// The bytes of a move and of times at which to evaluate it.
pub fn encode<R: Real>(arguments: &[R], times: &[R]) -> Vec<u8> {
    let mut bytes = vec![u8::from(size_of::<R>() == 4)];
    for &argument in arguments {
        bytes.extend(
            argument
                .low_bits()
                .to_le_bytes()
                .iter()
                .take(size_of::<R>()),
        );
    }
    for &time in times.iter().take(MOMENTS) {
        bytes.push(0);
        bytes.extend(time.low_bits().to_le_bytes().iter().take(size_of::<R>()));
    }
    bytes
}
