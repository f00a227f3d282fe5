//! A device of Vulkan to run shaders on, be it of software.

use nearfield_shaders::query;
use std::iter;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{
    BackendOptions, Backends, BindGroupDescriptor, BindGroupEntry, Buffer, BufferDescriptor, BufferUsages,
    CommandEncoder, ComputePipeline, ComputePipelineDescriptor, Device, DeviceDescriptor, Instance, InstanceDescriptor,
    Limits, MapMode, PollType, Queue, RequestAdapterOptions, ShaderModuleDescriptor, ShaderSource,
};

/// A device, and what it is called.
pub(crate) struct Gpu {
    pub(crate) name: String,
    pub(crate) device: Device,
    pub(crate) queue: Queue,
}

impl Gpu {
    /// The first device of Vulkan. Says aloud that there is none; panics if that may not be.
    pub(crate) fn open() -> Option<Self> {
        let gpu = pollster::block_on(Self::request());
        if gpu.is_none() {
            let ci = std::env::var("CI").is_ok_and(|value| value == "true");
            assert!(!ci, "no driver of Vulkan: install mesa-vulkan-drivers and libvulkan1");
            eprintln!("SKIPPED: no driver of Vulkan (mesa-vulkan-drivers and libvulkan1 have one of software)");
        }
        gpu
    }

    async fn request() -> Option<Self> {
        let instance = Instance::new(InstanceDescriptor {
            backends: Backends::VULKAN,
            backend_options: BackendOptions::default(),
            ..InstanceDescriptor::new_without_display_handle()
        });
        let adapter = instance.request_adapter(&RequestAdapterOptions::default()).await.ok()?;
        let descriptor = DeviceDescriptor { required_limits: Limits::default(), ..DeviceDescriptor::default() };
        let (device, queue) = adapter.request_device(&descriptor).await.expect("a device of the adapter");
        Some(Self { name: adapter.get_info().name, device, queue })
    }

    /// A buffer that holds these bytes.
    pub(crate) fn buffer(&self, contents: &[u8], usage: BufferUsages) -> Buffer {
        self.device.create_buffer_init(&BufferInitDescriptor { label: None, contents, usage })
    }

    /// Submits commands and returns what is in `buffer` after them.
    pub(crate) fn read(&self, mut commands: CommandEncoder, buffer: &Buffer) -> Vec<u8> {
        let size = buffer.size();
        let usage = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
        let copy = self.device.create_buffer(&BufferDescriptor { label: None, size, usage, mapped_at_creation: false });
        commands.copy_buffer_to_buffer(buffer, 0, &copy, 0, size);
        self.queue.submit(iter::once(commands.finish()));
        copy.map_async(MapMode::Read, .., |outcome| outcome.expect("a buffer to read from"));
        self.device.poll(PollType::wait_indefinitely()).expect("a device that ends its work");
        copy.get_mapped_range(..).expect("a buffer that is mapped").to_vec()
    }
}

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
