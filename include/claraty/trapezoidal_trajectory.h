/*!
 @file trapezoidal_trajectory.h
 @brief CLARAty's classes `Trajectory` and `Trapezoidal_Trajectory` over the handle of trapezoid.h; C++98 and later
 @details The public members of the original under their names, plus `handle()` for what it did not have: the mode
 (`claraty_trapezoid_set_mode`; corrected motions unless asked for the listing's), the clock, the duration, the profile.

 Warnings and refused arguments are told on `std::cerr`, a line each. Define CLARATY_NO_WARNINGS for the whole program to
 leave that out, and the header `iostream` with it.
*/

#ifndef CLARATY_TRAPEZOIDAL_TRAJECTORY_H
#define CLARATY_TRAPEZOIDAL_TRAJECTORY_H

#include "trapezoid.h"
#include <cstddef>
#include <ostream>
#if !defined(CLARATY_NO_WARNINGS)
#include <iostream>
#endif

namespace claraty
{

namespace detail
{

/* What a class calls its number of elements: `get_size()`, as CLARAty's Vector, or `size()`. */

typedef char one[1];
typedef char two[2];
template <std::size_t>
struct well_formed;

template <class T>
one &has_get_size(well_formed<sizeof(static_cast<T *>(0)->get_size())> *);
template <class T>
two &has_get_size(...);

template <class T>
one &has_size(well_formed<sizeof(static_cast<T *>(0)->size())> *);
template <class T>
two &has_size(...);

/* Has a `result`, the one of a `set`, only for a vector: other types fall to the overloads for numbers. */
template <class T, std::size_t GetSize = sizeof(has_get_size<T>(0)), std::size_t Size = sizeof(has_size<T>(0))>
struct vector
{
};
template <class T, std::size_t Size>
struct vector<T, sizeof(one), Size>
{
    typedef void result;
    static std::size_t size(T &v) { return static_cast<std::size_t>(v.get_size()); }
};
template <class T>
struct vector<T, sizeof(two), sizeof(one)>
{
    typedef void result;
    static std::size_t size(T &v) { return static_cast<std::size_t>(v.size()); }
};

/* The elements as an array; 0 if there are none or they do not lie side by side. */
template <class T>
const double *elements(T &v)
{
    const std::size_t n = vector<T>::size(v);
    if (n == 0) { return 0; }
    const double *const first = &v[0];
    for (std::size_t i = 1; i < n; ++i)
    {
        const double *const element = &v[i];
        if (element != first + i) { return 0; }
    }
    return first;
}

} /* namespace detail */

/*!
 @brief a trajectory of one axis
 @details Position, velocity and acceleration in any consistent unit, times in seconds, limits by magnitude. It may be
 copied at any time.
*/
class Trajectory
{
public:
    virtual ~Trajectory() {}

    /*! where to go next, deceleration as acceleration; it moves nothing before `start` */
    virtual void set(double final_position, double max_velocity, double accel)
    {
        set(final_position, max_velocity, accel, accel);
    }
    /*! where to go next */
    virtual void set(double final_position, double max_velocity, double accel, double decel)
    {
        report("set", claraty_trapezoid_set(&_handle, final_position, max_velocity, accel, decel));
    }
    /*!
     @brief waypoints with rest at each, their velocities and accelerations
     @details The vectors, of `double` side by side, must stay as they are until the next `set`.
    */
    template <class Vector>
    typename detail::vector<Vector>::result set(Vector &final_position, Vector &max_velocity, Vector &accel)
    {
        const std::size_t n = detail::vector<Vector>::size(final_position);
        if (detail::vector<Vector>::size(max_velocity) != n || detail::vector<Vector>::size(accel) != n)
        {
            report("set", CLARATY_ERR_WAYPOINTS);
            return;
        }
        report("set", claraty_trapezoid_set_waypoints(&_handle, detail::elements(final_position),
                                                      detail::elements(max_velocity), detail::elements(accel), n));
    }
    /*! waypoints with rest at each, and one velocity and one acceleration for all */
    template <class Vector>
    typename detail::vector<Vector>::result set(Vector &final_position, double max_velocity, double accel)
    {
        report("set", claraty_trapezoid_set_uniform_waypoints(&_handle, detail::elements(final_position),
                                                              detail::vector<Vector>::size(final_position),
                                                              max_velocity, accel));
    }

    /*! sets off from the present motion, or from rest at 0 */
    void start() { report("start", claraty_trapezoid_start(&_handle)); }
    /*! brakes from here */
    void stop() { report("stop", claraty_trapezoid_stop(&_handle)); }
    /*! forgets the present motion and sets the timer to 0 */
    void reset() { claraty_trapezoid_reset(&_handle); }
    /*! from the start until the setpoint has been read after the end */
    bool is_started() const { return claraty_trapezoid_is_started(&_handle) > 0; }
    /*! adds to what the clock gives */
    void advance_timer_by(double delta_time) { claraty_trapezoid_advance_timer_by(&_handle, delta_time); }

    /*! position now */
    double get_position() { return claraty_trapezoid_get_position(&_handle); }
    /*! position at a time after the start */
    double get_position(double time) { return claraty_trapezoid_get_position_at(&_handle, time); }
    /*! velocity now */
    double get_velocity() { return claraty_trapezoid_get_velocity(&_handle); }
    /*! velocity at a time after the start */
    double get_velocity(double time) { return claraty_trapezoid_get_velocity_at(&_handle, time); }
    /*! acceleration now */
    double get_acceleration() { return claraty_trapezoid_get_acceleration(&_handle); }
    /*! acceleration at a time after the start */
    double get_acceleration(double time) { return claraty_trapezoid_get_acceleration_at(&_handle, time); }
    /*! all three now */
    void get_setpoint(double &position, double &velocity, double &accel)
    {
        report("get_setpoint", claraty_trapezoid_get_setpoint(&_handle, &position, &velocity, &accel));
    }
    /*! all three at a time after the start */
    void get_setpoint(double time, double &position, double &velocity, double &accel)
    {
        report("get_setpoint", claraty_trapezoid_get_setpoint_at(&_handle, time, &position, &velocity, &accel));
    }

    /*! for the functions of trapezoid.h */
    claraty_trapezoid *handle() { return &_handle; }
    /*! for those that only read */
    const claraty_trapezoid *handle() const { return &_handle; }

protected:
    Trajectory() { claraty_trapezoid_init(&_handle); }

private:
    claraty_trapezoid _handle;

#if defined(CLARATY_NO_WARNINGS)
    static void report(const char *, int) {}
#else
    static void report(const char *function, int code)
    {
        if (code < 0) { tell(function, error(code)); }
        else
        {
            if (code & CLARATY_WARN_ACCEL) { tell(function, "acceleration too small, raised"); }
            if (code & CLARATY_WARN_DECEL) { tell(function, "deceleration too small, raised"); }
            if (code & CLARATY_WARN_VELOCITY) { tell(function, "maximum velocity too small, raised"); }
            if (code & CLARATY_WARN_SWITCH) { tell(function, "no switching time found, the motion is wrong"); }
        }
    }
    static const char *error(int code)
    {
        switch (code)
        {
        case CLARATY_ERR_NOT_FINITE: return "refused, not a finite number";
        case CLARATY_ERR_WAYPOINTS: return "refused, vectors empty or of different size";
        default: return "refused, elements not side by side";
        }
    }
    static void tell(const char *function, const char *what)
    {
        std::cerr << "claraty::Trajectory::" << function << ": " << what << '\n';
    }
#endif
};

/*! @brief a trajectory with a trapezoid, or a triangle, of velocity over time */
class Trapezoidal_Trajectory : public Trajectory
{
public:
    /*! shape of the velocity over time */
    enum trajectory_type
    {
        TRIANGULAR = CLARATY_TRIANGULAR,
        TRAPEZOIDAL = CLARATY_TRAPEZOIDAL
    };

    /*! at rest at 0 */
    Trapezoidal_Trajectory() {}
};

/*! the profile of the last start or stop in one line */
inline std::ostream &operator<<(std::ostream &out, const Trapezoidal_Trajectory &trajectory)
{
    claraty_profile p;
    claraty_trapezoid_get_profile(trajectory.handle(), &p);
    return out << (p.type == Trapezoidal_Trajectory::TRAPEZOIDAL ? "trapezoidal" : "triangular") << " t1 " << p.t1
               << " t2 " << p.t2 << " tf " << p.tf << " p(t1) " << p.p_at_t1 << " p(t2) " << p.p_at_t2 << " p(tf) "
               << p.final_position << " v " << p.velocity << " a " << p.accel << " d " << p.decel;
}

} /* namespace claraty */

#endif /* CLARATY_TRAPEZOIDAL_TRAJECTORY_H */
