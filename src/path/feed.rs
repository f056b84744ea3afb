//! The feed of a path: a highest speed of all axes together.

use super::chain::Request;
use crate::findings::Error;
use crate::limits::Limits;
use crate::real::Real;
use crate::state::State;

/// Lowers the limits of the velocities such that the axes together are nowhere faster than the feed: the norm of their velocities.
///
/// `limits` has an entry for each of the `axes` section by section, as [`plan_path`](super::plan_path) takes them, `states` has the points of the
/// path, and `feeds` a feed for each section, unit/s; an infinite one sets no limit.
///
/// Each axis of a section gets the part `w` of its feed, with `w² = 15/16 d² + 1/(16 axes)` for the direction `d` of its line. The squares add
/// up to 1, so the feed is kept at all times, however a path moves between its points. On a line it moves at 96.8 % of the feed or more. Where
/// an axis moves across the line of a section, as at a corner, it has little of the feed.
///
/// It returns the errors of [`plan_path`](super::plan_path), [`Error::Limits`] also if a feed is not above 0, [`Error::NotFinite`] if it is not a
/// number. Then no limit changes.
///
/// ```
/// use atraj::State;
/// use atraj::axes::{limit_feed, path_size, plan_path};
/// use atraj::online::Limits;
/// let mut limits = [Limits::symmetric(30.0, 10.0, 5.0); 4];
/// let mut states = [0.0, 0.0, 3.0, 4.0, 6.0, 8.0].map(State::at);
/// limit_feed(&mut limits, &states, &[2.0, 1.0], 2)?;
/// let (mut durations, mut work) = ([0.0; 2], vec![0.0; path_size(2, 2).expect("two axes")]);
/// plan_path(&mut states, &mut durations, &limits, 2, 0, &mut work)?;
/// // 5 at a speed of 2, and 5 at a speed of 1.
/// assert!(durations[0] > 2.5 && durations[1] > 5.0);
/// # Ok::<(), atraj::Error>(())
/// ```
pub fn limit_feed<R: Real>(
    limits: &mut [Limits<R>], states: &[State<R>], feeds: &[R], axes: usize,
) -> Result<(), Error> {
    for &feed in feeds {
        feed.partial_cmp(&feed).ok_or(Error::NotFinite)?;
        Error::Limits.unless(feed > R::ZERO)?;
    }
    Request::of(states, feeds, limits, axes)?;
    Error::Axes.unless(limits.len() == axes * feeds.len())?;
    for (section, &feed) in feeds.iter().enumerate() {
        let of = section * axes..(section + 1) * axes;
        let line = states.get(of.start..).unwrap_or_default();
        lower(limits.get_mut(of).unwrap_or_default(), line, line.get(axes..).unwrap_or_default(), feed);
    }
    Ok(())
}

fn lower<R: Real>(zone: &mut [Limits<R>], from: &[State<R>], to: &[State<R>], feed: R) {
    let count = zone.len();
    let line = || from.iter().zip(to).take(count).map(|(from, to)| (to.position - from.position).abs());
    let longest = line().fold(R::ZERO, R::at_least);
    // In parts of the longest one no square leaves the range.
    let parts = || line().map(|distance| if longest > R::ZERO { distance / longest } else { R::ONE });
    let square = parts().fold(R::ZERO, |sum, part| sum + part * part);
    let across = R::SIXTEENTH / R::from_index(count as i32);
    for (limits, part) in zone.iter_mut().zip(parts()) {
        let speed = feed * (part * part / square * (R::ONE - R::SIXTEENTH) + across).sqrt();
        limits.vmax = limits.vmax.at_most(speed);
        limits.vmin = limits.vmin.at_least(-speed);
    }
}
