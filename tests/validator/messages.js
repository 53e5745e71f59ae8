// What the glTF validator of the Khronos Group says about files, for every test that asks it.
'use strict';

const fs = require('fs');
const path = require('path');

/// Loads the validator from MODULE_FOLDER/node_modules. Returns a function that gives the errors and warnings of a file; what lies
/// beside a .gltf is read with it.
function validatorIn(moduleFolder) {
  const validator = require(path.join(path.resolve(moduleFolder), 'node_modules', 'gltf-validator'));
  return async (file) => {
    const beside = (uri) => {
      const bytes = fs.readFileSync(path.join(path.dirname(file), decodeURIComponent(uri).replace(/\\/g, '/')));
      return Promise.resolve(new Uint8Array(bytes));
    };
    const bytes = new Uint8Array(fs.readFileSync(file));
    const options = { uri: path.basename(file), maxIssues: 1000, externalResourceFunction: beside };
    const report = await validator.validateBytes(bytes, options);
    return report.issues.messages.filter((message) => message.severity < 2);
  };
}

const severities = ['error', 'warning', 'information', 'hint'];

/// Messages of a file that are not among those of the file from which it was made. Prints both numbers, and what is new.
async function newMessages(messagesOf, name, file, before) {
  const known = new Set((before ? await messagesOf(before) : []).map((m) => `${m.code} ${m.pointer}`));
  const all = await messagesOf(file);
  const messages = all.filter((m) => !known.has(`${m.code} ${m.pointer}`));
  const count = (severity) => messages.filter((m) => m.severity === severity).length;
  console.log(`${name}: ${count(0)} errors, ${count(1)} warnings, ${all.length - messages.length} as in the file that was read`);
  for (const message of messages.slice(0, 20)) {
    console.log(`  ${severities[message.severity]} ${message.code} ${message.pointer || ''} ${message.message}`);
  }
  return messages;
}

module.exports = { validatorIn, newMessages };
