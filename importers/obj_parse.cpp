#include "importers/obj_parse.h"

#include <istream>
#include <map>
#include <streambuf>
#include <utility>

#include "importers/tinyobj.h"

namespace restframe {
namespace {

// Hands checked lines to tinyobjloader.
class CheckedLines : public std::streambuf {
 public:
  explicit CheckedLines(ObjChecker& checker) : checker_(checker) {}

 protected:
  int_type underflow() override {
    std::string_view line;
    if (!checker_.next_line(line)) return traits_type::eof();
    line_.assign(line);
    line_ += " \n";  // the blank: a bare "g" would be ignored
    setg(line_.data(), line_.data(), line_.data() + line_.size());
    return traits_type::to_int_type(line_[0]);
  }

 private:
  ObjChecker& checker_;
  std::string line_;
};

// Receives tinyobjloader's statements in the order of the file.
class Collector {
 public:
  explicit Collector(ObjData& data) : data_(data) {}

  void add_face(const tinyobj::index_t* corners, int count) {
    if (!run_is_current_) start_run();
    for (int i = 0; i < count; ++i) {
      data_.corners.push_back({absolute(corners[i].vertex_index, data_.positions.size()),
                               absolute(corners[i].texcoord_index, data_.uvs.size()),
                               absolute(corners[i].normal_index, data_.normals.size())});
    }
    data_.face_ends.push_back(static_cast<std::uint32_t>(data_.corners.size()));
  }

  void use_material(const char* name) {
    const auto next = static_cast<int>(data_.materials.size());
    const auto [entry, is_new] = materials_.emplace(trimmed(name), next);
    if (is_new) data_.materials.push_back(entry->first);
    material_ = entry->second;
    run_is_current_ = false;
  }

  void start_object(const char* name) {
    object_ = trimmed(name);
    group_.clear();
    run_is_current_ = false;
  }

  void start_group(const char** names, int count) {
    group_.clear();
    for (int i = 0; i < count; ++i) {
      if (i > 0) group_ += ' ';
      group_ += names[i];
    }
    run_is_current_ = false;
  }

  ObjData& data() { return data_; }

 private:
  // From 1, or counted back from the last with -1; 0 where none is given.
  static int absolute(int index, std::size_t count) {
    return index >= 0 ? index - 1 : static_cast<int>(count) + index;
  }

  void start_run() {
    const auto next = static_cast<int>(data_.groups.size());
    const auto [entry, is_new] = groups_.try_emplace(std::pair(object_, group_), next);
    if (is_new) {
      const auto object = objects_.try_emplace(object_, data_.objects);
      data_.objects += object.second ? 1 : 0;
      data_.groups.push_back({object_, group_, object.first->second});
    }
    data_.runs.push_back(
        {static_cast<std::uint32_t>(data_.face_ends.size()), entry->second, material_});
    run_is_current_ = true;
  }

  ObjData& data_;
  std::string object_, group_;
  int material_ = -1;
  bool run_is_current_ = false;
  std::map<std::string, int> materials_, objects_;
  std::map<std::pair<std::string, std::string>, int> groups_;
};

Collector& collector(void* user) {
  return *static_cast<Collector*>(user);
}

tinyobj::callback_t callbacks() {
  tinyobj::callback_t result;
  result.vertex_cb = [](void* user, float x, float y, float z, float) {
    collector(user).data().positions.emplace_back(x, y, z);
  };
  result.normal_cb = [](void* user, float x, float y, float z) {
    collector(user).data().normals.emplace_back(x, y, z);
  };
  result.texcoord_cb = [](void* user, float u, float v, float) {
    collector(user).data().uvs.emplace_back(u, v);
  };
  result.index_cb = [](void* user, tinyobj::index_t* corners, int count) {
    collector(user).add_face(corners, count);
  };
  result.usemtl_cb = [](void* user, const char* name, int) { collector(user).use_material(name); };
  result.object_cb = [](void* user, const char* name) { collector(user).start_object(name); };
  result.group_cb = [](void* user, const char** names, int count) {
    collector(user).start_group(names, count);
  };
  return result;
}

}  // namespace

ObjData parse_obj(const Path& path, const ImportLimits& limits, Warnings& warnings) {
  TextFile file(path, limits.total_bytes);
  ObjChecker checker(file, limits);
  CheckedLines lines(checker);
  std::istream stream(&lines);
  stream.exceptions(std::ios::badbit);  // let InputError through

  ObjData data;
  Collector collected(data);
  tinyobj::LoadObjWithCallback(stream, callbacks(), &collected);
  checker.finish(warnings);
  data.colors = checker.colors();
  data.colors.resize(data.colors.empty() ? 0 : data.positions.size(), Vec4f(1));
  data.libraries = checker.libraries();
  return data;
}

}  // namespace restframe
