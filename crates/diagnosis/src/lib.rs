//! Why a scene or a plan does not work, and what to try: [`check`](mod@check) looks at a scene before it is solved, [`warnings`] at
//! what is odd about problems and plans, and [`explain`] at plans that are not done.

pub mod check;
pub mod explain;
pub mod warnings;
