//! Files that other programs write in unusual ways, which are read, and files that are refused with the reason.

use mesh::Format::{Obj, Stl};
use mesh::{Format, MeshError, TriangleMesh};

use crate::reading::volume;
use crate::reading::writers::{binary_with_solid_in_its_header, binary_with_zeros, text_with_exponents};
use crate::shapes::{Shape, cube, stack};

/// A cube of 10.
fn text() -> String {
    String::from_utf8(text_with_exponents(&cube(10.0))).unwrap()
}

fn obj() -> String {
    cube(10.0).obj()
}

/// The cube and one of 5 beside it.
fn two() -> Shape {
    cube(10.0).and(&cube(5.0).moved([20.0, 0.0, 0.0]))
}

fn assert_volume(content: impl AsRef<[u8]>, format: Format, expected: f64, what: &str) {
    match volume(content.as_ref(), format) {
        Ok(volume) => assert!((volume - expected).abs() < 1e-4 * expected, "{what}: {volume}"),
        Err(error) => panic!("{what}: {error}"),
    }
}

fn assert_refused(content: impl AsRef<[u8]>, format: Format, words: &str) {
    match volume(content.as_ref(), format) {
        Ok(volume) => panic!("read as {volume}, not refused with `{words}`"),
        Err(error) => assert!(error.to_string().contains(words), "{error}\nnot: {words}"),
    }
}

#[test]
fn text_as_other_programs_write_it_is_read() {
    let text = text();
    let latin = |name: &[u8]| [b"solid ", name, &text.as_bytes()[text.find('\n').unwrap()..]].concat();
    let variants: [(&str, Vec<u8>); 22] = [
        ("as it is", text.clone().into()),
        ("no name", text.replace(" part", "").into()),
        ("capitals", text.to_uppercase().into()),
        ("CR LF", text.replace('\n', "\r\n").into()),
        ("CR", text.replace('\n', "\r").into()),
        ("blank lines first", format!("\n\n  {text}").into()),
        ("tabs", text.replace(' ', "\t").into()),
        ("byte order mark", format!("\u{feff}{text}").into()),
        ("name in UTF-8", text.replace("part", "Gehäuse").into()),
        ("name in Latin-1", latin(b"Geh\xe4use")),
        ("name with keywords", latin(b"facet normal solid endsolid loop")),
        ("name of 10 kB", latin(&[b'x'; 10_000])),
        (
            "normals that are none",
            text.lines()
                .map(|line| if line.starts_with("facet") { "facet normal nan -nan(ind) 1.#QNAN" } else { line })
                .map(|line| line.to_owned() + "\n")
                .collect::<String>()
                .into(),
        ),
        (
            "no normals",
            text.lines()
                .map(|line| if line.starts_with("facet") { "facet\n" } else { line }.to_owned() + "\n")
                .collect::<String>()
                .into(),
        ),
        ("end loop", text.replace("endloop", "end loop").replace("endfacet", "End Facet").into()),
        ("end solid", text.replace("endsolid", "end solid").into()),
        (
            "one facet in a line",
            text.replace('\n', " ").replace("endfacet", "endfacet\n").replacen("part", "part\n", 1).into(),
        ),
        ("three digits in exponents", text.replace("e0", "e+000").replace("e1", "E+001").into()),
        ("empty solid first", format!("solid empty\nendsolid empty\n{text}").into()),
        ("empty solid last", format!("{text}solid\nendsolid").into()),
        ("blanks at the end", format!("{text}\n\n  \t\n").into()),
        ("end mark of DOS and padding", format!("{text}\u{1a}\0\0\0\0").into()),
    ];
    for (what, content) in variants {
        assert_volume(content, Stl, 1000.0, what);
    }
}

#[test]
fn all_solids_of_a_text_are_read() {
    let five = String::from_utf8(text_with_exponents(&cube(5.0).moved([20.0, 0.0, 0.0]))).unwrap();
    assert_volume(text() + &five, Stl, 1125.0, "two solids");
    assert_volume(text() + &text(), Stl, 1000.0, "the same solid twice");
    let all = (0..20)
        .map(|at| String::from_utf8(text_with_exponents(&cube(5.0).moved([6.0 * f64::from(at), 0.0, 0.0]))).unwrap());
    assert_volume(all.collect::<String>(), Stl, 2500.0, "twenty solids");
}

#[test]
fn text_that_is_wrong_is_refused_at_its_line() {
    let text = text();
    let third = |line: &str| {
        let mut lines: Vec<&str> = text.lines().collect();
        lines[3] = line;
        lines.join("\n")
    };
    assert_refused(third("vertex 1,5 0 0"), Stl, "line 4: `1,5` has a comma");
    assert_refused(third("vertex 0, 0, 0"), Stl, "line 4: `0,` has a comma");
    assert_refused(third("vertex 0 0 nan"), Stl, "line 4: `nan` is not a finite number");
    assert_refused(third("vertex 0 0 1e999"), Stl, "line 4: `1e999` is not a finite number");
    assert_refused(third("vertex 0 0 0x10"), Stl, "line 4: `0x10` is not a finite number");
    assert_refused(third("vertex 0 0"), Stl, "line 5: `vertex` is not a finite number");
    assert_refused(third("vertex 0 0 0 0"), Stl, "line 4: `0` where `vertex` should be");
    assert_refused(third("edge 0 0 0"), Stl, "line 4: `edge` where `vertex` should be");
    assert_refused(third("vertex 0 0 0\x1b[31m"), Stl, "line 4: `0\\x1b[31m` is not a finite number");
    assert_refused(third(""), Stl, "where `vertex` should be");
    assert_refused(
        text.replacen("endloop", "vertex 0 0 0\nendloop", 1),
        Stl,
        "line 7: `vertex` where `endloop` should be",
    );
    assert_refused(text.replacen("facet", "fact", 1), Stl, "line 2: `fact` where `facet` or `endsolid` should be");
    let commented = text.replacen("outer loop", "a comment\nouter loop", 1);
    assert_refused(commented, Stl, "line 3: `a` where `outer` should be");
    assert_refused(format!("{text}rubbish"), Stl, "`rubbish` where `solid` should be");
    assert_refused(text.replace('\n', " "), Stl, "begin a new line");
    let lines = text.lines().count();
    assert_refused(&text[..text.rfind("endsolid").unwrap()], Stl, &format!("line {}: the file is cut off", lines - 1));
    assert_refused(&text[..text.len() - 30], Stl, "the file is cut off: it ends with `");
    for end in (0..text.len() - 12).step_by(7) {
        assert!(volume(&text.as_bytes()[..end], Stl).is_err(), "cut off at {end}");
    }
}

#[test]
fn the_size_decides_what_is_binary() {
    let bytes = binary_with_solid_in_its_header(&cube(10.0));
    assert_volume(&bytes, Stl, 1000.0, "solid in the header");
    assert_volume(binary_with_zeros(&cube(10.0)), Stl, 1000.0, "zeros in the header");
    assert_volume([&bytes[..], &[0; 2]].concat(), Stl, 1000.0, "two bytes behind");
    assert_volume([&bytes[..], b"\r\n"].concat(), Stl, 1000.0, "a line end behind");
    assert_volume([&bytes[..], &[0; 512]].concat(), Stl, 1000.0, "padded");
    let mut marked = bytes.clone();
    marked[84 + 48..].chunks_mut(50).for_each(|record| record[0] = 0x7f);
    assert_volume(marked, Stl, 1000.0, "colours in the attributes");
    let mut normals = bytes.clone();
    normals[84..].chunks_mut(50).for_each(|record| record[..12].copy_from_slice(&[0xff; 12]));
    assert_volume(normals, Stl, 1000.0, "normals that are none");
    for header in [&b"\xef\xbb\xbfsolid"[..], b"<html>", b"v 0 0 0", b"PK\x03\x04", b"version https://git-lfs"] {
        let mut named = bytes.clone();
        named[..header.len()].copy_from_slice(header);
        assert_volume(named, Stl, 1000.0, "another file's beginning in the header");
    }
}

#[test]
fn nothing_of_a_binary_file_is_left_over() {
    let counted = |bytes: &[u8], count: u32| [&bytes[..80], &count.to_le_bytes(), &bytes[84..]].concat();
    let (one, both) = (binary_with_zeros(&cube(10.0)), binary_with_zeros(&two()));
    assert_volume(&both, Stl, 1125.0, "two bodies");
    assert_refused(counted(&both, 12), Stl, "states 12 triangles, which end at byte 684, but 600 bytes follow");
    assert_refused(counted(&one, 11), Stl, "states 11 triangles, which end at byte 634, but 50 bytes follow");
    assert_refused(counted(&one, 0), Stl, "states 0 triangles, which end at byte 84, but 600 bytes follow");
    assert_refused(counted(&one, 13), Stl, "states 13 triangles, which take 734 bytes, and it has 684");
    assert_refused(counted(&one, u32::MAX), Stl, "states 4294967295 triangles, which take 214748364834 bytes");
    assert_refused([&one[..], &one].concat(), Stl, "684 bytes follow");
    assert_refused([&one[..], b"end"].concat(), Stl, "3 bytes follow");
    assert_refused(&one[..500], Stl, "cut off");
    assert_refused([b'x'; 84], Stl, "cut off or no STL file");
    assert_refused([b'x'; 83], Stl, "it is no STL file: it has 83 bytes");
    let mut infinite = one.clone();
    infinite[84 + 12..84 + 16].copy_from_slice(&f32::INFINITY.to_le_bytes());
    assert_refused(infinite, Stl, "triangle 1 (counted from one) has a coordinate that is not a finite number");
    assert!(matches!(volume(&counted(&one[..84], 0), Stl), Err(MeshError::Empty)));
}

#[test]
fn files_that_are_something_else_are_named() {
    for format in [Stl, Obj] {
        assert_refused("", format, "the file is empty");
        assert_refused(" \n\t\0", format, "the file is empty");
        let pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:0123\nsize 684\n";
        assert_refused(pointer, format, "Git LFS pointer");
        assert_refused("<!DOCTYPE html>\n<html></html>", format, "web page");
        assert_refused("\n<HTML lang=en>", format, "web page");
        assert_refused("<?xml version=\"1.0\"?><COLLADA/>", format, "XML");
        assert_refused("{\"asset\": {}}", format, "JSON");
        assert_refused([&b"PK\x03\x04"[..], &[7; 200]].concat(), format, "ZIP");
        assert_refused([&b"\x1f\x8b"[..], &[7; 200]].concat(), format, "gzip");
        assert_refused("ISO-10303-21;\nHEADER;", format, "STEP");
        assert_refused("ply\nformat ascii 1.0\n", format, "PLY");
        let utf_16: Vec<u8> = text().encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert_refused([&b"\xff\xfe"[..], &utf_16].concat(), format, "UTF-16");
        assert_refused(utf_16, format, "UTF-16");
        let big_endian: Vec<u8> = text().encode_utf16().flat_map(u16::to_be_bytes).collect();
        assert_refused(big_endian, format, "UTF-16");
    }
    assert_refused(obj(), Stl, "it is an OBJ file: name it .obj");
    assert_refused(format!("# a comment\n\n{}", obj()), Stl, "it is an OBJ file");
    assert_refused(text(), Obj, "it is an STL file: name it .stl");
    assert_refused(binary_with_zeros(&cube(10.0)), Obj, "it is an STL file");
    assert_refused(
        "no mesh at all, but more than the 84 bytes that a header of a binary STL file would need in any case",
        Stl,
        "cut off or no STL file",
    );
    assert_refused("no mesh", Stl, "it is no STL file: it has 7 bytes");
}

#[test]
fn obj_files_as_other_programs_write_them_are_read() {
    let obj = obj();
    let corners = |change: fn(usize) -> String| {
        let face = |line: &str| {
            line.split(' ').skip(1).map(|word| change(word.parse().unwrap())).collect::<Vec<_>>().join(" ")
        };
        let line = |line: &str| if line.starts_with('f') { format!("f {}\n", face(line)) } else { format!("{line}\n") };
        obj.lines().map(line).collect::<String>()
    };
    let vertices = |behind: &str| {
        obj.lines()
            .map(|line| if line.starts_with('v') { format!("{line}{behind}\n") } else { format!("{line}\n") })
            .collect::<String>()
    };
    let latin = [b"# Geh\xe4use\no Geh\xe4use\nmtllib C:\\teile\\\xfc.mtl\n", obj.as_bytes()].concat();
    let variants: [(&str, Vec<u8>); 27] = [
        ("as it is", obj.clone().into()),
        ("CR LF", obj.replace('\n', "\r\n").into()),
        ("CR", obj.replace('\n', "\r").into()),
        ("capitals", obj.to_uppercase().into()),
        ("byte order mark", format!("\u{feff}{obj}").into()),
        ("Latin-1", latin),
        ("tabs", obj.replace(' ', "\t ").into()),
        ("texture and normal", corners(|corner| format!("{corner}/999/-999")).into()),
        ("texture", corners(|corner| format!("{corner}/x")).into()),
        ("normal", corners(|corner| format!("{corner}//7")).into()),
        ("backwards", corners(|corner| (corner as i64 - 9).to_string()).into()),
        ("colours", vertices(" 0.1 0.2 0.3").into()),
        ("colours and opacity", vertices(" 0.1 0.2 0.3 1").into()),
        ("weights of one", vertices(" 1.0").into()),
        ("looks", format!("mtllib\nusemtl\nvt 1\nvt x\nvn nan\ng\ns off\n{obj}").into()),
        ("polyline", format!("{obj}l 1 2 3 4 1\nl 1 2\n").into()),
        ("points", format!("{obj}v 100 100 100\np 9\np 1 2 3\n").into()),
        ("curves", format!("{obj}cstype bspline\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\nvp 1 2\n").into()),
        ("continued faces", obj.replace("f 1", "f \\\n1").into()),
        ("continued numbers", obj.replace(" 10.0", " \\  \r\n 10.0").into()),
        ("comment that ends with a backslash", format!("# C:\\teile\\\n{obj}").into()),
        ("comments behind", obj.replace('\n', " # comment\n").into()),
        ("no line end", obj.trim_end().into()),
        ("vertex that is used by nothing", format!("{obj}v 1e9 0 0\n").into()),
        ("faces first", {
            let (v, f): (Vec<&str>, Vec<&str>) = obj.lines().partition(|line| line.starts_with('v'));
            [f, v].concat().join("\n").into()
        }),
        ("several objects", obj.replacen('f', "o a\ng b c\nf", 1).into()),
        ("old faces", obj.replace("f ", "fo ").into()),
    ];
    for (what, content) in variants {
        assert_volume(content, Obj, 1000.0, what);
    }
    // The fourth number divides the others.
    assert_volume(vertices(" 0.5"), Obj, 8000.0, "weights of a half");
}

#[test]
fn obj_files_that_are_wrong_are_refused_at_their_lines() {
    let obj = obj();
    let faces = obj.find('f').unwrap();
    let first_face = obj[..faces].lines().count() + 1;
    let with = |line: &str| format!("{}{line}\n{}", &obj[..faces], &obj[faces..]);
    let at = |problem: &str| format!("line {first_face}: {problem}");
    assert_refused(with("v 1,5 0 0"), Obj, &at("`1,5` has a comma"));
    assert_refused(with("v 0 0"), Obj, &at("a vertex needs three coordinates, not 2"));
    assert_refused(with("v 0 0 inf"), Obj, &at("`inf` is not a finite number"));
    assert_refused(with("v 0 0 0 0"), Obj, &at("the weight of a vertex must not be zero"));
    assert_refused(with("f 1 2"), Obj, &at("a face needs three corners, not 2"));
    assert_refused(with("f"), Obj, &at("a face needs three corners, not 0"));
    assert_refused(with("f 1 2 0"), Obj, &at("`0` is no index of a vertex"));
    assert_refused(with("f 1 2 9"), Obj, &at("the face names a vertex that does not exist: there are 8"));
    assert_refused(with("f 1 2 -9"), Obj, &at("the face names a vertex that does not exist"));
    assert_refused(with("f 1 2 99999999999999999999"), Obj, &at("`99999999999999999999` is no index"));
    assert_refused(with("f 1 2 3.0"), Obj, &at("`3.0` is no index"));
    assert_refused(with("f /1 /2 /3"), Obj, &at("`/1` is no index"));
    assert_refused(with("surf 0 1 0 1 1 2 3"), Obj, &at("`surf` is not read"));
    assert_refused(with("call other.obj"), Obj, &at("`call` is not read"));
    assert_refused(with("<<<<<<< HEAD"), Obj, &at("`<<<<<<<` is no keyword of OBJ files"));
    assert_refused(with("1 2 3"), Obj, &at("`1` is no keyword"));
    assert_refused(with("v 0 0 \\"), Obj, "is not a finite number");
    assert_refused(&obj[..faces], Obj, "it has no triangles");
    let last = obj.trim_end().rfind('f').unwrap();
    assert_refused(&obj[..last + 3], Obj, "a face needs three corners, not 1");
    let open = format!("{}l 5 6 7 8 5\n", &obj[..obj.trim_end().rfind('\n').unwrap() + 1]);
    assert_refused(open, Obj, "the surface is open");
}

#[test]
fn both_sides_of_polygons_are_one_surface() {
    let shape = cube(10.0);
    let mut both = shape.clone();
    both.polygons.extend(shape.inverted().polygons);
    assert_volume(both.obj(), Obj, 1000.0, "polygons with both sides");
    assert_volume(shape.and(&shape.inverted()).obj(), Obj, 1000.0, "with vertices of their own");
}

#[test]
fn thousands_of_triangles_are_refused_or_read_soon() {
    // Polygons of very many corners.
    let star = |z: f64| {
        let corner = |index: usize| {
            let (sine, cosine) = (std::f64::consts::TAU * index as f64 / 4e3).sin_cos();
            let radius = if index.is_multiple_of(2) { 50.0 } else { 40.0 };
            [radius * cosine, radius * sine, z]
        };
        (0..4000).map(corner).collect::<Vec<_>>()
    };
    let prism = stack(&[star(0.0), star(10.0)], false);
    let area = 0.5 * 4e3 * 50.0 * 40.0 * (std::f64::consts::TAU / 4e3).sin();
    assert_volume(prism.obj(), Obj, area * 10.0, "star of 4000 corners");
    // Tetrahedra that all cross each other.
    let mut random = crate::reading::random::Random(4);
    let mut soup = Shape::default();
    for _ in 0..2000 {
        let mut corner = || [0, 1, 2].map(|_| random.between(0.0, 10.0));
        let [a, b, c, d] = std::array::from_fn(|_| soup.add(&[corner()])[0]);
        soup.polygons.extend([vec![a, b, c], vec![a, c, d], vec![a, d, b], vec![b, d, c]]);
    }
    assert_refused(binary_with_zeros(&soup), Stl, "crosses itself");
    // Triangles that hang together nowhere.
    let loose = Shape { polygons: soup.polygons.iter().step_by(4).cloned().collect(), ..soup };
    assert_refused(binary_with_zeros(&loose), Stl, "the surface is open");
}

#[test]
fn only_regular_files_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("folder.stl");
    std::fs::create_dir(&path).unwrap();
    let error = TriangleMesh::read(&path, 1.0).unwrap_err();
    assert_eq!(error.to_string(), "cannot be read: it is a folder");
}
