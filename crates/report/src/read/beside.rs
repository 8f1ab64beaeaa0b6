//! Another plan of the same parts beside the first one.

use std::path::Path;

use plan::PlannerError;

use super::{read, title};
use crate::model::{BesideData, PageData, PartData, PlanData};

/// Reads the plan in another folder, and puts it beside the one that was read from the first.
///
/// # Errors
/// When one of them is no plan, or the other one cannot be read or is of other parts.
pub fn read_beside(data: PageData, folder: &Path, other: &Path) -> Result<PageData, PlannerError> {
    let (one, two) = (plan(data, folder)?, plan(read(other, &[])?, other)?);
    require_same_parts(&one, &two, folder, other)?;
    let [own, theirs] = [folder, other].map(title);
    let names = if own == theirs { [folder, other].map(|folder| folder.display().to_string()) } else { [own, theirs] };
    Ok(PageData::Beside(Box::new(BesideData { names, plans: [one, two] })))
}

fn plan(data: PageData, folder: &Path) -> Result<PlanData, PlannerError> {
    match data {
        PageData::Plan(plan) => Ok(*plan),
        _ => Err(PlannerError::file(folder, "is no plan; name the folders of two plans for --beside")),
    }
}

/// Refuses plans whose parts differ in shape, name, place or number.
fn require_same_parts(one: &PlanData, other: &PlanData, folder: &Path, beside: &Path) -> Result<(), PlannerError> {
    for (owner, own, theirs) in
        [("body", &one.body, &other.body), ("environment", &one.environment, &other.environment)]
    {
        let differs = |(own, theirs): &(&PartData, &PartData)| own != theirs;
        let difference = if own.len() != theirs.len() {
            format!("its {owner} has {} convex parts, not {}", theirs.len(), own.len())
        } else if let Some((_, part)) = own.iter().zip(theirs).find(differs) {
            format!("{} of its {owner} differs in name, shape or place", part.name)
        } else {
            continue;
        };
        let problem = format!("has other parts than {}: {difference}; name plans of the same parts", folder.display());
        return Err(PlannerError::file(beside, problem));
    }
    Ok(())
}
