// The oracle of the accuracy ledger: random inputs and their true answers, from 113-bit arithmetic.
//
//   oracle FUNCTION COUNT SEED > records      (FUNCTION: one of FUNCTIONS below)
//   oracle FUNCTION < inputs > records        (no COUNT: inputs as binary f64 from standard input)
//
// A record is binary f64, little endian: region, the inputs of `inputs_of`, then each answer as hi, lo with
// hi + lo the answer to about 106 bits. Everything rests on the AGM (Gauss; DLMF 19.8, 22.20) and on
// R. Bulirsch, Numer. Math. 7 (1965) 78-90, whose cotangent recurrences keep relative accuracy as k' -> 0.
// reference/check_oracle.py compares it with mpmath at 700 digits.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <quadmath.h>
#include <string>
#include <vector>

typedef __float128 quad;

static const quad PI = M_PIq;
static const quad PI_LOW = 8.6718101301237810247970440260433519687623233462e-35Q;  // pi - PI

// ---------------------------------------------------------------- elliptic integrals and functions

struct Modulus { quad k, kc; };

static quad agm(quad a, quad b) {
    while (fabsq(a - b) > 1e-17Q * a) {
        quad mean = (a + b) / 2;
        b = sqrtq(a * b);
        a = mean;
    }
    return (a + b) / 2;  // the next arithmetic mean is already the limit to 2^-113
}

static quad first(quad kc) { return kc == 0 ? (quad)INFINITY : PI / (2 * agm(1, kc)); }

static quad second(Modulus m) {
    quad a = 1, b = m.kc, c = m.k, weight = 0.5Q, sum = 0;
    if (b == 0) return 1;
    while (fabsq(c) > 1e-36Q * a) {
        sum += weight * c * c;
        weight *= 2;
        quad mean = (a + b) / 2;
        c = c * c / (4 * mean);
        b = sqrtq(a * b);
        a = mean;
    }
    return PI / (2 * a) * (1 - sum);
}

// tan(am x) for 0 <= x <= K/2 or so: Bulirsch's recurrences, no cancellation while x < K.
static quad tangent_of_am(quad x, quad kc) {
    if (kc == 0) return sinhq(x);
    if (x == 0) return 0;
    quad a[32], b[32], mean = 1, root = kc;
    int n = 0;
    for (;; n++) {
        a[n] = mean;
        b[n] = root;
        if (fabsq(mean - root) < 1e-17Q * mean) break;
        quad next = (mean + root) / 2;
        root = sqrtq(mean * root);
        mean = next;
    }
    quad phase = x * (a[n] + b[n]) / 2, sn, cn;
    sincosq(phase, &sn, &cn);
    quad cot = cn / sn, scaled = cot * (a[n] + b[n]) / 2, dn = 1;
    for (; n >= 0; n--) {
        cot = scaled * cot;
        scaled = dn * scaled;
        dn = (b[n] + cot) / (a[n] + cot);
        cot = scaled / a[n];
    }
    return 1 / cot;
}

struct Jacobi { quad sn, cn, dn, am; };

static Jacobi jacobi(quad u, Modulus m) {
    if (m.kc == 0) return {tanhq(u), 1 / coshq(u), 1 / coshq(u), 2 * atanq(tanhq(u / 2))};
    quad quarter = first(m.kc), turns = rintq(u / quarter), x = u - turns * quarter;
    int side = x < 0 ? -1 : 1;
    quad t = tangent_of_am(fabsq(x), m.kc), kt = m.kc * t;
    quad sec = sqrtq(1 + t * t), dsec = sqrtq(1 + kt * kt);
    bool odd = fmodq(turns, 2) != 0, negative = fmodq(floorq(turns / 2), 2) != 0;
    Jacobi j;
    if (odd) j = {1 / dsec, -side * kt / dsec, m.kc * sec / dsec, side * atanq(kt)};
    else j = {side * t / sec, 1 / sec, dsec / sec, side * atanq(t)};
    if (negative) j.sn = -j.sn, j.cn = -j.cn;
    j.am += turns * (PI / 2) + turns * (PI_LOW / 2);
    return j;
}

// F as a function of the tangent of phi within [0, inf]: Bulirsch's el1, by the complement beyond K/2.
static quad incomplete_first(quad tangent, quad kc) {
    if (kc == 0) return asinhq(tangent);
    if (tangent == 0) return 0;
    if (tangent * tangent * kc > 1) return first(kc) - incomplete_first(1 / (kc * tangent), kc);
    quad y = 1 / tangent, root = kc, mean = 1, halves = 0;
    for (;;) {
        quad product = mean * root, before = mean;
        mean += root;
        y -= product / y;
        if (y == 0) y = sqrtq(product) * 1e-34Q;
        if (fabsq(before - root) <= 1e-17Q * before) break;
        root = 2 * sqrtq(product);
        halves = 2 * halves + (y < 0);
    }
    if (y < 0) halves += 1;
    return (atanq(mean / y) + PI * halves) / mean;
}

// E as a function of the tangent of phi within [0, inf]: Bulirsch's el2 with a = 1, b = kc^2.
static quad incomplete_second(quad tangent, quad kc) {
    if (kc == 0) return tangent / sqrtq(1 + tangent * tangent);
    if (tangent == 0) return 0;
    quad a = 1, b = kc * kc, c = tangent * tangent, d = 1 + c, p = sqrtq((1 + b * c) / d);
    d = tangent / d;
    c = d / (2 * p);
    quad z = a - b, i = a, y = 1 / tangent, f = 0, mean = 1, root = kc, halves = 0;
    a = (b + a) / 2;
    for (;;) {
        b += i * root;
        quad e = mean * root, g = e / p, before = mean;
        d += f * g;
        f = c;
        i = a;
        p += g;
        c = (d / p + c) / 2;
        mean += root;
        a = (b / mean + a) / 2;
        y -= e / y;
        if (y == 0) y = sqrtq(e) * 1e-34Q;
        if (fabsq(before - root) <= 1e-17Q * before) break;
        root = 2 * sqrtq(e);
        halves = 2 * halves + (y < 0);
    }
    if (y < 0) halves += 1;
    return (atanq(mean / y) + PI * halves) * a / mean + c * z;
}

// phi = halves*pi + the angle within [-pi/2, pi/2] of this tangent, by the nearest quarter turn.
struct Reduced { quad halves, tangent; };

static Reduced reduce(quad phi) {
    quad quarters = rintq(phi / (PI / 2)), rest = fmaq(-quarters, PI / 2, phi);
    rest = fmaq(-quarters, PI_LOW / 2, rest);
    if (fmodq(quarters, 2) == 0) return {quarters / 2, tanq(rest)};
    return {(rest > 0 ? quarters + 1 : quarters - 1) / 2, -1 / tanq(rest)};
}

// A function of phi, given its value at pi/2 and as a function of the tangent.
static quad of_angle(double phi, quad kc, quad quarter, quad (*of_tangent)(quad, quad)) {
    if (fabs(phi) > 1e20) return phi * (2 * quarter / PI);  // what is left oscillates within a quarter
    Reduced r = reduce(phi);
    quad part = of_tangent(fabsq(r.tangent), kc);
    if (r.halves == 0) return r.tangent < 0 ? -part : part;
    return 2 * r.halves * quarter + (r.tangent < 0 ? -part : part);
}

// k and kc of a nome by theta functions of the smaller nome (DLMF 20.9.1, 20.7(viii)).
static Modulus modulus_of_nome(double nome) {
    quad log = logq((quad)nome);
    bool small = log <= -PI;
    if (!small) log = PI * PI / log;
    quad second = 1, third = 1, fourth = 1;
    for (int n = 1; n < 8; n++) {
        quad square = expq(n * n * log);
        second += expq(n * (n + 1) * log);
        third += 2 * square;
        fourth += n % 2 ? -2 * square : 2 * square;
    }
    quad k = 4 * expq(log / 2) * (second / third) * (second / third), kc = (fourth / third) * (fourth / third);
    return small ? Modulus{k, kc} : Modulus{kc, k};
}

// ---------------------------------------------------------------- the pendulum, omega0 = 1

static quad complement_of(quad angle) { return (PI - angle) + PI_LOW; }

// x - sin x without cancellation.
static quad sine_deficit(quad x) {
    if (fabsq(x) > 0.5Q) return x - sinq(x);
    quad term = x * x * x / 6, sum = 0;
    for (int n = 4; fabsq(term) > 1e-36Q * fabsq(sum); n += 2) {
        sum += term;
        term *= -x * x / (n * (n + 1));
    }
    return sum;
}

struct Ratio { quad ratio, excess; };

// c_1 = sin^2(theta0/4) and 1 - agm = c_1 + c_2 + ..., all positive.
static Ratio ratio_from(quad amplitude, quad kc) {
    quad a = 1, b = kc, c = sinq(amplitude / 4), gap = 0;
    c *= c;
    while (c > 1e-36Q * gap) {
        gap += c;
        quad mean = (a + b) / 2;
        b = sqrtq(a * b);
        a = mean;
        c = c * c / (2 * (a + b));
    }
    return {1 / agm(1, kc), gap == 0 ? 0 : gap / agm(1, kc)};
}

struct State { quad angle, velocity, complement; };

// The motion from an angle within [-pi, pi], given as sine and cosine of its half, with velocity 2w, w >= 0;
// gap = C - w, with full relative accuracy. The complement counts from the nearest upright position.
static State state(quad s, quad c, quad gap, quad w, quad time) {
    quad energy = s * s + w * w, half, complement;
    if (energy == 0) return {0, 0, PI};
    if (gap > 0) {
        Modulus m = {sqrtq(energy), sqrtq(gap * (c + w))};
        quad start = w == 0 ? first(m.kc) : incomplete_first(fabsq(s) / w, m.kc);
        Jacobi j = jacobi(time + (s < 0 ? -start : start), m);
        half = atan2q(m.k * j.sn, j.dn);
        complement = 2 * atan2q(j.dn, m.k * fabsq(j.sn));
        return {2 * half, 2 * m.k * j.cn, complement};
    }
    if (gap == 0) {
        quad x = time + (s < 0 ? -1 : 1) * asinhq(fabsq(s) / c);
        return {2 * atanq(sinhq(x)), 2 / coshq(x), 2 * atan2q(1, fabsq(sinhq(x)))};
    }
    quad rate = sqrtq(energy);
    Modulus m = {1 / rate, sqrtq(-gap * (c + w)) / rate};
    quad start = c == 0 ? first(m.kc) : incomplete_first(fabsq(s) / c, m.kc);
    Jacobi j = jacobi(rate * time + (s < 0 ? -start : start), m);
    return {2 * j.am, 2 * rate * j.dn, 2 * atan2q(fabsq(j.cn), fabsq(j.sn))};
}

// kind 0: from the angle a with velocity b; kind 1: from pi - a with velocity b.
static State motion(int kind, double a, double b, double time) {
    quad turns = 0, complement, angle;
    if (kind == 0) {
        turns = rintq((quad)a / (2 * PI));
        angle = ((quad)a - turns * 2 * PI) - turns * 2 * PI_LOW;
        complement = complement_of(fabsq(angle));
    } else {
        complement = a;
        angle = (PI - complement) + PI_LOW;
    }
    quad mirror = b < 0 ? -1 : 1, w = fabsq((quad)b) / 2;
    angle *= mirror;
    quad s = sinq(angle / 2), c = sinq(complement / 2);
    quad gap = (complement / 2 - w) - sine_deficit(complement / 2);
    if (fabsq(complement) > 1) gap = c - w;
    if (angle == 0) c = 1, gap = 1 - w;
    State at = state(s, c, gap, w, time);
    at.angle = mirror * at.angle + turns * 2 * PI + turns * 2 * PI_LOW;
    at.velocity *= mirror;
    return at;
}

// Harmonic n of the libration of complement delta.
static quad harmonic(quad delta, int n) {
    Modulus m = {cosq(delta / 2), sinq(delta / 2)};
    quad x = PI * first(m.k) / (2 * first(m.kc));
    return ((n / 2) % 2 ? -4 : 4) / (n * coshq(n * x));
}

// Harmonic n of the rotation with this velocity at the bottom.
static quad turning_harmonic(quad velocity, int n) {
    Modulus m = {2 / velocity, sqrtq((velocity - 2) * (velocity + 2)) / velocity};
    return 2 / (n * coshq(n * PI * first(m.k) / first(m.kc)));
}

// ---------------------------------------------------------------- inputs

static uint64_t random_state;

static uint64_t random_bits() {  // splitmix64
    uint64_t z = (random_state += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}
static double uniform() { return (random_bits() >> 11) * 0x1p-53; }
static double between(double low, double high) { return low + (high - low) * uniform(); }
static double log_between(double low, double high) { return std::pow(10.0, between(low, high)); }
static int choice(int n) { return random_bits() % n; }
static double sign() { return choice(2) ? 1 : -1; }
static double neighbour(double x, int reach) {
    for (int n = choice(2 * reach + 1) - reach; n != 0; n += n < 0 ? 1 : -1) x = std::nextafter(x, n < 0 ? -INFINITY : INFINITY);
    return x;
}

typedef std::vector<double> Inputs;  // region first

// Next to a place where a kernel changes its expansion, its logarithm its exponent, or a word its last bit.
static double period_seam() {
    static const double edges[] = {M_PI_2, M_PI_4, 1, 2, 0.5, 0.25, 3, 2.5, 1.5, 0x1p-26, 0x1p-13, 1e-8};
    if (choice(2)) return neighbour(edges[choice(12)], 20);
    return neighbour(M_SQRT2 * std::ldexp(1, -choice(40)), 3);
}

// kind 0: amplitude, kind 1: complement.
static Inputs period_inputs() {
    int region = choice(8);
    switch (region) {
        case 0: return {0, 0, between(0, M_PI)};
        case 1: return {1, 0, log_between(-150, 0)};
        case 2: return {2, 0, M_PI - log_between(-15.5, 0)};
        case 3: return {3, 1, log_between(-300, 0)};
        case 4: return {4, (double)choice(2), period_seam()};
        case 6: return {6, 1, between(0, M_PI)};
        case 7: return {7, (double)choice(2), choice(4) ? between(1.54, 1.61) : neighbour(M_PI_2, 1000)};
        default: return {5, 0, neighbour(std::nextafter(M_PI, 0), 40) > M_PI ? M_PI : M_PI - choice(1000) * 0x1p-51};
    }
}

static Inputs excess_inputs() {
    int region = choice(3);
    if (region == 0) return {0, 0, between(0, M_PI)};
    if (region == 1) return {1, 0, log_between(-150, 0)};
    return {2, 0, log_between(-4, 0.49)};
}

// kind 0: m, 1: mc = 1 - m, 2: k, 3: k'.
static Inputs modulus_seam() {
    // Equal moduli, where the expansion changes; a scale in the arithmetic-geometric mean; the nome's underflow; the ends.
    static const double seams[][2] = {{0, 0.5}, {1, 0.5}, {2, M_SQRT1_2}, {3, M_SQRT1_2}, {2, 1e-150}, {3, 1e-150}, {0, 1e-300}};
    static const double ends[][2] = {{2, 8.89e-161}, {2, 8.9e-162}, {2, 6.3e-162}, {0, 0}, {0, 1}, {2, 5e-324}, {0, 5e-324}};
    const double *seam = choice(2) ? seams[choice(7)] : ends[choice(7)];
    double value = seam[1] == 0 || seam[1] == 1 ? seam[1] : neighbour(seam[1], 3);
    return {6, seam[0], fmax(0, value)};
}

static Inputs modulus_inputs() {
    switch (choice(8)) {
        case 0: return {0, 0, uniform()};
        case 1: return {1, 1, log_between(-300, 0)};
        case 2: return {2, 3, log_between(-300, 0)};
        case 3: return {3, 0, log_between(-300, 0)};
        case 4: return {4, 2, uniform()};
        case 6: return modulus_seam();
        case 7: return {7, 2.0 * choice(2), log_between(-323, -140)};
        default: return {5, (double)choice(2), 1 - log_between(-16, 0)};
    }
}

static Modulus modulus_of(int kind, quad x) {
    switch (kind) {
        case 0: return {sqrtq(x), sqrtq(1 - x)};
        case 1: return {sqrtq(1 - x), sqrtq(x)};
        case 2: return {x, sqrtq((1 - x) * (1 + x))};
        default: return {sqrtq((1 - x) * (1 + x)), x};
    }
}

// An angle next to a multiple of a quarter turn.
static double next_to_quarter(double most) {
    return neighbour((double)(rintq((quad)between(-most, most)) * (PI / 2)), 3);
}

static double incomplete_angle(int where) {
    switch (where) {
        case 0: return between(-M_PI_2, M_PI_2);
        case 1: return sign() * log_between(-320, 0);
        case 2: return sign() * (M_PI_2 - log_between(-16, 0));
        case 3: return next_to_quarter(20);
        case 4: return next_to_quarter(1e6);
        case 5: return sign() * log_between(0, 6);
        case 6: return sign() * log_between(6, 20);
        case 7: return next_to_quarter(std::ldexp(1, 10 + choice(50)));
        default: return sign() * (choice(2) ? neighbour(1e18, 20) : log_between(20, 308));
    }
}

static Inputs incomplete_inputs() {
    Inputs in = modulus_inputs();
    int where = choice(9);
    in[0] = where;
    in.push_back(incomplete_angle(where));
    return in;
}

static Inputs nome_inputs() {
    switch (choice(5)) {
        case 0: return {0, between(0, 0.9929)};
        case 1: return {1, log_between(-307, 0) * 0.99};
        case 2: return {2, 5e-324 * std::floor(log_between(0, 15))};
        case 3: return {3, neighbour(std::exp(-M_PI), 20)};
        default: return {4, 0.9929 - log_between(-6, -1)};
    }
}

static Inputs jacobi_inputs() {
    Inputs in = modulus_inputs();
    double quarter = (double)first(modulus_of(in[1], in[2]).kc), u;
    if (!(quarter < 1e4)) quarter = 20;  // k = 1
    int where = choice(6);
    switch (where) {
        case 0: u = between(-4, 4) * quarter; break;
        case 1: u = sign() * log_between(-200, 0); break;
        case 2: u = sign() * quarter * log_between(0, 6); break;
        case 3: u = neighbour(quarter * (choice(17) - 8), 3); break;
        case 4: u = neighbour(quarter * (choice(17) - 8) / 2, 3); break;
        default: u = neighbour(quarter * (choice(2000001) - 1000000), 3);
    }
    in[0] = where;
    in.push_back(u);
    return in;
}

// The time scale of a motion: its quarter period, or that of a neighbour where it has none.
static double quarter_period(double kind, double a, double b) {
    quad delta = kind == 1 ? (quad)a : complement_of(fabsq(remainderq(a, 2 * PI)));
    quad c = sinq(delta / 2), w = fabs(b) / 2, gap = fabsq((c - w) * (c + w));
    double scale = (double)fmaxq(1, w);
    return (double)first(fminq(1, sqrtq(gap + 1e-600Q) / scale)) / scale;
}

// region, kind, angle or complement, velocity.
static Inputs start_inputs(int region) {
    double kind = 0, a, b = 0;
    switch (region) {
        case 0: a = between(-M_PI, M_PI); break;
        case 1: kind = 1, a = log_between(-300, 0); break;
        case 2: a = between(-M_PI, M_PI), b = between(-4, 4); break;
        case 3: a = between(-M_PI, M_PI), b = sign() * neighbour(2 * std::cos(a / 2), 1000); break;
        case 4: kind = 1, a = log_between(-30, 0), b = sign() * neighbour(a * (choice(2) ? 1 : between(0.5, 2)), 3); break;
        case 6: a = sign() * neighbour(choice(4) ? M_PI_2 : M_PI, 20), a = fmax(-M_PI, fmin(M_PI, a)); break;
        case 7: a = 0, b = sign() * 2; break;
        default: a = between(-100, 100), b = sign() * log_between(-3, 2);
    }
    return {(double)region, kind, a, b};
}

// Next to a turn of the expansion (halves of a quarter) or the end of a segment of a table (powers of two more).
static double seam_of_time(double quarter) {
    return neighbour(quarter * (choice(257) - 128) / (choice(2) ? 2 : 16 << choice(8)), 3);
}

static Inputs motion_inputs() {
    // Starts next to the separatrix are dear for the library, a millisecond each, and so kept to one in forty.
    static const int others[] = {0, 1, 2, 5, 6, 7};
    Inputs in = start_inputs(choice(40) ? others[choice(6)] : 3 + choice(2));
    if (in[0] == 7) {
        in.push_back(sign() * (choice(2) ? between(0, 760) : log_between(-8, 3)));
        return in;
    }
    double quarter = quarter_period(in[1], in[2], in[3]);
    switch (choice(3)) {
        case 0: in.push_back(between(-4, 4) * quarter); break;
        case 1: in.push_back(seam_of_time(quarter)); break;
        default: in.push_back(sign() * quarter * log_between(-8, 6.6));
    }
    return in;
}

// One start for thousands of times in a row.
static Inputs orbit_inputs() {
    static Inputs start;
    static double quarter;
    static int left = 0;
    if (left-- == 0) {
        start = start_inputs(choice(7));
        quarter = quarter_period(start[1], start[2], start[3]);
        left = 9999;
    }
    Inputs in = start;
    switch (choice(3)) {
        case 0: in.push_back(between(-40, 40) * quarter); break;
        case 1: in.push_back(seam_of_time(quarter)); break;
        default: in.push_back(sign() * quarter * log_between(-3, 6.6));
    }
    return in;
}

// kind 0: amplitude, 1: complement, 2: velocity at the bottom, of a rotation.
static Inputs harmonics_inputs() {
    int region = choice(5);
    double n = 2 * choice(region == 0 ? 6 : 30) + 1;
    if (region == 3) return {3, (double)choice(2), choice(2) ? neighbour(M_PI_2, 20) : between(1.5, 1.65), n};
    if (region == 4) return {4, 2, 2 + log_between(-15, 1), (double)(1 + choice(30))};
    if (region == 0) return {0, 0, between(0, M_PI), n};
    if (region == 1) return {1, 1, log_between(-300, 0), n};
    return {2, 0, log_between(-3, 0.49), n};
}

// ---------------------------------------------------------------- answers

typedef std::vector<quad> Answers;

static Answers period_answers(const Inputs &in) {
    bool near_top = in[1] == 1;
    quad amplitude = near_top ? complement_of(in[2]) : in[2], delta = near_top ? (quad)in[2] : complement_of(in[2]);
    Ratio r = ratio_from(amplitude, sinq(delta / 2));
    return {r.ratio, r.excess};
}
static Answers complete_answers(const Inputs &in) {
    Modulus m = modulus_of(in[1], in[2]);
    quad k = first(m.kc), kc = first(m.k);
    return {k, second(m), kc, m.kc == 0 ? 1 : expq(-PI * kc / k)};
}
static Answers incomplete_answers(const Inputs &in) {
    Modulus m = modulus_of(in[1], in[2]);
    double phi = in[3];
    quad f = m.kc == 0 && fabs(phi) > M_PI_2 ? copysign(INFINITY, phi) : of_angle(phi, m.kc, first(m.kc), incomplete_first);
    return {f, of_angle(phi, m.kc, second(m), incomplete_second)};
}
static Answers nome_answers(const Inputs &in) {
    Modulus m = modulus_of_nome(in[1]);
    return {m.k, m.kc};
}
static Answers jacobi_answers(const Inputs &in) {
    Jacobi j = jacobi(in[3], modulus_of(in[1], in[2]));
    return {j.sn, j.cn, j.dn, j.am};
}
static Answers motion_answers(const Inputs &in) {
    State s = motion(in[1], in[2], in[3], in[4]);
    return {s.angle, s.velocity, s.complement};
}
static Answers harmonics_answers(const Inputs &in) {
    if (in[1] == 2) return {turning_harmonic(in[2], in[3])};
    return {harmonic(in[1] == 1 ? (quad)in[2] : complement_of(in[2]), in[3])};
}

struct Function { std::function<Inputs()> inputs; std::function<Answers(const Inputs &)> answers; size_t width; };

static const std::map<std::string, Function> FUNCTIONS = {
    {"period", {period_inputs, period_answers, 3}},       {"excess", {excess_inputs, period_answers, 3}},
    {"complete", {modulus_inputs, complete_answers, 3}},  {"incomplete", {incomplete_inputs, incomplete_answers, 4}},
    {"nome", {nome_inputs, nome_answers, 2}},
    {"jacobi", {jacobi_inputs, jacobi_answers, 4}},       {"motion", {motion_inputs, motion_answers, 5}},
    {"orbit", {orbit_inputs, motion_answers, 5}},
    {"harmonics", {harmonics_inputs, harmonics_answers, 4}},
};

static void write_record(Inputs record, const Answers &answers) {
    for (quad x : answers) {
        double hi = (double)x;
        record.push_back(hi);
        record.push_back(isinfq(x) ? 0 : (double)(x - hi));
    }
    fwrite(record.data(), sizeof(double), record.size(), stdout);
}

int main(int argc, char **argv) {
    auto found = argc < 2 ? FUNCTIONS.end() : FUNCTIONS.find(argv[1]);
    if (found == FUNCTIONS.end()) {
        fprintf(stderr, "usage: oracle period|excess|complete|incomplete|nome|jacobi|motion|orbit|harmonics [COUNT SEED]\n");
        return 2;
    }
    const Function &function = found->second;
    if (argc < 4) {
        Inputs in(function.width);
        while (fread(in.data(), sizeof(double), in.size(), stdin) == in.size()) write_record(in, function.answers(in));
        return 0;
    }
    random_state = strtoull(argv[3], nullptr, 10);
    for (long long n = atoll(argv[2]); n > 0; n--) {
        Inputs in = function.inputs();
        write_record(in, function.answers(in));
    }
    return 0;
}
