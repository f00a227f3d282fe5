// A server of this folder, for a browser on this machine: `node serve.mjs`, then open what it prints.
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname } from "node:path";
import { fileURLToPath } from "node:url";

const types = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm" };

/** Resolves with the server once it listens; port 0 is any that is free. */
export function serve(port) {
  const server = createServer(async (request, response) => {
    // A URL's path has no "..": nothing above this folder is served.
    const path = new URL(request.url, "http://localhost").pathname.replace(/\/$/, "/index.html");
    const body = await readFile(new URL(`.${path}`, import.meta.url)).catch(() => undefined);
    const type = types[extname(path)] ?? "application/octet-stream";
    response.writeHead(body === undefined ? 404 : 200, { "content-type": type });
    response.end(body);
  });
  return new Promise((listening) => server.listen(port, "127.0.0.1", () => listening(server)));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const server = await serve(Number(process.env.PORT ?? 8080));
  console.log(`http://127.0.0.1:${server.address().port}/`);
}
