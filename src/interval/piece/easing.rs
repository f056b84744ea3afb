//! The end of an easing.

/// How the piece ends in which the acceleration eases.
pub(crate) enum Easing {
    /// The hold is over.
    HoldEnds,
    /// The acceleration eases down to 0.
    Vanishes,
    /// The acceleration can ease no further.
    IsFollowedByGap,
}
