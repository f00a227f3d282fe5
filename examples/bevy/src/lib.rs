//! Nearfield fields as assets of Bevy: loaded in the background, checked, and loaded again when they change.
//!
//! ```
//! use bevy_app::{App, TaskPoolPlugin};
//! use bevy_asset::{AssetPlugin, AssetServer, Assets, Handle};
//! use nearfield_bevy::{FieldAsset, FieldPlugin};
//!
//! let mut app = App::new();
//! app.add_plugins((TaskPoolPlugin::default(), AssetPlugin::default(), FieldPlugin));
//! let rock: Handle<FieldAsset> = app.world().resource::<AssetServer>().load("rock.nfd");
//!
//! // In a system, once it is there:
//! if let Some(asset) = app.world().resource::<Assets<FieldAsset>>().get(&rock) {
//!     let field = asset.field();
//!     let (distance, gradient) = field.distance_and_gradient([0.1, 0.2, 0.3]);
//!     # let _ = (distance, gradient);
//! }
//! ```

#[cfg(feature = "material")]
pub mod material;

use bevy_app::{App, Plugin};
use bevy_asset::io::Reader;
use bevy_asset::{Asset, AssetApp, AssetLoader, LoadContext};
use bevy_reflect::TypePath;
use nearfield::Field;
use std::io;
use std::sync::Arc;
use thiserror::Error;

/// Lets the asset server load `.nfd` files. Add it after Bevy's `AssetPlugin`.
#[derive(Clone, Copy, Debug, Default)]
pub struct FieldPlugin;

impl Plugin for FieldPlugin {
    fn build(&self, app: &mut App) {
        app.init_asset::<FieldAsset>().init_asset_loader::<FieldLoader>();
    }
}

/// The bytes of a sound field. Copies share them.
#[derive(Asset, Clone, Debug, TypePath)]
pub struct FieldAsset {
    bytes: Arc<[u8]>,
}

impl FieldAsset {
    /// Takes the bytes of a file after checking all of them.
    ///
    /// # Errors
    /// The first rule of the format that they break.
    pub fn new(bytes: Vec<u8>) -> Result<Self, nearfield::Error> {
        Field::open(&bytes)?.validate()?;
        Ok(Self { bytes: bytes.into() })
    }

    /// The field, for queries. Takes about a microsecond: once a system, not once a query.
    pub fn field(&self) -> Field<'_> {
        Field::open(&self.bytes).expect("these bytes were opened before, and have not changed since")
    }

    /// The bytes of the file, for a storage buffer.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }
}

/// Reads `.nfd` files for the asset server.
#[derive(Clone, Copy, Debug, Default, TypePath)]
pub struct FieldLoader;

/// Why an asset is not loaded.
#[derive(Debug, Error)]
pub enum FieldLoadError {
    /// The source did not hand over the bytes.
    #[error("the field cannot be read: {0}")]
    Unreadable(#[from] io::Error),
    /// They are not a sound field.
    #[error("the file is not a sound field: {0}; bake it again")]
    Unsound(#[from] nearfield::Error),
}

impl AssetLoader for FieldLoader {
    type Asset = FieldAsset;
    type Settings = ();
    type Error = FieldLoadError;

    async fn load(
        &self,
        reader: &mut dyn Reader,
        _settings: &(),
        _context: &mut LoadContext<'_>,
    ) -> Result<FieldAsset, FieldLoadError> {
        let mut bytes = Vec::new();
        reader.read_to_end(&mut bytes).await?;
        Ok(FieldAsset::new(bytes)?)
    }

    fn extensions(&self) -> &[&str] {
        &["nfd"]
    }
}
