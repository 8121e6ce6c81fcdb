"""Frame times of a walk, in a table and in words."""
import statistics

from markdown import listed, number, speed, table


def percentile(values, share):
    """Linear between the closest ranks, as the reports have it."""
    return statistics.quantiles(values, n=100, method="inclusive")[share - 1]


def times_row(play, method):
    times = play.values(method, "frametime_ms")
    figures = (min(times), statistics.median(times), percentile(times, 95), max(times))
    return [f"`{method}`"] + [number(value) for value in figures]


def times_table(play, methods):
    return table(["frame time, ms", "least", "median", "95th percentile", "most"],
                 [times_row(play, method) for method in methods])


def against(play, method, others):
    """In the median `ldi` is 1.2 times as fast as `culling`, …"""
    parts = [f"{speed(play.median_ms(method), play.median_ms(other))} `{other}`" for other in others]
    return f"In the median `{method}` is {listed(parts)}."
