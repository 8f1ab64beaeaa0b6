//! The best of several references, found with few rollouts.

use simulation::{Evaluator, Reference, TestCase, TestResult};

/// How the best reference did.
pub struct Winner {
    /// Its index.
    pub index: usize,
    /// Its results, in the order of the test cases.
    pub results: Vec<TestResult>,
    /// Rollouts that the race took.
    pub rollouts: usize,
}

/// The test cases of a race.
#[derive(Clone, Copy)]
pub struct Heats<'cases> {
    /// Test cases of the winner.
    pub cases: &'cases [TestCase],
    /// Number of them that are played before references are dropped.
    pub first: usize,
}

/// The reference that passes most test cases; of equals the one with the smaller violation in all, then the later one.
/// `None` without references, or when `stop` returns true before the end. The first test cases speak for all: after `first`
/// of them half of the references are dropped, and the others are played in twice as many (successive halving).
pub fn race(
    evaluator: &Evaluator,
    references: &[Reference],
    Heats { cases, first }: Heats,
    stop: &(dyn Fn() -> bool + Sync),
) -> Option<Winner> {
    let mut running: Vec<(usize, Vec<TestResult>)> = (0..references.len()).map(|index| (index, Vec::new())).collect();
    let (mut played, mut rollouts) = (0, 0);
    while running.len() > 1 || played < cases.len() {
        let wanted = if running.len() > 1 { (2 * played).max(first).min(cases.len()) } else { cases.len() };
        for (index, results) in &mut running {
            results.extend(evaluator.evaluate_all(&references[*index], &cases[played..wanted], stop)?);
            rollouts += wanted - played;
        }
        played = wanted;
        let failures = |results: &[TestResult]| results.iter().filter(|result| !result.passed).count();
        let violation = |results: &[TestResult]| results.iter().map(|result| result.violation).sum::<f64>();
        running.sort_by(|(index, one), (next, other)| {
            let fewer = failures(one).cmp(&failures(other));
            fewer.then(violation(one).total_cmp(&violation(other))).then(next.cmp(index))
        });
        let kept = if played < cases.len() { running.len().div_ceil(2) } else { 1 };
        running.truncate(kept);
    }
    let (index, results) = running.pop()?;
    Some(Winner { index, results, rollouts })
}

#[cfg(test)]
mod tests {
    use plan::{Choices, Problem};
    use simulation::{Disturbance, FrictionIndex, Success};
    use task::{GraspError, Pose};

    use super::*;
    use crate::tests::corner;

    #[test]
    fn the_reference_that_passes_most_trials_wins_with_few_rollouts() {
        let problem = Problem::load(&corner(), &Choices::default()).unwrap();
        let task = problem.task();
        let evaluator = Evaluator::new(&problem.world(), &[0.0], Success::default());
        let resting = Reference::new(0.1, &[task.start.at_rest(); 3]);
        let push = Reference::straight(&task.start, &task.goal, task.horizon);
        let cases = [TestCase {
            friction: FrictionIndex(0),
            grasp: GraspError::default(),
            disturbance: Disturbance::default(),
        }; 30];
        let references = [resting.clone(), push.clone(), resting.clone(), resting];
        let winner = race(&evaluator, &references, Heats { cases: &cases, first: 6 }, &|| false).unwrap();
        assert_eq!((winner.index, winner.results.len()), (1, cases.len()));
        assert!(winner.results.iter().all(|result| result.passed));
        // Six test cases of all four, six more of two, then the others of one.
        assert_eq!(winner.rollouts, 4 * 6 + 2 * 6 + 18);
        let equals = [push.clone(), push];
        assert_eq!(
            race(&evaluator, &equals, Heats { cases: &cases, first: 6 }, &|| false).unwrap().index,
            1,
            "of equals the later"
        );
        // A push that ends halfway misses the goal by less than rest.
        let halfway = Pose(std::array::from_fn(|index| 0.5 * (task.start[index] + task.goal[index])));
        let failing = [Reference::straight(&task.start, &halfway, task.horizon), references[0].clone()];
        assert_eq!(
            race(&evaluator, &failing, Heats { cases: &cases, first: 6 }, &|| false).unwrap().index,
            0,
            "of equals the nearer"
        );
        assert!(race(&evaluator, &references, Heats { cases: &cases, first: 6 }, &|| true).is_none(), "no time");
        assert!(race(&evaluator, &[], Heats { cases: &cases, first: 6 }, &|| false).is_none(), "no references");
    }
}
