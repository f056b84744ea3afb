//! `windows`: rows of 1,000 points through a window that moves along, and what it loses compared with the whole path: `docs/data/path-windows.csv`.

use oracle::judge::path::windows::{rows, through_window, whole};

fn main() {
    println!("row,whole s,points of the window,s,loss %,longest update ms");
    for (name, row) in rows(1_000) {
        let whole = whole(&row);
        for size in [8, 32, 128] {
            let (time, longest) = through_window(&row, size);
            let loss = 100.0 * (time / whole - 1.0);
            println!("\"{name}\",{whole:.3},{size},{time:.3},{loss:.2},{:.1}", longest.as_secs_f64() * 1e3);
        }
    }
}
