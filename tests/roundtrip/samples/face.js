// A face with all that a file of a production has: two materials on shared vertices, pictures, two sets of texture coordinates,
// colours, tangents, clips, a camera, a light, and things that nobody knows.
'use strict';

const { Builder, png, k_jpeg } = require('./builder.js');
const { grid, target } = require('./surfaces.js');

const k_rows = 33;
const k_columns = 27;

/// The front of a head about `middle` [x, y, z], `size` tall, that looks along +z, or along -z.
const faceAt = (middle, size, looks = 1) => (u, v) => {
  const x = 0.8 * (u - 0.5);
  const y = 0.5 - v;
  const z = Math.sqrt(Math.max(0.05, 0.3 - 0.7 * x * x - 0.5 * y * y)) - 0.3;
  return [middle[0] + looks * size * x, middle[1] + size * y, middle[2] + looks * size * z];
};
const around = (x, y, cx, cy, rx, ry) => Math.exp(-(((x - cx) / rx) ** 2) - ((y - cy) / ry) ** 2);
/// Controls of the face, in its own measures: how (x, y) of the unit face moves.
const k_controls = {
  jawOpen: (x, y) => [0, -0.09 * around(x, y, 0, -0.32, 0.25, 0.13), -0.02 * around(x, y, 0, -0.32, 0.25, 0.13)],
  mouthSmileLeft: (x, y) => [0.05 * around(x, y, 0.15, -0.2, 0.09, 0.08), 0.05 * around(x, y, 0.15, -0.2, 0.09, 0.08), 0],
  browInnerUp: (x, y) => [0, 0.06 * around(x, y, 0, 0.22, 0.16, 0.07), 0],
};
const movedBy = (name, middle, size, looks = 1) => (px, py) => {
  const [x, y, z] = k_controls[name](looks * (px - middle[0]) / size, (py - middle[1]) / size);
  return [looks * size * x, size * y, looks * size * z];
};

/// Skin with dark brows and red lips, so that a picture shows where it is.
const skin = (u, v) => {
  const x = 0.8 * (u - 0.5);
  const y = 0.5 - v;
  const brow = around(Math.abs(x), y, 0.14, 0.22, 0.09, 0.025) > 0.5;
  const lip = around(x, y, 0, -0.2, 0.16, 0.03) > 0.5;
  return brow ? [60, 40, 30, 255] : lip ? [190, 60, 70, 255] : [230 - 40 * v, 190 - 20 * u, 160, 255];
};

/// Attributes of a surface as accessors.
function attributesOf(builder, surface, { colours = true, second = true } = {}) {
  const vertex = { target: 34962 };
  const attributes = {
    POSITION: builder.addAccessor(surface.positions, 'VEC3', { ...vertex, bounds: true, name: 'places', extras: { acme: 'kept' } }),
    NORMAL: builder.addAccessor(surface.normals, 'VEC3', vertex),
    TANGENT: builder.addAccessor(surface.tangents, 'VEC4', vertex),
    TEXCOORD_0: builder.addAccessor(surface.uv, 'VEC2', vertex),
  };
  if (second) {
    const other = surface.uv.map((x) => x * 65535);
    attributes.TEXCOORD_1 = builder.addAccessor(other, 'VEC2', { ...vertex, component: 5123, normalized: true });
  }
  if (colours) {
    const tint = surface.uv.flatMap((x, i) => (i % 2 === 0 ? [255, 255 - 60 * x] : [255 - 40 * x, 255]));
    attributes.COLOR_0 = builder.addAccessor(tint, 'VEC4', { ...vertex, component: 5121, normalized: true });
  }
  return attributes;
}
function targetOf(builder, moved, tangents = true) {
  const vertex = { target: 34962 };
  return {
    POSITION: builder.addAccessor(moved.positions, 'VEC3', { ...vertex, bounds: true }),
    NORMAL: builder.addAccessor(moved.normals, 'VEC3', vertex),
    ...(tangents ? { TANGENT: builder.addAccessor(moved.tangents, 'VEC3', vertex) } : {}),
  };
}
const cornersOf = (builder, corners) => builder.addAccessor(corners.flat(), 'SCALAR', { component: 5123, target: 34963 });

/// Adds the mesh and its materials. Returns the number of the mesh.
function addFace(builder, middle, size, looks = 1, more = {}) {
  const at = faceAt(middle, size, looks);
  const surface = grid(k_rows, k_columns, at);
  const attributes = { ...attributesOf(builder, surface), ...(more.attributes ? more.attributes(surface) : {}) };
  const names = Object.keys(k_controls);
  const targets = names.map((name) => targetOf(builder, target(surface, at, movedBy(name, middle, size, looks))));
  const upper = surface.corners.length / 2;
  const primitive = (corners, material, extra) =>
    ({ attributes, targets, indices: cornersOf(builder, corners), material, mode: 4, ...extra });
  return builder.add('meshes', {
    name: 'Gesicht 顔',
    primitives: [primitive(surface.corners.slice(0, upper), 0, { extensions: { ACME_strands: { count: 3 } } }),
                 primitive(surface.corners.slice(upper), 1, { extras: { acme: [1, { two: null }] } })],
    weights: names.map((name) => (more.standing || {})[name] || 0),
    extras: { targetNames: names, acme: true },
    extensions: { ACME_body: { part: 'head' } },
  });
}

/// Adds pictures, samplers, textures and two materials that use them. `more`: members of both materials.
function addMaterials(builder, more = {}) {
  const picture = builder.addPicture(png(64, skin), 'image/png', { name: 'skin', extras: { painter: 'somebody' } });
  const slope = builder.addPicture(k_jpeg, 'image/jpeg', { name: 'slope', extensions: { ACME_picture: { dpi: 72 } } });
  const sampler = builder.add('samplers', { magFilter: 9728, minFilter: 9987, wrapS: 33648, wrapT: 33071, extras: { acme: 's' } });
  const skinned = builder.add('textures', { name: 'skin', sampler, source: picture, extras: { acme: 't' } });
  const sloped = builder.add('textures', { source: slope, extensions: { ACME_texture: { layer: 2 } } });
  const normal = builder.add('textures', { sampler, source: slope });
  builder.add('materials', {
    name: 'Haut',
    pbrMetallicRoughness: { baseColorTexture: { index: skinned, extras: { acme: 1 } }, metallicFactor: 0, roughnessFactor: 0.9 },
    normalTexture: { index: normal, scale: 0.25, texCoord: 1 },
    doubleSided: true, extensions: { KHR_materials_clearcoat: { clearcoatFactor: 0.1 }, ACME_skin: { depth: 1.5e-3 }, ...more },
  });
  builder.add('materials', {
    name: 'Kinn', alphaMode: 'MASK', alphaCutoff: 0.25, doubleSided: true, extras: { acme: { deep: ['x', 1.25, false] } },
    pbrMetallicRoughness: {
      baseColorFactor: [1, 0.9, 0.8, 1], metallicFactor: 0,
      baseColorTexture: { index: sloped, texCoord: 1,
                          extensions: { KHR_texture_transform: { offset: [0.1, 0.2], scale: [2, 2], rotation: 0.3 } } } },
    ...(Object.keys(more).length > 0 ? { extensions: more } : {}),
  });
  builder.json.extensionsUsed = [...(builder.json.extensionsUsed || []), 'KHR_materials_clearcoat', 'KHR_texture_transform', 'ACME_skin',
                                 'ACME_strands', 'ACME_body', 'ACME_picture', 'ACME_texture', ...Object.keys(more)];
}

/// A clip of a mesh's weights, on node `node`, and of another node's place.
function addClip(builder, name, node, other, keys) {
  const input = builder.addAccessor([0, 0.5, 1], 'SCALAR', { bounds: true });
  const shift = builder.addAccessor([0, 0, 3, 0, 0.5, 3, 0, 0, 3], 'VEC3');
  builder.add('animations', {
    name, extras: { acme: 'clip' },
    samplers: [{ input, output: builder.addAccessor(keys, 'SCALAR'), interpolation: 'LINEAR' }, { input, output: shift, interpolation: 'STEP' }],
    channels: [{ sampler: 0, target: { node, path: 'weights' } }, { sampler: 1, target: { node: other, path: 'translation' }, extras: { acme: 2 } }],
  });
}

/// The face as a builder.
function face() {
  const builder = new Builder();
  addMaterials(builder);
  const mesh = addFace(builder, [0, 0, 0], 1, 1, { standing: { browInnerUp: 0.25 } }); // a face that is not at rest in its file
  const camera = builder.add('cameras', { type: 'perspective', perspective: { yfov: 0.6, znear: 0.01 }, extras: { lens: '85 mm' } });
  builder.add('nodes', { name: 'Kopf', children: [1, 2], scale: [2, 2, 2], extensions: { ACME_body: { root: true } } });
  builder.add('nodes', { name: 'Gesicht 顔', mesh, extras: { acme: 'node' } });
  builder.add('nodes', { name: 'Kamera', camera, translation: [0, 0, 3] });
  builder.add('nodes', { name: 'Licht', rotation: [0, 0.6, 0, 0.8], extensions: { KHR_lights_punctual: { light: 0 } } });
  builder.add('scenes', { name: 'Bühne', nodes: [0, 3], extras: { acme: 'scene' } });
  addClip(builder, 'says', 1, 2, [0, 0, 0, 1, 0, 0.5, 0, 0.25, 0]);
  addClip(builder, 'looks', 1, 2, [0, 0, 0, 0, 1, 0, 0.1, 0, 0]);
  builder.json.extensionsUsed.push('KHR_lights_punctual', 'ACME_studio');
  builder.json.extensions = { KHR_lights_punctual: { lights: [{ type: 'directional', intensity: 2, name: 'Sonne' }] },
                              ACME_studio: { list: [1, 'zwei', { three: [3.5, null, true] }] } };
  builder.json.extras = { author: 'somebody', notes: ['line', { deep: {} }] };
  return builder;
}

/// The face as .gltf with two buffers and its pictures beside it. Returns {files: {path: bytes}}; the first is the model.
function faceBeside() {
  const builder = face();
  const { json, binary } = builder;
  const files = {};
  const cut = json.bufferViews[6].byteOffset;
  for (const [i, image] of json.images.entries()) {
    const view = json.bufferViews[image.bufferView];
    image.uri = i === 0 ? 'tex/skin%201.png' : 'tex/slope.jpg';
    files[decodeURIComponent(image.uri)] = binary.subarray(view.byteOffset, view.byteOffset + view.byteLength);
    delete image.bufferView;
    delete image.mimeType;
  }
  for (const view of json.bufferViews) {
    if (view.byteOffset < cut) continue;
    view.buffer = 1;
    view.byteOffset -= cut;
  }
  files['face one.bin'] = binary.subarray(0, cut);
  files['more/face2.bin'] = binary.subarray(cut);
  json.buffers = [{ name: 'first', byteLength: cut, uri: 'face%20one.bin', extras: { acme: 'b' } }, { byteLength: binary.length - cut, uri: 'more/face2.bin' }];
  return { 'beside.gltf': Buffer.from(`${JSON.stringify(json, null, 1)}\n`), ...files };
}

/// A face whose places are 16-bit numbers (KHR_mesh_quantization) with targets of the same kind, and a second mesh without any.
function quantized() {
  const builder = new Builder();
  const at = faceAt([0, 0, 0], 1);
  const surface = grid(k_rows, k_columns, at);
  const small = (list, scale) => list.map((x) => Math.round(x * scale));
  const vertex = { component: 5122, target: 34962 };
  const moved = target(surface, at, movedBy('jawOpen', [0, 0, 0], 1));
  builder.json.extensionsUsed = ['KHR_mesh_quantization'];
  builder.json.extensionsRequired = ['KHR_mesh_quantization'];
  builder.add('meshes', {
    name: 'face',
    primitives: [{
      attributes: { POSITION: builder.addAccessor(small(surface.positions, 20000), 'VEC3', { ...vertex, bounds: true }),
                    NORMAL: builder.addAccessor(small(surface.normals, 32767), 'VEC3', { ...vertex, normalized: true }) },
      targets: [{ POSITION: builder.addAccessor(small(moved.positions, 20000), 'VEC3', { ...vertex, bounds: true }) }],
      indices: cornersOf(builder, surface.corners) }],
    extras: { targetNames: ['jawOpen'] } });
  const ball = grid(9, 9, (u, v) => [0.2 * (u - 0.5), 0.2 * (0.5 - v), 0.6]);
  builder.add('meshes', { name: 'plate', primitives: [{ attributes: attributesOf(builder, ball), indices: cornersOf(builder, ball.corners) }] });
  builder.add('nodes', { name: 'face', mesh: 0, scale: [1 / 20000, 1 / 20000, 1 / 20000] });
  builder.add('nodes', { name: 'plate', mesh: 1, translation: [1, 0, 0] });
  builder.add('scenes', { nodes: [0, 1] });
  return builder;
}

module.exports = { face, faceBeside, quantized, addFace, addMaterials, attributesOf, cornersOf, faceAt };
