//! Which parts of a mesh file are wanted, and how they should lie.

use super::Problem;
use glam::DVec3;
use globset::{Glob, GlobSet, GlobSetBuilder};
use std::collections::BTreeSet;

/// What is wanted of a mesh file.
#[derive(Clone, Debug, Default)]
pub struct ReadOptions {
    /// Which triangles.
    pub selection: Selection,
    /// How they lie in the field.
    pub placement: Placement,
}

impl ReadOptions {
    /// Joins these options to the hash of the settings that they go with: equal options, equal hash.
    /// The defaults leave the hash as it is.
    pub fn hash_onto(&self, settings: [u8; 8]) -> [u8; 8] {
        let Self { selection: Selection { nodes, materials }, placement } = self;
        if self.selection.is_everything() && *placement == Placement::default() {
            return settings;
        }
        let names = [&nodes.with, &nodes.without, &materials.with, &materials.without];
        let digest = blake3::hash(format!("{settings:?} {names:?} {placement:?}").as_bytes());
        let (head, _) = digest.as_bytes().split_first_chunk().expect("a digest has 32 bytes");
        *head
    }
}

/// Which triangles of a file are wanted, by the names that the file gives them.
///
/// A node is an object or a group of an OBJ, a node of a glTF with everything below it, or the mesh
/// that the node shows. A name is wanted when a pattern of the wanted ones fits it, or there is none,
/// and no pattern of the unwanted ones does.
#[derive(Clone, Debug, Default)]
pub struct Selection {
    /// Names of nodes.
    pub nodes: Names,
    /// Names of materials.
    pub materials: Names,
}

impl Selection {
    /// Whether every triangle is wanted.
    pub fn is_everything(&self) -> bool {
        self.nodes.is_everything() && self.materials.is_everything()
    }

    /// Whether triangles of these nodes, one within the other, and of this material are wanted.
    pub(super) fn takes<'a>(&self, nodes: impl Iterator<Item = &'a str> + Clone, material: Option<&'a str>) -> bool {
        self.nodes.take(nodes) && self.materials.take(material.into_iter())
    }
}

/// Patterns of names, as shells write them: `wheel*`, `door_?`, `{left,right}`.
#[derive(Clone, Debug, Default)]
pub struct Names {
    with: Vec<String>,
    without: Vec<String>,
    wanted: GlobSet,
    unwanted: GlobSet,
}

impl Names {
    /// Takes names that one of the patterns `with` fits, or any if there is none, but no name that a
    /// pattern `without` fits.
    ///
    /// # Errors
    /// A pattern is none, in one sentence.
    pub fn new(with: &[String], without: &[String]) -> Result<Self, String> {
        let set = |patterns: &[String]| {
            let mut set = GlobSetBuilder::new();
            for pattern in patterns {
                set.add(Glob::new(pattern).map_err(|error| format!("{pattern:?} is no pattern of names: {error}"))?);
            }
            set.build().map_err(|error| error.to_string())
        };
        Ok(Self { wanted: set(with)?, unwanted: set(without)?, with: with.to_vec(), without: without.to_vec() })
    }

    fn is_everything(&self) -> bool {
        self.with.is_empty() && self.without.is_empty()
    }

    fn take<'a>(&self, mut names: impl Iterator<Item = &'a str> + Clone) -> bool {
        let wanted = self.with.is_empty() || names.clone().any(|name| self.wanted.is_match(name));
        wanted && !names.any(|name| self.unwanted.is_match(name))
    }
}

/// Names met in a file, for the message that none of them was wanted.
#[derive(Default)]
pub(super) struct NamesMet {
    pub(super) nodes: BTreeSet<String>,
    pub(super) materials: BTreeSet<String>,
}

impl NamesMet {
    pub(super) fn nothing_selected(&self) -> Problem {
        let list = |kind: &str, names: &BTreeSet<String>| {
            // A message is one sentence, not a catalogue.
            const SHOWN: usize = 12;
            let shown: Vec<&str> = names.iter().take(SHOWN).map(String::as_str).collect();
            match names.len() {
                0 => format!("no {kind}s"),
                count if count > SHOWN => format!("the {kind}s {} and {} more", shown.join(", "), count - SHOWN),
                _ => format!("the {kind}s {}", shown.join(", ")),
            }
        };
        let known = format!("{} and {}", list("node", &self.nodes), list("material", &self.materials));
        Problem::NothingSelected { known: known.replace(char::is_control, " ") }
    }
}

/// How a mesh lies in the field: first turned, then scaled about the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Field units a mesh unit, finite and above zero.
    pub scale: f64,
    /// The axis that is up in the field; the axes stay as they are if absent.
    pub up: Option<Up>,
}

/// The axis that is up. Only glTF says so (y); of a mesh in another format it is taken to be the other
/// one than asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Up {
    /// The second axis: z of the mesh becomes y of the field, and y becomes −z.
    Y,
    /// The third axis: y of the mesh becomes z of the field, and z becomes −y.
    Z,
}

impl Default for Placement {
    fn default() -> Self {
        Self { scale: 1.0, up: None }
    }
}

impl Placement {
    /// Moves finite positions; `is_y_up` says that the format has y up.
    pub(super) fn apply(&self, positions: &mut [DVec3], is_y_up: bool) -> Result<(), Problem> {
        match self.up {
            Some(Up::Z) => positions.iter_mut().for_each(|p| *p = DVec3::new(p.x, -p.z, p.y)),
            Some(Up::Y) if !is_y_up => positions.iter_mut().for_each(|p| *p = DVec3::new(p.x, p.z, -p.y)),
            Some(Up::Y) | None => {}
        }
        if self.scale != 1.0 {
            positions.iter_mut().for_each(|position| *position *= self.scale);
        }
        match positions.iter().find(|position| !position.is_finite()) {
            Some(&position) => Err(Problem::NotFinite { place: "a scaled vertex".into(), position }),
            None => Ok(()),
        }
    }
}
