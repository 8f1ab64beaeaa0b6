//! The place of the linear solver MA57 in the loaded Ipopt, which a program can fill with functions of its own.

use std::ffi::{CStr, c_int, c_void};

/// `MA57AD(n, ne, irn, jcn, lkeep, keep, iwork, icntl, info, rinfo)` analyses a pattern.
pub type Analyse = unsafe extern "C" fn(
    *mut c_int,
    *mut c_int,
    *const c_int,
    *const c_int,
    *mut c_int,
    *mut c_int,
    *mut c_int,
    *mut c_int,
    *mut c_int,
    *mut f64,
);

/// `MA57BD(n, ne, a, fact, lfact, ifact, lifact, lkeep, keep, iwork, icntl, cntl, info, rinfo)` factorises a matrix.
pub type Factorise = unsafe extern "C" fn(
    *mut c_int,
    *mut c_int,
    *mut f64,
    *mut f64,
    *mut c_int,
    *mut c_int,
    *mut c_int,
    *mut c_int,
    *mut c_int,
    *mut c_int,
    *mut c_int,
    *mut f64,
    *mut c_int,
    *mut f64,
);

/// `MA57CD(job, n, fact, lfact, ifact, lifact, nrhs, rhs, lrhs, work, lwork, iwork, icntl, info)` solves.
pub type Solve = unsafe extern "C" fn(
    *mut c_int,
    *mut c_int,
    *mut f64,
    *mut c_int,
    *mut c_int,
    *mut c_int,
    *mut c_int,
    *mut f64,
    *mut c_int,
    *mut f64,
    *mut c_int,
    *mut c_int,
    *mut c_int,
    *mut c_int,
);

/// `MA57ED(n, ic, keep, fact, lfact, newfac, lnew, ifact, lifact, newifc, linew, info)` enlarges the arrays of factors.
pub type Enlarge = unsafe extern "C" fn(
    *mut c_int,
    *mut c_int,
    *mut c_int,
    *mut f64,
    *mut c_int,
    *mut f64,
    *mut c_int,
    *mut c_int,
    *mut c_int,
    *mut c_int,
    *mut c_int,
    *mut c_int,
);

/// `MA57ID(cntl, icntl)` sets defaults.
pub type Initialise = unsafe extern "C" fn(*mut f64, *mut c_int);

/// Makes Ipopt call these functions wherever it would call MA57's; without functions, it looks for MA57 again.
pub type SetFunctions =
    unsafe extern "C" fn(Option<Analyse>, Option<Factorise>, Option<Solve>, Option<Enlarge>, Option<Initialise>);

/// Its names: a static member function of `Ma57TSolverInterface` from Ipopt 3.14 on, where indices have 32 bits, and a
/// function of the loader for HSL in 3.11 to 3.13.
const NAMES: [&CStr; 2] = [
    c"_ZN5Ipopt20Ma57TSolverInterface12SetFunctionsEPFvPiS1_PKiS3_S1_S1_S1_S1_S1_PdEPFvS1_S1_S4_S4_S1_S1_S1_S1_S1_S1_S1_S4_S1_S4_EPFvS1_S1_S4_S1_S1_S1_S1_S4_S1_S4_S1_S1_S1_S1_EPFvS1_S1_S1_S4_S1_S4_S1_S1_S1_S1_S1_S1_EPFvS4_S1_E",
    c"LSL_setMA57",
];

/// Looks for the function in the shared library that holds the loaded Ipopt; `None` when that exports none.
pub fn set_functions() -> Option<SetFunctions> {
    let library = loaded_ipopt()?;
    let function = NAMES.iter().find_map(|name| {
        // SAFETY: the handle is valid, and the name ends with a zero.
        let address = unsafe { libc::dlsym(library, name.as_ptr()) };
        (!address.is_null()).then_some(address)
    })?;
    // SAFETY: under both names, Ipopt declares five function pointers of the types above and no result.
    Some(unsafe { std::mem::transmute::<*mut c_void, SetFunctions>(function) })
}

/// A handle of the shared library that holds Ipopt. It is asked by its path, since the symbols of a library that a module
/// of Python has brought along are not visible to the rest of the process.
fn loaded_ipopt() -> Option<*mut c_void> {
    let known = crate::CreateIpoptProblem as *const c_void;
    let mut place = std::mem::MaybeUninit::<libc::Dl_info>::zeroed();
    // SAFETY: the address is that of a function, and the result is plain data for which zero is valid. The library is
    // loaded already, so that its handle costs nothing but a reference.
    let library = unsafe {
        if libc::dladdr(known, place.as_mut_ptr()) == 0 {
            return None;
        }
        libc::dlopen(place.assume_init().dli_fname, libc::RTLD_LAZY | libc::RTLD_NOLOAD)
    };
    (!library.is_null()).then_some(library)
}
