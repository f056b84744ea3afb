//! Does each plan take over in its own tick or never, wherever the interrupt comes? On one processor, all places are tried.

use handover::one_processor::{self, atomic};
use handover::{Handover, Plan, is_seen};
use std::cell::{Cell, RefCell};
use std::rc::Rc;

struct Axis<H> {
    words: H,
    plans: [Cell<Plan>; 3],
    now: Cell<(usize, u64)>, // the move that the interrupt follows, and its age
    taken: RefCell<Vec<usize>>,
}

impl<H: Handover> Axis<H> {
    fn new() -> Self {
        let rest = Plan { is_whole: true, ..Plan::default() };
        Self {
            words: H::new(),
            plans: [Cell::new(rest), Cell::default(), Cell::default()],
            now: Cell::default(),
            taken: RefCell::default(),
        }
    }

    /// The interrupt. The next state follows from the last one.
    fn tick(&self) {
        let now = self.now.get();
        let (place, next) = self.words.tick();
        let plan = self.plans[place].get();
        assert!(plan.is_whole, "half a plan");
        plan.follows(now, next);
        if plan.id != now.0 {
            self.taken.borrow_mut().push(plan.id);
        }
        self.now.set((plan.id, next));
    }

    /// The main loop: the plan, if there was one to make, and whether it was accepted.
    fn go(&self, id: usize, lead: u32) -> Option<(Plan, bool)> {
        let takeover = self.words.prepare(lead)?;
        let (from, age, place) = H::places(&takeover);
        self.plans[place].set(Plan::default());
        atomic::step();
        let plan = Plan { id, from: (self.plans[from].get().id, age), is_whole: true };
        atomic::step();
        self.plans[place].set(plan);
        Some((plan, self.words.publish(&takeover)))
    }
}

/// Calls with these leads, in which the interrupt comes before the given steps. Returns the number of steps, and how many plans were accepted.
fn run<H: Handover + 'static>(ticks_before: u64, leads: &[u32], interrupted: &[usize]) -> (usize, usize) {
    let axis = Rc::new(Axis::<H>::new());
    (0..ticks_before).for_each(|_| axis.tick());
    let steps = Rc::new(Cell::new(0));
    let interrupt = {
        let (axis, steps, interrupted) = (axis.clone(), steps.clone(), interrupted.to_vec());
        move || {
            interrupted.iter().filter(|&&step| step == steps.get()).for_each(|_| axis.tick());
            steps.set(steps.get() + 1);
        }
    };
    atomic::set_interrupt(Some(Rc::new(interrupt)));
    let answers: Vec<_> = (1..).zip(leads).map(|(id, &lead)| axis.go(id, lead)).collect();
    atomic::set_interrupt(None);
    // The counter wraps once more.
    (0..20).for_each(|_| axis.tick());
    let taken = axis.taken.borrow();
    let mut accepted = 0;
    for (call, answer) in answers.iter().enumerate() {
        let is_taken = taken.contains(&(call + 1));
        let is_last = answers[call + 1..].iter().all(Option::is_none); // a later call may replace a plan
        match answer {
            Some((_, true)) => assert!(is_taken || !is_last, "an accepted plan is lost"),
            Some((_, false)) => assert!(!is_taken, "a late plan takes over"),
            None => {}
        }
        if let (Some((plan, true)), Some(Some((later, true)))) = (answer, answers.get(call + 1)) {
            assert!(later.from.0 != plan.from.0 || later.from.1 <= plan.from.1, "a plan is replaced by a later one");
        }
        accepted += usize::from(matches!(answer, Some((_, true))));
    }
    (steps.get(), accepted)
}

/// Calls `run` with every choice of `ticks` steps. Returns the number of runs, and of plans in them that were not accepted.
fn everywhere<H: Handover + 'static>(ticks_before: u64, leads: &[u32], ticks: usize) -> (usize, usize) {
    let (steps, _) = run::<H>(ticks_before, leads, &[]);
    let mut interrupted = vec![0; ticks];
    let (mut runs, mut late) = (0, 0);
    loop {
        let (_, accepted) = run::<H>(ticks_before, leads, &interrupted);
        runs += 1;
        late += leads.len() - accepted;
        // The next choice in order: steps that do not fall.
        let Some(at) = interrupted.iter().rposition(|&step| step < steps) else { return (runs, late) };
        let next = interrupted[at] + 1;
        interrupted[at..].fill(next);
    }
}

/// Calls of which one waits, is replaced by an earlier one, by a later one; in the wrap of the counter, and at half of its range.
fn all<H: Handover + 'static>() -> (usize, usize) {
    let mut sum = (0, 0);
    for ticks_before in [0, 1, 4, 9, 12, 17, 30] {
        let of_one: [(&[u32], _); 2] = [(&[1], 5), (&[3], 6)];
        let of_two: [(&[u32], _); 6] =
            [(&[1, 1], 5), (&[2, 2], 5), (&[3, 1], 5), (&[1, 3], 4), (&[5, 2], 4), (&[7, 7], 3)];
        let of_three: [(&[u32], _); 3] = [(&[3, 2, 2], 3), (&[2, 1, 1], 3), (&[1, 2, 3], 3)];
        for (leads, ticks) in of_one.into_iter().chain(of_two).chain(of_three) {
            let (runs, late) = everywhere::<H>(ticks_before, leads, ticks);
            sum = (sum.0 + runs, sum.1 + late);
        }
    }
    sum
}

#[test]
fn wherever_it_comes() {
    let (runs, late) = all::<one_processor::whole::Variant>();
    assert!(runs > 1_000_000 && late > 100_000, "{runs} runs, {late} plans late");
}

#[test]
fn planted_faults_are_seen() {
    use one_processor::*;
    std::panic::set_hook(Box::new(|_| {}));
    is_seen(all::<always_in_time::Variant>, "every plan is accepted");
    is_seen(all::<never_withdrawn::Variant>, "a late plan stays published");
    is_seen(all::<from_any_move::Variant>, "a plan takes over from any move");
    is_seen(all::<in_any_tick::Variant>, "a plan takes over in any tick");
    is_seen(all::<without_halves::Variant>, "the age of a move wraps");
    is_seen(all::<of_another_place::Variant>, "a young move has the age of the one before");
    is_seen(all::<without_missing::Variant>, "the upper bits of the age are late");
}
