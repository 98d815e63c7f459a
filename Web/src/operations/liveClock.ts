/** Length of the window over which the fastest stamps are used, in seconds. */
const WINDOW_S = 10;

/** Jump of the stamps that indicates another clock. */
const STEP_S = 2;

/** Estimates the current control time from the fastest stamps, accurately enough to show the state of half a second ago. */
export class LiveClock {
  private seen: [at: number, ahead: number][] = [];

  /** @param now Time of this machine, in seconds. */
  add(stamp: number, now: number): void {
    const ahead = stamp - now;
    const last = this.seen[this.seen.length - 1];
    if (last && Math.abs(last[1] - ahead) > STEP_S) this.seen = [];
    // Keeps only stamps that can become the maximum of a later window.
    while (this.seen.length > 0 && this.seen[this.seen.length - 1][1] <= ahead) this.seen.pop();
    this.seen.push([now, ahead]);
    while (this.seen[0][0] < now - WINDOW_S) this.seen.shift();
  }

  /** Returns the control time of the newest possible sample; null before the first. */
  at(now: number): number | null {
    return this.seen.length === 0 ? null : now + this.seen[0][1];
  }
}
