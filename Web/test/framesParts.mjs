// Shared by the tests of the cell's frames: messages of poses, and what is drawn.
import { fileURLToPath } from 'node:url';
import { buildSync } from 'esbuild';

const source = fileURLToPath(new URL('../src/robot/frames.ts', import.meta.url));
const { outputFiles } = buildSync({ entryPoints: [source], bundle: true, write: false, format: 'esm' });
export const { Frames } = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString('base64')}`);

export const message = (child, parent, t, x, angle = 0) => JSON.stringify({ msg: { transforms: [{
  header: { stamp: { sec: Math.floor(t), nanosec: Math.round((t % 1) * 1e9) }, frame_id: parent }, child_frame_id: child,
  transform: { translation: { x, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: Math.sin(angle / 2), w: Math.cos(angle / 2) } },
}] } });
export const none = () => null;
export const drawn = frames => frames.group.children.map(axes => (axes.visible ? Number(axes.position.x.toFixed(6)) : null));
export const states = frames => Object.fromEntries(frames.labels().map(({ name, state, at }) => [name, [state, Number(at.x.toFixed(6))]]));
/** Whether the axes of each frame are drawn in the colours of a current pose. */
export const coloured = frames => frames.group.children.map(axes => axes.material.vertexColors);
