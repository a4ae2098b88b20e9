//! Where Tepui's CPU executor is more exact than OSMesa and where less, out of the numbers of a run, with what we know of the cause.

use super::run::{FamilyResult, Outcome};

/// One number in which the two differ, over all severities of a family.
pub struct Finding {
    /// The family.
    pub family: &'static str,
    /// What differs, with its unit.
    pub metric: &'static str,
    /// Tepui's, OSMesa's.
    pub values: [f64; 2],
    /// Why, as far as it is known.
    pub why: &'static str,
}

/// What we know of causes: family, metric, text.
const CAUSES: &[(&str, &str, &str)] = &[
    (
        "homogeneous_scale",
        "",
        "Mesa runs with denormal numbers flushed to zero; at w = 2^-120 clip coordinates near the middle of the window are denormal and become 0. Tepui keeps them.",
    ),
    (
        "far_vertices",
        "wrong",
        "Both clip at the frustum in single precision and have no bits left beyond 10^7 pixels. At 10^30 OSMesa drops triangles that Tepui still cuts (not traced further).",
    ),
    (
        "texture_far_linear",
        "",
        "Up to 256 Tepui is exact where OSMesa filters with 8-bit weights. At 10^6 a coordinate moves in steps of four texels: both are chance.",
    ),
    ("texture_thin", "colour", "OSMesa filters with 8-bit weights, Tepui in single precision."),
    (
        "texture_minified",
        "colour",
        "OSMesa approximates the logarithm of the level of detail and mixes levels with 8-bit weights; Tepui does both in single precision.",
    ),
    (
        "texture_grazing",
        "colour",
        "OSMesa approximates the logarithm of the level of detail and mixes levels with 8-bit weights; Tepui does both in single precision.",
    ),
    (
        "clipped_slivers",
        "",
        "Tepui takes the distances from user clip planes in eye space, as 2.12 has it, Mesa in clip space: new vertices differ in their last bits, and slivers amplify them.",
    ),
    (
        "special_values",
        "",
        "With coordinates of 3.4e38 sums overflow: each implementation leaves out other ones of the poisoned triangles.",
    ),
    (
        "viewports",
        "",
        "At 16384 pixels OSMesa is wrong in a few samples of the full form (not traced); Tepui's snapped positions and edge functions are exact from -16384 to 32767.",
    ),
    (
        "lines_far",
        "",
        "With both ends 10^15 pixels away single precision loses lines; once in 64 lines Tepui draws half of one that misses the window by 10^7 pixels, and OSMesa does not (not traced further).",
    ),
    ("blend_layers", "", "The kernels' and the CPU executor's blending is OSMesa's, product by product."),
];

/// A number of one severity, and how numbers of several severities are put together.
type Metric = (&'static str, fn(&Outcome) -> f64, fn(f64, f64) -> f64);

const METRICS: [Metric; 7] = [
    ("wrong samples", |o| o.score.counts.wrong as f64, |a, b| a + b),
    ("samples off the snapped rule", |o| o.score.counts.off_rule as f64, |a, b| a + b),
    ("images that crashed, hung or ended in an error", |o| o.failures.len() as f64, |a, b| a + b),
    ("largest colour error, in 1/255", |o| o.score.color.max, f64::max),
    ("sum of mean colour errors, in 1/255", |o| o.score.color.mean(), |a, b| a + b),
    ("largest depth error, in units", |o| o.score.depth.max, f64::max),
    ("sum of mean depth errors, in units", |o| o.score.depth.mean(), |a, b| a + b),
];

fn total(result: &FamilyResult, implementation: &str, metric: &Metric) -> Option<f64> {
    let outcomes = result.steps.iter().flat_map(|s| &s.outcomes).filter(|o| o.implementation == implementation);
    outcomes.map(metric.1).reduce(metric.2)
}

/// Where Tepui is the more exact, and where it is the less exact. Differences of less than two percent are none.
pub fn findings(results: &[FamilyResult]) -> [Vec<Finding>; 2] {
    let mut out = [Vec::new(), Vec::new()];
    for result in results {
        for metric in &METRICS {
            let (Some(tepui), Some(osmesa)) = (total(result, "cpu", metric), total(result, "osmesa", metric)) else { continue };
            if (tepui - osmesa).abs() <= 0.02 * tepui.max(osmesa) {
                continue;
            }
            let cause = CAUSES.iter().find(|c| c.0 == result.family && metric.0.contains(c.1));
            let why = cause.map_or("Not examined.", |c| c.2);
            out[usize::from(tepui > osmesa)].push(Finding { family: result.family, metric: metric.0, values: [tepui, osmesa], why });
        }
    }
    out
}
