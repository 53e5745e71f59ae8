// What runs in the browser for looks.js: a head in the light that three.js's viewers have, a room and a sun.
import * as THREE from 'three';
import { GLTFLoader } from '/three/examples/jsm/loaders/GLTFLoader.js';
import { RoomEnvironment } from '/three/examples/jsm/environments/RoomEnvironment.js';
import { VRMLoaderPlugin } from 'vrm';

/// Where the head is, and from where it is seen from its front a little aside.
function cameraOf(scene, looks) {
  const box = new THREE.Box3().setFromObject(scene, true);
  const size = box.getSize(new THREE.Vector3());
  let head = null;
  scene.traverse((object) => { if (!head && object.isBone && /head$/i.test(object.name)) head = object.getWorldPosition(new THREE.Vector3()); });
  const high = head ? box.max.y - head.y : size.y;
  const middle = head ? head.clone().setY(head.y + 0.42 * high) : box.getCenter(new THREE.Vector3());
  const away = 4.4 * Math.max(high, 0.1 * size.y);
  const eye = middle.clone().add(new THREE.Vector3(0.35 * looks, 0.05, looks).normalize().multiplyScalar(away));
  return { eye: eye.toArray(), look_at: middle.toArray(), up: [0, 1, 0], vertical_fov_degrees: 22 };
}

/// Returns {camera, picture: base64 of a PNG}.
window.show = async (url, side) => {
  const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  renderer.setSize(side, side, false);
  const loader = new GLTFLoader();
  loader.register((parser) => new VRMLoaderPlugin(parser));
  const gltf = await loader.loadAsync(url);
  const vrm = gltf.userData.vrm;
  const root = vrm ? vrm.scene : gltf.scene;
  if (vrm) vrm.update(0);
  root.updateMatrixWorld(true);
  const camera = cameraOf(root, vrm && vrm.meta.metaVersion === '0' ? -1 : 1);
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0x3c434c);
  if (!vrm) scene.environment = new THREE.PMREMGenerator(renderer).fromScene(new RoomEnvironment(), 0.04).texture;
  const sun = new THREE.DirectionalLight(0xffffff, vrm ? Math.PI : 1.5);
  const eye = new THREE.Vector3(...camera.eye);
  const middle = new THREE.Vector3(...camera.look_at);
  const back = eye.clone().sub(middle).normalize();
  const right = new THREE.Vector3(0, 1, 0).cross(back).normalize();
  // The program's key: from the upper left of whoever looks.
  sun.position.copy(back.multiplyScalar(0.72).addScaledVector(right, -0.5).add(new THREE.Vector3(0, 0.62, 0)));
  scene.add(root, sun);
  root.traverse((object) => { object.frustumCulled = false; });
  const far = eye.distanceTo(middle);
  const view = new THREE.PerspectiveCamera(camera.vertical_fov_degrees, 1, far / 50, far * 10);
  view.position.copy(eye);
  view.lookAt(middle);
  renderer.render(scene, view);
  return { camera, picture: renderer.domElement.toDataURL('image/png').split(',')[1] };
};
