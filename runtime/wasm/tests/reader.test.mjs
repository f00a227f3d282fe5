// The package in Node, as its users import it: built by `npm run build`.
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import test from "node:test";
import { Field, FieldError, open, openPrefix } from "nearfield";

const vectors = new URL("../../../format-spec/vectors/", import.meta.url);

async function names(folder) {
  const all = await readdir(new URL(folder, vectors));
  return all.filter((name) => name.endsWith(".nfd")).map((name) => folder + name);
}

async function bytesOf(name) {
  return readFile(new URL(name, vectors));
}

async function modulesOfOneFamily() {
  const modules = {};
  for (const family of ["grid", "octree", "polynomial"]) {
    const url = new URL(import.meta.resolve(`nearfield/nearfield-${family}.wasm`));
    modules[family] = await WebAssembly.compile(await readFile(url));
  }
  return modules;
}

/** The files within a file, the field itself first and the coarsest level last, which lies first. */
function levelsOf(bytes) {
  const magic = bytes.subarray(0, 8);
  const starts = [];
  for (let start = 0; start !== -1; start = bytes.indexOf(magic, start + 8)) starts.push(start);
  const files = starts.map((start) => bytes.subarray(start, start + bytes.readUInt32LE(start + 12)));
  return [files[0], ...files.slice(1).reverse()];
}

/** Points in a box and around it. */
function pointsIn([min, max]) {
  return Float32Array.from({ length: 300 }, (_, index) => {
    const axis = index % 3;
    return min[axis] + (((index * 0.618034) % 1.2) - 0.1) * (max[axis] - min[axis]);
  });
}

test("the answers of every vector of the format", async () => {
  const valid = await names("valid/");
  assert.ok(valid.length > 50);
  for (const name of valid) {
    const field = await open(await bytesOf(name));
    const answers = JSON.parse(await readFile(new URL(name.replace(".nfd", ".json"), vectors), "utf8"), beyondJson);
    const points = new Float32Array(answers.flatMap(({ point }) => point));
    const { distances, gradients } = field.distancesAndGradients(points);

    for (const [index, answer] of answers.entries()) {
      const where = `${name} at ${answer.point}`;
      near(distances[index], answer.distance, answer.distance_tolerance, where);
      for (const axis of [0, 1, 2]) {
        near(gradients[index * 3 + axis], answer.gradient[axis], answer.gradient_tolerance, where);
      }

      // Every way to ask gives the same bits.
      const one = field.distanceAndGradient(...answer.point);
      assert.equal(one.distance, distances[index], where);
      assert.deepEqual(one.gradient, [...gradients.subarray(index * 3, index * 3 + 3)], where);
      assert.equal(field.distance(...answer.point), distances[index], where);
    }
    assert.deepEqual(field.distances(points), distances, name);
  }
});

test("a module of one family has the answers of the module of all", async () => {
  const modules = await modulesOfOneFamily();
  const opened = { grid: 0, octree: 0, polynomial: 0 };
  for (const name of await names("valid/")) {
    const bytes = await bytesOf(name);
    const whole = await open(bytes);
    const answers = JSON.parse(await readFile(new URL(name.replace(".nfd", ".json"), vectors), "utf8"), beyondJson);
    const points = new Float32Array(answers.flatMap(({ point }) => point));
    const expected = whole.distancesAndGradients(points);
    let count = 0;
    for (const [family, module] of Object.entries(modules)) {
      const field = await open(bytes, module).catch((error) => assert.match(error.message, /family/, name));
      if (!field) continue;
      assert.deepEqual(field.distancesAndGradients(points), expected, name);
      opened[family] += 1;
      count += 1;
    }
    assert.equal(count, 1, name);
  }
  for (const [family, count] of Object.entries(opened)) assert.ok(count > 10, `${count} of ${family}`);
});

test("invalid vectors are refused for their reason", async () => {
  const manifest = JSON.parse(await readFile(new URL("invalid/manifest.json", vectors), "utf8"));
  const modules = Object.values(await modulesOfOneFamily());
  const invalid = await names("invalid/");
  assert.ok(invalid.length > 50);
  for (const name of invalid) {
    const bytes = await bytesOf(name);
    const rule = manifest[name.slice("invalid/".length, -".nfd".length)];
    await assert.rejects(open(bytes), { name: "FieldError", rule }, name);
    // Another family is a reason too.
    for (const module of modules) {
      await assert.rejects(open(bytes, module), FieldError, name);
    }
  }
  await assert.rejects(open(new TextEncoder().encode("solid cube")), /does not start with the magic number/);
  await assert.rejects(open(new Uint8Array()), FieldError);
});

test("levels of detail are fields, in a module of one family too", async () => {
  const modules = await modulesOfOneFamily();
  for (const [family, levels] of [["polynomial", 3], ["octree", 2], ["grid", 2], ["polynomial_eight", 9]]) {
    const bytes = await bytesOf(`valid/lods_${family}.nfd`);
    for (const module of [undefined, modules[family.split("_")[0]]]) {
      const field = await open(bytes, module);
      assert.equal(field.lodCount, levels, family);
      assert.equal(field.lod(0), field);
      const all = Array.from({ length: levels }, (_, level) => field.lod(level));
      for (const [number, level] of all.entries()) {
        // A level is a whole file within the file: what it says and answers is what that file does.
        const alone = await open(levelsOf(bytes)[number], module);
        const where = `${family}, level ${number}`;
        assert.deepEqual([level.bounds, level.targetError, level.contract], [alone.bounds, alone.targetError, alone.contract], where);
        if (number > 0) assert.ok(level.targetError > all[number - 1].targetError, where);
        const points = pointsIn(field.bounds);
        assert.deepEqual(level.distancesAndGradients(points), alone.distancesAndGradients(points), where);
        assert.deepEqual(level.raycast([-9, 1, 1], [1, 0.1, 0.1]), alone.raycast([-9, 1, 1], [1, 0.1, 0.1]), where);
        assert.equal(level.lodCount, number === 0 ? levels : 1, where);
      }
      for (const missing of [levels, -1, 0.5, NaN, 2 ** 32 + 1]) assert.throws(() => field.lod(missing), RangeError);
    }
  }
});

test("a prefix is its finest whole level", async () => {
  for (const family of ["polynomial", "octree", "grid"]) {
    const bytes = await bytesOf(`valid/lods_${family}.nfd`);
    const levels = levelsOf(bytes);
    const targets = await Promise.all(levels.map(async (level) => (await open(level)).targetError));
    let before = levels.length;
    for (let length = 0; length <= bytes.length; length++) {
      const field = await openPrefix(bytes.subarray(0, length));
      const level = field === undefined ? levels.length : targets.indexOf(field.targetError);
      // The next finer level is there with its last byte, and not before.
      const isWhole = before > 0 && length === levels[before - 1].byteOffset + levels[before - 1].length - bytes.byteOffset;
      assert.equal(level, isWhole ? before - 1 : before, `${length} bytes of ${family}`);
      before = level;
    }
    assert.equal(before, 0, family);
  }
  await assert.rejects(openPrefix(new TextEncoder().encode("solid cube")), { rule: "Magic" });
});

test("modules of one family open whole files alone", async () => {
  const { grid } = await modulesOfOneFamily();
  await assert.rejects(Field.openPrefix(await bytesOf("valid/lods_grid.nfd"), grid), TypeError);
});

test("the header is there", async () => {
  const name = "valid/all_samples_full_f32.nfd";
  const bytes = await bytesOf(name);
  const field = await open(bytes);
  const [min, max] = field.bounds;
  for (const axis of [0, 1, 2]) assert.ok(min[axis] < max[axis]);
  assert.ok(field.lipschitz >= 0 && field.diagonal >= 0 && field.targetError >= 0);
  const { contract } = field;
  assert.ok(contract.sampleCount === 0 ? contract.maxError === Infinity : contract.maxError >= contract.uniform.rmse);
  assert.ok(Number.isInteger(contract.sampleCount) && Number.isInteger(contract.doubtfulSigns));
});

test("many points pass through a small memory", async () => {
  const field = await open(await bytesOf("valid/smallest_cells.nfd"));
  const [min, max] = field.bounds;
  const points = new Float32Array(3 * 100_001);
  for (let index = 0; index < points.length; index++) {
    const axis = index % 3;
    points[index] = min[axis] + ((index * 0.618034) % 1.2) * (max[axis] - min[axis]);
  }
  const distances = field.distances(points);
  assert.equal(distances.length, 100_001);
  for (let index = 0; index < distances.length; index += 997) {
    assert.equal(distances[index], field.distance(...points.subarray(index * 3, index * 3 + 3)));
  }
  const into = new Float32Array(100_001);
  assert.equal(field.distances(points, into), into);
  assert.deepEqual(into, distances);
  assert.throws(() => field.distances(new Float32Array(4)), RangeError);
  assert.equal(field.distances(new Float32Array()).length, 0);
});

test("two fields do not disturb each other", async () => {
  const [first, second] = await Promise.all([bytesOf("valid/smallest_cells.nfd"), bytesOf("valid/all_samples_full_f32.nfd")]);
  const [a, b] = await Promise.all([open(first), open(second)]);
  const before = a.distance(1, 2, 3);
  b.distances(new Float32Array(3000).fill(0.5));
  assert.equal(a.distance(1, 2, 3), before);
});

test("rays and descents stay with the field", async () => {
  for (const name of await names("valid/")) {
    const field = await open(await bytesOf(name));
    const [min, max] = field.bounds;
    const middle = min.map((low, axis) => (low + max[axis]) / 2);
    const end = field.closestPoint(...middle);
    near(field.distance(...end.point), end.residual, 0, name);
    assert.ok(Math.abs(end.residual) <= Math.abs(field.distance(...middle)), name);

    const start = [min[0] - 1, middle[1], middle[2]];
    const ray = field.raycast(start, [2, 0, 0]);
    if (ray.kind !== "hit") continue;
    near(ray.point[0], start[0] + ray.distance, 1e-3 * (max[0] - min[0]) + 1e-6 * Math.abs(max[0]), name);
    assert.equal(field.raycast(start, [2, 0, 0], { length: 0.5 }).kind, "miss", name);
  }
});

test("odd points and rays have documented answers", async () => {
  const field = await open(await bytesOf("valid/smallest_cells.nfd"));
  assert.ok(Number.isNaN(field.distance(NaN, 0, 0)));
  assert.equal(field.distance(Infinity, 0, 0), Infinity);
  assert.ok(Number.isFinite(field.distance(1e30, 0, 0)));
  assert.ok(field.clearance(NaN, 0, 0) <= 0);
  assert.deepEqual(field.raycast([0, 0, 0], [0, 0, 0]), { kind: "miss" });
});

// What JSON has no numbers for.
function beyondJson(_key, value) {
  return { inf: Infinity, "-inf": -Infinity, nan: NaN }[value] ?? value;
}

function near(actual, expected, tolerance, where) {
  const isNear = Object.is(actual, expected) || Math.abs(actual - expected) <= tolerance;
  assert.ok(isNear, `${where}: ${actual} is not within ${tolerance} of ${expected}`);
}
