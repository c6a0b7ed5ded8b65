#include "film/exr_header.h"

#include <OpenEXR/ImfBoxAttribute.h>
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

#include "film/exr_check.h"

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
    case Compression::b44:
      return Imf::B44_COMPRESSION;
    case Compression::b44a:
      return Imf::B44A_COMPRESSION;
  }
  return Imf::ZIP_COMPRESSION;
}

// OpenEXR's camera space is left-handed, its z axis the viewing direction; its matrices act on row
// vectors. The camera's own axes at the moment of the picture, in scene units.
Imath::M44d world_to_camera(const CameraPose& pose, const PictureInfo& info) {
  const Mat3& axes = pose.axes;
  const Vec3 columns[3] = {axes[0], axes[1], -axes[2]};
  const Vec3 position = pose.event.x * info.light_speed;
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

PixelWindow display_of(const PixelWindow& window, const PictureInfo& info) {
  return info.display.width > 0 ? info.display : window;
}

// Film coordinates from (0, 0), top left, to (1, 1), after division by w = distance along the view.
Imath::M44d ndc_from_camera(const PixelWindow& display, const CameraPose& pose) {
  const double half_height = std::tan(0.5 * pose.vertical_fov);
  const double half_width = half_height * display.width / display.height;
  const double middle = 0.5 - 0.5 * pose.film_shift / half_width;
  return Imath::M44d(0.5 / half_width, 0, 0, 0,    //
                     0, -0.5 / half_height, 0, 0,  //
                     middle, 0.5, 1, 1,            //
                     0, 0, 0, 0);
}

struct CameraMatrices {
  Imath::M44f to_camera, to_ndc;
};

CameraMatrices matrices(const CameraPose& pose, const PixelWindow& window,
                        const PictureInfo& info) {
  const Imath::M44d to_camera = world_to_camera(pose, info);
  const Imath::M44d to_ndc = to_camera * ndc_from_camera(display_of(window, info), pose);
  return {Imath::M44f(to_camera), Imath::M44f(to_ndc)};
}

// The display on a film at the distance 1: its width, and where its middle is.
void add_screen(Imf::Header& header, const CameraPose& pose, const PixelWindow& display) {
  const double width = 2.0 * std::tan(0.5 * pose.vertical_fov) * display.width / display.height;
  header.screenWindowWidth() = static_cast<float>(width);
  header.screenWindowCenter() = Imath::V2f(static_cast<float>(pose.film_shift), 0.0F);
}

// Of a film at this rate that begins with picture 0. The format has no more than 30 pictures a second,
// and a day.
void add_time_code(Imf::Header& header, const PictureInfo& info) {
  const int rate = info.rate >= 1 && info.rate <= 30 ? static_cast<int>(info.rate) : 0;
  if (rate != info.rate || info.number < 0) return;
  const int seconds = info.number / rate;
  if (seconds >= 24 * 3600) return;
  Imf::addTimeCode(
      header, Imf::TimeCode(seconds / 3600, seconds / 60 % 60, seconds % 60, info.number % rate));
}

// The focus is in metres, by OpenEXR's definition.
void add_exposure(Imf::Header& header, const PictureInfo& info) {
  constexpr double light_metres = 299'792'458;  // a second
  if (info.shutter > 0.0) Imf::addExpTime(header, static_cast<float>(info.shutter));
  if (info.focus && info.light_speed == light_metres) {
    Imf::addFocus(header, static_cast<float>(*info.focus * light_metres));
  }
}

}  // namespace

Imf::Header exr_header(const PixelWindow& window, const PictureInfo& info, const CameraPose& pose,
                       const std::pair<double, double>& time_origins) {
  Imf::Header header(exr_box(display_of(window, info)), exr_box(window));
  if (info.uncropped.width > 0) {
    header.insert("originalDataWindow", Imf::Box2iAttribute(exr_box(info.uncropped)));
  }
  Imf::addChromaticities(header, Imf::Chromaticities());  // Rec. 709
  Imf::addFramesPerSecond(header, Imf::Rational(info.rate));
  header.insert("imageCounter", Imf::IntAttribute(info.number));
  add_time_code(header, info);
  add_exposure(header, info);
  add_screen(header, pose, display_of(window, info));
  const auto [to_camera, to_ndc] = matrices(pose, window, info);
  Imf::addWorldToCamera(header, to_camera);
  Imf::addWorldToNDC(header, to_ndc);
  const Vec3 velocity =
      Boost<in::Camera, in::World>(pose.world_from_camera.inverse()).velocity().beta();
  header.insert("cameraVelocity",
                Imf::V3dAttribute(Imath::V3d(velocity.x, velocity.y, velocity.z)));
  header.insert("cameraTime", Imf::DoubleAttribute(info.camera_time));
  header.insert("pictureNumber", Imf::IntAttribute(info.number));
  header.insert("depthType", Imf::StringAttribute("distance"));
  header.insert("timeOrigin", Imf::StringAttribute(fmt::format(
                                  "{:.17g} {:.17g}", time_origins.first, time_origins.second)));
  header.insert("objectNames", Imf::StringVectorAttribute(info.object_names));
  header.insert("materialNames", Imf::StringVectorAttribute(info.material_names));
  header.insert(seal_attribute, Imf::StringAttribute(no_seal));
  return header;
}

void set_compression(Imf::Header& header, Compression compression, double level) {
  header.compression() = exr_compression(compression);
  header.zipCompressionLevel() = 2;  // a sixth faster than the usual 4, and 2% larger
  if (compression != Compression::dwaa && compression != Compression::dwab) return;
  // Some versions of OpenEXR take it from the one, some from the other.
  header.dwaCompressionLevel() = static_cast<float>(level);
  header.insert("dwaCompressionLevel", Imf::FloatAttribute(static_cast<float>(level)));
}

void add_views(Imf::Header& header, const PixelWindow& window, const PictureInfo& info) {
  Imf::StringVector names;
  for (const ViewInfo& view : info.views) names.push_back(view.name);
  Imf::addMultiView(header, names);
  for (std::size_t i = 1; i < info.views.size(); ++i) {
    const auto [to_camera, to_ndc] = matrices(info.views[i].pose, window, info);
    header.insert(names[i] + ".worldToCamera", Imf::M44fAttribute(to_camera));
    header.insert(names[i] + ".worldToNDC", Imf::M44fAttribute(to_ndc));
  }
}

}  // namespace restframe
