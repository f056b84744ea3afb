//! The one comparison that every run uses: a case through two implementations, bit for bit.

use crate::family::{Family, Implementation, MOST_ARGUMENTS, MOST_FIELDS};
use crate::ours::{bell, bell_fields};
use crate::real::OracleReal;
use crate::reference;
use std::fmt;

/// Times at which each move is evaluated.
pub const MOMENTS: usize = 4;

/// A move to plan and the times at which to evaluate it.
#[derive(Clone, Copy)]
pub struct Case<R> {
    /// Whose functions are called.
    pub family: Family,
    /// Arguments of `gen`, as many as the family has.
    pub arguments: [R; MOST_ARGUMENTS],
    /// What the struct holds before.
    pub before: [R; MOST_FIELDS],
    /// Whether `gen` is called; else the struct is evaluated as it is.
    pub planned: bool,
    /// When it is evaluated.
    pub moments: [Moment<R>; MOMENTS],
}

/// A time, told by itself or by what is there in the planned move.
#[derive(Clone, Copy, Debug)]
pub enum Moment<R> {
    /// The time itself.
    At(R),
    /// A part of the duration.
    Fraction(R),
    /// So many representable numbers beside one of the phase borders.
    Border {
        /// Which of them; taken modulo their number.
        index: usize,
        /// Numbers further from zero.
        steps: i8,
    },
}

impl<R: OracleReal> Moment<R> {
    /// The most borders a family has.
    pub const BORDERS: usize = 9;

    fn time(self, case: &Case<R>, fields: &[R]) -> R {
        let zero = R::from(0);
        let mut all = [zero; 9];
        let borders: &[R] = match case.family {
            Family::Bell => {
                let [t, tv, ta, td, taj, tdj] = *fields.first_chunk().unwrap();
                all = [
                    zero,
                    taj,
                    ta - taj,
                    ta,
                    ta + tv,
                    t - td,
                    t - td + tdj,
                    t - tdj,
                    t,
                ];
                &all
            }
            Family::Trap => {
                (all[1], all[2], all[3]) = (fields[6], fields[7], fields[0]);
                &all[..4]
            }
            Family::Poly3 | Family::Poly5 | Family::Poly7 => {
                all[1] = case.arguments[0];
                &all[..2]
            }
        };
        match self {
            Self::At(x) => x,
            Self::Fraction(f) => f * borders[borders.len() - 1],
            Self::Border { index, steps } => borders[index % borders.len()].neighbour(steps),
        }
    }
}

/// What a run has compared and found.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// Moves.
    pub moves: u64,
    /// Calls of each implementation.
    pub calls: u64,
    /// Values, returned or stored, that have been compared.
    pub values: u64,
    /// Values of other bits.
    pub differing: u64,
    /// The first of them in words.
    pub examples: Vec<String>,
    /// Moves on which the original would never return; they are compared with the reference instead.
    pub endless: u64,
    /// Bells without cruise.
    pub searches: u64,
    /// Rounds of all those searches.
    pub rounds: u64,
    /// Rounds of the longest.
    pub most_rounds: u32,
}

impl Report {
    /// Puts the case through both. A bell is planned by the reference as well, which counts its rounds.
    pub fn compare<R: OracleReal>(
        &mut self,
        ours: &impl Implementation<R>,
        original: &impl Implementation<R>,
        case: &Case<R>,
    ) {
        let count = case.family.fields().len();
        let (mut got, mut want) = (case.before, case.before);
        let (got, want) = (&mut got[..count], &mut want[..count]);
        self.moves += 1;
        if case.planned {
            self.compare_plans(ours, original, case, got, want);
        }
        let functions = case.family.functions();
        for moment in case.moments {
            let x = moment.time(case, want);
            let got = ours.evaluate(case.family, got, x);
            let want = original.evaluate(case.family, want, x);
            self.calls += functions.len() as u64;
            for ((what, got), want) in functions.iter().zip(got).zip(want) {
                self.check(case, what, Some(x), got, want);
            }
        }
    }

    fn compare_plans<R: OracleReal>(
        &mut self,
        ours: &impl Implementation<R>,
        original: &impl Implementation<R>,
        case: &Case<R>,
        got: &mut [R],
        want: &mut [R],
    ) {
        let arguments = &case.arguments[..case.family.arguments().len()];
        let reference = (case.family == Family::Bell).then(|| {
            let mut bell = bell(want);
            let plan = reference::plan(&mut bell, *arguments.first_chunk().unwrap());
            (plan, bell_fields(&bell))
        });

        self.calls += 1;
        let duration = ours.plan(case.family, arguments, got);
        let expected = match &reference {
            Some((plan, fields)) if plan.endless => {
                self.endless += 1;
                want.copy_from_slice(fields);
                plan.duration
            }
            _ => original.plan(case.family, arguments, want),
        };

        self.check(case, "returned", None, duration, expected);
        for ((what, &got), &want) in case.family.fields().iter().zip(&*got).zip(&*want) {
            self.check(case, what, None, got, want);
        }
        if let Some((plan, fields)) = reference {
            self.check(case, "reference duration", None, plan.duration, expected);
            for (got, &want) in fields.into_iter().zip(&*want) {
                self.check(case, "reference field", None, got, want);
            }
            self.searches += u64::from(plan.rounds > 0);
            self.rounds += u64::from(plan.rounds);
            self.most_rounds = self.most_rounds.max(plan.rounds);
        }
    }

    fn check<R: OracleReal>(&mut self, case: &Case<R>, what: &str, at: Option<R>, got: R, want: R) {
        self.values += 1;
        if !got.same(want) {
            self.differing += 1;
            if self.examples.len() < 10 {
                let at = at.map_or(String::new(), |x| format!(" at {}", x.show()));
                let (got, want) = (got.show(), want.show());
                self.examples
                    .push(format!("{case}: {what}{at} is {got}, original {want}"));
            }
        }
    }

    /// Adds what another run has found.
    pub fn add(&mut self, other: Self) {
        self.moves += other.moves;
        self.calls += other.calls;
        self.values += other.values;
        self.differing += other.differing;
        self.examples.extend(other.examples);
        self.endless += other.endless;
        self.searches += other.searches;
        self.rounds += other.rounds;
        self.most_rounds = self.most_rounds.max(other.most_rounds);
    }

    /// Panics with the first differences, if there is one, or if nothing was compared.
    pub fn assert_same(&self) {
        assert!(self.values > 0, "nothing was compared");
        assert!(self.differing == 0, "{self}\n{}", self.examples.join("\n"));
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mean = self.rounds as f64 / self.searches.max(1) as f64;
        write!(
            f,
            "{} calls, {} moves, {} values compared, {} differing; {} moves endless in the original; \
             {} searches without cruise, {mean:.1} rounds on average, {} at most",
            self.calls,
            self.moves,
            self.values,
            self.differing,
            self.endless,
            self.searches,
            self.most_rounds
        )
    }
}

impl<R: OracleReal> fmt::Display for Case<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.family.name(), R::NAME)?;
        let (names, values) = if self.planned {
            (self.family.arguments(), &self.arguments[..])
        } else {
            (self.family.fields(), &self.before[..])
        };
        for (name, value) in names.iter().zip(values) {
            write!(f, " {name}={}", value.show())?;
        }
        Ok(())
    }
}

impl<R: OracleReal> fmt::Debug for Case<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}; {:?}", self.moments)
    }
}
