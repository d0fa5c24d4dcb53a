# Reference values of `palpate stats test`: Rscript make_cases.R  ->  cases.json and the tables beside it
# R 4.2.2 alone. What R has no function for is enumerated or written out from its formula here; models are copied
# from ../study/study_golden.json (lme4, lmerTest, ordinal, clubSandwich).
file <- sub("^--file=", "", grep("^--file=", commandArgs(FALSE), value = TRUE))
if (length(file)) setwd(dirname(file))
write.table.csv <- function(d, name) write.csv(d, name, row.names = FALSE, quote = FALSE)

# --- tables ---------------------------------------------------------------------------------------------------------
groups <- data.frame(group = rep(c("a", "b", "c"), c(6, 5, 7)),
                     value = c(2.1, 3.4, 1.9, 4.4, 2.8, 3.1, 5.2, 4.9, 6.3, 3.9, 5.5, 4.1, 4.0, 2.2, 3.6, 5.8, 4.7, 3.3))
ratings <- data.frame(judge1 = c(9, 6, 8, 7, 10, 6), judge2 = c(2, 1, 4, 1, 5, 2),   # Shrout & Fleiss 1979, table 2
                      judge3 = c(5, 3, 6, 2, 6, 4), judge4 = c(8, 2, 8, 6, 9, 7))
yes.no <- data.frame(A = c(1, 1, 1, 1, 0, 1, 1, 1), B = c(0, 1, 0, 1, 0, 1, 0, 0), C = c(0, 1, 0, 0, 0, 1, 1, 0))
sorted <- data.frame(first = rep(c("student", "resident", "surgeon"), each = 3),
                     second = rep(c("poor", "fair", "good"), 3), count = c(4, 3, 1, 2, 4, 3, 0, 2, 6))
change2 <- data.frame(before = c("fem", "fem", "kalman", "kalman"), after = c("fem", "kalman", "fem", "kalman"), count = c(5, 9, 2, 7))
change3 <- data.frame(before = rep(c("fem", "kalman", "interpolation"), each = 3),
                      after = rep(c("fem", "kalman", "interpolation"), 3), count = c(6, 5, 1, 2, 8, 3, 4, 1, 7))
votes <- data.frame(option = rep(c("fem", "kalman", "interpolation"), c(2, 9, 4)))
answers <- subset(read.csv("../study/study_answers.csv"), cohort == "professional")[, c("participant", "method", "round", "score")]
for (name in c("groups", "ratings", "yes.no", "sorted", "change2", "change3", "votes", "answers"))
  write.table.csv(get(name), paste0(sub("\\.", "_", name), ".csv"))
sleep2 <- read.csv("../two/t23_sleep.csv"); x <- sleep2$x[sleep2$g == "a"]; y <- sleep2$x[sleep2$g == "b"]
pairs <- read.csv("../pair/p01_sleep.csv"); d <- round(pairs$x - pairs$y, 10)
blocks <- as.matrix(read.csv("../block/b02_prof6.csv")[, c("I", "F", "K")])

# --- writing --------------------------------------------------------------------------------------------------------
cases <- character()
number <- function(v) if (is.na(v)) "null" else sprintf("%.15g", v)
quoted <- function(s) paste0("\"", s, "\"")
object <- function(l) paste0("{", paste0(quoted(names(l)), ": ", vapply(l, function(v) if (is.character(v)) quoted(v) else number(v), ""), collapse = ", "), "}")
add <- function(.test, .file, .options = character(), ..., rows = NULL, tolerance = 1e-9) {
  expected <- if (is.null(rows)) paste0("\"expected\": ", object(list(...))) else paste0("\"comparisons\": [\n    ", paste(vapply(rows, object, ""), collapse = ",\n    "), "]")
  cases <<- c(cases, paste0("  {\"test\": ", quoted(.test), ", \"file\": ", quoted(.file), ", \"options\": [",
    paste(quoted(.options), collapse = ", ")[length(.options) > 0], "], \"tolerance\": ", number(tolerance), ",\n   ", expected, "}"))
}
two.sided <- function(p.less, p.greater) min(1, 2 * min(p.less, p.greater))

# --- two groups -----------------------------------------------------------------------------------------------------
w <- t.test(x, y)
s <- t.test(x, y, var.equal = TRUE)
# d = t / root, root from difference / standard error to difference / deviation; limits of the noncentrality by pt()
effects <- function(test, deviation) { t <- unname(test$statistic); df <- unname(test$parameter); root <- test$stderr / deviation
  limit <- function(p) uniroot(function(delta) pt(t, df, delta) - p, t + c(-6, 6), tol = 1e-13)$root
  J <- exp(lgamma(df / 2) - lgamma((df - 1) / 2)) / sqrt(df / 2)
  list(d = t * root, g = J * t * root, low = J * root * limit(0.975), high = J * root * limit(0.025)) }
shared <- list(glass_delta1 = (mean(x) - mean(y)) / sd(x), glass_delta2 = (mean(x) - mean(y)) / sd(y), common_language = pnorm((mean(x) - mean(y)) / sqrt(var(x) + var(y))))
e <- effects(w, sqrt((var(x) + var(y)) / 2))
do.call(add, c(list("welch", "../two/t23_sleep.csv", difference = mean(x) - mean(y), se = w$stderr, t = w$statistic, df = w$parameter, p = w$p.value, conf_low = w$conf.int[1], conf_high = w$conf.int[2],
    hedges_g_av = e$g, hedges_g_av_low = e$low, hedges_g_av_high = e$high, cohen_d_av = e$d), shared))
e <- effects(s, sqrt(((length(x) - 1) * var(x) + (length(y) - 1) * var(y)) / (length(x) + length(y) - 2)))
do.call(add, c(list("student", "../two/t23_sleep.csv", t = s$statistic, df = s$parameter, p = s$p.value,
    hedges_g = e$g, hedges_g_low = e$low, hedges_g_high = e$high, cohen_d = e$d), shared))
r <- rank(c(x, y)); sums <- combn(length(r), length(x), function(i) sum(r[i])); R <- sum(r[seq_along(x)])
u <- R - length(x) * (length(x) + 1) / 2
add("mann_whitney", "../two/t23_sleep.csv", U = u, p = two.sided(mean(sums <= R + 1e-9), mean(sums >= R - 1e-9)),
    cliff_delta = mean(sign(outer(x, y, "-"))), p_asymptotic = wilcox.test(x, y, correct = FALSE, exact = FALSE)$p.value,
    p_asymptotic_continuity = wilcox.test(x, y, exact = FALSE)$p.value)
bm <- local({ n1 <- length(x); n2 <- length(y); r1 <- r[1:n1]; r2 <- r[n1 + 1:n2]
  v1 <- var(r1 - rank(x)); v2 <- var(r2 - rank(y)); W <- n1 * n2 * (mean(r2) - mean(r1)) / (n1 + n2) / sqrt(n1 * v1 + n2 * v2)
  df <- (n1 * v1 + n2 * v2)^2 / ((n1 * v1)^2 / (n1 - 1) + (n2 * v2)^2 / (n2 - 1))
  list(W = W, df = df, p = 2 * pt(-abs(W), df), prob = (mean(r2) - (n2 + 1) / 2) / n1) })
add("brunner_munzel", "../two/t23_sleep.csv", W = bm$W, df = bm$df, p = bm$p, probability = bm$prob)
add("tost_groups", "../two/t23_sleep.csv", c("--bound", "3"), p = max(t.test(x, y, mu = -3, alternative = "greater")$p.value, t.test(x, y, mu = 3, alternative = "less")$p.value), df = w$parameter)
jzs <- function(t, df, n, r = sqrt(2) / 2) integrate(function(g) (1 + n * g * r^2)^(-1/2) * (1 + t^2 / ((1 + n * g * r^2) * df))^(-(df + 1) / 2) * (2 * pi)^(-1/2) * g^(-3/2) * exp(-1 / (2 * g)),
  0, Inf, rel.tol = 1e-11)$value / (1 + t^2 / df)^(-(df + 1) / 2)
add("bayes_factor_groups", "../two/t23_sleep.csv", bf10 = jzs(unname(s$statistic), unname(s$parameter), length(x) * length(y) / (length(x) + length(y))), tolerance = 1e-8)

# --- several groups -------------------------------------------------------------------------------------------------
a <- anova(lm(value ~ group, groups))
add("one_way_anova", "groups.csv", F = a$F[1], df = a$Df[1], df2 = a$Df[2], p = a$P[1], eta2 = a$Sum[1] / sum(a$Sum))
a <- anova(lm(abs(value - ave(value, group, FUN = median)) ~ group, groups))
add("brown_forsythe", "groups.csv", F = a$F[1], df = a$Df[1], df2 = a$Df[2], p = a$P[1])
q <- shapiro.test(groups$value)
add("shapiro_wilk", "groups.csv", c("--value", "value"), W = q$statistic, p = q$p.value, tolerance = 1e-6)

# --- pairs ----------------------------------------------------------------------------------------------------------
w <- t.test(pairs$x, pairs$y, paired = TRUE); n <- length(d); J <- exp(lgamma((n - 1) / 2) - lgamma((n - 2) / 2)) / sqrt((n - 1) / 2)
limit <- function(p) uniroot(function(ncp) pt(unname(w$statistic), n - 1, ncp) - p, c(-30, 30), tol = 1e-12)$root / sqrt(n) * J
add("paired_t", "../pair/p01_sleep.csv", n = n, difference = mean(d), se = w$stderr, t = w$statistic, df = w$parameter, p = w$p.value, conf_low = w$conf.int[1], conf_high = w$conf.int[2], g_z = mean(d) / sd(d) * J)
add("paired_t", "../pair/p01_sleep.csv", g_z_low = limit(.975), g_z_high = limit(.025), tolerance = 1e-6)
add("tost", "../pair/p01_sleep.csv", c("--bound", "2.5"), p = max(t.test(d, mu = -2.5, alternative = "greater")$p.value, t.test(d, mu = 2.5, alternative = "less")$p.value))
add("bayes_factor", "../pair/p01_sleep.csv", bf10 = jzs(unname(w$statistic), n - 1, n), tolerance = 1e-8)
pairs <- read.csv("../pair/p05_zeros_and_ties.csv"); d <- pairs$x - pairs$y; n <- length(d)
signs <- as.matrix(expand.grid(rep(list(c(-1, 1)), n)))
add("sign_flip", "../pair/p05_zeros_and_ties.csv", p = mean(abs(signs %*% abs(d)) >= abs(sum(d)) - 1e-9))
rank.test <- function(r) { V <- sum(r[d > 0]); all <- (signs[, d != 0] > 0) %*% r[d != 0]; list(V = V, p = two.sided(mean(all <= V + 1e-9), mean(all >= V - 1e-9)), b = (2 * V - sum(r[d != 0])) / sum(r[d != 0])) }
r0 <- numeric(n); r0[d != 0] <- rank(abs(d[d != 0])); q <- rank.test(r0); walsh <- outer(d, d, "+") / 2
add("signed_rank", "../pair/p05_zeros_and_ties.csv", V = q$V, p = q$p, rank_biserial = q$b, location = median(walsh[lower.tri(walsh, TRUE)]),
    p_asymptotic = suppressWarnings(wilcox.test(d, correct = FALSE, exact = FALSE)$p.value), p_asymptotic_continuity = suppressWarnings(wilcox.test(d, exact = FALSE)$p.value))
q <- rank.test(rank(abs(d)))
add("signed_rank_pratt", "../pair/p05_zeros_and_ties.csv", V = q$V, p = q$p, rank_biserial = q$b)
add("sign_test", "../pair/p05_zeros_and_ties.csv", p = binom.test(sum(d > 0), sum(d != 0))$p.value, positive = sum(d > 0), negative = sum(d < 0), zeros = sum(d == 0))

# --- a participant a line -------------------------------------------------------------------------------------------
permutations <- list(c(1, 2, 3), c(1, 3, 2), c(2, 1, 3), c(2, 3, 1), c(3, 1, 2), c(3, 2, 1))
permutation.p <- function(m) { R <- t(apply(m, 1, rank)); S <- matrix(0, 1, 3)
  for (i in seq_len(nrow(R))) S <- do.call(rbind, lapply(permutations, function(k) sweep(S, 2, R[i, k], "+")))
  centre <- mean(S[1, ]); mean(rowSums((S - centre)^2) >= sum((colSums(R) - centre)^2) - 1e-9) }
columns <- c("--columns", "I", "F", "K"); b <- nrow(blocks); k <- 3
q <- friedman.test(blocks); Q <- unname(q$statistic); f <- (b - 1) * Q / (b * (k - 1) - Q)
add("friedman", "../block/b02_prof6.csv", columns, chi2 = Q, df = q$parameter, p = q$p.value, kendall_w = Q / (b * (k - 1)), p_permutation = permutation.p(blocks),
    iman_davenport_f = f, iman_davenport_p = pf(f, k - 1, (k - 1) * (b - 1), lower.tail = FALSE))
R <- t(apply(blocks, 1, rank)); pairs3 <- list(c(1, 2), c(1, 3), c(2, 3)); names3 <- colnames(blocks)
rows <- lapply(pairs3, function(p) { z <- mean(R[, p[1]]) - mean(R[, p[2]]); q <- abs(z) / sqrt(k * (k + 1) / (6 * b)) * sqrt(2)
  list(group1 = names3[p[1]], group2 = names3[p[2]], mean_rank_difference = z, q = q, p = ptukey(q, k, Inf, lower.tail = FALSE)) })
add("nemenyi", "../block/b02_prof6.csv", columns, rows = rows, tolerance = 1e-7)
rows <- lapply(pairs3, function(p) { z <- colSums(R)[p[1]] - colSums(R)[p[2]]; t <- unname(z / sqrt(2 * (b * sum(R^2) - sum(colSums(R)^2)) / ((b - 1) * (k - 1))))
  list(group1 = names3[p[1]], group2 = names3[p[2]], t = t, p = 2 * pt(-abs(t), (b - 1) * (k - 1))) })
add("conover", "../block/b02_prof6.csv", columns, rows = rows)
m <- lm(blocks ~ 1); a <- anova(m, X = ~1, test = "Spherical"); S <- cov(blocks); C <- diag(k) - 1 / k; e <- C %*% S %*% C
ss <- anova(lm(c(blocks) ~ factor(rep(1:b, k)) + factor(rep(1:k, each = b))))
add("rm_anova", "../block/b02_prof6.csv", columns, F = a$F[1], df = a$"num Df"[1], df2 = a$"den Df"[1], p = a$"Pr(>F)"[1], partial_eta2 = ss$Sum[2] / sum(ss$Sum[2:3]),
    epsilon = sum(diag(e))^2 / ((k - 1) * sum(diag(e %*% e))), p_epsilon = a$"G-G Pr"[1])
q <- friedman.test(as.matrix(yes.no))   # Cochran's Q is Friedman's chi squared of zeros and ones
add("cochran_q", "yes_no.csv", Q = q$statistic, df = q$parameter, p = q$p.value, p_permutation = permutation.p(as.matrix(yes.no)))
# Shrout & Fleiss 1979: mean squares, correlations and intervals
icc <- local({ M <- as.matrix(ratings); n <- nrow(M); k <- ncol(M); a <- anova(lm(c(M) ~ factor(rep(1:n, k)) + factor(rep(1:k, each = n))))
  B <- a$Mean[1]; Jm <- a$Mean[2]; E <- a$Mean[3]; W <- (a$Sum[2] + a$Sum[3]) / (n * (k - 1)); z <- .975; o <- list()
  f1 <- B / W; l1 <- f1 / qf(z, n - 1, n * (k - 1)); u1 <- f1 * qf(z, n * (k - 1), n - 1)
  f3 <- B / E; l3 <- f3 / qf(z, n - 1, (n - 1) * (k - 1)); u3 <- f3 * qf(z, (n - 1) * (k - 1), n - 1)
  single <- function(f) (f - 1) / (f + k - 1); average <- function(f) 1 - 1 / f
  i2 <- (B - E) / (B + (k - 1) * E + k * (Jm - E) / n); fj <- Jm / E
  v <- (k - 1) * (n - 1) * (k * i2 * fj + n * (1 + (k - 1) * i2) - k * i2)^2 / ((n - 1) * k^2 * i2^2 * fj^2 + (n * (1 + (k - 1) * i2) - k * i2)^2)
  fu <- qf(z, n - 1, v); fl <- qf(z, v, n - 1)
  lo2 <- n * (B - fu * E) / (fu * (k * Jm + (k * n - k - n) * E) + n * B); hi2 <- n * (fl * B - E) / (k * Jm + (k * n - k - n) * E + n * fl * B)
  spearman <- function(r) k * r / (1 + (k - 1) * r)
  d1 <- c(n - 1, n * (k - 1)); d3 <- c(n - 1, (n - 1) * (k - 1)); p <- function(f, d) pf(f, d[1], d[2], lower.tail = FALSE)
  list("1_1" = c(single(f1), single(l1), single(u1), f1, d1, p(f1, d1)), "1_k" = c(average(f1), average(l1), average(u1), f1, d1, p(f1, d1)),
       "2_1" = c(i2, lo2, hi2, f3, d3, p(f3, d3)), "2_k" = c((B - E) / (B + (Jm - E) / n), spearman(lo2), spearman(hi2), f3, d3, p(f3, d3)),
       "3_1" = c(single(f3), single(l3), single(u3), f3, d3, p(f3, d3)), "3_k" = c(average(f3), average(l3), average(u3), f3, d3, p(f3, d3))) })
printed <- c("1_1" = .17, "2_1" = .29, "3_1" = .71, "1_k" = .44, "2_k" = .62, "3_k" = .91)   # as the authors print them
for (i in names(icc)) { v <- icc[[i]]; stopifnot(abs(v[1] - printed[i]) < .006)
  add(paste0("icc_", i), "ratings.csv", icc = v[1], icc_low = v[2], icc_high = v[3], F = v[4], df = v[5], df2 = v[6], p = v[7]) }
V <- cov(ratings); n <- nrow(ratings); k <- ncol(ratings); alpha <- k / (k - 1) * (1 - sum(diag(V)) / sum(V))
add("cronbach_alpha", "ratings.csv", cronbach_alpha = alpha, cronbach_alpha_low = 1 - (1 - alpha) * qf(.975, n - 1, (n - 1) * (k - 1)), cronbach_alpha_high = 1 - (1 - alpha) * qf(.025, n - 1, (n - 1) * (k - 1)))
three <- ratings[, c("judge2", "judge3", "judge4")]; r <- cor(three)   # three items determine one factor
l <- sqrt(c(r[1, 2] * r[1, 3] / r[2, 3], r[1, 2] * r[2, 3] / r[1, 3], r[1, 3] * r[2, 3] / r[1, 2])); stopifnot(all(l < 1)); sdev <- sapply(three, sd)
add("omega_total", "ratings.csv", c("--columns", colnames(three)), omega_total = sum(sdev * l)^2 / (sum(sdev * l)^2 + sum(sdev^2 * (1 - l^2))), tolerance = 1e-6)

# --- counts ---------------------------------------------------------------------------------------------------------
table3 <- function(d) { o <- unique(c(d[[1]], d[[2]])); xtabs(d$count ~ factor(d[[1]], o) + factor(d[[2]], o)) }
add("fisher_exact", "sorted.csv", c("--count", "count"), p = fisher.test(xtabs(count ~ first + second, sorted))$p.value, n = sum(sorted$count), tolerance = 1e-7)
q <- mcnemar.test(table3(change2), correct = FALSE)
add("mcnemar", "change2.csv", c("--count", "count"), chi2 = q$statistic, p_asymptotic = q$p.value, p = binom.test(9, 11)$p.value, changed_to_second = 9, changed_to_first = 2, n = sum(change2$count))
N <- unclass(table3(change3)); dm <- (rowSums(N) - colSums(N))[1:2]; S <- -(N + t(N)); diag(S) <- rowSums(N) + colSums(N) - 2 * diag(N); Q <- sum(dm * solve(S[1:2, 1:2], dm))
add("stuart_maxwell", "change3.csv", c("--count", "count"), chi2 = Q, df = 2, p = pchisq(Q, 2, lower.tail = FALSE), n = sum(N), changed = sum(N) - sum(diag(N)))
v <- c(2, 9, 4); all <- do.call(rbind, lapply(0:15, function(i) cbind(i, 0:(15 - i)))); pr <- apply(all, 1, function(o) dmultinom(c(o, 15 - sum(o)), prob = rep(1, 3)))
q <- chisq.test(v)
add("equal_shares", "votes.csv", p = sum(pr[pr <= dmultinom(v, prob = rep(1, 3)) * (1 + 1e-9)]), chi2 = q$statistic, df = q$parameter, p_asymptotic = q$p.value, n = 15)

# --- models: from ../study/study_golden.json, cr2_prof, lmm_prof and clmm_prof with the sign turned -----------------
model <- c("--cluster", "participant", "--group", "method", "--value", "score"); i <- "interpolation"
add("cluster_robust", "answers.csv", model, rows = list(
  list(group1 = i, group2 = "fem", difference = 1.41666666666666, se = 0.391459756221174, t = 3.61893309376673, df = 5, p = 0.0152366053920915),
  list(group1 = i, group2 = "kalman", difference = 0.86111111111111, se = 0.378634649141973, t = 2.27425332853842, df = 5, p = 0.0720542243609412)))
# lme4's optimiser stops at six digits: in these balanced data the degrees of freedom are 10 exactly.
add("mixed_model", "answers.csv", c(model, "--round", "round"), tolerance = 2e-5, rows = list(
  list(group1 = i, group2 = "fem", difference = 1.41666666666667, se = 0.351218258259351, t = 4.03357921563564, df = 9.99997058229754, p = 0.00238574657202039),
  list(group1 = i, group2 = "kalman", difference = 0.861111111111111, se = 0.351218258259351, t = 2.45178344479813, df = 9.99997058314221, p = 0.0341534524667063)))
add("ordinal_model", "answers.csv", c(model, "--round", "round"), tolerance = 1e-3, rows = list(
  list(group1 = i, group2 = "fem", log_odds_ratio = 2.6604352284786, se = 0.603520866865139, z = 4.40819095833035, odds_ratio = exp(2.6604352284786)),
  list(group1 = i, group2 = "kalman", log_odds_ratio = 1.70912649480622, se = 0.565046599108214, z = 3.02475317523131, odds_ratio = exp(1.70912649480622))))
add("answer_probability", "answers.csv", c(model, "--round", "round", "--from", "4"), tolerance = 2e-2, rows = list(   # clmm_prof_from_4
  list(group1 = i, n = 36, observed_share = 26 / 36, logit = 0.918778274649396, se = 0.55410666096314, probability = 0.71479310535273, probability_low = 0.458284490353745, probability_high = 0.881300898101772),
  list(group1 = "fem", n = 36, observed_share = 12 / 36, logit = -0.813250068508771, se = 0.54971587024455, probability = 0.307198358558007, probability_low = 0.13116771061115, probability_high = 0.565661888225528),
  list(group1 = "kalman", n = 36, observed_share = 18 / 36, logit = -0.193027559478199, se = 0.518431254774151, probability = 0.451892390133397, probability_low = 0.229854289467466, probability_high = 0.69488954119449)))
writeLines(c("[", paste(cases, collapse = ",\n"), "]"), "cases.json")
