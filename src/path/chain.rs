//! The sections of a path, one after the other: what is given, and the plan as it stands.

use super::memory::Memory;
use super::slack::{Bounds, Side};
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::online::problem::Problem;
use crate::real::Real;
use crate::state::State;

/// The sum of durations, s.
pub(super) fn total<R: Real>(durations: &[R]) -> R {
    durations.iter().fold(R::ZERO, |sum, t| sum + *t)
}

/// How much later than planned a section may end in a path of this duration, s: more than what rounding does in most.
pub(super) fn most_late<R: Real>(duration: R) -> R {
    R::EPSILON.sqrt() * duration
}

/// What is asked for: points with their states, and limits.
#[derive(Clone, Copy)]
pub(super) struct Request<'a, R> {
    pub axes: usize,
    pub sections: usize,
    /// The states of all axes, point by point. Between start and end the positions alone count.
    pub states: &'a [State<R>],
    /// The limits of all axes, or of all axes section by section.
    pub limits: &'a [Limits<R>],
    /// The first section of each part that has limits of its own, and the number of sections. None: each section is such a part.
    pub parts: &'a [usize],
    /// How far the position of each axis may be from the given one, for each point between start and end. None: all points are exact.
    pub tolerances: &'a [R],
    /// Whether the first section is what is left of a followed plan. It lasts, even if rounding hides its displacement.
    pub is_begun: bool,
}

impl<'a, R: Real> Request<'a, R> {
    /// Whether the sections have limits of their own.
    pub fn has_zones(&self) -> bool {
        self.limits.len() > self.axes
    }

    pub fn limits(&self, section: usize, axis: usize) -> Limits<R> {
        self.zone(section).get(axis).copied().unwrap_or(Limits::endless())
    }

    /// The limits of all axes in a section.
    pub fn zone(&self, section: usize) -> &'a [Limits<R>] {
        let first = if self.has_zones() { self.part(section) * self.axes } else { 0 };
        self.limits.get(first..first + self.axes).unwrap_or_default()
    }

    /// Which part of the path with limits of its own a section belongs to.
    fn part(&self, section: usize) -> usize {
        let begun = self.parts.partition_point(|&first| first <= section);
        begun.checked_sub(1).unwrap_or(section)
    }

    /// The states of all axes at the start and at the end of a section.
    pub fn ends(&self, section: usize) -> [&'a [State<R>]; 2] {
        let states = [section, section + 1].map(|point| self.states.get(point * self.axes..(point + 1) * self.axes));
        states.map(Option::unwrap_or_default)
    }

    #[inline(never)] // for its size: it is asked in several places
    pub fn state(&self, point: usize, axis: usize) -> State<R> {
        let state = self.states.get(point * self.axes + axis);
        state.copied().unwrap_or_default()
    }

    /// Refuses what cannot be planned.
    pub fn check(&self) -> Result<(), Error> {
        let mut limits = self.limits.iter();
        limits.try_for_each(Limits::are_limits)?;
        for axis in 0..self.axes {
            let end = self.state(self.sections, axis);
            self.limits(self.sections - 1, axis).check(self.state(0, axis), end)?;
        }
        let mut ways = self.states.iter().zip(self.states.iter().skip(self.axes));
        let is_finite = ways.all(|(from, to)| (to.position - from.position).is_finite());
        Error::NotFinite.unless(is_finite)
    }

    fn moves(&self, section: usize) -> bool {
        let way = |axis| self.state(section + 1, axis).position - self.state(section, axis).position;
        (0..self.axes).any(|axis| way(axis) != R::ZERO)
    }

    /// Whether the limits of a section admit the states of all axes at a point.
    fn admits(&self, point: usize, section: usize) -> bool {
        (0..self.axes).all(|axis| {
            let state = self.state(point, axis);
            self.limits(section, axis).check(state, state).is_ok()
        })
    }

    /// Whether all axes can stay in their states at a point while a section lasts.
    fn can_stay(&self, point: usize, section: usize) -> bool {
        let mut limits = self.zone(section).iter().enumerate();
        let is_left = limits.any(|(axis, limits)| limits.are_left_after(self.state(point, axis)));
        !is_left && self.admits(point, section)
    }

    /// Whether the path can end with the last section in which an axis moves.
    fn can_end_early(&self) -> bool {
        let (last, end) = (self.sections - 1, self.sections);
        let moving = (0..last).rfind(|&section| self.moves(section)).unwrap_or(0);
        self.admits(end, moving) && (moving + 1..end).all(|section| self.can_stay(end, section))
    }

    /// The sections that last: each section in which an axis moves, one in which the start returns within its limits, and the last one if the
    /// end is not possible before. If none does, the last one.
    fn each_lasting(&self, mut act: impl FnMut(usize)) {
        let mut has_begun = false;
        let last = self.sections - 1;
        let ends = !self.can_end_early();
        for section in 0..self.sections {
            let begins = !has_begun && (section == last || !self.can_stay(0, section));
            if begins || self.moves(section) || section == 0 && self.is_begun || section == last && ends {
                has_begun = true;
                act(section);
            }
        }
    }
}

/// A plan of the sections that last. An axis has `K` unknowns at a point: the third one is its position.
pub(super) struct Chain<'a, 'w, R, const K: usize = 2> {
    pub request: Request<'a, R>,
    pub axes: usize,
    pub sections: usize,
    pub memory: Memory<'w, R, K>,
    /// Whether an axis starts outside its limits, or will unavoidably exceed them at the end.
    pub findings: Findings,
    /// The section that was assembled last. If it was not feasible, half of the step often leaves it infeasible too.
    pub last_assembled: usize,
}

impl<'a, 'w, R: Real, const K: usize> Chain<'a, 'w, R, K> {
    /// The sections that last, with no plan yet.
    pub fn of(request: Request<'a, R>, work: &'w mut [R]) -> Result<Self, Error> {
        let axes = request.axes;
        let mut sections = 0;
        request.each_lasting(|_| sections += 1);
        let mut memory = Memory::of(work, axes, sections).ok_or(Error::Axes)?;
        let mut section = 0;
        request.each_lasting(|place| {
            memory.places.put(section, R::from_index(place as i32));
            section += 1;
        });
        let mut chain = Self { request, axes, sections, memory, findings: Findings::default(), last_assembled: 0 };
        chain.memory.plan.states.clear();
        chain.memory.plan.offsets.clear();
        for axis in 0..axes {
            for section in 0..sections {
                let (from, to) = chain.positions(section, axis);
                let piece = section * axes + axis;
                chain.memory.displacements.put(piece, to - from);
            }
            for point in 1..sections {
                chain.set_bounds(point, axis);
                chain.set_tolerance(point, axis);
            }
            chain.start(axis);
        }
        Ok(chain)
    }

    /// Makes an axis return within its limits in the first section, and sets the states of both ends.
    fn start(&mut self, axis: usize) {
        let target = State::at(self.positions(0, axis).1);
        let start = self.request.state(0, axis);
        let problem = Problem::new(&self.limits(0, axis), &start, &target);
        self.memory.plan.states.set(axis, [problem.border.v0, problem.border.a0]);
        self.memory.recovery_time.put(axis, problem.with_recovery(R::ZERO));
        self.memory.displacements.put(axis, problem.displacement().h);
        self.findings |= problem.outside();
        let end = self.request.state(self.request.sections, axis);
        let last = self.request.limits(self.request.sections - 1, axis);
        self.findings |= Findings::ENDS_LEAVING.when(last.are_left_after(end));
        self.set_end(self.sections, axis, R::ONE);
    }

    /// Gives an axis this part of its given velocity at the start or at the end of the path, and the square of it of its acceleration.
    pub fn set_end(&mut self, point: usize, axis: usize, part: R) {
        let given = if point == 0 { 0 } else { self.request.sections };
        let State { velocity, acceleration, .. } = self.request.state(given, axis);
        self.memory.plan.states.set(point * self.axes + axis, [part * velocity, part * part * acceleration]);
    }

    /// Which section of the caller this one is.
    pub fn place(&self, section: usize) -> usize {
        self.memory.places.at(section).to_index() as usize
    }

    pub fn limits(&self, section: usize, axis: usize) -> Limits<R> {
        let place = if self.request.has_zones() { self.place(section) } else { 0 };
        self.request.limits(place, axis)
    }

    /// The limits of a waypoint: the limits of both sections, and of sections between them that do not last.
    pub fn bounds(&self, point: usize, axis: usize) -> Bounds<R> {
        Bounds(self.memory.bounds.row((point - 1) * self.axes + axis))
    }

    fn set_bounds(&mut self, point: usize, axis: usize) {
        let places = self.place(point - 1)..self.place(point) + 1;
        let Bounds(row) = Bounds::of(places.map(|place| self.request.limits(place, axis)));
        self.memory.bounds.set((point - 1) * self.axes + axis, row);
    }

    /// Points that repeat are one point, with the least of their tolerances.
    fn set_tolerance(&mut self, point: usize, axis: usize) {
        let places = self.place(point - 1)..self.place(point);
        let tolerances = self.request.tolerances;
        let tolerances = places.filter_map(|place| tolerances.get(place * self.axes + axis));
        let least = tolerances.fold(R::INFINITY, |least, &tolerance| least.at_most(tolerance));
        self.memory.tolerances.put((point - 1) * self.axes + axis, least);
    }

    fn positions(&self, section: usize, axis: usize) -> (R, R) {
        let from = self.place(section);
        let position = |point| self.request.state(point, axis).position;
        (position(from), position(from + 1))
    }

    /// Velocity and acceleration at a point.
    pub fn at(&self, point: usize, axis: usize) -> [R; 2] {
        self.memory.plan.states.row(point * self.axes + axis)
    }

    pub fn rests_at(&self, point: usize) -> bool {
        (0..self.axes).all(|axis| self.at(point, axis) == [R::ZERO; 2])
    }

    /// The states of an axis at both ends of a section. A start outside the limits is the given one.
    pub fn ends(&self, section: usize, axis: usize) -> (State<R>, State<R>) {
        let (from, to) = self.positions(section, axis);
        let state = |point, position| {
            let [velocity, acceleration] = self.at(point, axis);
            State { position: self.memory.moved(position, point * self.axes + axis, self.axes), velocity, acceleration }
        };
        let start = if section == 0 && self.memory.recovery_time.at(axis) > R::ZERO {
            State { position: from, ..self.request.state(0, axis) }
        } else {
            state(section, from)
        };
        (start, state(section + 1, to))
    }

    /// How much of a section that lasts `duration` is left after the recovery of an axis, s.
    pub fn after_recovery(&self, section: usize, axis: usize, duration: R) -> R {
        if section == 0 { duration - self.memory.recovery_time.at(axis) } else { duration }
    }

    /// How long a section is.
    pub fn displacement(&self, section: usize, axis: usize) -> R {
        let end = section * self.axes + axis;
        let given = self.memory.displacements.at(end);
        if K == 2 {
            return given;
        }
        let offset = |row: usize| self.memory.tolerances.at(row) * self.memory.plan.offsets.at(row);
        given + (offset(end) - end.checked_sub(self.axes).map_or(R::ZERO, offset))
    }

    pub fn upper(&self, limits: &Limits<R>, (section, axis): (usize, usize), duration: R) -> Side<R> {
        let ends = [self.at(section, axis), self.at(section + 1, axis)];
        let t = self.after_recovery(section, axis, duration);
        let h = self.displacement(section, axis);
        Side::upper(limits, ends, t, h)
    }

    /// Whether every axis can take `duration` for a section, with slack to both sides.
    pub fn is_possible(&self, section: usize, duration: R) -> bool {
        (0..self.axes).all(|axis| self.upper(&self.limits(section, axis), (section, axis), duration).has_slack())
    }

    /// Whether a section can last as long as it does, with slack to both sides, and its end is strictly within the limits of its waypoint.
    pub fn is_section_feasible(&self, section: usize) -> bool {
        let point = section + 1;
        self.is_possible(section, self.memory.plan.durations.at(section))
            && (point == self.sections
                || (0..self.axes).all(|axis| self.bounds(point, axis).product(self.at(point, axis)).is_some()))
    }

    pub fn is_strictly_feasible(&self) -> bool {
        (0..self.sections).all(|section| self.is_section_feasible(section))
    }

    #[inline(never)] // for its size: it is asked in several places
    pub fn duration(&self) -> R {
        total(self.memory.plan.durations.numbers())
    }

    /// The plan alone, if its numbers are within the range of the real type.
    pub fn done(mut self) -> Result<Planned<'w, R, K>, Error> {
        // Sections before the first one that lasts keep the given start, not the state after a recovery.
        (0..self.axes).for_each(|axis| self.set_end(0, axis, R::ONE));
        let Self { axes, sections, memory, findings, .. } = self;
        Error::NotFinite.unless(memory.plan.durations.numbers().iter().all(|t| t.is_finite()))?;
        Ok(Planned { axes, sections, memory, findings })
    }
}

pub(super) struct Planned<'w, R, const K: usize> {
    axes: usize,
    sections: usize,
    memory: Memory<'w, R, K>,
    findings: Findings,
}

impl<R: Real, const K: usize> Planned<'_, R, K> {
    /// Writes the states of the waypoints and the durations of all sections. A section that does not last keeps the state.
    pub fn write(self, states: &mut [State<R>], durations: &mut [R]) -> Findings {
        let Self { axes, sections, memory, findings } = self;
        let mut point = 0;
        for (place, duration) in durations.iter_mut().enumerate() {
            let lasts = point < sections && memory.places.at(point).to_index() as usize == place;
            *duration = if lasts { memory.plan.durations.at(point) } else { R::ZERO };
            point += usize::from(lasts);
            let end = states.iter_mut().skip((place + 1) * axes).take(axes);
            for (axis, state) in end.enumerate() {
                let row = point * axes + axis;
                state.position = memory.moved(state.position, row, axes);
                [state.velocity, state.acceleration] = memory.plan.states.row(row);
            }
        }
        findings
    }
}
