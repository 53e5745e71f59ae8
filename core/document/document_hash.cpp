#include "core/document/document_hash.h"

#include "core/document/model_hash.h"

namespace penpose::document {
namespace {

using base::StateHash;

void add_vector(StateHash& hash, const geometry::ModelVector& v) {
  hash.add(v.x);
  hash.add(v.y);
  hash.add(v.z);
}

void add_view(StateHash& hash, const View& view) {
  add_vector(hash, view.camera.eye);
  add_vector(hash, view.camera.look_at);
  add_vector(hash, view.camera.up);
  hash.add(view.camera.vertical_fov_degrees);
  hash.add(static_cast<std::uint64_t>(view.viewport.width));
  hash.add(static_cast<std::uint64_t>(view.viewport.height));
}

void add_points(StateHash& hash, const std::vector<geometry::ModelPoint>& points) {
  hash.add(std::uint64_t{points.size()});
  for (const auto& point : points) add_vector(hash, point);
}

void add_target(StateHash& hash, const DrawnTarget& target) {
  add_view(hash, target.view);
  hash.add(std::uint64_t{target.line.size()});
  for (const curve::PxPoint& p : target.line) {
    hash.add(p.x);
    hash.add(p.y);
  }
  hash.add(std::span<const double>(target.pressure));
  add_points(hash, target.points);
  hash.add(std::span<const double>(target.weights));
}

void add_face(StateHash& hash, const char* name, const FaceDrawing& face) {
  hash.add(name);
  add_view(hash, face.view);
  add_vector(hash, face.middle);
  hash.add(face.time_s);
  hash.add(std::uint64_t{face.lines.size()});
  for (const FaceLine& one : face.lines) {
    hash.add(std::uint64_t{one.id.value});
    hash.add(std::uint64_t{one.line.size()});
    for (const curve::PxPoint& p : one.line) {
      hash.add(p.x);
      hash.add(p.y);
    }
    hash.add(std::uint64_t{one.said.has_value()});
    if (one.said) hash.add(*one.said);
    hash.add(one.feature);
  }
}

base::Hash128 hash_of(const PoseCurve& curve, const HashForm& form) {
  StateHash hash;
  hash.add(std::uint64_t{curve.id.value});
  hash.add(static_cast<std::uint64_t>(curve.role));
  add_mesh_points(hash, curve.points);
  add_points(hash, curve.kept);
  if (!curve.aside.empty()) add_points(hash, curve.aside);
  if (curve.time_s != 0.0 && form.moments_of_curves) hash.add(curve.time_s);
  hash.add(std::uint64_t{curve.target.has_value()});
  if (curve.target) add_target(hash, *curve.target);
  return hash.digest();
}

void add_digest(StateHash& hash, const base::Hash128& digest) {
  hash.add(digest.high);
  hash.add(digest.low);
}

void add_reference(StateHash& hash, const ReferencePicture& picture) {
  hash.add("reference");
  hash.add(picture.file);
  add_digest(hash, picture.content);
  hash.add(std::uint64_t{picture.beside});
  add_vector(hash, picture.middle);
  for (const double value :
       {picture.offset_s, picture.opacity, picture.height, picture.card.x, picture.card.y, picture.card_height})
    hash.add(value);
}

base::Hash128 hash_deformers(const Document& document) {
  StateHash hash;
  if (document.model->deformers) articulation::add_to_hash(hash, *document.model->deformers);
  hash.add(std::uint64_t{document.pending != nullptr});
  if (document.pending) articulation::add_to_hash(hash, document.pending->sketch);
  if (document.model->corrections) {
    for (const auto& one : document.model->corrections->all()) articulation::add_to_hash(hash, one->drawn);
  }
  if (document.pending && !document.pending->drivers.empty()) {
    articulation::add_to_hash(hash, articulation::CorrectionSketch{{}, document.pending->drivers});
  }
  return hash.digest();
}

void add_taken(StateHash& hash, const std::vector<TakenReading>& taken) {
  hash.add(std::uint64_t{taken.size()});
  for (const TakenReading& one : taken) {
    for (const auto* names : {&one.taken, &one.instead_of}) {
      hash.add(std::uint64_t{names->size()});
      for (const std::string& name : *names) hash.add(name);
    }
    hash.add(one.by);
  }
}

base::Hash128 hash_parameters(const Document& document) {
  StateHash hash;
  add_parameters(hash, *document.model->rig);
  hash.add(std::span<const double>(document.pose));
  for (const std::string& name : document.locked) hash.add(name);
  hash.add(std::uint64_t{document.pressure_weighting});
  // States of before the hand could be told are hashed as ever.
  if (document.hand != 1.0) hash.add(document.hand);
  hash.add(document.time_s);
  if (document.taken) add_taken(hash, *document.taken);
  return hash.digest();
}

void add_spoken(StateHash& hash, const SpokenMouths& spoken) {
  hash.add("spoken");
  for (const SpokenMouth& one : spoken) {
    hash.add(one.time_s);
    hash.add(one.mouth);
  }
}

void add_bookmarks(StateHash& hash, const Bookmarks& bookmarks) {
  hash.add("bookmarks");
  for (const Bookmark& one : bookmarks) {
    hash.add(one.time_s);
    hash.add(one.name);
    hash.add(std::uint64_t{one.color});
  }
}

/// Documents of before there was sound are hashed as ever.
void add_sound(StateHash& hash, const Document& document) {
  if (document.sound) {
    hash.add("sound");
    hash.add(document.sound->file);
    add_digest(hash, document.sound->content);
    hash.add(document.sound->offset_s);
  }
  for (const auto& mouth : document.mouths) {
    hash.add("mouth");
    hash.add(mouth->name);
    hash.add(std::uint64_t{mouth->values.size()});
    for (const NamedValue& one : mouth->values) {
      hash.add(one.name);
      hash.add(one.value);
    }
  }
  if (document.spoken) add_spoken(hash, *document.spoken);
  if (!document.words) return;
  hash.add("words");
  for (const SpokenWord& one : *document.words) {
    hash.add(one.from_s);
    hash.add(one.word);
  }
}

void add_keys(StateHash& hash, const Timeline& timeline, const HashForm& form) {
  for (const PoseKey& key : timeline.keys) {
    hash.add(key.time_s);
    hash.add(std::span<const double>(static_cast<const rig::Pose&>(key.pose)));
    hash.add(key.name);
    if (key.controls.usual() || form.one_kind) continue;
    for (std::size_t i = 0; i < key.pose.size(); ++i) {
      const ControlKey control = key.controls[i];
      hash.add(static_cast<std::uint64_t>(control.kind));
      hash.add(control.in);
      hash.add(control.out);
    }
  }
}

void add_clip(StateHash& hash, const Document& document, std::size_t number, const HashForm& form) {
  const Clip& clip = *document.clips[number];
  hash.add(clip.name);
  if (number == document.clip) return;
  hash.add(std::uint64_t{clip.timeline->keys.size()});
  add_keys(hash, *clip.timeline, form);
  if (clip.spoken) add_spoken(hash, *clip.spoken);
  if (clip.bookmarks) add_bookmarks(hash, *clip.bookmarks);
}

void add_camera(StateHash& hash, const CameraTrack& track) {
  hash.add("camera");
  for (const CameraKey& key : track.keys) {
    hash.add(key.time_s);
    add_view(hash, key.view);
    hash.add(static_cast<std::uint64_t>(key.kind));
  }
}

base::Hash128 hash_keys(const Document& document, const base::Hash128& animations, const HashForm& form) {
  StateHash hash;
  // The two kinds that timelines had: 0, straight, and 1, smooth.
  if (form.one_kind) hash.add(std::uint64_t{*form.one_kind == KeyKind::smooth});
  add_keys(hash, *document.timeline, form);
  if (!document.clips.empty()) {
    hash.add("clips");
    hash.add(std::uint64_t{document.clips.size()});
    hash.add(std::uint64_t{document.clip});
  }
  for (std::size_t i = 0; i < document.clips.size(); ++i) add_clip(hash, document, i, form);
  add_digest(hash, animations);
  add_sound(hash, document);
  if (document.bookmarks) add_bookmarks(hash, *document.bookmarks);
  if (document.camera) add_camera(hash, *document.camera);
  return hash.digest();
}

}  // namespace

std::vector<std::string_view> differing_parts(const DocumentState& a, const DocumentState& b) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < k_state_parts.size(); ++i) {
    if (a.parts[i] != b.parts[i]) names.push_back(k_state_parts[i]);
  }
  return names;
}

base::Hash128 DocumentHasher::hash_curves(const Document& document) {
  // The list of the last call in step with this one: between two neighbours one or a few curves come, go or change.
  std::vector<HashedCurve> hashed;
  hashed.reserve(document.curves.size());
  std::size_t known = 0;
  for (std::size_t i = 0; i < document.curves.size(); ++i) {
    const auto& curve = document.curves[i];
    const auto is_at = [&](std::size_t at, const auto& one) { return at < curves_.size() && curves_[at].curve == one; };
    if (!is_at(known, curve) && is_at(known + 1, curve)) ++known;
    if (is_at(known, curve)) {
      hashed.push_back(std::move(curves_[known++]));
      continue;
    }
    hashed.push_back({curve, hash_of(*curve, form_)});
    const bool added = i + 1 < document.curves.size() && is_at(known, document.curves[i + 1]);
    if (!added) ++known;
  }
  curves_ = std::move(hashed);
  StateHash hash;
  hash.add(std::uint64_t{document.last_curve});
  hash.add(std::uint64_t{curves_.size()});
  for (const HashedCurve& one : curves_) add_digest(hash, one.hash);
  add_curves(hash, document.model->curves);
  if (!document.model->features.empty()) {
    hash.add("features");
    add_curves(hash, document.model->features);
  }
  for (const auto& named : document.views) {
    hash.add(named->name);
    add_view(hash, named->view);
    // Views of before they had keys are hashed as ever.
    if (named->key != 0) hash.add(std::uint64_t{named->key});
  }
  if (document.reference) add_reference(hash, *document.reference);
  if (document.face) add_face(hash, "face", *document.face);
  if (document.neutral) add_face(hash, "neutral", *document.neutral);
  return hash.digest();
}

DocumentState DocumentHasher::operator()(const Document& document) {
  const Model& model = *document.model;
  if (mesh_ != model.mesh || shapes_ != model.shapes || skeleton_ != model.skeleton) {
    mesh_ = model.mesh;
    shapes_ = model.shapes;
    skeleton_ = model.skeleton;
    surface_ = hash_surface(model);
  }
  std::vector<std::size_t> opened;
  for (const auto& clip : document.clips) {
    if (clip->animation) opened.push_back(*clip->animation);
  }
  if (animated_ != document.model || opened_ != opened) {
    animated_ = document.model;
    StateHash hash;
    add_animations(hash, model.animations, opened);
    animations_ = hash.digest();
    opened_ = std::move(opened);
  }
  const std::array<base::Hash128, k_state_parts.size()> parts{surface_, hash_deformers(document),
                                                              hash_parameters(document), hash_curves(document),
                                                              hash_keys(document, animations_, form_)};
  StateHash hash;
  hash.add("penpose document 1");
  DocumentState state;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    add_digest(hash, parts[i]);
    state.parts[i] = static_cast<std::uint32_t>(parts[i].low);
  }
  state.whole = hash.digest();
  return state;
}

base::Hash128 state_hash(const Model& model) { return DocumentHasher()(make_document(model)).whole; }

}  // namespace penpose::document
