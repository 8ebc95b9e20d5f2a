// A thousand seconds of T's cone (60 rad/s) by Boost.odeint's Fehlberg 7(8), in Euler angles: `odeint_cone TOLERANCE` prints the
// seconds of processor time, and psi, theta, phi and their rates at the end.

#include <boost/numeric/odeint.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using State = std::array<double, 6>;

constexpr double M = 0.03926990816987242, G = 9.81, I1 = 4.7860200582032015e-5, I3 = 2.9452431127404324e-5, D = 0.1125;
constexpr double AT_A = I1 + M * D * D;

void rates(const State& y, State& dy, double) {
    const double sine = std::sin(y[1]), cosine = std::cos(y[1]), p = y[3], t = y[4], f = y[5];
    const double moment = AT_A * p * cosine - I3 * (p * cosine + f);
    dy = {p, t, f, (-t * moment / AT_A - p * t * cosine) / sine, (M * G * D * sine + p * sine * moment) / AT_A, 0};
    dy[5] = p * t * sine - dy[3] * cosine;
}

int main(int count, char** arguments) {
    const double tolerance = count > 1 ? std::atof(arguments[1]) : 1e-12;
    namespace odeint = boost::numeric::odeint;
    State y = {0, std::acos(-1.0) / 6, 0, 0, 0, 60};
    const auto begin = std::clock();
    const auto stepper = odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(tolerance, tolerance);
    odeint::integrate_adaptive(stepper, rates, y, 0.0, 1000.0, 1e-3);
    std::printf("%.9f", double(std::clock() - begin) / CLOCKS_PER_SEC);
    for (const double number : y) std::printf(" %.17g", number);
    std::puts("");
}
