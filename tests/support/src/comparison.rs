//! Counted comparison, bit for bit.

use crate::real::Real;
use std::fmt::Display;

#[derive(Default)]
pub struct Comparison {
    pub compared: usize,          // how many values were compared
    pub differences: Vec<String>, // each differing value in words
}

impl Comparison {
    pub fn check<R: Real>(&mut self, place: impl Display, what: &str, got: R, want: R) {
        self.compared += 1;
        if !got.same(want) {
            self.differences.push(format!("{place}: {what} is {}, golden {}", got.show(), want.show()));
        }
    }

    pub fn finish(self, what: &str) {
        println!("{what}: {} values, {} differing", self.compared, self.differences.len());
        assert!(self.compared > 0, "{what}: nothing was compared");
        let first = &self.differences[..self.differences.len().min(10)];
        assert!(first.is_empty(), "{what}:\n{}", first.join("\n"));
    }
}
