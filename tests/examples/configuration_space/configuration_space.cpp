// SPDX-License-Identifier: BSD-3-Clause
// Where can a robot be in a map, and with which heading? Exact at every cell's centre, or safe for whole cells.
//
// What kUsage says. The result (see Job, ResultFile) is the same byte for byte for any number of threads and ranks.
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <thread>

#include "job.h"
#include "result_file.h"
#ifdef CONFIGURATION_SPACE_MPI
#ifdef __linux__
#include <sys/prctl.h>

#include <csignal>
#endif

#include "spread_mpi.h"
#else
#include "spread_threads.h"
#endif

namespace {

using namespace configuration_space;

constexpr const char* kUsage =
    R"(usage: configuration_space map.yaml result [headings 64] [width 512] [height 512] [whole] [threads N] [progress 10]
       mpirun -n 8 configuration_space_mpi map.yaml result ...

The map is one of ROS's map_server. Places and headings are those of the map's own frame, as if its origin were 0, 0, 0.
'whole' asks for cells that are free wherever in them the robot is. Progress is said on a terminal, elsewhere by a line
every so many seconds. An interrupted run leaves result.part, from which the same command goes on. result.pgm is a
picture of four headings.
)";

struct Arguments {
  Arguments(int argc, char** argv) {
    if (argc < 3) throw std::runtime_error(std::string("a map and a result are needed\n") + kUsage);
    map = argv[1];
    result = argv[2];
    for (int i = 3; i < argc; ++i) {
      const std::string key = argv[i];
      if (key == "whole") {
        whole = true;
        continue;
      }
      std::size_t* const number = key == "headings"   ? &size.headings
                                  : key == "width"    ? &size.width
                                  : key == "height"   ? &size.height
                                  : key == "threads"  ? &threads
                                  : key == "progress" ? &progress
                                                      : nullptr;
      if (number == nullptr)
        throw std::runtime_error("'" + key + "' is none of headings, width, height, whole, threads, progress");
      std::istringstream in(i + 1 < argc ? argv[++i] : "");
      if (!(in >> *number) || !in.eof() || *number < 1 || *number > 65536)
        throw std::runtime_error(key + ": it must be a number from 1 to 65536");
    }
  }

  std::string map, result;
  Size size;
  bool whole = false;
  std::size_t threads = std::max(1u, std::thread::hardware_concurrency()), progress = 10;
};

/// The share that is free, and result.pgm: four headings side by side, white where the robot is free.
void describe(const Job& job, const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(job.header().size()));
  const Size& size = job.size();
  const std::size_t shown = std::min<std::size_t>(4, size.headings);
  std::string row(job.rowBytes(), '\0'), picture(shown * size.width * size.height, '\0');
  std::size_t free = 0;
  for (std::size_t heading = 0; heading < size.headings; ++heading) {
    const std::size_t place = heading * shown / size.headings;
    const bool is_shown = heading == (place * size.headings + shown - 1) / shown;
    for (std::size_t y = 0; y < size.height; ++y) {
      in.seekg(static_cast<std::streamoff>(job.header().size() + job.rowAt(heading, y)));
      in.read(row.data(), static_cast<std::streamsize>(row.size()));
      for (std::size_t x = 0; x < size.width; ++x) {
        const bool collides = (row[x / 8] >> x % 8 & 1) != 0;
        free += !collides;
        if (is_shown)
          picture[((size.height - 1 - y) * shown + place) * size.width + x] = static_cast<char>(collides ? 64 : 255);
      }
    }
  }
  std::ofstream out(path + ".pgm", std::ios::binary);
  out << "P5\n" << shown * size.width << " " << size.height << "\n255\n" << picture;
  if (!in || !out.flush()) throw std::runtime_error("can't read " + path + " or write " + path + ".pgm");
  std::cout << free << " of " << size.headings * size.width * size.height << " configurations are free\n";
}

void run(int argc, char** argv, int rank) {
  const Arguments arguments(argc, argv);
  const Job job(arguments.map, arguments.size, arguments.whole);
#ifdef CONFIGURATION_SPACE_MPI
  agreeOn(job);
  if (rank > 0) return work(job);
#endif
  ResultFile result(job, arguments.result);
  if (result.left().size() < job.chunks())
    std::cout << "goes on: " << job.chunks() - result.left().size() << " of " << job.chunks() << " chunks are there\n";
  Progress progress(result.missing(), job.chunks(), static_cast<double>(arguments.progress));
#ifdef CONFIGURATION_SPACE_MPI
  Dispatcher dispatcher(job, result);
  dispatcher.run(progress);
  result.finish();
  dispatcher.dismiss();
#else
  (void)rank;
  spread(job, result, progress, arguments.threads);
  result.finish();
#endif
  describe(job, arguments.result);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && argv[1] == std::string("--help")) {
    std::cout << kUsage;
    return 0;
  }
  int rank = 0, status = 0;
#ifdef CONFIGURATION_SPACE_MPI
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // no rank outlives its mpirun, not even one that was killed
#endif
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
#endif
  try {
    run(argc, argv, rank);
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << "\n";
    status = 1;
  }
#ifdef CONFIGURATION_SPACE_MPI
  if (status != 0) MPI_Abort(MPI_COMM_WORLD, status);
  MPI_Finalize();
#endif
  return status;
}
