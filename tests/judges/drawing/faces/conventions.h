#pragma once

#include "tests/judges/drawing/faces/mood.h"
#include "tests/judges/drawing/faces/sheet.h"

// Ways in which people draw the features of a face.

namespace penpose::judges::drawn {

/// A feature's middle and half of its size at rest, px.
struct Place {
  PxPoint middle;
  double half_width = 0, half_height = 0;
};

/// The side of the character that is at the left or the right of a picture: 0 left, 1 right of the character.
inline constexpr std::array<double, 2> k_way{1, -1};

/// The mouth as one line; an open one is a closed shape. `half_height`: how far corners go up or down.
void one_line_mouth(Sheet& sheet, const Place& at, const Mood& mood);
/// The mouth as borders of both lips and, where it is shut, the line between them.
void lipped_mouth(Sheet& sheet, const Place& at, const Mood& mood);
/// A shape that is closed, as of cut paper, also where the mouth is shut and smiles.
void shaped_mouth(Sheet& sheet, const Place& at, const Mood& mood);

/// An eye as a dot: a ring around it where it is wide, a dash where it is half shut, an arc where it is shut.
void dot_eye(Sheet& sheet, const Place& at, double lid);
/// An oval with a pupil; lids cut it; an arc where it is shut. `smiles`: shut eyes are arcs like a roof.
void oval_eye(Sheet& sheet, const Place& at, double lid, bool smiles);
/// Two lids that meet in corners, and the iris between them. `outwards`: 1 where the outer corner is to the right.
void lidded_eye(Sheet& sheet, const Place& at, double lid, double outwards);

/// A brow from its inner to its outer end. `half_height`: how far its ends go up or down; `arch`: of its middle, px.
void brow(Sheet& sheet, const Place& at, const Mood& mood, std::size_t side, double arch);

}  // namespace penpose::judges::drawn
