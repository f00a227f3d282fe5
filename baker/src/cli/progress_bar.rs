//! The progress of a bake, on standard error, for eyes only.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use nearfield_bake::progress::Progress;
use std::io::{self, IsTerminal};
use std::time::Duration;

/// One line that is redrawn, or nothing where no terminal shows it.
pub(super) struct TerminalProgress {
    bar: ProgressBar,
}

impl TerminalProgress {
    /// Shows itself only on a terminal, and never when asked to be quiet.
    pub(super) fn new(quiet: bool) -> Self {
        let shown = !quiet && io::stderr().is_terminal();
        let target = if shown { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        let bar = ProgressBar::with_draw_target(None, target);
        if shown {
            bar.enable_steady_tick(Duration::from_millis(120));
        }
        Self { bar }
    }

    /// Does something that writes, without the line in its way.
    pub(super) fn suspend<T>(&self, write: impl FnOnce() -> T) -> T {
        self.bar.suspend(write)
    }

    /// Removes the line.
    pub(super) fn clear(&self) {
        self.bar.finish_and_clear();
    }
}

impl Progress for TerminalProgress {
    fn stage(&self, name: &'static str, length: Option<u64>) {
        let template = match length {
            Some(_) => "{msg:<12} [{bar:32}] {percent:>3} %  {elapsed}",
            None => "{msg:<12} {spinner} {human_pos}  {elapsed}",
        };
        let style = ProgressStyle::with_template(template).expect("the template is well formed");

        self.bar.reset();
        self.bar.set_style(style.progress_chars("=> "));
        self.bar.set_message(name);
        match length {
            Some(length) => self.bar.set_length(length),
            None => self.bar.unset_length(),
        }
    }

    fn advance(&self, by: u64) {
        self.bar.inc(by);
    }
}
