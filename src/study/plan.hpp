#pragma once

#include "core/settings.hpp"
#include "study/measures.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace breccia {

/// What `breccia study` was asked for.
struct StudyRequest {
  std::filesystem::path scene;
  std::vector<std::string> options;             ///< "key.path=value" of each --set
  std::optional<std::filesystem::path> output;  ///< otherwise `<scene name>.study`
  std::string program;                          ///< the executable that jobs run
  int threads = 1;                              ///< of every job
  int repeats = 0;                              ///< 0: as the scene says
  int jobs = 1;                                 ///< that run side by side
  bool list = false;                            ///< say what would run, and run nothing
  bool quiet = false;
};

struct Knob {
  std::string name;
  std::vector<std::string> paths;  ///< of the keys that take the value
  std::vector<std::string> rungs;  ///< as --set takes them
  std::vector<std::string> words;  ///< as people see them
  std::vector<double> sizes;       ///< falling; empty where the rungs are words
};

/// A quantity with what it is held against.
struct Judged {
  enum class Against { value, finest, curve };
  std::string name, value, source;
  std::string check;  ///< name of the [[check]] it is, if it is one
  Against against = Against::value;
  std::string reference;  ///< an expression, evaluated in each job
  std::string scale;      ///< likewise; empty: the size of the reference
  std::string curve_x;    ///< column that the table's first one stands for
  Curve table;
};

/// One run of the ladder.
struct Job {
  std::vector<int> rung;  ///< of each knob; -1: as in the scene
  std::string label;      ///< "mesh size 2 mm, element tri3"
  std::string folder;     ///< "003_size_2_mm-element_tri3"
  std::vector<std::string> options;
  std::size_t same_as = 0;  ///< index of the first job that is the same scene; its own as a rule
  std::string identity;     ///< changes with anything that changes the result or its time
};

struct Study {
  std::string title, name;
  std::filesystem::path scene;   ///< the file that jobs run
  std::filesystem::path output;  ///< folder of the study
  std::vector<Knob> knobs;
  std::vector<Judged> quantities;
  std::vector<Job> jobs;
  std::string program;
  int threads = 1, repeats = 1, side_by_side = 1;
  bool by_processor = false;  ///< seconds are those of the processor
  std::optional<double> time_limit;
};

/// Reads a scene with its [study] and resolves every job, exactly as `breccia run --set` would.
/// \throws Error for whatever is wrong, before anything runs.
Study plan_study(const StudyRequest& request);

}  // namespace breccia
