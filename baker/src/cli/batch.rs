//! `nearfield batch`: every mesh of a manifest that has changed.

use super::arguments::{Threads, bytes};
use super::bake::Bake;
use super::batch_report::{BatchReport, Outcome, Verdict, summary};
use super::exit_code::Failure;
use super::{bake_report, files, print, tell, to_json};
use clap::Args;
use nearfield_bake::batch::memory::{self, MemoryBudget};
use nearfield_bake::batch::{Asset, Cache, Change, Inputs, Manifest, Shard, examine, is_up_to_date};
use nearfield_bake::output;
use nearfield_bake::progress::Silent;
use rayon::ThreadPool;
use std::collections::BTreeSet;
use std::fs;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Instant;

/// Bake what has changed of many meshes
///
/// Reads a manifest (TOML) that names meshes by globs and says how to bake them, and brings every field up to date. A
/// field is left alone when its mesh, its settings and the baker are those it was baked with. What was baked once, here
/// or by another process with the same cache, is copied from the cache.
///
/// A mesh that fails does not stop the others. The exit code is that of the first that failed, in the order of the
/// manifest.
#[derive(Debug, Args)]
#[command(after_help = "\
A manifest; its paths are relative to its folder, and every flag of `nearfield bake` is a setting:
  output = \"fields\"                    # folder of the fields
  settings = { error = 1e-3 }          # of every mesh
  [presets.hero]                       # to be named by assets, and by other presets with inherits = \"hero\"
  error = 2e-4
  [[assets]]
  include = [\"props/**/*.obj\"]
  exclude = [\"props/wip/**\"]
  [[assets]]                           # a mesh belongs to the last entry that matches it
  include = [\"props/statue.obj\"]
  preset = \"hero\"
  max-depth = 10

Examples:
  nearfield batch assets.toml
  nearfield batch assets.toml --dry-run
  nearfield batch assets.toml --shard 2/5 --cache /shared/nearfield --report batch.json")]
pub(super) struct Batch {
    /// The manifest
    manifest: PathBuf,

    /// Folder of the cache, which other processes may use too [default: the manifest's, or .nearfield-cache beside it]
    #[arg(long, value_name = "FOLDER")]
    cache: Option<PathBuf>,

    /// Say what would be done and why, and do nothing
    #[arg(short = 'n', long)]
    dry_run: bool,

    /// Bake everything, changed or not
    #[arg(short, long)]
    force: bool,

    /// Start nothing new once N meshes have failed; 0 is never
    #[arg(short, long, value_name = "N", num_args = 0..=1, default_value_t = 0, default_missing_value = "0")]
    keep_going: usize,

    /// Meshes baked at a time, sharing the threads and the memory [default: as many as threads]
    #[arg(short, long, value_name = "N")]
    jobs: Option<NonZeroUsize>,

    /// Memory that all bakes at a time may take by their estimates, as 512M or 8G: those that do not fit beside the
    /// others wait, and a mesh that never will fails with exit code 6 [default: no limit]
    #[arg(long, value_name = "N", value_parser = bytes)]
    memory: Option<u64>,

    /// Do part I of N only; the same meshes belong to it on every machine
    #[arg(long, value_name = "I/N")]
    shard: Option<Shard>,

    #[command(flatten)]
    threads: Threads,

    /// Write what became of every mesh, in JSON
    #[arg(long, value_name = "JSON")]
    report: Option<PathBuf>,

    /// Print nothing but errors and warnings
    #[arg(short, long)]
    quiet: bool,
}

impl Batch {
    pub(super) fn run(self) -> Result<(), Failure> {
        let jobs = self.read_jobs()?;
        if let Some(report) = &self.report {
            files::check_output(report, &self.manifest)?;
        }

        if !self.dry_run {
            let folders: BTreeSet<&Path> = jobs.iter().filter_map(|job| job.asset.field.parent()).collect();
            folders.into_iter().for_each(output::sweep);
        }

        let pool = self.threads.pool()?;
        let outcomes = self.run_all(&jobs, &pool);

        if let Some(report) = &self.report {
            files::write_bytes(report, to_json(&BatchReport::of(&outcomes)).as_bytes())?;
        }
        self.conclude(&outcomes)
    }

    /// The manifest's meshes, or the shard's, with the arguments of each.
    fn read_jobs(&self) -> Result<Vec<Job>, Failure> {
        let manifest = Manifest::read(&self.manifest).map_err(|error| Failure::Usage(error.to_string()))?;
        for glob in &manifest.idle_globs {
            tell(&format!("warning: {}: no mesh matches {glob:?}\n", self.manifest.display()));
        }
        let beside = || self.manifest.with_file_name(".nearfield-cache");
        let cache = self.cache.clone().or(manifest.cache).unwrap_or_else(beside);

        let mut jobs = Vec::new();
        for (index, asset) in manifest.assets.into_iter().enumerate() {
            // A wrong setting is a wrong manifest, whichever shard meets it.
            let arguments = Bake::of_asset(&asset)?;
            arguments.settings()?;
            if self.shard.is_none_or(|shard| shard.holds(index)) {
                jobs.push(Job { asset, arguments, cache: Cache::new(cache.clone()) });
            }
        }
        Ok(jobs)
    }

    /// What became of each, in their order.
    fn run_all(&self, jobs: &[Job], pool: &ThreadPool) -> Vec<Outcome> {
        let next = AtomicUsize::new(0);
        let failures = AtomicUsize::new(0);
        let outcomes = Mutex::new(Vec::new());
        let budget = MemoryBudget::new(self.memory);

        // A worker waits for memory and for the bake that it starts; the pool's threads, which never wait, do the work of
        // all of them.
        let worker = || {
            while let Some((index, job)) = take_next(&next, jobs) {
                let enough = self.keep_going > 0 && failures.load(Ordering::Relaxed) >= self.keep_going;
                let start = Instant::now();
                let verdict = if enough { Verdict::NotStarted } else { self.run_one(job, pool, &budget) };
                if matches!(verdict, Verdict::Failed(_)) {
                    failures.fetch_add(1, Ordering::Relaxed);
                }
                let outcome = Outcome { asset: job.asset.clone(), verdict, elapsed: start.elapsed() };
                self.announce(&outcome);
                outcomes.lock().expect("no worker panics while it holds the list").push((index, outcome));
            }
        };
        let workers = self.jobs.map_or(pool.current_num_threads(), NonZeroUsize::get).min(jobs.len());
        thread::scope(|scope| {
            for _ in 0..workers {
                scope.spawn(worker);
            }
        });

        let mut outcomes = outcomes.into_inner().expect("no worker panics while it holds the list");
        outcomes.sort_unstable_by_key(|(index, _)| *index);
        outcomes.into_iter().map(|(_, outcome)| outcome).collect()
    }

    fn run_one(&self, job: &Job, pool: &ThreadPool, budget: &MemoryBudget) -> Verdict {
        self.bring_up_to_date(job, pool, budget).unwrap_or_else(Verdict::Failed)
    }

    fn bring_up_to_date(&self, job: &Job, pool: &ThreadPool, budget: &MemoryBudget) -> Result<Verdict, Failure> {
        let Job { asset, arguments, cache } = job;
        let (settings, hash) = (arguments.settings()?, arguments.hash()?);
        if !self.force && is_up_to_date(cache, &asset.mesh, hash, &asset.field) {
            return Ok(Verdict::UpToDate);
        }

        let change = examine(cache, &asset.mesh, hash, &asset.field, self.force)
            .map_err(|error| Failure::Input(error.to_string()))?;

        // What need not be baked.
        let (reason, inputs) = match change {
            Change::Touched(inputs) => {
                if !self.dry_run {
                    self.remember(job, &inputs);
                }
                return Ok(Verdict::UpToDate);
            }
            Change::Stale(reason, inputs) => (reason, inputs),
        };
        let cached = if self.force { None } else { cache.field(&inputs.key) };
        if self.dry_run {
            return Ok(if cached.is_some() { Verdict::WouldCopy(reason) } else { Verdict::WouldBake(reason) });
        }
        if let Some(folder) = asset.field.parent() {
            fs::create_dir_all(folder).map_err(|error| files::not_written(folder, &error))?;
        }
        if let Some(field) = cached {
            files::write_bytes_if_changed(&asset.field, &field)?;
            self.remember(job, &inputs);
            return Ok(Verdict::Copied(reason));
        }

        // What must be.
        files::check_output(&asset.field, &asset.mesh)?;
        let too_large = |error| Failure::Budget(format!("{}: {error}", asset.mesh.display()));
        let held = budget.reserve(memory::to_read(inputs.bytes())).map_err(too_large)?;
        let options = arguments.reading.read_options()?;
        let mesh = pool.install(|| files::read_mesh(&asset.mesh, &options))?;
        if let Some(path) = inputs.disturbed() {
            return Err(Failure::Input(format!("{} changed while it was read; run the batch again", path.display())));
        }
        let _held = held.resize(memory::to_bake(mesh.triangles.len())).map_err(too_large)?;
        let (baked, settings) = pool.install(|| arguments.bake(&mesh, &settings, &Silent))?;
        arguments.check_doubt(&baked.report.measurement)?;
        files::write_bytes_if_changed(&asset.field, &baked.bytes)?;
        if let Err(error) = cache.keep(&inputs.key, &baked.bytes) {
            tell(&format!("warning: {}: the cache did not take it: {error}\n", asset.field.display()));
        }
        self.remember(job, &inputs);
        for warning in bake_report::warnings(&mesh, &settings, &baked.report) {
            tell(&format!("warning: {}: {warning}\n", asset.mesh.display()));
        }
        Ok(Verdict::Baked { reason, bytes: baked.bytes.len() })
    }

    /// The field is right whether or not the cache remembers it: next time it is only looked at more closely.
    fn remember(&self, job: &Job, inputs: &Inputs) {
        if let Err(error) = inputs.remember(&job.cache, &job.asset.field) {
            tell(&format!("warning: {}: the cache did not take it: {error}\n", job.asset.field.display()));
        }
    }

    /// One line a mesh, as soon as it is done.
    fn announce(&self, outcome: &Outcome) {
        if let Verdict::Failed(failure) = &outcome.verdict {
            tell(&format!("error: {failure}\n"));
        } else if !self.quiet {
            // Nobody listens: the fields matter more.
            let _ = print(&outcome.line());
        }
    }

    fn conclude(&self, outcomes: &[Outcome]) -> Result<(), Failure> {
        if !self.quiet {
            print(&summary(outcomes))?;
        }
        let mut failed = outcomes.iter().filter_map(|outcome| match &outcome.verdict {
            Verdict::Failed(failure) => Some(failure.code()),
            _ => None,
        });
        let Some(code) = failed.next() else { return Ok(()) };
        let message = format!("{} of {} meshes failed; the others are done", failed.count() + 1, outcomes.len());
        Err(Failure::Assets { message, code })
    }
}

/// One asset, its arguments and where its field may be already.
struct Job {
    asset: Asset,
    arguments: Bake,
    cache: Cache,
}

fn take_next<'a>(next: &AtomicUsize, jobs: &'a [Job]) -> Option<(usize, &'a Job)> {
    let index = next.fetch_add(1, Ordering::Relaxed);
    jobs.get(index).map(|job| (index, job))
}
