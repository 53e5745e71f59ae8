#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/placement.h"
#include "core/io/project/cast_file.h"
#include "ui/app/canvas/canvas.h"
#include "ui/app/files/recording.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/view/posed_surface.h"

namespace penpose::app {

/// A character that is open. While it is worked on, its document is in the EditingSession, its file in the Recording
/// and its surface on the Canvas.
struct Character {
  std::string name;
  geometry::Placement placement;  ///< in the scene
  bool shown = true;
  std::string path;           ///< what it was opened from (files::ModelName)
  Recording::Aside recorded;  ///< outlives the session, which writes to it
  SessionAside session;
  PosedSurface surface;
  std::optional<double> posed_at_s;  ///< the moment that `surface` shows
};

/// The characters that are open: one is worked on, the others are drawn beside it as they are at the same moment of the
/// timeline. The view, and with it all that is drawn, is in the space of the one that is worked on.
class Cast {
 public:
  Cast(EditingSession& editing, Recording& recording, Canvas& canvas)
      : editing_(editing), recording_(recording), canvas_(canvas) {
    members_.push_back(std::make_unique<Character>());
  }
  ~Cast() { end_others(); }
  Cast(const Cast&) = delete;
  Cast& operator=(const Cast&) = delete;

  [[nodiscard]] std::size_t size() const { return members_.size(); }
  [[nodiscard]] bool several() const { return members_.size() > 1; }
  /// The one that is worked on.
  [[nodiscard]] std::size_t active() const { return active_; }
  [[nodiscard]] const Character& at(std::size_t character) const { return *members_[character]; }
  [[nodiscard]] const document::Document& document(std::size_t character) const;
  /// Where another one stands, seen from the one that is worked on.
  [[nodiscard]] geometry::Placement beside(std::size_t character) const;
  /// Its box as it stands in the scene, at rest.
  [[nodiscard]] geometry::Box box(std::size_t character) const;
  /// The one of a name; nothing: there is none.
  [[nodiscard]] std::optional<std::size_t> find(const std::string& name) const;

  // Who is worked on. The callers tell everybody else (Files).
  /// One document was opened, and all others are closed.
  void begin(const std::string& path);
  /// Puts what is worked on aside: something else must be opened or taken up next.
  void set_aside();
  /// What was just opened after `set_aside` is one more character. `like`: its name and place; null: by its file, in
  /// the middle.
  void add(const std::string& path, const io::CastMember* like = nullptr);
  /// Goes on with one that was set aside, in the same view of the scene.
  void take_up(std::size_t character);
  /// Asks for another one, for when the frame begins and nothing is in hand.
  void ask_for(std::size_t character) { asked_ = character; }
  [[nodiscard]] std::optional<std::size_t> take_asked() { return std::exchange(asked_, std::nullopt); }
  /// Takes away one that is not worked on; the last one can come back.
  void remove(std::size_t character);
  [[nodiscard]] bool can_bring_back() const { return removed_ != nullptr; }
  void bring_back();
  /// Ends the sessions of all that are not worked on.
  void end_others();

  // How they stand.
  /// Gives one the name and the place of a member of a project.
  void describe(std::size_t character, const io::CastMember& like);
  /// Looks at all that are shown, from where one looks.
  void frame_all();
  /// Looks at the face of the one that is worked on, from its front.
  void frame_active() { canvas_.begin(); }
  void rename(std::size_t character, const std::string& name);
  void show(std::size_t character, bool shown);
  void place(std::size_t character, const geometry::Placement& placement);
  /// Puts one beside all others, to the right as they are seen from the front, so that boxes do not touch: on their
  /// ground, looking where the first one looks; where its face is much larger or smaller than the first one's, as
  /// large.
  void place_beside(std::size_t character);

  /// Takes the character at a place of the view in hand, else the one that is worked on.
  void take_in_hand(PxPoint at);
  /// Moves it along with the pen, in the plane of the picture.
  void drag_to(PxPoint at);

  /// The others take their pose of a moment of the timeline. `plays`: it runs. Call it once a frame.
  void follow(double time_s, bool plays);
  /// The others are to look as if they were farther away: one draws.
  [[nodiscard]] bool recedes() const { return recedes_; }
  /// When the last key of the others is, s; 0: they have none.
  [[nodiscard]] double last_key_s() const;
  /// The other character that is seen at a place of the view, before the one that is worked on; nothing: none.
  [[nodiscard]] std::optional<std::size_t> touched(PxPoint at);

  // What is saved.
  /// Something of a character that is not worked on, or of how they stand, was changed since `mark_saved`.
  [[nodiscard]] bool unsaved() const;
  void mark_saved();
  /// Who they are and how they stand, without files.
  [[nodiscard]] io::Cast described() const;
  [[nodiscard]] std::vector<const document::Document*> documents() const;
  /// One that is not worked on, to be changed.
  [[nodiscard]] Character& aside(std::size_t character) { return *members_[character]; }
  /// Keeps beside the session of every other one where the work is saved.
  void note_project(const std::string& project);
  /// Grows with every change of who they are and how they stand.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  [[nodiscard]] std::string free_name(const std::string& wanted) const;
  void end(Character& character);
  void changed();

  EditingSession& editing_;
  Recording& recording_;
  Canvas& canvas_;
  std::vector<std::unique_ptr<Character>> members_;
  std::size_t active_ = 0;
  std::unique_ptr<Character> removed_;
  std::optional<std::size_t> asked_;
  std::size_t in_hand_ = 0;
  PxPoint hand_at_;
  double hand_units_ = 0;  ///< of the scene, a px
  std::uint64_t revision_ = 0;
  bool moved_ = false;  ///< since it was saved
  bool recedes_ = true;
};

/// What a character is called by the name of its file.
[[nodiscard]] std::string character_name(const std::string& path);

}  // namespace penpose::app
