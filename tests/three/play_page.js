// What runs in the browser: loads a file with three.js' GLTFLoader, plays its first animation with AnimationMixer, and
// compares vertices and outlines with the program's. Functions are called from play.js, by their names in `window`.
import * as THREE from 'three';
import { GLTFLoader } from '/three/examples/jsm/loaders/GLTFLoader.js';
import { begin, distances, drawn } from '/stage.js';

const white = new THREE.MeshBasicMaterial({ color: 0xffffff, side: THREE.DoubleSide });
const loaded = { meshes: [] };

window.begin = begin;

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
  const { off, flat } = distances(meshes, wanted.parts.map((part) => part.positions[i]));
  return { off: off / wanted.size, flat: flat / wanted.size };
};

/// Which px three.js covers, be it in part, rows from the top; of one part alone if it is named.
function covered(camera, part) {
  const { scene, meshes, wanted } = loaded;
  meshes.forEach((mesh, p) => { mesh.visible = part === null || wanted.parts[p].name === part; });
  const pixels = drawn(scene, camera, wanted.size);
  return Uint8Array.from({ length: pixels.length / 4 }, (_, at) => (pixels[4 * at] > 0 ? 1 : 0));
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
  const theirs = covered(camera, part);
  const background = await pixelsOf(empty);
  const shares = [];
  for (const picture of pictures) {
    const ours = await pixelsOf(picture);
    if (ours.length !== 4 * theirs.length) throw new Error(`${picture} has another size`);
    let both = 0;
    let either = 0;
    for (let at = 0; at < theirs.length; ++at) {
      const mine = [0, 1, 2].some((c) => Math.abs(ours[4 * at + c] - background[4 * at + c]) > 2);
      both += mine && theirs[at] ? 1 : 0;
      either += mine || theirs[at] ? 1 : 0;
    }
    shares.push(both / either);
  }
  return shares;
};
