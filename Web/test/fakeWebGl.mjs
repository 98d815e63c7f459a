/**
 * Runs in a page before its scripts. Replaces WebGL by functions that draw nothing, for tests that count the calls or look only at texts and labels,
 * because the processor needs half a second for the first picture of a page. `buffers` is the number of buffers in the graphics memory.
 */
export function fakeWebGl() {
  const gl = WebGL2RenderingContext.prototype, { getContext } = HTMLCanvasElement.prototype;
  const limits = [gl.MAX_TEXTURE_IMAGE_UNITS, gl.MAX_COMBINED_TEXTURE_IMAGE_UNITS, gl.MAX_VERTEX_ATTRIBS, gl.MAX_TEXTURE_SIZE, gl.MAX_SAMPLES];
  const parameters = new Map([
    [gl.VERSION, 'WebGL 2.0'], [gl.SHADING_LANGUAGE_VERSION, 'WebGL GLSL ES 3.00'], [gl.SCISSOR_BOX, [0, 0, 1, 1]], [gl.VIEWPORT, [0, 0, 1, 1]],
    ...limits.map(limit => [limit, 16]),
  ]);
  const results = {
    getContextAttributes: () => ({}), getExtension: () => null, getSupportedExtensions: () => [], getError: () => gl.NO_ERROR,
    isContextLost: () => false, checkFramebufferStatus: () => gl.FRAMEBUFFER_COMPLETE,
    getParameter: name => parameters.get(name) ?? 0, getShaderPrecisionFormat: () => ({ rangeMin: 127, rangeMax: 127, precision: 23 }),
    getShaderParameter: () => true, getShaderInfoLog: () => '', getProgramInfoLog: () => '',
    getProgramParameter: (_, name) => (name === gl.LINK_STATUS ? true : 0),
    createBuffer: () => { window.buffers++; return {}; }, deleteBuffer: () => { window.buffers--; },
  };
  window.buffers = 0;
  for (const [name, { value }] of Object.entries(Object.getOwnPropertyDescriptors(gl)))
    if (typeof value === 'function' && name !== 'constructor') gl[name] = results[name] ?? (name.startsWith('create') ? () => ({}) : () => null);
  HTMLCanvasElement.prototype.getContext = function (kind, ...options) {
    if (kind !== 'webgl2') return getContext.call(this, kind, ...options);
    return Object.create(gl, { canvas: { value: this }, drawingBufferWidth: { value: this.width }, drawingBufferHeight: { value: this.height } });
  };
}
