"""The mechanism that the search for a load factor has drawn, from the fields of a run: certificates.py and its sister in space."""

import h5py


def drawn_mechanism(folder):
    """Motion of nodes; gap, slip and shear of joints; places of nodes and the stone of each. Nothing where none is drawn."""
    with h5py.File(folder / "fields.h5") as fields:
        last = fields["steps"][sorted(fields["steps"])[-1]]
        if last.attrs["stage"] != b"load factor: mechanism":
            return None
        of_step = ("displacement", "joint_gap_m", "joint_slip_m", "joint_tangential_force_N")
        return (*(last[name][()] for name in of_step), fields["mesh/coordinates"][()], fields["mesh/block_of_node"][()])
