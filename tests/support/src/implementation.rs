//! How tests see a library: each family is a function from arguments to fields and one from fields to quantities.

use crate::family::Family;

pub trait Implementation<R> {
    /// Calls the family's `gen`: finds what `fields` held before, writes them, returns the duration; 0 for a polynomial, whose `gen` returns nothing.
    fn plan(&self, family: Family, arguments: &[R], fields: &mut [R]) -> R;

    fn evaluate(&self, family: Family, fields: &[R], x: R) -> [R; 4];
}
