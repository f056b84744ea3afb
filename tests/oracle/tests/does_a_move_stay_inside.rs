//! Does a move that is planned between two positions stay between them, and is it refused only where the axis cannot stop there, or the
//! target cannot be reached from rest there?

use atraj::online::{Error, Move};
use oracle::judge::inside::{launch, span, stop};
use oracle::judge::planner::Plan;
use oracle::judge::problem::{Problem, Request};
use oracle::judge::problems::Problems;
use oracle::judge::trial::{Scale, doubt};
use oracle::liba::abi::Original;
use support::Random;

const PROBLEMS: usize = 60_000;

/// A position near one of these, or far.
fn near(random: &mut Random, spans: &[[f64; 2]; 3]) -> f64 {
    let span = random.pick(spans);
    let width = (span[1] - span[0]).abs() + 1e-3 * span[0].abs();
    random.pick(&span) + random.between(-1.0, 1.0) * width * random.magnitude(-3.0, 0.0)
}

fn moves_stay_inside<R: Original>() {
    let mut random = Random::seeded(11);
    let (mut inside, mut refused) = (0, 0);
    for problem in Problems::<R>::new(11).take(PROBLEMS) {
        let Problem {
            limits, from, to, ..
        } = problem;
        let mut fastest = Move::default();
        let found = fastest.plan(&limits, from, to);
        let (Ok(findings), Request::Plan) = (found, problem.request) else {
            continue;
        };
        let of_plan = span(from, &fastest);
        let ends = stop(&limits, from).zip(launch(&limits, to));
        let (of_stop, of_launch) = ends.expect("a stop and a launch");
        let spans = [of_plan, of_stop, of_launch];
        let [one, other] = [(); 2].map(|()| R::of(near(&mut random, &spans)));
        let (lowest, highest) = if one < other {
            (one, other)
        } else {
            (other, one)
        };
        if lowest == highest {
            continue;
        }
        let before = Move {
            t: R::of(-1.0),
            ..Move::default()
        };
        let mut planned = before;
        let result = planned.within(&limits, from, to, lowest, highest);
        let scale = Scale::of(&problem, &Plan::of_move(fastest, findings));
        let slack = 4.0 * doubt::<R>() * scale.position;
        let [low, high] = [lowest, highest].map(R::widen);
        let leaves = |[least, most]: [f64; 2], by: f64| least < low - by || most > high + by;
        match result {
            Ok(_) => {
                assert_eq!((result, planned), (found, fastest), "{problem}");
                assert!(
                    !leaves(of_plan, slack),
                    "{low} {high} {of_plan:?} {problem}"
                );
                inside += 1;
            }
            Err(error) => {
                assert_eq!((error, planned), (Error::Position, before), "{problem}");
                assert!(
                    leaves(of_plan, -slack),
                    "{low} {high} {of_plan:?} {problem}"
                );
                let is_reason = leaves(of_stop, -slack) || leaves(of_launch, -slack);
                assert!(is_reason, "{low} {high} {spans:?} {problem}");
                refused += 1;
            }
        }
    }
    println!("{}: {inside} stay inside, {refused} are refused", R::NAME);
    assert!(inside > PROBLEMS / 10 && refused > PROBLEMS / 10);
}

#[test]
fn moves_stay_inside_f64() {
    moves_stay_inside::<f64>();
}

#[test]
fn moves_stay_inside_f32() {
    moves_stay_inside::<f32>();
}
