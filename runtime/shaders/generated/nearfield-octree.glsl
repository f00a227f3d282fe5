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
struct Block {
    uint present;
    uint full;
    uint sample_precision;
    int base;
    uint first;
    float quantum;
    float edge;
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
struct Corners {
    vec4 at[8];
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
const uint NODE_OFFSET_BITS = 28u;
const uint NODE_INNER = 0u;
const uint NODE_OFFSET_MASK = 268435455u;
const uint LATTICE_MASK = 134217727u;
const uint PRECISION_SHIFT = 27u;
const uint PRECISION_F32_ = 2u;
const uint INTERPOLANT_TRICUBIC = 1u;
const uint PRECISION_F16_ = 1u;
const uint MAX_MAGNITUDE_BITS = 1568669696u;
const uint PRECISION_PACKED32_ = 0u;
const uint DISTANCE_SHIFT = 20u;
const uint GRADIENT_MASK = 1023u;
const uint GRADIENT_BITS = 10u;
const int GRADIENT_CENTRE = 511;
const float GRADIENT_STEP = 0.0019569471;
const float SUBNORMAL_STEP = 5.9604645e-8;
const uint RECONSTRUCTION_NEAREST = 0u;
const uint RECONSTRUCTION_HALF = 2u;
const uint RECONSTRUCTION_BLEND = 3u;
const uint RECONSTRUCTION_HERMITE = 4u;
const uint RANGE_BRICK = 1u;
const uint BRICK_EDGE = 4u;
const uint ROOT_LEAF = 2147483648u;
const uint RECORD_LENGTH = 14u;
const uint RECORD_FIRST = 8u;
const uint RECORD_CHILD_BITS = 21u;
const uint RECORD_CHILD_MASK = 2097151u;
const uint RECORD_LEAF_MASK = 134217727u;
const uint KIND_SINGLE = 0u;
const uint KIND_MIN = 1u;
const uint MAX_EXPONENT = 15u;
const uint SUPPORT_BITS = 2u;
const uint OVERLAP_BITS = 4u;
const uint MAX_SUPPORT = 3u;
const uint MAX_LEVELS_APART = 5u;
const float MIN_OVERLAP = 0.015625;

uniform highp usampler2D nearfield_words;


uint word(uint index) {
    uvec2 size = uvec2(textureSize(nearfield_words, 0).xy);
    uint texel = (index / 4u);
    uint row = (texel / size.x);
    if ((row >= size.y)) {
        return 0u;
    }
    uvec4 _e17 = texelFetch(nearfield_words, ivec2(uvec2((texel - (row * size.x)), row)), 0);
    return _e17[(index & 3u)];
}

uint byte_of(uint bits, uint number) {
    return ((bits >> (8u * number)) & 255u);
}

float float_(uint index_1) {
    uint _e1 = word(index_1);
    return uintBitsToFloat(_e1);
}

Field nearfield_open() {
    Field field = Field(0u, vec3(0.0), vec3(0.0), uvec3(0u), uvec3(0u), vec3(0.0), vec3(0.0), 0.0, 0u, 0u, 0u, 0u, 0u, 0u, 0.0, 0u, 0u, 0u, 0u);
    uint parameters = 0u;
    uint index_2 = 0u;
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
            uint _e85 = index_2;
            index_2 = (_e85 + 1u);
        }
        loop_init = false;
        uint _e30 = index_2;
        if ((_e30 < min(_e27, MAX_SECTIONS))) {
        } else {
            break;
        }
        {
            uint _e36 = index_2;
            uint entry = (TABLE_WORD + (SECTION_WORDS * _e36));
            uint _e41 = word((entry + 1u));
            uint start = (_e41 / 4u);
            uint _e44 = word(entry);
            switch(_e44) {
                case 1381253967u: {
                    uint _e46 = field.family;
                    if ((_e46 == FAMILY_OCTREE)) {
                        parameters = start;
                    }
                    break;
                }
                case 1145655879u: {
                    uint _e50 = field.family;
                    if ((_e50 == FAMILY_GRID)) {
                        parameters = start;
                    }
                    break;
                }
                case 1163023440u: {
                    uint _e54 = field.family;
                    if ((_e54 == FAMILY_POLYNOMIAL)) {
                        parameters = start;
                    }
                    break;
                }
                case 1162104654u: {
                    uint _e58 = field.family;
                    if ((_e58 == FAMILY_OCTREE)) {
                        field.nodes = start;
                    }
                    break;
                }
                case 1163084098u: {
                    uint _e63 = field.family;
                    if ((_e63 == FAMILY_GRID)) {
                        field.nodes = start;
                    }
                    break;
                }
                case 1414483794u: {
                    uint _e68 = field.family;
                    if ((_e68 == FAMILY_POLYNOMIAL)) {
                        field.nodes = start;
                    }
                    break;
                }
                case 1347240275u: {
                    uint _e73 = field.family;
                    if ((_e73 != FAMILY_POLYNOMIAL)) {
                        field.samples = start;
                    }
                    break;
                }
                case 1178682700u: {
                    uint _e78 = field.family;
                    if ((_e78 == FAMILY_POLYNOMIAL)) {
                        field.samples = start;
                    }
                    break;
                }
                case 1162889299u: {
                    field.shapes = start;
                    break;
                }
                case 1162170964u: {
                    field.records = start;
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
    float half_ = (0.5 * x);
    float coarse = (seed * (1.5 - (half_ * (seed * seed))));
    return (coarse + (coarse * (0.5 - (half_ * (coarse * coarse)))));
}

float finite(float number_1) {
    return intBitsToFloat(min(floatBitsToInt(number_1), 2139095039));
}

Answer length_and_direction(vec3 vector) {
    float largest = max(max(abs(vector.x), abs(vector.y)), abs(vector.z));
    vec3 scaled = (vector / vec3(largest));
    float taxicab = ((abs(scaled.x) + abs(scaled.y)) + abs(scaled.z));
    vec3 place_1 = (scaled / vec3(taxicab));
    float squared = (((place_1.x * place_1.x) + (place_1.y * place_1.y)) + (place_1.z * place_1.z));
    float _e32 = reciprocal_sqrt(squared);
    float _e36 = finite(((taxicab * (squared * _e32)) * largest));
    return Answer(_e36, (place_1 * _e32));
}

Answer answer_without_end(uvec3 bits_1, vec3 point_1) {
    if (any(greaterThan(bits_1, uvec3(2139095040u)))) {
        float nan = uintBitsToFloat(max(max(bits_1.x, bits_1.y), bits_1.z));
        return Answer(nan, vec3(nan));
    }
    uvec3 signs = (floatBitsToUint(point_1) & uvec3(2147483648u));
    vec3 ones = uintBitsToFloat((signs | uvec3(1065353216u)));
    vec3 toward = mix(vec3(0.0), ones, equal(bits_1, uvec3(2139095040u)));
    Answer _e34 = length_and_direction(toward);
    return Answer(uintBitsToFloat(max(max(bits_1.x, bits_1.y), bits_1.z)), _e34.gradient);
}

uint root_of(Field field_1, uvec3 cell) {
    uvec3 root = (cell >> uvec3(field_1.depth));
    return (root.x + (field_1.counts.x * (root.y + (field_1.counts.y * root.z))));
}

uint octant_of(uvec3 cell_1, uint shift) {
    uvec3 half_1 = ((cell_1 >> uvec3(shift)) & uvec3(1u));
    return ((half_1.x | (half_1.y << 1u)) | (half_1.z << 2u));
}

float power_of_half(uint exponent) {
    return uintBitsToFloat(((127u - min(exponent, 126u)) << 23u));
}

uint count_bits(uint bits_2) {
    uint pairs = (bits_2 - ((bits_2 >> 1u) & 1431655765u));
    uint nibbles = ((pairs & 858993459u) + ((pairs >> 2u) & 858993459u));
    return ((((nibbles + (nibbles >> 4u)) & 252645135u) * 16843009u) >> 24u);
}

float decode_float(uint bits_3) {
    return (((bits_3 & 2147483647u) <= MAX_MAGNITUDE_BITS) ? uintBitsToFloat(bits_3) : 0.0);
}

float decode_distance(int base, uint code, float quantum) {
    return (float((base + int(code))) * quantum);
}

float copy_sign(float magnitude, float sign_) {
    return uintBitsToFloat((floatBitsToUint(abs(magnitude)) | (floatBitsToUint(sign_) & 2147483648u)));
}

vec3 decode_gradient(uint code_1) {
    ivec2 codes = (ivec2(uvec2((code_1 & GRADIENT_MASK), ((code_1 >> GRADIENT_BITS) & GRADIENT_MASK))) - ivec2(511));
    vec2 flat_ = (vec2(codes) * GRADIENT_STEP);
    float z_1 = ((1.0 - abs(flat_.x)) - abs(flat_.y));
    float fold = max(-(z_1), 0.0);
    float _e27 = copy_sign(fold, flat_.x);
    float x_2 = (flat_.x - _e27);
    float _e31 = copy_sign(fold, flat_.y);
    float y_1 = (flat_.y - _e31);
    float _e39 = reciprocal_sqrt((((x_2 * x_2) + (y_1 * y_1)) + (z_1 * z_1)));
    return (vec3(x_2, y_1, z_1) * _e39);
}

float decode_half(uint bits_4) {
    uint sign_1 = ((bits_4 & 32768u) << 16u);
    uint exponent_1 = ((bits_4 >> 10u) & 31u);
    uint fraction = (bits_4 & 1023u);
    if ((exponent_1 == 0u)) {
        return uintBitsToFloat((sign_1 | floatBitsToUint((float(fraction) * SUBNORMAL_STEP))));
    }
    return uintBitsToFloat((sign_1 | ((exponent_1 == 31u) ? 0u : (((exponent_1 + 112u) << 23u) | (fraction << 13u)))));
}

vec2 decode_halves(uint bits_5) {
    float _e1 = decode_half(bits_5);
    float _e4 = decode_half((bits_5 >> 16u));
    return vec2(_e1, _e4);
}

Jet read_jet(uint interpolant, Block block, uint source) {
    uint place = 0u;
    uint count = 0u;
    uint words[8] = uint[8](0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
    uint index_3 = 0u;
    float distance_ = 0.0;
    vec3 gradient = vec3(0.0);
    vec4 mixed = vec4(0.0);
    bool local = false;
    bool local_1 = false;
    uint before = (source - 1u);
    uint _e7 = count_bits((block.present & before));
    uint _e10 = count_bits((block.full & before));
    bool is_full = ((block.full & source) != 0u);
    bool is_float = (block.sample_precision == PRECISION_F32_);
    bool is_trilinear = (interpolant != INTERPOLANT_TRICUBIC);
    uint stride = (is_float ? 4u : ((block.sample_precision == PRECISION_F16_) ? 2u : 1u));
    uint full_stride = (is_float ? 8u : 4u);
    place = ((_e7 * stride) + (_e10 * (full_stride - stride)));
    count = (is_full ? full_stride : stride);
    if (is_trilinear) {
        place = (is_float ? _e7 : (_e7 / 2u));
        count = 1u;
    }
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e57 = index_3;
            index_3 = (_e57 + 1u);
        }
        loop_init_1 = false;
        uint _e45 = index_3;
        uint _e46 = count;
        if ((_e45 < _e46)) {
        } else {
            break;
        }
        {
            uint _e48 = index_3;
            uint _e51 = place;
            uint _e53 = index_3;
            uint _e55 = word(((block.first + _e51) + _e53));
            words[_e48] = _e55;
        }
    }
    if (is_float) {
        uint _e67 = words[0];
        float _e68 = decode_float(_e67);
        distance_ = _e68;
        uint _e70 = words[1];
        float _e71 = decode_float(_e70);
        uint _e73 = words[2];
        float _e74 = decode_float(_e73);
        uint _e76 = words[3];
        float _e77 = decode_float(_e76);
        gradient = vec3(_e71, _e74, _e77);
        uint _e80 = words[4];
        float _e81 = decode_float(_e80);
        uint _e83 = words[5];
        float _e84 = decode_float(_e83);
        uint _e86 = words[6];
        float _e87 = decode_float(_e86);
        uint _e89 = words[7];
        float _e90 = decode_float(_e89);
        mixed = vec4(_e81, _e84, _e87, _e90);
    } else {
        if ((block.sample_precision == PRECISION_PACKED32_)) {
            local = !(is_full);
        } else {
            local = false;
        }
        bool _e99 = local;
        if (_e99) {
            local_1 = !(is_trilinear);
        } else {
            local_1 = false;
        }
        bool _e104 = local_1;
        if (_e104) {
            uint _e107 = words[0];
            float _e111 = decode_distance(block.base, (_e107 >> DISTANCE_SHIFT), block.quantum);
            distance_ = _e111;
            uint _e113 = words[0];
            vec3 _e114 = decode_gradient(_e113);
            gradient = _e114;
        } else {
            uint _e116 = words[0];
            uint half_2 = (_e116 >> (is_trilinear ? (16u * (_e7 & 1u)) : 0u));
            float _e132 = decode_distance((16 * block.base), (half_2 & 65535u), (block.quantum * 0.0625));
            distance_ = _e132;
            uint _e134 = words[0];
            float _e137 = decode_half((_e134 >> 16u));
            uint _e139 = words[1];
            vec2 _e140 = decode_halves(_e139);
            gradient = vec3(_e137, _e140);
            uint _e143 = words[2];
            vec2 _e144 = decode_halves(_e143);
            uint _e146 = words[3];
            vec2 _e147 = decode_halves(_e146);
            mixed = vec4(_e144, _e147);
        }
    }
    if (is_trilinear) {
        float _e149 = distance_;
        return Jet(vec4(_e149, 0.0, 0.0, 0.0), vec4(0.0));
    }
    vec3 _e157 = gradient;
    gradient = (_e157 * block.edge);
    vec4 _e160 = mixed;
    mixed = (_e160 * block.edge);
    float _e163 = distance_;
    float _e165 = gradient.z;
    float _e167 = gradient.y;
    float _e169 = mixed.z;
    float _e172 = gradient.x;
    float _e174 = mixed.y;
    float _e176 = mixed.x;
    float _e178 = mixed.w;
    return Jet(vec4(_e163, _e165, _e167, _e169), vec4(_e172, _e174, _e176, _e178));
}

Jet middle(Jet near, Jet far, uint axis) {
    Jet sum = Jet((near.plain + far.plain), (near.by_x + far.by_x));
    Jet change = Jet((near.plain - far.plain), (near.by_x - far.by_x));
    if ((axis == 0u)) {
        return Jet(((0.5 * sum.plain) + (0.25 * change.by_x)), ((-0.25 * sum.by_x) + (-0.75 * change.plain)));
    }
    if ((axis == 1u)) {
        vec4 by_sum = vec4(0.5, 0.5, -0.25, -0.25);
        vec4 by_change = vec4(0.25, 0.25, -0.75, -0.75);
        return Jet(((by_sum * sum.plain) + (by_change * change.plain.zwxy)), ((by_sum * sum.by_x) + (by_change * change.by_x.zwxy)));
    }
    vec4 by_sum_1 = vec4(0.5, -0.25, 0.5, -0.25);
    vec4 by_change_1 = vec4(0.25, -0.75, 0.25, -0.75);
    return Jet(((by_sum_1 * sum.plain) + (by_change_1 * change.plain.yxwz)), ((by_sum_1 * sum.by_x) + (by_change_1 * change.by_x.yxwz)));
}

void settle(inout Jets jets, uint implied, uint octant, uint axis_1) {
    uint corner = 0u;
    bool local_2 = false;
    uint bit = (4u >> axis_1);
    uint end = ((((octant >> axis_1) & 1u) == 1u) ? 0u : bit);
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            uint _e47 = corner;
            corner = (_e47 + 1u);
        }
        loop_init_2 = false;
        uint _e15 = corner;
        if ((_e15 < 8u)) {
        } else {
            break;
        }
        {
            uint _e18 = corner;
            if (((_e18 & bit) == end)) {
                uint _e23 = corner;
                local_2 = (((implied >> _e23) & 1u) == 1u);
            } else {
                local_2 = false;
            }
            bool _e30 = local_2;
            if (_e30) {
                uint _e32 = corner;
                Jet near_1 = jets.corners[(_e32 & ~(bit))];
                uint _e38 = corner;
                Jet far_1 = jets.corners[(_e38 | bit)];
                uint _e43 = corner;
                Jet _e45 = middle(near_1, far_1, axis_1);
                jets.corners[_e43] = _e45;
            }
        }
    }
    return;
}

Jets read_corners(uint interpolant_1, Block block_1, uint octant_1) {
    Jets jets_1 = Jets(Jet[8](Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0))));
    uint implied_1 = 0u;
    uint corner_1 = 0u;
    uint source_1 = 0u;
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            uint _e74 = corner_1;
            corner_1 = (_e74 + 1u);
        }
        loop_init_3 = false;
        uint _e8 = corner_1;
        if ((_e8 < 8u)) {
        } else {
            break;
        }
        {
            uint _e11 = corner_1;
            uint _e14 = corner_1;
            uint _e19 = corner_1;
            uvec3 along = uvec3((_e11 >> 2u), ((_e14 >> 1u) & 1u), (_e19 & 1u));
            uvec3 at = (along + uvec3((octant_1 & 1u), ((octant_1 >> 1u) & 1u), (octant_1 >> 2u)));
            source_1 = (1u << ((at.x + (3u * at.y)) + (9u * at.z)));
            uint _e46 = source_1;
            if (((block_1.present & _e46) == 0u)) {
                uint _e50 = implied_1;
                uint _e52 = corner_1;
                implied_1 = (_e50 | (1u << _e52));
                source_1 = (1u << (((2u * along.x) + (6u * along.y)) + (18u * along.z)));
            }
            uint _e69 = corner_1;
            uint _e71 = source_1;
            Jet _e72 = read_jet(interpolant_1, block_1, _e71);
            jets_1.corners[_e69] = _e72;
        }
    }
    uint _e76 = implied_1;
    if ((_e76 != 0u)) {
        uint _e79 = implied_1;
        settle(jets_1, _e79, octant_1, 0u);
        uint _e81 = implied_1;
        settle(jets_1, _e81, octant_1, 1u);
        uint _e83 = implied_1;
        settle(jets_1, _e83, octant_1, 2u);
    }
    Jets _e85 = jets_1;
    return _e85;
}

Face at_x(inout Jets jets_2, vec4 weights) {
    Face face = Face(vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)));
    int edge = 0;
    bool loop_init_4 = true;
    while(true) {
        if (!loop_init_4) {
            int _e37 = edge;
            edge = (_e37 + 1);
        }
        loop_init_4 = false;
        int _e5 = edge;
        if ((_e5 < 4)) {
        } else {
            break;
        }
        {
            int _e9 = edge;
            Jet near_2 = jets_2.corners[_e9];
            int _e13 = edge;
            Jet far_2 = jets_2.corners[(_e13 + 4)];
            int _e19 = edge;
            face.corners[_e19] = (((near_2.plain * weights.x) + (far_2.plain * weights.y)) + ((near_2.by_x * weights.z) + (far_2.by_x * weights.w)));
        }
    }
    Face _e39 = face;
    return _e39;
}

vec4 cubic(float t) {
    float rest = (1.0 - t);
    float end_1 = ((t * t) * (3.0 - (2.0 * t)));
    return vec4((1.0 - end_1), end_1, (t * (rest * rest)), (-((t * t)) * rest));
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

vec4 cubic_slope(float t_1) {
    float end_2 = ((6.0 * t_1) * (1.0 - t_1));
    return vec4(-(end_2), end_2, ((1.0 - t_1) * (1.0 - (3.0 * t_1))), (t_1 * ((3.0 * t_1) - 2.0)));
}

Answer tricubic(inout Jets jets_3, vec3 local_3) {
    vec4 _e3 = cubic(local_3.x);
    Face _e4 = at_x(jets_3, _e3);
    vec4 _e6 = cubic(local_3.y);
    vec4 _e8 = cubic(local_3.z);
    vec4 _e9 = at_y(_e4, _e6);
    vec4 _e11 = cubic_slope(local_3.x);
    Face _e12 = at_x(jets_3, _e11);
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

vec4 weighted_sum(Corners corners, vec2 x_1, vec2 y, vec2 z) {
    vec4 a = ((corners.at[0] * x_1.x) + (corners.at[4] * x_1.y));
    vec4 b = ((corners.at[1] * x_1.x) + (corners.at[5] * x_1.y));
    vec4 c = ((corners.at[2] * x_1.x) + (corners.at[6] * x_1.y));
    vec4 d = ((corners.at[3] * x_1.x) + (corners.at[7] * x_1.y));
    return ((((a * y.x) + (c * y.y)) * z.x) + (((b * y.x) + (d * y.y)) * z.y));
}

Answer trilinear(Jets jets_4, vec3 local_4) {
    Corners corners_1 = Corners(vec4[8](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)));
    int corner_2 = 0;
    bool loop_init_5 = true;
    while(true) {
        if (!loop_init_5) {
            int _e16 = corner_2;
            corner_2 = (_e16 + 1);
        }
        loop_init_5 = false;
        int _e5 = corner_2;
        if ((_e5 < 8)) {
        } else {
            break;
        }
        {
            int _e9 = corner_2;
            int _e12 = corner_2;
            corners_1.at[_e9] = jets_4.corners[_e12].plain;
        }
    }
    vec2 x_3 = vec2((1.0 - local_4.x), local_4.x);
    vec2 y_2 = vec2((1.0 - local_4.y), local_4.y);
    vec2 z_2 = vec2((1.0 - local_4.z), local_4.z);
    vec2 slope = vec2(-1.0, 1.0);
    Corners _e36 = corners_1;
    vec4 _e37 = weighted_sum(_e36, slope, y_2, z_2);
    float by_x = _e37.x;
    Corners _e39 = corners_1;
    vec4 _e40 = weighted_sum(_e39, x_3, slope, z_2);
    float by_y = _e40.x;
    Corners _e42 = corners_1;
    vec4 _e43 = weighted_sum(_e42, x_3, y_2, slope);
    float by_z = _e43.x;
    Corners _e45 = corners_1;
    vec4 _e46 = weighted_sum(_e45, x_3, y_2, z_2);
    return Answer(_e46.x, vec3(by_x, by_y, by_z));
}

Answer evaluate_octree(Field field_2, vec3 position) {
    uint node = 0u;
    uint shift_1 = 0u;
    uint octant_2 = 0u;
    bool local_5 = false;
    Block block_2 = Block(0u, 0u, 0u, 0, 0u, 0.0, 0.0);
    Jets jets_5 = Jets(Jet[8](Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0))));
    Answer answer = Answer(0.0, vec3(0.0));
    uvec3 cell_2 = min(uvec3(position), (field_2.cells - uvec3(1u)));
    uint _e9 = root_of(field_2, cell_2);
    uint _e11 = word((field_2.nodes + _e9));
    node = _e11;
    shift_1 = field_2.depth;
    while(true) {
        uint _e17 = node;
        if (((_e17 >> NODE_OFFSET_BITS) == NODE_INNER)) {
            uint _e24 = shift_1;
            local_5 = (_e24 > 0u);
        } else {
            local_5 = false;
        }
        bool _e28 = local_5;
        if (_e28) {
        } else {
            break;
        }
        {
            uint _e29 = shift_1;
            shift_1 = (_e29 - 1u);
            uint _e32 = shift_1;
            uint _e33 = octant_of(cell_2, _e32);
            octant_2 = _e33;
            uint _e35 = node;
            uint _e39 = octant_2;
            uint _e41 = word(((field_2.nodes + (_e35 & NODE_OFFSET_MASK)) + _e39));
            node = _e41;
        }
    }
    uint _e42 = shift_1;
    uint _e45 = shift_1;
    uint _e50 = shift_1;
    float _e51 = power_of_half(_e50);
    vec3 local_6 = ((position - vec3(((cell_2 >> uvec3(_e42)) << uvec3(_e45)))) * _e51);
    uint _e54 = shift_1;
    uint level = (field_2.depth - _e54);
    uint _e57 = node;
    uint start_1 = (field_2.samples + (_e57 & NODE_OFFSET_MASK));
    uint _e62 = word(start_1);
    block_2.present = (_e62 & LATTICE_MASK);
    block_2.sample_precision = ((_e62 >> PRECISION_SHIFT) & 3u);
    uint _e74 = word((start_1 + 1u));
    block_2.full = (_e74 & LATTICE_MASK);
    uint _e80 = word((start_1 + 2u));
    block_2.base = int(_e80);
    block_2.first = (start_1 + 3u);
    float _e87 = power_of_half(level);
    block_2.quantum = (field_2.quantum * _e87);
    float _e92 = power_of_half(level);
    block_2.edge = (field_2.spacing.x * _e92);
    Block _e95 = block_2;
    uint _e96 = octant_2;
    Jets _e97 = read_corners(field_2.reconstruction, _e95, _e96);
    jets_5 = _e97;
    if ((field_2.reconstruction == INTERPOLANT_TRICUBIC)) {
        Answer _e103 = tricubic(jets_5, local_6);
        answer = _e103;
    } else {
        Jets _e104 = jets_5;
        Answer _e105 = trilinear(_e104, local_6);
        answer = _e105;
    }
    vec3 _e107 = answer.gradient;
    float _e109 = block_2.edge;
    answer.gradient = (_e107 * (1.0 / _e109));
    Answer _e113 = answer;
    return _e113;
}

Answer answer_at(Field field_3, vec3 position_1) {
    Answer _e2 = evaluate_octree(field_3, position_1);
    return _e2;
}

Answer answer_inside(Field field_4, vec3 point_2) {
    Answer _e9 = answer_at(field_4, min(((point_2 - field_4.low) * field_4.cells_per_unit), vec3(field_4.cells)));
    return _e9;
}

Answer nearfield_evaluate(Field field_5, vec3 point_3) {
    Answer answer_1 = Answer(0.0, vec3(0.0));
    uvec3 bits_6 = (floatBitsToUint(point_3) & uvec3(2147483647u));
    if (any(greaterThanEqual(bits_6, uvec3(2139095040u)))) {
        Answer _e10 = answer_without_end(bits_6, point_3);
        return _e10;
    }
    vec3 nearest = min(max(point_3, field_5.low), field_5.high);
    Answer _e15 = answer_inside(field_5, nearest);
    answer_1 = _e15;
    if (any(notEqual(nearest, point_3))) {
        Answer _e20 = length_and_direction((point_3 - nearest));
        float _e23 = answer_1.distance_;
        float _e26 = finite((_e23 + _e20.distance_));
        answer_1.distance_ = _e26;
        answer_1.gradient = _e20.gradient;
    }
    Answer _e29 = answer_1;
    return _e29;
}

float nearfield_distance(Field field_6, vec3 point_4) {
    Answer _e2 = nearfield_evaluate(field_6, point_4);
    return _e2.distance_;
}
