//! `exact <motions>`: by how many roundings the worst of so many motions of each kind misses what it promises, in exact arithmetic, and how
//! many of them are extremal. It prints the rows of docs/data/exact.csv.

use oracle::judge::exact::Row;
use std::thread;

fn main() {
    let motions = std::env::args().nth(1).map_or(Ok(1_000_000), |number| number.parse()).expect("a number");
    let rows = thread::scope(|scope| {
        let double = scope.spawn(|| Row::of_every_kind::<f64>(motions));
        let float = Row::of_every_kind::<f32>(motions);
        [double.join().expect("rows"), float].concat()
    });
    println!("{}", Row::HEADER);
    rows.iter().for_each(|row| println!("{row}"));
}
