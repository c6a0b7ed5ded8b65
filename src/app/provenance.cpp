#include "app/provenance.h"

#include <fmt/format.h>

#include <map>
#include <sstream>
#include <string_view>

#include "app/version.h"
#include "scene/canonical.h"
#include "scene/file_names.h"

namespace restframe {
namespace {

using Lines = std::vector<std::pair<std::string, std::string>>;  // key and value

Lines lines_of(const std::string& text, const std::string& separator) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t at = std::min(line.find(separator), line.size());
    lines.emplace_back(line.substr(0, at),
                       at < line.size() ? line.substr(at + separator.size()) : "");
  }
  return lines;
}

// Name and hash of the files other than scene files.
Lines assets_in(const std::string& sources) {
  Lines assets;
  for (auto& [hash, name] : lines_of(sources, " ")) {
    if (lower_extension(name) != ".toml") assets.emplace_back(name, hash);
  }
  return assets;
}

// `changed` tells of a key that has another value now.
template <class Changed>
std::string first_difference(const Lines& before, const Lines& now, const Changed& changed) {
  std::map<std::string, std::string> old_values(before.begin(), before.end());
  for (const auto& [key, value] : now) {
    const auto old = old_values.find(key);
    if (old == old_values.end()) return fmt::format("now also {} {}", key, value);
    if (old->second != value) return changed(key, old->second, value);
    old_values.erase(old);
  }
  return old_values.empty() ? "" : "no longer " + old_values.begin()->first;
}

// "restframe 1.2" of "restframe 1.2.3".
std::string_view release_of(std::string_view program) {
  return program.substr(0, program.rfind('.'));
}

}  // namespace

Provenance provenance_of(const Scene& scene) {
  Provenance provenance{canonical_settings(scene), {}, std::string("restframe ") + program_version};
  for (const SourceFile& source : scene.sources) {
    provenance.sources += fmt::format("{} {}\n", source.hash, source.name);
  }
  return provenance;
}

std::string pixel_text(const Provenance& provenance) {
  std::string text = provenance.settings;
  for (const auto& [name, hash] : assets_in(provenance.sources)) text += hash + " " + name + "\n";
  return text;
}

std::vector<std::pair<std::string, std::string>> texts_of(const Provenance& provenance) {
  return {{"restframeSettings", provenance.settings},
          {"restframeSources", provenance.sources},
          {"software", provenance.program}};
}

std::string difference(const Provenance& before, const Provenance& now) {
  if (release_of(before.program) != release_of(now.program)) {
    return fmt::format("by {}, this is {}", before.program, now.program);
  }
  const auto file_changed = [](const std::string& name, const std::string&, const std::string&) {
    return name + " has changed";
  };
  std::string found =
      first_difference(assets_in(before.sources), assets_in(now.sources), file_changed);
  if (!found.empty() || before.settings == now.settings) return found;
  const auto value_changed = [](const std::string& key, const std::string& was,
                                const std::string& is) {
    return fmt::format("{} was {}, is {}", key, was, is);
  };
  found = first_difference(lines_of(before.settings, " = "), lines_of(now.settings, " = "),
                           value_changed);
  return found.empty() ? "the order of its settings" : found;
}

}  // namespace restframe
