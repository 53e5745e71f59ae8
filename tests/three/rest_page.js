// What runs in the browser for rest.js: draws an input and an output as a viewer does, and compares the pictures.
import * as THREE from 'three';
import { GLTFLoader } from '/three/examples/jsm/loaders/GLTFLoader.js';
import { MeshoptDecoder } from '/three/examples/jsm/libs/meshopt_decoder.module.js';
import { begin, drawn } from '/stage.js';

window.begin = begin;

async function load(url) {
  const gltf = await new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).loadAsync(url);
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0x203040);
  const sun = new THREE.DirectionalLight(0xffffff, 2);
  sun.position.set(1, 2, 3);
  const back = new THREE.DirectionalLight(0xffffff, 1);
  back.position.set(-1, 1, -3);
  scene.add(gltf.scene, sun, back, new THREE.HemisphereLight(0xffffff, 0x404040, 1));
  gltf.scene.traverse((object) => { object.frustumCulled = false; }); // bounds are those at rest
  const objects = [];
  gltf.scene.traverse((object) => objects.push(object));
  return { scene, objects };
}

/// Puts an output where its input is: the same places, turns and weights of what both have.
function stand(output, input) {
  if (output.objects.length !== input.objects.length) throw new Error(`${output.objects.length} objects instead of ${input.objects.length}`);
  output.objects.forEach((object, i) => {
    const from = input.objects[i];
    object.position.copy(from.position);
    object.quaternion.copy(from.quaternion);
    object.scale.copy(from.scale);
    if (!object.morphTargetInfluences) return;
    object.morphTargetInfluences.fill(0);
    (from.morphTargetInfluences || []).forEach((weight, k) => { object.morphTargetInfluences[k] = weight; });
  });
}

/// Shares of px that differ by more than 1 of 255 between pictures.
function differing(a, b) {
  let count = 0;
  for (let at = 0; at < a.length; at += 4) {
    if ([0, 1, 2].some((c) => Math.abs(a[at + c] - b[at + c]) > 1)) ++count;
  }
  return count / (a.length / 4);
}

/// Draws the input and each output {url, posed}, all from cameras about `close` {middle, size, looks} or, without it, about the whole
/// model. A posed output is drawn as it is, too. Returns {covered: share of px that show something, colours, outputs: [{differs,
/// moved}]}.
window.compare = async (url, outputs, close) => {
  const input = await load(url);
  input.scene.updateMatrixWorld(true);
  const box = new THREE.Box3();
  for (const object of input.objects) if (object.isMesh) box.expandByObject(object, true);
  const whole = { middle: box.getCenter(new THREE.Vector3()).toArray(), size: box.getSize(new THREE.Vector3()).length() * 0.8, looks: 1 };
  const cameras = [close, whole].filter((one) => one).flatMap(({ middle, size, looks }) => [[0, 0, 1], [0.8, 0.3, 0.6]].map((direction) => ({
    eye: middle.map((x, axis) => x + (axis === 1 ? 1 : looks) * 2.2 * size * direction[axis]), look_at: middle, up: [0, 1, 0], vertical_fov_degrees: 30 })));
  const pictures = ({ scene }) => cameras.map((camera) => drawn(scene, camera, 2 * whole.size));
  const was = pictures(input);
  const colours = new Set();
  let covered = 1;
  for (const picture of was) {
    let shown = 0;
    for (let at = 0; at < picture.length; at += 4) {
      if (picture[at] === picture[0] && picture[at + 1] === picture[1] && picture[at + 2] === picture[2]) continue;
      ++shown;
      colours.add((picture[at] << 16) | (picture[at + 1] << 8) | picture[at + 2]);
    }
    covered = Math.min(covered, shown / (picture.length / 4));
  }
  const results = [];
  for (const { url: at, posed } of outputs) {
    const output = await load(at);
    const moved = posed ? Math.max(...pictures(output).map((picture, i) => differing(picture, was[i]))) : null;
    if (posed) stand(output, input);
    results.push({ differs: Math.max(...pictures(output).map((picture, i) => differing(picture, was[i]))), moved });
  }
  return { covered, colours: colours.size, outputs: results };
};
