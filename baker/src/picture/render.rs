//! Views of a surface by sphere tracing (Hart 1996), with the occlusion and the soft shadows that a distance field gives
//! away (Pujol and Chica 2023, section 7.2).

use super::camera::{Camera, Ray, View};
use super::image::{Image, Rgb};
use crate::distance::SignedDistance;
use crate::field_function::FieldFunction;
use crate::geometry::Aabb;
use crate::progress::Progress;
use glam::{DVec3, Vec3};
use nearfield::Field;
use rayon::prelude::*;

/// A view to draw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Render {
    /// Pixels along x and y, each at least 1.
    pub size: [u32; 2],
    /// Where it is seen from.
    pub camera: Camera,
    /// The surface drawn is where the distance is this, mesh units.
    pub offset: f64,
    /// What colours mean.
    pub shading: Shading,
    /// Rays a pixel along each axis, at least 1.
    pub antialias: u32,
}

/// What colours mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// Clay under a lamp.
    Shaded {
        /// Darkens where other parts are near.
        occlusion: bool,
        /// Draws what other parts keep from the light.
        shadow: bool,
    },
    /// Red, green and blue are the gradient's x, y and z.
    Normals,
}

/// What is drawn: a field or a mesh.
pub struct Surface<'a> {
    source: Source<'a>,
    bounds: Aabb,
}

enum Source<'a> {
    Field {
        field: Field<'a>,
        slope: f64,
        /// How far the field may be from the distance, on either side.
        error: f64,
    },
    Mesh(&'a SignedDistance),
}

impl<'a> Surface<'a> {
    /// The surface of a field.
    pub fn of_field(field: Field<'a>) -> Self {
        let header = field.header();
        let [min, max] = [header.bounds.min, header.bounds.max].map(|corner| Vec3::from_array(corner).as_dvec3());
        let source = Source::Field {
            field,
            slope: f64::from(header.lipschitz).max(1.0),
            error: f64::from(field.contract().max_error()),
        };
        Self { source, bounds: Aabb { min, max } }
    }

    /// The surface of a mesh, exactly, within a field's box.
    pub fn of_mesh(distance: &'a SignedDistance, like: &Surface<'_>) -> Self {
        Self { source: Source::Mesh(distance), bounds: like.bounds }
    }

    fn distance(&self, point: DVec3) -> f64 {
        match &self.source {
            Source::Field { field, .. } => f64::from(field.distance(point.as_vec3().to_array())),
            Source::Mesh(distance) => distance.sample(point).distance,
        }
    }

    fn normal(&self, point: DVec3) -> DVec3 {
        match &self.source {
            Source::Field { field, .. } => {
                let (_, gradient) = field.distance_and_gradient(point.as_vec3().to_array());
                Vec3::from_array(gradient).as_dvec3().normalize_or_zero()
            }
            Source::Mesh(distance) => distance.sample(point).gradient,
        }
    }

    /// How far one may go in any direction from where the field says `distance` without crossing zero.
    ///
    /// The slope bound says distance / slope. The error contract says more when far away: within distance − 2 error the
    /// true distance is at least the error, so the field is not below zero.
    fn safe_step(&self, distance: f64) -> f64 {
        match self.source {
            Source::Field { slope, error, .. } => (distance / slope).max(distance - 2.0 * error),
            Source::Mesh(_) => distance,
        }
    }
}

/// Steps after which a ray is taken for lost along a surface.
const MAX_STEPS: u32 = 512;
/// A ray has arrived within this part of a pixel.
const ARRIVED: f64 = 0.25;
const CLAY: DVec3 = DVec3::new(0.62, 0.60, 0.56);
const BACKGROUND: DVec3 = DVec3::ONE;
/// Directions of the lamp, as the camera sees it: right, up, back.
const LAMP: [f64; 3] = [-0.55, 0.8, 0.6];
/// How sharp shadows are: the sine of the lamp's angular radius is about one over this.
const SHADOW_SHARPNESS: f64 = 12.0;

/// Draws a view. `progress` advances by one a row.
pub fn render(surface: &Surface<'_>, request: &Render, progress: &dyn Progress) -> Image {
    let [width, height] = request.size;
    let tracer =
        Tracer { surface, request, view: request.camera.around(&surface.bounds), size: surface.bounds.diagonal() };
    progress.stage("render", Some(u64::from(height)));
    let rows = (0..height).into_par_iter().map(|row| {
        let pixels: Vec<Rgb> = (0..width).map(|column| tracer.pixel(column, row)).collect();
        progress.advance(1);
        pixels
    });
    Image::new(width, rows.collect::<Vec<_>>().concat())
}

struct Tracer<'a> {
    surface: &'a Surface<'a>,
    request: &'a Render,
    view: View,
    /// Diagonal of the box.
    size: f64,
}

impl Tracer<'_> {
    /// The mean colour of the rays through a pixel.
    fn pixel(&self, column: u32, row: u32) -> Rgb {
        let count = self.request.antialias;
        let mut sum = DVec3::ZERO;
        for index in 0..count * count {
            let within = |index: u32| (f64::from(index) + 0.5) / f64::from(count);
            let place = [f64::from(column) + within(index % count), f64::from(row) + within(index / count)];
            sum += self.colour(&self.view.ray(place, self.request.size));
        }
        encode(sum / f64::from(count * count))
    }

    fn colour(&self, ray: &Ray) -> DVec3 {
        let Some(travelled) = self.hit(ray) else { return BACKGROUND };
        let point = ray.at(travelled);
        let normal = self.surface.normal(point);
        // Inside out, or seen from within: both sides are lit alike.
        let normal = if normal.dot(ray.direction) > 0.0 { -normal } else { normal };

        match self.request.shading {
            Shading::Normals => 0.5 * normal + 0.5,
            Shading::Shaded { occlusion, shadow } => {
                let lamp = self.view.direction(LAMP);
                // Off the surface, so that its own roundness does not count.
                let start = point + normal * (1e-3 * self.size);
                let open = if occlusion { self.openness(point, normal) } else { 1.0 };
                let facing = normal.dot(lamp).max(0.0);
                let lit =
                    if facing > 0.0 && shadow { self.light(&Ray { origin: start, direction: lamp }) } else { 1.0 };
                let sky = 0.24 + 0.12 * normal.dot(self.view.direction([0.0, 1.0, 0.0]));
                CLAY * (sky * open + 0.95 * facing * lit * (0.5 + 0.5 * open))
            }
        }
    }

    fn distance(&self, point: DVec3) -> f64 {
        self.surface.distance(point) - self.request.offset
    }

    /// How far along the ray the surface is.
    fn hit(&self, ray: &Ray) -> Option<f64> {
        let (enter, leave) = ray.through(&self.surface.bounds)?;
        let pixel = self.view.pixel(self.request.size);
        let mut travelled = enter;
        for _ in 0..MAX_STEPS {
            let distance = self.distance(ray.at(travelled));
            if distance < ARRIVED * pixel * travelled {
                return Some(travelled);
            }
            travelled += self.surface.safe_step(distance).max(ARRIVED * pixel * travelled);
            if travelled > leave {
                return None;
            }
        }
        Some(travelled)
    }

    /// From 0, hidden, to 1, open: how much nearer than in the open the surface stays along the normal.
    fn openness(&self, point: DVec3, normal: DVec3) -> f64 {
        const PROBES: u32 = 5;
        let mut hidden = 0.0;
        let mut weight = 1.0;
        for probe in 1..=PROBES {
            let height = 0.12 * self.size * f64::from(probe) / f64::from(PROBES);
            let distance = self.distance(point + normal * height);
            hidden += weight * (1.0 - distance / height).clamp(0.0, 1.0);
            weight *= 0.7;
        }
        let all = (1.0 - weight) / (1.0 - 0.7);
        1.0 - hidden / all
    }

    /// From 0, dark, to 1, lit: the narrowest cone around the ray that meets nothing, by the lamp's size.
    fn light(&self, ray: &Ray) -> f64 {
        let Some((_, leave)) = ray.through(&self.surface.bounds) else { return 1.0 };
        let mut lit: f64 = 1.0;
        let mut travelled = 4e-3 * self.size;
        while travelled < leave && lit > 0.0 {
            let distance = self.distance(ray.at(travelled));
            lit = lit.min(SHADOW_SHARPNESS * distance / travelled);
            travelled += self.surface.safe_step(distance).max(2e-3 * self.size);
        }
        let lit = lit.clamp(0.0, 1.0);
        lit * lit * (3.0 - 2.0 * lit)
    }
}

/// Linear light to sRGB.
fn encode(colour: DVec3) -> Rgb {
    colour.to_array().map(|linear| {
        let linear = linear.clamp(0.0, 1.0);
        let encoded = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055 };
        (255.0 * encoded).round() as u8
    })
}
