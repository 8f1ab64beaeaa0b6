//! A stage's front, all scenarios and the reference together: how it is assembled, and two ways to factorise it.

pub mod assembly;
pub mod bunch_kaufman;
pub mod general;
pub mod pose_elimination;
pub mod poses;
