//! Compares the arm of a URDF file with what `scripts/lab record arm` wrote for it, and prints its apparent inertia:
//! `cargo run -p robot --example compare_arm -- URDF FILE`.

#[path = "../tests/main/record.rs"]
mod record;

use std::path::Path;

use record::Record;

fn main() {
    let files: Vec<String> = std::env::args().skip(1).collect();
    let [urdf, file] = &files[..] else {
        eprintln!("usage: compare_arm URDF FILE");
        std::process::exit(2);
    };
    let record = Record::read(Path::new(urdf), Path::new(file));
    println!("{} joints: {}", record.joints.len(), record.joints.join(", "));
    for (quantity, difference) in record.differences() {
        println!("largest difference of {quantity}: {difference:.1e}");
    }
    for state in &record.states {
        let inertia = record.arm.at(&state.position).apparent_inertia();
        match inertia.map(|inertia| [inertia.m11, inertia.m22, inertia.m33]) {
            Some([x, y, z]) => println!("apparent mass along x, y, z: {x:.3}, {y:.3}, {z:.3} kg"),
            None => println!("singular"),
        }
    }
}
