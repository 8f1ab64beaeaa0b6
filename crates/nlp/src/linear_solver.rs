//! Availability of linear solvers in the installed Ipopt.

#![allow(unsafe_code)]

use crate::error::SolveError;

/// Solvers of the HSL collection that Ipopt loads from `libhsl.so`.
const HSL: [&str; 3] = ["ma27", "ma57", "ma97"];
/// The solver that Debian's Ipopt is built with.
pub const MUMPS: &str = "mumps";

/// Ipopt's name of the solver whose place the caller's solver takes.
pub const SLOT: &str = "ma57";

/// Whether a solver of the caller can be registered in the installed Ipopt.
pub const TAKES_OWN_SOLVER: bool = cfg!(hsl_loader);

/// Checks that a solver of the caller can run.
///
/// # Errors
/// When it cannot be registered in this Ipopt.
pub fn require_slot(name: &str) -> Result<(), SolveError> {
    if TAKES_OWN_SOLVER {
        return Ok(());
    }
    let reason = format!("it cannot be registered in Ipopt {}", crate::IPOPT_VERSION);
    Err(SolveError::LinearSolver { name: name.to_owned(), reason })
}

/// Checks that one of Ipopt's own linear solvers can run.
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
    // Loaded anew each time, because the caller's solver may have taken the place of MA57 in the meantime.
    // SAFETY: a null name asks for the default library; the message has the announced length.
    let failed = unsafe {
        if ipopt_sys::LSL_isHSLLoaded() != 0 {
            ipopt_sys::LSL_unloadHSL();
        }
        ipopt_sys::LSL_loadHSL(std::ptr::null(), message.as_mut_ptr(), MESSAGE as i32) != 0
    };
    if failed {
        // SAFETY: the loader terminates its message with a zero within the given length.
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

/// Newer versions of Ipopt find the library themselves and report a missing solver as an invalid option.
#[cfg(not(hsl_loader))]
fn hsl_is_available(_name: &str) -> Result<(), String> {
    Ok(())
}
