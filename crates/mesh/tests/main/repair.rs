//! What is repaired and what is refused.

use std::path::Path;

use crate::shapes::{
    CROSS, Shape, block_with_hole, chamfered_peg, countersunk_block, cube, prism, rotation, square, stack, tube,
};
use mesh::{Cover, CoverSettings, Deviation, MeshError, Repair, Solid, TriangleMesh};

fn assert_volume(solid: &Solid, cubic_millimetres: f64) {
    let volume = solid.mass_properties().volume;
    assert!((volume * 1e9 - cubic_millimetres).abs() < 1e-6 * cubic_millimetres, "{volume}");
}

fn refused(shape: &Shape) -> MeshError {
    Solid::of(&shape.mesh()).unwrap_err()
}

/// A cube of triangles.
fn triangles() -> Shape {
    let mut shape = cube(10.0);
    shape.polygons = shape.polygons.iter().flat_map(|p| [vec![p[0], p[1], p[2]], vec![p[0], p[2], p[3]]]).collect();
    shape
}

#[test]
fn a_good_mesh_needs_no_repairs() {
    let solid = triangles().solid();
    assert_eq!((solid.repairs(), solid.face_count()), (&[][..], 6));
    let properties = solid.mass_properties();
    assert_volume(&solid, 1000.0);
    let moment = 1e-6 * 1e-4 / 6.0;
    for row in 0..3 {
        assert!((properties.center[row] - 5e-3).abs() < 1e-12);
        for column in 0..3 {
            let expected = if row == column { moment } else { 0.0 };
            assert!((properties.inertia[row][column] - expected).abs() < 1e-9 * moment, "{:?}", properties.inertia);
        }
    }
    let [low, high] = solid.bounding_box();
    assert_eq!(low, [0.0; 3]);
    assert!(high.iter().all(|coordinate| (coordinate - 0.01).abs() < 1e-15));
}

#[test]
fn single_triangles_are_repaired() {
    let mut inverted = triangles();
    inverted.polygons[3].reverse();
    assert_eq!(inverted.solid().repairs(), [Repair::Rewound { triangles: 1 }]);
    assert_volume(&inverted.solid(), 1000.0);

    let mut missing = triangles();
    missing.polygons.remove(5);
    let solid = missing.solid();
    let [Repair::Capped { place, edges: 3, area }] = solid.repairs() else { panic!() };
    assert!(place.iter().all(|coordinate| (0.0..=10.0).contains(coordinate)) && (area - 5e-5).abs() < 1e-12);
    assert_volume(&missing.solid(), 1000.0);

    let mut double = triangles();
    double.polygons.push(double.polygons[2].clone());
    assert_eq!(double.solid().repairs(), [Repair::Duplicates { triangles: 1 }]);
    assert_volume(&double.solid(), 1000.0);

    let mut collapsed = triangles();
    collapsed.polygons.push(vec![0, 0, 1]);
    assert_eq!(collapsed.solid().repairs(), [Repair::Collapsed { triangles: 1 }]);

    let all = triangles().inverted().solid();
    assert_eq!(all.repairs(), [Repair::Inverted { shells: 1 }]);
    assert_volume(&all, 1000.0);
}

#[test]
fn a_corner_in_the_middle_of_an_edge_is_joined() {
    let mut shape = triangles();
    let middle = shape.add(&[[5.0, 0.0, 0.0]])[0];
    let edge = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0]].map(|end| shape.vertices.iter().position(|v| *v == end).unwrap());
    let polygon = shape.polygons.iter().position(|p| edge.iter().all(|end| p.contains(end))).unwrap();
    let corners = shape.polygons.remove(polygon);
    let replaced = |end: usize| corners.iter().map(|&c| if c == end { middle } else { c }).collect::<Vec<_>>();
    shape.polygons.extend([replaced(edge[0]), replaced(edge[1])]);
    let solid = shape.solid();
    assert!(matches!(solid.repairs(), [Repair::Sewn { edges: 3, .. }]), "{:?}", solid.repairs());
    assert_volume(&solid, 1000.0);
    assert_eq!((solid.face_count(), shape.cover(24).pieces().len()), (6, 1));
}

#[test]
fn an_open_box_is_refused_with_the_place_of_its_rim() {
    let mut shape = cube(10.0);
    shape.polygons.pop();
    let MeshError::Open { place, length, edges: 4 } = refused(&shape) else { panic!("{}", refused(&shape)) };
    assert!((place[2] - 10.0).abs() < 1e-9 && (length - 40.0).abs() < 1e-6);
}

/// A cube with a blind hole of square section in its top, as cut from a file before the faces of the hole.
fn without_its_pocket(width: f64) -> Shape {
    let mut shape = cube(20.0);
    let (low, high) = (10.0 - 0.5 * width, 10.0 + 0.5 * width);
    let rim = shape.add(&[[low, low, 20.0], [high, low, 20.0], [high, high, 20.0], [low, high, 20.0]]);
    let top = shape.polygons.iter().position(|p| p.iter().all(|&corner| shape.vertices[corner][2] == 20.0)).unwrap();
    let outer = shape.polygons.remove(top);
    let nearest = |corner: usize| {
        let distance = |&one: &usize| {
            (0..2).map(|axis| (shape.vertices[one][axis] - shape.vertices[corner][axis]).powi(2)).sum::<f64>()
        };
        rim.iter().copied().min_by(|one, other| distance(one).total_cmp(&distance(other))).unwrap()
    };
    let sides: Vec<Vec<usize>> = (0..4)
        .map(|at| (outer[at], outer[(at + 1) % 4]))
        .map(|(one, next)| vec![one, next, nearest(next), nearest(one)])
        .collect();
    shape.polygons.extend(sides);
    shape
}

#[test]
fn the_mouth_of_a_lost_pocket_is_told_and_refused_where_it_is_large() {
    let solid = without_its_pocket(4.0).solid();
    let [Repair::Capped { place, edges: 4, area }] = solid.repairs() else { panic!("{:?}", solid.repairs()) };
    assert!((place[0] - 10.0).abs() < 1e-9 && (place[2] - 20.0).abs() < 1e-9 && (area - 1.6e-5).abs() < 1e-12);
    let MeshError::Open { edges: 4, .. } = refused(&without_its_pocket(8.0)) else { panic!() };
}

#[test]
fn exact_covers_of_crossing_bodies_are_refused_with_a_place_of_both() {
    let other = cube(10.0).moved([5.0, 4.0, 3.0]);
    let solid = cube(10.0).and(&other).solid();
    let refused = Cover::of(&solid, &CoverSettings::default()).unwrap_err();
    let MeshError::SelfIntersecting { place } = refused else { panic!() };
    let inside = |low: f64, coordinate: f64| coordinate >= low - 1e-6 && coordinate <= 10.0 + 1e-6;
    assert!(inside(5.0, place[0]) && inside(4.0, place[1]) && inside(3.0, place[2]), "{place:?}");
}

/// Edges may run into the diagonal between two triangles of a face, and faces may lie in one plane.
#[test]
fn bodies_that_cross_at_special_places_are_counted_once() {
    for place in [[5.0, 5.0, 5.0], [5.0, 5.0, 0.0], [5.0, 0.0, 0.0], [2.0, 8.0, 5.0], [9.0, 9.0, 9.0]] {
        let solid = cube(10.0).and(&cube(10.0).moved(place)).solid();
        assert!(solid.is_rough(), "{place:?}");
        let common: f64 = place.iter().map(|by| 10.0 - by).product();
        let volume = 1e9 * solid.mass_properties().volume;
        assert!((volume - (2000.0 - common)).abs() < 0.01 * volume, "{place:?}: {volume}");
    }
}

#[test]
fn folds_are_told_and_refused_by_exact_covers() {
    // A corner of the rim pulled through the wall of the hole below it.
    let mut shape = countersunk_block(20);
    shape.vertices[29][2] = 0.0;
    let solid = shape.solid();
    assert!(matches!(solid.repairs(), [Repair::Decided { .. }]));
    let refused = Cover::of(&solid, &CoverSettings::default()).unwrap_err();
    assert!(matches!(refused, MeshError::SelfIntersecting { .. }), "{refused}");
}

#[test]
fn three_triangles_at_an_edge_are_refused() {
    let mut shape = triangles();
    let fin = shape.add(&[[5.0, 5.0, 20.0]])[0];
    let [a, b, ..] = shape.polygons[0][..] else { panic!() };
    shape.polygons.push(vec![a, b, fin]);
    assert!(matches!(refused(&shape), MeshError::NonManifold { count: 3, .. }), "{}", refused(&shape));
}

#[test]
fn a_sheet_across_a_hole_is_dropped_and_told() {
    let open = tube(12);
    let mut shut = open.clone();
    // Over the upper mouth, with its other side out.
    shut.polygons.push((24..36).rev().collect());
    let solid = shut.solid();
    let [Repair::Sheet { place, triangles: 10 }] = solid.repairs() else { panic!("{:?}", solid.repairs()) };
    assert!((place[2] - 20.0).abs() < 1e-9 && place[0].hypot(place[1]) < 6.0, "{place:?}");
    assert!(!solid.is_rough());
    assert_volume(&solid, 1e9 * open.solid().mass_properties().volume);
}

#[test]
fn a_lid_on_a_blind_hole_which_may_as_well_be_a_void_is_refused() {
    let mut shape = block_with_hole(12, 0.0);
    shape.polygons.push((8..20).collect());
    assert!(matches!(refused(&shape), MeshError::NonManifold { count: 3, .. }), "{}", refused(&shape));
}

#[test]
fn the_wall_of_a_hole_that_was_moved_aside_is_joined_and_told() {
    let whole = block_with_hole(12, 0.0);
    let wall_moved_by = |aside: f64| {
        let mut shape = whole.clone();
        let own: Vec<[f64; 3]> = shape.vertices[8..].iter().map(|[x, y, z]| [x + aside, *y, *z]).collect();
        let first = shape.add(&own)[0];
        let is_wall = |polygon: &Vec<usize>| polygon.len() == 3 && polygon.iter().all(|&corner| corner >= 8);
        let wall = shape.polygons.iter_mut().filter(|polygon| is_wall(polygon));
        wall.flatten().for_each(|corner| *corner += first - 8);
        shape
    };
    let solid = wall_moved_by(0.04).solid();
    let [Repair::Joined { edges: 12, moved, .. }, Repair::Joined { .. }] = solid.repairs() else {
        panic!("{:?}", solid.repairs())
    };
    assert!((moved - 4e-5).abs() < 1e-8, "{moved}");
    assert!(!solid.is_rough());
    assert_volume(&solid, 1e9 * whole.solid().mass_properties().volume);
    let MeshError::Open { .. } = refused(&wall_moved_by(0.4)) else { panic!() };
}

#[test]
fn bodies_may_be_apart_touch_or_lie_in_voids() {
    let apart = cube(10.0).and(&cube(5.0).moved([20.0, 0.0, 0.0]));
    assert_volume(&apart.solid(), 1125.0);
    assert_eq!(apart.cover(24).pieces().len(), 2);
    let touching = cube(10.0).and(&cube(4.0).moved([3.0, 3.0, 10.0]));
    assert_volume(&touching.solid(), 1064.0);
    assert_eq!(touching.cover(24).pieces().len(), 2);
    let void = cube(10.0).and(&cube(4.0).moved([3.0, 3.0, 3.0]).inverted());
    assert_volume(&void.solid(), 1000.0 - 64.0);
    assert_eq!(void.cover(24).pieces().len(), 6);
    let body = void.and(&cube(2.0).moved([4.0, 4.0, 4.0]));
    assert_volume(&body.solid(), 1000.0 - 64.0 + 8.0);
    let doubled = cube(10.0).and(&cube(4.0).moved([3.0, 3.0, 3.0]));
    assert!(matches!(refused(&doubled), MeshError::Nested { .. }));
    assert!(matches!(void.inverted().solid().repairs(), [Repair::Inverted { shells: 2 }]));
}

/// All polygons of a shape also turned around.
fn two_sided(shape: &Shape) -> Shape {
    let mut both = shape.clone();
    both.polygons.extend(shape.inverted().polygons);
    both
}

#[test]
fn of_surfaces_that_are_there_twice_one_copy_stays() {
    let twice = |shape: &Shape| Shape { polygons: [&shape.polygons[..], &shape.polygons].concat(), ..shape.clone() };
    let cube = cube(10.0);
    // Bodies beside it, and that touch it on a whole side, on some of one, and with other triangles there.
    let beside = [20.0, 10.0].map(|x| cube.moved([x, 0.0, 0.0]));
    let [some, other] = [cube.moved([10.0, 3.0, 0.0]), triangles().moved([10.0, 0.0, 0.0])];
    for doubled in [twice(&cube), two_sided(&cube), twice(&two_sided(&cube)), cube.and(&cube.inverted())] {
        assert!(matches!(doubled.solid().repairs(), [Repair::Duplicates { .. }]), "{:?}", doubled.solid().repairs());
        assert_volume(&doubled.solid(), 1000.0);
        for single in beside.iter().chain([&some, &other]) {
            assert_volume(&single.and(&doubled).solid(), 2000.0);
            assert_volume(&doubled.and(single).solid(), 2000.0);
        }
        assert_volume(&doubled.and(&doubled.moved([10.0, 3.0, 0.0])).solid(), 2000.0);
        assert_volume(&doubled.and(&twice(&cube).moved([10.0, 0.0, 0.0])).solid(), 2000.0);
    }
    // A body that is there twice and touches another such one is never lost: what is not certain is refused.
    let touching = two_sided(&cube).and(&two_sided(&cube.moved([10.0, 0.0, 0.0])));
    assert!(Solid::of(&touching.mesh()).map_or(true, |solid| (solid.mass_properties().volume - 2e-6).abs() < 1e-12));
    let mut side = triangles();
    side.polygons.extend(triangles().inverted().polygons[..8].iter().cloned());
    assert_volume(&side.solid(), 1000.0);
}

#[test]
fn walls_between_bodies_go() {
    for count in [2, 3] {
        let mut block = Shape::default();
        for place in 0..count * count * count {
            let corner = [place % count, place / count % count, place / count / count].map(|at| 10.0 * f64::from(at));
            block = block.and(&cube(10.0).moved(corner));
        }
        let solid = block.solid();
        assert_eq!((solid.triangle_count() as i32, solid.face_count()), (12 * count * count, 6));
        assert_volume(&solid, 1000.0 * f64::from(count * count * count));
    }
}

#[test]
fn sheets_are_never_dropped() {
    let sheet = |half: f64| {
        let mut sheet = Shape::default();
        let corners = sheet.add(&square(half, 12.0));
        sheet.polygons.push(corners);
        sheet
    };
    for half in [0.1, 5.0] {
        for sheet in [sheet(half), two_sided(&sheet(half))] {
            let error = refused(&triangles().and(&sheet));
            assert!(matches!(error, MeshError::Open { edges: 4, .. }), "{error}");
        }
    }
    // A fin that stands on a side, with both of its sides.
    let mut fin = triangles();
    let tip = fin.add(&[[5.0, 5.0, 20.0]])[0];
    let [a, b, ..] = fin.polygons[0][..] else { panic!() };
    fin.polygons.extend([vec![a, b, tip], vec![tip, b, a]]);
    assert!(matches!(refused(&fin), MeshError::NonManifold { .. }), "{}", refused(&fin));
}

#[test]
fn triangles_without_area_go_and_those_in_gaps_stay() {
    let mut shape = triangles();
    let middle = shape.add(&[[5.0, 0.0, 0.0]])[0];
    let [a, b] = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0]].map(|end| shape.vertices.iter().position(|v| *v == end).unwrap());
    shape.polygons.push(vec![a, b, middle]);
    assert_eq!(shape.solid().repairs(), [Repair::Collapsed { triangles: 1 }]);
    assert_volume(&shape.solid(), 1000.0);
    // Between an edge and the two halves of it on its other side it closes the surface.
    let polygon = shape.polygons.iter().position(|p| p.windows(2).any(|edge| edge == [a, b])).unwrap();
    let corners = shape.polygons.remove(polygon);
    let replaced = |end: usize| corners.iter().map(|&c| if c == end { middle } else { c }).collect::<Vec<_>>();
    shape.polygons.extend([replaced(a), replaced(b)]);
    assert_eq!(shape.solid().repairs(), []);
    assert_volume(&shape.solid(), 1000.0);
}

#[test]
fn flat_meshes_are_refused() {
    let mut flat = Shape::default();
    let corners = flat.add(&square(5.0, 0.0));
    flat.polygons = vec![corners.clone(), corners.into_iter().rev().collect()];
    // Of its two sides one is left, which encloses nothing.
    assert!(matches!(refused(&flat), MeshError::Open { .. }), "{}", refused(&flat));
}

#[test]
fn polygons_of_any_shape_are_read() {
    let solid = prism(&CROSS, 7.0).solid();
    assert_volume(&solid, 500.0 * 7.0);
    assert_eq!(solid.face_count(), 14);
}

/// A binary STL file of the triangles of convex polygons.
fn stl(shape: &Shape) -> Vec<u8> {
    let mut triangles: Vec<[usize; 3]> = Vec::new();
    for polygon in &shape.polygons {
        triangles.extend((2..polygon.len()).map(|corner| [polygon[0], polygon[corner - 1], polygon[corner]]));
    }
    let mut bytes = b"solid by name only".to_vec();
    bytes.resize(80, b' ');
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for triangle in triangles {
        bytes.extend([0; 12]);
        for corner in triangle {
            shape.vertices[corner].iter().for_each(|coordinate| bytes.extend((*coordinate as f32).to_le_bytes()));
        }
        bytes.extend([0; 2]);
    }
    bytes
}

#[test]
fn binary_stl_is_read_and_welded() {
    let file = tempfile::Builder::new().suffix(".STL").tempfile().unwrap();
    let peg = chamfered_peg(72);
    let turned = Shape { vertices: peg.turned(&rotation(0.7)).vertices, ..peg };
    std::fs::write(file.path(), stl(&turned)).unwrap();
    let solid = Solid::of(&TriangleMesh::read(file.path(), 1e-3).unwrap()).unwrap();
    assert_eq!((solid.repairs(), solid.face_count()), (&[][..], 2 + 2 * 72));
    let cover = mesh::Cover::of(&solid, &CoverSettings::default()).unwrap();
    assert_eq!((cover.pieces().len(), cover.pieces()[0].normals.len()), (1, 2 + 2 * 24));
    assert!(Deviation::measure(&solid, &cover).uncovered < 1e-7);
}

#[test]
fn unusable_files_are_refused() {
    let read = |suffix: &str, content: &[u8]| {
        let file = tempfile::Builder::new().suffix(suffix).tempfile().unwrap();
        std::fs::write(file.path(), content).unwrap();
        TriangleMesh::read(file.path(), 1.0)
    };
    assert!(matches!(read(".step", b""), Err(MeshError::Format { .. })));
    assert!(matches!(read(".obj", b""), Err(MeshError::NoContent { size: 0 })));
    assert!(matches!(read(".stl", b"solid empty\nendsolid empty\n"), Err(MeshError::Empty)));
    assert!(matches!(read(".stl", b"solid x\nfacet rubbish"), Err(MeshError::Line { line: 2, .. })));
    assert!(matches!(read(".obj", b"v 0 0 0\nv 1 0 0\nv nan 0 1\nf 1 2 3\n"), Err(MeshError::Line { line: 3, .. })));
    assert!(matches!(TriangleMesh::read(Path::new("/no/such.stl"), 1.0), Err(MeshError::Read { .. })));
    let one = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    assert!(matches!(TriangleMesh::new(&one, &[[0, 1, 3]], 1.0, 0.0), Err(MeshError::Vertex { index: 1 })));
    assert!(matches!(TriangleMesh::new(&one, &[[0, 1, 2]], -1.0, 0.0), Err(MeshError::Scale { .. })));
    let many = vec![[0, 1, 2]; 200_001];
    assert!(matches!(TriangleMesh::new(&one, &many, 1.0, 0.0), Err(MeshError::TooManyTriangles { .. })));
}

#[test]
fn block_with_hole_has_its_volume() {
    let loops = [square(15.0, 0.0), square(15.0, 20.0), square(5.0, 20.0), square(5.0, 5.0)];
    assert_volume(&stack(&loops, false).solid(), 900.0 * 20.0 - 100.0 * 15.0);
    assert!(block_with_hole(5, 0.0).solid().repairs().is_empty());
}

#[test]
fn vertices_less_precise_than_they_are_written_are_welded() {
    // Triangles without common vertices, each corner off by up to 20 nm, in a file with nanometres.
    let (cube, mut soup) = (triangles(), Shape::default());
    for (index, corner) in cube.polygons.iter().flatten().enumerate() {
        let off = |axis: usize| 2e-5 * ((index * 7 + axis * 3) % 11) as f64 / 10.0;
        let vertex = cube.vertices[*corner];
        soup.vertices.push(std::array::from_fn(|axis| vertex[axis] + off(axis)));
    }
    soup.polygons = (0..cube.polygons.len()).map(|at| vec![3 * at, 3 * at + 1, 3 * at + 2]).collect();
    let triangles: Vec<[usize; 3]> = (0..soup.polygons.len()).map(|at| [3 * at, 3 * at + 1, 3 * at + 2]).collect();
    let mesh = TriangleMesh::new(&soup.vertices, &triangles, 1e-3, 5e-7).unwrap();
    let solid = Solid::of(&mesh).unwrap();
    assert!(matches!(solid.repairs(), [Repair::Welded { distance }] if *distance < 5e-7), "{:?}", solid.repairs());
    assert!(!solid.is_rough());
    assert_eq!(solid.face_count(), 6);
}
