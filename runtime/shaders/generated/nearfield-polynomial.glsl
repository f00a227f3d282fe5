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
struct Leaf {
    uint place;
    uvec3 cell;
    uint shift;
};
struct Region {
    uvec3 low;
    uvec3 high;
    uvec3 root;
    uvec3 cell;
    uint shift;
    uint finest;
    uint records[16];
    uint pending[16];
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
const uint ROOT_LEAF = 2147483648u;
const uint RECORD_LENGTH = 14u;
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
const uint GRADIENT_MASK = 1023u;
const uint GRADIENT_BITS = 10u;
const int GRADIENT_CENTRE = 511;
const float GRADIENT_STEP = 0.0019569471;
const float SUBNORMAL_STEP = 5.9604645e-8;
const uint MAX_MAGNITUDE_BITS = 1568669696u;
const uint INTERPOLANT_TRICUBIC = 1u;
const uint NODE_OFFSET_BITS = 28u;
const uint NODE_OFFSET_MASK = 268435455u;
const uint NODE_INNER = 0u;
const uint LATTICE_MASK = 134217727u;
const uint PRECISION_SHIFT = 27u;
const uint PRECISION_PACKED32_ = 0u;
const uint PRECISION_F16_ = 1u;
const uint PRECISION_F32_ = 2u;
const uint DISTANCE_SHIFT = 20u;
const uint RECONSTRUCTION_NEAREST = 0u;
const uint RECONSTRUCTION_HALF = 2u;
const uint RECONSTRUCTION_BLEND = 3u;
const uint RECONSTRUCTION_HERMITE = 4u;
const uint RANGE_BRICK = 1u;
const uint BRICK_EDGE = 4u;
const uint RECORD_FIRST = 8u;

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

uint joined(uint lower, uint upper, uint bit) {
    return ((lower >> bit) | ((upper << 1u) << (31u - bit)));
}

uint child_node(Field field_2, uint record, uint octant) {
    uint words[4] = uint[4](0u, 0u, 0u, 0u);
    uint index_3 = 0u;
    uint start_2 = (field_2.records + ((RECORD_LENGTH * record) / 4u));
    uint shift_3 = (8u * ((RECORD_LENGTH * record) & 3u));
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e27 = index_3;
            index_3 = (_e27 + 1u);
        }
        loop_init_1 = false;
        uint _e18 = index_3;
        if ((_e18 < 4u)) {
        } else {
            break;
        }
        {
            uint _e21 = index_3;
            uint _e23 = index_3;
            uint _e25 = word((start_2 + _e23));
            words[_e21] = _e25;
        }
    }
    uint _e30 = words[0];
    uint _e32 = words[1];
    uint _e33 = joined(_e30, _e32, shift_3);
    uint _e35 = words[1];
    uint _e37 = words[2];
    uint _e38 = joined(_e35, _e37, shift_3);
    uvec2 inner_and_starts = uvec2(_e33, _e38);
    uint _e41 = words[2];
    uint _e43 = words[3];
    uint _e44 = joined(_e41, _e43, shift_3);
    uint _e46 = words[3];
    uvec2 first = uvec2(_e44, (_e46 >> shift_3));
    uint own_2 = ((inner_and_starts[(octant >> 2u)] >> (8u * (octant & 3u))) & 255u);
    uint before = ((octant == 0u) ? 0u : own_2);
    if ((((inner_and_starts.x >> octant) & 1u) == 1u)) {
        return ((first.x & RECORD_CHILD_MASK) + before);
    }
    uint _e76 = joined(first.x, first.y, RECORD_CHILD_BITS);
    uint leaf_4 = (_e76 & RECORD_LEAF_MASK);
    return (ROOT_LEAF | (leaf_4 + before));
}

uint octant_of(uvec3 cell_1, uint shift) {
    uvec3 half_1 = ((cell_1 >> uvec3(shift)) & uvec3(1u));
    return ((half_1.x | (half_1.y << 1u)) | (half_1.z << 2u));
}

Leaf find_leaf(Field field_3, uvec3 cell_2) {
    uint node = 0u;
    uint shift_1 = 0u;
    bool local = false;
    uint _e3 = root_of(field_3, cell_2);
    uint _e5 = word((field_3.nodes + _e3));
    node = _e5;
    shift_1 = field_3.depth;
    while(true) {
        uint _e9 = node;
        if (((_e9 & ROOT_LEAF) == 0u)) {
            uint _e16 = shift_1;
            local = (_e16 > 0u);
        } else {
            local = false;
        }
        bool _e20 = local;
        if (_e20) {
        } else {
            break;
        }
        {
            uint _e21 = shift_1;
            shift_1 = (_e21 - 1u);
            uint _e24 = node;
            uint _e25 = shift_1;
            uint _e26 = octant_of(cell_2, _e25);
            uint _e27 = child_node(field_3, _e24, _e26);
            node = _e27;
        }
    }
    uint _e28 = node;
    uint _e31 = shift_1;
    uint _e34 = shift_1;
    uint _e37 = shift_1;
    return Leaf((_e28 & 2147483647u), ((cell_2 >> uvec3(_e31)) << uvec3(_e34)), _e37);
}

uint bits_at(uint section, uint bit_1, uint index_4) {
    uint at = ((section + index_4) + (bit_1 / 32u));
    uint _e7 = word(at);
    uint _e10 = word((at + 1u));
    uint _e13 = joined(_e7, _e10, (bit_1 & 31u));
    return _e13;
}

LeafHead read_head(Field field_4, uint place) {
    uint _e9 = bits_at(field_4.samples, (8u * (place & 3u)), (place / 4u));
    uint shape = (field_4.shapes + (2u * (_e9 & ((1u << field_4.shape_bits) - 1u))));
    uint codes_1 = (_e9 >> field_4.shape_bits);
    uint _e22 = word(shape);
    uint _e25 = word((shape + 1u));
    return LeafHead(_e22, _e25, (codes_1 & 3u), ((codes_1 >> SUPPORT_BITS) & 3u));
}

float power_of_half(uint exponent) {
    return uintBitsToFloat(((127u - min(exponent, 126u)) << 23u));
}

vec3 local_of(Leaf leaf, vec3 position) {
    float _e6 = power_of_half(leaf.shift);
    return (((position - vec3(leaf.cell)) * (2.0 * _e6)) - vec3(1.0));
}

float copy_sign(float magnitude, float sign_) {
    return uintBitsToFloat((floatBitsToUint(abs(magnitude)) | (floatBitsToUint(sign_) & 2147483648u)));
}

vec4 weight_at(vec3 local_1, float steepness) {
    vec3 s = clamp((vec3(0.5) + ((vec3(1.0) - abs(local_1)) * steepness)), vec3(0.0), vec3(1.0));
    vec3 w = ((s * s) * (vec3(3.0) - (2.0 * s)));
    float _e24 = copy_sign(steepness, -(local_1.x));
    float _e27 = copy_sign(steepness, -(local_1.y));
    float _e30 = copy_sign(steepness, -(local_1.z));
    vec3 signs_1 = vec3(_e24, _e27, _e30);
    vec3 slope_2 = (((6.0 * s) * (vec3(1.0) - s)) * signs_1);
    return vec4((slope_2.x * (w.y * w.z)), (slope_2.y * (w.x * w.z)), (slope_2.z * (w.x * w.y)), ((w.x * w.y) * w.z));
}

Terms read_terms(Field field_5, uint index_5, uint start, uint degree, uint widths) {
    float codes[20] = float[20](0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    uint bit_2 = 0u;
    uint number_2 = 0u;
    uint of_degree = 0u;
    Terms terms = Terms(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), 0u);
    bit_2 = start;
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            uint _e56 = of_degree;
            of_degree = (_e56 + 1u);
        }
        loop_init_2 = false;
        uint _e11 = of_degree;
        if ((_e11 <= min(degree, 3u))) {
        } else {
            break;
        }
        {
            uint _e15 = of_degree;
            uint _e16 = byte_of(widths, _e15);
            uint width = (_e16 & 31u);
            uint size_1 = (1u << width);
            uint _e21 = of_degree;
            uint _e24 = of_degree;
            uint _e28 = of_degree;
            uint end = ((((_e21 + 1u) * (_e24 + 2u)) * (_e28 + 3u)) / 6u);
            bool loop_init_3 = true;
            while(true) {
                if (!loop_init_3) {
                    uint _e53 = number_2;
                    number_2 = (_e53 + 1u);
                }
                loop_init_3 = false;
                uint _e34 = number_2;
                if ((_e34 < end)) {
                } else {
                    break;
                }
                {
                    uint _e37 = bit_2;
                    uint _e38 = bits_at(field_5.samples, _e37, index_5);
                    uint code_2 = (_e38 & (size_1 - 1u));
                    uint _e42 = number_2;
                    codes[_e42] = float((int(code_2) - int((size_1 >> 1u))));
                    uint _e50 = bit_2;
                    bit_2 = (_e50 + width);
                }
            }
        }
    }
    float _e61 = codes[1];
    float _e63 = codes[2];
    float _e65 = codes[3];
    float _e67 = codes[0];
    terms.linear = vec4(_e61, _e63, _e65, _e67);
    float _e71 = codes[4];
    float _e73 = codes[5];
    float _e75 = codes[6];
    terms.square = vec4(_e71, _e73, _e75, 0.0);
    float _e80 = codes[7];
    float _e82 = codes[8];
    float _e84 = codes[9];
    terms.cross_ = vec4(_e80, _e82, _e84, 0.0);
    float _e89 = codes[10];
    float _e91 = codes[11];
    float _e93 = codes[12];
    float _e95 = codes[19];
    terms.cube = vec4(_e89, _e91, _e93, _e95);
    float _e99 = codes[13];
    float _e101 = codes[14];
    float _e103 = codes[15];
    terms.next = vec4(_e99, _e101, _e103, 0.0);
    float _e108 = codes[16];
    float _e110 = codes[17];
    float _e112 = codes[18];
    terms.previous = vec4(_e108, _e110, _e112, 0.0);
    uint _e116 = bit_2;
    terms.end = _e116;
    Terms _e117 = terms;
    return _e117;
}

Answer evaluate_terms(Terms terms_1, uint degree_1, vec3 local_2) {
    vec4 value = vec4(0.0);
    vec4 slope = vec4(0.0);
    vec4 square = vec4(0.0);
    vec4 first_1 = vec4(local_2, 1.0);
    vec4 next = vec4(local_2.yzx, 0.0);
    vec4 previous = vec4(local_2.zxy, 0.0);
    vec4 second = vec4(((1.5 * (first_1 * first_1)) - vec4(0.5)).xyz, 0.0);
    vec4 third = vec4((first_1 * ((2.5 * (first_1 * first_1)) - vec4(1.5))).xyz, ((local_2.x * local_2.y) * local_2.z));
    value = (terms_1.linear * first_1);
    slope = terms_1.linear;
    if ((degree_1 >= 2u)) {
        vec4 line = (terms_1.linear + (terms_1.cross_ * next));
        square = terms_1.square;
        if ((degree_1 >= 3u)) {
            vec4 _e49 = square;
            square = (_e49 + ((terms_1.next * next) + (terms_1.previous * previous)));
        }
        vec4 _e57 = square;
        value = ((line * first_1) + (_e57 * second));
        vec4 _e64 = square;
        slope = ((line + (terms_1.cross_.zxyw * previous)) + (_e64 * (3.0 * first_1)));
        if ((degree_1 >= 3u)) {
            vec4 _e71 = value;
            value = (_e71 + (terms_1.cube * third));
            vec4 others = ((terms_1.next * second).zxyw + (terms_1.previous * second).yzxw);
            vec4 _e82 = slope;
            slope = ((_e82 + ((terms_1.cube * ((7.5 * (first_1 * first_1)) - vec4(1.5))) + others)) + (terms_1.cube.w * (next * previous)));
        }
    }
    float _e99 = value.x;
    float _e101 = value.y;
    float _e104 = value.z;
    float _e106 = value.w;
    vec4 _e109 = slope;
    return Answer(((_e99 + _e101) + (_e104 + _e106)), _e109.xyz);
}

float edge_of(Field field_6, Leaf leaf_1) {
    float _e7 = power_of_half((field_6.depth - leaf_1.shift));
    return (field_6.spacing.x * _e7);
}

Answer evaluate_leaf(Field field_7, Leaf leaf_2, LeafHead head, vec3 local_3) {
    uint bit_3 = 0u;
    Answer answer = Answer(0.0, vec3(0.0));
    uint index_6 = 0u;
    bool local_4 = false;
    bool local_5 = false;
    bool local_6 = false;
    bool local_7 = false;
    uint _e6 = byte_of(head.kind_and_degrees, 0u);
    uint _e9 = byte_of(head.kind_and_degrees, 3u);
    uint exponent_1 = (_e9 & MAX_EXPONENT);
    float step_ = (field_7.quantum * uintBitsToFloat(((127u + exponent_1) << 23u)));
    bit_3 = (((8u * (leaf_2.place & 3u)) + field_7.shape_bits) + ((field_7.overlap == 0.0) ? 0u : OVERLAP_BITS));
    bool loop_init_4 = true;
    while(true) {
        if (!loop_init_4) {
            uint _e95 = index_6;
            index_6 = (_e95 + 1u);
        }
        loop_init_4 = false;
        uint _e41 = index_6;
        if ((_e41 < ((_e6 == KIND_SINGLE) ? 1u : 2u))) {
        } else {
            break;
        }
        {
            uint _e50 = index_6;
            uint _e52 = byte_of(head.kind_and_degrees, (1u + _e50));
            uint _e56 = bit_3;
            Terms _e58 = read_terms(field_7, (leaf_2.place / 4u), _e56, _e52, head.widths);
            bit_3 = _e58.end;
            Answer _e60 = evaluate_terms(_e58, _e52, local_3);
            float _e63 = answer.distance_;
            bool is_less = (_e60.distance_ < _e63);
            float _e67 = answer.distance_;
            bool is_greater = (_e60.distance_ > _e67);
            uint _e69 = index_6;
            if (!((_e69 == 0u))) {
                if ((_e6 == KIND_MIN)) {
                    local_5 = is_less;
                } else {
                    local_5 = false;
                }
                bool _e80 = local_5;
                local_4 = _e80;
            } else {
                local_4 = true;
            }
            bool _e82 = local_4;
            if (!(_e82)) {
                if ((_e6 != KIND_MIN)) {
                    local_7 = is_greater;
                } else {
                    local_7 = false;
                }
                bool _e91 = local_7;
                local_6 = _e91;
            } else {
                local_6 = true;
            }
            bool _e93 = local_6;
            if (_e93) {
                answer = _e60;
            }
        }
    }
    float _e97 = edge_of(field_7, leaf_2);
    float per_half = (2.0 / _e97);
    float _e101 = answer.distance_;
    vec3 _e104 = answer.gradient;
    return Answer((_e101 * step_), ((_e104 * step_) * per_half));
}

bool is_shared(Field field_8, LeafHead head_1, vec3 local_8) {
    bool local_9 = false;
    float _e4 = power_of_half(head_1.reach);
    float share = ((head_1.reach == 0u) ? 128.0 : (_e4 * 4.0));
    float outermost = max(max(abs(local_8.x), abs(local_8.y)), abs(local_8.z));
    if ((field_8.overlap > 0.0)) {
        local_9 = (outermost > (1.0 - (field_8.overlap * share)));
    } else {
        local_9 = false;
    }
    bool _e31 = local_9;
    return _e31;
}

Region region_around(Field field_9, Leaf own, vec3 position_1, uint reach) {
    Region region = Region(uvec3(0u), uvec3(0u), uvec3(0u), uvec3(0u), 0u, 0u, uint[16](0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), uint[16](0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u));
    float _e4 = power_of_half(reach);
    float share_1 = ((reach == 0u) ? LEAST_SUPPORT_SHARE : (_e4 * 2.0));
    float margin = ((field_9.overlap * float((1u << own.shift))) * share_1);
    uvec3 last = (field_9.cells - uvec3(1u));
    region.low = min(uvec3(max((position_1 - vec3(margin)), vec3(0.0))), last);
    region.high = min(uvec3((position_1 + vec3(margin))), last);
    uvec3 _e38 = region.low;
    region.root = (_e38 >> uvec3(field_9.depth));
    region.shift = field_9.depth;
    region.finest = (max(own.shift, MAX_LEVELS_APART) - MAX_LEVELS_APART);
    Region _e50 = region;
    return _e50;
}

uint count_bits(uint bits_2) {
    uint pairs = (bits_2 - ((bits_2 >> 1u) & 1431655765u));
    uint nibbles = ((pairs & 858993459u) + ((pairs >> 2u) & 858993459u));
    return ((((nibbles + (nibbles >> 4u)) & 252645135u) * 16843009u) >> 24u);
}

uint children_in(uvec3 middle, uvec3 low, uvec3 high) {
    uint children = 255u;
    uint _e5 = children;
    children = (_e5 & (((high.x < middle.x) ? 85u : 255u) & ((low.x >= middle.x) ? 170u : 255u)));
    uint _e20 = children;
    children = (_e20 & (((high.y < middle.y) ? 51u : 255u) & ((low.y >= middle.y) ? 204u : 255u)));
    uint _e35 = children;
    children = (_e35 & (((high.z < middle.z) ? 15u : 255u) & ((low.z >= middle.z) ? 240u : 255u)));
    uint _e50 = children;
    return _e50;
}

Leaf next_leaf(Field field_10, inout Region region_1, uint own_1) {
    uint shift_2 = 0u;
    bool local_10 = false;
    uint node_1 = 0u;
    uvec3 cell_3 = uvec3(0u);
    bool local_11 = false;
    bool local_12 = false;
    while(true) {
        uint _e4 = region_1.shift;
        shift_2 = _e4;
        while(true) {
            uint _e6 = shift_2;
            if ((_e6 < field_10.depth)) {
                uint _e12 = shift_2;
                uint _e16 = region_1.pending[(_e12 & 15u)];
                local_10 = (_e16 == 0u);
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
                shift_2 = (_e21 + 1u);
            }
        }
        node_1 = 0u;
        cell_3 = uvec3(0u);
        uint _e28 = shift_2;
        if ((_e28 < field_10.depth)) {
            uint _e32 = shift_2;
            uint children_1 = region_1.pending[(_e32 & 15u)];
            uint _e38 = shift_2;
            region_1.pending[(_e38 & 15u)] = (children_1 & (children_1 - 1u));
            uint _e51 = count_bits(((children_1 & (~(children_1) + 1u)) - 1u));
            uvec3 _e53 = region_1.cell;
            uint _e54 = shift_2;
            uint _e59 = shift_2;
            uvec3 parent = ((_e53 >> uvec3((_e54 + 1u))) << uvec3((_e59 + 1u)));
            uint _e73 = shift_2;
            cell_3 = (parent + (uvec3((_e51 & 1u), ((_e51 >> 1u) & 1u), (_e51 >> 2u)) << uvec3(_e73)));
            uint _e78 = shift_2;
            uint _e82 = region_1.records[(_e78 & 15u)];
            uint _e83 = child_node(field_10, _e82, _e51);
            node_1 = _e83;
        } else {
            uvec3 root_1 = region_1.root;
            uvec3 _e87 = region_1.low;
            uvec3 first_2 = (_e87 >> uvec3(field_10.depth));
            uvec3 _e92 = region_1.high;
            uvec3 last_1 = (_e92 >> uvec3(field_10.depth));
            if ((root_1.z > last_1.z)) {
                break;
            }
            bool is_last_x = (root_1.x == last_1.x);
            if (is_last_x) {
                local_11 = (root_1.y == last_1.y);
            } else {
                local_11 = false;
            }
            bool is_last_y = local_11;
            region_1.root = uvec3((is_last_x ? first_2.x : (root_1.x + 1u)), (is_last_y ? first_2.y : (is_last_x ? (root_1.y + 1u) : root_1.y)), (is_last_y ? (root_1.z + 1u) : root_1.z));
            cell_3 = (root_1 << uvec3(field_10.depth));
            uvec3 _e132 = cell_3;
            uint _e133 = root_of(field_10, _e132);
            uint _e135 = word((field_10.nodes + _e133));
            node_1 = _e135;
        }
        uvec3 _e137 = cell_3;
        region_1.cell = _e137;
        uint _e138 = node_1;
        if (((_e138 & ROOT_LEAF) == 0u)) {
            uint _e145 = shift_2;
            local_12 = (_e145 > 0u);
        } else {
            local_12 = false;
        }
        bool _e149 = local_12;
        if (_e149) {
            uint _e151 = shift_2;
            region_1.shift = _e151;
            uint _e152 = shift_2;
            uint _e154 = region_1.finest;
            if ((_e152 == _e154)) {
                continue;
            }
            uint _e156 = shift_2;
            shift_2 = (_e156 - 1u);
            uint _e160 = shift_2;
            uint _e164 = node_1;
            region_1.records[(_e160 & 15u)] = _e164;
            uint _e166 = shift_2;
            uvec3 _e170 = cell_3;
            uint _e172 = shift_2;
            uvec3 _e177 = region_1.low;
            uvec3 _e179 = region_1.high;
            uint _e180 = children_in((_e170 + uvec3((1u << _e172))), _e177, _e179);
            region_1.pending[(_e166 & 15u)] = _e180;
            uint _e182 = shift_2;
            region_1.shift = _e182;
            continue;
        }
        uint _e184 = shift_2;
        region_1.shift = _e184;
        uint _e185 = node_1;
        uint place_2 = (_e185 & 2147483647u);
        if ((place_2 != own_1)) {
            uvec3 _e189 = cell_3;
            uint _e190 = shift_2;
            return Leaf(place_2, _e189, _e190);
        }
    }
    return Leaf(own_1, uvec3(0u), 0u);
}

Answer evaluate_polynomial_octree(Field field_11, vec3 position_2) {
    Answer alone = Answer(0.0, vec3(0.0));
    float weight = 0.0;
    vec3 weight_slope = vec3(0.0);
    float change = 0.0;
    vec3 slope_1 = vec3(0.0);
    bool is_alone = true;
    Region region_2 = Region(uvec3(0u), uvec3(0u), uvec3(0u), uvec3(0u), 0u, 0u, uint[16](0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), uint[16](0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u));
    Leaf leaf_3 = Leaf(0u, uvec3(0u), 0u);
    bool local_13 = false;
    Leaf _e8 = find_leaf(field_11, min(uvec3(position_2), (field_11.cells - uvec3(1u))));
    float steepness_1 = (0.25 / field_11.overlap);
    leaf_3 = _e8;
    while(true) {
        uint _e28 = leaf_3.place;
        LeafHead _e29 = read_head(field_11, _e28);
        Leaf _e30 = leaf_3;
        vec3 _e31 = local_of(_e30, position_2);
        uint _e33 = leaf_3.place;
        bool is_own = (_e33 == _e8.place);
        vec4 _e41 = weight_at(_e31, (steepness_1 * float((1u << _e29.support))));
        if (!(is_own)) {
            local_13 = (_e41.w > 0.0);
        } else {
            local_13 = true;
        }
        bool _e49 = local_13;
        if (_e49) {
            Leaf _e50 = leaf_3;
            Answer _e51 = evaluate_leaf(field_11, _e50, _e29, _e31);
            if (is_own) {
                alone = _e51;
                bool _e52 = is_shared(field_11, _e29, _e31);
                if (!(_e52)) {
                    return _e51;
                }
                Region _e55 = region_around(field_11, _e8, position_2, _e29.reach);
                region_2 = _e55;
            } else {
                is_alone = false;
            }
            float _e59 = alone.distance_;
            float difference = (_e51.distance_ - _e59);
            Leaf _e62 = leaf_3;
            float _e63 = edge_of(field_11, _e62);
            vec3 its_slope = (_e41.xyz * (2.0 / _e63));
            float _e67 = weight;
            weight = (_e67 + _e41.w);
            float _e70 = change;
            change = (_e70 + (_e41.w * difference));
            vec3 _e74 = weight_slope;
            weight_slope = (_e74 + its_slope);
            vec3 _e76 = slope_1;
            slope_1 = (_e76 + ((_e41.w * _e51.gradient) + (its_slope * difference)));
        }
        Leaf _e84 = next_leaf(field_11, region_2, _e8.place);
        leaf_3 = _e84;
        uint _e86 = leaf_3.place;
        if ((_e86 == _e8.place)) {
            break;
        }
    }
    bool _e89 = is_alone;
    if (_e89) {
        Answer _e90 = alone;
        return _e90;
    }
    float _e91 = weight;
    float per_weight = (1.0 / _e91);
    float _e94 = change;
    float mean = (_e94 * per_weight);
    float _e97 = alone.distance_;
    vec3 _e99 = slope_1;
    vec3 _e100 = weight_slope;
    return Answer((_e97 + mean), ((_e99 - (mean * _e100)) * per_weight));
}

Answer answer_at(Field field_12, vec3 position_3) {
    Answer _e2 = evaluate_polynomial_octree(field_12, position_3);
    return _e2;
}

Answer answer_inside(Field field_13, vec3 point_2) {
    Answer _e9 = answer_at(field_13, min(((point_2 - field_13.low) * field_13.cells_per_unit), vec3(field_13.cells)));
    return _e9;
}

Answer nearfield_evaluate(Field field_14, vec3 point_3) {
    Answer answer_1 = Answer(0.0, vec3(0.0));
    uvec3 bits_6 = (floatBitsToUint(point_3) & uvec3(2147483647u));
    if (any(greaterThanEqual(bits_6, uvec3(2139095040u)))) {
        Answer _e10 = answer_without_end(bits_6, point_3);
        return _e10;
    }
    vec3 nearest = min(max(point_3, field_14.low), field_14.high);
    Answer _e15 = answer_inside(field_14, nearest);
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

float nearfield_distance(Field field_15, vec3 point_4) {
    Answer _e2 = nearfield_evaluate(field_15, point_4);
    return _e2.distance_;
}

vec3 decode_gradient(uint code) {
    ivec2 codes_2 = (ivec2(uvec2((code & GRADIENT_MASK), ((code >> GRADIENT_BITS) & GRADIENT_MASK))) - ivec2(511));
    vec2 flat_ = (vec2(codes_2) * GRADIENT_STEP);
    float z = ((1.0 - abs(flat_.x)) - abs(flat_.y));
    float fold = max(-(z), 0.0);
    float _e27 = copy_sign(fold, flat_.x);
    float x_1 = (flat_.x - _e27);
    float _e31 = copy_sign(fold, flat_.y);
    float y = (flat_.y - _e31);
    float _e39 = reciprocal_sqrt((((x_1 * x_1) + (y * y)) + (z * z)));
    return (vec3(x_1, y, z) * _e39);
}

float decode_half(uint bits_3) {
    uint sign_1 = ((bits_3 & 32768u) << 16u);
    uint exponent_2 = ((bits_3 >> 10u) & 31u);
    uint fraction = (bits_3 & 1023u);
    if ((exponent_2 == 0u)) {
        return uintBitsToFloat((sign_1 | floatBitsToUint((float(fraction) * SUBNORMAL_STEP))));
    }
    return uintBitsToFloat((sign_1 | ((exponent_2 == 31u) ? 0u : (((exponent_2 + 112u) << 23u) | (fraction << 13u)))));
}

vec2 decode_halves(uint bits_4) {
    float _e1 = decode_half(bits_4);
    float _e4 = decode_half((bits_4 >> 16u));
    return vec2(_e1, _e4);
}

float decode_distance(int base, uint code_1, float quantum) {
    return (float((base + int(code_1))) * quantum);
}

float decode_float(uint bits_5) {
    return (((bits_5 & 2147483647u) <= MAX_MAGNITUDE_BITS) ? uintBitsToFloat(bits_5) : 0.0);
}
