type Listener = (time: number, mover: unknown) => void;

/** The time of the session that the plots and the view of the robot show, in seconds since the start. Listeners can also change it. */
export class Playhead {
  private readonly listeners: Listener[] = [];
  private isMoving = false;

  follow(listener: Listener): void {
    this.listeners.push(listener);
  }

  /** @param mover The object that changes the time. It is notified like the other listeners and must ignore the notification. */
  move(time: number, mover: unknown): void {
    // A plot moves its cursor when it is notified, which calls this method again. The nested call must have no effect.
    if (this.isMoving) return;
    this.isMoving = true;
    try {
      for (const listener of this.listeners) listener(time, mover);
    } finally {
      this.isMoving = false;
    }
  }
}
