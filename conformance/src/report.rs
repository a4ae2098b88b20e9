//! Writes report/index.html, which opens without a network, and report/report.json.

use std::path::Path;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::Error;
use crate::compare::{Row, Side};
use crate::expectations::Verdict;
use crate::frame::Difference;
use crate::timing::Times;

/// The style sheet of all reports.
pub const STYLE: &str = "
body { font: 14px/1.4 system-ui, sans-serif; margin: 2em; color: #222; background: #fafafa }
table { border-collapse: collapse } td, th { padding: .15em .7em; text-align: right; border-bottom: 1px solid #ddd }
td:first-child, th:first-child { text-align: left }
section { margin: 2em 0; padding: 1em; background: #fff; border: 1px solid #ddd }
figure { display: inline-block; margin: .4em } figcaption { color: #666 } img { max-width: 256px; image-rendering: pixelated; background: #000 }
.pass { color: #070 } .expected { color: #850 } .fail { color: #c00; font-weight: bold } .small { color: #666; max-width: 60em }
";

fn verdict(v: &Verdict) -> Markup {
    match v {
        Verdict::Pass => html! { span.pass { "pass" } },
        Verdict::Expected(why) => html! { span.expected title=(why) { "expected" } },
        Verdict::Fail(why) => html! { span.fail title=(why) { "FAIL" } },
        Verdict::UnexpectedPass(why) => html! { span.fail title=(why) { "unexpected pass" } },
    }
}

fn milliseconds(times: &Option<Result<Times, String>>) -> String {
    match times {
        None => "-".into(),
        Some(Err(why)) => why.clone(),
        Some(Ok(t)) => format!("{:.2} ({:.2} – {:.2})", t.median, t.quartiles[0], t.quartiles[1]),
    }
}

fn ratio(times: &Option<Result<Times, String>>) -> String {
    times.as_ref().and_then(|t| t.as_ref().ok()).and_then(|t| t.ratio).map_or_else(|| "-".into(), |r| format!("{r:.2}"))
}

fn difference_cells(outcome: &Result<Difference, String>) -> Markup {
    match outcome {
        Err(why) => html! { td.fail colspan="9" { (why) } },
        Ok(d) => html! {
            td { (d.pixels) } td { (d.max) } td { (format!("{:.4}", d.mean)) } td { (format!("{:.5}", d.flip)) }
            td { (d.coverage) } td { (d.depth_pixels) } td { (d.depth_max) } td { (d.stencil) } td { (d.text) }
        },
    }
}

fn heads(first: &str) -> Markup {
    html! {
        tr {
            th { (first) } th { "pixels" } th { "max /255" } th { "mean /255" } th { "FLIP" } th { "coverage" } th { "depth px" } th { "depth max" }
            th { "stencil" } th { "text" }
        }
    }
}

fn name(side: &Side) -> &'static str {
    match side.device {
        "cpu" => "CPU executor",
        "gpu" => "kernels",
        "parity" => "TEPUI_PARITY=osmesa",
        other => other,
    }
}

fn section(row: &Row) -> Markup {
    html! {
        section id=(row.scene) {
            h3 { (row.scene) " " small { (row.class) } }
            p { (row.proves) }
            @if let Some(picture) = &row.picture { figure { img src=(picture) loading="lazy"; figcaption { "OSMesa" } } }
            @for side in row.sides.iter().chain(&row.parity) {
                @if let Some([picture, difference]) = &side.pictures {
                    figure { img src=(picture) loading="lazy"; figcaption { (name(side)) } }
                    figure { img src=(difference) loading="lazy"; figcaption { (name(side)) " - OSMesa, x16" } }
                }
            }
            table {
                (heads("against"))
                @for side in row.sides.iter().chain(&row.parity) {
                    tr { td { (name(side)) " - OSMesa" } (difference_cells(&side.against_reference)) }
                    @if let Some(outcome) = &side.against_cpu { tr { td { (name(side)) " - CPU executor" } (difference_cells(outcome)) } }
                }
            }
            @for side in row.sides.iter().chain(&row.parity) {
                p {
                    (name(side)) ": " (verdict(&side.verdict))
                    @match &side.verdict { Verdict::Expected(why) | Verdict::Fail(why) | Verdict::UnexpectedPass(why) => { ": " (why) } Verdict::Pass => {} }
                    ". Time " (milliseconds(&side.times)) " ms, OSMesa " (milliseconds(&row.times)) " ms, ratio " (ratio(&side.times)) "."
                }
                @if let Ok(d) = &side.against_reference {
                    @for (reference, test) in &d.text_sample { p.small { "OSMesa: " code { (reference) } br; (name(side)) ": " code { (test) } } }
                }
            }
        }
    }
}

fn page(rows: &[Row], about: &[(&str, String)]) -> Markup {
    let good = rows.iter().filter(|r| r.sides.iter().chain(&r.parity).all(|s| s.verdict.good())).count();
    html! {
        (DOCTYPE)
        html lang="en" {
            head { meta charset="utf-8"; title { "Tepui and OSMesa" } style { (PreEscaped(STYLE)) } }
            body {
                h1 { "Tepui and Mesa's OSMesa" }
                p { (rows.len()) " scenes, " (good) " as demanded or expected." }
                ul { @for (label, strings) in about { li { b { (label) } ": " (strings) } } }
                p.small {
                    "Classes: exact = everything equal; shaded = coverage, depth and stencil equal, colour within 1/255; other = at most 0.1 % of the pixels differ. "
                    "The kernels are judged against the CPU executor: coverage and stencil equal, depth within one unit, colour within 1/255. "
                    "Times are medians with quartiles, frames of all implementations interleaved; ratio is the median of the ratios of neighbouring frames, under 1 is faster than OSMesa."
                }
                table {
                    tr {
                        th { "scene" } th { "class" }
                        @if let Some(row) = rows.first() { @for side in &row.sides { th { (name(side)) } th { "pixels" } th { "max" } th { "FLIP" } th { "time ratio" } } }
                    }
                    @for row in rows {
                        tr {
                            td { a href=(format!("#{}", row.scene)) { (row.scene) } } td { (row.class) }
                            @for side in &row.sides {
                                td { (verdict(&side.verdict)) }
                                @match &side.against_reference {
                                    Ok(d) => { td { (d.pixels) } td { (d.max) } td { (format!("{:.5}", d.flip)) } }
                                    Err(_) => { td { "-" } td { "-" } td { "-" } }
                                }
                                td { (ratio(&side.times)) }
                            }
                        }
                    }
                }
                @for row in rows { (section(row)) }
            }
        }
    }
}

/// Writes both files into `output`.
pub fn write(output: &Path, rows: &[Row], about: &[(&str, String)]) -> Result<(), Error> {
    std::fs::write(output.join("index.html"), page(rows, about).into_string())?;
    let json = serde_json::json!({ "implementations": about, "scenes": rows });
    std::fs::write(output.join("report.json"), serde_json::to_string_pretty(&json)?)?;
    Ok(())
}
