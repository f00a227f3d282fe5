//! The manifest of a batch: TOML that names meshes by globs and says how to bake them.

use globset::{GlobBuilder, GlobSet, GlobSetBuilder};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};
use std::{fs, io};
use thiserror::Error;
use toml::{Table, Value};
use walkdir::WalkDir;

/// What to bake.
#[derive(Clone, Debug)]
pub struct Manifest {
    /// The meshes in the order of their paths.
    pub assets: Vec<Asset>,
    /// Folder of the cache, if the manifest names one.
    pub cache: Option<PathBuf>,
    /// Globs that found no mesh.
    pub idle_globs: Vec<String>,
}

/// One mesh and the field to bake from it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Asset {
    /// The mesh.
    pub mesh: PathBuf,
    /// The field.
    pub field: PathBuf,
    /// The settings as flags of `nearfield bake`, in the order of their names.
    pub flags: Vec<String>,
}

/// Why a manifest is not understood.
#[derive(Debug, Error)]
#[error("{}: {problem}", path.display())]
pub struct ManifestError {
    /// The manifest.
    pub path: PathBuf,
    /// What is wrong with it.
    #[source]
    pub problem: Problem,
}

/// What is wrong with a manifest.
#[derive(Debug, Error)]
pub enum Problem {
    /// It cannot be read.
    #[error("it cannot be read: {0}")]
    Unreadable(#[source] io::Error),
    /// It is not TOML, or not of this form.
    #[error("{}", .0.to_string().trim_end())]
    Malformed(#[from] toml::de::Error),
    /// A glob is not one.
    #[error("{0}")]
    Glob(#[from] globset::Error),
    /// A folder cannot be listed.
    #[error("{0}")]
    Walk(#[from] walkdir::Error),
    /// A preset is named but not there.
    #[error("there is no preset {0:?}; write a table [presets.{0}]")]
    NoPreset(String),
    /// A preset inherits from itself.
    #[error("the preset {0:?} inherits from itself")]
    Cycle(String),
    /// A key that is not for manifests.
    #[error("{0:?} is decided by the batch; remove it")]
    Reserved(String),
    /// A setting is neither a string, a number nor a switch.
    #[error("{0:?} must be a string, a number, true or false")]
    Shape(String),
    /// Two meshes would become one field.
    #[error("{} and {} would both become {}; exclude one, or give it an entry with an output of its own", .meshes[0].display(), .meshes[1].display(), field.display())]
    Clash {
        /// The meshes.
        meshes: [PathBuf; 2],
        /// Their field.
        field: PathBuf,
    },
}

/// The file as it is written.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Text {
    output: Option<PathBuf>,
    cache: Option<PathBuf>,
    #[serde(default)]
    settings: Table,
    #[serde(default)]
    presets: BTreeMap<String, Preset>,
    assets: Vec<Entry>,
}

#[derive(Debug, Deserialize)]
struct Preset {
    inherits: Option<String>,
    #[serde(flatten)]
    settings: Table,
}

#[derive(Debug, Deserialize)]
struct Entry {
    include: Vec<String>,
    #[serde(default)]
    exclude: Vec<String>,
    preset: Option<String>,
    output: Option<PathBuf>,
    #[serde(flatten)]
    settings: Table,
}

/// Flags of `bake` that say where things go or how the program behaves, not what the field is.
const RESERVED: [&str; 8] = ["output", "report", "depfile", "if-changed", "threads", "quiet", "help", "mesh"];
/// Settings that say the same thing in two ways: the nearer one replaces both.
const ALTERNATIVES: [&str; 2] = ["error", "error-abs"];

impl Manifest {
    /// Reads a manifest and finds its meshes. Paths in it are relative to its folder.
    ///
    /// A mesh that several entries match belongs to the last of them. A path without a wildcard is an asset even if
    /// nothing is there, so that its absence is noticed.
    ///
    /// # Errors
    /// The manifest is not understood, a folder cannot be listed, or two meshes would become one field.
    pub fn read(path: &Path) -> Result<Self, ManifestError> {
        let read = || {
            let text = fs::read_to_string(path).map_err(Problem::Unreadable)?;
            Self::parse(&text, path.parent().unwrap_or(Path::new("")))
        };
        read().map_err(|problem| ManifestError { path: path.to_owned(), problem })
    }

    fn parse(text: &str, folder: &Path) -> Result<Self, Problem> {
        let text: Text = toml::from_str(text)?;
        let mut idle_globs = Vec::new();

        // Every mesh with the last entry that matches it.
        let mut by_mesh = BTreeMap::new();
        for entry in &text.assets {
            let flags = flags(&text.settings_of(entry)?)?;
            let output = entry.output.as_ref().or(text.output.as_ref()).cloned().unwrap_or_default();
            let excluded = globs(&entry.exclude)?;

            for pattern in &entry.include {
                let meshes = find(folder, pattern)?;
                if meshes.is_empty() {
                    idle_globs.push(pattern.clone());
                }
                for mesh in meshes.into_iter().filter(|mesh| !excluded.is_match(mesh)) {
                    let field = folder.join(&output).join(below_the_manifest(&mesh)).with_extension("nfd");
                    let asset = Asset { mesh: folder.join(&mesh), field, flags: flags.clone() };
                    by_mesh.insert(mesh, asset);
                }
            }
        }
        let assets: Vec<Asset> = by_mesh.into_values().collect();

        // No field twice.
        let mut by_field = BTreeMap::new();
        for asset in &assets {
            if let Some(earlier) = by_field.insert(&asset.field, &asset.mesh) {
                let meshes = [earlier.clone(), asset.mesh.clone()];
                return Err(Problem::Clash { meshes, field: asset.field.clone() });
            }
        }

        Ok(Self { assets, cache: text.cache.map(|cache| folder.join(cache)), idle_globs })
    }
}

impl Text {
    /// The settings of everything, then of the presets from the farthest to the nearest, then the entry's own.
    fn settings_of(&self, entry: &Entry) -> Result<Table, Problem> {
        let mut layers = vec![&entry.settings];
        let mut next = entry.preset.as_ref();
        while let Some(name) = next {
            let preset = self.presets.get(name).ok_or_else(|| Problem::NoPreset(name.clone()))?;
            if layers.len() > self.presets.len() {
                return Err(Problem::Cycle(name.clone()));
            }
            layers.push(&preset.settings);
            next = preset.inherits.as_ref();
        }
        layers.push(&self.settings);

        let mut settings = Table::new();
        for layer in layers.into_iter().rev() {
            for (key, value) in layer {
                if ALTERNATIVES.contains(&key.as_str()) {
                    settings.retain(|inherited, _| !ALTERNATIVES.contains(&inherited));
                }
                settings.insert(key.clone(), value.clone());
            }
        }
        Ok(settings)
    }
}

/// `max-depth = 7` is `--max-depth=7`, `key = true` is `--key`, and `key = false` is nothing.
fn flags(settings: &Table) -> Result<Vec<String>, Problem> {
    let mut settings: Vec<(&String, &Value)> = settings.iter().collect();
    settings.sort_unstable_by_key(|(key, _)| *key);

    let mut flags = Vec::new();
    for (key, value) in settings {
        if RESERVED.contains(&key.as_str()) {
            return Err(Problem::Reserved(key.clone()));
        }
        match value {
            Value::String(text) => flags.push(format!("--{key}={text}")),
            Value::Integer(number) => flags.push(format!("--{key}={number}")),
            Value::Float(number) => flags.push(format!("--{key}={number}")),
            Value::Boolean(true) => flags.push(format!("--{key}")),
            Value::Boolean(false) => {}
            _ => return Err(Problem::Shape(key.clone())),
        }
    }
    Ok(flags)
}

/// The files that a pattern matches, relative to the folder as the pattern is.
fn find(folder: &Path, pattern: &str) -> Result<Vec<PathBuf>, Problem> {
    // Only the part before the first wildcard can be walked into.
    let is_plain = |part: &&str| !part.contains(['*', '?', '[', '{']);
    let parts: Vec<&str> = pattern.split('/').collect();
    let plain = parts.iter().take_while(|part| is_plain(part)).count();
    if plain == parts.len() {
        return Ok(vec![PathBuf::from(pattern)]);
    }
    let base = PathBuf::from(parts[..plain].join("/"));
    let start = Path::new(".").join(folder).join(&base);
    if !start.exists() {
        return Ok(Vec::new());
    }

    let glob = GlobBuilder::new(pattern).literal_separator(true).build()?.compile_matcher();
    let mut found = Vec::new();
    for entry in WalkDir::new(&start).follow_links(true).sort_by_file_name() {
        let entry = entry?;
        let inside = entry.path().strip_prefix(&start).unwrap_or(entry.path());
        let path = base.join(inside);
        if entry.file_type().is_file() && glob.is_match(&path) {
            found.push(path);
        }
    }
    Ok(found)
}

fn globs(patterns: &[String]) -> Result<GlobSet, Problem> {
    let mut set = GlobSetBuilder::new();
    for pattern in patterns {
        set.add(GlobBuilder::new(pattern).literal_separator(true).build()?);
    }
    Ok(set.build()?)
}

/// The path without what leads out of the manifest's folder.
fn below_the_manifest(mesh: &Path) -> PathBuf {
    mesh.components().filter(|part| matches!(part, Component::Normal(_))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder_with(files: &[&str]) -> tempfile::TempDir {
        let folder = tempfile::tempdir().expect("a folder");
        for file in files {
            let path = folder.path().join(file);
            fs::create_dir_all(path.parent().expect("a parent")).expect("its folder");
            fs::write(path, "").expect("the file");
        }
        folder
    }

    fn parse(folder: &tempfile::TempDir, text: &str) -> Result<Manifest, Problem> {
        Manifest::parse(text, folder.path())
    }

    #[test]
    fn globs_find_meshes_and_the_last_entry_wins() {
        let folder = folder_with(&["props/a.obj", "props/deep/b.obj", "props/wip/c.obj", "props/notes.txt"]);
        let manifest = parse(
            &folder,
            r#"
            output = "fields"
            settings = { error = 1e-3, max-depth = 7 }
            presets.fine = { inherits = "finer", precision = "f16" }
            presets.finer = { error = 1e-4 }
            [[assets]]
            include = ["props/**/*.obj", "more/*.ply"]
            exclude = ["props/wip/**"]
            [[assets]]
            include = ["props/deep/b.obj"]
            preset = "fine"
            error-abs = 0.01
            "#,
        )
        .expect("a manifest");

        let flags: Vec<String> = manifest.assets.iter().map(|asset| asset.flags.join(" ")).collect();
        assert_eq!(flags, ["--error=0.001 --max-depth=7", "--error-abs=0.01 --max-depth=7 --precision=f16"]);
        assert_eq!(manifest.assets[1].field, folder.path().join("fields/props/deep/b.nfd"));
        assert_eq!(manifest.idle_globs, ["more/*.ply"]);
    }

    #[test]
    fn a_path_without_a_wildcard_is_an_asset_even_if_it_is_missing() {
        let folder = folder_with(&[]);
        let manifest = parse(&folder, "assets = [{ include = ['../gone.obj'] }]").expect("a manifest");
        assert_eq!(manifest.assets[0].field, folder.path().join("gone.nfd"));
    }

    #[test]
    fn contradictions_are_refused() {
        let folder = folder_with(&["a.obj", "a.ply"]);
        let wrong = |text: &str| parse(&folder, text).expect_err(text).to_string();

        assert!(wrong("assets = [{ include = ['*.obj', '*.ply'] }]").contains("both become"));
        assert!(wrong("assets = [{ include = ['*.obj'], preset = 'x' }]").contains("no preset"));
        assert!(wrong("assets = [{ include = ['*.obj'], report = 'x' }]").contains("report"));
        assert!(wrong("assets = [{ include = ['*.obj'], error = [1] }]").contains("number"));
        assert!(wrong("asset = []").contains("asset"));
        let cycle = "presets.a.inherits = 'a'\nassets = [{ include = ['*.obj'], preset = 'a' }]";
        assert!(wrong(cycle).contains("inherits from itself"));
    }
}
