//! One call, many points: blocks handed to threads, without the interpreter's lock.

use crate::points::{Points, Triples};
use numpy::{Element, IntoPyArray, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;
use std::num::NonZeroUsize;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};
use std::thread;

/// Points that a thread takes at a time: some hundred microseconds of work.
const BLOCK: usize = 4096;

/// Answers every point of `points`: `work` fills a block of answers from a block of points.
pub fn answer<T: Copy + Default + Send>(
    py: Python<'_>,
    points: &Points<'_>,
    threads: Option<NonZeroUsize>,
    work: impl Fn(&[[f32; 3]], &mut [T]) + Sync,
) -> Vec<T> {
    let points = points.triples();
    py.detach(|| {
        let mut answers = vec![T::default(); points.len()];
        in_blocks(answers.chunks_mut(BLOCK), threads, |block, answers, room| {
            work(points.block(span(block, &points), room), answers);
        });
        answers
    })
}

/// Answers every point of `points` twice over, as a distance and a vector are.
pub fn answer_pairs<T: Copy + Default + Send, U: Copy + Default + Send>(
    py: Python<'_>,
    points: &Points<'_>,
    threads: Option<NonZeroUsize>,
    work: impl Fn(&[[f32; 3]], &mut [T], &mut [U]) + Sync,
) -> (Vec<T>, Vec<U>) {
    let points = points.triples();
    py.detach(|| {
        let mut first = vec![T::default(); points.len()];
        let mut second = vec![U::default(); points.len()];
        let blocks = first.chunks_mut(BLOCK).zip(second.chunks_mut(BLOCK));
        in_blocks(blocks, threads, |block, (first, second), room| {
            work(points.block(span(block, &points), room), first, second);
        });
        (first, second)
    })
}

/// Answers every ray, from its origin and its direction.
pub fn answer_rays<T: Copy + Default + Send>(
    py: Python<'_>,
    origins: &Points<'_>,
    directions: &Points<'_>,
    threads: Option<NonZeroUsize>,
    work: impl Fn([f32; 3], [f32; 3]) -> T + Sync,
) -> Vec<T> {
    let (origins, directions) = (origins.triples(), directions.triples());
    py.detach(|| {
        let mut answers = vec![T::default(); origins.len()];
        in_blocks(answers.chunks_mut(BLOCK), threads, |block, answers, room| {
            let mut more_room = Vec::new();
            let origins = origins.block(span(block, &origins), room);
            let directions = directions.block(span(block, &directions), &mut more_room);
            for ((answer, &origin), &direction) in answers.iter_mut().zip(origins).zip(directions) {
                *answer = work(origin, direction);
            }
        });
        answers
    })
}

/// A vector as an array of the shape of the points that it answers, without a copy.
pub fn to_array<'py, T: Element>(
    py: Python<'py>,
    answers: Vec<T>,
    shape: &[usize],
) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
    answers.into_pyarray(py).reshape(shape)
}

/// Vectors as an array of the shape of the points that they answer, without a copy.
pub fn to_vector_array<'py, T: Element>(
    py: Python<'py>,
    answers: Vec<[T; 3]>,
    shape: &[usize],
) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
    to_array(py, answers.into_flattened(), &[shape, &[3]].concat())
}

fn span(block: usize, points: &Triples<'_>) -> Range<usize> {
    let start = block * BLOCK;
    start..points.len().min(start + BLOCK)
}

/// Hands blocks to threads in turn, each with its index and its thread's room for points.
///
/// The threads end with the call: a pool that stays would be missing, and waited for, in a process forked later.
fn in_blocks<B: Send>(
    blocks: impl ExactSizeIterator<Item = B> + Send,
    threads: Option<NonZeroUsize>,
    work: impl Fn(usize, B, &mut Vec<[f32; 3]>) + Sync,
) {
    let most = threads.or_else(|| thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get);
    let threads = most.min(blocks.len());
    let queue = Mutex::new(blocks.enumerate());
    let next = || queue.lock().unwrap_or_else(PoisonError::into_inner).next();
    let run = || {
        let mut room = Vec::new();
        while let Some((index, block)) = next() {
            work(index, block, &mut room);
        }
    };

    thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(run);
        }
        run();
    });
}
