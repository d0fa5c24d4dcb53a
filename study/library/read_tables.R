# Reads the tables of this folder with their types: whole and other numbers, times in UTC, true and
# false, closed lists as factors in the order of columns.csv. With base R.
#   source("read_tables.R"); data <- read_tables("."); summary(data$responses)
#   Rscript read_tables.R [folder; without it, its own]      says what is there, and the means by condition code

read_tables <- function(folder = ".") {
  read <- function(name) {
    read.csv(file.path(folder, paste0(name, ".csv")), na.strings = "", colClasses = "character",
             encoding = "UTF-8", check.names = FALSE)
  }
  columns <- read("columns")
  typed <- function(values, about, where) {
    known <- values[!is.na(values)]
    levels <- about$value[!is.na(about$value)]
    if (length(levels) > 0) {
      strangers <- setdiff(known, levels)
      if (length(strangers) > 0) stop(where, " holds what is no value of it: ", strangers[1])
      return(factor(values, levels = levels))
    }
    result <- switch(about$type[1],
                     integer = , number = as.numeric(values),
                     boolean = values == "true",
                     date_time = as.POSIXct(values, format = "%Y-%m-%dT%H:%M:%OS", tz = "UTC"),
                     values)
    if (sum(is.na(result)) > sum(is.na(values))) stop(where, " holds what is no ", about$type[1])
    fits <- about$type[1] == "integer" && all(abs(result) <= .Machine$integer.max, na.rm = TRUE)
    if (fits) as.integer(result) else result
  }
  table_of <- function(name) {
    table <- read(name)
    for (column in names(table)) {
      about <- columns[columns$table == name & columns$column == column, ]
      table[[column]] <- typed(table[[column]], about, paste(name, column))
    }
    table
  }
  sapply(unique(columns$table), table_of, simplify = FALSE)
}

if (sys.nframe() == 0) {
  arguments <- commandArgs(trailingOnly = TRUE)
  own <- gsub("~+~", " ", sub("^--file=", "", grep("^--file=", commandArgs(), value = TRUE)), fixed = TRUE)
  data <- read_tables(if (length(arguments) > 0) arguments[1] else dirname(own))
  for (name in names(data)) cat(name, ":", nrow(data[[name]]), "rows,", ncol(data[[name]]), "columns\n")
  r <- data$responses
  if (!is.null(r$included)) r <- r[r$included, ]
  r <- r[r$item_type == "likert" & !is.na(r$condition_code), ]
  groups <- split(r$response_keyed, list(r$instrument, r$condition_code), drop = TRUE)
  for (name in names(groups)) {
    cat(sprintf("%s: n = %d, mean = %.6f, sd = %.6f\n", name, length(groups[[name]]),
                mean(groups[[name]]), sd(groups[[name]])))
  }
}
