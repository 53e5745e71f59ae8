// node kept.js PENPOSE MODELS|- FOLDER: makes samples (or takes those of the folder MODELS), lets the program pose them, draw
// a control on them and animate them, and compares each output with its input by a reader of its own: everything that was
// not asked for is equal, byte for byte. Leaves FOLDER/outputs.json for tests that look at the outputs. Exit status 1 if
// anything differs.
'use strict';

const fs = require('fs');
const path = require('path');
const { makeSamples, foundModels, makeOutputs, run } = require('./make_files.js');
const { faultsOf } = require('./rules.js');

const [penpose, from, folder] = process.argv.slice(2).map((one) => (one === '-' ? one : path.resolve(one)));

/// Files of the shared data that hold no model, or a stream that is none.
const k_no_models = /^(not_a_model_called_damaged\.|draco_called_damaged\.draco$)/;

function main() {
  fs.rmSync(folder, { recursive: true, force: true });
  fs.mkdirSync(path.join(folder, 'read'), { recursive: true });
  const models = from === '-' ? makeSamples(path.join(folder, 'read')) : foundModels(from);
  const list = [];
  let good = models.length > 0;
  for (const model of models) {
    if (from !== '-') {
      try {
        run(penpose, 'info', model.file, '--json');
      } catch (error) {
        console.log(`${model.name}: is not read: ${error.message.split('\n')[0]}`);
        good = good && k_no_models.test(model.name);
        continue;
      }
    }
    const outputs = makeOutputs(penpose, model, folder);
    list.push({ ...model, outputs });
    const same = path.join(folder, `${model.name}.same${path.extname(model.file)}`);
    if (!model.text) {
      run(penpose, 'convert', model.file, same);
      if (!fs.readFileSync(same).equals(fs.readFileSync(model.file))) {
        console.log(`${model.name}: WRONG: saved without a change it is another file`);
        good = false;
      }
    }
    for (const output of outputs) {
      const faults = faultsOf(model, output);
      console.log(`${path.basename(output.file)}: ${faults.length === 0 ? 'all else is kept' : `WRONG in ${faults.length} places`}`);
      for (const fault of faults.slice(0, 12)) console.log(`  ${fault}`);
      good = good && faults.length === 0;
    }
  }
  fs.writeFileSync(path.join(folder, 'outputs.json'), JSON.stringify(list, null, 1));
  process.exitCode = good ? 0 : 1;
}

main();
