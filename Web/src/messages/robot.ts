import { format } from '../numbers';

/** Descriptions of the views of the robot for screen readers. */
export const robotDescriptions = {
  session: 'The robot of this session as it was, as it was displayed, and without compensation, at one moment.',
  live: 'The robot as it was half a second ago, and what the shown headset displayed for the same moment.',
};

/** Texts of the views of the robot. */
export const robotMessages = {
  keys: 'Arrow keys turn the view, plus and minus zoom, 0 resets; or drag, and double-click.',
  noWebGl: 'This browser has no WebGL, so the robot is not drawn. Everything else on this page works.',
  notShown: (reason: string) => `The robot cannot be shown: ${reason}.`,
  meshesReplaced: (count: number) => `Lines replace ${count} ${count === 1 ? 'part' : 'parts'} of the robot whose meshes are not on this page.`,
  noDescription: 'No robot description has arrived.',
  onlyOtherRobots: 'The robots in namespaces are drawn without the poses of headsets.',
  late: 'Joint positions arrive too late for a comparison.',
  noHeadset: 'No headset is shown.',
  toolUnknown: 'The position of the tool is not known, because the position of a joint is not known.',
  /** @param displayedMm Null if the headset does not report it, as for `heldMm`. */
  toolError: (headset: string, displayedMm: number | null, heldMm: number | null) => {
    const shown =
      displayedMm == null ? `${headset} does not report what it displays` : `${headset} shows the tool ${apart(displayedMm)} from where it was`;
    return heldMm == null ? `${shown}.` : `${shown}; without compensation ${heldMm < 0.1 ? '' : 'about '}${apart(heldMm)}.`;
  },
  /** @param joints The joints, each with the reason from `jointReasons`. */
  linksNotDrawn: (joints: string[]) => `${joints.join(', ')}: the links below are not drawn.`,
};

/** Reasons why the position of a joint is not known. */
export const jointReasons = {
  notReceived: (joint: string) => `${joint} has not been received`,
  inState: (joint: string, state: string) => `${joint} is ${state}`,
};

/** Reasons why a robot cannot be shown. */
export const robotReasons = { notUrdf: 'the robot description is not a URDF' };

// Predictions are not accurate enough for smaller differences.
const apart = (mm: number) => (mm < 0.1 ? 'less than 0.1\u00a0mm' : format(mm, 'mm'));
