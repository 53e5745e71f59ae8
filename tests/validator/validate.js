// node validate.js MODULE_FOLDER FOLDER: runs the glTF validator of the Khronos Group over every .glb, .vrma and .vrm in FOLDER, and the
// rules of VRM (vrm_rules.js) over every .vrm. Prints what
// it has to say about each; fails on any error or warning, and when there is no file. What it says of FOLDER/read/NAME, from which
// NAME was read, is no fault of NAME: a file that was read is kept as it was.
'use strict';

const fs = require('fs');
const path = require('path');
const { validatorIn, newMessages } = require('./messages.js');

const [moduleFolder, folder] = process.argv.slice(2);
const { faultsOf, tPoseFaults, documentOf } = require('./vrm_rules.js');

/// What VRM's rules find in an avatar, and where its T-pose is no longer that of the file from which it was read.
function avatarFaults(file, before) {
  if (!file.endsWith('.vrm')) return [];
  const document = documentOf(fs.readFileSync(file));
  const rest = fs.existsSync(before) ? tPoseFaults(documentOf(fs.readFileSync(before)), document) : [];
  return [...faultsOf(document), ...rest];
}

async function main() {
  const messagesOf = validatorIn(moduleFolder);
  const files = fs.readdirSync(folder).filter((name) => /\.(glb|vrma|vrm)$/.test(name)).sort();
  let bad = files.length === 0;
  for (const name of files) {
    const before = path.join(folder, 'read', name);
    const messages = await newMessages(messagesOf, name, path.join(folder, name), fs.existsSync(before) ? before : null);
    const faults = avatarFaults(path.join(folder, name), before);
    for (const fault of faults) console.log(`  VRM: ${fault}`);
    bad = bad || messages.length + faults.length > 0;
  }
  process.exitCode = bad ? 1 : 0;
}

main();
