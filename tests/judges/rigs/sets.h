#pragma once

#include "tests/judges/rigs/builder.h"

namespace penpose::judges {

/// Shapes for each side of brows, eyes, nose and mouth, and pucker, funnel and jaw, under plain names.
void add_brows(FaceBuilder& face);
void add_lids(FaceBuilder& face);
void add_mouth(FaceBuilder& face);

/// The 52 shapes of ARKit (51 without a tongue), by its names.
void add_arkit(FaceBuilder& face);

/// Mouths of speech: aa, E, ih, oh, ou and the consonants, each name behind `before`.
void add_visemes(FaceBuilder& face, const std::string& before);

/// How far each vertex goes with a muscle: 1 where it moves farthest.
[[nodiscard]] std::vector<double> share_of(const Field& field);

}  // namespace penpose::judges
