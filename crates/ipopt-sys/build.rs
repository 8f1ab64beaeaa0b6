//! Finds the installed Ipopt by pkg-config and binds its C interface.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

const FIX: &str =
    "On Debian: apt-get install coinor-libipopt-dev libclang-dev pkg-config. Elsewhere: docs/guide/install.md";

fn main() {
    let library = probe();
    // The shared library brings its own dependencies, whose development packages need not be installed.
    println!("cargo::rustc-link-lib=ipopt");
    for folder in &library.link_paths {
        println!("cargo::rustc-link-search=native={}", folder.display());
    }
    // Debian's pkg-config drops the flags of directories that the compiler searches anyway.
    let mut folders = library.include_paths.clone();
    folders.extend(["/usr/include/coin", "/usr/include/coin-or"].map(PathBuf::from));
    let interface = find(&folders, "IpStdCInterface.h").unwrap_or_else(|| {
        fail(&format!("pkg-config knows Ipopt {}, but its header IpStdCInterface.h is missing", library.version))
    });
    println!("cargo::rerun-if-changed={}", interface.display());
    refuse_other_numbers(&interface);
    println!("cargo::metadata=version={}", library.version);
    let folders_of_libraries = std::env::join_paths(&library.link_paths).expect("folders of libraries have no colon");
    println!("cargo::metadata=library_folders={}", folders_of_libraries.display());
    bind(&interface, &folders);
}

/// Ends the build with what is missing and what to do.
fn fail(reason: &str) -> ! {
    println!("cargo::error={reason}. {FIX}");
    std::process::exit(1)
}

fn probe() -> pkg_config::Library {
    pkg_config::Config::new().cargo_metadata(false).probe("ipopt").unwrap_or_else(|error| match error {
        pkg_config::Error::Command { .. } => fail("pkg-config cannot be run"),
        error => {
            println!("{error}");
            fail("pkg-config knows no Ipopt: it is missing, or the folder of its ipopt.pc is not in PKG_CONFIG_PATH")
        }
    })
}

fn find(folders: &[PathBuf], header: &str) -> Option<PathBuf> {
    folders.iter().map(|folder| folder.join(header)).find(|path| path.exists())
}

/// Refuses an Ipopt whose numbers or indices are not the usual ones, which `nlp` passes on.
fn refuse_other_numbers(interface: &Path) {
    let settings = std::fs::read_to_string(interface.with_file_name("IpoptConfig.h")).unwrap_or_default();
    for (setting, what) in [("IPOPT_SINGLE", "single precision"), ("IPOPT_INT64", "indices of 64 bits")] {
        if settings.lines().any(|line| line.starts_with("#define") && line.split_whitespace().nth(1) == Some(setting)) {
            fail(&format!("this Ipopt was built with {what}; assembly-plan needs one that was built without"));
        }
    }
}

fn bind(interface: &Path, folders: &[PathBuf]) {
    let builder = bindgen::Builder::default()
        .header(interface.to_string_lossy())
        .clang_args(folders.iter().map(|folder| format!("-I{}", folder.display())))
        .allowlist_function("(Create|Free)IpoptProblem|AddIpopt(Str|Num|Int)Option|SetIntermediateCallback|IpoptSolve")
        .allowlist_type("ApplicationReturnStatus|AlgorithmMode|Bool|Index|Number|UserDataPtr")
        .default_enum_style(bindgen::EnumVariation::ModuleConsts)
        .generate_comments(false)
        .layout_tests(false);
    // Where there is no libclang, bindgen panics.
    let bindings = match catch_unwind(AssertUnwindSafe(|| builder.generate())) {
        Ok(Ok(bindings)) => bindings,
        Ok(Err(error)) => fail(&format!("the headers of Ipopt cannot be bound: {error}")),
        Err(_) => fail("libclang cannot be loaded, which reads the headers of Ipopt"),
    };
    let output = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR")).join("bindings.rs");
    bindings.write_to_file(output).expect("the bindings can be written to the build folder");
}
