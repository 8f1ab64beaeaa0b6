//! Passes on the version of the installed Ipopt and whether it has a loader for HSL solvers.

fn main() {
    println!("cargo::rustc-check-cfg=cfg(hsl_loader)");
    let version = std::env::var("DEP_IPOPT_VERSION").unwrap_or_default();
    println!("cargo::rustc-env=IPOPT_VERSION={version}");
    if std::env::var_os("DEP_IPOPT_HSL_LOADER").is_some() {
        println!("cargo::rustc-cfg=hsl_loader");
    }
}
