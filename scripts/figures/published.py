"""What the paper published, as far as this project knows it: Rafferty, Aliaga, Popescu and Lastra, Images for
Accelerating Architectural Walkthroughs, IEEE Computer Graphics and Applications 18(6), 1998."""

HOUSES = {
    "brooks": {"name": "Brooks House", "cells": 19, "portals": 52, "triangles": 1_744_000},
    "haunted": {"name": "Haunted House", "cells": 7, "portals": 12, "triangles": 214_000},
}
LAYER_SHARES = [72.1, 19.4, 5.8, 2.7]  # percent of the samples in layers 1, 2, 3 and beyond
LAYER_SAMPLES = 167_295                # of the image that they were counted in
CLIPPED_SHARE = 0.5                    # of an image's samples, by columns, on average
WARP_MS = 30                           # one image of 256 x 256 samples, SGI Onyx
WARP_NS_A_SAMPLE = 458
LDI_MS = (30, 90)                      # one layered depth image, SGI Onyx
