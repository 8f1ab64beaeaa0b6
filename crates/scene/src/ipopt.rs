//! Entries of `[ipopt]`: which options a file may set, and to what.

use task::{IpoptOption, IpoptValue};

use crate::entry::Entry;
use crate::error::SceneError;
use crate::keys::{Key, Values};
use crate::table::Table;

/// Most entries of a table.
pub const MOST_ENTRIES: usize = 50;

/// Options that a file may not set, with the reason and what to do instead. `*` stands for any text.
const REFUSED: [(&str, &str); 21] = [
    ("mu_init", "it changes from one homotopy step to the next; use homotopy.mu_init and homotopy.mu_rate"),
    ("linear_solver", "the program has to prepare it; use homotopy.linear_solver or --linear-solver"),
    ("hessian_approximation", "the program has to compute what Ipopt expects; use homotopy.hessian"),
    (
        "jacobian_approximation gradient_approximation findiff_perturbation",
        "first derivatives are always exact; to approximate second derivatives, use homotopy.hessian",
    ),
    (
        "hessian_constant jac_c_constant jac_d_constant grad_f_constant num_linear_variables",
        "the problem is nonlinear, and Ipopt would use outdated derivatives; to save time, use homotopy.hessian",
    ),
    (
        "derivative_test derivative_test_* point_perturbation_radius",
        "Ipopt would print the result, which is not shown; use `cargo test -p ocp`, which tests all derivatives",
    ),
    (
        "print_timing_statistics timing_statistics",
        "the program needs these times for its own statistics; use the times in result.json",
    ),
    (
        "output_file file_print_level file_append",
        "the program reads Ipopt's log itself and deletes it; use the progress that solve prints, and result.json",
    ),
    (
        "print_* *_print_level pardiso_msglvl sb suppress_all_output inf_pr_output",
        "Ipopt's log is not shown; use the progress that solve prints, and result.json",
    ),
    ("option_file_name", "results must not depend on a second file; use [ipopt] for its options"),
    (
        "warm_start_init_point warm_start_same_structure warm_start_entire_iterate",
        "each homotopy step starts from the solution of the one before; use warm_start_bound_push and the other \
         warm_start_*_push and warm_start_*_frac to say how close",
    ),
    (
        "linear_system_scaling linear_scaling_on_demand",
        "results must not depend on whether HSL is installed; use nlp_scaling_method",
    ),
    (
        "dependency_detector dependency_detection_with_rhs fixed_variable_treatment replace_bounds \
         limited_memory_aug_solver",
        "it would change the rows of the linear systems, which the linear solver `stage` knows; use Ipopt's default",
    ),
    (
        "nlp_lower_bound_inf nlp_upper_bound_inf",
        "bounds could get lost; to do without a limit, use a scene that does not give it in [limits]",
    ),
    ("skip_finalize_solution_call", "the solution would get lost; use Ipopt's default"),
    ("obj_scaling_factor", "a negative factor would maximise the cost; use nlp_scaling_obj_target_gradient"),
    ("mehrotra_algorithm", "it is made for linear programs, and Ipopt may crash; use mu_strategy = \"adaptive\""),
    ("warm_start_target_mu", "Ipopt may crash; use homotopy.mu_init and homotopy.mu_rate"),
    ("hsllib", "libraries are not loaded by path; install HSL as libhsl.so and use homotopy.linear_solver"),
    ("pardisolib", "libraries are not loaded by path; use homotopy.linear_solver"),
    (
        "ma28_* ma77_* ma86_* pardiso_* spral_* wsmp_*",
        "this linear solver cannot be chosen; use homotopy.linear_solver and the options of the one that it names",
    ),
];

/// Choices of an option that a file may not make, with the reason and what to do instead.
const REFUSED_CHOICES: [(&str, &str, &str); 2] = [
    (
        "nlp_scaling_method",
        "equilibration-based",
        "Ipopt ends the program where HSL is not installed; use gradient-based or none",
    ),
    ("nlp_scaling_method", "user-scaling", "the program gives no scaling factors; use gradient-based or none"),
];

/// Why an option may not be set.
pub fn refusal(name: &str) -> Option<&'static str> {
    let fits = |pattern: &str| match pattern.split_once('*') {
        Some((start, end)) => name.starts_with(start) && name.ends_with(end),
        None => name == pattern,
    };
    REFUSED.iter().find(|(patterns, _)| patterns.split(' ').any(fits)).map(|(_, reason)| *reason)
}

/// Why an option may not be set to this.
pub fn refusal_of_choice(option: &Key, text: &str) -> Option<&'static str> {
    let found = REFUSED_CHOICES.iter().find(|(name, choice, _)| (*name, *choice) == (option.name, text));
    found.filter(|_| option.table == "ipopt").map(|(_, _, reason)| *reason)
}

/// The options that a table gives, by name.
///
/// # Errors
/// The first entry that is wrong, with its place.
pub fn options(table: &Table) -> Result<Vec<IpoptOption>, SceneError> {
    let entries = table.given();
    if let Some(entry) = entries.get(MOST_ENTRIES) {
        return Err(entry.refuse_name(format!("[ipopt] has more than {MOST_ENTRIES} entries")));
    }
    let mut options = entries.iter().map(option).collect::<Result<Vec<_>, SceneError>>()?;
    options.sort_by(|one, other| one.name.cmp(&other.name));
    Ok(options)
}

fn option(entry: &Entry) -> Result<IpoptOption, SceneError> {
    let (name, path) = (entry.key().name, entry.path());
    if let Some(reason) = refusal(name) {
        return Err(entry.refuse_name(format!("{path} cannot be set: {reason}")));
    }
    let value = match entry.key().values {
        Values::Integer(_) => IpoptValue::Integer(entry.integer()? as i32),
        Values::Number(_) => IpoptValue::Number(entry.number()?),
        _ => {
            let word = entry.key().words()[entry.choice()?];
            if let Some(reason) = refusal_of_choice(entry.key(), word) {
                return Err(entry.refuse(format!("{path} cannot be `{word}`: {reason}")));
            }
            IpoptValue::Text(word.to_owned())
        }
    };
    Ok(IpoptOption { name: name.to_owned(), value })
}
