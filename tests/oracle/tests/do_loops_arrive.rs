//! Do loops that plan at every tick arrive when their first plan said? `LOOPS=20000` runs as many of each family.

use atraj::axes::synchronise;
use atraj::online::Move;
use oracle::judge::axes::loops::{Family, Loops};
use support::online::{limits_of, state_of};
use support::{Real, test_both_reals};

const LOOPS: u64 = 300; // loops of each family
const ONE_LATE_OF: u64 = 1000; // one loop in so many may be late by more than two ticks: of 2,000, up to 2 are

fn loops_arrive<R: Real>() {
    let loops = std::env::var("LOOPS").map_or(LOOPS, |loops| loops.parse().expect("a number of loops"));
    for family in Family::all() {
        let run = Loops::of_seed::<R>(&family, 0, loops);
        println!("{} {family:?}: {run}", R::NAME);
        assert!(run.late <= loops.div_ceil(ONE_LATE_OF), "{:#?}", run.examples);
        assert_eq!(run.refused, 0, "{:#?}", run.examples);
    }
}

test_both_reals!(loops_arrive);

/// In this state of a loop 0.188 s were left, and 0.696 s were planned.
#[test]
#[rustfmt::skip]
fn the_slowest_axis_takes_the_duration_of_another_one() {
    let limits = [
        [1.1686525022234153, -0.6947019870685104, 7.104011671570745, -5.6717765335430546, 29.75519939870755, -20.334074261141684],
        [1.0582902629798658, -1.1622674194650193, 1.9612290763125357, -1.033982227791014, 7.498128751563341, -8.077694212288307],
    ];
    let from = [
        [-0.14452649403406104, -0.359312300746299, 3.822638621328021],
        [-0.03166908250630297, 0.24821512620247965, -1.033982227791014],
    ];
    let to = [[-0.16704241250641094, 0.0, 0.0], [0.0, 0.12512074760657954, 0.0]];
    let mut axes = [Move::default(); 2];
    synchronise(&mut axes, &limits.map(limits_of), &from.map(state_of), &to.map(state_of), 0.0, 4e-3).expect("a plan");
    assert!(axes[0].t < 0.188 + 1e-9, "{}", axes[0].t);
}

/// In this state of a loop 0.3 ms were left, which is 0.16 of a tick, and 0.922 s were planned. The velocity of the second axis has the
/// rounding error of the tick before, when it was 50 times as high.
#[test]
#[rustfmt::skip]
fn the_last_part_of_a_tick_is_short() {
    let limits = [
        [0.5999259097975925, -0.5999259097975925, 9.759447590637537, -9.759447590637537, 11.705506964496628, -11.705506964496628],
        [0.7489348620160077, -0.7489348620160077, 7.7867856680128895, -7.7867856680128895, 10.640216858487081, -10.640216858487081],
    ];
    let from = [
        [0.013440171730717305, -0.3115526904031246, 0.0024858976019611276],
        [0.2400544331791675, 5.207314339034029e-7, -0.0033288722960675976],
    ];
    let to = [[0.013342700226573134, -0.31155214708633727, 0.0], [0.24005443323347242, 0.0, 0.0]];
    let mut axes = [Move::default(); 2];
    synchronise(&mut axes, &limits.map(limits_of), &from.map(state_of), &to.map(state_of), 0.0, 0.0).expect("a plan");
    assert!(axes[0].t < 0.0004, "{}", axes[0].t);
}
