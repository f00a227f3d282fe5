// A perspective camera that orbits a field's box, in the terms of `nearfield render`.

const FIELD_OF_VIEW = 30;

const add = (a, b, factor = 1) => a.map((part, axis) => part + factor * b[axis]);
const scale = (a, factor) => a.map((part) => part * factor);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const radians = (degrees) => degrees * Math.PI / 180;

class Camera {
  constructor({ azimuth, elevation, zoom, up }) {
    Object.assign(this, { azimuth, elevation, zoom, up, pan: [0, 0, 0] });
  }

  // The camera in its place around a box, for a picture of this size.
  place(low, high, width, height) {
    const worldUp = this.up === "z" ? [0, 0, 1] : [0, 1, 0];
    const ahead = this.up === "z" ? [0, -1, 0] : [0, 0, 1];
    const aside = [1, 0, 0];
    const [sine, cosine] = [Math.sin(radians(this.azimuth)), Math.cos(radians(this.azimuth))];
    const around = add(scale(ahead, cosine), aside, sine);
    const from = add(scale(around, Math.cos(radians(this.elevation))), worldUp, Math.sin(radians(this.elevation)));

    // Far enough for the sphere around the box to touch the edges of the picture.
    const size = Math.hypot(...add(high, low, -1));
    const half = radians(0.5 * FIELD_OF_VIEW);
    const centre = add(scale(add(low, high), 0.5), this.pan);
    const right = add(scale(aside, cosine), ahead, -sine);
    const halfHeight = Math.tan(half) / this.zoom;
    const pixel = 2 * halfHeight / Math.min(width, height);
    return {
      eye: add(centre, from, 0.5 * size / Math.sin(half)),
      forward: scale(from, -1),
      right,
      up: cross(from, right),
      pixel,
      size,
      halfWidth: 0.5 * pixel * width,
      halfHeight: 0.5 * pixel * height,
      // Width of a pixel in the middle of the box.
      reach: 0.5 * size / Math.sin(half) * pixel,
    };
  }

  turn(x, y) {
    this.azimuth -= 0.4 * x;
    this.elevation = Math.min(90, Math.max(-90, this.elevation + 0.4 * y));
  }

  // By pixels of a placed camera.
  move(x, y, placed) {
    this.pan = add(add(this.pan, placed.right, -x * placed.reach), placed.up, y * placed.reach);
  }

  magnify(factor) {
    this.zoom = Math.min(1000, Math.max(0.2, this.zoom * factor));
  }
}
