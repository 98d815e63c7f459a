// Creates RTDE packages as described in UR's guide (size, type and payload, big-endian) without the code of the adapter.

export function packageOf(type, ...parts) {
  const payload = Buffer.concat(parts.map(part => typeof part === 'string' ? Buffer.from(part, 'ascii') : part));
  const header = Buffer.alloc(3);
  header.writeUInt16BE(3 + payload.length, 0);
  header.write(type, 2, 'ascii');
  return Buffer.concat([header, payload]);
}

export const byte = value => Buffer.from([value]);

export function int(value) {
  const bytes = Buffer.alloc(4);
  bytes.writeInt32BE(value);
  return bytes;
}

export function doubles(...values) {
  const bytes = Buffer.alloc(8 * values.length);
  values.forEach((value, i) => bytes.writeDoubleBE(value, 8 * i));
  return bytes;
}
