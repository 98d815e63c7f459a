import { cv } from './opencv';
import { coarser, matrixOf, type Edges } from './edges';
import { isPlausible, type Quad } from './geometry';

type Mat = InstanceType<typeof cv.Mat>;

/** Minimum side of a code, px. A cell then has 7 px. */
export const minSide = 56;

/**
 * Maximum gaps between edges within a code, in blocks of edges. Each value is the width of two cells of a code of a certain size. Together, the values
 * cover the sizes of codes up to twice the minimum. Larger codes are searched for in the same way with blocks of twice the size.
 */
const gaps = [4, 5, 6, 7];
/** Maximum width of an area with edges that is taken for an edge or a cable in the scene instead of a code, as a multiple of the gap. */
const narrow = 1.3;
/** Thresholds for the brightness change at an edge, 0 to 255. They cover faint holograms in front of a bright scene and LEDs in bright light. */
const steps = [6, 8, 10, 13, 16, 20, 26, 34];

/**
 * Returns quads around areas with many edges, which can be codes. The corners are in px and clockwise, starting at any corner. The scene behind a
 * hologram adds edges but never removes them, so holograms are also found in front of structured scenes.
 */
export function candidatesIn(edges: Edges): Quad[] {
  const areas = new cv.Mat();
  const binary = new cv.Mat();
  const quads: Quad[] = [];
  for (const seen of [edges, coarser(edges)]) {
    const matrix = matrixOf(seen);
    for (const gap of gaps) {
      // Closing and opening commute with the threshold, so each is computed only once per gap.
      const within = square(gap);
      const across = square(Math.round(narrow * gap));
      cv.morphologyEx(matrix, areas, cv.MORPH_CLOSE, within);
      cv.morphologyEx(areas, areas, cv.MORPH_OPEN, across);
      for (const step of steps) {
        cv.threshold(areas, binary, step, 255, cv.THRESH_BINARY);
        quads.push(...quadsIn(binary, seen.block));
      }
      for (const made of [within, across]) made.delete();
    }
    matrix.delete();
  }
  for (const made of [areas, binary]) made.delete();
  return quads;
}

const square = (size: number) => cv.getStructuringElement(cv.MORPH_RECT, new cv.Size(size, size));

/** @param block Size of the blocks, px. */
function quadsIn(binary: Mat, block: number): Quad[] {
  const contours = new cv.MatVector();
  const [hierarchy, hull, corners] = [new cv.Mat(), new cv.Mat(), new cv.Mat()];
  const quads: Quad[] = [];
  cv.findContours(binary, contours, hierarchy, cv.RETR_LIST, cv.CHAIN_APPROX_SIMPLE);
  for (let i = 0; i < contours.size(); i++) {
    const contour = contours.get(i);
    quads.push(...quadsOf(contour, block, hull, corners));
    contour.delete();
  }
  for (const made of [contours, hierarchy, hull, corners]) made.delete();
  return quads;
}

/** @param hull Receives the hull of the contour, as `corners` receives the corners. All contours of a picture use the same two matrices. */
function quadsOf(contour: Mat, block: number, hull: Mat, corners: Mat): Quad[] {
  const { width, height } = cv.boundingRect(contour);
  const size = Math.max(width, height);
  if (size * block < 0.8 * minSide || Math.min(width, height) < 0.4 * size) return [];
  cv.convexHull(contour, hull, false, true);
  const around = cv.arcLength(hull, true);
  const quads: Quad[] = [];
  for (const share of [0.03, 0.06, 0.1]) {
    cv.approxPolyDP(hull, corners, share * around, true);
    if (corners.rows !== 4) continue;
    const at = corners.data32S;
    quads.push(
      clockwise(
        Array.from({ length: 8 }, (_, i) => at[i]),
        block,
      ),
    );
    break;
  }
  quads.push(
    clockwise(
      cv.RotatedRect.points(cv.minAreaRect(hull)).flatMap(({ x, y }: { x: number; y: number }) => [x, y]),
      block,
    ),
  );
  return quads.filter(quad => isPlausible(quad, 0.7 * minSide));
}

/** Converts corners in blocks to clockwise corners in px. */
function clockwise(corners: number[], block: number): Quad {
  const [x0, y0, x1, y1, x2, y2, x3, y3] = corners.map(at => (at + 0.5) * block);
  const area = x0 * y1 - y0 * x1 + (x1 * y2 - y1 * x2) + (x2 * y3 - y2 * x3) + (x3 * y0 - y3 * x0);
  return area > 0 ? [x0, y0, x1, y1, x2, y2, x3, y3] : [x3, y3, x2, y2, x1, y1, x0, y0];
}
