//! Readers of mutated files: they read or refuse them, and what they read makes sense. `MUTATIONS=100000 cargo test -p mesh
//! --test main mutat -- --nocapture` tries more than the tests do, and says how long the slowest took.

use std::time::{Duration, Instant};

use mesh::{Cover, CoverSettings, Format, Solid, TriangleMesh};

use crate::reading::random::Random;
use crate::reading::writers::WRITERS;
use crate::shapes::{Shape, block_with_hole, chamfered_peg, cube, tube};

/// Words that readers may stumble over.
const WORDS: [&str; 40] = [
    "",
    "0",
    "-1",
    "1e999",
    "-1e-999",
    "nan",
    "inf",
    "1,5",
    "1.5.5",
    "0x7f",
    "1e",
    "--1",
    "4294967296",
    "99999999999999999999",
    "solid",
    "endsolid",
    "facet",
    "endfacet",
    "outer",
    "loop",
    "endloop",
    "end",
    "vertex",
    "normal",
    "v",
    "f",
    "l",
    "p",
    "o",
    "#",
    "\\",
    "1/2/3",
    "1//",
    "-1/-1",
    "/",
    "1.0",
    "\u{feff}",
    "\u{202e}",
    "\0",
    "\r",
];
const BYTES: [u8; 10] = [0, 1, b'\n', b'\r', b' ', b'\\', b'#', 0x7f, 0x80, 0xff];

fn seeds() -> Vec<(Vec<u8>, Format)> {
    let shapes: [Shape; 5] = [
        cube(10.0),
        cube(10.0).and(&cube(10.0).moved([10.0, 0.0, 0.0])),
        tube(12),
        chamfered_peg(16),
        block_with_hole(9, 0.2),
    ];
    shapes.iter().flat_map(|shape| WRITERS.iter().map(|writer| ((writer.write)(shape), writer.format))).collect()
}

/// One change: of bytes, of words or of lines.
fn mutate(content: &mut Vec<u8>, others: &[(Vec<u8>, Format)], random: &mut Random) {
    let place = random.below(content.len().max(1));
    let end = (place + 1 + random.below(64)).min(content.len());
    let start = place.min(end);
    match random.below(10) {
        0 if !content.is_empty() => content[start] ^= 1 << random.below(8),
        1 if !content.is_empty() => content[start] = *random.pick(&BYTES),
        2 => content.truncate(place),
        3 => drop(content.drain(start..end)),
        4 => {
            let copy = content[start..end].to_vec();
            let to = random.below(content.len() + 1);
            content.splice(to..to, copy);
        }
        5 => {
            let other = &random.pick(others).0;
            let from = random.below(other.len());
            content.truncate(place);
            content.extend(&other[from..]);
        }
        6 if content.len() > 84 => {
            let counts = [0, 1, 11, 13, 255, 65_536, u32::MAX];
            content[80..84].copy_from_slice(&random.pick(&counts).to_le_bytes());
        }
        7 if content.len() > 134 => {
            // A coordinate of a binary record.
            let numbers = [0.0f32, -0.0, 1e-45, 1e-7, 5.0, 10.0, 10.000_001, 1e30, f32::NAN, f32::INFINITY];
            let records = (content.len() - 84) / 50;
            let at = 84 + 50 * random.below(records) + 12 + 4 * random.below(9);
            content[at..at + 4].copy_from_slice(&random.pick(&numbers).to_le_bytes());
        }
        8 => swap_lines(content, random),
        _ => {
            let word = content[start..].iter().position(|byte| byte.is_ascii_whitespace()).map(|at| start + at);
            content.splice(start..word.unwrap_or(end), random.pick(&WORDS).bytes());
        }
    }
}

fn swap_lines(content: &mut Vec<u8>, random: &mut Random) {
    let mut lines: Vec<Vec<u8>> = content.split(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect();
    let (one, other) = (random.below(lines.len()), random.below(lines.len()));
    match random.below(3) {
        0 => lines.swap(one, other),
        1 => lines.insert(one, lines[other].clone()),
        _ => drop(lines.remove(one)),
    }
    *content = lines.join(&b'\n');
}

/// Reads a file; whether it is a part.
fn try_all(content: &[u8], format: Format) -> bool {
    let Ok(mesh) = TriangleMesh::parse(content, format, 1e-3) else { return false };
    let Ok(solid) = Solid::of(&mesh) else { return false };
    let [low, high] = solid.bounding_box();
    let largest: f64 = (0..3).map(|axis| high[axis] - low[axis]).product();
    let volume = solid.mass_properties().volume;
    // Bodies that touch may overlap by as much as points of files are rounded.
    assert!(volume > 0.0 && volume <= largest * (1.0 + 1e-4), "{volume} in {largest}");
    if let Ok(cover) = Cover::of(&solid, &CoverSettings { facets: 8, ..CoverSettings::default() }) {
        assert!(!cover.pieces().is_empty());
    }
    true
}

fn mutations(format: Format, default: usize) {
    let given = |name: &str| std::env::var(name).ok().map(|value| value.parse::<u64>().expect("a whole number"));
    let (count, first) =
        (given("MUTATIONS").map_or(default, |count| count as usize), given("FIRST_MUTATION").unwrap_or(0));
    let seeds = seeds();
    let own: Vec<&(Vec<u8>, Format)> = seeds.iter().filter(|(_, other)| *other == format).collect();
    let mut slowest = Duration::ZERO;
    let mut parts = 0;
    for number in 0..count {
        let mut random = Random(first.wrapping_add(number as u64));
        let mut content = random.pick(&own).0.clone();
        for _ in 0..1 + random.below(4) {
            mutate(&mut content, &seeds, &mut random);
        }
        let start = Instant::now();
        parts += usize::from(try_all(&content, format));
        slowest = slowest.max(start.elapsed());
    }
    println!("{format:?}: {count} files, {parts} read as parts, slowest {slowest:?}");
    assert!(parts > 0 && parts < count, "{parts} of {count}");
}

#[test]
fn mutated_stl_files() {
    mutations(Format::Stl, 400);
}

#[test]
fn mutated_obj_files() {
    mutations(Format::Obj, 400);
}
