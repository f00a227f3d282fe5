#version 300 es

precision highp float;
precision highp int;

struct Corner {
    vec4 position;
    vec2 place;
};
smooth out vec2 _vs2fs_location0;

void main() {
    uint index = uint(gl_VertexID);
    vec2 place = vec2(((float((index & 1u)) * 4.0) - 1.0), ((float((index >> 1u)) * 4.0) - 1.0));
    Corner _tmp_return = Corner(vec4(place, 0.0, 1.0), place);
    gl_Position = _tmp_return.position;
    _vs2fs_location0 = _tmp_return.place;
    return;
}

