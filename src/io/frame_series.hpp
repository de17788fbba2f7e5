#pragma once

#include "io/vtkhdf.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace breccia {

/// Data sets beside the mesh, each with files and a series of its own.
enum class SideKind : std::uint8_t { cracks, contacts };
struct SideFrame {
  SideKind kind;
  Frame frame;
};

/// The frames of a run: `frames/NNNNNN.vtkhdf` with `frames.vtkhdf.series` (the list ParaView
/// opens), and, where the run has interfaces or contact, `frames/cracks_NNNNNN.vtkhdf` with
/// `cracks.vtkhdf.series` and `frames/contacts_NNNNNN.vtkhdf` with `contacts.vtkhdf.series`. A
/// frame enters the lists only when all of it is whole on the disk. All functions throw Error (disk
/// full, no permission, no HDF5 in this build).
class FrameSeries {
 public:
  /// Starts a new series in the run folder `folder`.
  explicit FrameSeries(std::string folder);

  /// Goes on after a checkpoint that had written frames at `times` [s]: later frames are removed
  /// and written again.
  FrameSeries(std::string folder, std::vector<double> times);

  void write(const Frame& frame, const std::vector<SideFrame>& sides = {});

  /// What a checkpoint keeps of the series.
  [[nodiscard]] const std::vector<double>& times() const { return times_; }

 private:
  [[nodiscard]] std::string name(const char* prefix, std::size_t number) const;
  void remove_later_frames() const;
  void write_list(const char* prefix, const char* list,
                  const std::vector<std::size_t>& numbers) const;

  std::string folder_;
  std::vector<double> times_;
  std::array<std::vector<std::size_t>, 2> sides_;  ///< per kind: frames that have such a file
};

}  // namespace breccia
