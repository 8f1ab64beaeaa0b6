//! Finished boundaries, from which another run resumes.

use plan::{PlannerError, Session, Unusable, VERSION, hash, reference_hash, seal, unseal};
use serde::{Deserialize, Serialize};

use crate::answer::Question;
use crate::boundary::{Boundary, boundary};
use crate::conditions::Conditions;
use crate::quantity::Quantity;
use crate::trials::{ToleranceRequest, Trials};

/// Writes the record of finished boundaries somewhere, in place of an older one.
pub type Keep<'store> = &'store dyn Fn(&[u8]) -> Result<(), PlannerError>;

/// The boundaries that are finished, and where they are kept.
pub struct Work<'store> {
    record: WorkRecord,
    keep: Option<Keep<'store>>,
}

/// Why finished boundaries are of no use.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ResumeError {
    /// They cannot be read.
    #[error(transparent)]
    Unusable(#[from] Unusable),
    /// They are of something else.
    #[error("it has another {0}")]
    Other(&'static str),
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WorkRecord {
    inputs: Inputs,
    finished: Vec<Finished>,
}

/// Everything that boundaries depend on, apart from the plans of rows.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Inputs {
    assembly_plan: String,
    /// Hash of the problem with its tolerances of success.
    problem: String,
    reference: String,
    request: ToleranceRequest,
    question: Question,
}

/// A boundary with what it depends on besides the inputs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Finished {
    reference: String,
    base: Conditions,
    boundary: Boundary,
}

impl<'store> Work<'store> {
    /// With nothing finished, which is kept nowhere.
    pub fn new(trials: &Trials, question: &Question) -> Self {
        let inputs = Inputs {
            assembly_plan: VERSION.to_owned(),
            problem: hash(trials.problem().resolved().as_bytes()),
            reference: reference_hash(trials.reference()),
            request: trials.request.clone(),
            question: question.clone(),
        };
        Self { record: WorkRecord { inputs, finished: Vec::new() }, keep: None }
    }

    /// The same, which is kept whenever a boundary is finished.
    pub fn kept_by(self, keep: Keep<'store>) -> Self {
        Self { keep: Some(keep), ..self }
    }

    /// The same with the boundaries of a record that another run has kept, too.
    ///
    /// # Errors
    /// When the record was changed, or is of another measurement.
    pub fn resumed(mut self, text: &str) -> Result<Self, ResumeError> {
        let record: WorkRecord = unseal(text, Unusable::DamagedCheckpoint)?;
        if let Some(difference) = record.inputs.difference(&self.record.inputs) {
            return Err(ResumeError::Other(difference));
        }
        self.record.finished.extend(record.finished);
        Ok(self)
    }

    /// Number of finished boundaries.
    pub fn count(&self) -> usize {
        self.record.finished.len()
    }

    /// As [`boundary()`], unless it is finished.
    ///
    /// # Errors
    /// Those of [`boundary()`], and when the record cannot be kept.
    pub(crate) fn boundary(
        &mut self,
        trials: &Trials,
        base: &Conditions,
        quantity: Quantity,
        session: &Session,
    ) -> Result<Option<Boundary>, PlannerError> {
        let reference = reference_hash(trials.reference());
        let is_it = |finished: &&Finished| {
            finished.boundary.quantity == quantity && finished.base == *base && finished.reference == reference
        };
        if let Some(finished) = self.record.finished.iter().find(is_it) {
            return Ok(Some(finished.boundary.clone()));
        }
        let Some(found) = boundary(trials, base, quantity, session)? else { return Ok(None) };
        self.record.finished.push(Finished { reference, base: *base, boundary: found.clone() });
        if let Some(keep) = self.keep {
            keep(&seal(&self.record)?)?;
        }
        Ok(Some(found))
    }
}

impl Inputs {
    /// The first difference from others, in the user's words.
    fn difference(&self, other: &Self) -> Option<&'static str> {
        let Self { request, question, .. } = self;
        let (asked, of) = (&other.request, &other.question);
        let differences = [
            (self.assembly_plan != other.assembly_plan, "version of assembly-plan"),
            (self.problem != other.problem, "scene, start, offset or tolerance of success"),
            (self.reference != other.reference, "plan"),
            (request.rate != asked.rate, "--target-rate"),
            (request.frictions != asked.frictions, "--friction"),
            (request.cases != asked.cases, "--cases"),
            (request.seed != asked.seed, "--seed"),
            (question.quantities != of.quantities, "--quantity"),
            (question.need != of.need, "--need or --by"),
            (question.map != of.map, "map"),
        ];
        differences.into_iter().find_map(|(differs, name)| differs.then_some(name))
    }
}
