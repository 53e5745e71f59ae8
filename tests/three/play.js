// node play.js PENPOSE WRITE_THREE_POSITIONS MODULE_FOLDER CHROMIUM SHARED FOLDER: writes animated files with the program, plays
// them with three.js in headless Chromium, and compares vertices and outlines at eight times. Prints a line a file; exit
// status 1 if any differs, 77 where Chromium or the modules are missing.
'use strict';

const fs = require('fs');
const path = require('path');
const { needBrowser, withPage } = require('./browser.js');
const { makeFiles, run } = require('./files.js');

const [penpose, writePositions, moduleFolder, chromium, shared, folder] = process.argv.slice(2).map((p) => path.resolve(p));
const k_side = 512; // px of a picture
const k_outline = 0.99; // the least agreement of two outlines

/// Pictures of the program for a file: the whole model at each time and, for a file with a `closeUp` part, that part.
function drawPictures(file, wanted) {
  const render = (model, camera, output, ...more) =>
    run(penpose, 'render', model, '--camera', path.join(folder, camera), '--size', `${k_side}x${k_side}`, ...more,
        '-o', path.join(folder, output));
  const writeCamera = (name, low, high, direction) => {
    const middle = low.map((l, axis) => (l + high[axis]) / 2);
    const reach = Math.hypot(...low.map((l, axis) => high[axis] - l)) / 2;
    const camera = {
      eye: middle.map((m, axis) => m + (direction[axis] / Math.hypot(...direction)) * 4 * reach),
      look_at: middle, up: [0, 1, 0], vertical_fov_degrees: 30 };
    fs.writeFileSync(path.join(folder, name), JSON.stringify(camera));
    return camera;
  };
  const { name, closeUp } = file;
  const model = path.join(folder, `${name}.glb`);
  const views = [{ part: null, camera: writeCamera(`${name}.camera`, wanted.low, wanted.high, [0.45, 0.15, 1]), pictures: [] }];
  wanted.times.forEach((time, i) => {
    views[0].pictures.push(`${name}_${i}.png`);
    render(model, `${name}.camera`, `${name}_${i}.png`, '--time', String(time));
  });
  // Nothing but the background: the same picture from a camera that has its back to the model.
  const { eye, look_at: at } = views[0].camera;
  fs.writeFileSync(path.join(folder, 'away.camera'), JSON.stringify({ eye, look_at: eye.map((e, axis) => 2 * e - at[axis]) }));
  render(model, 'away.camera', 'empty.png');
  if (!closeUp) return views;
  const part = wanted.parts.find((p) => p.name === closeUp);
  const all = part.positions.flat();
  const bound = (pick) => [0, 1, 2].map((axis) => all.reduce((a, x, i) => (i % 3 === axis ? pick(a, x) : a), all[axis]));
  const camera = writeCamera(`${name}_part.camera`, bound(Math.min), bound(Math.max), [0, 0, 1]);
  const pictures = part.positions.map((positions, i) => {
    const lines = [];
    for (let v = 0; v < positions.length; v += 3) lines.push(`v ${positions.slice(v, v + 3).join(' ')}`);
    for (let t = 0; t < part.triangles.length; t += 3) lines.push(`f ${part.triangles.slice(t, t + 3).map((c) => c + 1).join(' ')}`);
    fs.writeFileSync(path.join(folder, `${name}_part_${i}.obj`), `${lines.join('\n')}\n`);
    render(path.join(folder, `${name}_part_${i}.obj`), `${name}_part.camera`, `${name}_part_${i}.png`);
    return `${name}_part_${i}.png`;
  });
  return [...views, { part: closeUp, camera, pictures }];
}

async function check(page, file) {
  const { name, tolerance } = file;
  run(writePositions, path.join(folder, `${name}.glb`), path.join(folder, `${name}.json`));
  const wanted = JSON.parse(fs.readFileSync(path.join(folder, `${name}.json`)));
  const views = drawPictures(file, wanted);
  const targets = await page.evaluate((n) => window.load(n), name);
  let off = 0;
  let flat = 0;
  let outline = 1;
  let told = 1; // agreement of the close-up with the picture of another time: less, or the close-up shows nothing
  for (let i = 0; i < wanted.times.length; ++i) {
    const found = await page.evaluate((at) => window.goTo(at), i);
    off = Math.max(off, found.off); // NaN stays
    flat = Math.max(flat, found.flat);
    for (const { part, camera, pictures } of views) {
      const shares = await page.evaluate((all) => window.agreement(...all), [camera, part, 'empty.png', pictures]);
      outline = Math.min(outline, shares[i]);
      if (part !== null) told = Math.min(told, ...shares);
    }
  }
  const good = off <= tolerance && flat > 10 * tolerance && outline >= k_outline && (!file.closeUp || told < 0.9);
  console.log(`${name}: ${wanted.times.length} times, ${targets} morph targets, vertices off by ${off.toExponential(1)} of the size ` +
              `(allowed ${tolerance}; undeformed ${flat.toExponential(1)}); outlines agree by ${outline.toFixed(4)}` +
              `${file.closeUp ? `, those of other times by ${told.toFixed(4)} at the least` : ''}${good ? '' : ' WRONG'}`);
  return good;
}

async function main() {
  needBrowser(moduleFolder, chromium, ['three']);
  fs.rmSync(folder, { recursive: true, force: true });
  fs.mkdirSync(folder, { recursive: true });
  const files = makeFiles(penpose, folder, shared);
  let good = true;
  await withPage(moduleFolder, chromium, 'play_page.js', { files: folder }, async (page) => {
    console.log(await page.evaluate((side) => window.begin(side), k_side));
    for (const file of files) good = (await check(page, file)) && good;
  });
  process.exitCode = good ? 0 : 1;
}

main().catch((error) => {
  console.log(error.message);
  process.exitCode = 1;
});
