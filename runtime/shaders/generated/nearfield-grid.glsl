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
struct Face {
    vec4 corners[4];
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
const uint RECONSTRUCTION_HERMITE = 4u;
const uint RECONSTRUCTION_HALF = 2u;
const uint PRECISION_F32_ = 2u;
const uint PRECISION_PACKED32_ = 0u;
const float SUBNORMAL_STEP = 5.9604645e-8;
const uint MAX_MAGNITUDE_BITS = 1568669696u;
const uint GRADIENT_MASK = 1023u;
const uint GRADIENT_BITS = 10u;
const int GRADIENT_CENTRE = 511;
const float GRADIENT_STEP = 0.0019569471;
const uint DISTANCE_SHIFT = 20u;
const uint RANGE_BRICK = 1u;
const uint BRICK_EDGE = 4u;
const uint RECONSTRUCTION_BLEND = 3u;
const uint RECONSTRUCTION_NEAREST = 0u;
const uint INTERPOLANT_TRICUBIC = 1u;
const uint NODE_OFFSET_BITS = 28u;
const uint NODE_OFFSET_MASK = 268435455u;
const uint NODE_INNER = 0u;
const uint LATTICE_MASK = 134217727u;
const uint PRECISION_SHIFT = 27u;
const uint PRECISION_F16_ = 1u;
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
    float half_1 = (0.5 * x);
    float coarse = (seed * (1.5 - (half_1 * (seed * seed))));
    return (coarse + (coarse * (0.5 - (half_1 * (coarse * coarse)))));
}

float finite(float number_1) {
    return intBitsToFloat(min(floatBitsToInt(number_1), 2139095039));
}

Answer length_and_direction(vec3 vector) {
    float largest = max(max(abs(vector.x), abs(vector.y)), abs(vector.z));
    vec3 scaled = (vector / vec3(largest));
    float taxicab = ((abs(scaled.x) + abs(scaled.y)) + abs(scaled.z));
    vec3 place = (scaled / vec3(taxicab));
    float squared = (((place.x * place.x) + (place.y * place.y)) + (place.z * place.z));
    float _e32 = reciprocal_sqrt(squared);
    float _e36 = finite(((taxicab * (squared * _e32)) * largest));
    return Answer(_e36, (place * _e32));
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

vec4 factors_of(Field field_1) {
    if ((field_1.reconstruction != RECONSTRUCTION_HALF)) {
        return vec4(1.0);
    }
    switch(field_1.order) {
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

uint coefficients_of(Field field_2) {
    switch(field_2.order) {
        case 0u: {
            return 1u;
        }
        case 1u: {
            return 4u;
        }
        case 2u: {
            return 10u;
        }
        default: {
            return 20u;
        }
    }
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

float decode_float(uint bits_3) {
    return (((bits_3 & 2147483647u) <= MAX_MAGNITUDE_BITS) ? uintBitsToFloat(bits_3) : 0.0);
}

float copy_sign(float magnitude, float sign_) {
    return uintBitsToFloat((floatBitsToUint(abs(magnitude)) | (floatBitsToUint(sign_) & 2147483648u)));
}

vec3 decode_gradient(uint code) {
    ivec2 codes = (ivec2(uvec2((code & GRADIENT_MASK), ((code >> GRADIENT_BITS) & GRADIENT_MASK))) - ivec2(511));
    vec2 flat_ = (vec2(codes) * GRADIENT_STEP);
    float z_2 = ((1.0 - abs(flat_.x)) - abs(flat_.y));
    float fold = max(-(z_2), 0.0);
    float _e27 = copy_sign(fold, flat_.x);
    float x_3 = (flat_.x - _e27);
    float _e31 = copy_sign(fold, flat_.y);
    float y_2 = (flat_.y - _e31);
    float _e39 = reciprocal_sqrt((((x_3 * x_3) + (y_2 * y_2)) + (z_2 * z_2)));
    return (vec3(x_3, y_2, z_2) * _e39);
}

float decode_distance(int base, uint code_1, float quantum) {
    return (float((base + int(code_1))) * quantum);
}

int base_of(Field field_3, uvec3 vertex) {
    uint brick = 0u;
    if ((field_3.range == RANGE_BRICK)) {
        uvec3 bricks = ((field_3.counts + uvec3(3u)) / uvec3(4u));
        uvec3 at_1 = (vertex / uvec3(4u));
        brick = (at_1.x + (bricks.x * (at_1.y + (bricks.y * at_1.z))));
    }
    uint _e27 = brick;
    uint _e29 = word((field_3.nodes + _e27));
    return int(_e29);
}

Polynomial read_polynomial(Field field_4, uvec3 vertex_1) {
    bool local = false;
    float stored[20] = float[20](0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    uint first = 0u;
    uint half_ = 0u;
    Polynomial sample_ = Polynomial(0.0, vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
    uint number_2 = (vertex_1.x + (field_4.counts.x * (vertex_1.y + (field_4.counts.y * vertex_1.z))));
    uint _e13 = coefficients_of(field_4);
    bool is_float = (field_4.sample_precision == PRECISION_F32_);
    if ((field_4.sample_precision == PRECISION_PACKED32_)) {
        local = (field_4.order > 0u);
    } else {
        local = false;
    }
    bool is_packed = local;
    uint skipped = (is_packed ? 2u : 0u);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e66 = half_;
            half_ = (_e66 + 1u);
        }
        loop_init_1 = false;
        uint _e35 = half_;
        if ((_e35 < (_e13 - skipped))) {
        } else {
            break;
        }
        {
            uint _e40 = half_;
            uint place_1 = ((number_2 * (_e13 - skipped)) + _e40);
            uint _e47 = word((field_4.samples + (is_float ? place_1 : (place_1 / 2u))));
            uint bits_6 = (_e47 >> (is_float ? 0u : (16u * (place_1 & 1u))));
            uint _e55 = half_;
            if ((_e55 == 0u)) {
                first = bits_6;
            }
            uint _e58 = half_;
            float _e61 = decode_half(bits_6);
            stored[(_e58 + skipped)] = _e61;
            if (is_float) {
                uint _e62 = half_;
                float _e64 = decode_float(bits_6);
                stored[_e62] = _e64;
            }
        }
    }
    if (is_packed) {
        uint _e68 = first;
        vec3 _e69 = decode_gradient(_e68);
        stored[1] = _e69.x;
        stored[2] = _e69.y;
        stored[3] = _e69.z;
    }
    if (!(is_float)) {
        uint _e77 = first;
        uint _e80 = first;
        uint code_2 = (is_packed ? (_e80 >> DISTANCE_SHIFT) : (_e77 & 65535u));
        int _e85 = base_of(field_4, vertex_1);
        float _e87 = decode_distance(_e85, code_2, field_4.quantum);
        stored[0] = _e87;
    }
    float _e91 = stored[0];
    sample_.constant = _e91;
    float _e94 = stored[1];
    float _e96 = stored[2];
    float _e98 = stored[3];
    sample_.first = vec3(_e94, _e96, _e98);
    float _e102 = stored[4];
    float _e104 = stored[5];
    float _e106 = stored[6];
    sample_.square = vec3(_e102, _e104, _e106);
    float _e110 = stored[7];
    float _e112 = stored[8];
    float _e114 = stored[9];
    sample_.cross_ = vec3(_e110, _e112, _e114);
    float _e118 = stored[10];
    float _e120 = stored[11];
    float _e122 = stored[12];
    sample_.cube = vec3(_e118, _e120, _e122);
    float _e126 = stored[13];
    float _e128 = stored[14];
    float _e130 = stored[15];
    sample_.mixed = vec3(_e126, _e128, _e130);
    float _e134 = stored[16];
    float _e136 = stored[17];
    float _e138 = stored[18];
    sample_.more = vec3(_e134, _e136, _e138);
    float _e142 = stored[19];
    sample_.xyz = _e142;
    vec3 s = field_4.spacing;
    vec3 r = (s / vec3(max(max(s.x, s.y), s.z)));
    vec3 _e152 = sample_.first;
    sample_.first = (_e152 * s);
    vec3 _e155 = sample_.square;
    sample_.square = (_e155 * (s * r));
    vec3 _e159 = sample_.cross_;
    sample_.cross_ = (_e159 * (s.xxy * r.yzz));
    vec3 _e165 = sample_.cube;
    sample_.cube = (_e165 * ((s * r) * r));
    vec3 _e170 = sample_.mixed;
    sample_.mixed = (_e170 * ((s.xxx * r.xxy) * r.yzy));
    vec3 _e178 = sample_.more;
    sample_.more = (_e178 * ((s.xyy * r.zyz) * r.zzz));
    float _e186 = sample_.xyz;
    sample_.xyz = (_e186 * ((s.x * r.y) * r.z));
    Polynomial _e193 = sample_;
    return _e193;
}

Answer polynomial_at(Polynomial p, vec3 at, vec4 factors) {
    float x_4 = at.x;
    float y_3 = at.y;
    float z_3 = at.z;
    float first_1 = (((p.first.x * x_4) + (p.first.y * y_3)) + (p.first.z * z_3));
    float second = ((((((p.square.x * x_4) + (p.cross_.x * y_3)) + (p.cross_.y * z_3)) * x_4) + (((p.square.y * y_3) + (p.cross_.z * z_3)) * y_3)) + (p.square.z * (z_3 * z_3)));
    float third = (((((((((p.cube.x * x_4) + (p.mixed.x * y_3)) + (p.mixed.y * z_3)) * x_4) + (((p.mixed.z * y_3) + (p.xyz * z_3)) * y_3)) + (p.more.x * (z_3 * z_3))) * x_4) + (((((p.cube.y * y_3) + (p.more.y * z_3)) * y_3) + (p.more.z * (z_3 * z_3))) * y_3)) + (p.cube.z * ((z_3 * z_3) * z_3)));
    float value = ((((p.constant * factors.x) + (first_1 * factors.y)) + (second * factors.z)) + (third * factors.w));
    float by_x = (((p.first.x * factors.y) + (((((2.0 * p.square.x) * x_4) + (p.cross_.x * y_3)) + (p.cross_.y * z_3)) * factors.z)) + (((((((3.0 * p.cube.x) * x_4) + (2.0 * ((p.mixed.x * y_3) + (p.mixed.y * z_3)))) * x_4) + (((p.mixed.z * y_3) + (p.xyz * z_3)) * y_3)) + (p.more.x * (z_3 * z_3))) * factors.w));
    float by_y = (((p.first.y * factors.y) + (((((2.0 * p.square.y) * y_3) + (p.cross_.x * x_4)) + (p.cross_.z * z_3)) * factors.z)) + (((((((3.0 * p.cube.y) * y_3) + (2.0 * ((p.mixed.z * x_4) + (p.more.y * z_3)))) * y_3) + (((p.mixed.x * x_4) + (p.xyz * z_3)) * x_4)) + (p.more.z * (z_3 * z_3))) * factors.w));
    float by_z = (((p.first.z * factors.y) + (((((2.0 * p.square.z) * z_3) + (p.cross_.y * x_4)) + (p.cross_.z * y_3)) * factors.z)) + (((((((3.0 * p.cube.z) * z_3) + (2.0 * ((p.more.x * x_4) + (p.more.z * y_3)))) * z_3) + (((p.mixed.y * x_4) + (p.xyz * y_3)) * x_4)) + (p.more.y * (y_3 * y_3))) * factors.w));
    return Answer(value, vec3(by_x, by_y, by_z));
}

vec3 quintic(float t, uint end) {
    float rest = (1.0 - t);
    float cube = ((t * t) * t);
    float rest_cube = ((rest * rest) * rest);
    float far = (cube * (10.0 - (t * (15.0 - (6.0 * t)))));
    vec3 near_weights = vec3((1.0 - far), ((t * rest_cube) * (1.0 + (3.0 * t))), ((t * t) * rest_cube));
    vec3 far_weights = vec3(far, ((-(cube) * rest) * (4.0 - (3.0 * t))), (cube * (rest * rest)));
    return mix(near_weights, far_weights, bvec3((end == 1u)));
}

float quintic_product(Polynomial p_1, vec3 x_1, vec3 y, vec3 z) {
    return (((((((((p_1.constant * x_1.x) + (p_1.first.x * x_1.y)) + (p_1.square.x * x_1.z)) * y.x) + (((p_1.first.y * x_1.x) + (p_1.cross_.x * x_1.y)) * y.y)) + ((p_1.square.y * x_1.x) * y.z)) * z.x) + (((((p_1.first.z * x_1.x) + (p_1.cross_.y * x_1.y)) * y.x) + ((p_1.cross_.z * x_1.x) * y.y)) * z.y)) + (((p_1.square.z * x_1.x) * y.x) * z.z));
}

vec3 quintic_slope(float t_1, uint end_1) {
    float rest_1 = (1.0 - t_1);
    float square = (t_1 * t_1);
    float rest_square = (rest_1 * rest_1);
    float far_1 = ((30.0 * square) * rest_square);
    vec3 near_weights_1 = vec3(-(far_1), (rest_square * (1.0 + (t_1 * (2.0 - (15.0 * t_1))))), ((t_1 * rest_square) * (2.0 - (5.0 * t_1))));
    vec3 far_weights_1 = vec3(far_1, (square * ((t_1 * (28.0 - (15.0 * t_1))) - 12.0)), ((square * rest_1) * (3.0 - (5.0 * t_1))));
    return mix(near_weights_1, far_weights_1, bvec3((end_1 == 1u)));
}

Answer quintic_part(Polynomial sample_1, vec3 local_1, uvec3 end_2) {
    vec3 _e5 = quintic(local_1.x, end_2.x);
    vec3 _e8 = quintic(local_1.y, end_2.y);
    vec3 _e11 = quintic(local_1.z, end_2.z);
    vec3 _e14 = quintic_slope(local_1.x, end_2.x);
    float _e15 = quintic_product(sample_1, _e14, _e8, _e11);
    vec3 _e18 = quintic_slope(local_1.y, end_2.y);
    float _e19 = quintic_product(sample_1, _e5, _e18, _e11);
    vec3 _e22 = quintic_slope(local_1.z, end_2.z);
    float _e23 = quintic_product(sample_1, _e5, _e8, _e22);
    float _e24 = quintic_product(sample_1, _e5, _e8, _e11);
    return Answer(_e24, vec3(_e15, _e19, _e23));
}

vec4 weights_of(Field field_5, float t_2) {
    float end_3 = 0.0;
    float slope = 1.0;
    uint smoothness = ((field_5.reconstruction == RECONSTRUCTION_BLEND) ? field_5.order : 0u);
    float rest_2 = (1.0 - t_2);
    end_3 = t_2;
    if ((field_5.reconstruction == RECONSTRUCTION_NEAREST)) {
        end_3 = ((t_2 >= 0.5) ? 1.0 : 0.0);
        slope = 0.0;
    } else {
        if ((smoothness == 1u)) {
            end_3 = ((t_2 * t_2) * (3.0 - (2.0 * t_2)));
            slope = ((6.0 * t_2) * rest_2);
        } else {
            if ((smoothness == 2u)) {
                end_3 = (((t_2 * t_2) * t_2) * (10.0 - (t_2 * (15.0 - (6.0 * t_2)))));
                slope = ((30.0 * (t_2 * t_2)) * (rest_2 * rest_2));
            } else {
                if ((smoothness == 3u)) {
                    float square_1 = (t_2 * t_2);
                    float cube_1 = (((t_2 * rest_2) * (t_2 * rest_2)) * (t_2 * rest_2));
                    end_3 = ((square_1 * square_1) * (35.0 - (t_2 * (84.0 - (t_2 * (70.0 - (20.0 * t_2)))))));
                    slope = (140.0 * cube_1);
                }
            }
        }
    }
    float _e72 = end_3;
    float _e75 = end_3;
    float _e76 = slope;
    float _e78 = slope;
    return vec4((1.0 - _e72), _e75, -(_e76), _e78);
}

vec4 weighted_sum(Corners corners, vec2 x_2, vec2 y_1, vec2 z_1) {
    vec4 a = ((corners.at[0] * x_2.x) + (corners.at[4] * x_2.y));
    vec4 b = ((corners.at[1] * x_2.x) + (corners.at[5] * x_2.y));
    vec4 c = ((corners.at[2] * x_2.x) + (corners.at[6] * x_2.y));
    vec4 d = ((corners.at[3] * x_2.x) + (corners.at[7] * x_2.y));
    return ((((a * y_1.x) + (c * y_1.y)) * z_1.x) + (((b * y_1.x) + (d * y_1.y)) * z_1.y));
}

Answer weighted_answer(Field field_6, Corners corners_1, vec3 local_2) {
    vec4 _e4 = weights_of(field_6, local_2.x);
    vec4 _e6 = weights_of(field_6, local_2.y);
    vec4 _e8 = weights_of(field_6, local_2.z);
    vec4 _e12 = weighted_sum(corners_1, _e4.xy, _e6.xy, _e8.xy);
    vec4 _e16 = weighted_sum(corners_1, _e4.zw, _e6.xy, _e8.xy);
    float by_x_1 = _e16.w;
    vec4 _e21 = weighted_sum(corners_1, _e4.xy, _e6.zw, _e8.xy);
    float by_y_1 = _e21.w;
    vec4 _e26 = weighted_sum(corners_1, _e4.xy, _e6.xy, _e8.zw);
    float by_z_1 = _e26.w;
    return Answer(_e12.w, (vec3(by_x_1, by_y_1, by_z_1) + _e12.xyz));
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
            Jet near = jets.corners[_e9];
            int _e13 = edge;
            Jet far_2 = jets.corners[(_e13 + 4)];
            int _e19 = edge;
            face.corners[_e19] = (((near.plain * weights.x) + (far_2.plain * weights.y)) + ((near.by_x * weights.z) + (far_2.by_x * weights.w)));
        }
    }
    Face _e39 = face;
    return _e39;
}

vec4 cubic(float t_3) {
    float rest_3 = (1.0 - t_3);
    float end_4 = ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
    return vec4((1.0 - end_4), end_4, (t_3 * (rest_3 * rest_3)), (-((t_3 * t_3)) * rest_3));
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

vec4 cubic_slope(float t_4) {
    float end_5 = ((6.0 * t_4) * (1.0 - t_4));
    return vec4(-(end_5), end_5, ((1.0 - t_4) * (1.0 - (3.0 * t_4))), (t_4 * ((3.0 * t_4) - 2.0)));
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

Answer evaluate_grid(Field field_7, vec3 position) {
    Corners weighted = Corners(vec4[8](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0)));
    Jets jets_2 = Jets(Jet[8](Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0)), Jet(vec4(0.0), vec4(0.0))));
    Answer quintics = Answer(0.0, vec3(0.0));
    uint corner = 0u;
    Answer answer = Answer(0.0, vec3(0.0));
    uvec3 cell = min(uvec3(position), (field_7.cells - uvec3(1u)));
    vec3 local_4 = (position - vec3(cell));
    bool is_hermite = (field_7.reconstruction == RECONSTRUCTION_HERMITE);
    vec4 _e13 = factors_of(field_7);
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            uint _e81 = corner;
            corner = (_e81 + 1u);
        }
        loop_init_3 = false;
        uint _e23 = corner;
        if ((_e23 < 8u)) {
        } else {
            break;
        }
        {
            uint _e26 = corner;
            uint _e29 = corner;
            uint _e34 = corner;
            uvec3 end_6 = uvec3((_e26 >> 2u), ((_e29 >> 1u) & 1u), (_e34 & 1u));
            Polynomial _e39 = read_polynomial(field_7, (cell + end_6));
            if (!(is_hermite)) {
                Answer _e43 = polynomial_at(_e39, (local_4 - vec3(end_6)), _e13);
                uint _e45 = corner;
                weighted.at[_e45] = vec4(_e43.gradient, _e43.distance_);
            } else {
                if ((field_7.order == 1u)) {
                    vec4 plain = vec4(_e39.constant, _e39.first.z, _e39.first.y, 0.0);
                    uint _e61 = corner;
                    jets_2.corners[_e61] = Jet(plain, vec4(_e39.first.x, 0.0, 0.0, 0.0));
                } else {
                    Answer _e70 = quintic_part(_e39, local_4, end_6);
                    float _e72 = quintics.distance_;
                    vec3 _e76 = quintics.gradient;
                    quintics = Answer((_e72 + _e70.distance_), (_e76 + _e70.gradient));
                }
            }
        }
    }
    Answer _e83 = quintics;
    answer = _e83;
    if (!(is_hermite)) {
        Corners _e86 = weighted;
        Answer _e87 = weighted_answer(field_7, _e86, local_4);
        answer = _e87;
    } else {
        if ((field_7.order == 1u)) {
            Answer _e91 = tricubic(jets_2, local_4);
            answer = _e91;
        }
    }
    vec3 _e93 = answer.gradient;
    answer.gradient = (_e93 * field_7.cells_per_unit);
    Answer _e96 = answer;
    return _e96;
}

Answer answer_at(Field field_8, vec3 position_1) {
    Answer _e2 = evaluate_grid(field_8, position_1);
    return _e2;
}

Answer answer_inside(Field field_9, vec3 point_2) {
    Answer _e9 = answer_at(field_9, min(((point_2 - field_9.low) * field_9.cells_per_unit), vec3(field_9.cells)));
    return _e9;
}

Answer nearfield_evaluate(Field field_10, vec3 point_3) {
    Answer answer_1 = Answer(0.0, vec3(0.0));
    uvec3 bits_7 = (floatBitsToUint(point_3) & uvec3(2147483647u));
    if (any(greaterThanEqual(bits_7, uvec3(2139095040u)))) {
        Answer _e10 = answer_without_end(bits_7, point_3);
        return _e10;
    }
    vec3 nearest = min(max(point_3, field_10.low), field_10.high);
    Answer _e15 = answer_inside(field_10, nearest);
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

float nearfield_distance(Field field_11, vec3 point_4) {
    Answer _e2 = nearfield_evaluate(field_11, point_4);
    return _e2.distance_;
}

float power_of_half(uint exponent) {
    return uintBitsToFloat(((127u - min(exponent, 126u)) << 23u));
}

uint count_bits(uint bits_4) {
    uint pairs = (bits_4 - ((bits_4 >> 1u) & 1431655765u));
    uint nibbles = ((pairs & 858993459u) + ((pairs >> 2u) & 858993459u));
    return ((((nibbles + (nibbles >> 4u)) & 252645135u) * 16843009u) >> 24u);
}

vec2 decode_halves(uint bits_5) {
    float _e1 = decode_half(bits_5);
    float _e4 = decode_half((bits_5 >> 16u));
    return vec2(_e1, _e4);
}
