use support::*;
fn main() {
    let mut r = Random::seeded(
        std::env::args()
            .nth(1)
            .and_then(|x| x.parse().ok())
            .unwrap_or(1),
    );
    std::panic::set_hook(Box::new(|i| {
        println!("{i}");
    }));
    let n: usize = std::env::args()
        .nth(2)
        .and_then(|x| x.parse().ok())
        .unwrap_or(200000);
    let mut bad = 0;
    for k in 0..n {
        let kind = r.bits() as u8;
        let mut b = vec![kind];
        let mode = r.below(4);
        for i in 0..70 {
            let axes = 1 + (kind / 2 % 2) as usize;
            let lim = i < 6 * axes;
            let m = if mode == 0 {
                r.magnitude(-8., 8.)
            } else if mode == 1 {
                r.magnitude(-1., 1.)
            } else if mode == 2 {
                r.magnitude(-3., 3.)
            } else {
                r.pick(&[1.0, 2.0, 0.5, 3.0])
            };
            let x = if lim {
                if i % 2 == 0 { m } else { -m }
            } else if r.one_in(6) {
                0.0
            } else {
                r.sign() * m
            };
            let x = if lim && mode == 0 && r.one_in(20) {
                x * f64::INFINITY
            } else {
                x
            };
            if kind % 2 == 1 {
                b.extend((x as f32).to_le_bytes())
            } else {
                b.extend(x.to_le_bytes())
            }
        }
        if mode == 0 && r.one_in(3) {
            let at = r.below(b.len());
            b[at] ^= r.bits() as u8;
        }
        let bb = b.clone();
        if std::panic::catch_unwind(move || oracle::bytes::way_points(&bb)).is_err() {
            bad += 1;
            println!("case {k} mode {mode}");
            if bad > 5 {
                break;
            }
        }
    }
    println!("{bad} bad");
}
