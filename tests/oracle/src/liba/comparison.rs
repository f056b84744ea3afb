//! The one comparison that every run uses: a case through two implementations, bit for bit.

use std::fmt;
use support::family::{MOST_ARGUMENTS, MOST_FIELDS};
use support::{Family, Implementation, Real, reference};

pub const MOMENTS: usize = 4;

#[derive(Clone, Copy)]
pub struct Case<R> {
    pub family: Family, // the functions that are called
    pub arguments: [R; MOST_ARGUMENTS],
    pub before: [R; MOST_FIELDS],
    pub planned: bool, // whether `gen` is called. If not, the struct is evaluated as it is.
    pub moments: [Moment<R>; MOMENTS],
}

#[derive(Clone, Copy, Debug)]
pub enum Moment<R> {
    At(R),       // the time itself
    Fraction(R), // a part of the duration
    Border {
        index: usize, // which border, modulo the number of borders
        steps: i8,    // how many representable numbers further from zero
    },
}

impl<R: Real> Moment<R> {
    fn time(self, borders: &[R]) -> R {
        match self {
            Self::At(x) => x,
            Self::Fraction(f) => f * borders[borders.len() - 1],
            Self::Border { index, steps } => borders[index % borders.len()].neighbour(steps),
        }
    }
}

#[derive(Clone, Debug, Default)]
pub struct Report {
    pub moves: u64,
    pub calls: u64,            // calls of each implementation
    pub values: u64,           // compared values, returned or stored
    pub differing: u64,        // values whose bits differ
    pub examples: Vec<String>, // the first differing values in words
    pub endless: u64, // Moves on which the original would never return. They are compared with the reference instead.
    pub searches: u64, // bells without cruise
    pub rounds: u64,  // rounds of all searches
    pub most_rounds: u32, // rounds of the longest search
}

impl Report {
    pub fn compare<R: Real>(
        &mut self, ours: &impl Implementation<R>, original: &impl Implementation<R>, case: &Case<R>,
    ) {
        let count = case.family.fields().len();
        let (mut got, mut want) = (case.before, case.before);
        let (got, want) = (&mut got[..count], &mut want[..count]);
        self.moves += 1;
        if case.planned {
            self.compare_plans(ours, original, case, got, want);
        }
        let quantities = case.family.quantities();
        let borders = case.family.borders(&case.arguments, want);
        for moment in case.moments {
            let x = moment.time(&borders);
            let got = ours.evaluate(case.family, got, x);
            let want = original.evaluate(case.family, want, x);
            self.calls += quantities.len() as u64;
            for ((quantity, got), want) in quantities.iter().zip(got).zip(want) {
                self.check(case, quantity.name, Some(x), got, want);
            }
        }
    }

    fn compare_plans<R: Real>(
        &mut self, ours: &impl Implementation<R>, original: &impl Implementation<R>, case: &Case<R>, got: &mut [R],
        want: &mut [R],
    ) {
        let arguments = &case.arguments[..case.family.arguments().len()];
        let reference = (case.family == Family::Bell).then(|| {
            let mut fields = want.to_vec();
            (reference::plan(arguments, &mut fields), fields)
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

    fn check<R: Real>(&mut self, case: &Case<R>, what: &str, at: Option<R>, got: R, want: R) {
        self.values += 1;
        if !got.same(want) {
            self.differing += 1;
            if self.examples.len() < 10 {
                let at = at.map_or(String::new(), |x| format!(" at {}", x.show()));
                let (got, want) = (got.show(), want.show());
                self.examples.push(format!("{case}: {what}{at} is {got}, original {want}"));
            }
        }
    }

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
            self.calls, self.moves, self.values, self.differing, self.endless, self.searches, self.most_rounds
        )
    }
}

impl<R: Real> fmt::Display for Case<R> {
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

impl<R: Real> fmt::Debug for Case<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}; {:?}", self.moments)
    }
}
