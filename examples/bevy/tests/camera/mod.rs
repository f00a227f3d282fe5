//! Pictures of Bevy's renderer without a window.

use bevy::app::PluginsState;
use bevy::asset::RenderAssetUsages;
use bevy::camera::{RenderTarget, ScalingMode};
use bevy::core_pipeline::tonemapping::Tonemapping;
use bevy::prelude::*;
use bevy::render::RenderPlugin;
use bevy::render::gpu_readback::{Readback, ReadbackComplete};
use bevy::render::render_resource::{TextureFormat, TextureUsages};
use bevy::window::ExitCondition;
use nearfield_bevy::material::FieldMaterialPlugin;
use std::time::{Duration, Instant};

/// A row is a multiple of 256 bytes, so that none is padded.
pub(crate) const WIDTH: u32 = 320;
pub(crate) const HEIGHT: u32 = 240;

/// Red, green and blue of the pixels, row after row.
pub(crate) type Picture = Vec<[u8; 3]>;

/// The longest that a loaded machine may take to compile the shaders and to draw.
const PATIENCE: Duration = Duration::from_secs(300);

/// So often the same picture follows itself when all is there.
const SETTLED: u32 = 2;

/// How the eye sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum View {
    Perspective,
    Orthographic,
}

#[derive(Default, Resource)]
struct Drawn(Option<Picture>);

/// Draws what `fill` puts into a world, by one lamp.
pub(crate) fn draw(view: View, fill: impl FnOnce(&mut World)) -> Picture {
    let mut app = App::new();
    let window = WindowPlugin { primary_window: None, exit_condition: ExitCondition::DontExit, ..default() };
    let render = RenderPlugin { synchronous_pipeline_compilation: true, ..default() };
    app.add_plugins(DefaultPlugins.set(window).set(render)).add_plugins(FieldMaterialPlugin);
    app.init_resource::<Drawn>();
    let start = Instant::now();
    while app.plugins_state() == PluginsState::Adding {
        assert!(start.elapsed() < PATIENCE, "the renderer starts");
        bevy::tasks::tick_global_task_pools_on_main_thread();
    }
    app.finish();
    app.cleanup();

    let world = app.world_mut();
    let picture = add_camera(world, view);
    let lamp = DirectionalLight { illuminance: 5_000.0, ..default() };
    world.spawn((lamp, Transform::from_xyz(1.0, 3.0, 2.0).looking_at(Vec3::ZERO, Vec3::Y)));
    fill(world);

    app.world_mut().spawn(Readback::texture(picture)).observe(
        |read: On<ReadbackComplete>, mut drawn: ResMut<Drawn>| {
            drawn.0 = Some(read.data.as_chunks().0.iter().map(|&[red, green, blue, _]| [red, green, blue]).collect());
        },
    );
    // The first pictures lack what is not yet uploaded.
    let mut last = Picture::new();
    let mut same = 0;
    while same < SETTLED {
        app.update();
        assert!(start.elapsed() < PATIENCE, "a picture is drawn");
        let Some(picture) = app.world_mut().resource_mut::<Drawn>().0.take() else { continue };
        assert_eq!(picture.len(), (WIDTH * HEIGHT) as usize, "rows without padding");
        same = if picture == last && picture.iter().any(|pixel| *pixel != picture[0]) { same + 1 } else { 0 };
        last = picture;
    }
    last
}

fn add_camera(world: &mut World, view: View) -> Handle<Image> {
    let mut image = Image::new_target_texture(WIDTH, HEIGHT, TextureFormat::Rgba8UnormSrgb, None);
    image.texture_descriptor.usage |= TextureUsages::COPY_SRC;
    image.asset_usage = RenderAssetUsages::RENDER_WORLD;
    let picture = world.resource_mut::<Assets<Image>>().add(image);

    let projection = match view {
        View::Perspective => Projection::from(PerspectiveProjection::default()),
        View::Orthographic => {
            let scaling_mode = ScalingMode::FixedVertical { viewport_height: 4.0 };
            Projection::from(OrthographicProjection { scaling_mode, ..OrthographicProjection::default_3d() })
        }
    };
    world.spawn((
        Camera3d::default(),
        projection,
        RenderTarget::Image(picture.clone().into()),
        Tonemapping::None,
        Msaa::Off,
        Transform::from_xyz(0.5, 2.2, 4.6).looking_at(Vec3::ZERO, Vec3::Y),
    ));
    picture
}
