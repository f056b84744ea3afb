//! The handover of `src/machine/handover.rs`, compiled with other atomics, and faulty variants of it.

use std::panic::{AssertUnwindSafe, catch_unwind};

pub trait Handover {
    type Takeover;
    fn new() -> Self;
    fn tick(&self) -> (usize, u64); // the place of the move in force, and its age
    fn prepare(&self, lead: u32) -> Option<Self::Takeover>;
    fn publish(&self, takeover: &Self::Takeover) -> bool;
    /// The place and the age of the move in force at the takeover, and the place of the new move.
    fn places(takeover: &Self::Takeover) -> (usize, u64, usize);
}

/// What a planner knows of a move: the one that it goes on from, and the age of that one then.
#[derive(Clone, Copy, Debug, Default)]
pub struct Plan {
    pub id: usize,
    pub from: (usize, u64),
    pub is_whole: bool,
}

impl Plan {
    /// The state after one that was followed: the same move goes on, or a move that was planned from this very state.
    pub fn follows(&self, (id, age): (usize, u64), next: u64) {
        if self.id == id {
            assert_eq!(next, age + 1, "a jump in a move");
        } else {
            assert_eq!((self.from, next), ((id, age + 1), 0), "a jump between two moves");
        }
    }
}

/// Whether a test of a faulty variant fails.
pub fn is_seen<T>(test: fn() -> T, fault: &str) {
    assert!(catch_unwind(AssertUnwindSafe(test)).is_err(), "{fault}");
}

macro_rules! variants {
    ($($name:ident)+) => {$(
        #[allow(clippy::all, dead_code, unused)]
        pub mod $name {
            include!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".rs"));

            pub struct Variant(Handover);
            pub struct Way(Takeover);

            impl crate::Handover for Variant {
                type Takeover = Way;
                fn new() -> Self {
                    Self(Handover::new())
                }
                fn tick(&self) -> (usize, u64) {
                    let moment = self.0.tick();
                    (moment.place, moment.age)
                }
                fn prepare(&self, lead: u32) -> Option<Way> {
                    self.0.prepare(lead).map(Way)
                }
                fn publish(&self, takeover: &Way) -> bool {
                    self.0.publish(&takeover.0)
                }
                fn places(takeover: &Way) -> (usize, u64, usize) {
                    let Takeover { from, place, .. } = takeover.0;
                    (from.place, from.age, place)
                }
            }
        }
    )+};
}

/// On one processor, an interrupt is over before the main loop goes on. It may come before each access to a word.
pub mod one_processor {
    pub mod atomic {
        pub use core::sync::atomic::Ordering;
        use std::cell::{Cell, RefCell};
        use std::rc::Rc;

        thread_local! {
            static INTERRUPT: RefCell<Option<Rc<dyn Fn()>>> = const { RefCell::new(None) };
        }

        pub fn set_interrupt(interrupt: Option<Rc<dyn Fn()>>) {
            INTERRUPT.set(interrupt);
        }

        /// A step of the main loop. The steps of an interrupt are not interrupted.
        pub fn step() {
            if let Some(interrupt) = INTERRUPT.take() {
                interrupt();
                INTERRUPT.set(Some(interrupt));
            }
        }

        #[derive(Debug)]
        pub struct AtomicU32(Cell<u32>);

        impl AtomicU32 {
            pub const fn new(x: u32) -> Self {
                Self(Cell::new(x))
            }
            pub fn load(&self, _: Ordering) -> u32 {
                step();
                self.0.get()
            }
            pub fn store(&self, x: u32, _: Ordering) {
                step();
                self.0.set(x);
            }
        }

        pub fn fence(_: Ordering) {}
    }

    variants! { whole always_in_time never_withdrawn from_any_move in_any_tick without_halves without_missing of_another_place }
}

/// On two processors, what one does may reach the other in any order that the language allows.
pub mod two_processors {
    pub use loom::sync::atomic;

    variants! { whole unfenced_tick unfenced_publish relaxed_store relaxed_tick relaxed_prepare while_it_decides }
}
