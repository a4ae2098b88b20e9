//! Writes report/raster.html, which opens without a network, the plots as SVG files beside it, and report/raster.json.

use std::path::Path;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::plot::draw;
use super::section::{Section, Table};
use crate::Error;
use crate::machine::machine;
use crate::report::STYLE;

fn table(table: &Table) -> Markup {
    html! {
        h4 { (table.caption) }
        table {
            tr { @for head in &table.heads { th { (head) } } }
            @for row in &table.rows { tr { @for cell in row { td { (cell) } } } }
        }
    }
}

fn limits(section: &Section) -> Markup {
    html! {
        @if !section.limits.is_empty() {
            h4 { "Limits" }
            table {
                tr { th { "what" } th { "measured" } th { "at most" } th {} }
                @for limit in &section.limits {
                    tr {
                        td { (limit.what) } td { (format!("{:.4}", limit.measured)) } td { (limit.at_most) }
                        td { @if limit.held() { span.pass { "held" } } @else { span.fail { "broken" } } }
                    }
                }
            }
        }
    }
}

fn part(section: &Section, plots: &[String]) -> Markup {
    html! {
        section id=(section.id) {
            h2 { (section.title) }
            p.small { (section.about) }
            @for what in &section.wrong { p.fail { "Wrong: " (what) } }
            @for why in &section.left_out { p.expected { "Left out: " (why) } }
            @for plot in plots { figure { (PreEscaped(plot)) } }
            @for t in &section.tables { (table(t)) }
            (limits(section))
        }
    }
}

/// Writes all files into `output`. `about`: name and value of what the figures depend on.
pub fn write(output: &Path, command: &str, about: &[(String, String)], sections: &[Section]) -> Result<(), Error> {
    std::fs::create_dir_all(output)?;
    let mut parts = Vec::new();
    for section in sections {
        let mut plots = Vec::new();
        for (k, plot) in section.plots.iter().enumerate() {
            if let Some(svg) = draw(plot)? {
                std::fs::write(output.join(format!("raster-{}-{k}.svg", section.id)), &svg)?;
                plots.push(svg);
            }
        }
        parts.push(part(section, &plots));
    }
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head { meta charset="utf-8"; title { "Tepui: the rasterizer" } style { (PreEscaped(STYLE)) } }
            body {
                h1 { "The rasterizer" }
                p { "The same figures again: " code { (command) } }
                ul {
                    @for (name, value) in machine() { li { b { (name) } ": " (value) } }
                    @for (name, value) in about { li { b { (name) } ": " (value) } }
                }
                @for p in &parts { (p) }
            }
        }
    };
    std::fs::write(output.join("raster.html"), page.into_string())?;
    let json = serde_json::json!({ "command": command, "machine": machine(), "about": about, "sections": sections });
    std::fs::write(output.join("raster.json"), serde_json::to_string_pretty(&json)?)?;
    Ok(())
}
