"""The tablet that QEMU itself emulates, drawn with from outside."""
import math


class Pen:
    """QEMU's emulated PenPartner, moved from outside one report at a time: the next movement waits until the machine has
    recorded the one before. `sent` holds what every report must say: x, y, pressure, tip."""

    def __init__(self, vm):
        self.vm, self.sent, self.state = vm, [], {'x': 0, 'y': 0, 'tip': False}

    def recorded(self):
        return self.trace().count(b'\nE:')

    def trace(self):
        with open(self.vm.live, 'rb') as f:
            return f.read()

    def move(self, x=None, y=None, tip=None):
        events = []
        for axis, value in (('x', x), ('y', y)):
            if value is not None:
                self.state[axis] = int(value)
                events.append({'type': 'abs', 'data': {'axis': axis, 'value': int(value)}})
        if tip is not None:
            self.state['tip'] = tip
            events.append({'type': 'btn', 'data': {'button': 'left', 'down': tip}})
        before = self.recorded()
        self.vm.command('input-send-event', events=events)
        self.vm.wait(lambda: self.recorded() > before, 'a report of the pen', 60)
        s = self.state
        self.sent.append((s['x'] * 5040 // 0x7fff, s['y'] * 3780 // 0x7fff, 127 if s['tip'] else 0, s['tip']))

    def draw(self):
        # The device reports once by itself, when it is first asked.
        self.vm.wait(lambda: self.recorded() > 0, 'the first report of the pen', 60)
        self.sent.append((0, 0, 0, False))
        for i in range(10):
            self.move(1000 + 50 * i, 1000 + 20 * i)
        for stroke in range(3):
            self.move(tip=True)
            for i in range(30):
                a = i * math.pi / 15
                self.move(9000 + 5000 * stroke + 3000 * math.cos(a), 12000 + 4000 * math.sin(a))
            if stroke == 2:
                return  # pulled out while it draws
            self.move(tip=False)
            self.move(20000, 30000 - stroke)
