//! Which linear solvers the installed Ipopt can run.

#![allow(unsafe_code)]

use crate::error::SolveError;

/// Solvers of the HSL collection that Ipopt loads from `libhsl.so`.
const HSL: [&str; 3] = ["ma27", "ma57", "ma97"];
/// The solver that Debian's Ipopt is built with.
pub const MUMPS: &str = "mumps";

/// Ipopt's name for the place that a program's own solver takes.
pub const SLOT: &str = "ma57";

/// Whether the installed Ipopt lets a program bring its own linear solver.
pub const TAKES_OWN_SOLVER: bool = cfg!(hsl_loader);

/// Checks that a program's own solver can run.
///
/// # Errors
/// When this Ipopt has no place for it.
pub fn require_slot(name: &str) -> Result<(), SolveError> {
    if TAKES_OWN_SOLVER {
        return Ok(());
    }
    let reason = format!("Ipopt {} has no functions to register it", crate::IPOPT_VERSION);
    Err(SolveError::LinearSolver { name: name.to_owned(), reason })
}

/// Checks that a linear solver can run before Ipopt is asked for it.
///
/// # Errors
/// When the name is unknown or the solver is not installed.
pub fn require(name: &str) -> Result<(), SolveError> {
    let refuse = |reason: String| Err(SolveError::LinearSolver { name: name.to_owned(), reason });
    if name == MUMPS {
        return Ok(());
    }
    if !HSL.contains(&name) {
        return refuse(format!("unknown; choose {MUMPS} or {}", HSL.join(", ")));
    }
    hsl_is_available(name).or_else(refuse)
}

#[cfg(hsl_loader)]
fn hsl_is_available(name: &str) -> Result<(), String> {
    const MESSAGE: usize = 512;
    crate::slot::forget();
    let mut message = [0 as std::ffi::c_char; MESSAGE];
    // Loaded anew each time: a program's own solver may have taken MA57's place since.
    // SAFETY: a null name asks for the default library; the message has the announced length.
    let failed = unsafe {
        if ipopt_sys::LSL_isHSLLoaded() != 0 {
            ipopt_sys::LSL_unloadHSL();
        }
        ipopt_sys::LSL_loadHSL(std::ptr::null(), message.as_mut_ptr(), MESSAGE as i32) != 0
    };
    if failed {
        // SAFETY: the loader ends its message with a zero within the given length.
        let reason = unsafe { std::ffi::CStr::from_ptr(message.as_ptr()) };
        return Err(format!("the HSL library cannot be loaded: {}", reason.to_string_lossy()));
    }
    // SAFETY: plain queries.
    let available = unsafe {
        match name {
            "ma27" => ipopt_sys::LSL_isMA27available(),
            "ma57" => ipopt_sys::LSL_isMA57available(),
            _ => ipopt_sys::LSL_isMA97available(),
        }
    };
    if available == 0 { Err("the HSL library does not contain it".to_owned()) } else { Ok(()) }
}

/// Newer versions of Ipopt find the library themselves and report what is missing as an invalid option.
#[cfg(not(hsl_loader))]
fn hsl_is_available(_name: &str) -> Result<(), String> {
    Ok(())
}
