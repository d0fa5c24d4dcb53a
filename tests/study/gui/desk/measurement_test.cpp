#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableWidget>
#include <QTest>

#include "haptics/reaming/material/series.h"
#include "haptics/reaming/material/synthetic_series.h"
#include "protocols/reading/cut_file.h"
#include "protocols/reading/packing_file.h"
#include "study/gui/desk/measurement_dialogs.h"
#include "study/gui/desk/measurement_work.h"
#include "study/gui/desk/recording_plots.h"
#include "study/model/storage_error.h"
#include "study/model/user_error.h"
#include "study/session/import_recording.h"
#include "tests/haptics/recordings/made_recording.h"
#include "tests/study/gui/pictures.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace measurement_test {

class MeasurementTest : public testing::Test {
 protected:
  static void set(QDialog& dialog, const char* name, const std::string& path) {
    dialog.findChild<PathField*>(QString::fromUtf8(name))->setPath(QString::fromStdString(path));
  }
  /// Presses the button, waits for the end, and returns the line with the result.
  static std::string press(QDialog& dialog) {
    dialog.show();
    QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("go")), Qt::LeftButton);
    return dialog.findChild<QLabel*>(QStringLiteral("outcome"))->text().toStdString();
  }

  tests::ScratchFolder folder_;
};

TEST_F(MeasurementTest, ImportsACutThatAProtocolCanRead) {
  ImportCutDialog dialog;
  set(dialog, "recording", folder_.write("recording.txt", tests::textOf({})));
  set(dialog, "target", folder_ / "cut.json");
  EXPECT_TRUE(press(dialog).starts_with("✓"));
  questionnaires::Problems problems;
  EXPECT_TRUE(protocols::readCut(tests::contentOf(folder_ / "cut.json"), problems).has_value())
      << questionnaires::describe(problems.all());
  tests::photographInAllThemes(dialog, QStringLiteral("import"));
}

TEST_F(MeasurementTest, SaysWhyAButtonCannotBePressed) {
  const auto obstacle = [](QDialog& dialog) {
    const auto words = dialog.findChild<QLabel*>(QStringLiteral("obstacle"))->text().toStdString();
    EXPECT_EQ(dialog.findChild<QPushButton*>(QStringLiteral("go"))->isEnabled(), words.empty());
    return words;
  };
  FitMaterialDialog fit;
  EXPECT_EQ(obstacle(fit), "Choose the folder of series.");
  set(fit, "series", folder_ / "series");
  EXPECT_EQ(obstacle(fit), "");
  set(fit, "target", "");
  EXPECT_EQ(obstacle(fit), "Choose a new file.");
  BuildBoneDialog bone;
  EXPECT_EQ(obstacle(bone), "");
  set(bone, "target", "");
  EXPECT_EQ(obstacle(bone), "Choose a new file.");
  ImportCutDialog cut;
  EXPECT_EQ(obstacle(cut), "Choose a recording.");
  set(cut, "recording", folder_.write("text.txt", "no recording"));
  EXPECT_EQ(obstacle(cut), "No cut can be taken from this recording.");
  set(cut, "recording", folder_.write("recording.txt", tests::textOf({})));
  EXPECT_EQ(obstacle(cut), "");
}

TEST_F(MeasurementTest, ShowsARecordingBeforeAnythingIsKept) {
  // So long a name that a picture of the field shows it, and not the scratch folder's.
  std::filesystem::create_directory(folder_ / "measured-in-november");
  const auto file = folder_.write("measured-in-november/recording.txt", tests::textOf({}));
  ImportCutDialog dialog;
  dialog.show();
  const auto* picture = dialog.findChild<RecordingPlot*>();
  EXPECT_FALSE(picture->isVisible());
  set(dialog, "recording", file);
  EXPECT_TRUE(picture->isVisible());
  const auto preview = previewOf(file, {});
  EXPECT_GT(preview.survey.closures.size(), 0U);
  EXPECT_EQ(picture->cuts(), static_cast<int>(preview.survey.closures.size()));
  const auto words = picture->words().toStdString();
  EXPECT_NE(words.find(std::to_string(preview.survey.rows) + " rows"), std::string::npos) << words;
  EXPECT_NE(words.find(preview.trace.calibration.name), std::string::npos) << words;
  dialog.resize(1240, 720);
  dialog.findChild<QSpinBox*>()->setFocus();  // the paths are not being edited
  QTest::qWait(1);                            // sizes follow what is shown
  EXPECT_EQ(dialog.findChild<QScrollArea*>()->verticalScrollBar()->maximum(), 0)
      << "the pictures are beside the form";
  tests::photographInAllThemes(dialog, QStringLiteral("import-picture"));
  set(dialog, "recording", folder_.write("text.txt", "no recording"));
  EXPECT_FALSE(picture->isVisible());
  EXPECT_TRUE(dialog.findChild<QLabel*>(QStringLiteral("outcome"))->text().startsWith(u'✕'));
}

TEST_F(MeasurementTest, WarnsBeforeAndAfterSavingACutThatLosesItsPeak) {
  ImportCutDialog dialog;
  set(dialog, "recording", folder_.write("recording.txt", tests::textOf({})));
  set(dialog, "target", folder_ / "cut.json");
  dialog.show();
  auto* slope = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("slope"));
  EXPECT_EQ(slope->value(), haptics::recordings::ImportOptions{}.maxSlope);
  EXPECT_TRUE(dialog.findChild<CutPlot*>()->isVisible());
  const auto* change = dialog.findChild<QLabel*>(QStringLiteral("cut-change"));
  EXPECT_TRUE(change->text().startsWith(QStringLiteral("No part of this cut is that steep")))
      << change->text().toStdString();
  const auto* landmarks = dialog.findChild<QTableWidget*>(QStringLiteral("cut-landmarks"));
  ASSERT_EQ(landmarks->rowCount(), 4);
  EXPECT_EQ(landmarks->item(1, 0)->text(), QStringLiteral("Yield"));
  EXPECT_NEAR(landmarks->item(1, 2)->text().toDouble(), 4.4, 0.05);
  EXPECT_FALSE(dialog.findChild<QLabel*>(QStringLiteral("no-yield"))->isVisible());
  slope->setValue(1.0);
  EXPECT_TRUE(change->text().startsWith(u'!')) << change->text().toStdString();
  const auto line = press(dialog);
  EXPECT_TRUE(line.starts_with("!")) << line;
  EXPECT_NE(line.find("its largest force was 4.96 N and is 4.41 N"), std::string::npos) << line;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "cut.json"));
  const auto more = dialog.findChild<NoteList*>(QStringLiteral("more"))->text();
  EXPECT_TRUE(more.contains(QStringLiteral("to 1.00 N per travel unit"))) << more.toStdString();
  tests::photographInAllThemes(dialog, QStringLiteral("import-altered"));
}

TEST_F(MeasurementTest, ImportsATableThatAColumnsFileDescribes) {
  ImportCutDialog dialog;
  set(dialog, "recording", folder_.write("table.txt", tests::textOf({})));
  set(dialog, "columns", folder_.write("columns.json", R"({
        "format": "palpate-columns-1",
        "separator": "tab",
        "time": {"column": 5, "unit": "ms"},
        "travel": {"column": 4, "open": 0, "closed": 10},
        "force": {"column": 1, "unit": "N", "factor": 0.005}})"));
  set(dialog, "target", folder_ / "cut.json");
  const auto words = dialog.findChild<RecordingPlot*>()->words();
  EXPECT_TRUE(words.contains(QStringLiteral("force in newtons"))) << words.toStdString();
  EXPECT_TRUE(press(dialog).starts_with("✓"));
  const auto cut = tests::contentOf(folder_ / "cut.json");
  EXPECT_NE(cut.find(R"("calibration": "newtons")"), std::string::npos) << cut;
}

TEST_F(MeasurementTest, AsksForTheColumnsOfAnotherTableAndImportsIt) {
  std::string table = "load_mN;jaw_mm;t_s\n";
  const auto recording = previewOf(folder_.write("recording.txt", tests::textOf({})), {}).recording;
  for (const auto& row : recording.rows) {
    table += std::to_string(5.0 * row.reading) + ";" + std::to_string(0.6 * row.travel) + ";" +
             std::to_string(1e-3 * row.time) + "\n";
  }
  ImportCutDialog dialog;
  dialog.show();
  auto* form = dialog.findChild<ColumnsForm*>();
  EXPECT_FALSE(form->isVisible());
  set(dialog, "recording", folder_.write("table.csv", table));
  set(dialog, "target", folder_ / "cut.json");
  EXPECT_TRUE(form->isVisible()) << "the recorder did not write it";
  const auto chosen = [&](const char* name) {
    return form->findChild<QComboBox*>(QString::fromUtf8(name))->currentText().toStdString();
  };
  EXPECT_EQ(chosen("time"), "t_s");
  EXPECT_EQ(chosen("travel"), "jaw_mm");
  EXPECT_EQ(chosen("force"), "load_mN");
  EXPECT_TRUE(dialog.findChild<RecordingPlot*>()->isVisible());
  tests::photographInAllThemes(dialog, QStringLiteral("import-table"));
  form->findChild<QComboBox*>(QStringLiteral("time"))->setCurrentIndex(1);
  EXPECT_TRUE(dialog.findChild<QLabel*>(QStringLiteral("outcome"))->text().startsWith(u'✕'))
      << "the travel goes back";
  form->findChild<QComboBox*>(QStringLiteral("time"))->setCurrentIndex(2);
  const auto line = press(dialog);
  EXPECT_NE(line.find("Cut saved"), std::string::npos) << line;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "cut.json"));
}

/// A table of cuts as another laboratory may record them.
std::string tableOfCuts(bool hasTime) {
  const auto made = haptics::recordings::readRecording(tests::textOf({}));
  std::string table = hasTime ? "t_ms\tLoad cell [g]\tHandle [deg]\n" : "Load cell [g]\tHandle\n";
  for (const auto& row : made.rows) {
    if (hasTime) table += fmt::format("{}\t", row.time);
    table += fmt::format("{}\t{}\n", row.reading / 2.0, 48.0 - 4.2 * row.travel);
  }
  return table;
}

TEST_F(MeasurementTest, AsksForTheRateOfATableWithoutTime) {
  ImportCutDialog dialog;
  dialog.show();
  set(dialog, "recording", folder_.write("table.txt", tableOfCuts(false)));
  set(dialog, "target", folder_ / "cut.json");
  auto* form = dialog.findChild<ColumnsForm*>();
  ASSERT_TRUE(form->isVisible());
  const auto* obstacle = dialog.findChild<QLabel*>(QStringLiteral("obstacle"));
  EXPECT_EQ(obstacle->text(), QStringLiteral("Give the rows per second."));
  auto* rate = form->findChild<QDoubleSpinBox*>(QStringLiteral("rate"));
  ASSERT_TRUE(rate->isVisible()) << "in place of the unit of the time";
  rate->setValue(333.0);
  const auto& preview = dialog.findChild<RecordingPlot*>()->preview();
  ASSERT_TRUE(preview.has_value());
  EXPECT_NEAR(preview->survey.sampling.rate, 333.0, 0.5);
  EXPECT_TRUE(press(dialog).find("Cut saved") != std::string::npos);
}

TEST_F(MeasurementTest, SaysWhyACutHasNoYield) {
  std::string table = "t_s;jaw;load_N\n";
  constexpr int kRows = 500;  // of a cut, 2 ms each
  for (int row = 0; row < 3 * kRows; ++row) {
    const double phase = 2.0 * std::numbers::pi * row / kRows;
    const double travel = 5.0 - 5.0 * std::cos(phase);
    const double closing = travel < 6.5 ? 3.0 * std::max(0.0, travel - 3.0)
                                        : std::max(1.5, 10.5 - 9.0 * (travel - 6.5));
    const double force = std::sin(phase) > 0.0 ? closing : 0.0;
    table += fmt::format("{};{};{}\n", 2e-3 * row, travel, force);
  }
  ImportCutDialog dialog;
  dialog.show();
  set(dialog, "recording", folder_.write("table.csv", table));
  const auto* landmarks = dialog.findChild<QTableWidget*>(QStringLiteral("cut-landmarks"));
  ASSERT_EQ(landmarks->rowCount(), 4);
  EXPECT_EQ(landmarks->item(1, 2)->text(), QStringLiteral("–")) << "a seventh of the load is left";
  EXPECT_TRUE(dialog.findChild<QLabel*>(QStringLiteral("no-yield"))->isVisible());
}

TEST_F(MeasurementTest, StaysOnTheScreenAsItGrows) {
  ImportCutDialog dialog;
  dialog.show();
  const QRect room = dialog.screen()->availableGeometry();
  dialog.resize(dialog.minimumSizeHint());
  dialog.move(room.bottomRight() - QPoint(dialog.width() - 1, dialog.height() - 1));
  const auto before = dialog.geometry();
  set(dialog, "recording", folder_.write("table.txt", tableOfCuts(true)));
  QTest::qWait(1);
  const QRect frame = dialog.frameGeometry();
  EXPECT_GT(frame.height(), before.height());
  EXPECT_LE(frame.bottom(), room.bottom());
  EXPECT_GE(frame.top(), room.top());
  EXPECT_EQ(frame.left(), std::max(room.left(), room.right() - frame.width() + 1));
}

TEST_F(MeasurementTest, SaysThatARecordingIsTooLargeToBeRead) {
  const auto file = folder_.write("table.csv", "t_s;jaw_mm;load_mN\n");
  std::filesystem::resize_file(file, haptics::recordings::kLargestRecording + 1);
  ImportCutDialog dialog;
  ASSERT_NO_THROW(set(dialog, "recording", file));
  EXPECT_TRUE(dialog.findChild<QLabel*>(QStringLiteral("outcome"))->text().startsWith(u'✕'));
  const auto more = dialog.findChild<NoteList*>(QStringLiteral("more"))->text();
  EXPECT_TRUE(more.contains(QStringLiteral("larger than 200 MB"))) << more.toStdString();
}

TEST_F(MeasurementTest, ImportsTheChosenOneOfTwoColumnsWithTheSameHeading) {
  const auto file = folder_.write(
      "table.csv", "t_s;jaw;jaw;load_N\n0;5;0;0\n0.1;5;2;0.5\n0.2;5;8;1\n0.3;5;10;2\n");
  ColumnsForm form;
  ASSERT_TRUE(form.offerColumnsOf(file));
  form.findChild<QComboBox*>(QStringLiteral("travel"))->setCurrentIndex(2);
  const auto recording = readRecordingWithColumns(file, form.columns());
  ASSERT_EQ(recording.rows.size(), 4U);
  EXPECT_EQ(recording.rows[1].travel, 2.0);
  EXPECT_EQ(recording.refusedCount, 0U) << "the headings are no row";
}

TEST_F(MeasurementTest, NoLongerSaysThatThereIsNoCutOnceOneIsChosen) {
  ImportCutDialog dialog;
  set(dialog, "recording", folder_.write("saturated.txt", tests::textOf({.scales = {10.0, 10.0}})));
  dialog.show();
  const auto* line = dialog.findChild<QLabel*>(QStringLiteral("outcome"));
  EXPECT_TRUE(line->text().startsWith(u'!')) << "no cut is typical";
  dialog.findChild<QSpinBox*>()->setValue(1);
  EXPECT_EQ(line->text(), QString());
  EXPECT_TRUE(dialog.findChild<QPushButton*>(QStringLiteral("go"))->isEnabled());
}

TEST_F(MeasurementTest, SaysWhatIsWrongInAColumnsFile) {
  const auto recording = folder_.write("table.txt", tests::textOf({}));
  const auto columns = folder_.write("columns.json", R"({"format": "palpate-columns-1"})");
  ImportCutDialog dialog;
  set(dialog, "recording", recording);
  set(dialog, "columns", columns);
  EXPECT_EQ(
      dialog.findChild<QLabel*>(QStringLiteral("outcome"))->text(),
      QStringLiteral("✕  This recording cannot be read"));
  EXPECT_THROW(columnsIn(columns), UserError);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "cut.json"));
}

TEST_F(MeasurementTest, FitsAMaterialToAFolderOfSeries) {
  std::filesystem::create_directory(folder_ / "series");
  using haptics::reaming::TestSet;
  for (const auto set : {TestSet::Static, TestSet::Dynamic1, TestSet::Dynamic2}) {
    const auto series = haptics::reaming::syntheticSeries({.set = set});
    folder_.write(
        "series/specimen-1-" + std::string(nameOf(set)) + ".csv", haptics::reaming::asText(series));
  }
  FitMaterialDialog dialog;
  set(dialog, "series", folder_ / "series");
  set(dialog, "target", folder_ / "bone.json");
  EXPECT_TRUE(press(dialog).starts_with("✓"));
  const auto more = dialog.findChild<NoteList*>(QStringLiteral("more"))->text();
  EXPECT_TRUE(more.startsWith(QStringLiteral("!  Synthetic"))) << more.toStdString();
  const auto& errors = dialog.findChild<ResultView*>()->table();
  ASSERT_EQ(errors.rows.size(), 3U) << "one of each test";
  EXPECT_EQ(errors.rows[1][0], Cell(std::string("dynamic-1")));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "bone.json"));
  EXPECT_TRUE(press(dialog).starts_with("✓")) << "fitted again, to the next free name";
  EXPECT_TRUE(std::filesystem::exists(folder_ / "bone-2.json"));
  tests::photographInAllThemes(dialog, QStringLiteral("fit-material-done"));
}

TEST_F(MeasurementTest, RejectsASeriesWithoutATestInItsName) {
  folder_.write("series.csv", "time_s,displacement_mm,force_n\n0,0,0\n1,1,1\n2,2,2\n");
  try {
    fitMaterialTo(folder_.path().string(), "x", folder_ / "m.json", {});
    FAIL() << "was not refused";
  } catch (const UserError& error) {
    EXPECT_NE(std::string(error.what()).find("series.csv"), std::string::npos) << error.what();
  }
}

TEST_F(MeasurementTest, FillsACupWithTheRequestedNumberOfSpheres) {
  BuildBoneDialog dialog;
  dialog.findChild<QSpinBox*>(QStringLiteral("spheres"))->setValue(400);
  set(dialog, "target", folder_ / "cup.packing");
  EXPECT_TRUE(press(dialog).starts_with("✓"));
  const auto more = dialog.findChild<NoteList*>(QStringLiteral("more"))->text();
  EXPECT_TRUE(more.startsWith(QStringLiteral("400 spheres"))) << more.toStdString();
}

TEST_F(MeasurementTest, LeavesNoFileAfterCancelling) {
  int told = 0;
  const auto giveUp = [&](double, const std::string&) {
    if (++told == 3) throw Cancelled();
  };
  EXPECT_THROW(buildBoneTo(20'000, 1, folder_ / "cup.packing", giveUp), Cancelled);
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

TEST_F(MeasurementTest, OverwritesNoFile) {
  const auto mine = folder_.write("cup.packing", "mine");
  EXPECT_THROW(buildBoneTo(400, 1, mine, {}), storage::StorageError);
  EXPECT_EQ(tests::contentOf(mine), "mine");
}

}  // namespace measurement_test
}  // namespace study::gui
