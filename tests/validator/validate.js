// node validate.js MODULE_FOLDER FOLDER: runs the glTF validator of the Khronos Group over every .glb and .vrma in FOLDER. Prints what
// it has to say about each; fails on any error or warning, and when there is no file.
'use strict';

const fs = require('fs');
const path = require('path');

const [moduleFolder, folder] = process.argv.slice(2);
const validator = require(path.join(path.resolve(moduleFolder), 'node_modules', 'gltf-validator'));
const severities = ['error', 'warning', 'information', 'hint'];

async function main() {
  const files = fs.readdirSync(folder).filter((name) => /\.(glb|vrma)$/.test(name)).sort();
  let bad = files.length === 0;
  for (const name of files) {
    const bytes = new Uint8Array(fs.readFileSync(path.join(folder, name)));
    const report = await validator.validateBytes(bytes, { uri: name, maxIssues: 1000 });
    const { numErrors, numWarnings, messages } = report.issues;
    console.log(`${name}: ${numErrors} errors, ${numWarnings} warnings`);
    for (const message of messages.filter((m) => m.severity < 2).slice(0, 20)) {
      console.log(`  ${severities[message.severity]} ${message.code} ${message.pointer || ''} ${message.message}`);
    }
    bad = bad || numErrors > 0 || numWarnings > 0;
  }
  process.exitCode = bad ? 1 : 0;
}

main();
