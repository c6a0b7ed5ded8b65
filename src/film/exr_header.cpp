#include "film/exr_header.h"

#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>
#include <fmt/format.h>

#include <cmath>

namespace restframe {
namespace {

Imf::Compression exr_compression(Compression compression) {
  switch (compression) {
    case Compression::none:
      return Imf::NO_COMPRESSION;
    case Compression::rle:
      return Imf::RLE_COMPRESSION;
    case Compression::zips:
      return Imf::ZIPS_COMPRESSION;
    case Compression::zip:
      return Imf::ZIP_COMPRESSION;
    case Compression::piz:
      return Imf::PIZ_COMPRESSION;
    case Compression::pxr24:
      return Imf::PXR24_COMPRESSION;
    case Compression::dwaa:
      return Imf::DWAA_COMPRESSION;
    case Compression::dwab:
      return Imf::DWAB_COMPRESSION;
  }
  return Imf::ZIP_COMPRESSION;
}

// OpenEXR's camera space is left-handed, its z axis the viewing direction; its matrices act on row
// vectors. The camera's own axes at the moment of the picture, in scene units.
Imath::M44d world_to_camera(const PictureInfo& info) {
  const Mat3& axes = info.pose.axes;
  const Vec3 columns[3] = {axes[0], axes[1], -axes[2]};
  const Vec3 position = info.pose.event.x * info.light_speed;
  Imath::M44d m;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) m[row][column] = columns[column][row];
    m[3][column] = -glm::dot(position, columns[column]);
  }
  return m;
}

Imath::Box2i exr_box(const PixelWindow& window) {
  return {{window.left, window.top}, {window.right() - 1, window.bottom() - 1}};
}

PixelWindow display_of(const Picture& picture, const PictureInfo& info) {
  return info.display.width > 0 ? info.display : picture.window();
}

// Film coordinates from (0, 0), top left, to (1, 1), after division by w = distance along the view.
Imath::M44d ndc_from_camera(const PixelWindow& display, const PictureInfo& info) {
  const double half_height = std::tan(0.5 * info.pose.vertical_fov);
  const double half_width = half_height * display.width / display.height;
  return Imath::M44d(0.5 / half_width, 0, 0, 0,    //
                     0, -0.5 / half_height, 0, 0,  //
                     0.5, 0.5, 1, 1,               //
                     0, 0, 0, 0);
}

}  // namespace

Imf::Header exr_header(const Picture& picture, const PictureInfo& info,
                       const std::pair<double, double>& time_origins) {
  const PixelWindow display = display_of(picture, info);
  Imf::Header header(exr_box(display), exr_box(picture.window()));
  header.compression() = exr_compression(info.compression);
  Imf::addChromaticities(header, Imf::Chromaticities());  // Rec. 709
  Imf::addFramesPerSecond(header, Imf::Rational(info.rate));
  const Imath::M44d to_camera = world_to_camera(info);
  Imf::addWorldToCamera(header, Imath::M44f(to_camera));
  Imf::addWorldToNDC(header, Imath::M44f(to_camera * ndc_from_camera(display, info)));
  const Vec3 velocity =
      Boost<in::Camera, in::World>(info.pose.world_from_camera.inverse()).velocity().beta();
  header.insert("cameraVelocity",
                Imf::V3dAttribute(Imath::V3d(velocity.x, velocity.y, velocity.z)));
  header.insert("cameraTime", Imf::DoubleAttribute(info.camera_time));
  header.insert("pictureNumber", Imf::IntAttribute(info.number));
  header.insert("depthType", Imf::StringAttribute("distance"));
  header.insert("timeOrigin", Imf::StringAttribute(fmt::format(
                                  "{:.17g} {:.17g}", time_origins.first, time_origins.second)));
  header.insert("objectNames", Imf::StringVectorAttribute(info.object_names));
  header.insert("materialNames", Imf::StringVectorAttribute(info.material_names));
  for (const auto& [name, text] : info.texts) header.insert(name, Imf::StringAttribute(text));
  return header;
}

}  // namespace restframe
