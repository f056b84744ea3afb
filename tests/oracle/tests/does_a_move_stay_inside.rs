//! Does a move that is planned between two positions stay between them, is it the fastest one that does, and is it refused only where the
//! hardest brake from the start leaves them, or the hardest approach to the target?

use atraj::Findings;
use atraj::online::{Error, Limits, Move, State};
use oracle::judge::inside::{approach, brake, launch, span, stop};
use oracle::judge::planner::Plan;
use oracle::judge::problem::{Problem, Request};
use oracle::judge::problems::Problems;
use oracle::judge::trial::{Scale, doubt};
use oracle::liba::abi::Original;
use support::{Random, test_both_reals};

const PROBLEMS: usize = 60_000;

/// A position near one of these, or far.
fn near(random: &mut Random, spans: &[[f64; 2]; 3]) -> f64 {
    let span = random.pick(spans);
    let width = (span[1] - span[0]).abs() + 1e-3 * span[0].abs();
    random.pick(&span) + random.between(-1.0, 1.0) * width * random.magnitude(-3.0, 0.0)
}

/// A wall between the turns of the hardest brake and of the fastest stop, and the target at rest near it; or the same for the hardest approach to
/// the target, and the start. Answers the walls.
fn bind<R: Original>(random: &mut Random, problem: &mut Problem<R>) -> Option<[f64; 2]> {
    let Problem { limits, from, to, .. } = *problem;
    let is_start = random.one_in(2);
    let (hard, easy) = if is_start {
        (brake(&limits, from), stop(&limits, from)?)
    } else {
        (approach(&limits, to), launch(&limits, to)?)
    };
    let side = random.below(2);
    let (span, inwards) = (easy[side] - hard[side], [1.0, -1.0][side]);
    let wall = hard[side] + random.unit() * span;
    let rest = State::at(R::of(wall + inwards * span.abs() * random.magnitude(-2.0, 1.5)));
    let far = wall + inwards * (easy[1] - easy[0] + 10.0 * span.abs()) * random.magnitude(1.0, 2.0);
    *(if is_start { &mut problem.to } else { &mut problem.from }) = rest;
    (span != 0.0 && wall.is_finite() && far.is_finite()).then_some(if side == 0 { [wall, far] } else { [far, wall] })
}

/// A faster motion by way of a state near the planned motion, or at a wall, if there is one: its duration and this state.
fn faster_by_way_of<R: Original>(
    random: &mut Random, limits: &Limits<R>, planned: &Move<R>, to: State<R>, walls: [R; 2], slack: f64,
    stays: impl Fn(&Move<R>, State<R>) -> bool,
) -> Option<(R, State<R>)> {
    let from = planned.state_at(R::of(0.0));
    (0..20).find_map(|_| {
        let State { position, velocity, acceleration } = planned.state_at(planned.t * R::of(random.unit()));
        let by = random.magnitude(-5.0, -1.0);
        let mut near = |x: R| x * R::of(1.0 + by * random.between(-1.0, 1.0));
        let acceleration = near(acceleration);
        let near = State { position: near(position), velocity: near(velocity), acceleration };
        let turn = State { position: random.pick(&walls), velocity: R::of(0.0), acceleration };
        let via = random.pick(&[near, turn]);
        let [mut one, mut other] = [Move::default(); 2];
        let found = one.plan(limits, from, via).and(other.plan(limits, via, to)).ok()?;
        if found.contains(Findings::STARTS_OUTSIDE) {
            return None; // the limits of this way are wider
        }
        let t = one.t + other.t;
        // At a turn the root of a rounding of the position is time.
        let reached = planned.extremes();
        let steepest = reached.highest.acceleration.widen().max(-reached.lowest.acceleration.widen());
        let rounding = 4.0 * (slack / steepest).sqrt() + 16.0 * R::MACHINE_EPSILON.widen() * planned.t.widen();
        let is_faster = t.widen() < planned.t.widen() - rounding;
        (is_faster && stays(&one, from) && stays(&other, via)).then_some((t, via))
    })
}

fn moves_stay_inside<R: Original>() {
    let mut random = Random::seeded(11);
    let (mut inside, mut turned, mut refused, mut between_two_turns) = (0, 0, 0, 0);
    for mut problem in Problems::<R>::new(11).take(PROBLEMS) {
        let mut binding = None;
        if problem.request == Request::Plan && random.one_in(2) {
            binding = bind(&mut random, &mut problem);
        }
        let Problem { limits, from, to, .. } = problem;
        let mut fastest = Move::default();
        let found = fastest.plan(&limits, from, to);
        let (Ok(findings), Request::Plan) = (found, problem.request) else {
            continue;
        };
        let of_plan = span(from, &fastest);
        let ends = stop(&limits, from).zip(launch(&limits, to));
        let (of_stop, of_launch) = ends.expect("a stop and a launch");
        let spans = [of_plan, of_stop, of_launch];
        let hard = [brake(&limits, from), approach(&limits, to)];
        let walls = binding.unwrap_or_else(|| [(); 2].map(|()| near(&mut random, &spans)));
        let [one, other] = walls.map(R::of);
        let (lowest, highest) = if one < other { (one, other) } else { (other, one) };
        if lowest == highest {
            continue;
        }
        let before = Move { t: R::of(-1.0), ..Move::default() };
        let mut planned = before;
        let result = planned.within(&limits, from, to, lowest, highest);
        let scale = Scale::of(&problem, &Plan::of_move(fastest, findings));
        let slack = 4.0 * doubt::<R>() * scale.position;
        let [low, high] = [lowest, highest].map(R::widen);
        let leaves = |[least, most]: [f64; 2], by: f64| least < low - by || most > high + by;
        match result {
            Ok(found) if planned != fastest => {
                assert!(leaves(of_plan, -slack), "{low} {high} {of_plan:?} {problem}");
                let longer = Scale::of(&problem, &Plan::of_move(planned, found)).position;
                let reached = span(from, &planned);
                assert!(!leaves(reached, slack + 4.0 * doubt::<R>() * longer), "{low} {high} {reached:?} {problem}");
                let checked = planned.check(&limits).expect("numbers");
                let excess = Findings::EXCEEDS_VELOCITY | Findings::EXCEEDS_ACCELERATION;
                let ends = Findings::OVERSHOOTS | Findings::STARTS_OUTSIDE | Findings::ENDS_LEAVING;
                let allowed = if found.contains(Findings::STARTS_OUTSIDE) { ends | excess } else { ends };
                assert!(allowed.contains(checked), "{checked:?} {low} {high} {problem}");
                let [start, end] = [R::of(0.0), planned.t].map(|x| planned.state_at(x));
                assert_eq!((start, end), (from, to), "{problem}");
                let stays = |axis: &Move<R>, from| !leaves(span(from, axis), 0.0);
                let faster = faster_by_way_of(&mut random, &limits, &planned, to, [lowest, highest], slack, stays);
                assert!(faster.is_none(), "{:?} {faster:?} {low} {high} {problem}", planned.t);
                turned += 1;
            }
            Ok(_) => {
                assert_eq!((result, planned), (found, fastest), "{problem}");
                assert!(!leaves(of_plan, slack), "{low} {high} {of_plan:?} {problem}");
                inside += 1;
            }
            Err(error) => {
                assert_eq!((error, planned), (Error::Position, before), "{problem}");
                assert!(leaves(of_plan, -slack), "{low} {high} {of_plan:?} {problem}");
                let is_reason = leaves(of_stop, -slack) || leaves(of_launch, -slack);
                assert!(is_reason, "{low} {high} {spans:?} {problem}");
                let unknown = hard.as_flattened().iter().any(|position| position.is_nan());
                let is_reason = unknown || hard.iter().any(|span| leaves(*span, -slack));
                if !is_reason && !findings.contains(Findings::STARTS_OUTSIDE) {
                    between_two_turns += 1;
                }
                refused += 1;
            }
        }
    }
    println!("{}: {inside} stay inside, {turned} turn at a wall, {refused} are refused", R::NAME);
    println!("{between_two_turns} would turn at both walls before they can stop");
    assert!(inside > PROBLEMS / 10 && turned > PROBLEMS / 50 && refused > PROBLEMS / 10);
    assert!(500 * between_two_turns < refused);
}

test_both_reals!(moves_stay_inside);
