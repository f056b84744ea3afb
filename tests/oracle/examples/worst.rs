use oracle::judge::path::problems::{Chains, Family};
use oracle::judge::path::{Paths, Planner};
fn main() {
    let fam = std::env::args().nth(1).unwrap();
    let f = *Family::ALL
        .iter()
        .find(|f| format!("{f:?}") == fam)
        .unwrap();
    let mut chains = Chains::new(5);
    for k in 0..200 {
        let c = chains.of::<f64>(f);
        let d = |s| Paths.plan(&c, s).unwrap().0.duration();
        let all: Vec<f64> = [8, 12, 16, 24, 32, 48, 64, 96, 200]
            .iter()
            .map(|&s| d(s))
            .collect();
        let b = all.iter().cloned().fold(1e300, f64::min);
        if all[2] > 1.01 * b {
            println!(
                "{k} axes {} sections {} {:.4?} of {b}",
                c.axes,
                c.sections(),
                all.iter().map(|x| x / b).collect::<Vec<_>>()
            );
            if std::env::args().nth(2).is_some() {
                for l in &c.limits {
                    println!("   {:.3?}", l);
                }
                for s in c.states.chunks(c.axes) {
                    println!(
                        "   {:?}",
                        s.iter()
                            .map(|s| (s.position, s.velocity, s.acceleration))
                            .collect::<Vec<_>>()
                    );
                }
            }
        }
    }
}
