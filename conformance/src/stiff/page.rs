//! Writes report/stiff.html, which opens without a network, and report/stiff.json.

use std::path::Path;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::findings::{Finding, findings};
use super::plots::{PLOTS, draw, short, style};
use super::run::{FamilyResult, Options, Outcome, Step};
use crate::Error;
use crate::expectations::Verdict;
use crate::machine::machine;
use crate::report::STYLE;

fn verdict(outcome: &Outcome) -> Markup {
    match &outcome.verdict {
        None => html! {},
        Some(Verdict::Pass) => html! { span.pass { "pass" } },
        Some(Verdict::Expected(why)) => html! { span.expected title=(why) { "expected" } },
        Some(Verdict::Fail(why)) => html! { span.fail title=(why) { "FAIL" } },
        Some(Verdict::UnexpectedPass(why)) => html! { span.fail title=(why) { "unexpected pass" } },
    }
}

fn row(step: &Step, outcome: &Outcome, first: bool) -> Markup {
    let (s, c) = (&outcome.score, &outcome.score.counts);
    let value = |count: u64, v: f64| if count == 0 { "-".to_owned() } else { format!("{v:.3}") };
    html! {
        tr {
            td { @if first { (short(step.severity)) @if !step.inside { " (outside)" } } }
            td { (style(outcome.implementation).1) }
            td { (verdict(outcome)) @if outcome.open { span.expected { ", values not judged" } } }
            td { (c.must) } td { (c.may) } td { (c.wrong) } td { (c.beyond) } td { (c.off_rule) } td { (s.holes) } td { (s.doubles) }
            td { (value(s.color.count, s.color.max)) } td { (value(s.color.count, s.color.mean())) }
            td { (value(s.depth.count, s.depth.max)) } td { (value(s.depth.count, s.depth.mean())) }
            td { (format!("{:.2}", outcome.milliseconds)) } td { (outcome.mebibytes) }
            td.fail { @if let Some(why) = outcome.failures.first() { (outcome.failures.len()) " failed, " (why) } }
        }
    }
}

fn section(result: &FamilyResult) -> Result<Markup, Error> {
    let plots = PLOTS.iter().map(|p| draw(result, p)).collect::<Result<Vec<_>, String>>()?;
    let mut reasons: Vec<&str> = Vec::new();
    for outcome in result.steps.iter().flat_map(|s| &s.outcomes) {
        if let Some(Verdict::Expected(why) | Verdict::Fail(why) | Verdict::UnexpectedPass(why)) = &outcome.verdict
            && !reasons.contains(&why.as_str())
        {
            reasons.push(why);
        }
    }
    Ok(html! {
        section id=(result.family) {
            h3 { (result.family) }
            p { (result.about) }
            @for plot in plots.iter().flatten() { figure { (PreEscaped(plot)) } }
            table {
                tr {
                    th { (result.knob) } th { "implementation" } th {} th { "must" } th { "may" } th { "wrong" } th { "beyond" } th { "off rule" } th { "holes" }
                    th { "doubles" } th { "colour max" } th { "mean" } th { "depth max" } th { "mean" } th { "ms" } th { "MiB" } th {}
                }
                @for step in &result.steps { @for (k, outcome) in step.outcomes.iter().enumerate() { (row(step, outcome, k == 0)) } }
            }
            @for why in reasons { p.small { (why) } }
        }
    })
}

fn sum(result: &FamilyResult, implementation: &str, number: impl Fn(&Outcome) -> f64) -> f64 {
    result.steps.iter().flat_map(|s| &s.outcomes).filter(|o| o.implementation == implementation).map(number).sum()
}

fn summary(results: &[FamilyResult], implementations: &[&'static str]) -> Markup {
    let largest = |r: &FamilyResult, i: &str, number: fn(&Outcome) -> (u64, f64)| {
        let outcomes = r.steps.iter().flat_map(|s| &s.outcomes).filter(|o| o.implementation == i);
        let max = outcomes.map(number).filter(|n| n.0 > 0).map(|n| n.1).reduce(f64::max);
        max.map_or("-".to_owned(), |v| if v.is_finite() { format!("{v:.2}") } else { "NaN".into() })
    };
    html! {
        table {
            tr {
                th { "family" }
                @for i in implementations { th { "wrong: " (style(i).1) } }
                @for i in implementations { th { "off rule: " (style(i).1) } }
                @for i in implementations { th { "colour max: " (style(i).1) } }
                @for i in implementations { th { "depth max: " (style(i).1) } }
                @for i in implementations { th { "failed: " (style(i).1) } }
            }
            @for r in results {
                tr {
                    td { a href=(format!("#{}", r.family)) { (r.family) } }
                    @for i in implementations { td { (sum(r, i, |o| o.score.counts.wrong as f64)) } }
                    @for i in implementations { td { (sum(r, i, |o| o.score.counts.off_rule as f64)) } }
                    @for i in implementations { td { (largest(r, i, |o| (o.score.color.count, o.score.color.max))) } }
                    @for i in implementations { td { (largest(r, i, |o| (o.score.depth.count, o.score.depth.max))) } }
                    @for i in implementations { td { (sum(r, i, |o| o.failures.len() as f64)) } }
                }
            }
        }
    }
}

fn found(title: &str, list: &[Finding]) -> Markup {
    html! {
        h3 { (title) }
        @if list.is_empty() { p { "Nowhere." } } @else {
            table {
                tr { th { "family" } th { "number" } th { "Tepui, CPU executor" } th { "OSMesa" } th { "why" } }
                @for f in list {
                    tr {
                        td { a href=(format!("#{}", f.family)) { (f.family) } }
                        td { (f.metric) } td { (short(f.values[0])) } td { (short(f.values[1])) }
                        td style="text-align: left; max-width: 45em" { (f.why) }
                    }
                }
            }
        }
    }
}

fn page(options: &Options, about: &[(&str, String)], results: &[FamilyResult]) -> Result<Markup, Error> {
    let implementations: Vec<&'static str> =
        results.first().map_or(Vec::new(), |r| r.steps[0].outcomes.iter().map(|o| o.implementation).collect());
    let sections = results.iter().map(section).collect::<Result<Vec<_>, _>>()?;
    let [better, worse] = findings(results);
    let meshes: f64 =
        results.iter().filter(|r| r.family.starts_with("mesh_")).flat_map(|r| &r.steps).map(|s| s.severity * s.images as f64).sum();
    let images: usize = results.iter().flat_map(|r| &r.steps).map(|s| s.images).sum();
    let open = results.iter().flat_map(|r| &r.steps).flat_map(|s| &s.outcomes).filter(|o| o.open).count();
    let missed = |i: &str| results.iter().map(|r| sum(r, i, |o| (o.score.holes + o.score.doubles) as f64)).sum::<f64>();
    Ok(html! {
        (DOCTYPE)
        html lang="en" {
            head { meta charset="utf-8"; title { "Tepui: the stiff suite" } style { (PreEscaped(STYLE)) } }
            body {
                h1 { @if options.has_reference() { "The stiff suite: Tepui and OSMesa against an exact oracle" } @else { "The stiff suite: Tepui against an exact oracle" } }
                p {
                    (results.len()) " families, " (images) " images on each implementation, " (options.form()) " form. "
                    "About " (format!("{meshes:.0}")) " triangles in meshes of shared edges: "
                    @for i in &implementations { (style(i).1) " " (missed(i)) "; " } "holes and double hits in all."
                }
                @if !options.has_reference() {
                    p {
                        "OSMesa was not there. Coverage is judged by the oracle, as always. Where values are off by more than 1.5 units, the kernels' are held against the CPU executor's: "
                        "at most a tenth worse. The CPU executor's own are then held against nothing but the exceptions' limits, which leaves " (open) " severities open; with OSMesa they are judged."
                    }
                }
                p { "The same numbers again: " code { (options.command()) } }
                ul {
                    @for (name, value) in machine() { li { b { (name) } ": " (value) } }
                    @for (label, strings) in about { li { b { (style(label).1) } ": " (strings) } }
                }
                h2 { "How it is judged" }
                p.small {
                    "Wrong: a sample that lies farther than half a subpixel (1/512 pixel, and the rounding of a single-precision vertex transform) from every edge of what is left of a primitive "
                    "after exact clipping, and that is not hit just as often as primitives contain it; a nearer sample may be hit or not. "
                    "Beyond: of the wrong ones, those that remain when edges of clipped primitives are allowed the rounding of single-precision clipping. "
                    "Off rule: samples that are allowed, but not what exact arithmetic on snapped positions gives (8 bits, to nearest even, left and bottom edges inclusive). "
                    "Must, may: samples that a primitive must, and may, cover. Holes, doubles: samples inside a mesh of shared edges that are hit never, or more than once. "
                    "Colour errors are in 1/255 against f64 (a correctly rounded value is off by up to 0.5), depth errors in units in the last place of the depth buffer. "
                    "Values are compared where just one primitive must cover a sample and no other may. Times are sums over the images of a severity, the fastest frame of each. "
                    "Outside: corners beyond the guard band, or the eye inside the geometry. "
                    "With floating-point depth, coverage is that of the same calls in the window, depth and colour are those of a framebuffer object. "
                    "Everything is drawn with one sample a pixel; what more samples buy is told by the report on error against run time."
                }
                @if options.has_reference() {
                    h2 { "Findings" }
                    (found("Where Tepui is the more exact", &better))
                    (found("Where Tepui is the less exact", &worse))
                }
                h2 { "All families" }
                (summary(results, &implementations))
                @for s in &sections { (s) }
            }
        }
    })
}

/// Writes both files into `output`.
pub fn write(output: &Path, options: &Options, about: &[(&str, String)], results: &[FamilyResult]) -> Result<(), Error> {
    std::fs::write(output.join("stiff.html"), page(options, about, results)?.into_string())?;
    let json = serde_json::json!({
        "command": options.command(), "form": options.form(), "machine": machine(), "implementations": about, "families": results,
    });
    std::fs::write(output.join("stiff.json"), serde_json::to_string_pretty(&json)?)?;
    Ok(())
}
