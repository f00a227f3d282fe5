/** What the module exports, as `src/lib.rs` describes it. Pointers are byte offsets in its memory. */
export interface Exports {
  readonly memory: WebAssembly.Memory;
  readonly __heap_base: WebAssembly.Global;
  field_size(): number;
  open(file: number, length: number, field: number): number;
  /** Not in modules of one family. */
  open_prefix?(file: number, length: number, field: number): number;
  lod(field: number, level: number, lod: number): number;
  describe(field: number, description: number): void;
  distance(field: number, x: number, y: number, z: number): number;
  clearance(field: number, x: number, y: number, z: number): number;
  distances(field: number, points: number, distances: number, count: number): void;
  distances_and_gradients(field: number, points: number, distances: number, gradients: number, count: number): void;
  raycast(field: number, ray: number, hit: number): number;
  closest_point(field: number, x: number, y: number, z: number, end: number): number;
}

/** Bytes for the numbers of one query. */
export const SCRATCH = 256;
/** Points that pass through the memory at a time, so that it stays small however many there are. */
export const BATCH = 16384;

/** Most levels of detail beside the field itself: `MAX_LODS` of the format. */
export const MOST_LEVELS = 8;

const F32 = 4;
const PAGE = 65536;

/** How the memory of one instance is divided: the field and its levels, scratch, a batch of points with its answers, the file. */
export class Memory {
  private readonly fields: number;
  readonly scratch: number;
  readonly points: number;
  readonly distances: number;
  readonly gradients: number;
  readonly file: number;

  constructor(
    private readonly exports: Exports,
    fileLength: number,
  ) {
    let end = align(Number(exports.__heap_base.value));
    const take = (bytes: number): number => {
      const start = end;
      end = align(start + bytes);
      return start;
    };
    this.fields = take((1 + MOST_LEVELS) * exports.field_size());
    this.scratch = take(SCRATCH);
    this.points = take(BATCH * 3 * F32);
    this.distances = take(BATCH * F32);
    this.gradients = take(BATCH * 3 * F32);
    this.file = take(fileLength);

    const missing = end - exports.memory.buffer.byteLength;
    if (missing > 0) exports.memory.grow(Math.ceil(missing / PAGE));
  }

  /** Where the field at a level of detail is. */
  field(level: number): number {
    return this.fields + level * this.exports.field_size();
  }

  /** The memory as numbers from a pointer on. Nothing grows it after the constructor. */
  floats(pointer: number, length: number): Float32Array {
    return new Float32Array(this.exports.memory.buffer, pointer, length);
  }

  bytes(pointer: number, length: number): Uint8Array {
    return new Uint8Array(this.exports.memory.buffer, pointer, length);
  }

  data(pointer: number, length: number): DataView {
    return new DataView(this.exports.memory.buffer, pointer, length);
  }
}

function align(pointer: number): number {
  return Math.ceil(pointer / 16) * 16;
}
