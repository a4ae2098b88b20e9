//! A work-precision diagram: log error over log time, one curve a method.

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, ValueFormatter};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;

use super::{Diagram, Point};
use crate::stiff::plots::short;

/// Errors up to this, in 1/255, are drawn on the floor.
const FLOOR: f64 = 0.01;

/// Colour and name of a method's curve.
pub fn style(method: &str) -> (RGBColor, &'static str) {
    match method {
        "osmesa" => (RGBColor(230, 130, 60), "OSMesa"),
        "scalar" => (RGBColor(150, 90, 170), "Tepui, CPU scalar"),
        "cpu" => (RGBColor(30, 90, 180), "Tepui, CPU AVX2"),
        _ => (RGBColor(20, 140, 70), "Tepui, kernels"),
    }
}

/// An axis of logarithms, whose ticks are at round values.
struct Logarithms(RangedCoordf64, Vec<f64>);

impl Logarithms {
    fn new(from: f64, to: f64) -> Logarithms {
        Logarithms((from..to).into(), ticks(from, to))
    }
}

impl Ranged for Logarithms {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        self.0.map(value, limit)
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.1.clone()
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.0.range()
    }
}

impl ValueFormatter<f64> for Logarithms {
    fn format(value: &f64) -> String {
        short(10f64.powf(*value))
    }
}

/// Logarithms of 1, 2 and 5 times the powers of ten within a range of logarithms, of the powers alone where these are many; round
/// values at equal distances where they are few.
fn ticks(from: f64, to: f64) -> Vec<f64> {
    let within = |values: Vec<f64>| -> Vec<f64> { values.into_iter().map(f64::log10).filter(|t| (from..=to).contains(t)).collect() };
    let decades = || from.floor() as i32..=to.ceil() as i32;
    let powers = within(decades().map(|k| 10f64.powi(k)).collect());
    if powers.len() > 4 {
        return powers;
    }
    let steps = within(decades().flat_map(|k| [1.0, 2.0, 5.0].map(|m| m * 10f64.powi(k))).collect());
    if steps.len() > 3 {
        return steps;
    }
    let [low, high] = [from, to].map(|v| 10f64.powf(v));
    let step = 10f64.powf(((high - low) / 2.0).log10().floor());
    within(((low / step).ceil() as u64..=(high / step).floor() as u64).map(|k| k as f64 * step).collect())
}

/// The diagram as an SVG element, the settings written beside the points of the first curve that has them all.
pub fn draw(diagram: &Diagram) -> Result<String, String> {
    let drawn = |points: &[Point]| -> Vec<(f64, f64, f64, f64, String)> {
        let good = points.iter().filter(|p| p.drawn());
        good.map(|p| {
            let [low, median, high] = p.milliseconds.map(f64::log10);
            (median, p.rms.max(FLOOR).log10(), low, high, p.setting.clone())
        })
        .collect()
    };
    let all: Vec<_> = diagram.curves.iter().flat_map(|c| drawn(&c.points)).collect();
    let range = |values: &mut dyn Iterator<Item = f64>| values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    let (left, right) = range(&mut all.iter().flat_map(|p| [p.2, p.3]));
    let (bottom, top) = range(&mut all.iter().map(|p| p.1));
    if all.is_empty() {
        return Err(format!("{}: no method drew anything", diagram.scene));
    }
    let most = diagram.curves.iter().map(|c| drawn(&c.points).len()).max();
    let labelled = diagram.curves.iter().position(|c| Some(drawn(&c.points).len()) == most);
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, (760, 460)).into_drawing_area();
        let failed = |e: DrawingAreaErrorKind<_>| format!("the diagram of {}: {e}", diagram.scene);
        area.fill(&WHITE).map_err(failed)?;
        let margin = 0.15 * (top - bottom).max(0.2);
        let mut chart = ChartBuilder::on(&area)
            .margin(12)
            .x_label_area_size(44)
            .y_label_area_size(64)
            .build_cartesian_2d(Logarithms::new(left - 0.1, right + 0.35), Logarithms::new(bottom - margin, top + 2.5 * margin))
            .map_err(failed)?;
        let mut mesh = chart.configure_mesh();
        mesh.x_desc("milliseconds a frame (median and quartiles), log").y_desc("RMS error, 1/255, log");
        mesh.light_line_style(WHITE).label_style(("sans-serif", 11)).draw().map_err(failed)?;
        for (k, curve) in diagram.curves.iter().enumerate() {
            let (color, name) = style(curve.method);
            let points = drawn(&curve.points);
            chart
                .draw_series(LineSeries::new(points.iter().map(|p| (p.0, p.1)), color.stroke_width(2)).point_size(3))
                .map_err(failed)?
                .label(name)
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 16, y)], color.stroke_width(2)));
            chart.draw_series(points.iter().map(|p| PathElement::new([(p.2, p.1), (p.3, p.1)], color.mix(0.5)))).map_err(failed)?;
            if Some(k) == labelled {
                let label = |p: &(f64, f64, f64, f64, String)| Text::new(p.4.clone(), (p.0 + 0.01, p.1), ("sans-serif", 10));
                chart.draw_series(points.iter().map(label)).map_err(failed)?;
            }
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperRight)
            .background_style(WHITE.mix(0.8))
            .label_font(("sans-serif", 11))
            .draw()
            .map_err(failed)?;
        area.present().map_err(failed)?;
    }
    Ok(svg)
}

#[cfg(test)]
mod tests {
    use super::ticks;

    fn values(from: f64, to: f64) -> Vec<f64> {
        ticks(from.log10(), to.log10()).into_iter().map(|t| (10f64.powf(t) * 1e6).round() / 1e6).collect()
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(values(0.3, 40.0), [0.5, 1.0, 2.0, 5.0, 10.0, 20.0]);
        assert_eq!(values(0.05, 3000.0), [0.1, 1.0, 10.0, 100.0, 1000.0]);
        assert_eq!(values(0.31, 0.68), [0.4, 0.5, 0.6]);
    }
}
