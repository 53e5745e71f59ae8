// What pages share: the pictures that three.js draws, and how far its vertices are from where the program has them.
import * as THREE from 'three';

let renderer;
let target;

/// Makes pictures of `side` x `side` px from now on. Returns the name of what draws them.
export function begin(side) {
  renderer = new THREE.WebGLRenderer({ antialias: false });
  renderer.setClearColor(0x000000);
  target = new THREE.WebGLRenderTarget(side, side, { samples: 4 });
  const gl = renderer.getContext();
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  return `three.js ${THREE.REVISION}, ${gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER)}`;
}

/// A picture of a scene from {eye, look_at, up, vertical_fov_degrees}: rows of RGBA from the top. `size`: of what is seen.
export function drawn(scene, camera, size) {
  const eye = new THREE.Vector3(...camera.eye);
  const far = eye.distanceTo(new THREE.Vector3(...camera.look_at)) + 2 * size;
  const view = new THREE.PerspectiveCamera(camera.vertical_fov_degrees, 1, far / 1000, far);
  view.position.copy(eye);
  view.up.set(...camera.up);
  view.lookAt(...camera.look_at);
  renderer.setRenderTarget(target);
  renderer.render(scene, view);
  const side = target.width;
  const pixels = new Uint8Array(4 * side * side);
  renderer.readRenderTargetPixels(target, 0, 0, side, side, pixels);
  const rows = new Uint8Array(pixels.length);
  for (let row = 0; row < side; ++row) rows.set(pixels.subarray(4 * side * (side - 1 - row), 4 * side * (side - row)), 4 * side * row);
  return rows;
}

/// How far the farthest vertex of meshes is from `positions` (a flat list a mesh), and how far it would be without morph targets
/// and skins (`flat`). NaN stays.
export function distances(meshes, positions) {
  const point = new THREE.Vector3();
  let off = 0;
  let flat = 0;
  meshes.forEach((mesh, m) => {
    const list = positions[m];
    const distance = (at) => Math.hypot(point.x - list[at], point.y - list[at + 1], point.z - list[at + 2]);
    if (mesh.isSkinnedMesh) mesh.skeleton.update();
    for (let v = 0; v < list.length / 3; ++v) {
      mesh.getVertexPosition(v, point).applyMatrix4(mesh.matrixWorld);
      off = Math.max(off, distance(3 * v));
      point.fromBufferAttribute(mesh.geometry.attributes.position, v).applyMatrix4(mesh.matrixWorld);
      flat = Math.max(flat, distance(3 * v));
    }
  });
  return { off, flat };
}
