// node vrm_rules_test.js FOLDER: that vrm_rules.js finds nothing in FOLDER/read/avatar0.vrm and avatar1.vrm, and something in
// each of many broken ones.
'use strict';

const assert = require('assert');
const fs = require('fs');
const path = require('path');
const { faultsOf, tPoseFaults, documentOf } = require('./vrm_rules.js');

const read = (name) => documentOf(fs.readFileSync(path.join(process.argv[2], 'read', name)));
const breaks = {
  'avatar1.vrm': [
    (d) => { delete d.extensions.VRMC_vrm.humanoid.humanBones.leftHand; },
    (d) => { d.extensions.VRMC_vrm.humanoid.humanBones.jaw.node = d.extensions.VRMC_vrm.humanoid.humanBones.leftEye.node; },
    (d) => { d.extensions.VRMC_vrm.humanoid.humanBones.hips.node = 999; },
    (d) => { d.nodes.forEach((node) => { delete node.children; }); },
    (d) => { d.extensions.VRMC_vrm.specVersion = '2.0'; },
    (d) => { d.extensions.VRMC_vrm.meta.authors = []; },
    (d) => { delete d.extensions.VRMC_vrm.meta.licenseUrl; },
    (d) => { d.extensions.VRMC_vrm.expressions.preset.happy.morphTargetBinds[0].index = 40; },
    (d) => { d.extensions.VRMC_vrm.expressions.preset.happy.morphTargetBinds[0].node = 1; },
    (d) => { d.extensions.VRMC_vrm.expressions.preset.happy.overrideBlink = 'never'; },
    (d) => { d.extensions.VRMC_vrm.expressions.custom.happy = {}; },
    (d) => { d.extensions.VRMC_vrm.firstPerson.meshAnnotations[0].node = 1; },
    (d) => { delete d.meshes[0].primitives[0].targets; },
    (d) => { d.extensions.VRMC_springBone.springs[0].joints.reverse(); },
    (d) => { d.extensions.VRMC_springBone.springs[0].colliderGroups = [1]; },
    (d) => { d.extensions.VRMC_springBone.colliders[0].node = -1; },
    (d) => { d.extensionsUsed = []; },
    (d) => { d.extensions = {}; },
  ],
  'avatar0.vrm': [
    (d) => { d.extensions.VRM.humanoid.humanBones.shift(); },
    (d) => { d.extensions.VRM.humanoid.humanBones.push(d.extensions.VRM.humanoid.humanBones[0]); },
    (d) => { d.extensions.VRM.blendShapeMaster.blendShapeGroups[0].binds[0].index = 9; },
    (d) => { d.extensions.VRM.blendShapeMaster.blendShapeGroups[0].binds[0].mesh = 9; },
    (d) => { d.extensions.VRM.blendShapeMaster.blendShapeGroups[0].binds[0].weight = 101; },
    (d) => { d.extensions.VRM.firstPerson.meshAnnotations[0].mesh = 9; },
    (d) => { d.extensions.VRM.secondaryAnimation.boneGroups[0].bones = [99]; },
    (d) => { d.extensions.VRM.materialProperties = []; },
  ],
};
for (const [name, all] of Object.entries(breaks)) {
  assert.deepStrictEqual(faultsOf(read(name)), [], name);
  all.forEach((change) => {
    const document = read(name);
    change(document);
    assert.notDeepStrictEqual(faultsOf(document), [], `${name}: ${change}`);
  });
}
const turned = read('avatar1.vrm');
turned.nodes[3].rotation = [0, 0, 0.6, 0.8];
assert.strictEqual(tPoseFaults(read('avatar1.vrm'), turned).length, 1);
assert.deepStrictEqual(tPoseFaults(turned, turned), []);
