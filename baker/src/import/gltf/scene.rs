//! The triangles that a scene shows.

use super::super::options::NamesMet;
use super::super::{MAX_TRIANGLES, push_fan, push_strip};
use super::buffers::Buffers;
use super::document::{Document, Mesh, Primitive, unsupported_extension};
use super::{Problem, Selection, TriangleSoup, accessor, malformed};
use glam::DAffine3;

/// A node to visit.
struct Visit {
    node: usize,
    /// From the parent's frame to the scene's.
    parent: DAffine3,
    /// Place of the parent in the list of ancestors.
    ancestor: Option<usize>,
}

/// Names of a node, with the place of its parent.
struct Ancestor<'a> {
    names: [Option<&'a str>; 2],
    parent: Option<usize>,
}

pub(super) fn triangles(
    document: &Document,
    buffers: &Buffers<'_>,
    selection: &Selection,
) -> Result<TriangleSoup, Problem> {
    let mut soup = TriangleSoup::default();
    let mut met = NamesMet::default();
    let mut ancestors: Vec<Ancestor<'_>> = Vec::new();
    let mut seen = vec![false; document.nodes.len()];
    let mut visits: Vec<Visit> = roots(document)?
        .into_iter()
        .rev()
        .map(|node| Visit { node, parent: DAffine3::IDENTITY, ancestor: None })
        .collect();

    while let Some(Visit { node: number, parent, ancestor }) = visits.pop() {
        let node = document.nodes.get(number).ok_or_else(|| malformed(format!("node {number} is not there")))?;
        if std::mem::replace(&mut seen[number], true) {
            return Err(malformed(format!("node {number} is in the scene twice")));
        }
        let to_scene = parent * node.transform();
        let mesh = match node.mesh {
            Some(mesh) => {
                let found = document.meshes.get(mesh);
                Some(found.ok_or_else(|| malformed(format!("mesh {mesh} is not there")))?)
            }
            None => None,
        };
        let names = [node.name.as_deref(), mesh.and_then(|mesh| mesh.name.as_deref())];
        ancestors.push(Ancestor { names, parent: ancestor });
        let place = ancestors.len() - 1;
        met.nodes.extend(names.into_iter().flatten().map(str::to_owned));
        if let Some(mesh) = mesh {
            push_mesh(document, buffers, mesh, to_scene, &mut soup, |material| {
                met.materials.extend(material.map(str::to_owned));
                selection.takes(names_from(&ancestors, place), material)
            })?;
        }
        let children = node.children.iter().rev();
        visits.extend(children.map(|&node| Visit { node, parent: to_scene, ancestor: Some(place) }));
    }

    if soup.triangles.is_empty() {
        let nothing =
            if selection.is_everything() { Problem::NoTriangles { hint: "" } } else { met.nothing_selected() };
        return Err(nothing);
    }
    match soup.positions.iter().find(|position| !position.is_finite()) {
        Some(&position) => Err(Problem::NotFinite { place: "a vertex".into(), position }),
        None => Ok(soup),
    }
}

/// The nodes at the top of the default scene; of a document without scenes, all that are no children.
fn roots(document: &Document) -> Result<Vec<usize>, Problem> {
    if !document.scenes.is_empty() {
        let scene = document.scene.unwrap_or(0);
        let found = document.scenes.get(scene).ok_or_else(|| malformed(format!("scene {scene} is not there")))?;
        return Ok(found.nodes.clone());
    }
    let mut is_root = vec![true; document.nodes.len()];
    for &child in document.nodes.iter().flat_map(|node| &node.children) {
        if let Some(is_root) = is_root.get_mut(child) {
            *is_root = false;
        }
    }
    Ok((0..is_root.len()).filter(|&node| is_root[node]).collect())
}

/// Names of a node, of its mesh and of all above it.
fn names_from<'a>(ancestors: &'a [Ancestor<'a>], place: usize) -> impl Iterator<Item = &'a str> + Clone {
    let line = std::iter::successors(Some(place), |&place| ancestors[place].parent);
    line.flat_map(|place| ancestors[place].names).flatten()
}

/// Adds the triangles of a mesh, as one node shows it.
fn push_mesh<'a>(
    document: &'a Document,
    buffers: &Buffers<'_>,
    mesh: &Mesh,
    to_scene: DAffine3,
    soup: &mut TriangleSoup,
    mut takes: impl FnMut(Option<&'a str>) -> bool,
) -> Result<(), Problem> {
    // A mirror turns triangles inside out.
    let is_mirrored = to_scene.matrix3.determinant() < 0.0;
    for primitive in &mesh.primitives {
        let material = primitive.material.and_then(|material| document.materials.get(material)?.name.as_deref());
        if !takes(material) {
            continue;
        }
        let Some((positions, mut triangles)) = primitive_triangles(document, buffers, primitive)? else { continue };
        if is_mirrored {
            triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
        }
        let base = soup.positions.len();
        let total = soup.triangles.len() + triangles.len();
        if total > MAX_TRIANGLES || base + positions.len() > u32::MAX as usize {
            return Err(Problem::TooLarge { triangles: total });
        }
        soup.positions.extend(positions.into_iter().map(|position| to_scene.transform_point3(position)));
        soup.triangles.extend(triangles.into_iter().map(|triangle| triangle.map(|vertex| vertex + base as u32)));
    }
    Ok(())
}

type Triangles = (Vec<glam::DVec3>, Vec<[u32; 3]>);

/// Positions and triangles of a primitive; nothing for points and lines.
fn primitive_triangles(
    document: &Document,
    buffers: &Buffers<'_>,
    primitive: &Primitive,
) -> Result<Option<Triangles>, Problem> {
    let mode = primitive.mode.unwrap_or(4);
    if mode < 4 {
        return Ok(None);
    }
    if let Some(name) = primitive.extensions.keys().find(|name| name.ends_with("_mesh_compression")) {
        return Err(unsupported_extension(name));
    }
    let Some(&accessor) = primitive.attributes.get("POSITION") else { return Ok(None) };
    let positions = accessor::positions(document, buffers, accessor)?;
    let indices = match primitive.indices {
        Some(accessor) => accessor::indices(document, buffers, accessor)?,
        None => (0..positions.len() as u32).collect(),
    };
    let vertices = positions.len();
    if let Some(&index) = indices.iter().find(|&&index| index as usize >= vertices) {
        return Err(Problem::IndexOutOfRange { place: "a primitive".into(), index: index.into(), vertices });
    }

    let mut triangles = Vec::new();
    match mode {
        4 => triangles.extend(indices.as_chunks::<3>().0),
        5 => push_strip(&mut triangles, &indices),
        6 => push_fan(&mut triangles, &indices),
        _ => return Err(malformed(format!("primitive mode {mode} is unknown"))),
    }
    Ok(Some((positions, triangles)))
}
