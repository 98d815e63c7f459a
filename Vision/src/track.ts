import type { Mat } from '@techstark/opencv-js';
import type { Grey } from './levels';
import { cv } from './opencv';

/** A rectangular patch, in px from the top left corner of the picture. */
export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** Position of the centre of a patch in px, and its correlation; 1 is an exact match. */
export interface Place {
  x: number;
  y: number;
  score: number;
}

/** REACH: search range around the last position, relative to the size of the patch. MIN_REACH: its minimum, px. */
const REACH = 0.75;
const MIN_REACH = 24;

/**
 * Tracks patches of the first picture in the following ones by normalised cross-correlation, with a resolution of less than a pixel. It always
 * compares with the first picture, so that errors do not accumulate.
 */
export class Tracker {
  private readonly patches: { template: Mat; left: number; top: number }[];

  constructor(first: Grey, boxes: Box[]) {
    const picture = matOf(first);
    this.patches = boxes.map(({ x, y, width, height }) => {
      const view = picture.roi(new cv.Rect(x, y, width, height));
      const template = view.clone();
      view.delete();
      return { template, left: x, top: y };
    });
    picture.delete();
  }

  follow(grey: Grey): Place[] {
    const picture = matOf(grey);
    const scores = new cv.Mat();
    try {
      return this.patches.map(patch => {
        const { cols: width, rows: height } = patch.template;
        const reachX = Math.max(MIN_REACH, Math.round(REACH * width));
        const reachY = Math.max(MIN_REACH, Math.round(REACH * height));
        const left = Math.max(0, Math.round(patch.left) - reachX);
        const top = Math.max(0, Math.round(patch.top) - reachY);
        const right = Math.min(grey.width, Math.round(patch.left) + width + reachX);
        const bottom = Math.min(grey.height, Math.round(patch.top) + height + reachY);
        const around = picture.roi(new cv.Rect(left, top, right - left, bottom - top));
        cv.matchTemplate(around, patch.template, scores, cv.TM_CCOEFF_NORMED);
        around.delete();
        const { best, x, y } = peak(scores);
        patch.left = left + x;
        patch.top = top + y;
        return { x: patch.left + width / 2, y: patch.top + height / 2, score: best };
      });
    } finally {
      picture.delete();
      scores.delete();
    }
  }

  delete(): void {
    this.patches.forEach(({ template }) => template.delete());
  }
}

function matOf({ width, height, data }: Grey): Mat {
  const mat = new cv.Mat(height, width, cv.CV_8UC1);
  mat.data.set(data);
  return mat;
}

/** Returns the maximum score and its position, interpolated between pixels with a parabola along each axis. */
function peak(scores: Mat): { best: number; x: number; y: number } {
  const { cols, rows, data32F: data } = scores;
  let at = 0;
  for (let i = 1; i < data.length; i++) if (data[i] > data[at]) at = i;
  const x = at % cols;
  const y = Math.floor(at / cols);
  return {
    best: data[at],
    x: x + (x > 0 && x < cols - 1 ? crest(data[at - 1], data[at], data[at + 1]) : 0),
    y: y + (y > 0 && y < rows - 1 ? crest(data[at - cols], data[at], data[at + cols]) : 0),
  };
}

function crest(before: number, top: number, after: number): number {
  const curvature = before - 2 * top + after;
  return curvature < 0 ? (before - after) / (2 * curvature) : 0;
}
