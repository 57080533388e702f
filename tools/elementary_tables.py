#!/usr/bin/env python3
"""elementary_tables.py [--check] -- writes src/core/elementary/tables.c from the definitions, in decimal arithmetic of 420
digits; --check only compares. The tables are in the tree so that a build needs no Python."""
import sys
from decimal import Decimal, getcontext
from fractions import Fraction
from pathlib import Path

getcontext().prec = 420
ONE = Decimal(1)
PLACE = Path(__file__).resolve().parent.parent / "src/core/elementary/tables.c"


def arctan_of_inverse(n):
    """atan(1/n), by its series"""
    term, total, k = ONE / n, Decimal(0), 0
    while abs(term) > Decimal(10) ** -410:
        total += term / (2 * k + 1) * (-1) ** k
        term /= n * n
        k += 1
    return total


PI = 4 * (4 * arctan_of_inverse(5) - arctan_of_inverse(239))  # Machin
LN2 = Decimal(2).ln()


def sine(x, first):
    """sin for first = 1, cos for first = 0, by the series"""
    term, total, k = x**first if first else ONE, Decimal(0), first
    while abs(term) > Decimal(10) ** -410 or k < 4:
        total += term
        term *= -x * x / ((k + 1) * (k + 2))
        k += 2
    return total


def arctan(x):
    """by halving the angle until the series is quick"""
    for _ in range(20):
        x = x / (1 + (1 + x * x).sqrt())
    term, total, k = x, Decimal(0), 0
    while abs(term) > Decimal(10) ** -415:
        total += term / (2 * k + 1) * (-1) ** k
        term *= x * x
        k += 1
    return total * 2**20


def exact(double):
    f = Fraction(double)
    return Decimal(f.numerator) / Decimal(f.denominator)


def nearest(x):
    """float() of a Decimal rounds correctly"""
    return float(x)


def cut(x, bits):
    """the leading bits of x"""
    f = Fraction(x) if not isinstance(x, Decimal) else Fraction(str(x))
    sign = -1 if f < 0 else 1
    f = abs(f)
    shift = 0
    while f >= 2**bits:
        f /= 2
        shift += 1
    while f < 2 ** (bits - 1):
        f *= 2
        shift -= 1
    return sign * float(Fraction(int(f)) * Fraction(2) ** shift)


def pair(x):
    high = nearest(x)
    return high, nearest(x - exact(high))


def text(double):
    return "0" if double == 0 else double.hex().replace("0000000000000p", "p").replace(".0p", ".p").replace(".p", "p")


def table(name, comment, values):
    rows = ",\n".join("    {%s, %s}" % (text(h), text(l)) for h, l in values)
    return f"/* {comment} */\nconst taut_twice {name}[{len(values)}] = {{\n{rows}}};\n"


def inverse_of_cell(i):
    """about 1/m for m = 1 + i/128 .. 1 + (i+1)/128, in nine bits; cells next to 1 have 1"""
    if i in (0, 127):
        return 1.0 if i == 0 else 0.5
    return round(512 / (1 + (i + 0.5) / 128)) / 512


def main():
    exps = [pair((LN2 * j / 64).exp()) for j in range(64)]
    inverses = [inverse_of_cell(i) for i in range(128)]
    # cells from 1.414 on belong to the next power of two: their logarithm is taken of m/2
    def log_of(i):
        c = exact(inverses[i]) * (2 if i >= 53 else 1)
        return pair(-c.ln()) if c != 1 else (0.0, 0.0)
    logs = [log_of(i) for i in range(128)]
    sines = [pair(sine(Decimal(j) / 32, 1)) if j else (0.0, 0.0) for j in range(27)]
    cosines = [pair(sine(Decimal(j) / 32, 0)) for j in range(27)]
    angles = [pair(arctan(Decimal(j) / 32)) if j else (0.0, 0.0) for j in range(33)]
    two_over_pi = 2 / PI
    words = []
    rest = two_over_pi
    for _ in range(40):
        rest *= 2**32
        words.append(int(rest))
        rest -= int(rest)
    out = ["/* tables.c -- made by tools/elementary_tables.py. */\n/* clang-format off */\n#include \"core/elementary/internal.h\"\n"]
    out.append(table("taut_table_exp", "2^(j/64)", exps))
    out.append("/* about 1/m in the cell 1 + i/128 <= m < 1 + (i+1)/128, in nine bits; from 53 on about 2/m */\nconst double taut_table_inverse[128] = {\n"
               + ",\n".join("    " + ", ".join(text(inverses[i] * (2 if i >= 53 else 1)) for i in range(s, s + 8)) for s in range(0, 128, 8)) + "};\n")
    out.append(table("taut_table_log", "minus the logarithms of those", logs))
    out.append(table("taut_table_sin", "sin(j/32)", sines))
    out.append(table("taut_table_cos", "cos(j/32)", cosines))
    out.append(table("taut_table_atan", "atan(j/32)", angles))
    out.append("/* 2/pi: the bits behind the point */\nconst uint32_t taut_table_two_over_pi[40] = {\n"
               + ",\n".join("    " + ", ".join("0x%08xu" % w for w in words[s:s + 6]) for s in range(0, 40, 6)) + "};\n")
    made = "\n".join(out)
    if "--constants" in sys.argv:
        def parts(x, bits):
            result, rest = [], x
            for b in bits:
                p = cut(rest, b) if b < 53 else nearest(rest)
                result.append(text(p))
                rest -= exact(p)
            return result
        print("pi/2 in 33, 33, 33, 53", parts(PI / 2, [33, 33, 33, 53]))
        print("pi/2 twice", parts(PI / 2, [53, 53]))
        print("pi twice", parts(PI, [53, 53]))
        print("ln2/64 in 36, 53", parts(LN2 / 64, [36, 53]))
        print("ln2 in 42, 53", parts(LN2, [42, 53]))
        print("ln2 twice", parts(LN2, [53, 53]))
        print("1/ln2 twice", parts(1 / LN2, [53, 53]))
        print("1/ln10 twice", parts(1 / Decimal(10).ln(), [53, 53]))
        return 0
    if "--check" in sys.argv:
        if PLACE.read_text() != made:
            print(f"elementary_tables: {PLACE} is not what its definitions give", file=sys.stderr)
            return 1
        return 0
    PLACE.write_text(made)
    return 0


if __name__ == "__main__":
    sys.exit(main())
