"""Between Blender's space and the character's: y up, the object's own place and turn taken out, its scale kept.

A character lies as glTF writes the object: (x, y, z) of the object is (x, z, -y) there. Scale and shear of an object go into the
character, so that a px is as wide as it is high in every view.
"""
import math

import numpy as np
from mathutils import Matrix

from .library import View

Y_UP = Matrix(((1, 0, 0), (0, 0, 1), (0, -1, 0)))
LEAST_FOV = 1.0  # degrees: what stands for a view without perspective


class Space:
    """Where the character of an object lies: character = linear * object, world = turn * character + place."""

    def __init__(self, matrix_world):
        turn = matrix_world.to_quaternion().to_matrix()
        scale = turn.transposed() @ matrix_world.to_3x3()
        if max(abs(a - b) for row, one in zip(scale, Matrix.Identity(3)) for a, b in zip(row, one)) < 1e-6:
            scale = Matrix.Identity(3)
        self.linear = Y_UP @ scale
        self.turn = turn @ Y_UP.transposed()
        self.place = matrix_world.to_translation()
        self.mirrored = self.linear.determinant() < 0

    def of_object(self, points):
        """Points (n, 3) of the object's own space, as the character has them."""
        linear = np.array(self.linear)
        if np.array_equal(np.abs(linear).sum(axis=0), np.ones(3)):
            # Nothing is rounded where axes only change places.
            out = np.empty_like(np.asarray(points, dtype=np.float64))
            for row in range(3):
                column = int(np.argmax(np.abs(linear[row])))
                out[:, row] = np.asarray(points)[:, column] * linear[row, column]
            return out
        return np.asarray(points, dtype=np.float64) @ linear.T

    def to_object(self, points):
        """Points or directions (n, 3) of the character, in the object's own space."""
        return np.asarray(points, dtype=np.float64) @ np.linalg.inv(np.array(self.linear)).T

    def to_world(self, points):
        """Points (n, 3) of the character, in the world."""
        return np.asarray(points, dtype=np.float64) @ np.array(self.turn).T + np.array(self.place)

    def from_world(self, points):
        """Points (n, 3) of the world, in the character's space."""
        return (np.asarray(points, dtype=np.float64) - np.array(self.place)) @ np.array(self.turn)

    def of_world(self, point):
        """A point of the world, in the character's space."""
        return self.turn.transposed() @ (point - self.place)

    def from_world(self, points):
        """Points (n, 3) of the world, in the character's space."""
        return (np.asarray(points, dtype=np.float64) - np.array(self.place)) @ np.array(self.turn)


class Seen:
    """A view of the 3D viewport: what penpose draws from, and where its px lie in the region."""

    def __init__(self, view, shift):
        self.view = view
        self.shift = shift  # px of the view minus those of the region

    def px(self, places):
        """px (n, 2) of the view at places of the region, which count from its lower left corner."""
        return np.asarray([(x + self.shift[0], self.shift[1] - y) for x, y in places], dtype=np.float64)

    def places(self, px):
        """The way back."""
        return np.asarray([(x - self.shift[0], self.shift[1] - y) for x, y in px], dtype=np.float64)


def seen_by(view_matrix, window_matrix, width, height, space, around):
    """How a region of width x height px shows the character. `around`: a point of the world that is drawn on, for views
    without perspective, which a pinhole far away stands for."""
    window = window_matrix
    perspective = abs(window[3][2]) > 0.5
    half_wide, half_high = 0.5 * width, 0.5 * height
    # The axis of the view need not go through the middle of the region: cameras are shifted and zoomed.
    if perspective:
        middle = (half_wide * (1 - window[0][2]), half_high * (1 - window[1][2]))
    else:
        middle = (half_wide * (1 + window[0][3]), half_high * (1 + window[1][3]))
    wide = max(1, min(32768, math.ceil(2 * max(middle[0], width - middle[0]))))
    high = max(1, min(32768, math.ceil(2 * max(middle[1], height - middle[1]))))
    camera = view_matrix.inverted()
    if perspective:
        fov = math.degrees(2 * math.atan(0.5 * high / (half_high * window[1][1])))
        eye = camera.to_translation()
    else:
        fov = LEAST_FOV
        away = 0.5 * high / math.tan(math.radians(0.5 * fov)) / (half_high * window[1][1])
        depth = (view_matrix @ around).z
        eye = camera @ Matrix.Translation((0, 0, depth + away)).to_translation()
    turn = camera.to_3x3().normalized()
    look = eye - turn.col[2] * max(1e-3, (eye - around).length)
    points = [space.of_world(p) for p in (eye, look)]
    up = space.turn.transposed() @ turn.col[1]
    view = View(tuple(points[0]), tuple(points[1]), tuple(up), min(179.0, max(LEAST_FOV, fov)), wide, high)
    return Seen(view, (0.5 * wide - middle[0], 0.5 * high + middle[1]))
