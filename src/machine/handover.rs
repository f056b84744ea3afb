//! The handover of moves between the main loop, which plans, and the interrupt, which ticks: loads and stores of words, no lock, no wait.
//!
//! Three places hold moves. One move is in force. One may wait for its tick. The main loop plans into the third. A place is known by its
//! index.
//!
//! | word | written by | holds |
//! |---|---|---|
//! | `now` | the interrupt | the tick, and the place of the move in force |
//! | `halves` | the interrupt | for how many halves of the counter's range this move is in force, rounded down |
//! | `due` | the main loop | the `now` at which a move takes over, and its place |
//! | `starts` | the main loop | the tick at which each move takes over |
//!
//! **The interrupt decides.** It counts the tick, stores `now` and then loads `due`. If `due` is for this `now`, it stores `now` with the
//! other place. So a plan takes over at its own tick or never, and never from another move than the one that it was planned from.
//!
//! **The main loop learns.** It stores `due` and then loads `now`. A fence on either side lets at least one of them see the other's store. So if
//! `now` is before the tick of the plan, then the interrupt will see the plan in time. If `now` has the place of the plan, then the
//! interrupt has taken it. Else the plan is late, and the main loop withdraws it: at that tick, the move in force goes on.
//! An interrupt is over before the main loop goes on, so on one processor the answer is always the truth. On two processors the
//! interrupt may be deciding while the main loop looks. Nobody could tell then without a wait, and the answer is that the plan is late. Until the next
//! tick the main loop touches no place, because `due` is for `now`.
//!
//! **Nobody writes what another reads.** The interrupt reads the place in `now`, from the tick at which it takes over. The main loop writes the
//! place that is neither in `now` nor in `due`. A place that leaves `due` was never in force: its tick was ahead. A place that leaves
//! `now` is not read again: the interrupt stores the new `now` after its last look at the old place.
//!
//! **The counter wraps**, after 74 hours at 1 kHz. It starts shortly before, so every test passes the wrap. The age of a move has 59
//! bits: its lower bits are a difference of ticks, its upper bits are `halves`. The main loop may see `halves` of a moment ago. The
//! lowest bit of `halves` is also the highest of the difference, and tells whether one is missing.
//!
//! From its store of `due` to its look at `now`, the main loop must not be held up for 74 hours.

use super::atomic::Ordering::{Acquire, Relaxed, Release, SeqCst};
use super::atomic::{AtomicU32, fence};

const PLACE_BITS: u32 = 2;
/// `due` holds a tick and two places.
const TICK_BITS: u32 = 32 - 2 * PLACE_BITS;
const HALF: u32 = 1 << (TICK_BITS - 1);
const TICKS: u32 = 2 * HALF - 1;

/// The words.
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
    time: Time,
}

/// A tick, and the place of the move that is in force when it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Time(u32);

impl Time {
    fn new(tick: u32, place: usize) -> Self {
        Self((tick & TICKS) << PLACE_BITS | place as u32)
    }

    fn tick(self) -> u32 {
        self.0 >> PLACE_BITS
    }

    fn place(self) -> usize {
        (self.0 & 3) as usize
    }

    fn after(self, ticks: u32) -> Self {
        Self::new(self.tick().wrapping_add(ticks), self.place())
    }

    /// The word `due`: at this time the move at `place` takes over.
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
        let first = Time::new(TICKS - 1000, 0);
        let start = || AtomicU32::new(first.tick());
        Self {
            now: AtomicU32::new(first.0),
            halves: AtomicU32::new(0),
            due: AtomicU32::new(first.after(TICKS).due(0)),
            starts: [start(), start(), start()],
        }
    }

    /// The interrupt: counts a tick. Returns the move in force.
    pub fn tick(&self) -> Moment {
        let mut now = Time(self.now.load(Relaxed)).after(1);
        self.now.store(now.0, Release);
        fence(SeqCst);
        let (time, place) = Time::of_due(self.due.load(Acquire));
        let mut halves = self.halves.load(Relaxed);
        if time == now && place != now.place() {
            now = Time::new(now.tick(), place);
            halves = 0;
        }
        let age = self.age(halves, now);
        self.halves.store((age / u64::from(HALF)) as u32, Relaxed);
        self.now.store(now.0, Release);
        Moment {
            place: now.place(),
            age,
        }
    }

    /// The main loop, before it plans: where to plan to, and from where. The new move takes over after `lead` ticks. If a move waits, the new one
    /// replaces it, and does not take over later. `None` if `lead` is 0 or half of the counter's range, or if the interrupt may be deciding.
    pub fn prepare(&self, lead: u32) -> Option<Takeover> {
        let now = Time(self.now.load(Acquire));
        let halves = self.halves.load(Relaxed);
        let (due, last) = Time::of_due(self.due.load(Relaxed));
        if lead == 0 || lead >= HALF || due == now {
            return None;
        }
        let waits = due.place() == now.place() && last != now.place();
        let until = due.tick().wrapping_sub(now.tick()) & TICKS;
        let time = now.after(if waits { lead.min(until) } else { lead });
        Some(Takeover {
            from: Moment {
                place: now.place(),
                age: self.age(halves, time),
            },
            place: (0..2)
                .find(|&place| place != now.place() && !(waits && place == last))
                .unwrap_or(2),
            time,
        })
    }

    /// The main loop, after it has planned: whether the move takes over.
    pub fn publish(&self, takeover: &Takeover) -> bool {
        let Takeover { from, place, time } = *takeover;
        at(&self.starts, place).store(time.tick(), Relaxed);
        self.due.store(time.due(place), Release);
        fence(SeqCst);
        // In this order: `halves` must not be newer than `now`.
        let halves = self.halves.load(Acquire);
        let now = Time(self.now.load(Acquire));
        let waits = now.place() == from.place && self.age(halves, now) < from.age;
        let takes_over = waits || now.place() == place;
        if !takes_over {
            self.due.store(time.due(from.place), Release);
        }
        takes_over
    }

    /// For how many ticks the move has been in force. `halves` are those of the age, or one less.
    fn age(&self, halves: u32, time: Time) -> u64 {
        let start = at(&self.starts, time.place()).load(Relaxed);
        let ticks = time.tick().wrapping_sub(start) & TICKS;
        let missing = ((ticks / HALF) ^ halves) & 1;
        u64::from(halves.wrapping_add(missing)) * u64::from(HALF) + u64::from(ticks % HALF)
    }
}
