//! `claraty/trapezoid.h`: CLARAty's trapezoid as a handle.

use crate::capi::assert_named;
use crate::claraty::{EPS, Kind, LARGEST, Mode, OutOfRange, Profile, Route, Target, Trajectory, Warnings, Waypoints};
use crate::state::State;
use core::ffi::{c_int, c_void};
use core::slice;

/// A clock: monotonic seconds from any fixed origin. It must not use the handle that reads it.
pub type claraty_clock = Option<unsafe extern "C" fn(user: *mut c_void) -> f64>;

/// The motion that a handle plans.
#[repr(C)]
pub enum claraty_mode {
    /// from any position and velocity to rest at the target, without a jump, without a needless overshoot
    CLARATY_CORRECTED = 0,
    /// the motion of CLARAty's published listing, bit for bit, infinite and NaN setpoints included
    CLARATY_LISTING = 1,
}

/// Shape of the velocity over time.
#[repr(C)]
pub enum claraty_type {
    /// does not cruise at the maximum velocity
    CLARATY_TRIANGULAR = 0,
    /// cruises at the maximum velocity
    CLARATY_TRAPEZOIDAL = 1,
}

/// What a plan changed or could not do, as bits.
#[repr(C)]
pub enum claraty_warning {
    /// the acceleration was below 1e-10 and was raised to it
    CLARATY_WARN_ACCEL = 1,
    /// the deceleration was below 1e-10 and was raised to it
    CLARATY_WARN_DECEL = 2,
    /// the maximum velocity was below 1e-10 and was raised to it
    CLARATY_WARN_VELOCITY = 4,
    /// listing mode only: the listing found no instant to switch to deceleration, and the motion is wrong
    CLARATY_WARN_SWITCH = 8,
}

/// The result of a function that can fail.
#[repr(C)]
pub enum claraty_result {
    /// done
    CLARATY_OK = 0,
    /// the handle or an array is NULL
    CLARATY_ERR_NULL = -1,
    /// an argument or the time on the clock is infinite or not a number
    CLARATY_ERR_NOT_FINITE = -2,
    /// the mode is not one of `claraty_mode`
    CLARATY_ERR_MODE = -3,
    /// there are no waypoints, or more than an array can hold
    CLARATY_ERR_WAYPOINTS = -4,
    /// a position, velocity or rate is larger than 1e60, and the motion could overflow
    CLARATY_ERR_RANGE = -5,
}
use claraty_result::*;
use claraty_warning::*;

const _: () = assert!(
    claraty_mode::CLARATY_LISTING as isize == Mode::Listing as isize
        && claraty_type::CLARATY_TRAPEZOIDAL as isize == Kind::Trapezoidal as isize
        && EPS == 1e-10
        && LARGEST == 1e60
);
assert_named! { Warnings::MEMBERS;
    Warnings::ACCELERATION.bits() => CLARATY_WARN_ACCEL,
    Warnings::DECELERATION.bits() => CLARATY_WARN_DECEL,
    Warnings::VELOCITY.bits() => CLARATY_WARN_VELOCITY,
    Warnings::SWITCH.bits() => CLARATY_WARN_SWITCH,
}

/// A planned motion: acceleration until `t1`, cruise until `t2`, deceleration until `tf`. Times count from its start.
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

/// One axis. The caller owns the handle, on the stack, static or on the heap, and has nothing to release. The handle
/// may be copied at any time, and the copy runs on its own. A copy reads the same arrays of waypoints.
#[repr(C)]
pub struct claraty_trapezoid {
    /// private
    pub opaque: [u64; 34],
}

/// The content of the caller's storage.
struct Handle {
    trajectory: Trajectory<'static>,
    clock: claraty_clock,
    user: *mut c_void,
}

const _: () = assert!(
    size_of::<Handle>() <= size_of::<claraty_trapezoid>() && align_of::<Handle>() <= align_of::<claraty_trapezoid>()
);

impl Handle {
    /// # Safety
    /// `h` is NULL or points to an initialised handle. Nobody else uses the handle as long as the result lives.
    unsafe fn of<'a>(h: *mut claraty_trapezoid) -> Result<&'a mut Self, claraty_result> {
        // SAFETY: an initialised handle holds a `Handle`, which has room in it.
        unsafe { h.cast::<Self>().as_mut() }.ok_or(CLARATY_ERR_NULL)
    }

    /// # Safety
    /// `h` is NULL or points to an initialised handle. Nobody changes the handle as long as the result lives.
    unsafe fn of_const<'a>(h: *const claraty_trapezoid) -> Option<&'a Self> {
        // SAFETY: as in `of`.
        unsafe { h.cast::<Self>().as_ref() }
    }

    /// Time on the clock, s. The manual clock stands still.
    fn now(&self) -> f64 {
        // SAFETY: the caller of `claraty_trapezoid_set_clock` gave the clock and its argument.
        self.clock.map_or(0.0, |clock| unsafe { clock(self.user) })
    }

    fn finite_now(&self) -> Result<f64, claraty_result> {
        let now = self.now();
        finite(self.trajectory.elapsed(now)).map(|_| now)
    }

    fn set(&mut self, route: Route<'static>) -> Result<(), claraty_result> {
        self.trajectory.set(route, self.finite_now()?).map_err(|OutOfRange| CLARATY_ERR_RANGE)
    }

    fn setpoint(&mut self) -> Result<State<f64>, claraty_result> {
        Ok(self.trajectory.setpoint(self.finite_now()?))
    }

    /// The listing may plan a motion that ends at a NaN. A look at this time is part of the listing's behaviour.
    fn setpoint_at(&mut self, time: f64) -> Result<State<f64>, claraty_result> {
        if self.trajectory.motion_mode() == Mode::Corrected {
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

/// No warning is 0, as `CLARATY_OK`.
fn code(result: Result<(), claraty_result>) -> c_int {
    warnings_or_code(result.map(|()| Warnings::default()))
}

fn warnings_or_code(result: Result<Warnings, claraty_result>) -> c_int {
    result.map_or_else(|error| error as c_int, |warnings| warnings.bits().into())
}

/// Makes a handle out of storage, which need not be initialised: at rest at 0, timer at 0, in mode `CLARATY_CORRECTED`.
/// The handle reads the monotonic clock of the system; on Windows and on a target without a system it has the manual
/// clock.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_init(h: *mut claraty_trapezoid) {
    if h.is_null() {
        return;
    }
    let mut handle = Handle { trajectory: Trajectory::default(), clock: SYSTEM_CLOCK, user: core::ptr::null_mut() };
    handle.trajectory.reset(handle.now());
    // SAFETY: `h` points to storage for a handle by the contract of this module.
    unsafe { h.cast::<Handle>().write(handle) };
}

/// Chooses the mode of the following starts and stops. A motion under way keeps its mode.
/// @param mode one of `claraty_mode`
/// @return `CLARATY_OK`, `CLARATY_ERR_NULL` or `CLARATY_ERR_MODE`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_set_mode(h: *mut claraty_trapezoid, mode: c_int) -> c_int {
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

/// Gives the handle another clock. A motion under way goes on where it is; if the old or the new clock shows no finite
/// number now, the motion is forgotten as by `claraty_trapezoid_reset`. The manual clock stands still: only
/// `claraty_trapezoid_advance_timer_by` moves the timer.
/// @param clock monotonic seconds; NULL for the manual clock
/// @param user the argument of every call of `clock`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_set_clock(
    h: *mut claraty_trapezoid, clock: claraty_clock, user: *mut c_void,
) {
    // SAFETY: by the contract of this module.
    if let Ok(handle) = unsafe { Handle::of(h) } {
        let before = handle.now();
        (handle.clock, handle.user) = (clock, user);
        handle.trajectory.change_clock(before, handle.now());
    }
}

/// Stores where to go next. Nothing moves before `claraty_trapezoid_start`. A motion along waypoints lets go of them:
/// it ends at rest at the waypoint ahead.
/// @param final_position relative to the start of the trajectory, unit
/// @param max_velocity magnitude, unit/s
/// @param accel magnitude of the rate from the present velocity to the cruise velocity, `decel` of the final stop,
/// unit/s^2
/// @return `CLARATY_OK`, `CLARATY_ERR_NULL`, `CLARATY_ERR_NOT_FINITE` or `CLARATY_ERR_RANGE`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_set(
    h: *mut claraty_trapezoid, final_position: f64, max_velocity: f64, accel: f64, decel: f64,
) -> c_int {
    // SAFETY: by the contract of this module.
    code(unsafe { Handle::of(h) }.and_then(|handle| {
        all_finite(&[final_position, max_velocity, accel, decel])?;
        let target =
            Target { position: final_position, velocity: max_velocity, acceleration: accel, deceleration: decel };
        handle.set(target.into())
    }))
}

/// Stores a path along `n` positions, with rest at each. Nothing moves before `claraty_trapezoid_start`. In both modes
/// the legs are corrected motions, and the first leg begins at the present motion. The caller must not change the
/// arrays until the next set.
/// @param positions relative to the start of the trajectory, unit
/// @param velocities maximum velocity of the leg to each position, unit/s
/// @param accels acceleration and deceleration of the leg to each position, unit/s^2
/// @return `CLARATY_OK`, `CLARATY_ERR_NULL`, `CLARATY_ERR_NOT_FINITE`, `CLARATY_ERR_WAYPOINTS` or `CLARATY_ERR_RANGE`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_set_waypoints(
    h: *mut claraty_trapezoid, positions: *const f64, velocities: *const f64, accels: *const f64, n: usize,
) -> c_int {
    // SAFETY: by the contract of this module.
    code(unsafe { Handle::of(h) }.and_then(|handle| {
        // SAFETY: each array is NULL or holds `n` numbers that stay until the next set.
        let [positions, velocities, accels] =
            unsafe { [finite_array(positions, n)?, finite_array(velocities, n)?, finite_array(accels, n)?] };
        let waypoints = Waypoints::new(positions, velocities, accels).ok_or(CLARATY_ERR_WAYPOINTS)?;
        handle.set(waypoints.into())
    }))
}

/// As `claraty_trapezoid_set_waypoints`, with one maximum velocity, unit/s, and one acceleration, unit/s^2, for all
/// legs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_set_uniform_waypoints(
    h: *mut claraty_trapezoid, positions: *const f64, n: usize, max_velocity: f64, accel: f64,
) -> c_int {
    // SAFETY: by the contract of this module.
    code(unsafe { Handle::of(h) }.and_then(|handle| {
        // SAFETY: the array is NULL or holds `n` numbers that stay until the next set.
        let positions = unsafe { finite_array(positions, n)? };
        all_finite(&[max_velocity, accel])?;
        let waypoints = Waypoints::uniform(positions, max_velocity, accel).ok_or(CLARATY_ERR_WAYPOINTS)?;
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
    // SAFETY: `values` is not NULL, and the size does not overflow; the caller promises `n` numbers.
    let values = unsafe { slice::from_raw_parts(values, n) };
    all_finite(values).map(|()| values)
}

/// Sets off with the timer at 0. The motion begins at the setpoint if a motion is under way, else at rest at 0.
/// @return the sum of `claraty_warning` bits, or `CLARATY_ERR_NULL` or `CLARATY_ERR_NOT_FINITE`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_start(h: *mut claraty_trapezoid) -> c_int {
    // SAFETY: by the contract of this module.
    warnings_or_code(unsafe { Handle::of(h) }.and_then(|handle| Ok(handle.trajectory.start(handle.finite_now()?))))
}

/// Brakes a motion under way. The timer is set to 0 also if no motion is under way.
/// @return as `claraty_trapezoid_start`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_stop(h: *mut claraty_trapezoid) -> c_int {
    // SAFETY: by the contract of this module.
    warnings_or_code(unsafe { Handle::of(h) }.and_then(|handle| Ok(handle.trajectory.stop(handle.finite_now()?))))
}

/// Forgets the motion and sets the timer to 0. The axis does not brake, and the last profile stays readable. If the
/// clock shows no finite number now, the timer goes on unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_reset(h: *mut claraty_trapezoid) {
    // SAFETY: by the contract of this module.
    if let Ok(handle) = unsafe { Handle::of(h) } {
        handle.trajectory.reset(handle.now());
    }
}

/// Whether a motion is under way, 1 or 0: from the start until a setpoint after the end has been read.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_is_started(h: *const claraty_trapezoid) -> c_int {
    // SAFETY: by the contract of this module.
    unsafe { Handle::of_const(h) }.map_or(CLARATY_ERR_NULL as c_int, |handle| handle.trajectory.is_started().into())
}

/// Adds to the time on the clock, s; a negative number too. A number that is not finite, and an advance that overflows,
/// are ignored. The next start, stop or reset drops an advance of more than 1e6 s, because the clock would lose digits
/// next to it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_advance_timer_by(h: *mut claraty_trapezoid, seconds: f64) {
    // SAFETY: by the contract of this module.
    if let (Ok(handle), Ok(seconds)) = (unsafe { Handle::of(h) }, finite(seconds)) {
        handle.trajectory.advance_timer_by(seconds);
    }
}

/// Reads the timer: the time since the last start, stop or reset, s.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_elapsed(h: *const claraty_trapezoid) -> f64 {
    // SAFETY: by the contract of this module.
    unsafe { Handle::of_const(h) }.map_or(f64::NAN, |handle| handle.trajectory.elapsed(handle.now()))
}

/// Reads the duration of the motion from the start to rest, over all legs, s; 0 before the first start.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_duration(h: *const claraty_trapezoid) -> f64 {
    // SAFETY: by the contract of this module.
    unsafe { Handle::of_const(h) }.map_or(f64::NAN, |handle| handle.trajectory.duration())
}

/// Reads the setpoint now: position, unit, velocity, unit/s, and acceleration, unit/s^2, each to its place or to NULL.
/// A reading after the end of the motion ends the motion.
/// @return `CLARATY_OK`, `CLARATY_ERR_NULL` or `CLARATY_ERR_NOT_FINITE`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_setpoint(
    h: *mut claraty_trapezoid, position: *mut f64, velocity: *mut f64, accel: *mut f64,
) -> c_int {
    // SAFETY: by the contract of this module.
    unsafe { write_setpoint(Handle::of(h).and_then(Handle::setpoint), position, velocity, accel) }
}

/// Reads the setpoint at a time after the start, s, as `claraty_trapezoid_get_setpoint` does. In a corrected motion a
/// look changes nothing, and a time before the start gives the state at the start. A motion of the listing behaves as
/// the listing: a look beyond the end ends it, a time before the start gives 0, and a time that is not finite is
/// accepted.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_setpoint_at(
    h: *mut claraty_trapezoid, time: f64, position: *mut f64, velocity: *mut f64, accel: *mut f64,
) -> c_int {
    // SAFETY: by the contract of this module.
    unsafe { write_setpoint(Handle::of(h).and_then(|handle| handle.setpoint_at(time)), position, velocity, accel) }
}

/// # Safety
/// Each pointer is NULL or valid to write.
unsafe fn write_setpoint(
    setpoint: Result<State<f64>, claraty_result>, position: *mut f64, velocity: *mut f64, accel: *mut f64,
) -> c_int {
    code(setpoint.map(|now| {
        for (to, value) in [(position, now.position), (velocity, now.velocity), (accel, now.acceleration)] {
            if !to.is_null() {
                // SAFETY: not NULL, so valid to write.
                unsafe { to.write(value) };
            }
        }
    }))
}

/// The position of `claraty_trapezoid_get_setpoint`, unit; NaN where that fails.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_position(h: *mut claraty_trapezoid) -> f64 {
    // SAFETY: by the contract of this module.
    unsafe { Handle::of(h) }.and_then(Handle::setpoint).map_or(f64::NAN, |setpoint| setpoint.position)
}

/// The velocity of `claraty_trapezoid_get_setpoint`, unit/s; NaN where that fails.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_velocity(h: *mut claraty_trapezoid) -> f64 {
    // SAFETY: by the contract of this module.
    unsafe { Handle::of(h) }.and_then(Handle::setpoint).map_or(f64::NAN, |setpoint| setpoint.velocity)
}

/// The acceleration of `claraty_trapezoid_get_setpoint`, unit/s^2; NaN where that fails.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_acceleration(h: *mut claraty_trapezoid) -> f64 {
    // SAFETY: by the contract of this module.
    unsafe { Handle::of(h) }.and_then(Handle::setpoint).map_or(f64::NAN, |setpoint| setpoint.acceleration)
}

/// The position of `claraty_trapezoid_get_setpoint_at`, unit; NaN where that fails.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_position_at(h: *mut claraty_trapezoid, time: f64) -> f64 {
    // SAFETY: by the contract of this module.
    unsafe { Handle::of(h) }.and_then(|handle| handle.setpoint_at(time)).map_or(f64::NAN, |setpoint| setpoint.position)
}

/// The velocity of `claraty_trapezoid_get_setpoint_at`, unit/s; NaN where that fails.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_velocity_at(h: *mut claraty_trapezoid, time: f64) -> f64 {
    // SAFETY: by the contract of this module.
    unsafe { Handle::of(h) }.and_then(|handle| handle.setpoint_at(time)).map_or(f64::NAN, |setpoint| setpoint.velocity)
}

/// The acceleration of `claraty_trapezoid_get_setpoint_at`, unit/s^2; NaN where that fails.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_acceleration_at(h: *mut claraty_trapezoid, time: f64) -> f64 {
    // SAFETY: by the contract of this module.
    unsafe { Handle::of(h) }.and_then(|handle| handle.setpoint_at(time)).map_or(f64::NAN, |state| state.acceleration)
}

/// Reads the profile of the last start or stop to `out`, or to NULL; before the first start all of it is 0. Along
/// waypoints it is the profile of the leg last looked at, and its times count from the start of this leg.
/// @return `CLARATY_OK` or `CLARATY_ERR_NULL`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn claraty_trapezoid_get_profile(
    h: *const claraty_trapezoid, out: *mut claraty_profile,
) -> c_int {
    // SAFETY: by the contract of this module.
    let Some(handle) = (unsafe { Handle::of_const(h) }) else { return CLARATY_ERR_NULL as c_int };
    if !out.is_null() {
        let &Profile {
            t1, t2, tf, p_at_t1, p_at_t2, final_position, velocity, acceleration, deceleration, kind, ..
        } = handle.trajectory.profile();
        let (accel, decel, r#type) = (acceleration, deceleration, kind as c_int);
        let profile = claraty_profile { t1, t2, tf, p_at_t1, p_at_t2, final_position, velocity, accel, decel, r#type };
        // SAFETY: not NULL, so valid to write.
        unsafe { out.write(profile) };
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
