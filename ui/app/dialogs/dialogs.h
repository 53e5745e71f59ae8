#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "ui/app/states.h"

namespace penpose::app {

/// A dialog by its name in the list of dialogs (dialog_list.cpp).
struct Dialog {
  std::string_view name;
  friend constexpr bool operator==(Dialog, Dialog) = default;

  // Those that are asked for by name elsewhere.
  static const Dialog none, open, save, export_as, recent, recover, steps, tablet, pad, sessions, unsaved, number,
      key_name, radial, shortcuts, search, history, film, backdrop, sound, older_session, drawn_again;
};
inline constexpr Dialog Dialog::none{""}, Dialog::open{"open"}, Dialog::save{"save"}, Dialog::export_as{"export"},
    Dialog::recent{"recent"}, Dialog::recover{"recover"}, Dialog::steps{"steps"}, Dialog::tablet{"tablet"},
    Dialog::pad{"pad"}, Dialog::sessions{"sessions"}, Dialog::unsaved{"unsaved"}, Dialog::number{"number"},
    Dialog::key_name{"key name"}, Dialog::radial{"radial"}, Dialog::shortcuts{"shortcuts"}, Dialog::search{"search"},
    Dialog::history{"history"}, Dialog::film{"film"}, Dialog::backdrop{"backdrop"}, Dialog::sound{"sound"},
    Dialog::older_session{"older session"}, Dialog::drawn_again{"drawn again"};

/// Which dialog is open, and what each keeps for itself.
class Dialogs {
 public:
  [[nodiscard]] Dialog open() const { return open_; }
  [[nodiscard]] bool any() const { return open_ != Dialog::none; }
  /// Shows it, here or where `send_elsewhere` does.
  void show(Dialog dialog) { open_ = elsewhere_ && elsewhere_(dialog) ? Dialog::none : dialog; }
  /// Shows our own.
  void show_ours(Dialog dialog) { open_ = dialog; }
  /// Who may show a dialog in place of ours: true, it does.
  void send_elsewhere(std::function<bool(Dialog)> elsewhere) { elsewhere_ = std::move(elsewhere); }
  void close() { open_ = Dialog::none; }
  /// What a dialog keeps, made when it is first asked for.
  template <typename State>
  [[nodiscard]] State& state() {
    return states_.of<State>();
  }

 private:
  Dialog open_ = Dialog::none;
  std::function<bool(Dialog)> elsewhere_;
  States states_;
};

/// What dialogs of files share: where one looks, and the name that is being typed.
struct FileChoice {
  std::string folder;
  std::string name;
  std::string lost;      ///< what writing to `asked_of` would lose, which was said; empty: nothing was
  std::string asked_of;  ///< a path
};

}  // namespace penpose::app
