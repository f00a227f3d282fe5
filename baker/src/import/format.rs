//! Which format a file is in.

use super::{gltf, obj, off, ply, stl};
use std::path::Path;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    Obj,
    Ply,
    Stl,
    Off,
    Gltf,
}

impl Format {
    /// The content decides; the extension only where the content says nothing.
    pub(super) fn detect(path: &Path, bytes: &[u8]) -> Option<Self> {
        Self::of_content(bytes).or_else(|| Self::of_extension(path)).or_else(|| {
            // The weakest sign comes last: many texts start with a word that OBJ knows.
            obj::looks_like_obj(bytes).then_some(Self::Obj)
        })
    }

    fn of_content(bytes: &[u8]) -> Option<Self> {
        let signs = [
            (Self::Ply, ply::is_ply(bytes)),
            (Self::Gltf, gltf::is_gltf(bytes)),
            (Self::Stl, stl::is_stl(bytes)),
            (Self::Off, off::is_off(bytes)),
        ];
        signs.into_iter().find_map(|(format, is_it)| is_it.then_some(format))
    }

    fn of_extension(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_ascii_lowercase();
        match extension.to_str()? {
            "obj" => Some(Self::Obj),
            "ply" => Some(Self::Ply),
            "stl" => Some(Self::Stl),
            "off" => Some(Self::Off),
            "gltf" | "glb" => Some(Self::Gltf),
            _ => None,
        }
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Obj => "OBJ",
            Self::Ply => "PLY",
            Self::Stl => "STL",
            Self::Off => "OFF",
            Self::Gltf => "glTF",
        }
    }
}
