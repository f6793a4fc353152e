/* The cases of series.py in PARI/GP, by the same recurrences as with_flint.py: x_n = c p_n(u), u = c^2, c = cos(tau).
   Vectors hold odd (or even) orders only: X[i] is x_(2i-1), W[i] stands before eps^(2i-2) in Omega^2. */

/* d^2/dtau^2 of c p(u). */
second(p) = 4*u*(1 - u)*p'' + (6 - 8*u)*p' - p;

/* Coefficients p_1, ... with (c p)'' + c p = -c rest (odd) or (s p)'' + s p = -s rest, and p_0 = 0 for now. */
triangular(rest, d, odd) =
{
  my(p = vector(d + 2), k);
  forstep(i = d, 1, -1,
    k = 2*i + odd;
    p[i+1] = ((k + 2)*(k + 1)*p[i+2] + polcoef(rest, i)) / if(odd, k^2 - 1, k^2 + 2*k));
  p
};

/* Without cos(tau), or without sin(tau). */
close_c(p) = { p[1] = -sum(i = 1, #p - 1, p[i+1]*binomial(2*i + 1, i)/4^i); Polrev(p, u) };
close_s(p) = { p[1] = -sum(i = 1, #p - 1, p[i+1]*binomial(2*i, i)/((i + 1)*4^i)); Polrev(p, u) };

/* x_(2m-1) and the square of the frequency before it, from the force without its own term. */
lindstedt(Y, W, m, force) =
{
  my(rest = force + sum(i = 2, m - 1, W[m - i + 1]*Y[i]), p = triangular(rest, m - 1, 1));
  [close_c(p), polcoef(rest, 0) + 6*p[2]]
};

pendulum(size) =
{
  my(X, Y, W, J, S, C, force, found);
  X = Y = W = J = S = C = vector(size);
  X[1] = J[1] = S[1] = C[1] = u^0; Y[1] = -u^0; W[1] = 1;
  for(m = 2, size,
    C[m] = -u*sum(i = 1, m - 1, J[i]*S[m - i])/(2*m - 2);
    force = sum(i = 1, m - 1, J[i]*C[m - i + 1])/(2*m - 1);
    found = lindstedt(Y, W, m, force);
    X[m] = found[1]; W[m] = found[2];
    Y[m] = second(X[m]); J[m] = (2*m - 1)*X[m]; S[m] = force + X[m]);
  [X, W]
};

duffing(size) =
{
  my(X, Y, W, Q, found);
  X = Y = W = Q = vector(size);
  X[1] = Q[1] = u^0; Y[1] = -u^0; W[1] = 1;
  for(m = 2, size,
    found = lindstedt(Y, W, m, u*sum(i = 1, m - 1, X[i]*Q[m - i]));
    X[m] = found[1]; W[m] = found[2]; Y[m] = second(X[m]);
    Q[m] = 2*sum(i = 1, m\2, X[i]*X[m - i + 1]) + if(m % 2, X[(m + 1)\2]^2));
  [X, W]
};

/* Omega and the harmonics by powers of eps; the check is the last frequency and the last a_3. */
solve_odd(oscillator, order) =
{
  my(size = (order + 1)\2, found = oscillator(size), omega, table);
  omega = Vec(sqrt(Ser(found[2], y)));
  table = matrix(size, size, k, i, if(k <= i, binomial(2*i - 1, i - k)/4^(i - 1)));
  table = table*matrix(size, size, i, n, polcoef(found[1][n], i - 1));
  [omega, table, [omega[size], table[2, size]]]
};

/* What stands before Y^n in eps/amplitude, Y = amplitude^2, by Lagrange: [y^n] h^(-2n-1)/(2n+1), amplitude = eps h(eps^2). */
reversion(h, size) =
{
  my(power = 1/h, step = power^2, found = vector(size));
  for(n = 1, size, found[n] = polcoef(power, n - 1)/(2*n - 1); power *= step);
  Ser(found, y)
};

/* Rows of coefficients. */
rows(list) = matconcat(apply(it -> Vec(it + O(y^#list), -#list), list)~);

/* eps, Omega, T and all harmonics as series in the amplitude too. */
full_odd(oscillator, order) =
{
  my(found = solve_odd(oscillator, order), omega = found[1], table = found[2], size = #omega, ratio, square, power, in_a);
  ratio = reversion(Ser(vector(size, n, vecsum(table[, n])), y), size);
  square = y*ratio^2;
  power = vector(size); power[1] = 1 + O(y^size);
  for(i = 2, size, power[i] = power[i - 1]*square + O(y^size));
  in_a = table*rows(apply(it -> ratio*it, power));
  omega = omega*rows(power);
  [ratio, omega, 1/Ser(omega, y), in_a, [omega[size], in_a[2, size]]]
};

/* Van der Pol with mu = i nu, as in with_flint.py; index n + 1 for order n. Sums over j of one parity, first, first + 2, ... */
alternate(A, B, n, first) = { my(t = 0); forstep(j = first, n, 2, t += A[j+1]*B[n - j + 1]); t };

mirrored(P, n, first) =
{
  my(t = 0);
  forstep(j = first, (n - 1)\2, 2, t += P[j+1]*P[n - j + 1]);
  2*t + if(n % 4 == 2*first, P[n\2 + 1]^2)
};

/* What stands before nu^n in x^2, and D(x - x^3/3) from it. */
pairs(P, n) = if(n % 2, 2*alternate(P, P, n, 0), u*mirrored(P, n, 0) + (u - 1)*mirrored(P, n, 1));
bend(P, G, n) =
{
  my(odd = alternate(P, G, n, 1), even = alternate(P, G, n, 0), smooth);
  smooth = P[n+1] - if(n % 2, odd + u*even, even + (u - 1)*odd)/3;
  smooth + 2*if(n % 2, u - 1, u)*smooth'
};

/* D^2 of c p(u) and of s p(u). */
twice(p, odd) = if(odd, 4*u*(u - 1)*p'' + (8*u - 2)*p' + p, -second(p));

van_der_pol(order) =
{
  my(P, G, B, O, W, rest, p, a);
  P = G = B = O = W = vector(order + 1);
  O[1] = W[1] = 1; P[1] = 2*u^0; G[1] = pairs(P, 0); B[1] = bend(P, G, 0);
  for(n = 1, order,
    rest = -alternate(O, B, n - 1, 0);
    forstep(j = 2, n - 1, 2, rest += W[j+1]*twice(P[n - j + 1], n % 2));
    p = triangular(-rest, n, 1 - n % 2);
    if(n % 2 == 0,
      W[n+1] = 3*p[2] - polcoef(rest, 0)/2;
      O[n+1] = (W[n+1] - sum(j = 1, n - 1, O[j+1]*O[n - j + 1]))/2);
    if(n % 2 && n > 1,
      a = p[2] - polcoef(rest, 0)/2;
      P[n] += a; G[n] += 4*a*u; B[n] += a*(1 - 12*u); p[2] -= 3*a/2);
    P[n+1] = if(n % 2, close_s(p), close_c(p));
    G[n+1] = pairs(P, n); B[n+1] = bend(P, G, n));
  a = P[order - 1];
  a = sum(i = 0, poldegree(a), polcoef(a, i)*binomial(2*i + 1, i)/4^i);
  [O, P, (-1)^(order\2)*[O[order + 1], -a]]
};

/* T/T0 in y = theta0^2. */
period_by_composition(order) =
{
  my(size = order\2 + 1, c = vector(size), m);
  c[1] = 1; for(n = 1, size - 1, c[n+1] = c[n]*((2*n - 1)/(2*n))^2);
  m = sum(n = 1, size - 1, (-1)^(n + 1)*y^n/(2*(2*n)!)) + O(y^size);
  m = subst(Ser(c, y), y, m);
  [m, [polcoef(m, size - 1)]]
};

period_by_agm(order) =
{
  my(size = order\2 + 1, r);
  r = 1/agm(1 + O(y^size), sum(n = 0, size - 1, (-1)^n*y^n/(4^n*(2*n)!)) + O(y^size));
  [r, [polcoef(r, size - 1)]]
};

period_by_euler_numbers(order) =
{
  my(size = order\2 + 1, s, e);
  s = 1/(sum(n = 0, size - 1, (-1)^n*y^n/(2*n)!) + O(y^size));
  e = exp(sum(n = 1, size - 1, polcoef(s, n)*(2*n)!/(2*n)*y^n) + O(y^size));
  e = vector(size, n, polcoef(e, n - 1)/((2*n - 2)!*4^(n - 1)));
  [e, [e[size]]]
};

run(name, order) =
{
  if(name == "pendulum", solve_odd(pendulum, order),
     name == "pendulum, full answer", full_odd(pendulum, order),
     name == "duffing", solve_odd(duffing, order),
     name == "duffing, full answer", full_odd(duffing, order),
     name == "van_der_pol", van_der_pol(order),
     name == "period", period_by_euler_numbers(order),
     name == "period, AGM", period_by_agm(order),
     name == "period, composition", period_by_composition(order), 0)
};

/* Prints processor seconds of up to 7 passes, each a mean over as many runs as make 0.1 s (the clock counts milliseconds), and the check, as JSON. */
bench(name, order) =
{
  my(start = getabstime(), last = run(name, order), once, runs, times = List(), check);
  if(!last, print("{\"seconds\": null, \"check\": []}"); return);
  once = max(getabstime() - start, 1/8);
  runs = ceil(100/once);
  if(once > 2000, listput(times, once));
  while(#times < 7 && once <= 2000,
    start = getabstime();
    for(i = 1, runs, run(name, order));
    listput(times, (getabstime() - start)/runs));
  check = apply(it -> Str("\"", it, "\""), last[#last]);
  print("{\"seconds\": ", "[", strjoin(apply(it -> strprintf("%.9f", it/1000), Vec(times)), ", "), "]", ", \"check\": ", "[", strjoin(check, ", "), "]", "}")
};
