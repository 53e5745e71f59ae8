"""in_python.py SESSION[@MODEL]...: replays sessions through the Python package and prints "NAME STATE" of each; then poses the demo's head and
prints how far it came."""
import os
import sys

import penpose


def main():
    for argument in sys.argv[1:]:
        path, _, model = argument.partition('@')
        on = None
        if model:
            with open(model, 'rb') as file:
                on = penpose.Character.read(file.read())
        with open(path, 'rb') as file:
            character, playback = penpose.play(file.read(), on)
        assert character.state == playback.state and playback.differing == 0
        print(os.path.basename(path), character.state)
    head = penpose.Character.built_in('builtin:demo')
    lip = head.curve('lip_upper')
    head.target(lip, head.positions(lip) + [0, 0.002, 0])
    head.solve()
    xyz = head.evaluate()
    print('pose %.17g %.17g' % (head.distances(lip).max(), xyz[len(xyz) // 2, 0]))


if __name__ == '__main__':
    main()
