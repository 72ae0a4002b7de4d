# SPDX-License-Identifier: GPL-3.0-or-later
"""heat_getfem.py CASE OUT | verify [options]: GetFEM, bilinear elements, its theta method with theta = 1/2.

    (rho_c dT/dt, v) + (k grad T, grad v) + <b T, v> = (source, v) + <flux or b T_air, v>,   T given on held walls
"""
import getfem as gf
import numpy as np

import heatladder


def solve(case):
    if not case.is_plain:
        raise heatladder.NotApplicable
    gf.util_trace_level(0)
    axes = "xyz"[:case.dim]
    mesh = gf.Mesh("cartesian", *[np.linspace(lo, hi, n + 1) for lo, hi, n in zip(case.lo, case.hi, case.cells)])
    nodes, cells, along = gf.MeshFem(mesh, 1), gf.MeshFem(mesh, 1), gf.MeshFem(mesh, case.dim)
    for space, degree in (nodes, 1), (cells, 0), (along, 0):
        (space.set_classical_fem if degree else space.set_classical_discontinuous_fem)(degree)
    integrals, middles = gf.MeshIm(mesh, 3), cells.basic_dof_nodes().T
    names = ["initial_mean", "source", "rho_c", *("k_" + a for a in axes)]
    at = heatladder.reference(case, middles, ",".join(names), width=case.width)
    model, start = gf.Model("real"), gf.Model("real")
    for name in names[:3]:
        for place in model, start:
            place.add_initialized_fem_data(name, cells, at[name])
    start.add_fem_variable("T", nodes)  # a projection, which keeps the heat
    start.add_linear_term(integrals, "rho_c*(T-initial_mean)*Test_T")
    start.solve()
    model.add_fem_variable("T", nodes)
    model.add_initialized_fem_data("k", along, np.stack([at[name] for name in names[3:]], axis=1).ravel())
    model.add_linear_term(integrals, "(k.*Grad_T).Grad_Test_T-source*Test_T")
    outer = mesh.outer_faces()
    for number, (d, end, place, kind) in enumerate(case.sides, 1):
        mesh.set_region(number, outer[:, mesh.normal_of_faces(outer)[d] * (1 if end == "hi" else -1) > 0.5])
        space, side = nodes if kind == "dirichlet" else cells, f"side_{axes[d]}_{end}"
        feet = space.basic_dof_nodes().T.copy()
        feet[:, d] = place
        for column, values in heatladder.reference(case, feet, f"wall_{axes[d]}").items():
            model.add_initialized_fem_data(column.replace(f"wall_{axes[d]}", side), space, values)
        if kind == "dirichlet":
            model.add_Dirichlet_condition_with_simplification("T", number, side + "_value")  # stays definite
        else:
            heat = f"{side}_value" if kind == "neumann" else f"{side}_b*({side}_value-T)"
            model.add_linear_term(integrals, f"-{heat}*Test_T", number)
    steps = case.steps(1 / (2 * (sum(at["k_" + a] / w**2 for a, w in zip(axes, case.width)) / at["rho_c"]).max()))
    model.add_theta_method_for_first_order("T", 0.5)
    model.add_mass_brick(integrals, "Dot_T", "rho_c")
    model.set_time_step(case.t_end / steps)
    model.set_variable("Previous_T", start.variable("T"))
    model.perform_init_time_derivative(1e-3 * case.t_end / steps)
    model.solve()
    for _ in range(steps):
        model.solve("lsolver", "cg/ildlt" if case.dim == 3 else "auto", "max_res", 1e-9)
        model.shift_variables_for_time_integration()
    return nodes.basic_dof_nodes().T, model.variable("T")


heatladder.run(solve)
