// Opens a page of `nearfield view` in Chromium, as `node viewer.mjs PAGE WIDTH HEIGHT FOLDER OTHER.nfd DAMAGED.nfd`, and
// leaves in the folder: first.png, the picture; cut.png and moved.png, after a cut and after a drag; dropped.png, after
// another field has been dropped on it; told.json, what the page said along the way.
import { createRequire } from "node:module";
import { readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { pathToFileURL } from "node:url";

const { chromium } = createRequire(join(process.cwd(), "x.js"))("playwright-core");
const [page_path, width, height, folder, other, damaged] = process.argv.slice(2);

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: [
    "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
  ],
});
const page = await browser.newPage({ viewport: { width: Number(width), height: Number(height) } });
page.setDefaultTimeout(120000);
const complaints = [];
const requests = [];
page.on("console", (message) => complaints.push(message.text()));
page.on("pageerror", (error) => complaints.push(error.message));
page.on("request", (request) => requests.push(request.url()));

const drawn = () => page.waitForSelector("body[data-drawn=yes]");
const shoot = async (name) => {
  await drawn();
  await page.screenshot({ path: join(folder, name) });
};
const drop = (path) => page.evaluate(([base64, name]) => {
  const transfer = new DataTransfer();
  transfer.items.add(new File([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], name));
  document.body.dataset.drawn = "no";
  window.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, cancelable: true }));
}, [readFileSync(path).toString("base64"), basename(path)]);

await page.goto(pathToFileURL(page_path).href);
await drawn();
const panel = await page.textContent("#panel");
await page.addStyleTag({ content: "#toggle, #panel { display: none !important }" });
await shoot("first.png");

await page.selectOption("#axis", "0", { force: true });
await shoot("cut.png");
await page.selectOption("#axis", "", { force: true });
await drawn();

await page.mouse.move(100, 100);
await page.mouse.down();
await page.mouse.move(160, 120, { steps: 3 });
await page.mouse.up();
await shoot("moved.png");

await drop(damaged);
await page.waitForSelector("#message:not([hidden])", { state: "attached" });
const refusal = await page.textContent("#message");
await drop(other);
await page.waitForFunction((name) => document.title === name, basename(other));
await shoot("dropped.png");

writeFileSync(join(folder, "told.json"), JSON.stringify({ panel, refusal, complaints, requests }));
await browser.close();
