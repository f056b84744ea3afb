//! Plans of ours next to those of the crate rsruckig: the same problems in the same rounds.
//!
//! rsruckig plans by its position interface, and computes in binary64 always.

use crate::Row;
use atraj::capi::a_float;
use rsruckig::prelude::*;
use std::cell::RefCell;
use std::hint::black_box;
use std::rc::Rc;
use std::time::Instant;
use support::Real;

/// How often each plan is timed alone. The shortest time counts, so no other work on the machine does.
const REPEATS: usize = 41;

pub struct Race {
    pub row: Row,
    one: Box<dyn Fn(usize, usize)>, // makes the library of this number write the plan of this number
    /// Plans with ours and with rsruckig. It takes too long for every run under callgrind.
    pub compare: Box<dyn Fn() -> Tally>,
}

pub type Pass<P> = Box<dyn Fn(&[P])>; // plans all these problems

impl Race {
    /// Like a control loop, each library overwrites its last plan. The passes of C libraries come first, then rsruckig, which `ask`
    /// tells a problem. `duration` is the one of our plan.
    pub fn new<const N: usize, P: 'static>(
        function: &str, case: String, problems: Rc<[P]>, passes: Vec<Pass<P>>, duration: impl Fn(&P) -> f64 + 'static,
        ask: impl Fn(&P, &mut InputParameter<N>) + 'static,
    ) -> Self {
        let ruckig = Rc::new((RefCell::new(Planner::new()), ask));
        let theirs = ruckig.clone();
        let pass = Rc::new(move |library: usize, problems: &[P]| match passes.get(library) {
            Some(pass) => pass(problems),
            None => theirs.0.borrow_mut().plan_all(problems, &theirs.1),
        });
        let ([all, each], pass_all) = ([(); 2].map(|()| problems.clone()), pass.clone());
        Self {
            row: Row::new(function, case, problems.len(), move |library| pass_all(library, &all)),
            one: Box::new(move |library, plan| pass(library, &each[plan..=plan])),
            compare: Box::new(move || {
                let mut tally = Tally::default();
                for problem in &*problems {
                    tally.note(duration(problem), ruckig.0.borrow_mut().plan(problem, &ruckig.1));
                }
                tally
            }),
        }
    }

    /// Nanoseconds of the longest of the plans. Passes over all plans time each one alone, so the processor cannot learn its branches.
    pub fn worst(&self, library: usize) -> f64 {
        let mut shortest = vec![f64::INFINITY; self.row.calls];
        for _ in 0..REPEATS {
            for (plan, shortest) in shortest.iter_mut().enumerate() {
                let start = Instant::now();
                (self.one)(library, plan);
                *shortest = shortest.min(start.elapsed().as_secs_f64() * 1e9);
            }
        }
        shortest.into_iter().fold(0.0, f64::max) - clock()
    }
}

fn clock() -> f64 {
    (0..10_000).map(|_| Instant::now().elapsed().as_secs_f64() * 1e9).fold(f64::INFINITY, f64::min)
}

#[derive(Default)]
pub struct Tally {
    pub errors: usize,
    pub slower: usize,
}

impl Tally {
    /// Notes our duration and that of rsruckig, which is nothing for an error. Ours is never longer.
    fn note(&mut self, ours: f64, ruckig: Option<f64>) {
        let Some(duration) = ruckig else {
            self.errors += 1;
            return;
        };
        let rounding = a_float::EPSILON.widen().sqrt() * duration;
        assert!(ours <= duration + rounding, "{ours:e} > {duration:e}");
        self.slower += usize::from(duration > ours + rounding);
    }
}

struct Planner<const N: usize> {
    ruckig: Ruckig<N, ThrowErrorHandler>,
    input: InputParameter<N>,
    trajectory: Trajectory<N>,
}

impl<const N: usize> Planner<N> {
    fn new() -> Self {
        Self { ruckig: Ruckig::new(None, 0.001), input: InputParameter::new(None), trajectory: Trajectory::new(None) }
    }

    #[inline(never)]
    fn plan_all<P>(&mut self, problems: &[P], ask: &impl Fn(&P, &mut InputParameter<N>)) {
        for problem in problems {
            black_box(self.plan(problem, ask));
        }
    }

    fn plan<P>(&mut self, problem: &P, ask: &impl Fn(&P, &mut InputParameter<N>)) -> Option<f64> {
        ask(problem, &mut self.input);
        match self.ruckig.calculate(&self.input, &mut self.trajectory) {
            Ok(RuckigResult::Working | RuckigResult::Finished) => Some(self.trajectory.get_duration()),
            _ => None,
        }
    }
}
