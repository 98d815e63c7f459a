/** Minimum time from the end of a connection, or of an attempt to connect, until the next attempt. */
const RETRY_MS = 2000;

/**
 * Time without any response to an attempt to connect or to a call, after which the connection counts as lost. The gateway's limit for a pong is the
 * same.
 */
const MAX_SILENCE_MS = 6000;

export const JOINT_STATE = 'sensor_msgs/msg/JointState';

/** Joint positions at a control time in seconds. */
interface JointState {
  stamp: number;
  frame: string;
  names: string[];
  positions: number[];
}

interface Topic {
  type: string;
  queue: number;
  take: (text: string) => void;
}

/** Connection to the rosbridge port of the gateway. The page subscribes to topics and publishes nothing. */
export class Rosbridge {
  private readonly topics = new Map<string, Topic>();
  private socket: WebSocket | null = null;
  private retryAt = 0;
  /** Time of the attempt to connect, or of the first call after the newest message; null if there is none. */
  private calledAt: number | null = null;
  private opened = () => {};
  private closed: Date | null = null;

  /** Time at which the connection was lost, or refused for the first time; null while it is open and before the first attempt has ended. */
  get closedAt(): Date | null {
    return this.closed;
  }

  /**
   * @param take Receives each message as text, so that unneeded messages are not parsed.
   * @param queue Maximum number of messages that wait in the gateway; 0 for the gateway's default, which depends on the topic.
   */
  subscribe(topic: string, type: string, take: (text: string) => void, queue = 0): void {
    this.topics.set(topic, { type, take, queue });
    if (this.socket?.readyState === WebSocket.OPEN) this.ask(this.socket, topic);
  }

  unsubscribe(topic: string): void {
    this.topics.delete(topic);
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify({ op: 'unsubscribe', topic }));
  }

  /** @param opened Called when a connection opens, before its first message. */
  onOpen(opened: () => void): void {
    this.opened = opened;
  }

  /**
   * Opens the connection, or checks it: after an outage of the network, a browser reports a loss late or never. Called after each response of the
   * gateway, because Firefox delays attempts to connect after one that failed.
   */
  keep(): void {
    const now = performance.now();
    if (!this.socket) {
      if (now >= this.retryAt) this.connect();
    } else if (this.calledAt !== null) {
      if (now - this.calledAt > MAX_SILENCE_MS) this.lose();
    } else if (this.socket.readyState === WebSocket.OPEN) {
      this.socket.send(JSON.stringify({ op: 'call_service', service: '/rosapi/get_time' }));
      this.calledAt = now;
    }
  }

  /** Closes the connection. The next call of `keep` opens another one. */
  close(): void {
    if (this.socket) this.lose();
    this.retryAt = 0;
  }

  private lose(): void {
    const lost = this.socket;
    this.socket = this.calledAt = null;
    lost?.close();
    this.closed ??= new Date();
    this.retryAt = performance.now() + RETRY_MS;
  }

  private connect(): void {
    this.calledAt = performance.now();
    const socket = (this.socket = new WebSocket(location.origin.replace(/^http/, 'ws') + '/'));
    const listen = <K extends keyof WebSocketEventMap>(kind: K, listener: (event: WebSocketEventMap[K]) => void) =>
      socket.addEventListener(kind, event => {
        // A connection that was dropped can still receive messages, and its loss can be reported late.
        if (this.socket === socket) listener(event);
      });
    listen('open', () => {
      this.closed = this.calledAt = null;
      this.opened();
      for (const topic of this.topics.keys()) this.ask(socket, topic);
    });
    listen('message', ({ data }) => {
      this.calledAt = null;
      if (typeof data === 'string') this.take(data);
    });
    listen('close', () => this.lose());
  }

  private ask(socket: WebSocket, topic: string): void {
    const { type, queue } = this.topics.get(topic)!;
    // Without a throttle rate, because the publishers of a topic would share it: one of them could suppress the others.
    socket.send(JSON.stringify({ op: 'subscribe', topic, type, queue_length: queue }));
  }

  // Reads only the topic, because most messages are not needed.
  private take(text: string): void {
    const topic = /"topic":"([^"]+)"/.exec(text)?.[1];
    if (topic) this.topics.get(topic)?.take(text);
  }
}

/** Parses a joint state; returns null if it is invalid. */
export function readJointState(text: string): JointState | null {
  try {
    const { header, name, position } = JSON.parse(text).msg;
    const stamp = header.stamp.sec + header.stamp.nanosec / 1e9;
    return Number.isFinite(stamp) ? { stamp, frame: header.frame_id ?? '', names: name, positions: position } : null;
  } catch {
    return null;
  }
}
