//! Begin and End, and the commands between them (2.6, 2.7).

/// The primitive under construction.
#[derive(Default)]
pub(crate) struct Immediate {
    inside: bool,
}

impl Immediate {
    /// Between Begin and End.
    #[inline]
    pub fn is_inside(&self) -> bool {
        self.inside
    }
}
