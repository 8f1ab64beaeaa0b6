//! The outline of a body of several convex pieces, in pixels.

/// How near (pixels) edges of two pieces are that count as one.
const SAME: f64 = 0.3;

/// A point of a picture, in pixels.
pub type Point = [f64; 2];

fn minus([x, y]: Point, [u, v]: Point) -> Point {
    [x - u, y - v]
}

/// Twice the area of the triangle of the origin and two points; positive if the second is to the left of the first.
fn cross([x, y]: Point, [u, v]: Point) -> f64 {
    x * v - y * u
}

fn lerp(from: Point, to: Point, share: f64) -> Point {
    [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])]
}

/// Corners of the convex hull of some points, in one sense of rotation. Fewer than three if the points are in a line.
pub fn hull(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by(|one, other| one[0].total_cmp(&other[0]).then(one[1].total_cmp(&other[1])));
    points.dedup();
    let chain = |points: &mut dyn Iterator<Item = Point>| {
        let mut chain: Vec<Point> = Vec::new();
        for point in points {
            while let [.., before, last] = chain[..]
                && cross(minus(last, before), minus(point, before)) <= 0.0
            {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut corners = chain(&mut points.iter().copied());
    corners.extend(chain(&mut points.iter().rev().copied()));
    corners
}

/// Lines around the union of convex polygons, as [`hull`] makes them.
pub fn outline(polygons: &[Vec<Point>]) -> Vec<Vec<Point>> {
    let mut lines: Vec<Vec<Point>> = Vec::new();
    for (index, polygon) in polygons.iter().enumerate() {
        for (from, to) in edges(polygon) {
            let mut left = vec![[0.0, 1.0]];
            for (other, polygon) in polygons.iter().enumerate().filter(|(other, _)| *other != index) {
                // An edge that two polygons share is drawn with the first of them.
                if !(other > index && edges(polygon).any(|edge| is_along((from, to), edge))) {
                    left = without(&left, hidden(from, to, polygon));
                }
            }
            for [begin, end] in left {
                append(&mut lines, lerp(from, to, begin), lerp(from, to, end));
            }
        }
    }
    lines
}

fn edges(polygon: &[Point]) -> impl Iterator<Item = (Point, Point)> + '_ {
    polygon.iter().copied().zip(polygon.iter().copied().cycle().skip(1))
}

/// Distance of a point to the left of a line.
fn to_the_left((from, to): (Point, Point), point: Point) -> f64 {
    let along = minus(to, from);
    cross(along, minus(point, from)) / along[0].hypot(along[1])
}

/// Whether an edge lies on the line of another one that has the same direction.
fn is_along((from, to): (Point, Point), other: (Point, Point)) -> bool {
    let (one, two) = (minus(to, from), minus(other.1, other.0));
    let is_near = [from, to].iter().all(|&point| to_the_left(other, point).abs() < SAME);
    is_near && one[0] * two[0] + one[1] * two[1] > 0.0
}

/// The share of an edge that lies within a polygon, from where to where; an empty one if none does.
fn hidden(from: Point, to: Point, polygon: &[Point]) -> [f64; 2] {
    let [mut begin, mut end] = [0.0_f64, 1.0_f64];
    for edge in edges(polygon) {
        let (before, after) = (to_the_left(edge, from) + SAME, to_the_left(edge, to) + SAME);
        match (before >= 0.0, after >= 0.0) {
            (true, true) => {}
            (false, false) => return [0.0, 0.0],
            (false, true) => begin = begin.max(before / (before - after)),
            (true, false) => end = end.min(before / (before - after)),
        }
    }
    [begin, end.max(begin)]
}

/// What is left of intervals without another one.
fn without(intervals: &[[f64; 2]], [begin, end]: [f64; 2]) -> Vec<[f64; 2]> {
    let left = intervals.iter().flat_map(|&[from, to]| [[from, to.min(begin)], [from.max(end), to]]);
    if end > begin { left.filter(|[from, to]| to - from > 1e-9).collect() } else { intervals.to_vec() }
}

/// Adds an edge to the line that ends where it begins, or as another line.
fn append(lines: &mut Vec<Vec<Point>>, from: Point, to: Point) {
    match lines.last_mut() {
        Some(line) if line.last() == Some(&from) => line.push(to),
        _ => lines.push(vec![from, to]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(left: f64, top: f64, size: f64) -> Vec<Point> {
        hull(vec![
            [left, top],
            [left + size, top + size],
            [left, top + size],
            [left + size, top],
            [left + 0.5 * size, top + 0.5 * size],
        ])
    }

    fn length(polygons: &[Vec<Point>]) -> f64 {
        let part =
            |line: &Vec<Point>| line.windows(2).map(|two| minus(two[1], two[0])).map(|[x, y]| x.hypot(y)).sum::<f64>();
        outline(polygons).iter().map(part).sum()
    }

    #[test]
    fn outlines_leave_out_what_is_within() {
        assert_eq!(square(0.0, 0.0, 10.0).len(), 4);
        let near = |polygons: &[Vec<Point>], expected: f64| {
            let found = length(polygons);
            assert!((found - expected).abs() < 3.0, "{found}, not {expected}");
        };
        let one = || square(0.0, 0.0, 100.0);
        near(&[one()], 400.0);
        // The same twice, beside each other, shifted along an edge, across each other, one within the other.
        near(&[one(), one(), one()], 400.0);
        near(&[one(), square(100.0, 0.0, 100.0)], 600.0);
        near(&[one(), square(50.0, 0.0, 100.0)], 500.0);
        near(&[one(), square(50.0, 50.0, 100.0)], 600.0);
        near(&[square(25.0, 25.0, 50.0), one()], 400.0);
    }
}
