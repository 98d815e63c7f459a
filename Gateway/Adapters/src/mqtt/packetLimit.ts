/** Finds packets of MQTT that are too long while they arrive. In MQTT 3.1.1, a client cannot tell the broker its maximum. */
export class PacketLimit {
  /** Bytes of the present packet that have not arrived yet, without its header. */
  #left = 0;
  /** Bytes of the present header that have arrived; its first byte has the type, the others the length, 7 bits each, the lowest first. */
  #header = 0;

  /** @param most Maximum length of a packet without its header, in bytes. */
  constructor(readonly most: number) {}

  /** Takes the next bytes of the connection. Returns whether the packet that they begin or continue is too long. */
  exceeds(bytes: Uint8Array): boolean {
    for (let at = 0; at < bytes.length;) {
      if (this.#header === 0 && this.#left > 0) {
        const taken = Math.min(this.#left, bytes.length - at);
        this.#left -= taken;
        at += taken;
        continue;
      }

      const byte = bytes[at++];
      if (this.#header > 0) this.#left += (byte & 0x7f) << (7 * (this.#header - 1));
      this.#header = this.#header > 0 && byte < 0x80 ? 0 : this.#header + 1;
      if (this.#left > this.most || this.#header > 5) return true;
    }

    return false;
  }
}
