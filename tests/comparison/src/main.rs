//! `comparison`: paths through the same points by atraj, rsruckig, TOPP-RA and COPP, as a table. docs/path.md shows it.

mod cases;
mod copp;
mod toppra;
mod two_passes;

use atraj::axes::path_deviation;
use cases::{Case, cases};
use oracle::judge::path::{Chain, Paths, Planner, stopping};
use oracle::judge::rivals::ruckig_path;
use std::time::Instant;

type Duration = f64; // s

fn main() {
    println!("points,planner,jerk,s,ms");
    for case in cases() {
        case.print("a stop at each point", true, |chain| Some(stopping(chain)));
        case.print("atraj", true, ours);
        case.print("rsruckig 3.0.1", true, theirs);
        case.print("two passes with a = 0", true, two_passes::duration);
        case.print("COPP 0.2.3 on its spline: TOPP3-SOCP", true, |chain| copp::duration(chain, copp::Limits::Jerk));
        case.print("COPP 0.2.3 on its spline: TOPP2-RA", false, |chain| {
            copp::duration(chain, copp::Limits::Acceleration)
        });
        case.print("atraj through 1,001 points of this spline", true, |chain| ours(&copp::stations(chain)?));
        toppra::print(&case);
        case.print_deviations();
    }
}

impl Case {
    fn print(&self, planner: &str, keeps_jerk: bool, plan: impl Fn(&Chain<f64>) -> Option<Duration>) {
        let start = Instant::now();
        let durations: Option<Vec<_>> = self.chains.iter().map(plan).collect();
        let ms = start.elapsed().as_secs_f64() * 1e3;
        if let Some(durations) = durations {
            self.print_row(planner, keeps_jerk, durations.iter().sum(), ms);
        }
    }

    fn print_row(&self, planner: &str, keeps_jerk: bool, s: f64, ms: f64) {
        let jerk = if keeps_jerk { "limited" } else { "free" };
        let count = self.chains.len() as f64;
        println!("\"{}\",\"{planner}\",{jerk},{:.4},{:.3}", self.name, s / count, ms / count);
    }

    /// Says how far the path through the stations of a spline, and the spline itself, leave the straight lines between the stations.
    fn print_deviations(&self) {
        let stations = self.chains.iter().map(copp::stations).collect::<Option<Vec<_>>>();
        if let Some(stations) = stations {
            let ours = stations.iter().map(deviation).fold(0.0, f64::max);
            let splines = self.chains.iter().map(copp::deviation).fold(0.0, f64::max);
            eprintln!(
                "{}: between its 1,001 points atraj leaves the lines by {ours:.5}, the spline by {splines:.5}",
                self.name
            );
        }
    }
}

fn deviation(chain: &Chain<f64>) -> f64 {
    let (path, _) = Paths.plan(chain, 0).expect("a plan");
    path_deviation(&path.moves(chain).expect("motions").0, chain.axes)
}

fn ours(chain: &Chain<f64>) -> Option<Duration> {
    Some(Paths.plan(chain, 0).ok()?.0.duration())
}

/// rsruckig has one limit of the jerk.
fn theirs(chain: &Chain<f64>) -> Option<Duration> {
    chain.limits.iter().all(|limits| limits.jmax == -limits.jmin).then(|| ruckig_path(chain)).flatten()
}
