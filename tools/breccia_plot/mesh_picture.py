"""A frame on a pair of axes: the mesh coloured by a field, cracks over it."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D

from . import fields, style
from .trouble import Trouble

VIEW = np.array([0.55, -0.75, 0.42])  # from where a space mesh is seen
LIGHT = np.array([0.3, -0.6, 0.75])
TET_FACES = np.array([[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]])
FULL_MESH = 4000  # up to so many faces their edges are drawn


def crack_kinds(mode):
    """1 tension ... 2 shear."""
    return np.where(mode < 4 / 3, "tension", np.where(mode > 5 / 3, "shear", "mixed"))


def border(cells, family):
    """Edges that belong to one triangle; copies of a split point count as one (cracks are drawn apart)."""
    edges = np.concatenate([cells[:, [0, 1]], cells[:, [1, 2]], cells[:, [2, 0]]])
    _, first, count = np.unique(np.sort(family[edges], axis=1), axis=0, return_index=True, return_counts=True)
    return edges[first[count == 1]]


def families(grid):
    """A number per point that the copies of a split node share: they began at one place."""
    moved = grid.arrays.get("displacement")
    if moved is None:
        return np.arange(len(grid.points))
    start = grid.points - moved.values.reshape(len(grid.points), -1)[:, :3]
    size = max(np.ptp(start, axis=0).max(), 1e-300)
    _, number = np.unique(np.round(start / size * 1e9), axis=0, return_inverse=True)
    return number.reshape(-1)


def surface(points, cells):
    """Faces that belong to one tetrahedron, corners counter-clockwise seen from outside, and their cells."""
    faces = cells[:, TET_FACES].reshape(-1, 3)
    owner = np.repeat(np.arange(len(cells)), 4)
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    outer = first[count == 1]
    faces, owner = faces[outer], owner[outer]
    corner = points[faces]
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    outward = corner.mean(axis=1) - points[cells[owner]].mean(axis=1)
    inside_out = (normal * outward).sum(axis=1) < 0
    faces[inside_out] = faces[inside_out][:, ::-1]
    normal[inside_out] *= -1
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    return faces, owner, normal / np.where(length > 0, length, 1)


def camera():
    """Rows: right, up and towards the eye."""
    eye = VIEW / np.linalg.norm(VIEW)
    right = np.cross([0, 0, 1], eye)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(eye, right), eye])


class Colours:
    """Field values to colours, in units fit for print."""

    def __init__(self, field, limits=None):
        low, high, signed = limits or fields.limits(field.values)
        self.factor, unit = style.prefixed(field.unit, max(abs(low), abs(high)))
        self.title = style.label(field.title, unit)
        self.norm = plt.Normalize(low * self.factor, high * self.factor)
        self.map = style.DIVERGING if signed else style.SEQUENTIAL
        if high <= 0:  # the light end belongs to zero
            self.map = style.SEQUENTIAL.reversed()

    def __call__(self, values):
        return self.map(self.norm(values * self.factor))

    def bar(self, axes):
        mappable = plt.cm.ScalarMappable(self.norm, self.map)
        bar = axes.figure.colorbar(mappable, ax=axes, shrink=0.62, aspect=26, pad=0.02, extend="both", extendfrac=0.02)
        bar.outline.set_visible(False)
        bar.ax.tick_params(length=0, labelsize=10)
        bar.set_label(self.title, size=10.5)


def on_faces(field, faces, owner):
    if field.on_points:
        return field.values[faces].mean(axis=1)
    return field.values[owner]


def draw_faces(axes, polygons, colours, edges):
    # Neighbours drawn without edges leave hairlines; an edge of the face's own colour closes them.
    line = {"edgecolors": "#ffffff66", "linewidths": 0.3} if edges else {"edgecolors": "face", "linewidths": 0.25}
    axes.add_collection(PolyCollection(polygons, facecolors=colours, **line, zorder=1))


def draw_plane(axes, grid, field, colours):
    xy = grid.points[:, :2]
    values = on_faces(field, grid.cells, np.arange(len(grid.cells)))
    draw_faces(axes, xy[grid.cells], colours(values), len(grid.cells) <= FULL_MESH)
    outline = xy[border(grid.cells, families(grid))]
    axes.add_collection(LineCollection(outline, colors=style.INK, linewidths=0.5, alpha=0.7, zorder=2))
    return xy


def draw_space(axes, grid, field, colours):
    faces, owner, normal = surface(grid.points, grid.cells)
    look = camera()
    seen = normal @ look[2] > 0
    faces, owner, normal = faces[seen], owner[seen], normal[seen]
    place = grid.points @ look.T
    order = np.argsort(place[faces][:, :, 2].mean(axis=1))
    faces, owner, normal = faces[order], owner[order], normal[order]
    light = LIGHT / np.linalg.norm(LIGHT)
    shade = 0.62 + 0.38 * np.clip(normal @ light, 0, 1)
    rgba = colours(on_faces(field, faces, owner))
    rgba[:, :3] *= shade[:, None]
    draw_faces(axes, place[faces][:, :, :2], rgba, len(faces) <= FULL_MESH)
    draw_axes_cross(axes, look)
    return place[:, :2]


def draw_axes_cross(axes, look):
    """Where x, y and z point, in the lower left corner."""
    size = 26
    for k, name in enumerate("xyz"):
        tip = look[:2, k] * size
        start = {"xy": (0.06, 0.1), "xycoords": "axes fraction", "textcoords": "offset points"}
        arrow = {"arrowstyle": "<-", "color": style.QUIET, "lw": 1, "shrinkA": 0, "shrinkB": 0}
        axes.annotate("", xytext=tip, arrowprops=arrow, **start)
        axes.annotate(name, xytext=tip * 1.35, color=style.QUIET, ha="center", va="center", size=9, **start)


# Interfaces below this damage are as strong as before; showing them would hide the cracks.
VISIBLE_DAMAGE = 0.1


def draw_cracks(axes, cracks, dimension):
    """Released faces in full, softening ones thin; coloured by mode. Returns the kinds drawn."""
    place = cracks.points if dimension == 2 else cracks.points @ camera().T
    shapes = place[cracks.cells][:, :, :2]
    kinds = crack_kinds(cracks.arrays["mode"].values)
    released = cracks.arrays["status"].values == 2
    visible = released | (cracks.arrays["damage"].values >= VISIBLE_DAMAGE)
    drawn = []
    for kind, colour in style.CRACK.items():
        for broken in (False, True):
            chosen = shapes[(kinds == kind) & (released == broken) & visible]
            if not len(chosen):
                continue
            drawn.append((kind, broken))
            if dimension == 2:
                # A pale rim keeps a crack legible on the dark end of the colours.
                if broken:
                    axes.add_collection(LineCollection(chosen, colors="white", linewidths=3.2, alpha=0.8, zorder=3))
                width, alpha = (1.9, 1.0) if broken else (0.9, 0.85)
                lines = LineCollection(chosen, colors=colour, linewidths=width, alpha=alpha, zorder=4 + broken)
                lines.set_capstyle("round")
                axes.add_collection(lines)
            else:
                axes.add_collection(
                    PolyCollection(chosen, facecolors=colour, edgecolors="none", alpha=0.6 if broken else 0.25,
                                   zorder=4 + broken)
                )
    return drawn


def crack_legend(axes, drawn, dimension):
    handles = []
    for kind, colour in style.CRACK.items():
        for broken in (True, False):
            if (kind, broken) not in drawn:
                continue
            name = f"{kind} crack" if broken else f"{kind}, softening"
            width = (2.4 if broken else 1.1) if dimension == 2 else (6 if broken else 3)
            handles.append(Line2D([], [], color=colour, linewidth=width, label=name))
    if handles:
        axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=3, handlelength=1.3,
                    columnspacing=1.2, fontsize=9.5)


def scale_bar(axes, place):
    """A length everybody can read off, below the mesh on the right."""
    low, high = place.min(axis=0), place.max(axis=0)
    width = max(high[0] - low[0], 1e-300)
    size = 10.0 ** np.floor(np.log10(width / 4))
    size *= max(step for step in (1, 2, 5) if step * size <= width / 4 * 1.0001)
    factor, unit = style.prefixed("m", size)
    y = low[1] - 0.035 * (high[1] - low[1])
    axes.plot([high[0] - size, high[0]], [y, y], color=style.INK, linewidth=2, solid_capstyle="butt")
    axes.annotate(f"{size * factor:g} {unit}", (high[0] - size / 2, y), xytext=(0, -3), textcoords="offset points",
                  ha="center", va="top", size=9, color=style.INK)


def draw(axes, grid, cracks, name=None, limits=None, bar=True):
    """Draws a frame; returns the field."""
    if not len(grid.cells):
        raise Trouble("the frame has no cells")
    field = fields.field(grid, name)
    colours = Colours(field, limits)
    draw_it = draw_plane if grid.dimension == 2 else draw_space
    place = draw_it(axes, grid, field, colours)
    if cracks is not None:
        crack_legend(axes, draw_cracks(axes, cracks, grid.dimension), grid.dimension)
    scale_bar(axes, place)
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.margins(0.03)
    axes.axis("off")
    if bar:
        colours.bar(axes)
    return field
