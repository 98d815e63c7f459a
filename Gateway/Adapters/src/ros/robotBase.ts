import { rootLinkIn } from '../configuration/robot';
import type { AdapterStatus } from '../gateway/status';
import { rosMessages } from '../messages/ros';

const SUBJECT = 'robot base';

/** Maximum number of stored transforms. A robot has one for each of its links. */
const MAX_TRANSFORMS = 1024;

/** Reports that ROS publishes the place of the robot, but that the configuration does not list it. Headsets would draw the robot at the origin. */
export class RobotBase {
  /** Parents and names in ROS of the received transforms that are not listed, by their names in the cell. */
  readonly #unlisted = new Map<string, { source: string; parent: string }>();
  /** Name of the robot's root link in the cell; null while unknown. */
  #root: string | null = null;

  /** @param listed The names in the cell of the listed frames. */
  constructor(
    readonly namespace: string,
    readonly listed: readonly string[],
    readonly status: Pick<AdapterStatus, 'notice'>,
  ) {}

  describe(urdf: string): void {
    const root = rootLinkIn(urdf);
    this.#root = root === null || this.namespace === '' ? root : `${this.namespace}/${root}`;
    this.#check();
  }

  /** Adds a transform that is not listed. */
  add(frame: string, source: string, parent: string): void {
    if (this.#unlisted.has(frame) || this.#unlisted.size >= MAX_TRANSFORMS) return;
    this.#unlisted.set(frame, { source, parent });
    if (frame === this.#root) this.#check();
  }

  #check(): void {
    const root = this.#root;
    const found = root === null || this.listed.includes(root) ? undefined : this.#unlisted.get(root);
    this.status.notice(found === undefined ? null : rosMessages.baseNotListed(found.source, found.parent, root!), SUBJECT);
  }
}
