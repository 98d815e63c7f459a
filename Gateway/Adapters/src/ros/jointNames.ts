import type { Joint } from '../configuration/configuration';

const MOST_JOINTS = 256;

/** A joint of the robot as it leaves: its place among the joints that were seen, and how its values become ours. */
export interface OutJoint {
  index: number;
  joint: string;
  scale: number;
  offset: number;
  /** Whether the position is known to be a length in m. */
  isLinear: boolean;
}

/** Which of the robot's joints pass, and under which name: those of the configuration, or all where it lists none. */
export class JointNames {
  readonly #known = new Map<string, OutJoint>();

  constructor(joints: Joint[]) {
    joints.forEach(({ joint, source, scale, offset, isLinear }, index) =>
      this.#known.set((source as string | undefined) ?? joint, { index, joint, scale, offset, isLinear: isLinear === true }));
    this.isOpen = joints.length === 0;
  }

  readonly isOpen: boolean;

  /** Undefined: not passed on. */
  find(source: unknown): OutJoint | undefined {
    if (typeof source !== 'string') return undefined;
    const known = this.#known.get(source);
    if (known !== undefined || !this.isOpen || this.#known.size >= MOST_JOINTS || source === '') return known;
    const added = { index: this.#known.size, joint: source, scale: 1, offset: 0, isLinear: false };
    this.#known.set(source, added);
    return added;
  }
}
