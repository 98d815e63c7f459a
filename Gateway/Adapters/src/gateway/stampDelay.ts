import { type Nanoseconds, ofRosTime, toRosTime } from '../times';
import type { Publisher } from './link';

interface Stamped {
  header?: { stamp: unknown };
  transforms?: Stamped[];
}

/**
 * Gets a publisher that subtracts a delay from the time stamps of joint states, transforms and signals, for a control system whose values are older than
 * their time stamps.
 */
export function withStampDelay(gateway: Publisher, delay: Nanoseconds): Publisher {
  if (delay === 0n) return gateway;
  return {
    publish: (topic, msg) => gateway.publish(topic, earlier(msg, delay)),
    publishNewest: (topic, next) =>
      gateway.publishNewest(topic, () => {
        const msg = next();
        return msg === null ? null : earlier(msg, delay);
      }),
    // The kept messages contain stationary frames, which have no time.
    publishKept: (topic, msg, key) => gateway.publishKept(topic, msg, key),
    forgetKept: key => gateway.forgetKept(key),
    get dropped() {
      return gateway.dropped;
    },
  };
}

function earlier<Message extends Stamped>(msg: Message, delay: Nanoseconds): Message {
  const { header, transforms } = msg;
  return {
    ...msg,
    ...(header && { header: { ...header, stamp: toRosTime(ofRosTime(header.stamp)! - delay) } }),
    ...(transforms && { transforms: transforms.map(one => earlier(one, delay)) }),
  };
}
