struct Field {
    uint family;
    int _pad1_0;
    int _pad1_1;
    int _pad1_2;
    float3 low;
    int _pad2_0;
    float3 high;
    int _pad3_0;
    uint3 counts;
    int _pad4_0;
    uint3 cells;
    int _pad5_0;
    float3 cells_per_unit;
    int _pad6_0;
    float3 spacing;
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
    int _end_pad_0;
};

struct Answer {
    float distance_;
    int _pad1_0;
    int _pad1_1;
    int _pad1_2;
    float3 gradient;
    int _end_pad_0;
};

struct Corners {
    float4 at[8];
};

struct Jet {
    float4 plain;
    float4 by_x;
};

struct Jets {
    Jet corners[8];
};

struct Polynomial {
    float constant;
    int _pad1_0;
    int _pad1_1;
    int _pad1_2;
    float3 first;
    int _pad2_0;
    float3 square;
    int _pad3_0;
    float3 cross_;
    int _pad4_0;
    float3 cube;
    int _pad5_0;
    float3 mixed;
    int _pad6_0;
    float3 more;
    float xyz;
};

struct Face {
    float4 corners[4];
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
    int _pad1_0;
    int _pad1_1;
    int _pad1_2;
    uint3 cell;
    uint shift;
};

struct Region {
    uint3 low;
    int _pad1_0;
    uint3 high;
    int _pad2_0;
    uint3 root;
    int _pad3_0;
    uint3 cell;
    uint shift;
    uint finest;
    uint records[16];
    uint pending[16];
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

struct LeafHead {
    uint kind_and_degrees;
    uint widths;
    uint support;
    uint reach;
};

struct Terms {
    float4 linear_;
    float4 square;
    float4 cross_;
    float4 cube;
    float4 next;
    float4 previous;
    uint end;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

static const uint FAMILY_WORD = 4u;
static const uint FAMILY_BYTE = 0u;
static const uint BOX_MIN_WORD = 6u;
static const uint BOX_MAX_WORD = 9u;
static const uint SECTION_COUNT_WORD = 4u;
static const uint SECTION_COUNT_BYTE = 2u;
static const uint MAX_SECTIONS = 16u;
static const uint TABLE_WORD = 32u;
static const uint SECTION_WORDS = 4u;
static const uint SECTION_OCTREE = 1381253967u;
static const uint FAMILY_OCTREE = 2u;
static const uint SECTION_GRID = 1145655879u;
static const uint FAMILY_GRID = 1u;
static const uint SECTION_POLYNOMIAL = 1163023440u;
static const uint FAMILY_POLYNOMIAL = 3u;
static const uint SECTION_NODES = 1162104654u;
static const uint SECTION_BASES = 1163084098u;
static const uint SECTION_ROOTS = 1414483794u;
static const uint SECTION_SAMPLES = 1347240275u;
static const uint SECTION_LEAVES = 1178682700u;
static const uint SECTION_SHAPES = 1162889299u;
static const uint SECTION_RECORDS = 1162170964u;
static const uint MAX_DEPTH = 16u;
static const uint LIPSCHITZ_WORD = 14u;
static const uint SAMPLE_COUNT_WORD = 22u;
static const uint UNIFORM_MAX_WORD = 17u;
static const uint BAND_MAX_WORD = 20u;
static const uint RECONSTRUCTION_HERMITE = 4u;
static const uint RECONSTRUCTION_HALF = 2u;
static const uint PRECISION_F32_ = 2u;
static const uint PRECISION_PACKED32_ = 0u;
static const float SUBNORMAL_STEP = 5.9604645e-8;
static const uint MAX_MAGNITUDE_BITS = 1568669696u;
static const uint GRADIENT_MASK = 1023u;
static const uint GRADIENT_BITS = 10u;
static const int GRADIENT_CENTRE = int(511);
static const float GRADIENT_STEP = 0.0019569471;
static const uint DISTANCE_SHIFT = 20u;
static const uint RANGE_BRICK = 1u;
static const uint BRICK_EDGE = 4u;
static const uint RECONSTRUCTION_BLEND = 3u;
static const uint RECONSTRUCTION_NEAREST = 0u;
static const uint NODE_OFFSET_BITS = 28u;
static const uint NODE_INNER = 0u;
static const uint NODE_OFFSET_MASK = 268435455u;
static const uint LATTICE_MASK = 134217727u;
static const uint PRECISION_SHIFT = 27u;
static const uint INTERPOLANT_TRICUBIC = 1u;
static const uint PRECISION_F16_ = 1u;
static const uint ROOT_LEAF = 2147483648u;
static const uint RECORD_LENGTH = 14u;
static const uint RECORD_CHILD_MASK = 2097151u;
static const uint RECORD_CHILD_BITS = 21u;
static const uint RECORD_LEAF_MASK = 134217727u;
static const uint SUPPORT_BITS = 2u;
static const uint MAX_EXPONENT = 15u;
static const uint OVERLAP_BITS = 4u;
static const uint KIND_SINGLE = 0u;
static const uint KIND_MIN = 1u;
static const float MIN_OVERLAP = 0.015625;
static const uint MAX_LEVELS_APART = 5u;
static const uint MAX_SUPPORT = 3u;
static const float LEAST_SUPPORT_SHARE = 4.0;
static const uint RECORD_FIRST = 8u;

ByteAddressBuffer words_2 : register(t0);
ByteAddressBuffer points : register(t1);
RWByteAddressBuffer answers : register(u2);

uint NagaBufferLength(ByteAddressBuffer buffer)
{
    uint ret;
    buffer.GetDimensions(ret);
    return ret;
}

uint word(uint index)
{
    if ((index < ((NagaBufferLength(words_2) - 0) / 4))) {
        uint _e6 = asuint(words_2.Load(index*4));
        return _e6;
    }
    return 0u;
}

uint byte_of(uint bits, uint number)
{
    return ((bits >> (8u * number)) & 255u);
}

float float_(uint index_1)
{
    const uint _e1 = word(index_1);
    return asfloat(_e1);
}

uint naga_div(uint lhs, uint rhs) {
    return lhs / (rhs == 0u ? 1u : rhs);
}

Field nearfield_open()
{
    Field field = (Field)0;
    uint parameters = 0u;
    uint index_2 = 0u;

    const uint _e3 = word(FAMILY_WORD);
    const uint _e5 = byte_of(_e3, FAMILY_BYTE);
    field.family = _e5;
    const float _e8 = float_(BOX_MIN_WORD);
    const float _e10 = float_(7u);
    const float _e12 = float_(8u);
    field.low = float3(_e8, _e10, _e12);
    const float _e16 = float_(BOX_MAX_WORD);
    const float _e18 = float_(10u);
    const float _e20 = float_(11u);
    field.high = float3(_e16, _e18, _e20);
    const uint _e25 = word(SECTION_COUNT_WORD);
    const uint _e27 = byte_of(_e25, SECTION_COUNT_BYTE);
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
            const uint _e41 = word((entry + 1u));
            uint start_1 = naga_div(_e41, 4u);
            const uint _e44 = word(entry);
            bool should_continue = false;
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
    const uint _e88 = word(_e87);
    uint _e89 = parameters;
    const uint _e92 = word((_e89 + 1u));
    uint _e93 = parameters;
    const uint _e96 = word((_e93 + 2u));
    field.counts = uint3((_e88 & 65535u), (_e88 >> 16u), (_e92 & 65535u));
    uint _e106 = field.family;
    if ((_e106 == FAMILY_GRID)) {
        const uint _e111 = byte_of(_e92, 2u);
        field.order = _e111;
        const uint _e114 = byte_of(_e92, 3u);
        field.reconstruction = _e114;
        const uint _e117 = byte_of(_e96, 0u);
        field.sample_precision = _e117;
        const uint _e120 = byte_of(_e96, 1u);
        field.range = _e120;
        uint3 _e123 = field.counts;
        field.cells = (_e123 - (1u).xxx);
        uint _e128 = parameters;
        const float _e131 = float_((_e128 + 3u));
        uint _e132 = parameters;
        const float _e135 = float_((_e132 + 4u));
        uint _e136 = parameters;
        const float _e139 = float_((_e136 + 5u));
        field.spacing = float3(_e131, _e135, _e139);
        float3 _e143 = field.spacing;
        field.cells_per_unit = ((1.0).xxx / _e143);
        uint _e148 = parameters;
        const float _e151 = float_((_e148 + 6u));
        field.quantum = _e151;
    } else {
        const uint _e154 = byte_of(_e92, 2u);
        field.depth = min(_e154, MAX_DEPTH);
        const uint _e159 = byte_of(_e92, 3u);
        field.reconstruction = _e159;
        const uint _e162 = byte_of(_e92, 3u);
        field.shape_bits = _e162;
        uint3 _e165 = field.counts;
        uint _e167 = field.depth;
        field.cells = (_e165 << (_e167).xxx);
        uint _e171 = parameters;
        const float _e174 = float_((_e171 + 3u));
        field.spacing = (_e174).xxx;
        uint _e179 = field.depth;
        float _e184 = field.spacing.x;
        field.cells_per_unit = ((float((1u << _e179)) / _e184)).xxx;
        uint _e188 = parameters;
        const float _e191 = float_((_e188 + 4u));
        field.quantum = _e191;
        uint _e193 = field.family;
        if ((_e193 == FAMILY_POLYNOMIAL)) {
            uint _e197 = parameters;
            const float _e200 = float_((_e197 + 5u));
            field.overlap = _e200;
        }
    }
    Field _e201 = field;
    const Field field_24 = _e201;
    return field_24;
}

float nearfield_slope()
{
    const float _e1 = float_(LIPSCHITZ_WORD);
    return _e1;
}

float nearfield_error()
{
    const uint _e1 = word(SAMPLE_COUNT_WORD);
    if ((_e1 == 0u)) {
        return 0.0;
    }
    const float _e6 = float_(UNIFORM_MAX_WORD);
    const float _e8 = float_(BAND_MAX_WORD);
    return max(_e6, _e8);
}

float reciprocal_sqrt(float x)
{
    float seed = (2.8898656 - (x * (4.8495784 - (x * (4.646499 - (x * 1.6896812))))));
    float half_1 = (0.5 * x);
    float coarse = (seed * (1.5 - (half_1 * (seed * seed))));
    return (coarse + (coarse * (0.5 - (half_1 * (coarse * coarse)))));
}

float finite(float number_1)
{
    return asfloat(min(asint(number_1), int(2139095039)));
}

Answer ConstructAnswer(float arg0, float3 arg1) {
    Answer ret = (Answer)0;
    ret.distance_ = arg0;
    ret.gradient = arg1;
    return ret;
}

Answer length_and_direction(float3 vector_)
{
    float largest = max(max(abs(vector_.x), abs(vector_.y)), abs(vector_.z));
    float3 scaled = (vector_ / (largest).xxx);
    float taxicab = ((abs(scaled.x) + abs(scaled.y)) + abs(scaled.z));
    float3 place_2 = (scaled / (taxicab).xxx);
    float squared = (((place_2.x * place_2.x) + (place_2.y * place_2.y)) + (place_2.z * place_2.z));
    const float _e32 = reciprocal_sqrt(squared);
    const float _e36 = finite(((taxicab * (squared * _e32)) * largest));
    const Answer answer_4 = ConstructAnswer(_e36, (place_2 * _e32));
    return answer_4;
}

Answer answer_without_end(uint3 bits_1, float3 point_)
{
    if (any((bits_1 > (2139095040u).xxx))) {
        float nan = asfloat(max(max(bits_1.x, bits_1.y), bits_1.z));
        const Answer answer_5 = ConstructAnswer(nan, (nan).xxx);
        return answer_5;
    }
    uint3 signs = (asuint(point_) & (2147483648u).xxx);
    float3 ones = asfloat((signs | (1065353216u).xxx));
    float3 toward = ((bits_1 == (2139095040u).xxx) ? ones : (0.0).xxx);
    const Answer _e34 = length_and_direction(toward);
    const Answer answer_6 = ConstructAnswer(asfloat(max(max(bits_1.x, bits_1.y), bits_1.z)), _e34.gradient);
    return answer_6;
}

float4 factors_of(Field field_1)
{
    if ((field_1.reconstruction != RECONSTRUCTION_HALF)) {
        return (1.0).xxxx;
    }
    switch(field_1.order) {
        case 1u: {
            return float4(1.0, 0.5, 0.0, 0.0);
        }
        case 2u: {
            return float4(1.0, 0.6666667, 0.33333334, 0.0);
        }
        default: {
            return float4(1.0, 0.75, 0.5, 0.25);
        }
    }
}

uint coefficients_of(Field field_2)
{
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

float decode_half(uint bits_2)
{
    uint sign_1 = ((bits_2 & 32768u) << 16u);
    uint exponent_1 = ((bits_2 >> 10u) & 31u);
    uint fraction = (bits_2 & 1023u);
    if ((exponent_1 == 0u)) {
        return asfloat((sign_1 | asuint((float(fraction) * SUBNORMAL_STEP))));
    }
    return asfloat((sign_1 | ((exponent_1 == 31u) ? 0u : (((exponent_1 + 112u) << 23u) | (fraction << 13u)))));
}

float decode_float(uint bits_3)
{
    return (((bits_3 & 2147483647u) <= MAX_MAGNITUDE_BITS) ? asfloat(bits_3) : 0.0);
}

float copy_sign(float magnitude, float sign_)
{
    return asfloat((asuint(abs(magnitude)) | (asuint(sign_) & 2147483648u)));
}

float3 decode_gradient(uint code)
{
    int2 codes_1 = asint(asuint(int2(uint2((code & GRADIENT_MASK), ((code >> GRADIENT_BITS) & GRADIENT_MASK)))) - asuint((int(511)).xx));
    float2 flat = (float2(codes_1) * GRADIENT_STEP);
    float z_2 = ((1.0 - abs(flat.x)) - abs(flat.y));
    float fold = max(-(z_2), 0.0);
    const float _e27 = copy_sign(fold, flat.x);
    float x_3 = (flat.x - _e27);
    const float _e31 = copy_sign(fold, flat.y);
    float y_2 = (flat.y - _e31);
    const float _e39 = reciprocal_sqrt((((x_3 * x_3) + (y_2 * y_2)) + (z_2 * z_2)));
    return (float3(x_3, y_2, z_2) * _e39);
}

float decode_distance(int base, uint code_1, float quantum)
{
    return (float(asint(asuint(base) + asuint(int(code_1)))) * quantum);
}

uint3 naga_div(uint3 lhs, uint3 rhs) {
    return lhs / (rhs == 0u ? 1u : rhs);
}

int base_of(Field field_3, uint3 vertex)
{
    uint brick = 0u;

    if ((field_3.range == RANGE_BRICK)) {
        uint3 bricks = naga_div((field_3.counts + (3u).xxx), (4u).xxx);
        uint3 at_1 = naga_div(vertex, (4u).xxx);
        brick = (at_1.x + (bricks.x * (at_1.y + (bricks.y * at_1.z))));
    }
    uint _e27 = brick;
    const uint _e29 = word((field_3.nodes + _e27));
    return asint(_e29);
}

Polynomial read_polynomial(Field field_4, uint3 vertex_1)
{
    bool local_1 = (bool)0;
    float stored[20] = (float[20])0;
    uint first = 0u;
    uint half_ = 0u;
    Polynomial sample_ = (Polynomial)0;

    uint number_3 = (vertex_1.x + (field_4.counts.x * (vertex_1.y + (field_4.counts.y * vertex_1.z))));
    const uint _e13 = coefficients_of(field_4);
    bool is_float = (field_4.sample_precision == PRECISION_F32_);
    if ((field_4.sample_precision == PRECISION_PACKED32_)) {
        local_1 = (field_4.order > 0u);
    } else {
        local_1 = false;
    }
    bool is_packed = local_1;
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
            uint place_3 = ((number_3 * (_e13 - skipped)) + _e40);
            const uint _e47 = word((field_4.samples + (is_float ? place_3 : naga_div(place_3, 2u))));
            uint bits_6 = (_e47 >> (is_float ? 0u : (16u * (place_3 & 1u))));
            uint _e55 = half_;
            if ((_e55 == 0u)) {
                first = bits_6;
            }
            uint _e58 = half_;
            const float _e61 = decode_half(bits_6);
            stored[min(uint((_e58 + skipped)), 19u)] = _e61;
            if (is_float) {
                uint _e62 = half_;
                const float _e64 = decode_float(bits_6);
                stored[min(uint(_e62), 19u)] = _e64;
            }
        }
    }
    if (is_packed) {
        uint _e68 = first;
        const float3 _e69 = decode_gradient(_e68);
        stored[1] = _e69.x;
        stored[2] = _e69.y;
        stored[3] = _e69.z;
    }
    if (!(is_float)) {
        uint _e77 = first;
        uint _e80 = first;
        uint code_2 = (is_packed ? (_e80 >> DISTANCE_SHIFT) : (_e77 & 65535u));
        const int _e85 = base_of(field_4, vertex_1);
        const float _e87 = decode_distance(_e85, code_2, field_4.quantum);
        stored[0] = _e87;
    }
    float _e91 = stored[0];
    sample_.constant = _e91;
    float _e94 = stored[1];
    float _e96 = stored[2];
    float _e98 = stored[3];
    sample_.first = float3(_e94, _e96, _e98);
    float _e102 = stored[4];
    float _e104 = stored[5];
    float _e106 = stored[6];
    sample_.square = float3(_e102, _e104, _e106);
    float _e110 = stored[7];
    float _e112 = stored[8];
    float _e114 = stored[9];
    sample_.cross_ = float3(_e110, _e112, _e114);
    float _e118 = stored[10];
    float _e120 = stored[11];
    float _e122 = stored[12];
    sample_.cube = float3(_e118, _e120, _e122);
    float _e126 = stored[13];
    float _e128 = stored[14];
    float _e130 = stored[15];
    sample_.mixed = float3(_e126, _e128, _e130);
    float _e134 = stored[16];
    float _e136 = stored[17];
    float _e138 = stored[18];
    sample_.more = float3(_e134, _e136, _e138);
    float _e142 = stored[19];
    sample_.xyz = _e142;
    float3 s = field_4.spacing;
    float3 r = (s / (max(max(s.x, s.y), s.z)).xxx);
    float3 _e152 = sample_.first;
    sample_.first = (_e152 * s);
    float3 _e155 = sample_.square;
    sample_.square = (_e155 * (s * r));
    float3 _e159 = sample_.cross_;
    sample_.cross_ = (_e159 * (s.xxy * r.yzz));
    float3 _e165 = sample_.cube;
    sample_.cube = (_e165 * ((s * r) * r));
    float3 _e170 = sample_.mixed;
    sample_.mixed = (_e170 * ((s.xxx * r.xxy) * r.yzy));
    float3 _e178 = sample_.more;
    sample_.more = (_e178 * ((s.xyy * r.zyz) * r.zzz));
    float _e186 = sample_.xyz;
    sample_.xyz = (_e186 * ((s.x * r.y) * r.z));
    Polynomial _e193 = sample_;
    const Polynomial polynomial = _e193;
    return polynomial;
}

Answer polynomial_at(Polynomial p, float3 at, float4 factors)
{
    float x_4 = at.x;
    float y_3 = at.y;
    float z_3 = at.z;
    float first_1 = (((p.first.x * x_4) + (p.first.y * y_3)) + (p.first.z * z_3));
    float second = ((((((p.square.x * x_4) + (p.cross_.x * y_3)) + (p.cross_.y * z_3)) * x_4) + (((p.square.y * y_3) + (p.cross_.z * z_3)) * y_3)) + (p.square.z * (z_3 * z_3)));
    float third = (((((((((p.cube.x * x_4) + (p.mixed.x * y_3)) + (p.mixed.y * z_3)) * x_4) + (((p.mixed.z * y_3) + (p.xyz * z_3)) * y_3)) + (p.more.x * (z_3 * z_3))) * x_4) + (((((p.cube.y * y_3) + (p.more.y * z_3)) * y_3) + (p.more.z * (z_3 * z_3))) * y_3)) + (p.cube.z * ((z_3 * z_3) * z_3)));
    float value_1 = ((((p.constant * factors.x) + (first_1 * factors.y)) + (second * factors.z)) + (third * factors.w));
    float by_x = (((p.first.x * factors.y) + (((((2.0 * p.square.x) * x_4) + (p.cross_.x * y_3)) + (p.cross_.y * z_3)) * factors.z)) + (((((((3.0 * p.cube.x) * x_4) + (2.0 * ((p.mixed.x * y_3) + (p.mixed.y * z_3)))) * x_4) + (((p.mixed.z * y_3) + (p.xyz * z_3)) * y_3)) + (p.more.x * (z_3 * z_3))) * factors.w));
    float by_y = (((p.first.y * factors.y) + (((((2.0 * p.square.y) * y_3) + (p.cross_.x * x_4)) + (p.cross_.z * z_3)) * factors.z)) + (((((((3.0 * p.cube.y) * y_3) + (2.0 * ((p.mixed.z * x_4) + (p.more.y * z_3)))) * y_3) + (((p.mixed.x * x_4) + (p.xyz * z_3)) * x_4)) + (p.more.z * (z_3 * z_3))) * factors.w));
    float by_z = (((p.first.z * factors.y) + (((((2.0 * p.square.z) * z_3) + (p.cross_.y * x_4)) + (p.cross_.z * y_3)) * factors.z)) + (((((((3.0 * p.cube.z) * z_3) + (2.0 * ((p.more.x * x_4) + (p.more.z * y_3)))) * z_3) + (((p.mixed.y * x_4) + (p.xyz * y_3)) * x_4)) + (p.more.y * (y_3 * y_3))) * factors.w));
    const Answer answer_7 = ConstructAnswer(value_1, float3(by_x, by_y, by_z));
    return answer_7;
}

float3 quintic(float t, uint end)
{
    float rest = (1.0 - t);
    float cube = ((t * t) * t);
    float rest_cube = ((rest * rest) * rest);
    float far_1 = (cube * (10.0 - (t * (15.0 - (6.0 * t)))));
    float3 near_weights = float3((1.0 - far_1), ((t * rest_cube) * (1.0 + (3.0 * t))), ((t * t) * rest_cube));
    float3 far_weights = float3(far_1, ((-(cube) * rest) * (4.0 - (3.0 * t))), (cube * (rest * rest)));
    return (((end == 1u)).xxx ? far_weights : near_weights);
}

float quintic_product(Polynomial p_1, float3 x_1, float3 y, float3 z)
{
    return (((((((((p_1.constant * x_1.x) + (p_1.first.x * x_1.y)) + (p_1.square.x * x_1.z)) * y.x) + (((p_1.first.y * x_1.x) + (p_1.cross_.x * x_1.y)) * y.y)) + ((p_1.square.y * x_1.x) * y.z)) * z.x) + (((((p_1.first.z * x_1.x) + (p_1.cross_.y * x_1.y)) * y.x) + ((p_1.cross_.z * x_1.x) * y.y)) * z.y)) + (((p_1.square.z * x_1.x) * y.x) * z.z));
}

float3 quintic_slope(float t_1, uint end_1)
{
    float rest_1 = (1.0 - t_1);
    float square_1 = (t_1 * t_1);
    float rest_square = (rest_1 * rest_1);
    float far_2 = ((30.0 * square_1) * rest_square);
    float3 near_weights_1 = float3(-(far_2), (rest_square * (1.0 + (t_1 * (2.0 - (15.0 * t_1))))), ((t_1 * rest_square) * (2.0 - (5.0 * t_1))));
    float3 far_weights_1 = float3(far_2, (square_1 * ((t_1 * (28.0 - (15.0 * t_1))) - 12.0)), ((square_1 * rest_1) * (3.0 - (5.0 * t_1))));
    return (((end_1 == 1u)).xxx ? far_weights_1 : near_weights_1);
}

Answer quintic_part(Polynomial sample_1, float3 local_2, uint3 end_2)
{
    const float3 _e5 = quintic(local_2.x, end_2.x);
    const float3 _e8 = quintic(local_2.y, end_2.y);
    const float3 _e11 = quintic(local_2.z, end_2.z);
    const float3 _e14 = quintic_slope(local_2.x, end_2.x);
    const float _e15 = quintic_product(sample_1, _e14, _e8, _e11);
    const float3 _e18 = quintic_slope(local_2.y, end_2.y);
    const float _e19 = quintic_product(sample_1, _e5, _e18, _e11);
    const float3 _e22 = quintic_slope(local_2.z, end_2.z);
    const float _e23 = quintic_product(sample_1, _e5, _e8, _e22);
    const float _e24 = quintic_product(sample_1, _e5, _e8, _e11);
    const Answer answer_8 = ConstructAnswer(_e24, float3(_e15, _e19, _e23));
    return answer_8;
}

float4 weights_of(Field field_5, float t_2)
{
    float end_3 = (float)0;
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
                    float square_2 = (t_2 * t_2);
                    float cube_1 = (((t_2 * rest_2) * (t_2 * rest_2)) * (t_2 * rest_2));
                    end_3 = ((square_2 * square_2) * (35.0 - (t_2 * (84.0 - (t_2 * (70.0 - (20.0 * t_2)))))));
                    slope = (140.0 * cube_1);
                }
            }
        }
    }
    float _e72 = end_3;
    float _e75 = end_3;
    float _e76 = slope;
    float _e78 = slope;
    return float4((1.0 - _e72), _e75, -(_e76), _e78);
}

float4 weighted_sum(Corners corners, float2 x_2, float2 y_1, float2 z_1)
{
    float4 a = ((corners.at[0] * x_2.x) + (corners.at[4] * x_2.y));
    float4 b = ((corners.at[1] * x_2.x) + (corners.at[5] * x_2.y));
    float4 c = ((corners.at[2] * x_2.x) + (corners.at[6] * x_2.y));
    float4 d = ((corners.at[3] * x_2.x) + (corners.at[7] * x_2.y));
    return ((((a * y_1.x) + (c * y_1.y)) * z_1.x) + (((b * y_1.x) + (d * y_1.y)) * z_1.y));
}

Answer weighted_answer(Field field_6, Corners corners_1, float3 local_3)
{
    const float4 _e4 = weights_of(field_6, local_3.x);
    const float4 _e6 = weights_of(field_6, local_3.y);
    const float4 _e8 = weights_of(field_6, local_3.z);
    const float4 _e12 = weighted_sum(corners_1, _e4.xy, _e6.xy, _e8.xy);
    const float4 _e16 = weighted_sum(corners_1, _e4.zw, _e6.xy, _e8.xy);
    float by_x_1 = _e16.w;
    const float4 _e21 = weighted_sum(corners_1, _e4.xy, _e6.zw, _e8.xy);
    float by_y_1 = _e21.w;
    const float4 _e26 = weighted_sum(corners_1, _e4.xy, _e6.xy, _e8.zw);
    float by_z_1 = _e26.w;
    const Answer answer_9 = ConstructAnswer(_e12.w, (float3(by_x_1, by_y_1, by_z_1) + _e12.xyz));
    return answer_9;
}

Face at_x(inout Jets jets, float4 weights)
{
    Face face = (Face)0;
    int edge = int(0);

    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            int _e37 = edge;
            edge = asint(asuint(_e37) + asuint(int(1)));
        }
        loop_init_2 = false;
        int _e5 = edge;
        if ((_e5 < int(4))) {
        } else {
            break;
        }
        {
            int _e9 = edge;
            Jet near_1 = jets.corners[min(uint(_e9), 7u)];
            int _e13 = edge;
            Jet far_3 = jets.corners[min(uint(asint(asuint(_e13) + asuint(int(4)))), 7u)];
            int _e19 = edge;
            face.corners[min(uint(_e19), 3u)] = (((near_1.plain * weights.x) + (far_3.plain * weights.y)) + ((near_1.by_x * weights.z) + (far_3.by_x * weights.w)));
        }
    }
    Face _e39 = face;
    const Face face_2 = _e39;
    return face_2;
}

float4 cubic(float t_3)
{
    float rest_3 = (1.0 - t_3);
    float end_4 = ((t_3 * t_3) * (3.0 - (2.0 * t_3)));
    return float4((1.0 - end_4), end_4, (t_3 * (rest_3 * rest_3)), (-((t_3 * t_3)) * rest_3));
}

float4 at_y(Face face_1, float4 weights_1)
{
    float4 near_y = float4(face_1.corners[0].xy, face_1.corners[1].xy);
    float4 far_y = float4(face_1.corners[2].xy, face_1.corners[3].xy);
    float4 near_y_slope = float4(face_1.corners[0].zw, face_1.corners[1].zw);
    float4 far_y_slope = float4(face_1.corners[2].zw, face_1.corners[3].zw);
    return (((near_y * weights_1.x) + (far_y * weights_1.y)) + ((near_y_slope * weights_1.z) + (far_y_slope * weights_1.w)));
}

float at_z(float4 edge_1, float4 weights_2)
{
    return (((edge_1.x * weights_2.x) + (edge_1.z * weights_2.y)) + ((edge_1.y * weights_2.z) + (edge_1.w * weights_2.w)));
}

float4 cubic_slope(float t_4)
{
    float end_5 = ((6.0 * t_4) * (1.0 - t_4));
    return float4(-(end_5), end_5, ((1.0 - t_4) * (1.0 - (3.0 * t_4))), (t_4 * ((3.0 * t_4) - 2.0)));
}

Answer tricubic(inout Jets jets_1, float3 local_4)
{
    const float4 _e3 = cubic(local_4.x);
    const Face _e4 = at_x(jets_1, _e3);
    const float4 _e6 = cubic(local_4.y);
    const float4 _e8 = cubic(local_4.z);
    const float4 _e9 = at_y(_e4, _e6);
    const float4 _e11 = cubic_slope(local_4.x);
    const Face _e12 = at_x(jets_1, _e11);
    const float4 _e13 = at_y(_e12, _e6);
    const float _e14 = at_z(_e13, _e8);
    const float4 _e16 = cubic_slope(local_4.y);
    const float4 _e17 = at_y(_e4, _e16);
    const float _e18 = at_z(_e17, _e8);
    const float4 _e20 = cubic_slope(local_4.z);
    const float _e21 = at_z(_e9, _e20);
    const float _e22 = at_z(_e9, _e8);
    const Answer answer_10 = ConstructAnswer(_e22, float3(_e14, _e18, _e21));
    return answer_10;
}

Jet ConstructJet(float4 arg0, float4 arg1) {
    Jet ret = (Jet)0;
    ret.plain = arg0;
    ret.by_x = arg1;
    return ret;
}

uint3 naga_f2u32(float3 value) {
    return uint3(clamp(value, 0.0, 4294967000.0));
}

Answer evaluate_grid(Field field_7, float3 position)
{
    Corners weighted = (Corners)0;
    Jets jets_2 = (Jets)0;
    Answer quintics = ConstructAnswer(0.0, (0.0).xxx);
    uint corner = 0u;
    Answer answer = (Answer)0;

    uint3 cell_4 = min(naga_f2u32(position), (field_7.cells - (1u).xxx));
    float3 local_24 = (position - float3(cell_4));
    bool is_hermite = (field_7.reconstruction == RECONSTRUCTION_HERMITE);
    const float4 _e13 = factors_of(field_7);
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
            uint3 end_6 = uint3((_e26 >> 2u), ((_e29 >> 1u) & 1u), (_e34 & 1u));
            const Polynomial _e39 = read_polynomial(field_7, (cell_4 + end_6));
            if (!(is_hermite)) {
                const Answer _e43 = polynomial_at(_e39, (local_24 - float3(end_6)), _e13);
                uint _e45 = corner;
                weighted.at[min(uint(_e45), 7u)] = float4(_e43.gradient, _e43.distance_);
            } else {
                if ((field_7.order == 1u)) {
                    float4 plain = float4(_e39.constant, _e39.first.z, _e39.first.y, 0.0);
                    uint _e61 = corner;
                    jets_2.corners[min(uint(_e61), 7u)] = ConstructJet(plain, float4(_e39.first.x, 0.0, 0.0, 0.0));
                } else {
                    const Answer _e70 = quintic_part(_e39, local_24, end_6);
                    float _e72 = quintics.distance_;
                    float3 _e76 = quintics.gradient;
                    quintics = ConstructAnswer((_e72 + _e70.distance_), (_e76 + _e70.gradient));
                }
            }
        }
    }
    Answer _e83 = quintics;
    answer = _e83;
    if (!(is_hermite)) {
        Corners _e86 = weighted;
        const Answer _e87 = weighted_answer(field_7, _e86, local_24);
        answer = _e87;
    } else {
        if ((field_7.order == 1u)) {
            const Answer _e91 = tricubic(jets_2, local_24);
            answer = _e91;
        }
    }
    float3 _e93 = answer.gradient;
    answer.gradient = (_e93 * field_7.cells_per_unit);
    Answer _e96 = answer;
    const Answer answer_11 = _e96;
    return answer_11;
}

uint root_of(Field field_8, uint3 cell)
{
    uint3 root = (cell >> (field_8.depth).xxx);
    return (root.x + (field_8.counts.x * (root.y + (field_8.counts.y * root.z))));
}

uint octant_of(uint3 cell_1, uint shift)
{
    uint3 half_2 = ((cell_1 >> (shift).xxx) & (1u).xxx);
    return ((half_2.x | (half_2.y << 1u)) | (half_2.z << 2u));
}

float power_of_half(uint exponent)
{
    return asfloat(((127u - min(exponent, 126u)) << 23u));
}

uint count_bits(uint bits_4)
{
    uint pairs = (bits_4 - ((bits_4 >> 1u) & 1431655765u));
    uint nibbles = ((pairs & 858993459u) + ((pairs >> 2u) & 858993459u));
    return ((((nibbles + (nibbles >> 4u)) & 252645135u) * 16843009u) >> 24u);
}

float2 decode_halves(uint bits_5)
{
    const float _e1 = decode_half(bits_5);
    const float _e4 = decode_half((bits_5 >> 16u));
    return float2(_e1, _e4);
}

Jet read_jet(uint interpolant, Block block, uint source)
{
    uint place = (uint)0;
    uint count = (uint)0;
    uint words[8] = (uint[8])0;
    uint index_3 = 0u;
    float distance_ = (float)0;
    float3 gradient = (0.0).xxx;
    float4 mixed = (0.0).xxxx;
    bool local_5 = (bool)0;
    bool local_6 = (bool)0;

    uint before = (source - 1u);
    const uint _e7 = count_bits((block.present & before));
    const uint _e10 = count_bits((block.full & before));
    bool is_full = ((block.full & source) != 0u);
    bool is_float_1 = (block.sample_precision == PRECISION_F32_);
    bool is_trilinear = (interpolant != INTERPOLANT_TRICUBIC);
    uint stride = (is_float_1 ? 4u : ((block.sample_precision == PRECISION_F16_) ? 2u : 1u));
    uint full_stride = (is_float_1 ? 8u : 4u);
    place = ((_e7 * stride) + (_e10 * (full_stride - stride)));
    count = (is_full ? full_stride : stride);
    if (is_trilinear) {
        place = (is_float_1 ? _e7 : naga_div(_e7, 2u));
        count = 1u;
    }
    bool loop_init_4 = true;
    while(true) {
        if (!loop_init_4) {
            uint _e57 = index_3;
            index_3 = (_e57 + 1u);
        }
        loop_init_4 = false;
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
            const uint _e55 = word(((block.first + _e51) + _e53));
            words[min(uint(_e48), 7u)] = _e55;
        }
    }
    if (is_float_1) {
        uint _e67 = words[0];
        const float _e68 = decode_float(_e67);
        distance_ = _e68;
        uint _e70 = words[1];
        const float _e71 = decode_float(_e70);
        uint _e73 = words[2];
        const float _e74 = decode_float(_e73);
        uint _e76 = words[3];
        const float _e77 = decode_float(_e76);
        gradient = float3(_e71, _e74, _e77);
        uint _e80 = words[4];
        const float _e81 = decode_float(_e80);
        uint _e83 = words[5];
        const float _e84 = decode_float(_e83);
        uint _e86 = words[6];
        const float _e87 = decode_float(_e86);
        uint _e89 = words[7];
        const float _e90 = decode_float(_e89);
        mixed = float4(_e81, _e84, _e87, _e90);
    } else {
        if ((block.sample_precision == PRECISION_PACKED32_)) {
            local_5 = !(is_full);
        } else {
            local_5 = false;
        }
        bool _e99 = local_5;
        if (_e99) {
            local_6 = !(is_trilinear);
        } else {
            local_6 = false;
        }
        bool _e104 = local_6;
        if (_e104) {
            uint _e107 = words[0];
            const float _e111 = decode_distance(block.base, (_e107 >> DISTANCE_SHIFT), block.quantum);
            distance_ = _e111;
            uint _e113 = words[0];
            const float3 _e114 = decode_gradient(_e113);
            gradient = _e114;
        } else {
            uint _e116 = words[0];
            uint half_3 = (_e116 >> (is_trilinear ? (16u * (_e7 & 1u)) : 0u));
            const float _e132 = decode_distance(asint(asuint(int(16)) * asuint(block.base)), (half_3 & 65535u), (block.quantum * 0.0625));
            distance_ = _e132;
            uint _e134 = words[0];
            const float _e137 = decode_half((_e134 >> 16u));
            uint _e139 = words[1];
            const float2 _e140 = decode_halves(_e139);
            gradient = float3(_e137, _e140);
            uint _e143 = words[2];
            const float2 _e144 = decode_halves(_e143);
            uint _e146 = words[3];
            const float2 _e147 = decode_halves(_e146);
            mixed = float4(_e144, _e147);
        }
    }
    if (is_trilinear) {
        float _e149 = distance_;
        const Jet jet = ConstructJet(float4(_e149, 0.0, 0.0, 0.0), (0.0).xxxx);
        return jet;
    }
    float3 _e157 = gradient;
    gradient = (_e157 * block.edge);
    float4 _e160 = mixed;
    mixed = (_e160 * block.edge);
    float _e163 = distance_;
    float _e165 = gradient.z;
    float _e167 = gradient.y;
    float _e169 = mixed.z;
    float _e172 = gradient.x;
    float _e174 = mixed.y;
    float _e176 = mixed.x;
    float _e178 = mixed.w;
    const Jet jet_1 = ConstructJet(float4(_e163, _e165, _e167, _e169), float4(_e172, _e174, _e176, _e178));
    return jet_1;
}

Jet middle(Jet near, Jet far, uint axis)
{
    Jet sum = ConstructJet((near.plain + far.plain), (near.by_x + far.by_x));
    Jet change_1 = ConstructJet((near.plain - far.plain), (near.by_x - far.by_x));
    if ((axis == 0u)) {
        const Jet jet_2 = ConstructJet(((0.5 * sum.plain) + (0.25 * change_1.by_x)), ((-0.25 * sum.by_x) + (-0.75 * change_1.plain)));
        return jet_2;
    }
    if ((axis == 1u)) {
        float4 by_sum = float4(0.5, 0.5, -0.25, -0.25);
        float4 by_change = float4(0.25, 0.25, -0.75, -0.75);
        const Jet jet_3 = ConstructJet(((by_sum * sum.plain) + (by_change * change_1.plain.zwxy)), ((by_sum * sum.by_x) + (by_change * change_1.by_x.zwxy)));
        return jet_3;
    }
    float4 by_sum_1 = float4(0.5, -0.25, 0.5, -0.25);
    float4 by_change_1 = float4(0.25, -0.75, 0.25, -0.75);
    const Jet jet_4 = ConstructJet(((by_sum_1 * sum.plain) + (by_change_1 * change_1.plain.yxwz)), ((by_sum_1 * sum.by_x) + (by_change_1 * change_1.by_x.yxwz)));
    return jet_4;
}

void settle(inout Jets jets_3, uint implied, uint octant, uint axis_1)
{
    uint corner_1 = 0u;
    bool local_7 = (bool)0;

    uint bit_4 = (4u >> axis_1);
    uint end_7 = ((((octant >> axis_1) & 1u) == 1u) ? 0u : bit_4);
    bool loop_init_5 = true;
    while(true) {
        if (!loop_init_5) {
            uint _e47 = corner_1;
            corner_1 = (_e47 + 1u);
        }
        loop_init_5 = false;
        uint _e15 = corner_1;
        if ((_e15 < 8u)) {
        } else {
            break;
        }
        {
            uint _e18 = corner_1;
            if (((_e18 & bit_4) == end_7)) {
                uint _e23 = corner_1;
                local_7 = (((implied >> _e23) & 1u) == 1u);
            } else {
                local_7 = false;
            }
            bool _e30 = local_7;
            if (_e30) {
                uint _e32 = corner_1;
                Jet near_2 = jets_3.corners[min(uint((_e32 & ~(bit_4))), 7u)];
                uint _e38 = corner_1;
                Jet far_4 = jets_3.corners[min(uint((_e38 | bit_4)), 7u)];
                uint _e43 = corner_1;
                const Jet _e45 = middle(near_2, far_4, axis_1);
                jets_3.corners[min(uint(_e43), 7u)] = _e45;
            }
        }
    }
    return;
}

Jets read_corners(uint interpolant_1, Block block_1, uint octant_1)
{
    Jets jets_4 = (Jets)0;
    uint implied_1 = 0u;
    uint corner_2 = 0u;
    uint source_1 = (uint)0;

    bool loop_init_6 = true;
    while(true) {
        if (!loop_init_6) {
            uint _e74 = corner_2;
            corner_2 = (_e74 + 1u);
        }
        loop_init_6 = false;
        uint _e8 = corner_2;
        if ((_e8 < 8u)) {
        } else {
            break;
        }
        {
            uint _e11 = corner_2;
            uint _e14 = corner_2;
            uint _e19 = corner_2;
            uint3 along = uint3((_e11 >> 2u), ((_e14 >> 1u) & 1u), (_e19 & 1u));
            uint3 at_2 = (along + uint3((octant_1 & 1u), ((octant_1 >> 1u) & 1u), (octant_1 >> 2u)));
            source_1 = (1u << ((at_2.x + (3u * at_2.y)) + (9u * at_2.z)));
            uint _e46 = source_1;
            if (((block_1.present & _e46) == 0u)) {
                uint _e50 = implied_1;
                uint _e52 = corner_2;
                implied_1 = (_e50 | (1u << _e52));
                source_1 = (1u << (((2u * along.x) + (6u * along.y)) + (18u * along.z)));
            }
            uint _e69 = corner_2;
            uint _e71 = source_1;
            const Jet _e72 = read_jet(interpolant_1, block_1, _e71);
            jets_4.corners[min(uint(_e69), 7u)] = _e72;
        }
    }
    uint _e76 = implied_1;
    if ((_e76 != 0u)) {
        uint _e79 = implied_1;
        settle(jets_4, _e79, octant_1, 0u);
        uint _e81 = implied_1;
        settle(jets_4, _e81, octant_1, 1u);
        uint _e83 = implied_1;
        settle(jets_4, _e83, octant_1, 2u);
    }
    Jets _e85 = jets_4;
    const Jets jets_7 = _e85;
    return jets_7;
}

Answer trilinear(Jets jets_5, float3 local_8)
{
    Corners corners_2 = (Corners)0;
    int corner_3 = int(0);

    bool loop_init_7 = true;
    while(true) {
        if (!loop_init_7) {
            int _e16 = corner_3;
            corner_3 = asint(asuint(_e16) + asuint(int(1)));
        }
        loop_init_7 = false;
        int _e5 = corner_3;
        if ((_e5 < int(8))) {
        } else {
            break;
        }
        {
            int _e9 = corner_3;
            int _e12 = corner_3;
            corners_2.at[min(uint(_e9), 7u)] = jets_5.corners[min(uint(_e12), 7u)].plain;
        }
    }
    float2 x_5 = float2((1.0 - local_8.x), local_8.x);
    float2 y_4 = float2((1.0 - local_8.y), local_8.y);
    float2 z_4 = float2((1.0 - local_8.z), local_8.z);
    float2 slope_3 = float2(-1.0, 1.0);
    Corners _e36 = corners_2;
    const float4 _e37 = weighted_sum(_e36, slope_3, y_4, z_4);
    float by_x_2 = _e37.x;
    Corners _e39 = corners_2;
    const float4 _e40 = weighted_sum(_e39, x_5, slope_3, z_4);
    float by_y_2 = _e40.x;
    Corners _e42 = corners_2;
    const float4 _e43 = weighted_sum(_e42, x_5, y_4, slope_3);
    float by_z_2 = _e43.x;
    Corners _e45 = corners_2;
    const float4 _e46 = weighted_sum(_e45, x_5, y_4, z_4);
    const Answer answer_12 = ConstructAnswer(_e46.x, float3(by_x_2, by_y_2, by_z_2));
    return answer_12;
}

Answer evaluate_octree(Field field_9, float3 position_1)
{
    uint node = (uint)0;
    uint shift_1 = (uint)0;
    uint octant_2 = 0u;
    bool local_9 = (bool)0;
    Block block_2 = (Block)0;
    Jets jets_6 = (Jets)0;
    Answer answer_1 = (Answer)0;

    uint3 cell_5 = min(naga_f2u32(position_1), (field_9.cells - (1u).xxx));
    const uint _e9 = root_of(field_9, cell_5);
    const uint _e11 = word((field_9.nodes + _e9));
    node = _e11;
    shift_1 = field_9.depth;
    while(true) {
        uint _e17 = node;
        if (((_e17 >> NODE_OFFSET_BITS) == NODE_INNER)) {
            uint _e24 = shift_1;
            local_9 = (_e24 > 0u);
        } else {
            local_9 = false;
        }
        bool _e28 = local_9;
        if (_e28) {
        } else {
            break;
        }
        {
            uint _e29 = shift_1;
            shift_1 = (_e29 - 1u);
            uint _e32 = shift_1;
            const uint _e33 = octant_of(cell_5, _e32);
            octant_2 = _e33;
            uint _e35 = node;
            uint _e39 = octant_2;
            const uint _e41 = word(((field_9.nodes + (_e35 & NODE_OFFSET_MASK)) + _e39));
            node = _e41;
        }
    }
    uint _e42 = shift_1;
    uint _e45 = shift_1;
    uint _e50 = shift_1;
    const float _e51 = power_of_half(_e50);
    float3 local_25 = ((position_1 - float3(((cell_5 >> (_e42).xxx) << (_e45).xxx))) * _e51);
    uint _e54 = shift_1;
    uint level = (field_9.depth - _e54);
    uint _e57 = node;
    uint start_2 = (field_9.samples + (_e57 & NODE_OFFSET_MASK));
    const uint _e62 = word(start_2);
    block_2.present = (_e62 & LATTICE_MASK);
    block_2.sample_precision = ((_e62 >> PRECISION_SHIFT) & 3u);
    const uint _e74 = word((start_2 + 1u));
    block_2.full = (_e74 & LATTICE_MASK);
    const uint _e80 = word((start_2 + 2u));
    block_2.base = asint(_e80);
    block_2.first = (start_2 + 3u);
    const float _e87 = power_of_half(level);
    block_2.quantum = (field_9.quantum * _e87);
    const float _e92 = power_of_half(level);
    block_2.edge = (field_9.spacing.x * _e92);
    Block _e95 = block_2;
    uint _e96 = octant_2;
    const Jets _e97 = read_corners(field_9.reconstruction, _e95, _e96);
    jets_6 = _e97;
    if ((field_9.reconstruction == INTERPOLANT_TRICUBIC)) {
        const Answer _e103 = tricubic(jets_6, local_25);
        answer_1 = _e103;
    } else {
        Jets _e104 = jets_6;
        const Answer _e105 = trilinear(_e104, local_25);
        answer_1 = _e105;
    }
    float3 _e107 = answer_1.gradient;
    float _e109 = block_2.edge;
    answer_1.gradient = (_e107 * (1.0 / _e109));
    Answer _e113 = answer_1;
    const Answer answer_13 = _e113;
    return answer_13;
}

uint joined(uint lower, uint upper, uint bit)
{
    return ((lower >> bit) | ((upper << 1u) << (31u - bit)));
}

uint child_node(Field field_10, uint record, uint octant_3)
{
    uint words_1[4] = (uint[4])0;
    uint index_4 = 0u;

    uint start_3 = (field_10.records + naga_div((RECORD_LENGTH * record), 4u));
    uint shift_4 = (8u * ((RECORD_LENGTH * record) & 3u));
    bool loop_init_8 = true;
    while(true) {
        if (!loop_init_8) {
            uint _e27 = index_4;
            index_4 = (_e27 + 1u);
        }
        loop_init_8 = false;
        uint _e18 = index_4;
        if ((_e18 < 4u)) {
        } else {
            break;
        }
        {
            uint _e21 = index_4;
            uint _e23 = index_4;
            const uint _e25 = word((start_3 + _e23));
            words_1[min(uint(_e21), 3u)] = _e25;
        }
    }
    uint _e30 = words_1[0];
    uint _e32 = words_1[1];
    const uint _e33 = joined(_e30, _e32, shift_4);
    uint _e35 = words_1[1];
    uint _e37 = words_1[2];
    const uint _e38 = joined(_e35, _e37, shift_4);
    uint2 inner_and_starts = uint2(_e33, _e38);
    uint _e41 = words_1[2];
    uint _e43 = words_1[3];
    const uint _e44 = joined(_e41, _e43, shift_4);
    uint _e46 = words_1[3];
    uint2 first_2 = uint2(_e44, (_e46 >> shift_4));
    uint own_2 = ((inner_and_starts[min(uint((octant_3 >> 2u)), 1u)] >> (8u * (octant_3 & 3u))) & 255u);
    uint before_1 = ((octant_3 == 0u) ? 0u : own_2);
    if ((((inner_and_starts.x >> octant_3) & 1u) == 1u)) {
        return ((first_2.x & RECORD_CHILD_MASK) + before_1);
    }
    const uint _e76 = joined(first_2.x, first_2.y, RECORD_CHILD_BITS);
    uint leaf_4 = (_e76 & RECORD_LEAF_MASK);
    return (ROOT_LEAF | (leaf_4 + before_1));
}

Leaf ConstructLeaf(uint arg0, uint3 arg1, uint arg2) {
    Leaf ret = (Leaf)0;
    ret.place = arg0;
    ret.cell = arg1;
    ret.shift = arg2;
    return ret;
}

Leaf find_leaf(Field field_11, uint3 cell_2)
{
    uint node_1 = (uint)0;
    uint shift_2 = (uint)0;
    bool local_10 = (bool)0;

    const uint _e3 = root_of(field_11, cell_2);
    const uint _e5 = word((field_11.nodes + _e3));
    node_1 = _e5;
    shift_2 = field_11.depth;
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
            const uint _e26 = octant_of(cell_2, _e25);
            const uint _e27 = child_node(field_11, _e24, _e26);
            node_1 = _e27;
        }
    }
    uint _e28 = node_1;
    uint _e31 = shift_2;
    uint _e34 = shift_2;
    uint _e37 = shift_2;
    const Leaf leaf_5 = ConstructLeaf((_e28 & 2147483647u), ((cell_2 >> (_e31).xxx) << (_e34).xxx), _e37);
    return leaf_5;
}

uint bits_at(uint section, uint bit_1, uint index_5)
{
    uint at_3 = ((section + index_5) + naga_div(bit_1, 32u));
    const uint _e7 = word(at_3);
    const uint _e10 = word((at_3 + 1u));
    const uint _e13 = joined(_e7, _e10, (bit_1 & 31u));
    return _e13;
}

LeafHead ConstructLeafHead(uint arg0, uint arg1, uint arg2, uint arg3) {
    LeafHead ret = (LeafHead)0;
    ret.kind_and_degrees = arg0;
    ret.widths = arg1;
    ret.support = arg2;
    ret.reach = arg3;
    return ret;
}

LeafHead read_head(Field field_12, uint place_1)
{
    const uint _e9 = bits_at(field_12.samples, (8u * (place_1 & 3u)), naga_div(place_1, 4u));
    uint shape = (field_12.shapes + (2u * (_e9 & ((1u << field_12.shape_bits) - 1u))));
    uint codes_2 = (_e9 >> field_12.shape_bits);
    const uint _e22 = word(shape);
    const uint _e25 = word((shape + 1u));
    const LeafHead leafhead = ConstructLeafHead(_e22, _e25, (codes_2 & 3u), ((codes_2 >> SUPPORT_BITS) & 3u));
    return leafhead;
}

float3 local_of(Leaf leaf, float3 position_2)
{
    const float _e6 = power_of_half(leaf.shift);
    return (((position_2 - float3(leaf.cell)) * (2.0 * _e6)) - (1.0).xxx);
}

float4 weight_at(float3 local_11, float steepness)
{
    float3 s_1 = clamp(((0.5).xxx + (((1.0).xxx - abs(local_11)) * steepness)), (0.0).xxx, (1.0).xxx);
    float3 w = ((s_1 * s_1) * ((3.0).xxx - (2.0 * s_1)));
    const float _e24 = copy_sign(steepness, -(local_11.x));
    const float _e27 = copy_sign(steepness, -(local_11.y));
    const float _e30 = copy_sign(steepness, -(local_11.z));
    float3 signs_1 = float3(_e24, _e27, _e30);
    float3 slope_4 = (((6.0 * s_1) * ((1.0).xxx - s_1)) * signs_1);
    return float4((slope_4.x * (w.y * w.z)), (slope_4.y * (w.x * w.z)), (slope_4.z * (w.x * w.y)), ((w.x * w.y) * w.z));
}

Terms read_terms(Field field_13, uint index_6, uint start, uint degree, uint widths)
{
    float codes[20] = (float[20])0;
    uint bit_2 = (uint)0;
    uint number_2 = 0u;
    uint of_degree = 0u;
    Terms terms = (Terms)0;

    bit_2 = start;
    bool loop_init_9 = true;
    while(true) {
        if (!loop_init_9) {
            uint _e56 = of_degree;
            of_degree = (_e56 + 1u);
        }
        loop_init_9 = false;
        uint _e11 = of_degree;
        if ((_e11 <= min(degree, 3u))) {
        } else {
            break;
        }
        {
            uint _e15 = of_degree;
            const uint _e16 = byte_of(widths, _e15);
            uint width = (_e16 & 31u);
            uint size = (1u << width);
            uint _e21 = of_degree;
            uint _e24 = of_degree;
            uint _e28 = of_degree;
            uint end_8 = naga_div((((_e21 + 1u) * (_e24 + 2u)) * (_e28 + 3u)), 6u);
            bool loop_init_10 = true;
            while(true) {
                if (!loop_init_10) {
                    uint _e53 = number_2;
                    number_2 = (_e53 + 1u);
                }
                loop_init_10 = false;
                uint _e34 = number_2;
                if ((_e34 < end_8)) {
                } else {
                    break;
                }
                {
                    uint _e37 = bit_2;
                    const uint _e38 = bits_at(field_13.samples, _e37, index_6);
                    uint code_3 = (_e38 & (size - 1u));
                    uint _e42 = number_2;
                    codes[min(uint(_e42), 19u)] = float(asint(asuint(int(code_3)) - asuint(int((size >> 1u)))));
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
    terms.linear_ = float4(_e61, _e63, _e65, _e67);
    float _e71 = codes[4];
    float _e73 = codes[5];
    float _e75 = codes[6];
    terms.square = float4(_e71, _e73, _e75, 0.0);
    float _e80 = codes[7];
    float _e82 = codes[8];
    float _e84 = codes[9];
    terms.cross_ = float4(_e80, _e82, _e84, 0.0);
    float _e89 = codes[10];
    float _e91 = codes[11];
    float _e93 = codes[12];
    float _e95 = codes[19];
    terms.cube = float4(_e89, _e91, _e93, _e95);
    float _e99 = codes[13];
    float _e101 = codes[14];
    float _e103 = codes[15];
    terms.next = float4(_e99, _e101, _e103, 0.0);
    float _e108 = codes[16];
    float _e110 = codes[17];
    float _e112 = codes[18];
    terms.previous = float4(_e108, _e110, _e112, 0.0);
    uint _e116 = bit_2;
    terms.end = _e116;
    Terms _e117 = terms;
    const Terms terms_2 = _e117;
    return terms_2;
}

Answer evaluate_terms(Terms terms_1, uint degree_1, float3 local_12)
{
    float4 value = (float4)0;
    float4 slope_1 = (float4)0;
    float4 square = (float4)0;

    float4 first_3 = float4(local_12, 1.0);
    float4 next = float4(local_12.yzx, 0.0);
    float4 previous = float4(local_12.zxy, 0.0);
    float4 second_1 = float4(((1.5 * (first_3 * first_3)) - (0.5).xxxx).xyz, 0.0);
    float4 third_1 = float4((first_3 * ((2.5 * (first_3 * first_3)) - (1.5).xxxx)).xyz, ((local_12.x * local_12.y) * local_12.z));
    value = (terms_1.linear_ * first_3);
    slope_1 = terms_1.linear_;
    if ((degree_1 >= 2u)) {
        float4 line_ = (terms_1.linear_ + (terms_1.cross_ * next));
        square = terms_1.square;
        if ((degree_1 >= 3u)) {
            float4 _e49 = square;
            square = (_e49 + ((terms_1.next * next) + (terms_1.previous * previous)));
        }
        float4 _e57 = square;
        value = ((line_ * first_3) + (_e57 * second_1));
        float4 _e64 = square;
        slope_1 = ((line_ + (terms_1.cross_.zxyw * previous)) + (_e64 * (3.0 * first_3)));
        if ((degree_1 >= 3u)) {
            float4 _e71 = value;
            value = (_e71 + (terms_1.cube * third_1));
            float4 others = ((terms_1.next * second_1).zxyw + (terms_1.previous * second_1).yzxw);
            float4 _e82 = slope_1;
            slope_1 = ((_e82 + ((terms_1.cube * ((7.5 * (first_3 * first_3)) - (1.5).xxxx)) + others)) + (terms_1.cube.w * (next * previous)));
        }
    }
    float _e99 = value.x;
    float _e101 = value.y;
    float _e104 = value.z;
    float _e106 = value.w;
    float4 _e109 = slope_1;
    const Answer answer_14 = ConstructAnswer(((_e99 + _e101) + (_e104 + _e106)), _e109.xyz);
    return answer_14;
}

float edge_of(Field field_14, Leaf leaf_1)
{
    const float _e7 = power_of_half((field_14.depth - leaf_1.shift));
    return (field_14.spacing.x * _e7);
}

Answer evaluate_leaf(Field field_15, Leaf leaf_2, LeafHead head, float3 local_13)
{
    uint bit_3 = (uint)0;
    Answer answer_2 = ConstructAnswer(0.0, (0.0).xxx);
    uint index_7 = 0u;
    bool local_14 = (bool)0;
    bool local_15 = (bool)0;
    bool local_16 = (bool)0;
    bool local_17 = (bool)0;

    const uint _e6 = byte_of(head.kind_and_degrees, 0u);
    const uint _e9 = byte_of(head.kind_and_degrees, 3u);
    uint exponent_2 = (_e9 & MAX_EXPONENT);
    float step_ = (field_15.quantum * asfloat(((127u + exponent_2) << 23u)));
    bit_3 = (((8u * (leaf_2.place & 3u)) + field_15.shape_bits) + ((field_15.overlap == 0.0) ? 0u : OVERLAP_BITS));
    bool loop_init_11 = true;
    while(true) {
        if (!loop_init_11) {
            uint _e95 = index_7;
            index_7 = (_e95 + 1u);
        }
        loop_init_11 = false;
        uint _e41 = index_7;
        if ((_e41 < ((_e6 == KIND_SINGLE) ? 1u : 2u))) {
        } else {
            break;
        }
        {
            uint _e50 = index_7;
            const uint _e52 = byte_of(head.kind_and_degrees, (1u + _e50));
            uint _e56 = bit_3;
            const Terms _e58 = read_terms(field_15, naga_div(leaf_2.place, 4u), _e56, _e52, head.widths);
            bit_3 = _e58.end;
            const Answer _e60 = evaluate_terms(_e58, _e52, local_13);
            float _e63 = answer_2.distance_;
            bool is_less = (_e60.distance_ < _e63);
            float _e67 = answer_2.distance_;
            bool is_greater = (_e60.distance_ > _e67);
            uint _e69 = index_7;
            if (!((_e69 == 0u))) {
                if ((_e6 == KIND_MIN)) {
                    local_15 = is_less;
                } else {
                    local_15 = false;
                }
                bool _e80 = local_15;
                local_14 = _e80;
            } else {
                local_14 = true;
            }
            bool _e82 = local_14;
            if (!(_e82)) {
                if ((_e6 != KIND_MIN)) {
                    local_17 = is_greater;
                } else {
                    local_17 = false;
                }
                bool _e91 = local_17;
                local_16 = _e91;
            } else {
                local_16 = true;
            }
            bool _e93 = local_16;
            if (_e93) {
                answer_2 = _e60;
            }
        }
    }
    const float _e97 = edge_of(field_15, leaf_2);
    float per_half = (2.0 / _e97);
    float _e101 = answer_2.distance_;
    float3 _e104 = answer_2.gradient;
    const Answer answer_15 = ConstructAnswer((_e101 * step_), ((_e104 * step_) * per_half));
    return answer_15;
}

bool is_shared(Field field_16, LeafHead head_1, float3 local_18)
{
    bool local_19 = (bool)0;

    const float _e4 = power_of_half(head_1.reach);
    float share = ((head_1.reach == 0u) ? 128.0 : (_e4 * 4.0));
    float outermost = max(max(abs(local_18.x), abs(local_18.y)), abs(local_18.z));
    if ((field_16.overlap > 0.0)) {
        local_19 = (outermost > (1.0 - (field_16.overlap * share)));
    } else {
        local_19 = false;
    }
    bool _e31 = local_19;
    return _e31;
}

Region region_around(Field field_17, Leaf own, float3 position_3, uint reach)
{
    Region region = (Region)0;

    const float _e4 = power_of_half(reach);
    float share_1 = ((reach == 0u) ? LEAST_SUPPORT_SHARE : (_e4 * 2.0));
    float margin = ((field_17.overlap * float((1u << own.shift))) * share_1);
    uint3 last = (field_17.cells - (1u).xxx);
    region.low = min(naga_f2u32(max((position_3 - (margin).xxx), (0.0).xxx)), last);
    region.high = min(naga_f2u32((position_3 + (margin).xxx)), last);
    uint3 _e38 = region.low;
    region.root = (_e38 >> (field_17.depth).xxx);
    region.shift = field_17.depth;
    region.finest = (max(own.shift, MAX_LEVELS_APART) - MAX_LEVELS_APART);
    Region _e50 = region;
    const Region region_3 = _e50;
    return region_3;
}

uint children_in(uint3 middle_1, uint3 low, uint3 high)
{
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

uint ZeroValueuint() {
    return (uint)0;
}

uint3 ZeroValueuint3() {
    return (uint3)0;
}

Leaf next_leaf(Field field_18, inout Region region_1, uint own_1)
{
    uint shift_3 = (uint)0;
    bool local_20 = (bool)0;
    uint node_2 = (uint)0;
    uint3 cell_3 = (uint3)0;
    bool local_21 = (bool)0;
    bool local_22 = (bool)0;

    while(true) {
        uint _e4 = region_1.shift;
        shift_3 = _e4;
        while(true) {
            uint _e6 = shift_3;
            if ((_e6 < field_18.depth)) {
                uint _e12 = shift_3;
                uint _e16 = region_1.pending[min(uint((_e12 & 15u)), 15u)];
                local_20 = (_e16 == 0u);
            } else {
                local_20 = false;
            }
            bool _e20 = local_20;
            if (_e20) {
            } else {
                break;
            }
            {
                uint _e21 = shift_3;
                shift_3 = (_e21 + 1u);
            }
        }
        node_2 = ZeroValueuint();
        cell_3 = ZeroValueuint3();
        uint _e28 = shift_3;
        if ((_e28 < field_18.depth)) {
            uint _e32 = shift_3;
            uint children_1 = region_1.pending[min(uint((_e32 & 15u)), 15u)];
            uint _e38 = shift_3;
            region_1.pending[min(uint((_e38 & 15u)), 15u)] = (children_1 & (children_1 - 1u));
            const uint _e51 = count_bits(((children_1 & (~(children_1) + 1u)) - 1u));
            uint3 _e53 = region_1.cell;
            uint _e54 = shift_3;
            uint _e59 = shift_3;
            uint3 parent = ((_e53 >> ((_e54 + 1u)).xxx) << ((_e59 + 1u)).xxx);
            uint _e73 = shift_3;
            cell_3 = (parent + (uint3((_e51 & 1u), ((_e51 >> 1u) & 1u), (_e51 >> 2u)) << (_e73).xxx));
            uint _e78 = shift_3;
            uint _e82 = region_1.records[min(uint((_e78 & 15u)), 15u)];
            const uint _e83 = child_node(field_18, _e82, _e51);
            node_2 = _e83;
        } else {
            uint3 root_1 = region_1.root;
            uint3 _e87 = region_1.low;
            uint3 first_4 = (_e87 >> (field_18.depth).xxx);
            uint3 _e92 = region_1.high;
            uint3 last_1 = (_e92 >> (field_18.depth).xxx);
            if ((root_1.z > last_1.z)) {
                break;
            }
            bool is_last_x = (root_1.x == last_1.x);
            if (is_last_x) {
                local_21 = (root_1.y == last_1.y);
            } else {
                local_21 = false;
            }
            bool is_last_y = local_21;
            region_1.root = uint3((is_last_x ? first_4.x : (root_1.x + 1u)), (is_last_y ? first_4.y : (is_last_x ? (root_1.y + 1u) : root_1.y)), (is_last_y ? (root_1.z + 1u) : root_1.z));
            cell_3 = (root_1 << (field_18.depth).xxx);
            uint3 _e132 = cell_3;
            const uint _e133 = root_of(field_18, _e132);
            const uint _e135 = word((field_18.nodes + _e133));
            node_2 = _e135;
        }
        uint3 _e137 = cell_3;
        region_1.cell = _e137;
        uint _e138 = node_2;
        if (((_e138 & ROOT_LEAF) == 0u)) {
            uint _e145 = shift_3;
            local_22 = (_e145 > 0u);
        } else {
            local_22 = false;
        }
        bool _e149 = local_22;
        if (_e149) {
            uint _e151 = shift_3;
            region_1.shift = _e151;
            uint _e152 = shift_3;
            uint _e154 = region_1.finest;
            if ((_e152 == _e154)) {
                continue;
            }
            uint _e156 = shift_3;
            shift_3 = (_e156 - 1u);
            uint _e160 = shift_3;
            uint _e164 = node_2;
            region_1.records[min(uint((_e160 & 15u)), 15u)] = _e164;
            uint _e166 = shift_3;
            uint3 _e170 = cell_3;
            uint _e172 = shift_3;
            uint3 _e177 = region_1.low;
            uint3 _e179 = region_1.high;
            const uint _e180 = children_in((_e170 + ((1u << _e172)).xxx), _e177, _e179);
            region_1.pending[min(uint((_e166 & 15u)), 15u)] = _e180;
            uint _e182 = shift_3;
            region_1.shift = _e182;
            continue;
        }
        uint _e184 = shift_3;
        region_1.shift = _e184;
        uint _e185 = node_2;
        uint place_4 = (_e185 & 2147483647u);
        if ((place_4 != own_1)) {
            uint3 _e189 = cell_3;
            uint _e190 = shift_3;
            const Leaf leaf_6 = ConstructLeaf(place_4, _e189, _e190);
            return leaf_6;
        }
    }
    const Leaf leaf_7 = ConstructLeaf(own_1, (0u).xxx, 0u);
    return leaf_7;
}

Answer evaluate_polynomial_octree(Field field_19, float3 position_4)
{
    Answer alone = (Answer)0;
    float weight = 0.0;
    float3 weight_slope = (0.0).xxx;
    float change = 0.0;
    float3 slope_2 = (0.0).xxx;
    bool is_alone = true;
    Region region_2 = (Region)0;
    Leaf leaf_3 = (Leaf)0;
    bool local_23 = (bool)0;

    const Leaf _e8 = find_leaf(field_19, min(naga_f2u32(position_4), (field_19.cells - (1u).xxx)));
    float steepness_1 = (0.25 / field_19.overlap);
    leaf_3 = _e8;
    while(true) {
        uint _e28 = leaf_3.place;
        const LeafHead _e29 = read_head(field_19, _e28);
        Leaf _e30 = leaf_3;
        const float3 _e31 = local_of(_e30, position_4);
        uint _e33 = leaf_3.place;
        bool is_own = (_e33 == _e8.place);
        const float4 _e41 = weight_at(_e31, (steepness_1 * float((1u << _e29.support))));
        if (!(is_own)) {
            local_23 = (_e41.w > 0.0);
        } else {
            local_23 = true;
        }
        bool _e49 = local_23;
        if (_e49) {
            Leaf _e50 = leaf_3;
            const Answer _e51 = evaluate_leaf(field_19, _e50, _e29, _e31);
            if (is_own) {
                alone = _e51;
                const bool _e52 = is_shared(field_19, _e29, _e31);
                if (!(_e52)) {
                    const Answer answer_16 = _e51;
                    return answer_16;
                }
                const Region _e55 = region_around(field_19, _e8, position_4, _e29.reach);
                region_2 = _e55;
            } else {
                is_alone = false;
            }
            float _e59 = alone.distance_;
            float difference = (_e51.distance_ - _e59);
            Leaf _e62 = leaf_3;
            const float _e63 = edge_of(field_19, _e62);
            float3 its_slope = (_e41.xyz * (2.0 / _e63));
            float _e67 = weight;
            weight = (_e67 + _e41.w);
            float _e70 = change;
            change = (_e70 + (_e41.w * difference));
            float3 _e74 = weight_slope;
            weight_slope = (_e74 + its_slope);
            float3 _e76 = slope_2;
            slope_2 = (_e76 + ((_e41.w * _e51.gradient) + (its_slope * difference)));
        }
        const Leaf _e84 = next_leaf(field_19, region_2, _e8.place);
        leaf_3 = _e84;
        uint _e86 = leaf_3.place;
        if ((_e86 == _e8.place)) {
            break;
        }
    }
    bool _e89 = is_alone;
    if (_e89) {
        Answer _e90 = alone;
        const Answer answer_17 = _e90;
        return answer_17;
    }
    float _e91 = weight;
    float per_weight = (1.0 / _e91);
    float _e94 = change;
    float mean = (_e94 * per_weight);
    float _e97 = alone.distance_;
    float3 _e99 = slope_2;
    float3 _e100 = weight_slope;
    const Answer answer_18 = ConstructAnswer((_e97 + mean), ((_e99 - (mean * _e100)) * per_weight));
    return answer_18;
}

Answer answer_at(Field field_20, float3 position_5)
{
    switch(field_20.family) {
        case 1u: {
            const Answer _e3 = evaluate_grid(field_20, position_5);
            const Answer answer_19 = _e3;
            return answer_19;
        }
        case 2u: {
            const Answer _e4 = evaluate_octree(field_20, position_5);
            const Answer answer_20 = _e4;
            return answer_20;
        }
        default: {
            const Answer _e5 = evaluate_polynomial_octree(field_20, position_5);
            const Answer answer_21 = _e5;
            return answer_21;
        }
    }
}

Answer answer_inside(Field field_21, float3 point_1)
{
    const Answer _e9 = answer_at(field_21, min(((point_1 - field_21.low) * field_21.cells_per_unit), float3(field_21.cells)));
    const Answer answer_22 = _e9;
    return answer_22;
}

Answer nearfield_evaluate(Field field_22, float3 point_2)
{
    Answer answer_3 = (Answer)0;

    uint3 bits_7 = (asuint(point_2) & (2147483647u).xxx);
    if (any((bits_7 >= (2139095040u).xxx))) {
        const Answer _e10 = answer_without_end(bits_7, point_2);
        const Answer answer_23 = _e10;
        return answer_23;
    }
    float3 nearest = min(max(point_2, field_22.low), field_22.high);
    const Answer _e15 = answer_inside(field_22, nearest);
    answer_3 = _e15;
    if (any((nearest != point_2))) {
        const Answer _e20 = length_and_direction((point_2 - nearest));
        float _e23 = answer_3.distance_;
        const float _e26 = finite((_e23 + _e20.distance_));
        answer_3.distance_ = _e26;
        answer_3.gradient = _e20.gradient;
    }
    Answer _e29 = answer_3;
    const Answer answer_24 = _e29;
    return answer_24;
}

float nearfield_distance(Field field_23, float3 point_3)
{
    const Answer _e2 = nearfield_evaluate(field_23, point_3);
    return _e2.distance_;
}

uint NagaBufferLengthRW(RWByteAddressBuffer buffer)
{
    uint ret;
    buffer.GetDimensions(ret);
    return ret;
}

[numthreads(64, 1, 1)]
void query(uint3 invocation : SV_DispatchThreadID)
{
    bool local = (bool)0;

    uint index_8 = invocation.x;
    if (!((index_8 >= ((NagaBufferLengthRW(answers) - 0) / 16)))) {
        local = (((3u * index_8) + 2u) >= ((NagaBufferLength(points) - 0) / 4));
    } else {
        local = true;
    }
    bool _e16 = local;
    if (_e16) {
        return;
    }
    float _e21 = asfloat(points.Load((3u * index_8)*4));
    float _e28 = asfloat(points.Load(((3u * index_8) + 1u)*4));
    float _e35 = asfloat(points.Load(((3u * index_8) + 2u)*4));
    float3 point_4 = float3(_e21, _e28, _e35);
    const Field _e37 = nearfield_open();
    const Answer _e38 = nearfield_evaluate(_e37, point_4);
    answers.Store4(index_8*16, asuint(float4(_e38.distance_, _e38.gradient)));
    return;
}
