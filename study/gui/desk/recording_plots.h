#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QLabel>
#include <QTableWidget>
#include <QWidget>

#include "haptics/recordings/cut_import.h"
#include "haptics/recordings/recording_table.h"
#include "haptics/recordings/trace.h"

class QCPAxisRect;
class QCustomPlot;

namespace study::gui {

/// A recording as it was read, to be shown before it is imported.
struct RecordingPreview {
  haptics::recordings::Recording recording;
  haptics::recordings::Trace trace;
  haptics::recordings::RecordingSurvey survey;
};

/// Reads a recording. Throws as readRecordingWithColumns() does.
RecordingPreview previewOf(
    const std::string& recording,
    const std::optional<haptics::recordings::RecordingColumns>& columns);

/// Draws force and travel over time, one above the other, with the cuts shaded, the chosen one
/// darker. A text below states rows, rate, unit, calibration, and the samples in which the sensor
/// was saturated.
class RecordingPlot final : public QWidget {
  Q_OBJECT

 public:
  explicit RecordingPlot(QWidget* parent = nullptr);

  /// Shows a recording; std::nullopt: shows none.
  void show(std::optional<RecordingPreview> preview);
  using QWidget::show;
  /// Marks a cut, from 1; 0: none.
  void choose(int cut);
  int cuts() const;
  QString words() const { return words_->text(); }
  const std::optional<RecordingPreview>& preview() const noexcept { return preview_; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void draw();
  void drawCurves(const RecordingPreview& preview);
  void shadeCuts(const RecordingPreview& preview);

  std::optional<RecordingPreview> preview_;
  int chosen_ = 0;
  QCustomPlot* plot_;
  QCPAxisRect* force_;
  QCPAxisRect* travel_;
  QLabel* words_;
};

/// Draws the cut that an import makes over the samples that it was taken from, with the landmarks,
/// and says in words what was changed.
class CutPlot final : public QWidget {
  Q_OBJECT

 public:
  explicit CutPlot(QWidget* parent = nullptr);

  /// @param trace  of the recording that the cut was taken from.
  void show(
      const haptics::recordings::Trace& trace, const haptics::recordings::ImportedCut& imported);
  using QWidget::show;
  /// A widget that says how the import changed the recorded curve and lists the landmarks in a
  /// table. The dialog places it.
  QWidget* summary() const noexcept { return summary_; }
  /// Shows or hides the plot with its summary.
  void setShown(bool isShown);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void paint();

  QCustomPlot* plot_;
  QWidget* summary_;
  QLabel* change_;
  QLabel* noYield_;  ///< why a cut may have no yield
  QTableWidget* landmarks_;
};

/// "its largest force was 17.06 N and is 12.99 N (−23.9 %)"
QString peakInWords(const haptics::recordings::ImportReport& report);

}  // namespace study::gui
