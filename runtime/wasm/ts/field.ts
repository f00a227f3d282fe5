import { BATCH, Memory, MOST_LEVELS, type Exports } from "./memory.js";
import { RULES } from "./rules.js";

/** Coordinates in the units and the frame of the mesh. */
export type Vector = readonly [x: number, y: number, z: number];

/** The name of a rule that a file must keep, as section 13 of the specification of the format has it. */
export type Rule = keyof typeof RULES;

/** Bytes that are not a sound field. */
export class FieldError extends Error {
  override name = "FieldError";

  constructor(
    /** The rule that they break. */
    readonly rule: Rule,
  ) {
    super(RULES[rule]);
  }
}

/** Errors measured over a set of points, mesh units. */
export interface ErrorStatistics {
  /** Root mean square error. */
  readonly rmse: number;
  /** 99th percentile of the absolute error. */
  readonly p99: number;
  /** Largest absolute error. */
  readonly max: number;
}

/** How wrong the field was found to be when it was baked, mesh units: measurements, not proofs. */
export interface Contract {
  /** Over points spread evenly over the mesh's bounding box. */
  readonly uniform: ErrorStatistics;
  /** Over points within 1 % of the diagonal of the surface. */
  readonly band: ErrorStatistics;
  /** Largest jump of the value across a face between leaves. */
  readonly seamMax: number;
  /** Largest error measured anywhere; infinite when nothing was measured. */
  readonly maxError: number;
  /** Points measured, uniform and again in the band. */
  readonly sampleCount: number;
  /** Measured points whose sign the sign method could not vouch for. */
  readonly doubtfulSigns: number;
}

/** Distances of many points, and the slopes of the field there. */
export interface DistancesAndGradients {
  /** One number a point: mesh units, negative inside. */
  readonly distances: Float32Array;
  /** Three numbers a point; near unit length but not normalized. */
  readonly gradients: Float32Array;
}

/** What became of a ray. */
export type Raycast =
  /** It met the surface. The normal is a unit vector, or zero where the field has none. */
  | { readonly kind: "hit"; readonly distance: number; readonly point: Vector; readonly normal: Vector }
  /** It left the box or ended first. */
  | { readonly kind: "miss" }
  /** It grazed the surface for longer than 512 steps: clear up to here. */
  | { readonly kind: "outOfSteps"; readonly clear: number };

/** A signed distance field. It has a WebAssembly memory of its own, which is collected with it. */
export class Field {
  /** Least and greatest corner of the box in which the field was sampled. */
  readonly bounds: readonly [min: Vector, max: Vector];
  /** Diagonal of the mesh's bounding box, mesh units. */
  readonly diagonal: number;
  /** Error that the baker was asked for, mesh units. */
  readonly targetError: number;
  /** Upper bound of the slope of the field inside its box. */
  readonly lipschitz: number;
  /** How wrong the field was found to be when it was baked. */
  readonly contract: Contract;

  private constructor(
    private readonly exports: Exports,
    private readonly memory: Memory,
    private readonly pointer: number,
  ) {
    const description = memory.scratch;
    exports.describe(pointer, description);
    const numbers = [...memory.floats(description, 17)];
    const counts = memory.data(description + 17 * 4, 8);
    const number = (index: number): number => numbers[index]!;
    const statistics = (index: number): ErrorStatistics => ({
      rmse: number(index),
      p99: number(index + 1),
      max: number(index + 2),
    });

    this.bounds = [vector(numbers, 0), vector(numbers, 3)];
    this.diagonal = number(6);
    this.targetError = number(7);
    this.lipschitz = number(8);
    this.contract = {
      uniform: statistics(9),
      band: statistics(12),
      seamMax: number(15),
      maxError: number(16),
      sampleCount: counts.getUint32(0, true),
      doubtfulSigns: counts.getUint32(4, true),
    };
  }

  /**
   * Opens a field after copying and checking every byte of its file.
   *
   * @throws FieldError when they are not a sound field.
   */
  static async open(bytes: Uint8Array, module: WebAssembly.Module): Promise<Field> {
    return Field.openBy("open", bytes, module);
  }

  /**
   * Opens the finest level of detail that is whole in the first bytes of a file, or the field itself once these are all its
   * bytes: what can be asked while the rest still arrives. Undefined while there is none yet.
   *
   * @param module the module that reads every family
   * @throws FieldError when they cannot become a sound field.
   */
  static async openPrefix(bytes: Uint8Array, module: WebAssembly.Module): Promise<Field | undefined> {
    try {
      return await Field.openBy("open_prefix", bytes, module);
    } catch (error) {
      if (error instanceof FieldError && error.rule === "Truncated") return undefined;
      throw error;
    }
  }

  private static async openBy(way: "open" | "open_prefix", bytes: Uint8Array, module: WebAssembly.Module): Promise<Field> {
    const instance = await WebAssembly.instantiate(module);
    const exports = instance.exports as unknown as Exports;
    const open = exports[way];
    if (open === undefined) throw new TypeError("a module of one family opens whole files alone");
    const memory = new Memory(exports, bytes.length);
    memory.bytes(memory.file, bytes.length).set(bytes);

    const broken = open(memory.file, bytes.length, memory.field(0));
    if (broken !== 0) throw new FieldError((Object.keys(RULES) as Rule[])[broken - 1]!);
    return new Field(exports, memory, memory.field(0));
  }

  /** How many levels of detail there are, the field itself among them: at least 1. */
  get lodCount(): number {
    let count = 1;
    while (this.hasLevel(count)) count += 1;
    return count;
  }

  /**
   * The field at a level of detail: 0 is the field itself, 1 the next coarser, and so on. It is a field of its own in the
   * same memory, with its own box and contract.
   *
   * @throws RangeError when there is no such level.
   */
  lod(level: number): Field {
    if (level === 0) return this;
    if (!this.hasLevel(level)) throw new RangeError(`there are the levels 0 to ${this.lodCount - 1}, and not ${level}`);
    return new Field(this.exports, this.memory, this.memory.field(level));
  }

  /** Puts a level where it belongs in the memory, if there is one. */
  private hasLevel(level: number): boolean {
    const exists = Number.isInteger(level) && level > 0 && level <= MOST_LEVELS;
    return exists && this.exports.lod(this.pointer, level, this.memory.field(level)) !== 0;
  }

  /** Signed distance at a point: mesh units, negative inside. Finite for every finite point; outside an upper bound. */
  distance(x: number, y: number, z: number): number {
    return this.exports.distance(this.pointer, x, y, z);
  }

  /** How far a point is at least from the true surface, as far as the contract goes. At most 0 where nothing is known. */
  clearance(x: number, y: number, z: number): number {
    return this.exports.clearance(this.pointer, x, y, z);
  }

  /** Signed distance at a point, and the slope of the field there. */
  distanceAndGradient(x: number, y: number, z: number): { distance: number; gradient: Vector } {
    const { points, distances, gradients } = this.memory;
    this.memory.floats(points, 3).set([x, y, z]);
    this.exports.distances_and_gradients(this.pointer, points, distances, gradients, 1);
    const [distance] = this.memory.floats(distances, 1);
    return { distance: distance!, gradient: vector(this.memory.floats(gradients, 3), 0) };
  }

  /**
   * Signed distances at many points.
   *
   * @param points three numbers a point
   * @param into where the distances go, one number a point; a new array by default
   */
  distances(points: Float32Array, into = new Float32Array(pointCount(points))): Float32Array {
    const { points: asked, distances } = this.memory;
    this.inBatches(points, (start, count) => {
      this.exports.distances(this.pointer, asked, distances, count);
      into.set(this.memory.floats(distances, count), start);
    });
    return into;
  }

  /** Signed distances at many points, three numbers each, and the slopes of the field there. */
  distancesAndGradients(points: Float32Array): DistancesAndGradients {
    const { points: asked, distances, gradients } = this.memory;
    const answers = {
      distances: new Float32Array(pointCount(points)),
      gradients: new Float32Array(points.length),
    };
    this.inBatches(points, (start, count) => {
      this.exports.distances_and_gradients(this.pointer, asked, distances, gradients, count);
      answers.distances.set(this.memory.floats(distances, count), start);
      answers.gradients.set(this.memory.floats(gradients, count * 3), start * 3);
    });
    return answers;
  }

  /**
   * Follows a ray to the surface by sphere tracing, inside the box of the field.
   *
   * The direction needs no unit length. The ray stops where the field is at most `within`: with `contract.maxError`
   * before the true surface, with 0 on the field's.
   */
  raycast(origin: Vector, direction: Vector, { length = Infinity, within = 0 } = {}): Raycast {
    const { scratch } = this.memory;
    this.memory.floats(scratch, 8).set([...origin, ...direction, length, within]);
    const hit = scratch + 8 * 4;
    const kind = this.exports.raycast(this.pointer, scratch, hit);
    const numbers = this.memory.floats(hit, 7);
    const distance = numbers[0]!;
    if (kind === 0) return { kind: "miss" };
    if (kind === 2) return { kind: "outOfSteps", clear: distance };
    return { kind: "hit", distance, point: vector(numbers, 1), normal: vector(numbers, 4) };
  }

  /**
   * Goes down the gradient to the surface: where it ends, and the field there.
   *
   * The end is no farther from the surface than the start; that it is the closest point is not promised.
   */
  closestPoint(x: number, y: number, z: number): { point: Vector; residual: number } {
    const { scratch } = this.memory;
    const residual = this.exports.closest_point(this.pointer, x, y, z, scratch);
    return { point: vector(this.memory.floats(scratch, 3), 0), residual };
  }

  private inBatches(points: Float32Array, answer: (start: number, count: number) => void): void {
    const total = pointCount(points);
    for (let start = 0; start < total; start += BATCH) {
      const count = Math.min(BATCH, total - start);
      this.memory.floats(this.memory.points, count * 3).set(points.subarray(start * 3, (start + count) * 3));
      answer(start, count);
    }
  }
}

function pointCount(points: Float32Array): number {
  if (points.length % 3 !== 0) throw new RangeError(`points are three numbers each, and ${points.length} is not a multiple`);
  return points.length / 3;
}

function vector(numbers: ArrayLike<number>, index: number): Vector {
  return [numbers[index]!, numbers[index + 1]!, numbers[index + 2]!];
}
