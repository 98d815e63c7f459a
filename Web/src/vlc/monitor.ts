const FRAMES = 120;

/** Properties of the monitor that a page can measure: its refresh interval, and from it the delay until a frame's light. */
export class Monitor {
  private readonly intervals: number[] = [];
  private last = NaN;

  /** @param at Start of a frame in ms, from requestAnimationFrame. */
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
   * Delay from a code's time to its light in ms, without the panel's own delay: the mean over the refresh that shows the code, and its
   * maximum error. The code reaches the middle of the picture after one to two refreshes and is shown for one.
   */
  get delayMs(): { mean: number; maxError: number } {
    return { mean: 2 * this.refreshMs, maxError: this.refreshMs / 2 };
  }
}
