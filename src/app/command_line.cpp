#include "app/command_line.hpp"

#include "app/info.hpp"
#include "batch/batch.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "core/schema.hpp"
#include "jobs/process.hpp"
#include "scene/commands.hpp"
#include "study/solutions.hpp"
#include "study/study.hpp"

#include <Kokkos_Core.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <new>
#include <optional>

namespace breccia {

namespace {

constexpr int user_error = 2;
constexpr int stopped = 1;

/// Everything the command line can say.
struct Arguments {
  std::filesystem::path scene, mesh_file;
  std::optional<std::filesystem::path> output;
  std::vector<std::string> options;
  std::string key;
  std::string program;  ///< as it was called
  int threads = 0;      ///< 0: all that the machine or OMP_NUM_THREADS offers; one for a study
  int repeats = 0, jobs = 0;
  std::vector<std::size_t> variants;
  bool overwrite = false, restart = false, quiet = false, markdown = false;
  bool list = false, solutions = false;
  const World* world = nullptr;
  bool many_ranks = false;  ///< the command can use them
  bool slurm = false, collect = false, dry_run = false;
};

int with_kokkos(const Arguments& arguments, const std::function<int()>& work) {
  Kokkos::InitializationSettings settings;
  if (arguments.threads > 0)
    settings.set_num_threads(arguments.threads);
  else if (arguments.world->size() > 1 && std::getenv("OMP_NUM_THREADS") == nullptr)
    settings.set_num_threads(arguments.world->cores());
  settings.set_disable_warnings(true);  // they speak of OMP_PROC_BIND to people who do not know it
  const Kokkos::ScopeGuard kokkos(settings);
  return work();
}

int help(const Arguments& arguments) {
  Schema schema;
  declare_schema(schema);
  if (arguments.markdown) {
    schema.markdown(std::cout);
  } else {
    std::cout << (arguments.key.empty() ? schema.overview() : schema.help(arguments.key));
  }
  return 0;
}

int info(const Arguments& arguments) {
  return with_kokkos(arguments, [] {
    std::cout << info_text();
    return 0;
  });
}

int run(const Arguments& a) {
  if (a.overwrite && a.restart) {
    throw Error("breccia run", "--overwrite and --restart exclude each other",
                "--restart goes on from the checkpoint, --overwrite begins anew");
  }
  log::set_quiet(a.quiet);
  const RunRequest request{a.scene, a.options, a.output, a.overwrite, a.restart, a.quiet, a.world};
  return with_kokkos(a, [&request] { return run_scene(request); });
}

int check(const Arguments& a) {
  return with_kokkos(a, [&a] { return check_scene({a.scene, a.options}); });
}

int mesh(const Arguments& a) {
  if (a.mesh_file.extension() != ".h5") {
    throw Error(a.mesh_file.string(), "a mesh is written in Breccia's own format, named .h5",
                "for example: breccia mesh " + a.scene.string() + " -o mesh.h5");
  }
  return with_kokkos(a, [&a] { return mesh_scene({a.scene, a.options, a.mesh_file}); });
}

int study(const Arguments& a) {
  if (a.solutions) {
    std::cout << solutions_text();
    return 0;
  }
  if (a.scene.empty()) throw Error("command line", "SCENE is required", "see breccia study --help");
  log::set_quiet(a.quiet);
  StudyRequest request;
  request.scene = a.scene;
  request.options = a.options;
  request.output = a.output;
  request.program = own_program(a.program);
  request.threads = a.threads > 0 ? a.threads : 1;
  request.repeats = a.repeats;
  request.jobs = a.jobs > 0 ? a.jobs : 1;
  request.list = a.list;
  request.quiet = a.quiet;
  return study_scene(request);
}

int batch(const Arguments& a) {
  if (a.dry_run && !a.slurm && !a.collect) {
    throw Error("breccia batch", "--dry-run belongs to --slurm or --collect",
                "--list says which variants would run");
  }
  log::set_quiet(a.quiet);
  BatchRequest request;
  request.sweep = a.scene;
  request.options = a.options;
  request.output = a.output;
  request.program = own_program(a.program);
  request.threads = a.threads;
  request.jobs = a.jobs;
  request.variants = a.variants;
  request.list = a.list;
  request.slurm = a.slurm;
  request.collect = a.collect;
  request.dry_run = a.dry_run;
  request.overwrite = a.overwrite;
  request.quiet = a.quiet;
  return batch_scene(request);
}

/// Options that take one value each, so that a scene may follow them.
void add_common(CLI::App& verb, Arguments& a, const char* what = "SCENE",
                const char* doc = "scene file, or folder with a scene.toml") {
  verb.add_option(what, a.scene, doc)
      ->required(verb.get_name() != "study");  // which may only list its solutions
  verb.add_option("--set", a.options, "replace a value of the scene, key.path=value (repeatable)")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  verb.add_option("--threads", a.threads, "number of threads")
      ->check(CLI::Range(1, 4096))
      ->type_name("N");
}

void declare_run_verb(CLI::App& app, Arguments& a, std::function<int(const Arguments&)>& chosen) {
  CLI::App* verb = app.add_subcommand("run", "run a scene");
  add_common(*verb, a);
  verb->add_option("--output", a.output, "folder for the results (default: <scene name>.out)")
      ->type_name("DIR");
  verb->add_flag("--overwrite", a.overwrite, "replace the results of an earlier run");
  verb->add_flag("--restart", a.restart, "go on from the checkpoint in the output folder");
  verb->add_flag("--quiet", a.quiet, "print warnings and errors only");
  verb->callback([&chosen, &a] {
    chosen = run;
    a.many_ranks = true;
  });
}

void declare_study_verb(CLI::App& app, Arguments& a, std::function<int(const Arguments&)>& chosen) {
  CLI::App* verb = app.add_subcommand("study", "run the ladders of [study]; what accuracy costs");
  add_common(*verb, a);
  verb->add_option("--output", a.output, "folder for the study (default: <scene name>.study)")
      ->type_name("DIR");
  verb->add_option("--repeats", a.repeats, "runs of each job, for the spread of its time")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  verb->add_option("--jobs", a.jobs, "jobs side by side (1: times can be compared)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  verb->add_flag("--list", a.list, "say which jobs would run; run none");
  verb->add_flag("--solutions", a.solutions, "the closed forms that a study may name");
  verb->add_flag("--quiet", a.quiet, "print warnings and errors only");
  verb->callback([&chosen] { chosen = study; });
}

void declare_batch_verb(CLI::App& app, Arguments& a, std::function<int(const Arguments&)>& chosen) {
  CLI::App* verb = app.add_subcommand("batch", "run the variants of [batch], here or by Slurm");
  add_common(*verb, a, "SWEEP", "file with a [batch]");
  verb->add_option("--output", a.output, "folder for the variants (default: <sweep name>.batch)")
      ->type_name("DIR");
  verb->add_option("--jobs", a.jobs, "variants at a time (default: cores over threads)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  verb->add_flag("--overwrite", a.overwrite, "run variants anew whose scene or build has changed");
  verb->add_flag("--quiet", a.quiet, "print warnings and errors only");
  CLI::Option_group* what = verb->add_option_group("instead of running them all here");
  what->add_flag("--list", a.list, "say which variants there are");
  what->add_flag("--slurm", a.slurm, "submit a Slurm job array");
  what->add_flag("--collect", a.collect, "the summary of what is there; Slurm retries failed ones");
  what->add_option("--variant", a.variants, "run this one alone, once (repeatable)")
      ->allow_extra_args(false)
      ->type_name("N");
  what->require_option(0, 1);
  verb->add_flag("--dry-run", a.dry_run, "with --slurm or --collect: submit nothing");
  verb->callback([&chosen] { chosen = batch; });
}

void declare_verbs(CLI::App& app, Arguments& a, std::function<int(const Arguments&)>& chosen) {
  declare_run_verb(app, a, chosen);
  CLI::App* check_verb = app.add_subcommand("check", "say what a scene would do; run nothing");
  add_common(*check_verb, a);
  check_verb->callback([&chosen] { chosen = check; });

  declare_study_verb(app, a, chosen);
  declare_batch_verb(app, a, chosen);

  CLI::App* help_verb = app.add_subcommand("help", "explain a key of the scene, or list them");
  help_verb->add_option("KEY", a.key, "for example run.duration or material");
  help_verb->add_flag("--markdown", a.markdown, "all keys, as docs/input.md");
  help_verb->callback([&chosen] { chosen = help; });

  CLI::App* mesh_verb = app.add_subcommand("mesh", "write the mesh of a scene");
  add_common(*mesh_verb, a);
  mesh_verb->add_option("-o,--output", a.mesh_file, "file to write, named .h5")
      ->required()
      ->type_name("FILE");
  mesh_verb->callback([&chosen] { chosen = mesh; });

  CLI::App* info_verb = app.add_subcommand("info", "version, backends, optional parts");
  info_verb->callback([&chosen] { chosen = info; });
}

/// CLI11 has a status of its own for every mistake; ours is 2 for all, 0 for --help and --version.
int parse_failed(const CLI::App& app, const CLI::ParseError& e, const World& world) {
  const bool asked = e.get_exit_code() == 0;
  if (asked) {
    if (world.speaks()) app.exit(e);
    return 0;
  }
  if (world.speaks()) {
    log::error(Error("command line", e.what(), "see breccia --help").what());
  }
  return user_error;
}

/// Seconds that a rank which fails waits for the others to fail, too.
constexpr double kPatience = 3;

/// One message where all ranks fail for the same reason; where only one has failed, its own, and
/// the end of all of them.
int fail(const World& world, int status, const std::string& text) {
  const bool all = world.together(kPatience);
  log::set_silent(all && !world.speaks());
  log::error(all ? text : fmt::format("rank {}: {}", world.rank(), text));
  if (!all) world.abort(status);
  return status;
}

int guarded(const std::function<int()>& work, const World& world) {
  try {
    return work();
  } catch (const Error& e) {
    return fail(world, user_error, e.what());
  } catch (const std::filesystem::filesystem_error& e) {
    return fail(world, user_error, Error(e.path1().string(), e.code().message()).what());
  } catch (const std::bad_alloc&) {
    return fail(world, stopped,
                "out of memory\n  use fewer elements, or a machine with more memory; breccia "
                "check tells how much a scene needs");
  } catch (const std::exception& e) {
    return fail(world, stopped,
                std::string("internal error: ") + e.what() +
                    "\n  this is a defect of breccia; please report it with the scene and this "
                    "line: " +
                    version_line());
  }
}

}  // namespace

int run_command_line(int argc, char** argv, const World& world) {
  CLI::App app{"breccia: solids that deform, break and collide", "breccia"};
  app.require_subcommand(1);
  app.set_version_flag("--version", version_line());
  Arguments arguments;
  arguments.program = argv[0];
  arguments.world = &world;
  std::function<int(const Arguments&)> chosen;
  declare_verbs(app, arguments, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return parse_failed(app, e, world);
  }
  return guarded(
      [&] {
        if (!arguments.many_ranks) world.require_one_rank();
        log::set_silent(!world.speaks());
        return chosen(arguments);
      },
      world);
}

}  // namespace breccia
