#include "firmware_io/device/source/libusb_source.h"

#include <algorithm>
#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/device/clock.h"
#include "firmware_io/device/source/driver_guard.h"
#include "firmware_io/device/source/libusb/internal/usb_transfers.h"

namespace penpose::device {
namespace {

/// Transfers that wait at the device together, so that it never finds none while one is being looked at.
constexpr std::size_t k_transfers = 16;
constexpr int k_most_errors = 64;
constexpr unsigned k_output_timeout_ms = 500;

struct Endpoints {
  std::uint8_t in = 0;
  std::uint8_t out = 0;  ///< 0: output reports go through the control pipe
  std::size_t in_packet = 0;
};

std::optional<Endpoints> find_endpoints(const UsbHandle& usb, int interface) {
  libusb_config_descriptor* raw = nullptr;
  if (libusb_get_active_config_descriptor(libusb_get_device(usb.get()), &raw) != 0) return std::nullopt;
  const std::unique_ptr<libusb_config_descriptor, void (*)(libusb_config_descriptor*)> config(
      raw, libusb_free_config_descriptor);
  for (int i = 0; i < config->bNumInterfaces; ++i) {
    const libusb_interface& alternatives = config->interface[i];
    if (alternatives.num_altsetting < 1) continue;
    const libusb_interface_descriptor& found = alternatives.altsetting[0];
    if (found.bInterfaceNumber != interface) continue;
    Endpoints endpoints;
    for (int k = 0; k < found.bNumEndpoints; ++k) {
      const libusb_endpoint_descriptor& endpoint = found.endpoint[k];
      if ((endpoint.bmAttributes & 3) != LIBUSB_TRANSFER_TYPE_INTERRUPT) continue;
      const bool in = (endpoint.bEndpointAddress & LIBUSB_ENDPOINT_IN) != 0;
      if (in && endpoints.in == 0) {
        endpoints.in = endpoint.bEndpointAddress;
        endpoints.in_packet = endpoint.wMaxPacketSize & 0x7ffu;
      } else if (!in && endpoints.out == 0) {
        endpoints.out = endpoint.bEndpointAddress;
      }
    }
    if (endpoints.in != 0 && endpoints.in_packet != 0) return endpoints;
  }
  return std::nullopt;
}

class LibusbSource final : public ReportSource {
 public:
  LibusbSource(UsbHandle usb, int interface, Endpoints endpoints, std::unique_ptr<DriverGuard> guard)
      : usb_(std::move(usb)), interface_(interface), endpoints_(endpoints), guard_(std::move(guard)) {}
  ~LibusbSource() override;

  base::Status prepare(std::size_t longest_report);

  ReadOutcome read(std::span<std::uint8_t> into, int timeout_ms) override;
  base::Status send_feature(base::Bytes report) override {
    return set_report(usb_, interface_, SentReport::feature, report);
  }
  base::Status send_output(base::Bytes report) override;
  base::Result<std::vector<std::uint8_t>> get_feature(std::uint8_t id, std::size_t length) override {
    return get_feature_report(usb_, interface_, id, length);
  }
  base::Result<std::string> read_string(std::uint8_t index) override { return get_string(usb_, index); }

 private:
  struct Waiting {
    LibusbSource* owner = nullptr;
    libusb_transfer* transfer = nullptr;
    std::vector<std::uint8_t> buffer;
    bool submitted = false;
    std::int64_t time_us = 0;
  };

  static void LIBUSB_CALL complete(libusb_transfer* transfer);
  void submit(Waiting& waiting);
  void handle_events(int timeout_ms);

  UsbHandle usb_;
  int interface_;
  Endpoints endpoints_;
  std::unique_ptr<DriverGuard> guard_;
  std::array<Waiting, k_transfers> waiting_;
  std::deque<Waiting*> done_;  ///< completed and not read yet, oldest first
  int errors_ = 0;             ///< one after another
  bool started_ = false;
  bool failed_ = false;
  bool closing_ = false;
};

void LibusbSource::complete(libusb_transfer* transfer) {
  auto& waiting = *static_cast<Waiting*>(transfer->user_data);
  LibusbSource& owner = *waiting.owner;
  waiting.submitted = false;
  waiting.time_us = monotonic_us();
  if (owner.closing_) return;
  switch (transfer->status) {
    case LIBUSB_TRANSFER_COMPLETED:
    case LIBUSB_TRANSFER_OVERFLOW:
      owner.errors_ = 0;
      owner.done_.push_back(&waiting);
      break;
    case LIBUSB_TRANSFER_STALL:
      libusb_clear_halt(owner.usb_.get(), owner.endpoints_.in);
      owner.submit(waiting);
      break;
    case LIBUSB_TRANSFER_TIMED_OUT:
      owner.submit(waiting);
      break;
    case LIBUSB_TRANSFER_ERROR:
      // Noise on the cable; a device that was unplugged says so only after a few of these.
      if (++owner.errors_ < k_most_errors) {
        owner.submit(waiting);
      } else {
        owner.failed_ = true;
      }
      break;
    default:
      owner.failed_ = true;
      break;
  }
}

void LibusbSource::submit(Waiting& waiting) {
  if (libusb_submit_transfer(waiting.transfer) == 0) {
    waiting.submitted = true;
  } else {
    failed_ = true;
  }
}

void LibusbSource::handle_events(int timeout_ms) {
  timeval timeout{timeout_ms / 1000, (timeout_ms % 1000) * 1000};
  const int code = libusb_handle_events_timeout_completed(usb_.context(), &timeout, nullptr);
  if (code != 0 && code != LIBUSB_ERROR_INTERRUPTED && code != LIBUSB_ERROR_TIMEOUT) failed_ = true;
}

base::Status LibusbSource::prepare(std::size_t longest_report) {
  // A whole number of packets: a device that sends more than it said cannot overflow the transfer.
  const std::size_t packets =
      (std::max<std::size_t>(longest_report, 1) + endpoints_.in_packet - 1) / endpoints_.in_packet;
  const std::size_t length = std::min(packets * endpoints_.in_packet, k_longest_report);
  for (Waiting& waiting : waiting_) {
    waiting.owner = this;
    waiting.buffer.resize(length);
    waiting.transfer = libusb_alloc_transfer(0);
    if (waiting.transfer == nullptr) return base::Error{"no memory for transfers", "", ""};
    libusb_fill_interrupt_transfer(waiting.transfer, usb_.get(), endpoints_.in, waiting.buffer.data(),
                                   static_cast<int>(length), complete, &waiting, 0);
  }
  return base::Done{};
}

LibusbSource::~LibusbSource() {
  closing_ = true;
  for (Waiting& waiting : waiting_) {
    if (waiting.submitted) libusb_cancel_transfer(waiting.transfer);
  }
  const auto pending = [this] {
    return std::any_of(waiting_.begin(), waiting_.end(), [](const Waiting& waiting) { return waiting.submitted; });
  };
  for (int i = 0; i < 100 && pending(); ++i) handle_events(10);
  // A transfer that the system still holds must keep its memory: better lost than written to later.
  for (Waiting& waiting : waiting_) {
    if (waiting.transfer != nullptr && !waiting.submitted) libusb_free_transfer(waiting.transfer);
  }
  // Auto-detach binds the kernel's driver again; then the guard has nothing left to do.
  libusb_release_interface(usb_.get(), interface_);
}

ReadOutcome LibusbSource::read(std::span<std::uint8_t> into, int timeout_ms) {
  // Not before: a tablet is woken before anything is asked of its pen, as the kernel's drivers do; some rely on it.
  if (!started_) {
    started_ = true;
    for (Waiting& waiting : waiting_) submit(waiting);
  }
  if (done_.empty() && !failed_) handle_events(timeout_ms);
  while (!done_.empty()) {
    Waiting& waiting = *done_.front();
    done_.pop_front();
    const std::size_t length = std::min(static_cast<std::size_t>(std::max(waiting.transfer->actual_length, 0)),
                                        std::min(into.size(), waiting.buffer.size()));
    std::copy_n(waiting.buffer.begin(), length, into.begin());
    const std::int64_t time_us = waiting.time_us;
    if (!failed_) submit(waiting);
    if (length > 0) return {ReadState::report, length, time_us};
  }
  if (failed_) return {ReadState::gone, 0, monotonic_us()};
  return {};
}

base::Status LibusbSource::send_output(base::Bytes report) {
  if (endpoints_.out == 0) return set_report(usb_, interface_, SentReport::output, report);
  if (report.empty()) return base::Error{"the report is empty", "", ""};
  std::vector<std::uint8_t> bytes(report.begin() + (report[0] == 0 ? 1 : 0), report.end());
  int sent = 0;
  const int code = libusb_interrupt_transfer(usb_.get(), endpoints_.out, bytes.data(), static_cast<int>(bytes.size()),
                                             &sent, k_output_timeout_ms);
  if (code != 0) return usb_error("the device took no report", code);
  return base::Done{};
}

}  // namespace

base::Result<std::unique_ptr<ReportSource>> open_libusb(HidInterface& interface) {
  const int number = interface.identity.interface_number.value_or(0);
  auto usb = UsbHandle::open(interface.usb_node);
  if (!usb) return usb.error();
  const auto endpoints = find_endpoints(*usb, number);
  if (!endpoints) return base::Error{"has no endpoint that gives reports", interface.usb_name, ""};
  std::unique_ptr<DriverGuard> guard;
  if (libusb_kernel_driver_active(usb->get(), number) == 1) {
    auto started = DriverGuard::start(interface.usb_node, number);
    if (!started) return started.error();
    guard = std::move(started).value();
  }
  libusb_set_auto_detach_kernel_driver(usb->get(), 1);
  if (const int code = libusb_claim_interface(usb->get(), number); code != 0) {
    auto error = usb_error("cannot be taken over", code);
    if (code == LIBUSB_ERROR_BUSY) error.remedy = "close the other program that reads this tablet";
    return error;
  }
  decode::DeviceIdentity& identity = interface.identity;
  if (identity.report_descriptor.empty()) {
    if (auto descriptor = get_report_descriptor(*usb, number)) identity.report_descriptor = std::move(*descriptor);
    decode::complete_identity(identity);
  }
  auto source = std::make_unique<LibusbSource>(std::move(usb).value(), number, *endpoints, std::move(guard));
  if (const auto prepared = source->prepare(interface.identity.input_report_length.value_or(64)); !prepared) {
    return prepared.error();
  }
  return std::unique_ptr<ReportSource>(std::move(source));
}

}  // namespace penpose::device
