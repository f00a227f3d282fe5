// Spot as a field, among ordinary meshes: a floor, a ring around her, and a box that she stands in.
import { open } from "nearfield";
import * as THREE from "three";
import { familyOf, fieldMesh } from "./field-mesh.js";

async function load(url) {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url} is not there`);
  return new Uint8Array(await response.arrayBuffer());
}

// `npm run bake` makes it. Another may be named: index.html?other.nfd
const bytes = await load(location.search.slice(1) || "spot.nfd");
const field = await open(bytes);
const reader = new TextDecoder().decode(await load(`node_modules/nearfield/dist/nearfield-${familyOf(bytes)}.glsl`));

const toLight = new THREE.Vector3(0.4, 0.7, 0.6);
const scene = new THREE.Scene();
const spot = fieldMesh({ bytes, field, reader, colour: 0xd9c7a8, toLight });
scene.add(spot);

const [min, max] = field.bounds.map((corner) => new THREE.Vector3(...corner));
const middle = min.clone().add(max).multiplyScalar(0.5);
const meshes = new THREE.Group();
const ordinary = (geometry, color) => {
  const mesh = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color }));
  meshes.add(mesh);
  return mesh;
};
ordinary(new THREE.CircleGeometry(2, 64), 0x4b5a6b).rotateX(-Math.PI / 2).position.set(0, -0.75, 0);
ordinary(new THREE.TorusGeometry(0.75, 0.05, 24, 96), 0xc8553d).rotateX(Math.PI / 2.4).position.copy(middle);
ordinary(new THREE.BoxGeometry(0.5, 0.3, 0.5), 0x588157).position.set(0.2, -0.6, 0.2);
scene.add(meshes);

const camera = new THREE.PerspectiveCamera(40, 1, 0.01, 100);
const light = new THREE.DirectionalLight(0xffffff, 2.5);
light.position.copy(toLight);
camera.add(light);
scene.add(camera, new THREE.AmbientLight(0xffffff, 0.8));

const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
document.body.append(renderer.domElement);

function resize() {
  renderer.setSize(innerWidth, innerHeight);
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
}
addEventListener("resize", resize);
resize();

function look(angle) {
  camera.position.set(middle.x + 3 * Math.sin(angle), middle.y + 0.8, middle.z + 3 * Math.cos(angle));
  camera.lookAt(middle);
}

// For the test, which looks at single pixels: the page stands still when its address ends in #still.
window.example = { THREE, field, scene, spot, meshes, camera, renderer, look };
look(2.5);
if (location.hash === "#still") {
  renderer.render(scene, camera);
} else {
  renderer.setAnimationLoop((time) => {
    look(2.5 + time / 4000);
    renderer.render(scene, camera);
  });
}
