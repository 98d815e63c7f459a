const FRAMES = 120;

/** Properties of the monitor that a page can measure: its refresh rate, and from it the delay until a frame's light. */
export class Monitor {
  private readonly intervals: number[] = [];
  private last = NaN;

  /** @param at Begin of a frame, ms, as requestAnimationFrame tells. */
  frame(at: number): void {
    const interval = at - this.last;
    this.last = at;
    if (!(interval > 0)) return;
    this.intervals.push(interval);
    if (this.intervals.length > FRAMES) this.intervals.shift();
  }

  /** From one refresh to the next, ms; NaN before it is known. */
  get refreshMs(): number {
    if (this.intervals.length < FRAMES / 4) return NaN;
    return [...this.intervals].sort((a, b) => a - b)[this.intervals.length >> 1];
  }

  /**
   * How much earlier than its light a code's time is, on average over the refresh that shows it, ms, the panel's own delay
   * apart: it takes one or two refreshes to reach the middle of the picture, and stays for one.
   */
  get delayMs(): { mean: number; greatestError: number } {
    return { mean: 2 * this.refreshMs, greatestError: this.refreshMs / 2 };
  }
}
