//! Draws a field on a device of Vulkan, without a window: sphere tracing, occlusion and a soft shadow.
//!
//!     cargo run --release --example render -- spot.nfd spot.png 320x240

mod gpu;

use gpu::Gpu;
use nearfield::{Aabb, Field};
use nearfield_shaders::{Bytes, Families, render};
use std::error::Error;
use std::io::BufWriter;
use wgpu::{
    BindGroupDescriptor, BindGroupEntry, BufferDescriptor, BufferUsages, Color, ColorTargetState, CommandEncoder,
    Extent3d, FragmentState, LoadOp, Operations, RenderPassColorAttachment, RenderPassDescriptor,
    RenderPipelineDescriptor, ShaderModuleDescriptor, ShaderSource, StoreOp, TexelCopyBufferInfo,
    TexelCopyBufferLayout, TextureDescriptor, TextureDimension, TextureFormat, TextureUsages, VertexState,
};

/// What `nearfield render` takes unless it is told otherwise.
const AZIMUTH: f64 = 35.0;
const ELEVATION: f64 = 20.0;
const ZOOM: f64 = 1.5;
const FIELD_OF_VIEW: f64 = 30.0;
const ANTIALIAS: u32 = 2;
/// Bits of `render.wgsl`.
const SHOW_OCCLUSION_AND_SHADOW: u32 = 3;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [field, picture, size] = arguments.as_slice() else {
        return Err("usage: render FIELD.nfd PICTURE.png WIDTHxHEIGHT".into());
    };
    let (width, height) = size.split_once('x').ok_or("a size such as 320x240")?;
    let size: [u32; 2] = [width.parse()?, height.parse()?];

    // A shader cannot check a file.
    let bytes = std::fs::read(field)?;
    let field = Field::open(&bytes).map_err(|error| error.to_string())?;
    field.validate().map_err(|error| error.to_string())?;

    let Some(gpu) = Gpu::open() else { return Err("no driver of Vulkan".into()) };
    let pixels = draw(&gpu, &bytes, &view(field.header().bounds, size), size);
    let mut encoder = png::Encoder::new(BufWriter::new(std::fs::File::create(picture)?), size[0], size[1]);
    encoder.set_color(png::ColorType::Rgba);
    encoder.write_header()?.write_image_data(&pixels)?;
    println!("{}: {picture}", gpu.name);
    Ok(())
}

/// The uniform `View` of `render.wgsl`: a camera around a box, y up.
fn view(bounds: Aabb, size: [u32; 2]) -> Vec<f32> {
    let [low, high] = [bounds.min, bounds.max].map(|corner| corner.map(f64::from));
    let diagonal = [0, 1, 2].map(|axis: usize| (high[axis] - low[axis]).powi(2)).iter().sum::<f64>().sqrt();
    let (sine, cosine) = AZIMUTH.to_radians().sin_cos();
    let (rise, run) = ELEVATION.to_radians().sin_cos();
    let from = [sine * run, rise, cosine * run];
    let right = [cosine, 0.0, -sine];
    let up = [
        from[1] * right[2] - from[2] * right[1],
        from[2] * right[0] - from[0] * right[2],
        from[0] * right[1] - from[1] * right[0],
    ];
    let half_angle = (0.5 * FIELD_OF_VIEW).to_radians();
    let away = 0.5 * diagonal / half_angle.sin();
    let eye = [0, 1, 2].map(|axis: usize| 0.5 * (low[axis] + high[axis]) + away * from[axis]);
    let pixel = 2.0 * half_angle.tan() / ZOOM / f64::from(size[0].min(size[1]));
    let [half_width, half_height] = size.map(|side| 0.5 * pixel * f64::from(side));

    let mut view: Vec<f32> = Vec::new();
    let back = from.map(|part| -part);
    for (vector, number) in [
        (eye, pixel),
        (back, diagonal),
        (right, half_width),
        (up, half_height),
        ([0.0; 3], 0.0),
        ([0.0, 1.0, 1.0], 0.0),
    ] {
        view.extend(vector.into_iter().chain([number]).map(|part| part as f32));
    }
    // The last number above is in the place of the rays a pixel; what follows is padding.
    view.pop();
    view.extend([f32::from_bits(ANTIALIAS), f32::from_bits(SHOW_OCCLUSION_AND_SHADOW), 0.0, 0.0, 0.0]);
    view
}

/// Four bytes a pixel.
fn draw(gpu: &Gpu, field: &[u8], view: &[f32], [width, height]: [u32; 2]) -> Vec<u8> {
    let source = ShaderSource::Wgsl(render(Bytes::Buffer, Families::All).into());
    let module = gpu.device.create_shader_module(ShaderModuleDescriptor { label: None, source });
    let format = TextureFormat::Rgba8Unorm;
    let pipeline = gpu.device.create_render_pipeline(&RenderPipelineDescriptor {
        label: None,
        layout: None,
        vertex: VertexState {
            module: &module,
            entry_point: Some("corner"),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: Default::default(),
        depth_stencil: None,
        multisample: Default::default(),
        fragment: Some(FragmentState {
            module: &module,
            entry_point: Some("pixel"),
            compilation_options: Default::default(),
            targets: &[Some(ColorTargetState::from(format))],
        }),
        multiview_mask: None,
        cache: None,
    });
    let words = gpu.buffer(field, BufferUsages::STORAGE);
    let uniform = gpu.buffer(bytemuck::cast_slice(view), BufferUsages::UNIFORM);
    let group = gpu.device.create_bind_group(&BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(0),
        entries: &[
            BindGroupEntry { binding: 0, resource: words.as_entire_binding() },
            BindGroupEntry { binding: 1, resource: uniform.as_entire_binding() },
        ],
    });

    let size = Extent3d { width, height, depth_or_array_layers: 1 };
    let target = gpu.device.create_texture(&TextureDescriptor {
        label: None,
        size,
        mip_level_count: 1,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format,
        usage: TextureUsages::RENDER_ATTACHMENT | TextureUsages::COPY_SRC,
        view_formats: &[],
    });
    let mut commands: CommandEncoder = gpu.device.create_command_encoder(&Default::default());
    let mut pass = commands.begin_render_pass(&RenderPassDescriptor {
        color_attachments: &[Some(RenderPassColorAttachment {
            view: &target.create_view(&Default::default()),
            depth_slice: None,
            resolve_target: None,
            ops: Operations { load: LoadOp::Clear(Color::WHITE), store: StoreOp::Store },
        })],
        ..Default::default()
    });
    pass.set_pipeline(&pipeline);
    pass.set_bind_group(0, &group, &[]);
    pass.draw(0..3, 0..1);
    drop(pass);

    // Rows of a copy are padded.
    let row = (4 * width).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = gpu.device.create_buffer(&BufferDescriptor {
        label: None,
        size: u64::from(row) * u64::from(height),
        usage: BufferUsages::COPY_DST | BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    });
    let layout = TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None };
    commands.copy_texture_to_buffer(target.as_image_copy(), TexelCopyBufferInfo { buffer: &buffer, layout }, size);
    let rows = gpu.read(commands, &buffer);
    rows.chunks(row as usize).flat_map(|padded| &padded[..4 * width as usize]).copied().collect()
}
