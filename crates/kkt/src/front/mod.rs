//! A stage's front, which covers the reference and all scenarios: its assembly and two ways to factorise it.

pub mod assembly;
pub mod bunch_kaufman;
pub mod general;
pub mod pose_elimination;
pub mod poses;
