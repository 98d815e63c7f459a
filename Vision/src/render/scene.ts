import { lightOfByte } from '../levels';
import { cv } from '../opencv';
import { randomOf } from './random';

type Mat = InstanceType<typeof cv.Mat>;

/** Takes the bytes of a matrix once, because each access to `data` is a slow call of OpenCV. */
function fill(data: Uint8Array, valueOf: () => number): void {
  for (let i = 0; i < data.length; i++) data[i] = valueOf();
}

/** Renders the scene behind the codes in linear light (32 bit). It resembles a plant hall, with patches, edges, boxes, discs and cables. */
export function sceneOf(seed: number, width: number, height: number): Mat {
  const random = randomOf(seed);
  const between = (a: number, b: number) => a + (b - a) * random();
  const coarse = new cv.Mat(4, 6, cv.CV_8UC1);
  const bytes = new cv.Mat();
  const grain = new cv.Mat((height / 3) | 0, (width / 3) | 0, cv.CV_8UC1);
  const texture = new cv.Mat();
  fill(coarse.data, () => between(25, 190));
  cv.resize(coarse, bytes, new cv.Size(width, height), 0, 0, cv.INTER_CUBIC);
  const grey = () => new cv.Scalar(between(30, 200));
  const point = () => new cv.Point(between(0, width), between(0, height));
  for (let i = 0; i < 9; i++) {
    const at = point();
    const size = new cv.Point(at.x + between(80, 420), at.y + between(80, 400));
    cv.rectangle(bytes, at, size, grey(), cv.FILLED);
  }
  for (let i = 0; i < 4; i++) cv.circle(bytes, point(), between(20, 120), grey(), cv.FILLED);
  for (let i = 0; i < 5; i++) cv.line(bytes, point(), point(), grey(), Math.ceil(between(1, 5)));
  for (let i = 0; i < 3; i++) cv.putText(bytes, 'NOWPOSE 0123', point(), cv.FONT_HERSHEY_SIMPLEX, between(0.5, 2), grey(), Math.ceil(between(1, 3)));
  fill(grain.data, () => between(0, 14));
  cv.resize(grain, texture, bytes.size(), 0, 0, cv.INTER_LINEAR);
  cv.add(bytes, texture, bytes);
  cv.GaussianBlur(bytes, bytes, new cv.Size(3, 3), 0);
  const light = new cv.Mat(height, width, cv.CV_32FC1);
  const out = light.data32F;
  const source = bytes.data;
  for (let i = 0; i < out.length; i++) out[i] = lightOfByte[source[i]];
  for (const made of [coarse, bytes, grain, texture]) made.delete();
  return light;
}
