//! The table of what was judged.

use std::collections::BTreeMap;

#[derive(Default)]
struct Counts {
    killed: u32,
    timeouts: u32,
    survived: u32,
    equivalent: u32,
    unviable: u32,
    constant: u32,
}

/// Prints the counts of each storey, and a row for each survivor. The page may have rows already: `| name | kind | why |`. Their kinds
/// count. A fault of the kind `equivalent` changes nothing that a test may ask for.
pub fn print(results: &str, page: &str) {
    let known: BTreeMap<_, _> = page.lines().filter_map(row).collect();
    let mut storeys: BTreeMap<&str, Counts> = BTreeMap::new();
    let mut survivors = Vec::new();
    for line in results.lines() {
        let [storey, verdict, _, _, name] = line.split('\t').collect::<Vec<_>>()[..] else {
            panic!("no result: {line}");
        };
        let name = name.replace('|', "\\|");
        let why = known.get(name.as_str()).copied().unwrap_or("open | |");
        for row in [storey, "**all**"] {
            let counts = storeys.entry(row).or_default();
            match verdict {
                "killed" => counts.killed += 1,
                "timeout" => counts.timeouts += 1,
                "survived" => counts.survived += 1,
                "unviable" => counts.unviable += 1,
                "constant" => counts.constant += 1,
                _ => panic!("no verdict: {line}"),
            }
            let is_equivalent = verdict == "survived" && why.starts_with("equivalent");
            counts.equivalent += u32::from(is_equivalent);
        }
        if verdict == "survived" {
            survivors.push(format!("| `{name}` | {why}"));
        }
    }
    println!(
        "| storey | judged | killed | hung | survived | seen, % | 95 % interval | equivalent | seen of the others, % | do not compile | in constants |"
    );
    println!("|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
    for (storey, counts) in storeys {
        let Counts {
            killed,
            timeouts,
            survived,
            equivalent,
            unviable,
            constant,
        } = counts;
        let (seen, judged) = (killed + timeouts, killed + timeouts + survived);
        let share = |of: u32| 100.0 * f64::from(seen) / f64::from(of);
        let [low, high] = wilson(f64::from(seen), f64::from(judged)).map(|share| 100.0 * share);
        println!(
            "| {storey} | {judged} | {killed} | {timeouts} | {survived} | {:.1} | {low:.1} to {high:.1} | {equivalent} | {:.1} | {unviable} | {constant} |",
            share(judged),
            share(judged - equivalent),
        );
    }
    println!("\n| survivor | kind | why |\n|---|---|---|");
    survivors.sort_unstable();
    for row in survivors {
        println!("{row}");
    }
}

/// The name of a survivor in a row of the page, and what follows.
fn row(line: &str) -> Option<(&str, &str)> {
    line.strip_prefix("| `src/")?;
    line.strip_prefix("| `")?.split_once("` | ")
}

/// Wilson's interval for a share, with 95 % confidence.
fn wilson(seen: f64, judged: f64) -> [f64; 2] {
    let z = 1.959_964;
    let share = seen / judged;
    let middle = share + z * z / (2.0 * judged);
    let half = z * (share * (1.0 - share) / judged + z * z / (4.0 * judged * judged)).sqrt();
    [middle - half, middle + half].map(|bound| bound / (1.0 + z * z / judged))
}
