//! Few of many sets that together have all members.

/// More tries to exchange sets (members of sets) take too long.
const MOST_WORK: usize = 50_000_000;

/// Indices of few sets that together have all members that any of them has, found greedily and by exchange.
/// `weights` says how much each member counts in the one of two greedy choices; in the other, rare members count more.
pub fn set_cover(sets: &[Vec<usize>], weights: &[f64]) -> Vec<usize> {
    let mut counts = vec![0; weights.len()];
    sets.iter().flatten().for_each(|&member| counts[member] += 1);
    let rarity: Vec<f64> = counts.iter().map(|&count| 1.0 / f64::from(count.max(1))).collect();
    let chosen = [greedy(sets, &rarity), greedy(sets, weights)];
    let chosen = chosen.map(|chosen| without_superfluous(sets, &chosen, weights.len()));
    let best = chosen.into_iter().min_by_key(Vec::len).unwrap_or_default();
    exchanged(sets, best, weights.len())
}

/// Always the set with the most weight that is still missing.
fn greedy(sets: &[Vec<usize>], weights: &[f64]) -> Vec<usize> {
    let mut is_missing = vec![true; weights.len()];
    let mut chosen = Vec::new();
    loop {
        let gain = |set: &Vec<usize>| -> f64 {
            set.iter().filter(|&&member| is_missing[member]).map(|&member| weights[member]).sum()
        };
        let gains = sets.iter().enumerate().map(|(index, set)| (index, gain(set)));
        match gains.max_by(|one, other| one.1.total_cmp(&other.1).then(other.0.cmp(&one.0))) {
            Some((index, gain)) if gain > 0.0 => {
                sets[index].iter().for_each(|&member| is_missing[member] = false);
                chosen.push(index);
            }
            _ => return chosen,
        }
    }
}

/// Without sets all of whose members are in others. The last set is asked last.
fn without_superfluous(sets: &[Vec<usize>], chosen: &[usize], members: usize) -> Vec<usize> {
    let mut counts = vec![0; members];
    chosen.iter().flat_map(|&set| &sets[set]).for_each(|&member| counts[member] += 1);
    let mut kept = Vec::new();
    for &set in chosen {
        if sets[set].iter().all(|&member| counts[member] > 1) {
            sets[set].iter().for_each(|&member| counts[member] -= 1);
        } else {
            kept.push(set);
        }
    }
    kept
}

/// Adds a set where two or more become superfluous by it, until there is none.
fn exchanged(sets: &[Vec<usize>], mut chosen: Vec<usize>, members: usize) -> Vec<usize> {
    let mut work = 0;
    let mut is_better = true;
    while is_better {
        is_better = false;
        for set in 0..sets.len() {
            let with: Vec<usize> = chosen.iter().copied().filter(|&other| other != set).chain([set]).collect();
            work += with.iter().map(|&set| sets[set].len()).sum::<usize>();
            if work > MOST_WORK {
                return chosen;
            }
            let without = without_superfluous(sets, &with, members);
            is_better |= without.len() < chosen.len();
            // As many, but others, may lead on to fewer.
            if without.len() < chosen.len()
                || (without.len() == chosen.len() && without.contains(&set) && !chosen.contains(&set))
            {
                chosen = without;
            }
        }
    }
    chosen
}
