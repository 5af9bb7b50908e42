"""Lists come to every rank by one door, src/linalg/gather.hpp, and to the first rank alone by another,
src/linalg/parcels.hpp; who uses them is written down here.

SMALL are those who bring lists to every rank: these do not grow with the structure, or are a small part of it. ON_FIRST
are those who bring lists to the first rank, with what bounds them; where nothing does the first rank ends scaling.
"""

import re

import house

DOOR = re.compile(r"\b(?:all_gather|list_over_ranks|total_of_list|largest_of_list|broadcast_values)\s*(?:<[^;()]*>)?\(")
# What would bring lists of any length to all ranks beside the door.
BESIDE = re.compile(r"\b(?:gatherAll|gather_?[vV]|MPI_I?(?:All)?[gG]ather\w*|MPI_I?(?:All)?[rR]educe|MPI_I?Bcast)\b\s*\(|"
                    r"\breduceAll\s*\([^;]*?,[^;]*?,\s*(?!1\s*,)[^;,]*\b(?:size|length|count|n)\b")
# To one rank, be it by a list of its own or by a parcel that all send there.
FIRST = re.compile(r"\bgather_on_first\s*\(|\bexchange_parcels(?:<[^;()]*>)?\(\{\{0,")
# The sums of reduce.hpp are for a fixed few numbers; of these the name is looked at.
SUMMED = re.compile(r"\b(?:each_over_ranks|(?:total|largest|least)_of_each)\s*\([^;]*?,\s*(\w+)\)")
NO_CODE = re.compile(r"//[^\n]*|\"(?:[^\"\\\n]|\\.)*\"")
BEHIND = ("src/linalg/gather.", "src/linalg/parcels.", "src/linalg/reduce.hpp", "src/linalg/traffic_mpi.cpp", "src/linalg/agree.hpp")
SMALL = {
    "src/loads/deck.cpp", "src/loads/point_load.cpp", "src/model/patch_groups.cpp", "src/range/input_warnings.cpp",
    "src/range/coarse_joints.cpp", "src/range/plane/slip_range.cpp", "src/range/space/slip_in_space.cpp", "src/results/acting_loads.cpp", "src/results/mechanism_words.cpp",
    "src/results/observations.cpp", "src/ties/tie_balance.cpp",
    "src/range/turn_range.cpp",  # the joint that is worst off
    "src/range/boxes_of_ranks.hpp",  # a box of each rank
    "src/range/plane/stone_overlap.cpp", "src/range/space/overlap_in_space.cpp",  # stones that lie in each other
    "src/linalg/shared_warnings.hpp",  # of a mesh
    "src/results/shares_of_ranks.cpp",  # four numbers of each rank
    "src/model/scene_fit.cpp", "src/range/joint_sides.cpp",  # sets that a scene names, and those of one stone
    "src/ties/rigid_stones.cpp",  # stones at the borders of ranks, and those that hang on one other
    "src/loads/time_series.cpp",  # a record of the ground
    "src/output/even_rows.cpp", "src/output/result_json.cpp",  # a number of each rank
}
ON_FIRST = {
    "src/homogenisation/released_region.cpp": "up to a quarter of the nodes, and the rows a direct solver takes",
    "src/linalg/direct_preconditioner.cpp": "rows up to a limit (`largest factor`), factored there",
    "src/linalg/distributed_lu.cpp": "where one rank has all rows",
    "src/mesh/mesh.cpp": "names of sets of blocks, while they are written or a scene has a wrong one",
    "src/mesh/partition.cpp": "the graph of up to a million stones",
    "src/range/turn_range.cpp": "stones and joints, once stones have turned: one system of all of them",
    "src/results/masonry_statics.cpp": "rows of a table for people",
    "src/run/rigid_limits.cpp": "stones and points of a limit analysis, whose library works on one rank",
}


def problems_of(path, text, callers, on_first=()):
    path = str(path)
    if path.startswith(BEHIND):
        return []
    code = NO_CODE.sub(lambda found: " " * len(found.group(0)), text)
    problems = [f"{path}:{code.count(chr(10), 0, found.start()) + 1}: brings a list to the first rank; say in "
                "tests/house/gathering.py what bounds it." for found in FIRST.finditer(code) if path not in on_first]
    for pattern, why in ((DOOR, "brings a list to every rank" if path not in callers else None),
                         (BESIDE, "brings lists to ranks beside src/linalg/gather.hpp")):
        if not why or (pattern is BESIDE and path in callers):
            continue
        problems += [f"{path}:{code.count(chr(10), 0, found.start()) + 1}: {why}; send what others need by parcels, or "
                     "say in tests/house/gathering.py why it is small." for found in pattern.finditer(code)]
    problems += [f"{path}:{code.count(chr(10), 0, found.start()) + 1}: sums a list of any length; that is for "
                 "src/linalg/gather.hpp." for found in SUMMED.finditer(code)
                 if re.search(r"std::vector<[^;{}()]*>&? (?:\w+(?:\([^;]*?\))?, )*" + found.group(1) + r"\b", code)]
    return problems


def idle_callers(callers, texts, doors=(DOOR, BESIDE), where="every rank"):
    """Named callers that do not come through the door; a name left standing would let the next one in."""
    return [f"tests/house/gathering.py names {path}, which brings nothing to {where}." for path in sorted(callers)
            if not any(door.search(texts.get(path, "")) for door in doors)]


def main():
    texts = {str(path): house.read(path) for path in house.code_files(".hpp", ".cpp") if path.parts[0] in ("src", "drivers")}
    house.finish("Lists of all ranks come to every rank by one door, to the first by another, and who uses them is known",
                 [problem for path, text in texts.items() for problem in problems_of(path, text, SMALL, ON_FIRST)]
                 + idle_callers(SMALL, texts) + idle_callers(ON_FIRST, texts, (FIRST,), "the first rank"))


if __name__ == "__main__":
    main()
