#include "tests/judges/jobs.h"

#include <algorithm>
#include <functional>

#include "tests/judges/rigs/control_words.h"
#include "tests/judges/shared/shared_sets.h"
#include "tests/support/parallel.h"

namespace penpose::judges {
namespace {

using Job = std::function<std::vector<Judged>()>;

/// No names mean all.
bool asks_for(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || has(names, name);
}

Job of_own(const RigMaker& maker, const std::vector<Measure>& measures, Extent extent) {
  return [&maker, &measures, extent] {
    const Rig rig = maker.make();
    std::vector<Judged> all;
    for (const Measure& measure : measures) {
      if (measure.applies(rig))
        all.push_back({measure.name, rig.name, group_name(rig.group), measure.judge(rig, extent)});
    }
    return all;
  };
}

Job of_shared(const SharedSet& set, const std::vector<std::string>& names, const std::vector<Measure>& measures,
              Extent extent) {
  return [set, names, &measures, extent] {
    std::vector<Judged> all;
    if (!names.empty()) all = set.run(names);
    const bool own =
        std::any_of(measures.begin(), measures.end(), [](const Measure& m) { return !needs_cases(m.name); });
    if (!own || !set.rig_of) return all;
    const Rig rig = set.rig_of();
    for (const Measure& measure : measures) {
      if (!needs_cases(measure.name) && measure.applies(rig))
        all.push_back({measure.name, rig.name, group_name(rig.group), measure.judge(rig, extent)});
    }
    return all;
  };
}

std::vector<Job> jobs_of(const Wanted& wanted, const std::vector<Measure>& measures) {
  std::vector<Job> jobs;
  for (const RigMaker& maker : own_rigs()) {
    if (asks_for(wanted.rigs, maker.name)) jobs.push_back(of_own(maker, measures, wanted.extent));
  }
  if (!wanted.shared) return jobs;
  for (const SharedSet& set : shared_sets()) {
    std::vector<std::string> names;
    for (const std::string& name : set.measures) {
      if (asks_for(wanted.measures, name)) names.push_back(name);
    }
    if (asks_for(wanted.rigs, set.rig)) jobs.push_back(of_shared(set, names, measures, wanted.extent));
  }
  return jobs;
}

}  // namespace

std::vector<Judged> judge_all(const Wanted& wanted) {
  std::vector<Measure> measures;
  for (const Measure& measure : all_measures()) {
    if (asks_for(wanted.measures, measure.name)) measures.push_back(measure);
  }
  const std::vector<Job> jobs = jobs_of(wanted, measures);
  // Rigs next to each other are of a kind and take alike; every second one makes two pieces of the same work.
  std::vector<std::size_t> order;
  for (std::size_t first = 0; first < 2; ++first) {
    for (std::size_t j = first; j < jobs.size(); j += 2) order.push_back(j);
  }
  std::vector<std::vector<Judged>> of_jobs(jobs.size());
  tests::parallel_for(jobs.size(), 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) of_jobs[order[i]] = jobs[order[i]]();
  });
  std::vector<Judged> all;
  for (const Measure& measure : measures) {
    for (const auto& of_job : of_jobs) {
      for (const Judged& one : of_job) {
        if (one.measure == measure.name) all.push_back(one);
      }
    }
  }
  return all;
}

}  // namespace penpose::judges
