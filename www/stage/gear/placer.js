/**
 * Finds room for labels: a label takes the first of its wished places that touches nothing, then
 * the free place nearest to its first wish, and stays away where there is none.
 *
 * @module
 */

/** @typedef {{x: number, y: number, width: number, height: number}} Box */
/** @typedef {readonly {x: number, y: number}[]} Polygon convex, in order */

/** Steps of the search for a free place [px]. */
const STEP = 9;
/** What labels on one line keep between them [px]. */
const APART = 6;

export class Placer {
  /** @type {Box[]} */
  #boxes = [];
  /** @type {Polygon[]} */
  #polygons = [];
  /** @type {{x: number, y: number, radius: number}[]} */
  #circles = [];
  #bounds;

  /** @param {Box} bounds no label leaves them */
  constructor(bounds) {
    this.#bounds = bounds;
  }

  /** @param {Box} box */
  blockBox(box) {
    this.#boxes.push(box);
  }

  /** @param {Polygon} polygon */
  blockPolygon(polygon) {
    this.#polygons.push(polygon);
  }

  /** @param {{x: number, y: number, radius: number}} circle */
  blockCircle(circle) {
    this.#circles.push(circle);
  }

  /**
   * A strip around a line, as an obstacle.
   *
   * @param {{x: number, y: number}} from
   * @param {{x: number, y: number}} to
   * @param {number} half half of its width
   */
  blockLine(from, to, half) {
    const dx = to.x - from.x;
    const dy = to.y - from.y;
    const length = Math.hypot(dx, dy);
    if (length === 0) return;
    const nx = (-dy / length) * half;
    const ny = (dx / length) * half;
    this.#polygons.push([
      { x: from.x + nx, y: from.y + ny },
      { x: to.x + nx, y: to.y + ny },
      { x: to.x - nx, y: to.y - ny },
      { x: from.x - nx, y: from.y - ny },
    ]);
  }

  /**
   * The place of a label, which is an obstacle from then on.
   *
   * @param {number} width
   * @param {number} height
   * @param {readonly {x: number, y: number}[]} wishes top left corners, dearest first
   * @param {number} [farthest] how far from its first wish a label may be put
   * @returns {Box | null}
   */
  place(width, height, wishes, farthest = 150) {
    const wished = wishes.find((at) => this.#isFree(at.x, at.y, width, height));
    const at = wished ?? this.#nearestFree(width, height, wishes[0], farthest);
    if (!at) return null;
    this.#boxes.push({ x: at.x - APART, y: at.y, width: width + 2 * APART, height });
    return { x: at.x, y: at.y, width, height };
  }

  /**
   * @param {number} width
   * @param {number} height
   * @param {{x: number, y: number} | undefined} wish
   * @param {number} farthest
   */
  #nearestFree(width, height, wish, farthest) {
    if (!wish) return null;
    /** @type {{x: number, y: number} | null} */
    let best = null;
    let least = farthest;
    const bounds = this.#bounds;
    const right = bounds.x + bounds.width - width;
    const bottom = bounds.y + bounds.height - height;
    for (let y = bounds.y; y <= bottom; y += STEP) {
      for (let x = bounds.x; x <= right; x += STEP) {
        const distance = Math.hypot(x - wish.x, y - wish.y);
        if (distance < least && this.#isFree(x, y, width, height)) {
          least = distance;
          best = { x, y };
        }
      }
    }
    return best;
  }

  /**
   * @param {number} x
   * @param {number} y
   * @param {number} width
   * @param {number} height
   */
  #isFree(x, y, width, height) {
    const bounds = this.#bounds;
    if (x < bounds.x || x + width > bounds.x + bounds.width) return false;
    if (y < bounds.y || y + height > bounds.y + bounds.height) return false;
    const hitsBox = this.#boxes.some(
      (box) =>
        x < box.x + box.width && box.x < x + width && y < box.y + box.height && box.y < y + height,
    );
    if (hitsBox) return false;
    const hitsCircle = this.#circles.some((circle) => {
      const dx = circle.x - Math.min(Math.max(circle.x, x), x + width);
      const dy = circle.y - Math.min(Math.max(circle.y, y), y + height);
      return dx * dx + dy * dy < circle.radius * circle.radius;
    });
    if (hitsCircle) return false;
    return !this.#polygons.some((polygon) => overlaps(polygon, x, y, width, height));
  }
}

/**
 * Whether a convex polygon and a box share area: they do unless one of their edges' directions
 * separates them.
 *
 * @param {Polygon} polygon
 * @param {number} x
 * @param {number} y
 * @param {number} width
 * @param {number} height
 */
function overlaps(polygon, x, y, width, height) {
  let [minX, maxX, minY, maxY] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const point of polygon) {
    minX = Math.min(minX, point.x);
    maxX = Math.max(maxX, point.x);
    minY = Math.min(minY, point.y);
    maxY = Math.max(maxY, point.y);
  }
  if (maxX <= x || minX >= x + width || maxY <= y || minY >= y + height) return false;
  let previous = polygon[polygon.length - 1];
  for (const point of polygon) {
    const nx = point.y - previous.y;
    const ny = previous.x - point.x;
    let low = Infinity;
    let high = -Infinity;
    for (const corner of polygon) {
      const along = corner.x * nx + corner.y * ny;
      low = Math.min(low, along);
      high = Math.max(high, along);
    }
    const start = x * nx + y * ny;
    const boxLow = start + Math.min(0, width * nx) + Math.min(0, height * ny);
    const boxHigh = start + Math.max(0, width * nx) + Math.max(0, height * ny);
    if (boxHigh <= low || boxLow >= high) return false;
    previous = point;
  }
  return true;
}
