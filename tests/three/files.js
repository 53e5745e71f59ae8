// The files that three.js is to play, all written by the program.
'use strict';

const { execFileSync } = require('child_process');
const fs = require('fs');
const path = require('path');

function run(program, ...args) {
  execFileSync(program, args, { stdio: ['ignore', 'ignore', 'inherit'] });
}

/// Copies a .glb file that the program wrote so that it reads itself what others see: no project and no deformers, but the
/// morph targets as the ordinary blend shapes of a foreign file.
function copyAsTargets(from, to) {
  const bytes = fs.readFileSync(from);
  const end = 20 + bytes.readUInt32LE(12); // of the JSON chunk, the first
  const document = JSON.parse(bytes.subarray(20, end).toString());
  delete document.extras;
  let text = JSON.stringify(document);
  while (Buffer.byteLength(text) % 4 !== 0) text += ' ';
  const head = Buffer.from(bytes.subarray(0, 20));
  head.writeUInt32LE(Buffer.byteLength(text), 12);
  head.writeUInt32LE(20 + Buffer.byteLength(text) + bytes.length - end, 8);
  fs.writeFileSync(to, Buffer.concat([head, Buffer.from(text), bytes.subarray(end)]));
}

/// Writes the files into `folder`. Returns [{name, tolerance (of the size), closeUp (name of a part)}, ...].
/// The demo's sketched deformers are baked to morph targets, which is exact to 1e-3 of the size; with the targets read as
/// ordinary blend shapes the same file must be shown alike to the last digits. Its weights are cubic splines.
function makeFiles(penpose, folder, shared) {
  const at = (name) => path.join(folder, name);
  run(penpose, 'demo', '-o', folder);
  copyAsTargets(at('demo.glb'), at('demo_targets.glb'));
  const files = [
    { name: 'demo', tolerance: 1e-3, closeUp: 'lips' },
    { name: 'demo_targets', tolerance: 1e-4, closeUp: 'lips' },
  ];
  const mesh = (name) => path.join(shared, 'meshes', name);
  const track = path.join(shared, 'tracks', 'openface_head_test.csv');
  if (fs.existsSync(mesh('ict_face.glb')) && fs.existsSync(track)) {
    run(penpose, 'animate', mesh('ict_face.glb'), '--track', track, '--head', 'apply', '-o', at('tracked_face.glb'));
    files.push({ name: 'tracked_face', tolerance: 1e-4 });
  }
  for (const name of ['cesium_man', 'animated_morph_cube']) { // a skin, and joints and shapes that move
    if (!fs.existsSync(mesh(`${name}.glb`))) continue;
    run(penpose, 'convert', mesh(`${name}.glb`), at(`${name}.glb`));
    files.push({ name, tolerance: 1e-4 });
  }
  return files;
}

module.exports = { makeFiles, run };
