"""What a virtual machine's screen shows, as QEMU writes it down, and what tests of the window ask of it."""
import time
import unittest

LIBRARIES = '/usr/lib/x86_64-linux-gnu/'
MESA = [LIBRARIES + name for name in ('libgbm.so.1', 'libdrm.so.2', 'libEGL.so.1', 'libEGL_mesa.so.0', 'libGL.so.1', 'libOpenGL.so.0',
                                      'libGLX_mesa.so.0', 'dri/kms_swrast_dri.so')]
MESA += ['/usr/share/glvnd/egl_vendor.d/50_mesa.json']
FONT = '/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf'
WIDTH, HEIGHT = 640, 480
LEAST_SHADES = 1000
LEAST_SKIN = 0.02


def read(path):
    """The pixels of a binary PPM, rows of (red, green, blue)."""
    with open(path, 'rb') as f:
        content = f.read()
    width, height = (int(word) for word in content.split(maxsplit=3)[1:3])
    pixels = content[-3 * width * height:]
    return [[tuple(pixels[3 * (y * width + x):3 * (y * width + x) + 3]) for x in range(width)] for y in range(height)]


def skin_in(picture):
    """The share of pixels of the head's skin: redder than blue by far, which panels and background are not."""
    return sum(r > b + 30 and r > 100 for row in picture for r, g, b in row) / (len(picture) * len(picture[0]))


def shows_head(picture):
    return skin_in(picture) > LEAST_SKIN


def look_until(vm, path, is_there, seconds):
    """Leaves what the screen shows in a file, and looks again until it is that or the time is over."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        time.sleep(2)
        vm.command('screendump', filename=path)
        if is_there(read(path)):
            break


class WindowOnScreen(unittest.TestCase):
    """Tests of a window on a bare screen: `shot` is to be set to a file of what it shows, `results` to what the machine left."""
    shot, results = '', {}

    def test_the_head_is_seen_between_the_panels(self):
        picture = read(self.shot)
        self.assertEqual((len(picture[0]), len(picture)), (WIDTH, HEIGHT))
        self.assertGreater(len({p for row in picture for p in row}), LEAST_SHADES)
        self.assertGreater(skin_in(picture), LEAST_SKIN)
        self.assertLess(skin_in(picture), 0.5)

    def test_a_polite_end_is_an_orderly_one(self):
        self.assertEqual(self.results['status'].decode().strip(), '0', self.results.get('app.txt', b'').decode())
        self.assertIn('# penpose', self.results['drawn.session'].decode())
