#!/usr/bin/env python3
"""The library and `penpose pose` solve the same: each of the first cases of a file, alone, by every preset, gives the same parameters to
the bit. usage: cases_test.py PENPOSE MODEL CASES, with PENPOSE_LIBRARY and PYTHONPATH naming the library and the package."""
import json
import os
import subprocess
import sys
import tempfile

import penpose

CASES = 6


def in_program(program, model, case, preset):
    with tempfile.NamedTemporaryFile('w', suffix='.json') as file:
        json.dump({'cases': [case]}, file)
        file.flush()
        done = subprocess.run([program, 'pose', model, '--cases', file.name, '--preset', preset, '--json'], check=True,
                              stdout=subprocess.PIPE, text=True)
    return json.loads(done.stdout)['cases'][0]['parameters']


def main():
    program, model, cases = sys.argv[1:]
    with open(model, 'rb') as file:
        at_rest = penpose.Character.read(file.read(), os.path.basename(model))
    with open(cases, encoding='utf-8') as file:
        chosen = json.load(file)['cases'][:CASES]
    differing = 0
    for case in chosen:
        for preset in penpose.Preset:
            character = at_rest.copy()
            for reference in case['references']:
                character.target(character.curve_at(reference['vertices']), reference['target'])
            for constraint in case.get('constraints', []):
                character.curve_at(constraint['vertices'], penpose.Role.CONSTRAINT)
            character.solve(preset)
            if character.values() != in_program(program, model, case, preset.name.lower()):
                differing += 1
                print(case['name'], preset.name, 'differs')
    print('%d cases by %d presets, %d differ' % (len(chosen), len(penpose.Preset), differing))
    return 1 if differing or not chosen else 0


if __name__ == '__main__':
    sys.exit(main())
