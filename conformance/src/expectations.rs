//! What is demanded of a scene, and the committed list of exceptions with their reasons.

use serde::{Deserialize, Serialize};

use crate::frame::Difference;

/// Which comparison a demand or an exception is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Device {
    /// The CPU executor against Mesa's OSMesa.
    Cpu,
    /// The kernels against the CPU executor.
    Gpu,
    /// The CPU executor with `TEPUI_PARITY=osmesa` against Mesa's OSMesa.
    Parity,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Status {
    /// Stricter than its class: no difference at all.
    Equal,
    /// Differs, within the numbers that the entry gives.
    Within,
    /// Differs without a bound, or crashes.
    Fails,
}

/// An entry of `expectations.toml`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Expectation {
    scene: String,
    device: Device,
    status: Status,
    /// Why. The report prints it.
    pub reason: String,
    /// OSMesa departs from the specification here; with `TEPUI_PARITY=osmesa` the class's demand has to hold.
    #[serde(default)]
    departure: bool,
    pixels: Option<u64>,
    max: Option<u64>,
    coverage: Option<u64>,
    depth_pixels: Option<u64>,
    depth_max: Option<u64>,
    stencil: Option<u64>,
    text: Option<u64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    expect: Vec<Expectation>,
}

/// All committed exceptions.
pub struct Expectations(Vec<Expectation>);

/// The largest difference that is allowed; `u64::MAX` allows any.
#[derive(Clone, Copy, Debug)]
struct Limits {
    pixels: u64,
    max: u64,
    coverage: u64,
    depth_pixels: u64,
    depth_max: u64,
    stencil: u64,
    text: u64,
}

const EQUAL: Limits = Limits { pixels: 0, max: 0, coverage: 0, depth_pixels: 0, depth_max: 0, stencil: 0, text: 0 };
const ANY: u64 = u64::MAX;

impl Limits {
    /// What a scene's class demands.
    fn of(class: &str, device: Device, size: u64) -> Limits {
        let permille = size / 1000;
        match (device, class) {
            (Device::Gpu, _) => Limits { pixels: ANY, max: 1, depth_pixels: ANY, depth_max: 1, ..EQUAL },
            (_, "shaded") => Limits { pixels: ANY, max: 1, ..EQUAL },
            (_, "other") => Limits {
                pixels: permille,
                max: ANY,
                coverage: permille,
                depth_pixels: permille,
                depth_max: ANY,
                stencil: permille,
                text: 0,
            },
            (_, _) => EQUAL,
        }
    }

    fn hold(&self, d: &Difference) -> bool {
        d.pixels <= self.pixels
            && d.max <= self.max
            && d.coverage <= self.coverage
            && d.depth_pixels <= self.depth_pixels
            && d.depth_max <= self.depth_max
            && d.stencil <= self.stencil
            && d.text <= self.text
    }
}

/// How a result stands to what was demanded and expected.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Meets the demand of its class.
    Pass,
    /// Does not, as expected, and no worse than expected.
    Expected(String),
    /// Does not, and nobody expected it.
    Fail(String),
    /// Meets the demand although the exception says otherwise.
    UnexpectedPass(String),
}

impl Verdict {
    /// Counts as passed.
    pub fn good(&self) -> bool {
        matches!(self, Verdict::Pass | Verdict::Expected(_))
    }
}

impl Expectations {
    /// Reads `expectations.toml`.
    pub fn parse(toml: &str) -> Result<Expectations, String> {
        toml::from_str::<File>(toml).map(|f| Expectations(f.expect)).map_err(|e| e.to_string())
    }

    /// Judges a difference, or the reason why there is none.
    pub fn judge(&self, scene: &str, class: &str, device: Device, outcome: &Result<Difference, String>) -> Verdict {
        let entry = self.0.iter().find(|e| e.scene == scene && e.device == device);
        let difference = match (outcome, entry) {
            (Ok(difference), _) => difference,
            (Err(_), Some(e)) if e.status == Status::Fails => return Verdict::Expected(e.reason.clone()),
            (Err(why), _) => return Verdict::Fail(why.clone()),
        };
        let demand = Limits::of(class, device, difference.size);
        let meets = demand.hold(difference);
        match entry {
            None if meets => Verdict::Pass,
            None => Verdict::Fail(format!("more than the class `{class}` allows")),
            Some(e) if e.status == Status::Equal => {
                if EQUAL.hold(difference) {
                    Verdict::Pass
                } else {
                    Verdict::Fail("was expected to be equal".into())
                }
            }
            Some(e) if meets => Verdict::UnexpectedPass(format!("remove the exception: {}", e.reason)),
            Some(e) if e.status == Status::Fails => Verdict::Expected(e.reason.clone()),
            Some(e) => {
                let within = Limits {
                    pixels: e.pixels.unwrap_or(demand.pixels),
                    max: e.max.unwrap_or(demand.max),
                    coverage: e.coverage.unwrap_or(demand.coverage),
                    depth_pixels: e.depth_pixels.unwrap_or(demand.depth_pixels),
                    depth_max: e.depth_max.unwrap_or(demand.depth_max),
                    stencil: e.stencil.unwrap_or(demand.stencil),
                    text: e.text.unwrap_or(demand.text),
                };
                if within.hold(difference) {
                    Verdict::Expected(e.reason.clone())
                } else {
                    Verdict::Fail(format!("worse than expected ({})", e.reason))
                }
            }
        }
    }

    /// OSMesa's own rule, against the specification, is why the scene differs.
    pub fn departs(&self, scene: &str) -> bool {
        self.0.iter().any(|e| e.scene == scene && e.departure)
    }

    /// Scenes that have an exception but do not exist.
    pub fn strangers<'a>(&'a self, scenes: &'a [String]) -> impl Iterator<Item = &'a str> {
        self.0.iter().map(|e| e.scene.as_str()).filter(|name| !scenes.iter().any(|s| s == name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn difference(pixels: u64, max: u64) -> Result<Difference, String> {
        Ok(Difference { size: 65536, pixels, max, ..Difference::default() })
    }

    #[test]
    fn classes_demand_what_they_say() {
        let none = Expectations(Vec::new());
        assert!(none.judge("a", "exact", Device::Cpu, &difference(0, 0)).good());
        assert!(!none.judge("a", "exact", Device::Cpu, &difference(1, 1)).good());
        assert!(none.judge("a", "shaded", Device::Cpu, &difference(60000, 1)).good());
        assert!(!none.judge("a", "shaded", Device::Cpu, &difference(1, 2)).good());
        assert!(none.judge("a", "other", Device::Cpu, &difference(65, 255)).good());
        assert!(!none.judge("a", "other", Device::Cpu, &difference(66, 255)).good());
    }

    #[test]
    fn unexpected_passes_and_worse_failures_are_not_good() {
        let toml = "[[expect]]\nscene = \"a\"\ndevice = \"cpu\"\nstatus = \"within\"\npixels = 10\nmax = 3\nreason = \"because\"\n";
        let list = Expectations::parse(toml).unwrap();
        assert_eq!(list.judge("a", "exact", Device::Cpu, &difference(9, 3)), Verdict::Expected("because".into()));
        assert!(!list.judge("a", "exact", Device::Cpu, &difference(11, 3)).good());
        assert!(matches!(list.judge("a", "exact", Device::Cpu, &difference(0, 0)), Verdict::UnexpectedPass(_)));
        assert!(list.judge("a", "exact", Device::Gpu, &difference(11, 1)).good());
    }

    #[test]
    fn a_departure_ends_with_parity() {
        let toml =
            "[[expect]]\nscene = \"a\"\ndevice = \"cpu\"\nstatus = \"within\"\npixels = 100\ndeparture = true\nreason = \"Mesa's rule\"\n";
        let list = Expectations::parse(toml).unwrap();
        assert!(list.departs("a") && !list.departs("b"));
        assert!(list.judge("a", "other", Device::Cpu, &difference(100, 255)).good());
        assert!(!list.judge("a", "other", Device::Parity, &difference(100, 255)).good());
        assert_eq!(list.judge("a", "other", Device::Parity, &difference(65, 255)), Verdict::Pass);
    }

    #[test]
    fn a_crash_fails_unless_it_is_expected_to_fail() {
        let toml = "[[expect]]\nscene = \"a\"\ndevice = \"gpu\"\nstatus = \"fails\"\nreason = \"not built\"\n";
        let list = Expectations::parse(toml).unwrap();
        assert!(list.judge("a", "exact", Device::Gpu, &Err("crashed".into())).good());
        assert!(!list.judge("b", "exact", Device::Gpu, &Err("crashed".into())).good());
    }
}
