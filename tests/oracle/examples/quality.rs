use oracle::judge::path::problems::*;
use oracle::judge::path::*;
use support::*;
fn main() {
    run::<f64>();
    run::<f32>();
}
fn run<R: Real>() {
    let n: usize = std::env::args()
        .nth(1)
        .and_then(|x| x.parse().ok())
        .unwrap_or(1000);
    let seed = std::env::args()
        .nth(2)
        .and_then(|x| x.parse().ok())
        .unwrap_or(5);
    let mut chains = Chains::new(seed);
    let mut rows: std::collections::BTreeMap<usize, Vec<[f64; 5]>> = Default::default();
    for _ in 0..n {
        let c = chains.next::<R>();
        let d = |s| Paths.plan(&c, s).unwrap().0.duration();
        let long = d(96).min(d(300)).min(d(48)).min(d(24));
        rows.entry(c.family as usize).or_default().push([
            d(12) / long,
            d(16) / long,
            d(24) / long,
            d(48) / long,
            d(0) / long,
        ]);
    }
    let stat = |v: &Vec<[f64; 5]>| {
        let mut s = String::new();
        for k in 0..5 {
            let mut x: Vec<f64> = v
                .iter()
                .map(|r| if r[k].is_nan() { 1. } else { r[k] })
                .collect();
            x.sort_by(f64::total_cmp);
            let mean = x.iter().sum::<f64>() / x.len() as f64;
            s += &format!(
                " | {:.5} {:.4} {:.3}",
                mean,
                x[x.len() * 99 / 100],
                x[x.len() - 1]
            );
        }
        s
    };
    println!("{} mean p99 worst of 12 16 24 48 default", R::NAME);
    for (f, v) in &rows {
        println!("{:>14} {}", format!("{:?}", Family::ALL[*f]), stat(v));
    }
    println!(
        "{:>14} {}",
        "all",
        stat(&rows.into_values().flatten().collect())
    );
}
