#include "study/report/family_section.h"
#include "study/report/html_writer.h"
#include "study/report/study_parts.h"

namespace study::report {
namespace {

/// Writes the beginning of the page: the study, and notes for the reader.
class HeadWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    head();
    return std::move(html_);
  }

 private:
  void head() {
    put("<h2>{}</h2>", escaped(s_.protocol.study.title));
    if (s_.results.runMode == RunMode::Simulated) {
      put("<p class=\"banner\">{}</p>",
          say("Simulated: nobody took part. These numbers show what the program does; they say "
              "nothing about any method."));
    }
    if (s_.results.runMode == RunMode::Pilot) {
      put("<p class=\"banner pilot\">{}</p>", say("Pilot sessions: not for publication."));
    }
    synthetic();
    if (!s_.protocol.study.description.empty())
      put("<p>{}</p>", escaped(s_.protocol.study.description));
  }

  void synthetic() {
    std::string titles;
    for (const auto& source : s_.sources) {
      if (source.isSynthetic) titles += (titles.empty() ? "" : "; ") + s_.words(source.title);
    }
    if (titles.empty()) return;
    put("<p class=\"banner\">{}</p>",
        say("SYNTHETIC: nobody recorded or measured what these alternatives were made from: {}. "
            "Which ones they are stands below, in “How this was made”.",
            titles));
  }
};

class ParticipantWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    flow();
    return std::move(html_);
  }

 private:
  void flow() {
    heading("Participants");
    table(
        say("Who took part"),
        {say("Cohort"),
         say("Enrolled"),
         say("Completed"),
         say("In progress"),
         say("Declined"),
         say("Withdrawn"),
         say("Rejected"),
         say("Device failed")});
    for (const auto& f : s_.results.flow) {
      std::vector<std::string> cells{cohort(f.cohort)};
      for (const int count :
           {f.enrolled,
            f.completed,
            f.inProgress,
            f.declined,
            f.withdrawn,
            f.rejected,
            f.abortedHardware}) {
        cells.push_back(std::to_string(count));
      }
      row(cells);
    }
    endTable();
    note(
        "Only completed sessions count below, and of these only steps that were finished and not "
        "repeated. Why somebody left is not told here: a few people are easily known. The export’s "
        "table of sessions has it.");
  }
};

class WarningWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    warnings();
    return std::move(html_);
  }

 private:
  void warnings() {
    if (s_.warnings.empty()) return;
    heading("What to know about the design");
    put("<ul>");
    for (const auto& warning : s_.warnings) {
      put("<li>{}{} <span class=\"note\">({})</span></li>",
          escaped(s_.words(warning.what)),
          warning.fix.empty() ? "." : "; " + escaped(s_.words(warning.fix)) + ".",
          escaped(warning.path));
    }
    put("</ul>");
  }
};

}  // namespace

std::string headAsHtml(const ReportSection& section) {
  return HeadWriter(section).all();
}

std::string participantsAsHtml(const ReportSection& section) {
  return ParticipantWriter(section).all();
}

std::string familiesAsHtml(const ReportSection& section) {
  std::string html;
  const auto& figures = section.figures.families;
  for (std::size_t i = 0; i < section.results.families.size(); ++i) {
    html += familyAsHtml(
        section, section.results.families[i], i < figures.size() ? figures[i] : FamilyFigures{});
  }
  return html;
}

std::string warningsAsHtml(const ReportSection& section) {
  return WarningWriter(section).all();
}

}  // namespace study::report
