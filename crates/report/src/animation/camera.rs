//! How the world becomes a picture: a parallel projection from above and from the side on which the parts are cut open.

use nalgebra::{Isometry3, Vector3};

use super::solid::{Cut, Piece};

/// Width of pictures in pixels, and their least and largest height.
pub const WIDTH: f64 = 480.0;
const HEIGHTS: [f64; 2] = [270.0, 520.0];
/// Room between parts and edges, and for the bar of time, in pixels.
const MARGIN: f64 = 16.0;
/// How much of the environment is seen around the body, in extents of what it sweeps.
const AROUND: f64 = 0.45;
/// How much less a cut across x must hide than one across y, which is the usual one.
const CLEARLY: f64 = 0.8;
/// From the cut towards the viewer: sideways, straight ahead, upwards.
const VIEW: [f64; 3] = [0.42, 1.0, 0.55];

/// A projection.
#[derive(Debug, Clone)]
pub struct Camera {
    right: Vector3<f64>,
    up: Vector3<f64>,
    /// Towards the viewer.
    pub back: Vector3<f64>,
    /// What is in the upper left corner (m along right and up).
    corner: [f64; 2],
    /// Pixels per m.
    scale: f64,
    /// Height of the picture in pixels.
    pub height: f64,
}

/// The plane that shows a motion best: along the way and across the parts that touch. The nearer half of the parts is cut away.
///
/// `travel` is the way from the start to the goal (m), `pushed` how much forces push along each axis, `middle` where the body
/// ends (m).
pub fn plane(travel: Vector3<f64>, pushed: Vector3<f64>, middle: Vector3<f64>) -> Cut {
    let share = |of: Vector3<f64>| of.abs() / of.abs().sum().max(f64::MIN_POSITIVE);
    let hidden = share(travel) + share(pushed);
    let (axis, side) = if hidden.x < CLEARLY * hidden.y { (0, -1.0) } else { (1, 1.0) };
    Cut { axis, at: middle[axis], side }
}

impl Camera {
    /// Sees the body wherever it goes, and what is around of the environment.
    pub fn new(cut: Cut, environment: &[Piece], body: &[Piece], poses: &[Isometry3<f64>]) -> Self {
        let [sideways, ahead, upwards] = VIEW;
        let forwards = Vector3::ith(cut.axis, -cut.side);
        // To the right as the viewer sees it.
        let across = Vector3::z().cross(&forwards);
        let back = (sideways * across + ahead * forwards + upwards * Vector3::z()).normalize();
        let right = Vector3::z().cross(&back).normalize();
        let mut camera = Self { right, up: back.cross(&right), back, corner: [0.0; 2], scale: 1.0, height: 0.0 };
        let swept = poses.iter().flat_map(|pose| body.iter().map(move |piece| piece.moved(pose)));
        let [low, high] = camera.extent(swept.collect::<Vec<_>>().iter());
        let [least, most] = camera.extent(environment.iter());
        let room = AROUND * (high[0] - low[0]).max(high[1] - low[1]);
        let low = [0, 1].map(|axis| low[axis].min(least[axis].max(low[axis] - room)));
        let high = [0, 1].map(|axis| high[axis].max(most[axis].min(high[axis] + room)));
        camera.fit(low, high);
        camera
    }

    /// Puts a rectangle (m) in the middle of the picture.
    fn fit(&mut self, low: [f64; 2], high: [f64; 2]) {
        let [width, height] = [high[0] - low[0], high[1] - low[1]].map(|extent| extent.max(1e-9));
        let [least, most] = HEIGHTS;
        self.scale = ((WIDTH - 2.0 * MARGIN) / width).min((most - 2.0 * MARGIN) / height);
        self.height = (self.scale * height + 2.0 * MARGIN).clamp(least, most).round();
        let half = [0.5 * WIDTH / self.scale, 0.5 * self.height / self.scale];
        self.corner = [0.5 * (low[0] + high[0]) - half[0], 0.5 * (low[1] + high[1]) + half[1]];
    }

    /// Lowest and highest coordinates of pieces along right and up (m).
    fn extent<'a>(&self, pieces: impl Iterator<Item = &'a Piece>) -> [[f64; 2]; 2] {
        let mut extent = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for corner in pieces.flat_map(Piece::corners) {
            for (index, along) in [self.right.dot(corner), self.up.dot(corner)].into_iter().enumerate() {
                extent[0][index] = extent[0][index].min(along);
                extent[1][index] = extent[1][index].max(along);
            }
        }
        extent
    }

    /// Where a point (m) is in the picture, in pixels from its upper left corner.
    pub fn pixel(&self, point: &Vector3<f64>) -> [f64; 2] {
        [self.scale * (self.right.dot(point) - self.corner[0]), self.scale * (self.corner[1] - self.up.dot(point))]
    }

    /// How bright a facet is, from 0 to 1. The light comes from over the left shoulder of the viewer.
    pub fn light(&self, normal: &Vector3<f64>) -> f64 {
        let towards = (self.back - 0.35 * self.right + 0.75 * self.up).normalize();
        towards.dot(normal).max(0.0)
    }
}
