import type { Publisher } from '../gateway/link';
import { description, excessOf, ROBOT_DESCRIPTION, topicOf } from '../gateway/messages';
import type { AdapterStatus } from '../gateway/status';
import { malformedMessages } from '../messages/broker';
import { rosMessages } from '../messages/ros';
import { EXPECTED_MS } from './subscriptionRenewals';

const SUBJECT = 'robot description';

/** Forwards the description of the robot. Reports if none arrives, because headsets then have no robot to display. */
export class RobotDescription {
  #hasArrived = false;

  constructor(
    readonly topic: string,
    readonly namespace: string,
    readonly gateway: Pick<Publisher, 'publishKept'>,
    readonly status: Pick<AdapterStatus, 'notice' | 'refuse'>,
  ) {}

  pass(text: unknown): void {
    this.#hasArrived = true;
    const isRobot = typeof text === 'string' && text.includes('<robot');
    // The gateway would report only once that it drops the description.
    const excess = isRobot ? excessOf(this.topic, text) : null;
    this.status.notice(excess, SUBJECT);
    if (!isRobot) this.status.refuse('malformed', SUBJECT, malformedMessages.noRobot);
    else if (excess === null) this.gateway.publishKept(topicOf(this.namespace, ROBOT_DESCRIPTION), description(text));
  }

  /** @param connectedMs Duration of the connection, ms. */
  check(connectedMs: number): void {
    if (!this.#hasArrived && connectedMs >= EXPECTED_MS) this.status.notice(rosMessages.noDescription(this.topic), SUBJECT);
  }
}
