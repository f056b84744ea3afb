//! Why there is no motion: which number is wrong. The core returns the kind of the error, and the arguments show the number.

use atraj::online::{Limits, Move};
use atraj::{Boundary, Error, State};
use pyo3::prelude::*;

use crate::motion::Number;
use crate::values::error;

/// A number of the caller, its name, and what it must be if it is not.
struct Claim {
    name: String,
    value: f64,
    holds: bool,
    must: String,
}

fn claim<R: Number>(name: impl Into<String>, value: R, holds: bool, must: impl Into<String>) -> Claim {
    Claim { name: name.into(), value: value.into(), holds, must: must.into() }
}

/// A `ValueError` about the first claim that does not hold, else with the sentence of the core. `axis` stands before this sentence.
fn first_broken(why: Error, axis: &str, claims: impl IntoIterator<Item = Claim>) -> PyErr {
    match claims.into_iter().find(|claim| !claim.holds) {
        Some(Claim { name, value, must, .. }) => error(&format!("{name} = {value} {must}")),
        None => error(&format!("{axis}{why}")),
    }
}

pub const NUMBER: &str = "is infinite or not a number";
const ABOVE: &str = "has the wrong sign: it must be above 0";
const BELOW: &str = "has the wrong sign: it must be below 0";

fn is_number<R: Number>(x: R) -> bool {
    x.partial_cmp(&x).is_some()
}

/// A limit that is not around 0.
fn limit<R: Number>(name: String, value: R, is_highest: bool) -> Claim {
    let must = match (is_number(value), value == R::ZERO, is_highest) {
        (false, ..) => "is not a number",
        (_, true, _) => "is 0: a limit must leave room to move",
        (_, _, true) => ABOVE,
        _ => BELOW,
    };
    let holds = if is_highest { value > R::ZERO } else { value < R::ZERO };
    claim(name, value, holds, must)
}

fn limits_claims<R: Number>(name: &str, limits: &Limits<R>) -> Vec<Claim> {
    let Limits { vmax, vmin, amax, amin, jmax, jmin } = *limits;
    let are_finite = (jmax < R::INFINITY || -jmin < R::INFINITY) || (amax < R::INFINITY && -amin < R::INFINITY);
    vec![
        limit(format!("{name}.vmax"), vmax, true),
        limit(format!("{name}.vmin"), vmin, false),
        limit(format!("{name}.amax"), amax, true),
        limit(format!("{name}.amin"), amin, false),
        limit(format!("{name}.jmax"), jmax, true),
        limit(format!("{name}.jmin"), jmin, false),
        claim(
            format!("{name}.jmax"),
            jmax,
            are_finite,
            "and an acceleration are infinite: a jerk, or both accelerations, are finite",
        ),
    ]
}

fn state_claims<R: Number>(name: &str, state: &State<R>) -> Vec<Claim> {
    [("position", state.position), ("velocity", state.velocity), ("acceleration", state.acceleration)]
        .map(|(quantity, x)| claim(format!("{name}.{quantity}"), x, x.is_finite(), NUMBER))
        .into()
}

fn target_claims<R: Number>(name: &str, limits: &Limits<R>, end: &State<R>) -> Vec<Claim> {
    let (v, a) = (end.velocity, end.acceleration);
    let (velocity, acceleration) = (format!("{name}.velocity"), format!("{name}.acceleration"));
    vec![
        claim(velocity.clone(), v, v <= limits.vmax, "is outside the limits: it is above vmax"),
        claim(velocity, v, v >= limits.vmin, "is outside the limits: it is below vmin"),
        claim(acceleration.clone(), a, a <= limits.amax, "is outside the limits: it is above amax"),
        claim(acceleration.clone(), a, a >= limits.amin, "is outside the limits: it is below amin"),
        claim(acceleration, a, false, "cannot be reached: the velocity must have left its limits before"),
    ]
}

/// Other numbers of a call. They are finite, but a lowest and a highest position may be infinite.
type Others<'a, R> = &'a [(&'a str, R)];

/// The lowest and the highest position, if they are the other numbers.
fn positions<R: Number>(others: Others<R>) -> Option<[R; 2]> {
    match *others {
        [("lowest", lowest), ("highest", highest)] => Some([lowest, highest]),
        _ => None,
    }
}

/// Each state is between the positions.
fn position_claims<R: Number>(axis: &str, states: &[(&str, State<R>)], [lowest, highest]: [R; 2]) -> Vec<Claim> {
    let [low, high]: [f64; 2] = [lowest.into(), highest.into()];
    let between = |(name, state): &(&str, State<R>)| {
        let x = state.position;
        claim(
            format!("{axis}{name}.position"),
            x,
            lowest <= x && x <= highest,
            format!("leaves the positions from lowest = {low} to highest = {high}"),
        )
    };
    states.iter().map(between).collect()
}

/// Why one axis is not planned: `axis` stands before the names, "axis 1: " for example.
pub fn no_move<R: Number>(
    why: Error, axis: &str, limits: &Limits<R>, states: &[(&str, State<R>)], others: Others<R>,
) -> PyErr {
    let mut claims = Vec::new();
    match why {
        Error::NotFinite => {
            let are_numbers =
                limits_claims(&format!("{axis}limits"), limits).into_iter().filter(|claim| claim.value.is_nan());
            claims.extend(are_numbers);
            for (name, state) in states {
                claims.extend(state_claims(&format!("{axis}{name}"), state));
            }
            let may_be_infinite = positions(others).is_some();
            let other = |&(name, x): &(&str, R)| {
                let holds = x.is_finite() || (may_be_infinite && is_number(x));
                claim(format!("{axis}{name}"), x, holds, NUMBER)
            };
            claims.extend(others.iter().map(other));
        }
        Error::Limits => {
            claims.extend(limits_claims(&format!("{axis}limits"), limits));
            if let Some([lowest, highest]) = positions(others) {
                let high: f64 = highest.into();
                let must = format!("is not below highest = {high}");
                claims.push(claim(format!("{axis}lowest"), lowest, lowest < highest, must));
            }
        }
        Error::Position => {
            if let Some(positions) = positions(others) {
                claims.extend(position_claims(axis, states, positions));
            }
        }
        Error::Target => {
            if let Some((name, end)) = states.last() {
                claims.extend(target_claims(&format!("{axis}{name}"), limits, end));
            }
        }
        Error::Duration => {
            let other = |&(name, x): &(&str, R)| {
                let must = if name == "horizon" { "is not a time above 0" } else { "is not a time from 0 on" };
                let is_time = x > R::ZERO || (x == R::ZERO && name != "horizon");
                claim(name, x, is_time && x.is_finite(), must)
            };
            claims.extend(others.iter().map(other));
        }
        _ => {}
    }
    first_broken(why, axis, claims)
}

/// What one of several axes is asked for: its limits, its start and its end, and its lowest and its highest position.
pub type Axis<R> = (Limits<R>, [State<R>; 2], [R; 2]);

/// Says why the first of these axes that cannot be planned alone cannot be.
pub fn each_alone<R: Number>(axes: impl IntoIterator<Item = Axis<R>>) -> PyResult<()> {
    for (axis, (limits, [start, end], [lowest, highest])) in axes.into_iter().enumerate() {
        let alone = Move::default().within(&limits, start, end, lowest, highest);
        alone.map_err(|why| {
            let states = [("start", start), ("end", end)];
            let positions = [("lowest", lowest), ("highest", highest)];
            no_move(why, &format!("axis {axis}: "), &limits, &states, &positions)
        })?;
    }
    Ok(())
}

/// Why there is no double-S or trapezoid within these limits. Their signs are ignored.
pub fn no_profile<R: Number>(
    why: Error, limits: [(&str, R); 3], boundary: Boundary<R>, accelerations: Option<[R; 2]>,
) -> PyErr {
    let Boundary { p0, p1, v0, v1 } = boundary;
    if let Some([ac, de]) = accelerations {
        let are_numbers = is_number(ac) && is_number(de) && ac != R::ZERO && de != R::ZERO;
        let [rise, fall] = [ac, de].map(|x| x > R::ZERO);
        let [ac, de]: [f64; 2] = [ac.into(), de.into()];
        if are_numbers && rise == fall {
            return error(&format!(
                "ac = {ac} and de = {de} have the same sign: a forward move has ac > 0 and de < 0, a backward one ac < 0 and de > 0"
            ));
        }
        if why == Error::Unreachable && are_numbers && p0 != p1 && rise != (p1 > p0) {
            let [p0, p1]: [f64; 2] = [p0.into(), p1.into()];
            return error(&format!(
                "liba finds no such move within the limits: from p0 = {p0} to p1 = {p1}, ac = {ac} and de = {de} have the wrong signs"
            ));
        }
    }
    let mut claims = Vec::new();
    for (name, x) in limits {
        claims.push(claim(name, x, is_number(x), "is not a number"));
        let leaves_room = x != R::ZERO;
        claims.push(claim(name, x, leaves_room, "is 0: a limit must leave room to move"));
    }
    for (name, x) in [("p0", p0), ("p1", p1), ("v0", v0), ("v1", v1)] {
        let is_velocity = name.starts_with('v');
        let holds = x.is_finite() || (is_velocity && is_number(x));
        claims.push(claim(name, x, holds, NUMBER));
    }
    if why == Error::Limits {
        let must = match accelerations {
            Some(_) => "is infinite: the velocity would jump",
            None => "and acceleration are infinite: a jerk, or both accelerations, are finite",
        };
        for (name, x) in limits.into_iter().filter(|limit| limit.0 != "velocity") {
            claims.push(claim(name, x, x.is_finite(), must));
        }
    }
    if why == Error::Unreachable {
        let must = "is also p0: liba finds no such move within the limits, for it takes no time";
        claims.push(claim("p1", p1, p0 != p1, must));
    }
    first_broken(why, "", claims)
}

/// Why there is no polynomial through these numbers in the time `t`.
pub fn no_polynomial<R: Number>(why: Error, t: R, ends: &[(&str, R)]) -> PyErr {
    let number = |&(name, x): &(&str, R)| claim(name, x, x.is_finite(), NUMBER);
    let time = [claim("t", t, t.is_finite(), NUMBER), claim("t", t, t != R::ZERO, "takes no time")];
    first_broken(why, "", time.into_iter().chain(ends.iter().map(number)))
}

/// Why a number is no step, frequency, damping or time: the first of them that is not within its bounds.
pub fn no_part<R: Number>(why: Error, numbers: &[(&str, R, bool, &'static str)]) -> PyErr {
    let number = |&(name, x, holds, must): &(&str, R, bool, _)| claim(name, x, holds, must);
    first_broken(why, "", numbers.iter().map(number))
}
