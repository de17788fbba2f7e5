"""Contacts as lines between fragments, as wide as their forces."""
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D

from . import mesh_picture, style
from .trouble import Trouble

WIDEST = 5.0  # points, of the largest force
PALE = "#e9edf1"
LARGE = 4  # a fragment so many times larger than its partner is a floor or a wall: no leg to its centre
FAINTEST = 0.01  # of the largest force


def legs(chains):
    """Ends and forces [N] of the legs worth a line, by rising force."""
    force = np.linalg.norm(chains.arrays["force"].values, axis=1)
    wall = chains.arrays["size"].values > LARGE * chains.arrays["partner_size"].values
    chosen = ~wall & (force > FAINTEST * force.max(initial=0))
    order = np.argsort(force[chosen])
    return chains.points[chains.cells[chosen]][order], force[chosen][order]


def draw_bodies(axes, grid):
    if grid.dimension == 2:
        xy = grid.points[:, :2]
        axes.add_collection(PolyCollection(xy[grid.cells], facecolors=PALE, edgecolors="face", linewidths=0.25, zorder=1))
        outline = xy[mesh_picture.border(grid.cells, mesh_picture.families(grid))]
        axes.add_collection(LineCollection(outline, colors=style.INK, linewidths=0.4, alpha=0.6, zorder=2))
        return xy
    faces, _, normal = mesh_picture.surface(grid.points, grid.cells)
    look = mesh_picture.camera()
    place = (grid.points @ look.T)[:, :2]
    seen = faces[normal @ look[2] > 0]
    axes.add_collection(PolyCollection(place[seen], facecolors=PALE, edgecolors="none", alpha=0.35, zorder=1))
    mesh_picture.draw_axes_cross(axes, look)
    return place


def draw(axes, grid, chains):
    """Bodies, pale, with the legs over them."""
    if not len(grid.cells):
        raise Trouble("the frame has no cells")
    place = draw_bodies(axes, grid)
    if chains is not None and len(chains.cells):
        ends, force = legs(chains)
        flat = ends[:, :, :2] if grid.dimension == 2 else (ends @ mesh_picture.camera().T)[:, :, :2]
        share = force / force.max(initial=1e-300)
        lines = LineCollection(flat, linewidths=0.3 + WIDEST * share, colors=style.SEQUENTIAL(0.35 + 0.65 * share), zorder=3)
        lines.set_capstyle("round")
        axes.add_collection(lines)
        if len(force):
            factor, unit = style.prefixed("N", force.max())
            text = f"{force.max() * factor:.3g} {unit}"
            key = Line2D([], [], color=style.SEQUENTIAL(1.0), linewidth=WIDEST, label=f"largest force between two fragments: {text}")
            axes.legend(handles=[key], loc="upper center", bbox_to_anchor=(0.5, 0.0), fontsize=9.5)
    mesh_picture.scale_bar(axes, place)
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.margins(0.03)
    axes.axis("off")
