//! Exact clipping of a convex polygon by the view volume and the user clip planes, in homogeneous integers: a new vertex is
//! `a * -d(b) + b * d(a)`, which needs no division.

use num_bigint::{BigInt, Sign};

use super::exact::{Homogeneous, USER};

/// Distance from plane `k`: six of the view volume, then the user's.
fn distance(v: &Homogeneous, k: usize) -> BigInt {
    match k {
        0..6 if k.is_multiple_of(2) => &v[3] - &v[k / 2],
        0..6 => &v[3] + &v[k / 2],
        _ => v[USER + k - 6].clone(),
    }
}

fn inside(d: &BigInt) -> bool {
    d.sign() != Sign::Minus
}

/// What is left of the polygon, and whether anything was cut away.
pub fn polygon(mut vertices: Vec<Homogeneous>) -> (Vec<Homogeneous>, bool) {
    let planes = 6 + vertices.first().map_or(0, |v| v.len() - USER);
    let mut cut = false;
    for plane in 0..planes {
        let distances: Vec<BigInt> = vertices.iter().map(|v| distance(v, plane)).collect();
        if distances.iter().all(inside) {
            continue;
        }
        cut = true;
        let mut next = Vec::new();
        for i in 0..vertices.len() {
            let j = (i + 1) % vertices.len();
            let (a, b, da, db) = (&vertices[i], &vertices[j], &distances[i], &distances[j]);
            if inside(da) {
                next.push(a.clone());
            }
            if inside(da) != inside(db) {
                // Weights of both ends are made positive, so that w keeps its sign.
                let (wa, wb) = if inside(da) { (-db, da.clone()) } else { (db.clone(), -da) };
                next.push(a.iter().zip(b).map(|(a, b)| a * &wa + b * &wb).collect());
            }
        }
        vertices = next;
        if vertices.is_empty() {
            break;
        }
    }
    // A polygon that only touches the eye point has no place on the screen.
    vertices.retain(|v| v[3].sign() == Sign::Plus);
    (vertices, cut)
}

#[cfg(test)]
mod tests {
    use super::super::exact::ratio;
    use super::*;

    fn vertex(v: [i64; 4]) -> Homogeneous {
        v.into_iter().chain([1]).map(BigInt::from).collect()
    }

    fn places(polygon: &[Homogeneous]) -> Vec<[f64; 2]> {
        polygon.iter().map(|v| [ratio(&v[0], &v[3]), ratio(&v[1], &v[3])]).collect()
    }

    #[test]
    fn what_is_inside_stays_as_it_is() {
        let triangle = vec![vertex([-1, -1, 0, 2]), vertex([1, -1, 0, 2]), vertex([0, 1, 0, 2])];
        assert_eq!(polygon(triangle.clone()), (triangle, false));
    }

    #[test]
    fn a_corner_is_cut_where_it_should_be() {
        // (-1,0) (3,0) (-1,1): the plane x = w cuts the long sides at (1,0) and (1, 0.5).
        let (left, cut) = polygon(vec![vertex([-1, 0, 0, 1]), vertex([3, 0, 0, 1]), vertex([-1, 1, 0, 1])]);
        assert!(cut);
        assert_eq!(places(&left), [[-1.0, 0.0], [1.0, 0.0], [1.0, 0.5], [-1.0, 1.0]]);
        assert!(left.iter().all(|v| v[3] == v[4]), "w stays one");
    }

    #[test]
    fn a_triangle_with_a_vertex_behind_the_eye_keeps_its_front() {
        // In front at x = 0, behind at w = -1: what is left has w > 0 everywhere and reaches the near plane.
        let (left, cut) = polygon(vec![vertex([-1, 0, 0, 2]), vertex([1, 0, 0, 2]), vertex([0, 1, -3, -1])]);
        assert!(cut && left.len() == 4);
        assert!(left.iter().all(|v| v[3].sign() == Sign::Plus));
        assert!(left.iter().any(|v| (&v[2] + &v[3]).sign() == Sign::NoSign));
    }

    #[test]
    fn user_planes_cut_as_well() {
        let with = |v: [i64; 4], d: i64| v.into_iter().chain([1, d]).map(BigInt::from).collect::<Homogeneous>();
        let (left, _) = polygon(vec![with([-1, 0, 0, 1], -1), with([1, 0, 0, 1], 1), with([1, 1, 0, 1], 1)]);
        assert_eq!(places(&left).first(), Some(&[0.0, 0.0]));
        assert_eq!(left.len(), 4);
    }
}
