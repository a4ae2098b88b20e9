//! Writes report/precision.html, which opens without a network, and report/precision.json.

use std::path::Path;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::leaving_out::Table;
use super::plot::{draw, style};
use super::{Diagram, Options, Point};
use crate::Error;
use crate::machine::machine;
use crate::report::STYLE;

fn cells(point: &Point) -> Markup {
    match (&point.failure, &point.missing) {
        (Some(why), _) => html! { td.fail colspan="5" { (why) } },
        (None, Some(why)) => html! { td colspan="5" { (why) } },
        (None, None) => {
            let [low, median, high] = point.milliseconds;
            html! {
                td { (format!("{:.3}", point.rms)) } td { (point.max) } td { (format!("{:.5}", point.flip)) }
                td { (format!("{median:.3}")) } td { (format!("{low:.3} – {high:.3}")) }
            }
        }
    }
}

fn section(diagram: &Diagram) -> Result<Markup, Error> {
    let plot = draw(diagram)?;
    Ok(html! {
        section id=(diagram.scene) {
            h3 { (diagram.scene) }
            p { (diagram.about) }
            figure { (PreEscaped(plot)) }
            @if !diagram.demand.is_empty() {
                p {
                    "Demanded of Tepui: " (diagram.demand) ". "
                    @for (holds, curve) in diagram.curves.iter().filter_map(|c| c.course.map(|holds| (holds, c))) {
                        (style(curve.method).1) ": " @if holds { span.pass { "yes" } } @else { span.fail { "NO" } } "; "
                    }
                }
            }
            table {
                tr { th { (diagram.knob) } th { "method" } th { "RMS, 1/255" } th { "max, 1/255" } th { "FLIP" } th { "ms, median" } th { "quartiles" } }
                @for k in 0..diagram.curves.first().map_or(0, |c| c.points.len()) {
                    @for curve in &diagram.curves { tr { td { (curve.points[k].setting) } td { (style(curve.method).1) } (cells(&curve.points[k])) } }
                }
            }
        }
    })
}

fn left_out(table: &Table) -> Markup {
    html! {
        h3 { (table.scene) }
        table {
            tr {
                th { "forced on" }
                @for method in &table.methods { th { (style(method).1) ", ms" } th { "by nothing" } }
                th { "pixels changed" }
                @for (device, _) in table.costs.iter().take(1).flat_map(|c| &c.built) {
                    th style="text-align: left" { @if *device == "cpu" { "CPU executor" } @else { "kernels" } ": built, left out" }
                }
            }
            @for cost in &table.costs {
                tr {
                    td { (cost.feature) }
                    @for (ms, ratio) in cost.milliseconds.iter().zip(&cost.ratios) { td { (format!("{ms:.2}")) } td { (format!("{ratio:.2}")) } }
                    td { (cost.changed.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")) }
                    @for (_, lines) in &cost.built { td.small style="text-align: left" { @for line in lines { (line) br; } } }
                }
            }
        }
    }
}

/// Writes both files into `output`.
pub fn write(output: &Path, options: &Options, about: &[(&str, String)], diagrams: &[Diagram], tables: &[Table]) -> Result<(), Error> {
    let sections = diagrams.iter().map(section).collect::<Result<Vec<_>, _>>()?;
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head { meta charset="utf-8"; title { "Tepui: error against run time" } style { (PreEscaped(STYLE)) } }
            body {
                h1 { "Error against run time" }
                p { "The same errors again: " code { (options.command()) } }
                ul {
                    @for (name, value) in machine() { li { b { (name) } ": " (value) } }
                    @for (label, strings) in about { li { b { (style(label).1) } ": " (strings) } }
                }
                p.small {
                    "Each point is one setting on one method: left is faster, down is more exact. Errors are of the colours against the scene's reference; those up to 0.01 are drawn at 0.01. "
                    "Times are of whole frames, drawing and glFinish, all methods in turn; the first frame of a context is left out. They drift with the machine: read one diagram's points beside each other. "
                    "Every round draws in a new context and must give the same errors to the last digit. "
                    "A setting that does not exist, and so is not here: a choice of precision of the interpolation."
                }
                @for s in &sections { (s) }
                section id="leaving_out" {
                    h2 { "What is left out, and what it would cost" }
                    p {
                        "Each feature is forced on in a state that changes no pixel. \"By nothing\" is the time by that of the scene without any, drawn in turn with it; how far the first row is from 1 is the noise. "
                        "The last columns are what the executors say of the batch (TEPUI_STATS=1): routines and kernels with what they contain, and what was left out. "
                        "The kernels' are those of a batch that they do from the vertices on (TEPUI_GPU_FRONT=kernels), by which hardware is driven; times are of the front end "
                        "that is chosen by itself."
                    }
                    @for t in tables { (left_out(t)) }
                }
            }
        }
    };
    std::fs::write(output.join("precision.html"), page.into_string())?;
    let json = serde_json::json!({ "command": options.command(), "machine": machine(), "implementations": about, "diagrams": diagrams, "leaving_out": tables });
    std::fs::write(output.join("precision.json"), serde_json::to_string_pretty(&json)?)?;
    Ok(())
}
