import { cv } from './opencv';
import { isPlausible, type Point, type Quad } from './geometry';

/** Least side of a code, px, in the picture that is searched: cells of 7 px. */
export const leastSide = 56;
/** Greatest one; larger codes are looked for in a smaller copy of the picture. */
export const greatestSide = 2.4 * leastSide;

/** Lit parts of a code are nowhere wider than two cells: what is wider than this is scene, px. */
const widest = 41;
/** Closes what is between round LEDs, and joins cells that touch at a corner, px; the least also keeps a code from its panel's edge. */
const gaps = [5, 9];
/** Neighbourhood whose mean tells lit from dark: about a code, px. */
const neighbourhood = 111;
/** Brighter than the mean by so much, of 255. */
const least = 6;
/** Also brighter than these: parts a code from brighter or darker things that it touches, of 255. */
const brightnesses = [20, 45, 90];
/** What joins a code to other things is thinner than its cells, px. */
const thinnest = 5;

/** Where codes of `leastSide` to `greatestSide` might be, as quads, clockwise from any corner, in pixels of the picture. */
export function candidatesIn(grey: InstanceType<typeof cv.Mat>): Quad[] {
  const light = new cv.Mat(), closed = new cv.Mat(), wide = square(widest);
  try {
    cv.morphologyEx(grey, light, cv.MORPH_TOPHAT, wide);
    return gaps.flatMap(gap => {
      const narrow = square(gap);
      cv.morphologyEx(light, closed, cv.MORPH_CLOSE, narrow);
      narrow.delete();
      return quadsInLight(closed);
    });
  } finally {
    for (const made of [light, closed, wide]) made.delete();
  }
}

const square = (size: number) => cv.getStructuringElement(cv.MORPH_RECT, new cv.Size(size, size));

function quadsInLight(light: InstanceType<typeof cv.Mat>): Quad[] {
  const binary = new cv.Mat(), thin = square(thinnest);
  cv.adaptiveThreshold(light, binary, 255, cv.ADAPTIVE_THRESH_MEAN_C, cv.THRESH_BINARY, neighbourhood, -least);
  cv.morphologyEx(binary, binary, cv.MORPH_OPEN, thin);
  const quads = quadsIn(binary);
  for (const brightness of brightnesses) {
    cv.threshold(light, binary, brightness, 255, cv.THRESH_BINARY);
    cv.morphologyEx(binary, binary, cv.MORPH_OPEN, thin);
    quads.push(...quadsIn(binary));
  }
  binary.delete();
  thin.delete();
  return quads;
}

function quadsIn(binary: InstanceType<typeof cv.Mat>): Quad[] {
  const contours = new cv.MatVector(), hierarchy = new cv.Mat(), quads: Quad[] = [];
  cv.findContours(binary, contours, hierarchy, cv.RETR_LIST, cv.CHAIN_APPROX_SIMPLE);
  for (let i = 0; i < contours.size(); i++) {
    const contour = contours.get(i);
    quads.push(...quadsOf(contour));
    contour.delete();
  }
  contours.delete();
  hierarchy.delete();
  return quads;
}

function quadsOf(contour: InstanceType<typeof cv.Mat>): Quad[] {
  const box = cv.boundingRect(contour);
  const size = Math.max(box.width, box.height);
  if (size < leastSide || size > 1.5 * greatestSide || Math.min(box.width, box.height) < 0.4 * size) return [];
  const hull = new cv.Mat(), corners = new cv.Mat();
  try {
    cv.convexHull(contour, hull, false, true);
    const around = cv.arcLength(hull, true);
    const quads: Quad[] = [];
    for (const share of [0.03, 0.06, 0.1]) {
      cv.approxPolyDP(hull, corners, share * around, true);
      if (corners.rows !== 4) continue;
      quads.push(clockwise(Array.from({ length: 4 }, (_, i) => [corners.data32S[2 * i] + 0.5, corners.data32S[2 * i + 1] + 0.5])));
      break;
    }
    const upright = cv.minAreaRect(hull);
    quads.push(clockwise(cv.RotatedRect.points(upright).map((p: { x: number; y: number }): Point => [p.x + 0.5, p.y + 0.5])));
    return quads.filter(quad => isPlausible(quad, 0.7 * leastSide));
  } finally {
    hull.delete();
    corners.delete();
  }
}

function clockwise(points: Point[]): Quad {
  let area = 0;
  points.forEach((p, i) => { const q = points[(i + 1) & 3]; area += p[0] * q[1] - q[0] * p[1]; });
  return (area > 0 ? points : points.reverse()) as Quad;
}
