// node looks.js MODULE_FOLDER CHROMIUM OUT MODEL...: heads of characters as three.js shows them (three-vrm's MToon where they are
// avatars), in headless Chromium: OUT/NAME_three.png, and OUT/NAME_camera.json, from where other programs are to look. Exit status 77
// where Chromium or the modules are missing. tests/pictures/looks.sh lays them side by side.
'use strict';

const fs = require('fs');
const path = require('path');
const { needBrowser, withPage } = require('./browser.js');

const [moduleFolder, chromium, out, ...models] = process.argv.slice(2).map((p) => path.resolve(p));
const k_side = 512; // px of a picture

async function main() {
  needBrowser(moduleFolder, chromium, ['three', '@pixiv/three-vrm']);
  for (const model of models) {
    const name = path.basename(model, path.extname(model));
    await withPage(moduleFolder, chromium, 'looks_page.js', { files: path.dirname(model) }, async (page) => {
      const { camera, picture } = await page.evaluate((all) => window.show(...all), [`/files/${encodeURIComponent(path.basename(model))}`, k_side]);
      fs.writeFileSync(path.join(out, `${name}_camera.json`), JSON.stringify(camera));
      fs.writeFileSync(path.join(out, `${name}_three.png`), Buffer.from(picture, 'base64'));
    });
  }
}

main().catch((error) => {
  console.log(error.message);
  process.exitCode = 1;
});
