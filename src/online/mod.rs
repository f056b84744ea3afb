//! Planning on the border: the fastest motion of one axis is the first one, in order of duration, whose greatest displacement is the
//! wanted one.

pub(crate) mod border;
