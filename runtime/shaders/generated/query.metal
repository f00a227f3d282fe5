// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct _mslBufferSizes {
    uint size0;
    uint size1;
    uint size2;
};

typedef uint type_1[1];
struct Field {
    uint family;
    char _pad1[12];
    metal::float3 low;
    metal::float3 high;
    metal::uint3 counts;
    metal::uint3 cells;
    metal::float3 cells_per_unit;
    metal::packed_float3 spacing;
    float quantum;
    uint depth;
    uint reconstruction;
    uint order;
    uint sample_precision;
    uint range;
    uint shape_bits;
    float overlap;
    uint nodes;
    uint samples;
    uint shapes;
    uint records;
    char _pad19[4];
};
struct Answer {
    float distance;
    char _pad1[12];
    metal::float3 gradient;
};
struct Polynomial {
    float constant_;
    char _pad1[12];
    metal::float3 first;
    metal::float3 square;
    metal::float3 cross;
    metal::float3 cube;
    metal::float3 mixed;
    metal::packed_float3 more;
    float xyz;
};
struct type_10 {
    metal::float4 inner[8];
};
struct Corners {
    type_10 at;
};
struct Jet {
    metal::float4 plain;
    metal::float4 by_x;
};
struct type_11 {
    Jet inner[8];
};
struct Jets {
    type_11 corners;
};
struct type_12 {
    metal::float4 inner[4];
};
struct Face {
    type_12 corners;
};
struct Block {
    uint present;
    uint full;
    uint sample_precision;
    int base;
    uint first;
    float quantum;
    float edge;
};
struct Leaf {
    uint place;
    char _pad1[12];
    metal::packed_uint3 cell;
    uint shift;
};
struct LeafHead {
    uint kind_and_degrees;
    uint widths;
    uint support;
    uint reach;
};
struct Terms {
    metal::float4 linear;
    metal::float4 square;
    metal::float4 cross;
    metal::float4 cube;
    metal::float4 next;
    metal::float4 previous;
    uint end;
    char _pad7[12];
};
struct type_14 {
    uint inner[16];
};
typedef float type_15[1];
typedef metal::float4 type_16[1];
constant uint FAMILY_WORD = 4u;
constant uint FAMILY_BYTE = 0u;
constant uint BOX_MIN_WORD = 6u;
constant uint BOX_MAX_WORD = 9u;
constant uint SECTION_COUNT_WORD = 4u;
constant uint SECTION_COUNT_BYTE = 2u;
constant uint MAX_SECTIONS = 16u;
constant uint TABLE_WORD = 32u;
constant uint SECTION_WORDS = 4u;
constant uint SECTION_OCTREE = 1381253967u;
constant uint FAMILY_OCTREE = 2u;
constant uint SECTION_GRID = 1145655879u;
constant uint FAMILY_GRID = 1u;
constant uint SECTION_POLYNOMIAL = 1163023440u;
constant uint FAMILY_POLYNOMIAL = 3u;
constant uint SECTION_NODES = 1162104654u;
constant uint SECTION_BASES = 1163084098u;
constant uint SECTION_ROOTS = 1414483794u;
constant uint SECTION_SAMPLES = 1347240275u;
constant uint SECTION_LEAVES = 1178682700u;
constant uint SECTION_SHAPES = 1162889299u;
constant uint SECTION_RECORDS = 1162170964u;
constant uint MAX_DEPTH = 16u;
constant uint LIPSCHITZ_WORD = 14u;
constant uint SAMPLE_COUNT_WORD = 22u;
constant uint UNIFORM_MAX_WORD = 17u;
constant uint BAND_MAX_WORD = 20u;
constant float MAX_FLOAT = 340282350000000000000000000000000000000.0;
constant uint RECONSTRUCTION_NEAREST = 0u;
constant uint PRECISION_F32_ = 2u;
constant uint PRECISION_PACKED32_ = 0u;
constant uint MAX_MAGNITUDE_BITS = 1568669696u;
constant uint RANGE_BRICK = 1u;
constant uint BRICK_EDGE = 4u;
constant uint DISTANCE_SHIFT = 20u;
constant uint GRADIENT_MASK = 1023u;
constant uint GRADIENT_BITS = 10u;
constant int GRADIENT_CENTRE = 511;
constant float GRADIENT_STEP = 0.0019569471;
constant float SUBNORMAL_STEP = 0.000000059604645;
constant uint RECONSTRUCTION_HERMITE = 4u;
constant uint RECONSTRUCTION_BLEND = 3u;
constant uint RECONSTRUCTION_HALF = 2u;
constant uint NODE_OFFSET_BITS = 28u;
constant uint NODE_INNER = 0u;
constant uint NODE_OFFSET_MASK = 268435455u;
constant uint LATTICE_MASK = 134217727u;
constant uint PRECISION_SHIFT = 27u;
constant uint INTERPOLANT_TRICUBIC = 1u;
constant uint PRECISION_F16_ = 1u;
constant uint ROOT_LEAF = 2147483648u;
constant uint RECORD_LENGTH = 14u;
constant uint RECORD_FIRST = 8u;
constant uint RECORD_CHILD_MASK = 2097151u;
constant uint RECORD_CHILD_BITS = 21u;
constant uint RECORD_LEAF_MASK = 134217727u;
constant uint SUPPORT_BITS = 2u;
constant uint MAX_EXPONENT = 15u;
constant uint OVERLAP_BITS = 4u;
constant uint KIND_SINGLE = 0u;
constant uint KIND_MIN = 1u;
constant float MIN_OVERLAP = 0.015625;
constant uint MAX_LEVELS_APART = 5u;
constant uint MAX_SUPPORT = 3u;
constant float LEAST_SUPPORT_SHARE = 4.0;

uint word(
    uint index,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    if (index < (1 + (_buffer_sizes.size0 - 0 - 4) / 4)) {
        uint _e6 = words[index];
        return _e6;
    }
    return 0u;
}

uint byte_of(
    uint bits,
    uint number
) {
    return (bits >> (8u * number)) & 255u;
}

float float_(
    uint index_1,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    uint _e1 = word(index_1, words, _buffer_sizes);
    return as_type<float>(_e1);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / metal::select(rhs, 1u, rhs == 0u);
}

Field nearfield_open(
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    Field field = {};
    uint parameters = 0u;
    uint index_2 = 0u;
    uint _e3 = word(FAMILY_WORD, words, _buffer_sizes);
    uint _e5 = byte_of(_e3, FAMILY_BYTE);
    field.family = _e5;
    float _e8 = float_(BOX_MIN_WORD, words, _buffer_sizes);
    float _e10 = float_(7u, words, _buffer_sizes);
    float _e12 = float_(8u, words, _buffer_sizes);
    field.low = metal::float3(_e8, _e10, _e12);
    float _e16 = float_(BOX_MAX_WORD, words, _buffer_sizes);
    float _e18 = float_(10u, words, _buffer_sizes);
    float _e20 = float_(11u, words, _buffer_sizes);
    field.high = metal::float3(_e16, _e18, _e20);
    uint _e25 = word(SECTION_COUNT_WORD, words, _buffer_sizes);
    uint _e27 = byte_of(_e25, SECTION_COUNT_BYTE);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e85 = index_2;
            index_2 = _e85 + 1u;
        }
        loop_init = false;
        uint _e30 = index_2;
        if (_e30 < metal::min(_e27, MAX_SECTIONS)) {
        } else {
            break;
        }
        {
            uint _e36 = index_2;
            uint entry = TABLE_WORD + (SECTION_WORDS * _e36);
            uint _e41 = word(entry + 1u, words, _buffer_sizes);
            uint start_1 = naga_div(_e41, 4u);
            uint _e44 = word(entry, words, _buffer_sizes);
            switch(_e44) {
                case 1381253967u: {
                    uint _e46 = field.family;
                    if (_e46 == FAMILY_OCTREE) {
                        parameters = start_1;
                    }
                    break;
                }
                case 1145655879u: {
                    uint _e50 = field.family;
                    if (_e50 == FAMILY_GRID) {
                        parameters = start_1;
                    }
                    break;
                }
                case 1163023440u: {
                    uint _e54 = field.family;
                    if (_e54 == FAMILY_POLYNOMIAL) {
                        parameters = start_1;
                    }
                    break;
                }
                case 1162104654u: {
                    uint _e58 = field.family;
                    if (_e58 == FAMILY_OCTREE) {
                        field.nodes = start_1;
                    }
                    break;
                }
                case 1163084098u: {
                    uint _e63 = field.family;
                    if (_e63 == FAMILY_GRID) {
                        field.nodes = start_1;
                    }
                    break;
                }
                case 1414483794u: {
                    uint _e68 = field.family;
                    if (_e68 == FAMILY_POLYNOMIAL) {
                        field.nodes = start_1;
                    }
                    break;
                }
                case 1347240275u: {
                    uint _e73 = field.family;
                    if (_e73 != FAMILY_POLYNOMIAL) {
                        field.samples = start_1;
                    }
                    break;
                }
                case 1178682700u: {
                    uint _e78 = field.family;
                    if (_e78 == FAMILY_POLYNOMIAL) {
                        field.samples = start_1;
                    }
                    break;
                }
                case 1162889299u: {
                    field.shapes = start_1;
                    break;
                }
                case 1162170964u: {
                    field.records = start_1;
                    break;
                }
                default: {
                    break;
                }
            }
        }
    }
    uint _e87 = parameters;
    uint _e88 = word(_e87, words, _buffer_sizes);
    uint _e89 = parameters;
    uint _e92 = word(_e89 + 1u, words, _buffer_sizes);
    uint _e93 = parameters;
    uint _e96 = word(_e93 + 2u, words, _buffer_sizes);
    field.counts = metal::uint3(_e88 & 65535u, _e88 >> 16u, _e92 & 65535u);
    uint _e106 = field.family;
    if (_e106 == FAMILY_GRID) {
        uint _e111 = byte_of(_e92, 2u);
        field.order = _e111;
        uint _e114 = byte_of(_e92, 3u);
        field.reconstruction = _e114;
        uint _e117 = byte_of(_e96, 0u);
        field.sample_precision = _e117;
        uint _e120 = byte_of(_e96, 1u);
        field.range = _e120;
        metal::uint3 _e123 = field.counts;
        field.cells = _e123 - metal::uint3(1u);
        uint _e128 = parameters;
        float _e131 = float_(_e128 + 3u, words, _buffer_sizes);
        uint _e132 = parameters;
        float _e135 = float_(_e132 + 4u, words, _buffer_sizes);
        uint _e136 = parameters;
        float _e139 = float_(_e136 + 5u, words, _buffer_sizes);
        field.spacing = metal::float3(_e131, _e135, _e139);
        metal::float3 _e143 = field.spacing;
        field.cells_per_unit = metal::float3(1.0) / _e143;
        uint _e148 = parameters;
        float _e151 = float_(_e148 + 6u, words, _buffer_sizes);
        field.quantum = _e151;
    } else {
        uint _e154 = byte_of(_e92, 2u);
        field.depth = metal::min(_e154, MAX_DEPTH);
        uint _e159 = byte_of(_e92, 3u);
        field.reconstruction = _e159;
        uint _e162 = byte_of(_e92, 3u);
        field.shape_bits = _e162;
        metal::uint3 _e165 = field.counts;
        uint _e167 = field.depth;
        field.cells = _e165 << metal::uint3(_e167);
        uint _e171 = parameters;
        float _e174 = float_(_e171 + 3u, words, _buffer_sizes);
        field.spacing = metal::float3(_e174);
        uint _e179 = field.depth;
        float _e184 = field.spacing[0];
        field.cells_per_unit = metal::float3(static_cast<float>(1u << _e179) / _e184);
        uint _e188 = parameters;
        float _e191 = float_(_e188 + 4u, words, _buffer_sizes);
        field.quantum = _e191;
        uint _e193 = field.family;
        if (_e193 == FAMILY_POLYNOMIAL) {
            uint _e197 = parameters;
            float _e200 = float_(_e197 + 5u, words, _buffer_sizes);
            field.overlap = _e200;
        }
    }
    Field _e201 = field;
    return _e201;
}

float nearfield_slope(
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    float _e1 = float_(LIPSCHITZ_WORD, words, _buffer_sizes);
    return _e1;
}

float nearfield_error(
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    uint _e1 = word(SAMPLE_COUNT_WORD, words, _buffer_sizes);
    if (_e1 == 0u) {
        return 0.0;
    }
    float _e6 = float_(UNIFORM_MAX_WORD, words, _buffer_sizes);
    float _e8 = float_(BAND_MAX_WORD, words, _buffer_sizes);
    return metal::max(_e6, _e8);
}

float reciprocal_sqrt(
    float x
) {
    float seed = 2.8898656 - (x * (4.8495784 - (x * (4.646499 - (x * 1.6896812)))));
    float half_1 = 0.5 * x;
    float coarse = seed * (1.5 - (half_1 * (seed * seed)));
    return coarse + (coarse * (0.5 - (half_1 * (coarse * coarse))));
}

Answer length_and_direction(
    metal::float3 vector
) {
    float largest = metal::max(metal::max(metal::abs(vector.x), metal::abs(vector.y)), metal::abs(vector.z));
    metal::float3 scaled = vector / metal::float3(largest);
    float taxicab = (metal::abs(scaled.x) + metal::abs(scaled.y)) + metal::abs(scaled.z);
    metal::float3 place_1 = scaled / metal::float3(taxicab);
    float squared = ((place_1.x * place_1.x) + (place_1.y * place_1.y)) + (place_1.z * place_1.z);
    float _e32 = reciprocal_sqrt(squared);
    float length = metal::min((taxicab * (squared * _e32)) * largest, MAX_FLOAT);
    return Answer {length, {}, place_1 * _e32};
}

Answer answer_without_end(
    metal::uint3 bits_1,
    metal::float3 point
) {
    if (metal::any(bits_1 > metal::uint3(2139095040u))) {
        float nan = as_type<float>(metal::max(metal::max(bits_1.x, bits_1.y), bits_1.z));
        return Answer {nan, {}, metal::float3(nan)};
    }
    metal::uint3 signs = as_type<metal::uint3>(point) & metal::uint3(2147483648u);
    metal::float3 ones = as_type<metal::float3>(signs | metal::uint3(1065353216u));
    metal::float3 toward = metal::select(metal::float3(0.0), ones, bits_1 == metal::uint3(2139095040u));
    Answer _e34 = length_and_direction(toward);
    return Answer {as_type<float>(metal::max(metal::max(bits_1.x, bits_1.y), bits_1.z)), {}, _e34.gradient};
}

Answer polynomial_at(
    Polynomial p,
    metal::float3 at,
    metal::float4 factors
) {
    float x_3 = at.x;
    float y_2 = at.y;
    float z_2 = at.z;
    float first_1 = ((p.first.x * x_3) + (p.first.y * y_2)) + (p.first.z * z_2);
    float second = (((((p.square.x * x_3) + (p.cross.x * y_2)) + (p.cross.y * z_2)) * x_3) + (((p.square.y * y_2) + (p.cross.z * z_2)) * y_2)) + (p.square.z * (z_2 * z_2));
    float third = ((((((((p.cube.x * x_3) + (p.mixed.x * y_2)) + (p.mixed.y * z_2)) * x_3) + (((p.mixed.z * y_2) + (p.xyz * z_2)) * y_2)) + (p.more[0] * (z_2 * z_2))) * x_3) + (((((p.cube.y * y_2) + (p.more[1] * z_2)) * y_2) + (p.more[2] * (z_2 * z_2))) * y_2)) + (p.cube.z * ((z_2 * z_2) * z_2));
    float value_1 = (((p.constant_ * factors.x) + (first_1 * factors.y)) + (second * factors.z)) + (third * factors.w);
    float by_x = ((p.first.x * factors.y) + (((((2.0 * p.square.x) * x_3) + (p.cross.x * y_2)) + (p.cross.y * z_2)) * factors.z)) + (((((((3.0 * p.cube.x) * x_3) + (2.0 * ((p.mixed.x * y_2) + (p.mixed.y * z_2)))) * x_3) + (((p.mixed.z * y_2) + (p.xyz * z_2)) * y_2)) + (p.more[0] * (z_2 * z_2))) * factors.w);
    float by_y = ((p.first.y * factors.y) + (((((2.0 * p.square.y) * y_2) + (p.cross.x * x_3)) + (p.cross.z * z_2)) * factors.z)) + (((((((3.0 * p.cube.y) * y_2) + (2.0 * ((p.mixed.z * x_3) + (p.more[1] * z_2)))) * y_2) + (((p.mixed.x * x_3) + (p.xyz * z_2)) * x_3)) + (p.more[2] * (z_2 * z_2))) * factors.w);
    float by_z = ((p.first.z * factors.y) + (((((2.0 * p.square.z) * z_2) + (p.cross.y * x_3)) + (p.cross.z * y_2)) * factors.z)) + (((((((3.0 * p.cube.z) * z_2) + (2.0 * ((p.more[0] * x_3) + (p.more[2] * y_2)))) * z_2) + (((p.mixed.y * x_3) + (p.xyz * y_2)) * x_3)) + (p.more[1] * (y_2 * y_2))) * factors.w);
    return Answer {value_1, {}, metal::float3(by_x, by_y, by_z)};
}

metal::uint2 coefficient(
    Field field_1,
    uint number_1,
    uint index_3
) {
    uint count = 1u;
    uint half_ = {};
    bool local_1 = {};
    switch(field_1.order) {
        case 0u: {
            break;
        }
        case 1u: {
            count = 4u;
            break;
        }
        case 2u: {
            count = 10u;
            break;
        }
        default: {
            count = 20u;
            break;
        }
    }
    if (field_1.sample_precision == PRECISION_F32_) {
        uint _e13 = count;
        return metal::uint2((field_1.samples + (number_1 * _e13)) + index_3, 0u);
    }
    uint _e19 = count;
    half_ = (number_1 * _e19) + index_3;
    if (field_1.sample_precision == PRECISION_PACKED32_) {
        local_1 = field_1.order > 0u;
    } else {
        local_1 = false;
    }
    bool _e32 = local_1;
    if (_e32) {
        uint _e33 = count;
        half_ = ((number_1 * (_e33 - 2u)) + metal::max(index_3, 2u)) - 2u;
    }
    uint _e43 = half_;
    uint _e48 = half_;
    return metal::uint2(field_1.samples + naga_div(_e43, 2u), 16u * (_e48 & 1u));
}

float sample_float(
    uint index_4,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    uint _e1 = word(index_4, words, _buffer_sizes);
    return ((_e1 & 2147483647u) <= MAX_MAGNITUDE_BITS) ? as_type<float>(_e1) : 0.0;
}

float decode_distance(
    int base,
    uint code,
    float quantum
) {
    return static_cast<float>(as_type<int>(as_type<uint>(base) + as_type<uint>(static_cast<int>(code)))) * quantum;
}

metal::uint3 naga_div(metal::uint3 lhs, metal::uint3 rhs) {
    return lhs / metal::select(rhs, 1u, rhs == 0u);
}

float read_constant(
    Field field_2,
    metal::uint3 vertex_,
    uint number_2,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    uint brick = 0u;
    uint code_1 = {};
    bool local_2 = {};
    metal::uint2 _e4 = coefficient(field_2, number_2, 0u);
    if (field_2.sample_precision == PRECISION_F32_) {
        float _e9 = sample_float(_e4.x, words, _buffer_sizes);
        return _e9;
    }
    if (field_2.range == RANGE_BRICK) {
        metal::uint3 bricks = naga_div(field_2.counts + metal::uint3(3u), metal::uint3(4u));
        metal::uint3 at_1 = naga_div(vertex_, metal::uint3(4u));
        brick = at_1.x + (bricks.x * (at_1.y + (bricks.y * at_1.z)));
    }
    uint _e35 = word(_e4.x, words, _buffer_sizes);
    code_1 = (_e35 >> _e4.y) & 65535u;
    if (field_2.sample_precision == PRECISION_PACKED32_) {
        local_2 = field_2.order > 0u;
    } else {
        local_2 = false;
    }
    bool _e50 = local_2;
    if (_e50) {
        uint _e52 = word(_e4.x, words, _buffer_sizes);
        code_1 = _e52 >> DISTANCE_SHIFT;
    }
    uint _e56 = brick;
    uint _e58 = word(field_2.nodes + _e56, words, _buffer_sizes);
    uint _e60 = code_1;
    float _e62 = decode_distance(as_type<int>(_e58), _e60, field_2.quantum);
    return _e62;
}

float copy_sign(
    float magnitude,
    float sign
) {
    return as_type<float>(as_type<uint>(metal::abs(magnitude)) | (as_type<uint>(sign) & 2147483648u));
}

metal::float3 decode_gradient(
    uint code_2
) {
    metal::int2 codes = as_type<metal::int2>(as_type<metal::uint2>(static_cast<metal::int2>(metal::uint2(code_2 & GRADIENT_MASK, (code_2 >> GRADIENT_BITS) & GRADIENT_MASK))) - as_type<metal::uint2>(metal::int2(511)));
    metal::float2 flat = static_cast<metal::float2>(codes) * GRADIENT_STEP;
    float z_3 = (1.0 - metal::abs(flat.x)) - metal::abs(flat.y);
    float fold = metal::max(-(z_3), 0.0);
    float _e27 = copy_sign(fold, flat.x);
    float x_4 = flat.x - _e27;
    float _e31 = copy_sign(fold, flat.y);
    float y_3 = flat.y - _e31;
    float _e39 = reciprocal_sqrt(((x_4 * x_4) + (y_3 * y_3)) + (z_3 * z_3));
    return metal::float3(x_4, y_3, z_3) * _e39;
}

float decode_half(
    uint bits_2
) {
    uint sign_1 = (bits_2 & 32768u) << 16u;
    uint exponent_1 = (bits_2 >> 10u) & 31u;
    uint fraction = bits_2 & 1023u;
    if (exponent_1 == 0u) {
        return as_type<float>(sign_1 | as_type<uint>(static_cast<float>(fraction) * SUBNORMAL_STEP));
    }
    return as_type<float>(sign_1 | ((exponent_1 == 31u) ? 0u : (((exponent_1 + 112u) << 23u) | (fraction << 13u))));
}

float read_number(
    Field field_3,
    uint number_3,
    uint index_5,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    metal::uint2 _e3 = coefficient(field_3, number_3, index_5);
    if (field_3.sample_precision == PRECISION_F32_) {
        float _e8 = sample_float(_e3.x, words, _buffer_sizes);
        return _e8;
    }
    uint _e10 = word(_e3.x, words, _buffer_sizes);
    float _e13 = decode_half(_e10 >> _e3.y);
    return _e13;
}

metal::float3 read_three(
    Field field_4,
    uint number_4,
    uint first,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    float _e3 = read_number(field_4, number_4, first, words, _buffer_sizes);
    float _e6 = read_number(field_4, number_4, first + 1u, words, _buffer_sizes);
    float _e9 = read_number(field_4, number_4, first + 2u, words, _buffer_sizes);
    return metal::float3(_e3, _e6, _e9);
}

Polynomial read_polynomial(
    Field field_5,
    metal::uint3 vertex_1,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    Polynomial sample = {};
    uint number_5 = vertex_1.x + (field_5.counts.x * (vertex_1.y + (field_5.counts.y * vertex_1.z)));
    float _e15 = read_constant(field_5, vertex_1, number_5, words, _buffer_sizes);
    sample.constant_ = _e15;
    if (field_5.order == 0u) {
        Polynomial _e19 = sample;
        return _e19;
    }
    if (field_5.sample_precision == PRECISION_PACKED32_) {
        metal::uint2 _e25 = coefficient(field_5, number_5, 0u);
        uint _e27 = word(_e25.x, words, _buffer_sizes);
        metal::float3 _e28 = decode_gradient(_e27);
        sample.first = _e28;
    } else {
        metal::float3 _e31 = read_three(field_5, number_5, 1u, words, _buffer_sizes);
        sample.first = _e31;
    }
    if (field_5.order >= 2u) {
        metal::float3 _e37 = read_three(field_5, number_5, 4u, words, _buffer_sizes);
        sample.square = _e37;
        metal::float3 _e40 = read_three(field_5, number_5, 7u, words, _buffer_sizes);
        sample.cross = _e40;
    }
    if (field_5.order >= 3u) {
        metal::float3 _e46 = read_three(field_5, number_5, 10u, words, _buffer_sizes);
        sample.cube = _e46;
        metal::float3 _e49 = read_three(field_5, number_5, 13u, words, _buffer_sizes);
        sample.mixed = _e49;
        metal::float3 _e52 = read_three(field_5, number_5, 16u, words, _buffer_sizes);
        sample.more = _e52;
        float _e55 = read_number(field_5, number_5, 19u, words, _buffer_sizes);
        sample.xyz = _e55;
    }
    metal::float3 s = field_5.spacing;
    metal::float3 r = s / metal::float3(metal::max(metal::max(field_5.spacing[0], field_5.spacing[1]), field_5.spacing[2]));
    metal::float3 _e65 = sample.first;
    sample.first = _e65 * s;
    metal::float3 _e68 = sample.square;
    sample.square = _e68 * (s * r);
    metal::float3 _e72 = sample.cross;
    sample.cross = _e72 * (metal::float3(s).xxy * r.yzz);
    metal::float3 _e78 = sample.cube;
    sample.cube = _e78 * ((s * r) * r);
    metal::float3 _e83 = sample.mixed;
    sample.mixed = _e83 * ((metal::float3(s).xxx * r.xxy) * r.yzy);
    metal::float3 _e91 = sample.more;
    sample.more = _e91 * ((metal::float3(s).xyy * r.zyz) * r.zzz);
    float _e99 = sample.xyz;
    sample.xyz = _e99 * ((field_5.spacing[0] * r.y) * r.z);
    Polynomial _e106 = sample;
    return _e106;
}

metal::float4 factors_of(
    Field field_6
) {
    if (field_6.reconstruction != RECONSTRUCTION_HALF) {
        return metal::float4(1.0);
    }
    switch(field_6.order) {
        case 1u: {
            return metal::float4(1.0, 0.5, 0.0, 0.0);
        }
        case 2u: {
            return metal::float4(1.0, 0.6666667, 0.33333334, 0.0);
        }
        default: {
            return metal::float4(1.0, 0.75, 0.5, 0.25);
        }
    }
}

metal::uint3 vertex_of(
    metal::uint3 cell,
    uint corner
) {
    return cell + metal::uint3(corner >> 2u, (corner >> 1u) & 1u, corner & 1u);
}

metal::float4 weights_of(
    uint smoothness,
    float t
) {
    float end = {};
    float slope = 1.0;
    float rest = 1.0 - t;
    end = t;
    if (smoothness == 1u) {
        end = (t * t) * (3.0 - (2.0 * t));
        slope = (6.0 * t) * rest;
    } else {
        if (smoothness == 2u) {
            end = ((t * t) * t) * (10.0 - (t * (15.0 - (6.0 * t))));
            slope = (30.0 * (t * t)) * (rest * rest);
        } else {
            if (smoothness == 3u) {
                float square_1 = t * t;
                float cube = ((t * rest) * (t * rest)) * (t * rest);
                end = (square_1 * square_1) * (35.0 - (t * (84.0 - (t * (70.0 - (20.0 * t))))));
                slope = 140.0 * cube;
            }
        }
    }
    float _e57 = end;
    float _e60 = end;
    float _e61 = slope;
    float _e63 = slope;
    return metal::float4(1.0 - _e57, _e60, -(_e61), _e63);
}

metal::float4 weighted_sum(
    Corners corners,
    metal::float2 x_1,
    metal::float2 y,
    metal::float2 z
) {
    metal::float4 a = (corners.at.inner[0] * x_1.x) + (corners.at.inner[4] * x_1.y);
    metal::float4 b = (corners.at.inner[1] * x_1.x) + (corners.at.inner[5] * x_1.y);
    metal::float4 c = (corners.at.inner[2] * x_1.x) + (corners.at.inner[6] * x_1.y);
    metal::float4 d = (corners.at.inner[3] * x_1.x) + (corners.at.inner[7] * x_1.y);
    return (((a * y.x) + (c * y.y)) * z.x) + (((b * y.x) + (d * y.y)) * z.y);
}

Answer weighted_polynomials(
    Field field_7,
    metal::uint3 cell_1,
    metal::float3 local_3,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    Corners corners_1 = {};
    uint corner_1 = 0u;
    uint smoothness_1 = (field_7.reconstruction == RECONSTRUCTION_BLEND) ? field_7.order : 0u;
    metal::float4 _e9 = factors_of(field_7);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e33 = corner_1;
            corner_1 = _e33 + 1u;
        }
        loop_init_1 = false;
        uint _e13 = corner_1;
        if (_e13 < 8u) {
        } else {
            break;
        }
        {
            uint _e16 = corner_1;
            metal::uint3 _e17 = vertex_of(cell_1, _e16);
            Polynomial _e18 = read_polynomial(field_7, _e17, words, _buffer_sizes);
            uint _e21 = corner_1;
            metal::uint3 _e22 = vertex_of(metal::uint3(0u), _e21);
            Answer _e25 = polynomial_at(_e18, local_3 - static_cast<metal::float3>(_e22), _e9);
            uint _e27 = corner_1;
            corners_1.at.inner[_e27] = metal::float4(_e25.gradient, _e25.distance);
        }
    }
    metal::float4 _e36 = weights_of(smoothness_1, local_3.x);
    metal::float4 _e38 = weights_of(smoothness_1, local_3.y);
    metal::float4 _e40 = weights_of(smoothness_1, local_3.z);
    Corners _e41 = corners_1;
    metal::float4 _e45 = weighted_sum(_e41, _e36.xy, _e38.xy, _e40.xy);
    Corners _e46 = corners_1;
    metal::float4 _e50 = weighted_sum(_e46, _e36.zw, _e38.xy, _e40.xy);
    float by_x_1 = _e50.w;
    Corners _e52 = corners_1;
    metal::float4 _e56 = weighted_sum(_e52, _e36.xy, _e38.zw, _e40.xy);
    float by_y_1 = _e56.w;
    Corners _e58 = corners_1;
    metal::float4 _e62 = weighted_sum(_e58, _e36.xy, _e38.xy, _e40.zw);
    float by_z_1 = _e62.w;
    return Answer {_e45.w, {}, metal::float3(by_x_1, by_y_1, by_z_1) + _e45.xyz};
}

Face at_x(
    thread Jets& jets,
    metal::float4 weights
) {
    Face face = {};
    int edge = 0;
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            int _e37 = edge;
            edge = as_type<int>(as_type<uint>(_e37) + as_type<uint>(1));
        }
        loop_init_2 = false;
        int _e5 = edge;
        if (_e5 < 4) {
        } else {
            break;
        }
        {
            int _e9 = edge;
            Jet near_1 = jets.corners.inner[_e9];
            int _e13 = edge;
            Jet far_1 = jets.corners.inner[as_type<int>(as_type<uint>(_e13) + as_type<uint>(4))];
            int _e19 = edge;
            face.corners.inner[_e19] = ((near_1.plain * weights.x) + (far_1.plain * weights.y)) + ((near_1.by_x * weights.z) + (far_1.by_x * weights.w));
        }
    }
    Face _e39 = face;
    return _e39;
}

metal::float4 cubic(
    float t_1
) {
    float rest_1 = 1.0 - t_1;
    float end_3 = (t_1 * t_1) * (3.0 - (2.0 * t_1));
    return metal::float4(1.0 - end_3, end_3, t_1 * (rest_1 * rest_1), -((t_1 * t_1)) * rest_1);
}

metal::float4 at_y(
    Face face_1,
    metal::float4 weights_1
) {
    metal::float4 near_y = metal::float4(face_1.corners.inner[0].xy, face_1.corners.inner[1].xy);
    metal::float4 far_y = metal::float4(face_1.corners.inner[2].xy, face_1.corners.inner[3].xy);
    metal::float4 near_y_slope = metal::float4(face_1.corners.inner[0].zw, face_1.corners.inner[1].zw);
    metal::float4 far_y_slope = metal::float4(face_1.corners.inner[2].zw, face_1.corners.inner[3].zw);
    return ((near_y * weights_1.x) + (far_y * weights_1.y)) + ((near_y_slope * weights_1.z) + (far_y_slope * weights_1.w));
}

float at_z(
    metal::float4 edge_1,
    metal::float4 weights_2
) {
    return ((edge_1.x * weights_2.x) + (edge_1.z * weights_2.y)) + ((edge_1.y * weights_2.z) + (edge_1.w * weights_2.w));
}

metal::float4 cubic_slope(
    float t_2
) {
    float end_4 = (6.0 * t_2) * (1.0 - t_2);
    return metal::float4(-(end_4), end_4, (1.0 - t_2) * (1.0 - (3.0 * t_2)), t_2 * ((3.0 * t_2) - 2.0));
}

Answer tricubic(
    thread Jets& jets_1,
    metal::float3 local_4
) {
    metal::float4 _e3 = cubic(local_4.x);
    Face _e4 = at_x(jets_1, _e3);
    metal::float4 _e6 = cubic(local_4.y);
    metal::float4 _e8 = cubic(local_4.z);
    metal::float4 _e9 = at_y(_e4, _e6);
    metal::float4 _e11 = cubic_slope(local_4.x);
    Face _e12 = at_x(jets_1, _e11);
    metal::float4 _e13 = at_y(_e12, _e6);
    float _e14 = at_z(_e13, _e8);
    metal::float4 _e16 = cubic_slope(local_4.y);
    metal::float4 _e17 = at_y(_e4, _e16);
    float _e18 = at_z(_e17, _e8);
    metal::float4 _e20 = cubic_slope(local_4.z);
    float _e21 = at_z(_e9, _e20);
    float _e22 = at_z(_e9, _e8);
    return Answer {_e22, {}, metal::float3(_e14, _e18, _e21)};
}

Answer hermite_of_samples(
    Field field_8,
    metal::uint3 cell_2,
    metal::float3 local_5,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    Jets jets_2 = {};
    uint corner_2 = 0u;
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            uint _e30 = corner_2;
            corner_2 = _e30 + 1u;
        }
        loop_init_3 = false;
        uint _e6 = corner_2;
        if (_e6 < 8u) {
        } else {
            break;
        }
        {
            uint _e9 = corner_2;
            metal::uint3 _e10 = vertex_of(cell_2, _e9);
            Polynomial _e11 = read_polynomial(field_8, _e10, words, _buffer_sizes);
            uint _e13 = corner_2;
            jets_2.corners.inner[_e13] = Jet {metal::float4(_e11.constant_, _e11.first.z, _e11.first.y, 0.0), metal::float4(_e11.first.x, 0.0, 0.0, 0.0)};
        }
    }
    Answer _e32 = tricubic(jets_2, local_5);
    return _e32;
}

metal::float3 quintic(
    float t_3,
    uint end_1
) {
    float rest_2 = 1.0 - t_3;
    float cube_1 = (t_3 * t_3) * t_3;
    float rest_cube = (rest_2 * rest_2) * rest_2;
    float far_2 = cube_1 * (10.0 - (t_3 * (15.0 - (6.0 * t_3))));
    metal::float3 near_weights = metal::float3(1.0 - far_2, (t_3 * rest_cube) * (1.0 + (3.0 * t_3)), (t_3 * t_3) * rest_cube);
    metal::float3 far_weights = metal::float3(far_2, (-(cube_1) * rest_2) * (4.0 - (3.0 * t_3)), cube_1 * (rest_2 * rest_2));
    return metal::select(near_weights, far_weights, metal::bool3(end_1 == 1u));
}

float quintic_product(
    Polynomial p_1,
    metal::float3 x_2,
    metal::float3 y_1,
    metal::float3 z_1
) {
    return ((((((((p_1.constant_ * x_2.x) + (p_1.first.x * x_2.y)) + (p_1.square.x * x_2.z)) * y_1.x) + (((p_1.first.y * x_2.x) + (p_1.cross.x * x_2.y)) * y_1.y)) + ((p_1.square.y * x_2.x) * y_1.z)) * z_1.x) + (((((p_1.first.z * x_2.x) + (p_1.cross.y * x_2.y)) * y_1.x) + ((p_1.cross.z * x_2.x) * y_1.y)) * z_1.y)) + (((p_1.square.z * x_2.x) * y_1.x) * z_1.z);
}

metal::float3 quintic_slope(
    float t_4,
    uint end_2
) {
    float rest_3 = 1.0 - t_4;
    float square_2 = t_4 * t_4;
    float rest_square = rest_3 * rest_3;
    float far_3 = (30.0 * square_2) * rest_square;
    metal::float3 near_weights_1 = metal::float3(-(far_3), rest_square * (1.0 + (t_4 * (2.0 - (15.0 * t_4)))), (t_4 * rest_square) * (2.0 - (5.0 * t_4)));
    metal::float3 far_weights_1 = metal::float3(far_3, square_2 * ((t_4 * (28.0 - (15.0 * t_4))) - 12.0), (square_2 * rest_3) * (3.0 - (5.0 * t_4)));
    return metal::select(near_weights_1, far_weights_1, metal::bool3(end_2 == 1u));
}

Answer triquintic(
    Field field_9,
    metal::uint3 cell_3,
    metal::float3 local_6,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    Answer sum = Answer {0.0, {}, metal::float3(0.0)};
    uint corner_3 = 0u;
    bool loop_init_4 = true;
    while(true) {
        if (!loop_init_4) {
            uint _e58 = corner_3;
            corner_3 = _e58 + 1u;
        }
        loop_init_4 = false;
        uint _e10 = corner_3;
        if (_e10 < 8u) {
        } else {
            break;
        }
        {
            uint _e13 = corner_3;
            metal::uint3 _e14 = vertex_of(cell_3, _e13);
            Polynomial _e15 = read_polynomial(field_9, _e14, words, _buffer_sizes);
            uint _e18 = corner_3;
            metal::uint3 _e19 = vertex_of(metal::uint3(0u), _e18);
            metal::float3 _e22 = quintic(local_6.x, _e19.x);
            metal::float3 _e25 = quintic(local_6.y, _e19.y);
            metal::float3 _e28 = quintic(local_6.z, _e19.z);
            float _e30 = sum.distance;
            float _e31 = quintic_product(_e15, _e22, _e25, _e28);
            sum.distance = _e30 + _e31;
            float _e35 = sum.gradient.x;
            metal::float3 _e38 = quintic_slope(local_6.x, _e19.x);
            float _e39 = quintic_product(_e15, _e38, _e25, _e28);
            sum.gradient.x = _e35 + _e39;
            float _e43 = sum.gradient.y;
            metal::float3 _e46 = quintic_slope(local_6.y, _e19.y);
            float _e47 = quintic_product(_e15, _e22, _e46, _e28);
            sum.gradient.y = _e43 + _e47;
            float _e51 = sum.gradient.z;
            metal::float3 _e54 = quintic_slope(local_6.z, _e19.z);
            float _e55 = quintic_product(_e15, _e22, _e25, _e54);
            sum.gradient.z = _e51 + _e55;
        }
    }
    Answer _e60 = sum;
    return _e60;
}

metal::uint3 naga_f2u32(metal::float3 value) {
    return static_cast<metal::uint3>(metal::clamp(value, 0.0, 4294967000.0));
}

Answer evaluate_grid(
    Field field_10,
    metal::float3 position,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    Answer answer = {};
    metal::uint3 cell_7 = metal::min(naga_f2u32(position), field_10.cells - metal::uint3(1u));
    metal::float3 local_22 = position - static_cast<metal::float3>(cell_7);
    if (field_10.reconstruction == RECONSTRUCTION_NEAREST) {
        metal::bool3 upper = local_22 >= metal::float3(0.5);
        metal::uint3 nearest = cell_7 + metal::select(metal::uint3(0u), metal::uint3(1u), upper);
        Polynomial _e23 = read_polynomial(field_10, nearest, words, _buffer_sizes);
        Answer _e32 = polynomial_at(_e23, local_22 - metal::select(metal::float3(0.0), metal::float3(1.0), upper), metal::float4(1.0));
        answer = _e32;
    } else {
        if (field_10.reconstruction != RECONSTRUCTION_HERMITE) {
            Answer _e36 = weighted_polynomials(field_10, cell_7, local_22, words, _buffer_sizes);
            answer = _e36;
        } else {
            if (field_10.order == 1u) {
                Answer _e40 = hermite_of_samples(field_10, cell_7, local_22, words, _buffer_sizes);
                answer = _e40;
            } else {
                Answer _e41 = triquintic(field_10, cell_7, local_22, words, _buffer_sizes);
                answer = _e41;
            }
        }
    }
    metal::float3 _e43 = answer.gradient;
    answer.gradient = _e43 * field_10.cells_per_unit;
    Answer _e46 = answer;
    return _e46;
}

uint octant_of(
    metal::uint3 cell_4,
    uint shift
) {
    metal::uint3 half_2 = (cell_4 >> metal::uint3(shift)) & metal::uint3(1u);
    return (half_2.x | (half_2.y << 1u)) | (half_2.z << 2u);
}

float power_of_half(
    uint exponent
) {
    return as_type<float>((127u - metal::min(exponent, 126u)) << 23u);
}

uint count_bits(
    uint bits_3
) {
    uint pairs = bits_3 - ((bits_3 >> 1u) & 1431655765u);
    uint nibbles = (pairs & 858993459u) + ((pairs >> 2u) & 858993459u);
    return (((nibbles + (nibbles >> 4u)) & 252645135u) * 16843009u) >> 24u;
}

metal::float2 decode_halves(
    uint bits_4
) {
    float _e1 = decode_half(bits_4);
    float _e4 = decode_half(bits_4 >> 16u);
    return metal::float2(_e1, _e4);
}

Jet read_jet(
    Block block,
    uint source,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    float distance = {};
    metal::float3 gradient = {};
    metal::float4 mixed = metal::float4(0.0);
    bool local_7 = {};
    uint before = source - 1u;
    uint _e6 = count_bits(block.present & before);
    uint _e9 = count_bits(block.full & before);
    bool is_full = (block.full & source) != 0u;
    if (block.sample_precision == PRECISION_F32_) {
        uint place_2 = block.first + (4u * (_e6 + _e9));
        float _e27 = sample_float(place_2, words, _buffer_sizes);
        distance = _e27;
        float _e30 = sample_float(place_2 + 1u, words, _buffer_sizes);
        float _e33 = sample_float(place_2 + 2u, words, _buffer_sizes);
        float _e36 = sample_float(place_2 + 3u, words, _buffer_sizes);
        gradient = metal::float3(_e30, _e33, _e36);
        if (is_full) {
            float _e40 = sample_float(place_2 + 4u, words, _buffer_sizes);
            float _e43 = sample_float(place_2 + 5u, words, _buffer_sizes);
            float _e46 = sample_float(place_2 + 6u, words, _buffer_sizes);
            float _e49 = sample_float(place_2 + 7u, words, _buffer_sizes);
            mixed = metal::float4(_e40, _e43, _e46, _e49);
        }
    } else {
        if (block.sample_precision == PRECISION_PACKED32_) {
            local_7 = !(is_full);
        } else {
            local_7 = false;
        }
        bool _e58 = local_7;
        if (_e58) {
            uint _e64 = word((block.first + _e6) + (3u * _e9), words, _buffer_sizes);
            float _e69 = decode_distance(block.base, _e64 >> DISTANCE_SHIFT, block.quantum);
            distance = _e69;
            metal::float3 _e70 = decode_gradient(_e64);
            gradient = _e70;
        } else {
            uint stride = (block.sample_precision == PRECISION_F16_) ? 2u : 1u;
            uint place_3 = (block.first + (_e6 * stride)) + (_e9 * (4u - stride));
            uint _e84 = word(place_3, words, _buffer_sizes);
            uint _e87 = word(place_3 + 1u, words, _buffer_sizes);
            metal::float2 _e88 = decode_halves(_e87);
            float _e97 = decode_distance(as_type<int>(as_type<uint>(16) * as_type<uint>(block.base)), _e84 & 65535u, block.quantum * 0.0625);
            distance = _e97;
            float _e100 = decode_half(_e84 >> 16u);
            gradient = metal::float3(_e100, _e88.x, _e88.y);
            if (is_full) {
                uint _e106 = word(place_3 + 2u, words, _buffer_sizes);
                metal::float2 _e107 = decode_halves(_e106);
                uint _e110 = word(place_3 + 3u, words, _buffer_sizes);
                metal::float2 _e111 = decode_halves(_e110);
                mixed = metal::float4(_e107, _e111);
            }
        }
    }
    metal::float3 _e113 = gradient;
    gradient = _e113 * block.edge;
    metal::float4 _e116 = mixed;
    mixed = _e116 * block.edge;
    float _e119 = distance;
    float _e121 = gradient.z;
    float _e123 = gradient.y;
    float _e125 = mixed.z;
    float _e128 = gradient.x;
    float _e130 = mixed.y;
    float _e132 = mixed.x;
    float _e134 = mixed.w;
    return Jet {metal::float4(_e119, _e121, _e123, _e125), metal::float4(_e128, _e130, _e132, _e134)};
}

float read_distance(
    Block block_1,
    uint source_1,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    uint _e6 = count_bits(block_1.present & (source_1 - 1u));
    if (block_1.sample_precision == PRECISION_F32_) {
        float _e12 = sample_float(block_1.first + _e6, words, _buffer_sizes);
        return _e12;
    }
    uint _e17 = word(block_1.first + naga_div(_e6, 2u), words, _buffer_sizes);
    uint code_3 = (_e17 >> (16u * (_e6 & 1u))) & 65535u;
    float _e31 = decode_distance(as_type<int>(as_type<uint>(16) * as_type<uint>(block_1.base)), code_3, block_1.quantum * 0.0625);
    return _e31;
}

Jet middle(
    Jet near,
    Jet far,
    uint axis
) {
    Jet sum_1 = Jet {near.plain + far.plain, near.by_x + far.by_x};
    Jet change_1 = Jet {near.plain - far.plain, near.by_x - far.by_x};
    if (axis == 0u) {
        return Jet {(0.5 * sum_1.plain) + (0.25 * change_1.by_x), (-0.25 * sum_1.by_x) + (-0.75 * change_1.plain)};
    }
    if (axis == 1u) {
        metal::float4 by_sum = metal::float4(0.5, 0.5, -0.25, -0.25);
        metal::float4 by_change = metal::float4(0.25, 0.25, -0.75, -0.75);
        return Jet {(by_sum * sum_1.plain) + (by_change * change_1.plain.zwxy), (by_sum * sum_1.by_x) + (by_change * change_1.by_x.zwxy)};
    }
    metal::float4 by_sum_1 = metal::float4(0.5, -0.25, 0.5, -0.25);
    metal::float4 by_change_1 = metal::float4(0.25, -0.75, 0.25, -0.75);
    return Jet {(by_sum_1 * sum_1.plain) + (by_change_1 * change_1.plain.yxwz), (by_sum_1 * sum_1.by_x) + (by_change_1 * change_1.by_x.yxwz)};
}

void settle(
    thread Jets& jets_3,
    uint implied,
    uint octant,
    uint axis_1
) {
    uint corner_4 = 0u;
    bool local_8 = {};
    uint bit_5 = 4u >> axis_1;
    uint end_5 = (((octant >> axis_1) & 1u) == 1u) ? 0u : bit_5;
    bool loop_init_5 = true;
    while(true) {
        if (!loop_init_5) {
            uint _e47 = corner_4;
            corner_4 = _e47 + 1u;
        }
        loop_init_5 = false;
        uint _e15 = corner_4;
        if (_e15 < 8u) {
        } else {
            break;
        }
        {
            uint _e18 = corner_4;
            if ((_e18 & bit_5) == end_5) {
                uint _e23 = corner_4;
                local_8 = ((implied >> _e23) & 1u) == 1u;
            } else {
                local_8 = false;
            }
            bool _e30 = local_8;
            if (_e30) {
                uint _e32 = corner_4;
                Jet near_2 = jets_3.corners.inner[_e32 & ~(bit_5)];
                uint _e38 = corner_4;
                Jet far_4 = jets_3.corners.inner[_e38 | bit_5];
                uint _e43 = corner_4;
                Jet _e45 = middle(near_2, far_4, axis_1);
                jets_3.corners.inner[_e43] = _e45;
            }
        }
    }
    return;
}

Jets read_corners(
    uint interpolant,
    Block block_2,
    uint octant_1,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    Jets jets_4 = {};
    uint implied_1 = 0u;
    uint corner_5 = 0u;
    uint source_2 = {};
    bool loop_init_6 = true;
    while(true) {
        if (!loop_init_6) {
            uint _e88 = corner_5;
            corner_5 = _e88 + 1u;
        }
        loop_init_6 = false;
        uint _e8 = corner_5;
        if (_e8 < 8u) {
        } else {
            break;
        }
        {
            uint _e11 = corner_5;
            uint _e14 = corner_5;
            uint _e19 = corner_5;
            metal::uint3 along = metal::uint3(_e11 >> 2u, (_e14 >> 1u) & 1u, _e19 & 1u);
            metal::uint3 at_2 = along + metal::uint3(octant_1 & 1u, (octant_1 >> 1u) & 1u, octant_1 >> 2u);
            source_2 = 1u << ((at_2.x + (3u * at_2.y)) + (9u * at_2.z));
            uint _e46 = source_2;
            if ((block_2.present & _e46) == 0u) {
                uint _e50 = implied_1;
                uint _e52 = corner_5;
                implied_1 = _e50 | (1u << _e52);
                source_2 = 1u << (((2u * along.x) + (6u * along.y)) + (18u * along.z));
            }
            if (interpolant == INTERPOLANT_TRICUBIC) {
                uint _e71 = corner_5;
                uint _e73 = source_2;
                Jet _e74 = read_jet(block_2, _e73, words, _buffer_sizes);
                jets_4.corners.inner[_e71] = _e74;
            } else {
                uint _e76 = corner_5;
                uint _e78 = source_2;
                float _e79 = read_distance(block_2, _e78, words, _buffer_sizes);
                jets_4.corners.inner[_e76] = Jet {metal::float4(_e79, 0.0, 0.0, 0.0), metal::float4(0.0)};
            }
        }
    }
    uint _e90 = implied_1;
    if (_e90 != 0u) {
        uint _e93 = implied_1;
        settle(jets_4, _e93, octant_1, 0u);
        uint _e95 = implied_1;
        settle(jets_4, _e95, octant_1, 1u);
        uint _e97 = implied_1;
        settle(jets_4, _e97, octant_1, 2u);
    }
    Jets _e99 = jets_4;
    return _e99;
}

Answer trilinear(
    Jets jets_5,
    metal::float3 local_9
) {
    Corners corners_2 = {};
    int corner_6 = 0;
    bool loop_init_7 = true;
    while(true) {
        if (!loop_init_7) {
            int _e16 = corner_6;
            corner_6 = as_type<int>(as_type<uint>(_e16) + as_type<uint>(1));
        }
        loop_init_7 = false;
        int _e5 = corner_6;
        if (_e5 < 8) {
        } else {
            break;
        }
        {
            int _e9 = corner_6;
            int _e12 = corner_6;
            corners_2.at.inner[_e9] = jets_5.corners.inner[_e12].plain;
        }
    }
    metal::float2 x_5 = metal::float2(1.0 - local_9.x, local_9.x);
    metal::float2 y_4 = metal::float2(1.0 - local_9.y, local_9.y);
    metal::float2 z_4 = metal::float2(1.0 - local_9.z, local_9.z);
    metal::float2 slope_3 = metal::float2(-1.0, 1.0);
    Corners _e36 = corners_2;
    metal::float4 _e37 = weighted_sum(_e36, slope_3, y_4, z_4);
    float by_x_2 = _e37.x;
    Corners _e39 = corners_2;
    metal::float4 _e40 = weighted_sum(_e39, x_5, slope_3, z_4);
    float by_y_2 = _e40.x;
    Corners _e42 = corners_2;
    metal::float4 _e43 = weighted_sum(_e42, x_5, y_4, slope_3);
    float by_z_2 = _e43.x;
    Corners _e45 = corners_2;
    metal::float4 _e46 = weighted_sum(_e45, x_5, y_4, z_4);
    return Answer {_e46.x, {}, metal::float3(by_x_2, by_y_2, by_z_2)};
}

Answer evaluate_octree(
    Field field_11,
    metal::float3 position_1,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    uint node = {};
    uint shift_1 = {};
    uint octant_2 = 0u;
    bool local_10 = {};
    Block block_3 = {};
    Jets jets_6 = {};
    Answer answer_1 = {};
    metal::uint3 cell_8 = metal::min(naga_f2u32(position_1), field_11.cells - metal::uint3(1u));
    metal::uint3 root_2 = cell_8 >> metal::uint3(field_11.depth);
    uint _e24 = word((field_11.nodes + root_2.x) + (field_11.counts.x * (root_2.y + (field_11.counts.y * root_2.z))), words, _buffer_sizes);
    node = _e24;
    shift_1 = field_11.depth;
    while(true) {
        uint _e30 = node;
        if ((_e30 >> NODE_OFFSET_BITS) == NODE_INNER) {
            uint _e37 = shift_1;
            local_10 = _e37 > 0u;
        } else {
            local_10 = false;
        }
        bool _e41 = local_10;
        if (_e41) {
        } else {
            break;
        }
        {
            uint _e42 = shift_1;
            shift_1 = _e42 - 1u;
            uint _e45 = shift_1;
            uint _e46 = octant_of(cell_8, _e45);
            octant_2 = _e46;
            uint _e48 = node;
            uint _e52 = octant_2;
            uint _e54 = word((field_11.nodes + (_e48 & NODE_OFFSET_MASK)) + _e52, words, _buffer_sizes);
            node = _e54;
        }
    }
    uint _e55 = shift_1;
    uint _e58 = shift_1;
    uint _e63 = shift_1;
    float _e64 = power_of_half(_e63);
    metal::float3 local_23 = (position_1 - static_cast<metal::float3>((cell_8 >> metal::uint3(_e55)) << metal::uint3(_e58))) * _e64;
    uint _e67 = shift_1;
    uint level = field_11.depth - _e67;
    uint _e70 = node;
    uint start_2 = field_11.samples + (_e70 & NODE_OFFSET_MASK);
    uint _e76 = word(start_2, words, _buffer_sizes);
    block_3.present = _e76 & LATTICE_MASK;
    uint _e80 = word(start_2, words, _buffer_sizes);
    block_3.sample_precision = (_e80 >> PRECISION_SHIFT) & 3u;
    uint _e88 = word(start_2 + 1u, words, _buffer_sizes);
    block_3.full = _e88 & LATTICE_MASK;
    uint _e94 = word(start_2 + 2u, words, _buffer_sizes);
    block_3.base = as_type<int>(_e94);
    block_3.first = start_2 + 3u;
    float _e101 = power_of_half(level);
    block_3.quantum = field_11.quantum * _e101;
    float _e106 = power_of_half(level);
    block_3.edge = field_11.spacing[0] * _e106;
    Block _e109 = block_3;
    uint _e110 = octant_2;
    Jets _e111 = read_corners(field_11.reconstruction, _e109, _e110, words, _buffer_sizes);
    jets_6 = _e111;
    if (field_11.reconstruction == INTERPOLANT_TRICUBIC) {
        Answer _e117 = tricubic(jets_6, local_23);
        answer_1 = _e117;
    } else {
        Jets _e118 = jets_6;
        Answer _e119 = trilinear(_e118, local_23);
        answer_1 = _e119;
    }
    metal::float3 _e121 = answer_1.gradient;
    float _e123 = block_3.edge;
    answer_1.gradient = _e121 * (1.0 / _e123);
    Answer _e127 = answer_1;
    return _e127;
}

uint root_node(
    Field field_12,
    metal::uint3 root,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    uint _e15 = word((field_12.nodes + root.x) + (field_12.counts.x * (root.y + (field_12.counts.y * root.z))), words, _buffer_sizes);
    return _e15;
}

uint bits_at(
    uint section,
    uint bit,
    uint index_6,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    uint at_3 = (section + index_6) + naga_div(bit, 32u);
    uint shift_4 = bit & 31u;
    uint _e9 = word(at_3, words, _buffer_sizes);
    uint _e13 = word(at_3 + 1u, words, _buffer_sizes);
    return (_e9 >> shift_4) | ((_e13 << 1u) << (31u - shift_4));
}

uint child_node(
    Field field_13,
    uint record,
    uint octant_3,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    uint byte = RECORD_LENGTH * record;
    uint _e15 = bits_at(field_13.records, (8u * (byte & 3u)) + (8u * octant_3), naga_div(byte, 4u), words, _buffer_sizes);
    uint start_3 = (octant_3 == 0u) ? 0u : (_e15 & 255u);
    uint _e29 = bits_at(field_13.records, 8u * (byte & 3u), naga_div(byte, 4u), words, _buffer_sizes);
    uint first_bit = 8u * ((byte & 3u) + RECORD_FIRST);
    if (((_e29 >> octant_3) & 1u) == 1u) {
        uint _e44 = bits_at(field_13.records, first_bit, naga_div(byte, 4u), words, _buffer_sizes);
        return (_e44 & RECORD_CHILD_MASK) + start_3;
    }
    uint _e53 = bits_at(field_13.records, first_bit + RECORD_CHILD_BITS, naga_div(byte, 4u), words, _buffer_sizes);
    uint leaf_3 = _e53 & RECORD_LEAF_MASK;
    return ROOT_LEAF | (leaf_3 + start_3);
}

Leaf find_leaf(
    Field field_14,
    metal::uint3 cell_5,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    uint node_1 = {};
    uint shift_2 = {};
    bool local_11 = {};
    metal::uint3 root_3 = cell_5 >> metal::uint3(field_14.depth);
    uint _e5 = root_node(field_14, root_3, words, _buffer_sizes);
    node_1 = _e5;
    shift_2 = field_14.depth;
    while(true) {
        uint _e9 = node_1;
        if ((_e9 & ROOT_LEAF) == 0u) {
            uint _e16 = shift_2;
            local_11 = _e16 > 0u;
        } else {
            local_11 = false;
        }
        bool _e20 = local_11;
        if (_e20) {
        } else {
            break;
        }
        {
            uint _e21 = shift_2;
            shift_2 = _e21 - 1u;
            uint _e24 = node_1;
            uint _e25 = shift_2;
            uint _e26 = octant_of(cell_5, _e25);
            uint _e27 = child_node(field_14, _e24, _e26, words, _buffer_sizes);
            node_1 = _e27;
        }
    }
    uint _e28 = node_1;
    uint _e31 = shift_2;
    uint _e34 = shift_2;
    uint _e37 = shift_2;
    return Leaf {_e28 & 2147483647u, {}, (cell_5 >> metal::uint3(_e31)) << metal::uint3(_e34), _e37};
}

metal::float3 local_of(
    Leaf leaf,
    metal::float3 position_2
) {
    float _e6 = power_of_half(leaf.shift);
    return ((position_2 - static_cast<metal::float3>(leaf.cell)) * (2.0 * _e6)) - metal::float3(1.0);
}

LeafHead read_head(
    Field field_15,
    uint place,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    uint _e9 = bits_at(field_15.samples, 8u * (place & 3u), naga_div(place, 4u), words, _buffer_sizes);
    uint shape = field_15.shapes + (2u * (_e9 & ((1u << field_15.shape_bits) - 1u)));
    uint codes_1 = _e9 >> field_15.shape_bits;
    uint _e22 = word(shape, words, _buffer_sizes);
    uint _e25 = word(shape + 1u, words, _buffer_sizes);
    return LeafHead {_e22, _e25, codes_1 & 3u, (codes_1 >> SUPPORT_BITS) & 3u};
}

float read_code(
    Field field_16,
    uint index_7,
    uint bit_1,
    uint width,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    uint size = 1u << (width & 31u);
    uint _e9 = bits_at(field_16.samples, bit_1, index_7, words, _buffer_sizes);
    uint code_4 = _e9 & (size - 1u);
    return static_cast<float>(as_type<int>(as_type<uint>(static_cast<int>(code_4)) - as_type<uint>(static_cast<int>(size >> 1u))));
}

metal::float3 read_codes(
    Field field_17,
    uint index_8,
    uint bit_2,
    uint width_1,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    float _e4 = read_code(field_17, index_8, bit_2, width_1, words, _buffer_sizes);
    float _e6 = read_code(field_17, index_8, bit_2 + width_1, width_1, words, _buffer_sizes);
    float _e10 = read_code(field_17, index_8, bit_2 + (2u * width_1), width_1, words, _buffer_sizes);
    return metal::float3(_e4, _e6, _e10);
}

Terms read_terms(
    Field field_18,
    uint index_9,
    uint start,
    uint degree,
    uint widths,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    Terms terms = {};
    uint bit_3 = {};
    bit_3 = start;
    uint _e9 = bit_3;
    uint _e11 = byte_of(widths, 0u);
    float _e12 = read_code(field_18, index_9, _e9, _e11, words, _buffer_sizes);
    terms.linear.w = _e12;
    uint _e13 = bit_3;
    uint _e15 = byte_of(widths, 0u);
    bit_3 = _e13 + _e15;
    if (degree >= 1u) {
        uint _e20 = byte_of(widths, 1u);
        uint _e22 = bit_3;
        metal::float3 _e23 = read_codes(field_18, index_9, _e22, _e20, words, _buffer_sizes);
        float _e26 = terms.linear.w;
        terms.linear = metal::float4(_e23, _e26);
        uint _e28 = bit_3;
        bit_3 = _e28 + (3u * _e20);
    }
    if (degree >= 2u) {
        uint _e35 = byte_of(widths, 2u);
        uint _e37 = bit_3;
        metal::float3 _e38 = read_codes(field_18, index_9, _e37, _e35, words, _buffer_sizes);
        terms.square = metal::float4(_e38, 0.0);
        uint _e42 = bit_3;
        metal::float3 _e46 = read_codes(field_18, index_9, _e42 + (3u * _e35), _e35, words, _buffer_sizes);
        terms.cross = metal::float4(_e46, 0.0);
        uint _e49 = bit_3;
        bit_3 = _e49 + (6u * _e35);
    }
    if (degree >= 3u) {
        uint _e56 = byte_of(widths, 3u);
        uint _e58 = bit_3;
        metal::float3 _e59 = read_codes(field_18, index_9, _e58, _e56, words, _buffer_sizes);
        uint _e60 = bit_3;
        float _e64 = read_code(field_18, index_9, _e60 + (9u * _e56), _e56, words, _buffer_sizes);
        terms.cube = metal::float4(_e59, _e64);
        uint _e67 = bit_3;
        metal::float3 _e71 = read_codes(field_18, index_9, _e67 + (3u * _e56), _e56, words, _buffer_sizes);
        terms.next = metal::float4(_e71, 0.0);
        uint _e75 = bit_3;
        metal::float3 _e79 = read_codes(field_18, index_9, _e75 + (6u * _e56), _e56, words, _buffer_sizes);
        terms.previous = metal::float4(_e79, 0.0);
        uint _e82 = bit_3;
        bit_3 = _e82 + (10u * _e56);
    }
    uint _e87 = bit_3;
    terms.end = _e87;
    Terms _e88 = terms;
    return _e88;
}

Answer evaluate_terms(
    Terms terms_1,
    uint degree_1,
    metal::float3 local_12
) {
    metal::float4 value = {};
    metal::float4 slope_1 = {};
    metal::float4 square = {};
    metal::float4 first_2 = metal::float4(local_12, 1.0);
    metal::float4 next = metal::float4(local_12.yzx, 0.0);
    metal::float4 previous = metal::float4(local_12.zxy, 0.0);
    metal::float4 second_1 = metal::float4(((1.5 * (first_2 * first_2)) - metal::float4(0.5)).xyz, 0.0);
    metal::float4 third_1 = metal::float4((first_2 * ((2.5 * (first_2 * first_2)) - metal::float4(1.5))).xyz, (local_12.x * local_12.y) * local_12.z);
    value = terms_1.linear * first_2;
    slope_1 = terms_1.linear;
    if (degree_1 >= 2u) {
        metal::float4 line = terms_1.linear + (terms_1.cross * next);
        square = terms_1.square;
        if (degree_1 >= 3u) {
            metal::float4 _e49 = square;
            square = _e49 + ((terms_1.next * next) + (terms_1.previous * previous));
        }
        metal::float4 _e57 = square;
        value = (line * first_2) + (_e57 * second_1);
        metal::float4 _e64 = square;
        slope_1 = (line + (terms_1.cross.zxyw * previous)) + (_e64 * (3.0 * first_2));
        if (degree_1 >= 3u) {
            metal::float4 _e71 = value;
            value = _e71 + (terms_1.cube * third_1);
            metal::float4 others = (terms_1.next * second_1).zxyw + (terms_1.previous * second_1).yzxw;
            metal::float4 _e82 = slope_1;
            slope_1 = (_e82 + ((terms_1.cube * ((7.5 * (first_2 * first_2)) - metal::float4(1.5))) + others)) + (terms_1.cube.w * (next * previous));
        }
    }
    float _e99 = value.x;
    float _e101 = value.y;
    float _e104 = value.z;
    float _e106 = value.w;
    metal::float4 _e109 = slope_1;
    return Answer {(_e99 + _e101) + (_e104 + _e106), {}, _e109.xyz};
}

float edge_of(
    Field field_19,
    Leaf leaf_1
) {
    float _e7 = power_of_half(field_19.depth - leaf_1.shift);
    return field_19.spacing[0] * _e7;
}

Answer evaluate_leaf(
    Field field_20,
    Leaf leaf_2,
    metal::float3 local_13,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    uint bit_4 = {};
    Answer answer_2 = Answer {0.0, {}, metal::float3(0.0)};
    uint index_10 = 0u;
    bool local_14 = {};
    bool local_15 = {};
    bool local_16 = {};
    bool local_17 = {};
    bool local_18 = {};
    LeafHead _e4 = read_head(field_20, leaf_2.place, words, _buffer_sizes);
    uint widths_1 = _e4.widths;
    uint _e8 = byte_of(_e4.kind_and_degrees, 0u);
    uint _e11 = byte_of(_e4.kind_and_degrees, 3u);
    uint exponent_2 = _e11 & MAX_EXPONENT;
    float step = field_20.quantum * as_type<float>((127u + exponent_2) << 23u);
    bit_4 = ((8u * (leaf_2.place & 3u)) + field_20.shape_bits) + ((field_20.overlap == 0.0) ? 0u : OVERLAP_BITS);
    bool loop_init_8 = true;
    while(true) {
        if (!loop_init_8) {
            uint _e101 = index_10;
            index_10 = _e101 + 1u;
        }
        loop_init_8 = false;
        uint _e43 = index_10;
        if (_e43 < 2u) {
        } else {
            break;
        }
        {
            uint _e46 = index_10;
            if (_e46 == 1u) {
                local_14 = _e8 == KIND_SINGLE;
            } else {
                local_14 = false;
            }
            bool _e54 = local_14;
            if (_e54) {
                break;
            }
            uint _e57 = index_10;
            uint _e59 = byte_of(_e4.kind_and_degrees, 1u + _e57);
            uint _e63 = bit_4;
            Terms _e64 = read_terms(field_20, naga_div(leaf_2.place, 4u), _e63, _e59, widths_1, words, _buffer_sizes);
            bit_4 = _e64.end;
            Answer _e66 = evaluate_terms(_e64, _e59, local_13);
            float _e69 = answer_2.distance;
            bool is_less = _e66.distance < _e69;
            float _e73 = answer_2.distance;
            bool is_greater = _e66.distance > _e73;
            uint _e75 = index_10;
            if (!((_e75 == 0u))) {
                if (_e8 == KIND_MIN) {
                    local_16 = is_less;
                } else {
                    local_16 = false;
                }
                bool _e86 = local_16;
                local_15 = _e86;
            } else {
                local_15 = true;
            }
            bool _e88 = local_15;
            if (!(_e88)) {
                if (_e8 != KIND_MIN) {
                    local_18 = is_greater;
                } else {
                    local_18 = false;
                }
                bool _e97 = local_18;
                local_17 = _e97;
            } else {
                local_17 = true;
            }
            bool _e99 = local_17;
            if (_e99) {
                answer_2 = _e66;
            }
        }
    }
    float _e103 = edge_of(field_20, leaf_2);
    float per_half = 2.0 / _e103;
    float _e107 = answer_2.distance;
    metal::float3 _e110 = answer_2.gradient;
    return Answer {_e107 * step, {}, (_e110 * step) * per_half};
}

metal::float4 weight_at(
    metal::float3 local_19,
    float steepness
) {
    metal::float3 s_1 = metal::clamp(metal::float3(0.5) + ((metal::float3(1.0) - metal::abs(local_19)) * steepness), metal::float3(0.0), metal::float3(1.0));
    metal::float3 w = (s_1 * s_1) * (metal::float3(3.0) - (2.0 * s_1));
    float _e24 = copy_sign(steepness, -(local_19.x));
    float _e27 = copy_sign(steepness, -(local_19.y));
    float _e30 = copy_sign(steepness, -(local_19.z));
    metal::float3 signs_1 = metal::float3(_e24, _e27, _e30);
    metal::float3 slope_4 = ((6.0 * s_1) * (metal::float3(1.0) - s_1)) * signs_1;
    return metal::float4(slope_4.x * (w.y * w.z), slope_4.y * (w.x * w.z), slope_4.z * (w.x * w.y), (w.x * w.y) * w.z);
}

uint children_in(
    metal::uint3 middle_1,
    metal::uint3 low,
    metal::uint3 high
) {
    uint children = 255u;
    uint _e5 = children;
    children = _e5 & (((high.x < middle_1.x) ? 85u : 255u) & ((low.x >= middle_1.x) ? 170u : 255u));
    uint _e20 = children;
    children = _e20 & (((high.y < middle_1.y) ? 51u : 255u) & ((low.y >= middle_1.y) ? 204u : 255u));
    uint _e35 = children;
    children = _e35 & (((high.z < middle_1.z) ? 15u : 255u) & ((low.z >= middle_1.z) ? 240u : 255u));
    uint _e50 = children;
    return _e50;
}

Answer blend(
    Field field_21,
    Leaf own,
    metal::float3 position_3,
    Answer alone,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    float weight = {};
    metal::float3 weight_slope = {};
    float change = 0.0;
    metal::float3 slope_2 = {};
    bool is_alone = true;
    type_14 records = {};
    type_14 pending = {};
    metal::uint3 root_1 = {};
    metal::uint3 cell_6 = metal::uint3(0u);
    uint shift_3 = {};
    bool local_20 = {};
    uint node_2 = {};
    bool local_21 = {};
    LeafHead _e5 = read_head(field_21, own.place, words, _buffer_sizes);
    float steepness_1 = 0.25 / field_21.overlap;
    metal::float3 _e9 = local_of(own, position_3);
    metal::float4 _e15 = weight_at(_e9, steepness_1 * static_cast<float>(1u << _e5.support));
    weight = _e15.w;
    float _e19 = edge_of(field_21, own);
    weight_slope = _e15.xyz * (2.0 / _e19);
    slope_2 = _e15.w * alone.gradient;
    float _e33 = power_of_half(_e5.reach);
    float share = (_e5.reach == 0u) ? LEAST_SUPPORT_SHARE : (_e33 * 2.0);
    float margin = (field_21.overlap * static_cast<float>(1u << own.shift)) * share;
    metal::uint3 last = field_21.cells - metal::uint3(1u);
    metal::uint3 low_1 = metal::min(naga_f2u32(metal::max(position_3 - metal::float3(margin), metal::float3(0.0))), last);
    metal::uint3 high_1 = metal::min(naga_f2u32(position_3 + metal::float3(margin)), last);
    metal::uint3 first_root = low_1 >> metal::uint3(field_21.depth);
    metal::uint3 last_root = high_1 >> metal::uint3(field_21.depth);
    root_1 = first_root;
    shift_3 = field_21.depth;
    while(true) {
        while(true) {
            uint _e77 = shift_3;
            if (_e77 < field_21.depth) {
                uint _e82 = shift_3;
                uint _e86 = pending.inner[_e82 & 15u];
                local_20 = _e86 == 0u;
            } else {
                local_20 = false;
            }
            bool _e90 = local_20;
            if (_e90) {
            } else {
                break;
            }
            {
                uint _e91 = shift_3;
                shift_3 = _e91 + 1u;
            }
        }
        node_2 = uint {};
        uint _e96 = shift_3;
        if (_e96 < field_21.depth) {
            uint _e99 = shift_3;
            uint children_1 = pending.inner[_e99 & 15u];
            uint _e104 = shift_3;
            pending.inner[_e104 & 15u] = children_1 & (children_1 - 1u);
            uint _e117 = count_bits((children_1 & (~(children_1) + 1u)) - 1u);
            metal::uint3 _e118 = cell_6;
            uint _e119 = shift_3;
            uint _e124 = shift_3;
            metal::uint3 parent = (_e118 >> metal::uint3(_e119 + 1u)) << metal::uint3(_e124 + 1u);
            uint _e138 = shift_3;
            cell_6 = parent + (metal::uint3(_e117 & 1u, (_e117 >> 1u) & 1u, _e117 >> 2u) << metal::uint3(_e138));
            uint _e142 = shift_3;
            uint _e146 = records.inner[_e142 & 15u];
            uint _e147 = child_node(field_21, _e146, _e117, words, _buffer_sizes);
            node_2 = _e147;
        } else {
            uint _e149 = root_1.z;
            if (_e149 > last_root.z) {
                break;
            }
            metal::uint3 _e152 = root_1;
            cell_6 = _e152 << metal::uint3(field_21.depth);
            metal::uint3 _e156 = root_1;
            uint _e157 = root_node(field_21, _e156, words, _buffer_sizes);
            node_2 = _e157;
            uint _e159 = root_1.x;
            root_1.x = _e159 + 1u;
            uint _e163 = root_1.x;
            if (_e163 > last_root.x) {
                root_1.x = first_root.x;
                uint _e169 = root_1.y;
                root_1.y = _e169 + 1u;
            }
            uint _e173 = root_1.y;
            if (_e173 > last_root.y) {
                root_1.y = first_root.y;
                uint _e179 = root_1.z;
                root_1.z = _e179 + 1u;
            }
        }
        uint _e182 = node_2;
        if ((_e182 & ROOT_LEAF) == 0u) {
            uint _e189 = shift_3;
            local_21 = _e189 > 0u;
        } else {
            local_21 = false;
        }
        bool _e193 = local_21;
        if (_e193) {
            uint _e194 = shift_3;
            shift_3 = _e194 - 1u;
            uint _e197 = shift_3;
            uint _e201 = node_2;
            records.inner[_e197 & 15u] = _e201;
            uint _e202 = shift_3;
            metal::uint3 _e206 = cell_6;
            uint _e208 = shift_3;
            uint _e212 = children_in(_e206 + metal::uint3(1u << _e208), low_1, high_1);
            pending.inner[_e202 & 15u] = _e212;
            continue;
        }
        uint _e213 = node_2;
        metal::uint3 _e216 = cell_6;
        uint _e217 = shift_3;
        Leaf leaf_4 = Leaf {_e213 & 2147483647u, {}, _e216, _e217};
        if (leaf_4.place == own.place) {
            continue;
        }
        metal::float3 _e222 = local_of(leaf_4, position_3);
        LeafHead _e225 = read_head(field_21, leaf_4.place, words, _buffer_sizes);
        metal::float4 _e230 = weight_at(_e222, steepness_1 * static_cast<float>(1u << _e225.support));
        if (_e230.w > 0.0) {
            is_alone = false;
            Answer _e235 = evaluate_leaf(field_21, leaf_4, _e222, words, _buffer_sizes);
            float difference = _e235.distance - alone.distance;
            float _e240 = edge_of(field_21, leaf_4);
            metal::float3 its_slope = _e230.xyz * (2.0 / _e240);
            float _e244 = weight;
            weight = _e244 + _e230.w;
            float _e247 = change;
            change = _e247 + (_e230.w * difference);
            metal::float3 _e251 = weight_slope;
            weight_slope = _e251 + its_slope;
            metal::float3 _e253 = slope_2;
            slope_2 = _e253 + ((_e230.w * _e235.gradient) + (its_slope * difference));
        }
    }
    bool _e260 = is_alone;
    if (_e260) {
        return alone;
    }
    float _e261 = weight;
    float per_weight = 1.0 / _e261;
    float _e264 = change;
    float mean = _e264 * per_weight;
    metal::float3 _e268 = slope_2;
    metal::float3 _e269 = weight_slope;
    return Answer {alone.distance + mean, {}, (_e268 - (mean * _e269)) * per_weight};
}

Answer evaluate_polynomial_octree(
    Field field_22,
    metal::float3 position_4,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    Leaf _e8 = find_leaf(field_22, metal::min(naga_f2u32(position_4), field_22.cells - metal::uint3(1u)), words, _buffer_sizes);
    metal::float3 _e9 = local_of(_e8, position_4);
    Answer _e10 = evaluate_leaf(field_22, _e8, _e9, words, _buffer_sizes);
    if (field_22.overlap == 0.0) {
        return _e10;
    }
    LeafHead _e15 = read_head(field_22, _e8.place, words, _buffer_sizes);
    uint reach = _e15.reach;
    float _e17 = power_of_half(reach);
    float share_1 = (reach == 0u) ? 128.0 : (_e17 * 4.0);
    if (metal::max(metal::max(metal::abs(_e9.x), metal::abs(_e9.y)), metal::abs(_e9.z)) > (1.0 - (field_22.overlap * share_1))) {
        Answer _e37 = blend(field_22, _e8, position_4, _e10, words, _buffer_sizes);
        return _e37;
    }
    return _e10;
}

Answer answer_inside(
    Field field_23,
    metal::float3 point_1,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    metal::float3 position_5 = metal::min((point_1 - field_23.low) * field_23.cells_per_unit, static_cast<metal::float3>(field_23.cells));
    switch(field_23.family) {
        case 1u: {
            Answer _e10 = evaluate_grid(field_23, position_5, words, _buffer_sizes);
            return _e10;
        }
        case 2u: {
            Answer _e11 = evaluate_octree(field_23, position_5, words, _buffer_sizes);
            return _e11;
        }
        default: {
            Answer _e12 = evaluate_polynomial_octree(field_23, position_5, words, _buffer_sizes);
            return _e12;
        }
    }
}

Answer nearfield_evaluate(
    Field field_24,
    metal::float3 point_2,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    Answer answer_3 = {};
    metal::uint3 bits_5 = as_type<metal::uint3>(point_2) & metal::uint3(2147483647u);
    if (metal::any(bits_5 >= metal::uint3(2139095040u))) {
        Answer _e10 = answer_without_end(bits_5, point_2);
        return _e10;
    }
    metal::float3 nearest_1 = metal::min(metal::max(point_2, field_24.low), field_24.high);
    Answer _e15 = answer_inside(field_24, nearest_1, words, _buffer_sizes);
    answer_3 = _e15;
    if (metal::any(nearest_1 != point_2)) {
        Answer _e20 = length_and_direction(point_2 - nearest_1);
        float _e23 = answer_3.distance;
        answer_3.distance = metal::min(_e23 + _e20.distance, MAX_FLOAT);
        answer_3.gradient = _e20.gradient;
    }
    Answer _e30 = answer_3;
    return _e30;
}

float nearfield_distance(
    Field field_25,
    metal::float3 point_3,
    device type_1 const& words,
    constant _mslBufferSizes& _buffer_sizes
) {
    Answer _e2 = nearfield_evaluate(field_25, point_3, words, _buffer_sizes);
    return _e2.distance;
}

struct queryInput {
};
kernel void query(
  metal::uint3 invocation [[thread_position_in_grid]]
, device type_1 const& words [[buffer(0)]]
, device type_15 const& points [[buffer(1)]]
, device type_16& answers [[buffer(2)]]
, constant _mslBufferSizes& _buffer_sizes [[buffer(3)]]
) {
    bool local = {};
    uint index_11 = invocation.x;
    if (!((index_11 >= (1 + (_buffer_sizes.size2 - 0 - 16) / 16)))) {
        local = ((3u * index_11) + 2u) >= (1 + (_buffer_sizes.size1 - 0 - 4) / 4);
    } else {
        local = true;
    }
    bool _e16 = local;
    if (_e16) {
        return;
    }
    float _e21 = points[3u * index_11];
    float _e28 = points[(3u * index_11) + 1u];
    float _e35 = points[(3u * index_11) + 2u];
    metal::float3 point_4 = metal::float3(_e21, _e28, _e35);
    Field _e37 = nearfield_open(words, _buffer_sizes);
    Answer _e38 = nearfield_evaluate(_e37, point_4, words, _buffer_sizes);
    answers[index_11] = metal::float4(_e38.distance, _e38.gradient);
    return;
}
