//! A problem as Ipopt's C interface has it.

#![allow(unsafe_code)]

use std::ffi::CString;

use ipopt_sys as ipopt;

use crate::callbacks::{self, Session, Truth};
use crate::error::SolveError;
use crate::options::{OptionValue, Options};
use crate::problem::{Bounds, Problem};
use crate::solution::{Iterate, Start};
use crate::status::SolveStatus;

/// An Ipopt problem that is freed when dropped.
pub struct Handle {
    problem: ipopt::IpoptProblem,
    variables: usize,
    constraints: usize,
}

/// How a solve ended. Its solution has replaced the iterate.
pub struct Outcome {
    pub status: SolveStatus,
    pub objective: f64,
    pub constraints: Vec<f64>,
}

impl Handle {
    /// For a problem.
    ///
    /// # Errors
    /// When its bounds and patterns do not fit together, or Ipopt rejects it.
    pub fn create(problem: &dyn Problem) -> Result<Self, SolveError> {
        let (variables, constraints) = (problem.variable_bounds(), problem.constraint_bounds());
        let (jacobian, hessian) = (problem.jacobian_pattern(), problem.hessian_pattern());
        let (n, m) = (variables.lower.len(), constraints.lower.len());
        let inside = |indices: &[usize], limit| indices.iter().all(|&index| index < limit);
        let consistent = variables.upper.len() == n
            && constraints.upper.len() == m
            && jacobian.rows.len() == jacobian.columns.len()
            && hessian.rows.len() == hessian.columns.len()
            && inside(&jacobian.rows, m)
            && inside(&jacobian.columns, n)
            && inside(&hessian.rows, n)
            && hessian.rows.iter().zip(&hessian.columns).all(|(row, column)| column <= row);
        if !consistent {
            return Err(SolveError::Problem(
                "bounds or patterns do not match the numbers of variables and constraints".into(),
            ));
        }
        Self::allocate(variables, constraints, jacobian.rows.len(), hessian.rows.len())
    }

    /// For the smallest problem there is.
    pub fn probe() -> Result<Self, SolveError> {
        Self::allocate(Bounds { lower: vec![0.0], upper: vec![1.0] }, Bounds::default(), 0, 0)
    }

    /// For a problem with these bounds, each with as many lower as upper ones, and numbers of nonzeros.
    fn allocate(
        mut variables: Bounds,
        mut constraints: Bounds,
        jacobian_nonzeros: usize,
        hessian_nonzeros: usize,
    ) -> Result<Self, SolveError> {
        let (n, m) = (variables.lower.len(), constraints.lower.len());
        // SAFETY: the bounds have n and m values, which Ipopt copies; the callbacks have the right types.
        let handle = unsafe {
            ipopt::CreateIpoptProblem(
                n as ipopt::Index,
                variables.lower.as_mut_ptr(),
                variables.upper.as_mut_ptr(),
                m as ipopt::Index,
                constraints.lower.as_mut_ptr(),
                constraints.upper.as_mut_ptr(),
                jacobian_nonzeros as ipopt::Index,
                hessian_nonzeros as ipopt::Index,
                0,
                Some(callbacks::objective),
                Some(callbacks::constraints),
                Some(callbacks::gradient),
                Some(callbacks::jacobian),
                Some(callbacks::hessian),
            )
        };
        if handle.is_null() {
            return Err(SolveError::Problem("Ipopt rejects it".into()));
        }
        // SAFETY: the handle is valid and the callback has the right type.
        unsafe { ipopt::SetIntermediateCallback(handle, Some(callbacks::iteration)) };
        Ok(Self { problem: handle, variables: n, constraints: m })
    }

    /// The starting point of a solve.
    ///
    /// # Errors
    /// When its lengths are not those of the problem.
    pub fn starting_iterate(&self, start: &Start) -> Result<Iterate, SolveError> {
        let iterate = match start {
            Start::Warm(iterate) => iterate.clone(),
            Start::Cold(x) => Iterate {
                x: x.clone(),
                constraint_multipliers: vec![0.0; self.constraints],
                lower_multipliers: vec![0.0; x.len()],
                upper_multipliers: vec![0.0; x.len()],
            },
        };
        match self.mismatch(&iterate) {
            Some((actual, expected)) => {
                Err(SolveError::Problem(format!("the starting point has {actual} values where {expected} are needed")))
            }
            None => Ok(iterate),
        }
    }

    /// The first length of an iterate that is not that of the problem, and what it must be.
    fn mismatch(&self, iterate: &Iterate) -> Option<(usize, usize)> {
        let lengths = [
            (iterate.x.len(), self.variables),
            (iterate.lower_multipliers.len(), self.variables),
            (iterate.upper_multipliers.len(), self.variables),
            (iterate.constraint_multipliers.len(), self.constraints),
        ];
        lengths.into_iter().find(|(actual, expected)| actual != expected)
    }

    /// Sets options.
    ///
    /// # Errors
    /// With the first one that Ipopt refuses.
    pub fn set_options(&self, options: &Options) -> Result<(), SolveError> {
        for (name, value) in options.iter() {
            if !self.set_option(name, value) {
                return Err(SolveError::Option { name: name.to_owned(), value: value.clone() });
            }
        }
        Ok(())
    }

    fn set_option(&self, name: &str, value: &OptionValue) -> bool {
        let Ok(key) = CString::new(name) else { return false };
        let key = key.as_ptr().cast_mut();
        // SAFETY: the handle is valid; key and text are zero-terminated and copied by Ipopt.
        unsafe {
            match value {
                OptionValue::Integer(value) => {
                    ipopt::AddIpoptIntOption(self.problem, key, *value).into_truth()
                        || ipopt::AddIpoptNumOption(self.problem, key, f64::from(*value)).into_truth()
                }
                OptionValue::Number(value) => ipopt::AddIpoptNumOption(self.problem, key, *value).into_truth(),
                OptionValue::Text(text) => CString::new(text.as_str()).is_ok_and(|text| {
                    ipopt::AddIpoptStrOption(self.problem, key, text.as_ptr().cast_mut()).into_truth()
                }),
            }
        }
    }

    /// Solves the problem that the session evaluates, from an iterate of [`Handle::starting_iterate`].
    ///
    /// # Panics
    /// When the lengths of the iterate are not those of the problem.
    pub fn solve(&self, iterate: &mut Iterate, session: &mut Session) -> Outcome {
        assert_eq!(self.mismatch(iterate), None, "an iterate has the lengths of its problem");
        let mut constraints = vec![0.0; self.constraints];
        let mut objective = 0.0;
        // SAFETY: all arrays have the lengths that the handle was created with; the session outlives the call.
        let status = unsafe {
            ipopt::IpoptSolve(
                self.problem,
                iterate.x.as_mut_ptr(),
                constraints.as_mut_ptr(),
                &mut objective,
                iterate.constraint_multipliers.as_mut_ptr(),
                iterate.lower_multipliers.as_mut_ptr(),
                iterate.upper_multipliers.as_mut_ptr(),
                std::ptr::from_mut(session).cast(),
            )
        };
        Outcome { status: SolveStatus::from_code(status), objective, constraints }
    }
}

impl Drop for Handle {
    fn drop(&mut self) {
        // SAFETY: the handle was created by Ipopt and is freed once.
        unsafe { ipopt::FreeIpoptProblem(self.problem) };
    }
}
