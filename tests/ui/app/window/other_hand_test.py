"""Plays the keys, the ring and the fingers of a tablet in a real window under Xvfb, in place of hardware.

    other_hand_test.py PROGRAM [RECORDING_OF_AN_INTUOS_PRO_S [FOLDER_FOR_PICTURES]]
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile

from window_test import Screen, lines_of, start

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "vm"))
import traces  # noqa: E402: found by the line above


def with_settings(folder, bindings):
    settings = os.path.join(folder, ".config", "penpose", "settings")
    os.makedirs(os.path.dirname(settings), exist_ok=True)
    with open(settings, "w") as file:
        file.write("steps_seen=1\npose_first=1\n" + "".join(f"pad=056a:0314|{key}|{done}\n" for key, done in bindings.items()))


def other_hand(program, screen, folder):
    """The keys, the ring and the fingers of a tablet, played in its place: what they are bound to is done and recorded, and
    replays to the same."""
    with_settings(folder, {"BTN_1": "action Key", "BTN_2": "tool Pin"})
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


def done_in(session):
    """What a session says was done, in order: commands, tools and views; views that follow one another are one."""
    done = []
    for line in lines_of(session, "# penpose "):
        what, *details = line.split()[2:]
        kinds = {"do": details[:1], "tool": [word for word in details if word.startswith("kind=")], "undo": [], "view": []}
        told = " ".join([what, *kinds.get(what, [])])
        if what in kinds and (what != "view" or done[-1:] != ["view"]):
            done.append(told)
    return done


def a_real_hand(program, screen, folder, recording):
    """A hand on a real tablet: the ring, seven keys one after the other, the key in the ring's middle."""
    with_settings(folder, {"BTN_1": "action Key", "BTN_2": "tool Hold", "BTN_3": "hold turn", "BTN_4": "tool Pin",
                           "BTN_5": "tool Erase", "BTN_6": "action Light"})
    session = os.path.join(folder, "real.session")
    process = start(program, screen, session, "--replay", recording)
    assert process.wait(timeout=90) == 0, process.stdout.read()
    done = done_in(session)
    # The ring goes through time before the first key and between its two; its second light zooms, fingers turn the view.
    tools = [one for one in done if one.startswith("tool")]
    assert tools == ["tool kind=constraint", "tool", "tool kind=pin", "tool", "tool kind=erase", "tool"], done
    commands = [one for one in done if one.startswith(("do", "undo"))]
    assert commands == ["do set_key", "do go_to_time", "do set_key"], done
    assert done[-1] == "view", done
    with open(os.path.join(folder, ".config", "penpose", "settings")) as file:
        assert "light=1" in file.read()
    played = subprocess.run([program, "replay", session, "--json"], env=screen.environment, stdout=subprocess.PIPE, text=True)
    said = json.loads(played.stdout)
    assert said["differing"] == 0 and said["checked"] == said["steps"] > 0, said


def main():
    folder = tempfile.mkdtemp(prefix="penpose-hand-")
    screen = Screen(folder, sys.argv[3] if len(sys.argv) > 3 else "")
    try:
        program = os.path.abspath(sys.argv[1])
        if len(sys.argv) > 2:
            a_real_hand(program, screen, folder, sys.argv[2])
        else:
            other_hand(program, screen, folder)
    finally:
        screen.close()
    shutil.rmtree(folder)


main()
