import type { FrameSettings } from '../configuration/frames';
import type { AdapterStatus } from '../gateway/status';
import { silenceMessages, stateMessages } from '../messages/values';
import { SampleSilence } from '../samples/sampleSilence';
import type { Nanoseconds } from '../times';
import { FrameMotion } from './frameMotion';
import type { Pose } from './messages';

/** The states of all frames that are not stationary. They result from the silence and the motion of each frame. */
export class FrameStates {
  /** Sampling interval of the source in seconds; 0 if unknown. */
  samplingS = 0;
  readonly silence: SampleSilence;
  readonly #motions: Map<string, FrameMotion>;

  /** @param counter Monotonic clock in ms; by default, the clock of this machine. */
  constructor(
    frames: FrameSettings[],
    readonly status: AdapterStatus,
    counter?: () => number,
  ) {
    this.#motions = new Map(frames.map(({ frame, maxDeceleration }) => [frame, new FrameMotion(maxDeceleration)]));
    const limits = new Map(frames.map(({ frame, faultAfterMs }) => [frame, faultAfterMs]));
    this.silence = new SampleSilence(status, frame => limits.get(frame) ?? null, counter, status.frames);
    this.silence.endOf = (frame, silentMs) => this.#endOf(frame, silentMs);
    for (const { frame } of frames) status.frames.expect(frame);
  }

  motionOf(frame: string): FrameMotion {
    return this.#motions.get(frame)!;
  }

  /** Adds a valid pose that is newer than the previous pose of its frame. */
  add(stamp: Nanoseconds, pose: Pose): void {
    this.motionOf(pose.frame).add(stamp, pose);
    this.status.accept(pose.frame);
    this.silence.heard(pose.frame);
  }

  /**
   * Sets a notice about each frame that may not be at rest although its pose is repeated. Without confirmed values, the pose is not repeated, so it does
   * not look current.
   */
  reportUncertainty(): void {
    for (const frame of this.#motions.keys()) {
      const uncertainty = this.silence.unconfirmedMs === null ? '' : (this.status.frames.conditionOf(frame)?.uncertainty ?? '');
      this.status.notice(uncertainty === '' ? null : stateMessages.uncertainRest(frame, uncertainty), `rest of ${frame}`);
    }
  }

  /** Prepares for a new connection. Objects at rest may have moved since the previous one. */
  restart(): void {
    for (const motion of this.#motions.values()) motion.restart();
  }

  /** Gets the reason why the data of a frame of a source without confirmations ended during a motion; null if they did not. */
  #endOf(frame: string, silentMs: number): string | null {
    const motion = this.motionOf(frame);
    const reason = silentMs < motion.overdueMs ? null : motion.end(this.samplingS).impossible;
    return reason === null ? null : silenceMessages.endedBecause(reason);
  }
}
