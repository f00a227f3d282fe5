//! An app of Bevy without a window loads fields from a folder.

use bevy_app::{App, TaskPoolPlugin};
use bevy_asset::{AssetEvent, AssetLoadFailedEvent, AssetPlugin, AssetServer, Assets, Handle, LoadState};
use bevy_ecs::message::Messages;
use nearfield::Field;
use nearfield_bevy::{FieldAsset, FieldPlugin};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use std::{fs, thread};

/// The longest that a loaded machine may take to load a small file.
const PATIENCE: Duration = Duration::from_secs(60);

fn valid_vectors() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../format-spec/vectors/valid");
    let entries = fs::read_dir(folder).expect("the vectors of the format").map(|entry| entry.expect("an entry").path());
    let mut vectors: Vec<PathBuf> = entries.filter(|path| path.extension().is_some_and(|is| is == "nfd")).collect();
    vectors.sort();
    vectors
}

fn app(folder: &Path) -> App {
    let assets = AssetPlugin {
        file_path: folder.to_str().expect("a folder with a plain name").to_owned(),
        watch_for_changes_override: Some(true),
        ..AssetPlugin::default()
    };
    let mut app = App::new();
    app.add_plugins((TaskPoolPlugin::default(), assets, FieldPlugin));
    app
}

/// Runs the app until something is there.
fn update_until<T>(app: &mut App, what: &str, mut found: impl FnMut(&mut App) -> Option<T>) -> T {
    let start = Instant::now();
    loop {
        app.update();
        if let Some(found) = found(app) {
            return found;
        }
        assert!(start.elapsed() < PATIENCE, "{what} within {PATIENCE:?}");
        thread::sleep(Duration::from_millis(5));
    }
}

fn load(app: &mut App, name: &'static str) -> Handle<FieldAsset> {
    app.world().resource::<AssetServer>().load(name)
}

fn bytes(app: &App, handle: &Handle<FieldAsset>) -> Option<Vec<u8>> {
    app.world().resource::<Assets<FieldAsset>>().get(handle).map(|asset| asset.bytes().to_vec())
}

fn failure(app: &mut App) -> Option<String> {
    let mut failures = app.world_mut().resource_mut::<Messages<AssetLoadFailedEvent<FieldAsset>>>();
    failures.drain().last().map(|failed| failed.error.to_string())
}

#[test]
fn a_field_loads_reloads_when_it_changes_and_outlives_a_damaged_file() {
    let [first, second, ..] = &valid_vectors()[..] else { panic!("at least two vectors") };
    let (first, second) = (fs::read(first).expect("a vector"), fs::read(second).expect("another"));
    assert_ne!(first, second, "the vectors differ");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("rock.nfd");
    fs::write(&path, &first).expect("the field");

    // It loads, and answers as the reader alone does.
    let mut app = app(folder.path());
    let rock = load(&mut app, "rock.nfd");
    let loaded = update_until(&mut app, "the field loads", |app| bytes(app, &rock));
    assert_eq!(loaded, first);
    let assets = app.world().resource::<Assets<FieldAsset>>();
    let asset = assets.get(&rock).expect("it is loaded");
    let alone = Field::open(&first).expect("the vector is valid");
    let point = [0.25, 0.5, 0.125];
    assert_eq!(asset.field().distance_and_gradient(point), alone.distance_and_gradient(point));

    // It changes, and what watches it is told.
    app.world_mut().resource_mut::<Messages<AssetEvent<FieldAsset>>>().clear();
    fs::write(&path, &second).expect("the new field");
    update_until(&mut app, "the new field loads", |app| (bytes(app, &rock)? == second).then_some(()));
    update_until(&mut app, "the change is told", |app| {
        let mut events = app.world_mut().resource_mut::<Messages<AssetEvent<FieldAsset>>>();
        events.drain().any(|event| event.is_modified(&rock)).then_some(())
    });

    // It is damaged: the error says how, and the sound field stays.
    let mut damaged = first.clone();
    let last = damaged.len() - 1;
    damaged[last] ^= 1;
    fs::write(&path, &damaged).expect("the damaged field");
    let message = update_until(&mut app, "the failure is told", failure);
    assert!(message.contains("rock.nfd") && message.contains("checksum"), "{message}");
    assert_eq!(bytes(&app, &rock).expect("the sound field stays"), second);
}

#[test]
fn what_is_not_a_field_fails_with_a_sentence() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("cube.nfd"), "solid cube").expect("the file");
    let mut app = app(folder.path());

    let cube = load(&mut app, "cube.nfd");
    let message = update_until(&mut app, "the failure is told", failure);
    assert!(message.contains("magic number") && message.contains("bake it again"), "{message}");
    assert!(matches!(app.world().resource::<AssetServer>().load_state(&cube), LoadState::Failed(_)));

    let gone = load(&mut app, "gone.nfd");
    let message = update_until(&mut app, "the absence is told", failure);
    assert!(message.contains("gone.nfd"), "{message}");
    assert!(bytes(&app, &gone).is_none());
}

#[test]
fn every_vector_of_the_format_is_an_asset() {
    for path in valid_vectors() {
        let bytes = fs::read(&path).expect("a vector");
        let asset = FieldAsset::new(bytes).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert!(asset.field().distance([0.0; 3]).is_finite());
    }
}
