//! The functions that Ipopt calls. Each catches panics, so that none unwinds into C.

#![allow(unsafe_code)]

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::slice::{from_raw_parts, from_raw_parts_mut};
use std::time::{Duration, Instant};

use ipopt_sys::{AlgorithmMode, Bool, Index, Number, UserDataPtr};

use crate::problem::{EvaluationError, Pattern, Problem};
use crate::solution::{Control, Progress};

/// State that the callbacks share during one solve.
pub struct Session<'solve> {
    problem: &'solve mut dyn Problem,
    observer: &'solve mut dyn FnMut(&Progress) -> Control,
    jacobian_pattern: Pattern,
    hessian_pattern: Pattern,
    /// The problem's current point; empty when it has none.
    point: Vec<f64>,
    /// Wall time inside the problem's functions.
    pub evaluation: Duration,
    /// Progress of every iteration.
    pub log: Vec<Progress>,
    /// The last failure to evaluate the problem.
    pub evaluation_error: Option<EvaluationError>,
    /// A panic to be resumed when Ipopt has returned.
    pub panic: Option<Box<dyn Any + Send>>,
}

impl<'solve> Session<'solve> {
    pub fn new(
        problem: &'solve mut dyn Problem,
        observer: &'solve mut dyn FnMut(&Progress) -> Control,
        jacobian_pattern: Pattern,
        hessian_pattern: Pattern,
    ) -> Self {
        Self {
            problem,
            observer,
            jacobian_pattern,
            hessian_pattern,
            point: Vec::new(),
            evaluation: Duration::ZERO,
            log: Vec::new(),
            evaluation_error: None,
            panic: None,
        }
    }

    /// Evaluates something at `x`; false when there is no value or after a panic.
    fn evaluate(&mut self, x: &[f64], function: impl FnOnce(&mut dyn Problem) -> Result<(), EvaluationError>) -> bool {
        if self.panic.is_some() {
            return false;
        }
        let begin = Instant::now();
        let result = catch_unwind(AssertUnwindSafe(|| {
            // Ipopt's flag for new points is unreliable when functions are evaluated in another order.
            if self.point != x {
                self.point.clear();
                self.problem.set_point(x)?;
                self.point.extend_from_slice(x);
            }
            function(self.problem)
        }));
        self.evaluation += begin.elapsed();
        match result {
            Ok(Ok(())) => true,
            Ok(Err(error)) => {
                self.evaluation_error = Some(error);
                false
            }
            Err(panic) => {
                self.panic = Some(panic);
                false
            }
        }
    }

    fn observe(&mut self, progress: Progress) -> bool {
        if self.panic.is_some() {
            return false;
        }
        self.log.push(progress);
        match catch_unwind(AssertUnwindSafe(|| (self.observer)(&progress))) {
            Ok(control) => control == Control::Continue,
            Err(panic) => {
                self.panic = Some(panic);
                false
            }
        }
    }
}

/// `Bool` of the installed header: an integer up to Ipopt 3.13, a C99 `bool` from then on.
pub trait Truth {
    /// The C value of a truth value.
    fn from_truth(truth: bool) -> Self;
    /// The truth value of a C value.
    fn into_truth(self) -> bool;
}

impl Truth for i32 {
    fn from_truth(truth: bool) -> Self {
        i32::from(truth)
    }
    fn into_truth(self) -> bool {
        self != 0
    }
}

impl Truth for bool {
    fn from_truth(truth: bool) -> Self {
        truth
    }
    fn into_truth(self) -> bool {
        self
    }
}

/// # Safety
/// `data` must point to the [`Session`] of the running solve.
unsafe fn session<'call>(data: UserDataPtr) -> &'call mut Session<'call> {
    // SAFETY: `solve` passes a pointer to its session, which outlives IpoptSolve and is used by one callback at a time.
    unsafe { &mut *data.cast::<Session<'call>>() }
}

/// # Safety
/// `pointer` must be null or point to `length` values.
unsafe fn numbers<'call>(pointer: *const Number, length: Index) -> &'call [f64] {
    if pointer.is_null() {
        return &[];
    }
    // SAFETY: the caller guarantees the length.
    unsafe { from_raw_parts(pointer, length as usize) }
}

/// # Safety
/// `pointer` must be null or point to `length` values to which there is no other reference.
unsafe fn numbers_mut<'call>(pointer: *mut Number, length: Index) -> &'call mut [f64] {
    if pointer.is_null() {
        return &mut [];
    }
    // SAFETY: the caller guarantees the length and exclusive access.
    unsafe { from_raw_parts_mut(pointer, length as usize) }
}

/// # Safety
/// As Ipopt calls it.
pub unsafe extern "C" fn objective(n: Index, x: *mut Number, _: Bool, value: *mut Number, data: UserDataPtr) -> Bool {
    // SAFETY: Ipopt passes n variables, one result and our user data.
    let (session, x, value) = unsafe { (session(data), numbers(x, n), &mut *value) };
    Bool::from_truth(session.evaluate(x, |problem| {
        *value = problem.objective()?;
        Ok(())
    }))
}

/// # Safety
/// As Ipopt calls it.
pub unsafe extern "C" fn gradient(n: Index, x: *mut Number, _: Bool, values: *mut Number, data: UserDataPtr) -> Bool {
    // SAFETY: Ipopt passes n variables, n results and our user data.
    let (session, x, values) = unsafe { (session(data), numbers(x, n), numbers_mut(values, n)) };
    Bool::from_truth(session.evaluate(x, |problem| problem.gradient(values)))
}

/// # Safety
/// As Ipopt calls it.
pub unsafe extern "C" fn constraints(
    n: Index,
    x: *mut Number,
    _: Bool,
    m: Index,
    values: *mut Number,
    data: UserDataPtr,
) -> Bool {
    // SAFETY: Ipopt passes n variables, m results and our user data.
    let (session, x, values) = unsafe { (session(data), numbers(x, n), numbers_mut(values, m)) };
    Bool::from_truth(session.evaluate(x, |problem| problem.constraints(values)))
}

/// # Safety
/// As Ipopt calls it: without values to ask for the pattern.
pub unsafe extern "C" fn jacobian(
    n: Index,
    x: *mut Number,
    _: Bool,
    _: Index,
    entries: Index,
    rows: *mut Index,
    columns: *mut Index,
    values: *mut Number,
    data: UserDataPtr,
) -> Bool {
    // SAFETY: Ipopt passes n variables (or null), either values or coordinates for all entries, and our user data.
    let (session, x, target) = unsafe { (session(data), numbers(x, n), numbers_mut(values, entries)) };
    if values.is_null() {
        // SAFETY: without values, both coordinate arrays have one element per entry.
        unsafe { write_pattern(&session.jacobian_pattern, rows, columns) };
        return Bool::from_truth(true);
    }
    Bool::from_truth(session.evaluate(x, |problem| problem.jacobian(target)))
}

/// # Safety
/// As Ipopt calls it: without values to ask for the pattern.
pub unsafe extern "C" fn hessian(
    n: Index,
    x: *mut Number,
    _: Bool,
    objective_factor: Number,
    m: Index,
    multipliers: *mut Number,
    _: Bool,
    entries: Index,
    rows: *mut Index,
    columns: *mut Index,
    values: *mut Number,
    data: UserDataPtr,
) -> Bool {
    // SAFETY: as for the Jacobian, with m multipliers (or null).
    let (session, x, multipliers, target) =
        unsafe { (session(data), numbers(x, n), numbers(multipliers, m), numbers_mut(values, entries)) };
    if values.is_null() {
        // SAFETY: without values, both coordinate arrays have one element per entry.
        unsafe { write_pattern(&session.hessian_pattern, rows, columns) };
        return Bool::from_truth(true);
    }
    Bool::from_truth(session.evaluate(x, |problem| problem.hessian(objective_factor, multipliers, target)))
}

/// # Safety
/// As Ipopt calls it.
pub unsafe extern "C" fn iteration(
    mode: Index,
    iteration: Index,
    objective: Number,
    primal_infeasibility: Number,
    dual_infeasibility: Number,
    mu: Number,
    step_norm: Number,
    regularization: Number,
    alpha_dual: Number,
    alpha_primal: Number,
    line_search_trials: Index,
    data: UserDataPtr,
) -> Bool {
    let progress = Progress {
        iteration: iteration as usize,
        objective,
        primal_infeasibility,
        dual_infeasibility,
        mu,
        step_norm,
        regularization,
        alpha_dual,
        alpha_primal,
        line_search_trials: line_search_trials as usize,
        restoration: mode as i64 == AlgorithmMode::RestorationPhaseMode as i64,
    };
    // SAFETY: Ipopt passes our user data.
    Bool::from_truth(unsafe { session(data) }.observe(progress))
}

/// # Safety
/// Both arrays must have one element per entry.
unsafe fn write_pattern(pattern: &Pattern, rows: *mut Index, columns: *mut Index) {
    let length = pattern.rows.len();
    if length == 0 {
        return;
    }
    // SAFETY: the caller guarantees the lengths.
    let (rows, columns) = unsafe { (from_raw_parts_mut(rows, length), from_raw_parts_mut(columns, length)) };
    for entry in 0..length {
        rows[entry] = pattern.rows[entry] as Index;
        columns[entry] = pattern.columns[entry] as Index;
    }
}
