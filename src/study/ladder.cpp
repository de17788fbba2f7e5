#include "study/ladder.hpp"

#include "core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace breccia {

namespace {

std::string safe(const std::string& text) {
  std::string word;
  for (const char c : text) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
    if (plain || (!word.empty() && word.back() != '_')) word += plain ? c : '_';
  }
  while (!word.empty() && word.back() == '_') word.pop_back();
  return word;
}

std::string part_of(const Knob& knob, int rung) {
  return knob.name + " " + knob.words[static_cast<std::size_t>(rung)];
}

Job job_of(const std::vector<Knob>& knobs, const std::vector<int>& rung) {
  Job job;
  job.rung = rung;
  std::vector<std::string> words;
  for (std::size_t k = 0; k < knobs.size(); ++k) {
    if (rung[k] < 0) continue;
    words.push_back(part_of(knobs[k], rung[k]));
    job.folder += (job.folder.empty() ? "" : "-") + safe(words.back());
    for (const std::string& path : knobs[k].paths)
      job.options.push_back(path + "=" + knobs[k].rungs[static_cast<std::size_t>(rung[k])]);
  }
  job.label = join(words);
  return job;
}

}  // namespace

std::vector<Job> climb(const std::vector<Knob>& knobs, bool product) {
  std::vector<Job> jobs;
  std::vector<int> rung(knobs.size(), product ? 0 : -1);
  if (!product) {
    for (std::size_t k = 0; k < knobs.size(); ++k) {
      for (std::size_t i = 0; i < knobs[k].rungs.size(); ++i) {
        std::vector<int> one = rung;
        one[k] = static_cast<int>(i);
        jobs.push_back(job_of(knobs, one));
      }
    }
    return jobs;
  }
  for (bool more = !knobs.empty(); more;) {
    jobs.push_back(job_of(knobs, rung));
    more = false;
    for (std::size_t k = 0; k < knobs.size() && !more; ++k) {
      more = ++rung[k] < static_cast<int>(knobs[k].rungs.size());
      if (!more) rung[k] = 0;
    }
  }
  return jobs;
}

void number_jobs(std::vector<Job>& jobs) {
  std::map<std::string, std::size_t> first;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    Job& job = jobs[i];
    job.same_as = first.emplace(job.identity, i).first->second;
    const bool twin = job.same_as != i;
    job.folder =
        twin ? jobs[job.same_as].folder : fmt::format("{:03}_{}", i + 1, job.folder.substr(0, 100));
  }
}

std::vector<std::vector<std::size_t>> lines_along(std::size_t knob, const std::vector<Job>& jobs) {
  std::vector<std::vector<std::size_t>> lines;
  std::vector<std::vector<int>> others;
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    if (jobs[j].rung[knob] < 0) continue;
    std::vector<int> other = jobs[j].rung;
    other[knob] = 0;
    const auto found = std::find(others.begin(), others.end(), other);
    const auto at = static_cast<std::size_t>(found - others.begin());
    if (found == others.end()) {
      others.push_back(other);
      lines.emplace_back();
    }
    lines[at].push_back(j);
  }
  std::erase_if(lines, [](const auto& line) { return line.size() < 2; });
  for (auto& line : lines)
    std::sort(line.begin(), line.end(), [&](std::size_t a, std::size_t b) {
      return jobs[a].rung[knob] < jobs[b].rung[knob];
    });
  return lines;
}

std::string other_rungs(const Job& job, std::size_t knob, const std::vector<Knob>& knobs) {
  std::vector<std::string> words;
  for (std::size_t k = 0; k < knobs.size(); ++k)
    if (k != knob && job.rung[k] >= 0) words.push_back(part_of(knobs[k], job.rung[k]));
  return join(words);
}

}  // namespace breccia
