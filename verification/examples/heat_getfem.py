# SPDX-License-Identifier: GPL-3.0-or-later
"""heat_getfem.py CASE OUT | verify [options]: GetFEM, bilinear elements, its theta method with theta = 1/2.

    (rho_c dT/dt, v) + (k grad T, grad v) + <b T, v> = (source, v) + <flux or b T_air, v>,   T given on held walls
"""
import getfem as gf
import numpy as np

import heatladder

gf.util_trace_level(0)


def solve(case):
    if {"shape", "k_law", "contact_resistance"} & case.keys() or {"periodic", "changing"} & {str(word) for word in case.values()}:
        raise heatladder.NotApplicable  # boxes with walls, and data that stay
    axes = "xyz"[:case.dim]
    mesh = gf.Mesh("cartesian", *[np.linspace(lo, hi, n + 1) for lo, hi, n in zip(case.lo, case.hi, case.cells)])
    nodes, cells, along = gf.MeshFem(mesh, 1), gf.MeshFem(mesh, 1), gf.MeshFem(mesh, case.dim)
    nodes.set_classical_fem(1)
    cells.set_classical_discontinuous_fem(0)
    along.set_classical_discontinuous_fem(0)
    integrals, middles = gf.MeshIm(mesh, 3), cells.basic_dof_nodes().T
    names = ["initial_mean", "source", "rho_c", *("k_" + a for a in axes)]
    at = heatladder.reference(case, middles, ",".join(names), width=case.width)
    model, start = gf.Model("real"), gf.Model("real")
    for name in names[:3]:
        model.add_initialized_fem_data(name, cells, at[name])
        start.add_initialized_fem_data(name, cells, at[name])
    start.add_fem_variable("T", nodes)  # a projection, which keeps the heat
    start.add_linear_term(integrals, "rho_c*(T-initial_mean)*Test_T")
    start.solve()
    model.add_fem_variable("T", nodes)
    model.add_initialized_fem_data("k", along, np.stack([at[name] for name in names[3:]], axis=1).ravel())
    model.add_linear_term(integrals, "(k.*Grad_T).Grad_Test_T-source*Test_T")
    outer = mesh.outer_faces()
    for number, (d, end) in enumerate(((d, end) for d in range(case.dim) for end in ("lo", "hi")), 1):
        side, kind = f"side_{axes[d]}_{end}", case[f"side_{axes[d]}_{end}"].split(",")[0]
        mesh.set_region(number, outer[:, mesh.normal_of_faces(outer)[d] * (1 if end == "hi" else -1) > 0.5])
        space = nodes if kind == "dirichlet" else cells
        feet = space.basic_dof_nodes().T.copy()
        feet[:, d] = getattr(case, end)[d]
        for column, values in heatladder.reference(case, feet, f"wall_{axes[d]}").items():
            model.add_initialized_fem_data(column.replace(f"wall_{axes[d]}", side), space, values)
        if kind == "dirichlet":
            model.add_Dirichlet_condition_with_multipliers(integrals, "T", nodes, number, side + "_value")
        else:
            heat = f"{side}_value" if kind == "neumann" else f"{side}_b*({side}_value-T)"
            model.add_linear_term(integrals, f"-{heat}*Test_T", number)
    fastest = (sum(at["k_" + a] / w**2 for a, w in zip(axes, case.width)) / at["rho_c"]).max()
    steps = int(np.ceil(case.t_end / case.dt - 1e-9 if "dt" in case else 2 * case.t_end * fastest + 4))
    model.add_theta_method_for_first_order("T", 0.5)
    model.add_mass_brick(integrals, "Dot_T", "rho_c")
    model.set_time_step(case.t_end / steps)
    model.set_variable("Previous_T", start.variable("T"))
    model.perform_init_time_derivative(1e-3 * case.t_end / steps)
    model.solve()
    for _ in range(steps):
        model.solve()
        model.shift_variables_for_time_integration()
    return nodes.basic_dof_nodes().T, model.variable("T")


heatladder.run(solve)
