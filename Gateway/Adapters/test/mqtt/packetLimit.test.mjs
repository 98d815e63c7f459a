// Tests the limit for the length of MQTT packets.
import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { parts } from '../parts.mjs';

const { PacketLimit } = await parts('mqtt/packetLimit');

/** A packet of type 3 (a publication) with this number of bytes after its header. */
function packet(length) {
  const header = [0x30];
  let rest = length;
  do {
    header.push((rest & 0x7f) | (rest > 0x7f ? 0x80 : 0));
    rest >>= 7;
  } while (rest > 0);
  return Buffer.concat([Buffer.from(header), Buffer.alloc(length, 0xff)]);
}

describe('packet limit', () => {
  for (const size of [1, 2, 3, 7, 1000, 100_000])
    it(`Exceeds_PacketsUpToTheLimitInPartsOf${size}_IsFalse`, () => {
      const limit = new PacketLimit(20_000), all = Buffer.concat([0, 1, 127, 128, 16_383, 16_384, 20_000, 0, 5].map(packet));

      for (let at = 0; at < all.length; at += size) assert.equal(limit.exceeds(all.subarray(at, at + size)), false, `at ${at}`);
    });

  it('Exceeds_HeaderOfALongerPacket_IsTrueBeforeItsContentArrives', () => {
    assert.equal(new PacketLimit(20_000).exceeds(packet(20_001).subarray(0, 4)), true);
  });

  it('Exceeds_HeaderWithoutEnd_IsTrue', () => {
    assert.equal(new PacketLimit(20_000).exceeds(Buffer.of(0x30, 0x80, 0x80, 0x80, 0x80, 0x80)), true);
  });
});
