#include "io/checkpoint.hpp"

#include "io/digest.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <stdexcept>

namespace breccia {
namespace {

constexpr std::size_t kHeader = 512;  // HDF5's smallest user block
constexpr std::string_view kMagic = "Breccia checkpoint\n";
constexpr std::int64_t kFormat = 1;
constexpr const char* kStartAgain = "start again with --overwrite";

// Everything the header says, and the checksum of that. These lines are the same in every format to
// come.
std::string header_text(std::int64_t format, std::uint64_t bytes, const std::string& digest) {
  std::string text(kMagic);
  text += "format " + std::to_string(format) + "\nbytes " + std::to_string(bytes) + "\ndigest " +
          digest + "\n";
  text += "header " + fingerprint(text) + "\n";
  text.resize(kHeader, '\0');
  return text;
}

struct Content {
  std::uint64_t bytes = 0;
  std::string digest;
};

// Length of the file, and checksum of what follows the header.
Content measure(const std::string& path, const std::string& shown) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw file_error(shown, "open the checkpoint", errno);
  file.seekg(kHeader);
  Content content{kHeader, {}};
  Digest digest;
  std::vector<char> buffer(std::size_t{1} << 20);
  while (file) {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    const auto n = static_cast<std::size_t>(file.gcount());
    digest.update(buffer.data(), n);
    content.bytes += n;
  }
  if (file.bad()) throw file_error(shown, "read the checkpoint", errno);
  content.digest = hex16(digest.value());
  return content;
}

// The word after `key` on its own line of the header; empty when there is none.
std::string_view field(std::string_view header, std::string_view key) {
  std::string lead = "\n";
  lead.append(key).append(" ");
  const auto line = header.find(lead);
  if (line == std::string_view::npos) return {};
  const auto start = line + lead.size();
  return header.substr(start, header.find('\n', start) - start);
}

std::int64_t number(std::string_view text) {
  std::int64_t value = -1;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

[[noreturn]] void refuse_damaged(const std::string& path, const std::string& how) {
  throw Error(path, "the checkpoint is damaged (" + how + ")",
              std::string("restore it from a copy, or ") + kStartAgain);
}

[[noreturn]] void refuse_truncated(const std::string& path, std::uint64_t has,
                                   const std::string& needs) {
  throw Error(
      path,
      "the checkpoint is truncated: it has " + std::to_string(has) + " of " + needs + " bytes",
      std::string("restore it from a copy, or ") + kStartAgain);
}

std::string read_header(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw file_error(path, "open the checkpoint", errno);
  std::string header(kHeader, '\0');
  file.read(header.data(), kHeader);
  header.resize(static_cast<std::size_t>(file.gcount()));
  const std::size_t known = std::min(header.size(), kMagic.size());
  if (header.substr(0, known) != kMagic.substr(0, known)) {
    throw Error(path, "this is not a checkpoint of Breccia",
                std::string("give the folder of an interrupted run, or ") + kStartAgain);
  }
  if (header.size() < kHeader) refuse_truncated(path, header.size(), "at least 512");
  return header;
}

// Refuses whatever is not, byte for byte, what a writer of this format published; returns the path.
const std::string& checked(const std::string& path) {
  require_hdf5(path);
  const std::string header = read_header(path);
  const std::int64_t format = number(field(header, "format")),
                     bytes = number(field(header, "bytes"));
  const std::string digest(field(header, "digest"));
  if (header != header_text(format, static_cast<std::uint64_t>(bytes), digest)) {
    refuse_damaged(path, "its header does not fit its own checksum");
  }
  if (format > kFormat) {
    throw Error(path,
                "the checkpoint was written by a newer version of Breccia (format " +
                    std::to_string(format) + "; this one reads up to " + std::to_string(kFormat) +
                    ")",
                std::string("restart with that version, or ") + kStartAgain);
  }
  const Content found = measure(path, path);
  if (found.bytes < static_cast<std::uint64_t>(bytes)) {
    refuse_truncated(path, found.bytes, std::to_string(bytes));
  }
  if (found.bytes > static_cast<std::uint64_t>(bytes))
    refuse_damaged(path, "it is longer than it was written");
  if (found.digest != digest) refuse_damaged(path, "its content does not fit its checksum");
  return path;
}

}  // namespace

CheckpointWriter::CheckpointWriter(const std::string& path, const CheckpointIdentity& identity)
    : path_(path), file_(path, kHeader) {
  file_.group("state");
  file_.attribute("", "scene", identity.scene);
  file_.attribute("", "build", identity.build);
}

void CheckpointWriter::put(const std::string& name, const ArrayView& array) {
  file_.write("state/" + name, array);
}

void CheckpointWriter::put_number(const std::string& name, double value) {
  put(name, std::array{value});
}

void CheckpointWriter::put_number(const std::string& name, std::int64_t value) {
  put(name, std::array{value});
}

void CheckpointWriter::put_text(const std::string& name, std::string_view text) {
  file_.write_text("state/" + name, text);
}

void CheckpointWriter::seal() {
  if (sealed_) return;
  file_.seal();
  const Content content = measure(file_.part(), path_);
  const std::string header = header_text(kFormat, content.bytes, content.digest);
  std::fstream file(file_.part(), std::ios::binary | std::ios::in | std::ios::out);
  file.write(header.data(), static_cast<std::streamsize>(header.size()));
  file.close();
  if (!file) throw file_error(path_, "write the checkpoint", errno);
  sealed_ = true;
}

void CheckpointWriter::commit() {
  seal();
  file_.commit();
}

CheckpointReader::CheckpointReader(const std::string& path, const CheckpointIdentity& expected)
    : file_(checked(path)) {
  const std::string scene = file_.text_attribute("", "scene"),
                    build = file_.text_attribute("", "build");
  if (scene != expected.scene) {
    throw Error(
        path,
        "the checkpoint belongs to another scene (" + scene + ", this one is " + expected.scene +
            ")",
        std::string(
            "restart with the scene of the interrupted run (scene.toml in its folder), or ") +
            kStartAgain);
  }
  if (build != expected.build) {
    throw Error(path,
                "the checkpoint was written by another build of Breccia (" + build +
                    ", this one is " + expected.build + ")",
                std::string("restart with that build, or ") + kStartAgain);
  }
}

void CheckpointReader::check_count(const std::string& name, std::size_t count) const {
  const std::size_t stored = info(name).count();
  if (stored == count) return;
  throw Error(file_.path(),
              "'" + name + "' has " + std::to_string(stored) + " values, " + std::to_string(count) +
                  " are expected",
              kStartAgain);
}

double CheckpointReader::real(const std::string& name) const {
  double value = 0;
  array(name, std::span(&value, 1));
  return value;
}

std::int64_t CheckpointReader::integer(const std::string& name) const {
  std::int64_t value = 0;
  array(name, std::span(&value, 1));
  return value;
}

std::string CheckpointReader::text(const std::string& name) const {
  return file_.read_text("state/" + name);
}

}  // namespace breccia
