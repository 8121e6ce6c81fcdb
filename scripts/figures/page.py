#!/usr/bin/env python3
"""Writes docs/figures.md from the runs of `make figures`.  usage: page.py RUNS PAGE HOUSE..."""
import datetime
import os
import sys

import further_sections
import paper_sections
from markdown import listed, number, paragraph
from runs import Growth, House


def head(houses):
    summary = houses[0].play.summary
    machine = summary["machine"]
    size = f"{summary['size'][0]} × {summary['size'][1]} pixels, {summary['frames']} frames"
    memory = number(machine["memory_bytes"] / 2**30, 2)
    return ("<!-- Written by `make figures` (scripts/figures/page.py). Do not edit: the next run writes it anew. -->\n"
            "# The paper's figures\n\n"
            + paragraph("*Images for Accelerating Architectural Walkthroughs*, Matthew M. Rafferty, Daniel G. Aliaga, Voicu Popescu "
                        "and Anselmo A. Lastra, IEEE Computer Graphics and Applications 18(6), 1998, reproduced in one run.")
            + paragraph("Ours stand beside what the paper published as far as this project knows it: its houses' cells, portals and "
                        "polygons, the samples in each layer of one layered depth image, how many samples clipping removes, and "
                        "what a warp took on an SGI Onyx. Where a cell says n/k, the published number is not known to us.")
            + f"- Machine: {machine['cpu']}, {summary['threads']} threads, {memory} GiB, {machine['system']}\n"
            f"- Drawn by: {machine['gl_renderer']}\n"
            f"- enfilade {summary['tool_version']}, {datetime.date.today().isoformat()}; {size}; "
            f"houses: {listed([house.name for house in houses])}\n\n")


def main():
    runs, page, names = sys.argv[1], sys.argv[2], sys.argv[3:]
    houses = [House(os.path.join(runs, name)) for name in names]
    growth = Growth(os.path.join(runs, "growth"))
    paper = [paper_sections.houses_table, paper_sections.figure_6, paper_sections.figure_5, paper_sections.clipping,
             paper_sections.warps, paper_sections.colour_figures]
    further = [further_sections.every_method, further_sections.quality]
    text = head(houses) + "".join(section(houses) for section in paper + further)
    text += further_sections.growth_plot(growth) + further_sections.what_it_took(houses, growth)
    with open(page, "w") as file:
        file.write(text)


if __name__ == "__main__":
    main()
