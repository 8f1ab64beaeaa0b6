//! Finds the installed Ipopt by pkg-config and binds its C interface.

use std::path::{Path, PathBuf};

const PACKAGES: &str = "apt-get install coinor-libipopt-dev libclang-dev pkg-config";

fn main() {
    let library = pkg_config::Config::new().cargo_metadata(false).probe("ipopt").unwrap_or_else(|error| {
        panic!("Ipopt was not found by pkg-config. On Debian: {PACKAGES}\n{error}");
    });
    // The shared library brings its own dependencies, whose development packages need not be installed.
    println!("cargo::rustc-link-lib=ipopt");
    for folder in &library.link_paths {
        println!("cargo::rustc-link-search=native={}", folder.display());
    }
    // Debian's pkg-config drops the flags of directories that the compiler searches anyway.
    let mut folders = library.include_paths.clone();
    folders.extend(["/usr/include/coin", "/usr/include/coin-or"].map(PathBuf::from));
    let interface = find(&folders, "IpStdCInterface.h").unwrap_or_else(|| {
        panic!("pkg-config knows Ipopt {}, but IpStdCInterface.h is missing. On Debian: {PACKAGES}", library.version);
    });
    // Only the loader of this very Ipopt: newer versions have none.
    let loader = Some(interface.with_file_name("HSLLoader.h")).filter(|path| path.exists());

    println!("cargo::rustc-check-cfg=cfg(hsl_loader)");
    println!("cargo::metadata=version={}", library.version);
    if loader.is_some() {
        println!("cargo::rustc-cfg=hsl_loader");
        println!("cargo::metadata=hsl_loader=1");
    }
    let mumps = std::env::var_os("CARGO_FEATURE_MUMPS").map(|_| {
        println!("cargo::rustc-link-lib=dmumps_seq");
        find(&folders, "dmumps_c.h").or_else(|| find(&["/usr/include".into()], "dmumps_c.h")).unwrap_or_else(|| {
            panic!("dmumps_c.h is missing. On Debian: apt-get install libmumps-seq-dev");
        })
    });
    bind(&interface, loader.as_deref(), mumps.as_deref(), &folders);
}

fn find(folders: &[PathBuf], header: &str) -> Option<PathBuf> {
    folders.iter().map(|folder| folder.join(header)).find(|path| path.exists())
}

fn bind(interface: &Path, loader: Option<&Path>, mumps: Option<&Path>, folders: &[PathBuf]) {
    let mut builder = bindgen::Builder::default()
        .header(interface.to_string_lossy())
        .clang_args(folders.iter().map(|folder| format!("-I{}", folder.display())))
        .allowlist_function("(Create|Free)IpoptProblem|AddIpopt(Str|Num|Int)Option|SetIntermediateCallback|IpoptSolve")
        .allowlist_type("ApplicationReturnStatus|AlgorithmMode|Bool|Index|Number|UserDataPtr")
        .default_enum_style(bindgen::EnumVariation::ModuleConsts)
        .generate_comments(false)
        .layout_tests(false);
    if let Some(loader) = loader {
        builder = builder
            .header(loader.to_string_lossy())
            .allowlist_function("LSL_(loadHSL|unloadHSL|isHSLLoaded|isMA(27|57|97)available|setMA57)");
    }
    if let Some(mumps) = mumps {
        builder = builder.header(mumps.to_string_lossy()).allowlist_function("dmumps_c");
    }
    let bindings = builder
        .generate()
        .unwrap_or_else(|error| panic!("the headers of Ipopt cannot be bound. On Debian: {PACKAGES}\n{error}"));
    let output = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR")).join("bindings.rs");
    bindings.write_to_file(output).expect("the bindings can be written to the build folder");
}
