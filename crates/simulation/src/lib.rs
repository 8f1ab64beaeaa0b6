//! Rollouts of a plan under injected errors with hard contacts, success statistics, and refinement by rollouts.
//!
//! A plan has converged when Ipopt says so. It is good when a body that tracks it under the impedance law reaches the
//! goal, also with errors that the plan does not model. The body is that of the plan: constant inertia, no gravity, no
//! gyroscopic term. It starts displaced by the injected offset, of which the controller never learns. After the last
//! knot the reference rests for the settling time; then the outcome is evaluated.
//!
//! ```
//! use simulation::{Reference, Rollout, Settings, SettingsError, Success, offsets};
//! use workers::Workers;
//!
//! /// Number of successes in 100 rollouts with random offsets.
//! fn successes(task: &task::AssemblyTask, plan: &task::Trajectory) -> Result<usize, SettingsError> {
//!     let reference = Reference::from(plan);
//!     let settings = Settings { friction: 0.1, ..Settings::default() };
//!     settings.validate_for(&reference)?;
//!     let rollout = Rollout::new(task, settings);
//!     let outcomes = rollout.simulate(&reference, &offsets::hull(&task.offsets(), 100, 1), &Workers::new(2));
//!     Ok(outcomes.iter().filter(|outcome| outcome.reaches_goal(&Success::default())).count())
//! }
//! ```
//!
//! With an [`ArmModel`] ([`Rollout::with_arm`]), rollouts simulate the whole arm in joint space: its mass matrix, Coriolis
//! torques, dry friction of the joints, torque limits, and a controller with samples and a delay. The part may sit elsewhere
//! in the gripper than the robot believes, and a [`Disturbance`] makes arm, controller and edges differ from their models.
//! The model leaves out gravity, which the arm compensates, limits of positions and speeds, and elasticity. The null space
//! of a redundant arm has no control torques: only joint friction brakes motions in it.
//!
//! | question | answer |
//! |---|---|
//! | how does the arm move? | semi-implicit Euler in joint space, and the midpoint rule in longer steps, with the mass matrix of a nearby configuration; `arm_dynamics`, `step_length` |
//! | what do contacts see? | the part as a free body with the inertia `(J M^-1 J')^-1`: the same solver; `contact_solver` |
//! | how do joints stick? | exactly: torques within their Coulomb bounds, by projected Gauss-Seidel; `joint_friction` |
//! | when does the controller act? | `sampled_controller` |
//!
//! An [`Evaluator`] simulates a reference in several [`TestCase`]s. A [`Refinement`] perturbs the reference until it passes
//! all of them. It keeps snapshots of earlier rollouts, and simulates only what follows a perturbation; outcomes are the
//! same to the last bit. A [`FinalOscillation`] ends a reference where dry friction would hold the body short of the goal.
//! A [`hardened`](Evaluator::hardened) evaluator has more friction, and its contact forces count friction of other contacts
//! as reversed ([`Rollout::with_reversed_friction`]).
//!
//! Contacts are neither smoothed nor relaxed, and the planner's collision kernel is not used, so errors of the planner's
//! physics show here. Contact points come from the facets and edges that touch; a flat contact has all of its points. Edges
//! are sharp unless a [`Disturbance`] gives them a radius: then faces that overlap by less do not touch, as if corners of
//! that size were cut off, and narrower facets count as edges. The velocity after a step is exactly the nearest one in
//! kinetic energy that avoids penetration. The method is of first order in the time step; where the velocity changes little,
//! steps are longer and of second order. Results are deterministic and do not depend on the number of threads.
//!
//! Settings, tolerances and numbers of offsets have ranges: callers check them with [`Settings::validate_for`],
//! [`Success::validate`] and [`offsets::validate_count`]. A rollout with settings out of range is not computed and
//! counts as diverged.
//!
//! The paper is *Robust Rigid Body Assembly via Contact-Implicit Optimal Control with Exact Second-Order Derivatives*
//! by Dietz et al., numbers as in the preprint:
//!
//! | paper | label | here |
//! |---|---|---|
//! | Eq. (17), Moreau's time stepping | `Eq. ts` | [`Rollout::play`], `dynamics::Stepper::step`, `arm_dynamics::ArmStepper::step` |
//! | Eq. (17c), contacts without penetration | `Eq. ts3` | `contact_solver::ContactSolver::resolve` |
//! | Eq. (18), impedance law | `Eq. impedancewrench` | `dynamics::Stepper::free_velocity` |
//! | zero level of Eq. (1), signed distance | `Eq. sdfopt` | `contact::ContactFinder::find` |
//! | `P_q^-1` of the start, Sec. V-B | `Sec. ocp:ocp` | [`task::GraspError::actual`] |
//! | Fig. 12, success rates under injected offsets | `Fig. realworldresults` | [`Success`], [`wilson_interval`], [`offsets`] |

mod admittance_dynamics;
mod arc;
mod arm_dynamics;
mod arm_mobility;
mod arm_model;
mod arm_terms;
mod axis;
mod body;
mod bounds;
mod candidates;
mod contact;
mod contact_solver;
mod disturbance;
mod dynamics;
mod evaluator;
mod final_oscillation;
mod joint_friction;
mod latency;
mod least_distance;
mod loads;
mod metric;
mod motion;
pub mod offsets;
mod overshoot;
mod patch;
mod perturbation;
mod plant;
mod reference;
mod refinement;
mod rollout;
mod rollout_state;
mod sampled_controller;
mod settings;
mod settings_error;
mod solid;
mod spiral_search;
mod step_length;
mod success;
mod timed_state;

pub use arm_model::{ArmModel, ArmModelError};
pub use bounds::{Bounds, LIMIT_SLACK};
pub use disturbance::{Disturbance, Injection};
pub use evaluator::{Evaluator, FrictionIndex, TestCase, TestResult};
pub use final_oscillation::FinalOscillation;
pub use loads::{Loads, larger};
pub use overshoot::Overshoot;
pub use perturbation::Perturbation;
pub use reference::{Knot, Reference};
pub use refinement::Refinement;
pub use rollout::{Outcome, Rollout};
pub use settings::Settings;
pub use settings_error::SettingsError;
pub use solid::{Edge, Facet, Solid};
pub use spiral_search::SpiralSearch;
pub use success::{Success, wilson_interval};
pub use timed_state::TimedState;
