#include "importers/material_assignment.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "importers/material_change.h"
#include "scene/suggest.h"

namespace restframe {
namespace {

constexpr int every_object = -1;

// A material as it stands: where it comes from, and the changes that it went through.
struct Origin {
  int asset = -1, slot = -1;  // -1: a new material
  std::string name;
  std::vector<int> changes;

  bool operator<(const Origin& other) const {
    return std::tie(asset, slot, name, changes) <
           std::tie(other.asset, other.slot, other.name, other.changes);
  }
};

// A material that names can mean.
struct Candidate {
  int object = every_object;  // whose slot it is, or for whom alone it was defined
  Origin origin;
};

class Assignment {
 public:
  Assignment(const std::vector<MaterialChange>& changes, SceneFile& file)
      : changes_(changes), file_(file) {}

  void run();

 private:
  void collect_slots();
  void apply_change(int index);
  bool is_referred_to(const MaterialChange& change, int object) const;
  void define(const MaterialChange& change, int object, int index);
  void report_no_match(const MaterialChange& change);
  const Origin* find(int object, const std::string& name) const;
  const Origin* find_or_report(int object, const MaterialReference& reference);
  void assign(int object);
  int scene_material(const Origin& origin);
  void warn_of_unseen_changes();
  std::vector<std::string> known_names() const;

  const std::vector<MaterialChange>& changes_;
  SceneFile& file_;
  std::vector<Candidate> candidates_;               // slots object by object, then new ones
  std::vector<std::size_t> first_slot_;             // of each object, in candidates_
  std::map<std::string, std::size_t> first_named_;  // of the slots
  std::size_t slot_count_ = 0;
  std::map<Origin, int> scene_materials_;
  std::set<int> seen_changes_;
};

void Assignment::collect_slots() {
  for (std::size_t i = 0; i < file_.object_materials.size(); ++i) {
    first_slot_.push_back(candidates_.size());
    const int asset = file_.object_materials[i].asset;
    if (asset < 0) continue;
    const auto& materials = file_.assets[static_cast<std::size_t>(asset)].materials;
    for (std::size_t slot = 0; slot < materials.size(); ++slot) {
      first_named_.emplace(materials[slot].name, candidates_.size());
      candidates_.push_back(
          {static_cast<int>(i), {asset, static_cast<int>(slot), materials[slot].name, {}}});
    }
  }
  slot_count_ = candidates_.size();
  first_slot_.push_back(slot_count_);
}

bool Assignment::is_referred_to(const MaterialChange& change, int object) const {
  for (std::size_t i = 0; i < file_.object_materials.size(); ++i) {
    if (object != every_object && object != static_cast<int>(i)) continue;
    const ObjectMaterials& materials = file_.object_materials[i];
    if (materials.all_slots && materials.all_slots->name == change.name) return true;
    for (const auto& [slot, reference] : materials.slots) {
      if (reference.name == change.name) return true;
    }
  }
  return false;
}

// A new material for one object begins as what the name meant there so far.
void Assignment::define(const MaterialChange& change, int object, int index) {
  const Origin* before = object == every_object ? nullptr : find(object, change.name);
  Candidate defined{object, before ? *before : Origin{-1, -1, change.name, {}}};
  defined.origin.changes.push_back(index);
  candidates_.push_back(std::move(defined));
}

std::vector<std::string> Assignment::known_names() const {
  std::set<std::string> names;
  for (const Candidate& candidate : candidates_) names.insert(candidate.origin.name);
  for (const ObjectMaterials& materials : file_.object_materials) {
    if (materials.all_slots) names.insert(materials.all_slots->name);
    for (const auto& [slot, reference] : materials.slots) names.insert(reference.name);
  }
  return {names.begin(), names.end()};
}

void Assignment::report_no_match(const MaterialChange& change) {
  const std::string where =
      change.object ? fmt::format("object \"{}\"", change.object->name) : "the scene";
  file_.faults.add(change.at,
                   fmt::format("material \"{}\": {} neither has such a material nor refers to it, "
                               "the nearest is \"{}\"",
                               change.name, where, nearest(change.name, known_names())));
}

void Assignment::apply_change(int index) {
  const MaterialChange& change = changes_[static_cast<std::size_t>(index)];
  int object = every_object;
  for (std::size_t i = 0; change.object && i < file_.scene.objects.size(); ++i) {
    if (file_.scene.objects[i].name == change.object->name) object = static_cast<int>(i);
  }
  bool matched = false;
  for (Candidate& candidate : candidates_) {
    if (object != every_object && candidate.object != object) continue;
    if (!matches(change.name, candidate.origin.name)) continue;
    candidate.origin.changes.push_back(index);
    matched = true;
  }
  if (matched) return;
  if (is_referred_to(change, object)) {
    define(change, object, index);
  } else {
    report_no_match(change);
  }
}

const Origin* Assignment::find(int object, const std::string& name) const {
  const auto first = first_slot_[static_cast<std::size_t>(object)];
  const auto last = first_slot_[static_cast<std::size_t>(object) + 1];
  for (std::size_t i = first; i < last; ++i) {
    if (candidates_[i].origin.name == name) return &candidates_[i].origin;
  }
  const Origin* for_all = nullptr;
  for (std::size_t i = slot_count_; i < candidates_.size(); ++i) {
    if (candidates_[i].origin.name != name) continue;
    if (candidates_[i].object == object) return &candidates_[i].origin;
    if (candidates_[i].object == every_object) for_all = &candidates_[i].origin;
  }
  if (for_all) return for_all;
  const auto other = first_named_.find(name);
  return other == first_named_.end() ? nullptr : &candidates_[other->second].origin;
}

const Origin* Assignment::find_or_report(int object, const MaterialReference& reference) {
  const Origin* found = find(object, reference.name);
  if (found) return found;
  std::vector<std::string> names;
  for (const Candidate& candidate : candidates_) names.push_back(candidate.origin.name);
  file_.faults.add(reference.at,
                   fmt::format("object \"{}\": there is no material \"{}\", the nearest is \"{}\"",
                               file_.scene.objects[static_cast<std::size_t>(object)].name,
                               reference.name, nearest(reference.name, names)));
  return nullptr;
}

int Assignment::scene_material(const Origin& origin) {
  const auto known = scene_materials_.find(origin);
  if (known != scene_materials_.end()) return known->second;
  Material material;
  if (origin.asset >= 0) {
    const SceneAsset& asset = file_.assets[static_cast<std::size_t>(origin.asset)];
    material = asset.materials[static_cast<std::size_t>(origin.slot)];
  }
  material.name = origin.name;
  for (const int index : origin.changes) {
    apply(changes_[static_cast<std::size_t>(index)], material);
    seen_changes_.insert(index);
  }
  const int added = static_cast<int>(file_.scene.materials.size());
  file_.scene.materials.push_back(std::move(material));
  scene_materials_.emplace(origin, added);
  return added;
}

void Assignment::assign(int object) {
  const auto index = static_cast<std::size_t>(object);
  const ObjectMaterials& wanted = file_.object_materials[index];
  std::vector<int>& materials = file_.scene.objects[index].materials;
  const Origin* all = wanted.all_slots ? find_or_report(object, *wanted.all_slots) : nullptr;
  const std::size_t first = first_slot_[index], count = first_slot_[index + 1] - first;
  for (std::size_t slot = 0; slot < count; ++slot) {
    const Origin* origin = all ? all : &candidates_[first + slot].origin;
    const auto by_slot = wanted.slots.find(static_cast<int>(slot));
    if (by_slot != wanted.slots.end()) {
      const Origin* named = find_or_report(object, by_slot->second);
      if (named) origin = named;
    }
    materials.push_back(scene_material(*origin));
  }
}

void Assignment::warn_of_unseen_changes() {
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    if (seen_changes_.count(static_cast<int>(i)) > 0) continue;
    file_.warnings.push_back(fmt::format(
        "{}:{}:{}: material \"{}\" is on no object: every slot that has it uses another",
        file_.path.string(), changes_[i].at.line, changes_[i].at.column, changes_[i].name));
  }
}

void Assignment::run() {
  collect_slots();
  for (std::size_t i = 0; i < changes_.size(); ++i) apply_change(static_cast<int>(i));
  for (std::size_t i = 0; i < file_.object_materials.size(); ++i) assign(static_cast<int>(i));
  if (file_.faults.empty()) warn_of_unseen_changes();
}

}  // namespace

void assign_materials(const std::vector<MaterialChange>& changes, SceneFile& file) {
  Assignment(changes, file).run();
}

}  // namespace restframe
