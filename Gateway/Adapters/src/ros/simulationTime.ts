import type { OfferedClock } from '../clock/offeredClock';
import type { AdapterStatus } from '../gateway/status';
import { type Nanoseconds, NS_PER_S, ofRosTime } from '../times';
import { rosMessages } from '../messages/ros';

/** A time in 2001. A stamp before it is the time since the start of a simulation, and a clock after it is in real time. */
const REAL_TIME: Nanoseconds = 1_000_000_000n * NS_PER_S;

const SUBJECT = 'simulation time';

/**
 * Reports that messages have stamps of a simulation although the robot's clock is in real time, because all of them are then refused. The rosapi of
 * ROS 2 returns the system time even with use_sim_time.
 */
export class SimulationTime {
  /** Topics whose newest message has a stamp of a simulation. */
  readonly #topics = new Set<string>();

  constructor(
    readonly clock: Pick<OfferedClock, 'now'>,
    readonly status: Pick<AdapterStatus, 'notice'>,
  ) {}

  /** @param header Header of the newest message on a topic. */
  check(topic: string, header: unknown): void {
    const stamp = ofRosTime((header as { stamp?: unknown } | null | undefined)?.stamp);
    const { now } = this.clock;
    if (stamp === null || stamp <= 0n || now === null) return;
    if (stamp < REAL_TIME && now > REAL_TIME) this.#topics.add(topic);
    else this.#topics.delete(topic);
    this.status.notice(this.#topics.size === 0 ? null : rosMessages.simulationTime([...this.#topics]), SUBJECT);
  }

  /** Prepares for a new connection to the robot. */
  forget(): void {
    this.#topics.clear();
    this.status.notice(null, SUBJECT);
  }
}
