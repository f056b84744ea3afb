//! The five families of profiles as every implementation of them is seen here: plain arrays of reals.
//!
//! A struct of the C ABI is nothing but reals, so its array is also its memory layout.

/// A profile family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Family {
    Bell,
    Trap,
    Poly3,
    Poly5,
    Poly7,
}

/// The most arguments a family's `gen` has.
pub const MOST_ARGUMENTS: usize = 9;
/// The most reals a family's struct holds.
pub const MOST_FIELDS: usize = 26;

impl Family {
    /// Every family.
    pub const ALL: [Self; 5] = [
        Self::Bell,
        Self::Trap,
        Self::Poly3,
        Self::Poly5,
        Self::Poly7,
    ];

    /// How files and functions name it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Bell => "bell",
            Self::Trap => "trap",
            Self::Poly3 => "poly3",
            Self::Poly5 => "poly5",
            Self::Poly7 => "poly7",
        }
    }

    /// Arguments of `gen`, in order.
    pub fn arguments(self) -> &'static [&'static str] {
        match self {
            Self::Bell => &["jm", "am", "vm", "p0", "p1", "v0", "v1"],
            Self::Trap => &["vm", "ac", "de", "p0", "p1", "v0", "v1"],
            Self::Poly3 => &["ts", "p0", "p1", "v0", "v1"],
            Self::Poly5 => &["ts", "p0", "p1", "v0", "v1", "a0", "a1"],
            Self::Poly7 => &["ts", "p0", "p1", "v0", "v1", "a0", "a1", "j0", "j1"],
        }
    }

    /// Fields of the struct, in order of memory.
    pub fn fields(self) -> &'static [&'static str] {
        match self {
            Self::Bell => &[
                "t", "tv", "ta", "td", "taj", "tdj", "p0", "p1", "v0", "v1", "vm", "jm", "am", "dm",
            ],
            Self::Trap => &[
                "t", "p0", "p1", "v0", "v1", "vc", "ta", "td", "pa", "pd", "ac", "de",
            ],
            Self::Poly3 => &[
                "p[0]", "p[1]", "p[2]", "p[3]", "v[0]", "v[1]", "v[2]", "a[0]", "a[1]",
            ],
            Self::Poly5 => &[
                "p[0]", "p[1]", "p[2]", "p[3]", "p[4]", "p[5]", "v[0]", "v[1]", "v[2]", "v[3]",
                "v[4]", "a[0]", "a[1]", "a[2]", "a[3]",
            ],
            Self::Poly7 => &[
                "p[0]", "p[1]", "p[2]", "p[3]", "p[4]", "p[5]", "p[6]", "p[7]", "v[0]", "v[1]",
                "v[2]", "v[3]", "v[4]", "v[5]", "v[6]", "a[0]", "a[1]", "a[2]", "a[3]", "a[4]",
                "a[5]", "j[0]", "j[1]", "j[2]", "j[3]", "j[4]",
            ],
        }
    }

    /// Columns of words and of returned durations in the golden table of `gen`.
    pub fn golden_columns(self) -> (usize, usize) {
        match self {
            Self::Bell | Self::Trap => (2, 1),
            Self::Poly3 | Self::Poly5 | Self::Poly7 => (1, 0),
        }
    }

    /// Evaluation functions, in the order of [`Implementation::evaluate`].
    pub fn functions(self) -> &'static [&'static str] {
        match self {
            Self::Bell | Self::Poly7 => &["position", "velocity", "acceleration", "jerk"],
            _ => &["position", "velocity", "acceleration"],
        }
    }
}

/// One implementation of the five families in the real type `R`.
pub trait Implementation<R> {
    /// Calls the family's `gen`: finds what `fields` held before, writes them, returns the duration (0 for polynomials,
    /// whose `gen` returns nothing).
    fn plan(&self, family: Family, arguments: &[R], fields: &mut [R]) -> R;

    /// Position, velocity, acceleration and jerk at time `x`; 0 for a jerk that the family does not have.
    fn evaluate(&self, family: Family, fields: &[R], x: R) -> [R; 4];
}
