#include "ui/app/window/sdl_sound.h"

#include <SDL.h>
#include <string>

namespace penpose::app {
namespace {

/// Samples that the device takes at once: 11 ms at 48 kHz, a quarter of a frame.
constexpr int k_device_samples = 512;

class SdlSound final : public SoundOutput {
 public:
  ~SdlSound() override { end(); }

  base::Status open(int rate_hz) override {
    end();
    if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) return no_device();
    begun_ = true;
    SDL_AudioSpec wanted{};
    wanted.freq = rate_hz;
    wanted.format = AUDIO_F32SYS;
    wanted.channels = 1;
    wanted.samples = k_device_samples;
    SDL_AudioSpec given{};
    // SDL turns the rate and the form into those of the device.
    device_ = SDL_OpenAudioDevice(nullptr, 0, &wanted, &given, 0);
    if (device_ == 0) return no_device();
    underway_ = given.samples;
    SDL_PauseAudioDevice(device_, 0);
    return base::Done{};
  }
  void close() override { end(); }
  void push(std::span<const float> samples) override {
    SDL_QueueAudio(device_, samples.data(), static_cast<Uint32>(samples.size_bytes()));
  }
  void clear() override { SDL_ClearQueuedAudio(device_); }
  [[nodiscard]] std::size_t waiting() const override { return SDL_GetQueuedAudioSize(device_) / sizeof(float); }
  [[nodiscard]] std::size_t underway() const override { return underway_; }

 private:
  static base::Error no_device() {
    return {"there is no sound device (SDL: " + std::string(SDL_GetError()) + ")", "", "the timeline plays in silence"};
  }
  void end() {
    if (device_ != 0) SDL_CloseAudioDevice(device_);
    if (begun_) SDL_QuitSubSystem(SDL_INIT_AUDIO);
    device_ = 0;
    begun_ = false;
  }

  SDL_AudioDeviceID device_ = 0;
  bool begun_ = false;
  std::size_t underway_ = 0;
};

}  // namespace

std::unique_ptr<SoundOutput> make_sdl_sound() { return std::make_unique<SdlSound>(); }

}  // namespace penpose::app
