//! Makes a bad problem simple: as round numbers as the fault allows.

use super::problems::Problem;
use atraj::online::Limits;
use support::Real;

/// Passes over all numbers.
const ROUNDS: usize = 4;

/// The problem with the roundest numbers at which it is still bad.
pub fn simplified<R: Real>(
    problem: &Problem<R>,
    is_bad: impl Fn(&Problem<R>) -> bool,
) -> Problem<R> {
    let mut numbers = numbers(problem);
    if !is_bad(&with_numbers(problem, numbers)) {
        return *problem;
    }
    for _ in 0..ROUNDS {
        let before = numbers;
        for index in 0..numbers.len() {
            let x = numbers[index];
            let digits = [0, 1, 2, 3, 4, 6].map(|digits| rounded(x, digits));
            let signed = R::of(1.0f64.copysign(x.widen()));
            let candidates = [R::of(0.0), signed].into_iter().chain(digits);
            for candidate in candidates.take_while(|candidate| *candidate != x) {
                let mut tried = numbers;
                tried[index] = candidate;
                let tried_problem = with_numbers(problem, tried);
                if super::problems::beyond_legal(&tried_problem.limits, tried_problem.to) <= 0.0
                    && is_bad(&tried_problem)
                {
                    numbers = tried;
                    break;
                }
            }
        }
        if before == numbers {
            break;
        }
    }
    with_numbers(problem, numbers)
}

/// The number with so many digits behind the first one.
fn rounded<R: Real>(x: R, digits: usize) -> R {
    let text = format!("{:.digits$e}", x.widen());
    R::of(text.parse().expect("a number"))
}

fn numbers<R: Real>(problem: &Problem<R>) -> [R; 12] {
    let Limits {
        vmax,
        vmin,
        amax,
        amin,
        jmax,
        jmin,
    } = problem.limits;
    let [from, to] = [problem.from, problem.to];
    [
        from.position,
        to.position,
        to.acceleration,
        from.acceleration,
        to.velocity,
        from.velocity,
        vmax,
        vmin,
        amax,
        amin,
        jmax,
        jmin,
    ]
}

fn with_numbers<R: Real>(problem: &Problem<R>, numbers: [R; 12]) -> Problem<R> {
    let [p0, p1, a1, a0, v1, v0, limits @ ..] = numbers;
    let [vmax, vmin, amax, amin, jmax, jmin] = limits;
    let numbers = [vmax, vmin, amax, amin, jmax, jmin, p0, v0, a0, p1, v1, a1];
    Problem::of(problem.kind, problem.wish, numbers)
}
