//! The chart of poses by raw coordinates. It takes derivatives along `u = (translation, rotation vector)` in the
//! contact frame to the contact information `W(q) = (Phi, Q' n)`, or `(Phi, Q' n, p)` with the contact point, at the
//! normalised pose and its derivatives by raw coordinates.

use pulp::Simd;

use crate::derivatives::{DIRECTIONS, DirectionMatrix, First, Seed, skew};
use crate::lane::{Lane, Vector, array, column, cross, dot, rotate};

/// Number of coordinates of a pose (position, quaternion).
pub const POSE: usize = 7;
/// Number of components of the contact information `(Phi, Q' n)`.
pub const CONTACT: usize = 7;
/// Number of components of the contact information with the contact point, `(Phi, Q' n, p)`.
pub const CONTACT_AND_POINT: usize = CONTACT + 3;

/// The first `COMPONENTS` components of the contact information, from distance, normal and contact point in the
/// coordinates of the result.
#[inline(always)]
pub fn contact_information<S: Simd, const COMPONENTS: usize>(
    distance: Lane<S>,
    normal: &[Lane<S>; DIRECTIONS],
    point: &Vector<S>,
) -> [Lane<S>; COMPONENTS] {
    array!(|component| match component {
        0 => distance,
        1..CONTACT => normal[component - 1],
        _ => point[component - CONTACT],
    })
}

/// A pose per lane, with the rotation of its quaternion and the derivatives of that rotation.
pub struct Placement<S: Simd> {
    /// Position (m).
    pub position: Vector<S>,
    /// Rotation matrix of the normalised quaternion.
    pub rotation: [Vector<S>; 3],
    /// Derivative of the rotation vector by the raw quaternion: `2 vec(d xi (x) xi^-1)`.
    turn: [[Lane<S>; 4]; 3],
    /// Derivative of the logarithm of the quaternion's norm by the raw quaternion.
    growth: [Lane<S>; 4],
}

impl<S: Simd> Placement<S> {
    /// From pose coordinates, the quaternion of any norm.
    #[inline(always)]
    pub fn new(simd: S, pose: &[Lane<S>; POSE]) -> Self {
        let [x, y, z, raw @ ..] = *pose;
        let position = [x, y, z];
        let mut square = Lane::splat(simd, 0.0);
        for component in raw {
            square = component.mul_add(component, square);
        }
        let inverse_square = square.recip();
        let growth: [Lane<S>; 4] = array!(|index| raw[index] * inverse_square);
        let scale = square.sqrt().recip();
        let [w, x, y, z]: [Lane<S>; 4] = array!(|index| raw[index] * scale);
        let two = Lane::splat(simd, 2.0);
        let rotation = rotation_matrix(w, [x, y, z]);
        let [w, x, y, z]: [Lane<S>; 4] = array!(|index| two * growth[index]);
        let turn = [[-x, w, -z, y], [-y, z, w, -x], [-z, -y, x, w]];
        Self { position, rotation, turn, growth }
    }

    /// Contact normal `n_tau` in R^7 at the normalised pose. Its radial component is that of the homogeneous rotation
    /// matrix.
    #[inline(always)]
    pub fn pose_normal(&self, force: &Vector<S>, lever: &Vector<S>) -> [Lane<S>; POSE] {
        let torque = cross(force, lever);
        let two = force[0].constant(2.0);
        let radial = two * dot(force, lever);
        array!(|index| {
            if index < 3 {
                return -force[index];
            }
            let component = index - 3;
            let tangential = dot(&column(&self.turn, component), &torque);
            radial.mul_add(self.growth[component], tangential)
        })
    }
}

/// Rotation matrix of a unit quaternion.
#[inline(always)]
fn rotation_matrix<S: Simd>(w: Lane<S>, [x, y, z]: Vector<S>) -> [Vector<S>; 3] {
    let (one, two) = (w.constant(1.0), w.constant(2.0));
    let (xx, yy, zz) = (x * x, y * y, z * z);
    let (wx, wy, wz) = (w * x, w * y, w * z);
    [
        [one - two * (yy + zz), two * x.mul_add(y, -wz), two * x.mul_add(z, wy)],
        [two * x.mul_add(y, wz), one - two * (xx + zz), two * y.mul_add(z, -wx)],
        [two * x.mul_add(z, -wy), two * y.mul_add(z, wx), one - two * (xx + yy)],
    ]
}

/// Maps between the contact frame and the pose coordinates.
pub struct Map<S: Simd> {
    /// Rotation from world to contact frame.
    frame: [Vector<S>; 3],
    /// Rotation from body to contact frame.
    body_frame: [Vector<S>; 3],
    /// Derivative of the rotation vector, in the contact frame, by the raw quaternion.
    turn: [[Lane<S>; 4]; 3],
    /// Derivative of the logarithm of the quaternion's norm by the raw quaternion.
    growth: [Lane<S>; 4],
}

impl<S: Simd> Map<S> {
    /// For a contact frame at a pose.
    #[inline(always)]
    pub fn new(frame: [Vector<S>; 3], place: &Placement<S>) -> Self {
        let columns: [Vector<S>; 3] = array!(|axis| rotate(&frame, &column(&place.rotation, axis)));
        let turned: [Vector<S>; 4] = array!(|component| { rotate(&frame, &column(&place.turn, component)) });
        Self {
            frame,
            body_frame: array!(|row| array!(|axis| columns[axis][row])),
            turn: array!(|row| array!(|component| turned[component][row])),
            growth: place.growth,
        }
    }

    /// `n~ = Q' n`: force in the world frame, torque in the body frame.
    #[inline(always)]
    pub fn normal(&self, normal: &[Lane<S>; DIRECTIONS]) -> [Lane<S>; DIRECTIONS] {
        self.to_twist(normal)
    }

    /// `DW`: rows are components of `W`, columns raw pose coordinates.
    #[inline(always)]
    pub fn jacobian<const COMPONENTS: usize>(&self, simd: S, first: &First<S>) -> [[Lane<S>; POSE]; COMPONENTS] {
        let along = self.normal_derivative(simd, first);
        let mut columns = [[Lane::splat(simd, 0.0); DIRECTIONS]; DIRECTIONS];
        for (direction, column) in columns.iter_mut().enumerate() {
            *column = self.to_twist(&array!(|row| along[row][direction]));
        }
        array!(|component| {
            let along_directions = match component {
                0 => first.distance,
                1..CONTACT => array!(|direction| columns[direction][component - 1]),
                _ => {
                    let axis = column(&self.frame, component - CONTACT);
                    array!(|direction| dot(&axis, &point_derivative(first, direction)))
                }
            };
            self.to_pose(&along_directions)
        })
    }

    /// The seed of `W` in the contact frame.
    #[inline(always)]
    pub fn seed<const COMPONENTS: usize>(&self, seed: &[Lane<S>; COMPONENTS]) -> Seed<S> {
        let shift = rotate(&self.frame, &[seed[1], seed[2], seed[3]]);
        let spin = rotate(&self.body_frame, &[seed[4], seed[5], seed[6]]);
        let point = (COMPONENTS == CONTACT_AND_POINT)
            .then(|| rotate(&self.frame, &[seed[CONTACT], seed[CONTACT + 1], seed[CONTACT + 2]]));
        Seed { distance: seed[0], normal: [shift[0], shift[1], shift[2], spin[0], spin[1], spin[2]], point }
    }

    /// `<s, D2W>` by raw pose coordinates from `<s, D2 (Phi, V', p)>` along `u`.
    #[inline(always)]
    pub fn hessian(
        &self,
        simd: S,
        first: &First<S>,
        mut along: DirectionMatrix<S>,
        seed: &Seed<S>,
    ) -> [[Lane<S>; POSE]; POSE] {
        let torque = [first.normal[3], first.normal[4], first.normal[5]];
        let spin = [seed.normal[3], seed.normal[4], seed.normal[5]];
        add_chart_terms(simd, &mut along, &first.curvature, &torque, &spin);
        let derivative = self.normal_derivative(simd, first);
        let gradient: Vector<S> = array!(|axis| {
            let mut sum = seed.distance * first.distance[3 + axis];
            for row in 0..DIRECTIONS {
                sum = seed.normal[row].mul_add(derivative[row][3 + axis], sum);
            }
            if let Some(point) = &seed.point {
                sum += dot(point, &point_derivative(first, 3 + axis));
            }
            sum
        });
        let half: [[Lane<S>; POSE]; DIRECTIONS] = array!(|row| self.to_pose(&along[row]));
        let columns: [[Lane<S>; POSE]; POSE] = array!(|column| { self.to_pose(&array!(|row| half[row][column])) });
        // Second derivative of the rotation vector: the longer the quaternion, the less a change of it rotates.
        let turned = self.turned(&gradient);
        let mut hessian = columns;
        for row in 0..4 {
            for column in 0..4 {
                let product = self.growth[row].mul_add(turned[column], turned[row] * self.growth[column]);
                hessian[3 + row][3 + column] -= product;
            }
        }
        hessian
    }

    /// Derivative along `u` of the normal as force and torque in the contact frame: `V''`, plus `[torque] / 2` in the
    /// rotations, because the gradient by a rotation vector equals the torque only where that vector is zero.
    #[inline(always)]
    fn normal_derivative(&self, simd: S, first: &First<S>) -> DirectionMatrix<S> {
        let half = Lane::splat(simd, 0.5);
        let twist = skew(simd, &[first.normal[3], first.normal[4], first.normal[5]]);
        let mut along = first.curvature;
        for row in 0..3 {
            for column in 0..3 {
                along[3 + row][3 + column] = half.mul_add(twist[row][column], along[3 + row][3 + column]);
            }
        }
        along
    }

    /// A wrench in the contact frame as force in world axes and torque in body axes.
    #[inline(always)]
    fn to_twist(&self, wrench: &[Lane<S>; DIRECTIONS]) -> [Lane<S>; DIRECTIONS] {
        array!(|index| {
            let (matrix, axis, start) =
                if index < 3 { (&self.frame, index, 0) } else { (&self.body_frame, index - 3, 3) };
            dot(
                &[matrix[0][axis], matrix[1][axis], matrix[2][axis]],
                &[wrench[start], wrench[start + 1], wrench[start + 2]],
            )
        })
    }

    /// A gradient along `u` as a gradient by raw pose coordinates.
    #[inline(always)]
    fn to_pose(&self, gradient: &[Lane<S>; DIRECTIONS]) -> [Lane<S>; POSE] {
        let shift = [gradient[0], gradient[1], gradient[2]];
        let turned = self.turned(&[gradient[3], gradient[4], gradient[5]]);
        array!(|index| {
            if index >= 3 {
                return turned[index - 3];
            }
            dot(&column(&self.frame, index), &shift)
        })
    }

    /// A gradient by the rotation vector as a gradient by the raw quaternion.
    #[inline(always)]
    fn turned(&self, gradient: &Vector<S>) -> [Lane<S>; 4] {
        array!(|component| { dot(&column(&self.turn, component), gradient) })
    }
}

/// Derivative of the contact point along a direction, in the contact frame.
#[inline(always)]
fn point_derivative<S: Simd>(first: &First<S>, direction: usize) -> Vector<S> {
    array!(|axis| first.solution[axis][direction])
}

/// Adds the second-order difference between the gradient by a rotation vector `theta` and the torque in body axes:
/// `(I - [theta] / 2 + [theta]^2 / 12) V_theta`.
#[inline(always)]
fn add_chart_terms<S: Simd>(
    simd: S,
    along: &mut DirectionMatrix<S>,
    curvature: &DirectionMatrix<S>,
    torque: &Vector<S>,
    spin: &Vector<S>,
) {
    let (half, twelfth) = (Lane::splat(simd, 0.5), Lane::splat(simd, 1.0 / 12.0));
    for column in 0..DIRECTIONS {
        let change = cross(spin, &[curvature[3][column], curvature[4][column], curvature[5][column]]);
        for row in 0..3 {
            along[3 + row][column] = half.mul_add(change[row], along[3 + row][column]);
            along[column][3 + row] = half.mul_add(change[row], along[column][3 + row]);
        }
    }
    let aligned = dot(spin, torque);
    for row in 0..3 {
        for column in 0..3 {
            let product = spin[row].mul_add(torque[column], torque[row] * spin[column]);
            along[3 + row][3 + column] = twelfth.mul_add(product, along[3 + row][3 + column]);
        }
        along[3 + row][3 + row] -= twelfth * (aligned + aligned);
    }
}
