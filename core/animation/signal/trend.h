#pragma once

#include <span>
#include <vector>

namespace penpose::animation {

/// Takes tremor out of numbers over time: finds columns that are near the given ones and go straight but for few bends
/// (trend filtering, Kim, Koh, Boyd and Gorinevsky 2009; large bends cost less in a second round, by Candes, Wakin and
/// Boyd 2008; solved by alternating directions), each on its own. It looks at all frames at once and therefore does not
/// lag; a line keeps its slope and a blink its corners, while what shakes about them is averaged along the straight
/// part.
///
/// `rows`: one a frame, all equally long. `trust`: one a frame, above 0 to 1, how much it is believed. `tremor`: the
/// standard deviation of what shakes, in units of the rows; 0 changes nothing.
void follow_trend(std::span<const double> trust, double tremor, std::vector<std::vector<double>>& rows);

}  // namespace penpose::animation
