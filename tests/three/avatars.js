// node avatars.js PENPOSE WRITE_THREE_POSITIONS MODULE_FOLDER CHROMIUM SAMPLES FOLDER: avatars of roundtrip/kept.js (in SAMPLES) opened by
// @pixiv/three-vrm in headless Chromium. Posed, drawn on and animated they are still the avatars that they were; their
// expressions, and VRM animations from elsewhere and of the program's own, move every vertex as the program does. Prints
// a line a check; exit status 1 if one fails, 77 where Chromium or the modules are missing.
'use strict';

const fs = require('fs');
const path = require('path');
const { needBrowser, withPage } = require('./browser.js');
const { run } = require('../roundtrip/make_files.js');

const [penpose, writePositions, moduleFolder, chromium, samples, folder] = process.argv.slice(2).map((p) => path.resolve(p));
const k_off = 1e-5; // of the height: numbers of files and of graphics are floats
const k_height = 1.7; // m

let good = true;
function tell(fits, line) {
  console.log(`${line}${fits ? '' : ' WRONG'}`);
  good = good && fits;
}
const addressOf = (file) => `/${file.startsWith(samples + path.sep) ? `samples/${path.relative(samples, file)}` : `files/${path.basename(file)}`}`;
const positionsOf = (objFile) => {
  const parts = [];
  for (const line of fs.readFileSync(objFile, 'utf8').split('\n')) {
    if (line.startsWith('o ')) parts.push([]);
    if (line.startsWith('v ')) parts[parts.length - 1].push(...line.slice(2).split(' ').slice(0, 3).map(Number));
  }
  return parts;
};

/// A person who stands with arms out, as tall as before.
function checkRest(name, was, now) {
  const { bones: b } = now;
  const side = Math.sign(was.bones.leftHand[0]);
  const upright = b.head[1] > b.hips[1] + 0.3 && b.hips[1] > b.leftFoot[1] + 0.5 && b.hips[1] > b.rightFoot[1] + 0.5;
  const out = side * b.leftHand[0] > 0.3 && side * b.rightHand[0] < -0.3;
  const off = Math.max(...Object.keys(was.bones).map((bone) => Math.hypot(...b[bone].map((x, axis) => x - was.bones[bone][axis]))));
  tell(now.straight && upright && out, `${name}: stands ${upright ? 'upright' : 'askew'}, arms ${out ? 'out' : 'elsewhere'}; bones at rest are off by ${off.toExponential(1)} m`);
  return off;
}

/// `known`: [[name in three-vrm, name in the file, value], ...].
async function checkExpressions(page, model, output, known) {
  const name = path.basename(output.file);
  for (const [expression, own, value] of known) {
    const obj = path.join(folder, `${name}.${expression}.obj`);
    // What stands in the file gives way to an expression that moves the same targets.
    run(penpose, 'convert', output.file, ...Object.keys(model.set).filter((c) => output.atRest || !c.includes('.')).flatMap((c) => ['--set', `${c}=0`]),
        '--set', `${own}=${value}`, obj);
    const { off, flat } = await page.evaluate((all) => window.express(...all), [{ [expression]: value }, positionsOf(obj)]);
    tell(off <= k_off * k_height && flat > 1e-3, `${name}: ${expression} = ${value}: vertices off by ${off.toExponential(1)} m (still ${flat.toExponential(1)})`);
  }
}

/// Plays a motion on the avatar, or on `output`, which was made of it.
async function checkMotion(page, model, name, motion, output = model) {
  const clip = path.join(folder, `${model.name}.${name}.clip.glb`);
  run(penpose, 'animate', model.file, '--track', motion, '-o', clip);
  run(writePositions, clip, `${clip}.json`);
  const wanted = JSON.parse(fs.readFileSync(`${clip}.json`));
  await page.evaluate((url) => window.openAvatar(url), addressOf(output.file));
  const seconds = await page.evaluate((url) => window.openMotion(url), addressOf(motion));
  let off = 0;
  let flat = 0;
  for (const [i, time] of wanted.times.entries()) {
    const found = await page.evaluate((all) => window.goTo(...all), [time, wanted.parts.map((part) => part.positions[i])]);
    off = Math.max(off, found.off);
    flat = Math.max(flat, found.flat);
  }
  tell(off <= k_off * k_height && flat > 0.1 && Math.abs(seconds - 1) < 1e-6,
       `${path.basename(output.file)}: ${name} at ${wanted.times.length} times: vertices off by ${off.toExponential(1)} m (still ${flat.toExponential(1)})`);
  return clip;
}

async function check(page, model) {
  const was = await page.evaluate((url) => window.openAvatar(url), addressOf(model.file));
  const expressions = model.name === 'avatar0'
    ? [['happy', 'Joy', 1], ['aa', 'A', 0.5], ['Surprised', 'Surprised', 1]]
    : [['happy', 'happy', 1], ['aa', 'aa', 0.5], ['surprised', 'surprised', 1]];
  checkRest(model.name, was, was);
  await checkExpressions(page, model, { file: model.file }, expressions);
  for (const output of model.outputs) {
    const now = await page.evaluate((url) => window.openAvatar(url), addressOf(output.file));
    const name = path.basename(output.file);
    const off = checkRest(name, was, now);
    if (output.kind !== 'posed' || output.atRest || output.from) tell(off < 1e-6, `${name}: at rest as it was`);
    for (const what of Object.keys(was.rest)) {
      const kept = JSON.stringify(now.rest[what]) === JSON.stringify(was.rest[what]);
      tell(kept, `${name}: ${what} ${kept ? 'as they were' : `were ${JSON.stringify(was.rest[what])} and are ${JSON.stringify(now.rest[what])}`}`);
    }
    await checkExpressions(page, model, output, expressions);
  }
  const from = path.join(samples, 'read', 'motion.vrma');
  const clip = await checkMotion(page, model, 'motion', from);
  for (const output of model.outputs.filter((one) => one.atRest || one.kind !== 'posed')) await checkMotion(page, model, 'motion', from, output);
  const written = path.join(folder, `${model.name}.written.vrma`);
  run(penpose, 'convert', clip, written);
  await checkMotion(page, model, 'written', written);
}

async function main() {
  needBrowser(moduleFolder, chromium, ['three', '@pixiv/three-vrm', '@pixiv/three-vrm-animation']);
  fs.rmSync(folder, { recursive: true, force: true });
  fs.mkdirSync(folder, { recursive: true });
  const models = JSON.parse(fs.readFileSync(path.join(samples, 'outputs.json'))).filter((model) => model.avatar);
  tell(models.length === 2, `${models.length} avatars`);
  await withPage(moduleFolder, chromium, 'avatars_page.js', { samples, files: folder }, async (page) => {
    for (const model of models) await check(page, model);
  });
  process.exitCode = good ? 0 : 1;
}

main().catch((error) => {
  console.log(error.message);
  process.exitCode = 1;
});
