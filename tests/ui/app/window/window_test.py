"""Uses the program in a real window under Xvfb as a new user would: sketches a control, poses the mouth, keys it, saves,
quits and opens it again; then does the same with the reports of a pen alone, played in place of a tablet. Reads the
document's state from the session.

    window_test.py PROGRAM [FOLDER_FOR_PICTURES [WAY]]

With WAY (gl, es, cpu) only the first of it and the full screen, and it is drawn by that way: found by the program itself where the environment
has made the better ones fail.
"""

import json
import os
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import zlib

WIDTH, HEIGHT = 1280, 800

# A control for a brow: around what may move, around what moves fully, where it should go. Then the mouth.
GENERAL = [(400, 300), (400, 260), (440, 240), (500, 245), (525, 270), (520, 310), (490, 322), (440, 320), (400, 303)]
SPECIFIC = [(415, 297), (415, 285), (450, 268), (490, 272), (500, 285), (500, 296), (450, 298), (416, 298)]
RAISED = [(415, 275), (430, 262), (450, 255), (475, 255), (497, 262)]
MOUTH = [(470, 464), (490, 468), (505, 471), (517, 472), (530, 471), (545, 468), (564, 464)]
SMILE = [(462, 446), (480, 458), (500, 470), (517, 476), (534, 470), (550, 461), (560, 452), (572, 446)]


def on_canvas(points, player=False):
    """Strokes that were measured where the canvas was 665 px high: the head follows the canvas's size."""
    height, middle = (545, 320.5) if player else (593, 344.5)
    share = height / 665
    return [(round(514 + (x - 525) * share), round(middle + (y - 379.5) * share)) for x, y in points]


def write_png(source, path):
    """Xvfb's picture of its screen (X window dump, 32 bits a pixel) as a PNG."""
    with open(source, "rb") as file:
        data = file.read()
    head = struct.unpack(">25I", data[:100])
    start, width, height, stride = head[0] + head[19] * 12, head[4], head[5], head[12]
    rows = bytearray()
    for y in range(height):
        row = data[start + y * stride : start + y * stride + 4 * width]
        line = bytearray(3 * width)
        line[0::3], line[1::3], line[2::3] = row[2::4], row[1::4], row[0::4]
        rows += b"\0" + line

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)))
        file.write(chunk(b"IDAT", zlib.compress(bytes(rows), 1)) + chunk(b"IEND", b""))


def begin_with_pose(home):
    """Whoever took Pose last finds it again; a newcomer has Draw in hand."""
    settings = os.path.join(home, ".config", "penpose", "settings")
    os.makedirs(os.path.dirname(settings), exist_ok=True)
    with open(settings, "w") as file:
        file.write("pose_first=1\n")


class Screen:
    def __init__(self, folder, pictures, width=WIDTH, height=HEIGHT):
        self.folder, self.pictures = folder, pictures
        begin_with_pose(folder)
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{width}x{height}x24", "-fbdir", folder],
            pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as answer:
            number = answer.readline().strip()
        assert number, "Xvfb did not start"
        self.environment = dict(os.environ, DISPLAY=":" + number, HOME=folder, SDL_VIDEODRIVER="x11")
        for name in ("XDG_STATE_HOME", "XDG_CONFIG_HOME", "WAYLAND_DISPLAY"):
            self.environment.pop(name, None)

    def close(self):
        self.server.terminate()
        self.server.wait()

    def do(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=True, stdout=subprocess.DEVNULL)

    def click(self, x, y):
        self.do("mousemove", x, y)
        time.sleep(0.15)
        self.do("click", 1)
        time.sleep(0.4)

    def key(self, name):
        self.do("key", name)
        time.sleep(0.4)

    def stroke(self, points):
        points = on_canvas(points)
        self.do("mousemove", *points[0])
        time.sleep(0.1)
        self.do("mousedown", 1)
        for point in points[1:]:
            self.do("mousemove", *point)
            time.sleep(0.03)
        self.do("mouseup", 1)
        time.sleep(0.4)

    def shows_something(self):
        with open(os.path.join(self.folder, "Xvfb_screen0"), "rb") as file:
            data = file.read()
        head = struct.unpack(">25I", data[:100])
        return any(data[head[0] + head[19] * 12 :])

    def picture(self, name):
        if self.pictures:
            write_png(os.path.join(self.folder, "Xvfb_screen0"), os.path.join(self.pictures, name + ".png"))


def lines_of(session, start):
    with open(session) as file:
        return [line for line in file if line.startswith(start)]


def wait_for(what, condition, seconds=20):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if condition():
            return
        time.sleep(0.1)
    raise AssertionError("waited in vain for " + what)


def start(program, screen, session, *words):
    process = subprocess.Popen([program, "--session", session, *words], env=screen.environment,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    # The first view of the window's own size is written with the first frame.
    wait_for("the first frame", lambda: process.poll() is not None or
             (os.path.exists(session) and any(f"{WIDTH}" in line for line in lines_of(session, "# penpose view"))))
    assert process.poll() is None, process.stdout.read()
    time.sleep(1)
    return process


def quit_window(screen, process):
    screen.key("ctrl+q")
    assert process.wait(timeout=20) == 0, process.stdout.read()


def use(program, screen, folder):
    session = os.path.join(folder, "first.session")
    process = start(program, screen, session)
    screen.picture("1_start")
    screen.key("Escape")
    screen.key("shift+1")
    screen.key("a")
    screen.stroke(GENERAL)
    screen.picture("2_region")
    screen.stroke(SPECIFIC)
    screen.picture("3_weights")
    screen.stroke(RAISED)
    screen.picture("4_control")
    # The mouth: where it is, where it should go.
    screen.key("b")
    screen.stroke(MOUTH)
    screen.stroke(SMILE)
    screen.picture("5_posed")
    screen.key("i")
    screen.key("ctrl+s")
    screen.picture("6_save")
    screen.key("Escape")
    project = os.path.join(folder, "head.glb")
    # The dialog's own button, found as a user finds it: it is in the middle of the window.
    screen.key("ctrl+s")
    screen.click(330, 586)
    wait_for("the project", lambda: os.path.exists(project))
    screen.picture("7_saved")
    quit_window(screen, process)
    states = lines_of(session, "# penpose state")
    strokes = [line for line in open(session) if line.startswith("E:")]
    assert len(states) >= 7, states
    assert len(strokes) > 30, len(strokes)
    # The session replays to what it says, and the project opens as what was saved.
    replayed = json.loads(subprocess.run([program, "replay", session, "--json"], env=screen.environment, check=True,
                                         stdout=subprocess.PIPE, text=True).stdout)
    whole = states[-1].split()[3]
    assert replayed["state"] == whole, (replayed, whole)
    second = os.path.join(folder, "second.session")
    process = start(program, screen, second, project)
    screen.picture("8_again")
    named = lines_of(second, "# penpose model")[0].split()[3]
    assert named == whole, f"saved {whole}, opened {named}"
    quit_window(screen, process)
    return session


def play(program, screen, folder, session):
    """The pen's part of the session alone, as a tablet would send it."""
    trace = os.path.join(folder, "pen.hid")
    with open(session) as source, open(trace, "w") as out:
        out.writelines(line for line in source if line[:2] in ("R:", "N:", "I:", "E:", "D:"))
    played = os.path.join(folder, "played.session")
    done = subprocess.run([program, "--replay", trace, "--session", played, "--timings"], env=screen.environment,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=90)
    assert done.returncode == 0, done.stdout
    assert len(lines_of(played, "E:")) >= len(lines_of(trace, "E:")), "a report of the trace was lost"
    print(done.stdout, end="")
    return done.stdout


class PenTrace:
    """What a tablet sends, 300 reports a second, in px of the window."""

    def __init__(self, head):
        self.lines, self.time = list(head), 0.0

    def report(self, x, y, touches):
        x, y, pressure = round(x / WIDTH * 65535), round(y / HEIGHT * 65535), 2500 if touches else 0
        body = [1, 3 if touches else 1, x & 255, x >> 8, y & 255, y >> 8, pressure & 255, pressure >> 8]
        self.time += 1 / 300
        self.lines.append(f"E: {self.time:.6f} 8 {' '.join(f'{b:02x}' for b in body)}\n")

    def hold(self, x, y, touches, seconds):
        for _ in range(round(300 * seconds)):
            self.report(x, y, touches)

    def tap(self, x, y):
        self.hold(x, y, False, 0.5)
        self.hold(x, y, True, 0.2)
        self.hold(x, y, False, 0.5)

    def stroke(self, points):
        # The player's row below the canvas makes the head smaller still.
        points = on_canvas(points, player=True)
        self.hold(*points[0], False, 0.3)
        for (x0, y0), (x1, y1) in zip(points, points[1:]):
            for i in range(20):
                self.report(x0 + (x1 - x0) * i / 20, y0 + (y1 - y0) * i / 20, True)
        self.hold(*points[-1], True, 0.05)
        self.hold(*points[-1], False, 0.4)


def pen_alone(program, screen, folder, session):
    """The same story with a tablet's reports alone: buttons are pressed by the pen, nothing else is touched."""
    head = [line for line in open(session) if line[:2] in ("R:", "N:", "I:", "D:")]
    pen = PenTrace(head)
    pen.hold(640, 400, False, 1)
    pen.tap(640, 589)  # Begin
    pen.tap(24, 231)  # Rig
    for line in (GENERAL, SPECIFIC, RAISED):
        pen.stroke(line)
    pen.tap(66, 72)  # Pose
    for line in (MOUTH, SMILE):
        pen.stroke(line)
    pen.tap(490, 690)  # Key
    pen.tap(50, 24)  # Menu
    pen.tap(224, 198)  # Save
    pen.tap(330, 586)  # the button of that name
    trace = os.path.join(folder, "alone.hid")
    with open(trace, "w") as out:
        out.writelines(pen.lines)
    home = os.path.join(folder, "home")
    os.mkdir(home)
    played = os.path.join(folder, "alone.session")
    process = subprocess.Popen([program, "--replay", trace, "--session", played, "--timings"],
                               env=dict(screen.environment, HOME=home), stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True)
    time.sleep(pen.time * 0.5)
    screen.picture("9_alone")
    output, _ = process.communicate(timeout=120)
    assert process.returncode == 0, output
    assert len(lines_of(played, "E:")) >= sum(line.startswith("E:") for line in pen.lines), "a report was lost"
    done = "".join(lines_of(played, "# penpose do"))
    assert "begin_deformer" in done and "set_key" in done, done
    project = os.path.join(home, "head.glb")
    assert os.path.exists(project), output
    whole = lines_of(played, "# penpose state")[-1].split()[3]
    told = json.loads(subprocess.run([program, "info", project, "--json"], check=True, stdout=subprocess.PIPE,
                                     text=True).stdout)
    assert "control 1" in json.dumps(told), told
    again = os.path.join(folder, "alone2.session")
    process = start(program, screen, again, project)
    screen.picture("10_alone_again")
    assert lines_of(again, "# penpose model")[0].split()[3] == whole, "what was saved opens as it was"
    quit_window(screen, process)
    print(output, end="")


def drawn_face(program, screen, folder):
    """A newcomer draws a mouth: the face takes it, with one line."""
    home = os.path.join(folder, "newcomer")
    os.mkdir(home)
    session = os.path.join(folder, "face.session")
    before = screen.environment
    screen.environment = dict(before, HOME=home)
    process = start(program, screen, session)
    screen.key("Escape")
    screen.key("shift+1")
    screen.stroke(SMILE)
    screen.picture("10_drawn_face")
    screen.key("ctrl+q")
    time.sleep(0.5)
    process.send_signal(signal.SIGTERM)
    assert process.wait(timeout=20) == 0, process.stdout.read()
    screen.environment = before
    replayed = json.loads(subprocess.run([program, "replay", session, "--json"], env=screen.environment, check=True,
                                         stdout=subprocess.PIPE, text=True).stdout)
    assert replayed["differing"] == 0 and replayed["curves"] == 0, replayed
    moved = {name: value for name, value in replayed["parameters"].items() if abs(value) > 0.05}
    assert any("mouth" in name or "lip" in name for name in moved), moved


def asked_to_end(program, screen, folder):
    """A signal ends the program as a user would, without a question, and the session holds everything."""
    session = os.path.join(folder, "ended.session")
    process = start(program, screen, session)
    screen.key("shift+1")
    screen.stroke(MOUTH)
    process.send_signal(signal.SIGTERM)
    assert process.wait(timeout=20) == 0, process.stdout.read()
    states = lines_of(session, "# penpose state")
    assert states, "the stroke is in the file"
    replayed = json.loads(subprocess.run([program, "replay", session, "--json"], env=screen.environment, check=True,
                                         stdout=subprocess.PIPE, text=True).stdout)
    assert replayed["state"] == states[-1].split()[3], replayed


def crash(program, screen, folder):
    """A program that is killed leaves a session that replays."""
    session = os.path.join(folder, "killed.session")
    process = start(program, screen, session)
    screen.key("shift+1")
    screen.stroke([(470, 464), (490, 468), (517, 472), (545, 468), (564, 464)])
    process.send_signal(signal.SIGKILL)
    process.wait()
    subprocess.run([program, "replay", session], env=screen.environment, check=True, stdout=subprocess.DEVNULL)
    assert lines_of(session, "# penpose state"), "the stroke is in the file"


def killed_twice(program, screen, folder):
    """Work comes back after a crash, and again after the next one, in one session that replays."""
    home = os.path.join(folder, "killed")
    environment = dict(screen.environment, HOME=home)
    begin_with_pose(home)
    sessions = os.path.join(home, ".local/state/penpose/sessions")

    def newest():
        return [os.path.join(sessions, name) for name in sorted(os.listdir(sessions)) if name.endswith(".session")]

    def begin():
        process = subprocess.Popen([program], env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        wait_for("the first frame", lambda: process.poll() is not None or screen.shows_something())
        assert process.poll() is None, process.stdout.read()
        time.sleep(1.5)
        return process

    process = begin()
    screen.key("Escape")
    screen.key("shift+1")
    screen.stroke(MOUTH)
    screen.stroke(SMILE)
    (session,) = newest()
    for _ in range(2):
        process.send_signal(signal.SIGKILL)
        process.wait()
        before, begun = len(lines_of(session, "# penpose state")), len(lines_of(session, "# penpose tablet"))
        process = begin()
        screen.picture("11_offered")
        screen.key("Return")
        wait_for("the work to be brought back", lambda: len(lines_of(session, "# penpose tablet")) > begun)
        # While the work is being drawn again, keys do nothing.
        began = time.monotonic()
        while len(lines_of(session, "# penpose state")) <= before:
            assert time.monotonic() - began < 60, "waited in vain for the key in the session"
            screen.key("i")
            time.sleep(2)
    process.send_signal(signal.SIGTERM)
    began = time.monotonic()
    assert process.wait(timeout=20) == 0, process.stdout.read()
    print(f"ended {time.monotonic() - began:.2f} s after it was asked to")
    replayed = json.loads(subprocess.run([program, "replay", session, "--json"], env=screen.environment, check=True,
                                         stdout=subprocess.PIPE, text=True).stdout)
    assert replayed["state"] == lines_of(session, "# penpose state")[-1].split()[3], replayed


def full_screen(program, folder, pictures):
    """Without a window manager the window fills the screen and is itself again, and what is in it follows."""
    screen = Screen(folder, pictures, 1600, 1000)
    try:
        session = os.path.join(folder, "full.session")
        process = start(program, screen, session)
        screen.key("Escape")

        def last_view():
            return lines_of(session, "# penpose view")[-1]

        for turn in range(2):
            screen.key("F11")
            wait_for("the full screen", lambda: "1600" in last_view() and "1000" in last_view())
            screen.picture(f"12_full_{turn}")
            screen.key("F11")
            wait_for("the window", lambda: f"{WIDTH}" in last_view() and f"{HEIGHT}" in last_view())
            screen.picture(f"13_window_{turn}")
        quit_window(screen, process)
    finally:
        screen.close()


def no_display(program, folder):
    environment = {"PATH": os.environ["PATH"], "HOME": folder}
    done = subprocess.run([program], env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=30)
    if done.returncode == 0:
        return
    assert done.returncode == 1 and done.stdout == "" and done.stderr.count("\n") == 1, done.stderr
    assert "display" in done.stderr, done.stderr


def main():
    program = os.path.abspath(sys.argv[1])
    pictures = sys.argv[2] if len(sys.argv) > 2 else ""
    folder = tempfile.mkdtemp(prefix="penpose-window-")
    screen = Screen(folder, pictures)
    try:
        session = use(program, screen, folder)
        told = play(program, screen, folder, session)
        if len(sys.argv) > 3:
            assert f"drawn_by {sys.argv[3]}\n" in told, told
        else:
            pen_alone(program, screen, folder, session)
            drawn_face(program, screen, folder)
            asked_to_end(program, screen, folder)
            crash(program, screen, folder)
            killed_twice(program, screen, folder)
    finally:
        screen.close()
    full_screen(program, folder, pictures)
    no_display(program, folder)
    shutil.rmtree(folder)


if __name__ == "__main__":
    main()
