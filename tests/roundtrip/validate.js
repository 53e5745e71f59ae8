// node validate.js MODULE_FOLDER FOLDER: the glTF validator of the Khronos Group finds nothing in the outputs of kept.js that it did
// not find in their inputs. Prints a line a file; exit status 1 if it does, or if there is no output.
'use strict';

const fs = require('fs');
const path = require('path');
const { validatorIn, newMessages } = require('../validator/messages.js');

const [moduleFolder, folder] = process.argv.slice(2);

async function main() {
  const messagesOf = validatorIn(moduleFolder);
  const list = JSON.parse(fs.readFileSync(path.join(folder, 'outputs.json')));
  let bad = list.length === 0;
  for (const model of list) {
    for (const output of model.outputs) {
      bad = (await newMessages(messagesOf, path.basename(output.file), output.file, output.from || model.file)).length > 0 || bad;
    }
  }
  process.exitCode = bad ? 1 : 0;
}

main();
