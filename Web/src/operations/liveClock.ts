/** Length of the window in which the time stamp with the smallest delay is determined, in seconds. */
const WINDOW_S = 10;

/** If the time stamps minus the local time jump by more than this number of seconds, they come from another clock. */
const STEP_S = 2;

/** Estimates the current control time from the time stamp with the smallest delay, accurately enough to show the state of half a second ago. */
export class LiveClock {
  private seen: [at: number, ahead: number][] = [];

  /** @param now Local time in seconds. */
  add(stamp: number, now: number): void {
    const ahead = stamp - now;
    const last = this.seen[this.seen.length - 1];
    if (last && Math.abs(last[1] - ahead) > STEP_S) this.seen = [];
    // Discards time stamps that arrived earlier with a larger delay, because they can no longer have the smallest delay in the window.
    while (this.seen.length > 0 && this.seen[this.seen.length - 1][1] <= ahead) this.seen.pop();
    this.seen.push([now, ahead]);
    while (this.seen[0][0] < now - WINDOW_S) this.seen.shift();
  }

  /** Returns the control time, estimated as if the sample with the smallest delay had arrived without delay; null before the first sample. */
  at(now: number): number | null {
    return this.seen.length === 0 ? null : now + this.seen[0][1];
  }
}
