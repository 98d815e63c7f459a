import type { Kind } from '../adapter';
import { type EntryOf, type PlantFile, type Silence, silenceMs } from './plantFile';
import { type Address, addressIn, type Value } from './values';
import type { Path, YamlFile } from './yamlFile';
import { valuesOf } from '../cell/framePose';
import { tooFar } from '../cell/messages';
import { configurationMessages, frameMessages } from '../messages/configuration';

/** Name of the anchored frame of the cell, the root of all frames. */
export const WORLD = 'world';

/** A component of a pose: a constant, or the index of a value that is read. */
export type Component = { constant: number } | { value: number };

/** The rotation of a frame: a unit quaternion x, y, z, w; a rotation vector; or three angles about the axes in `order`. `scale` converts to rad. */
type RotationSource =
  | { kind: 'quaternion'; parts: Component[] }
  | { kind: 'vector'; parts: Component[]; scale: number }
  | { kind: 'angles'; parts: Component[]; order: string; isFixed: boolean; scale: number };

/** Maximum number of transforms from a frame to its root, as in the gateway. */
const MAX_DEPTH = 16;

/** The settings of any object of the cell. */
export interface FrameSettings {
  frame: string;
  /** Time without data after which the frame has a fault, ms; null if a silent frame counts as at rest. */
  faultAfterMs: number | null;
  /** Maximum deceleration in m/s² and, for the rotation, rad/s²; null if unknown. */
  maxDeceleration: number | null;
}

/** An object of the cell. Its pose in its parent frame consists of numbers that are constant or read from the control system. */
export interface Frame extends FrameSettings {
  /** The possible parents. A single element is the parent at all times. */
  parents: string[];
  /** The number that selects the parent, counted from 0; null if there is a single parent. */
  selector: Component | null;
  /** x, y, z. */
  position: Component[];
  /** Factor that converts the position to m. */
  scale: number;
  /** The rotation relative to the parent; null if the frame has the parent's orientation. */
  rotation: RotationSource | null;
}

/** An entry of the list of frames. */
export type FrameEntry = EntryOf<'frames'>;

type NumberEntry = NonNullable<PlantFile<'opcua'>['frames']>[number]['position']['x'];

/** The entries with the rotation of a frame, of which it may have one. */
const ROTATIONS = ['quaternion', 'angles', 'rotation_vector'] as const;

const LENGTHS: Record<string, number> = { m: 1, mm: 0.001 };
const ANGLES: Record<string, number> = { rad: 1, deg: Math.PI / 180 };

/** Whether all components of the frame's pose are constant, so that the frame does not move relative to its parent. */
export const isStationary = ({ selector, position, rotation }: Frame): boolean =>
  selector === null && [...position, ...(rotation?.parts ?? [])].every(part => 'constant' in part);

/** Maximum deviation of the norm of a constant quaternion from 1. It is the deviation that the protocol allows. */
const MAX_NORM_ERROR = 0.001;

/**
 * Gets the frames of a configuration whose poses consist of individual values, and adds the values to be read for them to `values`.
 * @param whole Receives the settings of the other frames, whose poses arrive as a whole.
 */
export function framesOf(file: YamlFile, kind: Kind, entries: FrameEntry[], silence: Silence, values: Value[], whole: FrameSettings[]): Frame[] {
  const seen = new Map<string, number>();
  const paths: Path[] = [];
  const frames = entries.map(ofField).flatMap((entry, i): Frame[] => {
    const path: Path = ['frames', i];
    if (entry.frame === WORLD) file.report([...path, 'frame'], frameMessages.world(WORLD));
    if (seen.has(entry.frame)) file.report([...path, 'frame'], configurationMessages.nameTwice(entry.frame, seen.get(entry.frame), 'frame'));
    seen.set(entry.frame, file.lineOf([...path, 'frame']));
    const rotations = ROTATIONS.filter(name => entry[name] !== undefined);
    if (rotations.length > 1) file.report([...path, rotations[1]], frameMessages.severalRotations(rotations));
    reportQuaternion(file, entry, [...path, 'quaternion']);
    const settings = { frame: entry.frame, faultAfterMs: silenceMs(entry.silence ?? silence), maxDeceleration: entry.max_deceleration ?? null };
    if (entry.position === undefined) {
      whole.push(settings);
      return [];
    }
    paths.push(path);
    const { topic, type } = entry;
    const component = (at: Path, label: string, found: NumberEntry, numberUnit?: string): Component =>
      typeof found === 'number'
        ? { constant: found }
        : read(file, kind, { label: `${entry.frame} ${label}`, path: at, address: found, unit: numberUnit }, { topic, type }, values);
    const { x, y, z, unit } = entry.position;
    const frame: Frame = {
      ...settings,
      ...parentOf(entry, (label, found) => component([...path, 'parent'], label, found)),
      position: Object.entries({ x, y, z }).map(([name, found]) => component([...path, 'position', name], name, found, unit)),
      scale: LENGTHS[unit],
      rotation: rotationOf(entry, (at, ...number) => component([...path, ...at], ...number)),
    };
    warnOfSelector(file, kind, frame, values, [...path, 'parent']);
    return [frame];
  });
  frames.forEach((frame, i) => {
    reportDistance(file, frame, paths[i]);
    if (frame.frame !== WORLD) reportCycle(file, frames, frame, paths[i]);
  });
  return frames;
}

function ofField({ field, ...entry }: FrameEntry): FrameEntry {
  if (field === undefined) return entry;
  const [x, y, z, rx, ry, rz] = Array.from({ length: 6 }, (_, index) => ({ field, index }));
  return { ...entry, position: { unit: 'm', x, y, z }, rotation_vector: { unit: 'rad', x: rx, y: ry, z: rz } };
}

function parentOf({ parent = WORLD }: FrameEntry, component: (label: string, found: NumberEntry) => Component): Pick<Frame, 'parents' | 'selector'> {
  if (typeof parent === 'string') return { parents: [parent], selector: null };
  const { of, ...address } = parent;
  return { parents: of, selector: component('parent', address) };
}

function rotationOf(
  { quaternion, angles, rotation_vector: vector }: FrameEntry,
  component: (at: Path, label: string, found: NumberEntry, unit?: string) => Component,
): RotationSource | null {
  const parts = (key: string, numbers: Record<string, NumberEntry>, unit?: string): Component[] =>
    Object.entries(numbers).map(([name, found]) => component([key, name], `${key.replace('_', ' ')} ${name}`, found, unit));
  if (vector !== undefined) {
    const { x, y, z, unit } = vector;
    return { kind: 'vector', parts: parts('rotation_vector', { x, y, z }, unit), scale: ANGLES[unit] };
  }
  if (quaternion !== undefined) {
    const { x, y, z, w } = quaternion;
    return { kind: 'quaternion', parts: parts('quaternion', { x, y, z, w }) };
  }
  if (angles === undefined) return null;
  return {
    kind: 'angles',
    parts: angles.values.map((found, i) => component(['angles', 'values', i], `angle ${angles.order[i]}`, found, angles.unit)),
    order: angles.order,
    isFixed: angles.axes === 'fixed',
    scale: ANGLES[angles.unit],
  };
}

/**
 * Adds a value to be read. Reports an address that has the form of another kind of plant.
 * @param common The part of the address that all numbers of the frame share.
 */
function read(file: YamlFile, { address: allowed = [] }: Kind, { label, path, address, unit }: Value, common: Address, values: Value[]): Component {
  for (const key of Object.keys(address))
    if (!allowed.includes(key as keyof Address)) file.report([...path, key], configurationMessages.unknownEntry(undefined, allowed));
  if (address[allowed[0]] === undefined) file.report([...path, allowed[0]], frameMessages.noAddress(allowed[0]));
  values.push({ label, path, address: addressIn({ ...common, ...address }), unit });
  return { value: values.length - 1 };
}

/** Warns of a parent that is selected by another variable or message than the pose, if the two can arrive at different times. */
function warnOfSelector(file: YamlFile, { arrivesBy: key }: Kind, frame: Frame, values: Value[], path: Path): void {
  if (frame.selector === null || key === undefined) return;
  const sources = new Set(valuesOf(frame).map(index => values[index].address[key]));
  if (sources.size > 1) file.warn(path, frameMessages.separateSelector(key));
}

/** Reports a quaternion of four constants that is not a rotation. The values of other quaternions are checked when they arrive. */
function reportQuaternion(file: YamlFile, { frame, quaternion }: FrameEntry, path: Path): void {
  if (quaternion === undefined) return;
  const { x, y, z, w } = quaternion;
  const parts = [x, y, z, w].filter(part => typeof part === 'number');
  const norm = Math.hypot(...parts);
  if (parts.length === 4 && !(Math.abs(norm - 1) <= MAX_NORM_ERROR))
    file.report(path, frameMessages.constantQuaternion(parts, frame, norm, 1 - MAX_NORM_ERROR, 1 + MAX_NORM_ERROR));
}

/** Reports constant coordinates that are too large. Other coordinates are checked when they arrive. */
function reportDistance(file: YamlFile, { position, scale }: Frame, path: Path): void {
  position.forEach((part, i) => {
    if ('constant' in part && tooFar([part.constant * scale]) !== null)
      file.report([...path, 'position', 'xyz'[i]], frameMessages.tooFar(part.constant, part.constant * scale));
  });
}

/** Reports a frame that is its own ancestor, or too deep below the root. Each frame of a cycle is reported. The gateway checks frames whose parent changes. */
function reportCycle(file: YamlFile, frames: Frame[], { frame, parents: [parent, ...others] }: Frame, path: Path): void {
  const own = others.indexOf(frame);
  if (own >= 0) return file.report([...path, 'parent', 'of', own + 1], frameMessages.cycle(frame, [frame, frame], WORLD));
  const chain = [frame];
  for (let next: string | undefined = parent; next !== undefined && chain.length <= frames.length;) {
    chain.push(next);
    if (next === frame) return file.report([...path, 'parent'], frameMessages.cycle(parent, chain, WORLD));
    const above: Frame | undefined = others.length > 0 ? undefined : frames.find(f => f.frame === next);
    next = above?.parents.length === 1 ? above.parents[0] : undefined;
  }

  const depth = chain.length - 1;
  if (depth > MAX_DEPTH) file.report([...path, 'parent'], frameMessages.tooDeep(parent, depth, MAX_DEPTH));
}
