//! Origins of candidate plans, and how these were processed.

use std::fmt;

use plan::{PlanIteration, Variant};
use serde::{Deserialize, Serialize};
use simulation::Reference;

use crate::draft::Draft;
use crate::portfolio::Recipe;

/// Origin of a reference.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Origin {
    /// The scene as it is.
    Scene,
    /// A straight push, which solves nothing.
    Push,
    /// A spiral search for the hole, which solves nothing.
    Spiral,
    /// An earlier plan, moved.
    Earlier,
    /// The caller.
    Given,
    /// A problem of the portfolio.
    Variant(Recipe),
    /// A draft.
    Draft(Draft),
}

/// Processing of a reference since.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Marks {
    /// It ends with an oscillation.
    pub has_oscillation: bool,
    /// It was refined again.
    pub is_continued: bool,
    /// Parts that no test case needs were taken back.
    pub is_straightened: bool,
    /// It was refined in a hardened environment.
    pub has_margins: bool,
}

/// A solved problem, and which of its homotopy steps is refined.
#[derive(Clone)]
pub struct Solved {
    pub origin: Origin,
    pub marks: Marks,
    pub variant: Variant,
    /// Its homotopy; the scene's own for a reference that was not planned.
    pub iterations: Vec<PlanIteration>,
    /// Number of the homotopy step whose reference is refined, from 1; 0 for none of them.
    pub chosen: usize,
}

impl Origin {
    /// Whether its homotopy steps are those of the scene itself, which are stored elsewhere.
    pub fn has_homotopy_of_scene(&self) -> bool {
        matches!(self, Self::Scene | Self::Push | Self::Spiral | Self::Earlier | Self::Given)
    }
}

impl Solved {
    /// The steps of a homotopy, of which none is chosen yet.
    pub fn new(origin: Origin, variant: Variant, iterations: Vec<PlanIteration>) -> Self {
        Self { origin, marks: Marks::default(), variant, iterations, chosen: 0 }
    }

    /// In words.
    pub fn planned(&self) -> String {
        format!("{}{}", self.origin, self.marks)
    }

    /// Indices of the homotopy steps that have all time steps.
    pub fn with_all_steps(&self) -> Vec<usize> {
        let has_all = |&index: &usize| !self.iterations[index].record.is_coarse(&self.variant.task);
        (0..self.iterations.len()).filter(has_all).collect()
    }

    /// Indices of the homotopy steps that are worth refining: those with all time steps or, where there are none, all.
    pub fn refinable(&self) -> Vec<usize> {
        let fine = self.with_all_steps();
        if fine.is_empty() { (0..self.iterations.len()).collect() } else { fine }
    }

    /// The reference of a homotopy step, with all time steps.
    pub fn reference(&self, index: usize) -> Reference {
        reference_of(&self.variant, &self.iterations[index])
    }
}

/// The reference of a homotopy step of a variant, with all of its time steps.
pub fn reference_of(variant: &Variant, iteration: &PlanIteration) -> Reference {
    let reference = Reference::from(&iteration.trajectory);
    if iteration.record.is_coarse(&variant.task) { reference.on(variant.task.horizon) } else { reference }
}

impl fmt::Display for Origin {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Scene => formatter.write_str("the scene as it is"),
            Self::Push => formatter.write_str("a straight push"),
            Self::Spiral => formatter.write_str("a spiral search"),
            Self::Earlier => formatter.write_str("the earlier plan"),
            Self::Given => formatter.write_str("a given reference"),
            Self::Variant(recipe) => recipe.fmt(formatter),
            Self::Draft(draft) => draft.fmt(formatter),
        }
    }
}

impl fmt::Display for Marks {
    /// Suffix of the origin.
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let marks = [
            (self.has_oscillation, ", with a final oscillation"),
            (self.is_continued, ", continued"),
            (self.is_straightened, ", straightened"),
            (self.has_margins, ", with margins"),
        ];
        marks.into_iter().filter(|(is_set, _)| *is_set).try_for_each(|(_, words)| formatter.write_str(words))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_tell_the_origin_and_what_was_done_since() {
        let marks = Marks { has_oscillation: true, is_continued: true, has_margins: true, ..Marks::default() };
        let planned = format!("{}{marks}", Origin::Variant(Recipe::TwiceTheTime));
        assert_eq!(planned, "twice the time, with a final oscillation, continued, with margins");
        assert_eq!(format!("{}{}", Origin::Scene, Marks::default()), "the scene as it is");
    }
}
