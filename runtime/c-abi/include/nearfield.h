/* Nearfield: signed distance fields that ship. The interface of the reader for C99 and C++.
 *
 * This header is the manual. It is generated from runtime/c-abi/src; a stale one fails the tests.
 *
 *     NearfieldField field;
 *     if (nearfield_open(&field, bytes, length) != NEARFIELD_RESULT_OK) { ... }
 *     if (nearfield_validate(&field) != NEARFIELD_RESULT_OK) { ... }      // bytes from elsewhere: once
 *     float distance = nearfield_distance(&field, (NearfieldVector){x, y, z});
 *
 * Units      Everything is in the units and the frame of the mesh; distances are negative inside.
 * Memory     No heap and no global state. A handle is a plain struct of a fixed size that you own: put it on the
 *            stack, in static memory or in your own struct, copy it by assignment, forget it without a call. It
 *            borrows the bytes of the field: keep them in place and unchanged as long as the handle is used. They
 *            need no alignment; they may lie in flash or in a mapped file. Handles belong to one process and one
 *            version of the library: store and send the bytes instead.
 * Threads    Every function is reentrant. Any number of threads may query one NearfieldField; a NearfieldCursor
 *            belongs to one thread at a time.
 * Untrusted  Whatever the bytes and the points, no function crashes, reads beyond `length`, or fails to return, and
 *            once nearfield_open succeeds every finite point has a finite answer. Only nearfield_validate tells
 *            whether the answers are those that were baked.
 * NULL       A NULL handle, or one that is all zero or whose nearfield_open failed, answers NaN, or what is said at
 *            the function. Other pointers may be NULL only where it is said.
 * Bits       The same bytes and point give the same bits on every machine.
 * Work       No recursion; a function that loops says how often.
 */

#ifndef NEARFIELD_H
#define NEARFIELD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A handle that is not open, for initializers. */
#if defined(__cplusplus)
#define NEARFIELD_FIELD_NONE {}
#else
#define NEARFIELD_FIELD_NONE {0}
#endif

// Version of this interface. A library and a program go together if both have the same: compare it with
// nearfield_abi_version when the library is loaded at run time. The name of the shared library has it too.
#define NEARFIELD_ABI_VERSION 1

// What became of a call. A number keeps its meaning; later versions may add some.
enum NearfieldResult
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // All is well.
  NEARFIELD_RESULT_OK = 0,
  // The file is shorter than its header and section table (§2).
  NEARFIELD_RESULT_TRUNCATED = 1,
  // The first eight bytes are not the magic number (§3.1).
  NEARFIELD_RESULT_MAGIC = 2,
  // The version is outside the window of this reader (§3.2).
  NEARFIELD_RESULT_VERSION = 3,
  // The file length in the header is not the number of bytes (§3.3).
  NEARFIELD_RESULT_FILE_LENGTH = 4,
  // A reserved bit is set (§1.3).
  NEARFIELD_RESULT_RESERVED = 5,
  // The checksum of the header and the section table does not match (§3.4).
  NEARFIELD_RESULT_HEADER_CHECKSUM = 6,
  // The field family is unknown, or not the one that was asked for (§3.5).
  NEARFIELD_RESULT_FAMILY = 7,
  // The sign method is unknown (§3.6).
  NEARFIELD_RESULT_SIGN_METHOD = 8,
  // The box is empty, not finite or too large (§3.7).
  NEARFIELD_RESULT_BOUNDS = 9,
  // A length or slope in the header is negative, not finite or too large (§3.8).
  NEARFIELD_RESULT_QUANTITY = 10,
  // A root mean square or 99th percentile exceeds its maximum (§3.9).
  NEARFIELD_RESULT_CONTRACT = 11,
  // The section table is too long, or its sections do not tile the rest of the file (§4).
  NEARFIELD_RESULT_SECTION_TABLE = 12,
  // Two sections are of the same kind (§4).
  NEARFIELD_RESULT_SECTION_DUPLICATE = 13,
  // A section that the family requires is missing (§4).
  NEARFIELD_RESULT_SECTION_MISSING = 14,
  // The checksum of a section does not match (§4).
  NEARFIELD_RESULT_SECTION_CHECKSUM = 15,
  // The section of octree parameters has the wrong length (§5).
  NEARFIELD_RESULT_OCTREE_LENGTH = 16,
  // The root grid is empty, or the lattice or the tree too large (§5.1).
  NEARFIELD_RESULT_OCTREE_LATTICE = 17,
  // The interpolant is unknown (§5.2).
  NEARFIELD_RESULT_INTERPOLANT = 18,
  // The continuity is unknown (§5.3).
  NEARFIELD_RESULT_CONTINUITY = 19,
  // The edge of a root cell or the distance quantum is out of range (§5.4).
  NEARFIELD_RESULT_OCTREE_SCALE = 20,
  // The box is not the root grid (§5.4).
  NEARFIELD_RESULT_OCTREE_BOUNDS = 21,
  // The node section is not the root grid and whole groups of eight (§6).
  NEARFIELD_RESULT_NODE_LENGTH = 22,
  // The tag of a node word is unknown (§6).
  NEARFIELD_RESULT_NODE_TAG = 23,
  // A group of children is not where its order puts it (§6.1).
  NEARFIELD_RESULT_NODE_ORDER = 24,
  // A node lies below the deepest level (§6.1).
  NEARFIELD_RESULT_NODE_DEPTH = 25,
  // The leaf count is not the number of leaves (§6.1).
  NEARFIELD_RESULT_LEAF_COUNT = 26,
  // A sample block is not where its order puts it, or exceeds its section (§7).
  NEARFIELD_RESULT_BLOCK_ORDER = 27,
  // A sample that a leaf needs is not present (§7.1).
  NEARFIELD_RESULT_BLOCK_PRESENT = 28,
  // A full sample is not present, or the interpolant knows no full samples (§7.1).
  NEARFIELD_RESULT_BLOCK_FULL = 29,
  // The precision of a block is unknown (§7.1).
  NEARFIELD_RESULT_BLOCK_PRECISION = 30,
  // The base distance of a block is out of range (§7.1).
  NEARFIELD_RESULT_BLOCK_BASE = 31,
  // The section of grid parameters has the wrong length (§11.1).
  NEARFIELD_RESULT_GRID_LENGTH = 32,
  // A grid has fewer than two samples along an axis, or its sections hold too few (§11.1, §11.2).
  NEARFIELD_RESULT_GRID_RESOLUTION = 33,
  // The order or the reconstruction of a grid is unknown, or they do not go together (§11.1).
  NEARFIELD_RESULT_GRID_RECONSTRUCTION = 34,
  // The precision or the range of a grid is unknown, or they do not go together (§11.1).
  NEARFIELD_RESULT_GRID_PRECISION = 35,
  // The spacing or the distance quantum of a grid is out of range (§11.1).
  NEARFIELD_RESULT_GRID_SCALE = 36,
  // The box is not the one that the samples of a grid span (§11.1).
  NEARFIELD_RESULT_GRID_BOUNDS = 37,
  // A section of a grid is longer than its samples or bricks (§11.2).
  NEARFIELD_RESULT_GRID_SAMPLES = 38,
  // A gradient code is not one that a writer may write (§8).
  NEARFIELD_RESULT_GRADIENT_CODE = 39,
  // A floating-point component of a sample is not finite or too large (§8).
  NEARFIELD_RESULT_SAMPLE_VALUE = 40,
  // The bits of a shape are none or too many (§12.1).
  NEARFIELD_RESULT_SHAPE_BITS = 41,
  // The overlap is neither 0 nor in its range (§12.1).
  NEARFIELD_RESULT_OVERLAP = 42,
  // The section of root words is longer than the root grid (§12.2).
  NEARFIELD_RESULT_ROOT_LENGTH = 43,
  // A root word or a record names another record than its order does, or there are more records (§12.3).
  NEARFIELD_RESULT_RECORD_ORDER = 44,
  // A root word or a record names another byte for a leaf than its order does (§12.3).
  NEARFIELD_RESULT_LEAF_ORDER = 45,
  // A leaf is too long, or the section of leaves is not as long as they and the padding (§12.5).
  NEARFIELD_RESULT_LEAF_LENGTH = 46,
  // A leaf names a shape that there is not (§12.5).
  NEARFIELD_RESULT_LEAF_SHAPE = 47,
  // The kind, a degree, a width or the exponent of a shape is out of range (§12.4).
  NEARFIELD_RESULT_SHAPE = 48,
  // The shapes are too many or not in ascending order (§12.4).
  NEARFIELD_RESULT_SHAPE_ORDER = 49,
  // Leaves that overlap touch at levels too far apart (§12.6).
  NEARFIELD_RESULT_LEVELS_APART = 50,
  // The support or the reach of a leaf is not what the tree makes it (§12.6).
  NEARFIELD_RESULT_OVERLAP_CODES = 51,
  // The levels of detail are none, too many, or do not tile their section (§4.2).
  NEARFIELD_RESULT_LOD_LENGTH = 52,
  // A level of detail is of another family or diagonal, or has levels of its own (§4.2).
  NEARFIELD_RESULT_LOD_HEADER = 53,
  // A level of detail is not coarser than the next (§4.2).
  NEARFIELD_RESULT_LOD_ORDER = 54,
  // A pointer is NULL that may not be.
  NEARFIELD_RESULT_NULL = 256,
  // The handle of the field is not open.
  NEARFIELD_RESULT_NOT_OPEN = 257,
  // The bytes break a rule that this interface has no number for.
  NEARFIELD_RESULT_OTHER = 258,
  // A placement is not a rotation or reflection with a uniform scale.
  NEARFIELD_RESULT_NOT_A_SIMILARITY = 259,
  // The field has no such level of detail, or it is damaged.
  NEARFIELD_RESULT_NO_LOD = 260,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum NearfieldResult NearfieldResult;
#else
typedef int32_t NearfieldResult;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// What became of a ray.
enum NearfieldRayEnd
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // The ray left the box or ended first; or it is not finite, has no direction, or the handle is not open.
  NEARFIELD_RAY_END_MISS = 0,
  // It met the surface.
  NEARFIELD_RAY_END_HIT = 1,
  // It grazed the surface for longer than its 512 steps: clear up to `distance`.
  NEARFIELD_RAY_END_OUT_OF_STEPS = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum NearfieldRayEnd NearfieldRayEnd;
#else
typedef int32_t NearfieldRayEnd;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// A field that is open for queries. 256 bytes, on every machine; the members are the library's.
typedef struct NearfieldField {
  uint64_t is_open;
  uint64_t reader[31];
} NearfieldField;

// Which files the library reads.
typedef struct NearfieldFormat {
  // Major version that a file must have.
  uint16_t major;
  // Newest minor version that is read; so is every one before.
  uint16_t newest_minor;
} NearfieldFormat;

// A point, direction or gradient.
typedef struct NearfieldVector {
  // Along the x axis of the mesh.
  float x;
  // Along its y axis.
  float y;
  // Along its z axis.
  float z;
} NearfieldVector;

// Errors measured over a set of points: mesh units, finite, at least 0.
typedef struct NearfieldErrors {
  // Root mean square error.
  float rmse;
  // 99th percentile of the absolute error.
  float p99;
  // Largest absolute error.
  float max;
} NearfieldErrors;

// What a field is and how wrong it was found to be when it was baked.
typedef struct NearfieldInfo {
  // Least corner of the box, mesh units, mesh frame.
  struct NearfieldVector box_min;
  // Greatest corner of the box.
  struct NearfieldVector box_max;
  // Diagonal of the mesh's bounding box, mesh units.
  float diagonal;
  // Error that the baker was asked for, mesh units.
  float target_error;
  // Upper bound of the slope of the field inside the box.
  float lipschitz;
  // Largest error measured anywhere, mesh units: infinite if nothing was measured.
  float max_error;
  // Errors over points spread evenly over the mesh's bounding box.
  struct NearfieldErrors uniform;
  // Errors over points within 1 % of the diagonal of the surface.
  struct NearfieldErrors band;
  // Largest jump of the value across a face between leaves, mesh units.
  float seam_max;
  // Points measured, uniform and again in the band; 0 when nothing was measured.
  uint32_t sample_count;
  // Measured points whose sign nothing could vouch for.
  uint32_t doubtful_signs;
  // Minor version of the file's format.
  uint16_t format_minor;
  // Major, minor and patch version of the baker.
  uint16_t baker_version[3];
  // Hash of the mesh that was baked.
  uint8_t mesh_hash[16];
  // Hash of the settings that it was baked with.
  uint8_t settings_hash[8];
} NearfieldInfo;

// A distance and its gradient.
typedef struct NearfieldSample {
  // Signed distance, mesh units, negative inside.
  float distance;
  // Where the distance grows and how fast; its length is near 1, but not normalized.
  struct NearfieldVector gradient;
} NearfieldSample;

// Bounds of a field over a box, mesh units.
typedef struct NearfieldRange {
  // No value in the box is less.
  float min;
  // No value in the box is greater.
  float max;
} NearfieldRange;

// Answers queries that are near one another faster: a ray's steps, a particle's path, the points of a row. It remembers the
// leaf of the last query. 1024 bytes, on every machine; the members are the library's. It borrows the bytes, not the handle
// of the field.
typedef struct NearfieldCursor {
  uint64_t is_open;
  uint64_t reader[127];
} NearfieldCursor;

// The end of a ray.
typedef struct NearfieldRayHit {
  // What became of it.
  NearfieldRayEnd end;
  // Queries that it took, at most 512.
  uint32_t steps;
  // Along the ray from its origin, mesh units; of a miss 0.
  float distance;
  // On the ray, inside the box; of a hit alone, else 0.
  struct NearfieldVector point;
  // Unit gradient at the point, or zero where the field has none; of a hit alone, else 0.
  struct NearfieldVector normal;
} NearfieldRayHit;

// Where a ray starts, where it goes, and how far.
typedef struct NearfieldRay {
  // Mesh units, mesh frame.
  struct NearfieldVector origin;
  // Of any length but 0.
  struct NearfieldVector direction;
  // Mesh units; may be infinite.
  float length;
  // The ray ends where the field is at most so much, mesh units: the largest measured error to stop before the true
  // surface, 0 to stop on that of the field. No less than 2^-20 of the box's longest side counts.
  float within;
} NearfieldRay;

// The end of a descent to the surface.
typedef struct NearfieldClosestPoint {
  // Inside the box; mesh units, mesh frame.
  struct NearfieldVector point;
  // The field there, mesh units: how far the descent stayed from the surface.
  float residual;
  // Queries that it took, at most 16.
  uint32_t steps;
} NearfieldClosestPoint;

// Where a field is in a world: its point (x, y, z) is at x times `x_axis`, y times `y_axis` and z times `z_axis` from `origin`.
//
// The axes are at right angles and equally long, within 1e-4 of that length: it is the scale, from 2^-20 to 2^20. They may
// be left-handed, which mirrors the field. No factor turns the distances of a stretched field into the world's: bake the
// stretched mesh instead.
typedef struct NearfieldPlacement {
  // Where the x axis of the mesh points.
  struct NearfieldVector x_axis;
  // Its y axis.
  struct NearfieldVector y_axis;
  // Its z axis.
  struct NearfieldVector z_axis;
  // Where its origin is, in the units of the world.
  struct NearfieldVector origin;
} NearfieldPlacement;

// A field that was moved, turned, mirrored or uniformly scaled. 384 bytes, on every machine; the members are the library's. It
// borrows the bytes of the field, not its handle.
typedef struct NearfieldInstance {
  uint64_t is_open;
  uint64_t reader[47];
} NearfieldInstance;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// A result in words, zero-terminated, for ever. Never NULL, whatever the number.
const char *nearfield_result_text(int32_t result);

// Opens the field in `length` bytes, in constant time, after checking its header and parameters.
//
// The handle keeps a pointer to the bytes. `bytes` may be NULL if `length` is 0. Unless it succeeds the handle is not
// open. NEARFIELD_RESULT_NULL if `field` is NULL, or `bytes` is and `length` is not 0.
//
// # Safety
//
// `bytes` points to `length` bytes that stay as they are while the handle is in use, and `field` to memory for a handle.
NearfieldResult nearfield_open(struct NearfieldField *field,
                               const void *bytes,
                               size_t length);

// Opens the finest level of detail that is whole in the first `length` bytes of a file, or the field itself once these are
// all its bytes: what a program can ask while the rest still arrives.
//
// As nearfield_open; NEARFIELD_RESULT_TRUNCATED while there is none yet.
//
// # Safety
//
// As of nearfield_open.
NearfieldResult nearfield_open_prefix(struct NearfieldField *field,
                                      const void *bytes,
                                      size_t length);

// Checks every byte of the field against the format, in time proportional to the file and without memory.
//
// NEARFIELD_RESULT_NOT_OPEN if the handle is not open.
NearfieldResult nearfield_validate(const struct NearfieldField *field);

// How many levels of detail there are, the field itself among them: at least 1, but 0 if the handle is not open.
size_t nearfield_lod_count(const struct NearfieldField *field);

// Opens a level of detail of an open field: 0 is the field itself, 1 the next coarser, and so on.
//
// A level is a field of its own, in the same bytes: with every function, its own box and its own errors. Ask for it once,
// then query it. `lod` and `field` may be the same handle. Unless it succeeds `lod` is not open. NEARFIELD_RESULT_NULL if
// `lod` is NULL, NEARFIELD_RESULT_NOT_OPEN if `field` is not open, NEARFIELD_RESULT_NO_LOD if there is no such level.
//
// # Safety
//
// `lod` points to memory for a handle, and `field` to a handle; either may be NULL.
NearfieldResult nearfield_lod(struct NearfieldField *lod,
                              const struct NearfieldField *field,
                              size_t level);

// NEARFIELD_ABI_VERSION of the library.
uint32_t nearfield_abi_version(void);

// Which files the library reads.
struct NearfieldFormat nearfield_format(void);

// What a field is. All zero if the handle is not open.
struct NearfieldInfo nearfield_info(const struct NearfieldField *field);

// Signed distance from a point to the surface: mesh units, negative inside.
//
// Finite for every finite point. Outside the box of the field it is the distance at the nearest point of the box plus the
// distance to that point, an upper bound. NaN if a coordinate is NaN, infinite if one is infinite.
float nearfield_distance(const struct NearfieldField *field,
                         struct NearfieldVector point);

// Signed distance, as nearfield_distance to the bit, and gradient.
//
// Inside the box the gradient is the derivative of the reconstruction, outside it the unit vector from the nearest point of
// the box. NaN in all components if a coordinate is NaN.
struct NearfieldSample nearfield_distance_and_gradient(const struct NearfieldField *field,
                                                       struct NearfieldVector point);

// Unit vector along the gradient at a point, or zero where there is none. NaN if a coordinate is.
struct NearfieldVector nearfield_normal(const struct NearfieldField *field, struct NearfieldVector point);

// How far a point is at least from the true surface, mesh units, as far as the measured errors go: the distance less the
// largest of them. At most 0 where nothing is known, negative inside, never NaN; -INFINITY if the handle is not open.
//
// Errors are measured at points when a field is baked: nothing is proved.
float nearfield_clearance(const struct NearfieldField *field,
                          struct NearfieldVector point);

// Whether the clearance at a point exceeds `radius`, mesh units. False if the handle is not open.
bool nearfield_is_clear(const struct NearfieldField *field, struct NearfieldVector centre, float radius);

// Bounds of the field over the box from `min` to `max`, mesh units. Takes 64 queries.
//
// Holds for a continuous field; one without continuity may exceed it by `seam_max`. Infinite both ways unless the corners are
// finite and in order, and if the handle is not open.
struct NearfieldRange nearfield_range(const struct NearfieldField *field,
                                      struct NearfieldVector min,
                                      struct NearfieldVector max);

// nearfield_distance at `count` points. Returns how many answers were written: `count`, or 0 if the handle is not open or a
// pointer is NULL.
//
// A point is three floats in a row, x, y, z; `point_stride` is the number of bytes from one to the next, 12 where there is
// nothing between them, and likewise `distance_stride`, 4. No alignment is required. Answers may go into the records of
// their own points, beside or over them: a point is read before its answer is written, in order.
//
// # Safety
//
// There are `count` points and room for as many distances at these strides.
size_t nearfield_distances(const struct NearfieldField *field,
                           const float *points,
                           size_t point_stride,
                           float *distances,
                           size_t distance_stride,
                           size_t count);

// nearfield_distance_and_gradient at `count` points. Returns how many answers were written, as nearfield_distances.
//
// Strides as there; a gradient is three floats in a row.
//
// # Safety
//
// There are `count` points and room for as many distances and gradients at these strides.
size_t nearfield_distances_and_gradients(const struct NearfieldField *field,
                                         const float *points,
                                         size_t point_stride,
                                         float *distances,
                                         size_t distance_stride,
                                         float *gradients,
                                         size_t gradient_stride,
                                         size_t count);

// Makes a cursor of a field. Nothing happens if `cursor` is NULL; unless the field is open, neither is the cursor.
void nearfield_cursor(const struct NearfieldField *field,
                      struct NearfieldCursor *cursor);

// nearfield_distance, to the bit.
float nearfield_cursor_distance(struct NearfieldCursor *cursor, struct NearfieldVector point);

// nearfield_distance_and_gradient, to the bit.
struct NearfieldSample nearfield_cursor_distance_and_gradient(struct NearfieldCursor *cursor,
                                                              struct NearfieldVector point);

// Follows a ray to the surface, inside the box of the field, with at most 512 queries.
//
// No step is longer than the field divided by its stored bound of the slope: on a continuous field the ray passes no wall,
// however thin, but for the rounding of a coordinate. A field that was baked without continuity has no such guarantee.
struct NearfieldRayHit nearfield_raycast(const struct NearfieldField *field,
                                         struct NearfieldRay ray);

// Goes down the gradient to the surface, with at most 16 queries.
//
// The end is inside the box and no farther from the surface than the start. That it is the closest point is not promised.
// NaN and 0 steps if the handle is not open.
struct NearfieldClosestPoint nearfield_closest_point(const struct NearfieldField *field,
                                                     struct NearfieldVector point);

// Places a field in a world. To move it, place it again: it takes a few dozen operations.
//
// Unless it succeeds the instance is not open. NEARFIELD_RESULT_NULL if `instance` is NULL, NEARFIELD_RESULT_NOT_OPEN if the
// field is not open, NEARFIELD_RESULT_NOT_A_SIMILARITY if the axes are not as they should be or a number is not finite.
NearfieldResult nearfield_instance(const struct NearfieldField *field,
                                   struct NearfieldPlacement placement,
                                   struct NearfieldInstance *instance);

// Signed distance from a point of the world to the surface of an instance, in the units of the world: nearfield_distance times
// the scale.
float nearfield_instance_distance(const struct NearfieldInstance *instance,
                                  struct NearfieldVector point);

// Signed distance, as nearfield_instance_distance to the bit, and gradient in the frame of the world.
struct NearfieldSample nearfield_instance_distance_and_gradient(const struct NearfieldInstance *instance,
                                                                struct NearfieldVector point);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* NEARFIELD_H */

/* What the library was built with. */
#if defined(__cplusplus)
static_assert(sizeof(NearfieldField) == 256 && sizeof(NearfieldCursor) == 1024 &&
              sizeof(NearfieldInstance) == 384, "handles of another size");
#elif __STDC_VERSION__ >= 201112L
_Static_assert(sizeof(NearfieldField) == 256 && sizeof(NearfieldCursor) == 1024 &&
              sizeof(NearfieldInstance) == 384, "handles of another size");
#endif
