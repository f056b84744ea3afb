//! Paths that stay near their lines, with the points that are added.

use super::{Chain, Path};
use support::prelude::*;

pub struct Planned<R: Real> {
    pub answer: Result<Findings, Error>,
    pub chain: Chain<R>, // through its points
    pub path: Path<R>,
    pub moves: Vec<Move<R>>,
    pub places: Vec<usize>, // where the given points are
}

/// The contour through the points of `chain`, in room for so many sections.
pub fn contour<R: Real>(chain: &Chain<R>, tolerance: f64, room: usize, steps: u32) -> Planned<R> {
    let (axes, mut states) = (chain.axes, chain.states.clone());
    states.resize(axes * (room + 1), State::at(R::NAN));
    let (mut moves, mut durations) = (vec![Move::default(); axes * room], vec![R::NAN; room]);
    let mut places = vec![0; chain.sections() + 1];
    let mut work = vec![R::NAN; path_size(axes, room).expect("a size")];
    let path = Contour { moves: &mut moves, states: &mut states, durations: &mut durations, places: &mut places };
    let answer = plan_contour(path, &chain.limits, R::of(tolerance), axes, steps, &mut work);
    let sections = places[chain.sections()];
    moves.truncate(axes * sections);
    states.truncate(axes * (sections + 1));
    durations.truncate(sections);
    let parts = places.windows(2).enumerate().flat_map(|(part, ends)| vec![part; ends[1] - ends[0]]);
    let limits = parts.flat_map(|part| chain.limits(part).to_vec()).collect();
    let given = states.iter().enumerate().map(|(k, &state)| {
        let is_end = k < axes || k >= axes * sections;
        if is_end { state } else { State::at(state.position) }
    });
    let chain = Chain { family: chain.family, axes, limits, states: given.collect() };
    Planned { answer, chain, path: Path { states, durations }, moves, places }
}
