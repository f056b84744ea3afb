//! `examine [f64|f32] [plan|reach|stop|meet|bell|trap] vmax vmin amax amin jmax jmin p0 v0 a0 p1 v1 a1`: one motion,
//! what the reference solver knows of it, and what the judge says.

use oracle::judge::planner::{Fastest, Planner};
use oracle::judge::problem::{Problem, Request};
use oracle::judge::problems::Kind;
use oracle::judge::trial::Trial;
use oracle::liba::abi::Original;
use support::Random;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [real, request, numbers @ ..] = &arguments[..] else {
        panic!("a real type, what is wanted, and twelve numbers");
    };
    let request = match request.as_str() {
        "plan" => Request::Plan,
        "reach" => Request::Reach,
        "stop" => Request::Stop,
        "meet" => Request::Meet,
        "bell" => Request::Bell,
        "trap" => Request::Trap,
        other => panic!("{other} is none of plan, reach, stop, meet, bell and trap"),
    };
    let numbers: Vec<f64> = numbers
        .iter()
        .map(|text| text.trim_matches(&['[', ']', ','][..]).parse())
        .collect::<Result<_, _>>()
        .expect("numbers");
    let numbers = numbers.try_into().expect("twelve numbers");
    match real.as_str() {
        "f64" => examine::<f64>(request, numbers),
        _ => examine::<f32>(request, numbers),
    }
}

fn examine<R: Original>(request: Request, numbers: [f64; 12]) {
    let problem = Problem::<R>::of(Kind::Moving, request, numbers.map(R::of));
    println!("{problem}");
    let trial = Trial::new(problem);
    println!("{:#?}", trial.best());
    println!("{:?}", trial.judge(&Fastest, &mut Random::seeded(0)));
    match Fastest.plan(&problem) {
        Ok(plan) => {
            let planned = plan.planned;
            println!("t {:e}, findings {}", planned.t, plan.findings.bits());
            for phase in &planned.phase[..=planned.count as usize] {
                println!("{phase:?}");
            }
        }
        Err(error) => println!("{error:?}"),
    }
}
