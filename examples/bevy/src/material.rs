//! Fields on the screen: Bevy's own material on the surface of a field, found in the pixels of its box.
//!
//! ```
//! use bevy::prelude::*;
//! use nearfield_bevy::FieldAsset;
//! use nearfield_bevy::material::{FieldMaterial, FieldSurface, field_box};
//!
//! /// Shows a field that is loaded, where the entity is.
//! fn show(
//!     asset: &FieldAsset,
//!     commands: &mut Commands,
//!     meshes: &mut Assets<Mesh>,
//!     buffers: &mut Assets<bevy::render::storage::ShaderBuffer>,
//!     materials: &mut Assets<FieldMaterial>,
//! ) {
//!     let base = StandardMaterial::from(Color::srgb(0.8, 0.5, 0.3));
//!     let extension = FieldSurface::new(asset, buffers);
//!     let material = materials.add(FieldMaterial { base, extension });
//!     commands.spawn((Mesh3d(meshes.add(field_box(asset))), MeshMaterial3d(material), Transform::default()));
//! }
//! ```

use crate::FieldAsset;
use bevy::asset::{RenderAssetUsages, uuid_handle};
use bevy::mesh::MeshVertexBufferLayoutRef;
use bevy::pbr::{ExtendedMaterial, MaterialExtension, MaterialExtensionKey, MaterialExtensionPipeline};
use bevy::prelude::*;
use bevy::render::render_resource::{AsBindGroup, Face, RenderPipelineDescriptor, SpecializedMeshPipelineError};
use bevy::render::storage::ShaderBuffer;
use bevy::shader::{Shader, ShaderRef};

/// The reader for shaders, as the module `nearfield`.
const READER: Handle<Shader> = uuid_handle!("5b0c1d5e-9a3f-4e0b-8f0a-6e656172f1e1");
const SURFACE: Handle<Shader> = uuid_handle!("5b0c1d5e-9a3f-4e0b-8f0a-73757266ace0");

/// Bevy's standard material on the surface of a field: of its settings, those that need no texture coordinates.
///
/// It may be moved, turned and uniformly scaled. It receives shadows, and casts none.
pub type FieldMaterial = ExtendedMaterial<StandardMaterial, FieldSurface>;

/// Draws [`FieldMaterial`]. Add it after Bevy's `PbrPlugin`.
#[derive(Clone, Copy, Debug, Default)]
pub struct FieldMaterialPlugin;

impl Plugin for FieldMaterialPlugin {
    fn build(&self, app: &mut App) {
        app.add_plugins(MaterialPlugin::<FieldMaterial>::default());
        let mut shaders = app.world_mut().resource_mut::<Assets<Shader>>();
        let added = [
            shaders.insert(&READER, Shader::from_wgsl(reader(), "nearfield.wgsl")),
            shaders.insert(&SURFACE, Shader::from_wgsl(include_str!("surface.wgsl"), "nearfield_surface.wgsl")),
        ];
        added.into_iter().for_each(|result| result.expect("the handles are of this file alone"));
    }
}

/// The reader as a module that other shaders of Bevy import, which looks for the file among the bindings of the material.
fn reader() -> String {
    let reader = include_str!("../../../runtime/shaders/generated/nearfield.wgsl");
    let place = "@group(0) @binding(0)";
    assert!(reader.contains(place), "the reader names its binding");
    let placed = reader.replace(place, "@group(#{MATERIAL_BIND_GROUP}) @binding(100)");
    ["#define_import_path nearfield\n", &placed].concat()
}

/// What makes a material show a field.
#[derive(Asset, AsBindGroup, Clone, Debug, TypePath)]
pub struct FieldSurface {
    /// The bytes of its file.
    #[storage(100, read_only)]
    file: Handle<ShaderBuffer>,
}

impl FieldSurface {
    /// Uploads a field as it is. Its surface is drawn in the pixels of its [box](field_box).
    pub fn new(asset: &FieldAsset, buffers: &mut Assets<ShaderBuffer>) -> Self {
        Self { file: buffers.add(ShaderBuffer::new(asset.bytes(), RenderAssetUsages::RENDER_WORLD)) }
    }
}

impl MaterialExtension for FieldSurface {
    fn fragment_shader() -> ShaderRef {
        SURFACE.into()
    }

    // These passes would draw the box.
    fn enable_prepass() -> bool {
        false
    }

    fn enable_shadows() -> bool {
        false
    }

    fn specialize(
        _pipeline: &MaterialExtensionPipeline,
        descriptor: &mut RenderPipelineDescriptor,
        _layout: &MeshVertexBufferLayoutRef,
        _key: MaterialExtensionKey<Self>,
    ) -> Result<(), SpecializedMeshPipelineError> {
        descriptor.primitive.cull_mode = Some(Face::Front);
        Ok(())
    }
}

/// The box in whose pixels a field is drawn.
pub fn field_box(asset: &FieldAsset) -> Mesh {
    let bounds = asset.field().header().bounds;
    let [min, max] = [bounds.min, bounds.max].map(Vec3::from);
    Mesh::from(Cuboid::from_corners(min, max)).translated_by(0.5 * (min + max))
}
