import type { FrameStates } from '../cell/frameStates';
import { type Pose, stationaryKey, TF, TF_STATIC, tooFar, transform, transformMessages } from '../cell/messages';
import { unit } from '../cell/rotation';
import type { OfferedClock } from '../clock/offeredClock';
import { WORLD } from '../configuration/frames';
import type { Publisher } from '../gateway/link';
import type { AdapterStatus } from '../gateway/status';
import { type Refusal, StampRule } from '../samples/stampRule';
import { type Nanoseconds, ofRosTime } from '../times';
import { bare, type RosSettings } from './kind';
import { EXPECTED_MS } from './subscriptionRenewals';
import { RobotBase } from './robotBase';
import { rosMessages } from '../messages/ros';
import { refusalMessages } from '../messages/values';

/** A frame of the cell and its name in ROS. */
export interface RosFrame {
  frame: string;
  source: string;
  /** The topic with the frame's pose; null if the pose is in /tf or /tf_static. */
  topic: string | null;
  type?: string;
}

interface RosTransform {
  header?: { stamp?: unknown; frame_id?: unknown };
  transform?: Record<string, Record<string, unknown> | undefined>;
}

const SUBJECT = 'frames';

type Names = Pick<RosSettings, 'frames' | 'world' | 'namespace' | 'linkPrefix'>;

/** Forwards the configured frames of a robot with their own stamps. */
export class RosFrames {
  readonly #rules: StampRule[];
  readonly #base: RobotBase;
  /** The frames in /tf and /tf_static of which no pose has arrived. */
  readonly #awaited: Set<RosFrame>;

  constructor(
    readonly names: Names,
    oldest: Nanoseconds,
    readonly clock: Pick<OfferedClock, 'now' | 'isSettled'>,
    readonly gateway: Publisher,
    readonly status: AdapterStatus,
    readonly states: FrameStates,
  ) {
    this.#rules = names.frames.map(() => new StampRule(oldest));
    this.#awaited = new Set(names.frames.filter(({ topic }) => topic === null));
    const listed = names.frames.map(({ frame }) => frame);
    this.#base = new RobotBase(names.namespace, listed, status);
    // ROS does not confirm the poses of a frame whose publisher is silent.
    states.silence.unconfirmedMs = null;
  }

  /** Sets the description of the robot, whose base may be a frame. */
  describe(urdf: string): void {
    this.#base.describe(urdf);
  }

  /**
   * Reports the frames of which no pose has arrived.
   * @param connectedMs Duration of the connection, ms.
   */
  check(connectedMs: number, isRos1: boolean): void {
    if (connectedMs < EXPECTED_MS || this.#awaited.size === 0) return;
    this.status.notice(
      rosMessages.noPose(
        [...this.#awaited].map(({ source }) => source),
        isRos1,
      ),
      SUBJECT,
    );
  }

  /**
   * Forwards the tracked frames in a message of /tf.
   * @param seen Called with the header of each configured frame, valid or not.
   */
  pass(message: Record<string, unknown>, seen?: (header: unknown) => void): void {
    this.#forward(this.#found(message, seen));
  }

  /** Forwards a frame with its own topic. The message is a TransformStamped, a PoseStamped, or contains a pose with covariance. */
  passPose(index: number, message: Record<string, unknown>): void {
    this.#forward(this.#read(index, 'transform' in message ? message : ofPose(message)));
  }

  #forward(found: { index: number; pose: Pose; stamp: Nanoseconds | null }[]): void {
    if (found.length === 0) return;
    if (!this.clock.isSettled) return this.status.count('clock-unknown');
    const { now } = this.clock;
    const transforms = found.flatMap(({ index, pose, stamp }) => {
      const refusal = this.#rules[index].judge(stamp, now);
      if (refusal !== null) {
        this.status.refuse(refusal.reason, pose.frame, refusal.text, this.status.frames);
        return [];
      }
      this.states.add(stamp!, pose);
      this.gateway.forgetKept(stationaryKey(pose.frame));
      return [transform(stamp!, pose)];
    });
    for (const message of transformMessages(transforms)) {
      this.gateway.publish(TF, message);
      this.status.sampled();
    }
  }

  /** Forwards the stationary frames in a message of /tf_static. */
  passStationary(message: Record<string, unknown>): void {
    for (const { pose } of this.#found(message)) {
      this.states.silence.forget(pose.frame);
      this.status.frames.live(pose.frame);
      this.status.accept(pose.frame);
      // Uses a zero stamp, which needs no clock, because a stationary frame has the same pose at all times.
      this.gateway.publishKept(TF_STATIC, { transforms: [transform(0n, pose)] }, stationaryKey(pose.frame));
    }
  }

  #found({ transforms }: Record<string, unknown>, seen?: (header: unknown) => void): { index: number; pose: Pose; stamp: Nanoseconds | null }[] {
    if (!Array.isArray(transforms)) {
      this.status.refuse('malformed', 'transforms', rosMessages.noTransforms, this.status.frames);
      return [];
    }
    return transforms.flatMap((one: Record<string, unknown> | null) => {
      const source = bare(one?.child_frame_id);
      const index = this.names.frames.findIndex(frame => frame.topic === null && frame.source === source);
      if (index >= 0) {
        seen?.(one!.header);
        return this.#read(index, one!);
      }
      if (source !== '' && source !== this.names.world) this.#base.add(this.#linkOf(source), source, bare((one as RosTransform).header?.frame_id));
      return [];
    });
  }

  /** Gets the pose of a frame as a list of one element; an empty list if the pose is refused. */
  #read(index: number, { header, transform: pose }: RosTransform): { index: number; pose: Pose; stamp: Nanoseconds | null }[] {
    const { frame, source, topic } = this.names.frames[index];
    const parent = bare(header?.frame_id);
    const position = ['x', 'y', 'z'].map(axis => pose?.translation?.[axis]);
    const turn = ['x', 'y', 'z', 'w'].map(part => pose?.rotation?.[part]);
    const refusal = refusalOf(parent, position, turn, topic ?? source);
    if (refusal !== null) {
      this.status.refuse(refusal.reason, frame, refusal.text, this.status.frames);
      return [];
    }
    if (this.#awaited.delete(this.names.frames[index]) && this.#awaited.size === 0) this.status.notice(null, SUBJECT);
    const [metres, rotation] = [position as number[], unit(turn as number[])!];
    return [{ index, pose: { frame, parent: this.#parentOf(parent), position: metres, rotation }, stamp: ofRosTime(header?.stamp) }];
  }

  #parentOf(source: string): string {
    const { frames, world } = this.names;
    if (source === world) return WORLD;
    return frames.find(frame => frame.source === source)?.frame ?? this.#linkOf(source);
  }

  /** Gets the name in the cell of a link of the robot. */
  #linkOf(source: string): string {
    const { namespace, linkPrefix } = this.names;
    const link = source.startsWith(linkPrefix) ? source.slice(linkPrefix.length) : source;
    // With a frame_prefix, robot_state_publisher has already added the namespace.
    const isComplete = namespace === '' || link.startsWith(`${namespace}/`);
    return isComplete ? link : `${namespace}/${link}`;
  }
}

/** Gets the transform from a message of geometry_msgs or nav_msgs that contains a pose, with or without covariance. */
function ofPose({ header, pose }: Record<string, unknown>): RosTransform {
  const inner = (pose as { pose?: unknown } | undefined)?.pose ?? pose;
  const { position, orientation } = (inner ?? {}) as Record<string, Record<string, unknown> | undefined>;
  return { header: header as RosTransform['header'], transform: { translation: position, rotation: orientation } };
}

const FIELDS = ['position x', 'position y', 'position z', 'quaternion x', 'quaternion y', 'quaternion z', 'quaternion w'];

/** Gets the reason why a parent, a position and a quaternion are not a valid pose; null if they are. */
function refusalOf(parent: string, position: unknown[], quaternion: unknown[], source: string): Refusal | null {
  if (parent === '') return { reason: 'malformed', text: rosMessages.noParent(source) };
  const values = [...position, ...quaternion];
  const wrong = values.findIndex(value => typeof value !== 'number' || !Number.isFinite(value));
  if (wrong >= 0) return { reason: 'malformed', text: rosMessages.notFinite(FIELDS[wrong], source, values[wrong]) };
  if (unit(quaternion as number[]) === null) return { reason: 'not-unit', text: refusalMessages.quaternion(Math.hypot(...(quaternion as number[]))) };
  return tooFar(position as number[]);
}
