#include "core/io/gltf/read/compression/meshopt_stream.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <meshoptimizer.h>

namespace penpose::io {
namespace {

std::vector<std::uint8_t> packed(const void* data, std::size_t count, std::size_t stride) {
  std::vector<std::uint8_t> out(meshopt_encodeVertexBufferBound(count, stride));
  out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), data, count, stride));
  return out;
}

template <typename T>
std::vector<T> numbers(const std::vector<std::uint8_t>& bytes) {
  std::vector<T> out(bytes.size() / sizeof(T));
  std::memcpy(out.data(), bytes.data(), bytes.size());
  return out;
}

// Directions all around, as a sphere of them.
std::vector<float> directions() {
  std::vector<float> out;
  for (int i = 0; i < 200; ++i) {
    const float z = 1.0F - 2.0F * (static_cast<float>(i) + 0.5F) / 200.0F;
    const float r = std::sqrt(1.0F - z * z);
    const float turn = 2.4F * static_cast<float>(i);
    out.insert(out.end(), {r * std::cos(turn), r * std::sin(turn), z, 0.0F});
  }
  return out;
}

TEST(MeshoptStream, OctahedralDirectionsComeBackWithinTheirBits) {
  const auto in = directions();
  for (const std::size_t stride : {std::size_t{4}, std::size_t{8}}) {
    std::vector<std::uint8_t> filtered(200 * stride);
    meshopt_encodeFilterOct(filtered.data(), 200, stride, stride == 4 ? 8 : 16, in.data());
    const auto bytes = unpack_meshopt(packed(filtered.data(), 200, stride),
                                      {MeshoptMode::attributes, MeshoptFilter::octahedral, 200, stride}, 1 << 20);
    ASSERT_TRUE(bytes.ok()) << bytes.error().line();
    for (std::size_t i = 0; i < 200; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double value = stride == 4 ? numbers<std::int8_t>(*bytes)[4 * i + c] / 127.0
                                         : numbers<std::int16_t>(*bytes)[4 * i + c] / 32767.0;
        EXPECT_NEAR(value, static_cast<double>(in[4 * i + c]), stride == 4 ? 0.02 : 1e-4);
      }
    }
  }
}

TEST(MeshoptStream, QuaternionsComeBackUpToTheirSign) {
  std::vector<float> in;
  for (int i = 0; i < 64; ++i) {
    const float a = 0.1F * static_cast<float>(i);
    in.insert(in.end(), {std::sin(a) * 0.6F, std::sin(a) * 0.8F * std::cos(3 * a), std::sin(a) * 0.8F * std::sin(3 * a),
                         std::cos(a)});
  }
  std::vector<std::uint8_t> filtered(64 * 8);
  meshopt_encodeFilterQuat(filtered.data(), 64, 8, 16, in.data());
  const auto bytes = unpack_meshopt(packed(filtered.data(), 64, 8),
                                    {MeshoptMode::attributes, MeshoptFilter::quaternion, 64, 8}, 1 << 20);
  ASSERT_TRUE(bytes.ok()) << bytes.error().line();
  const auto out = numbers<std::int16_t>(*bytes);
  for (std::size_t i = 0; i < 64; ++i) {
    double dot = 0;
    for (std::size_t c = 0; c < 4; ++c) dot += out[4 * i + c] / 32767.0 * static_cast<double>(in[4 * i + c]);
    EXPECT_NEAR(std::abs(dot), 1.0, 1e-4) << i;
  }
}

TEST(MeshoptStream, ExponentialNumbersAreMantissaTimesAPowerOfTwo) {
  const auto word = [](int exponent, int mantissa) {
    return (static_cast<std::uint32_t>(exponent) << 24) | (static_cast<std::uint32_t>(mantissa) & 0xffffffU);
  };
  const std::vector<std::uint32_t> in{word(0, 3),    word(-2, -5), word(10, 1),
                                      word(-100, 1), word(0, 0),   word(-23, 1 << 22)};
  const auto bytes =
      unpack_meshopt(packed(in.data(), 6, 4), {MeshoptMode::attributes, MeshoptFilter::exponential, 6, 4}, 1 << 20);
  ASSERT_TRUE(bytes.ok()) << bytes.error().line();
  EXPECT_EQ(numbers<float>(*bytes), (std::vector<float>{3.0F, -1.25F, 1024.0F, std::ldexp(1.0F, -100), 0.0F, 0.5F}));
}

TEST(MeshoptStream, AStreamThatEndsEarlyOrClaimsTooMuchIsRefused) {
  const std::vector<std::uint32_t> in(1024, 5);
  const auto whole = packed(in.data(), 1024, 4);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_FALSE(unpack_meshopt(base::Bytes(whole).first(length), {.count = 1024, .stride = 4}, 1 << 20).ok());
  }
  EXPECT_FALSE(unpack_meshopt(whole, {.count = 1024, .stride = 4}, 4095).ok()) << "more than may be taken";
  EXPECT_FALSE(unpack_meshopt(whole, {.count = std::uint64_t{1} << 62, .stride = 4}, 1 << 20).ok());
  EXPECT_FALSE(
      unpack_meshopt(whole, {.count = std::uint64_t{1} << 40, .stride = 256}, std::numeric_limits<std::uint64_t>::max())
          .ok());
}

}  // namespace
}  // namespace penpose::io
