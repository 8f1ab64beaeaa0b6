//! SDF.

use std::path::Path;

use crate::support::{assert_pose, names, refusal, shapes, shapes_of_file};
use link::Geometry;

/// A model with one link and these elements in it.
fn model(inside: &str) -> String {
    format!("<sdf version='1.9'><model name='m'><link name='tool'>\n{inside}\n</link></model></sdf>")
}

/// A box with this pose.
fn posed(pose: &str) -> String {
    model(&format!("<collision name='c'>{pose}<geometry><box><size>0.1 0.2 0.3</size></box></geometry></collision>"))
}

#[test]
fn shapes_have_their_poses_and_sizes() {
    let text = model(
        "<pose>9 9 9 0 0 0</pose>
         <visual name='v'><geometry><sphere><radius>1</radius></sphere></geometry></visual>
         <collision name='a'><pose>1 2 3 0 0 1.5707963267948966</pose>
            <geometry><box><size>0.1 0.2 0.3</size></box></geometry></collision>
         <collision name='b'><geometry><cylinder><length>0.5</length><radius>0.1</radius></cylinder></geometry></collision>
         <collision name='nothing'><geometry><empty/></geometry></collision>
         <collision name='c'><geometry><mesh><uri>meshes/c.stl</uri><scale>0.001 0.001 0.001</scale></mesh></geometry>
         </collision>",
    );
    let found = shapes(&text, "tool").unwrap();
    let geometries: Vec<Geometry> = found.iter().map(|shape| shape.geometry.clone()).collect();
    assert_eq!(
        geometries,
        [
            Geometry::Box { edges: [0.1, 0.2, 0.3] },
            Geometry::Cylinder { radius: 0.1, length: 0.5 },
            Geometry::Mesh { file: "folder/meshes/c.stl".into(), scale: 0.001 },
        ]
    );
    let half = std::f64::consts::FRAC_1_SQRT_2;
    assert_pose(&found[0].pose, [1.0, 2.0, 3.0], [half, 0.0, 0.0, half], "a");
    assert_pose(&found[1].pose, [0.0; 3], [1.0, 0.0, 0.0, 0.0], "b");
    assert_eq!(found.iter().map(|shape| shape.name.as_str()).collect::<Vec<_>>(), ["a", "b", "c"]);
    assert!(text[found[1].span.clone()].starts_with("<collision name='b'>"));
}

#[test]
fn poses_come_in_several_notations() {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    for (pose, quaternion) in [
        ("<pose/>", [1.0, 0.0, 0.0, 0.0]),
        ("<pose relative_to='tool'>0 0 0 0 1.5707963267948966 0</pose>", [half, 0.0, half, 0.0]),
        ("<pose degrees='true'>0 0 0 90 0 0</pose>", [half, half, 0.0, 0.0]),
        // About x first, then about y and z, which stay where they are: x goes to -y, y to z.
        ("<pose degrees='1' rotation_format='euler_rpy'>0 0 0 90 0 -90</pose>", [0.5, 0.5, -0.5, -0.5]),
        ("<pose rotation_format='quat_xyzw'>0 0 0 0 0 2 2</pose>", [half, 0.0, 0.0, half]),
    ] {
        assert_pose(&shapes(&posed(pose), "tool").unwrap()[0].pose, [0.0; 3], quaternion, pose);
    }
}

#[test]
fn nested_models_are_part_of_a_name() {
    let link = |name: &str| {
        format!("<link name='{name}'><collision><geometry><box><size>1 1 1</size></box></geometry></collision></link>")
    };
    let nested =
        format!("<model name='m'>{}<link name='bare'/><model name='in'>{}</model></model>", link("a"), link("a"));
    assert_eq!(names(&format!("<sdf>{nested}</sdf>")), ["a", "in::a"]);
    assert_eq!(names(&format!("<sdf><world name='w'>{nested}</world></sdf>")), ["m::a", "m::in::a"]);
    assert_eq!(shapes(&format!("<sdf>{nested}</sdf>"), "in::a").unwrap()[0].name, "collision 1");
}

#[test]
fn meshes_are_found_in_folders_above() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("models/plug/model.sdf");
    std::fs::create_dir_all(folder.path().join("models/parts")).unwrap();
    std::fs::create_dir_all(file.parent().unwrap()).unwrap();
    let mesh = folder.path().join("models/parts/a.stl");
    std::fs::write(&mesh, "").unwrap();
    let named = |uri: &str| {
        let text =
            model(&format!("<collision name='c'><geometry><mesh><uri>{uri}</uri></mesh></geometry></collision>"));
        shapes_of_file(&file, &text, "tool").map(|shapes| shapes[0].geometry.clone())
    };
    let expected = |file: &Path| Geometry::Mesh { file: file.to_owned(), scale: 1.0 };
    assert_eq!(named("model://parts/a.stl").unwrap(), expected(&mesh));
    assert_eq!(named("package://models/parts/a.stl").unwrap(), expected(&mesh));
    assert_eq!(named(&format!("file://{}", mesh.display())).unwrap(), expected(&mesh));
    assert_eq!(named("../parts/a.stl").unwrap(), expected(&file.parent().unwrap().join("../parts/a.stl")));
    let message = |uri: &str| named(uri).unwrap_err().to_string();
    assert!(message("model://parts/b.stl").contains("is not found: no folder above"));
    assert!(message("https://example.org/a.stl").contains("must be a file: download it"));
    assert!(message("").contains("must be a file"));
}

#[test]
fn what_is_not_read_is_refused_at_its_place() {
    let geometry = |shape: &str| model(&format!("<collision name='c'><geometry>{shape}</geometry></collision>"));
    for (text, words) in [
        (geometry("<sphere><radius>1</radius></sphere>"), "sphere is not supported: use boxes, cylinders"),
        (geometry("<capsule/>"), "capsule is not supported"),
        (geometry("<cone/>"), "cone is not supported"),
        (geometry("<ellipsoid/>"), "ellipsoid is not supported"),
        (geometry("<plane/>"), "plane is not supported"),
        (geometry("<heightmap/>"), "heightmap is not supported"),
        (geometry("<polyline/>"), "polyline is not supported"),
        (geometry(""), "<collision> has no geometry"),
        (geometry("<empty/><empty/>"), "a second shape in one <geometry>: give it a <collision> of its own"),
        (model("<collision name='c'/>"), "<collision> has no geometry"),
        (
            geometry("<box><size>1 1 1</size><size>2 2 2</size></box>"),
            "a second <size> in one <box>: only one can be meant",
        ),
        (geometry("<box/>"), "<box> has no <size>"),
        (geometry("<box><size>1 1</size></box>"), "size \"1 1\" must have 3 numbers, not 2"),
        (geometry("<box><size>1 1 -1</size></box>"), "size \"1 1 -1\" must be positive"),
        (geometry("<box><size>1 1 1e9</size></box>"), "must have finite numbers below 1e6"),
        (geometry("<cylinder><radius>1</radius></cylinder>"), "<cylinder> has no <length>"),
        (geometry("<mesh><scale>1 1 1</scale></mesh>"), "<mesh> has no <uri>"),
        (geometry("<mesh><uri>a.stl</uri><scale>1 2 1</scale></mesh>"), "stretch or mirror the mesh in its file"),
        (geometry("<mesh><uri>a.stl</uri><submesh><name>s</name></submesh></mesh>"), "a submesh is not supported"),
        (posed("<pose>0 0 0</pose>"), "pose \"0 0 0\" must have 6 numbers, not 3"),
        (posed("<pose>0 0 0 0 0 a</pose>"), "pose \"0 0 0 0 0 a\" must be numbers with blanks between them"),
        (posed("<pose relative_to='f'>0 0 0 0 0 0</pose>"), "relative_to \"f\" is not followed: state the pose"),
        (posed("<pose frame='f'>0 0 0 0 0 0</pose>"), "frame \"f\" is not followed"),
        (posed("<pose rotation_format='matrix'>0</pose>"), "must be euler_rpy or quat_xyzw"),
        (posed("<pose rotation_format='quat_xyzw'>0 0 0 0 0 0 0</pose>"), "must have a quaternion, not zero"),
        (model("<include/>"), "<include> is not followed: name the included file itself"),
    ] {
        let (line, message) = refusal(&text, "tool");
        assert!(message.contains(words) && line == 2, "{text}: {line} {message}");
    }
    let many = "<collision><geometry><box><size>1 1 1</size></box></geometry></collision>".repeat(1001);
    assert!(refusal(&model(&many), "tool").1.contains("1001 collision shapes are too many: at most 1000"));
}

#[test]
fn files_of_no_known_format_are_refused() {
    let deep = format!("{}{}", "<model>".repeat(100_000), "</model>".repeat(100_000));
    for (text, line, words) in [
        (deep.as_str(), 1, "is neither <sdf>"),
        ("", 1, "is not well-formed XML"),
        ("solid cube", 1, "is not well-formed XML"),
        ("<sdf>\n<model>", 1, "is not well-formed XML"),
        ("<sdf>\n<model/>\n</sdr>", 3, "is not well-formed XML"),
        ("<!DOCTYPE sdf [<!ENTITY a 'b'>]><sdf/>", 1, "is not well-formed XML"),
        ("<html/>", 1, "is neither <sdf>, <robot> (URDF) nor <mujoco> (MJCF)"),
    ] {
        let (found, message) = refusal(text, "tool");
        assert!(message.contains(words) && found == line, "{text}: {found} {message}");
    }
}
