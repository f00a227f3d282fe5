//! OpenVDB's level sets and NanoVDB's quantized ones, where the libraries are installed (on Debian libopenvdb-dev and
//! libnanovdb-dev) and a C++ compiler is.

use crate::subject::Subject;
use crate::{Family, Kind, Measured};
use nearfield_bake::verify::BAND;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, io, process};

/// Voxels along the longest side of the mesh.
const RESOLUTIONS: [u32; 5] = [32, 64, 96, 128, 192];
/// The forms of the program beside this file, and what they are called: narrow, and valid in the whole box.
const FORMS: [(&str, [&str; 2]); 3] = [
    ("openvdb", ["OpenVDB, zip, narrow", "OpenVDB, zip"]),
    ("nanovdb-fp8", ["NanoVDB Fp8, narrow", "NanoVDB Fp8"]),
    ("nanovdb-fpn", ["NanoVDB FpN, narrow", "NanoVDB FpN"]),
];

/// The compiled program.
pub(crate) struct OpenVdb {
    folder: PathBuf,
}

impl Drop for OpenVdb {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.folder);
    }
}

impl OpenVdb {
    /// Compiles the program; none where that fails.
    pub(crate) fn find() -> Option<Self> {
        let folder = env::temp_dir().join(format!("nearfield-pareto-{}", process::id()));
        fs::create_dir_all(&folder).ok()?;
        let found = Self { folder };
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("pareto/openvdb/answers.cpp");
        let compiler = env::var("CXX").unwrap_or_else(|_| "c++".to_owned());
        let status = Command::new(compiler)
            .args(["-O2", "-std=c++17", "-DNDEBUG"])
            .arg(source)
            .arg("-o")
            .arg(found.folder.join("answers"))
            // OpenVDB brings libraries of its own that its headers call.
            .args(["-Wl,--copy-dt-needed-entries", "-lopenvdb", "-ltbb"])
            .status();
        status.is_ok_and(|status| status.success()).then_some(found)
    }

    pub(crate) fn families(&self, subject: &Subject) -> io::Result<Vec<Family>> {
        let mesh = &subject.mesh;
        let vertices = mesh.positions.iter().flat_map(|position| position.as_vec3().to_array());
        self.write("vertices", vertices.map(f32::to_ne_bytes))?;
        self.write("triangles", mesh.triangles.as_flattened().iter().map(|vertex| vertex.to_ne_bytes()))?;
        self.write("points", subject.points().flat_map(|point| point.map(f32::to_ne_bytes)))?;

        let diagonal = mesh.bounds.diagonal();
        let mut families = Vec::new();
        for (form, names) in FORMS {
            let kinds = [Kind::Narrow, Kind::Everywhere];
            families
                .extend(names.into_iter().zip(kinds).map(|(name, kind)| (form, Family { name, kind, fields: vec![] })));
        }
        for resolution in RESOLUTIONS {
            let edge = mesh.bounds.size().max_element() / f64::from(resolution);
            // So that the eight voxels about every point of the band hold distances, and at least OpenVDB's own three.
            let narrow = (BAND * diagonal + 2.0 * edge).max(3.0 * edge);
            for (kind, width) in [(Kind::Narrow, narrow), (Kind::Everywhere, diagonal)] {
                let output = Command::new(self.folder.join("answers"))
                    .arg(&self.folder)
                    .args([edge.to_string(), width.to_string()])
                    .output()?;
                let text = String::from_utf8_lossy(&output.stdout);
                for line in text.lines() {
                    let (form, bytes, nanoseconds) = parsed(line).ok_or_else(|| io::Error::other(line.to_owned()))?;
                    let answers = self.read(form)?;
                    let figures = subject.figures(&answers, nanoseconds);
                    assert!(figures.band.rmse * diagonal < edge, "{form} of {resolution}: these are no distances");
                    let family = families.iter_mut().find(|(f, family)| *f == form && family.kind == kind);
                    let (_, family) = family.ok_or_else(|| io::Error::other(form.to_owned()))?;
                    family.fields.push(Measured { setting: resolution.to_string(), bytes, figures });
                }
            }
        }
        Ok(families.into_iter().map(|(_, family)| family).collect())
    }

    fn write<const N: usize>(&self, name: &str, numbers: impl Iterator<Item = [u8; N]>) -> io::Result<()> {
        fs::write(self.folder.join(name), numbers.collect::<Vec<_>>().as_flattened())
    }

    fn read(&self, name: &str) -> io::Result<Vec<f32>> {
        let bytes = fs::read(self.folder.join(name))?;
        Ok(bytes.as_chunks().0.iter().map(|&bytes| f32::from_ne_bytes(bytes)).collect())
    }
}

/// Form, bytes and nanoseconds.
fn parsed(line: &str) -> Option<(&str, usize, f64)> {
    let mut words = line.split_whitespace();
    Some((words.next()?, words.next()?.parse().ok()?, words.next()?.parse().ok()?))
}
