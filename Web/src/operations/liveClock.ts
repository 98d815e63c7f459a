/** So much of the past is compared, in seconds. */
const WINDOW_S = 10;

/** A jump of the stamps beyond this is another clock. */
const STEP_S = 2;

/** Which control time it is here, well enough to show what was half a second ago: from the stamps that came quickest. */
export class LiveClock {
  private seen: [at: number, ahead: number][] = [];

  /** @param now Of this machine, in seconds. */
  add(stamp: number, now: number): void {
    const ahead = stamp - now;
    const last = this.seen[this.seen.length - 1];
    if (last && Math.abs(last[1] - ahead) > STEP_S) this.seen = [];
    // Only what may still be the greatest is kept.
    while (this.seen.length > 0 && this.seen[this.seen.length - 1][1] <= ahead) this.seen.pop();
    this.seen.push([now, ahead]);
    while (this.seen[0][0] < now - WINDOW_S) this.seen.shift();
  }

  /** Control time of the newest sample there could be by now; null before any came. */
  at(now: number): number | null {
    return this.seen.length === 0 ? null : now + this.seen[0][1];
  }
}
