"""Markdown, and numbers as a reader wants them."""
import textwrap


def paragraph(text):
    return textwrap.fill(" ".join(text.split()), 140, break_long_words=False, break_on_hyphens=False) + "\n\n"


def table(heads, rows):
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n\n"


def picture(text, file):
    return f"![{text}](figures/{file})\n\n"


def number(value, digits=3):
    """`digits` significant ones, thousands parted by commas."""
    if value == 0:
        return "0"
    rounded = float(f"{value:.{digits}g}")
    return f"{rounded:,.0f}" if abs(rounded) >= 10 ** (digits - 1) else f"{rounded:g}"


def percent(share, digits=1):
    return f"{100 * share:.{digits}f} %"


def listed(words):
    return words[0] if len(words) == 1 else ", ".join(words[:-1]) + " and " + words[-1]


def speed(ours_ms, theirs_ms):
    """How the first compares with the second: '1.4 times as fast as'."""
    ratio = theirs_ms / ours_ms
    if 0.95 < ratio < 1.05:
        return "as fast, within 5 %, as"
    return f"{number(ratio, 2)} times as fast as"
