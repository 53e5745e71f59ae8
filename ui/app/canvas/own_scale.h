#pragma once

#include <optional>
#include <string_view>

namespace penpose::app {

/// What the system says of how large everything shall be, beside the display's density. Zero: it says nothing.
struct SystemScale {
  double text_dpi = 0;   ///< Xft.dpi of the X resources, which desktops on X11 set from their own settings
  double px_a_unit = 0;  ///< px of the display for each unit of a window: what Wayland's compositors set
  double toolkits = 0;   ///< of the variables GDK_SCALE, GDK_DPI_SCALE and QT_SCALE_FACTOR
};

/// Px of the display for each px of an ordinary one, as the system wants it; 0: it says nothing, and the display's
/// density says it. X resources come first, then the compositor, then the toolkits' variables. What is out of 0.5..4 is
/// not heeded, nor is a compositor's 1, which none has chosen.
[[nodiscard]] double own_scale(const SystemScale& system);

/// The value of "Xft.dpi" in X resources, "NAME:<tab>VALUE" lines of which the last one counts; nothing where there is
/// none, or no number in 24..768.
[[nodiscard]] std::optional<double> xft_dpi(std::string_view resources);

/// The product of the numbers in two variables, as toolkits take them; 0 where neither holds one.
[[nodiscard]] double toolkit_scale(const char* whole, const char* part);

}  // namespace penpose::app
