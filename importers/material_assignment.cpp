#include "importers/material_assignment.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "importers/material_change.h"
#include "importers/object_parts.h"
#include "scene/message.h"
#include "scene/suggest.h"

namespace restframe {
namespace {

constexpr int every_object = -1;

// A material as it stands: where it comes from, and the changes that it went through.
struct Origin {
  int asset = -1, material = -1;  // the asset's material; -1: a new one
  std::string name;
  std::vector<int> changes;

  bool operator<(const Origin& other) const {
    return std::tie(asset, material, name, changes) <
           std::tie(other.asset, other.material, other.name, other.changes);
  }
};

// A material that names can mean.
struct Candidate {
  int object = every_object;  // whose slot it is, or for whom alone it was defined
  Origin origin;
};

// More changes of materials than any scene needs, and no more than memory bears.
constexpr std::size_t most_applications = 20'000'000;

class Assignment {
 public:
  Assignment(const std::vector<MaterialChange>& changes, SceneFile& file)
      : changes_(changes), file_(file), parts_(changes, file) {}

  void run();

 private:
  void collect_slots();
  void collect_references();
  void add_candidate(Candidate candidate);
  std::vector<std::size_t> targets(const MaterialChange& change, int object) const;
  void apply_change(int index);
  bool is_referred_to(const std::string& name, int object) const;
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
  const ObjectParts parts_;
  std::vector<Candidate> candidates_;    // slots object by object, then new ones
  std::vector<std::size_t> first_slot_;  // of each object, in candidates_
  std::map<std::string, std::vector<std::size_t>> by_name_;
  std::set<std::pair<int, std::string>> references_;  // by object, and by every_object
  std::size_t applications_ = 0;
  std::map<Origin, int> scene_materials_;
  std::set<int> seen_changes_;
};

void Assignment::add_candidate(Candidate candidate) {
  by_name_[candidate.origin.name].push_back(candidates_.size());
  candidates_.push_back(std::move(candidate));
}

void Assignment::collect_slots() {
  for (std::size_t i = 0; i < file_.object_materials.size(); ++i) {
    first_slot_.push_back(candidates_.size());
    if (parts_.shares_materials(i)) continue;
    const int asset = file_.object_materials[i].asset;
    const SceneAsset& source = file_.assets[static_cast<std::size_t>(asset)];
    for (int slot = 0; slot < slot_count(source); ++slot) {
      const int material = material_of_slot(source, slot, file_.object_materials[i].variant);
      const std::string& name = source.materials[static_cast<std::size_t>(material)].name;
      add_candidate({static_cast<int>(i), {asset, material, name, {}}});
    }
  }
  first_slot_.push_back(candidates_.size());
}

void Assignment::collect_references() {
  for (std::size_t i = 0; i < file_.object_materials.size(); ++i) {
    if (parts_.shares_materials(i)) continue;
    const ObjectMaterials& materials = parts_.wanted_on(i);
    const auto add = [&](const MaterialReference& reference) {
      references_.insert({static_cast<int>(i), reference.name});
      references_.insert({every_object, reference.name});
    };
    if (materials.all_slots) add(*materials.all_slots);
    for (const auto& [slot, reference] : materials.slots) add(reference);
  }
}

bool Assignment::is_referred_to(const std::string& name, int object) const {
  return references_.count({object, name}) > 0;
}

// The candidates that the change means: all of that name, or the object's only.
std::vector<std::size_t> Assignment::targets(const MaterialChange& change, int object) const {
  std::vector<std::size_t> found;
  const auto add_fitting = [&](const std::vector<std::size_t>& named) {
    for (const std::size_t i : named) {
      if (object == every_object || parts_.belongs_to(candidates_[i].object, object))
        found.push_back(i);
    }
  };
  if (change.name.find('*') == std::string::npos) {
    const auto named = by_name_.find(change.name);
    if (named != by_name_.end()) add_fitting(named->second);
    return found;
  }
  for (const auto& [name, named] : by_name_) {
    if (matches(change.name, name)) add_fitting(named);
  }
  return found;
}

// A new material for one object begins as what the name meant there so far.
void Assignment::define(const MaterialChange& change, int object, int index) {
  const Origin* before = object == every_object ? nullptr : find(object, change.name);
  Candidate defined{object, before ? *before : Origin{-1, -1, change.name, {}}};
  defined.origin.changes.push_back(index);
  add_candidate(std::move(defined));
}

std::vector<std::string> Assignment::known_names() const {
  std::vector<std::string> names;
  for (const auto& [name, named] : by_name_) names.push_back(name);
  return names;
}

void Assignment::report_no_match(const MaterialChange& change) {
  const std::string where =
      change.object ? fmt::format("object \"{}\"", change.object->name) : "the scene";
  std::vector<std::string> names = known_names();
  for (const auto& [object, name] : references_) {
    if (object == every_object) names.push_back(name);
  }
  file_.faults.add(change.at,
                   fmt::format("material \"{}\": {} neither has such a material nor refers to it, "
                               "the nearest is \"{}\"",
                               change.name, where, nearest(change.name, names)));
}

void Assignment::apply_change(int index) {
  const MaterialChange& change = changes_[static_cast<std::size_t>(index)];
  const int object = change.object ? file_.object_of_name.at(change.object->name) : every_object;
  const std::vector<std::size_t> found = targets(change, object);
  for (const std::size_t i : found) candidates_[i].origin.changes.push_back(index);
  applications_ += found.size();
  if (!found.empty()) return;
  if (is_referred_to(change.name, object)) {
    define(change, object, index);
  } else {
    report_no_match(change);
  }
}

// The object's own slot before new materials for it alone, before those for all, before others'
// slots.
const Origin* Assignment::find(int object, const std::string& name) const {
  const auto named = by_name_.find(name);
  if (named == by_name_.end()) return nullptr;
  const std::vector<std::size_t>& indices = named->second;
  const auto own = std::lower_bound(indices.begin(), indices.end(),
                                    first_slot_[static_cast<std::size_t>(object)]);
  if (own != indices.end() && candidates_[*own].object == object) return &candidates_[*own].origin;
  const Origin *for_all = nullptr, *for_whole = nullptr;
  for (auto i = std::lower_bound(own, indices.end(), first_slot_.back()); i != indices.end(); ++i) {
    const Candidate& candidate = candidates_[*i];
    if (candidate.object == object) return &candidate.origin;
    if (candidate.object == every_object) {
      for_all = &candidate.origin;
    } else if (parts_.belongs_to(object, candidate.object)) {
      for_whole = &candidate.origin;
    }
  }
  if (for_whole) return for_whole;
  if (for_all) return for_all;
  return indices.front() < first_slot_.back() ? &candidates_[indices.front()].origin : nullptr;
}

const Origin* Assignment::find_or_report(int object, const MaterialReference& reference) {
  const Origin* found = find(object, reference.name);
  if (found) return found;
  file_.faults.add(reference.at,
                   fmt::format("object \"{}\": there is no material \"{}\", the nearest is \"{}\"",
                               file_.scene.objects[static_cast<std::size_t>(object)].name,
                               reference.name, nearest(reference.name, known_names())));
  return nullptr;
}

int Assignment::scene_material(const Origin& origin) {
  const auto known = scene_materials_.find(origin);
  if (known != scene_materials_.end()) return known->second;
  Material material;
  if (origin.asset >= 0) {
    const SceneAsset& asset = file_.assets[static_cast<std::size_t>(origin.asset)];
    material = asset.materials[static_cast<std::size_t>(origin.material)];
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
  const ObjectMaterials& wanted = parts_.wanted_on(index);
  std::vector<int>& materials = file_.scene.objects[index].materials;
  if (parts_.shares_materials(index)) {
    const int whole = file_.object_materials[index].part_of;
    materials = file_.scene.objects[static_cast<std::size_t>(whole)].materials;
    return;
  }
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
    file_.warnings.push_back(file_.faults.located(
        changes_[i].at,
        fmt::format("material {} is on no object: every slot that has it uses another",
                    quote(changes_[i].name))));
  }
}

void Assignment::run() {
  collect_slots();
  collect_references();
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    apply_change(static_cast<int>(i));
    if (applications_ <= most_applications) continue;
    file_.faults.add(changes_[i].at, "the patterns of [[material]] change too many materials");
    return;
  }
  for (std::size_t i = 0; i < file_.object_materials.size(); ++i) assign(static_cast<int>(i));
  if (file_.faults.empty()) warn_of_unseen_changes();
}

}  // namespace

void assign_materials(const std::vector<MaterialChange>& changes, SceneFile& file) {
  Assignment(changes, file).run();
}

}  // namespace restframe
