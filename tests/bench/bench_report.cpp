#include "bench_report.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <utility>
#include <vector>

#include "bench_scene.h"
#include "memory_bench.h"
#include "split_glb.h"

namespace restframe {
namespace {

constexpr Target targets[] = {
    {"preview over bare Embree, at rest", "bare_at_rest", "preview_at_rest", 0.75, true},
    {"preview over bare Embree, 0.99c", "bare_moving", "preview_moving", 0.7, true},
    {"motion blur over none, 16 samples", "preview_blurred", "preview_sampled", 1.2, false},
    {"shadowed point light over preview", "light_shadowed", "light_none", 2.2, false},
    {"reading and building over bare build", "read_and_build", "bare_build", 2.0, false},
    {"reading OBJ and building over bare build", "read_obj_and_build", "bare_build", 4.0, false},
    {"animation over its renderings", "animation", "renderings", 1.1, false},
};

// Keeps every repetition's time, and shows what the console shows.
class Collector : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type == Run::RT_Iteration && !run.error_occurred) {
        const std::string name = run.run_name.function_name;
        times_[name].push_back(run.real_accumulated_time / static_cast<double>(run.iterations));
      }
    }
    ConsoleReporter::ReportRuns(runs);
  }

  double median(const std::string& name) const {
    const auto found = times_.find(name);
    if (found == times_.end()) return 0.0;
    std::vector<double> sorted = found->second;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }

 private:
  std::map<std::string, std::vector<double>> times_;
};

std::string row(const std::string& name, double a, double b, double ratio, double goal,
                bool at_least) {
  return fmt::format("{},{:.5g},{:.5g},{:.3f},{} {}\n", name, a, b, ratio,
                     at_least ? "at least" : "at most", goal);
}

}  // namespace

bool run_and_report(const std::string& csv_path) {
  std::string imports;
  {
    const BenchFile file;
    const std::string shared = file.folder() + "/shared.glb";
    split_glb(file.glb(), shared, 2);  // two take the most
    for (const auto& [name, path] :
         {std::pair("GLB", file.glb()), std::pair("GLB of shared vertices", shared),
          std::pair("OBJ", file.obj())}) {
      const ImportMemory use = measure_import(path);
      imports +=
          row(fmt::format("memory while importing {} over what is kept", name), use.peak_megabytes,
              use.kept_megabytes, use.peak_megabytes / use.kept_megabytes, 2.5, false);
    }
  }
  const MemoryUse memory = measure_memory();
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  std::string table = "what,numerator (s or MB),denominator (s or MB),ratio,goal\n";
  bool complete = true;
  for (const Target& target : targets) {
    const double a = collector.median(target.numerator);
    const double b = collector.median(target.denominator);
    complete = complete && a > 0.0 && b > 0.0;
    if (a > 0.0 && b > 0.0) {
      table += row(target.name, a, b, a / b, target.goal, target.at_least);
    }
  }
  table +=
      row("peak memory over vertices plus indices plus Embree", memory.peak_megabytes,
          memory.needed_megabytes, memory.peak_megabytes / memory.needed_megabytes, 1.5, false);
  table += imports;
  fmt::print("\n{}", table);
  if (!csv_path.empty()) std::ofstream(csv_path) << table;
  return complete;
}

}  // namespace restframe
