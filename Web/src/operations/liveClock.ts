/** Length of the window in which the response with the smallest delay is determined, in seconds. */
const WINDOW_S = 10;

/** If the control time minus the local time jumps by more than this number of seconds, the gateway serves another clock. */
const STEP_S = 2;

/** Estimates the current control time from the gateway's response with the smallest delay, accurately enough to show the state of half a second ago. */
export class LiveClock {
  private seen: [at: number, ahead: number][] = [];
  private steps: number | null = null;

  /**
   * @param control Control time in a response, in seconds.
   * @param now Local time at its arrival, in seconds.
   * @param steps Number of steps of the control clock; null if the gateway does not count them.
   */
  add(control: number, now: number, steps: number | null): void {
    const ahead = control - now;
    const last = this.seen[this.seen.length - 1];
    if (steps !== this.steps || (last && Math.abs(last[1] - ahead) > STEP_S)) this.seen = [];
    this.steps = steps;
    // Discards responses that arrived earlier with a larger delay, because they can no longer have the smallest delay in the window.
    while (this.seen.length > 0 && this.seen[this.seen.length - 1][1] <= ahead) this.seen.pop();
    this.seen.push([now, ahead]);
    while (this.seen[0][0] < now - WINDOW_S) this.seen.shift();
  }

  /** Returns the control time, estimated as if the response with the smallest delay had arrived without delay; null before the first response. */
  at(now: number): number | null {
    return this.seen.length === 0 ? null : now + this.seen[0][1];
  }
}
