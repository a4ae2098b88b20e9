//! Primitive assembly: ten primitive types become points, lines and triangles (2.6.1).
//!
//! The last vertex of each primitive provokes, a polygon's first one. The order of the vertices inside a triangle decides
//! from which vertex its planes start, and quads are not planar in general: both follow Mesa, so that images are equal to
//! the bit. Incomplete primitives are dropped.

use crate::raster::layout::*;

/// A primitive type, in GL's numbering.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
#[allow(missing_docs)]
pub enum PrimitiveType {
    Points = 0,
    Lines = 1,
    LineLoop = 2,
    LineStrip = 3,
    Triangles = 4,
    TriangleStrip = 5,
    TriangleFan = 6,
    Quads = 7,
    QuadStrip = 8,
    Polygon = 9,
}

impl PrimitiveType {
    /// From a GL enum.
    pub fn from_gl(mode: u32) -> Option<PrimitiveType> {
        use PrimitiveType::*;
        [Points, Lines, LineLoop, LineStrip, Triangles, TriangleStrip, TriangleFan, Quads, QuadStrip, Polygon].get(mode as usize).copied()
    }

    /// What it is after assembly: `topology::*`.
    pub fn topology(self) -> u32 {
        use PrimitiveType::*;
        match self {
            Points => topology::POINTS,
            Lines | LineLoop | LineStrip => topology::LINES,
            _ => topology::TRIANGLES,
        }
    }
}

/// How quads become triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum QuadSplit {
    /// Along vertices 0 and 2: Mesa's way with smooth vertices that it need not touch.
    #[default]
    Diagonal02,
    /// Along vertices 1 and 3: flat shading, indexed draws, display lists.
    Diagonal13,
    /// Like `Diagonal13`, and quad strips in the order of Mesa's unfilled and stippled polygons.
    Decomposed,
}

/// How polygons become triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Decomposition {
    /// Diagonals of quads.
    pub quads: QuadSplit,
    /// Edge flags count in strips and fans as well. Mesa has it so; by 2.6.2 all edges there are boundaries.
    pub flagged_strips: bool,
}

/// Which part of a Begin/End pair a run of vertices is. The default is all of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Part {
    /// Vertices were drawn before; the run starts with the carried ones (see [`carry`]).
    pub continued: bool,
    /// More vertices follow.
    pub continues: bool,
}

/// What assembly needs besides the vertices.
#[derive(Clone, Copy, Debug)]
pub struct Assembly {
    /// Type.
    pub mode: PrimitiveType,
    /// Part of the pair.
    pub part: Part,
    /// Into triangles.
    pub decomposition: Decomposition,
    /// Index of the draw, for the records.
    pub draw: u32,
}

/// All edges of a triangle are boundary edges.
const ALL_EDGES: u32 = PRIM_EDGE_01 | PRIM_EDGE_12 | PRIM_EDGE_20;

impl Assembly {
    /// What [`run`](Self::run) makes of independent triangles that are a list of vertex numbers, with all edges: `shift` is added to
    /// each. Most draws with indices are such, and without closures it is several times faster.
    pub fn listed_triangles(&self, list: &[u32], shift: u32, out: &mut Vec<Primitive>) {
        let draw_and_flags = self.draw | ALL_EDGES | PRIM_RESET_STIPPLE;
        let (triangles, _) = list.as_chunks::<3>();
        out.extend(
            triangles
                .iter()
                .map(|[a, b, c]| Primitive { v: [a.wrapping_add(shift), b.wrapping_add(shift), c.wrapping_add(shift)], draw_and_flags }),
        );
    }

    /// Assembles `count` vertices; `vertex` gives the number of the i-th one, `edge` its edge flag.
    #[inline]
    pub fn run(&self, count: u32, vertex: impl Fn(u32) -> u32, edge: impl Fn(u32) -> bool, out: &mut Vec<Primitive>) {
        let draw = self.draw;
        let Part { continued, continues } = self.part;
        let flag = |i: u32, bit: u32| if edge(i) { bit } else { 0 };
        let Decomposition { quads, flagged_strips } = self.decomposition;
        // The edges from vertices of a triangle of a strip or fan.
        let strip = |v: [u32; 3]| {
            let bits = [PRIM_EDGE_01, PRIM_EDGE_12, PRIM_EDGE_20];
            (0..3).map(|k| if flagged_strips { flag(v[k], bits[k]) } else { bits[k] }).sum::<u32>()
        };
        let point = |a: u32| Primitive { v: [vertex(a), 0, 0], draw_and_flags: draw };
        let line = |a: u32, b: u32, flags: u32| Primitive { v: [vertex(a), vertex(b), 0], draw_and_flags: draw | flags };
        let triangle =
            |a: u32, b: u32, c: u32, flags: u32| Primitive { v: [vertex(a), vertex(b), vertex(c)], draw_and_flags: draw | flags };
        match self.mode {
            PrimitiveType::Points => out.extend((0..count).map(point)),
            PrimitiveType::Lines => out.extend((0..count / 2).map(|k| line(2 * k, 2 * k + 1, PRIM_RESET_STIPPLE))),
            PrimitiveType::LineStrip => {
                out.extend((1..count).map(|i| line(i - 1, i, if i == 1 && !continued { PRIM_RESET_STIPPLE } else { 0 })));
            }
            PrimitiveType::LineLoop => {
                // A continued loop starts with its first vertex, kept for the end, and the last one drawn.
                let first = if continued { 2 } else { 1 };
                out.extend((first..count).map(|i| line(i - 1, i, if i == 1 { PRIM_RESET_STIPPLE } else { 0 })));
                if !continues && count >= 2 {
                    out.push(line(count - 1, 0, 0));
                }
            }
            PrimitiveType::Triangles => {
                out.extend((0..count / 3).map(|k| {
                    let i = 3 * k;
                    let flags = flag(i, PRIM_EDGE_01) | flag(i + 1, PRIM_EDGE_12) | flag(i + 2, PRIM_EDGE_20);
                    triangle(i, i + 1, i + 2, flags | PRIM_RESET_STIPPLE)
                }));
            }
            PrimitiveType::TriangleStrip => {
                out.extend((2..count).map(|i| {
                    let odd = i & 1;
                    let v = [i + odd - 2, i - odd - 1, i];
                    triangle(v[0], v[1], v[2], strip(v) | PRIM_RESET_STIPPLE)
                }));
            }
            PrimitiveType::TriangleFan => {
                out.extend((2..count).map(|i| triangle(0, i - 1, i, strip([0, i - 1, i]) | PRIM_RESET_STIPPLE)));
            }
            PrimitiveType::Quads => {
                out.reserve(count as usize / 2);
                for k in 0..count / 4 {
                    let i = 4 * k;
                    let [e0, e1, e2, e3] = [edge(i), edge(i + 1), edge(i + 2), edge(i + 3)];
                    let bits = |a: bool, b: bool, c: bool| {
                        (if a { PRIM_EDGE_01 } else { 0 }) | (if b { PRIM_EDGE_12 } else { 0 }) | (if c { PRIM_EDGE_20 } else { 0 })
                    };
                    if quads == QuadSplit::Diagonal02 {
                        out.push(triangle(i, i + 1, i + 2, bits(e0, e1, false) | PRIM_RESET_STIPPLE));
                        out.push(triangle(i, i + 2, i + 3, bits(false, e2, e3)));
                    } else {
                        out.push(triangle(i, i + 1, i + 3, bits(e0, false, e3) | PRIM_RESET_STIPPLE));
                        out.push(triangle(i + 1, i + 2, i + 3, bits(e1, e2, false)));
                    }
                }
            }
            PrimitiveType::QuadStrip => {
                for k in 0..(count / 2).saturating_sub(1) {
                    let i = 2 * k + 3;
                    if quads == QuadSplit::Decomposed {
                        out.push(triangle(i - 1, i - 3, i, PRIM_EDGE_01 | PRIM_EDGE_20 | PRIM_RESET_STIPPLE));
                        out.push(triangle(i - 3, i - 2, i, PRIM_EDGE_01 | PRIM_EDGE_12));
                    } else {
                        out.push(triangle(i - 3, i - 2, i, PRIM_EDGE_01 | PRIM_EDGE_12 | PRIM_RESET_STIPPLE));
                        out.push(triangle(i - 1, i - 3, i, PRIM_EDGE_01 | PRIM_EDGE_20));
                    }
                }
            }
            PrimitiveType::Polygon => {
                for i in 2..count {
                    // The edge from the first vertex belongs to the first triangle, the one back to it to the last.
                    let mut flags = flag(i - 1, PRIM_EDGE_01);
                    if i == 2 {
                        flags |= PRIM_RESET_STIPPLE | if continued { 0 } else { flag(0, PRIM_EDGE_20) };
                    }
                    if i + 1 == count && !continues {
                        flags |= flag(i, PRIM_EDGE_12);
                    }
                    out.push(triangle(i - 1, i, 0, flags));
                }
            }
        }
    }
}

/// When a run of `count` vertices is drawn before its End: how many of them to draw now, and which to carry to the next run.
pub fn carry(mode: PrimitiveType, count: u32) -> (u32, [Option<u32>; 3]) {
    use PrimitiveType::*;
    let tail = |from: u32| {
        let mut carried = [None; 3];
        for (slot, i) in carried.iter_mut().zip(from..count) {
            *slot = Some(i);
        }
        carried
    };
    let last = count.saturating_sub(1);
    match mode {
        Points => (count, [None; 3]),
        Lines => (count & !1, tail(count & !1)),
        Triangles => (count / 3 * 3, tail(count / 3 * 3)),
        Quads => (count & !3, tail(count & !3)),
        LineStrip => (count, tail(last)),
        // Strips keep their parity.
        TriangleStrip | QuadStrip if count < 2 => (0, tail(0)),
        TriangleStrip | QuadStrip => (count & !1, tail((count & !1) - 2)),
        LineLoop | TriangleFan | Polygon if count < 2 => (0, tail(0)),
        LineLoop | TriangleFan | Polygon => (count, [Some(0), Some(last), None]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assemble(mode: PrimitiveType, count: u32, quads: QuadSplit) -> Vec<[u32; 3]> {
        let mut out = Vec::new();
        Assembly { mode, part: Part::default(), decomposition: Decomposition { quads, ..Default::default() }, draw: 0 }.run(
            count,
            |i| i,
            |_| true,
            &mut out,
        );
        out.iter().map(|p| p.v).collect()
    }

    #[test]
    fn incomplete_primitives_are_dropped() {
        use PrimitiveType::*;
        for (mode, count, expected) in [
            (Lines, 3, 1),
            (LineStrip, 1, 0),
            (LineLoop, 1, 0),
            (Triangles, 5, 1),
            (TriangleStrip, 2, 0),
            (Quads, 7, 2),
            (QuadStrip, 5, 2),
            (Polygon, 2, 0),
        ] {
            assert_eq!(assemble(mode, count, QuadSplit::Diagonal02).len(), expected, "{mode:?}");
        }
    }

    #[test]
    fn edge_flags_count_in_fans_where_asked() {
        for (flagged_strips, boundaries) in [(false, 9), (true, 7)] {
            let mut out = Vec::new();
            let decomposition = Decomposition { flagged_strips, ..Default::default() };
            let assembly = Assembly { mode: PrimitiveType::TriangleFan, part: Part::default(), decomposition, draw: 0 };
            // Vertex 3 belongs to the second and the third triangle.
            assembly.run(5, |i| i, |i| i != 3, &mut out);
            assert_eq!(out.iter().map(|p| (p.draw_and_flags & ALL_EDGES).count_ones()).sum::<u32>(), boundaries);
        }
    }

    #[test]
    fn listed_triangles_are_those_of_a_run() {
        let list = [7, 9, 8, 9, 9, 12, 7, 10, 11, 8];
        let assembly = Assembly { mode: PrimitiveType::Triangles, part: Part::default(), decomposition: Decomposition::default(), draw: 5 };
        let (mut run, mut listed) = (Vec::new(), Vec::new());
        assembly.run(list.len() as u32, |i| list[i as usize] - 7 + 100, |_| true, &mut run);
        assembly.listed_triangles(&list, 100 - 7, &mut listed);
        assert_eq!(run, listed);
        assert_eq!(listed.len(), 3);
    }

    #[test]
    fn the_last_vertex_provokes_and_a_polygons_first() {
        use PrimitiveType::*;
        assert_eq!(assemble(TriangleStrip, 5, QuadSplit::Diagonal02), [[0, 1, 2], [2, 1, 3], [2, 3, 4]]);
        assert_eq!(assemble(TriangleFan, 4, QuadSplit::Diagonal02), [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(assemble(Polygon, 5, QuadSplit::Diagonal02), [[1, 2, 0], [2, 3, 0], [3, 4, 0]]);
        assert_eq!(assemble(Quads, 4, QuadSplit::Diagonal13), [[0, 1, 3], [1, 2, 3]]);
    }

    #[test]
    fn a_polygon_has_only_its_outline_as_edges() {
        let mut out = Vec::new();
        let assembly = Assembly { mode: PrimitiveType::Polygon, part: Part::default(), decomposition: Decomposition::default(), draw: 0 };
        assembly.run(5, |i| i, |_| true, &mut out);
        let edges: u32 = out.iter().map(|p| (p.draw_and_flags & (PRIM_EDGE_01 | PRIM_EDGE_12 | PRIM_EDGE_20)).count_ones()).sum();
        assert_eq!(edges, 5);
    }

    /// Drawing in parts gives the same primitives as drawing at once.
    #[test]
    fn parts_make_the_whole() {
        for mode in 0..10 {
            let mode = PrimitiveType::from_gl(mode).unwrap();
            for total in 0..40u32 {
                for limit in [6, 7, 12] {
                    let mut parts = Vec::new();
                    let (mut run, mut continued) = (Vec::new(), false);
                    for i in 0..total {
                        run.push(i);
                        if run.len() == limit {
                            let (now, carried) = carry(mode, run.len() as u32);
                            let part = Part { continued, continues: true };
                            let assembly = Assembly { mode, part, decomposition: Decomposition::default(), draw: 0 };
                            assembly.run(now, |i| run[i as usize], |_| true, &mut parts);
                            run = carried.iter().flatten().map(|&i| run[i as usize]).collect();
                            continued = true;
                        }
                    }
                    let part = Part { continued, continues: false };
                    let assembly = Assembly { mode, part, decomposition: Decomposition::default(), draw: 0 };
                    assembly.run(run.len() as u32, |i| run[i as usize], |_| true, &mut parts);
                    let mut whole = Vec::new();
                    Assembly { part: Part::default(), ..assembly }.run(total, |i| i, |_| true, &mut whole);
                    let vertices = |list: &[Primitive]| list.iter().map(|p| p.v).collect::<Vec<_>>();
                    assert_eq!(vertices(&parts), vertices(&whole), "{mode:?} {total} {limit}");
                    let resets = |list: &[Primitive]| list.iter().filter(|p| p.draw_and_flags & PRIM_RESET_STIPPLE != 0).count();
                    if mode.topology() == topology::LINES {
                        assert_eq!(resets(&parts), resets(&whole), "{mode:?} {total} {limit}");
                    }
                }
            }
        }
    }
}
