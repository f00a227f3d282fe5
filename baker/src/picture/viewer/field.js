// What a file says of itself. Places and codes are those of format-spec/SPEC.md.

const FAMILIES = { 1: "grid", 2: "octree", 3: "polynomial octree" };
const SIGNS = ["not from a mesh", "pseudonormals", "winding numbers", "rays", "a sheet, no inside"];
const HEADER = 128;

// Reads the header of a field, after the checks that a shader cannot make. Throws a sentence.
function readField(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const magic = [0x89, 0x4e, 0x46, 0x44, 0x0d, 0x0a, 0x1a, 0x0a];
  if (bytes.length < HEADER || magic.some((byte, at) => bytes[at] !== byte)) throw new Error("not a Nearfield file");
  const [major, minor] = [view.getUint16(8, true), view.getUint16(10, true)];
  if (major !== 1 || minor > 0) throw new Error(`written as version ${major}.${minor}, of which this viewer knows nothing`);
  if (view.getUint32(12, true) !== bytes.length) throw new Error("cut off or followed by something");
  checkSections(bytes, view);
  if (!FAMILIES[bytes[16]]) throw new Error("of a family that this viewer does not know");

  const floats = (at, count) => Array.from({ length: count }, (_, index) => view.getFloat32(at + 4 * index, true));
  const [diagonal, target, slope] = floats(48, 3);
  const [version, samples] = [view.getUint32(120, true), view.getUint32(88, true)];
  return {
    bytes,
    low: floats(24, 3),
    high: floats(36, 3),
    diagonal, target, slope, samples,
    family: bytes[16],
    sign: SIGNS[bytes[17]] ?? "unknown",
    uniform: floats(60, 3),
    band: floats(72, 3),
    seam: view.getFloat32(84, true),
    doubtful: view.getUint32(92, true),
    baker: [version >>> 16, version >>> 8 & 255, version & 255].join("."),
  };
}

// Sums the header and every section, which must tile the file.
function checkSections(bytes, view) {
  const count = bytes[18];
  let end = HEADER + 16 * count;
  if (count > 16 || end > bytes.length) throw new Error("damaged: its section table is cut off");
  const header = bytes.slice(0, end);
  header.fill(0, 20, 24);
  if (sumOf(header) !== view.getUint32(20, true)) throw new Error("damaged: its header has the wrong checksum");
  for (let entry = HEADER; entry < HEADER + 16 * count; entry += 16) {
    const [start, length] = [view.getUint32(entry + 4, true), view.getUint32(entry + 8, true)];
    if (start !== end || start + length > bytes.length) throw new Error("damaged: its sections do not fit together");
    end = start + length;
    const sum = sumOf(bytes.subarray(start, end));
    if (sum !== view.getUint32(entry + 12, true)) throw new Error("damaged: a section has the wrong checksum");
  }
  if (end !== bytes.length) throw new Error("damaged: its sections do not fill it");
}

// CRC-32C.
const SUMS = Uint32Array.from({ length: 256 }, (_, byte) => {
  let sum = byte;
  for (let bit = 0; bit < 8; bit++) sum = sum & 1 ? sum >>> 1 ^ 0x82f63b78 : sum >>> 1;
  return sum;
});

function sumOf(bytes) {
  let sum = ~0;
  for (const byte of bytes) sum = sum >>> 8 ^ SUMS[(sum ^ byte) & 255];
  return ~sum >>> 0;
}
