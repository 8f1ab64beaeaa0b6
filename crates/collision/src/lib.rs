//! Smoothed signed distances and contact normals of convex polytopes (skeleton of the public interface).
#![allow(unused_variables, dead_code)]

/// Why a description is not a convex polytope that can be used.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PolytopeError {
    /// Placeholder.
    #[error("placeholder")]
    Placeholder,
}

/// A distance that could not be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("distance did not converge")]
pub struct DistanceError {
    /// index of the pose in the batch
    pub index: usize,
    /// the pose
    pub pose: [f64; 7],
    /// smoothing
    pub tau: f64,
    /// relative residual reached
    pub residual: f64,
}

/// A bounded convex polytope `{p | normals p <= offsets}` with unit rows and its vertices, in its own frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Polytope {
    normals: Vec<[f64; 3]>,
    offsets: Vec<f64>,
    vertices: Vec<[f64; 3]>,
}

impl Polytope {
    /// Convex hull of points (m).
    pub fn from_vertices(vertices: &[[f64; 3]]) -> Result<Self, PolytopeError> {
        todo!()
    }
    /// Box with edge lengths (m), centred at the origin.
    pub fn from_box(edge_lengths: [f64; 3]) -> Result<Self, PolytopeError> {
        todo!()
    }
    /// Intersection of halfspaces `normals[k] . p <= offsets[k]`.
    pub fn from_halfspaces(normals: &[[f64; 3]], offsets: &[f64]) -> Result<Self, PolytopeError> {
        todo!()
    }
    /// Unit outward normals.
    pub fn normals(&self) -> &[[f64; 3]] {
        &self.normals
    }
    /// Offsets (m).
    pub fn offsets(&self) -> &[f64] {
        &self.offsets
    }
    /// Vertices (m).
    pub fn vertices(&self) -> &[[f64; 3]] {
        &self.vertices
    }
    /// The same polytope moved by a unit quaternion (w, x, y, z) and then a translation (m).
    pub fn placed(&self, position: [f64; 3], orientation: [f64; 4]) -> Polytope {
        todo!()
    }
}

/// A polytope of the moved body (in the body frame) and one of the environment (in the world frame).
#[derive(Debug, Clone)]
pub struct Pair {
    body: Polytope,
    environment: Polytope,
}

/// Smoothed distance and contact normal at one pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distance {
    /// `Phi_tau = 2 alpha_tau` (m).
    pub smoothed_distance: f64,
    /// `n_tau` in R^7 (Eq. contactvectordef).
    pub contact_normal: [f64; 7],
}

impl Pair {
    /// A pair, parts already placed in the body frame and the world frame.
    pub fn new(body: Polytope, environment: Polytope) -> Self {
        Self { body, environment }
    }
    /// `Phi_0` (m) at a pose (position, quaternion of any norm).
    pub fn exact_distance(&self, pose: &[f64; 7]) -> f64 {
        todo!()
    }
    /// `(Phi_tau, n_tau)` at the normalised pose.
    pub fn distance(&self, pose: &[f64; 7], tau: f64) -> Result<Distance, DistanceError> {
        todo!()
    }
    /// Contact information `W(q) = (Phi_tau(q~), Q(q~)' n_tau(q~))` in R^7 at many poses.
    pub fn contacts(&self, poses: &[[f64; 7]], tau: f64, values: &mut [[f64; 7]]) -> Result<(), DistanceError> {
        todo!()
    }
    /// `W` and `DW` (7 x 7, rows are components of `W`, columns raw pose coordinates) at many poses.
    pub fn contact_jacobians(
        &self,
        poses: &[[f64; 7]],
        tau: f64,
        values: &mut [[f64; 7]],
        jacobians: &mut [[[f64; 7]; 7]],
    ) -> Result<(), DistanceError> {
        todo!()
    }
    /// `W`, `DW` and `<s, D2W>` (7 x 7 symmetric) at many poses with one seed `s` in R^7 per pose.
    pub fn contact_hessians(
        &self,
        poses: &[[f64; 7]],
        tau: f64,
        seeds: &[[f64; 7]],
        values: &mut [[f64; 7]],
        jacobians: &mut [[[f64; 7]; 7]],
        hessians: &mut [[[f64; 7]; 7]],
    ) -> Result<(), DistanceError> {
        todo!()
    }
}
