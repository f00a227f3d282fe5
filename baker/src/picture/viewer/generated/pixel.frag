#version 300 es

precision highp float;
precision highp int;

struct Field {
    uint family;
    vec3 low;
    vec3 high;
    uvec3 counts;
    uvec3 cells;
    vec3 cells_per_unit;
    vec3 spacing;
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
};
struct Answer {
    float distance_;
    vec3 gradient;
};
struct Polynomial {
    float constant;
    vec3 first;
    vec3 square;
    vec3 cross_;
    vec3 cube;
    vec3 mixed;
    vec3 more;
    float xyz;
};
struct Corners {
    vec4 at[8];
};
struct Jet {
    vec4 plain;
    vec4 by_x;
};
struct Jets {
    Jet corners[8];
};
struct Face {
    vec4 corners[4];
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
    uvec3 cell;
    uint shift;
};
struct LeafHead {
    uint kind_and_degrees;
    uint widths;
    uint support;
    uint reach;
};
struct Terms {
    vec4 linear;
    vec4 square;
    vec4 cross_;
    vec4 cube;
    vec4 next;
    vec4 previous;
    uint end;
};
struct Corner {
    vec4 position;
    vec2 place;
};
struct View {
    vec3 eye;
    float pixel;
    vec3 forward;
    float size;
    vec3 right;
    float half_width;
    vec3 up;
    float half_height;
    vec3 cut;
    float cut_at;
    float offset;
    float deepest;
    float spacing;
    uint antialias;
    uint show;
};
const uint FAMILY_WORD = 4u;
const uint FAMILY_BYTE = 0u;
const uint BOX_MIN_WORD = 6u;
const uint BOX_MAX_WORD = 9u;
const uint SECTION_COUNT_WORD = 4u;
const uint SECTION_COUNT_BYTE = 2u;
const uint MAX_SECTIONS = 16u;
const uint TABLE_WORD = 32u;
const uint SECTION_WORDS = 4u;
const uint SECTION_OCTREE = 1381253967u;
const uint FAMILY_OCTREE = 2u;
const uint SECTION_GRID = 1145655879u;
const uint FAMILY_GRID = 1u;
const uint SECTION_POLYNOMIAL = 1163023440u;
const uint FAMILY_POLYNOMIAL = 3u;
const uint SECTION_NODES = 1162104654u;
const uint SECTION_BASES = 1163084098u;
const uint SECTION_ROOTS = 1414483794u;
const uint SECTION_SAMPLES = 1347240275u;
const uint SECTION_LEAVES = 1178682700u;
const uint SECTION_SHAPES = 1162889299u;
const uint SECTION_RECORDS = 1162170964u;
const uint MAX_DEPTH = 16u;
const uint LIPSCHITZ_WORD = 14u;
const uint SAMPLE_COUNT_WORD = 22u;
const uint UNIFORM_MAX_WORD = 17u;
const uint BAND_MAX_WORD = 20u;
const float MAX_FLOAT = 3.4028235e38;
const uint RECONSTRUCTION_NEAREST = 0u;
const uint PRECISION_F32_ = 2u;
const uint PRECISION_PACKED32_ = 0u;
const uint MAX_MAGNITUDE_BITS = 1568669696u;
const uint RANGE_BRICK = 1u;
const uint BRICK_EDGE = 4u;
const uint DISTANCE_SHIFT = 20u;
const uint GRADIENT_MASK = 1023u;
const uint GRADIENT_BITS = 10u;
const int GRADIENT_CENTRE = 511;
const float GRADIENT_STEP = 0.0019569471;
const float SUBNORMAL_STEP = 5.9604645e-8;
const uint RECONSTRUCTION_HERMITE = 4u;
const uint RECONSTRUCTION_BLEND = 3u;
const uint RECONSTRUCTION_HALF = 2u;
const uint NODE_OFFSET_BITS = 28u;
const uint NODE_INNER = 0u;
const uint NODE_OFFSET_MASK = 268435455u;
const uint LATTICE_MASK = 134217727u;
const uint PRECISION_SHIFT = 27u;
const uint INTERPOLANT_TRICUBIC = 1u;
const uint PRECISION_F16_ = 1u;
const uint ROOT_LEAF = 2147483648u;
const uint RECORD_LENGTH = 14u;
const uint RECORD_FIRST = 8u;
const uint RECORD_CHILD_MASK = 2097151u;
const uint RECORD_CHILD_BITS = 21u;
const uint RECORD_LEAF_MASK = 134217727u;
const uint SUPPORT_BITS = 2u;
const uint MAX_EXPONENT = 15u;
const uint OVERLAP_BITS = 4u;
const uint KIND_SINGLE = 0u;
const uint KIND_MIN = 1u;
const float MIN_OVERLAP = 0.015625;
const uint MAX_LEVELS_APART = 5u;
const uint MAX_SUPPORT = 3u;
const float LEAST_SUPPORT_SHARE = 4.0;
const uint SHOW_OCCLUSION = 1u;
const uint SHOW_SHADOW = 2u;
const uint SHOW_NORMALS = 4u;
const uint MAX_STEPS = 512u;
const float ARRIVED = 0.25;
const vec3 CLAY = vec3(0.62, 0.6, 0.56);
const vec3 BACKGROUND = vec3(1.0);
const vec3 LAMP = vec3(-0.55, 0.8, 0.6);
const float SHADOW_SHARPNESS = 12.0;
const uint PROBES = 5u;
const float ALL_PROBES = 2.7731;
const uint TRACE = 0u;
const uint OCCLUSION = 1u;
const uint SHADOW = 2u;
const uint PLANE = 3u;

uniform highp usampler2D _group_0_binding_0_fs;

layout(std140) uniform View_block_0Fragment { View _group_0_binding_1_fs; };

smooth in vec2 _vs2fs_location0;
layout(location = 0) out vec4 _fs2p_location0;

uint word(uint index_2) {
    uvec2 size = uvec2(textureSize(_group_0_binding_0_fs, 0).xy);
    uint texel = (index_2 / 4u);
    uint row = (texel / size.x);
    if ((row >= size.y)) {
        return 0u;
    }
    uvec4 _e17 = texelFetch(_group_0_binding_0_fs, ivec2(uvec2((texel - (row * size.x)), row)), 0);
    return _e17[(index_2 & 3u)];
}

uint byte_of(uint bits, uint number) {
    return ((bits >> (8u * number)) & 255u);
}

float float_(uint index_3) {
    uint _e1 = word(index_3);
    return uintBitsToFloat(_e1);
}

Field nearfield_open() {
    Field field = Field(0u, vec3(0.0), vec3(0.0), uvec3(0u), uvec3(0u), vec3(0.0), vec3(0.0), 0.0, 0u, 0u, 0u, 0u, 0u, 0u, 0.0, 0u, 0u, 0u, 0u);
    uint parameters = 0u;
    uint index_4 = 0u;
    uint _e3 = word(FAMILY_WORD);
    uint _e5 = byte_of(_e3, FAMILY_BYTE);
    field.family = _e5;
    float _e8 = float_(BOX_MIN_WORD);
    float _e10 = float_(7u);
    float _e12 = float_(8u);
    field.low = vec3(_e8, _e10, _e12);
    float _e16 = float_(BOX_MAX_WORD);
    float _e18 = float_(10u);
    float _e20 = float_(11u);
    field.high = vec3(_e16, _e18, _e20);
    uint _e25 = word(SECTION_COUNT_WORD);
    uint _e27 = byte_of(_e25, SECTION_COUNT_BYTE);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e85 = index_4;
            index_4 = (_e85 + 1u);
        }
        loop_init = false;
        uint _e30 = index_4;
        if ((_e30 < min(_e27, MAX_SECTIONS))) {
        } else {
            break;
        }
        {
            uint _e36 = index_4;
            uint entry = (TABLE_WORD + (SECTION_WORDS * _e36));
            uint _e41 = word((entry + 1u));
            uint start_1 = (_e41 / 4u);
            uint _e44 = word(entry);
            switch(_e44) {
                case 1381253967u: {
                    uint _e46 = field.family;
                    if ((_e46 == FAMILY_OCTREE)) {
                        parameters = start_1;
                    }
                    break;
                }
                case 1145655879u: {
                    uint _e50 = field.family;
                    if ((_e50 == FAMILY_GRID)) {
                        parameters = start_1;
                    }
                    break;
                }
                case 1163023440u: {
                    uint _e54 = field.family;
                    if ((_e54 == FAMILY_POLYNOMIAL)) {
                        parameters = start_1;
                    }
                    break;
                }
                case 1162104654u: {
                    uint _e58 = field.family;
                    if ((_e58 == FAMILY_OCTREE)) {
                        field.nodes = start_1;
                    }
                    break;
                }
                case 1163084098u: {
                    uint _e63 = field.family;
                    if ((_e63 == FAMILY_GRID)) {
                        field.nodes = start_1;
                    }
                    break;
                }
                case 1414483794u: {
                    uint _e68 = field.family;
                    if ((_e68 == FAMILY_POLYNOMIAL)) {
                        field.nodes = start_1;
                    }
                    break;
                }
                case 1347240275u: {
                    uint _e73 = field.family;
                    if ((_e73 != FAMILY_POLYNOMIAL)) {
                        field.samples = start_1;
                    }
                    break;
                }
                case 1178682700u: {
                    uint _e78 = field.family;
                    if ((_e78 == FAMILY_POLYNOMIAL)) {
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
    uint _e88 = word(_e87);
    uint _e89 = parameters;
    uint _e92 = word((_e89 + 1u));
    uint _e93 = parameters;
    uint _e96 = word((_e93 + 2u));
    field.counts = uvec3((_e88 & 65535u), (_e88 >> 16u), (_e92 & 65535u));
    uint _e106 = field.family;
    if ((_e106 == FAMILY_GRID)) {
        uint _e111 = byte_of(_e92, 2u);
        field.order = _e111;
        uint _e114 = byte_of(_e92, 3u);
        field.reconstruction = _e114;
        uint _e117 = byte_of(_e96, 0u);
        field.sample_precision = _e117;
        uint _e120 = byte_of(_e96, 1u);
        field.range = _e120;
        uvec3 _e123 = field.counts;
        field.cells = (_e123 - uvec3(1u));
        uint _e128 = parameters;
        float _e131 = float_((_e128 + 3u));
        uint _e132 = parameters;
        float _e135 = float_((_e132 + 4u));
        uint _e136 = parameters;
        float _e139 = float_((_e136 + 5u));
        field.spacing = vec3(_e131, _e135, _e139);
        vec3 _e143 = field.spacing;
        field.cells_per_unit = (vec3(1.0) / _e143);
        uint _e148 = parameters;
        float _e151 = float_((_e148 + 6u));
        field.quantum = _e151;
    } else {
        uint _e154 = byte_of(_e92, 2u);
        field.depth = min(_e154, MAX_DEPTH);
        uint _e159 = byte_of(_e92, 3u);
        field.reconstruction = _e159;
        uint _e162 = byte_of(_e92, 3u);
        field.shape_bits = _e162;
        uvec3 _e165 = field.counts;
        uint _e167 = field.depth;
        field.cells = (_e165 << uvec3(_e167));
        uint _e171 = parameters;
        float _e174 = float_((_e171 + 3u));
        field.spacing = vec3(_e174);
        uint _e179 = field.depth;
        float _e184 = field.spacing.x;
        field.cells_per_unit = vec3((float((1u << _e179)) / _e184));
        uint _e188 = parameters;
        float _e191 = float_((_e188 + 4u));
        field.quantum = _e191;
        uint _e193 = field.family;
        if ((_e193 == FAMILY_POLYNOMIAL)) {
            uint _e197 = parameters;
            float _e200 = float_((_e197 + 5u));
            field.overlap = _e200;
        }
    }
    Field _e201 = field;
    return _e201;
}

float nearfield_slope() {
    float _e1 = float_(LIPSCHITZ_WORD);
    return _e1;
}

float nearfield_error() {
    uint _e1 = word(SAMPLE_COUNT_WORD);
    if ((_e1 == 0u)) {
        return 0.0;
    }
    float _e6 = float_(UNIFORM_MAX_WORD);
    float _e8 = float_(BAND_MAX_WORD);
    return max(_e6, _e8);
}

float reciprocal_sqrt(float x) {
    float seed = (2.8898656 - (x * (4.8495784 - (x * (4.646499 - (x * 1.6896812))))));
    float half_1 = (0.5 * x);
    float coarse = (seed * (1.5 - (half_1 * (seed * seed))));
    return (coarse + (coarse * (0.5 - (half_1 * (coarse * coarse)))));
}

Answer length_and_direction(vec3 vector) {
    float largest = max(max(abs(vector.x), abs(vector.y)), abs(vector.z));
    vec3 scaled = (vector / vec3(largest));
    float taxicab = ((abs(scaled.x) + abs(scaled.y)) + abs(scaled.z));
    vec3 place_2 = (scaled / vec3(taxicab));
    float squared = (((place_2.x * place_2.x) + (place_2.y * place_2.y)) + (place_2.z * place_2.z));
    float _e32 = reciprocal_sqrt(squared);
    float length_ = min(((taxicab * (squared * _e32)) * largest), MAX_FLOAT);
    return Answer(length_, (place_2 * _e32));
}

Answer answer_without_end(uvec3 bits_1, vec3 point) {
    if (any(greaterThan(bits_1, uvec3(2139095040u)))) {
        float nan = uintBitsToFloat(max(max(bits_1.x, bits_1.y), bits_1.z));
        return Answer(nan, vec3(nan));
    }
    uvec3 signs = (floatBitsToUint(point) & uvec3(2147483648u));
    vec3 ones = uintBitsToFloat((signs | uvec3(1065353216u)));
    vec3 toward = mix(vec3(0.0), ones, equal(bits_1, uvec3(2139095040u)));
    Answer _e34 = length_and_direction(toward);
    return Answer(uintBitsToFloat(max(max(bits_1.x, bits_1.y), bits_1.z)), _e34.gradient);
}

Answer polynomial_at(Polynomial p, vec3 at_1, vec4 factors) {
    float x_3 = at_1.x;
    float y_2 = at_1.y;
    float z_2 = at_1.z;
    float first_1 = (((p.first.x * x_3) + (p.first.y * y_2)) + (p.first.z * z_2));
    float second = ((((((p.square.x * x_3) + (p.cross_.x * y_2)) + (p.cross_.y * z_2)) * x_3) + (((p.square.y * y_2) + (p.cross_.z * z_2)) * y_2)) + (p.square.z * (z_2 * z_2)));
    float third = (((((((((p.cube.x * x_3) + (p.mixed.x * y_2)) + (p.mixed.y * z_2)) * x_3) + (((p.mixed.z * y_2) + (p.xyz * z_2)) * y_2)) + (p.more.x * (z_2 * z_2))) * x_3) + (((((p.cube.y * y_2) + (p.more.y * z_2)) * y_2) + (p.more.z * (z_2 * z_2))) * y_2)) + (p.cube.z * ((z_2 * z_2) * z_2)));
    float value_1 = ((((p.constant * factors.x) + (first_1 * factors.y)) + (second * factors.z)) + (third * factors.w));
    float by_x = (((p.first.x * factors.y) + (((((2.0 * p.square.x) * x_3) + (p.cross_.x * y_2)) + (p.cross_.y * z_2)) * factors.z)) + (((((((3.0 * p.cube.x) * x_3) + (2.0 * ((p.mixed.x * y_2) + (p.mixed.y * z_2)))) * x_3) + (((p.mixed.z * y_2) + (p.xyz * z_2)) * y_2)) + (p.more.x * (z_2 * z_2))) * factors.w));
    float by_y = (((p.first.y * factors.y) + (((((2.0 * p.square.y) * y_2) + (p.cross_.x * x_3)) + (p.cross_.z * z_2)) * factors.z)) + (((((((3.0 * p.cube.y) * y_2) + (2.0 * ((p.mixed.z * x_3) + (p.more.y * z_2)))) * y_2) + (((p.mixed.x * x_3) + (p.xyz * z_2)) * x_3)) + (p.more.z * (z_2 * z_2))) * factors.w));
    float by_z = (((p.first.z * factors.y) + (((((2.0 * p.square.z) * z_2) + (p.cross_.y * x_3)) + (p.cross_.z * y_2)) * factors.z)) + (((((((3.0 * p.cube.z) * z_2) + (2.0 * ((p.more.x * x_3) + (p.more.z * y_2)))) * z_2) + (((p.mixed.y * x_3) + (p.xyz * y_2)) * x_3)) + (p.more.y * (y_2 * y_2))) * factors.w));
    return Answer(value_1, vec3(by_x, by_y, by_z));
}

uvec2 coefficient(Field field_1, uint number_1, uint index_5) {
    uint count = 1u;
    uint half_ = 0u;
    bool local = false;
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
    if ((field_1.sample_precision == PRECISION_F32_)) {
        uint _e13 = count;
        return uvec2(((field_1.samples + (number_1 * _e13)) + index_5), 0u);
    }
    uint _e19 = count;
    half_ = ((number_1 * _e19) + index_5);
    if ((field_1.sample_precision == PRECISION_PACKED32_)) {
        local = (field_1.order > 0u);
    } else {
        local = false;
    }
    bool _e32 = local;
    if (_e32) {
        uint _e33 = count;
        half_ = (((number_1 * (_e33 - 2u)) + max(index_5, 2u)) - 2u);
    }
    uint _e43 = half_;
    uint _e48 = half_;
    return uvec2((field_1.samples + (_e43 / 2u)), (16u * (_e48 & 1u)));
}

float sample_float(uint index_6) {
    uint _e1 = word(index_6);
    return (((_e1 & 2147483647u) <= MAX_MAGNITUDE_BITS) ? uintBitsToFloat(_e1) : 0.0);
}

float decode_distance(int base, uint code, float quantum) {
    return (float((base + int(code))) * quantum);
}

float read_constant(Field field_2, uvec3 vertex, uint number_2) {
    uint brick = 0u;
    uint code_1 = 0u;
    bool local_1 = false;
    uvec2 _e4 = coefficient(field_2, number_2, 0u);
    if ((field_2.sample_precision == PRECISION_F32_)) {
        float _e9 = sample_float(_e4.x);
        return _e9;
    }
    if ((field_2.range == RANGE_BRICK)) {
        uvec3 bricks = ((field_2.counts + uvec3(3u)) / uvec3(4u));
        uvec3 at_2 = (vertex / uvec3(4u));
        brick = (at_2.x + (bricks.x * (at_2.y + (bricks.y * at_2.z))));
    }
    uint _e35 = word(_e4.x);
    code_1 = ((_e35 >> _e4.y) & 65535u);
    if ((field_2.sample_precision == PRECISION_PACKED32_)) {
        local_1 = (field_2.order > 0u);
    } else {
        local_1 = false;
    }
    bool _e50 = local_1;
    if (_e50) {
        uint _e52 = word(_e4.x);
        code_1 = (_e52 >> DISTANCE_SHIFT);
    }
    uint _e56 = brick;
    uint _e58 = word((field_2.nodes + _e56));
    uint _e60 = code_1;
    float _e62 = decode_distance(int(_e58), _e60, field_2.quantum);
    return _e62;
}

float copy_sign(float magnitude, float sign_) {
    return uintBitsToFloat((floatBitsToUint(abs(magnitude)) | (floatBitsToUint(sign_) & 2147483648u)));
}

vec3 decode_gradient(uint code_2) {
    ivec2 codes = (ivec2(uvec2((code_2 & GRADIENT_MASK), ((code_2 >> GRADIENT_BITS) & GRADIENT_MASK))) - ivec2(511));
    vec2 flat_ = (vec2(codes) * GRADIENT_STEP);
    float z_3 = ((1.0 - abs(flat_.x)) - abs(flat_.y));
    float fold = max(-(z_3), 0.0);
    float _e27 = copy_sign(fold, flat_.x);
    float x_4 = (flat_.x - _e27);
    float _e31 = copy_sign(fold, flat_.y);
    float y_3 = (flat_.y - _e31);
    float _e39 = reciprocal_sqrt((((x_4 * x_4) + (y_3 * y_3)) + (z_3 * z_3)));
    return (vec3(x_4, y_3, z_3) * _e39);
}

float decode_half(uint bits_2) {
    uint sign_1 = ((bits_2 & 32768u) << 16u);
    uint exponent_1 = ((bits_2 >> 10u) & 31u);
    uint fraction = (bits_2 & 1023u);
    if ((exponent_1 == 0u)) {
        return uintBitsToFloat((sign_1 | floatBitsToUint((float(fraction) * SUBNORMAL_STEP))));
    }
    return uintBitsToFloat((sign_1 | ((exponent_1 == 31u) ? 0u : (((exponent_1 + 112u) << 23u) | (fraction << 13u)))));
}

float read_number(Field field_3, uint number_3, uint index_7) {
    uvec2 _e3 = coefficient(field_3, number_3, index_7);
    if ((field_3.sample_precision == PRECISION_F32_)) {
        float _e8 = sample_float(_e3.x);
        return _e8;
    }
    uint _e10 = word(_e3.x);
    float _e13 = decode_half((_e10 >> _e3.y));
    return _e13;
}

vec3 read_three(Field field_4, uint number_4, uint first) {
    float _e3 = read_number(field_4, number_4, first);
    float _e6 = read_number(field_4, number_4, (first + 1u));
    float _e9 = read_number(field_4, number_4, (first + 2u));
    return vec3(_e3, _e6, _e9);
}

Polynomial read_polynomial(Field field_5, uvec3 vertex_1) {
    Polynomial sample_ = Polynomial(0.0, vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
    uint number_5 = (vertex_1.x + (field_5.counts.x * (vertex_1.y + (field_5.counts.y * vertex_1.z))));
    float _e15 = read_constant(field_5, vertex_1, number_5);
    sample_.constant = _e15;
    if ((field_5.order == 0u)) {
        Polynomial _e19 = sample_;
        return _e19;
    }
    if ((field_5.sample_precision == PRECISION_PACKED32_)) {
        uvec2 _e25 = coefficient(field_5, number_5, 0u);
        uint _e27 = word(_e25.x);
        vec3 _e28 = decode_gradient(_e27);
        sample_.first = _e28;
    } else {
        vec3 _e31 = read_three(field_5, number_5, 1u);
        sample_.first = _e31;
    }
    if ((field_5.order >= 2u)) {
        vec3 _e37 = read_three(field_5, number_5, 4u);
        sample_.square = _e37;
        vec3 _e40 = read_three(field_5, number_5, 7u);
        sample_.cross_ = _e40;
    }
    if ((field_5.order >= 3u)) {
        vec3 _e46 = read_three(field_5, number_5, 10u);
        sample_.cube = _e46;
        vec3 _e49 = read_three(field_5, number_5, 13u);
        sample_.mixed = _e49;
        vec3 _e52 = read_three(field_5, number_5, 16u);
        sample_.more = _e52;
        float _e55 = read_number(field_5, number_5, 19u);
        sample_.xyz = _e55;
    }
    vec3 s = field_5.spacing;
    vec3 r = (s / vec3(max(max(s.x, s.y), s.z)));
    vec3 _e65 = sample_.first;
    sample_.first = (_e65 * s);
    vec3 _e68 = sample_.square;
    sample_.square = (_e68 * (s * r));
    vec3 _e72 = sample_.cross_;
    sample_.cross_ = (_e72 * (s.xxy * r.yzz));
    vec3 _e78 = sample_.cube;
    sample_.cube = (_e78 * ((s * r) * r));
    vec3 _e83 = sample_.mixed;
    sample_.mixed = (_e83 * ((s.xxx * r.xxy) * r.yzy));
    vec3 _e91 = sample_.more;
    sample_.more = (_e91 * ((s.xyy * r.zyz) * r.zzz));
    float _e99 = sample_.xyz;
    sample_.xyz = (_e99 * ((s.x * r.y) * r.z));
    Polynomial _e106 = sample_;
    return _e106;
}

vec4 factors_of(Field field_6) {
    if ((field_6.reconstruction != RECONSTRUCTION_HALF)) {
        return vec4(1.0);
    }
    switch(field_6.order) {
        case 1u: {
            return vec4(1.0, 0.5, 0.0, 0.0);
        }
        case 2u: {
            return vec4(1.0, 0.6666667, 0.33333334, 0.0);
        }
        default: {
            return vec4(1.0, 0.75, 0.5, 0.25);
        }
    }
}

uvec3 vertex_of(uvec3 cell, uint corner_1) {
    return (cell + uvec3((corner_1 >> 2u), ((corner_1 >> 1u) & 1u), (corner_1 & 1u)));
}

vec4 weights_of(uint smoothness, float t) {
    float end = 0.0;
    float slope = 1.0;
    float rest = (1.0 - t);
    end = t;
    if ((smoothness == 1u)) {
        end = ((t * t) * (3.0 - (2.0 * t)));
        slope = ((6.0 * t) * rest);
    } else {
        if ((smoothness == 2u)) {
            end = (((t * t) * t) * (10.0 - (t * (15.0 - (6.0 * t)))));
            slope = ((30.0 * (t * t)) * (rest * rest));
        } else {
            if ((smoothness == 3u)) {
                float square_1 = (t * t);
                float cube = (((t * rest) * (t * rest)) * (t * rest));
                end = ((square_1 * square_1) * (35.0 - (t * (84.0 - (t * (70.0 - (20.0 * t)))))));
                slope = (140.0 * cube);
            }
        }
    }
    float _e57 = end;
    float _e60 = end;
    float _e61 = slope;
    float _e63 = slope;
    return vec4((1.0 - _e57), _e60, -(_e61), _e63);
}

vec4 weighted_sum(Corners corners, vec2 x_1, vec2 y, vec2 z) {
    vec4 a = ((corners.at[0] * x_1.x) + (corners.at[4] * x_1.y));
    vec4 b = ((corners.at[1] * x_1.x) + (corners.at[5] * x_1.y));
    vec4 c = ((corners.at[2] * x_1.x) + (corners.at[6] * x_1.y));
    vec4 d = ((corners.at[3] * x_1.x) + (corners.at[7] * x_1.y));
    return ((((a * y.x) + (c * y.y)) * z.x) + (((b * y.x) + (d * y.y)) * z.y));
}

Answer weighted_polynomials(Field field_7, uvec3 cell_1, vec3 local_2) {
    Corners corners_1 = Corners(vec4[8](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)));
    uint corner_2 = 0u;
    uint smoothness_1 = ((field_7.reconstruction == RECONSTRUCTION_BLEND) ? field_7.order : 0u);
    vec4 _e9 = factors_of(field_7);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e33 = corner_2;
            corner_2 = (_e33 + 1u);
        }
        loop_init_1 = false;
        uint _e13 = corner_2;
        if ((_e13 < 8u)) {
        } else {
            break;
        }
        {
            uint _e16 = corner_2;
            uvec3 _e17 = vertex_of(cell_1, _e16);
            Polynomial _e18 = read_polynomial(field_7, _e17);
            uint _e21 = corner_2;
            uvec3 _e22 = vertex_of(uvec3(0u), _e21);
            Answer _e25 = polynomial_at(_e18, (local_2 - vec3(_e22)), _e9);
            uint _e27 = corner_2;
            corners_1.at[_e27] = vec4(_e25.gradient, _e25.distance_);
        }
    }
    vec4 _e36 = weights_of(smoothness_1, local_2.x);
    vec4 _e38 = weights_of(smoothness_1, local_2.y);
    vec4 _e40 = weights_of(smoothness_1, local_2.z);
    Corners _e41 = corners_1;
    vec4 _e45 = weighted_sum(_e41, _e36.xy, _e38.xy, _e40.xy);
    Corners _e46 = corners_1;
    vec4 _e50 = weighted_sum(_e46, _e36.zw, _e38.xy, _e40.xy);
    float by_x_1 = _e50.w;
    Corners _e52 = corners_1;
    vec4 _e56 = weighted_sum(_e52, _e36.xy, _e38.zw, _e40.xy);
    float by_y_1 = _e56.w;
    Corners _e58 = corners_1;
    vec4 _e62 = weighted_sum(_e58, _e36.xy, _e38.xy, _e40.zw);
    float by_z_1 = _e62.w;
    return Answer(_e45.w, (vec3(by_x_1, by_y_1, by_z_1) + _e45.xyz));
}

Face at_x(inout Jets jets, vec4 weights) {
    Face face = Face(vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)));
    int edge = 0;
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            int _e37 = edge;
            edge = (_e37 + 1);
        }
        loop_init_2 = false;
        int _e5 = edge;
        if ((_e5 < 4)) {
        } else {
            break;
        }
        {
            int _e9 = edge;
            Jet near_1 = jets.corners[_e9];
            int _e13 = edge;
            Jet far_1 = jets.corners[(_e13 + 4)];
            int _e19 = edge;
            face.corners[_e19] = (((near_1.plain * weights.x) + (far_1.plain * weights.y)) + ((near_1.by_x * weights.z) + (far_1.by_x * weights.w)));
        }
    }
    Face _e39 = face;
    return _e39;
}

vec4 cubic(float t_1) {
    float rest_1 = (1.0 - t_1);
    float end_3 = ((t_1 * t_1) * (3.0 - (2.0 * t_1)));
    return vec4((1.0 - end_3), end_3, (t_1 * (rest_1 * rest_1)), (-((t_1 * t_1)) * rest_1));
}

vec4 at_y(Face face_1, vec4 weights_1) {
    vec4 near_y = vec4(face_1.corners[0].xy, face_1.corners[1].xy);
    vec4 far_y = vec4(face_1.corners[2].xy, face_1.corners[3].xy);
    vec4 near_y_slope = vec4(face_1.corners[0].zw, face_1.corners[1].zw);
    vec4 far_y_slope = vec4(face_1.corners[2].zw, face_1.corners[3].zw);
    return (((near_y * weights_1.x) + (far_y * weights_1.y)) + ((near_y_slope * weights_1.z) + (far_y_slope * weights_1.w)));
}

float at_z(vec4 edge_1, vec4 weights_2) {
    return (((edge_1.x * weights_2.x) + (edge_1.z * weights_2.y)) + ((edge_1.y * weights_2.z) + (edge_1.w * weights_2.w)));
}

vec4 cubic_slope(float t_2) {
    float end_4 = ((6.0 * t_2) * (1.0 - t_2));
    return vec4(-(end_4), end_4, ((1.0 - t_2) * (1.0 - (3.0 * t_2))), (t_2 * ((3.0 * t_2) - 2.0)));
}

Answer tricubic(inout Jets jets_1, vec3 local_3) {
    vec4 _e3 = cubic(local_3.x);
    Face _e4 = at_x(jets_1, _e3);
    vec4 _e6 = cubic(local_3.y);
    vec4 _e8 = cubic(local_3.z);
    vec4 _e9 = at_y(_e4, _e6);
    vec4 _e11 = cubic_slope(local_3.x);
    Face _e12 = at_x(jets_1, _e11);
    vec4 _e13 = at_y(_e12, _e6);
    float _e14 = at_z(_e13, _e8);
    vec4 _e16 = cubic_slope(local_3.y);
    vec4 _e17 = at_y(_e4, _e16);
    float _e18 = at_z(_e17, _e8);
    vec4 _e20 = cubic_slope(local_3.z);
    float _e21 = at_z(_e9, _e20);
    float _e22 = at_z(_e9, _e8);
    return Answer(_e22, vec3(_e14, _e18, _e21));
}

Answer hermite_of_samples(Field field_8, uvec3 cell_2, vec3 local_4) {
    Jets jets_2 = Jets(Jet[8](Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0))));
    uint corner_3 = 0u;
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            uint _e30 = corner_3;
            corner_3 = (_e30 + 1u);
        }
        loop_init_3 = false;
        uint _e6 = corner_3;
        if ((_e6 < 8u)) {
        } else {
            break;
        }
        {
            uint _e9 = corner_3;
            uvec3 _e10 = vertex_of(cell_2, _e9);
            Polynomial _e11 = read_polynomial(field_8, _e10);
            uint _e13 = corner_3;
            jets_2.corners[_e13] = Jet(vec4(_e11.constant, _e11.first.z, _e11.first.y, 0.0), vec4(_e11.first.x, 0.0, 0.0, 0.0));
        }
    }
    Answer _e32 = tricubic(jets_2, local_4);
    return _e32;
}

vec3 quintic(float t_3, uint end_1) {
    float rest_2 = (1.0 - t_3);
    float cube_1 = ((t_3 * t_3) * t_3);
    float rest_cube = ((rest_2 * rest_2) * rest_2);
    float far_2 = (cube_1 * (10.0 - (t_3 * (15.0 - (6.0 * t_3)))));
    vec3 near_weights = vec3((1.0 - far_2), ((t_3 * rest_cube) * (1.0 + (3.0 * t_3))), ((t_3 * t_3) * rest_cube));
    vec3 far_weights = vec3(far_2, ((-(cube_1) * rest_2) * (4.0 - (3.0 * t_3))), (cube_1 * (rest_2 * rest_2)));
    return mix(near_weights, far_weights, bvec3((end_1 == 1u)));
}

float quintic_product(Polynomial p_1, vec3 x_2, vec3 y_1, vec3 z_1) {
    return (((((((((p_1.constant * x_2.x) + (p_1.first.x * x_2.y)) + (p_1.square.x * x_2.z)) * y_1.x) + (((p_1.first.y * x_2.x) + (p_1.cross_.x * x_2.y)) * y_1.y)) + ((p_1.square.y * x_2.x) * y_1.z)) * z_1.x) + (((((p_1.first.z * x_2.x) + (p_1.cross_.y * x_2.y)) * y_1.x) + ((p_1.cross_.z * x_2.x) * y_1.y)) * z_1.y)) + (((p_1.square.z * x_2.x) * y_1.x) * z_1.z));
}

vec3 quintic_slope(float t_4, uint end_2) {
    float rest_3 = (1.0 - t_4);
    float square_2 = (t_4 * t_4);
    float rest_square = (rest_3 * rest_3);
    float far_3 = ((30.0 * square_2) * rest_square);
    vec3 near_weights_1 = vec3(-(far_3), (rest_square * (1.0 + (t_4 * (2.0 - (15.0 * t_4))))), ((t_4 * rest_square) * (2.0 - (5.0 * t_4))));
    vec3 far_weights_1 = vec3(far_3, (square_2 * ((t_4 * (28.0 - (15.0 * t_4))) - 12.0)), ((square_2 * rest_3) * (3.0 - (5.0 * t_4))));
    return mix(near_weights_1, far_weights_1, bvec3((end_2 == 1u)));
}

Answer triquintic(Field field_9, uvec3 cell_3, vec3 local_5) {
    Answer sum_1 = Answer(0.0, vec3(0.0));
    uint corner_4 = 0u;
    bool loop_init_4 = true;
    while(true) {
        if (!loop_init_4) {
            uint _e58 = corner_4;
            corner_4 = (_e58 + 1u);
        }
        loop_init_4 = false;
        uint _e10 = corner_4;
        if ((_e10 < 8u)) {
        } else {
            break;
        }
        {
            uint _e13 = corner_4;
            uvec3 _e14 = vertex_of(cell_3, _e13);
            Polynomial _e15 = read_polynomial(field_9, _e14);
            uint _e18 = corner_4;
            uvec3 _e19 = vertex_of(uvec3(0u), _e18);
            vec3 _e22 = quintic(local_5.x, _e19.x);
            vec3 _e25 = quintic(local_5.y, _e19.y);
            vec3 _e28 = quintic(local_5.z, _e19.z);
            float _e30 = sum_1.distance_;
            float _e31 = quintic_product(_e15, _e22, _e25, _e28);
            sum_1.distance_ = (_e30 + _e31);
            float _e35 = sum_1.gradient.x;
            vec3 _e38 = quintic_slope(local_5.x, _e19.x);
            float _e39 = quintic_product(_e15, _e38, _e25, _e28);
            sum_1.gradient.x = (_e35 + _e39);
            float _e43 = sum_1.gradient.y;
            vec3 _e46 = quintic_slope(local_5.y, _e19.y);
            float _e47 = quintic_product(_e15, _e22, _e46, _e28);
            sum_1.gradient.y = (_e43 + _e47);
            float _e51 = sum_1.gradient.z;
            vec3 _e54 = quintic_slope(local_5.z, _e19.z);
            float _e55 = quintic_product(_e15, _e22, _e25, _e54);
            sum_1.gradient.z = (_e51 + _e55);
        }
    }
    Answer _e60 = sum_1;
    return _e60;
}

Answer evaluate_grid(Field field_10, vec3 position) {
    Answer answer = Answer(0.0, vec3(0.0));
    uvec3 cell_7 = min(uvec3(position), (field_10.cells - uvec3(1u)));
    vec3 local_27 = (position - vec3(cell_7));
    if ((field_10.reconstruction == RECONSTRUCTION_NEAREST)) {
        bvec3 upper = greaterThanEqual(local_27, vec3(0.5));
        uvec3 nearest = (cell_7 + mix(uvec3(0u), uvec3(1u), upper));
        Polynomial _e23 = read_polynomial(field_10, nearest);
        Answer _e32 = polynomial_at(_e23, (local_27 - mix(vec3(0.0), vec3(1.0), upper)), vec4(1.0));
        answer = _e32;
    } else {
        if ((field_10.reconstruction != RECONSTRUCTION_HERMITE)) {
            Answer _e36 = weighted_polynomials(field_10, cell_7, local_27);
            answer = _e36;
        } else {
            if ((field_10.order == 1u)) {
                Answer _e40 = hermite_of_samples(field_10, cell_7, local_27);
                answer = _e40;
            } else {
                Answer _e41 = triquintic(field_10, cell_7, local_27);
                answer = _e41;
            }
        }
    }
    vec3 _e43 = answer.gradient;
    answer.gradient = (_e43 * field_10.cells_per_unit);
    Answer _e46 = answer;
    return _e46;
}

uint octant_of(uvec3 cell_4, uint shift) {
    uvec3 half_2 = ((cell_4 >> uvec3(shift)) & uvec3(1u));
    return ((half_2.x | (half_2.y << 1u)) | (half_2.z << 2u));
}

float power_of_half(uint exponent) {
    return uintBitsToFloat(((127u - min(exponent, 126u)) << 23u));
}

uint count_bits(uint bits_3) {
    uint pairs = (bits_3 - ((bits_3 >> 1u) & 1431655765u));
    uint nibbles = ((pairs & 858993459u) + ((pairs >> 2u) & 858993459u));
    return ((((nibbles + (nibbles >> 4u)) & 252645135u) * 16843009u) >> 24u);
}

vec2 decode_halves(uint bits_4) {
    float _e1 = decode_half(bits_4);
    float _e4 = decode_half((bits_4 >> 16u));
    return vec2(_e1, _e4);
}

Jet read_jet(Block block, uint source) {
    float distance_ = 0.0;
    vec3 gradient = vec3(0.0);
    vec4 mixed = vec4(0.0);
    bool local_6 = false;
    uint before = (source - 1u);
    uint _e6 = count_bits((block.present & before));
    uint _e9 = count_bits((block.full & before));
    bool is_full = ((block.full & source) != 0u);
    if ((block.sample_precision == PRECISION_F32_)) {
        uint place_3 = (block.first + (4u * (_e6 + _e9)));
        float _e27 = sample_float(place_3);
        distance_ = _e27;
        float _e30 = sample_float((place_3 + 1u));
        float _e33 = sample_float((place_3 + 2u));
        float _e36 = sample_float((place_3 + 3u));
        gradient = vec3(_e30, _e33, _e36);
        if (is_full) {
            float _e40 = sample_float((place_3 + 4u));
            float _e43 = sample_float((place_3 + 5u));
            float _e46 = sample_float((place_3 + 6u));
            float _e49 = sample_float((place_3 + 7u));
            mixed = vec4(_e40, _e43, _e46, _e49);
        }
    } else {
        if ((block.sample_precision == PRECISION_PACKED32_)) {
            local_6 = !(is_full);
        } else {
            local_6 = false;
        }
        bool _e58 = local_6;
        if (_e58) {
            uint _e64 = word(((block.first + _e6) + (3u * _e9)));
            float _e69 = decode_distance(block.base, (_e64 >> DISTANCE_SHIFT), block.quantum);
            distance_ = _e69;
            vec3 _e70 = decode_gradient(_e64);
            gradient = _e70;
        } else {
            uint stride = ((block.sample_precision == PRECISION_F16_) ? 2u : 1u);
            uint place_4 = ((block.first + (_e6 * stride)) + (_e9 * (4u - stride)));
            uint _e84 = word(place_4);
            uint _e87 = word((place_4 + 1u));
            vec2 _e88 = decode_halves(_e87);
            float _e97 = decode_distance((16 * block.base), (_e84 & 65535u), (block.quantum * 0.0625));
            distance_ = _e97;
            float _e100 = decode_half((_e84 >> 16u));
            gradient = vec3(_e100, _e88.x, _e88.y);
            if (is_full) {
                uint _e106 = word((place_4 + 2u));
                vec2 _e107 = decode_halves(_e106);
                uint _e110 = word((place_4 + 3u));
                vec2 _e111 = decode_halves(_e110);
                mixed = vec4(_e107, _e111);
            }
        }
    }
    vec3 _e113 = gradient;
    gradient = (_e113 * block.edge);
    vec4 _e116 = mixed;
    mixed = (_e116 * block.edge);
    float _e119 = distance_;
    float _e121 = gradient.z;
    float _e123 = gradient.y;
    float _e125 = mixed.z;
    float _e128 = gradient.x;
    float _e130 = mixed.y;
    float _e132 = mixed.x;
    float _e134 = mixed.w;
    return Jet(vec4(_e119, _e121, _e123, _e125), vec4(_e128, _e130, _e132, _e134));
}

float read_distance(Block block_1, uint source_1) {
    uint _e6 = count_bits((block_1.present & (source_1 - 1u)));
    if ((block_1.sample_precision == PRECISION_F32_)) {
        float _e12 = sample_float((block_1.first + _e6));
        return _e12;
    }
    uint _e17 = word((block_1.first + (_e6 / 2u)));
    uint code_3 = ((_e17 >> (16u * (_e6 & 1u))) & 65535u);
    float _e31 = decode_distance((16 * block_1.base), code_3, (block_1.quantum * 0.0625));
    return _e31;
}

Jet middle(Jet near, Jet far, uint axis) {
    Jet sum_2 = Jet((near.plain + far.plain), (near.by_x + far.by_x));
    Jet change_1 = Jet((near.plain - far.plain), (near.by_x - far.by_x));
    if ((axis == 0u)) {
        return Jet(((0.5 * sum_2.plain) + (0.25 * change_1.by_x)), ((-0.25 * sum_2.by_x) + (-0.75 * change_1.plain)));
    }
    if ((axis == 1u)) {
        vec4 by_sum = vec4(0.5, 0.5, -0.25, -0.25);
        vec4 by_change = vec4(0.25, 0.25, -0.75, -0.75);
        return Jet(((by_sum * sum_2.plain) + (by_change * change_1.plain.zwxy)), ((by_sum * sum_2.by_x) + (by_change * change_1.by_x.zwxy)));
    }
    vec4 by_sum_1 = vec4(0.5, -0.25, 0.5, -0.25);
    vec4 by_change_1 = vec4(0.25, -0.75, 0.25, -0.75);
    return Jet(((by_sum_1 * sum_2.plain) + (by_change_1 * change_1.plain.yxwz)), ((by_sum_1 * sum_2.by_x) + (by_change_1 * change_1.by_x.yxwz)));
}

void settle(inout Jets jets_3, uint implied, uint octant, uint axis_1) {
    uint corner_5 = 0u;
    bool local_7 = false;
    uint bit_5 = (4u >> axis_1);
    uint end_5 = ((((octant >> axis_1) & 1u) == 1u) ? 0u : bit_5);
    bool loop_init_5 = true;
    while(true) {
        if (!loop_init_5) {
            uint _e47 = corner_5;
            corner_5 = (_e47 + 1u);
        }
        loop_init_5 = false;
        uint _e15 = corner_5;
        if ((_e15 < 8u)) {
        } else {
            break;
        }
        {
            uint _e18 = corner_5;
            if (((_e18 & bit_5) == end_5)) {
                uint _e23 = corner_5;
                local_7 = (((implied >> _e23) & 1u) == 1u);
            } else {
                local_7 = false;
            }
            bool _e30 = local_7;
            if (_e30) {
                uint _e32 = corner_5;
                Jet near_2 = jets_3.corners[(_e32 & ~(bit_5))];
                uint _e38 = corner_5;
                Jet far_4 = jets_3.corners[(_e38 | bit_5)];
                uint _e43 = corner_5;
                Jet _e45 = middle(near_2, far_4, axis_1);
                jets_3.corners[_e43] = _e45;
            }
        }
    }
    return;
}

Jets read_corners(uint interpolant, Block block_2, uint octant_1) {
    Jets jets_4 = Jets(Jet[8](Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0))));
    uint implied_1 = 0u;
    uint corner_6 = 0u;
    uint source_2 = 0u;
    bool loop_init_6 = true;
    while(true) {
        if (!loop_init_6) {
            uint _e88 = corner_6;
            corner_6 = (_e88 + 1u);
        }
        loop_init_6 = false;
        uint _e8 = corner_6;
        if ((_e8 < 8u)) {
        } else {
            break;
        }
        {
            uint _e11 = corner_6;
            uint _e14 = corner_6;
            uint _e19 = corner_6;
            uvec3 along = uvec3((_e11 >> 2u), ((_e14 >> 1u) & 1u), (_e19 & 1u));
            uvec3 at_3 = (along + uvec3((octant_1 & 1u), ((octant_1 >> 1u) & 1u), (octant_1 >> 2u)));
            source_2 = (1u << ((at_3.x + (3u * at_3.y)) + (9u * at_3.z)));
            uint _e46 = source_2;
            if (((block_2.present & _e46) == 0u)) {
                uint _e50 = implied_1;
                uint _e52 = corner_6;
                implied_1 = (_e50 | (1u << _e52));
                source_2 = (1u << (((2u * along.x) + (6u * along.y)) + (18u * along.z)));
            }
            if ((interpolant == INTERPOLANT_TRICUBIC)) {
                uint _e71 = corner_6;
                uint _e73 = source_2;
                Jet _e74 = read_jet(block_2, _e73);
                jets_4.corners[_e71] = _e74;
            } else {
                uint _e76 = corner_6;
                uint _e78 = source_2;
                float _e79 = read_distance(block_2, _e78);
                jets_4.corners[_e76] = Jet(vec4(_e79, 0.0, 0.0, 0.0), vec4(0.0));
            }
        }
    }
    uint _e90 = implied_1;
    if ((_e90 != 0u)) {
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

Answer trilinear(Jets jets_5, vec3 local_8) {
    Corners corners_2 = Corners(vec4[8](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)));
    int corner_7 = 0;
    bool loop_init_7 = true;
    while(true) {
        if (!loop_init_7) {
            int _e16 = corner_7;
            corner_7 = (_e16 + 1);
        }
        loop_init_7 = false;
        int _e5 = corner_7;
        if ((_e5 < 8)) {
        } else {
            break;
        }
        {
            int _e9 = corner_7;
            int _e12 = corner_7;
            corners_2.at[_e9] = jets_5.corners[_e12].plain;
        }
    }
    vec2 x_5 = vec2((1.0 - local_8.x), local_8.x);
    vec2 y_4 = vec2((1.0 - local_8.y), local_8.y);
    vec2 z_4 = vec2((1.0 - local_8.z), local_8.z);
    vec2 slope_3 = vec2(-1.0, 1.0);
    Corners _e36 = corners_2;
    vec4 _e37 = weighted_sum(_e36, slope_3, y_4, z_4);
    float by_x_2 = _e37.x;
    Corners _e39 = corners_2;
    vec4 _e40 = weighted_sum(_e39, x_5, slope_3, z_4);
    float by_y_2 = _e40.x;
    Corners _e42 = corners_2;
    vec4 _e43 = weighted_sum(_e42, x_5, y_4, slope_3);
    float by_z_2 = _e43.x;
    Corners _e45 = corners_2;
    vec4 _e46 = weighted_sum(_e45, x_5, y_4, z_4);
    return Answer(_e46.x, vec3(by_x_2, by_y_2, by_z_2));
}

Answer evaluate_octree(Field field_11, vec3 position_1) {
    uint node = 0u;
    uint shift_1 = 0u;
    uint octant_2 = 0u;
    bool local_9 = false;
    Block block_3 = Block(0u, 0u, 0u, 0, 0u, 0.0, 0.0);
    Jets jets_6 = Jets(Jet[8](Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0))));
    Answer answer_1 = Answer(0.0, vec3(0.0));
    uvec3 cell_8 = min(uvec3(position_1), (field_11.cells - uvec3(1u)));
    uvec3 root_2 = (cell_8 >> uvec3(field_11.depth));
    uint _e24 = word(((field_11.nodes + root_2.x) + (field_11.counts.x * (root_2.y + (field_11.counts.y * root_2.z)))));
    node = _e24;
    shift_1 = field_11.depth;
    while(true) {
        uint _e30 = node;
        if (((_e30 >> NODE_OFFSET_BITS) == NODE_INNER)) {
            uint _e37 = shift_1;
            local_9 = (_e37 > 0u);
        } else {
            local_9 = false;
        }
        bool _e41 = local_9;
        if (_e41) {
        } else {
            break;
        }
        {
            uint _e42 = shift_1;
            shift_1 = (_e42 - 1u);
            uint _e45 = shift_1;
            uint _e46 = octant_of(cell_8, _e45);
            octant_2 = _e46;
            uint _e48 = node;
            uint _e52 = octant_2;
            uint _e54 = word(((field_11.nodes + (_e48 & NODE_OFFSET_MASK)) + _e52));
            node = _e54;
        }
    }
    uint _e55 = shift_1;
    uint _e58 = shift_1;
    uint _e63 = shift_1;
    float _e64 = power_of_half(_e63);
    vec3 local_28 = ((position_1 - vec3(((cell_8 >> uvec3(_e55)) << uvec3(_e58)))) * _e64);
    uint _e67 = shift_1;
    uint level = (field_11.depth - _e67);
    uint _e70 = node;
    uint start_2 = (field_11.samples + (_e70 & NODE_OFFSET_MASK));
    uint _e76 = word(start_2);
    block_3.present = (_e76 & LATTICE_MASK);
    uint _e80 = word(start_2);
    block_3.sample_precision = ((_e80 >> PRECISION_SHIFT) & 3u);
    uint _e88 = word((start_2 + 1u));
    block_3.full = (_e88 & LATTICE_MASK);
    uint _e94 = word((start_2 + 2u));
    block_3.base = int(_e94);
    block_3.first = (start_2 + 3u);
    float _e101 = power_of_half(level);
    block_3.quantum = (field_11.quantum * _e101);
    float _e106 = power_of_half(level);
    block_3.edge = (field_11.spacing.x * _e106);
    Block _e109 = block_3;
    uint _e110 = octant_2;
    Jets _e111 = read_corners(field_11.reconstruction, _e109, _e110);
    jets_6 = _e111;
    if ((field_11.reconstruction == INTERPOLANT_TRICUBIC)) {
        Answer _e117 = tricubic(jets_6, local_28);
        answer_1 = _e117;
    } else {
        Jets _e118 = jets_6;
        Answer _e119 = trilinear(_e118, local_28);
        answer_1 = _e119;
    }
    vec3 _e121 = answer_1.gradient;
    float _e123 = block_3.edge;
    answer_1.gradient = (_e121 * (1.0 / _e123));
    Answer _e127 = answer_1;
    return _e127;
}

uint root_node(Field field_12, uvec3 root) {
    uint _e15 = word(((field_12.nodes + root.x) + (field_12.counts.x * (root.y + (field_12.counts.y * root.z)))));
    return _e15;
}

uint bits_at(uint section, uint bit, uint index_8) {
    uint at_4 = ((section + index_8) + (bit / 32u));
    uint shift_4 = (bit & 31u);
    uint _e9 = word(at_4);
    uint _e13 = word((at_4 + 1u));
    return ((_e9 >> shift_4) | ((_e13 << 1u) << (31u - shift_4)));
}

uint child_node(Field field_13, uint record, uint octant_3) {
    uint byte = (RECORD_LENGTH * record);
    uint _e15 = bits_at(field_13.records, ((8u * (byte & 3u)) + (8u * octant_3)), (byte / 4u));
    uint start_3 = ((octant_3 == 0u) ? 0u : (_e15 & 255u));
    uint _e29 = bits_at(field_13.records, (8u * (byte & 3u)), (byte / 4u));
    uint first_bit = (8u * ((byte & 3u) + RECORD_FIRST));
    if ((((_e29 >> octant_3) & 1u) == 1u)) {
        uint _e44 = bits_at(field_13.records, first_bit, (byte / 4u));
        return ((_e44 & RECORD_CHILD_MASK) + start_3);
    }
    uint _e53 = bits_at(field_13.records, (first_bit + RECORD_CHILD_BITS), (byte / 4u));
    uint leaf_3 = (_e53 & RECORD_LEAF_MASK);
    return (ROOT_LEAF | (leaf_3 + start_3));
}

Leaf find_leaf(Field field_14, uvec3 cell_5) {
    uint node_1 = 0u;
    uint shift_2 = 0u;
    bool local_10 = false;
    uvec3 root_3 = (cell_5 >> uvec3(field_14.depth));
    uint _e5 = root_node(field_14, root_3);
    node_1 = _e5;
    shift_2 = field_14.depth;
    while(true) {
        uint _e9 = node_1;
        if (((_e9 & ROOT_LEAF) == 0u)) {
            uint _e16 = shift_2;
            local_10 = (_e16 > 0u);
        } else {
            local_10 = false;
        }
        bool _e20 = local_10;
        if (_e20) {
        } else {
            break;
        }
        {
            uint _e21 = shift_2;
            shift_2 = (_e21 - 1u);
            uint _e24 = node_1;
            uint _e25 = shift_2;
            uint _e26 = octant_of(cell_5, _e25);
            uint _e27 = child_node(field_14, _e24, _e26);
            node_1 = _e27;
        }
    }
    uint _e28 = node_1;
    uint _e31 = shift_2;
    uint _e34 = shift_2;
    uint _e37 = shift_2;
    return Leaf((_e28 & 2147483647u), ((cell_5 >> uvec3(_e31)) << uvec3(_e34)), _e37);
}

vec3 local_of(Leaf leaf, vec3 position_2) {
    float _e6 = power_of_half(leaf.shift);
    return (((position_2 - vec3(leaf.cell)) * (2.0 * _e6)) - vec3(1.0));
}

LeafHead read_head(Field field_15, uint place) {
    uint _e9 = bits_at(field_15.samples, (8u * (place & 3u)), (place / 4u));
    uint shape = (field_15.shapes + (2u * (_e9 & ((1u << field_15.shape_bits) - 1u))));
    uint codes_1 = (_e9 >> field_15.shape_bits);
    uint _e22 = word(shape);
    uint _e25 = word((shape + 1u));
    return LeafHead(_e22, _e25, (codes_1 & 3u), ((codes_1 >> SUPPORT_BITS) & 3u));
}

float read_code(Field field_16, uint index_9, uint bit_1, uint width) {
    uint size_1 = (1u << (width & 31u));
    uint _e9 = bits_at(field_16.samples, bit_1, index_9);
    uint code_4 = (_e9 & (size_1 - 1u));
    return float((int(code_4) - int((size_1 >> 1u))));
}

vec3 read_codes(Field field_17, uint index_10, uint bit_2, uint width_1) {
    float _e4 = read_code(field_17, index_10, bit_2, width_1);
    float _e6 = read_code(field_17, index_10, (bit_2 + width_1), width_1);
    float _e10 = read_code(field_17, index_10, (bit_2 + (2u * width_1)), width_1);
    return vec3(_e4, _e6, _e10);
}

Terms read_terms(Field field_18, uint index_11, uint start, uint degree, uint widths) {
    Terms terms = Terms(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), 0u);
    uint bit_3 = 0u;
    bit_3 = start;
    uint _e9 = bit_3;
    uint _e11 = byte_of(widths, 0u);
    float _e12 = read_code(field_18, index_11, _e9, _e11);
    terms.linear.w = _e12;
    uint _e13 = bit_3;
    uint _e15 = byte_of(widths, 0u);
    bit_3 = (_e13 + _e15);
    if ((degree >= 1u)) {
        uint _e20 = byte_of(widths, 1u);
        uint _e22 = bit_3;
        vec3 _e23 = read_codes(field_18, index_11, _e22, _e20);
        float _e26 = terms.linear.w;
        terms.linear = vec4(_e23, _e26);
        uint _e28 = bit_3;
        bit_3 = (_e28 + (3u * _e20));
    }
    if ((degree >= 2u)) {
        uint _e35 = byte_of(widths, 2u);
        uint _e37 = bit_3;
        vec3 _e38 = read_codes(field_18, index_11, _e37, _e35);
        terms.square = vec4(_e38, 0.0);
        uint _e42 = bit_3;
        vec3 _e46 = read_codes(field_18, index_11, (_e42 + (3u * _e35)), _e35);
        terms.cross_ = vec4(_e46, 0.0);
        uint _e49 = bit_3;
        bit_3 = (_e49 + (6u * _e35));
    }
    if ((degree >= 3u)) {
        uint _e56 = byte_of(widths, 3u);
        uint _e58 = bit_3;
        vec3 _e59 = read_codes(field_18, index_11, _e58, _e56);
        uint _e60 = bit_3;
        float _e64 = read_code(field_18, index_11, (_e60 + (9u * _e56)), _e56);
        terms.cube = vec4(_e59, _e64);
        uint _e67 = bit_3;
        vec3 _e71 = read_codes(field_18, index_11, (_e67 + (3u * _e56)), _e56);
        terms.next = vec4(_e71, 0.0);
        uint _e75 = bit_3;
        vec3 _e79 = read_codes(field_18, index_11, (_e75 + (6u * _e56)), _e56);
        terms.previous = vec4(_e79, 0.0);
        uint _e82 = bit_3;
        bit_3 = (_e82 + (10u * _e56));
    }
    uint _e87 = bit_3;
    terms.end = _e87;
    Terms _e88 = terms;
    return _e88;
}

Answer evaluate_terms(Terms terms_1, uint degree_1, vec3 local_11) {
    vec4 value = vec4(0.0);
    vec4 slope_1 = vec4(0.0);
    vec4 square = vec4(0.0);
    vec4 first_2 = vec4(local_11, 1.0);
    vec4 next = vec4(local_11.yzx, 0.0);
    vec4 previous = vec4(local_11.zxy, 0.0);
    vec4 second_1 = vec4(((1.5 * (first_2 * first_2)) - vec4(0.5)).xyz, 0.0);
    vec4 third_1 = vec4((first_2 * ((2.5 * (first_2 * first_2)) - vec4(1.5))).xyz, ((local_11.x * local_11.y) * local_11.z));
    value = (terms_1.linear * first_2);
    slope_1 = terms_1.linear;
    if ((degree_1 >= 2u)) {
        vec4 line = (terms_1.linear + (terms_1.cross_ * next));
        square = terms_1.square;
        if ((degree_1 >= 3u)) {
            vec4 _e49 = square;
            square = (_e49 + ((terms_1.next * next) + (terms_1.previous * previous)));
        }
        vec4 _e57 = square;
        value = ((line * first_2) + (_e57 * second_1));
        vec4 _e64 = square;
        slope_1 = ((line + (terms_1.cross_.zxyw * previous)) + (_e64 * (3.0 * first_2)));
        if ((degree_1 >= 3u)) {
            vec4 _e71 = value;
            value = (_e71 + (terms_1.cube * third_1));
            vec4 others = ((terms_1.next * second_1).zxyw + (terms_1.previous * second_1).yzxw);
            vec4 _e82 = slope_1;
            slope_1 = ((_e82 + ((terms_1.cube * ((7.5 * (first_2 * first_2)) - vec4(1.5))) + others)) + (terms_1.cube.w * (next * previous)));
        }
    }
    float _e99 = value.x;
    float _e101 = value.y;
    float _e104 = value.z;
    float _e106 = value.w;
    vec4 _e109 = slope_1;
    return Answer(((_e99 + _e101) + (_e104 + _e106)), _e109.xyz);
}

float edge_of(Field field_19, Leaf leaf_1) {
    float _e7 = power_of_half((field_19.depth - leaf_1.shift));
    return (field_19.spacing.x * _e7);
}

Answer evaluate_leaf(Field field_20, Leaf leaf_2, vec3 local_12) {
    uint bit_4 = 0u;
    Answer answer_2 = Answer(0.0, vec3(0.0));
    uint index_12 = 0u;
    bool local_13 = false;
    bool local_14 = false;
    bool local_15 = false;
    bool local_16 = false;
    bool local_17 = false;
    LeafHead _e4 = read_head(field_20, leaf_2.place);
    uint widths_1 = _e4.widths;
    uint _e8 = byte_of(_e4.kind_and_degrees, 0u);
    uint _e11 = byte_of(_e4.kind_and_degrees, 3u);
    uint exponent_2 = (_e11 & MAX_EXPONENT);
    float step_ = (field_20.quantum * uintBitsToFloat(((127u + exponent_2) << 23u)));
    bit_4 = (((8u * (leaf_2.place & 3u)) + field_20.shape_bits) + ((field_20.overlap == 0.0) ? 0u : OVERLAP_BITS));
    bool loop_init_8 = true;
    while(true) {
        if (!loop_init_8) {
            uint _e101 = index_12;
            index_12 = (_e101 + 1u);
        }
        loop_init_8 = false;
        uint _e43 = index_12;
        if ((_e43 < 2u)) {
        } else {
            break;
        }
        {
            uint _e46 = index_12;
            if ((_e46 == 1u)) {
                local_13 = (_e8 == KIND_SINGLE);
            } else {
                local_13 = false;
            }
            bool _e54 = local_13;
            if (_e54) {
                break;
            }
            uint _e57 = index_12;
            uint _e59 = byte_of(_e4.kind_and_degrees, (1u + _e57));
            uint _e63 = bit_4;
            Terms _e64 = read_terms(field_20, (leaf_2.place / 4u), _e63, _e59, widths_1);
            bit_4 = _e64.end;
            Answer _e66 = evaluate_terms(_e64, _e59, local_12);
            float _e69 = answer_2.distance_;
            bool is_less = (_e66.distance_ < _e69);
            float _e73 = answer_2.distance_;
            bool is_greater = (_e66.distance_ > _e73);
            uint _e75 = index_12;
            if (!((_e75 == 0u))) {
                if ((_e8 == KIND_MIN)) {
                    local_15 = is_less;
                } else {
                    local_15 = false;
                }
                bool _e86 = local_15;
                local_14 = _e86;
            } else {
                local_14 = true;
            }
            bool _e88 = local_14;
            if (!(_e88)) {
                if ((_e8 != KIND_MIN)) {
                    local_17 = is_greater;
                } else {
                    local_17 = false;
                }
                bool _e97 = local_17;
                local_16 = _e97;
            } else {
                local_16 = true;
            }
            bool _e99 = local_16;
            if (_e99) {
                answer_2 = _e66;
            }
        }
    }
    float _e103 = edge_of(field_20, leaf_2);
    float per_half = (2.0 / _e103);
    float _e107 = answer_2.distance_;
    vec3 _e110 = answer_2.gradient;
    return Answer((_e107 * step_), ((_e110 * step_) * per_half));
}

vec4 weight_at(vec3 local_18, float steepness) {
    vec3 s_1 = clamp((vec3(0.5) + ((vec3(1.0) - abs(local_18)) * steepness)), vec3(0.0), vec3(1.0));
    vec3 w = ((s_1 * s_1) * (vec3(3.0) - (2.0 * s_1)));
    float _e24 = copy_sign(steepness, -(local_18.x));
    float _e27 = copy_sign(steepness, -(local_18.y));
    float _e30 = copy_sign(steepness, -(local_18.z));
    vec3 signs_1 = vec3(_e24, _e27, _e30);
    vec3 slope_4 = (((6.0 * s_1) * (vec3(1.0) - s_1)) * signs_1);
    return vec4((slope_4.x * (w.y * w.z)), (slope_4.y * (w.x * w.z)), (slope_4.z * (w.x * w.y)), ((w.x * w.y) * w.z));
}

uint children_in(uvec3 middle_1, uvec3 low, uvec3 high) {
    uint children = 255u;
    uint _e5 = children;
    children = (_e5 & (((high.x < middle_1.x) ? 85u : 255u) & ((low.x >= middle_1.x) ? 170u : 255u)));
    uint _e20 = children;
    children = (_e20 & (((high.y < middle_1.y) ? 51u : 255u) & ((low.y >= middle_1.y) ? 204u : 255u)));
    uint _e35 = children;
    children = (_e35 & (((high.z < middle_1.z) ? 15u : 255u) & ((low.z >= middle_1.z) ? 240u : 255u)));
    uint _e50 = children;
    return _e50;
}

Answer blend(Field field_21, Leaf own, vec3 position_3, Answer alone) {
    float weight = 0.0;
    vec3 weight_slope = vec3(0.0);
    float change = 0.0;
    vec3 slope_2 = vec3(0.0);
    bool is_alone = true;
    uint records[16] = uint[16](0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    uint pending[16] = uint[16](0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    uvec3 root_1 = uvec3(0u);
    uvec3 cell_6 = uvec3(0u);
    uint shift_3 = 0u;
    bool local_19 = false;
    uint node_2 = 0u;
    bool local_20 = false;
    LeafHead _e5 = read_head(field_21, own.place);
    float steepness_1 = (0.25 / field_21.overlap);
    vec3 _e9 = local_of(own, position_3);
    vec4 _e15 = weight_at(_e9, (steepness_1 * float((1u << _e5.support))));
    weight = _e15.w;
    float _e19 = edge_of(field_21, own);
    weight_slope = (_e15.xyz * (2.0 / _e19));
    slope_2 = (_e15.w * alone.gradient);
    float _e33 = power_of_half(_e5.reach);
    float share = ((_e5.reach == 0u) ? LEAST_SUPPORT_SHARE : (_e33 * 2.0));
    float margin = ((field_21.overlap * float((1u << own.shift))) * share);
    uvec3 last = (field_21.cells - uvec3(1u));
    uvec3 low_1 = min(uvec3(max((position_3 - vec3(margin)), vec3(0.0))), last);
    uvec3 high_1 = min(uvec3((position_3 + vec3(margin))), last);
    uvec3 first_root = (low_1 >> uvec3(field_21.depth));
    uvec3 last_root = (high_1 >> uvec3(field_21.depth));
    root_1 = first_root;
    shift_3 = field_21.depth;
    while(true) {
        while(true) {
            uint _e77 = shift_3;
            if ((_e77 < field_21.depth)) {
                uint _e82 = shift_3;
                uint _e86 = pending[(_e82 & 15u)];
                local_19 = (_e86 == 0u);
            } else {
                local_19 = false;
            }
            bool _e90 = local_19;
            if (_e90) {
            } else {
                break;
            }
            {
                uint _e91 = shift_3;
                shift_3 = (_e91 + 1u);
            }
        }
        node_2 = 0u;
        uint _e96 = shift_3;
        if ((_e96 < field_21.depth)) {
            uint _e99 = shift_3;
            uint children_1 = pending[(_e99 & 15u)];
            uint _e104 = shift_3;
            pending[(_e104 & 15u)] = (children_1 & (children_1 - 1u));
            uint _e117 = count_bits(((children_1 & (~(children_1) + 1u)) - 1u));
            uvec3 _e118 = cell_6;
            uint _e119 = shift_3;
            uint _e124 = shift_3;
            uvec3 parent = ((_e118 >> uvec3((_e119 + 1u))) << uvec3((_e124 + 1u)));
            uint _e138 = shift_3;
            cell_6 = (parent + (uvec3((_e117 & 1u), ((_e117 >> 1u) & 1u), (_e117 >> 2u)) << uvec3(_e138)));
            uint _e142 = shift_3;
            uint _e146 = records[(_e142 & 15u)];
            uint _e147 = child_node(field_21, _e146, _e117);
            node_2 = _e147;
        } else {
            uint _e149 = root_1.z;
            if ((_e149 > last_root.z)) {
                break;
            }
            uvec3 _e152 = root_1;
            cell_6 = (_e152 << uvec3(field_21.depth));
            uvec3 _e156 = root_1;
            uint _e157 = root_node(field_21, _e156);
            node_2 = _e157;
            uint _e159 = root_1.x;
            root_1.x = (_e159 + 1u);
            uint _e163 = root_1.x;
            if ((_e163 > last_root.x)) {
                root_1.x = first_root.x;
                uint _e169 = root_1.y;
                root_1.y = (_e169 + 1u);
            }
            uint _e173 = root_1.y;
            if ((_e173 > last_root.y)) {
                root_1.y = first_root.y;
                uint _e179 = root_1.z;
                root_1.z = (_e179 + 1u);
            }
        }
        uint _e182 = node_2;
        if (((_e182 & ROOT_LEAF) == 0u)) {
            uint _e189 = shift_3;
            local_20 = (_e189 > 0u);
        } else {
            local_20 = false;
        }
        bool _e193 = local_20;
        if (_e193) {
            uint _e194 = shift_3;
            shift_3 = (_e194 - 1u);
            uint _e197 = shift_3;
            uint _e201 = node_2;
            records[(_e197 & 15u)] = _e201;
            uint _e202 = shift_3;
            uvec3 _e206 = cell_6;
            uint _e208 = shift_3;
            uint _e212 = children_in((_e206 + uvec3((1u << _e208))), low_1, high_1);
            pending[(_e202 & 15u)] = _e212;
            continue;
        }
        uint _e213 = node_2;
        uvec3 _e216 = cell_6;
        uint _e217 = shift_3;
        Leaf leaf_4 = Leaf((_e213 & 2147483647u), _e216, _e217);
        if ((leaf_4.place == own.place)) {
            continue;
        }
        vec3 _e222 = local_of(leaf_4, position_3);
        LeafHead _e225 = read_head(field_21, leaf_4.place);
        vec4 _e230 = weight_at(_e222, (steepness_1 * float((1u << _e225.support))));
        if ((_e230.w > 0.0)) {
            is_alone = false;
            Answer _e235 = evaluate_leaf(field_21, leaf_4, _e222);
            float difference = (_e235.distance_ - alone.distance_);
            float _e240 = edge_of(field_21, leaf_4);
            vec3 its_slope = (_e230.xyz * (2.0 / _e240));
            float _e244 = weight;
            weight = (_e244 + _e230.w);
            float _e247 = change;
            change = (_e247 + (_e230.w * difference));
            vec3 _e251 = weight_slope;
            weight_slope = (_e251 + its_slope);
            vec3 _e253 = slope_2;
            slope_2 = (_e253 + ((_e230.w * _e235.gradient) + (its_slope * difference)));
        }
    }
    bool _e260 = is_alone;
    if (_e260) {
        return alone;
    }
    float _e261 = weight;
    float per_weight = (1.0 / _e261);
    float _e264 = change;
    float mean = (_e264 * per_weight);
    vec3 _e268 = slope_2;
    vec3 _e269 = weight_slope;
    return Answer((alone.distance_ + mean), ((_e268 - (mean * _e269)) * per_weight));
}

Answer evaluate_polynomial_octree(Field field_22, vec3 position_4) {
    Leaf _e8 = find_leaf(field_22, min(uvec3(position_4), (field_22.cells - uvec3(1u))));
    vec3 _e9 = local_of(_e8, position_4);
    Answer _e10 = evaluate_leaf(field_22, _e8, _e9);
    if ((field_22.overlap == 0.0)) {
        return _e10;
    }
    LeafHead _e15 = read_head(field_22, _e8.place);
    uint reach = _e15.reach;
    float _e17 = power_of_half(reach);
    float share_1 = ((reach == 0u) ? 128.0 : (_e17 * 4.0));
    if ((max(max(abs(_e9.x), abs(_e9.y)), abs(_e9.z)) > (1.0 - (field_22.overlap * share_1)))) {
        Answer _e37 = blend(field_22, _e8, position_4, _e10);
        return _e37;
    }
    return _e10;
}

Answer answer_inside(Field field_23, vec3 point_1) {
    vec3 position_5 = min(((point_1 - field_23.low) * field_23.cells_per_unit), vec3(field_23.cells));
    switch(field_23.family) {
        case 1u: {
            Answer _e10 = evaluate_grid(field_23, position_5);
            return _e10;
        }
        case 2u: {
            Answer _e11 = evaluate_octree(field_23, position_5);
            return _e11;
        }
        default: {
            Answer _e12 = evaluate_polynomial_octree(field_23, position_5);
            return _e12;
        }
    }
}

Answer nearfield_evaluate(Field field_24, vec3 point_2) {
    Answer answer_3 = Answer(0.0, vec3(0.0));
    uvec3 bits_5 = (floatBitsToUint(point_2) & uvec3(2147483647u));
    if (any(greaterThanEqual(bits_5, uvec3(2139095040u)))) {
        Answer _e10 = answer_without_end(bits_5, point_2);
        return _e10;
    }
    vec3 nearest_1 = min(max(point_2, field_24.low), field_24.high);
    Answer _e15 = answer_inside(field_24, nearest_1);
    answer_3 = _e15;
    if (any(notEqual(nearest_1, point_2))) {
        Answer _e20 = length_and_direction((point_2 - nearest_1));
        float _e23 = answer_3.distance_;
        answer_3.distance_ = min((_e23 + _e20.distance_), MAX_FLOAT);
        answer_3.gradient = _e20.gradient;
    }
    Answer _e30 = answer_3;
    return _e30;
}

float nearfield_distance(Field field_25, vec3 point_3) {
    Answer _e2 = nearfield_evaluate(field_25, point_3);
    return _e2.distance_;
}

vec2 through(Field field_26, vec3 origin, vec3 direction) {
    vec3 safe = mix(direction, vec3(1e-20), lessThan(abs(direction), vec3(1e-20)));
    vec3 low_2 = ((field_26.low - origin) / safe);
    vec3 high_2 = ((field_26.high - origin) / safe);
    vec3 enter = min(low_2, high_2);
    vec3 leave_1 = max(low_2, high_2);
    return vec2(max(max(enter.x, enter.y), max(enter.z, 0.0)), min(min(leave_1.x, leave_1.y), leave_1.z));
}

vec3 direction_of(vec3 seen) {
    vec3 _e3 = _group_0_binding_1_fs.right;
    vec3 _e8 = _group_0_binding_1_fs.up;
    vec3 _e14 = _group_0_binding_1_fs.forward;
    return normalize((((_e3 * seen.x) + (_e8 * seen.y)) - (_e14 * seen.z)));
}

vec3 colour_of_distance(float distance_1, float pixel_1) {
    float _e5 = _group_0_binding_1_fs.deepest;
    float depth = (2.0 * sqrt(clamp((abs(distance_1) / _e5), 0.0, 1.0)));
    bool is_inside = (distance_1 < 0.0);
    vec3 near_3 = (is_inside ? vec3(222.0, 238.0, 250.0) : vec3(255.0, 246.0, 228.0));
    vec3 middle_2 = (is_inside ? vec3(88.0, 158.0, 214.0) : vec3(246.0, 178.0, 98.0));
    vec3 far_5 = (is_inside ? vec3(10.0, 54.0, 112.0) : vec3(150.0, 50.0, 8.0));
    vec3 ground = ((depth > 1.0) ? mix(middle_2, far_5, (depth - 1.0)) : mix(near_3, middle_2, depth));
    float _e51 = _group_0_binding_1_fs.spacing;
    float _e56 = _group_0_binding_1_fs.spacing;
    float to_line = (distance_1 - (roundEven((distance_1 / _e51)) * _e56));
    float line_1 = clamp((1.0 - (abs(to_line) / pixel_1)), 0.0, 1.0);
    float surface = clamp((1.5 - (abs(distance_1) / pixel_1)), 0.0, 1.0);
    vec3 encoded = (mix(mix(ground, vec3(96.0, 96.0, 100.0), (0.6 * line_1)), vec3(12.0, 12.0, 14.0), surface) / vec3(255.0));
    return mix(pow(((encoded + vec3(0.055)) / vec3(1.055)), vec3(2.4)), (encoded / vec3(12.92)), lessThanEqual(encoded, vec3(0.04045)));
}

float safe_step(float distance_2) {
    float _e1 = nearfield_slope();
    float _e5 = nearfield_error();
    return max((distance_2 / max(_e1, 1.0)), (distance_2 - (2.0 * _e5)));
}

vec3 colour(Field field_27, vec3 direction_1) {
    vec2 interval = vec2(0.0);
    uint phase = TRACE;
    bool local_21 = false;
    float travelled = 0.0;
    vec3 place_1 = vec3(0.0);
    uint steps = 0u;
    vec3 point_4 = vec3(0.0);
    vec3 normal = vec3(0.0);
    float facing = 0.0;
    float hidden = 0.0;
    float weight_1 = 1.0;
    float lit = 1.0;
    float leave = 0.0;
    bool local_22 = false;
    bool local_23 = false;
    bool local_24 = false;
    bool local_25 = false;
    bool local_26 = false;
    vec3 _e4 = _group_0_binding_1_fs.eye;
    vec2 _e5 = through(field_27, _e4, direction_1);
    interval = _e5;
    vec3 _e11 = _group_0_binding_1_fs.cut;
    vec3 _e14 = _group_0_binding_1_fs.eye;
    float _e18 = _group_0_binding_1_fs.cut_at;
    float beyond = (dot(_e11, _e14) - _e18);
    vec3 _e22 = _group_0_binding_1_fs.cut;
    if (any(notEqual(_e22, vec3(0.0)))) {
        local_21 = (beyond > 0.0);
    } else {
        local_21 = false;
    }
    bool _e32 = local_21;
    if (_e32) {
        vec3 _e35 = _group_0_binding_1_fs.cut;
        float toward_1 = -(dot(_e35, direction_1));
        float _e39 = interval.y;
        if (((toward_1 * _e39) <= beyond)) {
            return BACKGROUND;
        }
        float _e44 = interval.x;
        if (((toward_1 * _e44) < beyond)) {
            interval.x = (beyond / toward_1);
            phase = PLANE;
        }
    }
    float _e51 = interval.x;
    float _e53 = interval.y;
    if ((_e51 >= _e53)) {
        return BACKGROUND;
    }
    vec3 _e57 = direction_of(LAMP);
    float _e59 = interval.x;
    travelled = _e59;
    vec3 _e63 = _group_0_binding_1_fs.eye;
    float _e64 = travelled;
    place_1 = (_e63 + (direction_1 * _e64));
    while(true) {
        vec3 _e82 = place_1;
        Answer _e83 = nearfield_evaluate(field_27, _e82);
        float _e87 = _group_0_binding_1_fs.offset;
        float distance_3 = (_e83.distance_ - _e87);
        uint _e89 = steps;
        steps = (_e89 + 1u);
        uint _e92 = phase;
        if ((_e92 == PLANE)) {
            float _e97 = _group_0_binding_1_fs.pixel;
            float _e98 = travelled;
            vec3 _e100 = colour_of_distance(distance_3, (_e97 * _e98));
            return _e100;
        } else {
            uint _e101 = phase;
            if ((_e101 == TRACE)) {
                float _e107 = _group_0_binding_1_fs.pixel;
                float _e109 = travelled;
                float near_4 = ((ARRIVED * _e107) * _e109);
                if ((distance_3 >= near_4)) {
                    uint _e114 = steps;
                    local_22 = (_e114 <= MAX_STEPS);
                } else {
                    local_22 = false;
                }
                bool _e118 = local_22;
                if (_e118) {
                    float _e119 = travelled;
                    float _e120 = safe_step(distance_3);
                    travelled = (_e119 + max(_e120, near_4));
                    float _e123 = travelled;
                    float _e125 = interval.y;
                    if ((_e123 > _e125)) {
                        return BACKGROUND;
                    }
                    vec3 _e130 = _group_0_binding_1_fs.eye;
                    float _e131 = travelled;
                    place_1 = (_e130 + (direction_1 * _e131));
                    continue;
                }
                vec3 _e134 = place_1;
                point_4 = _e134;
                normal = (_e83.gradient / vec3(max(length(_e83.gradient), 1e-30)));
                vec3 _e142 = normal;
                vec3 _e143 = normal;
                vec3 _e145 = normal;
                normal = ((dot(_e145, direction_1) > 0.0) ? -(_e143) : _e142);
                uint _e152 = _group_0_binding_1_fs.show;
                if (((_e152 & SHOW_NORMALS) != 0u)) {
                    vec3 _e157 = normal;
                    return ((0.5 * _e157) + vec3(0.5));
                }
                vec3 _e163 = normal;
                facing = max(dot(_e163, _e57), 0.0);
                phase = OCCLUSION;
                steps = 0u;
            } else {
                uint _e169 = phase;
                if ((_e169 == OCCLUSION)) {
                    float _e174 = _group_0_binding_1_fs.size;
                    uint _e177 = steps;
                    float height = (((0.12 * _e174) * float(_e177)) / 5.0);
                    float _e182 = hidden;
                    float _e183 = weight_1;
                    hidden = (_e182 + (_e183 * clamp((1.0 - (distance_3 / height)), 0.0, 1.0)));
                    float _e192 = weight_1;
                    weight_1 = (_e192 * 0.7);
                } else {
                    float _e195 = lit;
                    float _e198 = travelled;
                    lit = min(_e195, ((SHADOW_SHARPNESS * distance_3) / _e198));
                    float _e201 = travelled;
                    float _e202 = safe_step(distance_3);
                    float _e205 = _group_0_binding_1_fs.size;
                    travelled = (_e201 + max(_e202, (0.002 * _e205)));
                }
            }
        }
        uint _e210 = phase;
        if ((_e210 == OCCLUSION)) {
            uint _e217 = _group_0_binding_1_fs.show;
            if (!(((_e217 & SHOW_OCCLUSION) == 0u))) {
                uint _e225 = steps;
                local_24 = (_e225 == PROBES);
            } else {
                local_24 = true;
            }
            bool _e229 = local_24;
            local_23 = _e229;
        } else {
            local_23 = false;
        }
        bool _e231 = local_23;
        if (_e231) {
            float _e232 = facing;
            if (!((_e232 == 0.0))) {
                uint _e240 = _group_0_binding_1_fs.show;
                local_25 = ((_e240 & SHOW_SHADOW) == 0u);
            } else {
                local_25 = true;
            }
            bool _e246 = local_25;
            if (_e246) {
                break;
            }
            phase = SHADOW;
            vec3 _e248 = point_4;
            vec3 _e249 = normal;
            float _e252 = _group_0_binding_1_fs.size;
            vec2 _e257 = through(field_27, (_e248 + (_e249 * (0.001 * _e252))), _e57);
            leave = _e257.y;
            float _e261 = _group_0_binding_1_fs.size;
            travelled = (0.004 * _e261);
        }
        uint _e264 = phase;
        if ((_e264 == OCCLUSION)) {
            vec3 _e267 = point_4;
            vec3 _e268 = normal;
            float _e271 = _group_0_binding_1_fs.size;
            uint _e274 = steps;
            place_1 = (_e267 + (_e268 * (((0.12 * _e271) * float((_e274 + 1u))) / 5.0)));
        } else {
            float _e283 = travelled;
            float _e284 = leave;
            if (!((_e283 >= _e284))) {
                float _e289 = lit;
                local_26 = (_e289 <= 0.0);
            } else {
                local_26 = true;
            }
            bool _e293 = local_26;
            if (_e293) {
                break;
            }
            vec3 _e294 = point_4;
            vec3 _e295 = normal;
            float _e298 = _group_0_binding_1_fs.size;
            float _e303 = travelled;
            place_1 = ((_e294 + (_e295 * (0.001 * _e298))) + (_e57 * _e303));
        }
    }
    float _e306 = hidden;
    float open = (1.0 - (_e306 / ALL_PROBES));
    float _e311 = lit;
    float soft = clamp(_e311, 0.0, 1.0);
    float light = ((soft * soft) * (3.0 - (2.0 * soft)));
    vec3 _e321 = normal;
    vec3 _e324 = _group_0_binding_1_fs.up;
    float sky = (0.24 + (0.12 * dot(_e321, _e324)));
    float _e332 = facing;
    return (CLAY * ((sky * open) + (((0.95 * _e332) * light) * (0.5 + (0.5 * open)))));
}

void main() {
    Corner at = Corner(gl_FragCoord, _vs2fs_location0);
    vec3 sum = vec3(0.0);
    uint index_1 = 0u;
    Field _e1 = nearfield_open();
    vec3 _e4 = _group_0_binding_1_fs.forward;
    vec3 _e7 = _group_0_binding_1_fs.right;
    float _e12 = _group_0_binding_1_fs.half_width;
    vec3 _e18 = _group_0_binding_1_fs.up;
    float _e23 = _group_0_binding_1_fs.half_height;
    vec3 middle_3 = ((_e4 + (_e7 * (at.place.x * _e12))) + (_e18 * (at.place.y * _e23)));
    bool loop_init_9 = true;
    while(true) {
        if (!loop_init_9) {
            uint _e87 = index_1;
            index_1 = (_e87 + 1u);
        }
        loop_init_9 = false;
        uint _e32 = index_1;
        uint _e35 = _group_0_binding_1_fs.antialias;
        uint _e38 = _group_0_binding_1_fs.antialias;
        if ((_e32 < (_e35 * _e38))) {
        } else {
            break;
        }
        {
            uint _e41 = index_1;
            uint _e44 = _group_0_binding_1_fs.antialias;
            uint _e47 = index_1;
            uint _e50 = _group_0_binding_1_fs.antialias;
            uint _e59 = _group_0_binding_1_fs.antialias;
            vec2 within = (((vec2(float((_e41 % _e44)), float((_e47 / _e50))) + vec2(0.5)) / vec2(float(_e59))) - vec2(0.5));
            float _e68 = _group_0_binding_1_fs.pixel;
            vec2 place_5 = (within * _e68);
            vec3 _e70 = sum;
            vec3 _e73 = _group_0_binding_1_fs.right;
            vec3 _e79 = _group_0_binding_1_fs.up;
            vec3 _e84 = colour(_e1, normalize(((middle_3 + (_e73 * place_5.x)) + (_e79 * place_5.y))));
            sum = (_e70 + _e84);
        }
    }
    vec3 _e89 = sum;
    uint _e92 = _group_0_binding_1_fs.antialias;
    uint _e95 = _group_0_binding_1_fs.antialias;
    vec3 linear = clamp((_e89 / vec3(float((_e92 * _e95)))), vec3(0.0), vec3(1.0));
    vec3 encoded_1 = mix(((1.055 * pow(linear, vec3(0.41666666))) - vec3(0.055)), (12.92 * linear), lessThanEqual(linear, vec3(0.0031308)));
    _fs2p_location0 = vec4(encoded_1, 1.0);
    return;
}

