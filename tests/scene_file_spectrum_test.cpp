// Spectra in scene files: [render]'s doppler and observe, temperatures, measured spectra, lines.

#include <gmock/gmock.h>

#include "support/scene_reading.h"

namespace restframe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::string kPaint = "[[object]]\nasset = \"paint.obj\"\n[[material]]\nname = \"paint\"\n";
const std::string kLamp =
    "[render]\nintegrator = \"path\"\n[[object]]\nsphere = {fineness = 0}\n[[light]]\ntype = "
    "\"point\"\n";

class SceneFileSpectrum : public SceneReading {
 protected:
  Material paint(const std::string& keys) {
    const Scene scene = read(kPaint + keys);
    return scene.materials.at(static_cast<std::size_t>(scene.objects.at(0).materials.at(0)));
  }
  // One fault, at that line, with all of the words.
  void expect_fault(const std::string& text, const std::string& line,
                    const std::vector<std::string>& words) {
    const std::vector<std::string> lines = faults(text);
    ASSERT_THAT(lines, SizeIs(1)) << text;
    EXPECT_THAT(lines[0], ::testing::StartsWith(line + ":"));
    for (const std::string& word : words) EXPECT_THAT(lines[0], HasSubstr(word));
  }
};

TEST_F(SceneFileSpectrum, DopplerAndBand) {
  EXPECT_FALSE(read(kPaint).render.doppler);
  EXPECT_TRUE(read("[render]\ndoppler = true\n" + kPaint).render.doppler);
  const Scene scene =
      read("[render]\nobserve = {from = 2000, to = 4000}\ndoppler = true\n" + kPaint);
  ASSERT_TRUE(scene.render.observe);
  EXPECT_EQ(scene.render.observe->from, 2000);
  EXPECT_EQ(scene.render.observe->to, 4000);
}

TEST_F(SceneFileSpectrum, BandsHaveFaults) {
  const auto band = [&](const std::string& text, const std::vector<std::string>& words) {
    expect_fault("[render]\ndoppler = true\nobserve = " + text + "\n" + kPaint, "3", words);
  };
  band("{from = 4000, to = 2000}", {"observe", "to must be above from"});
  band("{from = 5, to = 2000}", {"observe: from is 5, must be from 10 to 100000"});
  band("{from = 500}", {"to is missing"});
  band("{from = 500, to = 600, til = 3}", {"unknown key \"til\"", "\"to\""});
  band("[500, 600]", {"observe is an array, must be a table"});
  expect_fault("[render]\nobserve = {from = 500, to = 600}\n" + kPaint, "2",
               {"observe needs doppler = true"});
}

TEST_F(SceneFileSpectrum, LightsHaveTemperatures) {
  const Light light = read(kLamp + "temperature = 5800\n").lights.at(0);
  EXPECT_EQ(light.temperature.value, 5800.0F);
  EXPECT_EQ(light.color.value, Vec3f(1));
  const Scene changing = read(kLamp + "temperature = {keys = [[0, 1000], [1, 9000]]}\n");
  EXPECT_EQ(changing.lights.at(0).temperature.function, 0);
  EXPECT_THAT(changing.functions, SizeIs(1));
}

TEST_F(SceneFileSpectrum, LightsHaveSpectraAndLines) {
  const Light light = read(kLamp +
                           "spectrum = [[400, 0.5], [500, 1], [500, 2]]\ncolor = \"red\"\n"
                           "lines = [[656.28, 3], [486.13, 1, 0.2]]\n")
                          .lights.at(0);
  ASSERT_THAT(light.spectrum.points, SizeIs(3));
  EXPECT_EQ(light.spectrum.points[2].wavelength, 500);
  EXPECT_EQ(light.spectrum.points[2].value, 2);
  ASSERT_THAT(light.spectrum.lines, SizeIs(2));
  EXPECT_FLOAT_EQ(light.spectrum.lines[0].wavelength, 656.28F);
  EXPECT_EQ(light.spectrum.lines[0].power, 3);
  EXPECT_EQ(light.spectrum.lines[0].width, 1);
  EXPECT_EQ(light.spectrum.lines[1].width, 0.2F);
  EXPECT_EQ(light.color.value, Vec3f(1, 0, 0));
}

TEST_F(SceneFileSpectrum, SpectraComeFromCsv) {
  folder.write("lamp.csv", "nm, lamp, other\n400, 1, 7\n# a remark\n450, 2.5, 8\n");
  const auto points = [&](const std::string& table) {
    return read(kLamp + "spectrum = " + table + "\n").lights.at(0).spectrum.points;
  };
  const auto first = points("{file = \"lamp.csv\"}");
  ASSERT_THAT(first, SizeIs(2));
  EXPECT_EQ(first[1].wavelength, 450);
  EXPECT_EQ(first[1].value, 2.5F);
  const auto other = points("{file = \"lamp.csv\", column = \"other\", wavelength = \"nm\"}");
  EXPECT_EQ(other.at(0).value, 7);
  EXPECT_THAT(read(kLamp + "spectrum = {file = \"lamp.csv\"}\n").sources,
              SizeIs(::testing::Ge(1U)));
}

TEST_F(SceneFileSpectrum, CsvHasFaults) {
  const auto csv = [&](const std::string& content, const std::string& word) {
    folder.write("lamp.csv", content);
    const std::vector<std::string> lines = faults(kLamp + "spectrum = {file = \"lamp.csv\"}\n");
    ASSERT_THAT(lines, SizeIs(1)) << content;
    EXPECT_THAT(lines[0], HasSubstr(word));
  };
  csv("nm,v\n400,1\n390,2\n", "3:1: the wavelength is 390, must be at least that of the point");
  csv("nm,v\n400,x\n500,1\n", "2:5: the value");
  csv("nm,v\n400,-1\n500,1\n", "2:5: the value is -1, must be from 0");
  csv("nm\n400\n", "there is one column, must be two");
  csv("nm,v\n", "has no points");
  csv("nm,v\n400,0\n500,0\n", "0 everywhere");
  expect_fault(kLamp + "spectrum = {file = \"none.csv\"}\n", "7", {"none.csv"});
  expect_fault(kLamp + "spectrum = {column = \"v\"}\n", "7", {"file is missing"});
}

TEST_F(SceneFileSpectrum, LightsHaveFaults) {
  const auto light = [&](const std::string& keys, const std::vector<std::string>& words) {
    expect_fault(kLamp + keys + "\n", "7", words);
  };
  light("temperature = 20", {"temperature is 20, must be from 500 to 100000000"});
  light("temperature = \"hot\"", {"temperature is a text, must be a number"});
  light("spectrum = []", {"must be an array of [wavelength, value]"});
  light("spectrum = [[400, 1], [300, 1]]", {"the wavelength is 300, must be at least"});
  light("spectrum = [[400, 1]]", {"0 everywhere"});
  light("lines = [[656]]", {"must be [wavelength, power] or [wavelength, power, width]"});
  light("lines = [[656, -1]]", {"the power is -1"});
  light("lines = [[656, 1, 0]]", {"the width is 0"});
  light("lines = [[1, 1]]", {"the wavelength is 1, must be from 10 to 100000"});
  const auto both = faults(kLamp + "temperature = 5000\nspectrum = [[400, 1], [500, 1]]\n");
  ASSERT_THAT(both, SizeIs(1));
  EXPECT_THAT(both[0], HasSubstr("exclude"));
}

// Lines, a spectrum or a temperature take the place of an asset's colour, and `emission` beside them
// is a filter.
TEST_F(SceneFileSpectrum, MaterialsGlow) {
  const Material plain = paint("emission = \"red\"\n");
  EXPECT_FALSE(has_own_spectrum(plain.emission_temperature, plain.emission_spectrum));
  const Material hot = paint("emission_temperature = 2000\n");
  EXPECT_EQ(hot.emission_temperature.value, 2000);
  EXPECT_EQ(hot.emission.value, Vec3f(1));
  const Material neon = paint("emission_lines = [[585.25, 1]]\nemission = \"red\"\n");
  ASSERT_THAT(neon.emission_spectrum.lines, SizeIs(1));
  EXPECT_EQ(neon.emission.value, Vec3f(1, 0, 0));
  const Material lamp = paint("emission_spectrum = [[400, 1], [700, 2]]\n");
  EXPECT_THAT(lamp.emission_spectrum.points, SizeIs(2));
  // In the gaps of a function something holds, too.
  const Material blinking = paint("emission_temperature = {intervals = [[0, 1, 3000]]}\n");
  EXPECT_EQ(blinking.emission_temperature.function, 0);
  EXPECT_EQ(blinking.emission_temperature.value, 6504);
}

TEST_F(SceneFileSpectrum, LaterChangesReplaceSpectra) {
  const std::string again = "[[material]]\nname = \"pai*\"\n";
  const Material hot =
      paint("emission_spectrum = [[400, 1], [700, 2]]\n" + again + "emission_temperature = 900\n");
  EXPECT_THAT(hot.emission_spectrum.points, IsEmpty());
  EXPECT_EQ(hot.emission_temperature.value, 900);
  const Material lamp = paint("emission_temperature = 900\nemission_lines = [[500, 1]]\n" + again +
                              "emission_spectrum = [[400, 1], [700, 2]]\n");
  EXPECT_EQ(lamp.emission_temperature.value, 0);
  EXPECT_THAT(lamp.emission_spectrum.lines, SizeIs(1));
}

TEST_F(SceneFileSpectrum, MaterialsHaveFaults) {
  expect_fault(kPaint + "emission_temperature = 3\n", "5", {"emission_temperature is 3"});
  expect_fault(kPaint + "emission_line = [[500, 1]]\n", "5", {"\"emission_lines\""});
  expect_fault(kPaint + "emission_spectrum = 3\n", "5", {"emission_spectrum"});
}

TEST(Spectrum, IsCheckedInScenesOfPrograms) {
  const auto fault = [](const EmissionSpectrum& spectrum, float kelvin) {
    const auto faults = spectrum_faults({kelvin}, spectrum);
    return faults.empty() ? "" : faults.front();
  };
  EXPECT_EQ(fault({}, 0), "");
  EXPECT_EQ(fault({{{400, 1}, {500, 1}}, {{600, 1, 1}}}, 0), "");
  EXPECT_THAT(fault({}, 20), HasSubstr("the temperature is 20"));
  EXPECT_THAT(fault({{{400, 1}, {500, 1}}, {}}, 3000), HasSubstr("exclude"));
  EXPECT_THAT(fault({{{5, 1}, {500, 1}}, {}}, 0), HasSubstr("point 0"));
  EXPECT_THAT(fault({{{400, -1}, {500, 1}}, {}}, 0), HasSubstr("is -1"));
  EXPECT_THAT(fault({{{400, 1}, {300, 1}}, {}}, 0), HasSubstr("shorter"));
  EXPECT_THAT(fault({{}, {{600, 1, 0}}}, 0), HasSubstr("width of line 0"));
  EXPECT_THAT(fault({{}, {{600, -1, 1}}}, 0), HasSubstr("power of line 0"));
  EXPECT_THAT(fault({{}, std::vector<EmissionLine>(300, {600, 1, 1})}, 0), HasSubstr("300 lines"));
  EXPECT_THAT(fault({std::vector<SpectrumPoint>(10'001, {600, 1}), {}}, 0),
              HasSubstr("10001 points"));
  EXPECT_THAT(band_faults({500, 500}), SizeIs(1));
  EXPECT_THAT(band_faults({500, 1000}), IsEmpty());
}

}  // namespace
}  // namespace restframe
