//! The plots of a family: a number over the severity, one curve an implementation.

use plotters::prelude::*;

use super::run::{FamilyResult, Outcome};

/// Colour and name of an implementation's curve.
pub fn style(implementation: &str) -> (RGBColor, &'static str) {
    match implementation {
        "osmesa" => (RGBColor(230, 130, 60), "OSMesa"),
        "cpu" => (RGBColor(30, 90, 180), "Tepui, CPU executor"),
        _ => (RGBColor(20, 140, 70), "Tepui, kernels"),
    }
}

/// Pixels across: curves often lie on each other, so the ones that are drawn first are wider.
const WIDTHS: [u32; 3] = [6, 3, 1];

/// What is drawn.
pub struct Plot {
    /// The vertical axis, with its unit.
    pub title: &'static str,
    /// The number; `None` where it is not defined.
    pub value: fn(&Outcome) -> Option<f64>,
    /// Values up to this are drawn on the floor, which is labelled with it.
    pub floor: f64,
}

/// Every plot that a family may have.
pub const PLOTS: [Plot; 4] = [
    Plot { title: "wrong samples", value: |o| (o.score.counts.samples > 0).then_some(o.score.counts.wrong as f64), floor: 0.1 },
    Plot { title: "largest colour error, 1/255", value: |o| (o.score.color.count > 0).then_some(o.score.color.max), floor: 0.1 },
    Plot { title: "largest depth error, units", value: |o| (o.score.depth.count > 0).then_some(o.score.depth.max), floor: 0.1 },
    Plot { title: "time, milliseconds", value: |o| o.failures.is_empty().then_some(o.milliseconds), floor: 0.001 },
];

/// A number short enough for an axis.
pub fn short(v: f64) -> String {
    if v == 0.0 || (0.01..1e5).contains(&v.abs()) {
        let text = format!("{v:.2}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{v:.0e}")
    }
}

/// The plot as an SVG element, or nothing where no value is defined or all lie on the floor.
pub fn draw(result: &FamilyResult, plot: &Plot) -> Result<Option<String>, String> {
    let curve = |implementation: &str| -> Vec<(f64, f64)> {
        let at = |(i, step): (usize, &super::run::Step)| {
            let outcome = step.outcomes.iter().find(|o| o.implementation == implementation)?;
            Some((i as f64, (plot.value)(outcome)?.clamp(plot.floor, 1e12).log10()))
        };
        result.steps.iter().enumerate().filter_map(at).collect()
    };
    let names: Vec<&str> = result.steps.iter().flat_map(|s| &s.outcomes).map(|o| o.implementation).fold(Vec::new(), |mut names, n| {
        if !names.contains(&n) {
            names.push(n);
        }
        names
    });
    let curves: Vec<(&str, Vec<(f64, f64)>)> = names.into_iter().map(|n| (n, curve(n))).collect();
    let highest = curves.iter().flat_map(|(_, c)| c).map(|p| p.1).fold(f64::NEG_INFINITY, f64::max);
    let floor = plot.floor.log10();
    if highest <= floor {
        return Ok(None);
    }
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, (460, 300)).into_drawing_area();
        let failed = |e: DrawingAreaErrorKind<_>| format!("the plot of {}: {e}", result.family);
        area.fill(&WHITE).map_err(failed)?;
        let last = (result.steps.len() as f64 - 1.0).max(0.5);
        let mut chart = ChartBuilder::on(&area)
            .margin(10)
            .caption(plot.title, ("sans-serif", 15))
            .x_label_area_size(42)
            .y_label_area_size(56)
            .build_cartesian_2d(-0.2..last + 0.2, floor - 0.1..highest + 0.4 * (highest - floor) + 0.3)
            .map_err(failed)?;
        let severity = |x: &f64| {
            let step = (x - x.round()).abs() < 1e-6 && *x >= 0.0;
            step.then(|| result.steps.get(x.round() as usize)).flatten().map_or(String::new(), |s| short(s.severity))
        };
        let magnitude = |y: &f64| {
            let whole = (y - y.round()).abs() < 1e-6;
            if !whole {
                String::new()
            } else if *y <= floor + 1e-9 {
                format!("≤ {}", short(plot.floor))
            } else {
                short(10f64.powf(*y))
            }
        };
        let mut mesh = chart.configure_mesh();
        mesh.x_desc(result.knob).x_labels(result.steps.len() * 2).x_label_formatter(&severity).y_label_formatter(&magnitude);
        mesh.light_line_style(WHITE).label_style(("sans-serif", 11)).draw().map_err(failed)?;
        for ((implementation, points), width) in curves.into_iter().zip(WIDTHS) {
            let (color, name) = style(implementation);
            chart
                .draw_series(LineSeries::new(points.iter().copied(), color.stroke_width(width)).point_size(width + 1))
                .map_err(failed)?
                .label(name)
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 16, y)], color.stroke_width(width)));
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperLeft)
            .background_style(WHITE.mix(0.8))
            .label_font(("sans-serif", 11))
            .draw()
            .map_err(failed)?;
        area.present().map_err(failed)?;
    }
    Ok(Some(svg))
}
