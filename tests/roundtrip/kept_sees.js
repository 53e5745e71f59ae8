// node kept_sees.js FOLDER: changes outputs of kept.js in FOLDER as a careless writer would, and sees that rules.js finds each change.
// Prints a line a change; exit status 1 if one is not found.
'use strict';

const fs = require('fs');
const path = require('path');
const { faultsOf } = require('./rules.js');

const folder = path.resolve(process.argv[2]);

/// A .glb with its JSON and its buffer changed.
function changed(file, change) {
  const bytes = fs.readFileSync(file);
  const end = 20 + bytes.readUInt32LE(12);
  const json = JSON.parse(bytes.toString('utf8', 20, end));
  const binary = Buffer.from(bytes.subarray(end));
  change(json, binary.subarray(8));
  let text = JSON.stringify(json);
  while (Buffer.byteLength(text) % 4 !== 0) text += ' ';
  const head = Buffer.from(bytes.subarray(0, 20));
  head.writeUInt32LE(Buffer.byteLength(text), 12);
  head.writeUInt32LE(20 + Buffer.byteLength(text) + binary.length, 8);
  return Buffer.concat([head, Buffer.from(text), binary]);
}

const flip = (view) => (json, binary) => { binary[json.bufferViews[view(json)].byteOffset + 5] ^= 1; };
const target = (json) => json.meshes[0].primitives[0].targets;
const k_changes = [
  ['face', 'posed', 'a byte of a picture', flip((json) => json.images[0].bufferView)],
  ['face', 'posed', 'a byte of texture coordinates', flip((json) => json.accessors[json.meshes[0].primitives[0].attributes.TEXCOORD_1].bufferView)],
  ['face', 'posed', 'no tangents', (json) => { delete json.meshes[0].primitives[0].attributes.TANGENT; }],
  ['face', 'posed', 'no extension that nobody knows', (json) => { delete json.textures[1].extensions; }],
  ['face', 'posed', 'no extras of a channel', (json) => { delete json.animations[0].channels[1].extras; }],
  ['face', 'posed', 'null for nothing', (json) => { json.extensions.ACME_studio.list[2].three.splice(1, 1); }],
  ['face', 'posed', 'another sampler', (json) => { json.samplers[0].wrapS = 10497; }],
  ['face', 'posed', 'a texture transform lost', (json) => { delete json.materials[1].pbrMetallicRoughness.baseColorTexture.extensions; }],
  ['face', 'posed', 'another weight than was asked for', (json) => { json.meshes[0].weights[0] += 0.01; }],
  ['face', 'posed', 'a weight that nobody asked for', (json) => { json.meshes[0].weights[2] = 0; }],
  ['face', 'posed', 'no pose', (json) => { json.meshes[0].weights[0] = 0; }],
  ['face', 'posed', 'a node more', (json) => { json.nodes.push({}); }],
  ['face', 'posed', 'another generator', (json) => { json.asset.generator = 'penpose'; }],
  ['face', 'drawn', 'a target in front', (json) => { for (const p of json.meshes[0].primitives) p.targets.unshift(p.targets.pop()); }],
  ['face', 'drawn', 'a target without normals', (json) => { delete target(json)[target(json).length - 1].NORMAL; }],
  ['face', 'drawn', 'another name', (json) => { json.meshes[0].extras.targetNames[3] = 'target'; }],
  ['face', 'drawn', 'keys of another clip', (json) => { json.animations[0].samplers[0].output = json.animations[1].samplers[0].output; }],
  ['face', 'moved', 'an animation lost', (json) => { json.animations.shift(); }],
  ['face', 'moved', 'two animations more', (json) => { json.animations.push(json.animations[0]); }],
  ['beside', 'posed', 'a picture that is not in the file', (json) => { json.images[0] = { ...json.images[0], uri: 'tex/skin%201.png' }; }],
  ['avatar1', 'drawn', 'an expression lost', (json) => { delete json.extensions.VRMC_vrm.expressions.custom; }],
  ['avatar1', 'posed', 'spring bones lost', (json) => { delete json.extensions.VRMC_springBone; }],
  ['avatar1', 'posed', 'a joint elsewhere', (json) => { json.nodes[3].translation[1] += 0.01; }],
  ['avatar0', 'moved', 'a curve of the gaze', (json) => { json.extensions.VRM.firstPerson.lookAtHorizontalInner.curve[7] = 1; }],
];

function main() {
  const list = JSON.parse(fs.readFileSync(path.join(folder, 'outputs.json')));
  let good = true;
  for (const [name, kind, what, change] of k_changes) {
    const model = list.find((one) => one.name === name);
    const output = model.outputs.find((one) => one.kind === kind && !one.file.endsWith('.gltf'));
    const file = path.join(folder, `changed${path.extname(output.file)}`);
    fs.writeFileSync(file, changed(output.file, () => {}));
    const fair = faultsOf(model, { ...output, file }).length === 0;
    fs.writeFileSync(file, changed(output.file, change));
    let found;
    try {
      found = faultsOf(model, { ...output, file }).length > 0;
    } catch (error) { // a file that cannot be read
      found = error.code === 'ENOENT';
    }
    console.log(`${name}.${kind}: ${what}: ${found ? 'seen' : 'NOT SEEN'}${fair ? '' : ', and so is no change: WRONG'}`);
    good = good && found && fair;
  }
  process.exitCode = good ? 0 : 1;
}

main();
