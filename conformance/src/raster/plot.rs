//! Plots with two logarithmic axes, as SVG elements.

use plotters::prelude::*;

use super::section::Plot;
use crate::stiff::plots::short;

const COLORS: [RGBColor; 10] = [
    RGBColor(30, 90, 180),
    RGBColor(230, 130, 60),
    RGBColor(20, 140, 70),
    RGBColor(200, 40, 60),
    RGBColor(150, 90, 170),
    RGBColor(90, 90, 90),
    RGBColor(190, 160, 20),
    RGBColor(20, 160, 170),
    RGBColor(220, 110, 170),
    RGBColor(120, 70, 30),
];

/// The least and the greatest, at least a decade apart, on a logarithmic axis.
fn range(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    let margin = 0.05 * (high - low).max(0.4);
    (low <= high).then_some((low - margin, high + margin))
}

/// The plot as an SVG element; `None` where it has no point.
pub fn draw(plot: &Plot) -> Result<Option<String>, String> {
    let logs = |points: &[(f64, f64)]| -> Vec<(f64, f64)> {
        points.iter().filter(|p| p.0 > 0.0 && p.1 > 0.0).map(|p| (p.0.log10(), p.1.log10())).collect()
    };
    let all: Vec<_> = plot.curves.iter().flat_map(|c| logs(&c.points)).collect();
    let (Some((left, right)), Some((bottom, top))) = (range(all.iter().map(|p| p.0)), range(all.iter().map(|p| p.1))) else {
        return Ok(None);
    };
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, (720, 420)).into_drawing_area();
        let failed = |e: DrawingAreaErrorKind<_>| format!("the plot {}: {e}", plot.title);
        area.fill(&WHITE).map_err(failed)?;
        // The legend has its own room at the right.
        let (area, legend) = area.split_horizontally(520);
        let mut chart = ChartBuilder::on(&area)
            .margin(12)
            .caption(&plot.title, ("sans-serif", 15))
            .x_label_area_size(44)
            .y_label_area_size(64)
            .build_cartesian_2d(left..right, bottom..top)
            .map_err(failed)?;
        let power = |v: &f64| short(10f64.powf(*v));
        let mut mesh = chart.configure_mesh();
        mesh.x_desc(&plot.x).y_desc(&plot.y).x_label_formatter(&power).y_label_formatter(&power).x_labels(8).y_labels(8);
        mesh.light_line_style(WHITE).label_style(("sans-serif", 11)).draw().map_err(failed)?;
        for (k, curve) in plot.curves.iter().enumerate() {
            let color = COLORS[k % COLORS.len()];
            chart.draw_series(LineSeries::new(logs(&curve.points), color.stroke_width(2)).point_size(3)).map_err(failed)?;
            let y = 40 + 18 * k as i32;
            legend.draw(&PathElement::new([(0, y), (18, y)], color.stroke_width(2))).map_err(failed)?;
            legend.draw(&Text::new(curve.name.clone(), (24, y - 6), ("sans-serif", 12))).map_err(failed)?;
        }
        area.present().map_err(failed)?;
    }
    Ok(Some(svg))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plot_of_nothing_is_left_out() {
        let mut plot = Plot::new("nothing", "x", "y");
        assert_eq!(draw(&plot), Ok(None));
        plot.point("a", 0.0, 1.0);
        assert_eq!(draw(&plot), Ok(None), "zero has no logarithm");
        plot.point("a", 1.0, 1.0);
        assert!(draw(&plot).is_ok_and(|svg| svg.is_some_and(|s| s.starts_with("<svg"))));
    }
}
