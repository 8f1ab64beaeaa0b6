//! Says what a mesh is made of and how its cover came out: `cover FILE UNIT FACETS [x0 y0 z0 x1 y1 z1]`, lengths of the
//! crop box in metres.

use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use mesh::{Cover, CoverSettings, Deviation, Solid, TriangleMesh};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &[String]) -> Result<(), String> {
    let [file, unit, facets, crop @ ..] = arguments else {
        return Err("usage: cover FILE UNIT FACETS [x0 y0 z0 x1 y1 z1]".to_owned());
    };
    let scale = match unit.as_str() {
        "m" => 1.0,
        "mm" => 1e-3,
        "in" => 0.0254,
        _ => return Err(format!("unit {unit}: use m, mm or in")),
    };
    let crop: Vec<f64> =
        crop.iter().map(|word| word.parse()).collect::<Result<_, _>>().map_err(|error| format!("crop: {error}"))?;
    let crop = match crop[..] {
        [] => None,
        [x0, y0, z0, x1, y1, z1] => Some([[x0, y0, z0], [x1, y1, z1]]),
        _ => return Err("a crop box has six numbers".to_owned()),
    };
    let facets = facets.parse().map_err(|_| format!("facets {facets}: a whole number is needed"))?;
    let start = Instant::now();
    let refused = |error: mesh::MeshError| error.to_string();
    let mesh = TriangleMesh::read(Path::new(file), scale).map_err(refused)?;
    let solid = Solid::of(&mesh).map_err(refused)?;
    describe(&mesh, &solid);
    println!("seconds to read: {:.2}", start.elapsed().as_secs_f64());
    let start = Instant::now();
    let cover = Cover::of(&solid, &CoverSettings { facets, crop, ..CoverSettings::default() }).map_err(refused)?;
    let covered = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let deviation = Deviation::measure(&solid, &cover);
    let rows: Vec<usize> = cover.pieces().iter().map(|piece| piece.normals.len()).collect();
    let cuts: usize = cover.pieces().iter().flat_map(|piece| &piece.is_surface).filter(|surface| !**surface).count();
    println!("{} pieces, halfspaces {rows:?} ({} in all, {cuts} cuts)", rows.len(), rows.iter().sum::<usize>());
    println!(
        "deviation (um): mesh to cover {:.2}, cover to mesh {:.2}, uncovered {:.3}; volume (mm^3): missing {:.3}, outside {:.3}, +- {:.3}",
        1e6 * deviation.mesh_to_cover,
        1e6 * deviation.cover_to_mesh,
        1e6 * deviation.uncovered,
        1e9 * deviation.missing_volume,
        1e9 * deviation.outside_volume,
        1e9 * deviation.volume_error
    );
    println!("seconds to cover {covered:.2}, to check {:.2}", start.elapsed().as_secs_f64());
    let errors = cover.curved_surfaces().iter().map(|(surface, facets)| (surface, surface.error(*facets)));
    if let Some((worst, error)) = errors.max_by(|one, other| one.1.total_cmp(&other.1)) {
        println!(
            "largest error of facets {:.2} um, radius {:.3} mm",
            1e6 * error,
            1e3 * worst.radii[0].max(worst.radii[1])
        );
    }
    Ok(())
}

fn describe(mesh: &TriangleMesh, solid: &Solid) {
    println!(
        "{} triangles, {} planar faces, rounding {:.2e} m, volume {:.3} mm^3",
        mesh.triangle_count(),
        solid.face_count(),
        mesh.rounding(),
        1e9 * solid.mass_properties().volume
    );
    solid.repairs().iter().for_each(|repair| println!("repair: {repair}"));
    for surface in solid.curved_surfaces() {
        println!(
            "{:?} {} r {:.7?} mm, {:.0} deg, {} facets, error {:.2} um, axis {:.4?} mm",
            surface.kind,
            if surface.is_convex { "convex" } else { "concave" },
            surface.radii.map(|radius| 1e3 * radius),
            surface.angle.to_degrees(),
            surface.mesh_facets,
            1e6 * surface.mesh_error,
            surface.axis.map(|point| point.map(|coordinate| 1e3 * coordinate))
        );
    }
}
