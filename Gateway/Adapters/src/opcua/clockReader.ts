import type { ClockReading, ReadClock } from '../clock/plantClock';
import type { Log } from '../log';
import { monotonicTime, type Nanoseconds, NS_PER_MS } from '../times';
import { isGood } from './nodeValues';
import type { ReadOnlySession } from './readOnlySession';
import type { OpcUaSettings } from './settings';
import { ofDate, timeIn } from './stamps';
import { clockMessages } from '../messages/gateway';
import { nodeMessages, opcuaMessages } from '../messages/opcua';

/** Server_ServerStatus_CurrentTime, which every OPC UA server has. */
const CURRENT_TIME = 'ns=0;i=2258';

/** A clock that stands still for longer than this is less accurate than the time of the answers. */
const STANDS: Nanoseconds = 16n * NS_PER_MS;

/** Maximum difference at which CurrentTime and the time of the answers count as one clock. Some servers write CurrentTime once a second. */
const SAME_CLOCK: Nanoseconds = 3000n * NS_PER_MS;

/**
 * Reads the clock of the stamps: the server's own, or the variable with t_k.
 * @param variable Its id at this server; null for the server's own clock.
 */
export async function clockOf(session: ReadOnlySession, settings: OpcUaSettings, variable: string | null, log: Log): Promise<ReadClock> {
  const node = variable ?? CURRENT_TIME;
  const ofNode = async (): Promise<ClockReading> => {
    const value = await session.read(node);
    if (!isGood(value.statusCode)) throw new Error(nodeMessages.notReadable(node, value.statusCode.name));
    const time = timeIn(value.value, settings.time?.unit ?? null);
    if (time === null) throw new Error(clockMessages.noTime(node));
    return { received: time, sent: time };
  };
  if (node !== CURRENT_TIME || !(await stands(session, ofNode))) return ofNode;
  log.change('server clock', 'seldom', opcuaMessages.rareTime);
  return async (): Promise<ClockReading> => {
    await session.read(node);
    const sent = sentAt(session);
    if (sent === null) throw new Error(opcuaMessages.noTimeOfAnswer);
    return { received: sent, sent };
  };
}

/** Whether the server's CurrentTime stands still between updates, while its answers have the time of the same clock. */
async function stands(session: ReadOnlySession, read: ReadClock): Promise<boolean> {
  const began = monotonicTime();
  const { sent: first } = await read();
  let time = first;
  let stood = 0n;
  while (time === first && monotonicTime() - began < 4n * STANDS) {
    const asked = monotonicTime();
    ({ sent: time } = await read());
    // A slow answer with a different time does not show a standstill.
    if (time === first) stood = asked - began;
  }
  const answered = sentAt(session);
  // The first reading may be just before an update, so an early change is checked once more.
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
