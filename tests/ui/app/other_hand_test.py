"""Plays the keys, the ring and the fingers of a tablet in a real window under Xvfb, in place of hardware.

    other_hand_test.py PROGRAM [FOLDER_FOR_PICTURES]
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile

from window_test import Screen, lines_of, start

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "vm"))
import traces  # noqa: E402: found by the line above


def other_hand(program, screen, folder):
    """The keys, the ring and the fingers of a tablet, played in its place: what they are bound to is done and recorded, and
    replays to the same."""
    settings = os.path.join(folder, ".config", "penpose", "settings")
    os.makedirs(os.path.dirname(settings), exist_ok=True)
    with open(settings, "w") as file:
        file.write("steps_seen=1\n" + "pad=056a:0314|BTN_1|action Key\npad=056a:0314|BTN_2|tool Pin\n")
    trace = os.path.join(folder, "hand.hid")
    with open(trace, "w") as file:
        file.write(traces.made()["hand"])
    session = os.path.join(folder, "hand.session")
    process = start(program, screen, session, "--replay", trace)
    assert process.wait(timeout=60) == 0, process.stdout.read()
    text = "".join(lines_of(session, "# penpose "))
    # Once by what the first key was bound to, once by what another one is from the start.
    assert text.count("# penpose do set_key") == 2, text
    assert text.count("kind=pin") == 2, text  # once held and let go, once held when the tablet went
    assert text.count("kind=erase") == 1, text
    # The ring's second light zooms, two fingers turn and zoom: each a view of its own.
    assert len(lines_of(session, "# penpose view")) > 20, text
    played = subprocess.run([program, "replay", session, "--json"], env=screen.environment, stdout=subprocess.PIPE, text=True)
    assert played.returncode == 0
    said = json.loads(played.stdout)
    assert said["differing"] == 0 and said["checked"] == said["steps"] > 0, said
    assert said["reports"] == len(lines_of(trace, "E:")), said


def main():
    folder = tempfile.mkdtemp(prefix="penpose-hand-")
    screen = Screen(folder, sys.argv[2] if len(sys.argv) > 2 else "")
    try:
        other_hand(os.path.abspath(sys.argv[1]), screen, folder)
    finally:
        screen.close()
    shutil.rmtree(folder)


main()
