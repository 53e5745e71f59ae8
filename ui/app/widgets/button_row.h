#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/app/panels/panels.h"
#include "ui/app/widgets/button_weight.h"

namespace penpose::app {

/// A row of buttons in a panel. Where not all have room their icons stand alone, and what still has none stands in a
/// menu at its end, so that nothing is ever cut off.
class ButtonRow {
 public:
  struct Button {
    std::string label;  ///< under which it is found; what stands behind "##" is not shown
    std::string_view icon = {};
    std::string tip = {};
    bool text = true;  ///< the label is shown, beside the icon
    bool chosen = false;
    bool enabled = true;
    std::function<void()> does = {};
    std::function<void(PanelContext&, float width)> shows = {};  ///< something else than a button, that wide
    float width = 0;                                             ///< of that
    float least = 0, most = 0;  ///< where there is less or more room; 0: as wide as ever
    bool spare = false;         ///< others are not narrower for it
    ButtonWeight weight = ButtonWeight::quiet;
    bool keeps_word = false;  ///< beside its icon, also where there is little room
    bool separates = false;   ///< a line, which a menu has no use for
  };

  ButtonRow(PanelContext& context, const char* name) : context_(context), name_(name) {}
  void add(Button button) { buttons_.push_back(std::move(button)); }
  void add(Action action, bool chosen = false, bool enabled = true, bool text = true,
           ButtonWeight weight = ButtonWeight::quiet);
  /// A line between what was added and what comes next.
  void separate();
  /// Shows them from the cursor on, in `width` px. Px that it took.
  float show(float width);

 private:
  [[nodiscard]] float width_of(const Button& button) const;
  [[nodiscard]] std::vector<float> widths() const;
  /// Px of all, or of those that are not spare.
  [[nodiscard]] float sum_of(const std::vector<float>& widths, bool with_spare) const;
  /// Gives those that can be wider or narrower what is left or lacking of `width` px.
  void fit(std::vector<float>& widths, float width) const;
  bool show_one(const Button& button, float width, bool text);

  PanelContext& context_;
  const char* name_;
  std::vector<Button> buttons_;
  bool in_menu_ = false;
};

}  // namespace penpose::app
