#include "tracer/bsdf_albedo.h"

namespace restframe {

const FacetAlbedoTable& facet_albedo_table() {
  static const FacetAlbedoTable table{};
  return table;
}

}  // namespace restframe
