//! Finds the MUMPS that the installed Ipopt uses and binds it.

use std::path::PathBuf;

fn main() {
    let ipopt = pkg_config::Config::new().cargo_metadata(false).probe("ipopt").expect("pkg-config knows Ipopt");
    for folder in &ipopt.link_paths {
        println!("cargo::rustc-link-search=native={}", folder.display());
    }
    // Debian's pkg-config drops the flags of directories that the compiler searches anyway.
    let mut folders = ipopt.include_paths;
    folders.extend(["/usr/include/coin", "/usr/include/coin-or"].map(PathBuf::from));
    let header = header(&folders);
    println!("cargo::rerun-if-changed={}", header.display());
    let builder = bindgen::Builder::default()
        .header(header.to_string_lossy())
        .clang_args(folders.iter().map(|folder| format!("-I{}", folder.display())))
        .allowlist_function("dmumps_c")
        .generate_comments(false)
        .layout_tests(false);
    let bindings = builder.generate().expect("the header of MUMPS can be bound");
    let output = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR")).join("bindings.rs");
    bindings.write_to_file(output).expect("the bindings can be written to the build folder");
}

/// Links MUMPS and returns its header: COIN-OR's, or Debian's.
fn header(folders: &[PathBuf]) -> PathBuf {
    let find = |name: &str| folders.iter().map(|folder| folder.join(name)).find(|path| path.exists());
    if let Some(header) = find("mumps/dmumps_c.h") {
        println!("cargo::rustc-link-lib=coinmumps");
        return header;
    }
    println!("cargo::rustc-link-lib=dmumps_seq");
    let header = find("dmumps_c.h").unwrap_or_else(|| PathBuf::from("/usr/include/dmumps_c.h"));
    assert!(header.exists(), "the header dmumps_c.h is missing: apt-get install libmumps-seq-dev");
    header
}
