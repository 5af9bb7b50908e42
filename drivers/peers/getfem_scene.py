"""One scene by GetFEM: node pairs, exact multipliers, semismooth Newton with a direct solver (Debian: python3-getfem).

    getfem_scene.py W16      prints a line of JSON: solves, whether both load steps converged, largest displacement, seconds
"""
import json
import sys
import time

import getfem
import numpy as np

import scenes

TOLERANCE, MOST_SOLVES = 1e-9, 200
# GetFEM stops on a residual that mixes newtons and metres: in SI it takes the first iterate for a solution. Displacements
# are therefore counted in 1e-10 m, which makes both of one size.
METRE = 1e10
PRESSED = 1e6  # [Pa]
AUGMENTATION = 0.1  # of Young's modulus, times the length of a pair; of 0.01, 0.03, 0.1, 1 what converges most often


def mesh_of(scene):
    """GetFEM joins points at one place, so every block stands apart from the others. Returns the degrees of freedom too."""
    far = 2 + 2 * max(np.ptp([p[0] for p, b in zip(scene.position, scene.block) if b == 0]), 1.0)
    x = np.array(scene.position)
    low = {}
    for (px, py), b in zip(scene.position, scene.block):
        low[b] = min(low.get(b, px), px)
    apart = x + np.array([[far * b - low[b], 0] for b in scene.block])
    mesh = getfem.Mesh("empty", 2)
    transformation = getfem.GeoTrans("GT_QK(2,1)")
    for a, b, c, d in scene.cells:
        mesh.add_convex(transformation, apart[[a, b, d, c]].T)
    fem = getfem.MeshFem(mesh, 2)
    fem.set_fem(getfem.Fem("FEM_QK(2,1)"))
    place = {tuple(np.round(p, 5)): node for node, p in enumerate(apart)}
    dof = np.full((len(apart), 2), -1)
    seen = {}
    for k, p in enumerate(fem.basic_dof_nodes().T):
        node = place[tuple(np.round(p, 5))]
        dof[node, seen.get(node, 0)] = k
        seen[node] = seen.get(node, 0) + 1
    assert (dof >= 0).all()
    return mesh, fem, dof


def rows_of(pairs, dof, direction, unknowns):
    """Relative motion of i against j along a direction of each pair."""
    rows = getfem.Spmat("empty", len(pairs), unknowns)
    for k, pair in enumerate(pairs):
        d = direction(pair)
        for node, sign in ((pair.i, 1.0), (pair.j, -1.0)):
            for c in range(2):
                if d[c]:
                    rows.add(k, int(dof[node, c]), sign * d[c])
    return rows


def main(name):
    scene = scenes.scene_of(name)
    start = time.process_time()
    mesh, fem, dof = mesh_of(scene)
    integration = getfem.MeshIm(mesh, getfem.Integ("IM_GAUSS_PARALLELEPIPED(2,4)"))
    model = getfem.Model("real")
    model.add_fem_variable("u", fem)
    e, nu = scenes.YOUNG * scenes.THICKNESS / METRE, scenes.POISSON
    model.add_initialized_data("lambda", e * nu / (1 - nu * nu))  # plane stress
    model.add_initialized_data("mu", e / (2 * (1 + nu)))
    model.add_isotropic_linearized_elasticity_brick(integration, "u", "lambda", "mu")
    weight = scenes.DENSITY * scenes.THICKNESS
    model.add_initialized_data("force", [0.0, -weight * scenes.GRAVITY])
    model.add_source_term_brick(integration, "u", "force")

    held = getfem.Spmat("empty", 2 * len(scene.held), fem.nbdof())
    for k, (node, _) in enumerate(scene.held):
        for c in range(2):
            held.add(2 * k + c, int(dof[node, c]), 1.0)
    model.add_variable("reaction", 2 * len(scene.held))
    model.add_initialized_data("given", np.zeros(2 * len(scene.held)))
    model.add_constraint_with_multipliers("u", "reaction", held, "given")

    pairs = scene.without_redundant_pairs()
    model.add_variable("normal", len(pairs))
    model.add_variable("tangential", len(pairs))
    model.add_initialized_data("r", AUGMENTATION * e)
    model.add_initialized_data("friction", scenes.FRICTION)
    model.add_initialized_data("gap", np.zeros(len(pairs)))
    model.add_initialized_data("share", np.array([pair.length for pair in pairs]))
    model.add_initialized_data("gamma", 1.0)
    model.add_initialized_data("before", np.zeros(fem.nbdof()))
    model.add_basic_contact_brick(
        "u", "normal", "tangential", "r", rows_of(pairs, dof, lambda p: p.normal, fem.nbdof()),
        rows_of(pairs, dof, lambda p: (-p.normal[1], p.normal[0]), fem.nbdof()), "friction", "gap", "share", 1, "gamma",
        "before")
    # From zero all points would slip without friction in the first iterate; pressed together they begin as one body.
    model.set_variable("normal", -PRESSED * np.array([pair.length for pair in pairs]))
    made = time.process_time()

    solves, converged, largest = [], True, []
    for step in (1, 2):
        if step == 2:
            model.set_variable("before", model.variable("u"))
            model.set_variable("force", [weight * scene.push, -weight * scenes.GRAVITY])
            model.set_variable("given", METRE * np.array([g for _, given in scene.held for g in given]))
        count, done = model.solve("max_res", TOLERANCE, "max_iter", MOST_SOLVES, "lsolver", "mumps")
        solves.append(int(count))
        converged = converged and bool(done)
        u = model.variable("u")
        largest.append(float(np.hypot(u[dof[:, 0]], u[dof[:, 1]]).max() / METRE))
        if not converged:
            break
    print(json.dumps({"solves": solves, "converged": converged, "largest_displacement_m": largest,
                      "seconds_to_make": made - start, "seconds_to_solve": time.process_time() - made}))


if __name__ == "__main__":
    main(sys.argv[1])
