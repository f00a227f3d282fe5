"""Signed distance fields that ship: bake a mesh into a small file, ask it for distance and gradient.

Points are arrays of shape (..., 3) in the units and the frame of the mesh. Arrays of ``float32`` or ``float64`` in
row-major order are read where they lie; other arrays and sequences are copied first. The reader computes in
``float32``, and so are all answers. Calls release the interpreter's lock: do not write to an array while another
thread is asking about it. ``threads`` is how many threads share the points, all processors by default.
"""

from collections.abc import Sequence
from os import PathLike
from typing import Any, Literal, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "Contract",
    "ErrorStatistics",
    "Field",
    "FieldError",
    "Raycast",
    "__version__",
    "bake",
    "from_bytes",
    "open",
]

__version__: str

class FieldError(ValueError):
    """Bytes that are not a sound field."""

def open(path: str | PathLike[str]) -> Field:
    """Opens a field file after checking every byte of it.

    Raises OSError when the file cannot be read, FieldError when it is not a sound field.
    """

def from_bytes(data: bytes) -> Field:
    """A field from the bytes of its file, which are copied and checked.

    Raises FieldError when they are not a sound field.
    """

def bake(
    vertices: ArrayLike,
    faces: NDArray[np.integer[Any]] | Sequence[Sequence[int]],
    *,
    error: float | None = None,
    error_abs: float | None = None,
    continuity: Literal["none", "c0", "c1"] = "c1",
    margin: float | None = None,
    max_depth: int | None = None,
    samples: int | None = None,
    lods: int = 0,
    threads: int | None = None,
) -> Field:
    """Bakes a triangle mesh into a field: the same mesh and settings give the same bytes on any machine.

    The settings are those of ``nearfield bake``, with its defaults: ``error`` is the root mean square error asked of
    every leaf, a fraction of the diagonal of the mesh's box, and ``error_abs`` the same in mesh units; ``lods`` is how
    many levels of detail to add. It runs to its end: an interrupt is noticed afterwards.

    Raises ValueError for a mesh or settings that give no field, TypeError for faces that are not integers.
    """

@final
class Field:
    """A signed distance field. Immutable: share it between threads, pickle it, fork with it.

    Make one with ``nearfield.open``, ``nearfield.from_bytes`` or ``nearfield.bake``.
    """

    def distance(self, points: ArrayLike, *, threads: int | None = None) -> NDArray[np.float32]:
        """Signed distances from points to the surface: mesh units, negative inside.

        Finite for every finite point; outside the box an upper bound.
        """

    def distance_and_gradient(
        self, points: ArrayLike, *, threads: int | None = None
    ) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Signed distances and their gradients, which are near unit length but not normalized."""

    def clearance(self, points: ArrayLike, *, threads: int | None = None) -> NDArray[np.float32]:
        """How far points are at least from the true surface, as far as the contract goes.

        The distance less the largest measured error. At most 0 where nothing is known, negative inside, never NaN.
        """

    def closest_point(
        self, points: ArrayLike, *, threads: int | None = None
    ) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Goes down the gradient to the surface: where it ends, and the field there.

        The end is no farther from the surface than the start; that it is the closest point is not promised.
        """

    def raycast(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        *,
        length: float = ...,
        within: float = 0.0,
        threads: int | None = None,
    ) -> Raycast:
        """Follows rays to the surface by sphere tracing, inside the box of the field, at most 512 steps each.

        ``directions`` need no unit length; ``length`` and ``within`` are mesh units. A ray stops where the field is at
        most ``within``: with ``contract.max_error`` before the true surface, with 0 on the field's.
        """

    def lod(self, level: int) -> Field:
        """A level of detail: 0 is the field itself, 1 the next coarser, and so on.

        A field of its own, with its own bounds and contract; its bytes are copied. Raises IndexError when there is no
        such level.
        """

    @property
    def lod_count(self) -> int:
        """How many levels of detail there are, the field itself among them: at least 1."""

    def tobytes(self) -> bytes:
        """The bytes of the file."""

    def save(self, path: str | PathLike[str]) -> None:
        """Writes the file, whole or not at all."""

    @property
    def nbytes(self) -> int:
        """Length of the file in bytes."""

    @property
    def bounds(self) -> NDArray[np.float32]:
        """Least and greatest corner of the box in which the field was sampled, as an array of shape (2, 3)."""

    @property
    def contract(self) -> Contract:
        """How wrong the field was found to be when it was baked."""

    @property
    def family(self) -> str:
        """How the field is represented: "grid", "octree" and so on."""

    @property
    def sign_method(self) -> str:
        """How the baker told inside from outside: "none", "pseudonormal", "winding" and so on."""

    @property
    def diagonal(self) -> float:
        """Diagonal of the mesh's bounding box, mesh units."""

    @property
    def target_error(self) -> float:
        """Error that the baker was asked for, mesh units."""

    @property
    def lipschitz(self) -> float:
        """Upper bound of the slope of the field inside its box."""

    @property
    def format_version(self) -> tuple[int, int]:
        """Major and minor version of the format."""

    @property
    def baker_version(self) -> tuple[int, int, int]:
        """Version of the baker."""

    @property
    def mesh_hash(self) -> bytes:
        """Hash of the welded mesh; zeros for a field that did not come from one."""

    @property
    def settings_hash(self) -> bytes:
        """Hash of the settings."""

@final
class Raycast:
    """What became of rays: one entry a ray in each array."""

    @property
    def hit(self) -> NDArray[np.bool_]:
        """Whether the ray met the surface."""

    @property
    def distance(self) -> NDArray[np.float32]:
        """How far the ray is clear, mesh units: to its hit; infinite for a miss; else to where 512 steps led."""

    @property
    def point(self) -> NDArray[np.float32]:
        """Where it hit; NaN where it did not."""

    @property
    def normal(self) -> NDArray[np.float32]:
        """Unit gradient there; NaN where it did not hit."""

@final
class Contract:
    """How wrong the field was found to be when it was baked, in mesh units: measurements, not proofs."""

    @property
    def uniform(self) -> ErrorStatistics:
        """Over points spread evenly over the mesh's bounding box."""

    @property
    def band(self) -> ErrorStatistics:
        """Over points within 1 % of the diagonal of the surface."""

    @property
    def max_error(self) -> float:
        """Largest error measured anywhere; infinite when nothing was measured."""

    @property
    def seam_max(self) -> float:
        """Largest jump of the value across a face between leaves."""

    @property
    def sample_count(self) -> int:
        """Points measured, uniform and again in the band."""

    @property
    def doubtful_signs(self) -> int:
        """Measured points whose sign the sign method could not vouch for."""

@final
class ErrorStatistics:
    """Errors measured over a set of points, in mesh units."""

    @property
    def rmse(self) -> float:
        """Root mean square error."""

    @property
    def p99(self) -> float:
        """99th percentile of the absolute error."""

    @property
    def max(self) -> float:
        """Largest absolute error."""
