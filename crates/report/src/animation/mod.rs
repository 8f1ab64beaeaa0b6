//! Moving pictures of plans, for slides and pages: the parts in a parallel projection, cut open across an axis like those of the
//! figures, and moving as the page of the plan shows them first.
//!
//! | module | content |
//! |---|---|
//! | `solid` | convex pieces, cut by a plane |
//! | `camera` | projection and the section of the world that is seen |
//! | `order` | which piece hides which |
//! | `outline` | the outline of a body of several pieces |
//! | `film` | pictures of a motion as polygons and lines, for both formats |
//! | `svg` | a film as a file that moves by style sheet |
//! | `gif`, `raster` | a film as pixels |

mod camera;
mod film;
mod gif;
mod order;
mod outline;
mod raster;
mod solid;
mod svg;

use std::path::{Path, PathBuf};

use plan::PlannerError;
use store::write_file;

use crate::model::{MotionData, PageData, PlanData, Source};

/// What to draw, and into which file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Animation {
    /// An SVG or a GIF file, by its extension.
    pub file: PathBuf,
    /// The only scenario to show, from 1; all of them without.
    pub scenario: Option<usize>,
}

/// Formats of animations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Svg,
    Gif,
}

/// Beginnings of files that may be replaced: earlier animations.
const KINDS: [(&str, Format); 2] = [("svg", Format::Svg), ("gif", Format::Gif)];

impl Animation {
    /// Refuses files of other formats, and to replace what is no animation of ours.
    ///
    /// # Errors
    /// With the name of the file.
    pub fn require_writable(&self) -> Result<(), PlannerError> {
        let is_own = match self.format()? {
            Format::Svg => svg::is_own,
            Format::Gif => gif::is_own,
        };
        let stands = self.file.symlink_metadata().is_ok();
        if stands && !std::fs::read(&self.file).is_ok_and(|content| is_own(&content)) {
            let problem = "exists and is not an earlier animation; choose another file for --animation";
            return Err(PlannerError::file(&self.file, problem));
        }
        Ok(())
    }

    /// Writes the file, for the plan in a folder.
    ///
    /// # Errors
    /// When the file may not be written, or as [`Self::draw`].
    pub fn write(&self, data: &PageData, folder: &Path) -> Result<(), PlannerError> {
        self.require_writable()?;
        write_file(&self.file, &self.draw(data, folder)?)
    }

    /// The content of the file, for the plan in a folder.
    ///
    /// # Errors
    /// When the folder holds no plan, the plan has no such scenario, or the file has another extension.
    pub fn draw(&self, data: &PageData, folder: &Path) -> Result<Vec<u8>, PlannerError> {
        let format = self.format()?;
        let PageData::Plan(plan) = data else {
            return Err(PlannerError::file(
                folder,
                "is no plan, and only plans move; name the folder of a plan for --animation",
            ));
        };
        let film = film::film(plan, shown_first(plan), self.scenario(shown_first(plan))?);
        match format {
            Format::Svg => Ok(svg::write(&film, &plan.result.scene).into_bytes()),
            Format::Gif => gif::write(&film),
        }
    }

    fn format(&self) -> Result<Format, PlannerError> {
        let extension = self.file.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        let known = KINDS.iter().find(|(name, _)| *name == extension);
        let problem = "is neither .svg nor .gif, the formats of animations; name a file with one of these extensions";
        known.map(|(_, format)| *format).ok_or_else(|| PlannerError::file(&self.file, problem))
    }

    /// Index of the only scenario to show.
    fn scenario(&self, motion: &MotionData) -> Result<Option<usize>, PlannerError> {
        let count = motion.scenarios.len();
        match self.scenario {
            Some(number) if !(1..=count).contains(&number) => Err(PlannerError::value(
                "scenario",
                number,
                &format!("must be from 1 to {count}, the scenarios of the motion"),
            )),
            number => Ok(number.map(|number| number - 1)),
        }
    }
}

/// The motion with which the page of a plan opens: what a robot did, else the first rollouts with hard contact.
fn shown_first(plan: &PlanData) -> &MotionData {
    let first = |holds: fn(&Source) -> bool| plan.motions.iter().find(|motion| holds(&motion.source));
    first(|source| matches!(source, Source::Executed))
        .or_else(|| first(|source| matches!(source, Source::Rollouts { .. })))
        .unwrap_or(&plan.motions[0])
}
