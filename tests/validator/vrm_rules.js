// What the specifications of VRM 0.x and 1.0 ask of an avatar, and UniVRM of a file that it loads, as far as it is said by the JSON
// of the file: faultsOf(document) lists what is wrong, one line each; tPoseFaults(before, after) nodes that rest otherwise, for whoever
// loads an avatar takes its nodes for the T-pose; avatarFaults(file, before) both.
'use strict';

const fs = require('fs');

const required = ['hips', 'spine', 'head', ...['left', 'right'].flatMap((side) =>
  ['UpperLeg', 'LowerLeg', 'Foot', 'UpperArm', 'LowerArm', 'Hand'].map((part) => side + part))];
const parents = {
  spine: 'hips', chest: 'spine', upperChest: 'chest', neck: 'upperChest', head: 'neck', leftEye: 'head', rightEye: 'head', jaw: 'head',
};
for (const side of ['left', 'right']) {
  Object.assign(parents, {
    [`${side}UpperLeg`]: 'hips', [`${side}LowerLeg`]: `${side}UpperLeg`, [`${side}Foot`]: `${side}LowerLeg`,
    [`${side}Toes`]: `${side}Foot`, [`${side}Shoulder`]: 'upperChest', [`${side}UpperArm`]: `${side}Shoulder`,
    [`${side}LowerArm`]: `${side}UpperArm`, [`${side}Hand`]: `${side}LowerArm`,
  });
}

function faultsOf(document) {
  const faults = [];
  const check = (good, what) => { if (!good) faults.push(what); };
  const extensions = document.extensions || {};
  const list = (name) => document[name] || [];
  const isIn = (name, index) => Number.isInteger(index) && index >= 0 && index < list(name).length;
  const is = (value, ...kinds) => kinds.includes(value === undefined ? 'none' : Array.isArray(value) ? 'list' : typeof value);
  const oneOf = (value, choices) => value === undefined || choices.includes(value);
  const used = new Set(document.extensionsUsed || []);
  for (const name of Object.keys(extensions)) check(used.has(name), `${name} is not among the extensions used`);

  const parentOf = new Map();
  list('nodes').forEach((node, n) => (node.children || []).forEach((child) => parentOf.set(child, n)));
  const isBelow = (node, above) => {
    for (let n = parentOf.get(node); n !== undefined; n = parentOf.get(n)) if (n === above) return true;
    return false;
  };
  const targetsOf = (mesh) => Math.min(...list('meshes')[mesh].primitives.map((primitive) => (primitive.targets || []).length));

  function checkBones(bones, wanted) {
    for (const bone of wanted) check(bones.has(bone), `the bone ${bone} is missing`);
    const seen = new Set();
    for (const [bone, node] of bones) {
      check(isIn('nodes', node), `${bone} is node ${node}, which is not there`);
      check(!seen.has(node), `node ${node} is two bones`);
      seen.add(node);
      let up = parents[bone];
      while (up && !bones.has(up)) up = parents[up];
      if (up) check(isBelow(node, bones.get(up)), `${bone} is not below ${up}`);
    }
  }

  function checkVrm1(vrm) {
    check(vrm.specVersion === '1.0' || vrm.specVersion === '1.0-beta', `specVersion is ${vrm.specVersion}`);
    const meta = vrm.meta || {};
    check(is(meta.name, 'string') && meta.name !== '', 'meta has no name');
    check(is(meta.authors, 'list') && meta.authors.length > 0 && meta.authors.every((one) => is(one, 'string')), 'meta has no authors');
    check(is(meta.licenseUrl, 'string') && meta.licenseUrl !== '', 'meta has no licenseUrl');
    check(meta.thumbnailImage === undefined || isIn('images', meta.thumbnailImage), 'the thumbnail is no image');
    check(oneOf(meta.avatarPermission, ['onlyAuthor', 'onlySeparatelyLicensedPerson', 'everyone']), 'meta.avatarPermission');
    check(oneOf(meta.commercialUsage, ['personalNonProfit', 'personalProfit', 'corporation']), 'meta.commercialUsage');
    const human = (vrm.humanoid || {}).humanBones || {};
    checkBones(new Map(Object.entries(human).map(([bone, of]) => [bone, of.node])), required);
    for (const one of (vrm.firstPerson || {}).meshAnnotations || []) {
      check(isIn('nodes', one.node) && list('nodes')[one.node].mesh !== undefined, `first person: node ${one.node} shows no mesh`);
      check(is(one.type, 'string') && oneOf(one.type, ['auto', 'both', 'thirdPersonOnly', 'firstPersonOnly']), `first person: ${one.type}`);
    }
    check(oneOf((vrm.lookAt || {}).type, ['bone', 'expression']), 'lookAt.type');
    const { preset = {}, custom = {} } = vrm.expressions || {};
    for (const name of Object.keys(custom)) check(!(name in preset), `the expression ${name} is there twice`);
    for (const [name, expression] of [...Object.entries(preset), ...Object.entries(custom)]) {
      check(is(expression.isBinary, 'boolean', 'none'), `${name}.isBinary`);
      for (const key of ['overrideBlink', 'overrideLookAt', 'overrideMouth']) {
        check(oneOf(expression[key], ['none', 'block', 'blend']), `${name}.${key}`);
      }
      for (const bind of expression.morphTargetBinds || []) {
        const mesh = isIn('nodes', bind.node) ? list('nodes')[bind.node].mesh : undefined;
        check(mesh !== undefined, `${name}: node ${bind.node} shows no mesh`);
        check(mesh !== undefined && Number.isInteger(bind.index) && bind.index >= 0 && bind.index < targetsOf(mesh), `${name}: target ${bind.index}`);
        check(is(bind.weight, 'number') && bind.weight >= 0 && bind.weight <= 1, `${name}: weight ${bind.weight}`);
      }
      for (const bind of [...(expression.materialColorBinds || []), ...(expression.textureTransformBinds || [])]) {
        check(isIn('materials', bind.material), `${name}: material ${bind.material}`);
      }
    }
  }

  function checkSprings(springs) {
    check(springs.specVersion === '1.0' || springs.specVersion === '1.0-beta', `springs: specVersion is ${springs.specVersion}`);
    const colliders = springs.colliders || [];
    for (const one of colliders) check(isIn('nodes', one.node), `a collider is of node ${one.node}`);
    const groups = springs.colliderGroups || [];
    for (const group of groups) for (const one of group.colliders) check(colliders[one] !== undefined, `there is no collider ${one}`);
    const seen = new Set();
    for (const spring of springs.springs || []) {
      const joints = (spring.joints || []).map((joint) => joint.node);
      check(joints.length > 0, 'a spring has no joints');
      joints.forEach((node, i) => {
        check(isIn('nodes', node), `a spring is of node ${node}`);
        check(!seen.has(node), `node ${node} springs twice`);
        seen.add(node);
        if (i > 0) check(isBelow(node, joints[i - 1]), `spring: node ${node} is not below ${joints[i - 1]}`);
      });
      for (const group of spring.colliderGroups || []) check(groups[group] !== undefined, `there is no collider group ${group}`);
      check(spring.center === undefined || isIn('nodes', spring.center), `spring: center ${spring.center}`);
    }
  }

  function checkVrm0(vrm) {
    const meta = vrm.meta || {};
    check(meta.texture === undefined || meta.texture === -1 || isIn('textures', meta.texture), 'the thumbnail is no texture');
    check(oneOf(meta.allowedUserName, ['OnlyAuthor', 'ExplicitlyLicensedPerson', 'Everyone']), 'meta.allowedUserName');
    const human = (vrm.humanoid || {}).humanBones || [];
    check(new Set(human.map((one) => one.bone)).size === human.length, 'a bone is there twice');
    checkBones(new Map(human.map((one) => [one.bone, one.node])), [...required, 'chest', 'neck']);
    const first = vrm.firstPerson || {};
    check(first.firstPersonBone === undefined || first.firstPersonBone === -1 || isIn('nodes', first.firstPersonBone), 'firstPersonBone');
    for (const one of first.meshAnnotations || []) {
      check(isIn('meshes', one.mesh), `first person: mesh ${one.mesh}`);
      check(is(one.firstPersonFlag, 'string') && oneOf(one.firstPersonFlag, ['Auto', 'Both', 'ThirdPersonOnly', 'FirstPersonOnly']), `first person: ${one.firstPersonFlag}`);
    }
    for (const group of (vrm.blendShapeMaster || {}).blendShapeGroups || []) {
      for (const bind of group.binds || []) {
        const there = isIn('meshes', bind.mesh);
        check(there, `${group.name}: mesh ${bind.mesh}`);
        check(there && Number.isInteger(bind.index) && bind.index >= 0 && bind.index < targetsOf(bind.mesh), `${group.name}: target ${bind.index}`);
        check(is(bind.weight, 'number') && bind.weight >= 0 && bind.weight <= 100, `${group.name}: weight ${bind.weight}`);
      }
    }
    const second = vrm.secondaryAnimation || {};
    for (const group of second.colliderGroups || []) check(isIn('nodes', group.node), `a collider is of node ${group.node}`);
    for (const group of second.boneGroups || []) {
      for (const bone of group.bones || []) check(isIn('nodes', bone), `a spring is of node ${bone}`);
      for (const one of group.colliderGroups || []) check((second.colliderGroups || [])[one] !== undefined, `there is no collider group ${one}`);
    }
    check((vrm.materialProperties || []).length === list('materials').length, 'materialProperties are not as many as materials');
  }

  if (extensions.VRMC_vrm) checkVrm1(extensions.VRMC_vrm);
  if (extensions.VRMC_springBone) checkSprings(extensions.VRMC_springBone);
  if (extensions.VRM) checkVrm0(extensions.VRM);
  if (!extensions.VRMC_vrm && !extensions.VRM) faults.push('it is no avatar');
  return faults;
}

function tPoseFaults(before, after) {
  return (before.nodes || []).flatMap((node, n) =>
    ['matrix', 'translation', 'rotation', 'scale'].filter(
      (key) => JSON.stringify(node[key]) !== JSON.stringify(((after.nodes || [])[n] || {})[key]))
      .map((key) => `/nodes/${n}/${key} is another one at rest`));
}

/// The document of a .glb file.
function documentOf(bytes) {
  return JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)).toString('utf8'));
}

/// What VRM's rules find in an avatar, and where its T-pose is no longer that of the file from which it was read.
function avatarFaults(file, before) {
  if (!file.endsWith('.vrm')) return [];
  const document = documentOf(fs.readFileSync(file));
  const rest = fs.existsSync(before) ? tPoseFaults(documentOf(fs.readFileSync(before)), document) : [];
  return [...faultsOf(document), ...rest];
}

module.exports = { avatarFaults, faultsOf, tPoseFaults, documentOf };
