//! One budget of memory for all bakes that run at a time.

use std::sync::{Condvar, Mutex};
use thiserror::Error;

/// What a bake takes whatever the mesh: the program, the samples of a batch of cells, the field.
const BASE: u64 = 32 << 20;
/// Measured on meshes of 3·10⁵ to 5·10⁶ triangles: 207 to 250, most of them search tree and topology.
const BYTES_PER_TRIANGLE: u64 = 256;
/// Reading holds the file and its triangles twice, before and after they are welded.
const BYTES_PER_FILE_BYTE: u64 = 8;

/// An estimate of what it takes to read a mesh file of this length, bytes.
pub fn to_read(file_bytes: u64) -> u64 {
    BASE + BYTES_PER_FILE_BYTE * file_bytes
}

/// An estimate of what it takes to bake so many triangles, bytes.
pub fn to_bake(triangles: usize) -> u64 {
    BASE + BYTES_PER_TRIANGLE * triangles as u64
}

/// Memory that bakes share by what they are estimated to need: those that do not fit beside the others wait.
#[derive(Debug)]
pub struct MemoryBudget {
    total: u64,
    free: Mutex<u64>,
    freed: Condvar,
}

/// More than the whole budget was asked for.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("it takes about {needed} bytes of memory, and all may take {total}: raise --memory")]
pub struct TooLarge {
    /// Bytes that it takes, by the estimate.
    pub needed: u64,
    /// The whole budget, bytes.
    pub total: u64,
}

impl MemoryBudget {
    /// So many bytes in all; without a number as many as anybody asks for.
    pub fn new(total: Option<u64>) -> Self {
        let total = total.unwrap_or(u64::MAX);
        Self { total, free: Mutex::new(total), freed: Condvar::new() }
    }

    /// Waits until there is so much, and takes it.
    ///
    /// # Errors
    /// There never will be.
    pub fn reserve(&self, bytes: u64) -> Result<Reservation<'_>, TooLarge> {
        if bytes > self.total {
            return Err(TooLarge { needed: bytes, total: self.total });
        }
        let free = self.free.lock().expect(NO_PANIC);
        let mut free = self.freed.wait_while(free, |free| *free < bytes).expect(NO_PANIC);
        *free -= bytes;
        Ok(Reservation { budget: self, bytes })
    }
}

const NO_PANIC: &str = "nothing panics while it counts";

/// A part of the budget, given back when dropped.
#[derive(Debug)]
pub struct Reservation<'a> {
    budget: &'a MemoryBudget,
    bytes: u64,
}

impl Reservation<'_> {
    /// Gives this back, then waits for another size: two that grow never wait for each other.
    ///
    /// # Errors
    /// As [`MemoryBudget::reserve`].
    pub fn resize(self, bytes: u64) -> Result<Self, TooLarge> {
        let budget = self.budget;
        drop(self);
        budget.reserve(bytes)
    }
}

impl Drop for Reservation<'_> {
    fn drop(&mut self) {
        *self.budget.free.lock().expect(NO_PANIC) += self.bytes;
        self.budget.freed.notify_all();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicU64, Ordering};
    use std::thread;

    #[test]
    fn what_runs_at_a_time_never_exceeds_the_budget() {
        let budget = MemoryBudget::new(Some(10));
        let (used, most) = (AtomicU64::new(0), AtomicU64::new(0));
        thread::scope(|scope| {
            for worker in 0..8u64 {
                let (budget, used, most) = (&budget, &used, &most);
                scope.spawn(move || {
                    for round in 0..200 {
                        let bytes = 1 + (worker * 7 + round) % 10;
                        let first = budget.reserve(bytes).expect("it fits");
                        let _held = first.resize(11 - bytes).expect("it fits");
                        let now = used.fetch_add(11 - bytes, Ordering::SeqCst) + 11 - bytes;
                        most.fetch_max(now, Ordering::SeqCst);
                        used.fetch_sub(11 - bytes, Ordering::SeqCst);
                    }
                });
            }
        });
        assert!((1..=10).contains(&most.into_inner()));
        assert_eq!(*budget.free.lock().unwrap(), 10, "all is back");
    }

    #[test]
    fn more_than_all_is_refused_at_once() {
        let budget = MemoryBudget::new(Some(10));
        let held = budget.reserve(4).expect("it fits");
        assert_eq!(budget.reserve(11).unwrap_err(), TooLarge { needed: 11, total: 10 });
        assert_eq!(held.resize(12).unwrap_err(), TooLarge { needed: 12, total: 10 });
        assert!(MemoryBudget::new(None).reserve(to_bake(usize::MAX >> 9)).is_ok());
    }
}
