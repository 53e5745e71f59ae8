#pragma once

#include <utility>
#include <variant>

#include "core/articulation/surface/free.h"
#include "core/articulation/surface/part_surface.h"
#include "core/articulation/surface/sphere.h"

// The kinds of surfaces that deformers slide over. Each is a class with its name in sessions (k_name), its key in
// sketch files and the form of its value there (k_key, k_form; one member stands alone, more are an object), its
// members, and what sketches, the window and the motion ask of it:
//
//   check      whether it can be, as far as that shows without a model; the place of an error begins "surface/KEY"
//   mirrored   the same on the model's other side
//   held       what keeps the distance of points on a model
//   k_of_region  whether it is fitted to one region, and dropped for the next control
//   words      what is shown of one that was chosen
//   offered    what there is to choose on a model, for a region
//
// Everything else knows them from the list here.

namespace penpose::articulation {

/// What a deformer slides over. Where none was chosen it is the ball that its curve lies on (ball_under.h), if any.
using Surface = std::variant<std::monostate, Sphere, PartSurface, Free>;

/// What visit(one) gives for the surface, or `none` where there is none.
template <typename Visit, typename None>
None of_surface(const Surface& surface, None none, Visit&& visit) {
  return std::visit(
      [&]<typename Kind>(const Kind& one) -> None {
        if constexpr (std::is_same_v<Kind, std::monostate>) {
          return std::move(none);
        } else {
          return visit(one);
        }
      },
      surface);
}

/// Calls visit<Kind>() for every kind, in the order of the list.
template <std::size_t Number = 1>
void each_surface_kind(auto&& visit) {
  if constexpr (Number < std::variant_size_v<Surface>) {
    visit.template operator()<std::variant_alternative_t<Number, Surface>>();
    each_surface_kind<Number + 1>(visit);
  }
}

}  // namespace penpose::articulation
