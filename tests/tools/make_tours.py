#!/usr/bin/env python3
"""Makes the sessions of the window's tours (ui/app/tours), drawn with `penpose serve`.

    make_tours.py PENPOSE FOLDER

Lines are named curves of the built-in head as the front shows them, moved. What a tour says of each step stands in a
comment line before it ("# tour says ..."); what is pressed and is no step of a session has a line of its own.
"""
import json
import math
import os
import subprocess
import sys

VIEW = {'eye': [0, -0.0173, 0.7837], 'look_at': [0, -0.0173, 0.003], 'up': [0, 1, 0], 'vertical_fov_degrees': 30,
        'viewport': [1000, 1000]}

SAID = {
    'pose': ('Pose a face', [
        'Draw along the line between the lips, from the disc to the arrow',
        'Draw where it should go: a smile. The face follows the pen',
        'Now the brow: draw along it as it is',
        'Draw it higher, and the brow is raised',
        'Draw along the edge of the upper eyelid',
        'Draw it down to the lower lid: the eye closes',
    ], 'Three features, six strokes: that is all of posing. Key keeps the pose, Undo takes back any stroke.'),
    'rig': ('Make a control', [
        'This head has no controls yet. Press Rig to sketch one',
        'Draw around everything that may move with the brow',
        'Draw around the brow itself, which moves fully',
        'The brow was found by itself. Draw where it should go at most',
        'The control is made. Pull its slider to the right end',
    ], 'Three lines make a control. Draw along the brow with Pose, and the new control is what follows.'),
    'animate': ('Animate', [
        'Press Key: the face as it is now is kept at frame 0',
        'Drag along the ruler to the mark: one second later',
        'Draw along the line between the lips',
        'Draw a smile, along the dashed line',
        'Press Key again: the smile is kept at this moment',
    ], 'Two keys, and the face moves between them. Film in the menu writes what you see.'),
}
PRESSED = {'animate': ['play Press Play, and see the smile come']}


class Talk:
    def __init__(self, penpose, *options):
        self.process = subprocess.Popen([penpose, 'serve', *options], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        text=True)

    def say(self, **line):
        self.process.stdin.write(json.dumps(line) + '\n')
        self.process.stdin.flush()
        answer = json.loads(self.process.stdout.readline())
        assert answer['ok'], (line, answer)
        return answer

    def end(self):
        self.process.stdin.close()
        assert self.process.wait() == 0


def seen(point):
    """Where VIEW shows a point, px."""
    depth = VIEW['eye'][2] - point[2]
    px = 500 / math.tan(math.radians(15)) / depth
    return [round(500 + point[0] * px, 1), round(500 - (point[1] - VIEW['eye'][1]) * px, 1)]


def curves(penpose):
    talk = Talk(penpose)
    names = talk.say(do='load', model='builtin:demo')['curves']
    lines = {name: [seen(p) for p in talk.say(do='curve', name=name)['positions']] for name in names}
    talk.end()
    return lines


def moved(line, way):
    """`way`: px down at a share of the line's length."""
    count = len(line) - 1
    return [[x, round(y + way(i / count), 1)] for i, (x, y) in enumerate(line)]


def smile(line):
    """The mouth wider, its corners up."""
    middle = sum(x for x, _ in line) / len(line)
    return [[round(middle + 1.2 * (x - middle), 1), y] for x, y in moved(line, lambda s: 2 - 28 * (2 * s - 1) ** 2)]


def ring(middle, wide, high):
    return [[round(middle[0] + wide * math.cos(a * math.pi / 16), 1),
             round(middle[1] + high * math.sin(a * math.pi / 16), 1)] for a in range(33)]


def middle_of(line):
    return [sum(p[k] for p in line) / len(line) for k in (0, 1)]


def pose(talk, lines):
    for name, target in (('lip_upper_inner', smile(lines['lip_upper_inner'])),
                         ('brow_L', moved(lines['brow_L'], lambda s: -22)),
                         ('eyelid_upper_L', moved(lines['eyelid_upper_L'], lambda s: 34 * math.sin(math.pi * s)))):
        curve = talk.say(do='curve', line=lines[name], view=VIEW)['curve']
        talk.say(do='target', curve=curve, line=target, view=VIEW)


def rig(talk, lines):
    brow = lines['brow_L']
    at = middle_of(brow)
    talk.say(do='sketch', view=VIEW, name='control 1', general=ring(at, 92, 62), specific=ring(at, 66, 22),
             target=moved(brow, lambda s: -26))
    talk.say(do='set', parameters={'control 1': 1})


def animate(talk, lines):
    talk.say(do='perform', command='set_key time_s=0')
    talk.say(do='perform', command='go_to_time time_s=1')
    curve = talk.say(do='curve', line=lines['lip_upper_inner'], view=VIEW)['curve']
    talk.say(do='target', curve=curve, line=smile(lines['lip_upper_inner']), view=VIEW)
    talk.say(do='perform', command='set_key time_s=1')


def with_texts(name, text):
    title, said, ends = SAID[name]
    out, left = [], list(said)
    for line in text.splitlines():
        if line.startswith('# penpose do '):
            out.append('# tour says ' + left.pop(0))
        out.append(line)
        if line.startswith('# penpose session'):
            out.append('# tour title ' + title)
    assert not left, left
    out += ['# tour press ' + pressed for pressed in PRESSED.get(name, [])]
    return '\n'.join(out + ['# tour ends ' + ends]) + '\n'


def main():
    penpose, folder = sys.argv[1:]
    lines = curves(penpose)
    for name, model, draw in (('pose', 'builtin:demo', pose), ('rig', 'builtin:head', rig),
                              ('animate', 'builtin:demo', animate)):
        path = os.path.join(folder, name + '.session')
        if os.path.exists(path):
            os.remove(path)
        talk = Talk(penpose, '--session', path)
        talk.say(do='load', model=model)
        draw(talk, lines)
        talk.end()
        with open(path) as file:
            text = file.read()
        with open(path, 'w') as file:
            file.write(with_texts(name, text))


if __name__ == '__main__':
    main()
