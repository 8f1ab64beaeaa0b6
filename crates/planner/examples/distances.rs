//! Smoothed distance of two parts with its derivative by the pose: `cargo run -p planner --example distances`.

use collision::{Pair, Polytope, Solutions};

/// Position (m) and unit quaternion (w x y z).
type Pose = [f64; 7];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let pair = peg_and_wall()?;
    println!("height (m)  exact (m)  smoothed (m)  d/dz");
    for height in [0.03, 0.02, 0.012, 0.01, 0.009] {
        let pose = [0.0, 0.0, height, 1.0, 0.0, 0.0, 0.0];
        let (smoothed, gradient) = distance(&pair, &pose, 1e-4)?;
        println!("{height:10.3}  {:9.5}  {smoothed:12.5}  {:.3}", pair.exact_distance(&pose), gradient[2]);
    }
    Ok(())
}

/// A cube of 20 mm above a plate with its upper face at z = 0.
///
/// # Errors
/// Never: both shapes are valid.
pub fn peg_and_wall() -> Result<Pair, collision::PolytopeError> {
    let plate = Polytope::from_box([0.2, 0.2, 0.02])?.placed([0.0, 0.0, -0.01], [1.0, 0.0, 0.0, 0.0]);
    Ok(Pair::new(Polytope::from_box([0.02; 3])?, plate))
}

/// The distance at a pose, smoothed by `tau` (N m), and its gradient by the seven numbers of the pose. Both are components
/// of the contact information `W = (Phi, Q' n)` and its Jacobian; [`Pair::contact_hessians`] has second derivatives.
///
/// # Errors
/// When the distance problem cannot be solved.
pub fn distance(pair: &Pair, pose: &Pose, tau: f64) -> Result<(f64, Pose), collision::DistanceError> {
    let (mut values, mut jacobians) = ([[0.0; 7]], [[[0.0; 7]; 7]]);
    // Solutions are kept between requests: derivatives at the same poses do not solve again.
    let mut solutions = Solutions::default();
    pair.contact_jacobians(&[*pose], tau, &mut solutions, &mut values, &mut jacobians)?;
    Ok((values[0][0], jacobians[0][0]))
}
