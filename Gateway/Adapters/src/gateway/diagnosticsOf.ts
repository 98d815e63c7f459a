import { VERSION } from '../version';
import { DIAGNOSTICS, diagnostics, publication } from './messages';
import type { AdapterStatus } from './status';

/** Maximum length of a message in bytes. The gateway drops a longer one, with the states of all joints, frames and signals. */
const MAX_BYTES = 64 * 1024;

const MAX_REASON = 1000;

/** Factor on the number of entries, for each attempt to make a message shorter. */
const KEPT = 0.9;

/**
 * Creates the diagnostics of an adapter. If they would be too long, shortens the reasons. If only the names would be too long, omits entries, the most
 * important ones last.
 */
export function diagnosticsOf(name: string, status: AdapterStatus, dropped: number): object {
  let [longest, count] = [MAX_REASON, status.size];
  for (;;) {
    const values = { version: VERSION, ...status.values(longest, count), dropped: String(dropped) };
    const message = diagnostics(`plant/${name}`, status.level, status.message, values);
    if (Buffer.byteLength(publication(DIAGNOSTICS, message)) <= MAX_BYTES || count === 0) return message;
    if (longest > 0) longest = Math.floor(longest / 2);
    else count = Math.floor(KEPT * count);
  }
}
