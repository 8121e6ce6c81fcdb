"""The sections of docs/figures.md on what the paper could not show, and on what the run took."""
import statistics

from frame_times import against, percentile, times_table
from markdown import listed, number, paragraph, picture, table

IMAGE_METHODS = ["texture", "warp", "warp2", "ldi"]
IMAGES = {"textures": "portal textures", "references": "reference images", "ldis": "layered depth images"}


def every_method(houses):
    text = "# What the paper could not show\n\n## Every method along the walk\n\n" + paragraph(
        "`geometry` draws all that is in the view, `raycast` casts Embree's primary rays, `warp` and `warp2` warp one and two "
        "reference images.")
    for house in houses:
        play = house.play
        text += picture(f"frame time along the walk through {house.name} by every method", f"{house.name}-all-methods.svg")
        text += times_table(play, play.methods)
        text += paragraph(f"`{house.name}`: {against(play, 'ldi', ['geometry', 'raycast', 'culling'])}")
    return text


def quality_row(house, method):
    play = house.play
    inside = play.values(method, "psnr_portals_db")
    uncovered = play.values(method, "uncovered_percent") or [0]
    return [f"`{house.name}`", f"`{method}`", number(statistics.mean(play.values(method, "psnr_db"))),
            number(statistics.mean(inside)), number(percentile(inside, 5)),
            number(statistics.mean(play.values(method, "ssim_portals"))),
            number(statistics.mean(uncovered), 2), number(max(uncovered), 2)]


def exact_frames(house):
    differing = house.play.values("culling", "differing_percent")
    return f"{differing.count(0)} of the {len(differing)} frames of `{house.name}`"


def quality(houses):
    text = "## How true the frames are\n\n" + paragraph(
        "Every frame is compared with `geometry`, inside the portals that show images and as a whole (identical frames count as "
        "100 dB). Uncovered are pixels that show a portal's image where no sample fell; nothing was filled in. The plots of PSNR "
        "end at 50 dB; lines break where no image is seen.")
    for house in houses:
        text += picture(f"PSNR, SSIM and uncovered pixels along the walk through {house.name}", f"{house.name}-quality.svg")
    heads = ["", "mean over the frames", "PSNR, dB", "in the portals", "its 5th percentile", "SSIM in the portals",
             "uncovered, %", "at most"]
    text += table(heads, [quality_row(house, method) for house in houses for method in IMAGE_METHODS])
    return text + paragraph(f"`culling` equals `geometry` to the pixel in {listed([exact_frames(h) for h in houses])}.")


def drawn(growth, method):
    """How many triangles a frame hands to OpenGL, from the smallest building to the largest."""
    means = [statistics.mean(play.values(method, "triangles")) for play in growth.plays]
    least, most = number(min(means)), number(max(means))
    return f"`{method}` hands {least if least == most else f'{least} to {most}'}"


def growth_plot(growth):
    triangles = growth.triangles()
    rows = [[f"{count:,}"] + [number(growth.medians(method)[i]) for method in growth.methods] + [f"{growth.seconds[i]} s"]
            for i, count in enumerate(triangles)]
    factors = listed([f"by `{m}` {number(growth.medians(m)[-1] / growth.medians(m)[0], 2)}" for m in growth.methods])
    frames = growth.plays[0].summary["frames"]
    return ("## As the triangles behind the portals grow\n\n"
            + paragraph(f"A hall with three doorways, to three rooms full of sculpture (`scripts/figures/behind.json`). The hall and "
                        f"the building's shell stay as they are; only what stands in the rooms behind gets finer. {frames} frames "
                        "along the hall, never nearer than 4 m to a doorway; median frame times in ms.")
            + picture("median frame time as the triangles behind the portals grow", "growth.svg")
            + table(["triangles"] + [f"`{method}`" for method in growth.methods] + ["preprocessing"], rows)
            + paragraph(f"With {number(triangles[-1] / triangles[0], 2)} times the triangles a frame takes so many times as long: "
                        f"{factors}. A frame of {drawn(growth, 'culling')} triangles to OpenGL in the mean, one of "
                        f"{drawn(growth, 'ldi')}."))


def what_it_took(houses, growth):
    rows = [[f"`{house.name}`", f"{house.seconds} s", f"{house.bytes / 1e6:,.0f} MB",
             ", ".join(f"{count:,} {IMAGES[kind]}" for kind, count in house.facts["portal_images"].items())]
            for house in houses]
    plays = [play for house in houses for play in (house.play, house.paper_play)] + growth.plays[:1]
    return ("## What it took\n\n" + paragraph("`enfilade preprocess` with all its images, and the house on disk:")
            + table(["", "time", "house", "images"], rows) + paragraph("The commands of the plays:")
            + "".join(f"    {play.summary['command']}\n" for play in plays))
