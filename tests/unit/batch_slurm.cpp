#include "batch/slurm.hpp"

#include <gmock/gmock.h>

namespace breccia {
namespace {

TEST(BatchSlurm, ArraysAreWrittenAsRanges) {
  EXPECT_EQ(array_text({0, 1, 2, 3, 7, 9, 10}), "0-3,7,9-10");
  EXPECT_EQ(array_text({5}), "5");
}

TEST(BatchSlurm, TheScriptAsksForWhatTheSweepSays) {
  Sweep sweep;
  sweep.name = "rock";
  sweep.file = "/data/it's rock.toml";
  sweep.output = "/data/rock.batch";
  sweep.program = "/opt/breccia";
  sweep.threads = 4;
  sweep.ranks = 2;
  sweep.time_limit = 93784.5;
  sweep.slurm = {1, "short", {"--mem=4G", "--account=x"}, {"module load openmpi"}};
  BatchRequest request;
  request.jobs = 8;
  request.options = {"run.duration=2 ms"};
  const std::string script = slurm_script(sweep, request, {0, 1, 2});
  for (const char* line :
       {"#!/bin/bash\n", "#SBATCH --array=0-2%8\n", "#SBATCH --ntasks=2\n",
        "#SBATCH --cpus-per-task=4\n", "#SBATCH --time=1-02:03:05\n", "#SBATCH --partition=short\n",
        "#SBATCH --mem=4G\n", "#SBATCH --account=x\n", "\nmodule load openmpi\n",
        "\nexec '/opt/breccia' batch '/data/it'\\''s rock.toml' \"--variant=$SLURM_ARRAY_TASK_ID\""
        " --jobs 1 --output '/data/rock.batch' --threads 4 --set 'run.duration=2 ms'\n"})
    EXPECT_THAT(script, testing::HasSubstr(line));
  sweep.slurm.variants_per_task = 2;
  const std::string short_runs = slurm_script(sweep, request, {0, 1, 2, 7, 8});
  for (const char* line :
       {"#SBATCH --array=0-2%8\n", "#SBATCH --time=2-04:06:09\n",
        "\nall=( --variant=0 --variant=1 --variant=2 --variant=7 --variant=8 )\n",
        " \"${all[@]:SLURM_ARRAY_TASK_ID*2:2}\" --jobs 1 "})
    EXPECT_THAT(short_runs, testing::HasSubstr(line));
}

}  // namespace
}  // namespace breccia
