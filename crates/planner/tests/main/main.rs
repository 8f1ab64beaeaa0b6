//! The library as a program uses it.

mod arm_courses;
mod arm_drafts;
mod attempts;
mod clock;
mod engagement;
mod examples;
mod explanations;
mod files;
mod robust_plans;
mod support;
