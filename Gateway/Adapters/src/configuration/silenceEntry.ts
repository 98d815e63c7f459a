/** Meaning of missing data, as written in a configuration. */
export type SilenceEntry = 'rest' | { fault_after_s: number };

/** Gets the time in ms without data that counts as a fault; null if missing data mean rest. */
export const silenceMs = (silence: SilenceEntry): number | null => (typeof silence === 'object' ? 1000 * silence.fault_after_s : null);
