//! Draws what the examples print. `plot DIRECTORY FILE…` writes one SVG for each file. These lines of a file make its picture:
//!
//! ```text
//! TITLE: DETAILS                                        the first line; the title is the SVG's name
//! within 5 m/s, +4 m/s^2, -8 m/s^2                      limits, of both directions or of one
//! 0.250 s: 0.1 m, 0.2 m/s, part 0.5 m, 0.4 m/s          a setpoint, and beside it the setpoint of something else
//! 0.250 s: 0.1 0.2 0.3 deg, 4 5 6 deg/s                 a setpoint of three axes
//! 0.700 s -> to -2 m                                    what happens at this time: a mark
//! synchronised:                                         the setpoints from here on are a path in the plane
//! ```

use plotters::coord::Shift;
use plotters::data::float::FloatPrettyPrinter;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::error::Error;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::{env, fs};

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), Box<dyn Error>>;
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
const PANEL: u32 = 180 * UNITS;
const LEGEND: u32 = 45 * UNITS;
const TIME_AXIS: u32 = 45 * UNITS;
const MARGIN: u32 = 20 * UNITS;
const VALUE_AXIS: u32 = 75 * UNITS;
const LEFT: u32 = MARGIN + VALUE_AXIS;
const RIGHT: u32 = 25 * UNITS;
const GAP: u32 = 7 * UNITS;
const THIN: u32 = UNITS;
const CURVE: u32 = 5 * UNITS / 2;
const TITLE: u32 = 23 * UNITS;
const TEXT: u32 = 16 * UNITS;
const LABEL: u32 = 14 * UNITS;

fn main() -> Drawn {
    let mut arguments = env::args_os().skip(1).map(PathBuf::from);
    let directory = arguments.next().ok_or("usage: plot DIRECTORY FILE…")?;
    fs::create_dir_all(&directory)?;
    for file in arguments {
        let name = |e: Box<dyn Error>| format!("{}: {e}", file.display());
        let picture = Picture::read(&fs::read_to_string(&file)?).map_err(name)?;
        let path = directory.join(picture.file_name());
        picture.draw(&path).map_err(name)?;
        println!("{}", path.display());
    }
    Ok(())
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
}

/// One quantity of an axis, or of something beside it, over time.
struct Curve {
    /// The path in the plane to which it belongs, if any.
    path: Option<String>,
    name: String,
    unit: String,
    points: Vec<Point>,
}

impl Picture {
    fn read(text: &str) -> Result<Self, Box<dyn Error>> {
        let mut lines = text.lines();
        let title = lines.next().unwrap_or_default();
        let (title, details) = title.split_once(": ").unwrap_or((title, ""));
        let mut picture = Self {
            title: title.to_owned(),
            details: details.to_owned(),
            ..Self::default()
        };
        let mut path = None;
        for line in lines {
            if let Some((_, limits)) = line.split_once("within ") {
                let limits = limits.split(", ").filter_map(|limit| limit.split_once(' '));
                let owned = limits.map(|(limit, unit)| (limit.to_owned(), unit.to_owned()));
                picture.limits.extend(owned);
            } else if let Some((time, what)) = line.split_once(" s -> ") {
                picture.marks.push((time.parse()?, what.to_owned()));
            } else if let Some((time, numbers)) = line.split_once(" s: ") {
                picture.add(&path, time.parse()?, numbers)?;
            } else if let Some(name) = line.strip_suffix(':') {
                path = Some(name.to_owned());
            }
        }
        picture.curves.first().ok_or("no setpoints to draw")?;
        for pair in picture.curves.windows(2) {
            if pair[0].path == pair[1].path && pair[0].points.len() != pair[1].points.len() {
                return Err("setpoints of different length".into());
            }
        }
        Ok(picture)
    }

    /// Adds the numbers of a setpoint to their curves.
    fn add(&mut self, path: &Option<String>, time: f64, text: &str) -> Drawn {
        let mut name = String::new();
        for quantity in text.split(", ") {
            let words: Vec<_> = quantity.split(' ').collect();
            let is_number = |word: &&str| word.parse::<f64>().is_ok();
            let first = words.iter().position(is_number).ok_or("no number")?;
            let (unit, numbers) = words[first..].split_last().ok_or("no unit")?;
            if first > 0 {
                name = words[..first].join(" ");
            }
            for (axis, number) in (1..).zip(numbers) {
                let name = match numbers.len() {
                    1 => name.clone(),
                    _ => format!("axis {axis}"),
                };
                let number = number.parse()?;
                if !f64::is_finite(number) {
                    return Err("a setpoint that is not finite".into());
                }
                let same = |curve: &&mut Curve| {
                    curve.path == *path && curve.name == name && curve.unit == *unit
                };
                match self.curves.iter_mut().find(same) {
                    Some(curve) => curve.points.push((time, number)),
                    None => self.curves.push(Curve {
                        path: path.clone(),
                        name,
                        unit: (*unit).to_owned(),
                        points: vec![(time, number)],
                    }),
                }
            }
        }
        Ok(())
    }

    fn file_name(&self) -> String {
        let words = self.title.split(|c: char| !c.is_alphanumeric());
        let words: Vec<_> = words.filter(|word| !word.is_empty()).collect();
        words.join("-").to_lowercase() + ".svg"
    }

    fn panels(&self) -> Result<Vec<Panel>, Box<dyn Error>> {
        if self.curves[0].path.is_some() {
            return Ok(vec![self.plane()?]);
        }
        let mut units: Vec<&str> = Vec::new();
        for curve in &self.curves {
            if !units.contains(&&*curve.unit) {
                units.push(&curve.unit);
            }
        }
        let panels = units.into_iter().enumerate();
        panels
            .map(|(order, unit)| self.panel(order, unit))
            .collect()
    }

    /// The curves of one unit over time.
    fn panel(&self, order: usize, unit: &str) -> Result<Panel, Box<dyn Error>> {
        let quantity = QUANTITIES.get(order).ok_or("too many quantities")?;
        let mut colors = COLORS.into_iter();
        let mut curves = Vec::new();
        for curve in self.curves.iter().filter(|curve| curve.unit == unit) {
            let color = match curve.name.as_str() {
                "" => COLORS[order],
                name if name.starts_with("axis ") => colors.next().ok_or("too many axes")?,
                _ => FAINT,
            };
            curves.push((curve.name.clone(), color, curve.points.clone()));
        }
        let values = span(
            curves
                .iter()
                .flat_map(|curve| &curve.2)
                .map(|point| point.1),
        );
        let mut limits = Vec::new();
        for (limit, _) in self.limits.iter().filter(|limit| limit.1 == unit) {
            let size = limit.trim_start_matches(['+', '-']).parse::<f64>()?;
            // A limit is drawn on the side where the curve is.
            if values.end > 0.0 && !limit.starts_with('-') {
                limits.push(size);
            }
            if values.start < 0.0 && !limit.starts_with('+') {
                limits.push(-size);
            }
        }
        Ok(Panel {
            x: "time [s]",
            y: format!(
                "{quantity} [{}]",
                unit.replace("^2", "²").replace("^3", "³")
            ),
            is_plane: false,
            curves,
            limits,
        })
    }

    /// The paths, each with its own colour.
    fn plane(&self) -> Result<Panel, Box<dyn Error>> {
        let mut curves = Vec::new();
        for (path, color) in self.curves.chunks(2).zip(COLORS) {
            let [x, y] = path else {
                return Err("a path has two coordinates".into());
            };
            let points = x.points.iter().zip(&y.points).map(|(x, y)| (x.1, y.1));
            let name = x.path.clone().unwrap_or_default();
            curves.push((name, color, points.collect()));
        }
        Ok(Panel {
            x: "x [m]",
            y: "y [m]".to_owned(),
            is_plane: true,
            curves,
            limits: Vec::new(),
        })
    }

    fn draw(&self, path: &Path) -> Drawn {
        let panels = self.panels()?;
        let marks = if self.marks.is_empty() { 0 } else { MARKS };
        let panel_heights = panels.iter().map(Panel::height).sum::<u32>();
        let height = HEADING + marks + panel_heights + TIME_AXIS + LEGEND;
        let mut svg = String::new();
        let root = SVGBackend::with_string(&mut svg, (WIDTH, height)).into_drawing_area();
        root.fill(&WHITE)?;
        let (heading, mut below) = root.split_vertically(HEADING);
        self.draw_heading(&heading)?;
        for (place, panel) in (1..).zip(&panels) {
            let above = if place == 1 { marks } else { 0 };
            let under = if place == panels.len() { TIME_AXIS } else { 0 };
            let (area, rest) = below.split_vertically(above + panel.height() + under);
            panel.draw(&area, above, under, &self.marks)?;
            below = rest;
        }
        draw_legend(&below, &panels)?;
        root.present()?;
        drop((root, heading, below));
        let size = |units| format!("width=\"{}\" height=\"{}\"", WIDTH / units, height / units);
        fs::write(path, svg.replacen(&size(1), &size(UNITS), 1))?;
        Ok(())
    }

    fn draw_heading(&self, area: &Area) -> Drawn {
        let large = ("sans-serif", TITLE).into_text_style(area).color(&INK);
        let small = ("sans-serif", TEXT).into_text_style(area).color(&FAINT);
        area.draw_text(&self.title, &large, (LEFT as i32, HEADING as i32 / 5))?;
        area.draw_text(&self.details, &small, (LEFT as i32, HEADING as i32 * 3 / 5))?;
        Ok(())
    }
}

/// Names the curves, unless there is one alone, and the limits.
fn draw_legend(area: &Area, panels: &[Panel]) -> Drawn {
    let text = ("sans-serif", LABEL).into_text_style(area).color(&INK);
    let curves = panels[0].curves.iter();
    let mut entries: Vec<_> = curves
        .map(|(name, color, _)| (name.as_str(), *color))
        .collect();
    if panels.iter().any(|panel| !panel.limits.is_empty()) {
        entries.push(("limit", LIMIT));
    }
    entries.retain(|(name, _)| !name.is_empty());
    let step = (WIDTH - LEFT - RIGHT) / entries.len().max(5) as u32;
    for (place, (name, color)) in (0..).zip(entries) {
        let (x, y) = ((LEFT + place * step) as i32, LABEL as i32);
        let sample = [(x, y + y / 2), (x + TEXT as i32, y + y / 2)];
        area.draw(&PathElement::new(sample, color.stroke_width(CURVE)))?;
        area.draw_text(name, &text, (x + (TEXT + LABEL / 2) as i32, y))?;
    }
    Ok(())
}

/// Curves with common axes.
struct Panel {
    x: &'static str,
    y: String,
    is_plane: bool,
    curves: Vec<(String, RGBColor, Vec<Point>)>,
    limits: Vec<f64>,
}

impl Panel {
    /// The range of each axis.
    fn ranges(&self) -> [Range<f64>; 2] {
        let points = || self.curves.iter().flat_map(|curve| &curve.2);
        let x = span(points().map(|point| point.0));
        let values = points().map(|point| point.1);
        let y = with_margin(span(values.chain(self.limits.iter().copied())));
        [if self.is_plane { with_margin(x) } else { x }, y]
    }

    /// The plane has the same scale in both directions.
    fn height(&self) -> u32 {
        let [x, y] = self.ranges();
        let ratio = (y.end - y.start) / (x.end - x.start);
        let height = f64::from(WIDTH - LEFT - RIGHT) * ratio;
        2 * GAP + if self.is_plane { height as u32 } else { PANEL }
    }

    /// `above` is the room for the text of the marks, `under` for the text of the axis.
    fn draw(&self, area: &Area, above: u32, under: u32, marks: &[(f64, String)]) -> Drawn {
        let [x, y] = self.ranges();
        let mut chart = ChartBuilder::on(area)
            .margin_top(GAP + above)
            .margin_bottom(GAP)
            .margin_left(MARGIN)
            .margin_right(RIGHT)
            .set_label_area_size(LabelAreaPosition::Left, VALUE_AXIS)
            .set_label_area_size(LabelAreaPosition::Bottom, under)
            .build_cartesian_2d(x.clone(), y.clone())?;
        chart
            .configure_mesh()
            .disable_x_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(INK.mix(0.12).stroke_width(THIN))
            .axis_style(INK.mix(0.6).stroke_width(THIN))
            .label_style(("sans-serif", LABEL).into_font().color(&INK))
            .axis_desc_style(("sans-serif", TEXT).into_font().color(&INK))
            .set_all_tick_mark_size(GAP)
            .y_labels(5)
            .y_label_formatter(&|value| label(*value, &y))
            .x_desc(self.x)
            .y_desc(&self.y)
            .draw()?;
        let line = |points: Vec<Point>, style: ShapeStyle| PathElement::new(points, style);
        for &limit in &self.limits {
            let ends = vec![(x.start, limit), (x.end, limit)];
            chart.draw_series([line(ends, LIMIT.mix(0.7).stroke_width(THIN))])?;
        }
        let text = ("sans-serif", LABEL).into_text_style(area).color(&INK);
        for (time, what) in marks {
            let ends = vec![(*time, y.start), (*time, y.end)];
            chart.draw_series([line(ends, INK.mix(0.5).stroke_width(THIN))])?;
            if above > 0 {
                let text = text.pos(Pos::new(HPos::Center, VPos::Bottom));
                let place = EmptyElement::at((*time, y.end));
                chart
                    .plotting_area()
                    .draw(&(place + Text::new(what.clone(), (0, 0), text)))?;
            }
        }
        let scale = (
            f64::from(WIDTH - LEFT - RIGHT) / (x.end - x.start),
            f64::from(self.height() - 2 * GAP) / (y.end - y.start),
        );
        for (_, color, points) in self.curves.iter().rev() {
            chart.draw_series([line(thin(points, scale), color.stroke_width(CURVE))])?;
        }
        Ok(())
    }
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
        (x * dy - y * dx).abs() / dx.hypot(dy)
    };
    let far =
        (0..points.len()).max_by(|&i, &k| distance(&points[i]).total_cmp(&distance(&points[k])));
    match far {
        Some(far) if distance(&points[far]) > 1.0 => {
            let mut thinned = thin(&points[..=far], scale);
            thinned.pop();
            thinned.extend(thin(&points[far..], scale));
            thinned
        }
        _ => vec![*first, *last],
    }
}

/// The text beside a tick. A tick at zero may be off by a rounding or carry a sign; its text is "0.0".
fn label(value: f64, axis: &Range<f64>) -> String {
    let negligible = value.abs() < 1e-6 * (axis.end - axis.start);
    let printer = FloatPrettyPrinter {
        allow_scientific: false,
        min_decimal: 1,
        max_decimal: 5,
    };
    printer.print(if negligible { 0.0 } else { value })
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
