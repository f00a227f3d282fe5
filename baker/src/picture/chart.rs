//! A chart of curves over logarithmic axes, as SVG.

use std::fmt::Write;

/// A name and points (x, y), both positive.
pub type Curve = (String, Vec<(f64, f64)>);

const SIZE: (f64, f64) = (760.0, 480.0);
const MARGIN: f64 = 56.0;
const LEGEND: f64 = 150.0;
const COLOURS: [&str; 10] =
    ["#000000", "#e69f00", "#56b4e9", "#009e73", "#d0b000", "#0072b2", "#d55e00", "#cc79a7", "#7f7f7f", "#8c564b"];

/// The curves with their names, each axis from the least to the greatest number; `unit` is that of x.
pub fn log_log(title: &str, unit: &str, curves: &[Curve]) -> String {
    let points = || curves.iter().flat_map(|(_, points)| points);
    let range = |numbers: &mut dyn Iterator<Item = f64>| {
        let (least, greatest) = numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, greatest), number| {
            (least.min(number.log10()), greatest.max(number.log10()))
        });
        // A single number stands in the middle.
        if least < greatest { (least, greatest) } else { (least - 0.5, least + 0.5) }
    };
    let (left, right) = range(&mut points().map(|point| point.0));
    let (bottom, top) = range(&mut points().map(|point| point.1));
    let x = |x: f64| MARGIN + (x.log10() - left) / (right - left) * (SIZE.0 - MARGIN - LEGEND);
    let y = |y: f64| SIZE.1 - MARGIN - (y.log10() - bottom) / (top - bottom) * (SIZE.1 - 2.0 * MARGIN);

    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" font-family=\"sans-serif\" font-size=\"12\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n<text x=\"{MARGIN}\" y=\"24\" font-size=\"15\">{}</text>\n",
        SIZE.0,
        SIZE.1,
        escaped(title)
    );
    for (label, number) in ticks(left, right) {
        let (at, low, high) = (x(number), SIZE.1 - MARGIN, MARGIN);
        writeln!(
            svg,
            "<path d=\"M{at:.1} {low}V{high}\" stroke=\"#ddd\"/><text x=\"{at:.1}\" y=\"{}\">{label}{unit}</text>",
            low + 18.0
        )
        .expect("memory");
    }
    for (label, number) in ticks(bottom, top) {
        let (at, end) = (y(number), SIZE.0 - LEGEND);
        writeln!(
            svg,
            "<path d=\"M{MARGIN} {at:.1}H{end}\" stroke=\"#ddd\"/><text x=\"8\" y=\"{at:.1}\">{label}</text>"
        )
        .expect("memory");
    }
    for (index, (name, points)) in curves.iter().enumerate() {
        let colour = COLOURS[index % COLOURS.len()];
        let path: Vec<String> = points.iter().map(|&(a, b)| format!("{:.1},{:.1}", x(a), y(b))).collect();
        let row = MARGIN + 18.0 * index as f64;
        writeln!(
            svg,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\"/>\
             <text x=\"{}\" y=\"{row}\" fill=\"{colour}\">{}</text>",
            path.join(" "),
            SIZE.0 - LEGEND + 12.0,
            escaped(name)
        )
        .expect("memory");
    }
    svg + "</svg>\n"
}

/// Ones, twos and fives between two powers of ten, as they are written and as numbers.
fn ticks(least: f64, greatest: f64) -> impl Iterator<Item = (String, f64)> {
    let labels = (least.floor() as i32..=greatest.floor() as i32)
        .flat_map(|power| [1, 2, 5].map(|digit| (format!("{digit}e{power}"), f64::from(digit) * 10f64.powi(power))));
    labels.filter(move |(_, number)| (least..=greatest).contains(&number.log10()))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chart_of_one_point_is_a_picture() {
        let svg = log_log("a<b & c", " B", &[("one".to_owned(), vec![(100.0, 1e-3)])]);
        assert!(svg.contains("a&lt;b &amp; c") && !svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        assert!(svg.starts_with("<svg") && svg.ends_with("</svg>\n"));
    }

    #[test]
    fn the_ends_of_a_curve_are_at_the_ends_of_the_axes() {
        let svg = log_log("", "", &[("one".to_owned(), vec![(10.0, 1e-2), (1000.0, 1e-4)])]);
        assert!(svg.contains("points=\"56.0,56.0 610.0,424.0\""), "{svg}");
    }
}
