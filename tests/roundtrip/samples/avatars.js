// Avatars with all that VRM 0.x and 1.0 have a place for: humanoid, expressions, gaze, first person, metadata, spring bones, MToon.
'use strict';

const { Builder } = require('./builder.js');
const { grid, rotated, turned, undoing, minus } = require('./surfaces.js');
const { addFace, addMaterials, attributesOf, cornersOf } = require('./face.js');

/// Bones with their places in T-pose, in metres, for a figure that looks along +z; parents come first.
const k_bones = [
  ['hips', null, [0, 0.9, 0]], ['spine', 'hips', [0, 1.02, 0]], ['chest', 'spine', [0, 1.18, 0]], ['neck', 'chest', [0, 1.38, 0]],
  ['head', 'neck', [0, 1.48, 0]], ['leftEye', 'head', [0.03, 1.56, 0.06]], ['rightEye', 'head', [-0.03, 1.56, 0.06]],
  ...['left', 'right'].flatMap((side) => {
    const s = side === 'left' ? 1 : -1;
    return [[`${side}UpperArm`, 'chest', [0.16 * s, 1.34, 0]], [`${side}LowerArm`, `${side}UpperArm`, [0.42 * s, 1.34, 0]],
            [`${side}Hand`, `${side}LowerArm`, [0.66 * s, 1.34, 0]], [`${side}UpperLeg`, 'hips', [0.09 * s, 0.86, 0]],
            [`${side}LowerLeg`, `${side}UpperLeg`, [0.09 * s, 0.46, 0]], [`${side}Foot`, `${side}LowerLeg`, [0.09 * s, 0.08, 0]]];
  }),
];
/// Rotations in the world at rest of a figure whose bones are not those of the world; those that are not named are as their parents'.
const k_rolled = { hips: [0, 0.6, 0, 0.8], head: [0.28, 0, 0, 0.96], leftUpperArm: [0, 0, -0.6, 0.8], rightUpperArm: [0.5, 0.5, 0.5, 0.5],
                   leftUpperLeg: [0.8, 0, 0, 0.6] };

/// Tubes of the body, from bone to bone.
const k_limbs = [
  ['hips', 'spine', 0.12], ['spine', 'chest', 0.12], ['chest', 'neck', 0.11], ['neck', 'head', 0.05],
  ...['left', 'right'].flatMap((s) => [[`${s}UpperArm`, `${s}LowerArm`, 0.045], [`${s}LowerArm`, `${s}Hand`, 0.035],
                                       [`${s}UpperLeg`, `${s}LowerLeg`, 0.07], [`${s}LowerLeg`, `${s}Foot`, 0.05]]),
];

function tube(from, to, radius) {
  const along = minus(to, from);
  const upright = Math.abs(along[1]) > Math.abs(along[0]);
  return (u, v) => {
    const a = (upright ? 1 : -1) * 2 * Math.PI * u;
    const round = upright ? [radius * Math.sin(a), 0, radius * Math.cos(a)] : [0, radius * Math.sin(a), radius * Math.cos(a)];
    return from.map((x, axis) => x + along[axis] * (upright ? 1 - v : v) + round[axis]);
  };
}

/// Adds the figure: nodes of bones, and after them hair that swings. Returns {node: {bone: number}, joints, matrices}.
function addFigure(builder, looks, rolled) {
  const place = {};
  const world = {};
  const node = {};
  for (const [bone, parent, at] of k_bones) {
    place[bone] = [looks * at[0], at[1], looks * at[2]];
    world[bone] = rolled[bone] || (parent ? world[parent] : [0, 0, 0, 1]);
    const up = parent ? world[parent] : [0, 0, 0, 1];
    const back = [-up[0], -up[1], -up[2], up[3]];
    const made = { name: `骨 ${bone}`, translation: rotated(back, parent ? minus(place[bone], place[parent]) : place[bone]), extras: { acme: bone } };
    const rotation = turned(back, world[bone]);
    if (rotation[3] < 1 - 1e-12) made.rotation = rotation;
    node[bone] = builder.add('nodes', made);
    if (parent) (builder.json.nodes[node[parent]].children ||= []).push(node[bone]);
  }
  node.hair = builder.add('nodes', { name: 'hair', translation: [0, 0.2, -0.1 * looks], children: [builder.json.nodes.length + 1] });
  node.hairEnd = builder.add('nodes', { name: 'hair end', translation: [0, -0.1, 0] });
  builder.json.nodes[node.head].children.push(node.hair);
  const joints = k_bones.map(([bone]) => node[bone]);
  return { node, place, joints, matrices: k_bones.flatMap(([bone]) => undoing(world[bone], place[bone])) };
}
const jointOf = (bone) => k_bones.findIndex(([name]) => name === bone);
const bound = (builder, joints, weights) => ({
  JOINTS_0: builder.addAccessor(joints, 'VEC4', { component: 5121, target: 34962 }),
  WEIGHTS_0: builder.addAccessor(weights, 'VEC4', { target: 34962 }),
});

/// Adds the meshes, their skin and the scene. Returns the numbers of the nodes of both, and the figure.
function addBodyAndFace(builder, looks, rolled) {
  const figure = addFigure(builder, looks, rolled);
  const face = addFace(builder, [0, 1.6, 0.08 * looks], 0.24, looks, {
    attributes: (surface) => {
      const count = surface.positions.length / 3;
      return bound(builder, Array.from({ length: count }, () => [jointOf('head'), 0, 0, 0]).flat(),
                   Array.from({ length: count }, () => [1, 0, 0, 0]).flat());
    },
  });
  const primitives = k_limbs.map(([from, to, radius]) => {
    const surface = grid(9, 13, tube(figure.place[from], figure.place[to], radius));
    const upright = Math.abs(figure.place[to][1] - figure.place[from][1]) > 0.01;
    const shares = surface.uv.filter((_, i) => i % 2 === 1).map((v) => (upright ? 1 - v : v)).map((t) => Math.fround(t * t * 0.75));
    return { attributes: { ...attributesOf(builder, surface, { colours: false, second: true }),
                           ...bound(builder, shares.flatMap((t) => [jointOf(from), t > 0 ? jointOf(to) : 0, 0, 0]),
                                    shares.flatMap((t) => [Math.fround(1 - t), t, 0, 0])) },
             indices: cornersOf(builder, surface.corners), material: 0 };
  });
  const body = builder.add('meshes', { name: 'body', primitives });
  const skin = builder.add('skins', { joints: figure.joints, inverseBindMatrices: builder.addAccessor(figure.matrices, 'MAT4'),
                                      skeleton: figure.node.hips, extras: { acme: 'skin' }, name: 'skin' });
  figure.face = builder.add('nodes', { name: 'face', mesh: face, skin });
  figure.body = builder.add('nodes', { name: 'body', mesh: body, skin, extensions: { ACME_cloth: {} } });
  builder.add('scenes', { nodes: [figure.node.hips, figure.face, figure.body] });
  builder.json.extensionsUsed.push('ACME_cloth');
  return { ...figure, mesh: { face, body } };
}

/// VRM 1.0; bones at rest are turned, and do not have names that tell them.
function avatar1() {
  const builder = new Builder();
  addMaterials(builder, { VRMC_materials_mtoon: { specVersion: '1.0', shadeColorFactor: [0.7, 0.5, 0.5], shadingToonyFactor: 0.9,
                                                  outlineWidthMode: 'none', giEqualizationFactor: 0.9 } });
  const { node, face, body } = addBodyAndFace(builder, 1, k_rolled);
  const binds = (list) => list.map(([index, weight]) => ({ node: face, index, weight }));
  const expression = (list, more = {}) => ({ morphTargetBinds: binds(list), isBinary: false, overrideBlink: 'none', overrideLookAt: 'none', overrideMouth: 'none', ...more });
  builder.json.extensionsUsed.push('VRMC_vrm', 'VRMC_springBone');
  builder.json.extensions = {
    VRMC_vrm: {
      specVersion: '1.0',
      meta: { name: 'Somebody', version: '2', authors: ['Nobody'], licenseUrl: 'https://vrm.dev/licenses/1.0/', thumbnailImage: 0,
              avatarPermission: 'everyone', commercialUsage: 'corporation', modification: 'allowModificationRedistribution' },
      humanoid: { humanBones: Object.fromEntries(k_bones.map(([bone]) => [bone, { node: node[bone], extras: { acme: 1 } }])) },
      firstPerson: { meshAnnotations: [{ node: face, type: 'thirdPersonOnly' }, { node: body, type: 'both' }] },
      lookAt: { type: 'bone', offsetFromHeadBone: [0, 0.08, 0.06], rangeMapHorizontalInner: { inputMaxValue: 90, outputScale: 10 },
                rangeMapHorizontalOuter: { inputMaxValue: 90, outputScale: 12 }, rangeMapVerticalDown: { inputMaxValue: 90, outputScale: 8 },
                rangeMapVerticalUp: { inputMaxValue: 90, outputScale: 8 } },
      expressions: {
        preset: { happy: expression([[1, 1], [2, 0.25]], { overrideMouth: 'block' }), aa: expression([[0, 0.75]]),
                  surprised: expression([[0, 0.5], [2, 1]], { isBinary: true }) },
        custom: { blush: expression([], { materialColorBinds: [{ material: 0, type: 'color', targetValue: [1, 0.6, 0.6, 1] }],
                                          textureTransformBinds: [{ material: 1, scale: [1, 1], offset: [0.5, 0] }] }) },
      },
      extras: { acme: 'vrm' },
    },
    VRMC_springBone: {
      specVersion: '1.0',
      colliders: [{ node: node.head, shape: { sphere: { offset: [0, 0.1, 0], radius: 0.1 } } }],
      colliderGroups: [{ name: 'head', colliders: [0] }],
      springs: [{ name: 'hair', joints: [{ node: node.hair, hitRadius: 0.02, stiffness: 1, gravityPower: 0.1, gravityDir: [0, -1, 0], dragForce: 0.4 },
                                         { node: node.hairEnd }], colliderGroups: [0] }],
    },
  };
  return builder;
}

/// VRM 0.x: looks along -z, bones without rotations, names of targets in the primitives.
function avatar0() {
  const builder = new Builder();
  addMaterials(builder);
  const { node, face, mesh } = addBodyAndFace(builder, -1, {});
  const object = builder.json.meshes[mesh.face];
  for (const primitive of object.primitives) primitive.extras = { ...primitive.extras, targetNames: object.extras.targetNames };
  delete object.extras.targetNames;
  const group = (name, presetName, list, more = {}) =>
    ({ name, presetName, isBinary: false, binds: list.map(([index, weight]) => ({ mesh: mesh.face, index, weight })), materialValues: [], ...more });
  const degree = (xRange, yRange) => ({ curve: [0, 0, 0, 1, 1, 1, 1, 0], xRange, yRange });
  builder.json.extensionsUsed.push('VRM');
  builder.json.extensions = {
    VRM: {
      exporterVersion: 'UniVRM-0.99.0', specVersion: '0.0',
      meta: { title: 'Somebody', version: '1', author: 'Nobody', texture: 0, allowedUserName: 'Everyone', violentUssageName: 'Disallow',
              sexualUssageName: 'Disallow', commercialUssageName: 'Allow', licenseName: 'CC0', otherLicenseUrl: '' },
      humanoid: { humanBones: k_bones.map(([bone]) => ({ bone, node: node[bone], useDefaultValues: true })), armStretch: 0.05, legStretch: 0.05,
                  upperArmTwist: 0.5, lowerArmTwist: 0.5, upperLegTwist: 0.5, lowerLegTwist: 0.5, feetSpacing: 0, hasTranslationDoF: false },
      firstPerson: { firstPersonBone: node.head, firstPersonBoneOffset: { x: 0, y: 0.06, z: 0 },
                     meshAnnotations: [{ mesh: mesh.face, firstPersonFlag: 'ThirdPersonOnly' }, { mesh: mesh.body, firstPersonFlag: 'Both' }],
                     lookAtTypeName: 'Bone', lookAtHorizontalInner: degree(90, 8), lookAtHorizontalOuter: degree(90, 12),
                     lookAtVerticalDown: degree(90, 10), lookAtVerticalUp: degree(90, 10) },
      blendShapeMaster: { blendShapeGroups: [group('Joy', 'joy', [[1, 100], [2, 25]]), group('A', 'a', [[0, 75]]), group('Neutral', 'neutral', []),
                                             group('Surprised', 'unknown', [[0, 50], [2, 100]], { isBinary: true })] },
      secondaryAnimation: {
        boneGroups: [{ comment: 'hair', stiffiness: 1, gravityPower: 0.1, gravityDir: { x: 0, y: -1, z: 0 }, dragForce: 0.4, center: -1,
                       hitRadius: 0.02, bones: [node.hair], colliderGroups: [0] }],
        colliderGroups: [{ node: node.head, colliders: [{ offset: { x: 0, y: 0.1, z: 0 }, radius: 0.1 }] }],
      },
      materialProperties: ['Haut', 'Kinn'].map((name) => ({ name, renderQueue: 2000, shader: 'VRM_USE_GLTFSHADER', floatProperties: {}, vectorProperties: {},
                                                             textureProperties: {}, keywordMap: {}, tagMap: {} })),
    },
  };
  return builder;
}

/// A motion (.vrma) of a figure with other rotations at rest: head, arms and a leg turn, the hips move, "happy" comes up and goes.
function motion() {
  const builder = new Builder();
  const rolled = { hips: [0.6, 0, 0, 0.8], head: [0, 0, 0.6, 0.8], leftUpperArm: [0, 0.8, 0, 0.6] };
  const { node, place } = addFigure(builder, 1, rolled);
  const happy = builder.add('nodes', { name: 'happy' });
  builder.add('scenes', { nodes: [node.hips, happy] });
  const input = builder.addAccessor([0, 0.4, 1], 'SCALAR', { bounds: true });
  const samplers = [];
  const channels = [];
  const add = (of, path, keys, type) => {
    samplers.push({ input, output: builder.addAccessor(keys, type) });
    channels.push({ sampler: samplers.length - 1, target: { node: of, path } });
  };
  const turns = { head: [0.28, 0, 0, 0.96], leftUpperArm: [0, 0, 0.6, 0.8], rightLowerArm: [0, 0.6, 0, 0.8], leftUpperLeg: [-0.6, 0, 0, 0.8],
                  spine: [0, 0.28, 0, 0.96] };
  for (const [bone, turn] of Object.entries(turns)) {
    const rest = builder.json.nodes[node[bone]].rotation || [0, 0, 0, 1];
    add(node[bone], 'rotation', [...rest, ...turned(rest, turn), ...rest], 'VEC4');
  }
  add(node.hips, 'translation', [...place.hips, 0.1, 0.85, 0.05, ...place.hips], 'VEC3');
  add(happy, 'translation', [0, 0, 0, 1, 0, 0, 0.25, 0, 0], 'VEC3');
  builder.add('animations', { name: 'motion', samplers, channels });
  builder.json.extensionsUsed = ['VRMC_vrm_animation'];
  builder.json.extensions = {
    VRMC_vrm_animation: {
      specVersion: '1.0', humanoid: { humanBones: Object.fromEntries(k_bones.map(([bone]) => [bone, { node: node[bone] }])) },
      expressions: { preset: { happy: { node: happy } } },
    } };
  return builder;
}

module.exports = { avatar0, avatar1, motion };
