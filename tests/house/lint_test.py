#!/usr/bin/env python3
"""The lint finds what it is there to find, and nothing else."""
import os
import tempfile

import lint

# One offence a line, each in a file of its own.
OFFENCES = '''
double f(double x) { return std::sin(x); }
double f(double x) { return std :: pow (x, 2); }
double f(double x) { using std::exp; return exp(x); }
auto a = std::transform(b, e, o, std::exp);
auto p = static_cast<double (*)(double)>(&cosh);
double f(double x) { return ::pow(x, 2); }
float y = sinf(x);
double f(double x) { return std::fma(x, x, x); }
double f(double x) { return __builtin_powi(x, 3); }
void f(double x, double* a, double* b) { sincos(x, a, b); }
double f(double x) { return exp10(x) + j0(x); }
double f(double x) { return std::riemann_zeta(x); }
namespace s = std; double f(double x) { return s::sin(x); }
using namespace std;
#include <complex>
#include <unordered_map>
__gnu_cxx::hash_map<int, int> m;
std::map<const Node*, int> seen;
std::set<std::shared_ptr<Node>> seen;
std::less<const Node*> by_address;
auto a = reinterpret_cast<std::uintptr_t>(p);
void f(int* a) { std::sort(a, a + 2); }
void f(std::vector<int>& a) { std::ranges::sort(a); }
namespace rg = std::ranges; void f(std::vector<int>& a) { sort(a.begin(), a.end()); }
using std::sort;
std::partial_sort_copy(a, b, c, d);
std::priority_queue<Item> queue;
std::qsort(a, 2, 4, c);
#include <chrono>
auto t = std::chrono::steady_clock::now();
timespec t; clock_gettime(0, &t);
auto t = time(nullptr);
const char* t = __TIME__;
auto t = __rdtsc();
int f() { return rand(); }
std::random_device d;
std::mt19937 g;
std::shuffle(a, b, g);
std::locale l;
double f(const char* s) { return strtold(s, nullptr); }
double f(const std::string& s) { return std::stof(s); }
bool f(char c) { return isalpha(c); }
fprintf(out, "%f", x);
sscanf(s, "%lf", &x);
std::ostringstream out;
#include <iomanip>
std::regex r("a");
std::ifstream f("a");
auto f = fopen("a", "r");
auto f = ::open("a", 0);
std::cout << x;
std::getenv("A");
long double f(long double x) { return x; }
#pragma GCC optimize("fast-math")
#pragma STDC FP_CONTRACT ON
__attribute__((optimize("fast-math"))) double f();
std::fesetround(FE_UPWARD);
#include <immintrin.h>
#pragma omp parallel for
double f() { return std::reduce(a, b); }
std::for_each(std::execution::par, a, b, c);
std::thread t(f);
std::atomic<int> a;
thread_local int x;
auto n = glm::normalize(v);
auto a = shares_of(line).value();
auto c = *geometry::make_camera(pose);
#include "../mesh/mesh.h"
#include "mesh.h"
'''
BAD = {'core/rig/%d/a.cpp' % i: line + '\n' for i, line in enumerate(OFFENCES.strip().splitlines())}
BAD['core/CMakeLists.txt'] = 'target_compile_options(core_rig PRIVATE -ffast-math)\n'
BAD['CMakeLists.txt'] = 'add_compile_options(-march=native)\n'
BAD['tests/core/lines.h'] = 'int a;  // TODO\n'
BAD['ui/app/taken.cpp'] = '#include "core/io/gltf/internal/gltf_extras.h"\n'
BAD['docs/sessions.md'] = '# Sessions\n\nThe number (`core/base/edition.h`; today 5).\n'
BAD['docs/formats.md'] = '`# penpose session edition=7 program=NAME`\n'
GOOD = {
    'docs/animator.md': 'Keys of edition 4, and `edition=NUMBER`.\n',
    'core/rig/a.cpp': '#include "core/base/math.h"\n// std::sin( would differ\ndouble f(double x) { return base::sin(x) + std::sqrt(x); }\n',
    'ui/app/b.cpp': '#include <chrono>\n#include <unordered_map>\ndouble g(double x) { return std::sin(x); }\n',
    'core/rig/c.cpp': 'const char* a = "sin(x) rand() time( std::sort(";\nconst char* b = R"(exp(x))";\nchar c = \'"\'; double d = 1\'000; int e = a.exp(1);\n',
    'core/rig/d.cpp': 'std::priority_queue<std::size_t> q; int unit_time(int); double f() { return unit_time(1) + log_of(2); }\n',
    'replay/e.cpp': 'auto a = std::move(b).value();\n// Cannot fail: the pose is ours.\nauto c = Camera::make(pose).value();\n',
    'tests/f.cpp': 'auto a = read(b).value();\n',
    'core/io/surface/own.cpp': '#include "core/io/gltf/internal/gltf_extras.h"\n',
    'tests/core/io/own_test.cpp': '#include "core/io/gltf/internal/gltf_extras.h"\n',
    'CMakeLists.txt': 'add_compile_options(-ffp-contract=off -fno-fast-math)\n',
    'core/base/math.cpp': 'double sin(double x) { return std::frexp(x, nullptr); }\n',
}


def count(files):
    with tempfile.TemporaryDirectory() as root:
        for path, text in files.items():
            os.makedirs(os.path.join(root, os.path.dirname(path)), exist_ok=True)
            with open(os.path.join(root, path), 'w', encoding='utf-8') as f:
                f.write(text)
        return {line.split(':')[0] for line in lint.faults(root)}


assert count(BAD) == set(BAD), count(BAD)
assert count(GOOD) == set(), count(GOOD)
assert count({'ui/app/full/%d.h' % i: '' for i in range(lint.MOST_SOURCES + 1)}) == {'ui/app/full'}
assert count({'ui/app/full/%d.h' % i: '' for i in range(lint.MOST_SOURCES)}) == set()
print('the lint finds its faults')
