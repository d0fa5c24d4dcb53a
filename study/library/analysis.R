# Computes the numbers of the statistics and votes tables again, from the responses, with base R:
#   Rscript analysis.R [folder of the export; without it, the one that this script is in]
# For each kind of number it prints the largest distance from an exported one, relative to it, and how much is
# allowed. The last line is the verdict; the exit status is 0 if all agree, 1 if not, 2 if a table is missing.
# Allowed is 1e-9. It needs R alone. Mixed models are computed as well where lme4, lmerTest and ordinal are there
# (Debian: sudo apt install r-cran-lmertest r-cran-ordinal; elsewhere: install.packages(c("lmerTest",
# "ordinal"))); both programs search for the best fit, so that the linear one agrees to 1e-4 only. Of the ordinal
# one, whose search in R ends early, estimates agree to 5e-4 (of a standard error where they are smaller than that),
# odds ratios to 2e-3, standard errors and z to 3e-3, and p, which multiplies what z is off, to a twentieth.
# Where the packages are missing it says so and goes on. Not computed are omega, Friedman's permutations, means of
# scores and what was felt. The scores that a family compares are taken from the wide table; the codebook says how
# they are computed.

# The folder of this script, wherever it is started from.
own_folder <- function() {
  started <- sub("^--file=", "", grep("^--file=", commandArgs(), value = TRUE))
  sourced <- unlist(lapply(sys.frames(), function(frame) frame$ofile))
  file <- c(sourced, gsub("~+~", " ", started, fixed = TRUE))  # Rscript writes spaces as ~+~
  if (length(file) == 0) return(".")
  folder <- normalizePath(dirname(file[1]))
  # Psych-DS has scripts in a folder of their own, beside that of the tables.
  beside <- basename(folder) == "analysis" && length(list.files(folder, "[.]csv$")) == 0
  if (beside) dirname(folder) else folder
}
arguments <- commandArgs(trailingOnly = TRUE)
folder <- if (length(arguments) > 0) arguments[1] else own_folder()
table_of <- function(name) {
  path <- list.files(folder, paste0("^(.*-)?", name, "(_data)?[.]csv$"), recursive = TRUE, full.names = TRUE)
  if (length(path) == 0) {
    message("analysis.R: the table '", name, "' is not in ", folder, ". It needs the folder of an unblinded export ",
            "as it was written:\n  Rscript analysis.R FOLDER")
    quit(status = 2)
  }
  table <- read.csv(path[1], na.strings = "", colClasses = "character", encoding = "UTF-8")
  ids <- c("participant_id", "cohort", "cohort2", "family_id", "instrument", "score", "block", "blocks", "item_id",
           "items", "preference")
  others <- setdiff(names(table), ids)  # an id of digits stays a word
  table[others] <- lapply(table[others], type.convert, as.is = TRUE, na.strings = "")
  table
}
responses <- table_of("responses")
statistics <- table_of("statistics")
# Only exports as CSV have the wide table; in others, families that compare a score are left out.
if (length(list.files(folder, "^wide[.]csv$", recursive = TRUE)) > 0) {
  wide <- table_of("wide")
} else {
  statistics <- statistics[is.na(statistics$family_id) | is.na(statistics$score), ]
}
responses <- responses[responses$included == "true" | responses$included == TRUE, ]
everything <- responses
responses <- responses[!is.na(responses$condition_code), ]
# Numbers of sliders and the like are reversed as points are: by the ends of their range.
items <- table_of("items")
asked <- items[match(paste(responses$instrument, responses$item_id), paste(items$instrument, items$item_id)), ]
given <- suppressWarnings(as.numeric(responses$response))
keyed <- ifelse(asked$key == -1, asked$lowest + asked$highest - given, given)
responses$response_keyed <- ifelse(is.na(responses$response_keyed), keyed, responses$response_keyed)

worst <- c()
# Relative to the exported number, or to what is least where that is nearer to zero.
check <- function(row, column, value, least = 1e-3) {
  expected <- as.numeric(row[[column]])
  if (is.na(expected)) return(invisible())
  distance <- abs(value - expected) / max(abs(expected), least)
  if (is.na(distance)) distance <- Inf
  name <- paste(row$method, column)
  worst[name] <<- max(distance, if (name %in% names(worst)) worst[name] else 0)
}

# A family's score as the answer to one item.
scored <- function(row) {
  column <- gsub("[^A-Za-z0-9]", "_", paste0(row$instrument, "__score_", row$score))
  answers <- wide[!is.na(wide[[column]]), ]
  answers$instrument <- row$instrument
  answers$item_id <- row$score
  answers$response_keyed <- answers[[column]]
  answers
}
# A family may compare some of the conditions that its questionnaire was answered about.
conditions_of <- function(row) {
  rows <- statistics[statistics$family_id %in% row$family_id & statistics$run_mode == row$run_mode, ]
  unique(c(rows$group1, rows$group2))
}
answers_to <- function(row, cohort) {
  blocks <- strsplit(row$blocks, " ")[[1]]
  items <- strsplit(row$items, " ")[[1]]
  if (!is.na(row$score)) {
    responses <- scored(row)
    items <- row$score
  }
  responses[responses$run_mode == row$run_mode & responses$cohort == cohort &
              responses$instrument == row$instrument & responses$block %in% blocks &
              responses$item_id %in% items & responses$condition_code %in% conditions_of(row), ]
}
scores <- function(row, group) {
  answers <- answers_to(row, row$cohort)
  answers$response_keyed[answers$condition_code == group]
}
# Means of a few whole numbers, without the rounding of their last digits.
means <- function(row, group, cohort = row$cohort) {
  answers <- answers_to(row, cohort)
  answers <- answers[answers$condition_code == group, ]
  tapply(answers$response_keyed, answers$participant_id, mean)
}
differences <- function(row) {
  first <- means(row, row$group1)
  second <- means(row, row$group2)
  both <- intersect(names(first), names(second))
  list(first = first[both], second = second[both], d = round(first[both] - second[both], 12))
}

# All choices of signs, a row each.
signs <- function(n) as.matrix(expand.grid(rep(list(c(-1, 1)), n)))

welch <- function(row) {
  x <- scores(row, row$group1)
  y <- scores(row, row$group2)
  check(row, "n1", length(x)); check(row, "n2", length(y))
  check(row, "mean1", mean(x)); check(row, "mean2", mean(y))
  check(row, "sd1", sd(x)); check(row, "sd2", sd(y))
  test <- t.test(x, y, conf.level = row$conf_level)
  check(row, "estimate", mean(x) - mean(y)); check(row, "se", test$stderr)
  check(row, "statistic", test$statistic); check(row, "df", test$parameter); check(row, "p", test$p.value)
  check(row, "conf_low", test$conf.int[1]); check(row, "conf_high", test$conf.int[2])
  adjusted <- t.test(x, y, conf.level = 1 - row$alpha_per_test)
  check(row, "conf_low_adj", adjusted$conf.int[1]); check(row, "conf_high_adj", adjusted$conf.int[2])
  test$p.value
}

paired_t <- function(row) {
  pairs <- differences(row)
  n <- length(pairs$d)
  check(row, "n1", n)
  check(row, "mean1", mean(pairs$first)); check(row, "mean2", mean(pairs$second))
  test <- t.test(pairs$d, conf.level = row$conf_level)
  check(row, "estimate", mean(pairs$d)); check(row, "se", test$stderr)
  check(row, "statistic", test$statistic); check(row, "df", test$parameter); check(row, "p", test$p.value)
  check(row, "conf_low", test$conf.int[1]); check(row, "conf_high", test$conf.int[2])
  adjusted <- t.test(pairs$d, conf.level = 1 - row$alpha_per_test)
  check(row, "conf_low_adj", adjusted$conf.int[1]); check(row, "conf_high_adj", adjusted$conf.int[2])
  df <- n - 1
  j <- exp(lgamma(df / 2) - lgamma((df - 1) / 2)) / sqrt(df / 2)
  check(row, "effect", j * mean(pairs$d) / sd(pairs$d))
  test$p.value
}

most_signs <- 18  # 2^18 choices; beyond, nothing is computed again
sign_flip <- function(row) {
  d <- differences(row)$d
  if (length(d) > most_signs) return(NA)
  sums <- signs(length(d)) %*% d
  mean(abs(sums) >= abs(sum(d)) - 1e-9)
}

signed_rank <- function(row) {
  d <- differences(row)$d
  d <- d[abs(d) > 1e-9]
  ranks <- rank(round(abs(d), 9))
  v <- sum(ranks[d > 0])
  check(row, "statistic", v); check(row, "effect", (2 * v - sum(ranks)) / sum(ranks))
  every <- differences(row)$d
  averages <- outer(every, every, "+") / 2
  check(row, "estimate", median(averages[upper.tri(averages, diag = TRUE)]))
  if (length(d) > most_signs) return(NA)
  all <- (signs(length(d)) > 0) %*% ranks
  min(1, 2 * min(mean(all <= v + 1e-9), mean(all >= v - 1e-9)))
}

tost <- function(row) {
  d <- differences(row)$d
  n <- length(d); error <- sd(d) / sqrt(n)
  check(row, "n1", n); check(row, "estimate", mean(d)); check(row, "se", error); check(row, "df", n - 1)
  max(pt((mean(d) + row$equivalence_bound) / error, n - 1, lower.tail = FALSE),
      pt((mean(d) - row$equivalence_bound) / error, n - 1))
}

# Rouder et al. 2009, with g = e^u and the scale sqrt(2) / 2.
bayes_factor <- function(row) {
  d <- differences(row)$d
  n <- length(d); df <- n - 1
  square <- (mean(d) / (sd(d) / sqrt(n)))^2
  of <- function(u) {
    g <- exp(u); spread <- 1 + n * g / 2
    spread^-0.5 * (1 + square / (spread * df))^(-(df + 1) / 2) * (2 * pi)^-0.5 * g^-0.5 * exp(-1 / (2 * g))
  }
  parts <- sapply(seq(-6, 59, 5), function(a) integrate(of, a, a + 5, rel.tol = 1e-12, abs.tol = 0)$value)
  check(row, "n1", n); check(row, "effect", sum(parts) / (1 + square / df)^(-(df + 1) / 2))
  NA
}

friedman <- function(row) {
  answers <- answers_to(row, row$cohort)
  groups <- strsplit(row$groups, " ")[[1]]
  cells <- tapply(answers$response_keyed, list(answers$participant_id, answers$condition_code), mean)
  cells <- round(cells[, groups, drop = FALSE], 12)
  cells <- cells[complete.cases(cells), , drop = FALSE]
  check(row, "n1", nrow(cells))
  if (nrow(cells) < 2) return(NA)  # R takes no table of one line
  test <- friedman.test(cells)
  check(row, "statistic", test$statistic); check(row, "df", test$parameter)
  test$p.value
}

mann_whitney <- function(row) {
  x <- round(means(row, row$group1), 12)
  y <- round(means(row, row$group1, row$cohort2), 12)
  ranks <- rank(c(x, y))
  n <- length(x)
  u <- sum(ranks[seq_len(n)]) - n * (n + 1) / 2
  check(row, "n1", n); check(row, "n2", length(y)); check(row, "statistic", u)
  delta <- mean(sign(outer(x, y, "-")))
  check(row, "effect", delta)
  if (choose(length(ranks), n) > 2e5) return(NA)
  all <- combn(length(ranks), n, function(chosen) sum(ranks[chosen])) - n * (n + 1) / 2
  min(1, 2 * min(mean(all <= u + 1e-9), mean(all >= u - 1e-9)))
}

brunner_munzel <- function(row) {
  x <- round(means(row, row$group1), 12)
  y <- round(means(row, row$group1, row$cohort2), 12)
  n <- length(x); m <- length(y)
  all <- rank(c(x, y)); rx <- all[seq_len(n)]; ry <- all[-seq_len(n)]
  sx <- var(rx - rank(x)); sy <- var(ry - rank(y))
  w <- n * m * (mean(ry) - mean(rx)) / ((n + m) * sqrt(n * sx + m * sy))
  df <- (n * sx + m * sy)^2 / ((n * sx)^2 / (n - 1) + (m * sy)^2 / (m - 1))
  check(row, "n1", n); check(row, "n2", m); check(row, "statistic", w); check(row, "df", df)
  2 * pt(-abs(w), df)
}

cells_of <- function(row) {
  answers <- answers_to(row, row$cohort)
  groups <- strsplit(row$groups, " ")[[1]]
  cells <- tapply(answers$response_keyed, list(answers$participant_id, answers$condition_code), mean)
  cells[, groups, drop = FALSE]
}

rm_anova <- function(row) {
  cells <- cells_of(row)
  cells <- cells[complete.cases(cells), , drop = FALSE]
  n <- nrow(cells)
  long <- data.frame(y = as.vector(cells), person = factor(rep(seq_len(n), ncol(cells))),
                     group = factor(rep(seq_len(ncol(cells)), each = n)))
  within <- summary(aov(y ~ group + Error(person / group), long))[["Error: person:group"]][[1]]
  check(row, "n1", n); check(row, "statistic", within[1, "F value"])
  check(row, "df", within[1, "Df"]); check(row, "df2", within[2, "Df"])
  check(row, "effect", within[1, "Sum Sq"] / sum(within[, "Sum Sq"]))
  centred <- diag(ncol(cells)) - 1 / ncol(cells)
  spread <- centred %*% cov(cells) %*% centred
  epsilon <- sum(diag(spread))^2 / ((ncol(cells) - 1) * sum(spread^2))
  check(row, "epsilon", epsilon)
  check(row, "p_epsilon", pf(within[1, "F value"], epsilon * within[1, "Df"], epsilon * within[2, "Df"],
                             lower.tail = FALSE))
  within[1, "Pr(>F)"]
}

order_slope <- function(row) {
  answers <- answers_to(row, row$cohort)
  answers$rest <- answers$response_keyed - ave(answers$response_keyed, answers$condition_code)
  by <- aggregate(rest ~ participant_id + position, answers, mean)
  slopes <- sapply(split(by, by$participant_id), function(own)
    if (nrow(own) > 1) cov(own$position, own$rest) / var(own$position) else NA)
  slopes <- slopes[!is.na(slopes)]
  test <- t.test(slopes, conf.level = row$conf_level)
  check(row, "n1", length(slopes)); check(row, "estimate", mean(slopes)); check(row, "se", test$stderr)
  check(row, "statistic", test$statistic); check(row, "df", test$parameter)
  check(row, "conf_low", test$conf.int[1]); check(row, "conf_high", test$conf.int[2])
  test$p.value
}

cronbach_alpha <- function(row) {
  answers <- answers_to(row, row$cohort)
  answers <- answers[answers$condition_code == row$group1, ]
  cells <- tapply(answers$response_keyed, list(answers$participant_id, answers$item_id), mean)
  cells <- cells[complete.cases(cells), , drop = FALSE]
  n <- nrow(cells); k <- ncol(cells)
  alpha <- k / (k - 1) * (1 - sum(apply(cells, 2, var)) / var(rowSums(cells)))
  check(row, "n1", n); check(row, "effect", alpha)
  tail <- (1 - row$conf_level) / 2  # Feldt
  check(row, "effect_low", 1 - (1 - alpha) * qf(1 - tail, n - 1, (n - 1) * (k - 1)))
  check(row, "effect_high", 1 - (1 - alpha) * qf(tail, n - 1, (n - 1) * (k - 1)))
  NA
}

shapiro_wilk <- function(row) {
  test <- shapiro.test(round(means(row, row$group1), 12))
  check(row, "statistic", test$statistic)
  test$p.value
}

brown_forsythe <- function(row) {
  cells <- round(cells_of(row), 12)
  away <- abs(sweep(cells, 2, apply(cells, 2, median, na.rm = TRUE)))
  long <- data.frame(y = as.vector(away), group = factor(col(away)))
  found <- anova(lm(y ~ group, long))
  check(row, "statistic", found[1, "F value"]); check(row, "df", found[1, "Df"]); check(row, "df2", found[2, "Df"])
  found[1, "Pr(>F)"]
}

# The same models as ours, fitted by others: score ~ method [+ round] + (1 | person) [+ (1 | taste)].
needs <- c(mixed_model = "lmerTest", ordinal_model = "ordinal")
absent <- needs[!sapply(needs, requireNamespace, quietly = TRUE)]
fits <- list()
fit_of <- function(row) {
  name <- paste(row$method, row$run_mode, row$cohort, row$family_id)
  if (is.null(fits[[name]])) {
    answers <- answers_to(row, row$cohort)
    data <- data.frame(score = answers$response_keyed, method = factor(answers$condition_code),
                       round = factor(answers$block), person = factor(answers$participant_id))
    data$taste <- interaction(data$person, data$method, drop = TRUE)
    formula <- paste0("score ~ method", if (nlevels(data$round) > 1) " + round", " + (1 | person)",
                      if (nlevels(data$taste) < nrow(data)) " + (1 | taste)")
    if (row$method == "mixed_model") {
      fit <- lmerTest::lmer(as.formula(formula), data, control = lme4::lmerControl(
        optimizer = "bobyqa", optCtrl = list(rhobeg = 0.1, rhoend = 1e-10)))
    } else {
      data$score <- factor(data$score)
      fit <- ordinal::clmm(as.formula(formula), data)
    }
    fits[[name]] <<- list(fit = fit, levels = levels(data$method))
  }
  fits[[name]]
}
# Weights of group1 - group2 among the coefficients, the first level of a factor being the base.
weights_of <- function(row, names) {
  weights <- setNames(rep(0, length(names)), names)
  if (paste0("method", row$group1) %in% names) weights[paste0("method", row$group1)] <- 1
  if (paste0("method", row$group2) %in% names) weights[paste0("method", row$group2)] <- -1
  weights
}
mixed_model <- function(row) {
  fit <- fit_of(row)$fit
  found <- lmerTest::contest(fit, weights_of(row, names(lme4::fixef(fit))), joint = FALSE)
  check(row, "estimate", found[, "Estimate"]); check(row, "se", found[, "Std. Error"])
  check(row, "statistic", found[, "t value"]); check(row, "df", found[, "df"])
  found[, "Pr(>|t|)"]
}
ordinal_model <- function(row) {
  fit <- fit_of(row)$fit
  weights <- weights_of(row, names(fit$beta))
  estimate <- sum(weights * fit$beta)
  error <- sqrt(c(weights %*% vcov(fit)[names(weights), names(weights)] %*% weights))
  check(row, "estimate", estimate, least = error); check(row, "se", error)
  check(row, "statistic", estimate / error, least = 1)
  check(row, "effect", exp(estimate))
  2 * pnorm(-abs(estimate / error))
}

adjustments <- c(bonferroni = "bonferroni", holm = "holm", hochberg = "hochberg",
                 hommel = "hommel", bh = "BH", by = "BY", none = "none")
adjusted <- function(p, method) {
  if (method != "holm-sidak") return(p.adjust(p, adjustments[[method]]))
  order <- order(p)
  steps <- 1 - (1 - p[order])^(length(p) - seq_along(p) + 1)
  pmin(1, cummax(steps))[order(order)]
}

tests <- list(welch = welch, paired_t = paired_t, sign_flip = sign_flip, signed_rank = signed_rank,
              friedman = friedman, mann_whitney = mann_whitney, rm_anova = rm_anova,
              mixed_model = mixed_model, ordinal_model = ordinal_model,
              brunner_munzel = brunner_munzel, tost = tost, bayes_factor = bayes_factor,
              order_slope = order_slope, cronbach_alpha = cronbach_alpha,
              shapiro_wilk = shapiro_wilk, brown_forsythe = brown_forsythe)
statistics$again <- NA
for (i in seq_len(nrow(statistics))) {
  row <- statistics[i, ]
  if (is.null(tests[[row$method]]) || (is.na(row$p) && is.na(row$effect))) next
  if (row$method %in% names(absent)) next
  p <- if (!(row$method %in% names(needs))) tests[[row$method]](row) else tryCatch(
    tests[[row$method]](row), error = function(e) {
      cat("Not computed again: ", row$method, " of ", row$cohort, ": ", conditionMessage(e), "\n", sep = "")
      NA
    })
  statistics$again[i] <- p
  if (!is.na(p)) check(row, "p", p)
}
# A test that is not defined does not count in the correction.
defined <- statistics[!is.na(statistics$p), ]
for (rows in split(defined, with(defined, paste(run_mode, cohort, family_id, method)))) {
  if (anyNA(rows$again) || anyNA(rows$p_adj)) next
  p <- adjusted(rows$again, rows$p_adj_method[1])
  for (i in seq_len(nrow(rows))) check(rows[i, ], "p_adj", p[i])
}
# How often each rendering was preferred. Who said "2" meant what they had felt as Alternative 2.
votes <- table_of("votes")
trials <- table_of("trials")
key_of <- function(table, block, label) paste(table$participant_id, table$session_num, block, label)
felt_as <- setNames(trials$condition_code, key_of(trials, trials$block, trials$alternative))
# Of several sites the table has also the votes of each.
sites_of <- function(table) if (is.null(table$site)) rep(NA, nrow(table)) else table$site
is_of_site <- function(row) if (is.na(sites_of(row))) TRUE else everything$site == row$site
cast <- function(row) {
  r <- everything[everything$run_mode == row$run_mode & everything$cohort == row$cohort &
                    everything$block == row$preference & is_of_site(row) &
                    everything$item_id %in% strsplit(row$item_id, " ")[[1]], ]
  felt_as[key_of(r, row$block, r$response)]
}
# All ways in which n votes may fall on k renderings, a row each.
outcomes <- function(n, k) {
  if (k == 1) return(matrix(n, 1, 1))
  do.call(rbind, lapply(0:n, function(v) cbind(v, outcomes(n - v, k - 1))))
}
equal_shares <- function(counts) {
  n <- sum(counts)
  k <- length(counts)
  if (choose(n + k - 1, k - 1) > 2e5) return(NA)
  terms <- apply(outcomes(n, k), 1, dmultinom, prob = rep(1 / k, k))
  sum(terms[terms <= dmultinom(counts, prob = rep(1 / k, k)) * (1 + 1e-9)])
}
most_votes <- function(rows) {
  given <- cast(rows[1, ])
  counts <- sapply(rows$condition_code, function(code) sum(given == code, na.rm = TRUE))
  n <- sum(counts)
  rows$method <- "votes"
  p <- if (n > 0) equal_shares(counts) else NA
  for (i in seq_along(counts)) {
    row <- rows[i, ]
    v <- counts[[i]]
    check(row, "votes", v); check(row, "votes_total", n)
    if (n == 0) next
    wilson <- suppressWarnings(prop.test(v, n, conf.level = row$conf_level, correct = FALSE)$conf.int)
    exact <- binom.test(v, n, conf.level = row$conf_level)$conf.int
    check(row, "share", v / n)
    check(row, "share_low", wilson[1]); check(row, "share_high", wilson[2])
    check(row, "share_low_exact", exact[1]); check(row, "share_high_exact", exact[2])
    expected <- n / length(counts)
    chi2 <- sum((counts - expected)^2 / expected)
    check(row, "chi2", chi2); check(row, "chi2_df", length(counts) - 1)
    check(row, "p_chi2", pchisq(chi2, length(counts) - 1, lower.tail = FALSE))
    if (!is.na(p)) check(row, "p_exact", p)
  }
}
for (rows in split(votes, paste(votes$run_mode, votes$cohort, sites_of(votes), votes$preference))) most_votes(rows)

# How far a number may be off.
searched <- list(
  mixed_model = function(column) 1e-4,
  ordinal_model = function(column) c(estimate = 5e-4, effect = 2e-3, se = 3e-3, statistic = 3e-3, p = 5e-2,
                                     p_adj = 5e-2)[[column]])
parts <- strsplit(names(worst), " ")
is_searched <- sapply(parts, function(part) part[1] %in% names(searched)) == TRUE
allowed <- sapply(parts, function(part)
  if (part[1] %in% names(searched)) searched[[part[1]]](part[2]) else 1e-9)
for (i in order(names(worst))) cat(sprintf("%-28s %.1e, allowed %.0e\n", names(worst)[i], worst[i], allowed[i]))
if (length(absent) > 0) {
  cat("Not computed again: ", paste(names(absent), collapse = ", "), ", without ", paste(absent, collapse = " and "),
      ".\nGet it with 'sudo apt install r-cran-lmertest r-cran-ordinal' (Debian, Ubuntu) or\n",
      "install.packages(c(\"lmerTest\", \"ordinal\")) in R.\n", sep = "")
}
is_off <- worst > allowed
if (length(worst) == 0) {
  cat("NOTHING was computed again: the tables have no number that this script knows\n")
} else if (any(is_off)) {
  cat("DIFFER:", sum(is_off), "of", length(worst), "kinds of numbers:", paste(names(worst)[is_off], collapse = ", "),
      "\n")
} else {
  cat("AGREE: all", length(worst), "kinds of numbers;", sum(!is_searched), "of them to 1e-09")
  if (any(is_searched)) cat(",", sum(is_searched), "of fitted models to the tolerances above")
  cat("\n")
}
quit(status = if (length(worst) == 0 || any(is_off)) 1 else 0)
