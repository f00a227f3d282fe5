import { BATCH, Memory, type Exports } from "./memory.js";

/** Coordinates in the units and the frame of the mesh. */
export type Vector = readonly [x: number, y: number, z: number];

/** Bytes that are not a sound field. */
export class FieldError extends Error {
  override name = "FieldError";
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
  ) {
    const description = memory.scratch;
    exports.describe(memory.field, description);
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
    const instance = await WebAssembly.instantiate(module);
    const exports = instance.exports as unknown as Exports;
    const memory = new Memory(exports, bytes.length);
    memory.bytes(memory.file, bytes.length).set(bytes);

    const length = exports.open(memory.file, bytes.length, memory.field, memory.scratch);
    if (length !== 0) {
      const message = memory.data(memory.scratch, 4).getUint32(0, true);
      throw new FieldError(new TextDecoder().decode(memory.bytes(message, length)));
    }
    return new Field(exports, memory);
  }

  /** Signed distance at a point: mesh units, negative inside. Finite for every finite point; outside an upper bound. */
  distance(x: number, y: number, z: number): number {
    return this.exports.distance(this.memory.field, x, y, z);
  }

  /** How far a point is at least from the true surface, as far as the contract goes. At most 0 where nothing is known. */
  clearance(x: number, y: number, z: number): number {
    return this.exports.clearance(this.memory.field, x, y, z);
  }

  /** Signed distance at a point, and the slope of the field there. */
  distanceAndGradient(x: number, y: number, z: number): { distance: number; gradient: Vector } {
    const { field, points, distances, gradients } = this.memory;
    this.memory.floats(points, 3).set([x, y, z]);
    this.exports.distances_and_gradients(field, points, distances, gradients, 1);
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
    const { field, points: asked, distances } = this.memory;
    this.inBatches(points, (start, count) => {
      this.exports.distances(field, asked, distances, count);
      into.set(this.memory.floats(distances, count), start);
    });
    return into;
  }

  /** Signed distances at many points, three numbers each, and the slopes of the field there. */
  distancesAndGradients(points: Float32Array): DistancesAndGradients {
    const { field, points: asked, distances, gradients } = this.memory;
    const answers = {
      distances: new Float32Array(pointCount(points)),
      gradients: new Float32Array(points.length),
    };
    this.inBatches(points, (start, count) => {
      this.exports.distances_and_gradients(field, asked, distances, gradients, count);
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
    const { field, scratch } = this.memory;
    this.memory.floats(scratch, 8).set([...origin, ...direction, length, within]);
    const hit = scratch + 8 * 4;
    const kind = this.exports.raycast(field, scratch, hit);
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
    const { field, scratch } = this.memory;
    const residual = this.exports.closest_point(field, x, y, z, scratch);
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
