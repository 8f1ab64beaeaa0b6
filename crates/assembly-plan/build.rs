//! Lets the program find an Ipopt outside of the system's folders of libraries, such as conda's, when it starts.

use std::env;

fn main() {
    let folders = env::var_os("DEP_IPOPT_LIBRARY_FOLDERS").unwrap_or_default();
    let library = format!("{}ipopt{}", env::consts::DLL_PREFIX, env::consts::DLL_SUFFIX);
    for folder in env::split_paths(&folders).filter(|folder| folder.join(&library).exists()) {
        if !["/lib", "/lib64", "/usr/lib", "/usr/lib64"].iter().any(|system| folder.starts_with(system)) {
            println!("cargo::rustc-link-arg-bins=-Wl,-rpath,{}", folder.display());
        }
    }
}
