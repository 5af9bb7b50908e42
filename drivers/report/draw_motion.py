"""The motion of the structure as an animated GIF: the deformed shape at the recorded steps, open joints in red.

The only picture with more than one frame. All frames share one magnification, one box and one palette, which keeps a
frame at a few kB.
"""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from PIL import Image

from draw_common import GREY, INK, RED, STONE, STONE_EDGE, frame_size, limits, outline_width, prepare, visible
from geometry import round_number, span
from read_results import OPEN

FRAMES = 50           # at 15 a second a little more than three seconds
CELLS_DRAWN = 400000  # in all frames together, about half a minute: large structures get fewer frames
FEWEST = 12
DOTS = 80             # per inch: 640 pixels wide
FRAME_SECONDS, STEP_SECONDS, LAST_SECONDS = 1 / 15, 0.6, 1.2
COLOURS = 48          # of the palette: stones, lines and the grey between them
SHARE = 0.05          # of the span, drawn for the largest displacement


def chosen_frames(times, count):
    """Numbers of at most `count` recorded steps, even in time (in load steps: in number), with the first and the last."""
    if len(times) <= count:
        return np.arange(len(times))
    course = np.array(times) if np.isfinite(times).all() else np.arange(float(len(times)))
    wanted = np.linspace(course[0], course[-1], count)
    return np.unique(np.abs(course[None, :] - wanted[:, None]).argmin(1))


def frames_for(mesh):
    return int(np.clip(CELLS_DRAWN // max(len(mesh.cells), 1), FEWEST, FRAMES))


def one_palette(images):
    """Images of the same few colours: no flicker, and equal areas of two frames are equal bytes."""
    sample = Image.new("RGB", (images[0].width, 3 * images[0].height))
    for k, image in enumerate((images[0], images[len(images) // 2], images[-1])):
        sample.paste(image, (0, k * image.height))
    palette = sample.quantize(COLOURS, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    return [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]


def draw_motion(mesh, joints, pieces, edges, frames, folder):
    """Writes pictures/motion.gif. Returns path, magnification and the number of frames; None when nothing moves.

    frames: rows (stage, time or NaN, displacement, status of the contact points)
    """
    largest = max((float(np.linalg.norm(u, axis=1).max(initial=0)) for _, _, u, _ in frames), default=0)
    if len(frames) < 3 or not np.isfinite(largest) or largest <= 0:
        return None
    scale = round_number(SHARE * span(mesh.coordinates) / largest)
    shapes = [mesh.coordinates + scale * np.nan_to_num(u) for _, _, u, _ in frames]
    low, high = np.min([x.min(0) for x in shapes], 0), np.max([x.max(0) for x in shapes], 0)
    box = limits(mesh.coordinates, np.stack([low, high]))
    width, height = frame_size(box, 7.6, 5.0)
    total_width, total_height = max(width, 4.5) + 0.2, height + 0.85
    figure = plt.figure(figsize=(total_width, total_height), dpi=DOTS)
    axes = figure.add_axes([(total_width - width) / 2 / total_width, 0.45 / total_height, width / total_width, height / total_height])
    prepare(axes, box)
    axes.add_collection(LineCollection(mesh.coordinates[edges], colors=GREY, linewidths=0.5))
    stones = PolyCollection([], facecolors=STONE, edgecolors="none", antialiased=False)
    outlines = LineCollection([], colors=STONE_EDGE, linewidths=outline_width(mesh.blocks))
    gaps = LineCollection([], colors=RED, linewidths=2.0, capstyle="round")
    for part in (stones, outlines, gaps):
        axes.add_collection(part, autolim=False)
    label = figure.text(0.02, 1 - 0.1 / total_height, "", va="top", fontsize=10, color=INK)
    milli = max((time for _, time, _, _ in frames if np.isfinite(time)), default=1.0) < 0.1
    images = []
    for (stage, time, _, status), x in zip(frames, shapes):
        stones.set_verts(x[mesh.cells])
        outlines.set_segments(x[edges])
        halves, point = pieces.halves(x, joints)
        gaps.set_segments(halves[status[point] == OPEN])
        clock = f"t = {1e3 * time:.3f} ms   " if milli else f"t = {time:.3f} s   "
        label.set_text((clock if np.isfinite(time) else "") + visible(stage))
        figure.canvas.draw()
        images.append(Image.fromarray(np.asarray(figure.canvas.buffer_rgba())[:, :, :3].copy()))
    plt.close(figure)
    in_time = bool(np.isfinite([time for _, time, _, _ in frames]).all())
    lasting = [round(1000 * (FRAME_SECONDS if in_time else STEP_SECONDS))] * len(images)
    lasting[-1] = round(1000 * LAST_SECONDS)
    images = one_palette(images)
    path = folder / "motion.gif"
    images[0].save(path, save_all=True, append_images=images[1:], duration=lasting, loop=0, optimize=False)
    return path, scale, len(images)
