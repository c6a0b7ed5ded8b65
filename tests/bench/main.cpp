// restframe_bench [CSV]: every speed goal as a ratio against a reference of the same run. Google Benchmark's own
// options work too.

#include <benchmark/benchmark.h>

#include "bench_report.h"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  return restframe::run_and_report(argc > 1 ? argv[1] : "") ? 0 : 1;
}
