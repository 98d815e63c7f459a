type Listener = (time: number, mover: unknown) => void;

/** The moment of the session that plots and robot show together, in seconds since its start. Whoever follows may move it, too. */
export class Playhead {
  private readonly listeners: Listener[] = [];
  private isMoving = false;

  follow(listener: Listener): void {
    this.listeners.push(listener);
  }

  /** @param mover Is told, too, and knows itself. */
  move(time: number, mover: unknown): void {
    // A plot that follows moves its cursor, which is no move of its own.
    if (this.isMoving) return;
    this.isMoving = true;
    try {
      for (const listener of this.listeners) listener(time, mover);
    } finally {
      this.isMoving = false;
    }
  }
}
