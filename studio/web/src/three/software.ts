// SPDX-License-Identifier: GPL-3.0-or-later
// Whether pictures are drawn without a graphics card, which takes a hundred times as long.
const kSoftware = /swiftshader|llvmpipe|softpipe|software|basic render/i;

export const isSoftwareName = (renderer: string): boolean => kSoftware.test(renderer);

// Throws where the browser has no WebGL.
export function drawsInSoftware(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) throw new Error("no WebGL");
  const names = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return isSoftwareName(name);
}
