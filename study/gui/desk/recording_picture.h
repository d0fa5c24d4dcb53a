#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QLabel>
#include <QWidget>

#include "haptics/recordings/cut_import.h"
#include "haptics/recordings/trace.h"

class QCustomPlot;

namespace study::gui {

/// A recording as it was read, to look at before anything is kept.
struct RecordingLook {
  haptics::recordings::Recording recording;
  haptics::recordings::Trace trace;
  haptics::recordings::RecordingSurvey survey;
};

/// Reads a recording, with a columns file if it is not empty. Throws as recordingIn() does.
RecordingLook lookAt(const std::string& recording, const std::string& columns);

/// Draws force and travel over time with the cuts shaded, the chosen one darker, and says in words
/// what was read: rows, rate, unit, calibration, what the sensor could not measure.
class RecordingPicture final : public QWidget {
  Q_OBJECT

 public:
  explicit RecordingPicture(QWidget* parent = nullptr);

  /// std::nullopt: nothing.
  void show(std::optional<RecordingLook> look);
  using QWidget::show;
  /// Marks a cut, from 1; 0: none.
  void choose(int cut);
  int cuts() const;
  QString words() const { return words_->text(); }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void draw();

  std::optional<RecordingLook> look_;
  int chosen_ = 0;
  QCustomPlot* plot_;
  QLabel* words_;
};

}  // namespace study::gui
