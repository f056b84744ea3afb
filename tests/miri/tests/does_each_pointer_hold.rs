//! Does each C function read and write no other memory than its caller promised, and only initialised memory? Miri is the judge.
//!
//! A table says for each function how many elements each argument points to. The test calls each function with arguments of its types: with
//! NULL, with ordinary values and with arbitrary bytes. Each array is a heap allocation of its own, of just the promised length, so Miri sees one
//! element too many. Natively the tests see a panic, a wrong answer, and a write to what a function may only read.

use atraj::capi::a::{trajbell::*, trajpoly3::*, trajpoly5::*, trajpoly7::*, trajtrap::*};
use atraj::capi::{atraj::*, claraty::*};
use std::collections::BTreeSet;
use std::ffi::{CStr, c_char, c_int, c_uint, c_void};
use std::hint::black_box;
use std::mem::MaybeUninit;
use std::ptr::{null, null_mut};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::thread;
use support::Random;

enum Promise {
    Any,                 // any value
    Given(usize),        // this number of elements, which are given; as an integer the number itself
    Numbers(usize, f64), // this number of elements, each of which is this number where arguments are ordinary
    Written(usize),      // room for this number of elements, all of which are written
    Room(usize),         // room for this number of elements, which need not be initialised
}

#[rustfmt::skip]
macro_rules! promise {
    (_) => { Promise::Any };
    (($count:tt of $value:expr)) => { Promise::Numbers($count, $value) };
    ([$count:expr]) => { Promise::Written($count) };
    ({$count:expr}) => { Promise::Room($count) };
    ($count:expr) => { Promise::Given($count) };
}

/// A call of a function with arguments for `n` axes, samples or waypoints.
type Call = fn(&mut Caller, n: usize) -> Answer;

/// `names: (arguments);` where `3` are three elements to read, `[3]` three to write, `{3}` room for three, and `_` is any value.
macro_rules! table {
    (|$n:ident| $($($name:ident)+: $arguments:tt;)*) => {
        const FUNCTIONS: &[(&str, Call)] = &[$($((stringify!($name), |caller, $n| {
            let _ = $n;
            call!(caller $name $arguments)
        })),+),*];
    };
}

macro_rules! call {
    ($caller:ident $name:ident ($($argument:tt)*)) => {
        // SAFETY: each argument keeps what the table promises.
        #[allow(unused_unsafe, reason = "two functions are safe")]
        unsafe { $name($($caller.argument(promise!($argument))),*) }.into()
    };
}

table! { |n|
    a_trajbell_gen a_trajpoly5_gen0: ({1} _ _ _ _ _ _ _);
    a_trajbell_pos a_trajbell_vel a_trajbell_acc a_trajbell_jer a_trajpoly3_pos a_trajpoly3_vel a_trajpoly3_acc
        a_trajpoly5_pos a_trajpoly5_vel a_trajpoly5_acc a_trajpoly7_pos a_trajpoly7_vel a_trajpoly7_acc
        a_trajpoly7_jer a_trajtrap_pos a_trajtrap_vel a_trajtrap_acc: (1 _);
    a_trajpoly3_gen: ([1] _ _ _ _ _);
    a_trajpoly3_gen0: ({1} _ _ _ _ _);
    a_trajpoly3_gen1 a_trajpoly3_gen2 a_trajpoly5_gen1 a_trajpoly5_gen2 a_trajpoly7_gen1 a_trajpoly7_gen2
        a_trajpoly7_gen3: (1);
    a_trajpoly5_gen: ([1] _ _ _ _ _ _ _);
    a_trajpoly7_gen: ([1] _ _ _ _ _ _ _ _ _);
    a_trajpoly7_gen0: ({1} _ _ _ _ _ _ _ _ _);
    a_trajtrap_gen: ({1} _ (1 of 10.0) (1 of -10.0) _ _ _ _);
    atraj_axis_go atraj_group_go atraj_group_line atraj_group_sync: (1 1 1 (1 of 2.0));
    atraj_axis_init: ({1} _ 1);
    atraj_axis_reach: (1 1 _ _ (1 of 2.0));
    atraj_axis_stop atraj_group_stop: (1 1 (1 of 2.0));
    atraj_axis_tick atraj_group_tick: (1 [1]);
    atraj_axis_track: (1 1 1 _ _ (1 of 2.0));
    atraj_bell_check: (1 _ _ _);
    atraj_bell_extremes atraj_trap_extremes: (1 [3] [3]);
    atraj_bell_gen: ({1} _ _ _ _ _ _ _);
    atraj_bell_sample atraj_move_sample atraj_poly7_sample: (1 _ _ n [n] [n] [n] [n]);
    atraj_bell_state atraj_move_state atraj_poly7_state: (1 _ [1] [1] [1] [1]);
    atraj_clock_rate: (1 (n * n) n n n _ _);
    atraj_clock_rebase atraj_clock_time atraj_move_acc atraj_move_jer atraj_move_pos atraj_move_vel
        atraj_shaper_stream_advance: (1 _);
    atraj_clock_start: ({1});
    atraj_clock_state: (1 (n * n) n n _ [1] [1] [1] [1]);
    atraj_clock_until atraj_step_stream_count: (1);
    atraj_group_init: ({1} _ n {3 * n} n);
    atraj_group_path: (1 1 n n _ (1 of 2.0));
    atraj_group_rate: (1 1 _ (1 of 2.0));
    atraj_group_time: (1 (1 of 2.0));
    atraj_group_within: (1 (1 of -9.0) (1 of 9.0));
    atraj_limits_init: ([1] _ _ _);
    atraj_message: (_);
    atraj_move_check atraj_step_stream_tick atraj_steps_follow: (1 1);
    atraj_move_extremes: (1 [1] [1]);
    atraj_move_meet atraj_move_plan: ({1} 1 1 1);
    atraj_move_reach: ({1} 1 1 _ _);
    atraj_move_stop: ({1} 1 1);
    atraj_move_time_at: (1 (1 of 1.0));
    atraj_move_track: ({1} 1 1 1 _ _);
    atraj_move_within: ({1} 1 1 1 (1 of -9.0) (1 of 9.0));
    atraj_moves_line atraj_moves_sync: ({n} n n n n _ _);
    atraj_moves_line_stop: (n n n _);
    atraj_moves_sync_within: ({n} n n n (n of -9.0) (n of 9.0) n _ _);
    atraj_path_contour: ({n * n} (n * n + n) {n} {n + 1} n (1 of 1000.0) n n n (1 of 1.0) {atraj_path_size(n, n)});
    atraj_path_contour_zones: ({n * n} (n * n + n) {n} {n + 1} (n * n) (1 of 1000.0) n n n (1 of 1.0) {atraj_path_size(n, n)});
    atraj_path_deviation: ((n * n) n n);
    atraj_path_feed: ((n * n) (n * n + n) (n of 9.0) n n);
    atraj_path_improve: ((n * n + n) n n n n (1 of 1.0) {atraj_path_size(n, n)});
    atraj_path_moves: ({n * n} n (n * n + n) (n of 9.0) n n);
    atraj_path_moves_zones: ({n * n} (n * n) (n * n + n) (n of 9.0) n n);
    atraj_path_plan: ((n * n + n) {n} n n n (1 of 1.0) {atraj_path_size(n, n)});
    atraj_path_plan_near: ((n * n + n) {n} n ((n * n - n) of 0.5) n n (1 of 1.0) {atraj_path_size_near(n, n)});
    atraj_path_plan_zones: ((n * n + n) {n} (n * n) n n (1 of 1.0) {atraj_path_size(n, n)});
    atraj_path_size atraj_path_size_near: (n n);
    atraj_poly3_extremes atraj_poly5_extremes atraj_poly7_extremes: (1 _ [3] [3]);
    atraj_poly3_sample atraj_poly5_sample atraj_trap_sample: (1 _ _ n [n] [n] [n]);
    atraj_poly3_state atraj_poly5_state atraj_trap_state: (1 _ [1] [1] [1]);
    atraj_shaper_add: (1 _ _ (1 of 0.1));
    atraj_shaper_bell_state atraj_shaper_state: (1 1 _ [1]);
    atraj_shaper_init: ({1} _ _ (1 of 0.1));
    atraj_shaper_size: (1 (1 of 0.01));
    atraj_shaper_smooth: ({1} _);
    atraj_shaper_stream_change: (1 1 {LINE} LINE);
    atraj_shaper_stream_init: ({1} 1 (1 of 0.01) 1 {LINE} LINE);
    atraj_shaper_stream_tick: (1 1 LINE LINE [1]);
    atraj_step_stream_init: ({1} _ _ 1);
    atraj_step_stream_next: (1 {1});
    atraj_step_stream_wait: (1 _ _);
    atraj_steps_init: ({1} 1 _ _);
    atraj_steps_next: (1 1 {1});
    atraj_trap_check: (1 _ (1 of 10.0) (1 of -10.0));
    atraj_trap_gen: ({1} _ (1 of 10.0) (1 of -10.0) _ _ _ _);
    claraty_trapezoid_advance_timer_by claraty_trapezoid_get_acceleration_at claraty_trapezoid_get_position_at
        claraty_trapezoid_get_velocity_at claraty_trapezoid_set_mode: (1 _);
    claraty_trapezoid_duration claraty_trapezoid_elapsed claraty_trapezoid_get_acceleration
        claraty_trapezoid_get_position claraty_trapezoid_get_velocity claraty_trapezoid_is_started
        claraty_trapezoid_reset claraty_trapezoid_start claraty_trapezoid_stop: (1);
    claraty_trapezoid_get_profile: (1 [1]);
    claraty_trapezoid_get_setpoint: (1 {1} {1} {1});
    claraty_trapezoid_get_setpoint_at: (1 _ {1} {1} {1});
    claraty_trapezoid_init: ({1});
    claraty_trapezoid_set: (1 _ _ _ _);
    claraty_trapezoid_set_clock: (1 _ 1);
    claraty_trapezoid_set_uniform_waypoints: (1 n n _ _);
    claraty_trapezoid_set_waypoints: (1 n n n n);
}

#[derive(Debug)]
enum Answer {
    Nothing,
    Number(f64),
    Code(c_int),
    Count(usize),
    Text(*const c_char),
}

macro_rules! answers {
    ($($kind:ident($type:ty)),*) => {
        $(impl From<$type> for Answer {
            fn from(value: $type) -> Self {
                Self::$kind(value)
            }
        })*
    };
}
answers!(Number(f64), Code(c_int), Count(usize), Text(*const c_char));

impl From<()> for Answer {
    fn from((): ()) -> Self {
        Self::Nothing
    }
}

/// Functions whose answer is a number of steps or of numbers, and no code.
const COUNTS: [&str; 3] = ["atraj_steps_next", "atraj_step_stream_next", "atraj_step_stream_count"];
const SIZES: [&str; 2] = ["atraj_path_size", "atraj_shaper_size"];
const LINE: usize = 4096; // how many numbers a delay line has: enough for each ordinary shaper

impl Answer {
    /// Whether this is the documented answer of a function to NULL for each pointer.
    fn is_for_null(&self, name: &str) -> bool {
        match *self {
            Self::Nothing => true,
            Self::Number(x) if name.starts_with("a_") && name.ends_with("_gen") => x == 0.0,
            Self::Number(x) => x.is_nan(),
            Self::Code(code) if COUNTS.contains(&name) => code == 0,
            Self::Code(code) => code == -1,
            Self::Count(count) => count == 0 || name.starts_with("atraj_path_size"),
            Self::Text(_) => name == "atraj_message",
        }
    }

    fn is_documented(&self, name: &str, n: usize) -> bool {
        match *self {
            Self::Nothing | Self::Number(_) => true,
            Self::Code(code) => COUNTS.contains(&name) || (-10..256).contains(&code),
            Self::Count(count) => count <= n || SIZES.iter().any(|size| name.starts_with(size)),
            // SAFETY: a text lasts as long as the program.
            Self::Text(text) => !unsafe { CStr::from_ptr(text) }.is_empty(),
        }
    }

    fn is_success(&self) -> bool {
        match *self {
            Self::Number(x) => !x.is_nan(),
            Self::Code(code) => code >= 0,
            _ => true,
        }
    }
}

#[derive(Clone, Copy, Default, PartialEq)]
enum Contents {
    #[default]
    Ordinary,
    Arbitrary,
    Mixed, // each argument is one or the other
}

#[derive(Clone, Copy, Default, PartialEq)]
enum Null {
    #[default]
    None,
    Some,
    All,
    One(usize), // the pointer of this number alone
}

#[derive(Default)]
struct Caller {
    contents: Contents,
    null: Null,
    random: Random,
    is_at_rest: bool,
    keeps: bool,        // whether all memory is initialised before the call and compared after it
    bad: Option<usize>, // the number that is NaN, if one is
    pointers: usize,    // how many pointers and numbers there were
    numbers: usize,
    lacks: Option<Promise>, // what was promised of the pointer that is NULL alone
    arrays: Vec<Array>,
}

struct Array {
    words: *mut [Word],
    before: Vec<u64>,                     // what a function may not change
    read: Option<fn(*const Word, usize)>, // reads what a function has to write
    count: usize,
}
type Word = MaybeUninit<u64>;

impl Drop for Array {
    fn drop(&mut self) {
        // SAFETY: the allocation came from a box, and nobody uses it any more.
        drop(unsafe { Box::from_raw(self.words) });
    }
}

impl Caller {
    fn new(contents: Contents, null: Null, seed: u64) -> Self {
        Self { contents, null, random: Random(seed), is_at_rest: seed.is_multiple_of(2), ..Self::default() }
    }

    fn argument<A: Argument>(&mut self, promise: Promise) -> A {
        let contents = self.contents;
        if contents == Contents::Mixed {
            self.contents = [Contents::Ordinary, Contents::Arbitrary][self.below(2)];
        }
        let argument = A::of(self, promise);
        self.contents = contents;
        argument
    }

    fn below(&mut self, end: usize) -> usize {
        (self.random.bits() >> 33) as usize % end
    }

    /// From 0.1 to 2.
    fn ordinary(&mut self) -> f64 {
        0.1 + 1.9 * self.below(1000) as f64 / 1000.0
    }

    /// Bits of an ordinary number, of an extreme one, two small integers, or any.
    fn arbitrary(&mut self) -> u64 {
        let extreme = [0.0, -0.0, -1.0, 1e-320, 1e300, -1e300, f64::INFINITY, f64::NAN];
        match self.below(4) {
            0 => self.ordinary().to_bits(),
            1 => extreme[self.below(extreme.len())].to_bits(),
            2 => (self.below(20) as u64) << 32 | self.below(20) as u64,
            _ => self.random.bits(),
        }
    }

    fn number(&mut self) -> f64 {
        if self.contents == Contents::Ordinary { self.ordinary() } else { f64::from_bits(self.arbitrary()) }
    }

    fn integer(&mut self) -> u32 {
        if self.contents == Contents::Ordinary { self.below(3) as u32 } else { self.arbitrary() as u32 }
    }

    fn is_bad(&mut self) -> bool {
        self.numbers += 1;
        self.bad == Some(self.numbers - 1)
    }

    fn is_null(&mut self) -> bool {
        self.pointers += 1;
        match self.null {
            Null::One(k) => self.pointers - 1 == k,
            Null::None => false,
            Null::Some => self.below(4) == 0,
            Null::All => true,
        }
    }

    fn array<T: Element>(&mut self, promise: &Promise, is_const: bool) -> *mut T {
        let (Promise::Given(count) | Promise::Numbers(count, _) | Promise::Written(count) | Promise::Room(count)) =
            *promise
        else {
            panic!("a pointer to nothing")
        };
        let is_output = matches!(promise, Promise::Written(_) | Promise::Room(_));
        let words = Box::into_raw(Box::<[u64]>::new_uninit_slice(count * T::WORDS));
        let first = words.cast::<Word>();
        for k in 0..count {
            // SAFETY: the element is inside, and there are as many words as it has.
            unsafe {
                let element = first.add(k * T::WORDS);
                match *promise {
                    Promise::Numbers(_, value) if self.contents == Contents::Ordinary => {
                        element.cast::<f64>().write(value);
                    }
                    Promise::Given(_) | Promise::Numbers(..) => T::fill(self, element),
                    _ => {}
                }
                for word in 0..T::WORDS {
                    if is_output && self.keeps {
                        (*element.add(word)).write(self.arbitrary());
                    } else if !is_output && T::ARE_NUMBERS && self.is_bad() {
                        (*element.add(word)).write(f64::NAN.to_bits());
                    }
                }
            }
        }
        let mut before = Vec::new();
        let is_all_written = self.contents == Contents::Arbitrary && (is_const || self.keeps) && !T::IS_MADE;
        if is_all_written || is_output && self.keeps {
            // SAFETY: all words are initialised.
            before.extend(unsafe { &*words }.iter().map(|word| unsafe { word.assume_init() }));
        }
        let read = matches!(promise, Promise::Written(_)).then_some(read::<T> as _);
        self.arrays.push(Array { words, before, read, count });
        first.cast()
    }

    fn judge(&self, name: &str) {
        for array in &self.arrays {
            // SAFETY: the array is there, and nobody uses it now.
            let words = unsafe { &*array.words };
            for (word, before) in words.iter().zip(&array.before) {
                // SAFETY: the word was initialised before the call.
                let after = unsafe { word.assume_init() };
                assert!(after == *before || self.keeps && f64::from_bits(after).is_nan(), "{name}: overwritten");
            }
            if let (Some(read), Null::None, false) = (array.read, self.null, self.keeps) {
                read(words.as_ptr(), array.count);
            }
        }
    }
}

/// Miri stops here if an element is not initialised.
fn read<T: Element>(first: *const Word, count: usize) {
    for k in 0..count {
        // SAFETY: the element is inside, and the function that was called has written it.
        black_box(unsafe { first.cast::<T>().add(k).read() });
    }
}

trait Argument {
    fn of(caller: &mut Caller, promise: Promise) -> Self;
}

impl Argument for f64 {
    fn of(caller: &mut Caller, promise: Promise) -> Self {
        if caller.is_bad() {
            return f64::NAN;
        }
        match (promise, caller.contents) {
            (Promise::Numbers(_, value), Contents::Ordinary) => value,
            _ => caller.number(),
        }
    }
}

impl Argument for c_int {
    fn of(caller: &mut Caller, _: Promise) -> Self {
        caller.integer() as c_int
    }
}

impl Argument for c_uint {
    fn of(caller: &mut Caller, promise: Promise) -> Self {
        match (promise, caller.contents) {
            (Promise::Numbers(_, value), Contents::Ordinary) => value as c_uint,
            _ => caller.integer(),
        }
    }
}

impl Argument for usize {
    fn of(_: &mut Caller, promise: Promise) -> Self {
        let Promise::Given(value) = promise else { panic!("any length") };
        value
    }
}

impl Argument for claraty_clock {
    fn of(caller: &mut Caller, _: Promise) -> Self {
        unsafe extern "C" fn clock(user: *mut c_void) -> f64 {
            // SAFETY: NULL, or a number that stays as long as the handle.
            unsafe { user.cast::<f64>().as_ref() }.map_or(1.0, |now| *now)
        }
        (!caller.is_null()).then_some(clock)
    }
}

impl<T: Element> Argument for *mut T {
    fn of(caller: &mut Caller, promise: Promise) -> Self {
        if caller.is_null() {
            caller.lacks = Some(promise);
            return null_mut();
        }
        caller.array(&promise, false)
    }
}

/// Miri lets nobody write through what came from a shared reference.
impl<T: Element> Argument for *const T {
    fn of(caller: &mut Caller, promise: Promise) -> Self {
        if caller.is_null() {
            caller.lacks = Some(promise);
            return null();
        }
        caller.array::<T>(&promise, true);
        // SAFETY: the array was allocated just now.
        let words: &[Word] = unsafe { &*caller.arrays[caller.arrays.len() - 1].words };
        words.as_ptr().cast()
    }
}

/// What a pointer of the C ABI points to. Its alignment is that of a word or less.
trait Element: Sized {
    const WORDS: usize = size_of::<Self>() / size_of::<Word>();
    const IS_MADE: bool = false; // some bytes of a struct that the library makes are not initialised
    const ARE_NUMBERS: bool = false; // a function that plans refuses NaN in each of its words

    /// An ordinary value, where numbers alone are none.
    ///
    /// # Safety
    /// There is room for it, and ordinary numbers are there.
    unsafe fn make(_: &mut Caller, _: *mut Self) {}

    /// # Safety
    /// There is room for `WORDS`.
    unsafe fn fill(caller: &mut Caller, first: *mut Word) {
        for k in 0..Self::WORDS {
            let is_ordinary = caller.contents == Contents::Ordinary;
            let bits = if is_ordinary { caller.ordinary().to_bits() } else { caller.arbitrary() };
            // SAFETY: by the contract of this function.
            unsafe { (*first.add(k)).write(bits) };
        }
        if caller.contents == Contents::Ordinary {
            // SAFETY: by the contract of this function.
            unsafe { Self::make(caller, first.cast()) };
        }
    }
}

impl Element for f64 {
    const ARE_NUMBERS: bool = true;
}
impl Element for usize {
    const WORDS: usize = 1;
}
impl Element for a_trajpoly3 {}
impl Element for a_trajpoly5 {}
impl Element for a_trajpoly7 {}
impl Element for claraty_profile {}
impl Element for c_void {
    const WORDS: usize = 1;
}

macro_rules! made {
    ($($type:ty $(: $are_numbers:literal)? = |$caller:ident, $to:ident| $make:expr;)*) => {
        $(impl Element for $type {
            $(const ARE_NUMBERS: bool = $are_numbers;)?
            unsafe fn make($caller: &mut Caller, $to: *mut Self) {
                // SAFETY: by the contract of this function.
                let answer = Answer::from(unsafe { $make });
                assert!(answer.is_success(), "{}: {answer:?}", stringify!($type));
            }
        })*
    };
}

made! {
    atraj_limits: true = |caller, to| atraj_limits_init(to, 30.0, 10.0, 4.0 + caller.ordinary());
    atraj_state: true = |caller, to| {
        if caller.is_at_rest {
            ((*to).v, (*to).a) = (0.0, 0.0);
        }
    };
    atraj_move = |caller, to| {
        let (limits, from, at) = caller.problem();
        atraj_move_plan(to, &limits, &from, &at)
    };
    a_trajbell = |caller, to| atraj_bell_gen(to, 30.0, 10.0, 5.0, 0.0, caller.ordinary(), 0.0, 0.0);
    a_trajtrap = |caller, to| atraj_trap_gen(to, 5.0, 10.0, -10.0, 0.0, caller.ordinary(), 0.0, 0.0);
    atraj_axis = |caller, to| atraj_axis_init(to, 1e-3, &caller.problem().1);
    atraj_clock = |_caller, to| atraj_clock_start(to);
    atraj_shaper = |caller, to| atraj_shaper_init(to, 0, caller.ordinary(), 0.1);
    atraj_shaper_stream = |caller, to| {
        let (mut shaper, mut line) = (MaybeUninit::uninit(), [0.0; LINE]);
        atraj_shaper_init(shaper.as_mut_ptr(), 0, 5.0, 0.1);
        let start = caller.problem().1;
        atraj_shaper_stream_init(to, shaper.as_ptr(), 0.01, &start, line.as_mut_ptr(), LINE)
    };
    atraj_step_stream = |caller, to| atraj_step_stream_init(to, 0.1, 0.01, &caller.problem().1);
    atraj_steps = |caller, to| {
        let (limits, from, at) = caller.problem();
        let mut planned = MaybeUninit::uninit();
        atraj_move_plan(planned.as_mut_ptr(), &limits, &from, &at);
        atraj_steps_init(to, planned.as_ptr(), 0.0, 0.1)
    };
}

impl Caller {
    fn problem(&mut self) -> (atraj_limits, atraj_state, atraj_state) {
        let mut problem = MaybeUninit::uninit();
        let to: *mut (atraj_limits, atraj_state, atraj_state) = problem.as_mut_ptr();
        // SAFETY: there is room for each, and a C function of this library fills the limits.
        unsafe {
            atraj_limits::fill(self, (&raw mut (*to).0).cast());
            atraj_state::fill(self, (&raw mut (*to).1).cast());
            atraj_state::fill(self, (&raw mut (*to).2).cast());
            problem.assume_init()
        }
    }
}

/// The bytes of a handle are the library's own, so it makes them, of any numbers.
impl Element for claraty_trapezoid {
    const IS_MADE: bool = true;

    unsafe fn fill(caller: &mut Caller, first: *mut Word) {
        let h = first.cast::<Self>();
        let mut x = [0.0; 5];
        x.fill_with(|| caller.number());
        // SAFETY: by the contract of this function.
        unsafe {
            claraty_trapezoid_init(h);
            claraty_trapezoid_set_mode(h, caller.below(2) as c_int);
            claraty_trapezoid_set(h, x[0], x[1], x[2], x[3]);
            claraty_trapezoid_start(h);
            claraty_trapezoid_advance_timer_by(h, x[4]);
        }
    }
}

/// The members of a group point to its room, so the library makes it: of one axis, which moves.
impl Element for atraj_group {
    const IS_MADE: bool = true;

    unsafe fn fill(caller: &mut Caller, first: *mut Word) {
        let room = size_of::<atraj_state>() + 3 * size_of::<atraj_move>();
        let words = Box::into_raw(Box::<[u64]>::new_uninit_slice(room / size_of::<Word>()));
        let states = words.cast::<atraj_state>();
        // SAFETY: there is room for a state and three moves, as long as the caller lives.
        let code = unsafe {
            states.write(atraj_state { p: caller.ordinary(), v: 0.0, a: 0.0 });
            let (mut limits, mut now) = (MaybeUninit::uninit(), MaybeUninit::uninit());
            atraj_limits_init(limits.as_mut_ptr(), 24.0, 8.0, 3.0);
            atraj_group_init(first.cast(), 1e-3, states, states.add(1).cast(), 1)
                + atraj_group_go(first.cast(), limits.as_ptr(), &atraj_state { p: 20.0, v: 0.0, a: 0.0 }, 1)
                + atraj_group_tick(first.cast(), now.as_mut_ptr())
                - atraj_tick::ATRAJ_TICK_BEGINS as c_int
        };
        assert_eq!(code, 0);
        caller.arrays.push(Array { words, before: Vec::new(), read: None, count: 0 });
    }
}

#[test]
fn the_table_has_each_function() {
    let symbols = include_str!("../../symbols.txt").lines();
    assert_eq!(FUNCTIONS.iter().map(|&(name, _)| name).collect::<BTreeSet<_>>(), symbols.collect());
}

/// Calls each function in each round, with arguments for `n` axes, and judges the answer and the memory.
fn each(rounds: &[(Contents, Null, usize)], mut judge: impl FnMut(&'static str, &Answer)) {
    for &(name, call) in FUNCTIONS {
        for (seed, &(contents, null, n)) in rounds.iter().enumerate() {
            let mut caller = Caller::new(contents, null, seed as u64);
            let answer = call(&mut caller, n);
            assert!(answer.is_documented(name, n), "{name}");
            caller.judge(name);
            judge(name, &answer);
        }
    }
}

#[test]
fn null_gets_its_answer() {
    let rounds = [Contents::Ordinary, Contents::Arbitrary].map(|contents| (contents, Null::All, 1));
    each(&rounds, |name, answer| assert!(answer.is_for_null(name), "{name}"));
}

/// Each pointer alone is NULL. A function can do without some outputs; else it answers as to NULL and leaves the memory, or what has no value is NaN.
#[test]
fn each_pointer_alone_gets_its_answer() {
    for &(name, call) in FUNCTIONS {
        let is_optional = |k, lacks| match lacks {
            Some(Promise::Written(_)) => k > 0,
            Some(Promise::Room(_)) => k > 0 && (COUNTS.contains(&name) || name.starts_with("claraty")),
            // A clock that is NULL is the timer's own, and its argument may be NULL.
            _ => k > 0 && name == "claraty_trapezoid_set_clock",
        };
        for k in 0.. {
            let mut caller = Caller { keeps: true, ..Caller::new(Contents::Arbitrary, Null::One(k), k as u64) };
            let answer = call(&mut caller, 1);
            if k >= caller.pointers {
                break;
            }
            assert!(answer.is_documented(name, 1), "{name}, pointer {k}");
            if !is_optional(k, caller.lacks.take()) {
                assert!(answer.is_for_null(name), "{name}, pointer {k}");
                caller.judge(name);
            }
        }
    }
}

/// Each number alone is NaN. A function that plans refuses it and leaves its outputs as they were.
#[test]
fn each_number_alone_is_refused() {
    let mut refused = 0;
    for &(name, call) in FUNCTIONS {
        let plans = name.starts_with("atraj") && (name.ends_with("_gen") || name.ends_with("_check"));
        for k in 0.. {
            let with = |bad: Option<usize>, n| {
                let mut caller = Caller { keeps: bad.is_some(), bad, ..Caller::new(Contents::Ordinary, Null::None, 0) };
                let answer = call(&mut caller, n);
                (caller, answer)
            };
            let is_path = name.starts_with("atraj_path"); // a path of two sections plans the velocity between them
            let n = if !is_path && with(None, 2).1.is_success() { 2 } else { 1 };
            let (mut caller, answer) = with(Some(k), n);
            if k >= caller.numbers {
                break;
            }
            match answer {
                // A delay line belongs to its stream.
                Answer::Code(_) if name == "atraj_shaper_stream_tick" && k >= caller.numbers - LINE => continue,
                // A time that is NaN is after the end, as in an evaluation.
                Answer::Code(_) if name == "atraj_moves_line_stop" && k + 1 == caller.numbers => continue,
                Answer::Code(code) => assert!(code < -1, "{name}, number {k} of {n}: {code}"),
                Answer::Number(x) if plans => assert!(x.is_nan(), "{name}, number {k}: {x}"),
                _ => continue,
            }
            refused += 1;
            if is_path && !name.starts_with("atraj_path_moves") && name != "atraj_path_feed" {
                caller.arrays.pop(); // the working memory
            }
            caller.judge(name);
        }
    }
    assert!(refused > 150, "{refused}");
}

/// Outputs and what is planned first are not initialised before the call, and outputs are after it. In one round a function does what it is asked for.
#[test]
fn ordinary_arguments_are_read_and_all_outputs_written() {
    let mut failed: BTreeSet<_> = FUNCTIONS.iter().map(|&(name, _)| name).collect();
    let rounds = [1, 1, 2].map(|n| (Contents::Ordinary, Null::None, n));
    each(&rounds, |name, answer| {
        if answer.is_success() {
            failed.remove(name);
        }
    });
    // The axes of a group are on no path of random moves. `c_tests/calls.c` follows one.
    assert_eq!(failed, BTreeSet::from(["atraj_group_path"]));
}

#[test]
fn any_bytes_stay_in_their_arrays() {
    use Contents::{Arbitrary, Mixed};
    let rounds = [
        (Arbitrary, Null::None, 0),
        (Arbitrary, Null::None, 1),
        (Arbitrary, Null::None, 3),
        (Arbitrary, Null::Some, 2),
        (Mixed, Null::None, 1),
        (Mixed, Null::None, 2),
        (Mixed, Null::Some, 2),
    ];
    each(&rounds, |_, _| {});
}

#[test]
fn lengths_that_no_array_has_are_refused() {
    const NULL: c_int = atraj_error::ATRAJ_ERR_NULL as c_int;
    let mut caller = Caller::new(Contents::Ordinary, Null::None, 1);
    for [axes, sections] in [[0, 1], [1, 0], [129, 1], [1, 65_537], [usize::MAX; 2]] {
        let states: *mut atraj_state = caller.argument(Promise::Given(1));
        let limits: *const atraj_limits = caller.argument(Promise::Given(1));
        let [durations, work] = [(); 2].map(|()| caller.argument::<*mut f64>(Promise::Given(1)));
        for plan in [atraj_path_plan, atraj_path_improve, atraj_path_plan_zones] {
            // SAFETY: such arrays are refused before they are read.
            let code = unsafe { plan(states, durations, limits, axes, sections, 0, work) };
            assert_eq!(code, NULL);
        }
        let moves: *mut atraj_move = caller.argument(Promise::Room(1));
        let [durations, work] = [(); 2].map(|()| caller.argument::<*mut f64>(Promise::Room(1)));
        let places = caller.argument(Promise::Room(1));
        for plan in [atraj_path_contour, atraj_path_contour_zones] {
            for [sections, room] in [[sections, 1], [1, sections]] {
                // SAFETY: as above.
                let code =
                    unsafe { plan(moves, states, durations, places, limits, 1.0, axes, sections, room, 0, work) };
                assert_eq!(code, NULL);
            }
        }
        for make in [atraj_path_moves, atraj_path_moves_zones] {
            // SAFETY: as above.
            let (code, deviation) = unsafe {
                (make(moves, limits, states, durations, axes, sections), atraj_path_deviation(moves, axes, sections))
            };
            assert!(code == NULL && deviation.is_nan());
        }
    }
    for n in [0, usize::MAX / 8, usize::MAX] {
        let handle = caller.argument(Promise::Given(1));
        let [p, v, a] = [(); 3].map(|()| caller.argument::<*const f64>(Promise::Given(1)));
        // SAFETY: as above.
        let codes = unsafe {
            [
                claraty_trapezoid_set_waypoints(handle, p, v, a, n),
                claraty_trapezoid_set_uniform_waypoints(handle, p, n, 1.0, 1.0),
            ]
        };
        assert_eq!(codes, [claraty_result::CLARATY_ERR_WAYPOINTS as c_int; 2]);
    }
}

/// A product of counts may wrap to one that the arrays have room for.
#[test]
fn impulses_that_no_shaper_has_room_for_are_refused() {
    let mut caller = Caller::new(Contents::Ordinary, Null::None, 1);
    for count in [17, 1 << 31, c_uint::MAX] {
        let shaper: *mut atraj_shaper = caller.argument(Promise::Given(1));
        // SAFETY: the caller owns a shaper.
        let (code, left) = unsafe {
            (*shaper).count = count;
            (atraj_shaper_add(shaper, 0, 1.0, 0.1), (*shaper).count)
        };
        assert_eq!((code, left), (atraj_error::ATRAJ_ERR_LIMITS as c_int, count));
    }
}

/// A place behind the end of its ring, or counts whose sum wraps to one that the delay line has room for.
#[test]
fn a_stream_that_no_function_made_is_refused() {
    let mut caller = Caller::new(Contents::Ordinary, Null::None, 1);
    let changes: [fn(&mut atraj_shaper_stream); 4] =
        [|of| of.at = of.ticks, |of| of.at_mean = of.means, |of| of.ticks = u32::MAX, |of| of.means = u32::MAX];
    for change in changes {
        let stream: *mut atraj_shaper_stream = caller.argument(Promise::Given(1));
        let (now, line) = (caller.argument(Promise::Given(1)), caller.argument(Promise::Given(LINE)));
        let shaped = caller.argument(Promise::Room(1));
        // SAFETY: the caller owns a stream, and the other pointers keep what the table promises.
        let code = unsafe {
            change(&mut *stream);
            atraj_shaper_stream_tick(stream, now, line, LINE, shaped)
        };
        assert_eq!(code, atraj_error::ATRAJ_ERR_NULL as c_int);
    }
}

/// Miri sees a reference to a move that the other thread writes.
#[test]
fn a_thread_ticks_an_axis_that_another_one_plans() {
    struct Shared(*mut atraj_axis);
    // SAFETY: an axis is made for one thread that ticks and one that plans.
    unsafe impl Sync for Shared {}

    let limits = Caller::new(Contents::Ordinary, Null::None, 0).problem().0;
    let state = |p| atraj_state { p, v: 0.0, a: 0.0 };
    let mut axis = MaybeUninit::uninit();
    // SAFETY: there is room for an axis.
    let code = unsafe { atraj_axis_init(axis.as_mut_ptr(), 1e-3, &state(0.0)) };
    assert_eq!(code, 0);
    let shared = &Shared(axis.as_mut_ptr());
    let is_over = &AtomicBool::new(false);
    thread::scope(|scope| {
        scope.spawn(move || {
            let mut last = 0.0;
            for _ in 0..400 {
                let mut now = MaybeUninit::<atraj_state>::uninit();
                // SAFETY: this thread alone ticks, and a tick writes the state.
                let now = unsafe {
                    atraj_axis_tick(shared.0, now.as_mut_ptr());
                    now.assume_init()
                };
                assert!((now.p - last).abs() < 0.01, "a jump from {last} to {}", now.p);
                last = now.p;
                thread::yield_now();
            }
            is_over.store(true, Relaxed);
        });
        for k in 0.. {
            let to = state(if k % 2 == 0 { 1.0 } else { -1.0 });
            // SAFETY: this thread alone plans. A plan may be late.
            unsafe { atraj_axis_go(shared.0, &limits, &to, 20) };
            if is_over.load(Relaxed) {
                break;
            }
        }
    });
    let mut now = state(0.0);
    // SAFETY: nobody else plans or ticks any more.
    let code = unsafe { atraj_axis_go(shared.0, &limits, &state(2.0), 20) };
    for _ in 0..200 {
        // SAFETY: as above.
        unsafe { atraj_axis_tick(shared.0, &mut now) };
    }
    assert!(code >= 0 && now.p != 0.0, "{code}: no plan took over");
}
