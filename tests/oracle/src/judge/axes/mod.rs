//! The judge of several axes that move together: random sets of axes, and faults that the judge must see.

pub mod faults;
pub mod line;
pub mod loops;
pub mod problems;
pub mod several;

use super::{Tallies, Verdict};
use crate::liba::Original;
use several::Planner;
use support::Random;

pub use problems::{Family, Set, Sets};

pub const SETS_PER_SEED: usize = 10_000; // sets that a seed stands for in long runs

/// Judges the planner by so many sets of a seed. Every fourth one lies on a line.
pub fn of_seed<R: Original>(planner: &impl Planner<R>, seed: u64, sets: usize) -> Tallies {
    let mut tallies = Tallies::default();
    let mut random = Random::seeded(!seed);
    let on_lines = sets / 4;
    let together = Sets::<R>::new(seed).take(sets - on_lines);
    let lines = Sets::<R>::on_lines(seed).take(on_lines);
    for (is_line, set) in together.map(|set| (false, set)).chain(lines.map(|set| (true, set))) {
        let judged =
            if is_line { line::judge(planner, &set, &mut random) } else { several::judge(planner, &set, &mut random) };
        let (axis, verdict) = judged.err().unwrap_or((0, Verdict::Good { error: 0.0, detour: false }));
        let way = if is_line { "line" } else { "together" };
        let tally = tallies.row([usize::from(is_line), set.family as usize], || format!("{way} {:?}", set.family));
        tally.note(&verdict, || format!("axis {axis} of {}", set.show()));
    }
    tallies
}
