#include "importers/gltf_context.h"

#include "scene/error.h"

namespace restframe {
namespace {

// Errors and warnings are one line each, whatever a file holds.
std::string printable(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text;
}

std::string located(const GltfContext& context, const std::string& pointer,
                    const std::string& what) {
  return printable(context.file + (pointer.empty() ? "" : ":" + pointer) + ": " + what);
}

}  // namespace

void GltfContext::fault(const std::string& pointer, const std::string& what) const {
  throw InputError(located(*this, pointer, what));
}

void GltfContext::warn(const std::string& pointer, const std::string& what) const {
  warnings.push_back(located(*this, pointer, what));
}

std::string in_quotes(const std::string& text) {
  constexpr std::size_t longest = 80;
  return '"' + (text.size() > longest ? text.substr(0, longest) + "..." : text) + '"';
}

}  // namespace restframe
