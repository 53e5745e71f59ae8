// node validate.js MODULE_FOLDER FOLDER: the glTF validator of the Khronos Group finds nothing in the outputs of kept.js that it did
// not find in their inputs; avatars are avatars by VRM's rules, in the T-pose that they had. Prints a line a file; exit status 1 if it does, or if there is no output.
'use strict';

const fs = require('fs');
const path = require('path');
const { validatorIn, newMessages } = require('../validator/messages.js');
const { avatarFaults } = require('../validator/vrm_rules.js');

const [moduleFolder, folder] = process.argv.slice(2);

async function main() {
  const messagesOf = validatorIn(moduleFolder);
  const list = JSON.parse(fs.readFileSync(path.join(folder, 'outputs.json')));
  let bad = list.length === 0;
  for (const model of list) {
    for (const output of model.outputs) {
      const messages = await newMessages(messagesOf, path.basename(output.file), output.file, output.from || model.file);
      const faults = model.avatar ? avatarFaults(output.file, model.file) : [];
      for (const fault of faults) console.log(`  VRM: ${fault}`);
      bad = bad || messages.length + faults.length > 0;
    }
  }
  process.exitCode = bad ? 1 : 0;
}

main();
