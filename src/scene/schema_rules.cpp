// Rules between several keys, for scenes whose keys are each right.
#include "scene/schema_rules.hpp"

#include "core/text.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {

namespace {

void check_copies(const Settings& body, int dimension, Problems& problems) {
  if (!body.has("copies")) return;
  const Settings& copies = body.at("copies");
  for (const char* key : {"count", "hollow"})
    if (copies.has(key) && copies.integers(key).size() != static_cast<std::size_t>(dimension))
      problems.add(copies.error(key, std::to_string(copies.integers(key).size()) + " numbers for " +
                                         std::to_string(dimension) + " dimensions"));
  if (copies.integer("offset") >= copies.integer("every"))
    problems.add(copies.error("offset", "sites are counted from 0 to every - 1",
                              "give an offset below " + std::to_string(copies.integer("every"))));
  if (body.flag("rigid"))
    problems.add(body.error("rigid", "the copies of a body would be one rigid body",
                            "leave rigid out, or write a [[body]] for each"));
  if (body.has("part_of"))
    problems.add(body.error("part_of", "copies do not grow together with other bodies",
                            "leave part_of or [body.copies] out"));
}

/// Keys that only one generator or one dimension knows.
void check_generator(const Settings& body, int dimension, Problems& problems) {
  const Settings& mesh = body.at("mesh");
  const bool structured = mesh.text("generator") == "structured";
  const bool brick = body.has("shape.rectangle") || body.has("shape.box");
  for (const char* key : {"pattern", "cells", "jitter"}) {
    if (structured || !mesh.has(key)) continue;
    problems.add(mesh.error(key, "is for a structured mesh", "add generator = \"structured\""));
  }
  if (!structured) return;
  if (!brick) {
    problems.add(mesh.error("generator", "only a rectangle or a box has a structured mesh",
                            "leave generator out: Gmsh meshes every shape"));
  }
  if (body.has("part_of"))
    problems.add(body.error("part_of", "a structured mesh does not grow together with others",
                            "leave generator out: Gmsh meshes all parts as one"));
  for (const char* word : {"refine", "embed"}) {
    if (!mesh.has(word)) continue;
    problems.add(mesh.error("generator", std::string("a structured mesh cannot have ") + word,
                            "leave generator out: Gmsh can"));
  }
  if (mesh.has("cells") && mesh.integers("cells").size() != static_cast<std::size_t>(dimension)) {
    problems.add(mesh.error("cells", std::to_string(mesh.integers("cells").size()) +
                                         " numbers for " + std::to_string(dimension) +
                                         " dimensions"));
  }
  const std::string pattern = mesh.text_or("pattern", "");
  const bool of_space = pattern == "kuhn" || pattern == "five";
  if (!pattern.empty() && of_space != (dimension == 3)) {
    problems.add(mesh.error(
        "pattern", "\"" + pattern + "\" is for " + (of_space ? "three" : "two") + " dimensions",
        dimension == 2 ? "in the plane: cross, right, union-jack" : "in space: kuhn, five"));
  }
}

void check_mesh(const Settings& body, int dimension, Problems& problems) {
  const Settings& mesh = body.at("mesh");
  const bool file = body.has("shape.file");
  const std::string kind = mesh.text_or("element", "");
  if (!kind.empty() && kind.starts_with("tri") != (dimension == 2)) {
    problems.add(mesh.error(
        "element", "\"" + kind + "\" does not fit run.dimension = " + std::to_string(dimension),
        dimension == 2 ? "write \"tri3\" or \"tri6c\", or leave it out"
                       : "write \"tet4\", \"tet10c\" or \"tet10c12\", or leave it out"));
  }
  if (!file && !mesh.has("size") && !mesh.has("cells")) {
    problems.add(body.error("mesh.size", "is missing (length)", "for example: size = \"0.5 mm\""));
  }
  check_generator(body, dimension, problems);
  check_copies(body, dimension, problems);
}

/// Bodies that grow together share the nodes of common edges, so all or none have mid-edge nodes.
void check_kinds_of_parts(const Settings& scene, Problems& problems) {
  const auto kind = [](const Settings& body) {
    const std::string text = body.at("mesh").text_or("element", "");
    return text == "tri3" || text == "tet4" ? "" : text;
  };
  const auto& bodies = scene.list("body");
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const std::string part = bodies[b].text_or("part_of", "");
    if (part.empty()) continue;
    for (std::size_t a = 0; a < b; ++a) {
      if (bodies[a].text_or("part_of", "") != part || kind(bodies[a]) == kind(bodies[b])) continue;
      const Settings& named = bodies[kind(bodies[b]).empty() ? a : b];
      problems.add(named.at("mesh").error("element",
                                          "\"" + bodies[a].name() + "\" and \"" + bodies[b].name() +
                                              "\" grow together (part_of = \"" + part +
                                              "\") but differ in their elements",
                                          "give both the same element"));
      break;
    }
  }
}

void check_shape(const Settings& body, Problems& problems) {
  const Settings& shape = body.at("shape");
  if (shape.has("region") && !shape.has("file")) {
    problems.add(shape.error("region", "a region is taken from a file, and there is none"));
  }
  if (shape.has("cylinder")) check_direction(shape.at("cylinder"), "axis", problems);
  if (!shape.has("polygon")) return;
  const Settings& polygon = shape.at("polygon");
  const auto check_outline = [&](const char* key, const Points& outline) {
    if (outline.size() >= 3) return;
    problems.add(
        polygon.error(key, std::to_string(outline.size()) + " points; an outline has 3 or more"));
  };
  check_outline("points", polygon.points("points"));
  if (!polygon.has("holes")) return;
  for (const auto& hole : polygon.lines("holes")) check_outline("holes", hole);
}

}  // namespace

void check_direction(const Settings& section, const char* key, Problems& problems) {
  const std::vector<double>& v = section.vector(key);
  if (std::all_of(v.begin(), v.end(), [](double x) { return x == 0; }))
    problems.add(section.error(key, "has no direction; every component is zero"));
}

void check_run_rules(const Settings& scene, Problems& problems) {
  const Settings& run = scene.at("run");
  if (run.has("mass_scaling") && (scene.has("fracture") || !scene.list("interface").empty()))
    problems.add(run.at("mass_scaling")
                     .error("",
                            "nodes that split take their mass anew, so it cannot be scaled where "
                            "faces may break",
                            "leave it out, or take coarser elements"));
  const double duration = run.number("duration");
  if (run.has("step") && run.number("step") > duration) {
    problems.add(run.error("step", number_text(run.number("step")) +
                                       " s is longer than the run (duration " +
                                       number_text(duration) + " s)"));
  }
  const Settings& output = scene.at("output");
  if (output.has("history") && output.number("history") > duration) {
    problems.add(output.error("history",
                              number_text(output.number("history")) +
                                  " s is longer than the run (duration " + number_text(duration) +
                                  " s)",
                              "history.csv would have no rows but the first and last"));
  }
}

void check_body_rules(const Settings& scene, Problems& problems) {
  const int dimension = static_cast<int>(scene.at("run").integer("dimension"));
  for (const Settings& body : scene.list("body")) {
    check_shape(body, problems);
    check_mesh(body, dimension, problems);
  }
  check_kinds_of_parts(scene, problems);
}

}  // namespace breccia
