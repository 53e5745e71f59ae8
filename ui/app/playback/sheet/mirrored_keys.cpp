#include "ui/app/playback/sheet/mirrored_keys.h"

#include <map>
#include <set>
#include <utility>

#include "core/document/time/timeline_editing.h"
#include "core/poses/sides.h"

namespace penpose::app {
namespace {

using document::PoseKey;
using poses::k_no_pair;

/// Numbers of controls that a key exchanges, both sides of each pair, by the place of the key.
using Exchanged = std::map<std::size_t, std::set<std::size_t>>;

/// What is done to the keys that there are and to those that come.
struct Exchange {
  document::SetKeyValues values;
  std::vector<document::KeyPoses> added;
  std::map<document::KeyKind, document::SetKeyKind> kinds;
};

Exchanged exchanged_by(const document::Document& document, const document::OfKeys& keys,
                       const std::vector<std::size_t>& pairs) {
  const auto parameters = document.model->rig->parameters();
  const std::size_t shapes = document::weight_count(*document.model);
  Exchanged out;
  for (std::size_t i = 0; i < keys.times_s.size(); ++i) {
    const auto place = document::key_at(*document.timeline, keys.times_s[i]);
    if (!place) continue;
    const PoseKey& key = document.timeline->keys[*place];
    const auto named = i < keys.names.size() ? rig::find_parameter(parameters, keys.names[i]) : std::nullopt;
    for (std::size_t p = 0; p < shapes; ++p) {
      const bool meant = keys.names.empty() ? key.controls.has(p) : named == p;
      if (meant && pairs[p] != k_no_pair) out[*place].insert({p, pairs[p]});
    }
  }
  return out;
}

void exchange(const document::Document& document, const PoseKey& key, std::size_t to, std::size_t from, Exchange& out,
              document::KeyPoses& added) {
  const rig::Parameter& parameter = document.model->rig->parameters()[to];
  const double value = poses::fitted(parameter, key.pose[from]);
  const bool has = key.controls.has(to);
  if (has && value != key.pose[to]) {
    out.values.times_s.push_back(key.time_s);
    out.values.names.push_back(parameter.name);
    out.values.values.push_back(value);
  } else if (!has) {
    added.names.push_back(parameter.name);
    added.values.push_back(value);
  }
  const document::KeyKind kind = key.controls.has(from) ? key.controls[from].kind : document::KeyKind::smooth;
  if (kind == (has ? key.controls[to].kind : document::KeyKind::smooth)) return;
  document::SetKeyKind& same = out.kinds[kind];
  same.kind = kind;
  same.times_s.push_back(key.time_s);
  same.names.push_back(parameter.name);
}

}  // namespace

std::vector<document::Command> mirrored_keys(const document::Document& document, const document::OfKeys& keys) {
  const auto pairs = poses::side_pairs(document.model->rig->parameters());
  Exchange all;
  for (const auto& [place, controls] : exchanged_by(document, keys, pairs)) {
    const PoseKey& key = document.timeline->keys[place];
    document::KeyPoses added{{}, {key.time_s}, {}};
    for (const std::size_t to : controls) exchange(document, key, to, pairs[to], all, added);
    if (!added.names.empty()) all.added.push_back(std::move(added));
  }
  std::vector<document::Command> out;
  if (!all.values.names.empty()) out.emplace_back(all.values);
  for (const document::KeyPoses& one : all.added) out.emplace_back(one);
  for (const auto& [kind, one] : all.kinds) out.emplace_back(one);
  return out;
}

}  // namespace penpose::app
