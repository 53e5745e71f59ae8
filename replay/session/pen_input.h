#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/members.h"
#include "core/curve/stroke.h"
#include "core/document/drawing/pose_curve.h"
#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/hand/pen_mapping.h"
#include "firmware_io/decode/sample/pen_events.h"

namespace penpose::replay {

/// How a tablet's area stands for the picture. The picture's size is that of the view.
struct TabletSetting {
  bool keep_aspect = false;
  bool left_handed = false;
  std::uint32_t quarter_turns = 0;
  std::vector<double> area;              ///< left, top, right, bottom in fractions; empty: all of the tablet
  std::vector<curve::PxPoint> pressure;  ///< points (pressed, meant) of the pressure curve; empty: straight
  std::uint32_t drawing_buttons = 0;     ///< of the pen: while only these are held it draws
  static auto members(auto& self) {
    return base::named("keep_aspect", self.keep_aspect, "left_handed", self.left_handed, "quarter_turns",
                       self.quarter_turns, "area", self.area, "pressure", self.pressure, "drawing_buttons",
                       self.drawing_buttons);
  }
  friend bool operator==(const TabletSetting&, const TabletSetting&) = default;
};

/// A moment of the pen on the picture.
struct PenMoment {
  decode::PenEventKind kind = decode::PenEventKind::hover;
  curve::PxPoint position;
  double pressure = 0;  ///< 0..1
  bool eraser = false;
  std::uint8_t button = 0;    ///< of button_down and button_up
  std::uint32_t buttons = 0;  ///< held at the moment
  std::int64_t time_us = 0;
  std::int32_t rotation = 0;  ///< of the pen about itself, and of its own wheel, in the device's units
  std::int32_t wheel = 0;
};

/// A stroke with the view under which it began.
struct DrawnStroke {
  curve::Stroke samples;
  document::View view;
  bool eraser = false;
  bool on_canvas = true;  ///< false: it began on a panel, or with a button of the pen held, and draws nothing
};

/// Raw reports of any number of tablets to moments and strokes on the picture. A tablet that cannot be decoded gives
/// nothing. Every tablet has its own pen; strokes of two pens do not mix.
class PenInput {
 public:
  /// `own` (may be null) are the user's tablets; it must outlive this.
  explicit PenInput(const decode::TabletTable* own = nullptr) : own_(own) {}

  /// A tablet came, or came again under its number.
  void connect(int device, const decode::DeviceIdentity& identity);
  /// It went; its stroke ends.
  std::span<const PenMoment> disconnect(int device, std::int64_t time_us);
  /// A stroke that goes on keeps the setting under which it began. Errors: an area outside of the tablet, a pressure
  /// curve that falls.
  base::Status set_tablet(int device, const TabletSetting& setting);
  /// Where strokes that begin from now on are drawn; one that goes on stays in its view.
  void set_view(const document::View& view);
  /// Whether strokes that begin from now on draw, or belong to a panel.
  void set_on_canvas(bool on_canvas) { on_canvas_ = on_canvas; }
  [[nodiscard]] bool on_canvas() const { return on_canvas_; }

  /// One report. What is returned is valid until the next call; a completed stroke is in `take_stroke`.
  std::span<const PenMoment> report(int device, std::int64_t time_us, base::Bytes bytes);

  /// Strokes that were completed since the last call, in order.
  [[nodiscard]] std::vector<DrawnStroke> take_strokes() { return std::exchange(completed_, {}); }
  /// The stroke that a pen is drawing now, null when none does.
  [[nodiscard]] const DrawnStroke* current() const;
  [[nodiscard]] bool draws(int device) const;
  /// The devices that are in the middle of a stroke.
  [[nodiscard]] std::vector<int> drawing() const;
  [[nodiscard]] bool decodes(int device) const;
  /// What a device's pen says; null where it cannot be decoded.
  [[nodiscard]] const decode::PenAxes* axes_of(int device) const;
  /// How the device is recognised; empty when it cannot be decoded.
  [[nodiscard]] std::string method_of(int device) const;
  /// Where samples came from a tablet that nothing tells from others with its ids: what they were read as
  /// (decode::Recognition::guess). Empty otherwise.
  [[nodiscard]] std::string guess_of(int device) const;
  /// Those of all tablets.
  [[nodiscard]] std::vector<std::string> guesses() const;

 private:
  struct Tablet {
    std::unique_ptr<decode::PenDecoder> decoder;  ///< null: cannot be decoded
    std::string method;
    std::string guess;
    bool by_table = false;   ///< the mapping is for the ranges of its table
    bool was_guess = false;  ///< samples were read by its table
    decode::PenEvents events{decode::ContactRule{}};
    TabletSetting setting;
    std::optional<decode::PenMapping> mapping;
    std::optional<decode::PenMapping> stroke_mapping;  ///< of the stroke that goes on, whatever changes meanwhile
    std::optional<DrawnStroke> stroke;
  };

  void map_anew(Tablet& tablet) const;
  void take_events(Tablet& tablet);

  const decode::TabletTable* own_;
  std::map<int, Tablet> tablets_;
  document::View view_;
  bool on_canvas_ = true;
  std::vector<decode::PenEvent> events_;
  std::vector<PenMoment> moments_;
  std::vector<DrawnStroke> completed_;
};

}  // namespace penpose::replay
