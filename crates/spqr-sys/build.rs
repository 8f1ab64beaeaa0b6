//! Finds the installed SuiteSparse and binds the C interface of its SPQR.

use std::path::{Path, PathBuf};

const PACKAGES: &str = "apt-get install libsuitesparse-dev libclang-dev";
/// Where Debian, other distributions and a build by hand put the headers.
const FOLDERS: [&str; 4] =
    ["/usr/include/suitesparse", "/usr/local/include/suitesparse", "/usr/include", "/usr/local/include"];

fn main() {
    let header = FOLDERS.iter().map(|folder| Path::new(folder).join("SuiteSparseQR_C.h")).find(|path| path.exists());
    let header = header.unwrap_or_else(|| panic!("SuiteSparseQR_C.h was not found. On Debian: {PACKAGES}"));
    for library in ["spqr", "cholmod"] {
        println!("cargo::rustc-link-lib={library}");
    }
    let bindings = bindgen::Builder::default()
        .header(header.to_string_lossy())
        .allowlist_function("SuiteSparseQR_C|cholmod_l_(start|finish|allocate_sparse|free_sparse|free)")
        .allowlist_var("CHOLMOD_REAL|CHOLMOD_OUT_OF_MEMORY|SPQR_ORDERING_DEFAULT")
        .generate_comments(false)
        .layout_tests(false)
        .generate()
        .unwrap_or_else(|error| panic!("the headers of SuiteSparse cannot be bound. On Debian: {PACKAGES}\n{error}"));
    let output = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR")).join("bindings.rs");
    bindings.write_to_file(output).expect("the bindings can be written to the build folder");
}
