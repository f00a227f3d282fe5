// Draws a view with WebGL2: the shaders read the bytes of the file from a texture of four words a texel. Each family has a
// shader of its own, since one for all takes drivers long to compile.

const TEXELS_A_ROW = 2048;
const SHOW = { occlusion: 1, shadow: 2, normals: 4 };

class Painter {
  // `fragments`: the source for each family, by its code.
  constructor(canvas, vertex, fragments) {
    Object.assign(this, { canvas, vertex, fragments, programs: {} });
    const gl = canvas.getContext("webgl2", { antialias: false, preserveDrawingBuffer: true });
    if (!gl) throw new Error("this browser has no WebGL2");
    this.gl = gl;
    this.block = new ArrayBuffer(112);
    gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, gl.createBuffer());
    gl.bufferData(gl.UNIFORM_BUFFER, this.block.byteLength, gl.DYNAMIC_DRAW);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  }

  // The program for a family.
  compile(family) {
    const gl = this.gl;
    const program = gl.createProgram();
    const sources = [[gl.VERTEX_SHADER, this.vertex], [gl.FRAGMENT_SHADER, this.fragments[family]]];
    const shaders = sources.map(([kind, source]) => {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source.trim());
      gl.compileShader(shader);
      gl.attachShader(program, shader);
      return shader;
    });
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
      const reasons = [gl.getProgramInfoLog(program), ...shaders.map((shader) => gl.getShaderInfoLog(shader))];
      throw new Error(`the shader does not compile here: ${reasons.filter(Boolean).join(" ")}`);
    }
    // Names that naga gives.
    gl.uniformBlockBinding(program, gl.getUniformBlockIndex(program, "View_block_0Fragment"), 0);
    gl.useProgram(program);
    gl.uniform1i(gl.getUniformLocation(program, "_group_0_binding_0_fs"), 0);
    return program;
  }

  // Takes the bytes of a field, as they are, and the code of its family.
  load(bytes, family) {
    const gl = this.gl;
    const texels = Math.ceil(bytes.length / 16);
    const width = Math.min(texels, TEXELS_A_ROW);
    const height = Math.ceil(texels / width);
    if (height > gl.getParameter(gl.MAX_TEXTURE_SIZE)) throw new Error("larger than a texture of this browser can be");
    this.programs[family] ??= this.compile(family);
    gl.useProgram(this.programs[family]);
    const padded = new Uint8Array(16 * width * height);
    padded.set(bytes);
    // Typed arrays have the byte order of the machine, and every machine with a browser is little-endian.
    const words = new Uint32Array(padded.buffer);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32UI, width, height, 0, gl.RGBA_INTEGER, gl.UNSIGNED_INT, words);
  }

  // `look`: offset, cut ({ axis, at } or null), occlusion, shadow, normals, antialias. `placed`: a placed camera.
  draw(placed, look) {
    const gl = this.gl;
    const [floats, integers] = [new Float32Array(this.block), new Uint32Array(this.block)];
    const cut = [0, 0, 0];
    let cutAt = 0;
    if (look.cut) {
      // The side of the eye is cut away.
      const side = placed.eye[look.cut.axis] > look.cut.at ? 1 : -1;
      cut[look.cut.axis] = side;
      cutAt = side * look.cut.at;
    }
    const deepest = 0.25 * placed.size;
    floats.set([
      ...placed.eye, placed.pixel, ...placed.forward, placed.size, ...placed.right, placed.halfWidth,
      ...placed.up, placed.halfHeight, ...cut, cutAt, look.offset, deepest, roundNumber(deepest / 20),
    ]);
    integers[23] = look.antialias;
    integers[24] = Object.keys(SHOW).reduce((bits, name) => look[name] ? bits | SHOW[name] : bits, 0);
    gl.bufferSubData(gl.UNIFORM_BUFFER, 0, this.block);
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}

// The number of the form 1, 2 or 5 times a power of ten that is next above `least`.
function roundNumber(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((factor) => factor * power).find((number) => number >= least);
}
