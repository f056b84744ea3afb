//! Draws motion profiles. `plot DIRECTORY` reads moves from standard input, in the form of `servo.c`'s output, and writes one
//! SVG for each move. The SVG shows position, velocity, acceleration and, if given, jerk over time.
//!
//! ```text
//! move TITLE                 a new picture; the text after ": " in the title becomes its second line
//! phase FROM TO NAME         shaded by name, between border lines
//! at x pos vel acc [jer]     a setpoint at time x
//! beside NAME                the setpoints from here on are another motion, drawn in grey; they may have fewer quantities
//! path TITLE                 a new picture of curves in the plane; its setpoints are `at x y`
//! curve NAME                 the setpoints from here on are an axis of several or a path, drawn in its own colour
//! ```
//!
//! Other lines are ignored.

use plotters::coord::Shift;
use plotters::data::float::FloatPrettyPrinter;
use plotters::prelude::*;
use std::collections::HashSet;
use std::error::Error;
use std::ops::Range;
use std::path::Path;
use std::{env, fs, io};

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), Box<dyn Error>>;

const QUANTITIES: [(&str, &str, RGBColor); 4] = [
    ("position", "m", RGBColor(31, 90, 166)),
    ("velocity", "m/s", RGBColor(24, 128, 78)),
    ("acceleration", "m/s²", RGBColor(204, 85, 0)),
    ("jerk", "m/s³", RGBColor(140, 40, 130)),
];
const CURVES: [RGBColor; 6] = [
    RGBColor(31, 90, 166),
    RGBColor(204, 85, 0),
    RGBColor(24, 128, 78),
    RGBColor(140, 40, 130),
    RGBColor(170, 130, 0),
    RGBColor(90, 100, 110),
];
const SHADES: [(&str, RGBColor); 3] = [
    ("accelerate", RGBColor(222, 240, 226)),
    ("cruise", RGBColor(230, 234, 244)),
    ("decelerate", RGBColor(252, 230, 222)),
];
const OTHER_SHADE: RGBColor = RGBColor(250, 244, 214);
const INK: RGBColor = RGBColor(40, 44, 52);
const FAINT: RGBColor = RGBColor(120, 126, 136);

// The backend rounds coordinates to whole units. Four units per pixel keep curves smooth.
const UNITS: u32 = 4;
const WIDTH: u32 = 900 * UNITS;
const HEADING: u32 = 75 * UNITS;
const PANEL: u32 = 180 * UNITS;
const LEGEND: u32 = 45 * UNITS;
const TIME_AXIS: u32 = 45 * UNITS;
const MARGIN: u32 = 20 * UNITS;
const VALUE_AXIS: u32 = 75 * UNITS;
const LEFT: u32 = MARGIN + VALUE_AXIS;
const RIGHT: u32 = 25 * UNITS;
const GAP: u32 = 7 * UNITS;
const BORDER: u32 = UNITS;
const CURVE: u32 = 5 * UNITS / 2;
const TITLE: u32 = 23 * UNITS;
const TEXT: u32 = 16 * UNITS;
const LABEL: u32 = 14 * UNITS;

fn main() -> Drawn {
    let directory = env::args_os().nth(1).ok_or("usage: plot DIRECTORY")?;
    let moves = read_moves(&io::read_to_string(io::stdin())?)?;
    if moves.is_empty() {
        return Err("no moves on standard input".into());
    }
    fs::create_dir_all(&directory)?;
    let mut drawn = HashSet::new();
    for motion in &moves {
        let path = Path::new(&directory).join(motion.file_name());
        if !drawn.insert(path.clone()) {
            return Err(format!("two moves are called {:?}", motion.heading().0).into());
        }
        motion
            .draw(&path)
            .map_err(|e| format!("{}: {e}", path.display()))?;
        println!("{}", path.display());
    }
    Ok(())
}

#[derive(Default)]
struct Move {
    title: String,
    phases: Vec<(Range<f64>, String)>,
    /// Time, then the quantities.
    points: Vec<Vec<f64>>,
    beside: Option<Curve>,
    /// In place of `points`.
    curves: Vec<Curve>,
    /// The setpoints are points of the plane.
    is_path: bool,
}

/// Setpoints with a name: of an axis, of a path, or of another motion beside the move.
struct Curve {
    name: String,
    points: Vec<Vec<f64>>,
}

fn read_moves(text: &str) -> Result<Vec<Move>, Box<dyn Error>> {
    let mut moves: Vec<Move> = Vec::new();
    for line in text.lines() {
        let (word, rest) = line.split_once(' ').unwrap_or((line, ""));
        if word == "move" || word == "path" {
            moves.push(Move {
                title: rest.to_owned(),
                is_path: word == "path",
                ..Move::default()
            });
            continue;
        }
        let motion = moves.last_mut().ok_or("the first line is no `move`")?;
        match word {
            "phase" => motion
                .phases
                .push(read_phase(rest).ok_or_else(|| line.to_owned())?),
            "beside" => {
                motion.beside = Some(Curve::named(rest));
            }
            "curve" => motion.curves.push(Curve::named(rest)),
            "at" => {
                let points = match (&mut motion.beside, motion.curves.last_mut()) {
                    (Some(named), _) | (None, Some(named)) => &mut named.points,
                    (None, None) => &mut motion.points,
                };
                points.push(rest.split(' ').map(str::parse).collect::<Result<_, _>>()?);
            }
            _ => {}
        }
    }
    Ok(moves)
}

fn read_phase(text: &str) -> Option<(Range<f64>, String)> {
    let mut words = text.splitn(3, ' ');
    let from = words.next()?.parse().ok()?;
    let to = words.next()?.parse().ok()?;
    Some((from..to, words.next()?.to_owned()))
}

impl Curve {
    fn named(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            points: Vec::new(),
        }
    }
}

impl Move {
    fn heading(&self) -> (&str, &str) {
        self.title.split_once(": ").unwrap_or((&self.title, ""))
    }

    fn file_name(&self) -> String {
        let words: Vec<_> = self
            .heading()
            .0
            .split(|c: char| !c.is_alphanumeric())
            .filter(|word| !word.is_empty())
            .map(str::to_lowercase)
            .collect();
        words.join("-") + ".svg"
    }

    /// The setpoints of the motion beside the move.
    fn beside(&self) -> &[Vec<f64>] {
        self.beside.as_ref().map_or(&[], |beside| &beside.points)
    }

    /// A number of each setpoint that has so many: its time, or a quantity.
    fn all(&self, number: usize) -> impl Iterator<Item = f64> {
        let curves = self.curves.iter().flat_map(|curve| &curve.points);
        let points = self.points.iter().chain(self.beside()).chain(curves);
        points.filter_map(move |point| point.get(number).copied())
    }

    /// How many of [`QUANTITIES`] every setpoint of the move has.
    fn quantities(&self) -> Result<usize, Box<dyn Error>> {
        let quantities = match self.curves.first() {
            Some(curve) => quantities(&curve.points)?,
            None => quantities(&self.points)?,
        };
        for curve in &self.curves {
            if self::quantities(&curve.points)? != quantities || !self.points.is_empty() {
                return Err("setpoints of different length, or of no curve".into());
            }
        }
        if self.curves.len() > CURVES.len() || self.is_path && quantities != 1 {
            return Err("too many curves or coordinates".into());
        }
        if self.beside.is_some() && self::quantities(self.beside())? > quantities {
            return Err("more quantities beside the move than in the move".into());
        }
        Ok(quantities)
    }

    fn draw(&self, path: &Path) -> Drawn {
        let quantities = self.quantities()?;
        let panel = self.panel();
        let height = HEADING + panel * quantities as u32 + TIME_AXIS + LEGEND;
        let mut svg = String::new();
        self.draw_panels(
            &SVGBackend::with_string(&mut svg, (WIDTH, height)).into_drawing_area(),
            quantities,
            panel,
        )?;
        let size =
            |units: u32| format!("width=\"{}\" height=\"{}\"", WIDTH / units, height / units);
        fs::write(path, svg.replacen(&size(1), &size(UNITS), 1))?;
        Ok(())
    }

    /// How high a panel is. A path has the same scale in both directions.
    fn panel(&self) -> u32 {
        if !self.is_path {
            return PANEL;
        }
        let width = |span: Range<f64>| span.end - span.start;
        let ratio = width(with_margin(span(self.all(1)))) / width(with_margin(span(self.all(0))));
        let height = f64::from(WIDTH - LEFT - RIGHT) * ratio;
        (height as u32).clamp(PANEL, 4 * PANEL) + 2 * GAP
    }

    fn draw_panels(&self, root: &Area, quantities: usize, panel: u32) -> Drawn {
        root.fill(&WHITE)?;
        let (heading, rest) = root.split_vertically(HEADING);
        let (panels, legend) = rest.split_vertically(panel * quantities as u32 + TIME_AXIS);
        self.draw_heading(&heading)?;
        let mut below = panels;
        for quantity in 0..quantities {
            let last = quantity + 1 == quantities;
            let (area, rest) = below.split_vertically(panel + if last { TIME_AXIS } else { 0 });
            self.draw_panel(&area, quantity, last)?;
            below = rest;
        }
        self.draw_legend(&legend, quantities)?;
        root.present()?;
        Ok(())
    }

    fn draw_heading(&self, area: &Area) -> Drawn {
        let (title, details) = self.heading();
        let large = ("sans-serif", TITLE).into_text_style(area).color(&INK);
        let small = ("sans-serif", TEXT).into_text_style(area).color(&FAINT);
        area.draw_text(title, &large, (LEFT as i32, HEADING as i32 / 5))?;
        area.draw_text(details, &small, (LEFT as i32, HEADING as i32 * 3 / 5))?;
        Ok(())
    }

    fn draw_panel(&self, area: &Area, quantity: usize, time_axis: bool) -> Drawn {
        let (name, unit, color) = QUANTITIES[quantity];
        let times = span(self.all(0));
        let (times, x_label, y_label) = if self.is_path {
            (with_margin(times), "x [m]", "y [m]".to_owned())
        } else {
            (times, "time [s]", format!("{name} [{unit}]"))
        };
        let values = with_margin(span(self.all(quantity + 1)));
        let curve = |points: &[Vec<f64>], color: RGBColor| {
            let line: Vec<_> = points
                .iter()
                .filter_map(|p| Some((p[0], *p.get(quantity + 1)?)))
                .collect();
            PathElement::new(line, color.stroke_width(CURVE))
        };
        let mut chart = ChartBuilder::on(area)
            .margin_top(GAP)
            .margin_bottom(GAP)
            .margin_left(MARGIN)
            .margin_right(RIGHT)
            .set_label_area_size(LabelAreaPosition::Left, VALUE_AXIS)
            .set_label_area_size(
                LabelAreaPosition::Bottom,
                if time_axis { TIME_AXIS } else { 0 },
            )
            .build_cartesian_2d(times, values.clone())?;

        let phases = self.painted_phases();
        for (phase, name) in &phases {
            let corners = [(phase.start, values.start), (phase.end, values.end)];
            chart.draw_series([Rectangle::new(corners, shade(name).filled())])?;
        }
        chart
            .configure_mesh()
            .disable_x_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(INK.mix(0.12).stroke_width(BORDER))
            .axis_style(INK.mix(0.6).stroke_width(BORDER))
            .label_style(("sans-serif", LABEL).into_font().color(&INK))
            .axis_desc_style(("sans-serif", TEXT).into_font().color(&INK))
            .set_all_tick_mark_size(GAP)
            .y_labels(5)
            .y_label_formatter(&|value| label(*value, &values))
            .x_desc(x_label)
            .y_desc(y_label)
            .draw()?;
        for (phase, _) in &phases {
            let border = vec![(phase.end, values.start), (phase.end, values.end)];
            chart.draw_series([PathElement::new(border, INK.mix(0.35).stroke_width(BORDER))])?;
        }
        if let Some(beside) = &self.beside {
            chart.draw_series([curve(&beside.points, FAINT)])?;
        }
        for (named, color) in self.curves.iter().zip(CURVES) {
            chart.draw_series([curve(&named.points, color)])?;
        }
        chart.draw_series([curve(&self.points, color)])?;
        Ok(())
    }

    fn draw_legend(&self, area: &Area, quantities: usize) -> Drawn {
        let text = ("sans-serif", LABEL).into_text_style(area).color(&INK);
        let phases = self.painted_phases();
        let names = names(&phases);
        let quantities = QUANTITIES[..if self.curves.is_empty() {
            quantities
        } else {
            0
        }]
            .iter()
            .map(|&(name, _, color)| (name, color));
        let named = self.curves.iter().zip(CURVES);
        let curves = quantities.chain(named.map(|(curve, color)| (curve.name.as_str(), color)));
        let beside = self.beside.as_ref();
        let curves: Vec<_> = curves
            .chain(beside.map(|beside| (beside.name.as_str(), FAINT)))
            .collect();
        let step = (WIDTH - LEFT - RIGHT) as usize / (curves.len() + names.len());
        let swatch = |place: usize| {
            let x = (LEFT as usize + place * step) as i32;
            [(x, LABEL as i32), (x + TEXT as i32, 2 * LABEL as i32)]
        };
        let label = |swatch: [(i32, i32); 2], name: &str| {
            let [_, (right, bottom)] = swatch;
            area.draw_text(
                name,
                &text,
                (right + (LABEL / 2) as i32, bottom - LABEL as i32),
            )
        };
        for (place, (name, color)) in curves.iter().enumerate() {
            let [(left, top), (right, bottom)] = swatch(place);
            let middle = (top + bottom) / 2;
            let sample = [(left, middle), (right, middle)];
            area.draw(&PathElement::new(sample, color.stroke_width(CURVE)))?;
            label(swatch(place), name)?;
        }
        for (place, name) in (curves.len()..).zip(names) {
            let border = INK.mix(0.35).stroke_width(BORDER);
            area.draw(&Rectangle::new(swatch(place), shade(name).filled()))?;
            area.draw(&Rectangle::new(swatch(place), border))?;
            label(swatch(place), name)?;
        }
        Ok(())
    }

    /// The phases to paint. A plan calls its first phase "accelerate", also if the axis brakes there before it turns round.
    /// A picture cuts such a phase where the axis turns round, and names each piece for what the axis does.
    fn painted_phases(&self) -> Vec<(Range<f64>, &str)> {
        let mut painted = Vec::new();
        for (phase, name) in &self.phases {
            if !["accelerate", "decelerate"].contains(&name.as_str()) {
                painted.push((phase.clone(), name.as_str()));
                continue;
            }
            let mut start = phase.start;
            for end in self.reversal(phase).into_iter().chain([phase.end]) {
                let gained = self.speed(end) - self.speed(start);
                let name = if gained > 0.0 {
                    "accelerate"
                } else if gained < 0.0 {
                    "decelerate"
                } else {
                    name
                };
                painted.push((start..end, name));
                start = end;
            }
        }
        painted
    }

    /// When the axis turns round in `phase`.
    fn reversal(&self, phase: &Range<f64>) -> Option<f64> {
        let within =
            |point: &&Vec<f64>| (phase.start..=phase.end).contains(&point[0]) && point.len() > 2;
        let points: Vec<_> = self.points.iter().filter(within).collect();
        let turn = points.windows(2).find(|pair| pair[0][2] * pair[1][2] < 0.0);
        let rest = points
            .windows(3)
            .find(|three| three[1][2] == 0.0 && three[0][2] * three[2][2] < 0.0);
        turn.map(|pair| pair[1][0])
            .or(rest.map(|three| three[1][0]))
    }

    /// The speed at the setpoint that is nearest to `time`.
    fn speed(&self, time: f64) -> f64 {
        let distance = |point: &Vec<f64>| (point[0] - time).abs();
        let nearest = self
            .points
            .iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest
            .and_then(|point| point.get(2))
            .map_or(0.0, |v| v.abs())
    }
}

/// How many of [`QUANTITIES`] each of these setpoints has.
fn quantities(points: &[Vec<f64>]) -> Result<usize, Box<dyn Error>> {
    let quantities = points.first().map_or(0, |point| point.len() - 1);
    if !(1..=QUANTITIES.len()).contains(&quantities) {
        return Err("no setpoints to draw".into());
    }
    if points.iter().any(|p| p.len() != 1 + quantities) {
        return Err("setpoints of different length".into());
    }
    if points.iter().flatten().any(|value| !value.is_finite()) {
        return Err("a setpoint that is not finite".into());
    }
    Ok(quantities)
}

/// Each name once, in the order of the phases.
fn names<'a>(phases: &[(Range<f64>, &'a str)]) -> Vec<&'a str> {
    let mut names = Vec::new();
    for (_, name) in phases {
        if !names.contains(name) {
            names.push(name);
        }
    }
    names
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

fn shade(phase: &str) -> RGBColor {
    SHADES
        .iter()
        .find(|(name, _)| *name == phase)
        .map_or(OTHER_SHADE, |&(_, color)| color)
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
