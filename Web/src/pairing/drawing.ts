import qrcode from 'qrcode-generator';
import { svg } from '../dom';

/** Width of the quiet zone around a code, in modules. Code readers need it. */
const MARGIN = 4;

/** A drawn code, and its number of modules along an edge without the quiet zone. */
interface Drawing {
  element: SVGElement;
  modules: number;
}

export function draw(text: string): Drawing {
  const code = qrcode(0, 'M');
  // eslint-disable-next-line nowpose/messages -- the name of a mode of the code
  code.addData(text, 'Byte');
  code.make();
  const modules = code.getModuleCount();
  let path = '';
  for (let row = 0; row < modules; row++)
    for (let column = 0; column < modules; column++) if (code.isDark(row, column)) path += `M${column + MARGIN} ${row + MARGIN}h1v1h-1z`;
  const edge = modules + 2 * MARGIN;
  const element = svg(
    'svg',
    { viewBox: `0 0 ${edge} ${edge}`, 'shape-rendering': 'crispEdges' },
    svg('rect', { width: edge, height: edge, fill: '#fff' }),
    svg('path', { d: path, fill: '#000' }),
  );
  return { element, modules };
}

/**
 * Sets the printed edge length of the code without the quiet zone, in mm.
 * @returns The width of the drawing with the quiet zone, in mm.
 */
export function setEdge({ element, modules }: Drawing, edgeMm: number): number {
  const total = (edgeMm * (modules + 2 * MARGIN)) / modules;
  element.setAttribute('width', `${total}mm`);
  element.setAttribute('height', `${total}mm`);
  return total;
}
