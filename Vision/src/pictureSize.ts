/** Of the phones' cameras: a picture has four bytes a pixel when it is read, and there are several workers. */
const mostMegapixels = 110;

/** Throws when a PNG or JPEG file says that it is too large to be read, or ends before it says how large it is. */
export function checkSize(bytes: Buffer): void {
  const [width, height] = isPng(bytes) ? pngSize(bytes) : jpegSize(bytes);
  if (width * height > mostMegapixels * 1e6) throw new Error(`${width}x${height} pixels are too many; at most ${mostMegapixels} megapixels are read`);
}

export const isPng = (bytes: Buffer) => bytes.subarray(0, 4).equals(Buffer.from([0x89, 0x50, 0x4e, 0x47]));

export const isJpeg = (bytes: Buffer) => bytes[0] === 0xff && bytes[1] === 0xd8;

function pngSize(bytes: Buffer): [number, number] {
  // Signature, then length and name of the first chunk.
  if (bytes.length < 24) throw cutOff();
  return [bytes.readUInt32BE(16), bytes.readUInt32BE(20)];
}

/** From one marker to the next, up to that of a frame. */
function jpegSize(bytes: Buffer): [number, number] {
  for (let at = 2; at + 9 <= bytes.length;) {
    const marker = bytes[at + 1];
    if (bytes[at] !== 0xff) throw new Error('the picture is damaged');
    if (marker === 0xff) at++;
    else if (isFrame(marker)) return [bytes.readUInt16BE(at + 7), bytes.readUInt16BE(at + 5)];
    else at += 2 + bytes.readUInt16BE(at + 2);
  }
  throw cutOff();
}

/** C4, C8 and CC among them are tables. */
const isFrame = (marker: number) => marker >= 0xc0 && marker <= 0xcf && marker % 4 !== 0 || marker === 0xc0;

const cutOff = () => new Error('the file is cut off');
