//! `examine [f64|f32] [plan|reach|stop|meet] vmax vmin amax amin jmax jmin p0 v0 a0 p1 v1 a1`: one move from any state to any state,
//! what the referee knows of it, and what the judge says.

use oracle::online::judge::{Fastest, Planner, Trial, show};
use oracle::online::problems::{Kind, Problem, Wish};
use support::{Random, Real};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [real, wish, numbers @ ..] = &arguments[..] else {
        panic!("a real type, what is wanted, and twelve numbers");
    };
    let wish = match wish.as_str() {
        "plan" => Wish::Plan,
        "reach" => Wish::Reach,
        "stop" => Wish::Stop,
        "meet" => Wish::Meet,
        other => panic!("{other} is none of plan, reach, stop and meet"),
    };
    let numbers: Vec<f64> = numbers
        .iter()
        .map(|text| text.trim_matches(&['[', ']', ','][..]).parse())
        .collect::<Result<_, _>>()
        .expect("numbers");
    let numbers = numbers.try_into().expect("twelve numbers");
    match real.as_str() {
        "f64" => examine::<f64>(wish, numbers),
        _ => examine::<f32>(wish, numbers),
    }
}

fn examine<R: Real>(wish: Wish, numbers: [f64; 12]) {
    let problem = Problem::<R>::of(Kind::Moving, wish, numbers.map(R::of));
    println!("{}", show(&problem));
    let trial = Trial::new(problem);
    println!("{:#?}", trial.best());
    println!("{:?}", trial.judge(&Fastest, &mut Random::seeded(0)));
    match Fastest.plan(&problem) {
        Ok((planned, findings)) => {
            println!("t {:e}, findings {}", planned.t, findings.bits());
            for phase in &planned.phase[..=planned.phases as usize] {
                println!("{phase:?}");
            }
        }
        Err(error) => println!("{error:?}"),
    }
}
