#include "io/frame_series.hpp"

#include "io/aside_file.hpp"
#include "io/hdf5_file.hpp"
#include "io/number.hpp"

#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <string_view>

namespace breccia {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMesh = "frames/";
constexpr const char* kMeshList = "frames.vtkhdf.series";

// By SideKind.
struct SideNames {
  const char* prefix;
  const char* list;
};
constexpr SideNames kSides[] = {{"frames/cracks_", "cracks.vtkhdf.series"},
                                {"frames/contacts_", "contacts.vtkhdf.series"}};

// Number of the frame that a file of the folder belongs to, or -1 when it is none of ours.
long frame_number(const std::string& file) {
  std::string_view digits = file;
  for (const std::string_view prefix : {"cracks_", "contacts_"}) {
    if (digits.starts_with(prefix)) digits.remove_prefix(prefix.size());
  }
  const auto end = digits.find(".vtkhdf");
  if (end == std::string_view::npos || end == 0) return -1;
  if (digits.substr(0, end).find_first_not_of("0123456789") != std::string_view::npos) return -1;
  return std::atol(std::string(digits.substr(0, end)).c_str());
}

}  // namespace

FrameSeries::FrameSeries(std::string folder) : FrameSeries(std::move(folder), {}) {}

FrameSeries::FrameSeries(std::string folder, std::vector<double> times)
    : folder_(std::move(folder)), times_(std::move(times)) {
  const std::string frames = (fs::path(folder_) / "frames").string();
  require_hdf5(frames);
  std::error_code trouble;
  fs::create_directories(frames, trouble);
  if (trouble) throw file_error(frames, "create the folder", trouble.value());
  remove_later_frames();
  for (std::size_t side = 0; side < sides_.size(); ++side)
    for (std::size_t k = 0; k < times_.size(); ++k)
      if (fs::exists(name(kSides[side].prefix, k))) sides_[side].push_back(k);
  std::vector<std::size_t> all(times_.size());
  std::iota(all.begin(), all.end(), 0u);
  write_list(kMesh, kMeshList, all);
  for (std::size_t side = 0; side < sides_.size(); ++side)
    if (!sides_[side].empty()) write_list(kSides[side].prefix, kSides[side].list, sides_[side]);
}

std::string FrameSeries::name(const char* prefix, std::size_t number) const {
  std::string digits = std::to_string(number);
  if (digits.size() < 6) digits.insert(0, 6 - digits.size(), '0');
  return (fs::path(folder_) / (prefix + digits + ".vtkhdf")).string();
}

void FrameSeries::remove_later_frames() const {
  std::vector<fs::path> later;
  for (const auto& entry : fs::directory_iterator(fs::path(folder_) / "frames")) {
    const long number = frame_number(entry.path().filename().string());
    if (number >= static_cast<long>(times_.size())) later.push_back(entry.path());
  }
  std::error_code trouble;
  for (const fs::path& path : later) {
    if (!fs::remove(path, trouble) && trouble)
      throw file_error(path.string(), "remove", trouble.value());
  }
  // Written again when there is something to list.
  for (const SideNames& side : kSides) fs::remove(fs::path(folder_) / side.list, trouble);
}

void FrameSeries::write_list(const char* prefix, const char* list,
                             const std::vector<std::size_t>& numbers) const {
  std::string text = "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [";
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const fs::path path = name(prefix, numbers[i]);
    text += i == 0 ? "\n" : ",\n";
    text += "    {\"name\": \"frames/" + path.filename().string() + "\", \"time\": ";
    append_number(text, times_[numbers[i]]);
    text += "}";
  }
  text += "\n  ]\n}\n";
  write_whole((fs::path(folder_) / list).string(), text);
}

void FrameSeries::write(const Frame& frame, const std::vector<SideFrame>& sides) {
  const std::size_t number = times_.size();
  const auto index = [](const SideFrame& side) { return static_cast<std::size_t>(side.kind); };
  try {
    for (const SideFrame& side : sides)
      write_frame(name(kSides[index(side)].prefix, number), side.frame);
    write_frame(name(kMesh, number), frame);
  } catch (const Error&) {  // cracks without their mesh would be half a frame
    std::error_code ignored;
    for (const SideFrame& side : sides)
      fs::remove(name(kSides[index(side)].prefix, number), ignored);
    throw;
  }
  times_.push_back(frame.time);
  std::vector<std::size_t> all(times_.size());
  std::iota(all.begin(), all.end(), 0u);
  write_list(kMesh, kMeshList, all);
  for (const SideFrame& side : sides) {
    sides_[index(side)].push_back(number);
    write_list(kSides[index(side)].prefix, kSides[index(side)].list, sides_[index(side)]);
  }
}

}  // namespace breccia
