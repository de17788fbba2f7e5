#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace breccia {

/// What `breccia batch` was asked for.
struct BatchRequest {
  std::filesystem::path sweep;
  std::vector<std::string> options;             ///< "key.path=value" of each --set
  std::optional<std::filesystem::path> output;  ///< otherwise `<sweep name>.batch`
  std::string program;                          ///< the executable that variants run
  int threads = 0;                              ///< of each variant; 0: as the sweep says
  int jobs = 0;                                 ///< at a time; 0: as many as the machine bears
  std::vector<std::size_t> variants;            ///< run these alone, once; empty: all
  bool list = false;                            ///< say which variants there are; run none
  bool slurm = false;                           ///< hand them to Slurm
  bool collect = false;                         ///< summary of what is there
  bool dry_run = false;                         ///< write the script, submit nothing
  bool overwrite = false;                       ///< run variants anew that have changed
  bool quiet = false;
};

/// A key with its values, one for each step of an axis.
struct Varied {
  std::string name;                 ///< for tables
  std::vector<std::string> paths;   ///< of the keys that take the value
  std::vector<std::string> values;  ///< as --set takes them
  std::vector<std::string> words;   ///< as people see them
  std::size_t axis = 0;
  std::string key_place, values_place;  ///< lines of the sweep
};

/// What varies independently of the rest: one key, several together, or the samples.
struct Axis {
  std::size_t length = 1;
  std::size_t stride = 1;  ///< variants from one step to the next
};

struct Variant {
  std::size_t number = 0;
  std::string folder;  ///< "0007"
  std::string label;   ///< "strength 7 MPa, seed 3"
  std::vector<std::string> options;
  std::string identity;  ///< changes with anything that changes the result; empty: not resolved
};

/// A quantity of the summary.
struct Collected {
  std::string name, formula;
};

struct SlurmWishes {
  int variants_per_task = 1;
  std::string partition;
  std::vector<std::string> options, setup;
};

struct Sweep {
  std::string name;
  std::filesystem::path file, scene, output;
  std::vector<Axis> axes;  ///< the first varies slowest
  std::vector<Varied> varied;
  std::vector<Variant> variants;
  std::vector<Collected> collect;
  std::string collect_place;
  std::string program;
  int threads = 1, ranks = 1, side_by_side = 1;
  std::optional<double> time_limit;
  SlurmWishes slurm;

  /// The step of an axis at which a variant stands.
  [[nodiscard]] std::size_t step(const Variant& variant, std::size_t axis) const {
    return variant.number / axes[axis].stride % axes[axis].length;
  }
  [[nodiscard]] std::filesystem::path folder(std::size_t variant) const {
    return output / variants[variant].folder;
  }
};

/// Reads a sweep and resolves its variants (or those that are asked for) exactly as
/// `breccia run --set` would. \throws Error for whatever is wrong, before anything runs.
Sweep plan_batch(const BatchRequest& request);

}  // namespace breccia
