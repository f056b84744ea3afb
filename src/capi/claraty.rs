//! `claraty/trapezoid.h`: CLARAty's trapezoid as a handle.

use crate::claraty::{EPS, Kind, Mode, Route, Target, Trajectory, Warnings, Waypoints};
use crate::state::State;
use core::ffi::{c_int, c_void};
use core::slice;

/// Monotonic seconds from any fixed origin. It must not use the handle that it is the clock of.
pub type claraty_clock = Option<unsafe extern "C" fn(user: *mut c_void) -> f64>;

/// Which motion a handle plans.
#[repr(C)]
pub enum claraty_mode {
    /// from any position and velocity to rest at the target, without a jump and without a needless overshoot
    CLARATY_CORRECTED = 0,
    /// what CLARAty's published listing computes, bit for bit
    CLARATY_LISTING = 1,
}

/// Shape of the velocity over time.
#[repr(C)]
pub enum claraty_type {
    /// no phase at the maximum velocity
    CLARATY_TRIANGULAR = 0,
    /// cruises at the maximum velocity
    CLARATY_TRAPEZOIDAL = 1,
}

/// Bits of what a plan had to put up with.
#[repr(C)]
pub enum claraty_warning {
    /// the acceleration was below 1e-10 and was raised to it
    CLARATY_WARN_ACCEL = 1,
    /// the deceleration was
    CLARATY_WARN_DECEL = 2,
    /// the maximum velocity was
    CLARATY_WARN_VELOCITY = 4,
    /// listing mode only: no instant to switch from acceleration to deceleration, the motion is wrong
    CLARATY_WARN_SWITCH = 8,
}

/// What a function returns that can fail.
#[repr(C)]
pub enum claraty_result {
    /// done
    CLARATY_OK = 0,
    /// the handle or an array is NULL
    CLARATY_ERR_NULL = -1,
    /// an argument or the clock is infinite or not a number
    CLARATY_ERR_NOT_FINITE = -2,
    /// not one of `claraty_mode`
    CLARATY_ERR_MODE = -3,
    /// no waypoints, or more than an array can hold
    CLARATY_ERR_WAYPOINTS = -4,
}
use claraty_result::*;

const _: () = assert!(
    claraty_mode::CLARATY_LISTING as isize == Mode::Listing as isize
        && claraty_type::CLARATY_TRAPEZOIDAL as isize == Kind::Trapezoidal as isize
        && claraty_warning::CLARATY_WARN_ACCEL as u8 == Warnings::ACCELERATION.bits()
        && claraty_warning::CLARATY_WARN_DECEL as u8 == Warnings::DECELERATION.bits()
        && claraty_warning::CLARATY_WARN_VELOCITY as u8 == Warnings::VELOCITY.bits()
        && claraty_warning::CLARATY_WARN_SWITCH as u8 == Warnings::SWITCH.bits()
        && EPS == 1e-10
);

/// A planned motion: acceleration up to `t1`, cruise up to `t2`, deceleration up to `tf`. Times in seconds from its start.
#[repr(C)]
pub struct claraty_profile {
    /// end of the acceleration, s
    pub t1: f64,
    /// start of the deceleration, s
    pub t2: f64,
    /// end of the motion, s
    pub tf: f64,
    /// position at `t1`
    pub p_at_t1: f64,
    /// position at `t2`
    pub p_at_t2: f64,
    /// position at `tf` and later
    pub final_position: f64,
    /// velocity between `t1` and `t2`, signed
    pub velocity: f64,
    /// acceleration before `t1`, signed
    pub accel: f64,
    /// acceleration after `t2`, signed
    pub decel: f64,
    /// `CLARATY_TRIANGULAR` or `CLARATY_TRAPEZOIDAL`
    pub r#type: c_int,
}

/// One axis. The caller owns it: on the stack, static or on the heap; there is nothing to release. Without waypoints it
/// may be copied at any time, and the copy runs on its own; with waypoints the copy reads the same arrays.
#[repr(C)]
pub struct claraty_trapezoid {
    /// not for the caller
    pub opaque: [u64; 34],
}

/// What the caller's storage holds.
struct Handle {
    trajectory: Trajectory<'static>,
    clock: claraty_clock,
    user: *mut c_void,
}

const _: () = assert!(
    size_of::<Handle>() <= size_of::<claraty_trapezoid>()
        && align_of::<Handle>() <= align_of::<claraty_trapezoid>()
);

impl Handle {
    /// # Safety
    /// `h` is NULL or points to an initialised handle that nobody else uses as long as the result lives.
    unsafe fn of<'a>(h: *mut claraty_trapezoid) -> Result<&'a mut Self, claraty_result> {
        // SAFETY: an initialised handle holds a `Handle`, which has room in it.
        unsafe { h.cast::<Self>().as_mut() }.ok_or(CLARATY_ERR_NULL)
    }

    /// # Safety
    /// As for [`Handle::of`], but others may read.
    unsafe fn of_const<'a>(h: *const claraty_trapezoid) -> Option<&'a Self> {
        // SAFETY: as in `of`.
        unsafe { h.cast::<Self>().as_ref() }
    }

    /// What the clock shows; a handle without one has a clock that stands still.
    fn now(&self) -> f64 {
        match self.clock {
            // SAFETY: the caller gave the clock to be called with what came with it.
            Some(clock) => unsafe { clock(self.user) },
            None => 0.0,
        }
    }

    fn finite_now(&self) -> Result<f64, claraty_result> {
        let now = self.now();
        finite(self.trajectory.elapsed(now)).map(|_| now)
    }

    fn set(&mut self, route: Route<'static>) -> Result<(), claraty_result> {
        let now = self.finite_now()?;
        self.trajectory.set(route, now);
        Ok(())
    }

    fn setpoint(&mut self) -> Result<State<f64>, claraty_result> {
        let now = self.finite_now()?;
        Ok(self.trajectory.setpoint(now))
    }

    /// The listing may plan a motion that ends at no number; what it makes of such a time is part of its behaviour.
    fn setpoint_at(&mut self, time: f64) -> Result<State<f64>, claraty_result> {
        if self.trajectory.mode() == Mode::Corrected {
            finite(time)?;
        }
        Ok(self.trajectory.setpoint_at(time))
    }
}

fn finite(x: f64) -> Result<f64, claraty_result> {
    x.is_finite().then_some(x).ok_or(CLARATY_ERR_NOT_FINITE)
}

fn all_finite(values: &[f64]) -> Result<(), claraty_result> {
    values.iter().try_for_each(|&x| finite(x).map(drop))
}

fn code(result: Result<(), claraty_result>) -> c_int {
    match result {
        Ok(()) => CLARATY_OK as c_int,
        Err(error) => error as c_int,
    }
}

fn warnings_or_code(result: Result<Warnings, claraty_result>) -> c_int {
    match result {
        Ok(warnings) => warnings.bits().into(),
        Err(error) => error as c_int,
    }
}

/// Makes a handle out of storage, which need not be initialised: at rest at 0, timer at 0, `CLARATY_CORRECTED`, on the
/// monotonic clock of the system; where there is none, on the manual one.
/// @param h the handle
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_init(h: *mut claraty_trapezoid) {
    if h.is_null() {
        return;
    }
    let mut handle = Handle {
        trajectory: Trajectory::default(),
        clock: SYSTEM_CLOCK,
        user: core::ptr::null_mut(),
    };
    handle.trajectory.reset(handle.now());
    // SAFETY: `h` points to storage for a handle by the contract of this module.
    unsafe { h.cast::<Handle>().write(handle) };
}

/// Chooses what the following starts and stops plan.
/// @param h the handle
/// @param mode one of `claraty_mode`
/// @return `CLARATY_OK`, `CLARATY_ERR_NULL` or `CLARATY_ERR_MODE`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_set_mode(
    h: *mut claraty_trapezoid,
    mode: c_int,
) -> c_int {
    // SAFETY: by the contract of this module.
    code(unsafe { Handle::of(h) }.and_then(|handle| {
        handle.trajectory.set_mode(match mode {
            0 => Mode::Corrected,
            1 => Mode::Listing,
            _ => return Err(CLARATY_ERR_MODE),
        });
        Ok(())
    }))
}

/// Goes over to another clock; a motion under way goes on from where it is. With a NULL `clock` the clock is manual: it
/// stands still, and only `claraty_trapezoid_advance_timer_by` moves it.
/// @param h the handle
/// @param clock monotonic seconds; NULL for the manual clock, which stands still
/// @param user is given to `clock` with every call
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_set_clock(
    h: *mut claraty_trapezoid,
    clock: claraty_clock,
    user: *mut c_void,
) {
    // SAFETY: by the contract of this module.
    if let Ok(handle) = unsafe { Handle::of(h) } {
        let before = handle.now();
        (handle.clock, handle.user) = (clock, user);
        handle.trajectory.change_clock(before, handle.now());
    }
}

/// Stores where to go next; it moves nothing before `claraty_trapezoid_start`. Waypoints of an earlier set are let go: a
/// motion along them ends at rest at the one it is heading for.
/// @param h the handle
/// @param final_position relative to the start of the trajectory, unit
/// @param max_velocity magnitude, unit/s
/// @param accel magnitude of the change from the present velocity to `max_velocity`, unit/s^2
/// @param decel magnitude of the final stop, unit/s^2
/// @return `CLARATY_OK`, `CLARATY_ERR_NULL` or `CLARATY_ERR_NOT_FINITE`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_set(
    h: *mut claraty_trapezoid,
    final_position: f64,
    max_velocity: f64,
    accel: f64,
    decel: f64,
) -> c_int {
    // SAFETY: by the contract of this module.
    code(unsafe { Handle::of(h) }.and_then(|handle| {
        all_finite(&[final_position, max_velocity, accel, decel])?;
        let target = Target {
            position: final_position,
            velocity: max_velocity,
            acceleration: accel,
            deceleration: decel,
        };
        handle.set(target.into())
    }))
}

/// Stores a way along `n` positions with rest at each; for the rest as `claraty_trapezoid_set`. In both modes the legs
/// are corrected motions; the first sets off from the present one. The arrays must stay as they are until the next set.
/// @param h the handle
/// @param n number of waypoints
/// @param positions relative to the start of the trajectory, unit
/// @param velocities maximum velocity of the leg to each position, unit/s
/// @param accels acceleration and deceleration of the leg to each position, unit/s^2
/// @return `CLARATY_OK`, `CLARATY_ERR_NULL`, `CLARATY_ERR_NOT_FINITE` or `CLARATY_ERR_WAYPOINTS`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_set_waypoints(
    h: *mut claraty_trapezoid,
    positions: *const f64,
    velocities: *const f64,
    accels: *const f64,
    n: usize,
) -> c_int {
    // SAFETY: by the contract of this module.
    code(unsafe { Handle::of(h) }.and_then(|handle| {
        // SAFETY: each is NULL or holds `n` numbers that stay until the next set.
        let [positions, velocities, accels] = unsafe {
            [
                finite_array(positions, n)?,
                finite_array(velocities, n)?,
                finite_array(accels, n)?,
            ]
        };
        let waypoints =
            Waypoints::new(positions, velocities, accels).ok_or(CLARATY_ERR_WAYPOINTS)?;
        handle.set(waypoints.into())
    }))
}

/// `claraty_trapezoid_set_waypoints` with one velocity and one acceleration for all legs.
/// @param h the handle
/// @param positions one for each waypoint, relative to the start of the trajectory, unit
/// @param n number of waypoints
/// @param max_velocity for every waypoint, unit/s
/// @param accel for every waypoint, unit/s^2
/// @return `CLARATY_OK`, `CLARATY_ERR_NULL`, `CLARATY_ERR_NOT_FINITE` or `CLARATY_ERR_WAYPOINTS`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_set_uniform_waypoints(
    h: *mut claraty_trapezoid,
    positions: *const f64,
    n: usize,
    max_velocity: f64,
    accel: f64,
) -> c_int {
    // SAFETY: by the contract of this module.
    code(unsafe { Handle::of(h) }.and_then(|handle| {
        // SAFETY: NULL or `n` numbers that stay until the next set.
        let positions = unsafe { finite_array(positions, n)? };
        all_finite(&[max_velocity, accel])?;
        let waypoints =
            Waypoints::uniform(positions, max_velocity, accel).ok_or(CLARATY_ERR_WAYPOINTS)?;
        handle.set(waypoints.into())
    }))
}

/// # Safety
/// `values` is NULL or points to `n` numbers that nobody changes until the next set.
unsafe fn finite_array(values: *const f64, n: usize) -> Result<&'static [f64], claraty_result> {
    if n == 0 || n > isize::MAX as usize / size_of::<f64>() {
        return Err(CLARATY_ERR_WAYPOINTS);
    }
    if values.is_null() {
        return Err(CLARATY_ERR_NULL);
    }
    // SAFETY: not NULL, and the size does not overflow; the rest is the caller's word.
    let values = unsafe { slice::from_raw_parts(values, n) };
    all_finite(values)?;
    Ok(values)
}

/// Sets off, timer at 0: from the present motion, or from rest at 0 if there is none.
/// @param h the handle
/// @return the sum of `claraty_warning` bits, or `CLARATY_ERR_NULL` or `CLARATY_ERR_NOT_FINITE`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_start(h: *mut claraty_trapezoid) -> c_int {
    // SAFETY: by the contract of this module.
    warnings_or_code(unsafe { Handle::of(h) }.and_then(|handle| {
        let now = handle.finite_now()?;
        Ok(handle.trajectory.start(now))
    }))
}

/// Brakes the present motion to rest; sets the timer to 0 also if there is none.
/// @param h the handle
/// @return the sum of `claraty_warning` bits, or `CLARATY_ERR_NULL` or `CLARATY_ERR_NOT_FINITE`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_stop(h: *mut claraty_trapezoid) -> c_int {
    // SAFETY: by the contract of this module.
    warnings_or_code(unsafe { Handle::of(h) }.and_then(|handle| {
        let now = handle.finite_now()?;
        Ok(handle.trajectory.stop(now))
    }))
}

/// Forgets the present motion and sets the timer to 0. The axis is not braked; the last profile can still be read.
/// @param h the handle
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_reset(h: *mut claraty_trapezoid) {
    // SAFETY: by the contract of this module.
    if let Ok(handle) = unsafe { Handle::of(h) } {
        handle.trajectory.reset(handle.now());
    }
}

/// Whether a motion is under way: from the start until the setpoint has been read after the end.
/// @param h the handle
/// @return 1, 0 or `CLARATY_ERR_NULL`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_is_started(h: *const claraty_trapezoid) -> c_int {
    // SAFETY: by the contract of this module.
    match unsafe { Handle::of_const(h) } {
        Some(handle) => handle.trajectory.is_started().into(),
        None => CLARATY_ERR_NULL as c_int,
    }
}

/// Adds to what the clock gives, whichever clock it is. A number that is not finite adds nothing.
/// @param h the handle
/// @param seconds to add, s; may be negative
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_advance_timer_by(
    h: *mut claraty_trapezoid,
    seconds: f64,
) {
    // SAFETY: by the contract of this module.
    if let (Ok(handle), Ok(seconds)) = (unsafe { Handle::of(h) }, finite(seconds)) {
        handle.trajectory.advance_timer_by(seconds);
    }
}

/// @param h the handle
/// @return time since the last start, stop or reset, s; NaN if `h` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_elapsed(h: *const claraty_trapezoid) -> f64 {
    // SAFETY: by the contract of this module.
    unsafe { Handle::of_const(h) }
        .map_or(f64::NAN, |handle| handle.trajectory.elapsed(handle.now()))
}

/// @param h the handle
/// @return time from the start to rest, all legs together, s; 0 before the first start; NaN if `h` is NULL
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_duration(h: *const claraty_trapezoid) -> f64 {
    // SAFETY: by the contract of this module.
    unsafe { Handle::of_const(h) }.map_or(f64::NAN, |handle| handle.trajectory.duration())
}

/// What the axis shall do now. Reading it after the end of the motion ends the motion.
/// @param h the handle
/// @param position NULL, or where to write the position, unit
/// @param velocity NULL, or where to write the velocity, unit/s
/// @param accel NULL, or where to write the acceleration, unit/s^2
/// @return `CLARATY_OK`, `CLARATY_ERR_NULL` or `CLARATY_ERR_NOT_FINITE`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_setpoint(
    h: *mut claraty_trapezoid,
    position: *mut f64,
    velocity: *mut f64,
    accel: *mut f64,
) -> c_int {
    // SAFETY: by the contract of this module.
    let setpoint = unsafe { Handle::of(h) }.and_then(Handle::setpoint);
    // SAFETY: each pointer is NULL or valid to write.
    code(setpoint.map(|setpoint| unsafe { write_setpoint(setpoint, position, velocity, accel) }))
}

/// The same at a time after the start, before or after now. In listing mode a look beyond the end ends the motion, and
/// before the start all is 0, as in the listing; a time that is not finite is looked up there too.
/// @param h the handle
/// @param time since the start, s
/// @param position NULL, or where to write the position, unit
/// @param velocity NULL, or where to write the velocity, unit/s
/// @param accel NULL, or where to write the acceleration, unit/s^2
/// @return `CLARATY_OK`, `CLARATY_ERR_NULL` or `CLARATY_ERR_NOT_FINITE`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_setpoint_at(
    h: *mut claraty_trapezoid,
    time: f64,
    position: *mut f64,
    velocity: *mut f64,
    accel: *mut f64,
) -> c_int {
    // SAFETY: by the contract of this module.
    let setpoint = unsafe { Handle::of(h) }.and_then(|handle| handle.setpoint_at(time));
    // SAFETY: each pointer is NULL or valid to write.
    code(setpoint.map(|setpoint| unsafe { write_setpoint(setpoint, position, velocity, accel) }))
}

/// # Safety
/// Each pointer is NULL or valid to write.
unsafe fn write_setpoint(
    setpoint: State<f64>,
    position: *mut f64,
    velocity: *mut f64,
    accel: *mut f64,
) {
    for (to, value) in [
        (position, setpoint.position),
        (velocity, setpoint.velocity),
        (accel, setpoint.acceleration),
    ] {
        if !to.is_null() {
            // SAFETY: not NULL, so valid to write.
            unsafe { to.write(value) };
        }
    }
}

/// @param h the handle
/// @return position now, unit; NaN where `claraty_trapezoid_get_setpoint` fails
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_position(h: *mut claraty_trapezoid) -> f64 {
    // SAFETY: by the contract of this module.
    let setpoint = unsafe { Handle::of(h) }.and_then(Handle::setpoint);
    setpoint.map_or(f64::NAN, |setpoint| setpoint.position)
}

/// @param h the handle
/// @return velocity now, unit/s; NaN where `claraty_trapezoid_get_setpoint` fails
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_velocity(h: *mut claraty_trapezoid) -> f64 {
    // SAFETY: by the contract of this module.
    let setpoint = unsafe { Handle::of(h) }.and_then(Handle::setpoint);
    setpoint.map_or(f64::NAN, |setpoint| setpoint.velocity)
}

/// @param h the handle
/// @return acceleration now, unit/s^2; NaN where `claraty_trapezoid_get_setpoint` fails
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_acceleration(h: *mut claraty_trapezoid) -> f64 {
    // SAFETY: by the contract of this module.
    let setpoint = unsafe { Handle::of(h) }.and_then(Handle::setpoint);
    setpoint.map_or(f64::NAN, |setpoint| setpoint.acceleration)
}

/// @param h the handle
/// @param time since the start, s
/// @return position at a time after the start, unit; NaN where `claraty_trapezoid_get_setpoint_at` fails
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_position_at(
    h: *mut claraty_trapezoid,
    time: f64,
) -> f64 {
    // SAFETY: by the contract of this module.
    let setpoint = unsafe { Handle::of(h) }.and_then(|handle| handle.setpoint_at(time));
    setpoint.map_or(f64::NAN, |setpoint| setpoint.position)
}

/// @param h the handle
/// @param time since the start, s
/// @return velocity at a time after the start, unit/s; NaN where `claraty_trapezoid_get_setpoint_at` fails
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_velocity_at(
    h: *mut claraty_trapezoid,
    time: f64,
) -> f64 {
    // SAFETY: by the contract of this module.
    let setpoint = unsafe { Handle::of(h) }.and_then(|handle| handle.setpoint_at(time));
    setpoint.map_or(f64::NAN, |setpoint| setpoint.velocity)
}

/// @param h the handle
/// @param time since the start, s
/// @return acceleration at a time after the start, unit/s^2; NaN where `claraty_trapezoid_get_setpoint_at` fails
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_acceleration_at(
    h: *mut claraty_trapezoid,
    time: f64,
) -> f64 {
    // SAFETY: by the contract of this module.
    let setpoint = unsafe { Handle::of(h) }.and_then(|handle| handle.setpoint_at(time));
    setpoint.map_or(f64::NAN, |setpoint| setpoint.acceleration)
}

/// The profile of the last start or stop, all 0 before; along waypoints that of the leg last looked at, with times from
/// the start of the leg.
/// @param h the handle
/// @param out NULL, or where to write it
/// @return `CLARATY_OK` or `CLARATY_ERR_NULL`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_profile(
    h: *const claraty_trapezoid,
    out: *mut claraty_profile,
) -> c_int {
    // SAFETY: by the contract of this module.
    let Some(handle) = (unsafe { Handle::of_const(h) }) else {
        return CLARATY_ERR_NULL as c_int;
    };
    if !out.is_null() {
        let profile = handle.trajectory.profile();
        // SAFETY: not NULL, so valid to write.
        unsafe {
            out.write(claraty_profile {
                t1: profile.t1,
                t2: profile.t2,
                tf: profile.tf,
                p_at_t1: profile.p_at_t1,
                p_at_t2: profile.p_at_t2,
                final_position: profile.final_position,
                velocity: profile.velocity,
                accel: profile.acceleration,
                decel: profile.deceleration,
                r#type: profile.kind as c_int,
            });
        }
    }
    CLARATY_OK as c_int
}

#[cfg(all(feature = "std", unix))]
const SYSTEM_CLOCK: claraty_clock = Some(system_clock);
#[cfg(not(all(feature = "std", unix)))]
const SYSTEM_CLOCK: claraty_clock = None;

#[cfg(all(feature = "std", unix))]
unsafe extern "C" fn system_clock(_: *mut c_void) -> f64 {
    // SAFETY: a `timespec` is made of integers.
    let mut time: libc::timespec = unsafe { core::mem::zeroed() };
    // SAFETY: `time` is valid to write.
    unsafe { libc::clock_gettime(libc::CLOCK_MONOTONIC, &mut time) };
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}
