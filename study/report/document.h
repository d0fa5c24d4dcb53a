#pragma once

#include <string>
#include <vector>

#include "study/model/data_table.h"
#include "study/report/chart.h"

namespace study::report {

struct DocumentFigure {
  std::string name;  ///< of its SVG file
  std::string caption;
  Chart chart;
  std::string svg;  ///< once it is painted
};

/// What belongs together below one heading: words, then figures, then tables. A table's
/// description is its caption; one without is for its CSV file alone.
struct DocumentPart {
  std::string heading;
  std::vector<std::string> paragraphs;
  std::vector<DocumentFigure> figures;
  std::vector<DataTable> tables;
};

/// A report of tables and figures about something that is not a study.
struct Document {
  std::string title;
  std::vector<std::string> lead;
  std::vector<DocumentPart> parts;
};

/// One page that needs nothing else; numbers to four digits.
std::string asHtml(const Document& document);

}  // namespace study::report
