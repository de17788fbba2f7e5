#include "app/info.hpp"

#include "core/build_info.hpp"

#include <Kokkos_Core.hpp>

#include <thread>

namespace breccia {

namespace {

std::string row(const std::string& word, std::string_view value) {
  constexpr std::size_t width = 18;
  std::string line = "  " + word;
  line.resize(width, ' ');
  return line.append(value) + "\n";
}

template <class Space>
std::string space_row() {
  const Space space;
  return row(Space::name(),
             "concurrency " + std::to_string(space.concurrency()) +
                 (std::is_same_v<Space, Kokkos::DefaultExecutionSpace> ? ", runs the loops" : ""));
}

std::string backends() {
  std::string text;
#ifdef KOKKOS_ENABLE_SERIAL
  text += space_row<Kokkos::Serial>();
#endif
#ifdef KOKKOS_ENABLE_OPENMP
  text += space_row<Kokkos::OpenMP>();
#endif
#ifdef KOKKOS_ENABLE_CUDA
  text += space_row<Kokkos::Cuda>();
#endif
#ifdef KOKKOS_ENABLE_HIP
  text += space_row<Kokkos::HIP>();
#endif
#ifdef KOKKOS_ENABLE_SYCL
  text += space_row<Kokkos::SYCL>();
#endif
  return text;
}

}  // namespace

std::string version_line() {
  const BuildInfo& build = build_info();
  return "breccia " + std::string(build.version) + " (" + std::string(build.commit) + ")";
}

std::string info_text() {
  const BuildInfo& build = build_info();
  std::string text = version_line() + "\n\nbuild\n";
  text += row("compiler", build.compiler);
  text += row("type", build.build_type);
  text += row("processor", build.arch);
  text += row("flags", build.flags);
  text += "\nbackends, Kokkos " + std::string(build.kokkos) + "\n" + backends();
  text += row("devices", std::to_string(Kokkos::num_devices() > 0 ? Kokkos::num_devices() : 0));
  text += row("processors", std::to_string(std::thread::hardware_concurrency()));
  text += "\noptional parts\n";
  text += row("MPI", build.mpi);
  text += row("HDF5", build.hdf5);
  text += row("METIS", build.metis);
  text += row("Gmsh", build.gmsh);
  return text;
}

}  // namespace breccia
