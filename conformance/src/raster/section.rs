//! What a case has measured: tables, plots and limits, the same for the terminal, the page and the JSON.

use serde::Serialize;

/// A table.
#[derive(Debug, Default, Serialize)]
pub struct Table {
    /// What it shows.
    pub caption: String,
    /// Heads of the columns.
    pub heads: Vec<String>,
    /// Cells by rows.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// Without rows yet.
    pub fn new(caption: impl Into<String>, heads: &[&str]) -> Table {
        Table { caption: caption.into(), heads: heads.iter().map(|h| (*h).to_owned()).collect(), rows: Vec::new() }
    }
}

/// A curve of a plot.
#[derive(Clone, Debug, Serialize)]
pub struct Curve {
    /// Its name in the legend.
    pub name: String,
    /// x and y.
    pub points: Vec<(f64, f64)>,
}

/// A plot, both axes logarithmic.
#[derive(Clone, Debug, Serialize)]
pub struct Plot {
    /// What it shows.
    pub title: String,
    /// The quantity along x, with its unit.
    pub x: String,
    /// The quantity along y, with its unit.
    pub y: String,
    /// The curves.
    pub curves: Vec<Curve>,
}

impl Plot {
    /// Without curves yet.
    pub fn new(title: impl Into<String>, x: &str, y: &str) -> Plot {
        Plot { title: title.into(), x: x.into(), y: y.into(), curves: Vec::new() }
    }

    /// Adds a point to the curve of this name.
    pub fn point(&mut self, name: &str, x: f64, y: f64) {
        let known = self.curves.iter().position(|c| c.name == name);
        let k = known.unwrap_or_else(|| {
            self.curves.push(Curve { name: name.into(), points: Vec::new() });
            self.curves.len() - 1
        });
        self.curves[k].points.push((x, y));
    }
}

/// A limit and what was measured.
#[derive(Clone, Debug, Serialize)]
pub struct Limit {
    /// What is limited, with its unit.
    pub what: String,
    /// What was measured.
    pub measured: f64,
    /// The limit.
    pub at_most: f64,
}

impl Limit {
    /// Whether it holds.
    pub fn held(&self) -> bool {
        self.measured <= self.at_most
    }
}

/// All that a case has measured.
#[derive(Debug, Default, Serialize)]
pub struct Section {
    /// Its name on the command line.
    pub id: &'static str,
    /// Its title.
    pub title: String,
    /// What is measured and how.
    pub about: String,
    /// Tables.
    pub tables: Vec<Table>,
    /// Plots.
    pub plots: Vec<Plot>,
    /// Limits that apply here.
    pub limits: Vec<Limit>,
    /// What was left out, and why.
    pub left_out: Vec<String>,
    /// What is wrong: pictures that differ.
    pub wrong: Vec<String>,
}

impl Section {
    /// Without results yet; says on the terminal that it begins.
    pub fn new(id: &'static str, title: &str, about: &str) -> Section {
        println!("\n== {title}");
        Section { id, title: title.into(), about: about.into(), ..Section::default() }
    }

    /// Something is not measured: said at once, and in the report.
    pub fn leave_out(&mut self, why: String) {
        println!("LEFT OUT: {why}");
        self.left_out.push(why);
    }

    /// Something is wrong: said at once, and in the report.
    pub fn wrong(&mut self, what: String) {
        println!("WRONG: {what}");
        self.wrong.push(what);
    }

    /// A limit: said at once, and in the report.
    pub fn limit(&mut self, what: impl Into<String>, measured: f64, at_most: f64) {
        let limit = Limit { what: what.into(), measured, at_most };
        println!("limit {}: {} is {:.4}, at most {}", if limit.held() { "held" } else { "BROKEN" }, limit.what, measured, at_most);
        self.limits.push(limit);
    }
}

/// A line of progress, each cell as wide as its head.
pub fn progress(cells: &[String]) {
    use std::io::Write;
    println!("{}", cells.iter().map(|c| format!("{c:>10}")).collect::<Vec<_>>().join(" "));
    let _ = std::io::stdout().flush();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_of_one_name_are_one_curve() {
        let mut plot = Plot::new("", "", "");
        [("a", 1.0), ("b", 2.0), ("a", 3.0)].iter().for_each(|(name, x)| plot.point(name, *x, 0.0));
        assert_eq!(plot.curves.iter().map(|c| c.points.len()).collect::<Vec<_>>(), [2, 1]);
    }

    #[test]
    fn a_limit_without_a_measurement_is_broken() {
        assert!(!Limit { what: String::new(), measured: f64::NAN, at_most: 1.0 }.held());
        assert!(Limit { what: String::new(), measured: 1.0, at_most: 1.0 }.held());
    }
}
