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
    vec3 place_2 = (scaled / vec3(taxicab));
    float squared = (((place_2.x * place_2.x) + (place_2.y * place_2.y)) + (place_2.z * place_2.z));
    float _e32 = reciprocal_sqrt(squared);
    float _e36 = finite(((taxicab * (squared * _e32)) * largest));
    return Answer(_e36, (place_2 * _e32));
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

uint root_of(Field field_1, uvec3 cell) {
    uvec3 root = (cell >> uvec3(field_1.depth));
    return (root.x + (field_1.counts.x * (root.y + (field_1.counts.y * root.z))));
}

uint joined(uint lower, uint upper, uint bit) {
    return ((lower >> bit) | ((upper << 1u) << (31u - bit)));
}

uint child_node(Field field_2, uint record, uint octant) {
    uint words[4] = uint[4](0u, 0u, 0u, 0u);
    uint index_5 = 0u;
    uint start_2 = (field_2.records + ((RECORD_LENGTH * record) / 4u));
    uint shift_3 = (8u * ((RECORD_LENGTH * record) & 3u));
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e27 = index_5;
            index_5 = (_e27 + 1u);
        }
        loop_init_1 = false;
        uint _e18 = index_5;
        if ((_e18 < 4u)) {
        } else {
            break;
        }
        {
            uint _e21 = index_5;
            uint _e23 = index_5;
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

uint bits_at(uint section, uint bit_1, uint index_6) {
    uint at_1 = ((section + index_6) + (bit_1 / 32u));
    uint _e7 = word(at_1);
    uint _e10 = word((at_1 + 1u));
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
    vec3 slope_3 = (((6.0 * s) * (vec3(1.0) - s)) * signs_1);
    return vec4((slope_3.x * (w.y * w.z)), (slope_3.y * (w.x * w.z)), (slope_3.z * (w.x * w.y)), ((w.x * w.y) * w.z));
}

Terms read_terms(Field field_5, uint index_7, uint start, uint degree, uint widths) {
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
                    uint _e38 = bits_at(field_5.samples, _e37, index_7);
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
    uint index_8 = 0u;
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
            uint _e95 = index_8;
            index_8 = (_e95 + 1u);
        }
        loop_init_4 = false;
        uint _e41 = index_8;
        if ((_e41 < ((_e6 == KIND_SINGLE) ? 1u : 2u))) {
        } else {
            break;
        }
        {
            uint _e50 = index_8;
            uint _e52 = byte_of(head.kind_and_degrees, (1u + _e50));
            uint _e56 = bit_3;
            Terms _e58 = read_terms(field_7, (leaf_2.place / 4u), _e56, _e52, head.widths);
            bit_3 = _e58.end;
            Answer _e60 = evaluate_terms(_e58, _e52, local_3);
            float _e63 = answer.distance_;
            bool is_less = (_e60.distance_ < _e63);
            float _e67 = answer.distance_;
            bool is_greater = (_e60.distance_ > _e67);
            uint _e69 = index_8;
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
        uint place_3 = (_e185 & 2147483647u);
        if ((place_3 != own_1)) {
            uvec3 _e189 = cell_3;
            uint _e190 = shift_2;
            return Leaf(place_3, _e189, _e190);
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

Answer answer_inside(Field field_13, vec3 point_1) {
    Answer _e9 = answer_at(field_13, min(((point_1 - field_13.low) * field_13.cells_per_unit), vec3(field_13.cells)));
    return _e9;
}

Answer nearfield_evaluate(Field field_14, vec3 point_2) {
    Answer answer_1 = Answer(0.0, vec3(0.0));
    uvec3 bits_6 = (floatBitsToUint(point_2) & uvec3(2147483647u));
    if (any(greaterThanEqual(bits_6, uvec3(2139095040u)))) {
        Answer _e10 = answer_without_end(bits_6, point_2);
        return _e10;
    }
    vec3 nearest = min(max(point_2, field_14.low), field_14.high);
    Answer _e15 = answer_inside(field_14, nearest);
    answer_1 = _e15;
    if (any(notEqual(nearest, point_2))) {
        Answer _e20 = length_and_direction((point_2 - nearest));
        float _e23 = answer_1.distance_;
        float _e26 = finite((_e23 + _e20.distance_));
        answer_1.distance_ = _e26;
        answer_1.gradient = _e20.gradient;
    }
    Answer _e29 = answer_1;
    return _e29;
}

float nearfield_distance(Field field_15, vec3 point_3) {
    Answer _e2 = nearfield_evaluate(field_15, point_3);
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

vec2 through(Field field_16, vec3 origin, vec3 direction) {
    vec3 safe = mix(direction, vec3(1e-20), lessThan(abs(direction), vec3(1e-20)));
    vec3 low_1 = ((field_16.low - origin) / safe);
    vec3 high_1 = ((field_16.high - origin) / safe);
    vec3 enter = min(low_1, high_1);
    vec3 leave_1 = max(low_1, high_1);
    return vec2(max(max(enter.x, enter.y), max(enter.z, 0.0)), min(min(leave_1.x, leave_1.y), leave_1.z));
}

vec3 direction_of(vec3 seen) {
    vec3 _e3 = _group_0_binding_1_fs.right;
    vec3 _e8 = _group_0_binding_1_fs.up;
    vec3 _e14 = _group_0_binding_1_fs.forward;
    return normalize((((_e3 * seen.x) + (_e8 * seen.y)) - (_e14 * seen.z)));
}

vec3 colour_of_distance(float distance_, float pixel_1) {
    float _e5 = _group_0_binding_1_fs.deepest;
    float depth = (2.0 * sqrt(clamp((abs(distance_) / _e5), 0.0, 1.0)));
    bool is_inside = (distance_ < 0.0);
    vec3 near = (is_inside ? vec3(222.0, 238.0, 250.0) : vec3(255.0, 246.0, 228.0));
    vec3 middle_1 = (is_inside ? vec3(88.0, 158.0, 214.0) : vec3(246.0, 178.0, 98.0));
    vec3 far = (is_inside ? vec3(10.0, 54.0, 112.0) : vec3(150.0, 50.0, 8.0));
    vec3 ground = ((depth > 1.0) ? mix(middle_1, far, (depth - 1.0)) : mix(near, middle_1, depth));
    float _e51 = _group_0_binding_1_fs.spacing;
    float _e56 = _group_0_binding_1_fs.spacing;
    float to_line = (distance_ - (roundEven((distance_ / _e51)) * _e56));
    float line_1 = clamp((1.0 - (abs(to_line) / pixel_1)), 0.0, 1.0);
    float surface = clamp((1.5 - (abs(distance_) / pixel_1)), 0.0, 1.0);
    vec3 encoded = (mix(mix(ground, vec3(96.0, 96.0, 100.0), (0.6 * line_1)), vec3(12.0, 12.0, 14.0), surface) / vec3(255.0));
    return mix(pow(((encoded + vec3(0.055)) / vec3(1.055)), vec3(2.4)), (encoded / vec3(12.92)), lessThanEqual(encoded, vec3(0.04045)));
}

float safe_step(float distance_1, float slope_2, float error) {
    return max((distance_1 / slope_2), (distance_1 - (2.0 * error)));
}

vec3 colour(Field field_17, vec3 direction_1) {
    vec2 interval = vec2(0.0);
    uint phase = TRACE;
    bool local_14 = false;
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
    bool local_15 = false;
    bool local_16 = false;
    bool local_17 = false;
    bool local_18 = false;
    bool local_19 = false;
    vec3 _e4 = _group_0_binding_1_fs.eye;
    vec2 _e5 = through(field_17, _e4, direction_1);
    interval = _e5;
    vec3 _e11 = _group_0_binding_1_fs.cut;
    vec3 _e14 = _group_0_binding_1_fs.eye;
    float _e18 = _group_0_binding_1_fs.cut_at;
    float beyond = (dot(_e11, _e14) - _e18);
    vec3 _e22 = _group_0_binding_1_fs.cut;
    if (any(notEqual(_e22, vec3(0.0)))) {
        local_14 = (beyond > 0.0);
    } else {
        local_14 = false;
    }
    bool _e32 = local_14;
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
    float _e56 = nearfield_slope();
    float slope_4 = max(_e56, 1.0);
    float _e59 = nearfield_error();
    vec3 _e61 = direction_of(LAMP);
    float _e63 = interval.x;
    travelled = _e63;
    vec3 _e67 = _group_0_binding_1_fs.eye;
    float _e68 = travelled;
    place_1 = (_e67 + (direction_1 * _e68));
    while(true) {
        vec3 _e86 = place_1;
        Answer _e87 = nearfield_evaluate(field_17, _e86);
        float _e91 = _group_0_binding_1_fs.offset;
        float distance_2 = (_e87.distance_ - _e91);
        uint _e93 = steps;
        steps = (_e93 + 1u);
        uint _e96 = phase;
        if ((_e96 == PLANE)) {
            float _e101 = _group_0_binding_1_fs.pixel;
            float _e102 = travelled;
            vec3 _e104 = colour_of_distance(distance_2, (_e101 * _e102));
            return _e104;
        } else {
            uint _e105 = phase;
            if ((_e105 == TRACE)) {
                float _e111 = _group_0_binding_1_fs.pixel;
                float _e113 = travelled;
                float near_1 = ((ARRIVED * _e111) * _e113);
                if ((distance_2 >= near_1)) {
                    uint _e118 = steps;
                    local_15 = (_e118 <= MAX_STEPS);
                } else {
                    local_15 = false;
                }
                bool _e122 = local_15;
                if (_e122) {
                    float _e123 = travelled;
                    float _e124 = safe_step(distance_2, slope_4, _e59);
                    travelled = (_e123 + max(_e124, near_1));
                    float _e127 = travelled;
                    float _e129 = interval.y;
                    if ((_e127 > _e129)) {
                        return BACKGROUND;
                    }
                    vec3 _e134 = _group_0_binding_1_fs.eye;
                    float _e135 = travelled;
                    place_1 = (_e134 + (direction_1 * _e135));
                    continue;
                }
                vec3 _e138 = place_1;
                point_4 = _e138;
                normal = (_e87.gradient / vec3(max(length(_e87.gradient), 1e-30)));
                vec3 _e146 = normal;
                vec3 _e147 = normal;
                vec3 _e149 = normal;
                normal = ((dot(_e149, direction_1) > 0.0) ? -(_e147) : _e146);
                uint _e156 = _group_0_binding_1_fs.show;
                if (((_e156 & SHOW_NORMALS) != 0u)) {
                    vec3 _e161 = normal;
                    return ((0.5 * _e161) + vec3(0.5));
                }
                vec3 _e167 = normal;
                facing = max(dot(_e167, _e61), 0.0);
                phase = OCCLUSION;
                steps = 0u;
            } else {
                uint _e173 = phase;
                if ((_e173 == OCCLUSION)) {
                    float _e178 = _group_0_binding_1_fs.size;
                    uint _e181 = steps;
                    float height = (((0.12 * _e178) * float(_e181)) / 5.0);
                    float _e186 = hidden;
                    float _e187 = weight_1;
                    hidden = (_e186 + (_e187 * clamp((1.0 - (distance_2 / height)), 0.0, 1.0)));
                    float _e196 = weight_1;
                    weight_1 = (_e196 * 0.7);
                } else {
                    float _e199 = lit;
                    float _e202 = travelled;
                    lit = min(_e199, ((SHADOW_SHARPNESS * distance_2) / _e202));
                    float _e205 = travelled;
                    float _e206 = safe_step(distance_2, slope_4, _e59);
                    float _e209 = _group_0_binding_1_fs.size;
                    travelled = (_e205 + max(_e206, (0.002 * _e209)));
                }
            }
        }
        uint _e214 = phase;
        if ((_e214 == OCCLUSION)) {
            uint _e221 = _group_0_binding_1_fs.show;
            if (!(((_e221 & SHOW_OCCLUSION) == 0u))) {
                uint _e229 = steps;
                local_17 = (_e229 == PROBES);
            } else {
                local_17 = true;
            }
            bool _e233 = local_17;
            local_16 = _e233;
        } else {
            local_16 = false;
        }
        bool _e235 = local_16;
        if (_e235) {
            float _e236 = facing;
            if (!((_e236 == 0.0))) {
                uint _e244 = _group_0_binding_1_fs.show;
                local_18 = ((_e244 & SHOW_SHADOW) == 0u);
            } else {
                local_18 = true;
            }
            bool _e250 = local_18;
            if (_e250) {
                break;
            }
            phase = SHADOW;
            vec3 _e252 = point_4;
            vec3 _e253 = normal;
            float _e256 = _group_0_binding_1_fs.size;
            vec2 _e261 = through(field_17, (_e252 + (_e253 * (0.001 * _e256))), _e61);
            leave = _e261.y;
            float _e265 = _group_0_binding_1_fs.size;
            travelled = (0.004 * _e265);
        }
        uint _e268 = phase;
        if ((_e268 == OCCLUSION)) {
            vec3 _e271 = point_4;
            vec3 _e272 = normal;
            float _e275 = _group_0_binding_1_fs.size;
            uint _e278 = steps;
            place_1 = (_e271 + (_e272 * (((0.12 * _e275) * float((_e278 + 1u))) / 5.0)));
        } else {
            float _e287 = travelled;
            float _e288 = leave;
            if (!((_e287 >= _e288))) {
                float _e293 = lit;
                local_19 = (_e293 <= 0.0);
            } else {
                local_19 = true;
            }
            bool _e297 = local_19;
            if (_e297) {
                break;
            }
            vec3 _e298 = point_4;
            vec3 _e299 = normal;
            float _e302 = _group_0_binding_1_fs.size;
            float _e307 = travelled;
            place_1 = ((_e298 + (_e299 * (0.001 * _e302))) + (_e61 * _e307));
        }
    }
    float _e310 = hidden;
    float open = (1.0 - (_e310 / ALL_PROBES));
    float _e315 = lit;
    float soft = clamp(_e315, 0.0, 1.0);
    float light = ((soft * soft) * (3.0 - (2.0 * soft)));
    vec3 _e325 = normal;
    vec3 _e328 = _group_0_binding_1_fs.up;
    float sky = (0.24 + (0.12 * dot(_e325, _e328)));
    float _e336 = facing;
    return (CLAY * ((sky * open) + (((0.95 * _e336) * light) * (0.5 + (0.5 * open)))));
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
    vec3 middle_2 = ((_e4 + (_e7 * (at.place.x * _e12))) + (_e18 * (at.place.y * _e23)));
    bool loop_init_5 = true;
    while(true) {
        if (!loop_init_5) {
            uint _e87 = index_1;
            index_1 = (_e87 + 1u);
        }
        loop_init_5 = false;
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
            vec2 place_4 = (within * _e68);
            vec3 _e70 = sum;
            vec3 _e73 = _group_0_binding_1_fs.right;
            vec3 _e79 = _group_0_binding_1_fs.up;
            vec3 _e84 = colour(_e1, normalize(((middle_2 + (_e73 * place_4.x)) + (_e79 * place_4.y))));
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

