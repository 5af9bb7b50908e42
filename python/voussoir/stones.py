"""Stones from polygons and boxes: written as the drawing that the program reads, with the section `mesh` of a scene.

    stones = Stones(snap=0.005)
    stones.polygon([(0, 0), (1, 0), (1, 0.5), (0, 0.5)], name="left", sets=["course 0"])
    stones.edges("ground", lambda x, y: y < 0.01)
    scene["mesh"] = stones.write("wall.geo", element_size=0.1)

In the plane that is a file of gmsh in which neighbours share the line between them: corners nearer than `snap` become
one, and an edge on which a corner of another stone lies is divided there; or a CSV of the corners as they are, which
the program fits together with the same `snap` and meshes by quadrilaterals where stones are. In space it is an OBJ in which
every object is a stone; the program finds the joints. Whether stones overlap, or gape more than was snapped, is judged by the program.
"""

import pathlib

import numpy

from .program import InputError, write_atomically


def chain(start, end, corners, number_of, tolerance):
    """The places of an edge in their order: its ends, and every corner that lies on it between them; how far from its straight
    line the farthest of these is."""
    way = end - start
    length = numpy.hypot(*way)
    along = (corners - start) @ way / length
    across = numpy.abs((corners - start) @ numpy.array([-way[1], way[0]]) / length)
    on = numpy.flatnonzero((across <= tolerance) & (along > tolerance) & (along < length - tolerance))
    between = [corners[k] for k in on[numpy.argsort(along[on])]]
    return [number_of(place) for place in (start, *between, end)], float(across[on].max(initial=0.0))


class Stones:
    """Stones of one drawing, all in the plane or all in space."""

    def __init__(self, snap=1e-6):
        """@param snap  [m] corners nearer to each other than this are one"""
        self.snap = float(snap)
        self.outlines, self.boxes, self.names, self.sets, self.edge_sets = [], [], [], {}, {}
        self.moved = 0.0  # [m] the farthest that a corner or an edge was moved; known once a .geo is written

    def _add(self, name, sets):
        name = name or f"stone {len(self.names)}"
        if name in self.names:
            raise InputError(f"stone {name}\n  is there twice.\n  Give every stone a name of its own.")
        self.names.append(name)
        for which in [sets] if isinstance(sets, str) else sets or []:
            self.sets.setdefault(which, []).append(name)
        return name

    def polygon(self, corners, name=None, sets=()):
        """A stone in the plane by its corners [m], in either sense; its name, which is a set too."""
        corners = numpy.asarray(corners, float)
        if self.boxes or corners.ndim != 2 or corners.shape[1] != 2 or len(corners) < 3 or not numpy.isfinite(corners).all():
            raise InputError(f"stone {name or len(self.names)}: corners\n  must be three places (x, y) or more, of a drawing in the plane.")
        if numpy.allclose(corners[0], corners[-1]):
            corners = corners[:-1]  # closed as drawings close them
        x, y = corners.T
        area = 0.5 * (x @ numpy.roll(y, -1) - y @ numpy.roll(x, -1))
        if abs(area) <= self.snap**2:
            raise InputError(f"stone {name or len(self.names)}: corners\n  enclose no area.")
        name = self._add(name, sets)
        self.outlines.append(corners if area > 0 else corners[::-1])
        return name

    def rectangle(self, x, y, width, height, name=None, sets=()):
        """A stone in the plane by its lower left corner."""
        return self.polygon([(x, y), (x + width, y), (x + width, y + height), (x, y + height)], name, sets)

    def box(self, corner, size, name=None, sets=()):
        """A stone in space by its lower corner (x, y, z) and its lengths; its name, which is a set too."""
        corner, size = numpy.asarray(corner, float), numpy.asarray(size, float)
        if self.outlines or corner.shape != (3,) or size.shape != (3,) or not (size > 0).all():
            raise InputError(f"stone {name or len(self.names)}\n  must have a corner (x, y, z) and three lengths above 0, "
                             "in a drawing in space.")
        name = self._add(name, sets)
        self.boxes.append((corner, size))
        return name

    def edges(self, name, where):
        """A set of edges in the plane, for supports and loads: those whose both ends fulfil `where(x, y)`."""
        self.edge_sets[name] = where

    def write(self, path, element_size=0, **options):
        """Writes the drawing; the section `mesh` of a scene, which names it.

        @param path  .geo or .csv of stones in the plane, .obj in space. A CSV has one set a stone, and of edges those that
                     every drawing has: base, top, left, right, faces
        @param options  further keys of `mesh > gmsh` or `mesh > stones`, such as cells="quadrilateral"
        """
        path = pathlib.Path(path).resolve()
        plane = bool(self.outlines)
        if not self.names:
            raise InputError(f"{path}: stones\n  are missing: none has been added.")
        write = {".geo": self._geo, ".csv": self._csv} if plane else {".obj": self._obj}
        if path.suffix not in write:
            raise InputError(f"{path}\n  must end in .geo or .csv for stones in the plane, in .obj for stones in space.")
        write_atomically(path, write[path.suffix]())
        kind = "gmsh" if path.suffix == ".geo" else "stones"
        snapped = {"snap": self.snap} if path.suffix == ".csv" else {}
        return {"type": kind, kind: {"file": str(path), **({"element size": float(element_size)} if element_size else {}), **snapped,
                                     **{key.replace("_", " "): value for key, value in options.items()}}}

    # In the plane.

    def _welded(self):
        """Corners of all stones as numbers of places: those that are near each other are their mean."""
        all_corners = numpy.vstack(self.outlines)
        place_of = numpy.full(len(all_corners), -1)
        groups = []
        for k, corner in enumerate(all_corners):
            if place_of[k] >= 0:
                continue
            near = numpy.flatnonzero((place_of < 0) & (numpy.hypot(*(all_corners - corner).T) <= self.snap))
            place_of[near] = len(groups)
            groups.append(all_corners[near].mean(axis=0))
        places = numpy.array(groups)
        self.moved = float(numpy.hypot(*(places[place_of] - all_corners).T).max())
        ends = numpy.cumsum([len(outline) for outline in self.outlines])
        return places, numpy.split(place_of, ends[:-1])

    def _geo(self):
        places, outlines = self._welded()
        number_of = {tuple(place): k for k, place in enumerate(places)}
        text = [f"Point({k + 1}) = {{{x!r}, {y!r}, 0}};" for k, (x, y) in enumerate(places.tolist())]
        lines, sets = {}, {}
        for surface, (name, outline) in enumerate(zip(self.names, outlines), start=1):
            loop = []
            for a, b in zip(outline, numpy.roll(outline, -1)):
                if a == b:
                    continue  # an edge shorter than what was snapped
                way, bent = chain(places[a], places[b], places, lambda place: number_of[tuple(place)], max(self.snap, 1e-9))
                self.moved = max(self.moved, bent)
                for one, other in zip(way, way[1:]):
                    key = (min(one, other), max(one, other))
                    if key not in lines:
                        lines[key] = len(lines) + 1
                        text.append(f"Line({lines[key]}) = {{{key[0] + 1}, {key[1] + 1}}};")
                    loop.append(lines[key] if one == key[0] else -lines[key])
            text += [f"Curve Loop({surface}) = {{{', '.join(map(str, loop))}}};", f"Plane Surface({surface}) = {{{surface}}};"]
            sets[name] = [surface]
        number = {name: surface for name, (surface,) in sets.items()}
        for which, names in self.sets.items():
            sets[which] = [number[name] for name in names]
        text += [f'Physical Surface("{name}") = {{{", ".join(map(str, surfaces))}}};' for name, surfaces in sets.items()]
        for name, where in self.edge_sets.items():
            chosen = [line for (a, b), line in lines.items() if where(*places[a]) and where(*places[b])]
            if not chosen:
                raise InputError(f"edges {name}\n  are none: no edge has both its ends where they are asked for.")
            text.append(f'Physical Curve("{name}") = {{{", ".join(map(str, chosen))}}};')
        return "\n".join(text) + "\n"

    def _csv(self):
        if self.edge_sets:
            raise InputError(f"edges {next(iter(self.edge_sets))}\n  have no place in a .csv.\n  Use base, top, left, right or faces, "
                             "which every drawing has, or write a .geo.")
        set_of = {}
        for which, names in self.sets.items():
            for name in names:
                if name in set_of:
                    raise InputError(f"stone {name}\n  is in the sets {set_of[name]} and {which}, and a .csv has one a stone.\n  "
                                     "Give it one, or write a .geo.")
                set_of[name] = which
        for word in (*self.names, *self.sets):
            if set(word) & set(',;\t"\n\r') or word != word.strip():
                raise InputError(f"{word!r}\n  cannot be a name in a .csv: it has a comma, a quote or a blank at its end.\n  Rename it.")
        rows = [f"{name},{x!r},{y!r},{set_of.get(name, '')}" for name, outline in zip(self.names, self.outlines)
                for x, y in outline.tolist()]
        self.moved = 0.0  # the program tells what it moves
        return "\n".join(["stone,x,y,set", *rows]) + "\n"

    # In space.

    def _obj(self):
        text, faces = [], ((1, 4, 3, 2), (5, 6, 7, 8), (1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8))
        for k, (name, (corner, size)) in enumerate(zip(self.names, self.boxes)):
            text.append(f"o {name}")
            for z in (0, 1):
                for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    text.append("v " + " ".join(repr(float(value)) for value in corner + size * (x, y, z)))
            text += ["f " + " ".join(str(8 * k + corner) for corner in face) for face in faces]
        return "\n".join(text) + "\n"
