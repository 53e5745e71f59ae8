#include "core/sound/read/read_sound.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <sndfile.h>

#include "tests/support/sound_files.h"

namespace penpose::sound {
namespace {

using tests::WavForm;

struct Written {
  std::vector<std::uint8_t> bytes;
  sf_count_t at = 0;
};

/// A file in one of libsndfile's formats.
std::vector<std::uint8_t> file_of(const std::vector<float>& samples, int rate_hz, int format) {
  Written written;
  SF_VIRTUAL_IO calls{};
  calls.get_filelen = [](void* f) { return static_cast<sf_count_t>(static_cast<Written*>(f)->bytes.size()); };
  calls.seek = [](sf_count_t offset, int whence, void* f) {
    auto& to = *static_cast<Written*>(f);
    to.at = offset + (whence == SF_SEEK_CUR   ? to.at
                      : whence == SF_SEEK_END ? static_cast<sf_count_t>(to.bytes.size())
                                              : 0);
    return to.at;
  };
  calls.read = [](void*, sf_count_t, void*) { return sf_count_t{0}; };
  calls.write = [](const void* from, sf_count_t count, void* f) {
    auto& to = *static_cast<Written*>(f);
    to.bytes.resize(std::max(to.bytes.size(), static_cast<std::size_t>(to.at + count)));
    std::copy_n(static_cast<const std::uint8_t*>(from), count, to.bytes.begin() + to.at);
    to.at += count;
    return count;
  };
  calls.tell = [](void* f) { return static_cast<Written*>(f)->at; };
  SF_INFO info{};
  info.samplerate = rate_hz;
  info.channels = 1;
  info.format = format;
  SNDFILE* file = sf_open_virtual(&calls, SFM_WRITE, &info, &written);
  EXPECT_NE(file, nullptr) << sf_strerror(nullptr);
  sf_writef_float(file, samples.data(), static_cast<sf_count_t>(samples.size()));
  sf_close(file);
  return written.bytes;
}

double mean_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) sum += std::abs(a[i] - b[i]);
  return sum / static_cast<double>(std::min(a.size(), b.size()));
}

TEST(ReadSound, WavFlacAndOggAreTheSameTone) {
  const auto expected = tests::tone(440, 44100, 1);
  const struct {
    std::vector<std::uint8_t> bytes;
    double most;
  } files[] = {{tests::wav_bytes(expected, 44100), 1e-4},
               {tests::wav_bytes(expected, 44100, 1, WavForm::float32), 0},
               {file_of(expected, 44100, SF_FORMAT_FLAC | SF_FORMAT_PCM_16), 1e-4},
               {file_of(expected, 44100, SF_FORMAT_OGG | SF_FORMAT_VORBIS), 0.01}};
  for (const auto& file : files) {
    EXPECT_TRUE(looks_like_sound(file.bytes));
    const auto sound = read_sound(file.bytes);
    ASSERT_TRUE(sound) << sound.error().line();
    EXPECT_EQ(sound->rate_hz, 44100);
    EXPECT_EQ(sound->samples.size(), expected.size());
    EXPECT_NEAR(sound->duration_s(), 1, 1e-9);
    EXPECT_LE(mean_difference(sound->samples, expected), file.most);
  }
}

TEST(ReadSound, ChannelsAreJoinedToTheirMean) {
  const auto sound = read_sound(tests::wav_bytes({0.5F, 0.25F, -1.0F, 1.0F}, 48000, 2, WavForm::float32));
  ASSERT_TRUE(sound);
  EXPECT_EQ(sound->samples, (std::vector<float>{0.375F, 0.0F}));
}

TEST(ReadSound, SamplesAreFiniteAndWithinOne) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const auto sound = read_sound(tests::wav_bytes({nan, infinity, -infinity, 1e30F, 0.5F}, 8000, 1, WavForm::float32));
  ASSERT_TRUE(sound);
  EXPECT_EQ(sound->samples, (std::vector<float>{0, 1, -1, 1, 0.5F}));
}

TEST(ReadSound, AHeaderThatPromisesMoreIsNotBelieved) {
  auto bytes = tests::wav_bytes(tests::tone(440, 8000, 0.1), 8000);
  for (const std::size_t at : {4, 40}) std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), 4, 0xff);
  const auto sound = read_sound(bytes);
  ASSERT_TRUE(sound) << sound.error().line();
  EXPECT_EQ(sound->samples.size(), 800U);
  const auto cut = tests::wav_bytes(tests::tone(440, 8000, 0.1), 8000);
  const auto half = read_sound(base::Bytes(cut).subspan(0, cut.size() / 2));
  ASSERT_TRUE(half) << half.error().line();
  EXPECT_LT(half->samples.size(), 800U);
}

TEST(ReadSound, WhatIsNoSoundIsSaidInOneLine) {
  const std::vector<std::uint8_t> nothing;
  const std::vector<std::uint8_t> text{'h', 'e', 'l', 'l', 'o'};
  const std::vector<std::uint8_t> head{'f', 'L', 'a', 'C', 0, 0, 0, 0};
  for (const auto& bytes : {nothing, text, head, tests::wav_bytes({}, 8000), tests::wav_bytes({0.5F}, 100)}) {
    const auto sound = read_sound(bytes);
    ASSERT_FALSE(sound);
    EXPECT_NE(sound.error().what.find("sound"), std::string::npos) << sound.error().line();
    EXPECT_EQ(sound.error().line().find('\n'), std::string::npos);
  }
  const auto rate = read_sound(tests::wav_bytes({0.5F}, 100));
  EXPECT_NE(rate.error().what.find("100 samples a second"), std::string::npos);
}

TEST(ReadSound, OtherContainersAreReadByWhatIsInThem) {
  const auto expected = tests::tone(440, 44100, 1);
  const std::pair<int, double> formats[] = {{SF_FORMAT_MPEG | SF_FORMAT_MPEG_LAYER_III, 0.02},
                                            {SF_FORMAT_AIFF | SF_FORMAT_PCM_16, 1e-4},
                                            {SF_FORMAT_AIFF | SF_FORMAT_FLOAT, 0},
                                            {SF_FORMAT_CAF | SF_FORMAT_PCM_16, 1e-4},
                                            {SF_FORMAT_RF64 | SF_FORMAT_PCM_16, 1e-4},
                                            {SF_FORMAT_W64 | SF_FORMAT_PCM_16, 1e-4},
                                            {SF_FORMAT_AU | SF_FORMAT_PCM_16, 1e-4}};
  for (const auto& [format, most] : formats) {
    const auto bytes = file_of(expected, 44100, format);
    EXPECT_TRUE(looks_like_sound(bytes));
    const auto sound = read_sound(bytes);
    ASSERT_TRUE(sound) << std::hex << format << ": " << sound.error().line();
    EXPECT_NEAR(sound->duration_s(), 1, 0.06) << std::hex << format;
    // A coder of MP3 begins with some silence.
    if (most < 0.01) {
      EXPECT_LE(mean_difference(sound->samples, expected), most) << std::hex << format;
    }
  }
  const auto opus = file_of(tests::tone(440, 48000, 1), 48000, SF_FORMAT_OGG | SF_FORMAT_OPUS);
  ASSERT_TRUE(read_sound(opus));
  EXPECT_NEAR(read_sound(opus)->duration_s(), 1, 0.05);
}

TEST(ReadSound, ATagInFrontAndAMissingSizeAreNoHindrance) {
  const auto plain = tests::wav_bytes(tests::tone(440, 8000, 0.1), 8000);
  std::vector<std::uint8_t> tagged{'I', 'D', '3', 4, 0, 0, 0, 0, 0, 5, 'a', 'b', 'c', 'd', 'e'};
  tagged.insert(tagged.end(), plain.begin(), plain.end());
  ASSERT_TRUE(read_sound(tagged)) << read_sound(tagged).error().line();
  EXPECT_EQ(read_sound(tagged)->samples.size(), 800U);
  auto piped = plain;
  std::fill_n(piped.begin() + 40, 4, std::uint8_t{0});
  ASSERT_TRUE(read_sound(piped)) << read_sound(piped).error().line();
  EXPECT_EQ(read_sound(piped)->samples.size(), 800U);
}

TEST(ReadSound, ContainersThatAreNotReadAreRefusedByName) {
  using namespace std::string_view_literals;
  const std::pair<std::string_view, const char*> files[] = {{"\0\0\0\x1c"
                                                             "ftypM4A \0\0\0\0"sv,
                                                             "MP4"},
                                                            {"\x30\x26\xB2\x75\x8E\x66\xCF\x11\xA6\xD9"sv, "WMA"},
                                                            {"\xFF\xF1\x50\x80\x00\x1F"sv, "AAC"},
                                                            {"#!AMR\n"sv, "AMR"}};
  for (const auto& [text, name] : files) {
    const auto sound = read_sound(base::as_bytes(text));
    ASSERT_FALSE(sound);
    EXPECT_NE(sound.error().what.find(name), std::string::npos) << sound.error().line();
    EXPECT_NE(sound.error().remedy.find("WAV"), std::string::npos);
  }
  EXPECT_FALSE(looks_like_sound(base::as_bytes("0.00\tX\n"sv)));
}

}  // namespace
}  // namespace penpose::sound
