// SPDX-License-Identifier: GPL-3.0-or-later
// heat_dealii CASE OUT: deal.II, Q1 elements, theta = 1/2; matrices, walls and solver (CG, SSOR) as in its step-26.
//     (rho_c dT/dt, v) + (k grad T, grad v) + <b T, v> = (source, v) + <flux or b T_air, v>,   T given on held walls
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/timer.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/numerics/matrix_tools.h>
#include <fstream>
using namespace dealii;
using Values = std::vector<double>;

static std::map<std::string, std::string> words; // key = value of the case
static std::string out;

static Values list_of(const std::string &text) {
    return Utilities::string_to_double(Utilities::split_string_list(text));
}

// A row of columns for each point.
template <int dim>
std::vector<Values> ask(const std::vector<Point<dim>> &points, const Tensor<1, dim> &width, const std::string &what) {
    std::ofstream file(out + ".points");
    file << std::string("x y z").substr(0, 2 * dim - 1) << std::string(" dx dy dz").substr(0, 3 * dim) << '\n';
    file << std::setprecision(17);
    for (auto &p : points) file << p << ' ' << width << '\n';
    file.close();
    auto question = getenv("HEATLADDER") + (" reference " + words["oracle"]) + " --time 0 --points '" + out +
                    ".points' --what " + what + " >'" + out + ".data'";
    AssertThrow(std::system(question.c_str()) == 0, ExcMessage(question));
    std::ifstream data(out + ".data");
    std::vector<Values> rows;
    std::string line;
    for (std::getline(data, line); std::getline(data, line);) {
        auto row = list_of(line);
        rows.emplace_back(row.begin() + dim, row.end());
    }
    return rows;
}

template <int dim> void solve() {
    Point<dim> lo, hi;
    Tensor<1, dim> width;
    std::vector<unsigned> cells;
    for (int d = 0; d < dim; d++) {
        lo[d] = list_of(words["lo"])[d], hi[d] = list_of(words["hi"])[d], cells.push_back(list_of(words["cells"])[d]);
        width[d] = (hi[d] - lo[d]) / cells[d];
    }
    Triangulation<dim> grid;
    GridGenerator::subdivided_hyper_rectangle(grid, cells, lo, hi, true); // numbers of the sides: 2 d and 2 d + 1
    FE_Q<dim> fe(1);
    DoFHandler<dim> dofs(grid);
    dofs.distribute_dofs(fe);
    SparsityPattern pattern(dofs.n_dofs(), dofs.max_couplings_between_dofs());
    DoFTools::make_sparsity_pattern(dofs, pattern);
    pattern.compress();
    SparseMatrix<double> mass(pattern), stiffness(pattern), matrix(pattern);
    Vector<double> T(dofs.n_dofs()), heat(dofs.n_dofs()), right(dofs.n_dofs()), part(dofs.n_dofs());

    std::vector<Point<dim>> middles, faces, nodes(dofs.n_dofs());
    DoFTools::map_dofs_to_support_points(MappingQ1<dim>(), dofs, nodes);
    for (auto &cell : dofs.active_cell_iterators()) {
        middles.push_back(cell->center());
        for (auto f : cell->face_indices()) faces.push_back(cell->face(f)->center());
    }
    auto walls = std::string("wall_x,wall_y,wall_z").substr(0, 7 * dim - 1);
    auto body = ask(middles, width, "initial_mean,source,rho_c," + std::string("k_x,k_y,k_z").substr(0, 4 * dim - 1));
    auto sides = ask(faces, width, walls), at_nodes = ask(nodes, width, walls);
    std::map<types::global_dof_index, double> held;
    for (unsigned i = 0; i < nodes.size(); i++)
        for (int d = 0; d < dim; d++)
            if (at_nodes[i][3 * d] == 1) held[i] = at_nodes[i][3 * d + 1];

    FEValues<dim> in(fe, QGauss<dim>(2), update_values | update_gradients | update_JxW_values);
    FEFaceValues<dim> on(fe, QGauss<dim - 1>(2), update_values | update_JxW_values);
    std::vector<types::global_dof_index> node(fe.dofs_per_cell);
    double fastest = 0; // 1/s
    unsigned c = 0;
    for (auto &cell : dofs.active_cell_iterators()) {
        const auto &data = body[c];
        double mean = data[0], source = data[1], rho_c = data[2], rate = 0;
        Tensor<2, dim> k;
        for (int d = 0; d < dim; d++) {
            k[d][d] = data[3 + d];
            rate += k[d][d] / rho_c / (width[d] * width[d]);
        }
        fastest = std::max(fastest, rate);
        in.reinit(cell);
        cell->get_dof_indices(node);
        for (auto q : in.quadrature_point_indices())
            for (auto i : in.dof_indices()) {
                heat(node[i]) += source * in.shape_value(i, q) * in.JxW(q);
                right(node[i]) += rho_c * mean * in.shape_value(i, q) * in.JxW(q);
                for (auto j : in.dof_indices()) {
                    mass.add(node[i], node[j], rho_c * in.shape_value(i, q) * in.shape_value(j, q) * in.JxW(q));
                    stiffness.add(node[i], node[j], in.shape_grad(i, q) * k * in.shape_grad(j, q) * in.JxW(q));
                }
            }
        for (auto f : cell->face_indices()) {
            const double *wall = &sides[c * 2 * dim + f][f / 2 * 3]; // kind, value, b
            if (!cell->face(f)->at_boundary() || wall[0] == 1) continue;
            on.reinit(cell, f);
            for (auto q : on.quadrature_point_indices())
                for (auto i : on.dof_indices()) {
                    double share = on.shape_value(i, q) * on.JxW(q);
                    heat(node[i]) += (wall[0] == 2 ? 1 : wall[2]) * wall[1] * share;
                    for (auto j : on.dof_indices())
                        stiffness.add(node[i], node[j], wall[2] * on.shape_value(j, q) * share);
                }
        }
        c++;
    }

    auto invert = [&] { // matrix T = right
        SolverControl control(1000, 1e-12 * right.l2_norm());
        SolverCG<> solver(control);
        PreconditionSSOR<> preconditioner;
        preconditioner.initialize(matrix, 1.0);
        solver.solve(matrix, T, right, preconditioner);
    };
    matrix.copy_from(mass);
    invert(); // the start: a projection, which keeps the heat
    double t_end = list_of(words["t_end"])[0];
    int steps = words.count("dt") ? std::round(t_end / list_of(words["dt"])[0]) : std::ceil(2 * t_end * fastest);
    double dt = t_end / steps;
    Timer solve; // starts
    for (int step = 0; step < steps; step++) {
        mass.vmult(right, T);
        stiffness.vmult(part, T);
        right.add(-dt / 2, part, dt, heat);
        matrix.copy_from(mass);
        matrix.add(dt / 2, stiffness);
        MatrixTools::apply_boundary_values(held, matrix, T, right);
        invert();
    }
    std::ofstream answer(out);
    answer << "# seconds = " << solve.wall_time() << "\n# steps = " << steps << '\n';
    answer << std::string("x y z").substr(0, 2 * dim - 1) << " T\n" << std::setprecision(17);
    for (unsigned i = 0; i < nodes.size(); i++) answer << nodes[i] << ' ' << T(i) << '\n';
}

int main(int, char **arguments) {
    std::ifstream file(arguments[1]);
    out = arguments[2];
    for (std::string line; std::getline(file, line);) {
        auto key = line.substr(0, line.find(" = ")), value = line.substr(key.size() + 3);
        words[key] = value;
        for (const char *word : {"shape", "k_law", "k_xy", "conductivity", "contact_resistance", "periodic", "changing"})
            if (key == word || value == word) return 77; // boxes with walls, and data that stay
    }
    int dim = list_of(words["dim"])[0];
    dim == 1 ? solve<1>() : dim == 2 ? solve<2>() : solve<3>();
}
