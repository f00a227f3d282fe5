//! From WGSL to other languages, by naga.

use naga::back::{glsl, hlsl, msl, spv};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{Module, ResourceBinding, ShaderStage};
use std::error::Error;

/// GLSL of desktops, with storage buffers.
pub(crate) const GLSL_430: glsl::Version = glsl::Version::Desktop(430);
/// GLSL of WebGL2.
pub(crate) const GLSL_ES_300: glsl::Version = glsl::Version::Embedded { version: 300, is_webgl: true };

/// A shader that is known to be valid.
pub(crate) struct Shader {
    module: Module,
    info: ModuleInfo,
}

impl Shader {
    pub(crate) fn new(wgsl: &str) -> Result<Self, Box<dyn Error>> {
        let module = naga::front::wgsl::parse_str(wgsl).map_err(|error| error.emit_to_string(wgsl))?;
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
        let info = validator.validate(&module).map_err(|error| error.emit_to_string(wgsl))?;
        Ok(Self { module, info })
    }

    /// Every entry point, for shader model 5.1: resource n of group 0 is register n of space 0.
    pub(crate) fn hlsl(&self) -> Result<Vec<u8>, Box<dyn Error>> {
        // The reader's loops are bounded by the depth of trees.
        let options = hlsl::Options { force_loop_bounding: false, ..Default::default() };
        let mut text = String::new();
        let pipeline = hlsl::PipelineOptions::default();
        hlsl::Writer::new(&mut text, &options, &pipeline).write(&self.module, &self.info, None)?;
        Ok(text.into())
    }

    /// Every entry point, for Metal 2.0: resource n of group 0 is buffer n, and a buffer after them has their sizes.
    pub(crate) fn metal(&self) -> Result<Vec<u8>, Box<dyn Error>> {
        let bindings = self.module.global_variables.iter().filter_map(|(_, variable)| variable.binding);
        let target = |binding: ResourceBinding| {
            let slot = u8::try_from(binding.binding)?;
            let target = msl::BindTarget { buffer: Some(slot), mutable: true, ..Default::default() };
            Ok::<_, Box<dyn Error>>((binding, target))
        };
        let resources: msl::BindingMap = bindings.map(target).collect::<Result<_, _>>()?;
        let sizes_buffer = Some(u8::try_from(resources.len())?);
        let slots = msl::EntryPointResources { resources, sizes_buffer, ..Default::default() };
        let points = self.module.entry_points.iter();
        let options = msl::Options {
            lang_version: (2, 0),
            per_entry_point_map: points.map(|point| (point.name.clone(), slots.clone())).collect(),
            fake_missing_bindings: false,
            force_loop_bounding: false,
            ..Default::default()
        };
        let (text, _) = msl::write_string(&self.module, &self.info, &options, &msl::PipelineOptions::default())?;
        Ok(text.into())
    }

    /// Every entry point, SPIR-V 1.3, as little-endian words.
    pub(crate) fn spirv(&self) -> Result<Vec<u8>, Box<dyn Error>> {
        let options = spv::Options {
            lang_version: (1, 3),
            // The default depends on the profile of the build.
            flags: spv::WriterFlags::ADJUST_COORDINATE_SPACE | spv::WriterFlags::LABEL_VARYINGS,
            force_loop_bounding: false,
            ..Default::default()
        };
        let words = spv::write_vec(&self.module, &self.info, &options, None)?;
        Ok(words.into_iter().flat_map(u32::to_le_bytes).collect())
    }

    /// One entry point.
    pub(crate) fn glsl(&self, entry_point: &str, version: glsl::Version) -> Result<Vec<u8>, Box<dyn Error>> {
        let point = self.module.entry_points.iter().find(|point| point.name == entry_point);
        let shader_stage = point.map_or(ShaderStage::Compute, |point| point.stage);
        let bindings = self.module.global_variables.iter().filter_map(|(_, variable)| variable.binding);
        let slot = |binding: ResourceBinding| Ok::<_, Box<dyn Error>>((binding, u8::try_from(binding.binding)?));
        let options = glsl::Options {
            version,
            writer_flags: glsl::WriterFlags::empty(),
            binding_map: bindings.map(slot).collect::<Result<_, _>>()?,
            ..Default::default()
        };
        let pipeline = glsl::PipelineOptions { shader_stage, entry_point: entry_point.to_owned(), multiview: None };
        let mut text = String::new();
        let policies = naga::proc::BoundsCheckPolicies::default();
        glsl::Writer::new(&mut text, &self.module, &self.info, &options, &pipeline, policies)?.write()?;
        Ok(text.into())
    }
}
