/** Meaning of the absence of data, as written in a configuration. */
export type SilenceEntry = 'rest' | { fault_after_s: number };

/** Gets the time without data after which there is a fault, ms; null if silence means rest. */
export const silenceMs = (silence: SilenceEntry): number | null => (typeof silence === 'object' ? 1000 * silence.fault_after_s : null);
