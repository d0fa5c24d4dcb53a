#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/export/column.h"
#include "study/export/export.h"

namespace study {

/// The study, the version of the protocol, the program, and whether the export is blinded: a JSON
/// object.
std::string exportMetadataAsJson(Study& study, const ExportOptions& options);

/// Whether the folder is blinded, as a line of its README.
std::string codesInWords(Study& study, const ExportOptions& options);

/// The README of a folder. @p sessions is the number of its sessions; @p responses is the table of
/// answers, by its path in the folder.
std::string readmeOf(
    Study& study, const ExportOptions& options, std::size_t sessions, const std::string& responses);

/// The readers of a folder made with @p options.
Readers readersOf(Study& study, const ExportOptions& options);

/// All tables for @p options. The first has a row per session or person.
std::vector<ExportedTable> tablesFor(Study& study, const ExportOptions& options);

/// Writes the study in the Psych-DS layout (psych-ds.github.io): tables with data dictionaries in
/// data/, the questionnaires in materials/. Unblinded, the protocol is included, which explains the
/// codes.
/// @return  the number of sessions.
std::size_t writePsychDs(
    Study& study, const std::filesystem::path& folder, const ExportOptions& options);

/// Writes the study in the BIDS layout: sub-<label>/ses-<label>/beh/, tab-separated tables with a
/// dictionary each.
/// @return  the number of sessions.
std::size_t writeBids(
    Study& study, const std::filesystem::path& folder, const ExportOptions& options);

/// A label for names of files: the letters and digits of @p text.
std::string bidsLabel(const std::string& text);

/// Writes the scripts for @p options: for R or Python one that reads the tables with their types;
/// unblinded also one that computes the statistics table again from the responses.
void writeScripts(const std::filesystem::path& folder, const ExportOptions& options);

/// The 1 kHz traces of all trials that @p options choose, one gzip-compressed CSV each, as
/// `P001_session-1_step-07_attempt-1_force.csv.gz` in @p folder. The same study always gives the
/// same bytes. @return  the number of files.
/// @throws storage::StorageError  if one cannot be read or written.
std::size_t writeTraces(
    Study& study, const std::filesystem::path& folder, const ExportOptions& options);

}  // namespace study
