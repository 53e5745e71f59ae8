#pragma once

#include <optional>
#include <string_view>

namespace penpose::app {

/// Px per inch of a display that scales nothing.
inline constexpr double k_scale_one_dpi = 96;

/// What the system says of how large everything shall be. Zero: it says nothing.
struct SystemScale {
  double text_dpi = 0;    ///< Xft.dpi of the X resources, which desktops on X11 set from their own settings
  double px_a_unit = 0;   ///< px of the display for each unit of a window: what Wayland's compositors set
  double toolkits = 0;    ///< of the variables GDK_SCALE, GDK_DPI_SCALE and QT_SCALE_FACTOR
  double server_dpi = 0;  ///< that the X server was started with (`-dpi`): its size in px over that in millimetres
};

/// Px of the display for each px of an ordinary one, as the system wants it; 0: it says nothing, and the display's
/// density says it. X resources come first, then the compositor, then the toolkits' variables, then what the X server
/// was started with. What is out of 0.5..4 is not heeded, nor is what nobody has chosen: a compositor's 1, a server's
/// 96 or 100.
[[nodiscard]] double own_scale(const SystemScale& system);

/// Px per inch of so many px in so many millimetres; 0 where either is none.
[[nodiscard]] double dpi_of(int px, int millimetres);

/// Px of a window that is opened in a place of `all` px: `usual` ones at the nearest quarter of a scale, and no more
/// than there are.
[[nodiscard]] int opened_px(int usual, double scale, int all);

/// The value of "Xft.dpi" in X resources, "NAME:<tab>VALUE" lines of which the last one counts; nothing where there is
/// none, or no number in 24..768.
[[nodiscard]] std::optional<double> xft_dpi(std::string_view resources);

/// The product of the numbers in two variables, as toolkits take them; 0 where neither holds one.
[[nodiscard]] double toolkit_scale(const char* whole, const char* part);

}  // namespace penpose::app
