// node validate.js MODULE_FOLDER FOLDER: runs the glTF validator of the Khronos Group over every .glb and .vrma in FOLDER. Prints what
// it has to say about each; fails on any error or warning, and when there is no file. What it says of FOLDER/read/NAME, from which
// NAME was read, is no fault of NAME: a file that was read is kept as it was.
'use strict';

const fs = require('fs');
const path = require('path');

const [moduleFolder, folder] = process.argv.slice(2);
const validator = require(path.join(path.resolve(moduleFolder), 'node_modules', 'gltf-validator'));
const severities = ['error', 'warning', 'information', 'hint'];

async function messagesOf(file) {
  const bytes = new Uint8Array(fs.readFileSync(file));
  const report = await validator.validateBytes(bytes, { uri: path.basename(file), maxIssues: 1000 });
  return report.issues.messages.filter((message) => message.severity < 2);
}

async function main() {
  const files = fs.readdirSync(folder).filter((name) => /\.(glb|vrma)$/.test(name)).sort();
  let bad = files.length === 0;
  for (const name of files) {
    const before = path.join(folder, 'read', name);
    const known = new Set((fs.existsSync(before) ? await messagesOf(before) : []).map((m) => `${m.code} ${m.pointer}`));
    const all = await messagesOf(path.join(folder, name));
    const messages = all.filter((m) => !known.has(`${m.code} ${m.pointer}`));
    const count = (severity) => messages.filter((m) => m.severity === severity).length;
    console.log(`${name}: ${count(0)} errors, ${count(1)} warnings, ${all.length - messages.length} as in the file that was read`);
    for (const message of messages.slice(0, 20)) {
      console.log(`  ${severities[message.severity]} ${message.code} ${message.pointer || ''} ${message.message}`);
    }
    bad = bad || messages.length > 0;
  }
  process.exitCode = bad ? 1 : 0;
}

main();
