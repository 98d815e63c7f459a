/** A grey picture, one byte per pixel, row by row. */
export interface Grey {
  width: number;
  height: number;
  data: Uint8Array;
}

/** What a byte of a picture means as light, 0 to 1: cameras write sRGB. */
export const lightOfByte = Float32Array.from({ length: 256 }, (_, v) => {
  const s = v / 255;
  return s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;
});

/** Light, 0 to 1, at a point between the middles of pixels; NaN outside of the picture. */
export function lightAt({ width, height, data }: Grey, x: number, y: number): number {
  const column = Math.floor(x - 0.5), row = Math.floor(y - 0.5);
  if (!(column >= 0 && row >= 0 && column < width - 1 && row < height - 1)) return NaN;
  const right = x - 0.5 - column, down = y - 0.5 - row, at = row * width + column;
  const above = lightOfByte[data[at]] * (1 - right) + lightOfByte[data[at + 1]] * right;
  const below = lightOfByte[data[at + width]] * (1 - right) + lightOfByte[data[at + width + 1]] * right;
  return above * (1 - down) + below * down;
}
