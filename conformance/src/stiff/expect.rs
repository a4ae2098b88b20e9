//! What is demanded of Tepui in every family at every severity, and the committed exceptions in `conformance/stiff.toml`.

use serde::{Deserialize, Serialize};

use super::Score;
use crate::expectations::Verdict;

/// Limits of the numbers that are judged.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Limits {
    /// Samples that differ from the oracle.
    pub wrong: u64,
    /// Of these, those that single-precision clipping does not explain.
    pub beyond: u64,
    /// Samples that differ from the snapped rule only.
    pub off_rule: u64,
    /// Largest error of a colour component in 1/255.
    pub color: f64,
    /// Largest error of a depth in units in the last place.
    pub depth: f64,
}

/// Beside its rounding, a value may be off by one unit.
const UNIT: f64 = 1.5;

/// Where OSMesa's largest error is more than that, Tepui's may be larger by a tenth: its plane equations are OSMesa's (ARCHITECTURE.md),
/// and a largest error depends on chance.
const BESIDE: f64 = 1.1;

/// What is demanded where no exception stands: coverage exact, values off by a unit, or no worse than OSMesa's. (Holes and double hits
/// are `wrong` as well.)
fn demand(reference: Option<&Score>) -> Limits {
    let value = |error: Option<f64>| (error.unwrap_or(0.0) * BESIDE).max(UNIT);
    Limits { wrong: 0, beyond: 0, off_rule: 0, color: value(reference.map(|r| r.color.max)), depth: value(reference.map(|r| r.depth.max)) }
}

/// An entry of `stiff.toml`: other limits, where the demand is not met.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Exception {
    family: String,
    devices: Vec<String>,
    severities: Vec<f64>,
    /// Only more seeds than the short form has show it.
    #[serde(default)]
    full_form_only: bool,
    wrong: Option<u64>,
    beyond: Option<u64>,
    off_rule: Option<u64>,
    color: Option<f64>,
    depth: Option<f64>,
    /// Crashes, hangs or gives up.
    #[serde(default)]
    fails: bool,
    reason: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    expect: Vec<Exception>,
}

/// What is judged.
#[derive(Clone, Copy)]
pub struct Judged<'a> {
    /// The family.
    pub family: &'a str,
    /// Its severity.
    pub severity: f64,
    /// `cpu` or `gpu`.
    pub device: &'a str,
    /// The full form.
    pub full: bool,
    /// What the oracle says.
    pub score: &'a Score,
    /// What it says of OSMesa, if that drew everything.
    pub reference: Option<&'a Score>,
    /// Crashes, hangs, errors.
    pub failures: &'a [String],
}

/// All exceptions.
pub struct Exceptions(Vec<Exception>);

/// Names of the limits that a score exceeds.
fn exceeded(score: &Score, limits: &Limits) -> Vec<&'static str> {
    let c = &score.counts;
    [
        ("wrong", c.wrong > limits.wrong),
        ("beyond", c.beyond > limits.beyond),
        ("off_rule", c.off_rule > limits.off_rule),
        ("color", score.color.max > limits.color),
        ("depth", score.depth.max > limits.depth),
    ]
    .into_iter()
    .filter_map(|(name, over)| over.then_some(name))
    .collect()
}

impl Exception {
    fn limits(&self, demand: &Limits) -> Limits {
        Limits {
            wrong: self.wrong.unwrap_or(demand.wrong),
            beyond: self.beyond.unwrap_or(demand.beyond),
            off_rule: self.off_rule.unwrap_or(demand.off_rule),
            color: self.color.unwrap_or(demand.color),
            depth: self.depth.unwrap_or(demand.depth),
        }
    }

    /// The numbers that it loosens.
    fn loosened(&self) -> Vec<&'static str> {
        let set = [
            ("wrong", self.wrong.is_some()),
            ("beyond", self.beyond.is_some()),
            ("off_rule", self.off_rule.is_some()),
            ("color", self.color.is_some()),
            ("depth", self.depth.is_some()),
        ];
        set.into_iter().filter_map(|(name, is)| is.then_some(name)).collect()
    }
}

impl Exceptions {
    /// Reads `stiff.toml`.
    pub fn parse(toml: &str) -> Result<Exceptions, String> {
        toml::from_str::<File>(toml).map(|f| Exceptions(f.expect)).map_err(|e| format!("stiff.toml: {e}"))
    }

    /// Judges one severity of one family on one of Tepui's executors.
    pub fn judge(&self, of: &Judged) -> Verdict {
        let (score, failures) = (of.score, of.failures);
        let entry = self.0.iter().find(|e| {
            let here = e.family == of.family && e.severities.contains(&of.severity) && (of.full || !e.full_form_only);
            here && e.devices.iter().any(|d| d == of.device)
        });
        let demand = demand(of.reference);
        let over = exceeded(score, &demand);
        let Some(entry) = entry else {
            return match (failures.first(), over.is_empty()) {
                (Some(why), _) => Verdict::Fail(why.clone()),
                (None, true) => Verdict::Pass,
                (None, false) => Verdict::Fail(format!("more than is allowed: {}", over.join(", "))),
            };
        };
        match (failures.first(), entry.fails) {
            (Some(_), true) => return Verdict::Expected(entry.reason.clone()),
            (Some(why), false) => return Verdict::Fail(why.clone()),
            (None, true) => return Verdict::UnexpectedPass(format!("it does not fail any more; remove `fails`: {}", entry.reason)),
            (None, false) => {}
        }
        let worse = exceeded(score, &entry.limits(&demand));
        let idle: Vec<&str> = entry.loosened().into_iter().filter(|name| !over.contains(name)).collect();
        if !worse.is_empty() {
            Verdict::Fail(format!("worse than expected in {} ({})", worse.join(", "), entry.reason))
        } else if !idle.is_empty() {
            Verdict::UnexpectedPass(format!("meets the demand; remove the limit of {}: {}", idle.join(", "), entry.reason))
        } else {
            Verdict::Expected(entry.reason.clone())
        }
    }

    /// Entries for families or severities that do not exist.
    pub fn strangers(&self, exists: impl Fn(&str, f64) -> bool) -> Vec<String> {
        let all = self.0.iter().flat_map(|e| e.severities.iter().map(move |s| (e, *s)));
        all.filter(|(e, s)| !exists(&e.family, *s)).map(|(e, s)| format!("{} at {s}", e.family)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::Counts;

    const LIST: &str = "[[expect]]\nfamily = \"a\"\ndevices = [\"cpu\"]\nseverities = [10.0]\nwrong = 5\nreason = \"because\"\n";

    fn score(wrong: u64, color: f64) -> Score {
        let mut score = Score { counts: Counts { wrong, ..Counts::default() }, ..Score::default() };
        score.color.add(color, 0.0);
        score
    }

    fn judge(family: &str, severity: f64, device: &str, score: Score, failures: &[String]) -> Verdict {
        let reference = Some(&Score::default());
        let judged = Judged { family, severity, device, full: false, score: &score, reference, failures };
        Exceptions::parse(LIST).unwrap().judge(&judged)
    }

    #[test]
    fn without_an_exception_everything_is_demanded() {
        assert_eq!(judge("b", 1.0, "cpu", score(0, 1.4), &[]), Verdict::Pass);
        assert!(!judge("b", 1.0, "cpu", score(1, 0.0), &[]).good());
        assert!(!judge("b", 1.0, "cpu", score(0, 1.6), &[]).good());
        assert!(!judge("a", 1.0, "cpu", score(1, 0.0), &[]).good(), "another severity");
        assert!(!judge("b", 1.0, "cpu", score(0, 0.0), &["crashed".into()]).good());
    }

    #[test]
    fn values_may_be_as_bad_as_osmesas() {
        let reference = score(0, 20.0);
        let demand = demand(Some(&reference));
        assert!(exceeded(&score(0, 21.0), &demand).is_empty());
        assert_eq!(exceeded(&score(0, 23.0), &demand), ["color"]);
        assert_eq!(exceeded(&score(1, 0.0), &demand), ["wrong"], "its coverage excuses nothing");
    }

    #[test]
    fn an_exception_is_a_limit_and_no_more() {
        assert_eq!(judge("a", 10.0, "cpu", score(5, 0.0), &[]), Verdict::Expected("because".into()));
        assert!(!judge("a", 10.0, "cpu", score(6, 0.0), &[]).good());
        assert!(!judge("a", 10.0, "cpu", score(5, 9.0), &[]).good(), "colour is not excepted");
        assert!(matches!(judge("a", 10.0, "cpu", score(0, 0.0), &[]), Verdict::UnexpectedPass(_)));
        assert!(!judge("a", 10.0, "gpu", score(5, 0.0), &[]).good());
    }

    #[test]
    fn exceptions_for_what_does_not_exist_are_found() {
        let list = Exceptions::parse(LIST).unwrap();
        assert_eq!(list.strangers(|f, _| f == "z"), ["a at 10"]);
        assert!(list.strangers(|_, s| s == 10.0).is_empty());
    }
}
