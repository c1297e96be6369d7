// Copyright (c) 2026 The Shape_interrogation authors.
// All rights reserved.
//
// This file is part of Shape_interrogation, a package in the style of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//

// Exact products of scalar surfaces beside FLINT, in one run: the same coefficients in its
// univariate polynomials (Kronecker substitution) and in its multivariate ones.

#include <CGAL/Shape_interrogation/Bernstein/Bernstein_polynomial.h>

#include <CGAL/Exact_integer.h>

#include <benchmark/benchmark.h>
#include <gmp.h>

#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_poly.h>

#include <random>
#include <vector>

namespace si = CGAL::Shape_interrogation;
using Integer = CGAL::Exact_integer;
using Polynomial = si::Bernstein_polynomial_2<Integer>;

namespace {

// With Bernstein coefficients of about 53 bits.
Polynomial polynomial(int degree, unsigned seed)
{
  std::mt19937_64 engine(seed);
  std::vector<Integer> b;
  for (int i = 0; i < (degree + 1) * (degree + 1); ++i)
    b.emplace_back(static_cast<long>(engine() >> 11) - (1L << 52));
  return Polynomial::from_coefficients({degree, degree}, b);
}

void set(fmpz* to, const Integer& from)
{
  fmpz_set_mpz(to, si::internal::gmp_of(from));
}

// In powers of x^(2 degree + 1) for the first variable, x for the second.
void set(fmpz_poly_t to, const Polynomial& p)
{
  const int degree = p.degree()[0];
  fmpz_t c;
  fmpz_init(c);
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j)
    {
      set(c, p.scaled_coefficient({i, j}));
      fmpz_poly_set_coeff_fmpz(to, i * (2 * degree + 1) + j, c);
    }
  fmpz_clear(c);
}

void set(fmpz_mpoly_t to, const Polynomial& p, const fmpz_mpoly_ctx_t context)
{
  fmpz_t c;
  fmpz_init(c);
  for (int i = 0; i <= p.degree()[0]; ++i)
    for (int j = 0; j <= p.degree()[1]; ++j)
    {
      const ulong exponents[] = {ulong(i), ulong(j)};
      set(c, p.scaled_coefficient({i, j}));
      fmpz_mpoly_set_coeff_fmpz_ui(to, c, exponents, context);
    }
  fmpz_clear(c);
}

void product_ours(benchmark::State& state)
{
  const Polynomial p = polynomial(static_cast<int>(state.range(0)), 1);
  const Polynomial q = polynomial(static_cast<int>(state.range(0)), 2);
  for (auto _ : state)
    benchmark::DoNotOptimize(p * q);
}

void product_flint_kronecker(benchmark::State& state)
{
  fmpz_poly_t p, q, r;
  for (auto* x : {p, q, r})
    fmpz_poly_init(x);
  set(p, polynomial(static_cast<int>(state.range(0)), 1));
  set(q, polynomial(static_cast<int>(state.range(0)), 2));
  for (auto _ : state)
    fmpz_poly_mul(r, p, q);
  for (auto* x : {p, q, r})
    fmpz_poly_clear(x);
}

void product_flint_multivariate(benchmark::State& state)
{
  fmpz_mpoly_ctx_t context;
  fmpz_mpoly_ctx_init(context, 2, ORD_LEX);
  fmpz_mpoly_t p, q, r;
  for (auto* x : {p, q, r})
    fmpz_mpoly_init(x, context);
  set(p, polynomial(static_cast<int>(state.range(0)), 1), context);
  set(q, polynomial(static_cast<int>(state.range(0)), 2), context);
  for (auto _ : state)
    fmpz_mpoly_mul(r, p, q, context);
  for (auto* x : {p, q, r})
    fmpz_mpoly_clear(x, context);
  fmpz_mpoly_ctx_clear(context);
}

BENCHMARK(product_ours)->Arg(3)->Arg(7)->Arg(14)->Arg(30)->Unit(benchmark::kMicrosecond);
BENCHMARK(product_flint_kronecker)
  ->Arg(3)->Arg(7)->Arg(14)->Arg(30)->Unit(benchmark::kMicrosecond);
BENCHMARK(product_flint_multivariate)
  ->Arg(3)->Arg(7)->Arg(14)->Arg(30)->Unit(benchmark::kMicrosecond);

} // namespace

BENCHMARK_MAIN();
