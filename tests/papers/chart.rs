//! A chart of curves over logarithmic axes, as SVG.

use std::fmt::Write;

/// A name and points (x, y), both positive.
pub(crate) type Curve = (String, Vec<(f64, f64)>);

const SIZE: (f64, f64) = (760.0, 480.0);
const MARGIN: f64 = 56.0;
const LEGEND: f64 = 150.0;
const COLOURS: [&str; 10] =
    ["#000000", "#e69f00", "#56b4e9", "#009e73", "#d0b000", "#0072b2", "#d55e00", "#cc79a7", "#7f7f7f", "#8c564b"];

/// `unit` is that of x.
pub(crate) fn log_log(title: &str, unit: &str, curves: &[Curve]) -> String {
    let points = || curves.iter().flat_map(|(_, points)| points);
    let range = |numbers: &mut dyn Iterator<Item = f64>| {
        numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, greatest), number| {
            (least.min(number.log10()), greatest.max(number.log10()))
        })
    };
    let (left, right) = range(&mut points().map(|point| point.0));
    let (bottom, top) = range(&mut points().map(|point| point.1));
    let x = |x: f64| MARGIN + (x.log10() - left) / (right - left) * (SIZE.0 - MARGIN - LEGEND);
    let y = |y: f64| SIZE.1 - MARGIN - (y.log10() - bottom) / (top - bottom) * (SIZE.1 - 2.0 * MARGIN);

    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" font-family=\"sans-serif\" font-size=\"12\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n<text x=\"{MARGIN}\" y=\"24\" font-size=\"15\">{title}</text>\n",
        SIZE.0, SIZE.1
    );
    for power in left.ceil() as i32..=right.floor() as i32 {
        let (at, low, high) = (x(10f64.powi(power)), SIZE.1 - MARGIN, MARGIN);
        writeln!(
            svg,
            "<path d=\"M{at:.1} {low}V{high}\" stroke=\"#ddd\"/><text x=\"{at:.1}\" y=\"{}\">1e{power}{unit}</text>",
            low + 18.0
        )
        .expect("memory");
    }
    for power in bottom.ceil() as i32..=top.floor() as i32 {
        let (at, end) = (y(10f64.powi(power)), SIZE.0 - LEGEND);
        writeln!(
            svg,
            "<path d=\"M{MARGIN} {at:.1}H{end}\" stroke=\"#ddd\"/><text x=\"8\" y=\"{at:.1}\">1e{power}</text>"
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
             <text x=\"{}\" y=\"{row}\" fill=\"{colour}\">{name}</text>",
            path.join(" "),
            SIZE.0 - LEGEND + 12.0
        )
        .expect("memory");
    }
    svg + "</svg>\n"
}
