// node validate.js MODULE_FOLDER FOLDER: runs the glTF validator of the Khronos Group over every .glb, .vrma and .vrm in FOLDER, and the
// rules of VRM (vrm_rules.js) over every .vrm. Prints what
// it has to say about each; fails on any error or warning, and when there is no file. What it says of FOLDER/read/NAME, from which
// NAME was read, is no fault of NAME: a file that was read is kept as it was.
'use strict';

const fs = require('fs');
const path = require('path');

const [moduleFolder, folder] = process.argv.slice(2);
const validator = require(path.join(path.resolve(moduleFolder), 'node_modules', 'gltf-validator'));
const { faultsOf, tPoseFaults, documentOf } = require('./vrm_rules.js');
const severities = ['error', 'warning', 'information', 'hint'];

async function messagesOf(file) {
  const bytes = new Uint8Array(fs.readFileSync(file));
  const report = await validator.validateBytes(bytes, { uri: path.basename(file), maxIssues: 1000 });
  return report.issues.messages.filter((message) => message.severity < 2);
}

/// What VRM's rules find in an avatar, and where its T-pose is no longer that of the file from which it was read.
function avatarFaults(file, before) {
  if (!file.endsWith('.vrm')) return [];
  const document = documentOf(fs.readFileSync(file));
  const rest = fs.existsSync(before) ? tPoseFaults(documentOf(fs.readFileSync(before)), document) : [];
  return [...faultsOf(document), ...rest];
}

async function main() {
  const files = fs.readdirSync(folder).filter((name) => /\.(glb|vrma|vrm)$/.test(name)).sort();
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
    const faults = avatarFaults(path.join(folder, name), before);
    for (const fault of faults) console.log(`  VRM: ${fault}`);
    bad = bad || messages.length + faults.length > 0;
  }
  process.exitCode = bad ? 1 : 0;
}

main();
