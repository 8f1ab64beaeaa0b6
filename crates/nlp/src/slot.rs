//! The caller's linear solver in the place of MA57.
//!
//! Ipopt calls MA57 through five function pointers that can be set. The functions here find the solver of the running
//! solve in a thread-local variable; Ipopt stays in its thread.

#![allow(unsafe_code)]

use std::any::Any;
use std::cell::Cell;
use std::ffi::c_int;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::ptr::NonNull;
use std::slice::{from_raw_parts, from_raw_parts_mut};
use std::sync::{Mutex, OnceLock, PoisonError};
use std::time::{Duration, Instant};

use ipopt_sys::ma57::{self, SetFunctions};

use crate::kkt_solver::{Factorisation, KktSolver};

thread_local! {
    /// The slot of the solve that runs in this thread.
    static CURRENT: Cell<Option<NonNull<Slot<'static>>>> = const { Cell::new(None) };
}

/// Ipopt's name of the solver in whose place the caller's solver runs.
pub const NAME: &str = "ma57";

/// Whether the functions below are registered at the moment.
static REGISTERED: Mutex<bool> = Mutex::new(false);

/// How the loaded Ipopt takes functions in the place of MA57's, if it does.
fn set_functions() -> Option<SetFunctions> {
    static FOUND: OnceLock<Option<SetFunctions>> = OnceLock::new();
    *FOUND.get_or_init(ma57::set_functions)
}

/// Whether the loaded Ipopt takes functions in the place of MA57's.
pub fn exists() -> bool {
    set_functions().is_some()
}

/// Registers the functions below, only once because other threads may be using them.
fn register() {
    let mut registered = REGISTERED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(set_functions) = set_functions().filter(|_| !*registered) {
        // SAFETY: the functions do as MA57's.
        unsafe { set_functions(Some(analyse), Some(factorise), Some(solve_system), Some(enlarge), Some(initialise)) };
        *registered = true;
    }
}

/// Gives HSL's MA57 its place back. No other solve may be running.
pub fn vacate() {
    let mut registered = REGISTERED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(set_functions) = set_functions() {
        // SAFETY: without functions, Ipopt looks for MA57 before it calls it.
        unsafe { set_functions(None, None, None, None, None) };
    }
    *registered = false;
}

/// MA57's codes in `info(1)`.
const FINE: c_int = 0;
const SINGULAR: c_int = 4;
const FATAL: c_int = -1;
/// Indices into `info`, from 0.
const STATUS: usize = 0;
const FACTOR_LENGTHS: [usize; 2] = [8, 9];
const NEGATIVE_EIGENVALUES: usize = 23;
const RANK: usize = 24;
const INFO_LENGTH: usize = 40;
/// Lengths of `cntl` and `icntl`.
const CONTROL_LENGTHS: [usize; 2] = [5, 20];
/// Length of the arrays for factors, which Ipopt allocates but never reads.
const NOMINAL_LENGTH: c_int = 64;

/// The solver of one solve.
pub struct Slot<'solver> {
    solver: &'solver mut dyn KktSolver,
    dimension: usize,
    /// Whether Ipopt has called it.
    pub was_called: bool,
    /// Ipopt's pivot tolerance, which it raises to request more accuracy.
    pivot_tolerance: Option<f64>,
    /// Wall time in the solver.
    pub elapsed: Duration,
    /// The reason why the solver cannot be used.
    pub refusal: Option<String>,
    /// A panic to be resumed when Ipopt has returned.
    pub panic: Option<Box<dyn Any + Send>>,
}

impl<'solver> Slot<'solver> {
    /// A slot for a solver.
    pub fn new(solver: &'solver mut dyn KktSolver) -> Self {
        Self {
            solver,
            dimension: 0,
            was_called: false,
            pivot_tolerance: None,
            elapsed: Duration::ZERO,
            refusal: None,
            panic: None,
        }
    }

    /// Runs Ipopt with this slot's solver in the place of MA57.
    pub fn run<T>(&mut self, solve: impl FnOnce() -> T) -> T {
        register();
        let slot = NonNull::from(&mut *self).cast::<Slot<'static>>();
        let _guard = Restore(CURRENT.replace(Some(slot)));
        solve()
    }

    /// Runs one of the solver's functions; `None` after a panic or refusal, now or before.
    fn call<T>(&mut self, function: impl FnOnce(&mut Self) -> T) -> Option<T> {
        if self.panic.is_some() || self.refusal.is_some() {
            return None;
        }
        let begin = Instant::now();
        let result = catch_unwind(AssertUnwindSafe(|| function(self)));
        self.elapsed += begin.elapsed();
        result.map_err(|panic| self.panic = Some(panic)).ok()
    }
}

/// Restores the previous slot.
struct Restore(Option<NonNull<Slot<'static>>>);

impl Drop for Restore {
    fn drop(&mut self) {
        CURRENT.set(self.0);
    }
}

/// Runs a function with the current slot, if there is one.
fn with_current<T>(function: impl FnOnce(&mut Slot) -> Option<T>) -> Option<T> {
    let mut slot = CURRENT.get()?;
    // SAFETY: the slot is borrowed by `run` until Ipopt has returned, and Ipopt makes one call at a time.
    function(unsafe { slot.as_mut() })
}

/// # Safety
/// As Ipopt calls MA57ID.
unsafe extern "C" fn initialise(control: *mut f64, integer_control: *mut c_int) {
    // SAFETY: both arrays have the lengths that MA57 requires.
    unsafe {
        from_raw_parts_mut(control, CONTROL_LENGTHS[0]).fill(0.0);
        from_raw_parts_mut(integer_control, CONTROL_LENGTHS[1]).fill(0);
    }
}

/// # Safety
/// As Ipopt calls MA57AD.
unsafe extern "C" fn analyse(
    dimension: *mut c_int,
    entries: *mut c_int,
    rows: *const c_int,
    columns: *const c_int,
    _: *mut c_int,
    _: *mut c_int,
    _: *mut c_int,
    _: *mut c_int,
    info: *mut c_int,
    _: *mut f64,
) {
    // SAFETY: Ipopt passes the stated number of rows and columns, counted from 1, and the info array.
    let (dimension, rows, columns, info) = unsafe {
        let entries = *entries as usize;
        (
            *dimension as usize,
            from_raw_parts(rows, entries),
            from_raw_parts(columns, entries),
            from_raw_parts_mut(info, INFO_LENGTH),
        )
    };
    let from_zero = |indices: &[c_int]| -> Vec<usize> { indices.iter().map(|&index| index as usize - 1).collect() };
    let analysed = with_current(|slot| {
        slot.call(|slot| {
            (slot.dimension, slot.was_called) = (dimension, true);
            slot.solver.analyse(dimension, &from_zero(rows), &from_zero(columns)).map_err(|reason| {
                slot.refusal = Some(reason.to_string());
            })
        })
    });
    info.fill(0);
    info[STATUS] = if matches!(analysed, Some(Ok(()))) { FINE } else { FATAL };
    for place in FACTOR_LENGTHS {
        info[place] = NOMINAL_LENGTH;
    }
}

/// # Safety
/// As Ipopt calls MA57BD.
unsafe extern "C" fn factorise(
    _: *mut c_int,
    entries: *mut c_int,
    values: *mut f64,
    _: *mut f64,
    _: *mut c_int,
    _: *mut c_int,
    _: *mut c_int,
    _: *mut c_int,
    _: *mut c_int,
    _: *mut c_int,
    _: *mut c_int,
    control: *mut f64,
    info: *mut c_int,
    _: *mut f64,
) {
    // SAFETY: Ipopt passes the stated number of values, the control and the info array.
    let (values, tolerance, info) =
        unsafe { (from_raw_parts(values, *entries as usize), *control, from_raw_parts_mut(info, INFO_LENGTH)) };
    let found = with_current(|slot| {
        slot.call(|slot| {
            if slot.pivot_tolerance.replace(tolerance).is_some_and(|before| tolerance > before) {
                slot.solver.increase_quality();
            }
            (slot.solver.factorise(values), slot.dimension)
        })
    });
    info.fill(0);
    match found {
        Some((Factorisation::Inertia { negative }, dimension)) => {
            info[NEGATIVE_EIGENVALUES] = negative as c_int;
            info[RANK] = dimension as c_int;
        }
        Some((Factorisation::Singular, _)) => info[STATUS] = SINGULAR,
        Some((Factorisation::Failed, _)) | None => info[STATUS] = FATAL,
    }
}

/// # Safety
/// As Ipopt calls MA57CD.
unsafe extern "C" fn solve_system(
    _: *mut c_int,
    dimension: *mut c_int,
    _: *mut f64,
    _: *mut c_int,
    _: *mut c_int,
    _: *mut c_int,
    count: *mut c_int,
    values: *mut f64,
    stride: *mut c_int,
    _: *mut f64,
    _: *mut c_int,
    _: *mut c_int,
    _: *mut c_int,
    info: *mut c_int,
) {
    // SAFETY: Ipopt passes `count` right-hand sides, `stride` values apart, each with one value per row.
    let (mut columns, info) = unsafe {
        let (dimension, count, stride) = (*dimension as usize, *count as usize, *stride as usize);
        let columns = (0..count).map(move |index| from_raw_parts_mut(values.add(index * stride), dimension));
        (columns, from_raw_parts_mut(info, INFO_LENGTH))
    };
    let solved = with_current(|slot| slot.call(|slot| columns.all(|column| slot.solver.solve(column))));
    info[STATUS] = if solved == Some(true) { FINE } else { FATAL };
}

/// Never needed, because the arrays hold no factors, but required by Ipopt.
///
/// # Safety
/// As Ipopt calls MA57ED.
unsafe extern "C" fn enlarge(
    _: *mut c_int,
    _: *mut c_int,
    _: *mut c_int,
    _: *mut f64,
    _: *mut c_int,
    _: *mut f64,
    _: *mut c_int,
    _: *mut c_int,
    _: *mut c_int,
    _: *mut c_int,
    _: *mut c_int,
    info: *mut c_int,
) {
    // SAFETY: Ipopt passes the info array.
    unsafe { *info = FATAL };
}
