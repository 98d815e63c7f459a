// Creates frames as described in Beckhoff's ADS/AMS specification (TE1000, "AMS/TCP" and "ADS commands"). All numbers are little-endian.
export const command = {
  readDeviceInfo: 1, read: 2, write: 3, readState: 4, writeControl: 5,
  addNotification: 6, deleteNotification: 7, notification: 8, readWrite: 9,
};

/** Values of the first two bytes of an AMS/TCP header. The specification defines only 0; the TwinCAT router also uses the other values. */
export const tcpCommand = { ads: 0, closePort: 1, openPort: 0x1000, localNetId: 0x1002 };

export const group = {
  symbolName: 0xf001, handleByName: 0xf003, valueByName: 0xf004, valueByHandle: 0xf005, releaseHandle: 0xf006,
  infoByName: 0xf007, symbolVersion: 0xf008, infoByNameEx: 0xf009, upload: 0xf00b, uploadInfo: 0xf00c,
  typeUpload: 0xf00e, uploadInfo2: 0xf00f, typeByName: 0xf011, sumRead: 0xf080, sumWrite: 0xf081, sumReadWrite: 0xf082,
  sumReadEx: 0xf083, sumReadEx2: 0xf084, deviceData: 0xf100, memory: 0x4040, systemState: 240,
};

export const state = { run: 5, stop: 6, config: 15 };

export const mode = { cyclic: 3, onChange: 4 };

export const error = {
  targetPort: 0x06, targetMachine: 0x07, serviceNotSupported: 0x701, invalidGroup: 0x702, invalidOffset: 0x703,
  invalidAccess: 0x704, invalidSize: 0x705, notReady: 0x707, noMemory: 0x70a, symbolNotFound: 0x710, symbolVersion: 0x711, invalidHandle: 0x714,
};

const response = 0x0005;
const request = 0x0004;

export const netIdBytes = text => Buffer.from(text.split('.').map(Number));
const netIdText = bytes => [...bytes].join('.');

/** Returns a frame: an AMS/TCP header with `kind` (a value of tcpCommand, 2 bytes) and the length of the data (4 bytes), then the data. */
export function tcpFrame(kind, data) {
  const header = Buffer.alloc(6);
  header.writeUInt16LE(kind, 0);
  header.writeUInt32LE(data.length, 2);
  return Buffer.concat([header, data]);
}

/** Returns an AMS header (32 bytes) followed by its data. */
function amsFrame(target, source, id, flags, errorCode, invokeId, data) {
  const header = Buffer.alloc(32);
  netIdBytes(target.netId).copy(header, 0);
  header.writeUInt16LE(target.port, 6);
  netIdBytes(source.netId).copy(header, 8);
  header.writeUInt16LE(source.port, 14);
  header.writeUInt16LE(id, 16);
  header.writeUInt16LE(flags, 18);
  header.writeUInt32LE(data.length, 20);
  header.writeUInt32LE(errorCode, 24);
  header.writeUInt32LE(invokeId, 28);
  return tcpFrame(tcpCommand.ads, Buffer.concat([header, data]));
}

export function parseAms(bytes) {
  return {
    target: { netId: netIdText(bytes.subarray(0, 6)), port: bytes.readUInt16LE(6) },
    source: { netId: netIdText(bytes.subarray(8, 14)), port: bytes.readUInt16LE(14) },
    command: bytes.readUInt16LE(16),
    flags: bytes.readUInt16LE(18),
    error: bytes.readUInt32LE(24),
    invokeId: bytes.readUInt32LE(28),
    data: bytes.subarray(32, 32 + bytes.readUInt32LE(20)),
  };
}

/** Returns the response to a request. Source and target are exchanged; command and invoke id are the same. */
export const answer = (asked, data, errorCode = 0) =>
  amsFrame(asked.source, asked.target, asked.command, response, errorCode, asked.invokeId, data);

export const result = code => words(code);

/** Returns the data of a response to Read or ReadWrite: result, length, data. */
export const readResult = data => Buffer.concat([words(0, data.length), data]);

/** Returns a device notification. `stamps` are times in units of 100 ns since 1601 UTC, each with the samples taken at this time. */
export function notificationFrame(target, source, stamps) {
  const parts = [words(stamps.length)];
  for (const { stamp, samples } of stamps) {
    const time = Buffer.alloc(8);
    time.writeBigUInt64LE(stamp);
    parts.push(time, words(samples.length));
    for (const { handle, data } of samples) parts.push(words(handle, data.length), data);
  }
  const stream = Buffer.concat(parts);
  return amsFrame(target, source, command.notification, request, 0, 0, Buffer.concat([words(stream.length), stream]));
}

export function words(...values) {
  const bytes = Buffer.alloc(4 * values.length);
  values.forEach((value, index) => bytes.writeUInt32LE(value, 4 * index));
  return bytes;
}

/** Extracts complete AMS/TCP frames from a stream of bytes. */
export class FrameReader {
  #bytes = Buffer.alloc(0);

  *read(more) {
    this.#bytes = Buffer.concat([this.#bytes, more]);
    while (this.#bytes.length >= 6) {
      const length = this.#bytes.readUInt32LE(2);
      if (length > 0x10000) throw new Error(`a frame of ${length} bytes`);
      if (this.#bytes.length < 6 + length) return;
      yield { kind: this.#bytes.readUInt16LE(0), data: this.#bytes.subarray(6, 6 + length) };
      this.#bytes = this.#bytes.subarray(6 + length);
    }
  }
}
