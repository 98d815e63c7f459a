import type { Joint } from '../configuration/configuration';

/** Maximum number of forwarded joints. */
export const MAX_JOINTS = 256;

/**
 * A forwarded joint and the conversion of its values. `index` is the index of the joint in the configuration or, without configured joints, its
 * position in the order in which the joints were first received.
 */
export interface OutJoint {
  index: number;
  /** Cell-wide name: NAMESPACE/NAME for a robot with a namespace. */
  joint: string;
  name: string;
  scale: number;
  offset: number;
  /** Whether the position is known to be a length in m. */
  isLinear: boolean;
  /** Maximum deceleration, rad/s² or m/s²; null if unknown. */
  maxDeceleration: number | null;
}

/** Selects and renames the joints that are forwarded: the joints in the configuration, or all joints if it lists none. */
export class JointNames {
  readonly #known = new Map<string, OutJoint>();

  /**
   * @param namespace Namespace of the robot; empty if it has none.
   * @param maxDeceleration Maximum deceleration of the joints that the configuration does not list; null if unknown.
   */
  constructor(
    joints: Joint[],
    readonly namespace = '',
    readonly maxDeceleration: number | null = null,
  ) {
    joints.forEach(({ joint, name, source, topic, scale, offset, isLinear = false, maxDeceleration: limit = null }, index) => {
      // Skips a joint with its own topic, because the joint states do not contain it.
      if (topic === undefined) this.#known.set(source ?? name, { index, joint, name, scale, offset, isLinear, maxDeceleration: limit });
    });
    this.isOpen = joints.length === 0;
  }

  readonly isOpen: boolean;

  /** Whether further joints are not forwarded although the configuration does not list any. */
  get isFull(): boolean {
    return this.isOpen && this.#known.size >= MAX_JOINTS;
  }

  /** Gets a joint by the name that the robot uses for it; undefined if the joint is not forwarded. */
  find(source: unknown): OutJoint | undefined {
    if (typeof source !== 'string') return undefined;
    const known = this.#known.get(source);
    if (known !== undefined || !this.isOpen || this.isFull || source === '') return known;
    const joint = this.namespace === '' ? source : `${this.namespace}/${source}`;
    const { maxDeceleration } = this;
    const added = { index: this.#known.size, joint, name: source, scale: 1, offset: 0, isLinear: false, maxDeceleration };
    this.#known.set(source, added);
    return added;
  }
}
