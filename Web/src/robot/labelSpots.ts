/** A label that needs a place: its point in the picture, its width, and the number of the spot that it had in the previous picture. All in px. */
export interface Wanted {
  x: number;
  y: number;
  width: number;
  former: number | null;
}

/** Number of a spot beside the label's point, and the upper left corner of the label there, px. */
export interface Spot {
  number: number;
  left: number;
  top: number;
}

interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** Height of a label, px. */
export const LABEL_HEIGHT = 18;

/** Distance of a label from its point, and half the size of the area around the point that other labels leave free, px. */
const GAP = 9;
const HALF_POINT = 4;

/** Spots from the best to the worst: right or left of the point, and by how many lines lower. Farther away, a label looks as if it belongs to another point. */
const SPOTS = [0, -1, 1, -2, 2].flatMap(lines => [
  { isRight: true, lines },
  { isRight: false, lines },
]);

/**
 * Finds places for labels, in the order of the list, so that no label covers another one. A label covers the point of another one only if all
 * other spots are taken. A label keeps its former spot while this is free, so that it does not jump.
 * @param size Size of the area for labels, px. It begins at the upper left corner of the picture.
 * @param max Maximum number of labels with a place.
 * @returns The spot of each label; null if it has no place.
 */
export function spotsOf(wanted: Wanted[], size: { width: number; height: number }, max: number): (Spot | null)[] {
  const points = wanted.map(({ x, y }) => boxOf(x - HALF_POINT, y - HALF_POINT, 2 * HALF_POINT, 2 * HALF_POINT));
  const taken: Box[] = [];
  return wanted.map((label, own) => {
    let spot: Spot | null = null;
    for (const number of taken.length < max ? inOrder(label.former) : []) {
      const { left, top } = cornerOf(label, number);
      const box = boxOf(left, top, label.width, LABEL_HEIGHT);
      if (left < 0 || top < 0 || box.right > size.width || box.bottom > size.height || taken.some(other => overlap(box, other))) continue;
      const isBest = !points.some((point, i) => i !== own && overlap(box, point));
      if (isBest || !spot) spot = { number, left, top };
      if (isBest) break;
    }
    if (spot) taken.push(boxOf(spot.left, spot.top, label.width, LABEL_HEIGHT));
    return spot;
  });
}

function inOrder(former: number | null): number[] {
  const numbers = SPOTS.map((_, number) => number);
  return former === null ? numbers : [former, ...numbers.filter(number => number !== former)];
}

function cornerOf({ x, y, width }: Wanted, number: number): { left: number; top: number } {
  const { isRight, lines } = SPOTS[number];
  return { left: isRight ? x + GAP : x - GAP - width, top: y + (lines - 0.5) * LABEL_HEIGHT };
}

function boxOf(left: number, top: number, width: number, height: number): Box {
  return { left, top, right: left + width, bottom: top + height };
}

function overlap(a: Box, b: Box): boolean {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}
