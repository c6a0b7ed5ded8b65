#pragma once

#include <vector>

#include "scene/settings.h"

namespace restframe {

inline const std::vector<Layer> all_layers = {Layer::beauty,
                                              Layer::z,
                                              Layer::time,
                                              Layer::doppler,
                                              Layer::normal,
                                              Layer::position,
                                              Layer::uv,
                                              Layer::id,
                                              Layer::variance,
                                              Layer::samples,
                                              Layer::crypto_object,
                                              Layer::crypto_material,
                                              Layer::crypto_asset,
                                              Layer::motion,
                                              Layer::emission,
                                              Layer::direct,
                                              Layer::indirect,
                                              Layer::reflection,
                                              Layer::transmission,
                                              Layer::lights,
                                              Layer::albedo,
                                              Layer::depth,
                                              Layer::apparent_normal};

}  // namespace restframe
