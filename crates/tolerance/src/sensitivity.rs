//! What a change of one quantity buys of another one.

use serde::{Deserialize, Serialize};

use crate::boundary::Boundary;
use crate::map::ToleranceMapRow;
use crate::quantity::Quantity;

/// How much the boundary of a map changes with its other quantity, on average between its first and its last row.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Sensitivity {
    /// The first and the last value of the other quantity (SI units).
    pub between: [f64; 2],
    /// Change of the boundary per unit of the other quantity (SI units).
    pub slope: f64,
    /// Its confidence interval of 95 %, which does not contain zero.
    pub interval: [f64; 2],
    /// The same in words, such as `1 mm more clearance buys 0.40 mm of offset (95 % confidence: 0.22 to 0.58 mm), on average
    /// between 0.250 mm and 2.000 mm of clearance`.
    pub sentence: String,
}

/// Error of a logarithm that is rounding.
const ROUNDING: f64 = 1e-9;

/// A boundary that is known from both sides.
struct Known {
    value: f64,
    low: f64,
    high: f64,
}

impl Known {
    fn of(boundary: &Boundary) -> Option<Self> {
        let Boundary { value: Some(value), interval: [Some(one), Some(other)], is_open: false, .. } = *boundary else {
            return None;
        };
        Some(Self { value, low: one.min(other), high: one.max(other) })
    }
}

impl Sensitivity {
    /// Of a map's rows, by ascending values of the other quantity. `None` unless the data decide it: all boundaries are known
    /// from both sides, their values only rise or only fall, and the interval of the slope does not contain zero.
    pub(crate) fn of(quantity: Quantity, over: Quantity, rows: &[ToleranceMapRow]) -> Option<Self> {
        let known: Vec<Known> = rows.iter().map(|row| Known::of(&row.boundary)).collect::<Option<_>>()?;
        let ([first, .., last], [from, .., to]) = (&known[..], rows) else { return None };
        let (change, span) = (last.value - first.value, to.at - from.at);
        let is_monotone = known.windows(2).all(|pair| (pair[1].value - pair[0].value) * change >= 0.0);
        // The interval of a difference from those of its terms (method of variance estimates recovery). All rows are played
        // with the same errors, so that their boundaries tend to deviate together: the true interval is narrower.
        let low = change - (last.value - last.low).hypot(first.high - first.value);
        let high = change + (last.high - last.value).hypot(first.value - first.low);
        let is_decided = low > 0.0 || high < 0.0;
        if !(is_monotone && is_decided && span > 0.0) {
            return None;
        }
        let (between, slope, interval) = ([from.at, to.at], change / span, [low / span, high / span]);
        let sentence = sentence(quantity, over, between, slope, interval);
        Some(Self { between, slope, interval, sentence })
    }
}

fn sentence(quantity: Quantity, over: Quantity, between: [f64; 2], slope: f64, interval: [f64; 2]) -> String {
    let ((unit, scale), (over_unit, over_scale)) = (quantity.unit(), over.unit());
    // The largest power of ten that fits between the rows.
    let step = 10.0_f64.powi(((over_scale * (between[1] - between[0])).log10() + ROUNDING).floor() as i32);
    let per_step = |slope: f64| scale * slope.abs() * step / over_scale;
    let [one, other] = interval.map(per_step);
    let decimals = decimals(one.min(other));
    let with_unit = |text: String, unit: &str| format!("{text} {unit}").trim_end().to_owned();
    let bought = with_unit(format!("{:.decimals$}", per_step(slope)), unit);
    let interval = with_unit(format!("{:.decimals$} to {:.decimals$}", one.min(other), one.max(other)), unit);
    let (name, over_name) = (quantity.name(), over.name());
    let effect = match (quantity.is_hard_when_small(), slope > 0.0) {
        (false, true) => format!("buys {bought} of {name}"),
        (false, false) => format!("costs {bought} of {name}"),
        (true, true) => format!("needs {bought} more {name}"),
        (true, false) => format!("needs {bought} less {name}"),
    };
    format!(
        "{} more {over_name} {effect} (95 % confidence: {interval}), on average between {} and {} of {over_name}",
        with_unit(step.to_string(), over_unit),
        over.in_words(between[0]),
        over.in_words(between[1])
    )
}

/// Decimals with which a number has at least two digits.
fn decimals(number: f64) -> usize {
    (1.0 - number.log10().floor()).clamp(0.0, 6.0) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(at: f64, [low, value, high]: [f64; 3]) -> ToleranceMapRow {
        let boundary = Boundary {
            quantity: Quantity::Offset,
            value: Some(value),
            interval: [Some(low), Some(high)],
            successes: 99,
            rollouts: 100,
            is_open: false,
        };
        ToleranceMapRow { at, boundary }
    }

    fn of(rows: &[ToleranceMapRow]) -> Option<Sensitivity> {
        Sensitivity::of(Quantity::Offset, Quantity::Clearance, rows)
    }

    #[test]
    fn a_difference_has_the_root_of_the_squares_of_its_terms_errors() {
        // 3.2 mm more, less errors of 0.3 and 0.4 mm, or plus errors of 1 and 0.6 mm.
        let rows = [row(0.0005, [1e-3, 2e-3, 2.3e-3]), row(0.0015, [4.8e-3, 5.2e-3, 5.8e-3])];
        let Sensitivity { slope, interval: [low, high], sentence, .. } = of(&rows).unwrap();
        assert!((slope - 3.2).abs() < 1e-9 && (low - 2.7).abs() < 1e-9, "{slope}, {low}");
        assert!((high - (3.2 + 1.0_f64.hypot(0.6))).abs() < 1e-9, "{high}");
        let expected = "1 mm more clearance buys 3.2 mm of offset (95 % confidence: 2.7 to 4.4 mm), on average between \
                        0.500 mm and 1.500 mm of clearance";
        assert_eq!(sentence, expected);
    }

    #[test]
    fn steps_stay_between_the_rows_and_falling_boundaries_are_costs() {
        let rows = [row(0.1, [2e-3, 2e-3, 2.1e-3]), row(0.2, [1e-3, 1e-3, 1.1e-3])];
        let found = Sensitivity::of(Quantity::Offset, Quantity::Friction, &rows).unwrap();
        assert!(found.sentence.starts_with("0.1 more friction costs 1.00 mm of offset"), "{}", found.sentence);
        let found = Sensitivity::of(Quantity::Clearance, Quantity::Offset, &rows).unwrap();
        assert!(found.sentence.starts_with("100 mm more offset needs 1.00 mm less clearance"), "{}", found.sentence);
    }

    #[test]
    fn what_the_data_do_not_decide_is_not_said() {
        let [low, high] = [row(0.001, [1e-3, 2e-3, 2.2e-3]), row(0.002, [3e-3, 4e-3, 4.2e-3])];
        assert!(of(&[low.clone(), high.clone()]).is_some());
        let dip = row(0.0015, [0.9e-3, 1.9e-3, 2.1e-3]);
        let wide = row(0.002, [1.5e-3, 4e-3, 9e-3]);
        let rising_a_little = row(0.002, [1.9e-3, 2.1e-3, 2.3e-3]);
        let mut open = high.clone();
        open.boundary.is_open = true;
        let mut unknown = high.clone();
        unknown.boundary.interval[1] = None;
        let mut nothing = high.clone();
        nothing.boundary.value = None;
        let same = row(0.001, [3e-3, 4e-3, 4.2e-3]);
        for other in [wide, rising_a_little, open, unknown, nothing, same, row(0.002, [f64::NAN; 3])] {
            assert_eq!(of(&[low.clone(), other.clone()]), None, "{other:?}");
        }
        assert_eq!(of(&[low.clone(), dip, high]), None, "values that fall and rise");
        assert_eq!(of(&[low]), None, "one row has no slope");
    }
}
