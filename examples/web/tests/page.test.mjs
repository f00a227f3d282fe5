// The page in a browser without a window: what its pixels show is what the reader's rays meet.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import test from "node:test";
import { chromium } from "playwright-core";
import { serve } from "../serve.mjs";

const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
const skip = !existsSync(executablePath) && !process.env.CI && `no browser at ${executablePath}`;
// WebGL without a graphics card.
const args = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

const fields = { "spot.nfd": [0.3, 2.5, 4.4], "octree.nfd": [2.5], "grid.nfd": [2.5] };
for (const [file, angles] of Object.entries(fields)) {
  test(`the field of ${file} hides and is hidden as its surface is`, { skip }, () => look(file, angles));
}

/** At a page with a field, from angles about it. */
async function look(file, angles) {
  const server = await serve(0);
  const browser = await chromium.launch({ executablePath, args });
  try {
    const page = await browser.newPage({ viewport: { width: 240, height: 240 } });
    const problems = [];
    page.on("console", (message) => ["error", "warning"].includes(message.type()) && problems.push(message.text()));
    page.on("pageerror", (error) => problems.push(String(error)));
    await page.goto(`http://127.0.0.1:${server.address().port}/?${file}#still`);
    await page.waitForFunction(() => window.example, undefined, { timeout: 300_000 });
    if (process.env.SCREENSHOT) await page.screenshot({ path: process.env.SCREENSHOT });

    for (const angle of angles) {
      const { rays, hits, alone, among } = await page.evaluate(compare, angle);
      assert.ok(hits > 0.05 * rays && hits < 0.9 * rays, `${hits} of ${rays} rays hit`);
      assert.ok(alone > 0.995 * rays, `from ${angle}, ${alone} of ${rays} pixels show what the rays meet`);
      assert.ok(among > 0.995 * rays, `from ${angle}, ${among} of ${rays} pixels are hidden as they should be`);
    }
    assert.deepEqual(problems.filter((text) => !text.includes("GPU stall")), []);
  } finally {
    await browser.close();
    server.close();
  }
}

/** In the page: every third pixel against the ray through it, alone and with a red wall through the middle. */
function compare(angle) {
  const { THREE, field, scene, meshes, camera, renderer, look } = window.example;
  const { width, height } = renderer.domElement;
  const context = renderer.getContext();
  const pixels = () => {
    renderer.render(scene, camera);
    const bytes = new Uint8Array(width * height * 4);
    context.readPixels(0, 0, width, height, context.RGBA, context.UNSIGNED_BYTE, bytes);
    return (x, y) => bytes.subarray(4 * (y * width + x), 4 * (y * width + x) + 3);
  };

  look(angle);
  meshes.visible = false;
  const alone = pixels();

  // A wall that faces the camera, through the middle of the box.
  const [min, max] = field.bounds.map((corner) => new THREE.Vector3(...corner));
  const middle = min.clone().add(max).multiplyScalar(0.5);
  const wall = new THREE.Mesh(new THREE.PlaneGeometry(10, 10), new THREE.MeshBasicMaterial({ color: 0xff0000 }));
  wall.position.copy(middle);
  wall.quaternion.copy(camera.quaternion);
  scene.add(wall);
  const among = pixels();
  scene.remove(wall);

  const forward = new THREE.Vector3();
  camera.getWorldDirection(forward);
  const toWall = middle.clone().sub(camera.position).dot(forward);
  const count = { rays: 0, hits: 0, alone: 0, among: 0 };
  for (let y = 1; y < height; y += 3) {
    for (let x = 1; x < width; x += 3) {
      const direction = new THREE.Vector3(((x + 0.5) / width) * 2 - 1, ((y + 0.5) / height) * 2 - 1, 0.5)
        .unproject(camera)
        .sub(camera.position)
        .normalize();
      const ray = field.raycast([...camera.position], [...direction]);
      const isHit = ray.kind === "hit";
      const isBefore = isHit && ray.distance * direction.dot(forward) < toWall;
      const isDark = Math.max(...alone(x, y)) === 0;
      const [red, green] = among(x, y);
      const isWall = red === 255 && green === 0;

      count.rays += 1;
      count.hits += isHit;
      count.alone += isHit !== isDark;
      count.among += isBefore !== isWall;
    }
  }
  return count;
}
