//! The handover of moves between the main loop, which plans, and the interrupt, which ticks: loads and stores of words, no lock, no wait.
//!
//! Three places hold moves. One move is in force. One may wait for its tick. The main loop plans into the third. A place is its index.
//!
//! | word | written by | holds |
//! |---|---|---|
//! | `now` | the interrupt | the tick, the place of the move in force, and whether the interrupt is deciding |
//! | `halves` | the interrupt | for how many halves of the counter's range a move is in force, rounded down, and its place |
//! | `due` | the main loop | the `now` at which a move takes over, and the place of this move |
//! | `starts` | the main loop | the tick at which the move at each place takes over |
//!
//! **The interrupt decides.** It counts the tick, stores `now`, and then loads `due`. If `due` is for this `now`, the other move takes
//! over. Then the interrupt stores `now` once more, with the place that it decided for. So a move takes over at its own tick or never,
//! and from no move but the one that it was planned from.
//!
//! **The main loop learns.** It stores `due` and then loads `now`. With a fence on each side, at least one of them sees what the other
//! has stored. If `now` is before the tick of the plan, the interrupt will see the plan in time. If `now` has the place of the plan, the
//! interrupt has taken it. Else the plan is late, and the main loop withdraws it: `due` says that the move in force goes on.
//! On one processor an interrupt is over before the main loop goes on, so the answer is the truth. On two processors the interrupt
//! may be deciding while the main loop looks. Without a wait nobody could tell, so the answer is that the plan is late. And while the
//! interrupt is deciding, the main loop plans nothing.
//!
//! **Nobody writes what the other one reads.** The interrupt reads the place in `now`. The main loop writes a place that is neither in
//! `now` nor in a `due` that is ahead. A place that leaves `due` was never in force, because its tick was ahead. A place that leaves
//! `now` is not read again, because the interrupt looks there before it stores the `now` of the next tick.
//!
//! **The counter wraps**, after 74 hours at 1 kHz. It starts shortly before, so every test passes the wrap. The age of a move has 55
//! bits: the upper ones are `halves`, the lower ones are a difference of ticks. The main loop loads `halves` first, so it may miss the
//! last half. The highest bit of the difference is also the lowest bit of `halves`, and decides. A `halves` of another place is for the
//! move before, and the move in force is young.
//!
//! Between its store of `due` and its look at `now`, the main loop must not be held up for 74 hours.

use super::atomic::Ordering::{Acquire, Relaxed, Release, SeqCst};
use super::atomic::{AtomicU32, fence};

const PLACE_BITS: u32 = 2;
/// `due` holds a tick and two places.
const TICK_BITS: u32 = 32 - 2 * PLACE_BITS;
const HALF: u32 = 1 << (TICK_BITS - 1);
const TICKS: u32 = 2 * HALF - 1;
/// In `now`, above the tick and the place.
const DECIDES: u32 = 1 << 31;

#[derive(Debug)]
#[repr(C)]
pub(crate) struct Handover {
    now: AtomicU32,
    halves: AtomicU32,
    due: AtomicU32,
    starts: [AtomicU32; 3],
}

/// A move in force, and for how many ticks it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Moment {
    pub place: usize,
    pub age: u64,
}

/// How a new move takes over.
#[derive(Debug)]
pub(crate) struct Takeover {
    /// The move that is in force until then.
    pub from: Moment,
    /// The place of the new move.
    pub place: usize,
    /// In how many ticks the new move takes over.
    pub ticks: u32,
    time: About,
}

/// A number, and the place that it is about: the words `now` and `halves`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct About(u32);

impl About {
    fn new(number: u32, place: usize) -> Self {
        Self((number & TICKS) << PLACE_BITS | place as u32)
    }

    fn number(self) -> u32 {
        (self.0 >> PLACE_BITS) & TICKS
    }

    fn place(self) -> usize {
        (self.0 & 3) as usize
    }

    fn after(self, ticks: u32) -> Self {
        Self::new(self.number().wrapping_add(ticks), self.place())
    }

    /// The word `due`: at this `now` the move at `place` takes over.
    fn due(self, place: usize) -> u32 {
        self.0 << PLACE_BITS | place as u32
    }

    fn of_due(due: u32) -> (Self, usize) {
        (Self(due >> PLACE_BITS), (due & 3) as usize)
    }
}

/// What stands at a place.
pub(crate) fn at<T>([a, b, c]: &[T; 3], place: usize) -> &T {
    match place {
        0 => a,
        1 => b,
        _ => c,
    }
}

impl Handover {
    /// The move at place 0 is in force.
    pub fn new() -> Self {
        let first = About::new(TICKS - 1000, 0);
        let start = || AtomicU32::new(first.number());
        Self {
            now: AtomicU32::new(first.0),
            halves: AtomicU32::new(0),
            due: AtomicU32::new(first.after(TICKS).due(0)),
            starts: [start(), start(), start()],
        }
    }

    /// The interrupt: counts a tick. Returns the move in force.
    pub fn tick(&self) -> Moment {
        let mut now = About(self.now.load(Relaxed)).after(1);
        self.now.store(now.0 | DECIDES, Release);
        fence(SeqCst);
        let (time, place) = About::of_due(self.due.load(Acquire));
        if time == now {
            now = About::new(now.number(), place);
        }
        let age = self.age(About(self.halves.load(Relaxed)), now);
        let halves = About::new((age / u64::from(HALF)) as u32, now.place());
        self.halves.store(halves.0, Release);
        self.now.store(now.0, Release);
        Moment { place: now.place(), age }
    }

    /// The main loop, before it plans: where to plan to, and from where. The new move takes over after `lead` ticks. If a move waits for its tick, the new
    /// one replaces it, and takes over in that tick or earlier. `None` if `lead` is 0 or half of the counter's range, or if the interrupt may be deciding.
    pub fn prepare(&self, lead: u32) -> Option<Takeover> {
        let halves = About(self.halves.load(Acquire));
        let now = About(self.now.load(Acquire));
        let (due, last) = About::of_due(self.due.load(Relaxed));
        if lead == 0 || lead >= HALF || now.0 & DECIDES != 0 {
            return None;
        }
        let waits = due.place() == now.place() && last != now.place();
        let until = due.number().wrapping_sub(now.number()) & TICKS;
        let ticks = if waits { lead.min(until) } else { lead };
        let is_free = |&place: &usize| place != now.place() && !(waits && place == last);
        Some(Takeover {
            from: Moment { place: now.place(), age: self.age(halves, now) + u64::from(ticks) },
            place: (0..2).find(is_free).unwrap_or(2),
            ticks,
            time: now.after(ticks),
        })
    }

    /// The main loop, after it has planned: whether the move takes over.
    pub fn publish(&self, takeover: &Takeover) -> bool {
        let Takeover { from, place, time, .. } = *takeover;
        at(&self.starts, place).store(time.number(), Relaxed);
        self.due.store(time.due(place), Release);
        fence(SeqCst);
        let halves = About(self.halves.load(Acquire));
        let now = About(self.now.load(Acquire));
        let goes_on = now.place() == from.place && halves.place() == from.place;
        let waits = goes_on && self.age(halves, now) < from.age;
        let takes_over = waits || now.place() == place;
        if !takes_over {
            self.due.store(time.due(from.place), Release);
        }
        takes_over
    }

    /// For how many ticks the move has been in force.
    fn age(&self, halves: About, now: About) -> u64 {
        let start = at(&self.starts, now.place()).load(Relaxed);
        let ticks = now.number().wrapping_sub(start) & TICKS;
        let known = if halves.place() == now.place() { halves.number() } else { 0 };
        let missing = (known ^ (ticks / HALF)) & 1;
        u64::from(known + missing) * u64::from(HALF) + u64::from(ticks % HALF)
    }
}
