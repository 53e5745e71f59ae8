// What runs in the browser for avatars.js: opens avatars with @pixiv/three-vrm, and plays expressions and VRM animations on them.
import * as THREE from 'three';
import { GLTFLoader } from '/three/examples/jsm/loaders/GLTFLoader.js';
import { VRMLoaderPlugin } from 'vrm';
import { VRMAnimationLoaderPlugin, createVRMAnimationClip } from 'vrm-animation';
import { distances } from '/stage.js';

let vrm;
let meshes; // of vertices of their own, in the order of the scene
let player;

const place = (node) => node.getWorldPosition(new THREE.Vector3()).toArray();

/// Opens an avatar. Returns what of it other programs rely on.
window.openAvatar = async (url) => {
  const loader = new GLTFLoader();
  loader.register((parser) => new VRMLoaderPlugin(parser));
  const gltf = await loader.loadAsync(url);
  vrm = gltf.userData.vrm;
  if (!vrm) throw new Error('three-vrm sees no avatar');
  const seen = new Set();
  meshes = [];
  vrm.scene.traverse((object) => {
    const position = object.isMesh ? object.geometry.attributes.position : null;
    if (position && !seen.has(position)) meshes.push(object);
    seen.add(position);
  });
  vrm.update(0);
  vrm.scene.updateMatrixWorld(true);
  const bones = Object.fromEntries(Object.entries(vrm.humanoid.humanBones).map(([bone, { node }]) => [bone, place(node)]));
  const rotations = Object.fromEntries(Object.entries(vrm.humanoid.rawRestPose).map(([bone, { rotation }]) => [bone, rotation]));
  const normalized = Object.values(vrm.humanoid.getNormalizedPose()).map(({ rotation }) => rotation || [0, 0, 0, 1]);
  return {
    bones, rotations,
    straight: normalized.every(([x, y, z]) => Math.hypot(x, y, z) < 1e-6),
    rest: {
      meta: [vrm.meta.metaVersion, vrm.meta.name || vrm.meta.title, vrm.meta.authors || vrm.meta.author],
      expressions: vrm.expressionManager.expressions.map((one) => [one.expressionName, one.isBinary, one.binds.length]),
      gaze: [vrm.lookAt.applier.constructor.name, vrm.lookAt.offsetFromHeadBone.toArray()],
      firstPerson: vrm.firstPerson.meshAnnotations.map((one) => [one.type, one.meshes.length]),
      springs: [...vrm.springBoneManager.joints].map((joint) => [joint.bone.name, joint.settings.stiffness, joint.colliderGroups.length]),
      materials: vrm.materials.map((material) => `${material.name} ${material.type}`).sort(), // they come as they are loaded
    },
  };
};

const distance = (positions) => {
  vrm.update(0);
  vrm.scene.updateMatrixWorld(true);
  if (meshes.length !== positions.length || meshes.some((mesh, i) => mesh.geometry.attributes.position.count !== positions[i].length / 3)) {
    throw new Error(`${meshes.length} meshes instead of ${positions.length}, or of other sizes`);
  }
  return distances(meshes, positions);
};

/// Sets expressions {name: value}, all others to nothing. Returns how far vertices are from `positions`.
window.express = (values, positions) => {
  vrm.expressionManager.resetValues();
  for (const [name, value] of Object.entries(values)) {
    if (!vrm.expressionManager.getExpression(name)) throw new Error(`three-vrm has no expression ${name}`);
    vrm.expressionManager.setValue(name, value);
  }
  return distance(positions);
};

/// Loads a VRM animation for the avatar that is open.
window.openMotion = async (url) => {
  const loader = new GLTFLoader();
  loader.register((parser) => new VRMAnimationLoaderPlugin(parser));
  const gltf = await loader.loadAsync(url);
  vrm.expressionManager.resetValues();
  vrm.humanoid.resetNormalizedPose();
  const mixer = new THREE.AnimationMixer(vrm.scene);
  const action = mixer.clipAction(createVRMAnimationClip(gltf.userData.vrmAnimations[0], vrm));
  action.setLoop(THREE.LoopOnce);
  action.clampWhenFinished = true;
  player = { mixer, action };
  return action.getClip().duration;
};

/// Goes to a time of the motion (s). Returns how far vertices are from `positions`.
window.goTo = (time, positions) => {
  player.action.reset().play();
  player.mixer.setTime(time);
  return distance(positions);
};
