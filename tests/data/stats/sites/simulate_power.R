# How often a study at several sites is significant, simulated with R and its metafor (3.8-1): the
# model of analysis/planning/simulated_power.h and site_power.h, written a second time. Prints what
# tests/analysis/planning/site_power_test.cpp compares with. `Rscript simulate_power.R`, some minutes;
# needs r-cran-metafor. test = "adhoc" is Knapp and Hartung's with a factor of at least 1.
suppressMessages(library(metafor))
set.seed(20)

participant <- function(shift, dz, answers, points, shares) {
  spread <- sqrt(2 * (shares[2] + shares[3] / answers))
  level <- c(dz * spread, 0) + rnorm(1, 0, sqrt(shares[1])) + shift + rnorm(2, 0, sqrt(shares[2]))
  x <- matrix(rnorm(2 * answers, rep(level, each = answers), sqrt(shares[3])), answers)
  point <- pmax(pmin(floor(x / 0.8 + (points + 1) / 2 + 0.5), points), 1)
  mean(point[, 1]) - mean(point[, 2])
}

study <- function(k, n, tau, dz, alpha, answers = 6, points = 5, shares = c(0.3, 0.2, 0.5)) {
  spread <- sqrt(2 * (shares[2] + shares[3] / answers))
  sites <- lapply(rep(n / k, k), function(m) {
    shift <- rnorm(2, 0, tau * spread / sqrt(2))
    replicate(m, participant(shift, dz, answers, points, shares))
  })
  error <- sapply(sites, function(d) sd(d) / sqrt(length(d)))
  used <- error > 0
  pooled <- if (sum(used) < 2) 1 else
    rma(sapply(sites, mean)[used], sei = error[used], method = "REML", test = "adhoc",
        control = list(maxiter = 10000, stepadj = 0.5))$pval
  c(pooled = pooled <= alpha, paired_t = t.test(unlist(sites))$p.value <= alpha)
}

for (case in list(c(4, 24, 0.2, 0.8, 0.05), c(6, 24, 0.5, 1.2, 0.05 / 3), c(3, 30, 0.5, 0, 0.05))) {
  rates <- rowMeans(replicate(4000, do.call(study, as.list(case))))
  cat(sprintf("k = %g, N = %g, tau = %g, dz = %g, alpha = %.4f: pooled %.4f, paired t %.4f\n",
              case[1], case[2], case[3], case[4], case[5], rates[1], rates[2]))
}
