//! Draws what the examples print. `plot DIRECTORY FILE…` writes one SVG for each file. These lines of a file make its picture:
//!
//! ```text
//! TITLE: DETAILS                                        the first line; the title is the SVG's name
//! within 5 m/s, +4 m/s^2, -8 m/s^2                      limits, of both directions or of one
//! 0.250 s: 0.1 m, 0.2 m/s, part 0.5 m, 0.4 m/s          a setpoint, and beside it the setpoint of something else
//! 0.250 s: 0.1 0.2 0.3 deg, 4 5 6 deg/s                 a setpoint of three axes
//! 0.700 s -> to -2 m                                    what happens at this time: a mark
//! synchronised:                                         from here on each setpoint has an x and a y, and is a point of a path
//! ```

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::collections::HashSet;
use std::error::Error;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::{env, fs};

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Result<T> = std::result::Result<T, Box<dyn Error>>;
type Point = (f64, f64);

const QUANTITIES: [&str; 4] = ["position", "velocity", "acceleration", "jerk"];
const COLORS: [RGBColor; 6] = [
    RGBColor(31, 90, 166),
    RGBColor(24, 128, 78),
    RGBColor(204, 85, 0),
    RGBColor(140, 40, 130),
    RGBColor(170, 130, 0),
    RGBColor(70, 170, 190),
];
const LIMIT: RGBColor = RGBColor(200, 30, 50);
const INK: RGBColor = RGBColor(40, 44, 52);
const FAINT: RGBColor = RGBColor(120, 126, 136);

// The backend rounds coordinates to whole units. Four units per pixel keep curves smooth.
const UNITS: u32 = 4;
const WIDTH: u32 = 900 * UNITS;
const HEADING: u32 = 75 * UNITS;
const MARKS: u32 = 22 * UNITS;
const PANEL: u32 = 166 * UNITS;
const TIME_AXIS: u32 = 45 * UNITS;
const LEGEND: u32 = 45 * UNITS;
const MARGIN: u32 = 20 * UNITS;
const VALUE_AXIS: u32 = 75 * UNITS;
const LEFT: u32 = MARGIN + VALUE_AXIS;
const INNER: u32 = WIDTH - LEFT - 25 * UNITS;
const GAP: u32 = 7 * UNITS;
const THIN: u32 = UNITS;
const CURVE: u32 = 5 * UNITS / 2;
const TITLE: u32 = 23 * UNITS;
const TEXT: u32 = 16 * UNITS;
const LABEL: u32 = 14 * UNITS;

fn main() -> Result<()> {
    let arguments: Vec<_> = env::args_os().skip(1).map(PathBuf::from).collect();
    let [directory, files @ ..] = &arguments[..] else {
        return Err("usage: plot DIRECTORY FILE…".into());
    };
    fs::create_dir_all(directory)?;
    let mut drawn = HashSet::new();
    for file in files {
        let picture = Picture::read(&fs::read_to_string(file)?);
        let path = picture.and_then(|picture| picture.draw(directory));
        let path = path.map_err(|e| format!("{}: {e}", file.display()))?;
        println!("{}", path.display());
        if !drawn.insert(path) {
            return Err(format!("{} has the title of another file", file.display()).into());
        }
    }
    if drawn.is_empty() {
        Err("no file to draw".into())
    } else {
        Ok(())
    }
}

/// What an example printed.
#[derive(Default)]
struct Picture {
    title: String,
    details: String,
    /// With a unit each. A limit with a sign is a limit of one direction.
    limits: Vec<(String, String)>,
    marks: Vec<(f64, String)>,
    curves: Vec<Curve>,
    /// The curves are paths, else they are quantities over time.
    is_plane: bool,
}

struct Curve {
    name: String,
    unit: String,
    points: Vec<Point>,
}

impl Picture {
    fn read(text: &str) -> Result<Self> {
        let mut lines = text.lines();
        let title = lines.next().unwrap_or_default();
        let (title, details) = title.split_once(": ").unwrap_or((title, ""));
        let mut picture = Self {
            title: title.to_owned(),
            details: details.to_owned(),
            ..Self::default()
        };
        let mut path = "";
        for line in lines {
            if let Some((_, limits)) = line.split_once("within ") {
                let limits = limits.split(", ").filter_map(|limit| limit.split_once(' '));
                let owned = limits.map(|(limit, unit)| (limit.to_owned(), unit.to_owned()));
                picture.limits.extend(owned);
            } else if let Some((time, what)) = line.split_once(" s -> ") {
                picture.marks.push((time.parse()?, what.to_owned()));
            } else if let Some((time, numbers)) = line.split_once(" s: ") {
                picture.add(path, time.parse()?, numbers)?;
            } else if let Some(name) = line.strip_suffix(':') {
                (path, picture.is_plane) = (name, true);
            }
        }
        let first = picture.curves.first().ok_or("no setpoints to draw")?;
        let same = |curve: &Curve| curve.points.len() == first.points.len();
        if !picture.is_plane && !picture.curves.iter().all(same) {
            return Err("setpoints of different length".into());
        }
        Ok(picture)
    }

    /// Adds the numbers of a setpoint to their curves.
    fn add(&mut self, path: &str, time: f64, text: &str) -> Result<()> {
        let mut name = String::new();
        let mut all = Vec::new();
        for quantity in text.split(", ") {
            let words: Vec<_> = quantity.split(' ').collect();
            let is_number = |word: &&str| word.parse::<f64>().is_ok_and(f64::is_finite);
            let first = words.iter().position(is_number).ok_or("no number")?;
            let (unit, numbers) = words[first..].split_last().ok_or("no number")?;
            if first > 0 {
                name = words[..first].join(" ");
            }
            for (axis, number) in (1..).zip(numbers) {
                let number = number.parse()?;
                all.push(number);
                match numbers.len() {
                    _ if self.is_plane => {}
                    1 => self.curve(&name, unit).push((time, number)),
                    _ => {
                        let name = format!("axis {axis}");
                        self.curve(&name, unit).push((time, number));
                    }
                }
            }
        }
        match all[..] {
            [x, y] if self.is_plane => self.curve(path, "m").push((x, y)),
            [_, ..] if !self.is_plane => {}
            _ => return Err("no setpoint".into()),
        }
        Ok(())
    }

    fn curve(&mut self, name: &str, unit: &str) -> &mut Vec<Point> {
        let same = |curve: &Curve| curve.name == name && curve.unit == unit;
        let index = self.curves.iter().position(same).unwrap_or_else(|| {
            let (name, unit, points) = (name.to_owned(), unit.to_owned(), Vec::new());
            self.curves.push(Curve { name, unit, points });
            self.curves.len() - 1
        });
        &mut self.curves[index].points
    }

    /// One panel for each unit.
    fn panels(&self) -> Result<Vec<Panel<'_>>> {
        let mut units: Vec<&str> = self.curves.iter().map(|curve| &*curve.unit).collect();
        let mut seen = HashSet::new();
        units.retain(|unit| seen.insert(*unit));
        if units.len() > QUANTITIES.len() {
            return Err("too many quantities".into());
        }
        let panels = units.into_iter().zip(QUANTITIES.iter().zip(COLORS));
        panels
            .map(|(unit, (quantity, color))| self.panel(unit, quantity, color))
            .collect()
    }

    fn panel(&self, unit: &str, quantity: &str, color: RGBColor) -> Result<Panel<'_>> {
        let mut colors = COLORS.into_iter();
        let mut curves = Vec::new();
        for curve in self.curves.iter().filter(|curve| curve.unit == unit) {
            let color = match curve.name.as_str() {
                "" => Some(color),
                name if self.is_plane || name.starts_with("axis ") => colors.next(),
                _ => Some(FAINT),
            };
            curves.push((curve, color.ok_or("too many curves")?));
        }
        let points = || curves.iter().flat_map(|(curve, _)| &curve.points);
        let (x, y) = (span(points().map(|p| p.0)), span(points().map(|p| p.1)));
        let mut limits = Vec::new();
        for (limit, _) in self.limits.iter().filter(|limit| limit.1 == unit) {
            let size = limit.trim_start_matches(['+', '-']).parse::<f64>()?;
            // A limit is drawn on the side where the curve is.
            if y.end > 0.0 && !limit.starts_with('-') {
                limits.push(size);
            }
            if y.start < 0.0 && !limit.starts_with('+') {
                limits.push(-size);
            }
        }
        let y = with_margin(span(limits.iter().copied().chain([y.start, y.end])));
        let x = if self.is_plane { with_margin(x) } else { x };
        // The plane has the same scale in both directions.
        let ratio = (y.end - y.start) / (x.end - x.start);
        let height = if self.is_plane {
            (f64::from(INNER) * ratio) as u32
        } else {
            PANEL
        };
        let x_name = if self.is_plane { "x [m]" } else { "time [s]" };
        let y_name = if self.is_plane { "y" } else { quantity };
        let y_name = format!("{y_name} [{}]", unit.replace("^2", "²").replace("^3", "³"));
        Ok(Panel {
            curves,
            limits,
            x,
            y,
            x_name,
            y_name,
            height,
        })
    }

    /// Draws the picture into this directory; its path.
    fn draw(&self, directory: &Path) -> Result<PathBuf> {
        let panels = self.panels()?;
        let marks = if self.marks.is_empty() { 0 } else { MARKS };
        let panel_heights: u32 = panels.iter().map(|panel| panel.height + 2 * GAP).sum();
        let height = HEADING + marks + panel_heights + TIME_AXIS + LEGEND;
        let mut svg = String::new();
        {
            let root = SVGBackend::with_string(&mut svg, (WIDTH, height)).into_drawing_area();
            root.fill(&WHITE)?;
            let large = text(TITLE).color(&INK);
            root.draw_text(&self.title, &large, (LEFT as i32, HEADING as i32 / 5))?;
            let small = text(TEXT).color(&FAINT);
            root.draw_text(&self.details, &small, (LEFT as i32, HEADING as i32 * 3 / 5))?;
            let (_, mut below) = root.split_vertically(HEADING);
            for (place, panel) in (1..).zip(&panels) {
                let above = if place == 1 { marks } else { 0 };
                let under = if place == panels.len() { TIME_AXIS } else { 0 };
                let (area, rest) = below.split_vertically(above + panel.height + 2 * GAP + under);
                panel.draw(&area, above, under, &self.marks)?;
                below = rest;
            }
            draw_legend(&below, &panels)?;
            root.present()?;
        }
        let words = self.title.split(|c: char| !c.is_alphanumeric());
        let words: Vec<_> = words.filter(|word| !word.is_empty()).collect();
        let path = directory.join(words.join("-").to_lowercase() + ".svg");
        let size = |units| format!("width=\"{}\" height=\"{}\"", WIDTH / units, height / units);
        fs::write(&path, svg.replacen(&size(1), &size(UNITS), 1))?;
        Ok(path)
    }
}

/// Names the curves, unless there is one alone, and the limits.
fn draw_legend(area: &Area, panels: &[Panel]) -> Result<()> {
    let curves = panels.iter().flat_map(|panel| &panel.curves);
    let mut entries: Vec<_> = curves
        .map(|(curve, color)| (&*curve.name, *color))
        .collect();
    let mut named = HashSet::new();
    entries.retain(|(name, _)| named.insert(*name));
    if panels.iter().any(|panel| !panel.limits.is_empty()) {
        entries.push(("limit", LIMIT));
    }
    entries.retain(|(name, _)| !name.is_empty());
    let step = INNER / entries.len().max(5) as u32;
    for (place, (name, color)) in (0..).zip(entries) {
        let (x, y) = ((LEFT + place * step) as i32, LABEL as i32);
        let sample = [(x, y + y / 2), (x + TEXT as i32, y + y / 2)];
        area.draw(&PathElement::new(sample, color.stroke_width(CURVE)))?;
        let place = (x + (TEXT + LABEL / 2) as i32, y);
        area.draw_text(name, &text(LABEL).color(&INK), place)?;
    }
    Ok(())
}

/// Curves with common axes.
struct Panel<'a> {
    curves: Vec<(&'a Curve, RGBColor)>,
    limits: Vec<f64>,
    x: Range<f64>,
    y: Range<f64>,
    x_name: &'static str,
    y_name: String,
    height: u32,
}

impl Panel<'_> {
    /// `above` is the room for the text of the marks, `under` for the text of the axis.
    fn draw(&self, area: &Area, above: u32, under: u32, marks: &[(f64, String)]) -> Result<()> {
        let (x, y) = (&self.x, &self.y);
        let mut chart = ChartBuilder::on(area)
            .margin_top(GAP + above)
            .margin_bottom(GAP)
            .margin_left(MARGIN)
            .margin_right(WIDTH - LEFT - INNER)
            .set_label_area_size(LabelAreaPosition::Left, VALUE_AXIS)
            .set_label_area_size(LabelAreaPosition::Bottom, under)
            .build_cartesian_2d(x.clone(), y.clone())?;
        chart
            .configure_mesh()
            .disable_x_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(INK.mix(0.12).stroke_width(THIN))
            .axis_style(INK.mix(0.6).stroke_width(THIN))
            .label_style(text(LABEL).color(&INK))
            .axis_desc_style(text(TEXT).color(&INK))
            .set_all_tick_mark_size(GAP)
            .y_labels(5)
            .x_label_formatter(&|value| label(*value))
            .y_label_formatter(&|value| label(*value))
            .x_desc(self.x_name)
            .y_desc(&self.y_name)
            .draw()?;
        let area = chart.plotting_area();
        let line =
            |points, style| area.draw(&PathElement::<Point>::new::<Vec<_>, _>(points, style));
        for &limit in &self.limits {
            let ends = vec![(x.start, limit), (x.end, limit)];
            line(ends, LIMIT.mix(0.7).stroke_width(THIN))?;
        }
        for (time, what) in marks {
            let ends = vec![(*time, y.start), (*time, y.end)];
            line(ends, INK.mix(0.5).stroke_width(THIN))?;
            if above > 0 {
                let style = text(LABEL)
                    .color(&INK)
                    .pos(Pos::new(HPos::Center, VPos::Bottom));
                area.draw(&Text::new(what.clone(), (*time, y.end), style))?;
            }
        }
        let scale = |pixels: u32, range: &Range<f64>| f64::from(pixels) / (range.end - range.start);
        let scales = (scale(INNER, x), scale(self.height, y));
        for (curve, color) in self.curves.iter().rev() {
            line(thin(&curve.points, scales), color.stroke_width(CURVE))?;
        }
        Ok(())
    }
}

fn text(size: u32) -> TextStyle<'static> {
    TextStyle::from(("sans-serif", size))
}

/// The points that a curve needs, so that it leaves no point by more than a unit: Ramer, Douglas and Peucker's.
fn thin(points: &[Point], scale: Point) -> Vec<Point> {
    let [first, .., last] = points else {
        return points.to_vec();
    };
    let across = |p: &Point, q: &Point| ((q.0 - p.0) * scale.0, (q.1 - p.1) * scale.1);
    let (dx, dy) = across(first, last);
    let distance = |point: &Point| {
        let (x, y) = across(first, point);
        match dx.hypot(dy) {
            0.0 => x.hypot(y),
            length => (x * dy - y * dx).abs() / length,
        }
    };
    let distances = points.iter().map(distance).enumerate();
    match distances.max_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((far, distance)) if distance > 1.0 => {
            let mut thinned = thin(&points[..=far], scale);
            thinned.pop();
            thinned.extend(thin(&points[far..], scale));
            thinned
        }
        _ => vec![*first, *last],
    }
}

/// The text beside a tick. A tick at zero may be off by a rounding or carry a sign; its text is "0".
fn label(value: f64) -> String {
    ((value * 1e5).round() / 1e5 + 0.0).to_string()
}

fn span(values: impl Iterator<Item = f64>) -> Range<f64> {
    values.fold(f64::INFINITY..f64::NEG_INFINITY, |span, value| {
        span.start.min(value)..span.end.max(value)
    })
}

/// Adds room above and below a curve, also if the curve is level.
fn with_margin(span: Range<f64>) -> Range<f64> {
    let margin = match span.end - span.start {
        0.0 => 1.0,
        height => 0.1 * height,
    };
    span.start - margin..span.end + margin
}
