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
  std::string svg;  ///< empty until the chart is painted
};

/// The content under one heading: text, then figures, then tables. A table's description is its
/// caption; a table without one is written to its CSV file only.
struct DocumentPart {
  std::string heading;
  std::vector<std::string> paragraphs;
  std::vector<DocumentFigure> figures;
  std::vector<DataTable> tables;
};

/// A report of tables and figures on a subject other than a study.
struct Document {
  std::string title;
  std::vector<std::string> lead;
  std::vector<DocumentPart> parts;
};

/// One self-contained HTML page. Numbers have four significant digits.
std::string asHtml(const Document& document);

}  // namespace study::report
