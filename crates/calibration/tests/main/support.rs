//! Scenes, and logs that rollouts with other values have written.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use calibration::{Calibration, Estimate, Log, Parameter, calibrate};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use plan::{Choices, Problem};
use simulation::{ArmModel, Reference, Rollout, Settings};
use task::{AssemblyTask, GraspError, Pose, State, Twist};
use tempfile::TempDir;
use workers::Workers;

/// A file of the project.
pub fn project(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap().join(name)
}

/// A scene for an arm of six joints: rotor inertia 0.1 kg m^2, joint friction 0.5 Nm.
pub fn arm_scene(name: &str) -> String {
    let scene = fs::read_to_string(project(&format!("scenes/{name}.toml"))).unwrap();
    let replaced = ["mass", "inertia", "translational_stiffness", "rotational_stiffness"];
    let kept = scene.lines().filter(|line| !replaced.iter().any(|key| line.starts_with(key)));
    let robot = fs::read_to_string(project("examples/arms/six.toml")).unwrap();
    let urdf = project("examples/arms/six.urdf");
    kept.map(|line| line.to_owned() + "\n").collect::<String>() + &robot.replace("six.urdf", urdf.to_str().unwrap())
}

/// A scene in a folder of its own, which ends with this value.
pub struct Workshop {
    pub folder: TempDir,
    pub problem: Problem,
}

/// What makes a robot differ from its scene.
pub struct Truth {
    pub arm: Option<ArmModel>,
    pub task: AssemblyTask,
    pub friction: f64,
    pub grasp: GraspError,
    /// Standard deviation of a component of measured positions (m) and orientations (rad).
    pub noise: f64,
}

impl Workshop {
    pub fn new(scene: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("scene.toml");
        fs::write(&file, scene).unwrap();
        let problem = Problem::load(&file, &Choices::default()).unwrap();
        Self { folder, problem }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// A robot that is as the scene says.
    pub fn truth(&self) -> Truth {
        let (arm, task) = (self.problem.arm(), self.problem.world());
        Truth { arm, task, friction: 0.0, grasp: GraspError::default(), noise: 2e-5 }
    }

    /// Reads logs and fits.
    #[track_caller]
    pub fn calibrate(&self, names: &[&str], per_joint: bool) -> Calibration {
        let logs: Vec<Log> =
            names.iter().map(|name| Log::read(&self.path(name), self.problem.scene()).unwrap()).collect();
        calibrate(&self.problem, &logs, per_joint, &Workers::default(), &|_| {}).unwrap()
    }

    /// A log of a robot that follows a reference; rows are as far apart as its knots. Gains are those of the scene.
    pub fn log(&self, name: &str, truth: &Truth, reference: &Reference, dry_run: f64) {
        let mut task = truth.task.clone();
        task.start = reference.start();
        if dry_run > 0.0 {
            task.pairs.clear();
        }
        let settings = Settings { friction: truth.friction, settling_time: 0.0, ..Settings::default() };
        let mut rollout = Rollout::new(&task, settings);
        if let Some(arm) = &truth.arm {
            rollout = rollout.with_arm(arm).unwrap().with_gains_set_for(task.goal.isometry().rotation);
        }
        let mut poses = vec![reference.start().isometry()];
        rollout.play(reference, truth.grasp, |state, _| {
            if state.time >= poses.len() as f64 * reference.time_step() - 1e-9 {
                poses.push(state.pose.isometry() * truth.grasp.believed());
            }
        });
        self.write_log(name, self.header(dry_run), reference, &poses, truth.noise, 5);
    }

    /// Writes where a robot was at each knot of its reference, with noise (m, rad) of a seed.
    pub fn write_log(
        &self,
        name: &str,
        header: serde_json::Value,
        reference: &Reference,
        poses: &[Isometry3<f64>],
        noise: f64,
        seed: u64,
    ) {
        let mut text = format!("# {header}\n{}\n", columns());
        let mut random = fastrand::Rng::with_seed(seed);
        let states = reference.states();
        for (knot, pose) in poses.iter().enumerate().take(states.len() - 1) {
            let time = knot as f64 * reference.time_step();
            // The sum of twelve uniform values has variance 1.
            let mut noise = || noise * ((0..12).map(|_| random.f64()).sum::<f64>() - 6.0);
            let (shift, rotation) = (Vector3::from_fn(|_, _| noise()), Vector3::from_fn(|_, _| noise()));
            let noisy = Isometry3::from_parts(
                (pose.translation.vector + shift).into(),
                pose.rotation * UnitQuaternion::from_scaled_axis(rotation),
            );
            let phase = if knot + 2 == states.len() { "resting" } else { "playing" };
            let numbers =
                [&[time][..], &Pose::from(&noisy)[..], &[0.0; 6], &[time], &states[knot][..7], &states[knot + 1][7..]];
            for number in numbers.concat() {
                write!(text, "{number},").unwrap();
            }
            writeln!(text, "{phase}").unwrap();
        }
        fs::write(self.path(name), text).unwrap();
    }

    /// The first line of a log of a robot that is commanded torques.
    pub fn header(&self, dry_run: f64) -> serde_json::Value {
        let scene = self.problem.scene();
        let [base, grasp] = scene.robot.as_ref().map_or([Pose::IDENTITY; 2], |robot| [robot.base, robot.grasp]);
        serde_json::json!({
            "format": 1, "scene": scene.title, "base": base, "grasp": grasp, "goal": scene.goal,
            "delta_m": scene.offset_magnitude, "dry_run_m": dry_run,
            "impedance": plan::records::ImpedanceRecord::from(&scene.impedance),
        })
    }
}

fn columns() -> String {
    let state = "px_m,py_m,pz_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s";
    let reference: Vec<String> = state.split(',').map(|name| format!("reference_{name}")).collect();
    format!("time_s,{state},elapsed_s,{},phase", reference.join(","))
}

/// From a pose along and about an axis after the other and back, a third of a second each.
pub fn test_motion(start: &Isometry3<f64>) -> Reference {
    let mut poses = vec![*start];
    for axis in 0..6 {
        let way = |axes: std::ops::Range<usize>, length: f64| {
            Vector3::from_fn(|row, _| if axes.start + row == axis { length } else { 0.0 })
        };
        let there = Isometry3::new(way(0..3, 0.015), way(3..6, 0.08));
        poses.extend([start * there, *start]);
    }
    through(&poses, 0.33)
}

/// Straight from pose to pose, each way and a short rest after it taking a time (s).
pub fn through(poses: &[Isometry3<f64>], seconds: f64) -> Reference {
    const TIME_STEP: f64 = 0.002;
    /// Part of the time in which the reference moves.
    const MOVING: f64 = 0.7;
    let count = (seconds / TIME_STEP) as usize;
    let mut path = vec![poses[0]];
    for pair in poses.windows(2) {
        path.extend((1..=count).map(|step| {
            let fraction = (step as f64 / (MOVING * count as f64)).min(1.0);
            task::pose::interpolate(&pair[0], &pair[1], fraction)
        }));
    }
    let state = |knot: usize| {
        let (now, before) = (&path[knot], &path[knot.saturating_sub(1)]);
        let velocity = (now.translation.vector - before.translation.vector) / TIME_STEP;
        let angular = (before.rotation.inverse() * now.rotation).scaled_axis() / TIME_STEP;
        State::new(&Pose::from(now), &Twist::new(&velocity, &angular))
    };
    Reference::new(TIME_STEP, &(0..path.len()).map(state).collect::<Vec<_>>())
}

/// The estimate of a parameter.
#[track_caller]
pub fn estimate(calibration: &Calibration, parameter: Parameter) -> &Estimate {
    calibration.estimates.iter().find(|estimate| estimate.quantity.parameter == parameter).unwrap()
}

/// Asserts that a parameter is known, and is within a distance of a value.
#[track_caller]
pub fn found(calibration: &Calibration, parameter: Parameter, expected: f64, tolerance: f64) {
    let Estimate { value, standard_error, .. } = estimate(calibration, parameter);
    let name = parameter.name();
    assert!((value - expected).abs() <= tolerance, "{name}: {value} +- {standard_error:?}, not {expected}");
    assert!(standard_error.is_some(), "{name} is not known");
}
