import type { Corners } from '../geometry';
import { cv } from '../opencv';

type Mat = InstanceType<typeof cv.Mat>;

/** A code to render. */
export interface DrawnCode {
  corners: Corners;
  /** Share of the exposure in which each cell is lit, 0 to 1. */
  lit: number[];
  /** Light of a lit cell; 1 is white, and more is overexposed. */
  light: number;
  /** Red, green and blue part of the light; absent or null for white light. */
  colour?: number[] | null;
  /** Diameter of round LEDs relative to a cell; 0 for complete squares. */
  dot: number;
  /** Light of the panel behind the cells; null for a hologram, which only adds light to the scene behind it. */
  panel: number | null;
}

/** Number of pixels per side of a cell before the perspective projection. */
const pixels = 16;

export function addCode(scene: Mat, code: DrawnCode): void {
  const side = Math.sqrt(code.lit.length);
  const size = (side + 2) * pixels;
  const [x, y, width, height] = boundsOf(code.corners, scene.cols, scene.rows);
  if (width < 1 || height < 1) return;
  const from = cv.matFromArray(4, 1, cv.CV_32FC2, [pixels, pixels, size - pixels, pixels, size - pixels, size - pixels, pixels, size - pixels]);
  const to = cv.matFromArray(
    4,
    1,
    cv.CV_32FC2,
    code.corners.flatMap(p => [p[0] - x, p[1] - y]),
  );
  const perspective = cv.getPerspectiveTransform(from, to);
  const region = scene.roi(new cv.Rect(x, y, width, height));
  const seen = new cv.Mat();
  const warp = (tile: Mat) =>
    cv.warpPerspective(tile, seen, perspective, new cv.Size(width, height), cv.INTER_LINEAR, cv.BORDER_CONSTANT, new cv.Scalar(0));
  if (code.panel !== null) {
    const cover = new cv.Mat(size, size, cv.CV_32FC1, new cv.Scalar(0));
    const inside = cover.roi(new cv.Rect(pixels / 2, pixels / 2, size - pixels, size - pixels));
    inside.setTo(new cv.Scalar(1));
    warp(cover);
    const kept = new cv.Mat();
    cv.multiply(region, seen, kept, code.panel - 1);
    // Computes region − region·cover·(1 − panel), because the panel reflects only a part of the ambient light.
    cv.add(region, kept, region);
    for (const made of [inside, cover, kept]) made.delete();
  }
  const tile = tileOf(code, side, size);
  warp(tile);
  cv.add(region, seen, region);
  for (const made of [from, to, perspective, region, seen, tile]) made.delete();
}

function tileOf({ lit, light, dot }: DrawnCode, side: number, size: number): Mat {
  const tile = new cv.Mat(size, size, cv.CV_32FC1, new cv.Scalar(0));
  const data = tile.data32F;
  const radius = (dot * pixels) / 2;
  for (let cell = 0; cell < lit.length; cell++) {
    const left = ((cell % side) + 1) * pixels;
    const top = (Math.floor(cell / side) + 1) * pixels;
    for (let j = 0; j < pixels; j++)
      for (let i = 0; i < pixels; i++)
        if (dot === 0 || Math.hypot(i + 0.5 - pixels / 2, j + 0.5 - pixels / 2) <= radius) data[(top + j) * size + left + i] = lit[cell] * light;
  }
  return tile;
}

function boundsOf(corners: Corners, width: number, height: number): [number, number, number, number] {
  const xs = corners.map(p => p[0]);
  const ys = corners.map(p => p[1]);
  const margin = 0.15 * Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys));
  const left = Math.max(0, Math.floor(Math.min(...xs) - margin));
  const top = Math.max(0, Math.floor(Math.min(...ys) - margin));
  const right = Math.min(width, Math.ceil(Math.max(...xs) + margin));
  const bottom = Math.min(height, Math.ceil(Math.max(...ys) + margin));
  return [left, top, right - left, bottom - top];
}
