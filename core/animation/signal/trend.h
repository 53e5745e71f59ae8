#pragma once

#include <span>
#include <vector>

namespace penpose::animation {

/// Removes tremor from numbers over time: finds columns that are near the given ones and piecewise linear with few
/// bends (trend filtering, Kim, Koh, Boyd and Gorinevsky 2009; large bends cost less in a second round, by Candes,
/// Wakin and Boyd 2008; solved by alternating directions), each column on its own. It uses all frames at once and
/// therefore does not lag; a line keeps its slope and a blink its corners, while the tremor is averaged along the
/// straight parts.
///
/// `rows`: one a frame, all equally long. `trust`: weight of each frame, above 0 to 1. `tremor`: its standard
/// deviation, in units of the rows; 0 changes nothing.
void follow_trend(std::span<const double> trust, double tremor, std::vector<std::vector<double>>& rows);

}  // namespace penpose::animation
