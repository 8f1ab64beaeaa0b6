//! Files in the styles of other programs.

use std::collections::BTreeMap;
use std::fmt::Write;

use mesh::Format;

use crate::shapes::{Point, Shape};

/// A program's way to write a file.
pub struct Writer {
    pub name: &'static str,
    pub format: Format,
    pub write: fn(&Shape) -> Vec<u8>,
}

pub const WRITERS: [Writer; 6] = [
    Writer { name: "binary STL like numpy-stl's", format: Format::Stl, write: binary_with_solid_in_its_header },
    Writer { name: "binary STL like trimesh's", format: Format::Stl, write: binary_with_zeros },
    Writer { name: "ASCII STL like numpy-stl's", format: Format::Stl, write: text_with_exponents },
    Writer { name: "ASCII STL like OpenSCAD's", format: Format::Stl, write: text_without_name },
    Writer { name: "OBJ like trimesh's", format: Format::Obj, write: obj_of_triangles },
    Writer { name: "OBJ like OpenSCAD's", format: Format::Obj, write: obj_of_polygons },
];

pub fn triangles(shape: &Shape) -> Vec<[Point; 3]> {
    let fan = |polygon: &Vec<usize>| -> Vec<[Point; 3]> {
        (2..polygon.len()).map(|at| [polygon[0], polygon[at - 1], polygon[at]].map(|c| shape.vertices[c])).collect()
    };
    shape.polygons.iter().flat_map(fan).collect()
}

fn normal([a, b, c]: &[Point; 3]) -> Point {
    let edge = |to: &Point| -> Point { std::array::from_fn(|axis| to[axis] - a[axis]) };
    let ([x, y, z], [u, v, w]) = (edge(b), edge(c));
    let normal = [y * w - z * v, z * u - x * w, x * v - y * u];
    let length = normal.iter().map(|component| component * component).sum::<f64>().sqrt();
    normal.map(|component| component / length)
}

fn binary(shape: &Shape, header: &[u8], normal: fn(&[Point; 3]) -> Point) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.resize(80, header.last().copied().unwrap_or(0));
    let triangles = triangles(shape);
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for triangle in &triangles {
        for number in normal(triangle).iter().chain(triangle.as_flattened()) {
            bytes.extend((*number as f32).to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}

pub fn binary_with_solid_in_its_header(shape: &Shape) -> Vec<u8> {
    binary(shape, b"solid numpy-stl (3.2.0) 2026-11-28 00:00:00.000000 part   ", normal)
}

pub fn binary_with_zeros(shape: &Shape) -> Vec<u8> {
    binary(shape, &[0], |_| [0.0; 3])
}

pub fn text_with_exponents(shape: &Shape) -> Vec<u8> {
    let numbers = |point: &Point| point.map(|number| format!("{:.8e}", number as f32)).join(" ");
    let mut text = "solid part\n".to_owned();
    for triangle in triangles(shape) {
        writeln!(text, "facet normal {}\n  outer loop", numbers(&normal(&triangle))).unwrap();
        triangle.iter().for_each(|corner| writeln!(text, "    vertex {}", numbers(corner)).unwrap());
        text += "  endloop\nendfacet\n";
    }
    (text + "endsolid part\n").into_bytes()
}

/// Six digits that count, as a stream of C++ has them.
fn six_digits(number: f64) -> String {
    let digits = 5 - number.abs().log10().floor().clamp(-4.0, 5.0) as i32;
    let text = format!("{number:.*}", digits.max(0) as usize);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

pub fn text_without_name(shape: &Shape) -> Vec<u8> {
    let numbers = |point: &Point| point.map(six_digits).join(" ");
    let mut text = "solid\r\n".to_owned();
    for triangle in triangles(shape) {
        write!(text, "\tFACET NORMAL {}\r\n\t\tOUTER LOOP\r\n", numbers(&normal(&triangle))).unwrap();
        triangle.iter().for_each(|corner| write!(text, "\t\t\tVERTEX {}\r\n", numbers(corner)).unwrap());
        text += "\t\tEND LOOP\r\n\tEND FACET\r\n";
    }
    (text + "endsolid").into_bytes()
}

/// Triangles that share their vertices.
pub fn obj_of_triangles(shape: &Shape) -> Vec<u8> {
    let mut known: BTreeMap<[u64; 3], usize> = BTreeMap::new();
    let (mut vertices, mut faces) = (String::new(), String::new());
    for triangle in triangles(shape) {
        let corners = triangle.map(|corner| {
            let count = known.len();
            *known.entry(corner.map(f64::to_bits)).or_insert_with(|| {
                let [x, y, z] = corner;
                writeln!(vertices, "v {x:.8} {y:.8} {z:.8}").unwrap();
                count + 1
            })
        });
        let corners = corners.map(|corner| format!("{corner}/1/1"));
        writeln!(faces, "f {}", corners.join(" ")).unwrap();
    }
    format!("# a comment\nmtllib part.mtl\nusemtl grey\n{vertices}vt 0.5\nvn 0 0 1\ns off\n{faces}").into_bytes()
}

/// Polygons with vertices of their own, counted backwards.
pub fn obj_of_polygons(shape: &Shape) -> Vec<u8> {
    let mut text = String::new();
    for (number, polygon) in shape.polygons.iter().enumerate() {
        writeln!(text, "g part{number}").unwrap();
        for &corner in polygon {
            writeln!(text, "v {} 0.5 0.5 0.5", shape.vertices[corner].map(six_digits).join(" ")).unwrap();
        }
        let corners: Vec<String> = (1..=polygon.len()).rev().map(|back| format!("-{back}")).collect();
        writeln!(text, "f {}", corners.join(" ")).unwrap();
    }
    text.into_bytes()
}
