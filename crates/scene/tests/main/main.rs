//! Good and bad files, and what is said about them.

mod documentation;
mod files;
mod homotopies;
mod interfaces;
mod links;
mod meshes;
mod mutations;
mod robots;
mod scenes;
mod schemas;
mod sizes;
mod support;
mod wrong_scenes;
