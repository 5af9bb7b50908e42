"""Stones from soft to almost rigid, next to each other, and almost incompressible ones."""

from case import COLLAPSE, Most, Near, case
from drawing import block_on_bed, grid
from scenes import GRAVITY, STONE, arch, arch_weight, changed, pushed_wall, scene, wall_weight

GROUP = "stiffness"
YOUNG = "materials/stone/Young modulus"


def like_ten_gpa(build, weight):
    """Displacements go with 1/E, forces and the way to them do not change."""
    def check(run):
        base = run.again(build())
        E = float(scene_young(run))
        yield Near("weight carried", run.reaction(), weight, 1e-8)
        # Forces differ by what the tolerance of the solver leaves open, 1e-8 of the largest.
        yield Near("displacement times E", run.result["largest_displacement_m"] * E,
                   base.result["largest_displacement_m"] * STONE["Young modulus"], 1e-6)
        yield Most("solves, relative to 10 GPa", run.result["linear_solves"] / base.result["linear_solves"], 1.5)
    return check


def scene_young(run):
    import xml.etree.ElementTree as ElementTree
    return ElementTree.parse(run.folder / "scene.xml").find(".//Parameter[@name='Young modulus']").get("value")


def pushed_w4():
    return pushed_wall(4)


def weighed_arch():
    return scene(arch(15), supports=("springing left", "springing right"))


for E, words in ((1e6, "1 MPa"), (1e12, "1000 GPa"), (1e18, "1e9 GPa")):
    case(GROUP, f"wall pushed, E {words}", lambda E=E: changed(pushed_w4(), {YOUNG: E}), quick=E != 1e12,
         check=like_ten_gpa(pushed_w4, wall_weight(4)))
    case(GROUP, f"arch, E {words}", lambda E=E: changed(weighed_arch(), {YOUNG: E}), quick=E == 1e18,
         check=like_ten_gpa(weighed_arch, arch_weight(15)))


def contrast(low, high):
    content = pushed_w4()
    content["materials"]["soft"] = {**STONE, "Young modulus": low, "blocks": "course 1"}
    content["materials"]["hard"] = {**STONE, "Young modulus": high, "blocks": "course 2"}
    return content


# The soft course gives way by 0.37 m: round-off of 1e12 Pa times that is more than 1e-8 of the forces.
case(GROUP, "contrast 1e8 between courses", lambda: contrast(1e4, 1e12), quick=True,
     check=lambda run: [Near("weight carried", run.reaction(), wall_weight(4), 1e-8)])
case(GROUP, "contrast 1e6 between courses", lambda: contrast(1e6, 1e12),
     check=lambda run: [Near("weight carried", run.reaction(), wall_weight(4), 1e-8)])
case(GROUP, "contrast 1e4 between courses", lambda: contrast(1e8, 1e12), quick=True,
     check=lambda run: [Near("weight carried", run.reaction(), wall_weight(4), 1e-8)])


def press(plane, nu):
    """Four stones pressed from above between two smooth planes of symmetry: uniform stress."""
    return scene(grid(2, 2, 0.5, 0.25, 0.125), friction=0.0, stone={"Poisson ratio": nu}, model={"plane": plane},
                 supports={"floor": {"on": "ground", "components": "y"}, "side": {"on": "left", "components": "x"}},
                 loads={"press": {"type": "traction", "on": "top", "pressure": 1e6}},
                 stages={"press": {"loads": {"press": 1.0}}})


def shortening(nu):
    def check(run):
        # sigma (1 - nu^2) / E over a height of 0.5 m; the solver stops at 1e-8 of the forces, and nu = 0.4999 makes
        # the volume stiffer than the shape by 1 / (1 - 2 nu) = 5000.
        top = min(run.table("displacement")[:, 1])
        yield Near("shortening", top, -1e6 * 0.5 * (1 - nu**2) / STONE["Young modulus"], 1e-6)
    return check


case(GROUP, "nu 0.4999, plane strain, pressed without friction", lambda: press("strain", 0.4999), quick=True,
     check=shortening(0.4999))
case(GROUP, "wall pushed, nu 0.4999, plane strain",
     lambda: changed(pushed_w4(), {"materials/stone/Poisson ratio": 0.4999, "model": {"plane": "strain"}}), quick=True,
     check=lambda run: [Near("weight carried", run.reaction(), wall_weight(4), 1e-8)])


def settled_arch(E):
    """The right springing of a semicircular arch moves out by 5 mm in 20 steps."""
    return changed(weighed_arch(), {
        YOUNG: E, "loads/moves": {"type": "settlement", "support": "springing right", "ux": 0.005},
        "joints/dry/friction coefficient": 1.5,
        "steps/stages": {"own weight": {"loads": {"weight": 1.0}},
                         "springing moves": {"increments": 20, "loads": {"moves": 1.0}}}})


def like_stiff(run):
    """The crown of stones 100 times stiffer stays: a rigid three-hinge mechanism is what is left."""
    base = run.again(settled_arch(1e12))
    yield Near("largest displacement", run.result["largest_displacement_m"], base.result["largest_displacement_m"], 1e-3)
    # 5 mm are 1e6 times what weight does at 1e9 GPa, and steps that find new hinges begin that far away.
    yield Most("solves, relative to 1000 GPa", run.result["linear_solves"] / base.result["linear_solves"], 2)


case(GROUP, "arch spreads by 5 mm, E 1e5 GPa", lambda: settled_arch(1e14), seconds=300, check=like_stiff)
# Round-off of 1e18 Pa times 5 mm is 0.5 N, 1e-5 of the forces.
case(GROUP, "arch spreads by 5 mm, E 1e9 GPa", lambda: settled_arch(1e18), quick=True, check=like_stiff)


def almost_rigid_block(E, slope):
    return changed(scene(block_on_bed(slope=slope)), {YOUNG: E})


for E, words in ((1e12, "1e3"), (1e15, "1e6"), (1e18, "1e9")):
    case(GROUP, f"E {words} GPa, friction 0.6, slope of 0.599", lambda E=E: almost_rigid_block(E, 0.599), quick=E == 1e18,
         check=lambda run: [Near("weight carried", run.reaction(), 0.75 * 2000 * GRAVITY, 1e-8)])
    case(GROUP, f"E {words} GPa, friction 0.6, slope of 0.601", lambda E=E: almost_rigid_block(E, 0.601), COLLAPSE,
         words="joints that slide: ", quick=E == 1e18)
