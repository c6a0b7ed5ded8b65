# Two Debian packages, by `cpack --config build/release/CPackConfig.cmake`: restframe, the program, and
# librestframe-dev, the libraries. tests/package.sh makes and tries them.
set(RESTFRAME_MAINTAINER "restframe contributors <restframe@packages.invalid>" CACHE STRING
  "Who answers for the Debian packages: NAME <ADDRESS>")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME restframe)
set(CPACK_PACKAGE_VENDOR restframe)
set(CPACK_PACKAGE_CONTACT ${RESTFRAME_MAINTAINER})
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/debian)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL restframe dev)
set(packages restframe librestframe-dev)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_RESTFRAME_PACKAGE_NAME restframe)
set(CPACK_DEBIAN_RESTFRAME_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_RESTFRAME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RESTFRAME_PACKAGE_SUGGESTS "ffmpeg, blender, slurm-client")
set(CPACK_COMPONENT_RESTFRAME_DESCRIPTION
"pictures of things that move close to the speed of light
restframe renders 3D assets as a camera would record them while they move
close to the speed of light: rays take their time, moving clocks run slow,
straight rods are seen bent and passing things from behind.

It reads glTF, OBJ, PLY, STL and OFF, and writes OpenEXR animations whose
layers tell a compositor where and when the light of each pixel set out.")
if(RESTFRAME_ARCH STREQUAL "x86-64-v3")
  string(APPEND CPACK_COMPONENT_RESTFRAME_DESCRIPTION "\n\nIt needs a processor with AVX2.")
endif()

# Whoever links the libraries links theirs, too: those that restframe-config.cmake looks for.
set(CPACK_DEBIAN_DEV_PACKAGE_NAME librestframe-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
string(JOIN ", " CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
  libglm-dev "libembree-dev (>= 3.12)" libtbb-dev "libopenexr-dev (>= 3.1)" nlohmann-json3-dev libdraco-dev
  libmeshoptimizer-dev libopenmesh-dev libfmt-dev libspdlog-dev libmuparser-dev libcli11-dev
  libtomlplusplus-dev)
set(CPACK_COMPONENT_DEV_DESCRIPTION
"libraries that render things close to the speed of light
The static libraries and headers of restframe, a ray tracer for things that
move close to the speed of light, and a CMake package that finds them:
find_package(restframe), then link restframe::restframe.")

# A package's own folder of documents tells of the packaging, too.
execute_process(COMMAND date -u -R -d ${release_date} OUTPUT_VARIABLE release_day
  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
foreach(component name IN ZIP_LISTS CPACK_COMPONENTS_ALL packages)
  configure_file(debian_changelog.in ${name}/changelog.Debian @ONLY)
  compressed(${CMAKE_CURRENT_BINARY_DIR}/${name}/changelog.Debian changelog.Debian ${component} ${doc}/${name})
endforeach()

include(CPack)
