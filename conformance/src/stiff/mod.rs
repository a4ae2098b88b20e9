//! The stiff suite: families of generated scenes, each with one severity knob that goes from harmless to brutal, judged by the
//! oracle on every implementation.

mod blending;
mod common;
mod depth;
mod expect;
mod findings;
mod geometry;
mod lighting;
mod lines_points;
mod masks;
mod meshes;
mod page;
pub mod plots;
mod run;
mod special;
mod texturing;

use serde::Serialize;

use crate::frame::Frame;
use crate::oracle::Counts;
use crate::oracle::values::ValueError;
use crate::recording::Recording;

pub use run::{Options, main};

/// What the oracle says of one or more images.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Score {
    /// Coverage.
    pub counts: Counts,
    /// Samples inside a mesh without gaps that nothing hit.
    pub holes: u64,
    /// Samples inside such a mesh that were hit more than once.
    pub doubles: u64,
    /// Colour components where they are defined, in 1/255. Correctly rounded values are off by up to 0.5.
    pub color: ValueError,
    /// Depths where they are defined, in units in the last place of the buffer.
    pub depth: ValueError,
}

impl Score {
    fn merge(&mut self, other: &Score) {
        let (to, from) = (&mut self.counts, &other.counts);
        to.samples += from.samples;
        to.must += from.must;
        to.may += from.may;
        to.wrong += from.wrong;
        to.beyond += from.beyond;
        to.off_rule += from.off_rule;
        self.holes += other.holes;
        self.doubles += other.doubles;
        self.color.merge(&other.color);
        self.depth.merge(&other.depth);
    }
}

/// One image: how it is drawn, how it is judged.
pub struct Case {
    /// What is played.
    pub recording: Recording,
    /// What is said of the result.
    pub judge: Box<dyn Fn(&Frame) -> Score>,
}

/// A generator of cases.
pub struct Family {
    /// Its name.
    pub name: &'static str,
    /// What is hard about it and how it is judged.
    pub about: &'static str,
    /// What the severity is, with its unit.
    pub knob: &'static str,
    /// From harmless to brutal.
    pub severities: &'static [f64],
    /// Whether everything lies in the range of window coordinates that Tepui promises (-16384 to 32767), and the eye outside.
    pub inside: fn(f64) -> bool,
    /// The cases of a severity for a seed.
    pub make: fn(f64, u64) -> Vec<Case>,
}

/// Every family.
pub fn families() -> Vec<Family> {
    [
        geometry::families(),
        meshes::families(),
        depth::families(),
        blending::families(),
        lighting::families(),
        texturing::families(),
        lines_points::families(),
        masks::families(),
        special::families(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_are_at_least_sixteen_families_with_names_of_their_own() {
        let mut names: Vec<&str> = families().iter().map(|f| f.name).collect();
        names.sort_unstable();
        names.dedup();
        assert!(names.len() >= 16 && names.len() == families().len());
    }

    #[test]
    fn the_same_seed_gives_the_same_recordings_and_another_seed_others() {
        for family in families() {
            let bytes = |seed: u64| -> Vec<Vec<u8>> {
                (family.make)(family.severities[0], seed).iter().map(|c| c.recording.bytes().to_vec()).collect()
            };
            assert!(bytes(1) == bytes(1), "{}", family.name);
            assert!(bytes(1) != bytes(2), "{}", family.name);
        }
    }
}
