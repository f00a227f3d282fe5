// A field as an object of three.js: its box, in whose pixels a shader traces spheres to the surface.
import * as THREE from "three";

/** Samples along each side of the box. The texture has 2 bytes for each. */
const SAMPLES = 64;

const vertexShader = /* glsl */ `
  out vec3 local;

  void main() {
    local = position;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }
`;

const fragmentShader = /* glsl */ `
  precision highp float;
  precision highp sampler3D;

  uniform sampler3D distances;
  uniform vec3 boxMin;
  uniform vec3 boxMax;
  uniform float lipschitz;
  uniform float near;
  uniform vec3 colour;
  uniform vec3 toLight;
  uniform vec3 eye;
  uniform mat4 modelViewMatrix;
  uniform mat4 projectionMatrix;
  uniform mat3 normalMatrix;

  in vec3 local;
  out vec4 fragment;

  // The outermost samples lie on the faces of the box.
  float field(vec3 point) {
    vec3 share = (point - boxMin) / (boxMax - boxMin);
    const float samples = float(${SAMPLES});
    return texture(distances, (share * (samples - 1.0) + 0.5) / samples).r;
  }

  vec3 gradient(vec3 point) {
    vec2 step = vec2(2.0 * near, 0.0);
    return vec3(
      field(point + step.xyy) - field(point - step.xyy),
      field(point + step.yxy) - field(point - step.yxy),
      field(point + step.yyx) - field(point - step.yyx)
    );
  }

  void main() {
    // The pixels are those of the far side of the box, so that the eye may be inside it.
    vec3 direction = normalize(local - eye);
    vec3 a = (boxMin - eye) / direction;
    vec3 b = (boxMax - eye) / direction;
    vec3 entry = min(a, b);
    vec3 exit = max(a, b);
    float along = max(0.0, max(entry.x, max(entry.y, entry.z)));
    float end = min(exit.x, min(exit.y, exit.z));

    for (int step = 0; step < 256; step++) {
      vec3 point = eye + along * direction;
      float distance = field(point);
      if (distance < near) {
        vec3 normal = normalize(normalMatrix * gradient(point));
        float light = 0.25 + 0.75 * max(0.0, dot(normal, toLight));
        fragment = vec4(colour * light, 1.0);
        // Its depth is that of the surface: meshes hide it and are hidden by it.
        vec4 clip = projectionMatrix * modelViewMatrix * vec4(point, 1.0);
        gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
        return;
      }
      along += distance / lipschitz;
      if (along > end) break;
    }
    discard;
  }
`;

/**
 * A mesh of three.js that shows a field. It may be moved, turned and uniformly scaled.
 *
 * `toLight` points to a light far away, in the frame of the camera.
 */
export function fieldMesh(field, { colour = 0xffffff, toLight = new THREE.Vector3(0.4, 0.7, 0.6) } = {}) {
  const [min, max] = field.bounds.map((corner) => new THREE.Vector3(...corner));
  const size = max.clone().sub(min);
  const geometry = new THREE.BoxGeometry(...size).translate(...min.clone().add(max).multiplyScalar(0.5));

  const longest = Math.max(...size);
  const material = new THREE.RawShaderMaterial({
    glslVersion: THREE.GLSL3,
    vertexShader: `in vec3 position; uniform mat4 modelViewMatrix; uniform mat4 projectionMatrix; ${vertexShader}`,
    fragmentShader,
    side: THREE.BackSide,
    uniforms: {
      distances: { value: sample(field, min, size) },
      boxMin: { value: min },
      boxMax: { value: max },
      lipschitz: { value: Math.max(1, field.lipschitz) },
      near: { value: longest * 5e-4 },
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

/** The field on a regular grid over its box, as a texture that is filtered. */
function sample(field, min, size) {
  const points = new Float32Array(SAMPLES ** 3 * 3);
  let next = 0;
  const at = (index, axis) => min.getComponent(axis) + (index / (SAMPLES - 1)) * size.getComponent(axis);
  for (let z = 0; z < SAMPLES; z++) {
    for (let y = 0; y < SAMPLES; y++) {
      for (let x = 0; x < SAMPLES; x++) {
        points[next++] = at(x, 0);
        points[next++] = at(y, 1);
        points[next++] = at(z, 2);
      }
    }
  }

  const halves = Uint16Array.from(field.distances(points), THREE.DataUtils.toHalfFloat);
  const texture = new THREE.Data3DTexture(halves, SAMPLES, SAMPLES, SAMPLES);
  texture.format = THREE.RedFormat;
  texture.type = THREE.HalfFloatType;
  texture.minFilter = texture.magFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
