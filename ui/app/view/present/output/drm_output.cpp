#include "ui/app/view/present/output/drm_output.h"

#include <SDL2/SDL.h>
#include <algorithm>
#include <array>
#include <cstring>
#include <poll.h>
#include <sys/mman.h>
#include <utility>
#include <xf86drm.h>

#include "ui/app/view/present/output/drm_objects.h"
#include "ui/app/view/present/output/px_copy.h"

namespace penpose::app {
namespace {

/// A screen answers a flip within one picture of its own, at the latest so soon.
constexpr int k_flip_ms = 100;

/// Memory of a card that it can show, which a program writes ("dumb buffer").
class ShownMemory {
 public:
  explicit ShownMemory(int card) : card_(card) {}
  ~ShownMemory() {
    if (px_ != nullptr) ::munmap(px_, length_);
    if (frame_ != 0) drmModeRmFB(card_, frame_);
    if (handle_ != 0) drmModeDestroyDumbBuffer(card_, handle_);
  }
  ShownMemory(const ShownMemory&) = delete;
  ShownMemory& operator=(const ShownMemory&) = delete;

  /// Of 32 bits a px, or of 16 where the card shows no others.
  bool make(geometry::Viewport size) { return make(size, 32, 24) || make(size, 16, 16); }
  [[nodiscard]] std::uint32_t frame() const { return frame_; }
  [[nodiscard]] PxMemory memory() const {
    return {px_, row_bytes_, bits_ == 32 ? Uint32{SDL_PIXELFORMAT_RGB888} : Uint32{SDL_PIXELFORMAT_RGB565}, size_};
  }

 private:
  bool make(geometry::Viewport size, std::uint32_t bits, std::uint8_t depth) {
    std::uint32_t row_bytes = 0;
    std::uint64_t length = 0;
    std::uint64_t offset = 0;
    if (drmModeCreateDumbBuffer(card_, static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height),
                                bits, 0, &handle_, &row_bytes, &length) != 0) {
      return false;
    }
    void* px = MAP_FAILED;
    if (drmModeAddFB(card_, static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height), depth,
                     static_cast<std::uint8_t>(bits), row_bytes, handle_, &frame_) == 0 &&
        drmModeMapDumbBuffer(card_, handle_, &offset) == 0) {
      px = ::mmap(nullptr, length, PROT_READ | PROT_WRITE, MAP_SHARED, card_, static_cast<off_t>(offset));
    }
    if (px == MAP_FAILED) {
      if (frame_ != 0) drmModeRmFB(card_, std::exchange(frame_, 0));
      drmModeDestroyDumbBuffer(card_, std::exchange(handle_, 0));
      return false;
    }
    px_ = static_cast<std::uint8_t*>(px);
    length_ = length;
    row_bytes_ = static_cast<int>(row_bytes);
    bits_ = bits;
    size_ = size;
    std::memset(px_, 0, length_);
    return true;
  }

  int card_;
  std::uint32_t handle_ = 0;
  std::uint32_t frame_ = 0;
  std::uint8_t* px_ = nullptr;
  std::size_t length_ = 0;
  int row_bytes_ = 0;
  std::uint32_t bits_ = 32;
  geometry::Viewport size_;
};

/// What drives a connector: what drives it now, else the first free one that can. 0: none.
std::uint32_t crtc_of(int card, const drmModeRes& resources, const drmModeConnector& connector) {
  if (const DrmEncoder now(drmModeGetEncoder(card, connector.encoder_id)); now && now->crtc_id != 0)
    return now->crtc_id;
  std::vector<std::uint32_t> taken;
  for (int i = 0; i < resources.count_encoders; ++i) {
    if (const DrmEncoder other(drmModeGetEncoder(card, resources.encoders[i])); other) taken.push_back(other->crtc_id);
  }
  for (int i = 0; i < connector.count_encoders; ++i) {
    const DrmEncoder encoder(drmModeGetEncoder(card, connector.encoders[i]));
    for (int c = 0; encoder && c < std::min(resources.count_crtcs, 32); ++c) {
      const bool can = (encoder->possible_crtcs >> static_cast<unsigned>(c) & 1U) != 0;
      if (can && std::find(taken.begin(), taken.end(), resources.crtcs[c]) == taken.end()) return resources.crtcs[c];
    }
  }
  return 0;
}

class DrmOutput final : public PictureOutput {
 public:
  explicit DrmOutput(const DrmScreen& screen)
      : screen_(screen),
        device_(screen.device()),
        buffers_{ShownMemory(device_.number()), ShownMemory(device_.number())} {}
  ~DrmOutput() override {
    wait_for_flip();
    if (before_ && shows_) {
      drmModeSetCrtc(device_.number(), before_->crtc_id, before_->buffer_id, before_->x, before_->y, &screen_.connector,
                     1, before_->mode_valid != 0 ? &before_->mode : nullptr);
    }
  }
  DrmOutput(const DrmOutput&) = delete;
  DrmOutput& operator=(const DrmOutput&) = delete;

  base::Status start(bool slow) {
    const int card = device_.number();
    if (!device_) return fault(std::strerror(device_.reason()), "sudo usermod -aG video $USER, then log in again");
    const DrmResources resources(drmModeGetResources(card));
    const DrmConnector connector(drmModeGetConnector(card, screen_.connector));
    if (!resources || !connector || connector->count_modes == 0) return fault("the screen is gone", "connect it");
    const std::uint32_t crtc = crtc_of(card, *resources, *connector);
    before_.reset(drmModeGetCrtc(card, crtc));
    if (!before_) return fault("nothing of the card is free to drive this screen", "choose another with --screen N");
    drmModeModeInfo mode = best_mode(*connector);
    size_ = {mode.hdisplay, mode.vdisplay};
    if (!buffers_[0].make(size_)) return fault("the card has no memory that a program can write", "try --screen N");
    drmSetMaster(card);
    if (drmModeSetCrtc(card, crtc, buffers_[0].frame(), 0, 0, &screen_.connector, 1, &mode) != 0) {
      return fault(std::string("the screen cannot be taken (") + std::strerror(errno) + ")",
                   "end the desktop or other program that shows on it, or run on the console in front");
    }
    shows_ = true;
    flips_ = !slow && buffers_[1].make(size_);
    return base::Done{};
  }

  [[nodiscard]] std::optional<geometry::Viewport> size() const override { return size_; }
  [[nodiscard]] double dpi() const override { return screen_.dpi; }

  void show(const render::Image& picture, const std::vector<render::PxRect>& parts) override {
    if (flips_) {
      const ShownMemory& next = buffers_[1 - front_];
      copy_px(picture, {0, 0, picture.width, picture.height}, next.memory());
      if (drmModePageFlip(device_.number(), before_->crtc_id, next.frame(), DRM_MODE_PAGE_FLIP_EVENT, this) == 0) {
        front_ = 1 - front_;
        flipping_ = true;
        wait_for_flip();
        return;
      }
      // Another console is in front: it comes back with the next picture.
      if (errno == EACCES || errno == EBUSY) return;
      flips_ = false;
    }
    show_parts(picture, parts);
  }

 private:
  base::Error fault(std::string why, std::string remedy) const {
    return {std::move(why), screen_.device(), std::move(remedy)};
  }

  /// Into what is seen already.
  void show_parts(const render::Image& picture, const std::vector<render::PxRect>& parts) {
    std::vector<drmModeClip> clips;
    for (const render::PxRect& part :
         std::exchange(whole_, true) ? parts : std::vector{render::PxRect{0, 0, picture.width, picture.height}}) {
      const render::PxRect put = copy_px(picture, part, buffers_[front_].memory());
      const auto of = [](int px) { return static_cast<std::uint16_t>(px); };
      if (!put.empty()) clips.push_back({of(put.left), of(put.top), of(put.right), of(put.bottom)});
    }
    // Cards that show their memory as it is need not be told.
    if (!clips.empty())
      drmModeDirtyFB(device_.number(), buffers_[front_].frame(), clips.data(),
                     static_cast<std::uint32_t>(clips.size()));
  }

  void wait_for_flip() {
    drmEventContext events{};
    events.version = 2;
    events.page_flip_handler = [](int, unsigned, unsigned, unsigned, void* self) {
      static_cast<DrmOutput*>(self)->flipping_ = false;
    };
    while (flipping_) {
      pollfd waits{device_.number(), POLLIN, 0};
      const int ready = ::poll(&waits, 1, k_flip_ms);
      if (ready < 0 && errno == EINTR) continue;
      if (ready <= 0 || drmHandleEvent(device_.number(), &events) != 0) flipping_ = false;
    }
  }

  DrmScreen screen_;
  OpenDevice device_;
  std::array<ShownMemory, 2> buffers_;
  DrmCrtc before_;  ///< what was on the screen
  geometry::Viewport size_;
  std::size_t front_ = 0;  ///< the buffer that is seen
  bool shows_ = false;
  bool flips_ = false;
  bool flipping_ = false;
  bool whole_ = false;  ///< the buffer in front holds a picture
};

}  // namespace

base::Result<std::unique_ptr<PictureOutput>> open_drm_output(const DrmScreen& screen, bool slow) {
  auto output = std::make_unique<DrmOutput>(screen);
  if (const auto started = output->start(slow); !started) return started.error();
  return std::unique_ptr<PictureOutput>(std::move(output));
}

}  // namespace penpose::app
