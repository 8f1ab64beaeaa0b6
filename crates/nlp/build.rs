//! Passes on whether the installed Ipopt lets a program register its own linear solver.

fn main() {
    println!("cargo::rustc-check-cfg=cfg(hsl_loader)");
    if std::env::var_os("DEP_IPOPT_HSL_LOADER").is_some() {
        println!("cargo::rustc-cfg=hsl_loader");
    }
}
