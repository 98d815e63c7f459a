import { READINGS_AT_ONCE } from '../clock/clockStep';
import type { ClockReading, ReadClock } from '../clock/offeredClock';
import type { Log } from '../log';
import { monotonicTime, type Nanoseconds, NS_PER_MS } from '../times';
import { isGood } from './nodeValues';
import type { ReadOnlySession } from './readOnlySession';
import type { OpcUaSettings } from './kind';
import { ofDate, timeIn } from './stamps';
import { nodeMessages, opcuaMessages } from '../messages/opcua';

/** Node id of Server_ServerStatus_CurrentTime, which every OPC UA server has. */
const CURRENT_TIME = 'ns=0;i=2258';

/** If CurrentTime stands still for at least this duration, the time in the server's responses is used instead, because it is more accurate. */
const STANDS: Nanoseconds = 16n * NS_PER_MS;

/**
 * Maximum difference at which CurrentTime and the time in the responses count as readings of the same clock. Some servers update CurrentTime once per
 * second.
 */
const SAME_CLOCK: Nanoseconds = 3000n * NS_PER_MS;

/**
 * Gets a function that reads the clock from which the time stamps come, which is the server's clock or the time variable, and the maximum number of its
 * simultaneous calls.
 * @param variable Node id of the time variable; null for the server's clock.
 */
export async function clockOf(
  session: ReadOnlySession,
  settings: OpcUaSettings,
  variable: string | null,
  log: Log,
): Promise<{ read: ReadClock; atOnce: number }> {
  const node = variable ?? CURRENT_TIME;
  const ofNode = async (): Promise<ClockReading> => {
    const value = await session.read(node);
    if (!isGood(value.statusCode)) throw new Error(nodeMessages.notReadable(node, value.statusCode.name));
    const time = timeIn(value.value, settings.time?.unit ?? null);
    if (time === null) throw new Error(nodeMessages.noTime(node));
    return { received: time, sent: time };
  };
  if (node !== CURRENT_TIME || !(await stands(session, ofNode))) return { read: ofNode, atOnce: READINGS_AT_ONCE };
  log.change('server clock', 'seldom', opcuaMessages.rareTime);
  const ofHeader = async (): Promise<ClockReading> => {
    await session.read(node);
    const sent = sentAt(session);
    if (sent === null) throw new Error(opcuaMessages.noTimeOfAnswer);
    return { received: sent, sent };
  };
  // The time is that of the newest response, so a second request would change it.
  return { read: ofHeader, atOnce: 1 };
}

/** Whether the server's CurrentTime stands still between updates, and its responses contain the time of the same clock. */
async function stands(session: ReadOnlySession, read: ReadClock): Promise<boolean> {
  const began = monotonicTime();
  const { sent: first } = await read();
  let time = first;
  let stood = 0n;
  while (time === first && monotonicTime() - began < 4n * STANDS) {
    const asked = monotonicTime();
    ({ sent: time } = await read());
    // Counts only responses with the same time. A slow response with a different time does not show a standstill.
    if (time === first) stood = asked - began;
  }
  const answered = sentAt(session);
  // Checks once more after an early change, because the first reading may have been just before an update.
  if (stood < STANDS && !(await stoodNext(read, time))) return false;
  if (answered === null) return false;
  const apart = answered - time;
  return (apart < 0n ? -apart : apart) < SAME_CLOCK;
}

async function stoodNext(read: ReadClock, first: Nanoseconds): Promise<boolean> {
  const began = monotonicTime();
  let time = first;
  while (time === first && monotonicTime() - began < STANDS) ({ sent: time } = await read());
  return time === first;
}

function sentAt(session: ReadOnlySession): Nanoseconds | null {
  const answered = session.answeredAt as (Date & { picoseconds?: number }) | null;
  return ofDate(answered, answered?.picoseconds);
}
