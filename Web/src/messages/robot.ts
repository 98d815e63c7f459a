import { format } from '../numbers';

/** Descriptions of the views of the robot for screen readers. */
export const robotDescriptions = {
  /** @param names The objects in the view; empty in a session without objects. */
  session: (names: string[]) =>
    'The robot of this session at one moment: its true pose, the displayed pose, and the pose without compensation.'
    + (names.length === 0 ? '' : ` Objects beside it: ${names.join(', ')}.`),
  live: 'The true pose of the robot half a second ago, and the pose that the selected headset displayed at that time.',
};

/** Names of the parts of the cell that carry the workpieces. */
export const partLabels = { belt: 'conveyor', fixture: 'fixture' };

/** Kind of the view of the robot for screen readers. */
export const robotLabels = { view: '3D view' };

/** Text of the views of the robot. */
export const robotMessages = {
  keys: 'Drag to turn the view, and double-click to reset it. On the keyboard, the arrow keys turn the view, plus and minus zoom, and 0 resets it.',
  noWebGl: 'This browser has no WebGL, so the robot is not drawn. Everything else on this page works.',
  interrupted:
    'The browser has stopped drawing the 3D view, for example because the graphics driver was restarted. If it does not go on, reload the page.',
  notShown: (reason: string) => `The robot cannot be shown: ${reason}.`,
  meshesReplaced: (count: number) =>
    `Lines replace ${count} ${count === 1 ? 'part' : 'parts'} of the robot, because meshes are not part of this page.`,
  noDescription: 'No robot description has arrived.',
  late: 'Joint positions arrive too late for a comparison.',
  /** @param time Time at which the connection was lost. */
  noConnection: (time: string) =>
    `This page has had no connection for joint positions since ${time}, so no robot is drawn. The page connects again by itself. `
    + 'If it does not, look for an alarm about the maximum number of connections, and check the network. '
    + 'An iPad or iPhone must also trust the certificate of the gateway.',
  baseUnknown: 'The robot is not drawn, because the pose of its base is not known.',
  /** @param names The root links of the robots. */
  basesUnknown: (names: string[]) => `Robots that are not drawn, because the poses of their bases are not known: ${names.join(', ')}.`,
  noHeadset: 'No headset is shown.',
  toolUnknown: 'The position of the tool is not known, because the position of a joint is not known.',
  /** @param displayedMm Tool error of the displayed pose; null if the headset does not report the pose. The same applies to `heldMm`. */
  toolError: (headset: string, displayedMm: number | null, heldMm: number | null) => {
    const shown =
      displayedMm == null
        ? `${headset} does not report the displayed pose`
        : `${headset} displays the tool ${apart(displayedMm)} from its true position`;
    return heldMm == null ? `${shown}.` : `${shown}; without compensation ${heldMm < 0.1 ? '' : 'about '}${apart(heldMm)}.`;
  },
  /** @param robot Namespace of the robot. */
  displaysUnknown: (headset: string, robot: string) => `${headset} displays the robot ${robot}, whose description has not arrived.`,
  /** @param joints The joints, each with the reason from `jointReasons`. */
  linksNotDrawn: (joints: string[]) => `${joints.join(', ')}: links below these joints are not drawn.`,
  /** @param names The objects, each with its state. */
  objectsNotDrawn: (names: string[], count: number) =>
    `Objects that are not drawn, because their poses are not known: ${names.join(', ')}${count === 0 ? '' : `, and ${count} more`}.`,
  labelsHidden: (count: number) =>
    count === 1 ? '1 more label does not fit; zoom in to see it.' : `${count} more labels do not fit; zoom in to see them.`,
};

/** States of a frame that the page itself can detect. They have the names of the gateway's states. */
export const frameStates = { stale: 'stale', parentStale: 'parent-stale' };

/** Reasons why the position of a joint is not known. */
export const jointReasons = {
  notReceived: (joint: string) => `${joint} has not been received`,
  noData: (joint: string) => `${joint} has no data at the displayed time`,
  notPublished: (joint: string) => `${joint} is no longer published`,
  inState: (joint: string, state: string) => `${joint} is ${state}`,
};

/** Reasons why a robot or a frame cannot be shown. */
export const robotReasons = { notUrdf: 'the robot description is not a URDF' };

// Smaller differences are not meaningful, because predictions are not that accurate.
const apart = (mm: number) => (mm < 0.1 ? 'less than 0.1\u00a0mm' : format(mm, 'mm'));
