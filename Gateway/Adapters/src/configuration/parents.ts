import { type FrameEntry, WORLD } from './frames';
import { nearest } from './nearest';
import { linksIn } from './robot';
import type { Path, YamlFile } from './yamlFile';
import { frameMessages } from '../messages/configuration';

/**
 * Reports parents that are unknown links of a robot of the file. If the file describes robots, also warns of parents without a namespace that are
 * neither frames of the file nor links of its robots, because such a parent must come from another source.
 * @param urdfs The descriptions of the file's robots by namespace.
 */
export function checkParents(file: YamlFile, frames: FrameEntry[], urdfs: Record<string, string>): void {
  const links = new Map(Object.entries(urdfs).map(([robot, urdf]) => [robot, qualified(robot, linksIn(urdf))]));
  const known = new Set([WORLD, ...frames.map(({ frame }) => frame), ...[...links.values()].flat()]);
  const check = (parent: string, path: Path): void => {
    if (known.has(parent)) return;
    const robot = parent.includes('/') ? parent.slice(0, parent.indexOf('/')) : '';
    const own = links.get(robot);
    if (robot !== '' && own !== undefined) file.report(path, frameMessages.noLink(parent, robot, nearest(parent, own)[0]));
    else if (robot === '' && links.size > 0) {
      const [similar] = nearest(parent, [...known].map(bare));
      const guess = [...known].find(name => bare(name) === similar);
      file.warn(path, frameMessages.otherParent(parent, guess));
    }
  };
  frames.forEach(({ parent }, i) => {
    const path = ['frames', i, 'parent'];
    if (typeof parent === 'string') check(parent, path);
    else parent?.of.forEach((one, choice) => check(one, [...path, 'of', choice]));
  });
}

const bare = (name: string): string => name.slice(name.indexOf('/') + 1);

const qualified = (robot: string, links: string[]): string[] => (robot === '' ? links : links.map(link => `${robot}/${link}`));
