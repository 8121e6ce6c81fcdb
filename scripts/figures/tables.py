#!/usr/bin/env python3
"""Writes the small tables that plots read: growth.csv, layers.csv, and for the colour figures of each
house a line "FRAME PORTAL SIDE".
usage: tables.py RUNS HOUSE..."""
import os
import sys

import published
from runs import Growth, House, layer_shares
from views import portal_in_view


def write_csv(file, rows):
    with open(file, "w") as text:
        text.writelines(",".join(map(str, row)) + "\n" for row in rows)


def layer_rows(houses):
    columns = [("published", published.LAYER_SHARES)]
    for house in houses:
        columns.append((f"{house.name} as in the paper", layer_shares(house.paper_facts)))
        columns.append((f"{house.name}", layer_shares(house.facts)))
    rows = [["layer"] + [name for name, _ in columns]]
    return rows + [[label] + [shares[i] for _, shares in columns] for i, label in enumerate(["1", "2", "3", "4+"])]


def main():
    runs, names = sys.argv[1], sys.argv[2:]
    houses = [House(os.path.join(runs, name)) for name in names]
    growth = Growth(os.path.join(runs, "growth"))
    write_csv(os.path.join(runs, "layers.csv"), layer_rows(houses))
    write_csv(os.path.join(runs, "growth.csv"),
              [["triangles"] + growth.methods]
              + [list(row) for row in zip(growth.triangles(), *(growth.medians(m) for m in growth.methods))])
    for house in houses:
        frame = house.colour_frame()
        portal, side = portal_in_view(house.facts, house.tour["frames"][frame])
        with open(os.path.join(house.folder, "colour.txt"), "w") as text:
            text.write(f"{frame} {portal} {side}\n")


if __name__ == "__main__":
    main()
