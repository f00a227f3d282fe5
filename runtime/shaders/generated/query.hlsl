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
static const float MAX_FLOAT = 3.4028235e38;
static const uint RECONSTRUCTION_NEAREST = 0u;
static const uint PRECISION_F32_ = 2u;
static const uint PRECISION_PACKED32_ = 0u;
static const uint MAX_MAGNITUDE_BITS = 1568669696u;
static const uint RANGE_BRICK = 1u;
static const uint BRICK_EDGE = 4u;
static const uint DISTANCE_SHIFT = 20u;
static const uint GRADIENT_MASK = 1023u;
static const uint GRADIENT_BITS = 10u;
static const int GRADIENT_CENTRE = int(511);
static const float GRADIENT_STEP = 0.0019569471;
static const float SUBNORMAL_STEP = 5.9604645e-8;
static const uint RECONSTRUCTION_HERMITE = 4u;
static const uint RECONSTRUCTION_BLEND = 3u;
static const uint RECONSTRUCTION_HALF = 2u;
static const uint NODE_OFFSET_BITS = 28u;
static const uint NODE_INNER = 0u;
static const uint NODE_OFFSET_MASK = 268435455u;
static const uint LATTICE_MASK = 134217727u;
static const uint PRECISION_SHIFT = 27u;
static const uint INTERPOLANT_TRICUBIC = 1u;
static const uint PRECISION_F16_ = 1u;
static const uint ROOT_LEAF = 2147483648u;
static const uint RECORD_LENGTH = 14u;
static const uint RECORD_FIRST = 8u;
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

ByteAddressBuffer words : register(t0);
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
    if ((index < ((NagaBufferLength(words) - 0) / 4))) {
        uint _e6 = asuint(words.Load(index*4));
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
    const Field field_26 = _e201;
    return field_26;
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
    float3 place_1 = (scaled / (taxicab).xxx);
    float squared = (((place_1.x * place_1.x) + (place_1.y * place_1.y)) + (place_1.z * place_1.z));
    const float _e32 = reciprocal_sqrt(squared);
    float length_ = min(((taxicab * (squared * _e32)) * largest), MAX_FLOAT);
    const Answer answer_4 = ConstructAnswer(length_, (place_1 * _e32));
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

Answer polynomial_at(Polynomial p, float3 at, float4 factors)
{
    float x_3 = at.x;
    float y_2 = at.y;
    float z_2 = at.z;
    float first_1 = (((p.first.x * x_3) + (p.first.y * y_2)) + (p.first.z * z_2));
    float second = ((((((p.square.x * x_3) + (p.cross_.x * y_2)) + (p.cross_.y * z_2)) * x_3) + (((p.square.y * y_2) + (p.cross_.z * z_2)) * y_2)) + (p.square.z * (z_2 * z_2)));
    float third = (((((((((p.cube.x * x_3) + (p.mixed.x * y_2)) + (p.mixed.y * z_2)) * x_3) + (((p.mixed.z * y_2) + (p.xyz * z_2)) * y_2)) + (p.more.x * (z_2 * z_2))) * x_3) + (((((p.cube.y * y_2) + (p.more.y * z_2)) * y_2) + (p.more.z * (z_2 * z_2))) * y_2)) + (p.cube.z * ((z_2 * z_2) * z_2)));
    float value_1 = ((((p.constant * factors.x) + (first_1 * factors.y)) + (second * factors.z)) + (third * factors.w));
    float by_x = (((p.first.x * factors.y) + (((((2.0 * p.square.x) * x_3) + (p.cross_.x * y_2)) + (p.cross_.y * z_2)) * factors.z)) + (((((((3.0 * p.cube.x) * x_3) + (2.0 * ((p.mixed.x * y_2) + (p.mixed.y * z_2)))) * x_3) + (((p.mixed.z * y_2) + (p.xyz * z_2)) * y_2)) + (p.more.x * (z_2 * z_2))) * factors.w));
    float by_y = (((p.first.y * factors.y) + (((((2.0 * p.square.y) * y_2) + (p.cross_.x * x_3)) + (p.cross_.z * z_2)) * factors.z)) + (((((((3.0 * p.cube.y) * y_2) + (2.0 * ((p.mixed.z * x_3) + (p.more.y * z_2)))) * y_2) + (((p.mixed.x * x_3) + (p.xyz * z_2)) * x_3)) + (p.more.z * (z_2 * z_2))) * factors.w));
    float by_z = (((p.first.z * factors.y) + (((((2.0 * p.square.z) * z_2) + (p.cross_.y * x_3)) + (p.cross_.z * y_2)) * factors.z)) + (((((((3.0 * p.cube.z) * z_2) + (2.0 * ((p.more.x * x_3) + (p.more.z * y_2)))) * z_2) + (((p.mixed.y * x_3) + (p.xyz * y_2)) * x_3)) + (p.more.y * (y_2 * y_2))) * factors.w));
    const Answer answer_7 = ConstructAnswer(value_1, float3(by_x, by_y, by_z));
    return answer_7;
}

uint2 coefficient(Field field_1, uint number_1, uint index_3)
{
    uint count = 1u;
    uint half_ = (uint)0;
    bool local_1 = (bool)0;

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
        return uint2(((field_1.samples + (number_1 * _e13)) + index_3), 0u);
    }
    uint _e19 = count;
    half_ = ((number_1 * _e19) + index_3);
    if ((field_1.sample_precision == PRECISION_PACKED32_)) {
        local_1 = (field_1.order > 0u);
    } else {
        local_1 = false;
    }
    bool _e32 = local_1;
    if (_e32) {
        uint _e33 = count;
        half_ = (((number_1 * (_e33 - 2u)) + max(index_3, 2u)) - 2u);
    }
    uint _e43 = half_;
    uint _e48 = half_;
    return uint2((field_1.samples + naga_div(_e43, 2u)), (16u * (_e48 & 1u)));
}

float sample_float(uint index_4)
{
    const uint _e1 = word(index_4);
    return (((_e1 & 2147483647u) <= MAX_MAGNITUDE_BITS) ? asfloat(_e1) : 0.0);
}

float decode_distance(int base, uint code, float quantum)
{
    return (float(asint(asuint(base) + asuint(int(code)))) * quantum);
}

uint3 naga_div(uint3 lhs, uint3 rhs) {
    return lhs / (rhs == 0u ? 1u : rhs);
}

float read_constant(Field field_2, uint3 vertex, uint number_2)
{
    uint brick = 0u;
    uint code_1 = (uint)0;
    bool local_2 = (bool)0;

    const uint2 _e4 = coefficient(field_2, number_2, 0u);
    if ((field_2.sample_precision == PRECISION_F32_)) {
        const float _e9 = sample_float(_e4.x);
        return _e9;
    }
    if ((field_2.range == RANGE_BRICK)) {
        uint3 bricks = naga_div((field_2.counts + (3u).xxx), (4u).xxx);
        uint3 at_1 = naga_div(vertex, (4u).xxx);
        brick = (at_1.x + (bricks.x * (at_1.y + (bricks.y * at_1.z))));
    }
    const uint _e35 = word(_e4.x);
    code_1 = ((_e35 >> _e4.y) & 65535u);
    if ((field_2.sample_precision == PRECISION_PACKED32_)) {
        local_2 = (field_2.order > 0u);
    } else {
        local_2 = false;
    }
    bool _e50 = local_2;
    if (_e50) {
        const uint _e52 = word(_e4.x);
        code_1 = (_e52 >> DISTANCE_SHIFT);
    }
    uint _e56 = brick;
    const uint _e58 = word((field_2.nodes + _e56));
    uint _e60 = code_1;
    const float _e62 = decode_distance(asint(_e58), _e60, field_2.quantum);
    return _e62;
}

float copy_sign(float magnitude, float sign_)
{
    return asfloat((asuint(abs(magnitude)) | (asuint(sign_) & 2147483648u)));
}

float3 decode_gradient(uint code_2)
{
    int2 codes = asint(asuint(int2(uint2((code_2 & GRADIENT_MASK), ((code_2 >> GRADIENT_BITS) & GRADIENT_MASK)))) - asuint((int(511)).xx));
    float2 flat = (float2(codes) * GRADIENT_STEP);
    float z_3 = ((1.0 - abs(flat.x)) - abs(flat.y));
    float fold = max(-(z_3), 0.0);
    const float _e27 = copy_sign(fold, flat.x);
    float x_4 = (flat.x - _e27);
    const float _e31 = copy_sign(fold, flat.y);
    float y_3 = (flat.y - _e31);
    const float _e39 = reciprocal_sqrt((((x_4 * x_4) + (y_3 * y_3)) + (z_3 * z_3)));
    return (float3(x_4, y_3, z_3) * _e39);
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

float read_number(Field field_3, uint number_3, uint index_5)
{
    const uint2 _e3 = coefficient(field_3, number_3, index_5);
    if ((field_3.sample_precision == PRECISION_F32_)) {
        const float _e8 = sample_float(_e3.x);
        return _e8;
    }
    const uint _e10 = word(_e3.x);
    const float _e13 = decode_half((_e10 >> _e3.y));
    return _e13;
}

float3 read_three(Field field_4, uint number_4, uint first)
{
    const float _e3 = read_number(field_4, number_4, first);
    const float _e6 = read_number(field_4, number_4, (first + 1u));
    const float _e9 = read_number(field_4, number_4, (first + 2u));
    return float3(_e3, _e6, _e9);
}

Polynomial read_polynomial(Field field_5, uint3 vertex_1)
{
    Polynomial sample_ = (Polynomial)0;

    uint number_5 = (vertex_1.x + (field_5.counts.x * (vertex_1.y + (field_5.counts.y * vertex_1.z))));
    const float _e15 = read_constant(field_5, vertex_1, number_5);
    sample_.constant = _e15;
    if ((field_5.order == 0u)) {
        Polynomial _e19 = sample_;
        const Polynomial polynomial = _e19;
        return polynomial;
    }
    if ((field_5.sample_precision == PRECISION_PACKED32_)) {
        const uint2 _e25 = coefficient(field_5, number_5, 0u);
        const uint _e27 = word(_e25.x);
        const float3 _e28 = decode_gradient(_e27);
        sample_.first = _e28;
    } else {
        const float3 _e31 = read_three(field_5, number_5, 1u);
        sample_.first = _e31;
    }
    if ((field_5.order >= 2u)) {
        const float3 _e37 = read_three(field_5, number_5, 4u);
        sample_.square = _e37;
        const float3 _e40 = read_three(field_5, number_5, 7u);
        sample_.cross_ = _e40;
    }
    if ((field_5.order >= 3u)) {
        const float3 _e46 = read_three(field_5, number_5, 10u);
        sample_.cube = _e46;
        const float3 _e49 = read_three(field_5, number_5, 13u);
        sample_.mixed = _e49;
        const float3 _e52 = read_three(field_5, number_5, 16u);
        sample_.more = _e52;
        const float _e55 = read_number(field_5, number_5, 19u);
        sample_.xyz = _e55;
    }
    float3 s = field_5.spacing;
    float3 r = (s / (max(max(s.x, s.y), s.z)).xxx);
    float3 _e65 = sample_.first;
    sample_.first = (_e65 * s);
    float3 _e68 = sample_.square;
    sample_.square = (_e68 * (s * r));
    float3 _e72 = sample_.cross_;
    sample_.cross_ = (_e72 * (s.xxy * r.yzz));
    float3 _e78 = sample_.cube;
    sample_.cube = (_e78 * ((s * r) * r));
    float3 _e83 = sample_.mixed;
    sample_.mixed = (_e83 * ((s.xxx * r.xxy) * r.yzy));
    float3 _e91 = sample_.more;
    sample_.more = (_e91 * ((s.xyy * r.zyz) * r.zzz));
    float _e99 = sample_.xyz;
    sample_.xyz = (_e99 * ((s.x * r.y) * r.z));
    Polynomial _e106 = sample_;
    const Polynomial polynomial_1 = _e106;
    return polynomial_1;
}

float4 factors_of(Field field_6)
{
    if ((field_6.reconstruction != RECONSTRUCTION_HALF)) {
        return (1.0).xxxx;
    }
    switch(field_6.order) {
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

uint3 vertex_of(uint3 cell, uint corner)
{
    return (cell + uint3((corner >> 2u), ((corner >> 1u) & 1u), (corner & 1u)));
}

float4 weights_of(uint smoothness, float t)
{
    float end = (float)0;
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
    return float4((1.0 - _e57), _e60, -(_e61), _e63);
}

float4 weighted_sum(Corners corners, float2 x_1, float2 y, float2 z)
{
    float4 a = ((corners.at[0] * x_1.x) + (corners.at[4] * x_1.y));
    float4 b = ((corners.at[1] * x_1.x) + (corners.at[5] * x_1.y));
    float4 c = ((corners.at[2] * x_1.x) + (corners.at[6] * x_1.y));
    float4 d = ((corners.at[3] * x_1.x) + (corners.at[7] * x_1.y));
    return ((((a * y.x) + (c * y.y)) * z.x) + (((b * y.x) + (d * y.y)) * z.y));
}

Answer weighted_polynomials(Field field_7, uint3 cell_1, float3 local_3)
{
    Corners corners_1 = (Corners)0;
    uint corner_1 = 0u;

    uint smoothness_1 = ((field_7.reconstruction == RECONSTRUCTION_BLEND) ? field_7.order : 0u);
    const float4 _e9 = factors_of(field_7);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e33 = corner_1;
            corner_1 = (_e33 + 1u);
        }
        loop_init_1 = false;
        uint _e13 = corner_1;
        if ((_e13 < 8u)) {
        } else {
            break;
        }
        {
            uint _e16 = corner_1;
            const uint3 _e17 = vertex_of(cell_1, _e16);
            const Polynomial _e18 = read_polynomial(field_7, _e17);
            uint _e21 = corner_1;
            const uint3 _e22 = vertex_of((0u).xxx, _e21);
            const Answer _e25 = polynomial_at(_e18, (local_3 - float3(_e22)), _e9);
            uint _e27 = corner_1;
            corners_1.at[min(uint(_e27), 7u)] = float4(_e25.gradient, _e25.distance_);
        }
    }
    const float4 _e36 = weights_of(smoothness_1, local_3.x);
    const float4 _e38 = weights_of(smoothness_1, local_3.y);
    const float4 _e40 = weights_of(smoothness_1, local_3.z);
    Corners _e41 = corners_1;
    const float4 _e45 = weighted_sum(_e41, _e36.xy, _e38.xy, _e40.xy);
    Corners _e46 = corners_1;
    const float4 _e50 = weighted_sum(_e46, _e36.zw, _e38.xy, _e40.xy);
    float by_x_1 = _e50.w;
    Corners _e52 = corners_1;
    const float4 _e56 = weighted_sum(_e52, _e36.xy, _e38.zw, _e40.xy);
    float by_y_1 = _e56.w;
    Corners _e58 = corners_1;
    const float4 _e62 = weighted_sum(_e58, _e36.xy, _e38.xy, _e40.zw);
    float by_z_1 = _e62.w;
    const Answer answer_8 = ConstructAnswer(_e45.w, (float3(by_x_1, by_y_1, by_z_1) + _e45.xyz));
    return answer_8;
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
            Jet far_1 = jets.corners[min(uint(asint(asuint(_e13) + asuint(int(4)))), 7u)];
            int _e19 = edge;
            face.corners[min(uint(_e19), 3u)] = (((near_1.plain * weights.x) + (far_1.plain * weights.y)) + ((near_1.by_x * weights.z) + (far_1.by_x * weights.w)));
        }
    }
    Face _e39 = face;
    const Face face_2 = _e39;
    return face_2;
}

float4 cubic(float t_1)
{
    float rest_1 = (1.0 - t_1);
    float end_3 = ((t_1 * t_1) * (3.0 - (2.0 * t_1)));
    return float4((1.0 - end_3), end_3, (t_1 * (rest_1 * rest_1)), (-((t_1 * t_1)) * rest_1));
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

float4 cubic_slope(float t_2)
{
    float end_4 = ((6.0 * t_2) * (1.0 - t_2));
    return float4(-(end_4), end_4, ((1.0 - t_2) * (1.0 - (3.0 * t_2))), (t_2 * ((3.0 * t_2) - 2.0)));
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
    const Answer answer_9 = ConstructAnswer(_e22, float3(_e14, _e18, _e21));
    return answer_9;
}

Jet ConstructJet(float4 arg0, float4 arg1) {
    Jet ret = (Jet)0;
    ret.plain = arg0;
    ret.by_x = arg1;
    return ret;
}

Answer hermite_of_samples(Field field_8, uint3 cell_2, float3 local_5)
{
    Jets jets_2 = (Jets)0;
    uint corner_2 = 0u;

    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            uint _e30 = corner_2;
            corner_2 = (_e30 + 1u);
        }
        loop_init_3 = false;
        uint _e6 = corner_2;
        if ((_e6 < 8u)) {
        } else {
            break;
        }
        {
            uint _e9 = corner_2;
            const uint3 _e10 = vertex_of(cell_2, _e9);
            const Polynomial _e11 = read_polynomial(field_8, _e10);
            uint _e13 = corner_2;
            jets_2.corners[min(uint(_e13), 7u)] = ConstructJet(float4(_e11.constant, _e11.first.z, _e11.first.y, 0.0), float4(_e11.first.x, 0.0, 0.0, 0.0));
        }
    }
    const Answer _e32 = tricubic(jets_2, local_5);
    const Answer answer_10 = _e32;
    return answer_10;
}

float3 quintic(float t_3, uint end_1)
{
    float rest_2 = (1.0 - t_3);
    float cube_1 = ((t_3 * t_3) * t_3);
    float rest_cube = ((rest_2 * rest_2) * rest_2);
    float far_2 = (cube_1 * (10.0 - (t_3 * (15.0 - (6.0 * t_3)))));
    float3 near_weights = float3((1.0 - far_2), ((t_3 * rest_cube) * (1.0 + (3.0 * t_3))), ((t_3 * t_3) * rest_cube));
    float3 far_weights = float3(far_2, ((-(cube_1) * rest_2) * (4.0 - (3.0 * t_3))), (cube_1 * (rest_2 * rest_2)));
    return (((end_1 == 1u)).xxx ? far_weights : near_weights);
}

float quintic_product(Polynomial p_1, float3 x_2, float3 y_1, float3 z_1)
{
    return (((((((((p_1.constant * x_2.x) + (p_1.first.x * x_2.y)) + (p_1.square.x * x_2.z)) * y_1.x) + (((p_1.first.y * x_2.x) + (p_1.cross_.x * x_2.y)) * y_1.y)) + ((p_1.square.y * x_2.x) * y_1.z)) * z_1.x) + (((((p_1.first.z * x_2.x) + (p_1.cross_.y * x_2.y)) * y_1.x) + ((p_1.cross_.z * x_2.x) * y_1.y)) * z_1.y)) + (((p_1.square.z * x_2.x) * y_1.x) * z_1.z));
}

float3 quintic_slope(float t_4, uint end_2)
{
    float rest_3 = (1.0 - t_4);
    float square_2 = (t_4 * t_4);
    float rest_square = (rest_3 * rest_3);
    float far_3 = ((30.0 * square_2) * rest_square);
    float3 near_weights_1 = float3(-(far_3), (rest_square * (1.0 + (t_4 * (2.0 - (15.0 * t_4))))), ((t_4 * rest_square) * (2.0 - (5.0 * t_4))));
    float3 far_weights_1 = float3(far_3, (square_2 * ((t_4 * (28.0 - (15.0 * t_4))) - 12.0)), ((square_2 * rest_3) * (3.0 - (5.0 * t_4))));
    return (((end_2 == 1u)).xxx ? far_weights_1 : near_weights_1);
}

Answer triquintic(Field field_9, uint3 cell_3, float3 local_6)
{
    Answer sum = ConstructAnswer(0.0, (0.0).xxx);
    uint corner_3 = 0u;

    bool loop_init_4 = true;
    while(true) {
        if (!loop_init_4) {
            uint _e58 = corner_3;
            corner_3 = (_e58 + 1u);
        }
        loop_init_4 = false;
        uint _e10 = corner_3;
        if ((_e10 < 8u)) {
        } else {
            break;
        }
        {
            uint _e13 = corner_3;
            const uint3 _e14 = vertex_of(cell_3, _e13);
            const Polynomial _e15 = read_polynomial(field_9, _e14);
            uint _e18 = corner_3;
            const uint3 _e19 = vertex_of((0u).xxx, _e18);
            const float3 _e22 = quintic(local_6.x, _e19.x);
            const float3 _e25 = quintic(local_6.y, _e19.y);
            const float3 _e28 = quintic(local_6.z, _e19.z);
            float _e30 = sum.distance_;
            const float _e31 = quintic_product(_e15, _e22, _e25, _e28);
            sum.distance_ = (_e30 + _e31);
            float _e35 = sum.gradient.x;
            const float3 _e38 = quintic_slope(local_6.x, _e19.x);
            const float _e39 = quintic_product(_e15, _e38, _e25, _e28);
            sum.gradient.x = (_e35 + _e39);
            float _e43 = sum.gradient.y;
            const float3 _e46 = quintic_slope(local_6.y, _e19.y);
            const float _e47 = quintic_product(_e15, _e22, _e46, _e28);
            sum.gradient.y = (_e43 + _e47);
            float _e51 = sum.gradient.z;
            const float3 _e54 = quintic_slope(local_6.z, _e19.z);
            const float _e55 = quintic_product(_e15, _e22, _e25, _e54);
            sum.gradient.z = (_e51 + _e55);
        }
    }
    Answer _e60 = sum;
    const Answer answer_11 = _e60;
    return answer_11;
}

uint3 naga_f2u32(float3 value) {
    return uint3(clamp(value, 0.0, 4294967000.0));
}

Answer evaluate_grid(Field field_10, float3 position)
{
    Answer answer = (Answer)0;

    uint3 cell_7 = min(naga_f2u32(position), (field_10.cells - (1u).xxx));
    float3 local_22 = (position - float3(cell_7));
    if ((field_10.reconstruction == RECONSTRUCTION_NEAREST)) {
        bool3 upper = (local_22 >= (0.5).xxx);
        uint3 nearest = (cell_7 + (upper ? (1u).xxx : (0u).xxx));
        const Polynomial _e23 = read_polynomial(field_10, nearest);
        const Answer _e32 = polynomial_at(_e23, (local_22 - (upper ? (1.0).xxx : (0.0).xxx)), (1.0).xxxx);
        answer = _e32;
    } else {
        if ((field_10.reconstruction != RECONSTRUCTION_HERMITE)) {
            const Answer _e36 = weighted_polynomials(field_10, cell_7, local_22);
            answer = _e36;
        } else {
            if ((field_10.order == 1u)) {
                const Answer _e40 = hermite_of_samples(field_10, cell_7, local_22);
                answer = _e40;
            } else {
                const Answer _e41 = triquintic(field_10, cell_7, local_22);
                answer = _e41;
            }
        }
    }
    float3 _e43 = answer.gradient;
    answer.gradient = (_e43 * field_10.cells_per_unit);
    Answer _e46 = answer;
    const Answer answer_12 = _e46;
    return answer_12;
}

uint octant_of(uint3 cell_4, uint shift)
{
    uint3 half_2 = ((cell_4 >> (shift).xxx) & (1u).xxx);
    return ((half_2.x | (half_2.y << 1u)) | (half_2.z << 2u));
}

float power_of_half(uint exponent)
{
    return asfloat(((127u - min(exponent, 126u)) << 23u));
}

uint count_bits(uint bits_3)
{
    uint pairs = (bits_3 - ((bits_3 >> 1u) & 1431655765u));
    uint nibbles = ((pairs & 858993459u) + ((pairs >> 2u) & 858993459u));
    return ((((nibbles + (nibbles >> 4u)) & 252645135u) * 16843009u) >> 24u);
}

float2 decode_halves(uint bits_4)
{
    const float _e1 = decode_half(bits_4);
    const float _e4 = decode_half((bits_4 >> 16u));
    return float2(_e1, _e4);
}

Jet read_jet(Block block, uint source)
{
    float distance_ = (float)0;
    float3 gradient = (float3)0;
    float4 mixed = (0.0).xxxx;
    bool local_7 = (bool)0;

    uint before = (source - 1u);
    const uint _e6 = count_bits((block.present & before));
    const uint _e9 = count_bits((block.full & before));
    bool is_full = ((block.full & source) != 0u);
    if ((block.sample_precision == PRECISION_F32_)) {
        uint place_2 = (block.first + (4u * (_e6 + _e9)));
        const float _e27 = sample_float(place_2);
        distance_ = _e27;
        const float _e30 = sample_float((place_2 + 1u));
        const float _e33 = sample_float((place_2 + 2u));
        const float _e36 = sample_float((place_2 + 3u));
        gradient = float3(_e30, _e33, _e36);
        if (is_full) {
            const float _e40 = sample_float((place_2 + 4u));
            const float _e43 = sample_float((place_2 + 5u));
            const float _e46 = sample_float((place_2 + 6u));
            const float _e49 = sample_float((place_2 + 7u));
            mixed = float4(_e40, _e43, _e46, _e49);
        }
    } else {
        if ((block.sample_precision == PRECISION_PACKED32_)) {
            local_7 = !(is_full);
        } else {
            local_7 = false;
        }
        bool _e58 = local_7;
        if (_e58) {
            const uint _e64 = word(((block.first + _e6) + (3u * _e9)));
            const float _e69 = decode_distance(block.base, (_e64 >> DISTANCE_SHIFT), block.quantum);
            distance_ = _e69;
            const float3 _e70 = decode_gradient(_e64);
            gradient = _e70;
        } else {
            uint stride = ((block.sample_precision == PRECISION_F16_) ? 2u : 1u);
            uint place_3 = ((block.first + (_e6 * stride)) + (_e9 * (4u - stride)));
            const uint _e84 = word(place_3);
            const uint _e87 = word((place_3 + 1u));
            const float2 _e88 = decode_halves(_e87);
            const float _e97 = decode_distance(asint(asuint(int(16)) * asuint(block.base)), (_e84 & 65535u), (block.quantum * 0.0625));
            distance_ = _e97;
            const float _e100 = decode_half((_e84 >> 16u));
            gradient = float3(_e100, _e88.x, _e88.y);
            if (is_full) {
                const uint _e106 = word((place_3 + 2u));
                const float2 _e107 = decode_halves(_e106);
                const uint _e110 = word((place_3 + 3u));
                const float2 _e111 = decode_halves(_e110);
                mixed = float4(_e107, _e111);
            }
        }
    }
    float3 _e113 = gradient;
    gradient = (_e113 * block.edge);
    float4 _e116 = mixed;
    mixed = (_e116 * block.edge);
    float _e119 = distance_;
    float _e121 = gradient.z;
    float _e123 = gradient.y;
    float _e125 = mixed.z;
    float _e128 = gradient.x;
    float _e130 = mixed.y;
    float _e132 = mixed.x;
    float _e134 = mixed.w;
    const Jet jet = ConstructJet(float4(_e119, _e121, _e123, _e125), float4(_e128, _e130, _e132, _e134));
    return jet;
}

float read_distance(Block block_1, uint source_1)
{
    const uint _e6 = count_bits((block_1.present & (source_1 - 1u)));
    if ((block_1.sample_precision == PRECISION_F32_)) {
        const float _e12 = sample_float((block_1.first + _e6));
        return _e12;
    }
    const uint _e17 = word((block_1.first + naga_div(_e6, 2u)));
    uint code_3 = ((_e17 >> (16u * (_e6 & 1u))) & 65535u);
    const float _e31 = decode_distance(asint(asuint(int(16)) * asuint(block_1.base)), code_3, (block_1.quantum * 0.0625));
    return _e31;
}

Jet middle(Jet near, Jet far, uint axis)
{
    Jet sum_1 = ConstructJet((near.plain + far.plain), (near.by_x + far.by_x));
    Jet change_1 = ConstructJet((near.plain - far.plain), (near.by_x - far.by_x));
    if ((axis == 0u)) {
        const Jet jet_1 = ConstructJet(((0.5 * sum_1.plain) + (0.25 * change_1.by_x)), ((-0.25 * sum_1.by_x) + (-0.75 * change_1.plain)));
        return jet_1;
    }
    if ((axis == 1u)) {
        float4 by_sum = float4(0.5, 0.5, -0.25, -0.25);
        float4 by_change = float4(0.25, 0.25, -0.75, -0.75);
        const Jet jet_2 = ConstructJet(((by_sum * sum_1.plain) + (by_change * change_1.plain.zwxy)), ((by_sum * sum_1.by_x) + (by_change * change_1.by_x.zwxy)));
        return jet_2;
    }
    float4 by_sum_1 = float4(0.5, -0.25, 0.5, -0.25);
    float4 by_change_1 = float4(0.25, -0.75, 0.25, -0.75);
    const Jet jet_3 = ConstructJet(((by_sum_1 * sum_1.plain) + (by_change_1 * change_1.plain.yxwz)), ((by_sum_1 * sum_1.by_x) + (by_change_1 * change_1.by_x.yxwz)));
    return jet_3;
}

void settle(inout Jets jets_3, uint implied, uint octant, uint axis_1)
{
    uint corner_4 = 0u;
    bool local_8 = (bool)0;

    uint bit_5 = (4u >> axis_1);
    uint end_5 = ((((octant >> axis_1) & 1u) == 1u) ? 0u : bit_5);
    bool loop_init_5 = true;
    while(true) {
        if (!loop_init_5) {
            uint _e47 = corner_4;
            corner_4 = (_e47 + 1u);
        }
        loop_init_5 = false;
        uint _e15 = corner_4;
        if ((_e15 < 8u)) {
        } else {
            break;
        }
        {
            uint _e18 = corner_4;
            if (((_e18 & bit_5) == end_5)) {
                uint _e23 = corner_4;
                local_8 = (((implied >> _e23) & 1u) == 1u);
            } else {
                local_8 = false;
            }
            bool _e30 = local_8;
            if (_e30) {
                uint _e32 = corner_4;
                Jet near_2 = jets_3.corners[min(uint((_e32 & ~(bit_5))), 7u)];
                uint _e38 = corner_4;
                Jet far_4 = jets_3.corners[min(uint((_e38 | bit_5)), 7u)];
                uint _e43 = corner_4;
                const Jet _e45 = middle(near_2, far_4, axis_1);
                jets_3.corners[min(uint(_e43), 7u)] = _e45;
            }
        }
    }
    return;
}

Jets read_corners(uint interpolant, Block block_2, uint octant_1)
{
    Jets jets_4 = (Jets)0;
    uint implied_1 = 0u;
    uint corner_5 = 0u;
    uint source_2 = (uint)0;

    bool loop_init_6 = true;
    while(true) {
        if (!loop_init_6) {
            uint _e88 = corner_5;
            corner_5 = (_e88 + 1u);
        }
        loop_init_6 = false;
        uint _e8 = corner_5;
        if ((_e8 < 8u)) {
        } else {
            break;
        }
        {
            uint _e11 = corner_5;
            uint _e14 = corner_5;
            uint _e19 = corner_5;
            uint3 along = uint3((_e11 >> 2u), ((_e14 >> 1u) & 1u), (_e19 & 1u));
            uint3 at_2 = (along + uint3((octant_1 & 1u), ((octant_1 >> 1u) & 1u), (octant_1 >> 2u)));
            source_2 = (1u << ((at_2.x + (3u * at_2.y)) + (9u * at_2.z)));
            uint _e46 = source_2;
            if (((block_2.present & _e46) == 0u)) {
                uint _e50 = implied_1;
                uint _e52 = corner_5;
                implied_1 = (_e50 | (1u << _e52));
                source_2 = (1u << (((2u * along.x) + (6u * along.y)) + (18u * along.z)));
            }
            if ((interpolant == INTERPOLANT_TRICUBIC)) {
                uint _e71 = corner_5;
                uint _e73 = source_2;
                const Jet _e74 = read_jet(block_2, _e73);
                jets_4.corners[min(uint(_e71), 7u)] = _e74;
            } else {
                uint _e76 = corner_5;
                uint _e78 = source_2;
                const float _e79 = read_distance(block_2, _e78);
                jets_4.corners[min(uint(_e76), 7u)] = ConstructJet(float4(_e79, 0.0, 0.0, 0.0), (0.0).xxxx);
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
    const Jets jets_7 = _e99;
    return jets_7;
}

Answer trilinear(Jets jets_5, float3 local_9)
{
    Corners corners_2 = (Corners)0;
    int corner_6 = int(0);

    bool loop_init_7 = true;
    while(true) {
        if (!loop_init_7) {
            int _e16 = corner_6;
            corner_6 = asint(asuint(_e16) + asuint(int(1)));
        }
        loop_init_7 = false;
        int _e5 = corner_6;
        if ((_e5 < int(8))) {
        } else {
            break;
        }
        {
            int _e9 = corner_6;
            int _e12 = corner_6;
            corners_2.at[min(uint(_e9), 7u)] = jets_5.corners[min(uint(_e12), 7u)].plain;
        }
    }
    float2 x_5 = float2((1.0 - local_9.x), local_9.x);
    float2 y_4 = float2((1.0 - local_9.y), local_9.y);
    float2 z_4 = float2((1.0 - local_9.z), local_9.z);
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
    const Answer answer_13 = ConstructAnswer(_e46.x, float3(by_x_2, by_y_2, by_z_2));
    return answer_13;
}

Answer evaluate_octree(Field field_11, float3 position_1)
{
    uint node = (uint)0;
    uint shift_1 = (uint)0;
    uint octant_2 = 0u;
    bool local_10 = (bool)0;
    Block block_3 = (Block)0;
    Jets jets_6 = (Jets)0;
    Answer answer_1 = (Answer)0;

    uint3 cell_8 = min(naga_f2u32(position_1), (field_11.cells - (1u).xxx));
    uint3 root_2 = (cell_8 >> (field_11.depth).xxx);
    const uint _e24 = word(((field_11.nodes + root_2.x) + (field_11.counts.x * (root_2.y + (field_11.counts.y * root_2.z)))));
    node = _e24;
    shift_1 = field_11.depth;
    while(true) {
        uint _e30 = node;
        if (((_e30 >> NODE_OFFSET_BITS) == NODE_INNER)) {
            uint _e37 = shift_1;
            local_10 = (_e37 > 0u);
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
            shift_1 = (_e42 - 1u);
            uint _e45 = shift_1;
            const uint _e46 = octant_of(cell_8, _e45);
            octant_2 = _e46;
            uint _e48 = node;
            uint _e52 = octant_2;
            const uint _e54 = word(((field_11.nodes + (_e48 & NODE_OFFSET_MASK)) + _e52));
            node = _e54;
        }
    }
    uint _e55 = shift_1;
    uint _e58 = shift_1;
    uint _e63 = shift_1;
    const float _e64 = power_of_half(_e63);
    float3 local_23 = ((position_1 - float3(((cell_8 >> (_e55).xxx) << (_e58).xxx))) * _e64);
    uint _e67 = shift_1;
    uint level = (field_11.depth - _e67);
    uint _e70 = node;
    uint start_2 = (field_11.samples + (_e70 & NODE_OFFSET_MASK));
    const uint _e76 = word(start_2);
    block_3.present = (_e76 & LATTICE_MASK);
    const uint _e80 = word(start_2);
    block_3.sample_precision = ((_e80 >> PRECISION_SHIFT) & 3u);
    const uint _e88 = word((start_2 + 1u));
    block_3.full = (_e88 & LATTICE_MASK);
    const uint _e94 = word((start_2 + 2u));
    block_3.base = asint(_e94);
    block_3.first = (start_2 + 3u);
    const float _e101 = power_of_half(level);
    block_3.quantum = (field_11.quantum * _e101);
    const float _e106 = power_of_half(level);
    block_3.edge = (field_11.spacing.x * _e106);
    Block _e109 = block_3;
    uint _e110 = octant_2;
    const Jets _e111 = read_corners(field_11.reconstruction, _e109, _e110);
    jets_6 = _e111;
    if ((field_11.reconstruction == INTERPOLANT_TRICUBIC)) {
        const Answer _e117 = tricubic(jets_6, local_23);
        answer_1 = _e117;
    } else {
        Jets _e118 = jets_6;
        const Answer _e119 = trilinear(_e118, local_23);
        answer_1 = _e119;
    }
    float3 _e121 = answer_1.gradient;
    float _e123 = block_3.edge;
    answer_1.gradient = (_e121 * (1.0 / _e123));
    Answer _e127 = answer_1;
    const Answer answer_14 = _e127;
    return answer_14;
}

uint root_node(Field field_12, uint3 root)
{
    const uint _e15 = word(((field_12.nodes + root.x) + (field_12.counts.x * (root.y + (field_12.counts.y * root.z)))));
    return _e15;
}

uint bits_at(uint section, uint bit, uint index_6)
{
    uint at_3 = ((section + index_6) + naga_div(bit, 32u));
    uint shift_4 = (bit & 31u);
    const uint _e9 = word(at_3);
    const uint _e13 = word((at_3 + 1u));
    return ((_e9 >> shift_4) | ((_e13 << 1u) << (31u - shift_4)));
}

uint child_node(Field field_13, uint record, uint octant_3)
{
    uint byte = (RECORD_LENGTH * record);
    const uint _e15 = bits_at(field_13.records, ((8u * (byte & 3u)) + (8u * octant_3)), naga_div(byte, 4u));
    uint start_3 = ((octant_3 == 0u) ? 0u : (_e15 & 255u));
    const uint _e29 = bits_at(field_13.records, (8u * (byte & 3u)), naga_div(byte, 4u));
    uint first_bit = (8u * ((byte & 3u) + RECORD_FIRST));
    if ((((_e29 >> octant_3) & 1u) == 1u)) {
        const uint _e44 = bits_at(field_13.records, first_bit, naga_div(byte, 4u));
        return ((_e44 & RECORD_CHILD_MASK) + start_3);
    }
    const uint _e53 = bits_at(field_13.records, (first_bit + RECORD_CHILD_BITS), naga_div(byte, 4u));
    uint leaf_3 = (_e53 & RECORD_LEAF_MASK);
    return (ROOT_LEAF | (leaf_3 + start_3));
}

Leaf ConstructLeaf(uint arg0, uint3 arg1, uint arg2) {
    Leaf ret = (Leaf)0;
    ret.place = arg0;
    ret.cell = arg1;
    ret.shift = arg2;
    return ret;
}

Leaf find_leaf(Field field_14, uint3 cell_5)
{
    uint node_1 = (uint)0;
    uint shift_2 = (uint)0;
    bool local_11 = (bool)0;

    uint3 root_3 = (cell_5 >> (field_14.depth).xxx);
    const uint _e5 = root_node(field_14, root_3);
    node_1 = _e5;
    shift_2 = field_14.depth;
    while(true) {
        uint _e9 = node_1;
        if (((_e9 & ROOT_LEAF) == 0u)) {
            uint _e16 = shift_2;
            local_11 = (_e16 > 0u);
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
            shift_2 = (_e21 - 1u);
            uint _e24 = node_1;
            uint _e25 = shift_2;
            const uint _e26 = octant_of(cell_5, _e25);
            const uint _e27 = child_node(field_14, _e24, _e26);
            node_1 = _e27;
        }
    }
    uint _e28 = node_1;
    uint _e31 = shift_2;
    uint _e34 = shift_2;
    uint _e37 = shift_2;
    const Leaf leaf_4 = ConstructLeaf((_e28 & 2147483647u), ((cell_5 >> (_e31).xxx) << (_e34).xxx), _e37);
    return leaf_4;
}

float3 local_of(Leaf leaf, float3 position_2)
{
    const float _e6 = power_of_half(leaf.shift);
    return (((position_2 - float3(leaf.cell)) * (2.0 * _e6)) - (1.0).xxx);
}

LeafHead ConstructLeafHead(uint arg0, uint arg1, uint arg2, uint arg3) {
    LeafHead ret = (LeafHead)0;
    ret.kind_and_degrees = arg0;
    ret.widths = arg1;
    ret.support = arg2;
    ret.reach = arg3;
    return ret;
}

LeafHead read_head(Field field_15, uint place)
{
    const uint _e9 = bits_at(field_15.samples, (8u * (place & 3u)), naga_div(place, 4u));
    uint shape = (field_15.shapes + (2u * (_e9 & ((1u << field_15.shape_bits) - 1u))));
    uint codes_1 = (_e9 >> field_15.shape_bits);
    const uint _e22 = word(shape);
    const uint _e25 = word((shape + 1u));
    const LeafHead leafhead = ConstructLeafHead(_e22, _e25, (codes_1 & 3u), ((codes_1 >> SUPPORT_BITS) & 3u));
    return leafhead;
}

float read_code(Field field_16, uint index_7, uint bit_1, uint width)
{
    uint size = (1u << (width & 31u));
    const uint _e9 = bits_at(field_16.samples, bit_1, index_7);
    uint code_4 = (_e9 & (size - 1u));
    return float(asint(asuint(int(code_4)) - asuint(int((size >> 1u)))));
}

float3 read_codes(Field field_17, uint index_8, uint bit_2, uint width_1)
{
    const float _e4 = read_code(field_17, index_8, bit_2, width_1);
    const float _e6 = read_code(field_17, index_8, (bit_2 + width_1), width_1);
    const float _e10 = read_code(field_17, index_8, (bit_2 + (2u * width_1)), width_1);
    return float3(_e4, _e6, _e10);
}

Terms read_terms(Field field_18, uint index_9, uint start, uint degree, uint widths)
{
    Terms terms = (Terms)0;
    uint bit_3 = (uint)0;

    bit_3 = start;
    uint _e9 = bit_3;
    const uint _e11 = byte_of(widths, 0u);
    const float _e12 = read_code(field_18, index_9, _e9, _e11);
    terms.linear_.w = _e12;
    uint _e13 = bit_3;
    const uint _e15 = byte_of(widths, 0u);
    bit_3 = (_e13 + _e15);
    if ((degree >= 1u)) {
        const uint _e20 = byte_of(widths, 1u);
        uint _e22 = bit_3;
        const float3 _e23 = read_codes(field_18, index_9, _e22, _e20);
        float _e26 = terms.linear_.w;
        terms.linear_ = float4(_e23, _e26);
        uint _e28 = bit_3;
        bit_3 = (_e28 + (3u * _e20));
    }
    if ((degree >= 2u)) {
        const uint _e35 = byte_of(widths, 2u);
        uint _e37 = bit_3;
        const float3 _e38 = read_codes(field_18, index_9, _e37, _e35);
        terms.square = float4(_e38, 0.0);
        uint _e42 = bit_3;
        const float3 _e46 = read_codes(field_18, index_9, (_e42 + (3u * _e35)), _e35);
        terms.cross_ = float4(_e46, 0.0);
        uint _e49 = bit_3;
        bit_3 = (_e49 + (6u * _e35));
    }
    if ((degree >= 3u)) {
        const uint _e56 = byte_of(widths, 3u);
        uint _e58 = bit_3;
        const float3 _e59 = read_codes(field_18, index_9, _e58, _e56);
        uint _e60 = bit_3;
        const float _e64 = read_code(field_18, index_9, (_e60 + (9u * _e56)), _e56);
        terms.cube = float4(_e59, _e64);
        uint _e67 = bit_3;
        const float3 _e71 = read_codes(field_18, index_9, (_e67 + (3u * _e56)), _e56);
        terms.next = float4(_e71, 0.0);
        uint _e75 = bit_3;
        const float3 _e79 = read_codes(field_18, index_9, (_e75 + (6u * _e56)), _e56);
        terms.previous = float4(_e79, 0.0);
        uint _e82 = bit_3;
        bit_3 = (_e82 + (10u * _e56));
    }
    uint _e87 = bit_3;
    terms.end = _e87;
    Terms _e88 = terms;
    const Terms terms_2 = _e88;
    return terms_2;
}

Answer evaluate_terms(Terms terms_1, uint degree_1, float3 local_12)
{
    float4 value = (float4)0;
    float4 slope_1 = (float4)0;
    float4 square = (float4)0;

    float4 first_2 = float4(local_12, 1.0);
    float4 next = float4(local_12.yzx, 0.0);
    float4 previous = float4(local_12.zxy, 0.0);
    float4 second_1 = float4(((1.5 * (first_2 * first_2)) - (0.5).xxxx).xyz, 0.0);
    float4 third_1 = float4((first_2 * ((2.5 * (first_2 * first_2)) - (1.5).xxxx)).xyz, ((local_12.x * local_12.y) * local_12.z));
    value = (terms_1.linear_ * first_2);
    slope_1 = terms_1.linear_;
    if ((degree_1 >= 2u)) {
        float4 line_ = (terms_1.linear_ + (terms_1.cross_ * next));
        square = terms_1.square;
        if ((degree_1 >= 3u)) {
            float4 _e49 = square;
            square = (_e49 + ((terms_1.next * next) + (terms_1.previous * previous)));
        }
        float4 _e57 = square;
        value = ((line_ * first_2) + (_e57 * second_1));
        float4 _e64 = square;
        slope_1 = ((line_ + (terms_1.cross_.zxyw * previous)) + (_e64 * (3.0 * first_2)));
        if ((degree_1 >= 3u)) {
            float4 _e71 = value;
            value = (_e71 + (terms_1.cube * third_1));
            float4 others = ((terms_1.next * second_1).zxyw + (terms_1.previous * second_1).yzxw);
            float4 _e82 = slope_1;
            slope_1 = ((_e82 + ((terms_1.cube * ((7.5 * (first_2 * first_2)) - (1.5).xxxx)) + others)) + (terms_1.cube.w * (next * previous)));
        }
    }
    float _e99 = value.x;
    float _e101 = value.y;
    float _e104 = value.z;
    float _e106 = value.w;
    float4 _e109 = slope_1;
    const Answer answer_15 = ConstructAnswer(((_e99 + _e101) + (_e104 + _e106)), _e109.xyz);
    return answer_15;
}

float edge_of(Field field_19, Leaf leaf_1)
{
    const float _e7 = power_of_half((field_19.depth - leaf_1.shift));
    return (field_19.spacing.x * _e7);
}

Answer evaluate_leaf(Field field_20, Leaf leaf_2, float3 local_13)
{
    uint bit_4 = (uint)0;
    Answer answer_2 = ConstructAnswer(0.0, (0.0).xxx);
    uint index_10 = 0u;
    bool local_14 = (bool)0;
    bool local_15 = (bool)0;
    bool local_16 = (bool)0;
    bool local_17 = (bool)0;
    bool local_18 = (bool)0;

    const LeafHead _e4 = read_head(field_20, leaf_2.place);
    uint widths_1 = _e4.widths;
    const uint _e8 = byte_of(_e4.kind_and_degrees, 0u);
    const uint _e11 = byte_of(_e4.kind_and_degrees, 3u);
    uint exponent_2 = (_e11 & MAX_EXPONENT);
    float step_ = (field_20.quantum * asfloat(((127u + exponent_2) << 23u)));
    bit_4 = (((8u * (leaf_2.place & 3u)) + field_20.shape_bits) + ((field_20.overlap == 0.0) ? 0u : OVERLAP_BITS));
    bool loop_init_8 = true;
    while(true) {
        if (!loop_init_8) {
            uint _e101 = index_10;
            index_10 = (_e101 + 1u);
        }
        loop_init_8 = false;
        uint _e43 = index_10;
        if ((_e43 < 2u)) {
        } else {
            break;
        }
        {
            uint _e46 = index_10;
            if ((_e46 == 1u)) {
                local_14 = (_e8 == KIND_SINGLE);
            } else {
                local_14 = false;
            }
            bool _e54 = local_14;
            if (_e54) {
                break;
            }
            uint _e57 = index_10;
            const uint _e59 = byte_of(_e4.kind_and_degrees, (1u + _e57));
            uint _e63 = bit_4;
            const Terms _e64 = read_terms(field_20, naga_div(leaf_2.place, 4u), _e63, _e59, widths_1);
            bit_4 = _e64.end;
            const Answer _e66 = evaluate_terms(_e64, _e59, local_13);
            float _e69 = answer_2.distance_;
            bool is_less = (_e66.distance_ < _e69);
            float _e73 = answer_2.distance_;
            bool is_greater = (_e66.distance_ > _e73);
            uint _e75 = index_10;
            if (!((_e75 == 0u))) {
                if ((_e8 == KIND_MIN)) {
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
                if ((_e8 != KIND_MIN)) {
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
    const float _e103 = edge_of(field_20, leaf_2);
    float per_half = (2.0 / _e103);
    float _e107 = answer_2.distance_;
    float3 _e110 = answer_2.gradient;
    const Answer answer_16 = ConstructAnswer((_e107 * step_), ((_e110 * step_) * per_half));
    return answer_16;
}

float4 weight_at(float3 local_19, float steepness)
{
    float3 s_1 = clamp(((0.5).xxx + (((1.0).xxx - abs(local_19)) * steepness)), (0.0).xxx, (1.0).xxx);
    float3 w = ((s_1 * s_1) * ((3.0).xxx - (2.0 * s_1)));
    const float _e24 = copy_sign(steepness, -(local_19.x));
    const float _e27 = copy_sign(steepness, -(local_19.y));
    const float _e30 = copy_sign(steepness, -(local_19.z));
    float3 signs_1 = float3(_e24, _e27, _e30);
    float3 slope_4 = (((6.0 * s_1) * ((1.0).xxx - s_1)) * signs_1);
    return float4((slope_4.x * (w.y * w.z)), (slope_4.y * (w.x * w.z)), (slope_4.z * (w.x * w.y)), ((w.x * w.y) * w.z));
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

Answer blend(Field field_21, Leaf own, float3 position_3, Answer alone)
{
    float weight = (float)0;
    float3 weight_slope = (float3)0;
    float change = 0.0;
    float3 slope_2 = (float3)0;
    bool is_alone = true;
    uint records[16] = (uint[16])0;
    uint pending[16] = (uint[16])0;
    uint3 root_1 = (uint3)0;
    uint3 cell_6 = (0u).xxx;
    uint shift_3 = (uint)0;
    bool local_20 = (bool)0;
    uint node_2 = (uint)0;
    bool local_21 = (bool)0;

    const LeafHead _e5 = read_head(field_21, own.place);
    float steepness_1 = (0.25 / field_21.overlap);
    const float3 _e9 = local_of(own, position_3);
    const float4 _e15 = weight_at(_e9, (steepness_1 * float((1u << _e5.support))));
    weight = _e15.w;
    const float _e19 = edge_of(field_21, own);
    weight_slope = (_e15.xyz * (2.0 / _e19));
    slope_2 = (_e15.w * alone.gradient);
    const float _e33 = power_of_half(_e5.reach);
    float share = ((_e5.reach == 0u) ? LEAST_SUPPORT_SHARE : (_e33 * 2.0));
    float margin = ((field_21.overlap * float((1u << own.shift))) * share);
    uint3 last = (field_21.cells - (1u).xxx);
    uint3 low_1 = min(naga_f2u32(max((position_3 - (margin).xxx), (0.0).xxx)), last);
    uint3 high_1 = min(naga_f2u32((position_3 + (margin).xxx)), last);
    uint3 first_root = (low_1 >> (field_21.depth).xxx);
    uint3 last_root = (high_1 >> (field_21.depth).xxx);
    root_1 = first_root;
    shift_3 = field_21.depth;
    while(true) {
        while(true) {
            uint _e77 = shift_3;
            if ((_e77 < field_21.depth)) {
                uint _e82 = shift_3;
                uint _e86 = pending[min(uint((_e82 & 15u)), 15u)];
                local_20 = (_e86 == 0u);
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
                shift_3 = (_e91 + 1u);
            }
        }
        node_2 = ZeroValueuint();
        uint _e96 = shift_3;
        if ((_e96 < field_21.depth)) {
            uint _e99 = shift_3;
            uint children_1 = pending[min(uint((_e99 & 15u)), 15u)];
            uint _e104 = shift_3;
            pending[min(uint((_e104 & 15u)), 15u)] = (children_1 & (children_1 - 1u));
            const uint _e117 = count_bits(((children_1 & (~(children_1) + 1u)) - 1u));
            uint3 _e118 = cell_6;
            uint _e119 = shift_3;
            uint _e124 = shift_3;
            uint3 parent = ((_e118 >> ((_e119 + 1u)).xxx) << ((_e124 + 1u)).xxx);
            uint _e138 = shift_3;
            cell_6 = (parent + (uint3((_e117 & 1u), ((_e117 >> 1u) & 1u), (_e117 >> 2u)) << (_e138).xxx));
            uint _e142 = shift_3;
            uint _e146 = records[min(uint((_e142 & 15u)), 15u)];
            const uint _e147 = child_node(field_21, _e146, _e117);
            node_2 = _e147;
        } else {
            uint _e149 = root_1.z;
            if ((_e149 > last_root.z)) {
                break;
            }
            uint3 _e152 = root_1;
            cell_6 = (_e152 << (field_21.depth).xxx);
            uint3 _e156 = root_1;
            const uint _e157 = root_node(field_21, _e156);
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
            local_21 = (_e189 > 0u);
        } else {
            local_21 = false;
        }
        bool _e193 = local_21;
        if (_e193) {
            uint _e194 = shift_3;
            shift_3 = (_e194 - 1u);
            uint _e197 = shift_3;
            uint _e201 = node_2;
            records[min(uint((_e197 & 15u)), 15u)] = _e201;
            uint _e202 = shift_3;
            uint3 _e206 = cell_6;
            uint _e208 = shift_3;
            const uint _e212 = children_in((_e206 + ((1u << _e208)).xxx), low_1, high_1);
            pending[min(uint((_e202 & 15u)), 15u)] = _e212;
            continue;
        }
        uint _e213 = node_2;
        uint3 _e216 = cell_6;
        uint _e217 = shift_3;
        Leaf leaf_5 = ConstructLeaf((_e213 & 2147483647u), _e216, _e217);
        if ((leaf_5.place == own.place)) {
            continue;
        }
        const float3 _e222 = local_of(leaf_5, position_3);
        const LeafHead _e225 = read_head(field_21, leaf_5.place);
        const float4 _e230 = weight_at(_e222, (steepness_1 * float((1u << _e225.support))));
        if ((_e230.w > 0.0)) {
            is_alone = false;
            const Answer _e235 = evaluate_leaf(field_21, leaf_5, _e222);
            float difference = (_e235.distance_ - alone.distance_);
            const float _e240 = edge_of(field_21, leaf_5);
            float3 its_slope = (_e230.xyz * (2.0 / _e240));
            float _e244 = weight;
            weight = (_e244 + _e230.w);
            float _e247 = change;
            change = (_e247 + (_e230.w * difference));
            float3 _e251 = weight_slope;
            weight_slope = (_e251 + its_slope);
            float3 _e253 = slope_2;
            slope_2 = (_e253 + ((_e230.w * _e235.gradient) + (its_slope * difference)));
        }
    }
    bool _e260 = is_alone;
    if (_e260) {
        const Answer answer_17 = alone;
        return answer_17;
    }
    float _e261 = weight;
    float per_weight = (1.0 / _e261);
    float _e264 = change;
    float mean = (_e264 * per_weight);
    float3 _e268 = slope_2;
    float3 _e269 = weight_slope;
    const Answer answer_18 = ConstructAnswer((alone.distance_ + mean), ((_e268 - (mean * _e269)) * per_weight));
    return answer_18;
}

Answer evaluate_polynomial_octree(Field field_22, float3 position_4)
{
    const Leaf _e8 = find_leaf(field_22, min(naga_f2u32(position_4), (field_22.cells - (1u).xxx)));
    const float3 _e9 = local_of(_e8, position_4);
    const Answer _e10 = evaluate_leaf(field_22, _e8, _e9);
    if ((field_22.overlap == 0.0)) {
        const Answer answer_19 = _e10;
        return answer_19;
    }
    const LeafHead _e15 = read_head(field_22, _e8.place);
    uint reach = _e15.reach;
    const float _e17 = power_of_half(reach);
    float share_1 = ((reach == 0u) ? 128.0 : (_e17 * 4.0));
    if ((max(max(abs(_e9.x), abs(_e9.y)), abs(_e9.z)) > (1.0 - (field_22.overlap * share_1)))) {
        const Answer _e37 = blend(field_22, _e8, position_4, _e10);
        const Answer answer_20 = _e37;
        return answer_20;
    }
    const Answer answer_21 = _e10;
    return answer_21;
}

Answer answer_inside(Field field_23, float3 point_1)
{
    float3 position_5 = min(((point_1 - field_23.low) * field_23.cells_per_unit), float3(field_23.cells));
    switch(field_23.family) {
        case 1u: {
            const Answer _e10 = evaluate_grid(field_23, position_5);
            const Answer answer_22 = _e10;
            return answer_22;
        }
        case 2u: {
            const Answer _e11 = evaluate_octree(field_23, position_5);
            const Answer answer_23 = _e11;
            return answer_23;
        }
        default: {
            const Answer _e12 = evaluate_polynomial_octree(field_23, position_5);
            const Answer answer_24 = _e12;
            return answer_24;
        }
    }
}

Answer nearfield_evaluate(Field field_24, float3 point_2)
{
    Answer answer_3 = (Answer)0;

    uint3 bits_5 = (asuint(point_2) & (2147483647u).xxx);
    if (any((bits_5 >= (2139095040u).xxx))) {
        const Answer _e10 = answer_without_end(bits_5, point_2);
        const Answer answer_25 = _e10;
        return answer_25;
    }
    float3 nearest_1 = min(max(point_2, field_24.low), field_24.high);
    const Answer _e15 = answer_inside(field_24, nearest_1);
    answer_3 = _e15;
    if (any((nearest_1 != point_2))) {
        const Answer _e20 = length_and_direction((point_2 - nearest_1));
        float _e23 = answer_3.distance_;
        answer_3.distance_ = min((_e23 + _e20.distance_), MAX_FLOAT);
        answer_3.gradient = _e20.gradient;
    }
    Answer _e30 = answer_3;
    const Answer answer_26 = _e30;
    return answer_26;
}

float nearfield_distance(Field field_25, float3 point_3)
{
    const Answer _e2 = nearfield_evaluate(field_25, point_3);
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

    uint index_11 = invocation.x;
    if (!((index_11 >= ((NagaBufferLengthRW(answers) - 0) / 16)))) {
        local = (((3u * index_11) + 2u) >= ((NagaBufferLength(points) - 0) / 4));
    } else {
        local = true;
    }
    bool _e16 = local;
    if (_e16) {
        return;
    }
    float _e21 = asfloat(points.Load((3u * index_11)*4));
    float _e28 = asfloat(points.Load(((3u * index_11) + 1u)*4));
    float _e35 = asfloat(points.Load(((3u * index_11) + 2u)*4));
    float3 point_4 = float3(_e21, _e28, _e35);
    const Field _e37 = nearfield_open();
    const Answer _e38 = nearfield_evaluate(_e37, point_4);
    answers.Store4(index_11*16, asuint(float4(_e38.distance_, _e38.gradient)));
    return;
}
