/*!
 @file trapezoidal_trajectory.h
 @brief CLARAty's classes `Trajectory` and `Trapezoidal_Trajectory` over the handle of trapezoid.h; C++98 and later
 @details The classes have the public members of the original under their names. `handle()` gives access to what the
 original did not have: the mode, the clock, the duration and the profile. Motions are corrected; for the motions of the
 listing call `claraty_trapezoid_set_mode(axis.handle(), CLARATY_LISTING)`.

 Each warning and each refused argument is a line on `std::cerr`. Define CLARATY_NO_WARNINGS for the whole program to
 leave out these lines and the header `iostream`.
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

/* The number of elements of a vector is `get_size()`, as in CLARAty's Vector, or `size()`. */

typedef char one[1];
typedef char two[2];
template <class T>
T &any();
template <std::size_t>
struct well_formed
{
    typedef int type;
};

template <class T>
one &has_get_size(typename well_formed<sizeof(any<T>().get_size())>::type);
template <class T>
two &has_get_size(...);

template <class T>
one &has_size(typename well_formed<sizeof(any<T>().size())>::type);
template <class T>
two &has_size(...);

/* Only a vector has a `result`, which is the result of `set`. Other types take the overloads of `set` for numbers. */
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

typedef const double *array;

/* The elements as an array. It is a null pointer if there are no elements, or if they do not lie side by side. */
template <class T>
array elements(T &v)
{
    const std::size_t n = vector<T>::size(v);
    if (n == 0) { return array(); }
    const array first = &v[0];
    for (std::size_t i = 1; i < n; ++i)
    {
        const array element = &v[i];
        if (element != first + i) { return array(); }
    }
    return first;
}

} /* namespace detail */

/*!
 @brief a trajectory of one axis
 @details Length or angle is in any consistent unit, time in seconds. The sign of a limit is ignored. A trajectory may
 be copied at any time.
*/
class Trajectory
{
public:
    virtual ~Trajectory() {}
    /*! the copy goes on with the motion on its own */
    Trajectory(const Trajectory &other) : _handle(other._handle) {}
    /*! this trajectory goes on with the motion of `other` on its own */
    Trajectory &operator=(const Trajectory &other)
    {
        _handle = other._handle;
        return *this;
    }

    /*! stores where to go next, deceleration equal to acceleration; nothing moves before `start` */
    virtual void set(double final_position, double max_velocity, double accel)
    {
        set(final_position, max_velocity, accel, accel);
    }
    /*! stores where to go next; nothing moves before `start` */
    virtual void set(double final_position, double max_velocity, double accel, double decel)
    {
        report("set", claraty_trapezoid_set(&_handle, final_position, max_velocity, accel, decel));
    }
    /*!
     @brief stores waypoints, with rest at each, and the velocity and acceleration of each leg
     @details The elements are of type `double` and lie side by side. The caller must not change the vectors until the
     next `set`.
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
    /*! stores waypoints, with rest at each, and one velocity and one acceleration for all legs */
    template <class Vector>
    typename detail::vector<Vector>::result set(Vector &final_position, double max_velocity, double accel)
    {
        report("set", claraty_trapezoid_set_uniform_waypoints(&_handle, detail::elements(final_position),
                                                              detail::vector<Vector>::size(final_position),
                                                              max_velocity, accel));
    }

    /*! sets off from the setpoint if a motion is under way, else from rest at 0 */
    void start() { report("start", claraty_trapezoid_start(&_handle)); }
    /*! brakes a motion under way */
    void stop() { report("stop", claraty_trapezoid_stop(&_handle)); }
    /*! forgets the motion and sets the timer to 0; the axis does not brake */
    void reset() { claraty_trapezoid_reset(&_handle); }
    /*! whether a motion is under way: from the start until a setpoint after the end has been read */
    bool is_started() const { return claraty_trapezoid_is_started(&_handle) > 0; }
    /*! adds to the time on the clock */
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
    /*! position, velocity and acceleration now */
    void get_setpoint(double &position, double &velocity, double &accel)
    {
        report("get_setpoint", claraty_trapezoid_get_setpoint(&_handle, &position, &velocity, &accel));
    }
    /*! position, velocity and acceleration at a time after the start */
    void get_setpoint(double time, double &position, double &velocity, double &accel)
    {
        report("get_setpoint", claraty_trapezoid_get_setpoint_at(&_handle, time, &position, &velocity, &accel));
    }

    /*! for the functions of trapezoid.h */
    claraty_trapezoid *handle() { return &_handle; }
    /*! for the functions of trapezoid.h that only read */
    const claraty_trapezoid *handle() const { return &_handle; }

protected:
    Trajectory() : _handle() { claraty_trapezoid_init(&_handle); }

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
        case CLARATY_ERR_RANGE: return "refused, a number larger than 1e60";
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
