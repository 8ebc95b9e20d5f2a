/*
 * Are our final positions those of the C program, where it agrees with itself?
 *
 *   compare_positions ONE OTHER [OURS [LIMIT]]
 *
 * ONE and OTHER are the C program's positions with two contractions (little-endian f64 pairs x, y). Points "agree" where
 * they are no farther apart than 1e-12; the others are chaos amplifying a rounding, and nobody's position is right there.
 * Standard output has one line of JSON: points, how many agree, and, if OURS is given, the largest distance from ONE to
 * OURS among those and the index of that point.
 * Exit status 1: no point agrees, or that distance is above LIMIT (1e-9); 2: a file cannot be compared.
 */
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define AGREE 1e-12

/* Reads one pair; 1, or 0 at the end, and the program ends on half a pair. */
static int pair(FILE *file, const char *name, double *values)
{
    unsigned char bytes[16];
    size_t got = fread(bytes, 1, 16, file);
    if (got == 0 && !ferror(file))
        return 0;
    if (got != 16) {
        fprintf(stderr, "compare_positions: '%s' is not made of pairs of f64\n", name);
        exit(2);
    }
    for (int i = 0; i < 2; i++) {
        uint64_t bits = 0;
        for (int k = 7; k >= 0; k--)
            bits = bits << 8 | bytes[8 * i + k];
        memcpy(&values[i], &bits, 8);
    }
    return 1;
}

static double distance(const double *a, const double *b)
{
    return hypot(a[0] - b[0], a[1] - b[1]);
}

int main(int argc, char **argv)
{
    if (argc < 3 || argc > 5) {
        fprintf(stderr, "usage: compare_positions ONE OTHER [OURS [LIMIT]]\n");
        return 2;
    }
    int files = argc == 3 ? 2 : 3;
    double limit = 1e-9;
    if (argc == 5) {
        char *end;
        limit = strtod(argv[4], &end);
        if (end == argv[4] || *end || !(limit >= 0.)) {
            fprintf(stderr, "compare_positions: LIMIT is a number, not '%s'\n", argv[4]);
            return 2;
        }
    }
    FILE *file[3];
    for (int i = 0; i < files; i++) {
        file[i] = fopen(argv[1 + i], "rb");
        if (!file[i]) {
            fprintf(stderr, "compare_positions: cannot read '%s': %s\n", argv[1 + i], strerror(errno));
            return 2;
        }
    }

    long points = 0, agree = 0, at = -1;
    double largest = 0.;
    for (;; points++) {
        double value[3][2];
        int present = 0;
        for (int i = 0; i < files; i++)
            present += pair(file[i], argv[1 + i], value[i]);
        if (present == 0)
            break;
        if (present != files) {
            fprintf(stderr, "compare_positions: the files differ in length (after %ld points)\n", points);
            return 2;
        }
        if (!(distance(value[0], value[1]) <= AGREE))
            continue;
        agree++;
        if (files == 3) {
            double far = distance(value[0], value[2]);
            if (isnan(far))
                far = INFINITY;
            if (at < 0 || far > largest) {
                largest = far;
                at = points;
            }
        }
    }

    printf("{\"points\": %ld, \"agree\": %ld", points, agree);
    if (files == 3 && agree > 0) {
        if (isinf(largest)) /* JSON knows no infinity */
            printf(", \"largest\": null, \"at\": %ld", at);
        else
            printf(", \"largest\": %.3e, \"at\": %ld", largest, at);
    }
    printf("}\n");
    return agree == 0 || largest > limit;
}
