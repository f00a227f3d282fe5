// A field as an object of three.js: its box, in whose pixels a shader traces spheres to the surface. The shader reads the bytes
// of the file as they are.
import * as THREE from "three";

/** Texels in a row of the texture that holds a file; a texel holds 16 bytes. */
const TEXELS_A_ROW = 2048;

const vertexShader = /* glsl */ `
  in vec3 position;
  out vec3 local;

  uniform mat4 modelViewMatrix;
  uniform mat4 projectionMatrix;

  void main() {
    local = position;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }
`;

const precisions = /* glsl */ `
  precision highp float;
  precision highp int;
  precision highp usampler2D;
`;

/** Follows the reader, which is of the family of the field. */
const pixel = /* glsl */ `
  uniform vec3 boxMin;
  uniform vec3 boxMax;
  uniform float near;
  uniform vec3 colour;
  uniform vec3 toLight;
  uniform vec3 eye;
  uniform mat4 modelViewMatrix;
  uniform mat4 projectionMatrix;
  uniform mat3 normalMatrix;

  in vec3 local;
  out vec4 fragment;

  void main() {
    // The pixels are those of the far side of the box, so that the eye may be inside it.
    vec3 direction = normalize(local - eye);
    vec3 a = (boxMin - eye) / direction;
    vec3 b = (boxMax - eye) / direction;
    vec3 entry = min(a, b);
    vec3 exit = max(a, b);
    float along = max(0.0, max(entry.x, max(entry.y, entry.z)));
    float end = min(exit.x, min(exit.y, exit.z));

    Field field = nearfield_open();
    float slope = max(1.0, nearfield_slope());
    for (int step = 0; step < 256; step++) {
      vec3 point = eye + along * direction;
      float ahead = nearfield_distance(field, point);
      if (ahead < near) {
        vec3 normal = normalize(normalMatrix * nearfield_evaluate(field, point).gradient);
        float light = 0.25 + 0.75 * max(0.0, dot(normal, toLight));
        fragment = vec4(colour * light, 1.0);
        // Its depth is that of the surface: meshes hide it and are hidden by it.
        vec4 clip = projectionMatrix * modelViewMatrix * vec4(point, 1.0);
        gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
        return;
      }
      along += ahead / slope;
      if (along > end) break;
    }
    discard;
  }
`;

/** The family of a field, as the name of the reader in GLSL has it (SPEC.md, section 3). */
export function familyOf(bytes) {
  return { 1: "grid", 2: "octree", 3: "polynomial" }[bytes[16]];
}

/**
 * A mesh of three.js that shows a field. It may be moved, turned and uniformly scaled.
 *
 * `field` was opened from `bytes`, which checked them: a shader cannot. `reader` is the text of `nearfield-FAMILY.glsl`.
 * `toLight` points to a light far away, in the frame of the camera.
 */
export function fieldMesh({ bytes, field, reader, colour = 0xffffff, toLight = new THREE.Vector3(0.4, 0.7, 0.6) }) {
  const [min, max] = field.bounds.map((corner) => new THREE.Vector3(...corner));
  const size = max.clone().sub(min);
  const geometry = new THREE.BoxGeometry(...size).translate(...min.clone().add(max).multiplyScalar(0.5));

  const material = new THREE.RawShaderMaterial({
    glslVersion: THREE.GLSL3,
    vertexShader,
    fragmentShader: precisions + reader + pixel,
    side: THREE.BackSide,
    uniforms: {
      nearfield_words: { value: words(bytes) },
      boxMin: { value: min },
      boxMax: { value: max },
      near: { value: Math.max(...size) * 5e-4 },
      colour: { value: new THREE.Color(colour) },
      toLight: { value: toLight.clone().normalize() },
      eye: { value: new THREE.Vector3() },
    },
  });

  const mesh = new THREE.Mesh(geometry, material);
  mesh.onBeforeRender = (_renderer, _scene, camera) => {
    mesh.worldToLocal(material.uniforms.eye.value.setFromMatrixPosition(camera.matrixWorld));
  };
  return mesh;
}

/** A file as a texture: four words a texel, row after row, zeros at the end. Machines with a browser are little-endian. */
function words(bytes) {
  const texels = Math.ceil(bytes.length / 16);
  const width = Math.min(texels, TEXELS_A_ROW);
  const height = Math.ceil(texels / width);
  const padded = new Uint8Array(16 * width * height);
  padded.set(bytes);
  const texture = new THREE.DataTexture(new Uint32Array(padded.buffer), width, height);
  texture.format = THREE.RGBAIntegerFormat;
  texture.type = THREE.UnsignedIntType;
  texture.internalFormat = "RGBA32UI";
  texture.needsUpdate = true;
  return texture;
}
