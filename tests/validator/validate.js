// node validate.js MODULE_FOLDER FOLDER: runs the glTF validator of the Khronos Group over every .glb, .vrma and .vrm in FOLDER, and the
// rules of VRM (vrm_rules.js) over every .vrm. Prints what they have to say about each; fails on any error or warning, and when there
// is no file. What the validator says of FOLDER/read/NAME, from which NAME was read, is no fault of NAME: a file that was read is
// kept as it was.
'use strict';

const fs = require('fs');
const path = require('path');
const { validatorIn, newMessages } = require('./messages.js');
const { avatarFaults } = require('./vrm_rules.js');

const [moduleFolder, folder] = process.argv.slice(2);

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
