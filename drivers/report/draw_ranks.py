"""The picture of a study of ranks: efficiency beside the ideal and the model, what ranks send, how evenly they share."""
import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter, NullLocator

from draw_common import BLUE, GREEN, GREY, INK, ORANGE, PALE, PAPER, PURPLE, RED, SKY, save_study
from geometry import counted

# What the model and the measurement are drawn as: colour, line, marker.
MEASURED, WORK, MODEL = (BLUE, "-", "o"), (GREEN, "-", "s"), (ORANGE, "--", "")
SHARES = (("memory_over_share", "memory over its share", RED), ("structure_over_share", "without the program", PURPLE),
          ("unknowns_imbalance", "unknowns, busiest over mean", BLUE), ("points_imbalance", "contact points", SKY),
          ("seconds_imbalance", "seconds of work", GREEN))


def curve(axes, rows, column, style, label, factor=1.0):
    """Its group in the SVG has the name of the column behind that of the kind."""
    colour, line, marker = style
    there = [row for row in rows if row[column] is not None]
    if there:
        axes.plot([row["ranks"] for row in there], [factor * row[column] for row in there], linestyle=line, color=colour,
                  marker=marker or None, ms=5, lw=1.6, label=label, gid=f"{rows[0]['kind']}-{column}")


def ranks_along(axes, rows):
    axes.set_xscale("log", base=2)
    ranks = [row["ranks"] for row in rows]
    axes.set_xticks(ranks, [str(number) for number in ranks])
    axes.xaxis.set_minor_locator(NullLocator())
    axes.set_xlabel("ranks")
    axes.grid(True, color=PALE, lw=0.5, alpha=0.7)


def draw_efficiency(axes, rows, kind):
    axes.axhline(100, color=GREY, lw=1.0, ls="-.", label="ideal", gid=f"{kind}-ideal")
    curve(axes, rows, "predicted_efficiency", MODEL, "model", 100)
    curve(axes, rows, "work_efficiency", WORK, "work alone, outside MPI", 100)
    curve(axes, rows, "efficiency", MEASURED, "measured by the clock", 100)
    crowded = [row for row in rows if row["ranks"] > row["cores"] and row["efficiency"] is not None]
    if crowded:
        axes.plot([row["ranks"] for row in crowded], [100 * row["efficiency"] for row in crowded], "o", ms=9, mfc="none",
                  mec=BLUE, label="more ranks than cores")
    axes.set_ylim(bottom=0)
    axes.set_ylabel("efficiency [%]")
    axes.set_title(f"{kind} scaling, " + (counted(rows[0]["blocks"], "stone") if kind == "strong" else
                                          counted(round(rows[-1]["blocks"] / rows[-1]["ranks"]), "stone") + " a rank"), loc="left")
    ranks_along(axes, rows)


def draw_traffic(axes, rows):
    """Nothing is sent on one rank, which a logarithm does not show."""
    several = [row for row in rows if row["ranks"] > 1]
    for column, words, colour, marker in (("messages", "messages", BLUE, "o"), ("kB", "kB", PURPLE, "s")):
        curve(axes, several, column, (colour, "none", marker), words)
        curve(axes, several, f"predicted_{column}", (colour, "--", ""), f"{words}, model")
    if several:
        axes.set_yscale("log")
        axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axes.yaxis.set_minor_formatter(NullFormatter())
    axes.set_title("sent in an iteration, all ranks", loc="left")
    ranks_along(axes, rows)


def draw_shares(axes, rows):
    fewest = rows[0]["iterations"]
    axes.plot([row["ranks"] for row in rows], [row["iterations"] / fewest for row in rows], color=INK, marker="D", ms=4, lw=1.2,
              label=f"iterations, over {fewest}")
    for column, words, colour in SHARES:
        curve(axes, rows, column, (colour, "-", "o"), words)
    axes.axhline(1, color=GREY, lw=1.0, ls="-.")
    axes.set_title("iterations, memory, balance", loc="left")
    ranks_along(axes, rows)


def draw(rows, folder):
    kinds = [kind for kind in ("strong", "weak") if any(row["kind"] == kind for row in rows)]
    figure, axes = plt.subplots(len(kinds), 3, figsize=(1.3 * PAPER.width, 4.6 * len(kinds)), squeeze=False)
    for line, kind in zip(axes, kinds):
        of_kind = [row for row in rows if row["kind"] == kind]
        draw_efficiency(line[0], of_kind, kind)
        draw_traffic(line[1], of_kind)
        draw_shares(line[2], of_kind)
        for panel in line:
            panel.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), ncol=2, frameon=False, fontsize=8)
    figure.tight_layout()
    save_study(figure, folder, "ranks")
