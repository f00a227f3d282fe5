// The package in a browser without a window: the same bits as in Node.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname } from "node:path";
import test from "node:test";
import { open } from "nearfield";
import { chromium } from "playwright-core";

const root = new URL("../../../", import.meta.url);
const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
const types = { ".js": "text/javascript", ".wasm": "application/wasm", ".html": "text/html" };

/** Serves the repository, and an empty page at its root. */
async function serve() {
  const server = createServer(async (request, response) => {
    const path = new URL(request.url, "http://localhost").pathname.slice(1);
    const body = path === "" ? "<!doctype html><title>empty</title>" : await readFile(new URL(path, root)).catch(() => undefined);
    response.writeHead(body === undefined ? 404 : 200, { "content-type": types[extname(path) || ".html"] ?? "application/octet-stream" });
    response.end(body);
  });
  await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
  return server;
}

test("a browser gives the same bits", { skip: !existsSync(executablePath) && !process.env.CI && `no browser at ${executablePath}` }, async () => {
  const server = await serve();
  const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-gpu"] });
  try {
    const page = await browser.newPage();
    await page.goto(`http://127.0.0.1:${server.address().port}/`);
    for (const name of ["smallest_cells", "all_samples_full_f16", "grid_smallest_spacing"]) {
      const path = `format-spec/vectors/valid/${name}.nfd`;
      const answers = JSON.parse(await readFile(new URL(path.replace(".nfd", ".json"), root), "utf8"));
      const points = answers.map(({ point }) => point.map(Number)).filter((point) => point.every(Number.isFinite));

      const there = await page.evaluate(
        async ([path, points]) => {
          const { open } = await import("/runtime/wasm/dist/web.js");
          const bytes = new Uint8Array(await (await fetch(path)).arrayBuffer());
          const field = await open(bytes);
          const { distances, gradients } = field.distancesAndGradients(new Float32Array(points.flat()));
          const ray = field.raycast([-1, 0.1, 0.1], [1, 0, 0]);
          return { distances: [...distances], gradients: [...gradients], bounds: field.bounds, ray };
        },
        [`/${path}`, points],
      );

      const field = await open(await readFile(new URL(path, root)));
      const here = field.distancesAndGradients(new Float32Array(points.flat()));
      assert.deepEqual(there.distances, [...here.distances], name);
      assert.deepEqual(there.gradients, [...here.gradients], name);
      assert.deepEqual(there.bounds, field.bounds, name);
      assert.deepEqual(there.ray, field.raycast([-1, 0.1, 0.1], [1, 0, 0]), name);
    }

    const message = await page.evaluate(async () => {
      const { open } = await import("/runtime/wasm/dist/web.js");
      return open(new Uint8Array(8)).catch((error) => `${error.name}: ${error.message}`);
    });
    assert.match(message, /^FieldError: .*magic number/);
  } finally {
    await browser.close();
    server.close();
  }
});
