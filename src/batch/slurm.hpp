#pragma once

#include "batch/sweep.hpp"

#include <optional>

namespace breccia {

/// "0-3,7": numbers that grow, as sbatch takes them.
std::string array_text(const std::vector<std::size_t>& numbers);

/// The script of a job array that runs these variants.
std::string slurm_script(const Sweep& sweep, const BatchRequest& request,
                         const std::vector<std::size_t>& numbers);

/// Writes the script into the output folder. Its path.
std::filesystem::path write_slurm_script(const Sweep& sweep, const BatchRequest& request,
                                         const std::vector<std::size_t>& numbers);

/// Hands the script to sbatch and remembers the job. Its number. \throws Error when Slurm refuses.
std::string submit(const Sweep& sweep, const std::filesystem::path& script);

/// The job that was submitted last, until it is forgotten.
std::optional<std::string> slurm_job(const Sweep& sweep);
void forget_slurm_job(const Sweep& sweep);

/// Whether tasks of a job wait or run. \throws Error when Slurm does not answer.
bool in_queue(const Sweep& sweep, const std::string& job);

}  // namespace breccia
