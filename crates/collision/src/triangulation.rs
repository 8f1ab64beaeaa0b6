//! The convex hull of points as triangles, in exact arithmetic.
//!
//! Points are rounded to a grid that is far finer than any tolerance for coordinates and coarse enough for 128-bit
//! integers to hold every determinant. Coplanar, collinear and clustered points are then no special cases, and the signs
//! that decide never contradict each other.

use std::cmp::Reverse;
use std::collections::BTreeSet;

use nalgebra::Vector3;

use crate::facet::Facet;

/// Coordinates on the grid, relative to the first point, lie within `2^GRID_BITS`. The sums of products of three
/// differences then stay below `2^126`.
const GRID_BITS: i32 = 40;

/// Of more points near one triangle than this, only the first are combined in every way.
const MOST_COMBINED: usize = 40;

type GridPoint = [i64; 3];

/// Three points of a facet with the facet's plane.
pub struct Triangle {
    pub corners: [usize; 3],
    pub plane: Facet,
}

/// Three corners, counter-clockwise seen from outside, with the normal `p` and offset for which the exact height of a
/// point is `normal . p - offset`.
struct Face {
    corners: [usize; 3],
    normal: [i128; 3],
    offset: i128,
}

impl Face {
    fn new(grid: &[GridPoint], corners: [usize; 3]) -> Self {
        let [a, b, c] = corners.map(|corner| grid[corner]);
        let difference = |from: GridPoint, to: GridPoint| -> [i128; 3] {
            std::array::from_fn(|axis| i128::from(to[axis] - from[axis]))
        };
        let (u, v) = (difference(a, b), difference(a, c));
        let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        Self { corners, normal, offset: dot(&normal, &a) }
    }

    fn sees(&self, point: &GridPoint) -> bool {
        dot(&self.normal, point) > self.offset
    }

    fn edges(&self) -> [(usize, usize); 3] {
        let [a, b, c] = self.corners;
        [(a, b), (b, c), (c, a)]
    }

    fn plane(&self, points: &[Vector3<f64>]) -> Facet {
        let normal = Vector3::from(self.normal.map(|component| component as f64)).normalize();
        Facet { normal, offset: normal.dot(&points[self.corners[0]]) }
    }
}

fn dot(normal: &[i128; 3], point: &GridPoint) -> i128 {
    (0..3).map(|axis| normal[axis] * i128::from(point[axis])).sum()
}

/// Triangles of the convex hull, the planes accurate even for slivers; none when the points lie in a plane.
pub fn triangulate(points: &[Vector3<f64>]) -> Vec<Triangle> {
    let grid = rounded(points);
    let Some(simplex) = simplex(&grid) else { return Vec::new() };
    let mut faces: Vec<Face> = (0..4).map(|opposite| outward(&grid, &simplex, opposite)).collect();
    for point in scattered(points.len()) {
        let seen: Vec<Face> = faces.extract_if(.., |face| face.sees(&grid[point])).collect();
        let edges: BTreeSet<(usize, usize)> = seen.iter().flat_map(Face::edges).collect();
        let horizon = edges.iter().filter(|&&(from, to)| !edges.contains(&(to, from)));
        faces.extend(horizon.map(|&(from, to)| Face::new(&grid, [from, to, point])));
    }
    faces.iter().map(|face| Triangle { corners: face.corners, plane: face.plane(points) }).collect()
}

fn rounded(points: &[Vector3<f64>]) -> Vec<GridPoint> {
    let first = points.first().copied().unwrap_or_default();
    let extent = points.iter().map(|point| (point - first).amax()).fold(0.0, f64::max);
    let steps = 2f64.powi(GRID_BITS);
    points
        .iter()
        .map(|point| std::array::from_fn(|axis| ((point - first)[axis] / extent * steps).round() as i64))
        .collect()
}

/// Four points that are not in a plane.
fn simplex(grid: &[GridPoint]) -> Option<[usize; 4]> {
    let a = 0;
    let b = (0..grid.len()).find(|&point| grid[point] != grid[a])?;
    let c = (0..grid.len()).find(|&point| Face::new(grid, [a, b, point]).normal != [0; 3])?;
    let face = Face::new(grid, [a, b, c]);
    let d = (0..grid.len()).find(|&point| dot(&face.normal, &grid[point]) != face.offset)?;
    Some([a, b, c, d])
}

fn outward(grid: &[GridPoint], simplex: &[usize; 4], opposite: usize) -> Face {
    let [a, b, c] = [1, 2, 3].map(|step| simplex[(opposite + step) % 4]);
    let face = Face::new(grid, [a, b, c]);
    if face.sees(&grid[simplex[opposite]]) { Face::new(grid, [a, c, b]) } else { face }
}

/// Indices in an order that does not follow the shape: neighbours one after the other would see many triangles each.
fn scattered(count: usize) -> Vec<usize> {
    const GOLDEN_RATIO: u64 = 0x9E37_79B9_7F4A_7C15;
    let mut indices: Vec<usize> = (0..count).collect();
    indices.sort_by_key(|&index| Reverse((index as u64).wrapping_mul(GOLDEN_RATIO)));
    indices
}

/// The points near each triangle, and the corners of a triangle near which there are too many.
pub fn groups(triangles: &[Triangle], count: usize, is_near: impl Fn(&Facet, usize) -> bool) -> BTreeSet<Vec<usize>> {
    let mut groups = BTreeSet::new();
    for triangle in triangles {
        let near = (0..count).filter(|&point| is_near(&triangle.plane, point));
        let group: Vec<usize> = near.take(MOST_COMBINED).collect();
        if group.len() == MOST_COMBINED {
            let mut corners = triangle.corners;
            corners.sort_unstable();
            groups.insert(corners.to_vec());
        }
        groups.insert(group);
    }
    groups
}

/// All triples of points that are in a common group, in lexicographic order.
pub fn triples_within(groups: &BTreeSet<Vec<usize>>, count: usize) -> impl Iterator<Item = [usize; 3]> {
    let mut rests: Vec<Vec<&[usize]>> = vec![Vec::new(); count];
    for group in groups {
        for (place, &point) in group.iter().enumerate() {
            rests[point].push(&group[place + 1..]);
        }
    }
    rests.into_iter().enumerate().flat_map(|(first, rests)| {
        let mut pairs: Vec<[usize; 2]> = rests.into_iter().flat_map(pairs).collect();
        pairs.sort_unstable();
        pairs.dedup();
        pairs.into_iter().map(move |[second, third]| [first, second, third])
    })
}

fn pairs(points: &[usize]) -> impl Iterator<Item = [usize; 2]> {
    points.iter().enumerate().flat_map(|(place, &one)| points[place + 1..].iter().map(move |&other| [one, other]))
}
