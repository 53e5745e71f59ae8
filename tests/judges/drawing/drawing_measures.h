#pragma once

#include <vector>

#include "tests/judges/measures/measure.h"

// Measures of drawings of whole faces, whose lines have no labels. On rigs that are seen, artists draw that are seen,
// on those that are held out artists that are held out, on rigs of other people all of them (faces/artist.h).

namespace penpose::judges {

/// Drawings of known poses, over the face that a view shows and beside it, on a sheet of their own, in proportions (and
/// over the face, in places) that are off by nothing, a tenth and a fifth: drawing_over, drawing_over_10,
/// drawing_over_20, drawing_beside, drawing_beside_10, drawing_beside_20. right: lines given a mark that is right, of
/// all lines; error, stray and still as for other known poses.
[[nodiscard]] std::vector<Measure> known_drawing_measures();

/// Faces as people draw them, with no pose behind them. right: poses on which a person sees what is meant; nothing:
/// that move nothing, or are refused; stray: how far lips or lids run through one another, per cent of the face's
/// height; still: of faces at rest.
[[nodiscard]] Measure drawn_face_measure();

/// Drawings of other things. right: nothing moves that a person would see; still: the largest movement.
[[nodiscard]] Measure no_face_measure();

/// The drawings of sets/, by hands of their own, judged in the same way: faces; faces with the same hand's drawing of
/// the face at rest given; what is no face. On shared rigs the hands that are held out are one case, their totals.
[[nodiscard]] Measure people_measure();
[[nodiscard]] Measure people_beside_rest_measure();
[[nodiscard]] Measure people_no_face_measure();

/// The drawings of the shared data on shared rigs, judged in the same way; what is no face counts as right or not, too.
[[nodiscard]] Measure shared_drawing_measure();

/// All of these.
[[nodiscard]] std::vector<Measure> drawing_measures();

}  // namespace penpose::judges
