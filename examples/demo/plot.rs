//! Draws what the examples print: `plot DIRECTORY` writes one SVG for each row of `PICTURES` from the row's text in this directory.
//!
//! ```text
//! TITLE: DETAILS                                        the first line; the title is the SVG's name
//! within 5 m/s, +4 m/s^2, -8 m/s^2                      limits, of both directions or of one
//! x within 1 m/s                                        a limit of something that has a name
//! the switch is at 0.8 m                                any other level
//! 0.250 s: 0.1 m, 0.2 m/s, part 0.5 m                   the numbers of a row, at a time (s) or a frequency (Hz)
//! 0.700 s -> to -2 m                                    what happens at this time: a mark
//! synchronised:                                         a path begins: the first two numbers of its rows are x and y
//! ```
//!
//! The curves over time are those of the last path. A picture is lines and text, so it is written without a plotting crate, in half of the
//! bytes. It has no background, and lighter colours where the reader's pages are dark.

use std::collections::HashSet;
use std::ops::Range;
use std::path::Path;
use std::{env, fs};

/// A name, the unit of positions, the axes, how many of `QUANTITIES` each has, and what else has which quantity, in which colour. The
/// numbers of a row stand in this order: the positions of all axes, the velocities of all axes, …, and what else there is.
struct Picture(&'static str, &'static str, &'static [&'static str], usize, &'static [(usize, &'static str, Color)]);

const QUANTITIES: [&str; 4] = ["position", "velocity", "acceleration", "jerk"];
/// Of an axis without a name, each quantity has a colour of its own.
const ALONE: &[&str] = &[""];
const AXIS: &[&str] = &["axis"];
const PLANE: &[&str] = &["x", "y"];
const ARM: &[&str] = &["joint 1", "joint 2", "joint 3", "joint 4", "joint 5", "joint 6"];
const SHAPERS: &[&str] = &["ZV", "MZV", "ZVD", "EI", "EI2"];
const ORIGINAL: &str = "a_trajbell_gen";
const ORIGINALS: &[(usize, &str, Color)] = &[(0, ORIGINAL, GREY), (1, ORIGINAL, GREY), (2, ORIGINAL, GREY)];
const PICTURES: [Picture; 27] = [
    Picture("01_relink", "m", ALONE, 4, &[]),
    Picture("02_follow", "m", ALONE, 4, &[]),
    Picture("03_sample", "m", ALONE, 3, &[]),
    Picture("04_polynomial", "m", ALONE, 4, &[]),
    Picture("05_one_prefix", "m", &["atraj_bell_gen"], 3, ORIGINALS),
    Picture("06_retarget", "m", ALONE, 4, &[]),
    Picture("07_track", "m", AXIS, 3, &[(0, "sensor", GREY)]),
    Picture("08_meet", "m", AXIS, 3, &[(0, "part", GREY), (1, "part", GREY)]),
    Picture("09_gantry", "m", PLANE, 3, &[]),
    Picture("10_arm", "deg", ARM, 2, &[]),
    Picture("11_claraty", "m", ALONE, 3, &[]),
    Picture("12_waypoints", "deg", ARM, 2, &[]),
    Picture("13_obstacle", "m", PLANE, 3, &[]),
    Picture("14_horizon", "m", PLANE, 3, &[]),
    Picture("15_jog", "m", ALONE, 3, &[]),
    Picture("16_homing", "m", ALONE, 3, &[]),
    Picture("17_limit_switch", "m", ALONE, 3, &[]),
    Picture("18_override", "m", AXIS, 3, &[(1, "feed", GREY)]),
    Picture("19_steps", "deg", ALONE, 2, &[]),
    Picture("20_hold", "m", PLANE, 3, &[]),
    Picture("21_swing", "m", AXIS, 3, &[(0, "load", COLORS[1]), (0, "load without a shaper", COLORS[2])]),
    Picture("22_two_steppers", "mm", PLANE, 1, &[]),
    Picture("23_contour", "mm", PLANE, 1, &[(1, "speed", INK)]),
    Picture("24_zones", "deg", ARM, 2, &[]),
    Picture("25_printer", "mm", PLANE, 2, &[(1, "filament", COLORS[3])]),
    Picture("26_cell", "m", PLANE, 3, &[]),
    Picture("sensitivity", "%", SHAPERS, 1, &[]),
];

type Color = &'static str;
const COLORS: [Color; 6] = ["#1F5AA6", "#18804E", "#CC5500", "#8C2882", "#AA8200", "#1E879B"];
/// Red is a limit, and nothing else.
const LIMIT: Color = "#C81E32";
const INK: Color = "#282C34";
const GREY: Color = "#646A74";
/// A speed below the number, mm/s.
const SPEEDS: [(f64, &str, Color); 4] = [
    (30.0, "below 30 mm/s", COLORS[3]),
    (60.0, "below 60 mm/s", COLORS[2]),
    (90.0, "below 90 mm/s", COLORS[4]),
    (f64::INFINITY, "faster", COLORS[1]),
];
/// What these are on a dark page, in their order.
const DARK: [Color; 9] =
    ["#7FB2F0", "#5FCF97", "#F2A65A", "#E18CD7", "#DEBE50", "#6ECDE1", "#FF7882", "#E6E7E9", "#979DA6"];

type Point = (f64, f64);
type Curve<'a> = (&'a str, Color, Vec<Point>);
type Level<'a> = (&'a str, Color, f64);
type Mark<'a> = (f64, &'a str);

/// Curves with common axes. A panel above one with the same axis has no `x_name`.
#[derive(Default)]
struct Panel<'a> {
    name: String,
    x: Range<f64>,
    x_name: &'static str,
    height: f64,
    curves: Vec<Curve<'a>>,
    levels: Vec<Level<'a>>,
    marks: Vec<Mark<'a>>,
    /// Points of the plane.
    places: Vec<Point>,
}

/// The sides of every panel, in pixels.
const SIDES: Range<f64> = 95.0..875.0;

fn main() {
    let directory = env::args_os().nth(1).expect("usage: plot DIRECTORY");
    for picture in &PICTURES {
        let file = Path::new(&directory).join(picture.0.to_owned() + ".txt");
        let text = fs::read_to_string(&file).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
        let title = text.split(": ").next().unwrap();
        let words: Vec<_> = title.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).collect();
        let svg = file.with_file_name(words.join("-").to_lowercase() + ".svg");
        fs::write(&svg, draw(&text, &picture.panels(&text))).unwrap();
        println!("{}: {}", picture.0, svg.display());
    }
}

impl Picture {
    /// The plane, if there are paths, and one panel for each other quantity.
    fn panels<'a>(&self, text: &'a str) -> Vec<Panel<'a>> {
        let &Picture(example, unit, axes, quantities, others) = self;
        let parts: Vec<&str> = text.split(":\n").collect();
        let (paths, last) = (parts.len() - 1, parts[parts.len() - 1]);
        let (rows, marks) = (rows(last), marks(last));
        let of_axes = (0..quantities * axes.len()).map(|i| (i / axes.len(), i % axes.len()));
        let color = |(quantity, axis)| COLORS[if axes == ALONE { quantity } else { paths + axis }];
        let of_axes = of_axes.map(|column| (column.0, axes[column.1], color(column)));
        let columns: Vec<_> = of_axes.chain(others.iter().copied()).collect();
        let is_whole = !rows.is_empty() && rows.iter().all(|row| row.len() == 1 + columns.len());
        assert!(is_whole, "{example}: not rows of {columns:?}");
        let times = span(rows.iter().map(|row| row[0]).chain(marks.iter().map(|mark| mark.0)), 0.0);
        let panel = |name, height| Panel { name, x: times.clone(), marks: marks.clone(), height, ..Panel::default() };
        let mut panels = Vec::new();
        // The plane shows the positions, and the first colours mean its paths.
        let last_quantity = columns.iter().map(|column| column.0).max().unwrap_or(0);
        for quantity in usize::from(paths > 0)..=last_quantity {
            let unit = unit.to_owned() + ["", "/s", "/s^2", "/s^3"][quantity];
            let name = if unit == "%" { "vibration" } else { QUANTITIES[quantity] };
            let mut panel = panel(format!("{name} [{}]", unit.replace("^2", "²").replace("^3", "³")), 166.0);
            for (i, &(_, name, color)) in columns.iter().enumerate().filter(|(_, column)| column.0 == quantity) {
                panel.curves.push((name, color, rows.iter().map(|row| (row[0], row[1 + i])).collect()));
            }
            // A limit is drawn on the side where the curve is.
            let y = span(panel.curves.iter().flat_map(|curve| &curve.2).map(|point| point.1), 0.0);
            panel.levels = levels(text, &unit);
            panel.levels.retain(|level| if level.2 < 0.0 { y.start < 0.0 } else { y.end > 0.0 });
            panels.push(panel);
        }
        if example == "19_steps" {
            let pulse = |row: &Vec<f64>| [0.0, row[2].signum(), 0.0].map(|height| (row[0], height));
            let train = ("", INK, rows.iter().flat_map(pulse).collect());
            panels.push(Panel { curves: vec![train], ..panel("pulses".to_owned(), 70.0) });
        }
        panels.last_mut().unwrap().x_name = if unit == "%" { "frequency [Hz]" } else { "time [s]" };
        if paths > 0 {
            panels.insert(0, plane(&parts, unit, columns[columns.len() - 1].1 == "speed"));
        }
        panels
    }
}

/// The finite numbers of each row.
fn rows(text: &str) -> Vec<Vec<f64>> {
    let is_row = |line: &&str| line.contains(" s: ") || line.contains(" Hz: ");
    let numbers = |line: &str| {
        line.split([' ', ',']).filter_map(|word| word.parse().ok()).filter(|n: &f64| n.is_finite()).collect()
    };
    text.lines().filter(is_row).map(numbers).collect()
}

fn marks(text: &str) -> Vec<Mark<'_>> {
    let marks = text.lines().filter_map(|line| line.split_once(" s -> "));
    marks.map(|(time, what)| (time.parse().unwrap(), what)).collect()
}

/// The limits and other levels in this unit.
fn levels<'a>(text: &'a str, unit: &str) -> Vec<Level<'a>> {
    let mut levels = Vec::new();
    for line in text.lines() {
        let limits = line.split_once("within ").map(|(name, limits)| (name.trim(), LIMIT, limits));
        let others = || line.strip_prefix("the ")?.split_once(" is at ").map(|(name, level)| (name, INK, level));
        let Some((name, color, sizes)) = limits.or_else(others) else { continue };
        for (size, _) in sizes.split(", ").filter_map(|size| size.split_once(' ')).filter(|size| size.1 == unit) {
            let value: f64 = size.parse().unwrap();
            levels.push((name, color, value));
            let is_of_both = color == LIMIT && !size.starts_with(['+', '-']);
            levels.extend(is_of_both.then_some((name, color, -value)));
        }
    }
    levels
}

/// The paths, and where the marks are on them. The name of a path is the line before it, unless its colour is the speed.
fn plane<'a>(parts: &[&'a str], unit: &str, has_speed: bool) -> Panel<'a> {
    let x_name = if unit == "mm" { "x [mm]" } else { "x [m]" };
    let mut plane = Panel { name: x_name.replace('x', "y"), x_name, ..Panel::default() };
    for (i, part) in parts.iter().enumerate().skip(1) {
        let rows = rows(part);
        let place = |row: &Vec<f64>| (row[1], row[2]);
        let marked = marks(part).into_iter().filter_map(|mark| rows.iter().find(|row| row[0] >= mark.0));
        plane.places.extend(marked.map(place));
        if has_speed {
            plane.curves.extend(by_speed(&rows));
            continue;
        }
        // What does not move is no path.
        let color = if rows[0].len() > 3 { COLORS[i - 1] } else { GREY };
        plane.curves.push((parts[i - 1].lines().last().unwrap(), color, rows.iter().map(place).collect()));
    }
    let points = || plane.curves.iter().flat_map(|path| &path.2);
    let (x, y) = (span(points().map(|p| p.0), 0.1), span(points().map(|p| p.1), 0.1));
    // The same scale in both directions.
    let height = (SIDES.end - SIDES.start) * (y.end - y.start) / (x.end - x.start);
    Panel { x, height, ..plane }
}

/// The path in pieces of about the same speed, which is the third number.
fn by_speed(rows: &[Vec<f64>]) -> Vec<Curve<'static>> {
    let class = |row: &Vec<f64>| SPEEDS.iter().position(|speed| row[3] < speed.0).unwrap_or(SPEEDS.len() - 1);
    let mut end = 0;
    let pieces = rows.chunk_by(|row, next| class(row) == class(next)).map(|piece| {
        let start = end;
        end += piece.len();
        let (_, name, color) = SPEEDS[class(&piece[0])];
        // A piece ends where the next one begins.
        (name, color, rows[start..rows.len().min(end + 1)].iter().map(|row| (row[1], row[2])).collect())
    });
    pieces.collect()
}

fn draw(text: &str, panels: &[Panel]) -> String {
    let (title, details) = text.lines().next().and_then(|line| line.split_once(": ")).expect("TITLE: DETAILS");
    let mut svg = Svg::default();
    svg.text((SIDES.start, 28.0), "start\" font-size=\"18", INK, title);
    svg.text((SIDES.start, 55.0), "start\" font-size=\"13", GREY, details);
    let mut top = 75.0;
    // The texts of the marks stand above the first panel that has marks.
    let with_texts = panels.iter().position(|panel| !panel.marks.is_empty());
    for (i, panel) in panels.iter().enumerate() {
        top = panel.draw(&mut svg, top, with_texts == Some(i));
    }
    // The legend names the curves, unless there is one alone, and the limits.
    let curves = panels.iter().flat_map(|panel| &panel.curves).map(|curve| (curve.0, curve.1));
    let has_limits = panels.iter().flat_map(|panel| &panel.levels).any(|level| level.1 == LIMIT);
    let mut entries: Vec<_> = curves.chain(has_limits.then_some(("limit", LIMIT))).collect();
    let mut named = HashSet::new();
    entries.retain(|(name, _)| !name.is_empty() && named.insert(*name));
    let (mut x, y) = (SIDES.start, top + 20.0);
    for (name, color) in entries {
        svg.line(&[(x, y), (x + 16.0, y)], "2.5", color);
        svg.text((x + 22.0, y + 4.0), "start", INK, name);
        x += 50.0 + width(name);
    }
    let colors = COLORS.into_iter().chain([LIMIT, INK, GREY]).zip(DARK);
    let dark = colors.map(|(c, dark)| format!("[stroke=\"{c}\"]{{stroke:{dark}}}[fill=\"{c}\"]{{fill:{dark}}}\n"));
    let (height, dark, Svg(paths, _, texts)) = (top.round() + 40.0, dark.collect::<String>(), svg);
    format!(
        "<svg width=\"900\" height=\"{height}\" viewBox=\"0 0 900 {height}\" xmlns=\"http://www.w3.org/2000/svg\">\n\
         <style>\n@media (prefers-color-scheme: dark){{\n{dark}}}\n</style>\n\
         <g fill=\"none\" stroke-linejoin=\"round\">{paths}\"/>\n</g>\n\
         <g font-family=\"sans-serif\" font-size=\"12\">{texts}\n</g>\n</svg>\n"
    )
}

impl Panel<'_> {
    /// Draws the panel below `top`; where it ends.
    fn draw(&self, svg: &mut Svg, top: f64, has_texts: bool) -> f64 {
        let top = top + if has_texts { 29.0 } else { 7.0 };
        let (x, bottom) = (&self.x, top + self.height);
        let values = self.curves.iter().flat_map(|curve| &curve.2).map(|point| point.1);
        let y = &span(values.chain(self.levels.iter().map(|level| level.2)), 0.1);
        let scale = (SIDES.end - SIDES.start) / (x.end - x.start);
        let across = |value: f64| SIDES.start + (value - x.start) * scale;
        let up = |value: f64| bottom - (value - y.start) * self.height / (y.end - y.start);
        for value in ticks(y, self.height / 33.0) {
            svg.line(&[(SIDES.start - 7.0, up(value)), (SIDES.end, up(value))], "1\" opacity=\".15", INK);
            svg.text((SIDES.start - 14.0, up(value) + 4.0), "end", INK, &rounded(value, 1e5).to_string());
        }
        svg.line(&[(SIDES.start, top), (SIDES.start, bottom)], "1\" opacity=\".6", INK);
        svg.text((-(top + bottom) / 2.0, 32.0), "middle\" font-size=\"13\" transform=\"rotate(-90)", INK, &self.name);
        if !self.x_name.is_empty() {
            svg.line(&[(SIDES.start, bottom), (SIDES.end, bottom)], "1\" opacity=\".6", INK);
            for value in ticks(x, 10.0) {
                svg.line(&[(across(value), bottom), (across(value), bottom + 7.0)], "1\" opacity=\".6", INK);
                svg.text((across(value), bottom + 21.0), "middle", INK, &rounded(value, 1e5).to_string());
            }
            svg.text(((SIDES.start + SIDES.end) / 2.0, bottom + 41.0), "middle\" font-size=\"13", INK, self.x_name);
        }
        for &(name, color, value) in &self.levels {
            let style = if color == LIMIT { "1\" opacity=\".7" } else { "1\" stroke-dasharray=\"6 4" };
            svg.line(&[(SIDES.start, up(value)), (SIDES.end, up(value))], style, color);
            // The name of a limit stands outside the range that the limits allow, that of another level below its line if a curve is above.
            let is_over = |point: &Point| {
                let above = up(value) - up(point.1);
                across(point.0) > SIDES.end - width(name) && above > -2.0 && above < 16.0
            };
            let is_crossed = || self.curves.iter().flat_map(|curve| &curve.2).any(is_over);
            let is_below = if color == LIMIT { value < 0.0 } else { is_crossed() };
            svg.text((SIDES.end, up(value) + if is_below { 12.0 } else { -4.0 }), "end", color, name);
        }
        for (i, &(time, what)) in self.marks.iter().enumerate() {
            svg.line(&[(across(time), top), (across(time), bottom)], "1\" opacity=\".5", INK);
            // The texts of two marks that are near each other lead away from each other.
            let is_near = |j: usize| self.marks.get(j).is_some_and(|other| (other.0 - time).abs() * scale < 70.0);
            let anchor = match [i + 1, i.wrapping_sub(1)].map(is_near) {
                [true, _] => "end",
                [_, true] => "start",
                // It would be cut off at the edge of the picture.
                _ if across(time) + width(what) / 2.0 > SIDES.end + 15.0 => "end",
                _ => "middle",
            };
            svg.text((across(time), top - 5.0), anchor, INK, if has_texts { what } else { "" });
        }
        for (_, color, points) in self.curves.iter().rev() {
            let points: Vec<_> = points.iter().map(|p| (across(p.0), up(p.1))).collect();
            svg.line(&thin(&points), if self.name == "pulses" { "1" } else { "2.5" }, color);
        }
        // A line without a length has round ends.
        for place in self.places.iter().map(|place| (across(place.0), up(place.1))) {
            svg.line(&[place, place], "12\" stroke-linecap=\"round", INK);
        }
        bottom + if self.x_name.is_empty() { 7.0 } else { 52.0 }
    }
}

/// Lines, the style of the last ones, and texts. The first attribute of a style may go on with others.
#[derive(Default)]
struct Svg(String, String, String);

impl Svg {
    /// Lines of the same style follow each other in one path.
    fn line(&mut self, points: &[Point], width: &str, color: Color) {
        let style = format!("\n<path stroke=\"{color}\" stroke-width=\"{width}\" d=\"");
        if self.1 != style {
            self.0 += &format!("{}{style}", if self.1.is_empty() { "" } else { "\"/>" });
            self.1 = style;
        }
        let points = points.iter().map(|(x, y)| format!("{},{}", rounded(*x, 10.0), rounded(*y, 10.0)));
        self.0 += &format!("M{}", points.collect::<Vec<_>>().join(" "));
    }

    fn text(&mut self, at: Point, anchor: &str, color: Color, text: &str) {
        let (x, y) = (rounded(at.0, 10.0), rounded(at.1, 10.0));
        if !text.is_empty() {
            self.2 += &format!("\n<text x=\"{x}\" y=\"{y}\" fill=\"{color}\" text-anchor=\"{anchor}\">{text}</text>");
        }
    }
}

/// About the width of a text, in pixels.
fn width(text: &str) -> f64 {
    text.len() as f64 * 7.0
}

/// A zero has no sign.
fn rounded(number: f64, parts: f64) -> f64 {
    (number * parts).round() / parts + 0.0
}

/// The points that a curve needs, so that it leaves no point by more than a third of a pixel: Ramer, Douglas and Peucker's.
fn thin(points: &[Point]) -> Vec<Point> {
    let [first, .., last] = points else { return points.to_vec() };
    let (dx, dy) = (last.0 - first.0, last.1 - first.1);
    let length = dx.hypot(dy);
    let distance = |point: &Point| {
        let (x, y) = (point.0 - first.0, point.1 - first.1);
        if length > 0.0 { (x * dy - y * dx).abs() / length } else { x.hypot(y) }
    };
    match points.iter().map(distance).enumerate().max_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((far, distance)) if distance > 0.3 => [&thin(&points[..=far])[..], &thin(&points[far..])[1..]].concat(),
        _ => vec![*first, *last],
    }
}

/// Round numbers in a range, at most about so many.
fn ticks(range: &Range<f64>, most: f64) -> impl Iterator<Item = f64> {
    let steps = (-6..6).flat_map(|power| [1.0, 2.0, 5.0].map(|digit| digit * 10f64.powi(power)));
    let step = steps.into_iter().find(|step| step * most >= range.end - range.start).expect("a range of numbers");
    let (first, last) = ((range.start / step).ceil() as i64, (range.end / step).floor() as i64);
    (first..=last).map(move |k| k as f64 * step)
}

/// The range of values, with room above and below: a part of its length, or 1 if it has none.
fn span(values: impl Iterator<Item = f64>, part: f64) -> Range<f64> {
    let (least, most) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |ends, v| (ends.0.min(v), ends.1.max(v)));
    let room = if most > least { part * (most - least) } else { 1.0 };
    least - room..most + room
}
