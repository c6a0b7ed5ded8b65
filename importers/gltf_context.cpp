#include "importers/gltf_context.h"

#include "scene/error.h"
#include "scene/message.h"

namespace restframe {

std::string GltfContext::place(const std::string& pointer) const {
  return pointer.empty() ? file : file + ":" + pointer;
}

void GltfContext::fault(const std::string& pointer, const std::string& what) const {
  throw InputError(on_one_line(place(pointer) + ": " + what));
}

void GltfContext::warn(const std::string& pointer, const std::string& what) const {
  warnings.push_back(on_one_line(place(pointer) + ": " + what));
}

}  // namespace restframe
