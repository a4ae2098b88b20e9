//! The oracle: says from the program's own numbers what an implementation's image must be, with arithmetic that is exact
//! or far more precise than any implementation's. It shares no code with the rasterizer that it judges.
//!
//! **Coverage** has three values. An implementation moves every vertex to its subpixel grid, by at most half a subpixel
//! (1/512 pixel) in x and in y, and with it every point of an edge by no more than that. So a sample whose distance from all
//! edges (the larger of |dx| and |dy|) is greater *must* be covered if it lies inside and *must not* be if it lies outside;
//! a nearer one *may* be. To the half subpixel we add the rounding of a single-precision vertex transform, which is computed
//! for each vertex ([`bound`]) and is far below a subpixel in ordinary windows.
//!
//! **Clipping.** What is judged is the part of the primitive inside the view volume and the user clip planes, cut exactly; its
//! new corners are vertices like the others, the edges along the planes edges like the others. A single-precision clipper is
//! allowed no more: where it errs by more, that counts as `wrong`. A second count, `beyond`, widens the band by what rounding
//! a new vertex in single precision can do ([`bound::clip`]), and so tells loss of precision from a defect.
//!
//! **The snapped rule.** Where the snapped position of every vertex of a primitive is certain, coverage is also determined exactly:
//! 8 subpixel bits, rounded to nearest even, edges in integers, left and bottom edges inclusive. The count `off_rule` holds
//! samples that are allowed by the three-valued judgement but differ from that rule.

pub mod bound;
pub mod clip;
pub mod coverage;
pub mod exact;
pub mod snapped;
pub mod supersampled;
pub mod values;

pub use coverage::{Counts, Coverage};
