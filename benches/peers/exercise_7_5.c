/*
 * Program 7.5 of P ("Le pendule et ses variantes chaotiques") without its drawing: a pendulum over three magnets,
 * started at rest from every point of a square. One start after the other and scalar, as printed.
 *
 *   exercise_7_5 N STEPS [FILE]
 *
 * Protocol: README.md beside this file.
 *
 * Differences from the print:
 * - the third cube is printed as D2*D2*D2*D2, a misprint (the two others and program 7.4 have the cube): D2*D2*D2 here;
 * - the starts are not pixels rounded to `float` but N x N points over [-2, 2]^2 with both ends; y is the outer loop
 *   and x the inner one, both ascending (the print has x outside, and y descending);
 * - the number of steps is an argument (40000 in the print), and the final position is kept instead of a colour.
 */
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifndef PEER
#define PEER "gcc"
#endif

static void integrate(long n, long steps, double *restrict out)
{
    const double d = 0.1, C = 4., R = 0.2, dt = 0.0001;
    const double xx[3] = {0.5, -0.25, -0.25}, yy[3] = {0., 0.433, -0.433};

    for (long iy = 0; iy < n; iy++) {
        for (long ix = 0; ix < n; ix++) {
            double x = -2. + 4. * (double)ix / (double)(n - 1), y = -2. + 4. * (double)iy / (double)(n - 1);
            double vx = 0., vy = 0.;

            for (long k = 0; k < steps; k++) {
                double D0 = sqrt((x - xx[0]) * (x - xx[0]) + (y - yy[0]) * (y - yy[0]) + d * d), D03 = D0 * D0 * D0;
                double D1 = sqrt((x - xx[1]) * (x - xx[1]) + (y - yy[1]) * (y - yy[1]) + d * d), D13 = D1 * D1 * D1;
                double D2 = sqrt((x - xx[2]) * (x - xx[2]) + (y - yy[2]) * (y - yy[2]) + d * d), D23 = D2 * D2 * D2;
                double ax = -C * x - R * vx + (xx[0] - x) / D03 + (xx[1] - x) / D13 + (xx[2] - x) / D23;
                double ay = -C * y - R * vy + (yy[0] - y) / D03 + (yy[1] - y) / D13 + (yy[2] - y) / D23;
                x += vx * dt + 0.5 * ax * dt * dt;
                y += vy * dt + 0.5 * ay * dt * dt;
                vx += ax * dt;
                vy += ay * dt;
            }
            *out++ = x;
            *out++ = y;
        }
    }
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static long number(const char *text, const char *name, long least, long most)
{
    char *end;
    errno = 0;
    long value = strtol(text, &end, 10);
    if (errno || end == text || *end || value < least || value > most) {
        fprintf(stderr, "exercise_7_5: %s is a whole number from %ld to %ld, not '%s'\n", name, least, most, text);
        exit(2);
    }
    return value;
}

/* Little-endian whatever the machine is. */
static int write_positions(const char *path, const double *values, size_t count)
{
    FILE *file = fopen(path, "wb");
    if (!file)
        return -1;
    for (size_t i = 0; i < count; i++) {
        uint64_t bits;
        unsigned char bytes[8];
        memcpy(&bits, &values[i], 8);
        for (int k = 0; k < 8; k++)
            bytes[k] = (unsigned char)(bits >> (8 * k));
        if (fwrite(bytes, 1, 8, file) != 8) {
            fclose(file);
            return -1;
        }
    }
    return fclose(file);
}

int main(int argc, char **argv)
{
    if (argc != 3 && argc != 4) {
        fprintf(stderr, "usage: exercise_7_5 N STEPS [FILE]\n");
        return 2;
    }
    long n = number(argv[1], "N", 2, 30000), steps = number(argv[2], "STEPS", 0, 1000000000);
    size_t count = 2 * (size_t)n * (size_t)n;
    double *out = calloc(count, sizeof *out);
    if (!out) {
        fprintf(stderr, "exercise_7_5: no memory for %ld x %ld points\n", n, n);
        return 1;
    }

    double begin = now();
    integrate(n, steps, out);
    double seconds = now() - begin;

    if (argc == 4 && write_positions(argv[3], out, count)) {
        fprintf(stderr, "exercise_7_5: cannot write '%s': %s\n", argv[3], strerror(errno));
        return 1;
    }
    printf("{\"peer\": \"%s\", \"seconds\": %.9f, \"points\": %ld, \"steps\": %ld, \"version\": \"%s\"}\n", PEER, seconds,
           n * n, steps, __VERSION__);
    free(out);
    return 0;
}
