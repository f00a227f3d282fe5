// The page: what the user does, and what is told.

const element = (name) => document.getElementById(name);
const canvas = element("picture");
const settings = JSON.parse(element("settings").textContent);
let painter, field, camera;
let drawing = 0, refining = 0;

function tell(sentence) {
  element("message").textContent = sentence;
  element("message").hidden = !sentence;
  if (sentence) element("panel").hidden = false;
}

// As few digits as tell numbers apart.
const short = (number) => Number(number.toPrecision(3)).toString();
const bytesOf = (text) => Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));

function table(name, rows) {
  element(name).replaceChildren(...rows.map((cells, index) => {
    const row = document.createElement("tr");
    row.append(...cells.map((cell) => {
      const made = document.createElement(name === "contract" && index === 0 ? "th" : "td");
      made.textContent = cell;
      return made;
    }));
    return row;
  }));
}

// Shows a field, or says why not and keeps the one before.
function show(bytes, name) {
  try {
    const read = readField(bytes);
    painter.load(bytes, read.family);
    field = read;
  } catch (error) {
    tell(`${name}: ${error.message}`);
    return;
  }
  tell("");
  element("name").textContent = document.title = name;
  const measured = (numbers) => numbers.map((number) => field.samples ? short(number) : "–");
  table("contract", [
    ["error", "RMSE", "99 %", "max"],
    ["uniform", ...measured(field.uniform)],
    ["near surface", ...measured(field.band)],
  ]);
  const share = field.diagonal > 0 ? ` = ${short(100 * field.target / field.diagonal)} % of the diagonal` : "";
  table("facts", [
    ["family", FAMILIES[field.family]],
    ["size", `${field.bytes.length.toLocaleString("en")} bytes`],
    ["target", field.target > 0 ? short(field.target) + share : "none"],
    ["diagonal of the mesh", short(field.diagonal)],
    ["largest seam", field.samples ? short(field.seam) : "–"],
    ["slope at most", short(field.slope)],
    ["doubtful signs", `${field.doubtful} of ${2 * field.samples}`],
    ["sign", field.sign],
    ["baker", field.baker],
  ]);

  const reach = 0.25 * Math.hypot(...add(field.high, field.low, -1));
  Object.assign(element("offset"), { min: -reach, max: reach, value: 0 });
  element("axis").value = "";
  startOver();
}

function startOver() {
  camera = new Camera(settings);
  element("offset").value = settings.offset;
  chooseAxis();
}

function chooseAxis() {
  const axis = element("axis").value;
  element("cut").disabled = axis === "";
  if (axis !== "") {
    const [low, high] = [field.low[axis], field.high[axis]];
    Object.assign(element("cut"), { min: low, max: high, value: 0.5 * (low + high) });
  }
  redraw();
}

const placed = () => camera.place(field.low, field.high, canvas.width, canvas.height);

function draw(antialias) {
  const axis = element("axis").value;
  painter.draw(placed(), {
    offset: Number(element("offset").value),
    cut: axis === "" ? null : { axis: Number(axis), at: Number(element("cut").value) },
    occlusion: element("occlusion").checked,
    shadow: element("shadow").checked,
    normals: element("normals").checked,
    antialias,
  });
}

// Draws at the next frame, and finer when nothing has changed for a moment.
function redraw() {
  if (!field) return;
  element("offset-shown").textContent = short(Number(element("offset").value));
  element("cut-shown").textContent = element("axis").value === "" ? "" : short(Number(element("cut").value));
  document.body.dataset.drawn = "no";
  cancelAnimationFrame(drawing);
  clearTimeout(refining);
  drawing = requestAnimationFrame(() => {
    draw(1);
    refining = setTimeout(() => {
      draw(2);
      painter.gl.finish();
      document.body.dataset.drawn = "yes";
    }, 200);
  });
}

function resize() {
  const ratio = window.devicePixelRatio || 1;
  canvas.width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  canvas.height = Math.max(1, Math.round(canvas.clientHeight * ratio));
  redraw();
}

// Pointers that are down, by their number: fingers, pens, mice.
const pointers = new Map();

function follow(event) {
  const before = pointers.get(event.pointerId);
  if (!before || !field) return;
  const ratio = window.devicePixelRatio || 1;
  const [x, y] = [event.clientX - before.clientX, event.clientY - before.clientY];
  if (pointers.size === 2) {
    const other = [...pointers.values()].find((pointer) => pointer.pointerId !== event.pointerId);
    const apart = (pointer) => Math.hypot(pointer.clientX - other.clientX, pointer.clientY - other.clientY);
    camera.magnify(Math.max(1, apart(event)) / Math.max(1, apart(before)));
    camera.move(0.5 * x * ratio, 0.5 * y * ratio, placed());
  } else if (event.shiftKey || event.buttons & 6) {
    camera.move(x * ratio, y * ratio, placed());
  } else {
    camera.turn(x, y);
  }
  pointers.set(event.pointerId, event);
  redraw();
}

canvas.addEventListener("pointerdown", (event) => {
  canvas.setPointerCapture(event.pointerId);
  pointers.set(event.pointerId, event);
});
canvas.addEventListener("pointermove", follow);
for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
canvas.addEventListener("contextmenu", (event) => event.preventDefault());
canvas.addEventListener("dblclick", () => field && startOver());
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  if (!field) return;
  camera.magnify(Math.exp(-0.0015 * event.deltaY * (event.deltaMode === 1 ? 16 : 1)));
  redraw();
}, { passive: false });
canvas.addEventListener("keydown", (event) => {
  const turns = { ArrowLeft: [-25, 0], ArrowRight: [25, 0], ArrowUp: [0, -25], ArrowDown: [0, 25] };
  const zooms = { "+": 1.2, "=": 1.2, "-": 1 / 1.2 };
  if (!field || !(turns[event.key] || zooms[event.key])) return;
  event.preventDefault();
  if (turns[event.key]) camera.turn(...turns[event.key]);
  else camera.magnify(zooms[event.key]);
  redraw();
});
canvas.addEventListener("webglcontextlost", () => tell("the graphics driver gave up: load the page again"));

for (const name of ["offset", "cut", "occlusion", "shadow", "normals"]) element(name).addEventListener("input", redraw);
element("axis").addEventListener("input", chooseAxis);
element("toggle").addEventListener("click", () => {
  element("panel").hidden = !element("panel").hidden;
  element("toggle").setAttribute("aria-expanded", String(!element("panel").hidden));
});

window.addEventListener("dragover", (event) => {
  event.preventDefault();
  document.body.classList.add("receiving");
});
window.addEventListener("dragleave", () => document.body.classList.remove("receiving"));
window.addEventListener("drop", async (event) => {
  event.preventDefault();
  document.body.classList.remove("receiving");
  const [file] = event.dataTransfer.files;
  if (file) show(new Uint8Array(await file.arrayBuffer()), file.name);
});

try {
  const fragments = { 1: "grid", 2: "octree", 3: "polynomial" };
  for (const family in fragments) fragments[family] = element(`fragment-${fragments[family]}`).textContent;
  painter = new Painter(canvas, element("vertex").textContent, fragments);
  // On a small screen the picture comes first.
  if (window.innerWidth < 600) element("toggle").click();
  show(bytesOf(element("field").textContent), settings.name);
  window.addEventListener("resize", resize);
  resize();
} catch (error) {
  tell(error.message);
}
