import type { JointCondition, JointState } from '../gateway/jointConditions';
import type { AdapterStatus } from '../gateway/status';
import type { JointNames } from '../ros/jointNames';
import type { Silence } from '../samples/silence';
import { type Nanoseconds, ofRosTime, toMilliseconds } from '../times';

const MOST_JOINTS = 256, LONGEST_NAME = 128, LONGEST_REASON = 300;

/** STATE SINCE REASON, as a gateway writes it; SINCE is its control time in seconds. */
const VALUE = /^(live|rest|stale|refused|fault|missing) (-?\d{1,12}(?:\.\d{1,9})?)(?: (.*))?$/;

/** How a gateway begins the reason of a joint at rest of which that is not certain. */
const UNCERTAIN = 'may not be at rest: ';

/** What the gateway that has the plant reports of one joint that is not live there. */
interface Report extends JointCondition { joint: string }

/** Gives the joints of this gateway the states that they have at the gateway that has the plant. */
export class ReportedJoints {
  #isThere = false;
  /** Heard while the other gateway was not known to be there. */
  #newest: Report[] | null = null;
  /** Joints of the newest message that was applied. */
  #reported = new Set<string>();

  /** @param now Unix time in milliseconds. */
  constructor(readonly names: JointNames, readonly status: AdapterStatus, readonly silence: Silence, readonly now: () => number = Date.now) {}

  /** Takes a message of the other gateway's topic /nowpose/joint_status. */
  hear(message: Record<string, unknown>): void {
    const reports = reportsOf(message, this.now());
    if (typeof reports === 'string') return this.status.refuse('malformed', 'joint status', reports);
    this.status.accept('joint status');
    this.#newest = reports;
    if (this.#isThere) this.#apply(reports);
  }

  /** The other gateway is there. */
  enter(): void {
    this.#isThere = true;
    if (this.#newest !== null) this.#apply(this.#newest);
  }

  /** The other gateway is away, and what it reported may not be so any more. */
  leave(): void {
    this.#isThere = false;
    this.#newest = null;
    for (const joint of this.#reported) this.silence.judge(joint);
  }

  #apply(reports: Report[]): void {
    const known = reports.filter(({ joint }) => this.names.find(joint) !== undefined);
    const now = new Set(known.map(({ joint }) => joint));
    for (const report of known) {
      this.silence.leave(report.joint);
      this.status.joints.report(report.joint, report);
    }
    for (const joint of this.#reported)
      // A joint that never sent anything, and is not missed there any more, is none of that gateway's joints.
      if (!now.has(joint) && !this.silence.judge(joint)) this.status.joints.forget(joint);
    this.#reported = now;
  }
}

/** What is wrong with the message where it cannot be used. */
function reportsOf(message: Record<string, unknown>, now: number): Report[] | string {
  const { header, status } = message as { header?: { stamp?: unknown }; status?: { values?: unknown }[] };
  const written = ofRosTime(header?.stamp), values = Array.isArray(status) && status.length === 1 ? status[0]?.values : undefined;
  if (written === null) return 'it has no time stamp';
  if (!Array.isArray(values)) return 'it has no list of values';
  if (values.length > MOST_JOINTS) return `it has ${values.length} joints; up to ${MOST_JOINTS} are allowed`;
  const reports: Report[] = [];
  for (const value of values as ({ key?: unknown; value?: unknown } | null)[]) {
    const report = reportOf(value, written, now);
    if (report === null) return `the entry ${JSON.stringify(value)?.slice(0, LONGEST_NAME)} is no joint's name with STATE SINCE REASON`;
    if (report.state !== 'live') reports.push(report);
  }
  return reports;
}

function reportOf(entry: { key?: unknown; value?: unknown } | null, written: Nanoseconds, now: number): Report | null {
  const { key: joint, value } = entry ?? {};
  if (typeof joint !== 'string' || joint === '' || joint.length > LONGEST_NAME || typeof value !== 'string') return null;
  const [, word, seconds, text = ''] = VALUE.exec(value) ?? [];
  if (word === undefined) return null;
  // The message took no time worth speaking of; so no clock has to be known here, and none of two machines to agree.
  const since = Math.max(0, now - Math.max(0, toMilliseconds(written) - 1000 * Number(seconds)));
  const reason = text.slice(0, LONGEST_REASON), isUncertain = word === 'rest' && reason.startsWith(UNCERTAIN);
  // An adapter does not judge what arrives at its own gateway, which is what stale says.
  const [state, why] = word === 'stale' ? ['fault', `at the gateway that has the plant: ${reason}`] : [word, reason];
  return { joint, state: state as JointState, since, reason: why, uncertainty: isUncertain ? reason.slice(UNCERTAIN.length) : '' };
}
