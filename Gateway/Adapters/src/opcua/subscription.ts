import { type ClientSession, ClientSubscription, type ModifySubscriptionOptions } from 'node-opcua-client';
import { opcuaMessages } from '../messages/opcua';
import { maxSilenceMs } from './serverSilence';
import { requestTrouble } from './troubles';

const KEEP_ALIVE_MS = 1000;
const LIFETIME_MS = 15_000;

/** A subscription, and the message that the server has not adapted it to the granted interval; null if it has. */
interface Subscribed {
  subscription: ClientSubscription;
  unmodified: string | null;
}

/** Creates a subscription without monitored items. */
export async function subscribe(session: ClientSession, publishingMs: number): Promise<Subscribed> {
  // Otherwise, the library never finishes the request if the granted interval times the granted count exceeds the session's timeout.
  ClientSubscription.ignoreNextWarning = true;
  const subscription = await session.createSubscription2({
    ...countsFor(publishingMs),
    maxNotificationsPerPublish: 0,
    publishingEnabled: true,
    priority: 100,
  });
  return { subscription, unmodified: await adapt(subscription, publishingMs) };
}

// Without this, a slow server would keep the subscription for many minutes after a lost connection, and the adapter would wait as long for missing
// notifications.
async function adapt(subscription: ClientSubscription, requestedMs: number): Promise<string | null> {
  const { publishingInterval, lifetimeCount, maxKeepAliveCount } = subscription;
  if (publishingInterval === requestedMs) return null;
  try {
    await subscription.modify(countsFor(publishingInterval));
    return null;
  } catch (error) {
    const [lifetimeMs, silenceMs] = [publishingInterval * lifetimeCount, maxSilenceMs(publishingInterval * maxKeepAliveCount)];
    return opcuaMessages.unmodified(requestTrouble(error as Error), Math.round(lifetimeMs / 1000), Math.round(silenceMs / 1000));
  }
}

/** Gets the counts of a subscription, which are multiples of its publishing interval. */
const countsFor = (publishingMs: number): ModifySubscriptionOptions => ({
  requestedPublishingInterval: publishingMs,
  requestedMaxKeepAliveCount: Math.max(1, Math.ceil(KEEP_ALIVE_MS / publishingMs)),
  requestedLifetimeCount: Math.max(3, Math.ceil(LIFETIME_MS / publishingMs)),
});
