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

static quad first(quad kc) { return PI / (2 * agm(1, kc)); }

static quad second(Modulus m) {
    quad a = 1, b = m.kc, c = m.k, weight = 0.5Q, sum = 0;
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
    quad quarter = m.kc == 0 ? 0 : first(m.kc);
    quad turns = m.kc == 0 ? 0 : rintq(u / quarter), x = u - turns * quarter;
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

// kind 0: amplitude, kind 1: complement.
static Inputs period_inputs() {
    static const double edges[] = {M_PI_2, M_PI_4, 1, 2, 0.5, 0.25, 3, 2.5, 1.5, 0x1p-26, 0x1p-13, 1e-8};
    int region = choice(6);
    switch (region) {
        case 0: return {0, 0, between(0, M_PI)};
        case 1: return {1, 0, log_between(-150, 0)};
        case 2: return {2, 0, M_PI - log_between(-15.5, 0)};
        case 3: return {3, 1, log_between(-300, 0)};
        case 4: return {4, 0, neighbour(edges[choice(12)], 20)};
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
static Inputs modulus_inputs() {
    switch (choice(6)) {
        case 0: return {0, 0, uniform()};
        case 1: return {1, 1, log_between(-300, 0)};
        case 2: return {2, 3, log_between(-300, 0)};
        case 3: return {3, 0, log_between(-300, 0)};
        case 4: return {4, 2, uniform()};
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

static Inputs incomplete_inputs() {
    Inputs in = modulus_inputs();
    in.push_back(choice(2) ? between(0, M_PI_2) : choice(2) ? log_between(-200, 0) : M_PI_2 - log_between(-16, 0));
    return in;
}

static Inputs jacobi_inputs() {
    Inputs in = modulus_inputs();
    double quarter = (double)first(modulus_of(in[1], in[2]).kc), u;
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
        default: a = between(-100, 100), b = sign() * log_between(-3, 2);
    }
    return {(double)region, kind, a, b};
}

static Inputs motion_inputs() {
    // Starts next to the separatrix are dear for the library, a millisecond each, and so kept to one in forty.
    static const int others[] = {0, 1, 2, 5};
    Inputs in = start_inputs(choice(40) ? others[choice(4)] : 3 + choice(2));
    double quarter = quarter_period(in[1], in[2], in[3]);
    in.push_back(choice(2) ? between(-4, 4) * quarter : sign() * quarter * log_between(-8, 6.6));
    return in;
}

// One start for thousands of times in a row.
static Inputs orbit_inputs() {
    static Inputs start;
    static double quarter;
    static int left = 0;
    if (left-- == 0) {
        start = start_inputs(choice(6));
        quarter = quarter_period(start[1], start[2], start[3]);
        left = 9999;
    }
    Inputs in = start;
    in.push_back(choice(2) ? between(-40, 40) * quarter : sign() * quarter * log_between(-3, 6.6));
    return in;
}

static Inputs harmonics_inputs() {
    int region = choice(3);
    double n = 2 * choice(region == 0 ? 6 : 30) + 1;
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
    return {k, second(m), kc, expq(-PI * kc / k)};
}
static Answers incomplete_answers(const Inputs &in) {
    quad phi = in[3], beyond = (M_PI_2q - phi) + PI_LOW / 2;
    return {incomplete_first(sinq(phi) / sinq(beyond), modulus_of(in[1], in[2]).kc)};
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
    return {harmonic(in[1] == 1 ? (quad)in[2] : complement_of(in[2]), in[3])};
}

struct Function { std::function<Inputs()> inputs; std::function<Answers(const Inputs &)> answers; size_t width; };

static const std::map<std::string, Function> FUNCTIONS = {
    {"period", {period_inputs, period_answers, 3}},       {"excess", {excess_inputs, period_answers, 3}},
    {"complete", {modulus_inputs, complete_answers, 3}},  {"incomplete", {incomplete_inputs, incomplete_answers, 4}},
    {"jacobi", {jacobi_inputs, jacobi_answers, 4}},       {"motion", {motion_inputs, motion_answers, 5}},
    {"orbit", {orbit_inputs, motion_answers, 5}},
    {"harmonics", {harmonics_inputs, harmonics_answers, 4}},
};

static void write_record(Inputs record, const Answers &answers) {
    for (quad x : answers) {
        double hi = (double)x;
        record.push_back(hi);
        record.push_back((double)(x - hi));
    }
    fwrite(record.data(), sizeof(double), record.size(), stdout);
}

int main(int argc, char **argv) {
    auto found = argc < 2 ? FUNCTIONS.end() : FUNCTIONS.find(argv[1]);
    if (found == FUNCTIONS.end()) {
        fprintf(stderr, "usage: oracle period|excess|complete|incomplete|jacobi|motion|orbit|harmonics [COUNT SEED]\n");
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
