import type { Condition, State } from '../gateway/conditions';
import type { AdapterStatus } from '../gateway/status';
import type { JointNames } from '../ros/jointNames';
import type { SampleSilence } from '../samples/sampleSilence';
import { type Nanoseconds, ofRosTime, toMilliseconds, unixTimeMs } from '../times';
import { brokerMessages, malformedMessages } from '../messages/broker';

const MAX_JOINTS = 256;

/** Matches the name of a joint or signal of up to 128 characters. The namespace of a robot before the name is not part of this length. */
const NAME = /^(?:[A-Za-z][A-Za-z0-9_]{0,31}\/)?[^]{1,128}$/;

/** Maximum length of the text of an invalid entry in the log. */
const MAX_ENTRY = 128;
const MAX_REASON = 300;

/** Matches the value STATE SINCE REASON that a gateway writes. SINCE is a control time in seconds. */
const VALUE = /^(live|rest|stale|refused|fault|missing) (-?\d{1,12}(?:\.\d{1,9})?)(?: (.*))?$/;

/** Beginning of the reason for a joint that may not be at rest. */
// eslint-disable-next-line nowpose/messages -- part of the protocol
const UNCERTAIN = 'may not be at rest: ';

/** The word for the reason of a joint or signal whose fault the plant's gateway reports. The metrics of that gateway have the reason itself. */
export const OTHER_GATEWAY = 'other-gateway';

/** A report of the plant's gateway about one joint that is not live. */
interface Report extends Condition {
  joint: string;
}

/** Transfers the states of joints from the plant's gateway to this gateway. */
export class ReportedJoints {
  #isThere = false;
  /** Newest message; null if none has arrived since the other gateway was last reported absent. */
  #newest: Report[] | null = null;
  /** Joints in the last message that was applied. */
  #reported = new Set<string>();

  /** @param now Unix time in milliseconds. */
  constructor(
    readonly names: Pick<JointNames, 'find'>,
    readonly status: AdapterStatus,
    readonly silence: SampleSilence,
    readonly now: () => number = unixTimeMs,
  ) {}

  /** Processes a message that the other gateway published on /nowpose/joint_status. */
  hear(message: Record<string, unknown>): void {
    const reports = reportsOf(message, this.now());
    if (typeof reports === 'string') return this.status.refuse('malformed', 'joint status', reports);
    this.status.accept('joint status');
    this.#newest = reports;
    if (this.#isThere) this.#apply(reports);
  }

  /** Whether a joint may rest: the other gateway reports it, or its report has not arrived yet. */
  mayRest(joint: string): boolean {
    return this.#newest?.some(report => report.joint === joint && report.state === 'rest') ?? true;
  }

  /** Records that the other gateway is present. Applies its newest message. */
  enter(): void {
    this.#isThere = true;
    if (this.#newest !== null) this.#apply(this.#newest);
  }

  /** Records that the other gateway is absent. Discards its newest message, because it may be outdated. */
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
      // Removes a joint that has never sent a value and is no longer reported: it does not belong to the other gateway.
      if (!now.has(joint) && !this.silence.judge(joint)) this.status.joints.forget(joint);
    this.#reported = now;
  }
}

/** Gets the reports in a message about joints or signals, without those of the state live; a description of the error if the message is invalid. */
export function reportsOf(message: Record<string, unknown>, now: number): Report[] | string {
  const { header, status } = message as { header?: { stamp?: unknown }; status?: { values?: unknown }[] };
  const written = ofRosTime(header?.stamp);
  const values = Array.isArray(status) && status.length === 1 ? status[0]?.values : undefined;
  if (written === null) return malformedMessages.noStamp;
  if (!Array.isArray(values)) return malformedMessages.noValues;
  if (values.length > MAX_JOINTS) return malformedMessages.tooManyJoints(values.length, MAX_JOINTS);
  const reports: Report[] = [];
  for (const value of values as ({ key?: unknown; value?: unknown } | null)[]) {
    const report = reportOf(value, written, now);
    if (report === null) return malformedMessages.entry(String(JSON.stringify(value)?.slice(0, MAX_ENTRY)));
    if (report.state !== 'live') reports.push(report);
  }
  return reports;
}

function reportOf(entry: { key?: unknown; value?: unknown } | null, written: Nanoseconds, now: number): Report | null {
  const { key: joint, value } = entry ?? {};
  if (typeof joint !== 'string' || !NAME.test(joint) || typeof value !== 'string') return null;
  const [, word, seconds, text = ''] = VALUE.exec(value) ?? [];
  if (word === undefined) return null;
  // Ignores the transmission time, so that only differences between times of the same clock are used.
  const since = Math.max(0, now - Math.max(0, toMilliseconds(written) - 1000 * Number(seconds)));
  const reason = text.slice(0, MAX_REASON);
  const isUncertain = word === 'rest' && reason.startsWith(UNCERTAIN);
  // Converts stale to fault: an adapter cannot report stale, because each gateway determines this state from the samples that it receives.
  const [state, why] = word === 'stale' ? ['fault', brokerMessages.atOtherGateway(reason)] : [word, reason];
  const isUsable = state === 'live' || state === 'rest';
  const uncertainty = isUncertain ? reason.slice(UNCERTAIN.length) : '';
  return { joint, state: state as State, since, reason: why, word: isUsable ? '' : OTHER_GATEWAY, uncertainty };
}
