"""200 texts that a person could enter into a field, by mistake or on purpose; equal in every run."""

import random

CHARACTERS = [chr(code) for code in (*range(0x20), 0x7F, 0x80, 0x9F, 0xA0, 0xAD)]
BIDIRECTIONAL = list("\u061c\u200b\u200d\u200e\u200f\u2028\u2029\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2069\ufeff")
HOSTS = [
    "", " ", ".", "..", "a..b", ".a", "a.", "a" * 63, "a" * 64, ".".join(["a" * 64] * 3), "a." * 126,
    "a." * 200, "-a", "a-", "a_b", "-", "_", "*", "a b", "a/b", "a@b", "a:b", "a:80", "http://a", "[::1]",
    "::1", "::", ":::", "1::2::3", "fe80::1%lo", "fe80::1%" + "x" * 40, "::ffff:127.0.0.1", "::ffff:999.0.0.1",
    "0", "1", "127.1", "127.0.0.1.", "127.0.0.256", "1.2.3.4.5", "0x7f000001", "0x", "0177.0.0.1", "4294967296",
    "127.0.0.1", "0.0.0.0", "255.255.255.255", "224.0.0.1", "192.0.2.1", "localhost", "LOCALHOST.",
    "none.invalid", "xn--", "xn--a", "xn--mnchen-3ya.de", "münchen.de", "a.b", "\u00ad.de", "１２７.0.0.1",
    "例え.テスト", "a\u3002b", "ß" * 63, "\U0001f9bd", "\U0001f9bd" * 64,
]  # fmt: skip
PATHS = [
    "/", "/dev/zero", "/dev/null", "/dev/full", "/dev/random", "/dev/stdin", "/dev/tty", "/dev/tty0",
    "/dev/ttyUSB0", "/dev/ttyS0", "/dev/pts/ptmx", "/dev/../dev/zero", "/dev/tty/../zero", "/dev/ttyS0/../zero",
    "/dev/mem", "/dev/watchdog", "/proc/self/mem", "/proc/self/environ", "/etc/passwd", "/etc/shadow",
    "../../etc/passwd", "..\\..\\x", "~", "~root", "file:///etc/passwd", "socket://127.0.0.1:80", "loop://",
    "spy:///dev/ttyS0", "COM3", "COM1000", "\\\\.\\COM3", "\\\\a\\b", "a\0b", "a\nb", "x" * 4096, "x" * 4097,
    "/" * 4000, "a/" * 2000, "pipe", "folder", "missing.csv", "words.csv", "empty.csv", "link.csv", "${HOME}",
    "$(id)", "`id`", "%s%n", "{0}", "{}", "None", "null", "true", "NaN", "-1", "1e999", "0.1", "' OR 1=1 --",
    '"', "'", "<script>", "&amp;", "\\", "\\u0000", "é", "e\u0301", "\ufffd", "\ud800", "\udfff", "a\udc80",
    "x" * 100_000, "é" * 5000,
]  # fmt: skip


def odd_values(count=200, seed=1):
    """Return exactly `count` different texts: all those above, then mixtures of their letters."""
    dice = random.Random(seed)
    values = [*CHARACTERS, *BIDIRECTIONAL, *HOSTS, *PATHS]
    letters = [*CHARACTERS, *BIDIRECTIONAL, *"ab.-_/:%\\", "é", "\U0001f9bd"]
    values = list(dict.fromkeys(values))
    while len(values) < count:
        values.append("".join(dice.choices(letters, k=dice.randint(2, 80))))
    return values[:count]
