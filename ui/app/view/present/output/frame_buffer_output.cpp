#include "ui/app/view/present/output/frame_buffer_output.h"

#include <SDL2/SDL.h>
#include <cerrno>
#include <cstring>
#include <linux/fb.h>
#include <linux/kd.h>
#include <string>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <utility>

#include "ui/app/view/present/output/drm_objects.h"
#include "ui/app/view/present/output/px_copy.h"

namespace penpose::app {
namespace {

constexpr unsigned k_most_px = 16384;

/// The console in front, which draws nothing as long as this lives.
class SilentConsole {
 public:
  SilentConsole() : console_("/dev/tty0") {
    silent_ = console_ && ::ioctl(console_.number(), KDGETMODE, &before_) == 0 &&
              ::ioctl(console_.number(), KDSETMODE, KD_GRAPHICS) == 0;
  }
  ~SilentConsole() {
    if (silent_) ::ioctl(console_.number(), KDSETMODE, before_);
  }
  SilentConsole(const SilentConsole&) = delete;
  SilentConsole& operator=(const SilentConsole&) = delete;
  [[nodiscard]] bool silent() const { return silent_; }

 private:
  OpenDevice console_;
  int before_ = KD_TEXT;
  bool silent_ = false;
};

class FrameBufferOutput final : public PictureOutput {
 public:
  explicit FrameBufferOutput(std::string path) : path_(std::move(path)), device_(path_) {}
  ~FrameBufferOutput() override {
    if (memory_ == nullptr) return;
    // A console draws itself anew; where there is none nothing stays behind.
    if (!console_->silent()) std::memset(memory_, 0, length_);
    ::munmap(memory_, length_);
  }
  FrameBufferOutput(const FrameBufferOutput&) = delete;
  FrameBufferOutput& operator=(const FrameBufferOutput&) = delete;

  base::Status start() {
    if (!device_ && device_.reason() == ENOENT)
      return fault("there is no such screen", "connect a screen that Linux has a driver for");
    if (!device_) return fault(std::strerror(device_.reason()), "sudo usermod -aG video $USER, then log in again");
    fb_var_screeninfo shape{};
    fb_fix_screeninfo memory{};
    if (::ioctl(device_.number(), FBIOGET_VSCREENINFO, &shape) != 0 ||
        ::ioctl(device_.number(), FBIOGET_FSCREENINFO, &memory) != 0) {
      return fault(std::strerror(errno), "try another with --screen N");
    }
    const auto mask = [](const fb_bitfield& bits) {
      return bits.length == 0 || bits.length > 16 || bits.offset > 31 ? 0U : ((1U << bits.length) - 1U) << bits.offset;
    };
    format_ = SDL_MasksToPixelFormatEnum(static_cast<int>(shape.bits_per_pixel), mask(shape.red), mask(shape.green),
                                         mask(shape.blue), 0);
    const bool plain = memory.type == FB_TYPE_PACKED_PIXELS &&
                       (memory.visual == FB_VISUAL_TRUECOLOR || memory.visual == FB_VISUAL_DIRECTCOLOR);
    if (!plain || format_ == SDL_PIXELFORMAT_UNKNOWN || shape.bits_per_pixel < 15) {
      return fault("px of " + std::to_string(shape.bits_per_pixel) + " bits in this order are not drawn",
                   "set the screen to 16, 24 or 32 bits (fbset -depth 32)");
    }
    const std::uint64_t bytes_a_px = SDL_BYTESPERPIXEL(format_);
    const std::uint64_t begin = std::uint64_t{shape.yoffset} * memory.line_length + shape.xoffset * bytes_a_px;
    const bool fits =
        shape.xres > 0 && shape.yres > 0 && shape.xres <= k_most_px && shape.yres <= k_most_px &&
        shape.xres * bytes_a_px <= memory.line_length &&
        begin + std::uint64_t{shape.yres - 1} * memory.line_length + shape.xres * bytes_a_px <= memory.smem_len;
    if (!fits) return fault("its size does not fit its memory", "try another with --screen N");
    size_ = {static_cast<int>(shape.xres), static_cast<int>(shape.yres)};
    dpi_ = static_cast<int>(shape.width) > 0 ? dpi_of(shape.xres, shape.width) : 0;
    row_bytes_ = static_cast<int>(memory.line_length);
    begin_ = begin;
    void* const mapped = ::mmap(nullptr, memory.smem_len, PROT_READ | PROT_WRITE, MAP_SHARED, device_.number(), 0);
    if (mapped == MAP_FAILED) return fault(std::strerror(errno), "try another with --screen N");
    memory_ = static_cast<std::uint8_t*>(mapped);
    length_ = memory.smem_len;
    console_.emplace();
    return base::Done{};
  }

  [[nodiscard]] std::optional<geometry::Viewport> size() const override { return size_; }
  [[nodiscard]] double dpi() const override { return dpi_; }

  void show(const render::Image& picture, const std::vector<render::PxRect>& parts) override {
    const PxMemory there{memory_ + begin_, row_bytes_, format_, size_};
    if (!std::exchange(whole_, true)) {
      copy_px(picture, {0, 0, picture.width, picture.height}, there);
      return;
    }
    for (const render::PxRect& part : parts) copy_px(picture, part, there);
  }

 private:
  base::Error fault(std::string why, std::string remedy) const { return {std::move(why), path_, std::move(remedy)}; }

  std::string path_;
  OpenDevice device_;
  std::optional<SilentConsole> console_;
  geometry::Viewport size_;
  double dpi_ = 0;
  std::uint32_t format_ = 0;
  int row_bytes_ = 0;
  std::uint64_t begin_ = 0;
  std::uint8_t* memory_ = nullptr;
  std::size_t length_ = 0;
  bool whole_ = false;
};

}  // namespace

base::Result<std::unique_ptr<PictureOutput>> open_frame_buffer_output(int number) {
  auto output = std::make_unique<FrameBufferOutput>("/dev/fb" + std::to_string(number));
  if (const auto started = output->start(); !started) return started.error();
  return std::unique_ptr<PictureOutput>(std::move(output));
}

}  // namespace penpose::app
