"""What a virtual machine's screen shows, as QEMU writes it down."""


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
