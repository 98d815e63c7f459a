import type { Frame } from '../configuration/frames';
import { StampRule } from '../samples/stampRule';
import { max, min, type Nanoseconds, NS_PER_MS } from '../times';
import type { FrameMotion } from './frameMotion';
import { valuesOf } from './framePose';

/** SILENCE: minimum time without changes after which a pose is repeated. REPETITION: interval of repetitions. Headsets predict for about 300 ms. */
const SILENCE: Nanoseconds = 60n * NS_PER_MS;
const REPETITION: Nanoseconds = 50n * NS_PER_MS;

/**
 * SILENT_INTERVALS: time without changes after which a pose is repeated, as a multiple of the time between changes. MAX_INTERVAL: times between
 * changes of at least this length are ignored.
 */
const SILENT_INTERVALS = 2n;
const MAX_INTERVAL: Nanoseconds = 500n * NS_PER_MS;

/** The state of a tracked frame. */
export interface Track {
  frame: Frame;
  /** Checks the stamps of the poses. */
  rule: StampRule;
  /** Indices of the values from which the pose is computed. */
  values: number[];
  /** Index of the value that selects the parent; null if the parent is constant. */
  selector: number | null;
  /** Number that selected the parent of the newest pose; null before the first pose. */
  choice: number | null;
  /** Stamp of the change with a jump that is not published yet, because the parent may also have changed; null if there is none. */
  jumped: Nanoseconds | null;
  /** Stamp of the newest pose; null before the first. */
  newest: Nanoseconds | null;
  /** Stamp of the newest change; null before the first. */
  changed: Nanoseconds | null;
  /** The two times between the last three changes. The shorter one is used, because the other may be a pause. */
  intervals: Nanoseconds[];
  isRepeated: boolean;
  motion: FrameMotion;
  /**
   * How the data have ended: during a motion, or by a silence that is longer than the setting allows; null if they have not. Only a newer pose, or the
   * loss of a variable, ends this state.
   */
  end: 'in-motion' | 'silent' | null;
}

/** @param oldest Maximum age of a stamp. */
export const trackOf = (frame: Frame, oldest: Nanoseconds, motion: FrameMotion): Track => ({
  frame,
  rule: new StampRule(oldest),
  values: valuesOf(frame),
  selector: frame.selector !== null && 'value' in frame.selector ? frame.selector.value : null,
  choice: null,
  jumped: null,
  newest: null,
  changed: null,
  intervals: [],
  isRepeated: false,
  motion,
  end: null,
});

/**
 * Gets the minimum time without changes after which a pose is repeated; if it has been repeated already, the repetition interval.
 * @param silence Maximum interval between the samples of a moving frame.
 */
export function silenceOf({ intervals, isRepeated }: Track, silence: Nanoseconds): Nanoseconds {
  if (isRepeated) return REPETITION;
  const interval = min(MAX_INTERVAL, ...intervals);
  const least = max(SILENCE, silence);
  return intervals.length > 0 && interval < MAX_INTERVAL && SILENT_INTERVALS * interval > least ? SILENT_INTERVALS * interval : least;
}
