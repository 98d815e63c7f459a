type Listener = (time: number, mover: unknown) => void;

/** The time in the session that plots and robot show together, in seconds since its start. Its listeners may also move it. */
export class Playhead {
  private readonly listeners: Listener[] = [];
  private isMoving = false;

  follow(listener: Listener): void {
    this.listeners.push(listener);
  }

  /** @param mover The object that moves it, which receives the notification, too, and must ignore it. */
  move(time: number, mover: unknown): void {
    // A listening plot moves its cursor, which must not start another move.
    if (this.isMoving) return;
    this.isMoving = true;
    try {
      for (const listener of this.listeners) listener(time, mover);
    } finally {
      this.isMoving = false;
    }
  }
}
