#include "ui/cli/tablet/no_rows.h"

#include <algorithm>

#include "firmware_io/decode/hand_factory.h"
#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::cli {
namespace {

/// A tablet of the table with an interface of these ids, whatever else is known of the interface.
const decode::Tablet* tablet_with_ids(const decode::DeviceIdentity& device) {
  const auto fits = [&](const decode::TabletIdentifier& identifier) {
    return identifier.vendor == device.vendor && identifier.product == device.product;
  };
  const auto tablets = decode::known_tablets().tablets();
  const auto found = std::find_if(tablets.begin(), tablets.end(), [&](const decode::Tablet& tablet) {
    return std::any_of(tablet.identifiers.begin(), tablet.identifiers.end(), fits) ||
           std::any_of(tablet.pads.begin(), tablet.pads.end(), fits);
  });
  return found == tablets.end() ? nullptr : &*found;
}

/// An interface that nothing knows.
base::Error why_unread(const RowlessReports& reports) {
  base::Error why = *reports.refusal;
  const bool is_named = reports.refused.vendor != 0 || reports.refused.product != 0;
  const decode::HandDecoders hand = decode::make_hand_decoders(reports.refused);
  const bool has_keys = hand.pad != nullptr && hand.pad->features().any();
  if (has_keys || hand.touch != nullptr) {
    why.what = std::string("this interface carries ") + (has_keys ? "keys" : "fingers") + " and no pen";
    why.remedy = std::string(has_keys ? "--pad" : "--touch") + " prints them";
  } else if (!is_named && reports.refused.report_descriptor.empty()) {
    why.what = "the recording does not say which tablet it is of";
    why.remedy =
        "name the tablet with --tablet NAME, or its reports with --protocol NAME; `penpose devices --known` lists both"
        "; a capture of USB begins before the tablet is plugged in";
  } else if (!is_named) {
    why.remedy =
        "name the tablet with --tablet NAME, which the recording does not; `penpose devices --known` lists them";
  } else if (const decode::Tablet* tablet = tablet_with_ids(reports.refused)) {
    why.what = "this interface of " + tablet->vendor + " " + tablet->name + " has no pen that is known";
    why.remedy = "record with `penpose record`, which wakes the tablet and reads all its interfaces";
  }
  if (reports.refusals > 1) why.what += " (nor has any other of " + std::to_string(reports.refusals) + " interfaces)";
  return why;
}

}  // namespace

std::string reports_in_words(std::uint64_t count) {
  return std::to_string(count) + (count == 1 ? " report" : " reports");
}

base::Error why_no_rows(const RowlessReports& reports) {
  if (reports.all == 0) {
    return {"no reports: it says which devices there are and ends", "", "record on while the pen is near the tablet"};
  }
  const std::string count = reports_in_words(reports.all);
  if (reports.desktop == reports.all) {
    return {count +
                ", none of a pen: this is the tablet's mouse mode (the form of a mouse or keyboard, before a driver "
                "wakes it)",
            "", "record with `penpose record`, which wakes it"};
  }
  if (reports.refusal && reports.desktop + reports.unread == reports.all) {
    base::Error why = why_unread(reports);
    why.what = count + ", none of a pen: " + why.what;
    return why;
  }
  return {count + ", none of a pen that is near", "", "--pad and --touch print keys and fingers"};
}

}  // namespace penpose::cli
