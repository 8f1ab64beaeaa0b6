//! Numbers on the command line, each with its range.

use std::ops::RangeInclusive;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use export::Target;
use scene_templates::Axis;
use task::{LinearSolver, Pose};
use tolerance::Quantity;

/// A pose: position (m) and quaternion (w x y z) of any norm but zero, which is scaled to unit norm.
pub fn pose(text: &str) -> Result<Pose, String> {
    let words = text.split([' ', ',']).filter(|word| !word.is_empty());
    let values: Result<Vec<f64>, String> =
        words.map(|word| word.parse().map_err(|_| format!("`{word}` is not a number"))).collect();
    let numbers = values?
        .try_into()
        .map_err(|values: Vec<f64>| format!("a pose has 7 numbers, x y z qw qx qy qz; got {}", values.len()))?;
    Pose::given(numbers).map_err(str::to_owned)
}

/// A linear solver by its name.
pub fn linear_solver() -> impl TypedValueParser<Value = LinearSolver> {
    named(LinearSolver::ALL.map(LinearSolver::name), LinearSolver::from_name)
}

/// A target of an export by its name.
pub fn target() -> impl TypedValueParser<Value = Target> {
    named(Target::ALL.map(Target::name), Target::from_name)
}

/// A direction along an axis, such as `z`, `+z` or `-Z`.
pub fn axis() -> impl TypedValueParser<Value = Axis> {
    let names = [("x", "+x"), ("y", "+y"), ("z", "+z")].map(|(name, alias)| PossibleValue::new(name).alias(alias));
    let negative = ["-x", "-y", "-z"].map(PossibleValue::new);
    let known = PossibleValuesParser::new(names.into_iter().chain(negative));
    known.try_map(|name| Axis::from_name(&name).ok_or("unknown"))
}

/// What may be off, by its name.
pub fn quantity() -> impl TypedValueParser<Value = Quantity> {
    named(Quantity::ALL.map(Quantity::name), Quantity::from_name)
}

/// A quantity of the parts by its name.
pub fn part_quantity() -> impl TypedValueParser<Value = Quantity> {
    named(Quantity::OF_PARTS.map(Quantity::name), Quantity::from_name)
}

/// Units of a requirement, with their size in SI units.
const UNITS: [(&str, f64); 5] =
    [("mm", 1e-3), ("mrad", 1e-3), ("deg", std::f64::consts::PI / 180.0), ("rad", 1.0), ("m", 1.0)];

/// A requirement such as `offset=2mm`, `rotation=1deg` or `friction=0.3`; without a unit, SI units.
pub fn required(text: &str) -> Result<(Quantity, f64), String> {
    let (name, value) = text.split_once('=').ok_or("must be a name and a value, such as offset=2mm")?;
    let known = Quantity::ALL.into_iter().filter(|quantity| !Quantity::OF_PARTS.contains(quantity));
    let names: Vec<&str> = known.map(Quantity::name).collect();
    let quantity = Quantity::from_name(name).filter(|_| names.contains(&name));
    let quantity =
        quantity.ok_or_else(|| format!("`{name}` cannot be required; choose one of {}", names.join(", ")))?;
    let found = UNITS.iter().find_map(|(unit, scale)| Some((*unit, value.strip_suffix(unit)?, *scale)));
    let (unit, digits, scale) = found.unwrap_or(("", value, 1.0));
    let fits = match quantity {
        Quantity::Rotation => ["", "deg", "rad", "mrad"].contains(&unit),
        Quantity::Friction => unit.is_empty(),
        _ => ["", "m", "mm"].contains(&unit),
    };
    if !fits {
        return Err(format!("`{unit}` is no unit of {name}"));
    }
    let value = scale * number(digits.trim(), |number| number >= 0.0, "must not be negative")?;
    in_range(quantity, value)?;
    Ok((quantity, value))
}

/// Refuses a value (SI units) that no scene could have.
pub fn in_range(quantity: Quantity, value: f64) -> Result<(), String> {
    let key = match quantity {
        Quantity::Offset | Quantity::Hole => scene::key("robustness", "offset_magnitude"),
        Quantity::Rotation => scene::key("robustness", "rotation_error"),
        Quantity::Friction => scene::key("robustness", "friction"),
        Quantity::Clearance | Quantity::Chamfer => scene::key("part", "clearance"),
    };
    match key.range().filter(|range| !range.contains(value)) {
        Some(range) => {
            let rule = format!("{} = {value}: must lie {range} {}", quantity.name(), key.unit);
            Err(rule.trim_end().to_owned())
        }
        None => Ok(()),
    }
}

/// A unit of length of meshes.
pub fn unit() -> PossibleValuesParser {
    PossibleValuesParser::new(["m", "cm", "mm", "inch"])
}

/// A value by one of the names, which shells then complete.
fn named<T: Clone + Send + Sync + 'static, const COUNT: usize>(
    names: [&'static str; COUNT],
    value: fn(&str) -> Option<T>,
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(names.map(PossibleValue::new)).try_map(move |name| value(&name).ok_or("unknown"))
}

/// A rate of samples (Hz).
pub fn rate(text: &str) -> Result<f64, String> {
    number(text, |number| (1.0..=10_000.0).contains(&number), "must lie between 1 and 10000 Hz")
}

/// A finite number above zero.
pub fn positive(text: &str) -> Result<f64, String> {
    number(text, |number| number > 0.0, "must be above zero")
}

/// A number from 0 to 1.
pub fn fraction(text: &str) -> Result<f64, String> {
    number(text, |number| (0.0..=1.0).contains(&number), "must lie between 0 and 1")
}

/// A finite number that is not negative.
pub fn not_negative(text: &str) -> Result<f64, String> {
    number(text, |number| number >= 0.0, "must not be negative")
}

/// A time in seconds, above zero.
pub fn seconds(text: &str) -> Result<f64, String> {
    const MOST: f64 = 1e7;
    number(text, |number| number > 0.0 && number <= MOST, "must lie between 0 and 10000000 s")
}

/// A number above zero that a key of scenes takes, as in `of_key("robustness.offset_magnitude")`.
pub fn of_key(path: &'static str) -> impl Fn(&str) -> Result<f64, String> + Clone + Send + Sync + 'static {
    let (table, name) = path.split_once('.').unwrap_or(("", path));
    let key = scene::key(table, name);
    move |text| {
        let range = key.range().ok_or("takes no number")?;
        let range = scene::Range { includes_low: range.low > 0.0, ..range };
        number(text, |number| range.contains(number), &format!("must lie {range} {}", key.unit))
    }
}

/// The largest whole number of flags that have no other limit.
pub const BILLION: u32 = 1_000_000_000;

/// A whole number.
pub fn whole<N: TryFrom<u32>>(
    range: RangeInclusive<u32>,
) -> impl Fn(&str) -> Result<N, String> + Clone + Send + Sync + 'static {
    move |text| {
        let number = text.parse().ok().filter(|number| range.contains(number));
        let number = number.and_then(|number: u32| N::try_from(number).ok());
        number.ok_or_else(|| format!("must be a whole number between {} and {}", range.start(), range.end()))
    }
}

/// A seed of random numbers.
pub fn seed(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("must be a whole number between 0 and {}", u64::MAX))
}

/// A number of threads or processes.
pub fn jobs(text: &str) -> Result<u16, String> {
    const MOST: u16 = 1024;
    let in_range = text.parse().ok().filter(|jobs| (1..=MOST).contains(jobs));
    in_range.ok_or_else(|| format!("must be a whole number between 1 and {MOST}"))
}

fn number(text: &str, is_right: impl Fn(f64) -> bool, rule: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(number) if !number.is_finite() => Err(format!("must be a finite number, got {number}")),
        Ok(number) if is_right(number) => Ok(number),
        Ok(_) => Err(rule.to_owned()),
        Err(_) => Err("not a number".to_owned()),
    }
}

/// Number of threads: one per processor, or as requested, up to a number per processor. More would only wait for each
/// other.
pub fn threads(jobs: Option<u16>) -> usize {
    const MOST_PER_PROCESSOR: usize = 4;
    let processors = std::thread::available_parallelism().map_or(1, Into::into);
    jobs.map_or(processors, |jobs| usize::from(jobs).min(MOST_PER_PROCESSOR * processors))
}
