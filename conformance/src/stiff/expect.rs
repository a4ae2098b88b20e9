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

/// Who else drew it: values that are off by more than a unit are held against theirs.
#[derive(Clone, Copy, Debug)]
pub enum Peer<'a> {
    /// OSMesa; what the oracle says of it, if it drew everything.
    Osmesa(Option<&'a Score>),
    /// The CPU executor, which the kernels are held against where there is no OSMesa.
    Cpu(Option<&'a Score>),
    /// Nobody: the CPU executor where there is no OSMesa. Its values are held against the exceptions only.
    Nobody,
}

/// What is demanded where no exception stands: coverage exact, values off by a unit, or no worse than the peer's. (Holes and double hits
/// are `wrong` as well.)
fn demand(peer: Peer) -> Limits {
    let value = |error: fn(&Score) -> f64| match peer {
        Peer::Osmesa(score) | Peer::Cpu(score) => (score.map_or(0.0, error) * BESIDE).max(UNIT),
        Peer::Nobody => f64::INFINITY,
    };
    Limits { wrong: 0, beyond: 0, off_rule: 0, color: value(|s| s.color.max), depth: value(|s| s.depth.max) }
}

/// An entry of `stiff.toml`: other limits, where the demand is not met.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Exception {
    family: String,
    devices: Vec<String>,
    /// Only where GL_RENDERER contains this: the Vulkan driver is the reason.
    driver: Option<String>,
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
    /// What it says of itself.
    pub renderer: &'a str,
    /// The full form.
    pub full: bool,
    /// What the oracle says.
    pub score: &'a Score,
    /// Who else drew it.
    pub peer: Peer<'a>,
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

    /// The entry that stands for a severity of a family on an executor.
    fn entry(&self, of: &Judged) -> Option<&Exception> {
        self.0.iter().find(|e| {
            let here = e.family == of.family && e.severities.contains(&of.severity) && (of.full || !e.full_form_only);
            here && e.devices.iter().any(|d| d == of.device) && e.driver.as_ref().is_none_or(|d| of.renderer.contains(d.as_str()))
        })
    }

    /// Values are off by more than a unit, and nothing says whether they may be.
    pub fn leaves_open(&self, of: &Judged) -> bool {
        let entry = self.entry(of);
        let open = |error: f64, limit: Option<f64>| error > UNIT && limit.is_none();
        let (color, depth) = (entry.and_then(|e| e.color), entry.and_then(|e| e.depth));
        matches!(of.peer, Peer::Nobody) && (open(of.score.color.max, color) || open(of.score.depth.max, depth))
    }

    /// Judges one severity of one family on one of Tepui's executors.
    pub fn judge(&self, of: &Judged) -> Verdict {
        let (score, failures) = (of.score, of.failures);
        let entry = self.entry(of);
        let demand = demand(of.peer);
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
        // Limits of values are written for a comparison with OSMesa: without it, nothing says that one is not needed.
        let known = |name: &&str| matches!(of.peer, Peer::Osmesa(_)) || !["color", "depth"].contains(name);
        let idle: Vec<&str> = entry.loosened().into_iter().filter(known).filter(|name| !over.contains(name)).collect();
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

    fn judged<'a>(family: &'a str, severity: f64, device: &'a str, score: &'a Score, peer: Peer<'a>) -> Judged<'a> {
        Judged { family, severity, device, renderer: "a soft driver", full: false, score, peer, failures: &[] }
    }

    fn judge(family: &str, severity: f64, device: &str, score: Score, failures: &[String]) -> Verdict {
        let right = Score::default();
        let judged = Judged { failures, ..judged(family, severity, device, &score, Peer::Osmesa(Some(&right))) };
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
        let demand = demand(Peer::Osmesa(Some(&reference)));
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
    fn without_osmesa_kernels_are_held_against_the_cpu_executor_and_that_against_its_coverage() {
        let list = Exceptions::parse(&LIST.replace("wrong = 5", "wrong = 5\ncolor = 30.0")).unwrap();
        let (good, bad, right, wrong) = (score(0, 20.0), score(0, 23.0), score(0, 1.0), score(1, 0.0));
        assert_eq!(list.judge(&judged("b", 1.0, "gpu", &good, Peer::Cpu(Some(&good)))), Verdict::Pass);
        assert!(!list.judge(&judged("b", 1.0, "gpu", &bad, Peer::Cpu(Some(&good)))).good());
        let alone = |family, score| judged(family, 10.0, "cpu", score, Peer::Nobody);
        assert!(list.judge(&alone("b", &bad)).good() && list.leaves_open(&alone("b", &bad)));
        assert!(!list.leaves_open(&alone("b", &right)), "right by itself");
        assert!(!list.judge(&alone("b", &wrong)).good(), "coverage needs nobody");
        let [within, above, even] = [score(3, 29.0), score(3, 31.0), score(3, 0.0)];
        assert!(list.judge(&alone("a", &within)).good() && !list.leaves_open(&alone("a", &within)));
        assert!(!list.judge(&alone("a", &above)).good(), "an exception's limit holds");
        assert!(list.judge(&alone("a", &even)).good(), "whether its limit of colours is needed is not known");
    }

    #[test]
    fn a_drivers_exceptions_are_its_own() {
        let list = |driver: &str| Exceptions::parse(&format!("{LIST}driver = \"{driver}\"\n")).unwrap();
        let (right, wrong) = (Score::default(), score(5, 0.0));
        let of = |score| judged("a", 10.0, "cpu", score, Peer::Nobody);
        assert!(list("soft").judge(&of(&wrong)).good() && !list("hard").judge(&of(&wrong)).good());
        assert!(!list("soft").judge(&of(&right)).good() && list("hard").judge(&of(&right)).good());
    }

    #[test]
    fn exceptions_for_what_does_not_exist_are_found() {
        let list = Exceptions::parse(LIST).unwrap();
        assert_eq!(list.strangers(|f, _| f == "z"), ["a at 10"]);
        assert!(list.strangers(|_, s| s == 10.0).is_empty());
    }
}
