//! Values of the reader in memory that C owns.
//!
//! C must know how large a handle is, but not what is in it: room for it is reserved in words, and it is asserted here
//! that the value fits.

use core::mem::MaybeUninit;

/// C copies a handle by assignment and forgets it without a call: nothing may need to be dropped.
const fn assert_fits<T, const COUNT: usize>() {
    assert!(size_of::<T>() <= size_of::<[MaybeUninit<u64>; COUNT]>() && align_of::<T>() <= align_of::<u64>());
    assert!(!core::mem::needs_drop::<T>());
}

/// Puts a value into its room: words of any content, none as well.
pub(crate) fn put<T, const COUNT: usize>(room: &mut [MaybeUninit<u64>; COUNT], value: T) {
    const { assert_fits::<T, COUNT>() };
    // SAFETY: the room is large enough and aligned, as asserted, and borrowed for writing.
    unsafe { room.as_mut_ptr().cast::<T>().write(value) }
}

/// The value in a room.
///
/// # Safety
///
/// `put::<T>` filled this room, or one that it was copied from.
pub(crate) unsafe fn get<T, const COUNT: usize>(room: &[MaybeUninit<u64>; COUNT]) -> &T {
    const { assert_fits::<T, COUNT>() };
    // SAFETY: the room holds a `T`, as the caller promises, is aligned, as asserted, and borrowed for as long.
    unsafe { &*room.as_ptr().cast::<T>() }
}

/// The value in a room, to be changed.
///
/// # Safety
///
/// As for [`get`].
pub(crate) unsafe fn get_mut<T, const COUNT: usize>(room: &mut [MaybeUninit<u64>; COUNT]) -> &mut T {
    const { assert_fits::<T, COUNT>() };
    // SAFETY: as in `get`, and borrowed for writing.
    unsafe { &mut *room.as_mut_ptr().cast::<T>() }
}
