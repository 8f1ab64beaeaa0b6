//! Passes on the version of the installed Ipopt.

fn main() {
    let version = std::env::var("DEP_IPOPT_VERSION").unwrap_or_default();
    println!("cargo::rustc-env=IPOPT_VERSION={version}");
}
