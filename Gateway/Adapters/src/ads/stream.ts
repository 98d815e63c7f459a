import { adsMessages } from '../messages/ads';

/** The values of a device's variables at one time. */
export interface StampedSamples {
  /** Time in 100 ns since 1601 UTC, as written by the device. */
  stamp: bigint;
  samples: { handle: number; data: Buffer }[];
}

/**
 * Parses the notifications of an ADS frame. ads-client reduces their stamps to ms; here the 100 ns are kept.
 * @throws RangeError The data are shorter than their length fields.
 */
export function parseStream(data: Buffer): StampedSamples[] {
  const stamps: StampedSamples[] = [];
  let at = 8;
  for (let s = data.readUInt32LE(4); s > 0; s--) {
    const stamp = data.readBigUInt64LE(at);
    const samples: StampedSamples['samples'] = [];
    let count = data.readUInt32LE(at + 8);
    for (at += 12; count > 0; count--) {
      const handle = data.readUInt32LE(at);
      const length = data.readUInt32LE(at + 4);
      if (at + 8 + length > data.length) throw new RangeError(adsMessages.sampleTooLarge(length, data.length));
      samples.push({ handle, data: data.subarray(at + 8, at + 8 + length) });
      at += 8 + length;
    }
    stamps.push({ stamp, samples });
  }
  return stamps;
}
