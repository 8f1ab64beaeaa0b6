//! Pieces merged into fewer ones that contain them.

use collision::Polytope;
use task::algebra::dot;

/// Where points between the corners of two hulls are compared with the pieces.
const BETWEEN: [f64; 3] = [0.25, 0.5, 0.75];

/// The hull of some pieces.
#[derive(Debug, Clone)]
pub struct Merged {
    /// It contains all of them.
    pub hull: Polytope,
    /// Their indices.
    pub members: Vec<usize>,
    /// The box around the hull (m).
    bounds: [[f64; 3]; 2],
}

impl Merged {
    fn new(hull: Polytope, members: Vec<usize>) -> Self {
        Self { bounds: bounds(&hull), hull, members }
    }
}

/// Two hulls that can be merged.
struct Candidate {
    /// Their numbers.
    of: [usize; 2],
    merged: Merged,
    /// How far the hull of both is outside all pieces (m).
    deviation: f64,
}

/// Pieces of one body merged as long as no hull is more than an error (m) outside its pieces, at points between its corners;
/// those whose hull differs least from them first.
pub fn merged(pieces: &[&Polytope], error: f64) -> Vec<Merged> {
    let alone = |(index, piece): (usize, &&Polytope)| Merged::new((*piece).clone(), vec![index]);
    // Hulls keep their numbers; those that were merged are gone.
    let mut hulls: Vec<Option<Merged>> = pieces.iter().enumerate().map(alone).map(Some).collect();
    let mut candidates: Vec<Candidate> = Vec::new();
    for number in 0..hulls.len() {
        candidates.extend(with_earlier(&hulls, number, pieces, error));
    }
    while let Some(best) = best(&candidates) {
        let Candidate { of, merged, .. } = candidates.swap_remove(best);
        candidates.retain(|candidate| candidate.of.iter().all(|number| !of.contains(number)));
        of.into_iter().for_each(|number| hulls[number] = None);
        hulls.push(Some(merged));
        candidates.extend(with_earlier(&hulls, hulls.len() - 1, pieces, error));
    }
    hulls.into_iter().flatten().collect()
}

/// Index of the candidate with the smallest deviation, of equal ones the first two hulls.
fn best(candidates: &[Candidate]) -> Option<usize> {
    let order = |one: &Candidate, other: &Candidate| {
        one.deviation.total_cmp(&other.deviation).then_with(|| one.of.cmp(&other.of))
    };
    let best = candidates.iter().enumerate().min_by(|(_, one), (_, other)| order(one, other));
    best.map(|(index, _)| index)
}

/// The hull of a number with each earlier one that it can be merged with.
fn with_earlier(
    hulls: &[Option<Merged>],
    number: usize,
    pieces: &[&Polytope],
    error: f64,
) -> impl Iterator<Item = Candidate> {
    let own = hulls[number].as_ref();
    hulls[..number].iter().enumerate().filter_map(move |(earlier, other)| {
        let (own, other) = (own?, other.as_ref()?);
        if !meet(&own.bounds, &other.bounds, error) {
            return None;
        }
        let members = [&other.members[..], &own.members].concat();
        let deviation = deviation(&own.hull, &other.hull, &members, pieces, error)?;
        let corners = [own.hull.vertices(), other.hull.vertices()].concat();
        let hull = Polytope::from_vertices(&corners).ok()?;
        Some(Candidate { of: [earlier, number], merged: Merged::new(hull, members), deviation })
    })
}

/// How far (m) points between the corners of two hulls are outside all of some pieces, unless more than an error.
fn deviation(one: &Polytope, other: &Polytope, members: &[usize], pieces: &[&Polytope], error: f64) -> Option<f64> {
    let mut most = 0.0_f64;
    for corner in one.vertices() {
        for opposite in other.vertices() {
            for share in BETWEEN {
                let point = std::array::from_fn(|axis| corner[axis] + share * (opposite[axis] - corner[axis]));
                let outside =
                    members.iter().map(|&member| outside(pieces[member], &point)).fold(f64::INFINITY, f64::min);
                if outside > error {
                    return None;
                }
                most = most.max(outside);
            }
        }
    }
    Some(most)
}

/// How far (m) a point is beyond a halfspace of a polytope; zero inside.
fn outside(polytope: &Polytope, point: &[f64; 3]) -> f64 {
    let heights = polytope.normals().iter().zip(polytope.offsets()).map(|(normal, offset)| dot(normal, point) - offset);
    heights.fold(0.0, f64::max)
}

/// Smallest and largest coordinates of a polytope (m).
fn bounds(polytope: &Polytope) -> [[f64; 3]; 2] {
    let corners = || polytope.vertices().iter();
    [f64::min as fn(f64, f64) -> f64, f64::max].map(|extreme| {
        std::array::from_fn(|axis| corners().map(|corner| corner[axis]).reduce(extreme).unwrap_or(f64::NAN))
    })
}

/// Whether two boxes are no farther apart than a distance (m) along any axis.
fn meet([low, high]: &[[f64; 3]; 2], [other_low, other_high]: &[[f64; 3]; 2], distance: f64) -> bool {
    (0..3).all(|axis| low[axis] <= other_high[axis] + distance && other_low[axis] <= high[axis] + distance)
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNTURNED: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

    fn cuboid(edges: [f64; 3], place: [f64; 3]) -> Polytope {
        Polytope::from_box(edges).unwrap().placed(place, UNTURNED)
    }

    fn members(merged: &[Merged]) -> Vec<&[usize]> {
        let mut members: Vec<&[usize]> = merged.iter().map(|merged| &merged.members[..]).collect();
        members.sort();
        members
    }

    /// Sectors of a ring of some inner and outer radius (m), 0.01 m high.
    fn ring(sectors: usize, inner: f64, outer: f64) -> Vec<Polytope> {
        let corner = |sector: usize, radius: f64, height: f64| {
            let angle = std::f64::consts::TAU * sector as f64 / sectors as f64;
            [radius * angle.cos(), radius * angle.sin(), height]
        };
        let sector = |sector: usize| {
            let corners = [sector, sector + 1].into_iter().flat_map(|end| {
                [inner, outer].into_iter().flat_map(move |radius| [0.0, 0.01].map(|height| corner(end, radius, height)))
            });
            Polytope::from_vertices(&corners.collect::<Vec<_>>()).unwrap()
        };
        (0..sectors).map(sector).collect()
    }

    #[test]
    fn halves_of_a_box_are_merged_and_sides_of_a_corner_are_not() {
        let one = cuboid([0.1; 3], [0.0; 3]);
        let halves = [one.clone(), cuboid([0.1; 3], [0.1, 0.0, 0.0])];
        let both = merged(&halves.each_ref(), 1e-9);
        assert_eq!(members(&both), [[0, 1]]);
        assert_eq!((both[0].hull.vertices().len(), both[0].hull.normals().len()), (8, 6));
        // The hull of an L is outside it at the middle of its diagonal, 0.05 m from either side.
        let sides = [cuboid([0.1, 0.3, 0.1], [0.0; 3]), cuboid([0.3, 0.1, 0.1], [0.2, -0.1, 0.0])];
        assert_eq!(merged(&sides.each_ref(), 0.02).len(), 2);
        assert_eq!(merged(&sides.each_ref(), 0.2).len(), 1);
        // Boxes that do not meet stay apart.
        assert_eq!(merged(&[&one, &cuboid([0.1; 3], [0.0, 0.0, 1.0])], 0.02).len(), 2);
    }

    /// Two sectors of a ring take its sagitta from the hole.
    #[test]
    fn sectors_of_a_ring_are_merged_within_their_sagitta() {
        let sectors = ring(24, 0.01, 0.02);
        let pieces: Vec<&Polytope> = sectors.iter().collect();
        let sagitta = 0.01 * (1.0 - (std::f64::consts::TAU / 24.0).cos());
        assert_eq!(merged(&pieces, 0.9 * sagitta).len(), 24);
        let pairs = merged(&pieces, 1.1 * sagitta);
        // One whose neighbours are merged with their other neighbours stays alone.
        assert!((12..=16).contains(&pairs.len()), "{}", pairs.len());
        assert!(pairs.iter().all(|pair| pair.members.len() <= 2));
        for Merged { hull, members, .. } in merged(&pieces, 1e-3) {
            let corners = members.iter().flat_map(|&member| pieces[member].vertices());
            assert!(corners.into_iter().all(|corner| outside(&hull, corner) < 1e-9), "it contains its members");
            let inside = |angle: f64| [0.0088 * angle.cos(), 0.0088 * angle.sin(), 0.005];
            let free = (0..360).map(|degrees| inside(f64::from(degrees).to_radians()));
            assert!(free.into_iter().all(|point| outside(&hull, &point) > 0.0), "it leaves the hole open");
        }
    }
}
