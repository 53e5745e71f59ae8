#include "firmware_io/decode/layout/vendor_touch_decoder.h"

#include <algorithm>

namespace penpose::decode {
namespace {

/// Of Wacom's messages of eight bytes.
constexpr std::size_t k_message_slots = 16;
constexpr std::int32_t k_message_maximum = 4095;

TouchAxes touch_axes(const Protocol& protocol, const Tablet* tablet) {
  TouchAxes axes;
  for (const Protocol::Rule& rule : protocol.rules) {
    const Layout& layout = *rule.layout;
    if (layout.gives == Gives::touch_pad) axes.contacts = std::max(axes.contacts, unsigned{k_message_slots});
    if (layout.contacts) {
      const auto slots = static_cast<unsigned>(layout.contacts->last_id - layout.contacts->first_id + 1);
      axes.contacts = std::max(axes.contacts, slots);
    }
  }
  axes.x = axes.y = {0, k_message_maximum, 0, true};
  if (tablet == nullptr || !tablet->touch) return axes;
  const TabletTouch& touch = *tablet->touch;
  axes.x = {0, touch.max_x, touch.width_mm > 0 ? touch.max_x / touch.width_mm : 0, true};
  axes.y = {0, touch.max_y, touch.height_mm > 0 ? touch.max_y / touch.height_mm : 0, true};
  return axes;
}

}  // namespace

bool has_touch(const Protocol& protocol) {
  return std::any_of(protocol.rules.begin(), protocol.rules.end(), [](const Protocol::Rule& rule) {
    return rule.layout->gives == Gives::touch_pad || rule.layout->contacts;
  });
}

VendorTouchDecoder::VendorTouchDecoder(std::shared_ptr<const Protocol> protocol, const Tablet* tablet)
    : TouchDecoder(touch_axes(*protocol, tablet)), protocol_(std::move(protocol)) {}

bool VendorTouchDecoder::decode(base::Bytes report) {
  if (report.size() < protocol_->skip) return false;
  report = report.subspan(protocol_->skip);
  if (report.size() < protocol_->shortest) return false;
  for (const Protocol::Rule& rule : protocol_->rules) {
    if (!rule.when.holds(report)) continue;
    const Layout& layout = *rule.layout;
    if (report.size() < layout.shortest) return false;
    if (layout.gives == Gives::touch_pad) return decode_messages(report);
    return layout.gives == Gives::touch && layout.contacts && decode_contacts(*layout.contacts, report);
  }
  return false;
}

void VendorTouchDecoder::show(std::size_t slot, bool down, std::int32_t x, std::int32_t y) {
  if (slot >= slots_.size()) return;
  slots_.set(slot, down);
  if (down) slots_.move(slot, x, y);
}

bool VendorTouchDecoder::decode_contacts(const ContactList& list, base::Bytes report) {
  for (std::size_t i = 0, at = list.from; i < list.most && at + list.size <= report.size(); ++i, at += list.size) {
    const base::Bytes entry = report.subspan(at, list.size);
    const std::int64_t id = list.id.read_or(entry, -1);
    if (id < list.first_id || id > list.last_id) continue;
    show(static_cast<std::size_t>(id - list.first_id), list.down.holds(entry),
         static_cast<std::int32_t>(list.x.read_or(entry, 0)), static_cast<std::int32_t>(list.y.read_or(entry, 0)));
  }
  slots_.end_frame();
  slots_.publish();
  return true;
}

/// Messages of eight bytes behind their number. One of 81 says by a mask which fingers are still there.
bool VendorTouchDecoder::decode_messages(base::Bytes report) {
  constexpr std::size_t k_entry = 8;
  constexpr std::uint8_t k_mask = 0x81;
  constexpr std::uint8_t k_lifted = 0x20;
  constexpr std::uint8_t k_first_id = 2;
  if (report.size() < 5) return false;
  if (report[2] == k_mask) {
    const unsigned present = report[3] | static_cast<unsigned>(report[4]) << 8;
    for (std::size_t i = 0; i < std::min(k_message_slots, slots_.size()); ++i) {
      if ((present >> i & 1) == 0) slots_.set(i, false);
    }
  }
  const std::size_t count = report[2] == k_mask ? 0 : report[1];
  for (std::size_t i = 0, at = 2; i < count && at + k_entry <= report.size(); ++i, at += k_entry) {
    const base::Bytes one = report.subspan(at, k_entry);
    if (one[0] < k_first_id || one[0] >= k_first_id + k_message_slots) continue;
    show(one[0] - std::size_t{k_first_id}, one[1] != k_lifted, one[2] << 4 | one[4] >> 4,
         one[3] << 4 | (one[4] & 0x0f));
  }
  slots_.end_frame();
  slots_.publish();
  return true;
}

}  // namespace penpose::decode
