// node rest.js MODULE_FOLDER CHROMIUM SHARED FOLDER...: what roundtrip/kept.js left in each FOLDER, drawn by three.js in headless
// Chromium with its materials and textures: at rest an output is its input, from the same cameras. Prints a line a file; exit
// status 1 if 0.1 % of the px differ by more than 1 of 255, 77 where Chromium or the modules are missing.
'use strict';

const fs = require('fs');
const path = require('path');
const { needBrowser, withPage } = require('./browser.js');

const [moduleFolder, chromium, shared, ...folders] = process.argv.slice(2).map((p) => path.resolve(p));
const k_side = 400; // px of a picture
const k_differing = 0.001;

/// The address of a file in the page.
function addressOf(file, folder) {
  const [name, root] = [['files', folder], ['shared', shared]].find(([, r]) => file.startsWith(r + path.sep));
  return `/${name}/${path.relative(root, file).split(path.sep).map(encodeURIComponent).join('/')}`;
}

async function check(page, model, folder) {
  const outputs = model.outputs.map((o) => ({ url: addressOf(o.file, folder), posed: o.kind === 'posed' }));
  if (outputs.length === 0) return true;
  const found = await page.evaluate((all) => window.compare(...all), [addressOf(model.file, folder), outputs, model.draw || null]);
  // A picture of nothing agrees with any other.
  let good = found.covered > 0.01 && found.colours > 20;
  if (!good) console.log(`${model.name}: covers ${found.covered.toFixed(4)} in ${found.colours} colours WRONG`);
  found.outputs.forEach(({ differs, moved }, i) => {
    const { kind, file } = model.outputs[i];
    const fits = differs <= k_differing && (kind !== 'posed' || moved > 0);
    good = good && fits;
    console.log(`${path.basename(file)}: ${(100 * differs).toFixed(4)} % of px differ at rest` +
                `${kind === 'posed' ? `, ${(100 * moved).toFixed(2)} % as posed` : ''}${fits ? '' : ' WRONG'}`);
  });
  return good;
}

async function main() {
  needBrowser(moduleFolder, chromium, ['three']);
  let good = true;
  for (const folder of folders) {
    const list = JSON.parse(fs.readFileSync(path.join(folder, 'outputs.json')));
    good = good && list.length > 0;
    await withPage(moduleFolder, chromium, 'rest_page.js', { files: folder, shared }, async (page) => {
      console.log(await page.evaluate((side) => window.begin(side), k_side));
      for (const model of list) good = (await check(page, model, folder)) && good;
    });
  }
  process.exitCode = good ? 0 : 1;
}

main().catch((error) => {
  console.log(error.message);
  process.exitCode = 1;
});
