#pragma once

#include <string>
#include <vector>

#include "study/export/export.h"
#include "study/export/k_anonymity.h"

namespace study {

/// The quasi-identifiers of the people of a study, generalised for release.
/// ExportOptions::publicClassSize must be set.
/// @throws storage::StorageError  if the study has fewer people than
/// ExportOptions::publicClassSize.
Release publicRelease(Study& study, const ExportOptions& options);

/// The tables of a public export: people with their released quasi-identifiers, and answers without
/// free text, times, dates or anything else that could identify a person. Ids and the order of rows
/// are random, so that they cannot be linked to the study.
/// @throws storage::StorageError  as publicRelease()
std::vector<ExportedTable> publicTables(Study& study, const ExportOptions& options);

/// The README of a public folder.
std::string publicReadme(Study& study, const ExportOptions& options, const Release& release);

/// The identifiability of participants in a few lines: the smallest class before and after
/// generalisation, and the columns that cause small classes.
std::string describe(const Release& release);

}  // namespace study
