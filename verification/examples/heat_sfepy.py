# SPDX-License-Identifier: GPL-3.0-or-later
"""heat_sfepy.py CASE OUT | verify [options]: SfePy, bilinear elements, its solver ts.simple (implicit Euler) with equal
steps.  A rod is a strip, one element high."""
import numpy as np
from sfepy.base.base import output
from sfepy.discrete import Equation, Equations, FieldVariable, Function, Integral, Material, Problem
from sfepy.discrete.conditions import Conditions, EssentialBC, InitialCondition
from sfepy.discrete.fem import FEDomain, Field
from sfepy.mesh.mesh_generators import gen_block_mesh
from sfepy.solvers.ls import ScipyDirect
from sfepy.solvers.nls import Newton
from sfepy.solvers.ts_solvers import SimpleTimeSteppingSolver
from sfepy.terms import Term

import heatladder


def solve(case):
    if not case.is_plain:
        raise heatladder.NotApplicable
    dim, axes, extra = case.dim, "xyz"[:case.dim], [case.width[0]] * (2 - case.dim)
    lo, size = np.array(case.lo + [0] * len(extra)), np.append(np.subtract(case.hi, case.lo), extra)
    mesh = gen_block_mesh(size, np.array(case.cells + [1] * len(extra)) + 1, lo + size / 2, verbose=False)
    body, gauss = FEDomain("body", mesh).create_region("Omega", "all"), Integral("i", order=2)
    field = Field.from_args("temperature", np.float64, "scalar", body, approx_order=1)
    T, v = FieldVariable("T", "unknown", field, history=1), FieldVariable("v", "test", field, primary_var_name="T")
    ask = lambda x, what: list(heatladder.reference(case, x[:, :dim], what, width=case.width).values())  # noqa: E731
    def data(ts, x, mode=None, what=None, **_):  # b, heat of a wall, or those of the body
        if mode == "qp":
            p, q, r, *k = ask(x, what)
            names = {"heat": np.where(p == 2, q, r * q), "b": r} if "wall" in what else {"source": p, "rho_c": q}
            K = np.stack([r, *k, r, r][:len(lo)], axis=1)[:, :, None] * np.eye(len(lo))
            return {"K": K, **{name: column[:, None, None] for name, column in names.items()}}
    def term(text, region, what):
        m = Material("m_" + region.name, function=Function("f_" + region.name, data, extra_args={"what": what}))
        return Term.new(text.replace("m.", m.name + "."), gauss, region, v=v, T=T, **{m.name: m})
    what, held = "source,rho_c," + ",".join("k_" + a for a in axes), []
    terms = [term("dw_dot(m.rho_c, v, dT/dt)", body, what), term("dw_diffusion(m.K, v, T)", body, what),
             -1 * term("dw_integrate(m.source, v)", body, what)]
    for d, end, place, kind in case.sides:
        test, wall = f"< {place + 1e-6}" if end == "lo" else f"> {place - 1e-6}", "wall_" + axes[d]
        side = body.domain.create_region(f"{axes[d]}_{end}", f"vertices in ({axes[d]} {test})", "facet")
        if kind == "dirichlet":
            value = Function(side.name, lambda ts, x, wall=wall, **_: ask(x, wall)[1])
            held.append(EssentialBC(side.name, side, {"T.0": value}))
        else:
            terms += [term("dw_dot(m.b, v, T)", side, wall), -1 * term("dw_integrate(m.heat, v)", side, wall)]
    problem = Problem("heat", equations=Equations([Equation("balance", sum(terms[1:], terms[0]))]))
    start = {"T.0": Function("start", lambda x, **_: ask(x, "initial_mean")[0])}
    problem.set_bcs(Conditions(held))
    problem.set_ics(Conditions([InitialCondition("start", body, start)]))
    _, rho_c, *k = ask(mesh.coors * 0.999 + 0.001 * (lo + size / 2), what)
    steps = case.steps(1 / (2 * max((k_d / rho_c).max() / w**2 for k_d, w in zip(k, case.width))))
    problem.set_solver(SimpleTimeSteppingSolver({"t1": case.t_end, "n_step": steps + 1}, context=problem,
                                                nls=Newton({"i_max": 1, "is_linear": True}, lin_solver=ScipyDirect({}))))
    low = mesh.coors[:, -1] < (extra[0] / 2 if extra else np.inf)
    return mesh.coors[low, :dim], problem.solve(save_results=False).get_parts()["T"][low]


output.set_output(quiet=True)
heatladder.run(solve)
