// What runs in the browser: loads a file with three.js' GLTFLoader, plays its first animation with AnimationMixer, and
// compares vertices and outlines with the program's. Functions are called from play.js, by their names in `window`.
import * as THREE from 'three';
import { GLTFLoader } from '/three/examples/jsm/loaders/GLTFLoader.js';

let renderer;
let target;
const white = new THREE.MeshBasicMaterial({ color: 0xffffff, side: THREE.DoubleSide });
const loaded = { meshes: [] };

/// Makes pictures of `side` x `side` px from now on. Returns the name of what draws them.
window.begin = (side) => {
  renderer = new THREE.WebGLRenderer({ antialias: false });
  renderer.setClearColor(0x000000);
  target = new THREE.WebGLRenderTarget(side, side, { samples: 4 });
  const gl = renderer.getContext();
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  return `three.js ${THREE.REVISION}, ${gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER)}`;
};

/// Loads NAME.glb and NAME.json (of write_three_positions) and finds each part's mesh, by name and number of vertices.
window.load = async (name) => {
  const [gltf, wanted] = await Promise.all(
    [new GLTFLoader().loadAsync(`/files/${name}.glb`), fetch(`/files/${name}.json`).then((r) => r.json())]);
  const { nodes, meshes } = gltf.parser.json;
  const found = [];
  gltf.scene.traverse((object) => {
    if (!object.isMesh) return;
    const from = gltf.parser.associations.get(object);
    object.material = white;
    object.frustumCulled = false; // its bounds are those at rest
    found.push({ object, names: [meshes[from.meshes].name, ...nodes.filter((n) => n.mesh === from.meshes).map((n) => n.name)] });
  });
  loaded.meshes = wanted.parts.map((part) => {
    const i = found.findIndex((f) => f.names.includes(part.name) &&
      f.object.geometry.attributes.position.count === part.positions[0].length / 3);
    if (i < 0) throw new Error(`${name}: three.js has no mesh "${part.name}" of ${part.positions[0].length / 3} vertices`);
    return found.splice(i, 1)[0].object;
  });
  if (found.length > 0) throw new Error(`${name}: three.js has ${found.length} meshes more`);
  const mixer = new THREE.AnimationMixer(gltf.scene);
  const action = mixer.clipAction(gltf.animations[0]);
  action.setLoop(THREE.LoopOnce);
  action.clampWhenFinished = true;
  Object.assign(loaded, { scene: gltf.scene, mixer, action, wanted });
  return Math.max(0, ...loaded.meshes.map((m) => m.morphTargetInfluences?.length ?? 0));
};

/// Goes to the i-th time. Returns in shares of the model's size how far the farthest vertex is from where the program has
/// it (`off`), and how far it would be without morph targets and skins (`flat`).
window.goTo = (i) => {
  const { scene, mixer, action, wanted, meshes } = loaded;
  action.reset().play();
  mixer.setTime(wanted.times[i]);
  scene.updateMatrixWorld(true);
  const point = new THREE.Vector3();
  const distance = (list, at) => Math.hypot(point.x - list[at], point.y - list[at + 1], point.z - list[at + 2]);
  let off = 0;
  let flat = 0;
  wanted.parts.forEach((part, p) => {
    const mesh = meshes[p];
    if (mesh.isSkinnedMesh) mesh.skeleton.update();
    for (let v = 0; v < part.positions[i].length / 3; ++v) {
      mesh.getVertexPosition(v, point).applyMatrix4(mesh.matrixWorld);
      off = Math.max(off, distance(part.positions[i], 3 * v)); // NaN stays
      point.fromBufferAttribute(mesh.geometry.attributes.position, v).applyMatrix4(mesh.matrixWorld);
      flat = Math.max(flat, distance(part.positions[i], 3 * v));
    }
  });
  return { off: off / wanted.size, flat: flat / wanted.size };
};

/// Which px three.js covers, be it in part, rows from the top; of one part alone if it is named.
function drawn(camera, part) {
  const { scene, meshes, wanted } = loaded;
  meshes.forEach((mesh, p) => { mesh.visible = part === null || wanted.parts[p].name === part; });
  const eye = new THREE.Vector3(...camera.eye);
  const far = eye.distanceTo(new THREE.Vector3(...camera.look_at)) + 2 * wanted.size;
  const view = new THREE.PerspectiveCamera(camera.vertical_fov_degrees, 1, far / 1000, far);
  view.position.copy(eye);
  view.up.set(...camera.up);
  view.lookAt(...camera.look_at);
  renderer.setRenderTarget(target);
  renderer.render(scene, view);
  const side = target.width;
  const pixels = new Uint8Array(4 * side * side);
  renderer.readRenderTargetPixels(target, 0, 0, side, side, pixels);
  return Uint8Array.from({ length: side * side }, (_, at) => {
    const row = side - 1 - Math.floor(at / side);
    return pixels[4 * (row * side + (at % side))] > 0 ? 1 : 0;
  });
}

async function pixelsOf(name) {
  const bitmap = await createImageBitmap(await (await fetch(`/files/${name}`)).blob());
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d', { willReadFrequently: true });
  context.drawImage(bitmap, 0, 0);
  return context.getImageData(0, 0, bitmap.width, bitmap.height).data;
}

/// The outline that three.js draws at the time of the last goTo, compared with the pictures of the program: the px
/// where a picture is not its empty background. Returns one share a picture: px covered in both / px covered in either.
window.agreement = async (camera, part, empty, pictures) => {
  const theirs = drawn(camera, part);
  const background = await pixelsOf(empty);
  const shares = [];
  for (const picture of pictures) {
    const ours = await pixelsOf(picture);
    if (ours.length !== 4 * theirs.length) throw new Error(`${picture} has another size`);
    let both = 0;
    let either = 0;
    for (let at = 0; at < theirs.length; ++at) {
      const covered = [0, 1, 2].some((c) => Math.abs(ours[4 * at + c] - background[4 * at + c]) > 2);
      both += covered && theirs[at] ? 1 : 0;
      either += covered || theirs[at] ? 1 : 0;
    }
    shares.push(both / either);
  }
  return shares;
};

window.ready = true;
