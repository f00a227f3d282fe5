use glam::DVec3;
use nearfield_bake::distance::{SignChoice, SignedDistance};
use nearfield_bake::encode::{Provenance, encode_polynomial};
use nearfield_bake::field_function::FieldFunction;
use nearfield_bake::import;
use nearfield_bake::mesh::CheckedMesh;
use nearfield_bake::polynomial::PolynomialOctree;
use nearfield_bake::polynomial::overlap::Blend;
use nearfield_bake::progress::Silent;
use nearfield_bake::random::Draws;
use nearfield_bake::settings::{Settings, PolynomialSettings, Target, Layout};
use rayon::prelude::*;
use cpu_time::ProcessTime;
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let n: u64 = std::env::var("N").ok().and_then(|s| s.parse().ok()).unwrap_or(60000);
    let mesh = CheckedMesh::new(import::read(std::path::Path::new(&args[1])).unwrap()).unwrap();
    let function = SignedDistance::new(&mesh, SignChoice::Auto.resolve(&mesh.topology));
    let diagonal = mesh.bounds.diagonal();
    let uniform: Vec<DVec3> = (0..n).map(|i| { let mut d = Draws::new(7, 1, i); mesh.bounds.min + mesh.bounds.size() * DVec3::new(d.unit(), d.unit(), d.unit()) }).collect();
    let mut areas = vec![]; let mut total = 0.0;
    for t in 0..mesh.triangles.len() { let [a, b, c] = mesh.corners(t); total += (b - a).cross(c - a).length(); areas.push(total); }
    let mut band: Vec<DVec3> = (0..n).map(|i| { let mut d = Draws::new(7, 2, i); let x = d.unit() * total; let t = areas.partition_point(|&a| a <= x).min(areas.len()-1);
        let [a, b, c] = mesh.corners(t); let (mut u, mut v) = (d.unit(), d.unit()); if u + v > 1.0 { (u, v) = (1.0 - u, 1.0 - v); }
        a + (b - a) * u + (c - a) * v + d.direction() * (0.01 * diagonal * d.unit()) }).collect();
    band.sort_by(|a, b| a.x.total_cmp(&b.x));
    let exact_u = function.sample_all(&uniform);
    let exact_b = function.sample_all(&band);
    for e in &args[2..] {
        let e: f64 = e.parse().unwrap();
        let start = ProcessTime::now();
        let o = PolynomialOctree::build(&function, &mesh.bounds, &Settings { error: Target::Relative(e), layout: Layout::Polynomial(PolynomialSettings::default()), ..Settings::default() }, &PolynomialSettings::default(), diagonal, &Silent);
        let built = start.elapsed().as_secs_f64();
        let p = Provenance { mesh_hash: [0; 16], settings_hash: [0; 8], sign_method: 1, diagonal, target_error: e * diagonal };
        let bytes = encode_polynomial(&o, &p).unwrap();
        if let Ok(path) = std::env::var("OUT") { std::fs::write(path, &bytes).unwrap(); }
        let enc = start.elapsed().as_secs_f64() - built;
        let blend = Blend::new(&o.cells, &o.reaches, o.overlap, &o.steps);
        let measure = |points: &[DVec3], exact: &[nearfield_bake::field_function::Sample]| {
            let r: Vec<(f64, f64, f64)> = points.par_iter().zip(exact).map(|(&p, s)| { let (v, g) = blend.evaluate(p);
                let angle = (g.dot(s.gradient) / (g.length() * s.gradient.length()).max(1e-30)).clamp(-1.0, 1.0).acos().to_degrees(); ((v - s.distance).abs() / diagonal, angle, g.length()) }).collect();
            let rmse = (r.iter().map(|x| x.0 * x.0).sum::<f64>() / r.len() as f64).sqrt();
            let max = r.iter().map(|x| x.0).fold(0.0, f64::max);
            let angle = r.iter().map(|x| x.1).sum::<f64>() / r.len() as f64;
            let steep = r.iter().map(|x| x.2).fold(0.0, f64::max);
            (rmse, max, angle, steep) };
        if std::env::var("WORST").is_ok() {
            let mut w: Vec<(f64, usize)> = uniform.iter().zip(&exact_u).enumerate().map(|(i, (&p, s))| ((blend.evaluate(p).0 - s.distance).abs() / diagonal, i)).collect();
            w.sort_by(|a, b| b.0.total_cmp(&a.0));
            for &(err, i) in w.iter().take(15) {
                let p = uniform[i]; let d = &o.cells.domain;
                for (_, cell, coded) in o.cells.leaves() {
                    let edge = d.edge(cell.level); let local = (p - d.point(cell.origin)) / edge * 2.0 - 1.0;
                    if local.abs().max_element() < 1.0 { println!("  err {err:.1e} level {} kind {:?} {:?} exp {} w {:?} local {local:.2} own {:.1e} d {:.1e}", cell.level, coded.kind, coded.degrees, coded.exponent, coded.widths, (o.steps.decode(coded).evaluate(local).0 - exact_u[i].distance).abs() / diagonal, exact_u[i].distance/diagonal); }
                }
            }
        }
        let u = measure(&uniform, &exact_u); let b = measure(&band, &exact_b);
        let leaves = o.cells.leaves().count();
        let mut kinds = std::collections::BTreeMap::new();
        for (_, _, c) in o.cells.leaves() { *kinds.entry((c.kind as u8 > 0, if c.kind as u8 > 0 && c.degrees[0] < c.degrees[1] { [c.degrees[1], c.degrees[0]] } else { c.degrees })).or_insert(0) += 1; }
        println!("{e:.2e}: {} B, {leaves} leaves {:.2} B/leaf | uni {:.2e} max {:.1e} ang {:.2} | band {:.2e} max {:.1e} ang {:.2} | steep {:.2} {:.2} | cpu {built:.1}+{enc:.1} samples {} ", bytes.len(), bytes.len() as f64 / leaves as f64, u.0, u.1, u.2, b.0, b.1, b.2, u.3, b.3, o.samples);
        if std::env::var("V").is_ok() { println!("   levels {:?} kinds {kinds:?}", o.leaves_by_level()); }
    }
}
