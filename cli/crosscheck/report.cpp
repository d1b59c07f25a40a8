// SPDX-License-Identifier: Apache-2.0
#include "cli/crosscheck/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "cli/crosscheck/ray_text.h"
#include "cli/options/common.h"
#include "cli/shell_text.h"

namespace twinray {
namespace {

/// What an engine saw: "t 0x1.8p+0 u 0.25 v 0.5 of 0:17", "nothing".
std::string answer_text(const Answer& answer) {
  const Hit& hit = answer.closest;
  const std::string text = hit ? fmt::format("t {:a} u {:a} v {:a} of {}", hit.t, hit.u, hit.v,
                                             primitive_text(hit.mesh, hit.primitive, hit.instance))
                               : "nothing";
  return answer.is_consistent() ? text : text + (answer.any ? ", but any hit" : ", but no any hit");
}

std::string command_text(const Finding& finding, const std::string& replay) {
  const Placement placement = placement_of(finding.ray_class);
  const std::string option =
      placement == Placement::file ? "" : fmt::format(" --placement={}", placement_name(placement));
  return fmt::format("{}{} --ray={}", replay, option, ray_text(finding.ray));
}

std::string name_of(const JudgedHit& hit) { return primitive_text(hit.mesh, hit.primitive, hit.instance); }

/// "t 1.5 of 0:17", "nothing"; empty for what was not judged.
std::string exact_text(const Finding& finding) {
  if (!finding.is_judged) return "";
  if (!finding.exact) return "nothing";
  return fmt::format("t {:.9g} of {}", finding.exact->t.value, name_of(*finding.exact));
}

std::string finding_text(const Finding& finding, const SceneCrosscheck& result, const std::string& label) {
  return fmt::format("{}, {}, {}{}: {} sees {}; {} sees {}{}\n", result.engines[finding.engine], label,
                     difference_name(finding.difference), finding.is_leak ? " (leak)" : "", result.engines[0],
                     answer_text(finding.reference), result.engines[finding.engine],
                     answer_text(finding.found), finding.is_judged ? "; exact " + exact_text(finding) : "");
}

bool is_unexplained(const Finding& finding) { return finding.difference == Difference::unexplained; }

std::string row_text(const std::string& label, const Tally& tally) {
  std::string text = fmt::format("{:<10} {:>10}", label, tally.rays);
  for (const std::uint64_t count : tally.counts) text += fmt::format(" {:>12}", count);
  return text + fmt::format(" {:>11} {:>8}\n", tally.hit_or_miss, tally.leaks);
}

std::string table_text(const SceneCrosscheck& result, std::size_t engine) {
  std::string text =
      fmt::format("{} against {}\n{:<10} {:>10}", result.engines[engine], result.engines[0], "rays", "shot");
  for (std::size_t i = 0; i < difference_count; ++i)
    text += fmt::format(" {:>12}", difference_name(Difference(i)));
  text += fmt::format(" {:>11} {:>8}\n", "hit or miss", "leaks");
  Tally sum;
  for (std::size_t i = 0; i < ray_class_count; ++i) {
    const Tally& tally = result.report.tally(engine, RayClass(i));
    if (tally.rays > 0) text += row_text(ray_class_name(RayClass(i)), tally);
    sum += tally;
  }
  return text + row_text("all", sum) + "\n";
}

/// The ceilings that are passed and count.
std::vector<PassedCeiling> wrong_ceilings(const CrosscheckReport& report, Ceilings ceilings) {
  return ceilings == Ceilings::count ? passed_ceilings(report) : std::vector<PassedCeiling>{};
}

/// The kept findings of the unexplained differences, and of the classes of these ceilings.
template <typename Visit>
void visit_wrong(const CrosscheckReport& report, const std::vector<PassedCeiling>& passed,
                 const Visit& visit) {
  for (std::size_t engine = 0; engine < report.engine_count(); ++engine)
    for (std::size_t i = 0; i < ray_class_count; ++i) {
      const bool is_passed_here = std::any_of(passed.begin(), passed.end(), [&](const PassedCeiling& p) {
        return p.engine == engine && p.ray_class == RayClass(i);
      });
      for (const Finding& finding : report.findings(engine, RayClass(i)))
        if (is_passed_here || is_unexplained(finding)) visit(finding);
    }
}

std::string ceiling_text(const PassedCeiling& passed, const SceneCrosscheck& result, Ceilings ceilings) {
  return fmt::format(
      "{}{}: {} {} rays {}; {} may\n", ceilings == Ceilings::remark ? "remark: " : "",
      result.engines[passed.engine], passed.found, ray_class_name(passed.ray_class),
      passed.ceiling.counts == Ceiling::Counts::leaks ? "leak" : "are neither identical nor rounding",
      passed.ceiling.most == 0 ? "none" : fmt::format("at most {}", passed.ceiling.most));
}

nlohmann::ordered_json tally_json(const Tally& tally) {
  nlohmann::ordered_json json{{"rays", tally.rays}};
  for (std::size_t i = 0; i < difference_count; ++i) json[difference_name(Difference(i))] = tally.counts[i];
  json["hit_or_miss"] = tally.hit_or_miss;
  json["leaks"] = tally.leaks;
  return json;
}

}  // namespace

bool is_passed(const CrosscheckReport& report, Ceilings ceilings) {
  return report.unexplained() == 0 && wrong_ceilings(report, ceilings).empty();
}

std::string replay_command(const std::string& scene, const LoadOptions& load,
                           const std::vector<std::string>& engines) {
  const bool are_usual = engines == default_crosscheck_engines();
  return fmt::format("twinray crosscheck {}{}{}{}", shell_text({scene}),
                     load.keep_both_lamps ? " --keep-both-lamps" : "", instances_words(load.instances),
                     are_usual ? "" : fmt::format(" --engines={}", fmt::join(engines, ",")));
}

std::string ray_label(const Finding& finding) {
  return fmt::format("{} {}", ray_class_name(finding.ray_class), finding.number);
}

std::string crosscheck_text(const SceneCrosscheck& result, const std::string& replay, Ceilings ceilings,
                            const std::function<std::string(const Finding&)>& label) {
  std::string text;
  for (std::size_t engine = 1; engine < result.engines.size(); ++engine) text += table_text(result, engine);
  visit_wrong(result.report, wrong_ceilings(result.report, ceilings), [&](const Finding& finding) {
    text += finding_text(finding, result, label(finding));
    text += fmt::format("  {}\n", command_text(finding, replay));
  });
  for (const PassedCeiling& passed : passed_ceilings(result.report))
    text += ceiling_text(passed, result, ceilings);
  const std::uint64_t unexplained = result.report.unexplained();
  return text + fmt::format("{} unexplained; {:.1f} s\n",
                            unexplained == 0 ? "nothing" : fmt::format("{}", unexplained), result.seconds);
}

std::string crosscheck_json(const SceneCrosscheck& result, const std::string& scene,
                            const std::string& replay, Ceilings ceilings) {
  nlohmann::ordered_json json{{"scene", scene},
                              {"passed", is_passed(result.report, ceilings)},
                              {"unexplained", result.report.unexplained()},
                              {"seconds", result.seconds},
                              {"reference", result.engines[0]}};
  for (std::size_t engine = 0; engine < result.engines.size(); ++engine) {
    auto& table = json["engines"][result.engines[engine]];
    for (std::size_t i = 0; i < ray_class_count; ++i) {
      table[ray_class_name(RayClass(i))] = tally_json(result.report.tally(engine, RayClass(i)));
      for (const Finding& finding : result.report.findings(engine, RayClass(i)))
        json["findings"].push_back({{"engine", result.engines[engine]},
                                    {"class", ray_class_name(finding.ray_class)},
                                    {"number", finding.number},
                                    {"difference", difference_name(finding.difference)},
                                    {"leak", finding.is_leak},
                                    {"reference", answer_text(finding.reference)},
                                    {"found", answer_text(finding.found)},
                                    {"exact", exact_text(finding)},
                                    {"command", command_text(finding, replay)}});
    }
  }
  for (const PassedCeiling& passed : passed_ceilings(result.report))
    json["passed_ceilings"].push_back({{"engine", result.engines[passed.engine]},
                                       {"class", ray_class_name(passed.ray_class)},
                                       {"found", passed.found},
                                       {"most", passed.ceiling.most}});
  // A file's name may hold bytes that are no letters.
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string ray_crosscheck_text(const RayCrosscheck& result) {
  std::string text;
  for (const RayCrosscheck::Row& row : result.rows)
    text +=
        fmt::format("{:<14} {} ({})\n", row.engine, answer_text(row.answer), difference_name(row.difference));
  if (result.truth.empty()) text += "exact          nothing\n";
  for (const JudgedHit& hit : result.truth)
    text += fmt::format("exact          t {:.17g} +- {:.1g} of {}\n", hit.t.value, hit.t.error, name_of(hit));
  return text;
}

}  // namespace twinray
