//! A device of Vulkan to run shaders on, be it of software.

use std::iter;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{
    Backends, Buffer, BufferDescriptor, BufferUsages, CommandEncoder, Device, DeviceDescriptor, Instance,
    InstanceDescriptor, MapMode, PollType, Queue, RequestAdapterOptions,
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
            ..InstanceDescriptor::new_without_display_handle()
        });
        let adapter = instance.request_adapter(&RequestAdapterOptions::default()).await.ok()?;
        let (device, queue) = adapter.request_device(&DeviceDescriptor::default()).await.expect("a device");
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
