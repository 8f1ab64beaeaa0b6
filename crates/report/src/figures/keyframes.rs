//! Sections through the parts at some moments: one outline of the body per scenario, the reference dashed.

use task::Pose;

use super::section::{others, section};
use super::svg::{Anchor, COLOURS, Drawing, Hex};
use crate::model::{MotionData, PartData, PlanData};

/// Names of the axes.
pub const AXES: [&str; 3] = ["x", "y", "z"];

const PANELS: usize = 6;
const PANEL: f64 = 170.0;
const MARGIN: f64 = 6.0;
const TITLE: f64 = 22.0;
/// Room around the body, in its largest extents.
const ROOM: f64 = 1.1;
/// Share of the largest contact force from which on there is contact.
const CONTACT: f64 = 0.05;

/// Draws the section at the goal across an axis.
pub fn draw(plan: &PlanData, axis: usize) -> String {
    let motion = &plan.motions[0];
    let steps = moments(motion);
    let width = PANELS as f64 * (PANEL + MARGIN) + MARGIN;
    let mut drawing = Drawing::new(width, PANEL + TITLE + MARGIN);
    drawing.push(&format!("<clipPath id=\"panel\"><rect width=\"{PANEL}\" height=\"{PANEL}\"/></clipPath>"));
    let frame = Frame::new(plan, motion, &steps, axis);
    for (index, &step) in steps.iter().enumerate() {
        let left = MARGIN + index as f64 * (PANEL + MARGIN);
        let time = format!("{:.2} s", step as f64 * motion.time_step);
        drawing.text([left + 0.5 * PANEL, 15.0], Anchor::Middle, &time);
        drawing.push(&format!("<g transform=\"translate({left} {TITLE})\" clip-path=\"url(#panel)\">"));
        drawing.rectangle([0.0, 0.0], [PANEL, PANEL], "fill=\"#f5f6f8\"");
        panel(&mut drawing, plan, motion, step, &frame);
        drawing.push("</g>");
    }
    drawing.finish()
}

/// From the first contact to the end in equal steps of time.
fn moments(motion: &MotionData) -> Vec<usize> {
    let last = motion.reference.len() / 7 - 1;
    let forces = || motion.scenarios.iter().map(|scenario| &scenario.forces);
    let largest = forces().flatten().copied().fold(0.0, f64::max);
    let touches =
        |step: &usize| forces().any(|forces| forces.get(*step).is_some_and(|force| *force > CONTACT * largest));
    let first = (0..last).find(touches).unwrap_or(0);
    (0..PANELS).map(|panel| first + (last - first) * panel / (PANELS - 1)).collect()
}

/// Section of the world in a panel.
struct Frame {
    axis: usize,
    /// Where the plane cuts the axis (m).
    at: f64,
    /// Middle of the panel (m).
    centre: [f64; 2],
    /// Pixels per m.
    scale: f64,
}

impl Frame {
    /// Around the body and its goal at all moments.
    fn new(plan: &PlanData, motion: &MotionData, steps: &[usize], axis: usize) -> Self {
        let axes = others(axis);
        let radius = |part: &PartData| {
            let corner = |corner: &[f64]| corner.iter().map(|value| value * value).sum::<f64>().sqrt();
            part.vertices.chunks_exact(3).map(corner).fold(0.0, f64::max)
        };
        let size = plan.body.iter().map(radius).fold(0.0, f64::max);
        let places = motion
            .scenarios
            .iter()
            .flat_map(|scenario| steps.iter().filter_map(|step| scenario.poses.get(7 * step..7 * step + 3)));
        let (mut low, mut high) = (axes.map(|axis| plan.goal[axis]), axes.map(|axis| plan.goal[axis]));
        for place in places {
            for (index, axis) in axes.into_iter().enumerate() {
                low[index] = low[index].min(place[axis]);
                high[index] = high[index].max(place[axis]);
            }
        }
        let spread = (high[0] - low[0]).max(high[1] - low[1]);
        let centre = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])];
        Self { axis, at: plan.goal[axis], centre, scale: PANEL / (spread + 2.0 * ROOM * size) }
    }

    fn pixel(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        [0.5 * PANEL + self.scale * (u - self.centre[0]), 0.5 * PANEL - self.scale * (v - self.centre[1])]
    }
}

/// The pose of a step, from seven numbers for each.
fn pose(poses: &[f64], step: usize) -> Option<Pose> {
    poses.as_chunks().0.get(step).copied().map(Pose)
}

fn panel(drawing: &mut Drawing, plan: &PlanData, motion: &MotionData, step: usize, frame: &Frame) {
    let parts = |parts: &[PartData], pose: &Pose, style: &str, drawing: &mut Drawing| {
        for part in parts {
            let polygon = section(part, &pose.isometry(), frame.axis, frame.at);
            if polygon.len() > 2 {
                drawing.points("polygon", polygon.into_iter().map(|point| frame.pixel(point)), style);
            }
        }
    };
    parts(&plan.environment, &Pose::IDENTITY, "fill=\"#b4bac4\" stroke=\"#808894\" stroke-width=\"0.5\"", drawing);
    for (index, scenario) in motion.scenarios.iter().enumerate() {
        let Some(pose) = pose(&scenario.poses, step) else { continue };
        // Fills cover the strokes between parts, and the group is transparent as a whole: one outline per body.
        drawing.push(&format!("<g opacity=\"0.5\" fill=\"{}\">", Hex(COLOURS[index % COLOURS.len()])));
        for style in ["stroke=\"#303030\" stroke-width=\"2\"", ""] {
            parts(&plan.body, &pose, style, drawing);
        }
        drawing.push("</g>");
    }
    let dashed = "fill=\"none\" stroke=\"#000000\" stroke-dasharray=\"4 3\"";
    if let Some(reference) = pose(&motion.reference, step) {
        parts(&plan.body, &reference, dashed, drawing);
    }
}
