//! Lists of points, answered by a device.

use crate::gpu::Gpu;
use nearfield_shaders::query;
use wgpu::{
    BindGroupDescriptor, BindGroupEntry, Buffer, BufferUsages, ComputePipeline, ComputePipelineDescriptor,
    ShaderModuleDescriptor, ShaderSource,
};

/// Answers lists of points by the compute shader.
pub(crate) struct Querier<'a> {
    gpu: &'a Gpu,
    pipeline: ComputePipeline,
}

impl<'a> Querier<'a> {
    pub(crate) fn new(gpu: &'a Gpu) -> Self {
        let source = ShaderSource::Wgsl(query().into());
        let module = gpu.device.create_shader_module(ShaderModuleDescriptor { label: None, source });
        let pipeline = gpu.device.create_compute_pipeline(&ComputePipelineDescriptor {
            label: None,
            layout: None,
            module: &module,
            entry_point: Some("query"),
            compilation_options: Default::default(),
            cache: None,
        });
        Self { gpu, pipeline }
    }

    /// Whether this is the driver of software that the tests know.
    pub(crate) fn is_software(&self) -> bool {
        self.gpu.name.starts_with("llvmpipe")
    }

    /// Distance and gradient at each point, by the bytes of a field.
    pub(crate) fn answers(&self, field: &[u8], points: &[[f32; 3]]) -> Vec<[f32; 4]> {
        let answers = vec![[0.0_f32; 4]; points.len()];
        let buffers = [
            self.gpu.buffer(field, BufferUsages::STORAGE),
            self.gpu.buffer(bytemuck::cast_slice(points), BufferUsages::STORAGE),
            self.gpu.buffer(bytemuck::cast_slice(&answers), BufferUsages::STORAGE | BufferUsages::COPY_SRC),
        ];
        let entries: Vec<_> = (0..).zip(&buffers).map(|(binding, buffer)| entry(binding, buffer)).collect();
        let group = self.gpu.device.create_bind_group(&BindGroupDescriptor {
            label: None,
            layout: &self.pipeline.get_bind_group_layout(0),
            entries: &entries,
        });

        let mut commands = self.gpu.device.create_command_encoder(&Default::default());
        let mut pass = commands.begin_compute_pass(&Default::default());
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.dispatch_workgroups((points.len() as u32).div_ceil(64), 1, 1);
        drop(pass);
        bytemuck::pod_collect_to_vec(&self.gpu.read(commands, &buffers[2]))
    }
}

fn entry(binding: u32, buffer: &Buffer) -> BindGroupEntry<'_> {
    BindGroupEntry { binding, resource: buffer.as_entire_binding() }
}
