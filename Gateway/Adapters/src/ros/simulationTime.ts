import type { OfferedClock } from '../clock/offeredClock';
import type { AdapterStatus } from '../gateway/status';
import { type Nanoseconds, NS_PER_S, ofRosTime } from '../times';
import { rosMessages } from '../messages/ros';

/** A time in 2001. A stamp before it is the time since the start of a simulation, and a clock after it is in real time. */
const REAL_TIME: Nanoseconds = 1_000_000_000n * NS_PER_S;

/** Time without such a stamp on a topic after which its notice ends. Several programs may publish on one topic, some of them in real time. */
const SPAN: Nanoseconds = 5n * NS_PER_S;

const SUBJECT = 'simulation time';

/**
 * Reports that messages have stamps of a simulation although the robot's clock is in real time, because the gateway then refuses them. The rosapi of
 * ROS 2 returns the system time even with use_sim_time.
 */
export class SimulationTime {
  /** Topics with stamps of a simulation, each with the time of the newest one. */
  readonly #topics = new Map<string, Nanoseconds>();

  constructor(
    readonly clock: Pick<OfferedClock, 'now'>,
    readonly status: Pick<AdapterStatus, 'notice'>,
  ) {}

  /** @param header Header of a message on a topic, or of a transform in it. */
  check(topic: string, header: unknown): void {
    const stamp = ofRosTime((header as { stamp?: unknown } | null | undefined)?.stamp);
    const { now } = this.clock;
    if (stamp === null || stamp <= 0n || now === null) return;
    if (stamp < REAL_TIME && now > REAL_TIME) this.#topics.set(topic, now);
    for (const [other, at] of this.#topics) if (now < REAL_TIME || now - at > SPAN) this.#topics.delete(other);
    this.status.notice(this.#topics.size === 0 ? null : rosMessages.simulationTime([...this.#topics.keys()]), SUBJECT);
  }

  /** Prepares for a new connection to the robot. */
  forget(): void {
    this.#topics.clear();
    this.status.notice(null, SUBJECT);
  }
}
