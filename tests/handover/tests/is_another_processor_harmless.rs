//! Does the interrupt ever see half a plan, or a jump, if it runs on another processor? loom tries every order of loads and stores that
//! the language allows, with at most three switches that no thread asked for.

use handover::{Handover, Plan, is_seen, two_processors};
use loom::cell::UnsafeCell;
use loom::sync::Arc;
use loom::thread;

struct Axis<H> {
    words: H,
    plans: [UnsafeCell<Plan>; 3],
}
// SAFETY: this is what the test asks. loom sees an access that is not ordered.
unsafe impl<H: Sync> Sync for Axis<H> {}

impl<H: Handover> Axis<H> {
    fn plan(&self, place: usize) -> Plan {
        // SAFETY: loom checks the access.
        self.plans[place].with(|plan| unsafe { *plan })
    }

    /// The next state follows from the last one, `now`.
    fn tick(&self, now: (usize, u64)) -> (usize, u64) {
        let (place, next) = self.words.tick();
        let plan = self.plan(place);
        plan.follows(now, next);
        (plan.id, next)
    }

    fn go(&self, id: usize, lead: u32) -> bool {
        let Some(takeover) = self.words.prepare(lead) else { return false };
        let (from, age, place) = H::places(&takeover);
        let plan = Plan { id, from: (self.plan(from).id, age), is_whole: true };
        // SAFETY: loom checks the access.
        self.plans[place].with_mut(|next| unsafe { *next = plan });
        self.words.publish(&takeover)
    }
}

/// One thread ticks while the other one plans with these leads, after some ticks. An accepted plan takes over if no other call comes behind it.
fn run<H: Handover + Send + Sync + 'static>(ticks_before: usize, ticks: usize, leads: &'static [u32]) {
    let mut model = loom::model::Builder::new();
    model.preemption_bound = Some(3);
    model.check(move || {
        let axis = Arc::new(Axis { words: H::new(), plans: std::array::from_fn(|_| UnsafeCell::new(Plan::default())) });
        let now = (0..ticks_before).fold((0, 0), |now, _| axis.tick(now));
        let interrupt = thread::spawn({
            let axis = axis.clone();
            move || (0..ticks).fold(now, |now, _| axis.tick(now))
        });
        let accepted = (1..).zip(leads).map(|(id, &lead)| (id, axis.go(id, lead))).last();
        let now = interrupt.join().unwrap();
        let (id, _) = (0..8).fold(now, |now, _| axis.tick(now));
        if let Some((last, true)) = accepted {
            assert_eq!(id, last, "an accepted plan is lost");
        }
    });
}

fn all<H: Handover + Send + Sync + 'static>() {
    run::<H>(0, 3, &[1]);
    run::<H>(0, 3, &[2]);
    run::<H>(0, 3, &[1, 1]);
    run::<H>(0, 3, &[2, 1]);
    run::<H>(0, 2, &[2, 1, 1]);
    run::<H>(0, 4, &[1, 1, 1]);
    // The age of the move passes half of the counter's range.
    run::<H>(6, 3, &[2]);
    run::<H>(6, 3, &[1, 1]);
}

#[test]
fn in_every_order() {
    all::<two_processors::whole::Variant>();
}

#[test]
fn planted_faults_are_seen() {
    use two_processors::*;
    std::panic::set_hook(Box::new(|_| {}));
    is_seen(all::<unfenced_tick::Variant>, "no fence in the tick");
    is_seen(all::<unfenced_publish::Variant>, "no fence in the publication");
    is_seen(all::<relaxed_store::Variant>, "a plan is published before it is whole");
    is_seen(all::<relaxed_tick::Variant>, "a plan is read before it is whole");
    is_seen(all::<while_it_decides::Variant>, "a move is planned while it takes over");
    is_seen(all::<relaxed_prepare::Variant>, "the look before the plan is not ordered");
}
