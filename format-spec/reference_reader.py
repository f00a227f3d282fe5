#!/usr/bin/env python3
"""A reader of Nearfield files that was written from SPEC.md alone, in its order, for readers of SPEC.md.

It is slow and shares nothing with the reader of this repository, so that a mistake in one shows as a disagreement.
Section numbers refer to SPEC.md. Needs Python 3.9 and nothing else.

    reference_reader.py check FILE...                    one line a file: "valid", or the name of the rule it breaks (§13)
    reference_reader.py query FILE POINTS.f32 OUT.f32    three f32 a point; distance, gradient, what another reader may
                                                         differ by in the two: six f32 an answer; a number after
                                                         these is the level of detail (§4.2)
    reference_reader.py expect FILE...                   points and answers, as stored beside the vectors, in JSON
"""

import json
import math
import struct
import sys
from ctypes import c_float

# ---- §1.1 Numbers ----------------------------------------------------------------------------------------------------


class F32(float):
    """A binary32 number whose operations round to nearest, ties to even.

    Sums, products and quotients of two binary32 numbers in binary64 keep enough bits to be rounded twice.
    """

    __slots__ = ()

    def __new__(cls, value):
        return float.__new__(cls, c_float(value).value)

    def __add__(a, b):
        return F32(float.__add__(a, b))

    def __sub__(a, b):
        return F32(float.__sub__(a, b))

    def __mul__(a, b):
        return F32(float.__mul__(a, b))

    def __truediv__(a, b):
        return F32(float.__truediv__(a, b))

    def __rsub__(a, b):
        return F32(float.__rsub__(a, b))

    def __rtruediv__(a, b):
        return F32(float.__rtruediv__(a, b))

    def __neg__(a):
        return F32(float.__neg__(a))

    def __abs__(a):
        return F32(float.__abs__(a))

    __radd__ = __add__
    __rmul__ = __mul__


def from_bits(bits):
    return F32(struct.unpack("<f", struct.pack("<I", bits))[0])


def half(bits):
    return F32(struct.unpack("<e", struct.pack("<H", bits))[0])


# ---- §1.4 Limits -----------------------------------------------------------------------------------------------------

MAX_MAGNITUDE = 2.0**60
MIN_ROOT_EDGE = 2.0**-40
MIN_QUANTUM = 2.0**-80
BOX_TOLERANCE = 2.0**-20
MAX_SECTIONS = 16
MAX_LODS = 8
MAX_DEPTH = 16
MAX_LATTICE = 1048576
MIN_BASE = -134217728
MAX_BASE = 134213632
MAX_ORDER = 3
MIN_RESOLUTION = 2
BRICK_EDGE = 4
MAX_ANISOTROPY = 1024
MAX_SHAPE_BITS = 10
MIN_OVERLAP = 2.0**-6
MAX_OVERLAP = 2.0**-2
MAX_DEGREE = 3
MAX_EXPONENT = 15
MAX_CONSTANT_BITS = 24
MAX_COEFFICIENT_BITS = 16
MAX_LEVELS_APART = 5
MAX_LENGTH = 40
PADDING = 72
LARGEST = F32(3.4028234663852886e38)
NAN = float("nan")

AXES = range(3)


class Invalid(Exception):
    """A rule that a file breaks, by its name in §13."""


def require(condition, rule):
    if not condition:
        raise Invalid(rule)


# ---- §4.1 CRC-32C ----------------------------------------------------------------------------------------------------

CRC_TABLE = []
for index in range(256):
    for _ in range(8):
        index = index >> 1 ^ (0x82F63B78 if index & 1 else 0)
    CRC_TABLE.append(index)


def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc = CRC_TABLE[(crc ^ byte) & 0xFF] ^ crc >> 8
    return crc ^ 0xFFFFFFFF


assert crc32c(b"123456789") == 0xE3069283

# ---- §2 to §4 The container ------------------------------------------------------------------------------------------

HEADER_LENGTH = 128
ENTRY_LENGTH = 16
MAGIC = bytes([0x89, 0x4E, 0x46, 0x44, 0x0D, 0x0A, 0x1A, 0x0A])
SIGN_METHODS = {0, 1, 2, 3, 4}


def open_field(data):
    """Opens a file (§1.5): the field that it holds, which answers queries."""
    sections, bounds, family = read_container(data)
    require(family in FAMILIES, "Family")
    field = FAMILIES[family](sections, *bounds)
    field.header = data[:HEADER_LENGTH]
    return field


def read_container(data):
    """The sections by kind, each with its bytes and its checksum, the corners of the box, and the family."""
    # What says that the rest can be read.
    require(len(data) >= HEADER_LENGTH, "Truncated")
    require(data[:8] == MAGIC, "Magic")
    major, minor, length = struct.unpack_from("<HHI", data, 8)
    require((major, minor) == (1, 0), "Version")
    require(length == len(data), "FileLength")
    family, sign_method, count, reserved, checksum = struct.unpack_from("<BBBBI", data, 16)
    table_end = HEADER_LENGTH + count * ENTRY_LENGTH
    require(count <= MAX_SECTIONS, "SectionTable")
    require(len(data) >= table_end, "Truncated")
    require(crc32c(data[:20] + bytes(4) + data[24:table_end]) == checksum, "HeaderChecksum")

    # §3.5 to §3.9
    require(reserved == 0, "Reserved")
    require(family in FAMILIES, "Family")
    require(sign_method in SIGN_METHODS, "SignMethod")
    numbers = [F32(number) for number in struct.unpack_from("<16f", data, 24)]
    box_min, box_max, quantities, contract = numbers[:3], numbers[3:6], numbers[6:9], numbers[9:]
    require(all(abs(x) <= MAX_MAGNITUDE for x in box_min + box_max), "Bounds")
    require(all(box_min[axis] < box_max[axis] for axis in AXES), "Bounds")
    require(all(0 <= x <= MAX_MAGNITUDE for x in quantities + contract), "Quantity")
    for rmse, p99, most in (contract[0:3], contract[3:6]):
        require(rmse <= most and p99 <= most, "Contract")

    # §4
    sections, end = {}, table_end
    for entry in range(HEADER_LENGTH, table_end, ENTRY_LENGTH):
        kind, offset, length, checksum = struct.unpack_from("<4sIII", data, entry)
        require(offset == end and length % 4 == 0, "SectionTable")
        end = offset + length
        require(end <= len(data), "SectionTable")
        require(kind not in sections, "SectionDuplicate")
        sections[kind] = (data[offset:end], checksum)
    require(end == len(data), "SectionTable")
    return sections, (box_min, box_max), family


# ---- §4.2 Levels of detail -------------------------------------------------------------------------------------------


def levels_of(field):
    """The bytes of each level, from level 1 to the coarsest."""
    data, levels = field.sections.get(b"LODS", (b"", 0))[0], []
    while data:
        require(len(data) >= HEADER_LENGTH and len(levels) < MAX_LODS, "LodLength")
        (length,) = struct.unpack_from("<I", data, 12)
        require(HEADER_LENGTH <= length <= len(data), "LodLength")
        levels.insert(0, data[:length])
        data = data[length:]
    return levels


def validate(field):
    """All that makes a file valid."""
    field.validate()
    if b"LODS" not in field.sections:
        return
    levels = [open_field(data) for data in levels_of(field)]
    require(levels, "LodLength")
    for finer, level in zip([field] + levels, levels):
        level.validate()
        same = level.header[16] == field.header[16] and level.header[48:52] == field.header[48:52]
        require(same and b"LODS" not in level.sections, "LodHeader")
        targets = [struct.unpack_from("<f", each.header, 52)[0] for each in (finer, level)]
        require(targets[0] < targets[1], "LodOrder")


# ---- §9 Queries of either family -------------------------------------------------------------------------------------


class Field:
    """A field in a box. Families give `inside`, the answer at a point of the box, and `magnitude_at`, M and L of §9."""

    # Times M, and times M / L.
    distance_tolerance, gradient_tolerance = 2.0**-19, 2.0**-16

    def distance_and_gradient(self, point):
        p = [F32(x) for x in point]
        if any(map(math.isnan, p)):
            return NAN, [NAN] * 3
        if any(map(math.isinf, p)):
            d = [math.copysign(1.0, x) if math.isinf(x) else 0.0 for x in p]
            return math.inf, [F32(x / math.hypot(*d)) for x in d]
        c = self.nearest_in_box(p)
        value, gradient = self.inside(c)
        if c == p:
            return value, gradient
        # Wider numbers neither overflow nor underflow here.
        beyond = [float(p[axis]) - float(c[axis]) for axis in AXES]
        length = math.hypot(*beyond)
        return F32(min(float(value) + length, LARGEST)), [F32(x / length) for x in beyond]

    def nearest_in_box(self, p):
        return [min(max(p[axis], self.box_min[axis]), self.box_max[axis]) for axis in AXES]

    def tolerances(self, point):
        """What another reader may differ by, in the distance and in each component of the gradient."""
        if not all(map(math.isfinite, point)):
            return 0.0, 2.0**-20
        c = self.nearest_in_box(point)
        largest, edge = self.magnitude_at(c)
        length = math.dist(point, c)
        if length > 0:
            return self.distance_tolerance * (largest + length), 2.0**-20
        return self.distance_tolerance * largest, self.gradient_tolerance * largest / edge

    def check_checksums(self):
        for contents, checksum in self.sections.values():
            require(crc32c(contents) == checksum, "SectionChecksum")

    def check_box(self, counts, edges, rule):
        """The box against so many edges along each axis, §5.4, §11.1."""
        for axis in AXES:
            extent = F32(counts[axis]) * edges[axis]
            total = self.box_min[axis] + extent
            largest = max(extent, abs(self.box_min[axis]), abs(self.box_max[axis]))
            require(abs(self.box_max[axis] - total) <= BOX_TOLERANCE * largest, rule)


# ---- §5 Octree parameters --------------------------------------------------------------------------------------------

TRILINEAR, TRICUBIC = 0, 1
CONTINUITIES = {0, 1, 2}
INNER, LEAF = 0, 1
PACKED32, F16, FULL_F32 = 0, 1, 2


class Octree(Field):
    """The octree family, §5 to §8."""

    def __init__(self, sections, box_min, box_max):
        for kind in (b"OCTR", b"NODE", b"SAMP"):
            require(kind in sections, "SectionMissing")
        self.sections, self.box_min, self.box_max = sections, box_min, box_max
        parameters, checksum = sections[b"OCTR"]
        require(len(parameters) == 24, "OctreeLength")
        require(crc32c(parameters) == checksum, "SectionChecksum")

        *self.root_cells, self.depth, self.interpolant, continuity = struct.unpack_from("<3H3B", parameters)
        root_edge, quantum, self.leaf_count = struct.unpack_from("<ffI", parameters, 12)
        self.root_edge, self.quantum = F32(root_edge), F32(quantum)
        require(not any(parameters[9:12]), "Reserved")
        require(self.depth <= MAX_DEPTH, "OctreeLattice")
        require(all(1 <= n <= MAX_LATTICE >> self.depth for n in self.root_cells), "OctreeLattice")
        require(self.interpolant in (TRILINEAR, TRICUBIC), "Interpolant")
        require(continuity in CONTINUITIES, "Continuity")
        require(MIN_ROOT_EDGE <= self.root_edge <= MAX_MAGNITUDE, "OctreeScale")
        require(MIN_QUANTUM <= self.quantum <= self.root_edge, "OctreeScale")
        self.check_box(self.root_cells, [self.root_edge] * 3, "OctreeBounds")

        self.nodes, self.samples = (words(sections[kind][0]) for kind in (b"NODE", b"SAMP"))
        self.root_count = math.prod(self.root_cells)
        groups = len(self.nodes) - self.root_count
        require(groups >= 0 and groups % 8 == 0, "NodeLength")

    # ---- §6 to §8: validation ----

    def validate(self):
        self.check_checksums()
        next_block = 0
        for level, child_words in self.check_nodes():
            next_block = self.check_leaves(level, child_words, next_block)
        require(next_block == len(self.samples), "BlockOrder")

    def check_nodes(self):
        """§6.1: the level and the words of each root cell, one a list, and of each group of children."""
        levels = [0] * self.root_count
        sets, leaf_count, inner_count = [], 0, 0
        for index, word in enumerate(self.nodes):
            offset, tag = word & 0xFFFFFFF, word >> 28
            require(tag in (INNER, LEAF), "NodeTag")
            # Of a group that no inner word before it refers to, nothing is known.
            require(index < len(levels), "NodeOrder")
            if tag == LEAF:
                leaf_count += 1
            else:
                require(offset == self.root_count + 8 * inner_count, "NodeOrder")
                require(levels[index] < self.depth, "NodeDepth")
                levels.extend([levels[index] + 1] * 8)
                inner_count += 1
        require(len(levels) == len(self.nodes), "NodeOrder")
        require(leaf_count == self.leaf_count, "LeafCount")

        for index in range(self.root_count):
            sets.append((0, self.nodes[index : index + 1]))
        for index in range(self.root_count, len(self.nodes), 8):
            sets.append((levels[index], self.nodes[index : index + 8]))
        return sets

    def check_leaves(self, level, child_words, start):
        """§7, §8: the leaves of one group, whose block starts at the word `start`. Answers where the next one does."""
        leaves = [(child, word & 0xFFFFFFF) for child, word in enumerate(child_words) if word >> 28 == LEAF]
        if not leaves:
            return start
        require(all(block == start for _, block in leaves), "BlockOrder")
        require(start + 3 <= len(self.samples), "BlockOrder")
        block = Block(self, start)
        require(block.precision <= 2, "BlockPrecision")
        require(self.samples[start] >> 29 == 0 and self.samples[start + 1] >> 27 == 0, "Reserved")
        require(block.full & ~block.present == 0, "BlockFull")
        require(self.interpolant == TRICUBIC or block.full == 0, "BlockFull")
        if block.precision == FULL_F32:
            require(block.base == 0, "Reserved")
        require(MIN_BASE <= block.base <= MAX_BASE, "BlockBase")
        for child, _ in leaves:
            for i, j, k in CORNERS:
                place = ((child & 1) + i, (child >> 1 & 1) + j, (child >> 2) + k)
                require(block.has(place) or level > 0 and block.implies(place), "BlockPresent")
        end = start + block.length()
        require(end <= len(self.samples), "BlockOrder")
        block.check_samples()
        return end

    # ---- §9 Queries ----

    def locate(self, c):
        """§9.2: the block's first word, the level, the octant in the parent, the local coordinates."""
        shift = self.depth
        n = [cells << self.depth for cells in self.root_cells]
        scale = F32(2**self.depth) / self.root_edge
        q = [min((c[axis] - self.box_min[axis]) * scale, F32(n[axis])) for axis in AXES]
        i = [min(math.floor(q[axis]), n[axis] - 1) for axis in AXES]
        root = [x >> shift for x in i]
        index = root[0] + self.root_cells[0] * (root[1] + self.root_cells[1] * root[2])
        child = (0, 0, 0)
        while self.nodes[index] >> 28 == INNER and shift > 0:
            shift -= 1
            child = tuple(x >> shift & 1 for x in i)
            index = (self.nodes[index] & 0xFFFFFFF) + (child[0] | child[1] << 1 | child[2] << 2)
        u = [(q[axis] - F32(i[axis] >> shift << shift)) * F32(2.0**-shift) for axis in AXES]
        return self.nodes[index] & 0xFFFFFFF, self.depth - shift, child, u

    def leaf_at(self, c):
        """The derivatives at the corners of the leaf, its edge, and the local coordinates of the point."""
        start, level, octant, u = self.locate(c)
        edge = self.root_edge * 2.0**-level
        return Block(self, start).corners(octant, level, edge, self.quantum * 2.0**-level), edge, u

    def magnitude_at(self, c):
        corners, edge, _ = self.leaf_at(c)
        return max(abs(float(x)) for corner in corners.values() for x in corner), float(edge)

    def inside(self, c):
        corners, edge, u = self.leaf_at(c)
        weights = self.value_weights(u)
        value = interpolate(corners, weights)
        inverse = 1 / edge
        gradient = []
        for axis in AXES:
            along = list(weights)
            along[axis] = self.slope_weights(u[axis])
            gradient.append(interpolate(corners, along) * inverse)
        return value, gradient

    def value_weights(self, u):
        """§9.3, §9.4: along each axis v0, v1, s0, s1."""
        weights = []
        for t in u:
            if self.interpolant == TRILINEAR:
                weights.append((1 - t, t, F32(0), F32(0)))
            else:
                v1 = t * t * (3 - 2 * t)
                weights.append((1 - v1, v1, t * ((1 - t) * (1 - t)), -(t * t) * (1 - t)))
        return weights

    def slope_weights(self, t):
        if self.interpolant == TRILINEAR:
            return F32(-1), F32(1), F32(0), F32(0)
        v1 = 6 * t * (1 - t)
        return -v1, v1, (1 - t) * (1 - 3 * t), t * (3 * t - 2)


def words(data):
    return struct.unpack(f"<{len(data) // 4}I", data)


# ---- §7 Sample blocks ------------------------------------------------------------------------------------------------

CORNERS = [(i, j, k) for k in (0, 1) for j in (0, 1) for i in (0, 1)]

# Derivatives at a corner are lists of eight, indexed by the axes that they are taken along: bit 0 for x, 1 for y, 2 for z.
F, FX, FY, FXY, FZ, FXZ, FYZ, FXYZ = range(8)


class Block:
    """A sample block of an octree."""

    def __init__(self, octree, start):
        self.octree, self.samples, self.start = octree, octree.samples, start
        first, second, base = self.samples[start : start + 3]
        self.present, self.precision = first & 0x7FFFFFF, first >> 27 & 3
        self.full = second & 0x7FFFFFF
        self.base = base - (base >> 31 << 32)
        self.is_tricubic = octree.interpolant == TRICUBIC

    def has(self, place):
        return self.present >> bit_number(place) & 1 == 1

    def implies(self, place):
        """§7.3."""
        middles = [axis for axis in AXES if place[axis] == 1]
        if self.has(place) or len(middles) not in (1, 2):
            return False
        ends = [with_ends(place, middles, mask) for mask in range(2 ** len(middles))]
        edges = [with_ends(place, [axis], mask) for axis in middles for mask in range(2)] if len(middles) == 2 else []
        return all(map(self.has, ends)) and not any(map(self.has, edges))

    # ---- §7.2 Sample data ----

    def sample_words(self):
        """Words of a tricubic sample and of a full one."""
        return {PACKED32: (1, 4), F16: (2, 4), FULL_F32: (4, 8)}[self.precision]

    def length(self):
        """Words of the block."""
        count = self.present.bit_count() if hasattr(int, "bit_count") else bin(self.present).count("1")
        if self.is_tricubic:
            short, long = self.sample_words()
            return 3 + short * count + (long - short) * bin(self.full).count("1")
        return 3 + (count if self.precision == FULL_F32 else (count + 1) // 2)

    def sample_at(self, bit):
        """The words of a tricubic sample, or the code or word of a trilinear one, and whether it is full."""
        below = (1 << bit) - 1
        rank = bin(self.present & below).count("1")
        if self.is_tricubic:
            short, long = self.sample_words()
            at = self.start + 3 + rank * short + bin(self.full & below).count("1") * (long - short)
            is_full = self.full >> bit & 1 == 1
            return self.samples[at : at + (long if is_full else short)], is_full
        if self.precision == FULL_F32:
            return self.samples[self.start + 3 + rank], False
        return self.samples[self.start + 3 + rank // 2] >> 16 * (rank % 2) & 0xFFFF, False

    def check_samples(self):
        """§8: the codes and the numbers of every sample."""
        bits = [bit for bit in range(27) if self.present >> bit & 1]
        for bit in bits:
            data, is_full = self.sample_at(bit)
            if not self.is_tricubic:
                if self.precision == FULL_F32:
                    require(abs(from_bits(data)) <= MAX_MAGNITUDE, "SampleValue")
            elif self.precision == FULL_F32:
                require(all(abs(from_bits(word)) <= MAX_MAGNITUDE for word in data), "SampleValue")
            elif self.precision == PACKED32 and not is_full:
                require(data[0] & 0x3FF != 0x3FF and data[0] >> 10 & 0x3FF != 0x3FF, "GradientCode")
            else:
                require(all(math.isfinite(half(bits)) for bits in halves(data)[1:]), "SampleValue")
        if not self.is_tricubic and self.precision != FULL_F32 and len(bits) % 2 == 1:
            require(self.samples[self.start + self.length() - 1] >> 16 == 0, "Reserved")

    # ---- §8 Sample codec ----

    def decode(self, place, edge, q):
        """Distance and derivatives by the leaf's local coordinates of a sample."""
        data, is_full = self.sample_at(bit_number(place))
        if not self.is_tricubic:
            if self.precision == FULL_F32:
                return [from_bits(data)]
            return [F32(16 * self.base + data) * (q * 0.0625)]
        if self.precision == PACKED32 and not is_full:
            distance = F32(self.base + (data[0] >> 20)) * q
            numbers = octahedral(data[0] & 0x3FF, data[0] >> 10 & 0x3FF)
        elif self.precision == FULL_F32:
            distance, *numbers = map(from_bits, data)
        else:
            code, *parts = halves(data)
            distance, numbers = F32(16 * self.base + code) * (q * 0.0625), [half(bits) for bits in parts]
        fx, fy, fz, fxy, fxz, fyz, fxyz = [x * edge for x in numbers] + [F32(0)] * (0 if is_full else 4)
        return [distance, fx, fy, fxy, fz, fxz, fyz, fxyz]

    def corners(self, octant, level, edge, q):
        """The derivatives at the eight corners of the leaf that is that octant of its parent."""
        decoded, implied = {}, []
        for corner in CORNERS:
            place = tuple(octant[axis] + corner[axis] for axis in AXES)
            if level > 0 and self.implies(place):
                implied.append((corner, place))
                place = tuple(2 * x for x in corner)
            decoded[corner] = self.decode(place, edge, q)

        for axis in AXES:
            for corner, place in implied:
                if place[axis] == 1:
                    near = decoded[corner[:axis] + (0,) + corner[axis + 1 :]]
                    far = decoded[corner[:axis] + (1,) + corner[axis + 1 :]]
                    decoded[corner] = self.middle(near, far, axis)
        return decoded

    def middle(self, near, far, axis):
        """§7.3: the middle of the cubic along an edge of the parent."""
        if not self.is_tricubic:
            return [0.5 * (near[0] + far[0])]
        result = [None] * 8
        for f in range(8):
            if not f >> axis & 1:
                slope = f | 1 << axis
                result[f] = 0.5 * (near[f] + far[f]) + 0.25 * (near[slope] - far[slope])
                result[slope] = 0.75 * (far[f] - near[f]) - 0.25 * (near[slope] + far[slope])
        return result


def bit_number(place):
    return place[0] + 3 * place[1] + 9 * place[2]


def with_ends(place, axes, mask):
    """The place with 0 or 2, as the bits of the mask say, along the axes."""
    changed = list(place)
    for number, axis in enumerate(axes):
        changed[axis] = 2 * (mask >> number & 1)
    return tuple(changed)


def halves(data):
    return [part for word in data for part in (word & 0xFFFF, word >> 16)]


# ---- §8.3 Octahedral code --------------------------------------------------------------------------------------------

STEP = from_bits(0x3B004020)
SEED = [F32(x) for x in (2.8898656, 4.8495786, 4.646499, 1.6896812)]


def octahedral(code_x, code_y):
    x = F32(code_x - 511) * STEP
    y = F32(code_y - 511) * STEP
    z = 1 - abs(x) - abs(y)
    t = -z if z < 0 else F32(0)
    x = x - math.copysign(t, x)
    y = y - math.copysign(t, y)
    r = rsqrt(x * x + y * y + z * z)
    return [x * r, y * r, z * r]


def rsqrt(s):
    seed = SEED[0] - s * (SEED[1] - s * (SEED[2] - s * SEED[3]))
    h = 0.5 * s
    coarse = seed * (1.5 - h * (seed * seed))
    return coarse + coarse * (0.5 - h * (coarse * coarse))


# ---- §9.3 Interpolation ----------------------------------------------------------------------------------------------


def blend(weights, a0, a1, b0, b1):
    v0, v1, s0, s1 = weights
    return (a0 * v0 + a1 * v1) + (b0 * s0 + b1 * s1)


def interpolate(corners, weights):
    """The eight corners to one number: along x, then y, then z."""
    along_x, along_y, along_z = weights
    if len(corners[0, 0, 0]) == 1:
        zero = F32(0)
        edges = {(j, k): blend(along_x, *(corners[i, j, k][0] for i in (0, 1)), zero, zero) for j in (0, 1) for k in (0, 1)}
        sides = [blend(along_y, edges[0, k], edges[1, k], zero, zero) for k in (0, 1)]
        return blend(along_z, *sides, zero, zero)

    def along(weights, f, slope, low, high):
        return blend(weights, low[f], high[f], low[slope], high[slope])

    edges = {
        (j, k): {f: along(along_x, f, f | FX, corners[0, j, k], corners[1, j, k]) for f in (F, FY, FZ, FYZ)}
        for j in (0, 1)
        for k in (0, 1)
    }
    sides = [{f: along(along_y, f, f | FY, edges[0, k], edges[1, k]) for f in (F, FZ)} for k in (0, 1)]
    return along(along_z, F, FZ, *sides)


# ---- §11 Grids -------------------------------------------------------------------------------------------------------

RANGE_FILE, RANGE_BRICK = 0, 1
NEAREST, LINEAR, HALF, BLEND, HERMITE = range(5)

# §11.4: the orders that each reconstruction is for.
ORDERS = {NEAREST: (0, 1, 2, 3), LINEAR: (0, 1, 2, 3), HALF: (1, 2, 3), BLEND: (1, 2, 3), HERMITE: (1, 2)}

# §11.3: the powers of x, y and z of each coefficient, and how many of them a sample of each order has.
MONOMIALS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
MONOMIALS += [(2, 0, 0), (0, 2, 0), (0, 0, 2), (1, 1, 0), (1, 0, 1), (0, 1, 1)]
MONOMIALS += [(3, 0, 0), (0, 3, 0), (0, 0, 3), (2, 1, 0), (2, 0, 1)]
MONOMIALS += [(1, 2, 0), (1, 0, 2), (0, 2, 1), (0, 1, 2), (1, 1, 1)]
COEFFICIENTS = (1, 4, 10, 20)


class Grid(Field):
    """The grid family, §11."""

    distance_tolerance, gradient_tolerance = 2.0**-18, 2.0**-15

    def __init__(self, sections, box_min, box_max):
        for kind in (b"GRID", b"SAMP"):
            require(kind in sections, "SectionMissing")
        self.sections, self.box_min, self.box_max = sections, box_min, box_max
        parameters, checksum = sections[b"GRID"]
        require(len(parameters) == 28, "GridLength")
        require(crc32c(parameters) == checksum, "SectionChecksum")

        *self.resolution, self.order, self.reconstruction = struct.unpack_from("<3H2B", parameters)
        self.precision, self.range = parameters[8:10]
        *self.spacing, self.quantum = map(F32, struct.unpack_from("<4f", parameters, 12))
        require(not any(parameters[10:12]), "Reserved")
        require(all(n >= MIN_RESOLUTION for n in self.resolution), "GridResolution")
        require(self.order <= MAX_ORDER, "GridReconstruction")
        require(self.order in ORDERS.get(self.reconstruction, ()), "GridReconstruction")
        require(self.precision in (PACKED32, F16, FULL_F32), "GridPrecision")
        require(self.range in (RANGE_FILE, RANGE_BRICK), "GridPrecision")
        require(self.precision != FULL_F32 or self.range == RANGE_FILE, "GridPrecision")
        require(all(MIN_ROOT_EDGE <= edge <= MAX_MAGNITUDE for edge in self.spacing), "GridScale")
        require(float(max(self.spacing)) <= MAX_ANISOTROPY * float(min(self.spacing)), "GridScale")
        require(MIN_QUANTUM <= self.quantum <= MAX_MAGNITUDE, "GridScale")
        self.check_box([n - 1 for n in self.resolution], self.spacing, "GridBounds")

        self.samples, self.bases = words(sections[b"SAMP"][0]), ()
        require(len(self.samples) >= self.sample_words(), "GridResolution")
        if self.precision != FULL_F32:
            require(b"BASE" in sections, "SectionMissing")
            bases = sections[b"BASE"][0]
            self.bases = struct.unpack(f"<{len(bases) // 4}i", bases)
            require(len(self.bases) >= self.base_count(), "GridResolution")

    # ---- §11.2, §11.3: validation ----

    def validate(self):
        self.check_checksums()
        require(len(self.samples) == self.sample_words(), "GridSamples")
        if self.precision != FULL_F32:
            require(len(self.bases) == self.base_count(), "GridSamples")
            require(all(MIN_BASE <= base <= MAX_BASE for base in self.bases), "BlockBase")
        count = math.prod(self.resolution)
        for number in range(count):
            self.check_sample(number)
        if self.has_half_samples() and count % 2 == 1:
            require(self.samples[-1] >> 16 == 0, "Reserved")

    def check_sample(self, number):
        if self.has_half_samples():
            return
        data = self.sample_at(number)
        if self.precision == FULL_F32:
            require(all(abs(from_bits(word)) <= MAX_MAGNITUDE for word in data), "SampleValue")
            return
        if self.precision == PACKED32:
            require(data[0] & 0x3FF != 0x3FF and data[0] >> 10 & 0x3FF != 0x3FF, "GradientCode")
            parts = halves(data[1:])
        else:
            parts = halves(data)[1:]
        require(all(math.isfinite(half(bits)) for bits in parts), "SampleValue")

    def bricks(self):
        """Bricks along each axis."""
        return [1, 1, 1] if self.range == RANGE_FILE else [-(-n // BRICK_EDGE) for n in self.resolution]

    def base_count(self):
        return math.prod(self.bricks())

    def base_of(self, place):
        if self.range == RANGE_FILE:
            return self.bases[0]
        bricks = self.bricks()
        i, j, k = (x // BRICK_EDGE for x in place)
        return self.bases[i + bricks[0] * (j + bricks[1] * k)]

    # ---- §11.3 Samples ----

    def has_half_samples(self):
        """Whether a sample is half a word."""
        return self.order == 0 and self.precision != FULL_F32

    def words_each(self):
        """Words of a sample that is not half a word."""
        count = COEFFICIENTS[self.order]
        return {PACKED32: 1 + (count - 4) // 2, F16: count // 2, FULL_F32: count}[self.precision]

    def sample_words(self):
        count = math.prod(self.resolution)
        return (count + 1) // 2 if self.has_half_samples() else count * self.words_each()

    def sample_at(self, number):
        at = number * self.words_each()
        return self.samples[at : at + self.words_each()]

    def coefficients_at(self, place):
        """The coefficients of a sample by the local coordinates of a cell."""
        number = place[0] + self.resolution[0] * (place[1] + self.resolution[1] * place[2])
        if self.has_half_samples():
            code = self.samples[number // 2] >> 16 * (number % 2) & 0xFFFF
            return [self.distance_of(place, code)]

        data = self.sample_at(number)
        if self.precision == FULL_F32:
            distance, *numbers = map(from_bits, data)
        elif self.precision == F16:
            code, *parts = halves(data)
            distance, numbers = self.distance_of(place, code), [half(bits) for bits in parts]
        else:
            distance = self.distance_of(place, data[0] >> 20)
            numbers = octahedral(data[0] & 0x3FF, data[0] >> 10 & 0x3FF) + [half(bits) for bits in halves(data[1:])]
        return [distance] + [number * self.scale_of(powers) for number, powers in zip(numbers, MONOMIALS[1:])]

    def distance_of(self, place, code):
        # The bases of valid files are too small for the sum to wrap.
        return F32(self.base_of(place) + code) * self.quantum

    def scale_of(self, powers):
        first, *others = [axis for axis in AXES for _ in range(powers[axis])]
        scale = self.spacing[first]
        for axis in others:
            scale = scale * (self.spacing[axis] / max(self.spacing))
        return scale

    # ---- §11.4 Reconstruction ----

    def cell_at(self, c):
        """The coefficients of the eight samples around a point, and its local coordinates."""
        n, scale = self.resolution, [1 / edge for edge in self.spacing]
        q = [min((c[axis] - self.box_min[axis]) * scale[axis], F32(n[axis] - 1)) for axis in AXES]
        i = [min(math.floor(q[axis]), n[axis] - 2) for axis in AXES]
        u = [q[axis] - F32(i[axis]) for axis in AXES]
        return {corner: self.coefficients_at([i[axis] + corner[axis] for axis in AXES]) for corner in CORNERS}, u

    def magnitude_at(self, c):
        corners, _ = self.cell_at(c)
        return max(abs(float(x)) for corner in corners.values() for x in corner), float(min(self.spacing))

    def inside(self, c):
        corners, u = self.cell_at(c)
        values, slopes = zip(*map(self.factors, u))
        gradient = []
        for axis in AXES:
            along = list(values)
            along[axis] = slopes[axis]
            gradient.append(self.sum_of_terms(corners, along) * (1 / self.spacing[axis]))
        return self.sum_of_terms(corners, values), gradient

    def sum_of_terms(self, corners, factors):
        """Every reconstruction is a sum, over samples and coefficients, of products of one factor an axis."""
        total = F32(0)
        for corner, coefficients in corners.items():
            for coefficient, powers in zip(coefficients, MONOMIALS):
                x, y, z = (factors[axis][corner[axis]][powers[axis]] for axis in AXES)
                total = total + self.reduced(coefficient, sum(powers)) * (x * y * z)
        return total

    def reduced(self, coefficient, degree):
        if self.reconstruction != HALF:
            return coefficient
        return coefficient * (F32(self.order + 1 - degree) / F32(self.order + 1))

    def factors(self, t):
        """Along an axis: the factors for each end, 0 and 1, and each power; and their derivatives by t."""
        if self.reconstruction == HERMITE:
            return hermite_cubic(t) if self.order == 1 else hermite_quintic(t)
        weight, slope = self.weight(t)
        values, slopes = [], []
        for end, (w, dw) in enumerate([(1 - weight, -slope), (weight, slope)]):
            v = t - F32(end)
            powers = [F32(1), v, v * v, v * v * v]
            rates = [F32(0), F32(1), 2 * v, 3 * (v * v)]
            values.append([w * power for power in powers])
            slopes.append([dw * power + w * rate for power, rate in zip(powers, rates)])
        return values, slopes

    def weight(self, t):
        """Of the greater end of an axis, and its derivative."""
        if self.reconstruction == NEAREST:
            return F32(t >= 0.5), F32(0)
        if self.reconstruction in (LINEAR, HALF):
            return t, F32(1)
        if self.order == 1:
            return t * t * (3 - 2 * t), 6 * t * (1 - t)
        if self.order == 2:
            return t * t * t * (10 - t * (15 - 6 * t)), 30 * (t * (1 - t)) * (t * (1 - t))
        both = t * (1 - t)
        return (t * t) * (t * t) * (35 - t * (84 - t * (70 - 20 * t))), 140 * both * both * both


def hermite_cubic(t):
    """§9.3."""
    v1 = t * t * (3 - 2 * t)
    rate = 6 * t * (1 - t)
    values = [[1 - v1, t * ((1 - t) * (1 - t))], [v1, -(t * t) * (1 - t)]]
    return values, [[-rate, (1 - t) * (1 - 3 * t)], [rate, t * (3 * t - 2)]]


def hermite_quintic(t):
    o = 1 - t
    last = t * t * t * (10 - t * (15 - 6 * t))
    rate = 30 * (t * o) * (t * o)
    values = [
        [1 - last, t * (o * o * o) * (1 + 3 * t), t * t * (o * o * o)],
        [last, -(t * t * t) * o * (4 - 3 * t), t * t * t * (o * o)],
    ]
    slopes = [
        [-rate, o * o * (1 - 3 * t) * (1 + 5 * t), t * (o * o) * (2 - 5 * t)],
        [rate, -(t * t) * (2 - 3 * t) * (6 - 5 * t), t * t * o * (3 - 5 * t)],
    ]
    return values, slopes


# ---- §12 Polynomial octrees ------------------------------------------------------------------------------------------

SINGLE, MIN, MAX = 0, 1, 2

# §12.5: the degrees in x, y and z of the terms, by total degree.
TERMS = [
    [(0, 0, 0)],
    [(1, 0, 0), (0, 1, 0), (0, 0, 1)],
    [(2, 0, 0), (0, 2, 0), (0, 0, 2), (1, 1, 0), (0, 1, 1), (1, 0, 1)],
    [(3, 0, 0), (0, 3, 0), (0, 0, 3), (2, 1, 0), (0, 2, 1), (1, 0, 2), (2, 0, 1), (1, 2, 0), (0, 1, 2), (1, 1, 1)],
]

# The Legendre polynomials of degree 0 to 3, and their derivatives.
LEGENDRE = [
    (lambda t: 1.0, lambda t: 0.0),
    (lambda t: t, lambda t: 1.0),
    (lambda t: 0.5 * (3 * t * t - 1), lambda t: 3 * t),
    (lambda t: 0.5 * (5 * t * t * t - 3 * t), lambda t: 0.5 * (15 * t * t - 3)),
]


class Shape:
    """§12.4."""

    def __init__(self, data):
        self.kind, *self.degrees, self.exponent = data[:4]
        self.widths = data[4:]

    def check(self):
        require(self.kind in (SINGLE, MIN, MAX), "Shape")
        require(max(self.degrees) <= MAX_DEGREE and self.exponent <= MAX_EXPONENT, "Shape")
        require(self.kind != SINGLE or self.degrees[1] == 0, "Shape")
        for degree, width in enumerate(self.widths):
            most = MAX_COEFFICIENT_BITS if degree <= max(self.degrees) else 0
            require(width <= (most if degree > 0 else MAX_CONSTANT_BITS), "Shape")

    def polynomials(self):
        """For each polynomial, the terms and widths of its coefficients, in order."""
        degrees = self.degrees[:1] if self.kind == SINGLE else self.degrees
        return [
            [(term, self.widths[degree]) for degree in range(most + 1) for term in TERMS[degree]] for most in degrees
        ]


class Bits:
    """§12.5: a string of bits."""

    def __init__(self, data):
        self.bits, self.length, self.at = int.from_bytes(data, "little"), 8 * len(data), 0

    def take(self, width):
        value = self.bits >> self.at & (1 << width) - 1
        self.at += width
        return value


class PolynomialLeaf:
    """A leaf where it lies, in finest cells. Everything is summed in wider numbers than §12.7 asks for."""

    def __init__(self, octree, place, cell, edge):
        self.cell, self.edge = cell, edge
        bits = Bits(octree.leaves[place : place + PADDING])
        number = bits.take(octree.shape_bits)
        require(number < len(octree.shapes), "LeafShape")
        shape = octree.shapes[number]
        self.support, self.reach = (bits.take(2), bits.take(2)) if octree.overlap else (0, 0)
        step = float(octree.quantum) * 2.0**shape.exponent
        self.kind, self.polynomials = shape.kind, []
        for terms in shape.polynomials():
            codes = [(term, bits.take(width), width) for term, width in terms]
            self.polynomials.append([(term, (code - (1 << width >> 1)) * step) for term, code, width in codes])
        self.length = -(-bits.at // 8)
        require(self.length <= MAX_LENGTH and place + self.length + PADDING <= len(octree.leaves), "LeafLength")
        require(bits.take(8 * self.length - bits.at) == 0, "Reserved")

    def touches(self, other):
        return all(
            self.cell[axis] <= other.cell[axis] + other.edge and other.cell[axis] <= self.cell[axis] + self.edge
            for axis in AXES
        )

    def local(self, q):
        return [2 * (float(q[axis]) - self.cell[axis]) / self.edge - 1 for axis in AXES]

    def magnitude(self):
        return sum(abs(number) for polynomial in self.polynomials for _, number in polynomial)

    def answers(self, u):
        """Value and derivatives of each polynomial, the one that the leaf chooses first."""
        answers = [sum_of_products(polynomial, u) for polynomial in self.polynomials]
        return sorted(answers, key=lambda answer: answer[0], reverse=self.kind == MAX)

    def weight(self, u, overlap):
        """§12.7: the weight, and its derivatives by u."""
        delta = overlap * self.edge * 2.0**-self.support
        s = [min(max(0.5 + (1 - abs(t)) * self.edge / (4 * delta), 0.0), 1.0) for t in u]
        steps = [t * t * (3 - 2 * t) for t in s]
        slopes = [-math.copysign(6 * s[axis] * (1 - s[axis]) * self.edge / (4 * delta), u[axis]) for axis in AXES]
        return math.prod(steps), [slopes[axis] * steps[axis - 1] * steps[axis - 2] for axis in AXES]


def sum_of_products(polynomial, u):
    value, slopes = 0.0, [0.0] * 3
    for degrees, number in polynomial:
        values = [LEGENDRE[degrees[axis]][0](u[axis]) for axis in AXES]
        rates = [LEGENDRE[degrees[axis]][1](u[axis]) for axis in AXES]
        value += number * math.prod(values)
        for axis in AXES:
            slopes[axis] += number * rates[axis] * values[axis - 1] * values[axis - 2]
    return value, slopes


class PolynomialOctree(Field):
    """The family of polynomial octrees, §12. It knows all leaves once it is validated."""

    distance_tolerance, gradient_tolerance = 2.0**-16, 2.0**-14

    def __init__(self, sections, box_min, box_max):
        for kind in (b"PTRE", b"ROOT", b"SHPE", b"TREE", b"LEAF"):
            require(kind in sections, "SectionMissing")
        self.sections, self.box_min, self.box_max = sections, box_min, box_max
        parameters, checksum = sections[b"PTRE"]
        require(len(parameters) == 28, "OctreeLength")
        require(crc32c(parameters) == checksum, "SectionChecksum")

        *self.root_cells, self.depth, self.shape_bits, continuity = struct.unpack_from("<3H3B", parameters)
        *numbers, self.leaf_count = struct.unpack_from("<fffI", parameters, 12)
        self.root_edge, self.quantum, self.overlap = map(F32, numbers)
        require(not any(parameters[9:12]), "Reserved")
        require(self.depth <= MAX_DEPTH, "OctreeLattice")
        require(all(1 <= n <= MAX_LATTICE >> self.depth for n in self.root_cells), "OctreeLattice")
        require(MIN_ROOT_EDGE <= self.root_edge <= MAX_MAGNITUDE, "OctreeScale")
        require(MIN_QUANTUM <= self.quantum <= self.root_edge, "OctreeScale")
        self.roots, self.leaves = words(sections[b"ROOT"][0]), sections[b"LEAF"][0]
        require(len(self.roots) >= math.prod(self.root_cells), "NodeLength")
        self.check_box(self.root_cells, [self.root_edge] * 3, "OctreeBounds")
        require(1 <= self.shape_bits <= MAX_SHAPE_BITS, "ShapeBits")
        require(self.overlap == 0 or MIN_OVERLAP <= self.overlap <= MAX_OVERLAP, "Overlap")
        require(continuity == (0 if self.overlap == 0 else 2), "Continuity")
        self.overlap = float(self.overlap)

    # ---- §12.2 to §12.6: validation ----

    def validate(self):
        self.check_checksums()
        self.read_shapes()
        self.read_tree()
        if self.overlap:
            self.check_overlap()

    def read_shapes(self):
        data = self.sections[b"SHPE"][0]
        require(len(data) % 8 == 0 and len(data) // 8 <= 1 << self.shape_bits, "ShapeOrder")
        shapes = [data[at : at + 8] for at in range(0, len(data), 8)]
        require(all(a < b for a, b in zip(shapes, shapes[1:])), "ShapeOrder")
        self.shapes = [Shape(shape) for shape in shapes]
        for shape in self.shapes:
            shape.check()

    def read_tree(self):
        """§12.3: everything in the order of the file."""
        edge = 1 << self.depth
        require(len(self.roots) == math.prod(self.root_cells), "RootLength")
        nodes, self.all_leaves, self.next_place = [], [], 0
        for number, word in enumerate(self.roots):
            x, yz = number % self.root_cells[0], number // self.root_cells[0]
            cell = [part * edge for part in (x, yz % self.root_cells[1], yz // self.root_cells[1])]
            self.read_node(word >> 31 == 0, word & 0x7FFFFFFF, cell, edge, nodes)

        records = self.sections[b"TREE"][0]
        count = len(records) // 14
        for number in range(count):
            require(number < len(nodes), "RecordOrder")
            cell, edge = nodes[number]
            record = records[14 * number : 14 * number + 14]
            inner, first = record[0], int.from_bytes(record[8:], "little")
            child, leaf = first & (1 << 21) - 1, first >> 21
            require(child == len(nodes), "RecordOrder")
            require(leaf == self.next_place, "LeafOrder")
            half = edge // 2
            for octant in range(8):
                start = record[octant] if octant else 0
                is_inner = inner >> octant & 1 == 1
                corner = [cell[axis] + (octant >> axis & 1) * half for axis in AXES]
                self.read_node(is_inner, (child if is_inner else leaf) + start, corner, half, nodes)
        require(len(nodes) == count, "RecordOrder")
        require(not any(records[14 * count :]), "Reserved")
        require(len(self.leaves) == (self.next_place + PADDING + 3) // 4 * 4, "LeafLength")
        require(not any(self.leaves[self.next_place :]), "Reserved")
        require(len(self.all_leaves) == self.leaf_count, "LeafCount")

    def read_node(self, is_inner, number, cell, edge, nodes):
        if is_inner:
            require(edge > 1, "NodeDepth")
            require(number == len(nodes), "RecordOrder")
            nodes.append((cell, edge))
        else:
            require(number == self.next_place, "LeafOrder")
            self.all_leaves.append(PolynomialLeaf(self, number, cell, edge))
            self.next_place += self.all_leaves[-1].length

    def check_overlap(self):
        """§12.6."""
        for leaf in self.all_leaves:
            others = [other for other in self.all_leaves if other is not leaf and leaf.touches(other)]
            finest = min((other.edge for other in others), default=leaf.edge)
            require(leaf.edge <= finest << MAX_LEVELS_APART, "LevelsApart")
            apart = max(leaf.edge // finest, 1).bit_length() - 1
            require(leaf.support == min(apart, 3), "OverlapCodes")
            greatest = max((other.edge * 2.0**-other.support for other in others), default=0.0)
            reach = max(k if greatest <= leaf.edge * 2.0 ** (1 - k) else 0 for k in (0, 1, 2, 3))
            require(leaf.reach == reach, "OverlapCodes")

    # ---- §12.7 Queries ----

    def position(self, c):
        """§9.2."""
        scale = F32(2**self.depth) / self.root_edge
        n = [cells << self.depth for cells in self.root_cells]
        return [min((c[axis] - self.box_min[axis]) * scale, F32(n[axis])) for axis in AXES], n

    def weighted(self, c):
        """The leaves that have a say, each with local coordinates, weight and the derivatives of the weight."""
        q, n = self.position(c)
        found = []
        if self.overlap:
            for leaf in self.all_leaves:
                u = leaf.local(q)
                weight, slopes = leaf.weight(u, self.overlap)
                if weight > 0:
                    found.append((leaf, u, weight, slopes))
        else:
            i = [min(math.floor(q[axis]), n[axis] - 1) for axis in AXES]
            for leaf in self.all_leaves:
                if all(leaf.cell[axis] <= i[axis] < leaf.cell[axis] + leaf.edge for axis in AXES):
                    found.append((leaf, leaf.local(q), 1.0, [0.0] * 3))
        return found

    def inside(self, c):
        total, value, weight_slopes, sums = 0.0, 0.0, [0.0] * 3, [0.0] * 3
        for leaf, u, weight, slopes in self.weighted(c):
            f, rates = leaf.answers(u)[0]
            total, value = total + weight, value + weight * f
            for axis in AXES:
                weight_slopes[axis] += slopes[axis] / leaf.edge
                sums[axis] += (weight * rates[axis] + slopes[axis] * f) / leaf.edge
        value /= total
        per_unit = 2.0 ** (self.depth + 1) / float(self.root_edge)
        gradient = [(sums[axis] - value * weight_slopes[axis]) / total * per_unit for axis in AXES]
        return F32(value), [F32(part) for part in gradient]

    def magnitude_at(self, c):
        """M and E of §12.7; where a reader may take the gradient of either polynomial, an E of next to nothing."""
        found = self.weighted(c)
        largest = max(leaf.magnitude() for leaf, *_ in found)
        for leaf, u, *_ in found:
            answers = leaf.answers(u)
            if abs(answers[0][0] - answers[-1][0]) <= 2 * self.distance_tolerance * largest and len(answers) > 1:
                return largest, 2.0**-100
        edges = [leaf.edge * (self.overlap * 2.0**-leaf.support if self.overlap else 1) for leaf, *_ in found]
        return largest, min(edges) * float(self.root_edge) * 2.0**-self.depth


FAMILIES = {1: Grid, 2: Octree, 3: PolynomialOctree}

# ---- The command line ------------------------------------------------------------------------------------------------


def read_bytes(path):
    with open(path, "rb") as file:
        return file.read()


def verdict(path):
    try:
        validate(open_field(read_bytes(path)))
        return "valid"
    except Invalid as error:
        return str(error)


def query(field_path, points_path, out_path, level="0"):
    field = open_field(read_bytes(field_path))
    validate(field)
    if int(level) > 0:
        field = open_field(levels_of(field)[int(level) - 1])
        field.validate()
    with open(out_path, "wb") as out:
        for point in struct.iter_unpack("<3f", read_bytes(points_path)):
            distance, gradient = field.distance_and_gradient(point)
            out.write(struct.pack("<6f", distance, *gradient, *field.tolerances(point)))


def chosen_points(field):
    """Points that tell readers apart: corners, faces and insides of cells, outside, far outside, and no points at all."""
    low, high = field.box_min, field.box_max
    state = 1

    def between(axis, start=0.0, end=1.0):
        nonlocal state
        state = state * 6364136223846793005 + 1442695040888963407 & 0xFFFFFFFFFFFFFFFF
        t = start + (end - start) * (state >> 40) / 2**24
        return float(low[axis]) + t * (float(high[axis]) - float(low[axis]))

    yield [low[0], low[1], low[2]]
    yield [high[0], high[1], high[2]]
    yield [high[0], low[1], between(2)]
    for parts in (2, 4, 8):
        yield [float(low[axis]) + (float(high[axis]) - float(low[axis])) / parts for axis in AXES]
    for _ in range(24):
        yield [between(axis) for axis in AXES]
    # Near the least corner, where the deepest leaves of the vectors are.
    for power in range(2, 18, 3):
        yield [between(axis, 0.0, 0.5**power) for axis in AXES]
    for _ in range(4):
        yield [between(axis, -2.0, 3.0) for axis in AXES]
    yield [between(0), between(1), float(high[2]) * 4 + 1]
    yield [3.0e38, -3.0e38, 3.0e38]
    yield [math.inf, 0.0, -math.inf]
    yield [0.0, NAN, 0.0]


def expectation(path):
    """The answers at chosen points; what JSON cannot say is a string."""
    field = open_field(read_bytes(path))
    validate(field)

    def numbers(values):
        return [float(x) if math.isfinite(x) else str(float(x)) for x in values]

    lines = []
    for point in chosen_points(field):
        point = [F32(x) for x in point]
        distance, gradient = field.distance_and_gradient(point)
        tolerances = field.tolerances(point)
        answer = {"point": numbers(point), "distance": numbers([distance])[0], "gradient": numbers(gradient)}
        answer.update(distance_tolerance=tolerances[0], gradient_tolerance=tolerances[1])
        lines.append(json.dumps(answer))
    return "[\n" + ",\n".join(lines) + "\n]\n"


def main(arguments):
    command, *paths = arguments or [""]
    if command == "check" and paths:
        for path in paths:
            print(verdict(path), path)
    elif command == "query" and len(paths) in (3, 4):
        query(*paths)
    elif command == "expect" and paths:
        for path in paths:
            sys.stdout.write(expectation(path))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])
