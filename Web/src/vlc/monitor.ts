const FRAMES = 120;

/** Measures the refresh interval of the monitor, and computes from it the delay from the start of a frame to its display time. */
export class Monitor {
  private readonly intervals: number[] = [];
  private last = NaN;

  /** @param at Start of a frame from requestAnimationFrame, ms. */
  frame(at: number): void {
    const interval = at - this.last;
    this.last = at;
    if (!(interval > 0)) return;
    this.intervals.push(interval);
    if (this.intervals.length > FRAMES) this.intervals.shift();
  }

  /** Refresh interval in ms; NaN before it is known. */
  get refreshMs(): number {
    if (this.intervals.length < FRAMES / 4) return NaN;
    return [...this.intervals].sort((a, b) => a - b)[this.intervals.length >> 1];
  }

  /**
   * Mean delay from the time that a code encodes to the emission of its light, without the panel's own delay, and the maximum deviation from this
   * mean, ms. In the fastest case, the code is sent at the next refresh, reaches the middle of the picture half a refresh later, and is visible for one
   * refresh: two refreshes in the mean. A browser that composes one more frame needs three.
   */
  get delayMs(): { mean: number; maxError: number } {
    return { mean: 2.5 * this.refreshMs, maxError: this.refreshMs };
  }
}
