//! Draws what the examples print. `plot DIRECTORY FILE…` writes one SVG for each file. These lines of a file make its picture:
//!
//! ```text
//! TITLE: DETAILS                                        the first line; the title is the SVG's name
//! within 5 m/s, +4 m/s^2, -8 m/s^2                      limits, of both directions or of one
//! x within 1 m/s                                        a limit of something that has a name
//! 0.250 s: 0.1 m, 0.2 m/s, part 0.5 m, 0.4 m/s          a setpoint, and beside it the setpoint of something else
//! 0.250 s: 0.1 0.2 0.3 deg, 4 5 6 deg/s                 a setpoint of three axes
//! 0.700 s -> to -2 m                                    what happens at this time: a mark
//! 1.250 Hz: ZV 31 %, EI 4 %                             what is left of a vibration of this frequency
//! synchronised:                                         from here on each setpoint has an x and a y, and is a point of a path
//! 0.250 s: x 0.1 m, y 0.2 m, 0.3 0.4 m/s                what else it has is drawn over time, for the last path
//! ```
//!
//! A picture has no background, and lighter colours where the reader's pages are dark.

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

const AXES: [&str; 2] = ["x", "y"];
const QUANTITIES: [&str; 4] = ["position", "velocity", "acceleration", "jerk"];
const COLORS: [RGBColor; 6] = [
    RGBColor(31, 90, 166),
    RGBColor(24, 128, 78),
    RGBColor(204, 85, 0),
    RGBColor(140, 40, 130),
    RGBColor(170, 130, 0),
    RGBColor(30, 135, 155),
];
const LIMIT: RGBColor = RGBColor(200, 30, 50);
const INK: RGBColor = RGBColor(40, 44, 52);
const FAINT: RGBColor = RGBColor(100, 106, 116);
/// What the colours above are on a dark page, in their order.
const DARK: [RGBColor; 9] = [
    RGBColor(127, 178, 240),
    RGBColor(95, 207, 151),
    RGBColor(242, 166, 90),
    RGBColor(225, 140, 215),
    RGBColor(222, 190, 80),
    RGBColor(110, 205, 225),
    RGBColor(255, 120, 130),
    RGBColor(230, 231, 233),
    RGBColor(151, 157, 166),
];

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
    limits: Vec<Limit>,
    marks: Vec<(f64, String)>,
    /// In the plane of x and y.
    paths: Vec<Curve>,
    /// Where the marks are on the paths.
    points: Vec<Point>,
    /// Quantities over time, of the last path if there is one.
    curves: Vec<Curve>,
    /// The curves are quantities over a frequency, else over time.
    is_spectrum: bool,
}

struct Limit {
    /// Empty if it is the only one of its unit.
    of: String,
    /// With a sign, it is a limit of one direction.
    size: String,
    unit: String,
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
        let mut is_marked = false;
        for line in lines {
            if let Some((of, limits)) = line.split_once("within ") {
                let limits = limits.split(", ").filter_map(|limit| limit.split_once(' '));
                let owned = limits.map(|(size, unit)| Limit {
                    of: of.trim().to_owned(),
                    size: size.to_owned(),
                    unit: unit.to_owned(),
                });
                picture.limits.extend(owned);
            } else if let Some((time, what)) = line.split_once(" s -> ") {
                picture.marks.push((time.parse()?, what.to_owned()));
                is_marked = true;
            } else if let Some((frequency, numbers)) = line.split_once(" Hz: ") {
                picture.is_spectrum = true;
                picture.add(frequency.parse()?, numbers)?;
            } else if let Some((time, numbers)) = line.split_once(" s: ") {
                picture.add(time.parse()?, numbers)?;
                let here = picture.paths.last().and_then(|path| path.points.last());
                picture.points.extend(here.filter(|_| is_marked));
                is_marked = false;
            } else if let Some(name) = line.strip_suffix(':') {
                picture.paths.push(Curve::new(name, "m"));
                picture.curves.clear();
                picture.marks.clear();
            }
        }
        let mut lengths = picture.curves.iter().map(|curve| curve.points.len());
        let first = lengths.next();
        if lengths.any(|length| Some(length) != first) {
            return Err("setpoints of different length".into());
        }
        if first.is_none() && picture.paths.iter().all(|path| path.points.is_empty()) {
            return Err("no setpoints to draw".into());
        }
        Ok(picture)
    }

    /// Adds the numbers of a setpoint to their curves.
    fn add(&mut self, time: f64, text: &str) -> Result<()> {
        let mut name = String::new();
        let mut place = Vec::new();
        for quantity in text.split(", ") {
            let words: Vec<_> = quantity.split(' ').collect();
            let is_number = |word: &&str| word.parse::<f64>().is_ok_and(f64::is_finite);
            let first = words.iter().position(is_number).ok_or("no number")?;
            let (unit, numbers) = words[first..].split_last().ok_or("no number")?;
            if first > 0 {
                name = words[..first].join(" ");
            }
            for (axis, number) in numbers.iter().enumerate() {
                let number = number.parse()?;
                let of_axis = match (numbers.len(), AXES.get(axis)) {
                    (1, _) if !self.paths.is_empty() => {
                        place.push(number);
                        continue;
                    }
                    (1, _) => name.clone(),
                    (2, Some(axis)) if !self.paths.is_empty() => (*axis).to_owned(),
                    _ => format!("axis {}", axis + 1),
                };
                self.curve(&of_axis, unit).push((time, number));
            }
        }
        match (&place[..], self.paths.last_mut()) {
            (&[x, y], Some(path)) => path.points.push((x, y)),
            (_, None) if !self.curves.is_empty() => {}
            _ => return Err("no setpoint".into()),
        }
        Ok(())
    }

    fn curve(&mut self, name: &str, unit: &str) -> &mut Vec<Point> {
        let same = |curve: &Curve| curve.name == name && curve.unit == unit;
        let index = self.curves.iter().position(same).unwrap_or_else(|| {
            self.curves.push(Curve::new(name, unit));
            self.curves.len() - 1
        });
        &mut self.curves[index].points
    }

    /// The plane, if there are paths, and one panel for each unit of the curves over time.
    fn panels(&self) -> Result<Vec<Panel<'_>>> {
        let mut units: Vec<&str> = self.curves.iter().map(|curve| &*curve.unit).collect();
        let mut seen = HashSet::new();
        units.retain(|unit| seen.insert(*unit));
        let plane = (!self.paths.is_empty()).then(|| self.plane());
        let over_time = units
            .into_iter()
            .map(|unit| self.over_time_or_frequency(unit));
        plane.into_iter().chain(over_time).collect()
    }

    fn plane(&self) -> Result<Panel<'_>> {
        if self.paths.len() > COLORS.len() {
            return Err("too many paths".into());
        }
        let curves: Vec<_> = self.paths.iter().zip(COLORS).collect();
        let (x, y) = spans(&curves);
        let (x, y) = (with_margin(x), with_margin(y));
        // The plane has the same scale in both directions.
        let ratio = (y.end - y.start) / (x.end - x.start);
        Ok(Panel {
            curves,
            limits: Vec::new(),
            marks: &[],
            points: &self.points,
            x,
            y,
            x_name: "x [m]",
            y_name: "y [m]".to_owned(),
            height: (f64::from(INNER) * ratio) as u32,
        })
    }

    fn over_time_or_frequency(&self, unit: &str) -> Result<Panel<'_>> {
        let derivatives = ["", "/s", "/s^2", "/s^3"];
        let per = unit.find("/s").unwrap_or(unit.len());
        let order = derivatives.iter().position(|per_s| *per_s == &unit[per..]);
        let order = order.ok_or("too many quantities")?;
        // A colour of a path means the path.
        let mut colors = COLORS.into_iter().skip(self.paths.len());
        let mut curves = Vec::new();
        for curve in self.curves.iter().filter(|curve| curve.unit == unit) {
            let color = match curve.name.as_str() {
                "" => Some(COLORS[order]),
                name if !self.paths.is_empty() || self.is_spectrum || name.starts_with("axis ") => {
                    colors.next()
                }
                _ => Some(FAINT),
            };
            curves.push((curve, color.ok_or("too many curves")?));
        }
        let (x, y) = spans(&curves);
        let mut limits = Vec::new();
        for Limit { of, size, .. } in self.limits.iter().filter(|limit| limit.unit == unit) {
            let number = size.trim_start_matches(['+', '-']).parse::<f64>()?;
            // A limit is drawn on the side where the curve is.
            if y.end > 0.0 && !size.starts_with('-') {
                limits.push((&**of, number));
            }
            if y.start < 0.0 && !size.starts_with('+') {
                limits.push((&**of, -number));
            }
        }
        let levels = limits.iter().map(|limit| limit.1);
        let y = with_margin(span(levels.chain([y.start, y.end])));
        let unit = unit.replace("^2", "²").replace("^3", "³");
        let (x_name, quantity) = if self.is_spectrum {
            ("frequency [Hz]", "vibration")
        } else {
            ("time [s]", QUANTITIES[order])
        };
        Ok(Panel {
            curves,
            limits,
            marks: &self.marks,
            points: &[],
            x,
            y,
            x_name,
            y_name: format!("{quantity} [{unit}]"),
            height: PANEL,
        })
    }

    /// Draws the picture into this directory; its path.
    fn draw(&self, directory: &Path) -> Result<PathBuf> {
        let panels = self.panels()?;
        // The first panel over time has room for the text of the marks, the last panel and the plane for the text of their axis.
        let first = usize::from(!self.paths.is_empty());
        let has_marks = !self.marks.is_empty();
        let above = |place| {
            if place == first && has_marks {
                MARKS
            } else {
                0
            }
        };
        let has_axis = |place| place + 1 == first || place + 1 == panels.len();
        let under = |place| if has_axis(place) { TIME_AXIS } else { 0 };
        let room = |place: usize| above(place) + panels[place].height + 2 * GAP + under(place);
        let height = HEADING + (0..panels.len()).map(room).sum::<u32>() + LEGEND;
        let mut svg = String::new();
        {
            let root = SVGBackend::with_string(&mut svg, (WIDTH, height)).into_drawing_area();
            let large = text(TITLE).color(&INK);
            root.draw_text(&self.title, &large, (LEFT as i32, HEADING as i32 / 5))?;
            let small = text(TEXT).color(&FAINT);
            root.draw_text(&self.details, &small, (LEFT as i32, HEADING as i32 * 3 / 5))?;
            let (_, mut below) = root.split_vertically(HEADING);
            for (place, panel) in panels.iter().enumerate() {
                let (area, rest) = below.split_vertically(room(place));
                panel.draw(&area, above(place), under(place))?;
                below = rest;
            }
            draw_legend(&below, &panels)?;
            root.present()?;
        }
        let words = self.title.split(|c: char| !c.is_alphanumeric());
        let words: Vec<_> = words.filter(|word| !word.is_empty()).collect();
        let path = directory.join(words.join("-").to_lowercase() + ".svg");
        let size = |units| format!("width=\"{}\" height=\"{}\"", WIDTH / units, height / units);
        let svg = svg.replacen(&size(1), &size(UNITS), 1);
        fs::write(&path, svg.replacen(">\n", &format!(">\n{}\n", style()), 1))?;
        Ok(path)
    }
}

impl Curve {
    fn new(name: &str, unit: &str) -> Self {
        let (name, unit, points) = (name.to_owned(), unit.to_owned(), Vec::new());
        Self { name, unit, points }
    }
}

/// Corners of a curve do not stand out beyond a limit, and every colour changes where pages are dark.
fn style() -> String {
    let light = COLORS.into_iter().chain([LIMIT, INK, FAINT]);
    let hex = |RGBColor(red, green, blue)| format!("#{red:02X}{green:02X}{blue:02X}");
    let rule = |(light, dark)| {
        let (light, dark) = (hex(light), hex(dark));
        format!("[stroke=\"{light}\"]{{stroke:{dark}}}[fill=\"{light}\"]{{fill:{dark}}}\n")
    };
    let rules: String = light.zip(DARK).map(rule).collect();
    format!(
        "<style>\npolyline{{stroke-linejoin:round}}\n@media (prefers-color-scheme: dark){{\n{rules}}}\n</style>"
    )
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
    /// Of what, and where.
    limits: Vec<(&'a str, f64)>,
    marks: &'a [(f64, String)],
    points: &'a [Point],
    x: Range<f64>,
    y: Range<f64>,
    x_name: &'static str,
    y_name: String,
    height: u32,
}

impl Panel<'_> {
    /// `above` is the room for the text of the marks, `under` for the text of the axis.
    fn draw(&self, area: &Area, above: u32, under: u32) -> Result<()> {
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
        let at = |horizontal| Pos::new(horizontal, VPos::Bottom);
        for &(of, limit) in &self.limits {
            let ends = vec![(x.start, limit), (x.end, limit)];
            line(ends, LIMIT.mix(0.7).stroke_width(THIN))?;
            let style = text(LABEL).color(&LIMIT).pos(at(HPos::Right));
            area.draw(&Text::new(of.to_owned(), (x.end, limit), style))?;
        }
        let when = |i: usize| self.marks.get(i).map_or(f64::INFINITY, |mark| mark.0);
        let near = f64::from(5 * LABEL) / f64::from(INNER) * (x.end - x.start);
        let is_near = |i, j| when(j) - when(i) < near;
        for (i, (time, what)) in self.marks.iter().enumerate() {
            let ends = vec![(*time, y.start), (*time, y.end)];
            line(ends, INK.mix(0.5).stroke_width(THIN))?;
            if above > 0 {
                // The texts of two marks that are near each other lead away from each other.
                let side = if is_near(i, i + 1) {
                    HPos::Right
                } else if i > 0 && is_near(i - 1, i) {
                    HPos::Left
                } else {
                    HPos::Center
                };
                let style = text(LABEL).color(&INK).pos(at(side));
                area.draw(&Text::new(what.clone(), (*time, y.end), style))?;
            }
        }
        let scale = |pixels: u32, range: &Range<f64>| f64::from(pixels) / (range.end - range.start);
        let scales = (scale(INNER, x), scale(self.height, y));
        for (curve, color) in self.curves.iter().rev() {
            line(thin(&curve.points, scales), color.stroke_width(CURVE))?;
        }
        for &point in self.points {
            area.draw(&Circle::new(point, GAP, INK.filled()))?;
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

/// What the curves span in both directions.
fn spans(curves: &[(&Curve, RGBColor)]) -> (Range<f64>, Range<f64>) {
    let points = || curves.iter().flat_map(|(curve, _)| &curve.points);
    (span(points().map(|p| p.0)), span(points().map(|p| p.1)))
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
