"""Goes through the window's three tours in a real window under Xvfb, with the hand of a user who knows nothing of what is
inside: lines are drawn along what is shown on the screen, and buttons are pressed where a ring is shown around them.

    tour_test.py PROGRAM [FOLDER_FOR_PICTURES [WIDTHxHEIGHT [light|first]]]

`first`: the first tour alone.
"""

import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import window_test
from window_test import Screen, lines_of, wait_for

# The colours of the line to draw and of the ring (ui/app/tour/tour_panel.cpp), as a screen holds them: blue, green, red.
GHOST, RING = bytes((0, 149, 255)), bytes((32, 176, 255))
STEPS = {
    "pose": ["line"] * 6,
    "rig": ["press", "lasso", "lasso", "line", "pull"],
    "animate": ["press", "drag", "line", "line", "press", "press"],
}


class Sight:
    """What is on the screen."""

    def __init__(self, screen, width, height):
        self.path, self.width, self.height = os.path.join(screen.folder, "Xvfb_screen0"), width, height

    def pixels(self, color):
        """Where a colour is."""
        with open(self.path, "rb") as file:
            data = file.read()
        import struct
        head = struct.unpack(">25I", data[:100])
        start, stride = head[0] + head[19] * 12, head[12]
        found, at = [], data.find(color, start)
        while at >= 0:
            offset = at - start
            if offset % 4 == 0:
                found.append((offset % stride // 4, offset // stride))
            at = data.find(color, at + 1)
        return found

    def line(self):
        """The line to draw, from left to right."""
        columns = {}
        for x, y in self.pixels(GHOST):
            columns.setdefault(x, []).append(y)
        return [(x, sum(ys) / len(ys)) for x, ys in sorted(columns.items())]

    def ring(self):
        """The middle of what is ringed, and its edges."""
        points = self.pixels(RING)
        # The card of the tour has a bar of the same colour at its left edge: a ring has a right side, too.
        rows = {}
        for x, y in points:
            rows.setdefault(y, []).append(x)
        columns = {}
        for x, y in points:
            columns.setdefault(x, []).append(y)
        spans = [(min(xs), max(xs), y) for y, xs in rows.items() if max(xs) - min(xs) > 20 and len(xs) > 20]
        if not spans:
            return None
        left, right = min(s[0] for s in spans), max(s[1] for s in spans)
        return left, min(s[2] for s in spans), right, max(s[2] for s in spans)


def thinned(points, count):
    return [points[round(i * (len(points) - 1) / (count - 1))] for i in range(count)]


class Hand:
    def __init__(self, screen, sight):
        self.screen, self.sight = screen, sight

    def draw(self, points):
        points = [(round(x), round(y)) for x, y in points]
        self.screen.do("mousemove", *points[0])
        time.sleep(0.15)
        self.screen.do("mousedown", 1)
        for point in points[1:]:
            self.screen.do("mousemove", *point)
            time.sleep(0.02)
        self.screen.do("mouseup", 1)

    def lasso(self):
        points = self.sight.pixels(GHOST)
        x, y = (sum(p[k] for p in points) / len(points) for k in (0, 1))
        turns = [[] for _ in range(36)]
        for px, py in points:
            turns[int((math.atan2(py - y, px - x) + math.pi) / (2 * math.pi) * 36) % 36].append((px, py))
        around = [(sum(p[0] for p in part) / len(part), sum(p[1] for p in part) / len(part)) for part in turns if part]
        self.draw(around + [around[0]])

    def line(self, down=0):
        self.draw([(x, y + down) for x, y in thinned(self.sight.line(), 25)])

    def ringed(self, kind):
        left, top, right, bottom = self.sight.ring()
        x, y = (left + right) / 2, (top + bottom) / 2
        if kind == "press":
            self.screen.click(round(x), round(y))
        elif kind == "drag":
            self.draw([(x - 120, y), (x - 60, y), (x - 20, y), (x, y), (x, y)])
        else:
            self.draw([(right - 8, y), ((right + x) / 2, y), (x + 4, y), (x, y), (x, y)])


def sure_sight(look):
    """What is seen twice in a row."""
    end = time.monotonic() + 20
    before = None
    while time.monotonic() < end:
        now = look()
        if now and now == before:
            return now
        before = now
        time.sleep(0.25)
    raise AssertionError("nothing is shown to do")


def states(session):
    """How much was done: one line a stroke or a command."""
    return len(lines_of(session, "# penpose state"))


def walk(name, screen, sight, session, picture):
    hand = Hand(screen, sight)
    for number, kind in enumerate(STEPS[name]):
        look = sight.line if kind in ("line", "lasso") else sight.ring
        shown = sure_sight(look)
        screen.picture(f"{picture}_{name}_{number + 1}")
        if name == "pose" and number == 0:
            # Beside it: it is said so and taken back, and the line is still there to be drawn.
            hand.line(down=-0.075 * sight.height)
            wait_for("the stroke to be taken back", lambda: lines_of(session, "# penpose undo"))
            time.sleep(0.6)
            screen.picture(f"{picture}_{name}_again")
            assert abs(sure_sight(look)[0][0] - shown[0][0]) <= 6, "the line to draw stays"
        before = states(session)
        if kind == "lasso":
            hand.lasso()
        elif kind == "line":
            hand.line()
        else:
            hand.ringed(kind)
        if kind != "press" or number + 1 < len(STEPS[name]):
            wait_for(f"step {number + 1} of {name}", lambda: states(session) > before)
        wait_for(f"what is shown after step {number + 1} of {name}", lambda: look() != shown)
        time.sleep(0.6)
    screen.picture(f"{picture}_{name}_done")
    assert not sight.pixels(GHOST), "the last step is done, and no line is left to draw"
    assert not sight.ring(), "nothing is left to press"


def check_done(name, program, session, environment):
    """What was done is in the session, which replays to it."""
    told = json.loads(subprocess.run([program, "replay", session, "--json"], env=environment, check=True,
                                     stdout=subprocess.PIPE, text=True).stdout)
    assert told["differing"] == 0, told
    if name == "pose":
        assert told["curves"] == 3, told
        assert told["parameters"]["mouth_corner_L"] > 0.3 and told["parameters"]["mouth_corner_R"] > 0.3, told
        assert told["parameters"]["eyelid_upper_L"] > 0.2, told
    elif name == "rig":
        assert 0.3 <= told["parameters"]["control 1"] <= 0.7, told
    else:
        assert told["keys"] == 2, told


def run(program, pictures, width, height, light, tours):
    folder = tempfile.mkdtemp(prefix="penpose-tour-")
    screen = Screen(folder, pictures, width, height)
    try:
        os.makedirs(os.path.join(folder, ".config/penpose"), exist_ok=True)
        with open(os.path.join(folder, ".config/penpose/settings"), "w") as file:
            file.write(f"light={1 if light else 0}\npose_first=1\n")
        sessions = os.path.join(folder, ".local/state/penpose/sessions")
        process = subprocess.Popen([program], env=screen.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   text=True)

        def newest():
            names = sorted(os.listdir(sessions)) if os.path.isdir(sessions) else []
            return [os.path.join(sessions, one) for one in names if one.endswith(".session")]

        wait_for("the first frame", lambda: process.poll() is not None or
                 any(lines_of(path, "# penpose view") for path in newest()))
        assert process.poll() is None, process.stdout.read()
        time.sleep(1)
        if (width, height) != (window_test.WIDTH, window_test.HEIGHT):
            screen.key("Escape")
            screen.key("F11")
            wait_for("the whole screen", lambda: f"{width}x{height}" in lines_of(newest()[-1], "# penpose view")[-1],
                     60)
            time.sleep(0.5)
            screen.key("ctrl+k")
            screen.do("type", "--delay", "60", "tour: pose")
            screen.key("Return")
        else:
            screen.picture("0_offered")
            # A slow machine may show the question later than a hand would wait.
            for _ in range(5):
                screen.click(*OFFERED)
                time.sleep(1.5)
                if Sight(screen, width, height).line():
                    break
        sight = Sight(screen, width, height)
        for number, name in enumerate(tours):
            if number > 0:
                screen.key("ctrl+k")
                screen.do("type", "--delay", "60", "tour: " + {"rig": "make", "animate": "animate"}[name])
                screen.key("Return")
                time.sleep(1)
                # What the tour before drew is not saved: its button in the middle of the window.
                screen.picture(f"{number + 1}_unsaved")
                screen.click(*without_saving(width, height))
            # A session that nothing was done in goes when the tour opens its own.
            sure_sight(sight.line if name == "pose" else sight.ring)
            session = newest()[-1]
            walk(name, screen, sight, session, str(number + 1))
            check_done(name, program, session, screen.environment)
        screen.key("ctrl+q")
        time.sleep(0.5)
    except AssertionError:
        screen.picture("failed")
        raise
    finally:
        if process.poll() is None:
            process.terminate()
            process.wait()
        screen.close()
    shutil.rmtree(folder)


OFFERED = (640, 451)


def without_saving(width, height):
    return width // 2 - 60, height // 2 + 26


def main():
    program = os.path.abspath(sys.argv[1])
    pictures = sys.argv[2] if len(sys.argv) > 2 else ""
    width, height = (int(v) for v in sys.argv[3].split("x")) if len(sys.argv) > 3 else (window_test.WIDTH, window_test.HEIGHT)
    more = sys.argv[4:]
    run(program, pictures, width, height, "light" in more, list(STEPS)[:1] if "first" in more else list(STEPS))


if __name__ == "__main__":
    main()
