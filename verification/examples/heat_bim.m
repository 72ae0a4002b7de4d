% SPDX-License-Identifier: GPL-3.0-or-later
% octave-cli heat_bim.m CASE OUT: Octave's package bim, linear elements on triangles with lumped masses, the trapezoidal
% rule.  bim has one conductivity for both axes.  A rod is a strip, one cell high.
1; % a script, although a function comes first

% The columns of `what` at points in the plane.
function columns = ask(c, out, points, what)
    d = 1:c.dim;
    dlmwrite([out '.points'], [points(d, :); repmat(c.width(d)', 1, size(points, 2))]', 'precision', '%.17g');
    [~, answer] = system(sprintf(['(echo %s; cat ''%s.points'') | ${HEATLADDER:-heatladder} reference %s --points - ' ...
                                  '--what %s | tail -n +2'], {'x,dx', 'x,y,dx,dy'}{c.dim}, out, c.oracle, what));
    columns = reshape(sscanf(strrep(answer, ',', ' '), '%f'), [], size(points, 2))'(:, c.dim + 1:end);
end

pkg load bim
[file, out] = argv(){:};
for pair = regexp(fileread(file), '([^\n]+?) = ([^\n]*)', 'tokens')
    c.(pair{1}{1}) = pair{1}{2};
end
lacks = {'shape', 'k_law', 'contact_resistance', 'conductivity'};
if any(ismember({'changing', 'periodic'}, struct2cell(c))) || any(isfield(c, lacks)) || strcmp(c.dim, '3') ...
        || isfield(c, 'k_y') && ! strcmp(c.k_x, c.k_y)
    exit(77);
end
for key = {'dim', 'lo', 'hi', 'cells', 't_end'}
    c.(key{1}) = sscanf(strrep(c.(key{1}), ',', ' '), '%f')';
end
c.width = (c.hi - c.lo) ./ c.cells;
[lo, hi, n] = deal([c.lo 0], [c.hi c.width(1)], [c.cells 1]);
[x, y] = deal(linspace(lo(1), hi(1), n(1) + 1), linspace(lo(2), hi(2), n(2) + 1));
mesh = bim2c_mesh_properties(msh2m_structured_mesh(x, y, 1, 1:4));
middle = squeeze(mean(reshape(mesh.p(:, mesh.t(1:3, :)), 2, 3, []), 2));
at = ask(c, out, middle, 'source,rho_c,k_x');
T = ask(c, out, mesh.p, 'initial_mean');
[one, held, source] = deal(ones(columns(mesh.p), 1), [], at(:, 1));
[K, M, F] = deal(bim2a_laplacian(mesh, at(:, 3), one), bim2a_reaction(mesh, at(:, 2), one), bim2a_rhs(mesh, source, one));
for side = find([c.dim > 1, 1, c.dim > 1, 1]) % y_lo, x_hi, y_hi, x_lo
    on = bim2c_unknowns_on_side(mesh, side);
    wall = ask(c, out, mesh.p(:, on), {'wall_y', 'wall_x', 'wall_y', 'wall_x'}{side});
    if wall(1, 1) == 1
        held = union(held, on);
        T(on) = wall(:, 2);
    else
        weight = full(diag(bim2a_boundary_mass(mesh, side)));
        F(on) += weight .* wall(:, 2) .* merge(wall(:, 1) == 2, 1, wall(:, 3));
        K += sparse(on, on, weight .* wall(:, 3), rows(K), rows(K));
    end
end
free = setdiff(1:rows(K), held);
steps = ceil(2 * c.t_end * sum(max(at(:, 3) ./ at(:, 2)) ./ c.width .^ 2)) + 4;
if isfield(c, 'dt'), steps = round(c.t_end / str2double(c.dt)); end
tic; M *= steps / c.t_end;
[L, U, P, Q] = lu(M(free, free) + K(free, free) / 2);
for step = 1:steps
    T(free) += Q * (U \ (L \ (P * (F - K * T)(free))));
end
answer = fopen(out, 'w');
fprintf(answer, '# steps = %d\n# seconds = %g\n%s\n', steps, toc, {'x,T', 'x,y,T'}{c.dim});
low = mesh.p(2, :) == lo(2) | c.dim > 1;
fprintf(answer, [repmat('%.17g,', 1, c.dim) '%.17g\n'], [mesh.p(1:c.dim, low); T(low)']);
fclose(answer);
