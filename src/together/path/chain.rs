//! The sections of a path, one behind the other: what is given, and the plan as it stands.

use super::border::{Border, Ends};
use super::bounds::Bounds;
use super::memory::Memory;
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::online::problem::Problem;
use crate::real::Real;
use crate::state::State;

/// What is asked for: points with their states, and limits.
#[derive(Clone, Copy)]
pub(super) struct Request<'a, R> {
    pub axes: usize,
    pub sections: usize,
    /// The states of all axes, point by point. Between start and end the positions alone count.
    pub states: &'a [State<R>],
    /// The limits of all axes, or of all axes section by section.
    pub limits: &'a [Limits<R>],
}

impl<'a, R: Real> Request<'a, R> {
    /// Whether the sections have limits of their own.
    fn has_zones(&self) -> bool {
        self.limits.len() > self.axes
    }

    pub fn limits(&self, section: usize, axis: usize) -> Result<&'a Limits<R>, Error> {
        let first = if self.has_zones() {
            section * self.axes
        } else {
            0
        };
        self.limits.get(first + axis).ok_or(Error::Axes)
    }

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
            // The end lasts while nothing moves any more.
            let mut section = self.sections - 1;
            self.limits(section, axis)?
                .check(self.state(0, axis), end)?;
            while section > 0 && !self.moves(section) {
                // An axis that is bound to leave its limits cannot stay.
                if self.limits(section, axis)?.are_left_after(end) {
                    return Err(Error::Target);
                }
                section -= 1;
                self.limits(section, axis)?.check(end, end)?;
            }
        }
        let mut ways = self.states.iter().zip(self.states.iter().skip(self.axes));
        let is_finite = ways.all(|(from, to)| (to.position - from.position).is_finite());
        is_finite.then_some(()).ok_or(Error::NotFinite)
    }

    /// Whether an axis moves in this section.
    fn moves(&self, section: usize) -> bool {
        let way =
            |axis| self.state(section + 1, axis).position - self.state(section, axis).position;
        (0..self.axes).any(|axis| way(axis) != R::ZERO)
    }

    /// Whether all axes can stay in the state of the start.
    fn can_stay(&self, section: usize) -> bool {
        let mut axes = 0..self.axes;
        axes.all(|axis| {
            let start = self.state(0, axis);
            let limits = self.limits(section, axis);
            limits.is_ok_and(|limits| {
                limits.check(start, start).is_ok() && !limits.are_left_after(start)
            })
        })
    }

    /// Which sections last: each section in which an axis moves, and one in which the start comes inside its limits. If none does, the last one.
    fn lasting(&self) -> impl Iterator<Item = usize> + '_ {
        let mut has_begun = false;
        let last = self.sections - 1;
        (0..self.sections).filter(move |&section| {
            let begins = !has_begun && (section == last || !self.can_stay(section));
            let lasts = begins || self.moves(section);
            has_begun = has_begun || lasts;
            lasts
        })
    }
}

/// A plan of the sections that last.
pub(super) struct Chain<'a, 'w, R> {
    pub request: Request<'a, R>,
    pub axes: usize,
    /// How many sections last.
    pub sections: usize,
    pub memory: Memory<'w, R>,
    /// Whether an axis starts outside its limits, or is bound to leave them at the end.
    pub findings: Findings,
}

impl<'a, 'w, R: Real> Chain<'a, 'w, R> {
    /// The sections that last, with no plan yet.
    pub fn of(request: Request<'a, R>, work: &'w mut [R]) -> Result<Self, Error> {
        let axes = request.axes;
        let sections = request.lasting().count();
        let mut memory = Memory::of(work, axes, sections).ok_or(Error::Axes)?;
        for (section, place) in request.lasting().enumerate() {
            memory.places.put(section, R::from_index(place as i32));
        }
        let mut chain = Self {
            request,
            axes,
            sections,
            memory,
            findings: Findings::default(),
        };
        chain.memory.states.clear();
        for axis in 0..axes {
            for section in 0..sections {
                let (from, to) = chain.positions(section, axis);
                let piece = section * axes + axis;
                chain.memory.displacements.put(piece, to - from);
            }
            for point in 1..sections {
                chain.set_bounds(point, axis);
            }
            chain.start(axis)?;
        }
        Ok(chain)
    }

    /// Lets an axis come inside its limits in the first section, and sets the states of both ends.
    fn start(&mut self, axis: usize) -> Result<(), Error> {
        let target = State::at(self.positions(0, axis).1);
        let start = self.request.state(0, axis);
        let inside = Problem::new(self.limits(0, axis)?, start, target);
        let (v0, a0) = (inside.border.v0, inside.border.a0);
        self.memory.states.set(axis, [v0, a0]);
        self.memory.inside.put(axis, inside.with_inside(R::ZERO));
        self.memory.displacements.put(axis, inside.displacement().0);
        self.findings |= inside.outside();
        let end = self.request.state(self.request.sections, axis);
        let last = self.request.limits(self.request.sections - 1, axis)?;
        self.findings |= Findings::ENDS_LEAVING.when(last.are_left_after(end));
        let State {
            velocity,
            acceleration,
            ..
        } = end;
        let end = self.sections * self.axes + axis;
        self.memory.states.set(end, [velocity, acceleration]);
        Ok(())
    }

    /// Which section of the caller this one is.
    pub fn place(&self, section: usize) -> usize {
        self.memory.places.at(section).to_index() as usize
    }

    pub fn limits(&self, section: usize, axis: usize) -> Result<&'a Limits<R>, Error> {
        let place = if self.request.has_zones() {
            self.place(section)
        } else {
            0
        };
        self.request.limits(place, axis)
    }

    /// The limits of a way point: the limits of both sections, and of sections between them that do not last.
    pub fn bounds(&self, point: usize, axis: usize) -> Bounds<R> {
        Bounds(self.memory.bounds.row((point - 1) * self.axes + axis))
    }

    fn set_bounds(&mut self, point: usize, axis: usize) {
        let places = self.place(point - 1)..=self.place(point);
        let limits = places.flat_map(|place| self.request.limits(place, axis));
        let Bounds(row) = Bounds::of(limits);
        self.memory.bounds.set((point - 1) * self.axes + axis, row);
    }

    fn positions(&self, section: usize, axis: usize) -> (R, R) {
        let from = self.place(section);
        let position = |point| self.request.state(point, axis).position;
        (position(from), position(from + 1))
    }

    /// Velocity and acceleration at a point.
    pub fn at(&self, point: usize, axis: usize) -> [R; 2] {
        self.memory.states.row(point * self.axes + axis)
    }

    /// The states of an axis at both ends of a section, at the start as given.
    pub fn ends(&self, section: usize, axis: usize) -> (State<R>, State<R>) {
        let (from, to) = self.positions(section, axis);
        let state = |point, position| {
            let [velocity, acceleration] = self.at(point, axis);
            State {
                position,
                velocity,
                acceleration,
            }
        };
        let start = if section == 0 {
            let given = self.request.state(0, axis);
            State {
                position: from,
                ..given
            }
        } else {
            state(section, from)
        };
        (start, state(section + 1, to))
    }

    /// How long an axis moves inside its limits, if the section lasts `duration`, s.
    pub fn inside(&self, section: usize, axis: usize, duration: R) -> R {
        if section == 0 {
            duration - self.memory.inside.at(axis)
        } else {
            duration
        }
    }

    pub fn displacement(&self, section: usize, axis: usize) -> R {
        self.memory.displacements.at(section * self.axes + axis)
    }

    /// How much farther than the section an axis gets to both sides, if the section can last `duration` between these states.
    pub fn slacks(
        &self,
        section: usize,
        axis: usize,
        ends: [[R; 2]; 2],
        duration: R,
    ) -> Option<[R; 2]> {
        let limits = self.limits(section, axis).ok()?;
        let [upper, lower] = self.borders(limits, (section, axis), ends, duration);
        Some([upper.farthest()?.slack, lower.farthest()?.slack])
    }

    /// Both borders of a section between these states.
    pub fn borders(
        &self,
        limits: &Limits<R>,
        (section, axis): (usize, usize),
        [[v0, a0], [v1, a1]]: [[R; 2]; 2],
        duration: R,
    ) -> [Border<R>; 2] {
        let t = self.inside(section, axis, duration);
        let h = self.displacement(section, axis);
        Border::both(limits, Ends { v0, a0, v1, a1 }, t, h)
    }

    /// Whether every axis can take `duration` for a section, with slack to both sides.
    pub fn is_possible(&self, section: usize, duration: R) -> bool {
        let mut axes = 0..self.axes;
        axes.all(|axis| {
            let ends = [self.at(section, axis), self.at(section + 1, axis)];
            self.slacks(section, axis, ends, duration).is_some()
        })
    }

    /// The sum of all durations, s.
    pub fn duration(&self) -> R {
        let durations = self.memory.durations.rows(self.sections);
        durations.fold(R::ZERO, |sum, [t]| sum + t)
    }
}

/// A plan that is done.
pub(super) struct Planned<'w, R> {
    axes: usize,
    sections: usize,
    memory: Memory<'w, R>,
    findings: Findings,
}

impl<'w, R: Real> Chain<'_, 'w, R> {
    /// The plan alone, if its numbers are within the range of the real type.
    pub fn done(self) -> Result<Planned<'w, R>, Error> {
        let Self {
            axes,
            sections,
            memory,
            findings,
            ..
        } = self;
        let is_finite = memory.durations.numbers().iter().all(|t| t.is_finite());
        let planned = Planned {
            axes,
            sections,
            memory,
            findings,
        };
        is_finite.then_some(planned).ok_or(Error::NotFinite)
    }
}

impl<R: Real> Planned<'_, R> {
    /// Writes the states of the way points and the durations of all sections. A section that does not last keeps the state.
    pub fn write(self, states: &mut [State<R>], durations: &mut [R]) -> Findings {
        let Self {
            axes,
            sections,
            memory,
            findings,
        } = self;
        let mut point = 0;
        for (place, duration) in durations.iter_mut().enumerate() {
            let lasts = point < sections && memory.places.at(point).to_index() as usize == place;
            *duration = if lasts {
                memory.durations.at(point)
            } else {
                R::ZERO
            };
            point += usize::from(lasts);
            let end = states.iter_mut().skip((place + 1) * axes).take(axes);
            for (axis, state) in end.enumerate() {
                [state.velocity, state.acceleration] = memory.states.row(point * axes + axis);
            }
        }
        findings
    }
}
