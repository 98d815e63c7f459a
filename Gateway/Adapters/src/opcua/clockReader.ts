import type { ClockReading, ReadClock } from '../clock/plantClock';
import type { Log } from '../log';
import { monotonicTime, type Nanoseconds, NS_PER_MS } from '../times';
import { isGood } from './nodeValues';
import type { ReadOnlySession } from './readOnlySession';
import type { OpcUaSettings } from './settings';
import { ofDate, timeIn } from './stamps';

/** Server_ServerStatus_CurrentTime, which every OPC UA server has. */
const CURRENT_TIME = 'ns=0;i=2258';

/** A clock that stands for longer than this is worse than the time of the answers. */
const STANDS: Nanoseconds = 16n * NS_PER_MS;

/** The time of the answers is of the same clock when it differs by no more: some servers write CurrentTime once a second. */
const SAME_CLOCK: Nanoseconds = 3000n * NS_PER_MS;

/**
 * Reads the clock that the stamps are from: the server's own, or the variable that t_k is read from.
 * @param variable Its id at this server; null for the server's own.
 */
export async function clockOf(session: ReadOnlySession, settings: OpcUaSettings, variable: string | null, log: Log): Promise<ReadClock> {
  const node = variable ?? CURRENT_TIME;
  const ofNode = async (): Promise<ClockReading> => {
    const value = await session.read(node);
    if (!isGood(value.statusCode)) throw new Error(`${node} cannot be read: ${value.statusCode.name}`);
    const time = timeIn(value.value, settings.time?.unit ?? null);
    if (time === null) throw new Error(`${node} holds no time`);
    return { received: time, sent: time };
  };
  if (node !== CURRENT_TIME || !await stands(session, ofNode)) return ofNode;
  log.change('server clock', 'seldom', 'the server writes its CurrentTime seldom; its clock is told by the time at which it sends its answers');
  return async (): Promise<ClockReading> => {
    await session.read(node);
    const sent = sentAt(session);
    if (sent === null) throw new Error('the server does not say when it sent its answer');
    return { received: sent, sent };
  };
}

/** Whether the server's CurrentTime stands still between updates, while its answers tell the same clock's time. */
async function stands(session: ReadOnlySession, read: ReadClock): Promise<boolean> {
  const began = monotonicTime(), { sent: first } = await read();
  let time = first, stood = 0n;
  while (time === first && monotonicTime() - began < 4n * STANDS) {
    const asked = monotonicTime();
    ({ sent: time } = await read());
    // A slow answer that shows another time is none of a clock that stands.
    if (time === first) stood = asked - began;
  }
  const answered = sentAt(session);
  // The first reading may have come right before an update: what changed early is looked at once more.
  if (stood < STANDS && !await stoodNext(read, time)) return false;
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
