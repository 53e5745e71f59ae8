#include "core/io/tracks/vmd/write_vmd.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/base/byte_writer.h"
#include "core/document/time/animation_sampling.h"
#include "core/io/model/model_formats.h"
#include "core/io/tracks/vmd/shift_jis.h"
#include "core/io/tracks/vmd/vmd_layout.h"

namespace penpose::io {
namespace {

/// Which frames need a key so that a line between keys is within `within` of every value.
std::vector<std::size_t> keyed_frames(const std::vector<double>& values, double within) {
  std::vector<std::size_t> keys{0};
  double least = -std::numeric_limits<double>::infinity();
  double most = -least;
  for (std::size_t f = 1; f < values.size(); ++f) {
    const auto passed = [&](std::size_t to) { return static_cast<double>(to - keys.back()); };
    double slope = (values[f] - values[keys.back()]) / passed(f);
    if (slope < least || slope > most) {
      keys.push_back(f - 1);
      least = -std::numeric_limits<double>::infinity();
      most = -least;
      slope = values[f] - values[f - 1];
    }
    least = std::max(least, slope - within / passed(f));
    most = std::min(most, slope + within / passed(f));
  }
  const bool still =
      keys.size() == 1 && std::all_of(values.begin(), values.end(), [&](double v) { return v == values[0]; });
  if (!still && keys.back() + 1 < values.size()) keys.push_back(values.size() - 1);
  return keys;
}

void write_padded(base::ByteWriter& out, std::string_view text, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) out.write(static_cast<std::uint8_t>(i < text.size() ? text[i] : 0));
}

}  // namespace

base::Result<VmdBytes> write_vmd(const document::Model& model) {
  constexpr double k_within = 0.0005;
  const std::size_t weights = document::weight_count(model);
  if (weights == 0) return base::Error{"the model has no blend shape or deformer", "", "write .glb to keep its joints"};
  const bool moves = !model.animations.empty();
  const double last = moves ? std::round(document::duration_s(model.animations.front()) * k_vmd_fps) : 0;
  if (!(last < 1e6) || (last + 1) * static_cast<double>(weights) > 5e7) {
    return base::Error{"the animation has over 1,000,000 frames or 50,000,000 values", "", "cut it"};
  }
  const auto frames = static_cast<std::size_t>(last) + 1;
  std::vector<std::vector<double>> values(weights, std::vector<double>(frames));
  for (std::size_t f = 0; f < frames; ++f) {
    std::vector<double> now(model.pose.begin(), model.pose.begin() + static_cast<std::ptrdiff_t>(weights));
    if (moves) {
      auto moment = document::sample(model, model.animations.front(), static_cast<double>(f) / k_vmd_fps);
      if (moment.weights.size() == weights) now = std::move(moment.weights);
    }
    for (std::size_t i = 0; i < weights; ++i) values[i][f] = now[i];
  }
  VmdBytes result;
  base::ByteWriter keys;
  std::uint32_t count = 0;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < weights; ++i) {
    const std::string& own = model.rig->parameters()[i].name;
    const ShiftJis name = shift_jis_of(own, VmdSizes::morph_name);
    if (!taken.insert(name.bytes).second) {
      result.notes.push_back(own + ": another control has the same first 15 bytes of its name; left out");
      continue;
    }
    if (!name.whole) {
      result.notes.push_back(own + " is called \"" + utf8_of_shift_jis(base::as_bytes(name.bytes)) +
                             "\" there: names are Shift-JIS of at most 15 bytes");
    }
    for (const std::size_t f : keyed_frames(values[i], k_within)) {
      write_padded(keys, name.bytes, VmdSizes::morph_name);
      keys.write(static_cast<std::uint32_t>(f));
      keys.write_f32(static_cast<float>(values[i][f]));
      ++count;
    }
  }
  if (model.skeleton && moves) {
    const auto& channels = model.animations.front().channels;
    const bool turns = std::any_of(channels.begin(), channels.end(), [](const document::Channel& channel) {
      return channel.target != document::ChannelTarget::weights;
    });
    if (turns) result.notes.emplace_back("the motion of joints is left out");
  }
  base::ByteWriter out;
  write_padded(out, k_vmd_header, VmdSizes::header);
  write_padded(out, "penpose", VmdSizes::model);
  out.write(std::uint32_t{0});  // bones
  out.write(count);
  out.append(keys.bytes());
  // Cameras, lights, shadows.
  for (int run = 0; run < 3; ++run) out.write(std::uint32_t{0});
  result.bytes = std::move(out).take();
  return result;
}

ModelFormat vmd_format_of_models() {
  return {.name = "VMD",
          .extension = ".vmd",
          .write = [](const document::Model& model, const WriteOptions&, WriteReport& report) -> ModelFormat::Written {
            auto motion = write_vmd(model);
            if (!motion) return motion.error();
            report.notes = std::move(motion->notes);
            return std::move(motion->bytes);
          },
          .holds = "Blend shapes over time",
          .detail = "Morph keys for MikuMikuDance"};
}

}  // namespace penpose::io
