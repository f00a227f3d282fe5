//! The examples in C and C++: free of warnings, free of faults, and with the bits that Rust has.

use nearfield::{Field, Raycast};
use std::ffi::OsStr;
use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::LazyLock;

const WARNINGS: [&str; 5] = ["-Wall", "-Wextra", "-Werror", "-pedantic", "-O1"];

/// Where the libraries of this build are.
fn libraries() -> PathBuf {
    let test = std::env::current_exe().expect("this program");
    test.parent().expect("its folder").to_path_buf()
}

/// Where this test may write.
fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
}

/// A folder where the shared library has the name that the dynamic linker looks for.
fn shared_libraries() -> PathBuf {
    let links = folder().join("shared");
    fs::create_dir_all(&links).expect("a folder");
    for name in ["libnearfield_c.so", "libnearfield_c.so.1"] {
        let link = links.join(name);
        fs::copy(libraries().join("libnearfield_c.so"), &link).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
    links
}

fn run(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}\n{error}");
    String::from_utf8(output.stdout).expect("text")
}

fn compile(compiler: &str, standard: &str, source: &str, flags: &[&OsStr]) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let tag: String = flags.iter().filter_map(|flag| flag.to_str()).filter(|flag| flag.starts_with("-f")).collect();
    let program = folder().join(format!("{source}{}", tag.replace(['=', ','], "_")));
    let mut command = Command::new(compiler);
    command.arg(standard).args(WARNINGS).arg("-I").arg(root.join("include"));
    command.arg(root.join("examples").join(source)).args(flags).arg("-o").arg(&program);
    run(&mut command);
    program
}

/// `query.c`, which two tests run.
static QUERY: LazyLock<PathBuf> = LazyLock::new(|| compile_sanitized("cc", "-std=c99", "query.c"));

/// With the static library, under the sanitizers of addresses and of undefined behaviour.
fn compile_sanitized(compiler: &str, standard: &str, source: &str) -> PathBuf {
    let library = libraries().join("libnearfield_c.a");
    let flags = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-g"].map(OsStr::new);
    compile(compiler, standard, source, &[&flags[..], &[library.as_os_str()]].concat())
}

/// With the shared library.
fn compile_shared(compiler: &str, standard: &str, source: &str) -> PathBuf {
    let search = format!("-L{}", shared_libraries().display());
    let flags = ["-g", &search, "-lnearfield_c"].map(OsStr::new);
    compile(compiler, standard, source, &flags)
}

fn answer(command: &mut Command, points: &[[f32; 3]]) -> Vec<Vec<f32>> {
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let child = child.as_mut().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let mut lines = String::new();
    for [x, y, z] in points {
        writeln!(lines, "{x:e} {y:e} {z:e}").expect("a string takes all");
    }
    let mut input = child.stdin.take().expect("a pipe");
    input.write_all(lines.as_bytes()).expect("the program reads");
    drop(input);
    let mut text = String::new();
    let mut errors = String::new();
    use std::io::Read as _;
    child.stdout.take().expect("a pipe").read_to_string(&mut text).expect("text");
    child.stderr.take().expect("a pipe").read_to_string(&mut errors).expect("text");
    assert!(child.wait().expect("it ends").success(), "{errors}");
    let number = |word: &str| word.parse::<f32>().unwrap_or_else(|error| panic!("{word}: {error}"));
    text.lines().map(|line| line.split_whitespace().map(number).collect()).collect()
}

/// Points inside, on and outside the box of a field.
fn points(field: &Field<'_>) -> Vec<[f32; 3]> {
    let bounds = field.header().bounds;
    let place = |axis: usize, share: f32| bounds.min[axis] + share * (bounds.max[axis] - bounds.min[axis]);
    let shares = [-0.25, 0.0, 0.55, 1.0];
    let mut points = Vec::new();
    for x in shares {
        for y in shares {
            points.extend(shares.map(|z| [place(0, x), place(1, y), place(2, z)]));
        }
    }
    points
}

/// What `query.c` prints, from Rust.
fn answers(field: &Field<'_>, point: [f32; 3]) -> Vec<f32> {
    let (distance, gradient) = field.distance_and_gradient(point);
    let closest = field.closest_point(point);
    let region = nearfield::Aabb { min: point.map(|x| x - 0.1), max: point.map(|x| x + 0.1) };
    let (low, high) = field.range(region);
    let ray = match field.raycast(point, [1.0, 2.0, 3.0], 1e3, 0.0) {
        Raycast::Miss { steps } => [&[0.0, steps as f32][..], &[0.0; 7]].concat(),
        Raycast::Hit(hit) => [&[1.0, hit.steps as f32, hit.distance][..], &hit.point, &hit.normal].concat(),
        Raycast::OutOfSteps { clear } => [&[2.0, 512.0, clear][..], &[0.0; 6]].concat(),
    };
    let axes = [[0.0, 2.0, 0.0], [-2.0, 0.0, 0.0], [0.0, 0.0, 2.0]];
    let instance = nearfield::Instance::new(*field, axes, [1.0, 0.0, 0.5]).expect("a similarity");
    let (placed, slope) = instance.distance_and_gradient(point);
    let parts: [&[f32]; 9] = [
        &[distance],
        &gradient,
        &field.normal(point),
        &closest.point,
        &[closest.residual, closest.steps as f32],
        &[field.clearance(point), low, high],
        &ray,
        &[placed],
        &slope,
    ];
    parts.concat()
}

fn assert_same_bits(ours: &[f32], theirs: &[f32], place: &str) {
    let bits = |numbers: &[f32]| numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(ours), bits(theirs), "{place}: Rust {ours:?}, C {theirs:?}");
}

/// The valid fields beside the specification.
fn fields() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../format-spec/vectors/valid");
    let files = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<PathBuf> = files.map(|file| file.expect("a file").path()).collect();
    paths.retain(|path| path.extension() == Some(OsStr::new("nfd")));
    paths.sort();
    assert!(paths.len() > 40, "only {} fields", paths.len());
    paths
}

fn assert_query(command: impl Fn(&Path) -> Command, paths: &[PathBuf]) {
    for path in paths {
        let bytes = fs::read(path).expect("a field");
        let field = Field::open(&bytes).expect("a valid field");
        let points = points(&field);
        let theirs = answer(&mut command(path), &points);
        assert_eq!(theirs.len(), points.len());
        for (point, line) in points.iter().zip(&theirs) {
            assert_same_bits(&answers(&field, *point), line, &format!("{} at {point:?}", path.display()));
        }
    }
}

fn assert_particles(command: impl Fn(&Path) -> Command, paths: &[PathBuf]) {
    for path in paths {
        let bytes = fs::read(path).expect("a field");
        let field = Field::open(&bytes).expect("a valid field");
        let points = points(&field);
        let theirs = answer(&mut command(path), &points);
        assert_eq!(theirs.len(), points.len());
        for (point, line) in points.iter().zip(&theirs) {
            let (distance, gradient) = field.distance_and_gradient(*point);
            let moved = [0, 1, 2].map(|axis: usize| point[axis] - distance * gradient[axis]);
            let ours = [&[distance][..], &gradient, &[field.distance(moved)]].concat();
            assert_same_bits(&ours, line, &format!("{} at {point:?}", path.display()));
        }
    }
}

fn plain(program: &Path, path: &Path) -> Command {
    let mut command = Command::new(program);
    command.arg(path);
    command
}

fn valgrind(program: &Path, path: &Path) -> Command {
    let mut command = Command::new("valgrind");
    command.args(["--quiet", "--error-exitcode=9", "--leak-check=full"]).arg(program).arg(path);
    command.env("LD_LIBRARY_PATH", folder().join("shared"));
    command
}

#[test]
fn c_has_the_bits_of_rust_under_sanitizers() {
    assert_query(|path| plain(&QUERY, path), &fields());
}

#[test]
fn cpp_has_the_bits_of_rust_under_sanitizers() {
    let program = compile_sanitized("c++", "-std=c++17", "particles.cpp");
    assert_particles(|path| plain(&program, path), &fields());
}

#[test]
fn the_shared_library_has_the_bits_of_rust_under_valgrind() {
    // A few of every kind: each run starts a machine.
    let paths: Vec<PathBuf> = fields().into_iter().step_by(12).collect();
    let program = compile_shared("cc", "-std=c99", "query.c");
    assert_query(|path| valgrind(&program, path), &paths);
    let program = compile_shared("c++", "-std=c++17", "particles.cpp");
    assert_particles(|path| valgrind(&program, path), &paths);
}

#[test]
fn refusals_are_sentences() {
    let path = folder().join("short.nfd");
    fs::write(&path, b"solid cube").expect("a file");
    let output = plain(&QUERY, &path).output().expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1));
    assert!(said.contains(nearfield::Error::Magic.text()), "{said}");
}
