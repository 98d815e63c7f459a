import type { ClockReading } from '../clock/offeredClock';
import type { GatewayLink } from '../gateway/link';
import { isTimeOfRos1, ofRosTime } from '../times';
import { rosMessages } from '../messages/ros';

/** The service of rosapi, and its name without the slash: rosbridge adds its own namespace to this name, and rosapi usually runs in the same one. */
const GET_TIME = '/rosapi/get_time';
const GET_TIME_OF_NAMESPACE = 'rosapi/get_time';

/** Reads the time of a robot over one connection to its rosbridge. */
export class RobotTime {
  #service = GET_TIME;
  /** Whether the time has the format of ROS 1. */
  isRos1 = false;

  constructor(readonly robot: Pick<GatewayLink, 'call'>) {}

  /** @throws Error The service did not respond, or its response has no time. The message contains the remedy. */
  async read(): Promise<ClockReading> {
    const { time } = await this.#call().catch((error: Error) => {
      throw new Error(rosMessages.callFailed(error.message));
    });
    this.isRos1 = isTimeOfRos1(time);
    const now = ofRosTime(time);
    if (now === null || now <= 0n) throw new Error(rosMessages.noTime(this.#service));
    return { received: now, sent: now };
  }

  async #call(): Promise<Record<string, unknown>> {
    try {
      return await this.robot.call(this.#service);
    } catch (error) {
      if (!(error as Error).message.includes('does not exist')) throw error;
      const other = this.#service === GET_TIME ? GET_TIME_OF_NAMESPACE : GET_TIME;
      const answer = await this.robot.call(other);
      this.#service = other;
      return answer;
    }
  }
}
