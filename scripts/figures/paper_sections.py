"""The sections of docs/figures.md that set ours beside what the paper shows."""
import statistics

import published
from frame_times import against, times_table
from markdown import number, paragraph, percent, picture, table
from runs import layer_shares

AS_PAPER = "13 captures, 256 rows"
AS_USUAL = "as `preprocess` does"
COLOUR = [("A", "everything drawn, the truth"), ("B", "the nearest portal texture"),
          ("C", "the nearest reference image, warped"), ("D", "the two nearest, warped"),
          ("E", "the layered depth image, warped")]
AUTHORS_PAGE = "http://www.cs.unc.edu/~ibr/projects/ArchWalkAcc/ArchitecturalWalkthroughs.html"


def houses_table(houses):
    rows = []
    for house in houses:
        theirs = published.HOUSES.get(house.name)
        if theirs:
            rows.append([theirs["name"], "published", theirs["cells"], theirs["portals"], f"{theirs['triangles']:,}"])
        rows.append([f"`{house.name}`", "ours", house.rooms(), len(house.facts["portals"]),
                     f"{house.facts['building']['triangles']:,}"])
    return ("## The houses\n\n" + table(["house", "", "cells", "portals", "polygons"], rows)
            + paragraph("Cells are rooms; the outside, one more, is not counted. Ours are buildings of our own, from "
                        "`enfilade sample`."))


def figure_6(houses):
    text = "## Figure 6: frame time along the walk\n\n" + paragraph(
        "By the paper's three ways to show what lies behind a portal. Its curves and frame times are not known to us.")
    for house in houses:
        text += picture(f"frame time along the walk through {house.name} by culling, ldi and texture",
                        f"{house.name}-frame-times.svg")
        text += times_table(house.play, ["culling", "ldi", "texture"])
        text += paragraph(f"`{house.name}`: {against(house.play, 'ldi', ['culling', 'texture'])}")
    return text


def figure_5(houses):
    rows = [["published, one image", f"{published.LAYER_SAMPLES:,}"] + [f"{s:.1f}" for s in published.LAYER_SHARES]]
    for house in houses:
        for facts, how in ((house.paper_facts, AS_PAPER), (house.facts, AS_USUAL)):
            samples = statistics.mean(side["samples"] for side in facts["layers"]["sides"])
            rows.append([f"`{house.name}`, {how}", number(samples)] + [f"{s:.1f}" for s in layer_shares(facts)])
    return ("## Figure 5: samples in each layer of a layered depth image\n\n"
            + picture("share of the samples in each layer", "layers.svg")
            + table(["", "samples an image", "layer 1, %", "layer 2, %", "layer 3, %", "4 and more, %"], rows)
            + paragraph("Ours are of all the layered depth images of a house together, the samples an image their mean. The paper "
                        "made an image from 13 captures of 256 × 256; `preprocess` of itself takes 27, in three rings, of 384 "
                        "rows, which see farther under and behind things."))


def clipping(houses):
    rows = [["published", "columns", percent(published.CLIPPED_SHARE, 0)]]
    for house in houses:
        for play, how, by in ((house.paper_play, AS_PAPER, "columns"), (house.play, AS_USUAL, "tiles of 16 × 16")):
            rows.append([f"`{house.name}`, {how}", by, percent(play.clipped_share("ldi"))])
    return ("## Samples removed by clipping\n\n"
            + paragraph("Of the samples of the layered depth images shown along the walk, the share left out before the warp "
                        "because it cannot appear in the portal.")
            + table(["", "clipped by", "removed"], rows))


def warp_row(name, play, method):
    images, samples = play.total(method, "portals_as_images"), play.total(method, "samples")
    milliseconds = play.total(method, "warp_ms")
    return [name, f"`{method}`", number(milliseconds / images, 2), number(1e6 * milliseconds / samples, 2),
            number(samples / images)]


def warps(houses):
    rows = [["published", "one reference image", published.WARP_MS, published.WARP_NS_A_SAMPLE, f"{256 * 256:,}"],
            ["published", "one layered depth image", "{}–{}".format(*published.LDI_MS), "n/k", "n/k"]]
    for house in houses:
        for method in ("warp", "ldi"):
            rows.append(warp_row(f"`{house.name}`, 256 rows, by columns", house.paper_play, method))
            rows.append(warp_row(f"`{house.name}`, {AS_USUAL}, by tiles", house.play, method))
    return ("## What a warp takes\n\n"
            + paragraph("Along the walk, the time that frames spent warping by the images that they show, and by the samples "
                        "warped, those left after clipping; with all threads, and the default splat.")
            + table(["", "", "ms an image", "ns a sample", "samples an image"], rows))


def colour_of(house):
    frame = house.colour_frame()
    cells = [f"**{letter}** {what}<br>![{what}](figures/{house.name}-{letter.lower()}.jpg)" for letter, what in COLOUR]
    cells.append(f"**F** layers 1 to 4<br>![the layers](figures/{house.name}-f.jpg)")
    values = []
    for method in ("warp", "warp2", "ldi"):
        psnr = dict(house.play.column(method, "psnr_portals_db"))[frame]
        uncovered = dict(house.play.column(method, "uncovered_percent"))[frame]
        values.append(f"`{method}` {number(psnr)} dB in the portals, {number(uncovered, 2)} % of the frame uncovered")
    return (f"### `{house.name}`, frame {frame}\n\n" + table(cells[0:2], [cells[2:4], cells[4:6]])
            + paragraph(f"Against A: {'; '.join(values)}.")
            + picture(f"the floor plan of {house.name}, its portals marked", f"{house.name}-plan.svg"))


def colour_figures(houses):
    return ("## Colour figures A to F\n\n"
            + paragraph(f"After the paper's: of its own we know that F shows an image's layers; what A to E show here is our "
                        f"choice. Its authors' [page]({AUTHORS_PAGE}) has the contrast of C and E, a simple depth image and a "
                        "layered one.")
            + paragraph("A to E are one frame of the walk: of those that look into a room through a portal, the one where a single "
                        "reference image leaves most of the picture uncovered. F is of the layered depth image of the portal "
                        "that it looks at: where the first layer is dense, grey where a layer has no sample.")
            + "".join(colour_of(house) for house in houses))
