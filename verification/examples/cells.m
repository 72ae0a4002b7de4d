% SPDX-License-Identifier: GPL-3.0-or-later
% octave-cli cells.m CASE OUT: finite volumes on a grid of cells, explicit Euler.
%
%     rho_c dT/dt = source + sum over the faces of a cell of conductance (T_beyond - T)
%
% The case file gives the grid and the end time.  `heatladder reference` gives all else (start,
% source, coefficients, walls) at the centres of the cells and of the faces on the sides.
% $HEATLADDER is the path of that program.
1; % a script, although functions come first

% The `key = value` lines of the case as a structure of strings.
function field = read_case(path)
    for pair = regexp(fileread(path), '([^\n]+?) = ([^\n]*)', 'tokens')
        field.(pair{1}{1}) = pair{1}{2};
    end
end

function values = numbers(text)
    values = sscanf(strrep(text, ',', ' '), '%f')';
end

function write_rows(path, header, rows)
    [f, message] = fopen(path, 'w');
    if f < 0
        error('%s: %s', path, message);
    end
    fprintf(f, '%s\n', header);
    fprintf(f, [strjoin(repmat({'%.17g'}, 1, columns(rows)), ',') '\n'], rows');
    fclose(f);
end

% A row of numbers for each point (and each time, if there are several), with the point itself.
function rows = ask(oracle, path, times, what, width)
    [status, answer] = system(sprintf('${HEATLADDER:-heatladder} reference %s --points ''%s'' --time %s --what %s', ...
                                      oracle, path, times, what));
    if status
        error('no answer from heatladder reference');
    end
    answer = regexprep(answer, '^[^\n]*\n', ''); % the header
    rows = sscanf(strrep(answer, ',', ' '), '%f', [width, Inf])';
end

args = argv();
if numel(args) != 2
    error('two arguments are needed: CASE OUT');
end
field = read_case(args{1});
dim = numbers(field.dim);
others = {'shape', 'walls', 'k_law', 'contact_resistance', 'conductivity'};
if dim == 3 || any(isfield(field, others)) || any(strcmp(struct2cell(field), 'periodic'))
    exit(77); % rods and rectangles with steady walls and k alone
end
lo = numbers(field.lo);
hi = numbers(field.hi);
n = numbers(field.cells);
t_end = numbers(field.t_end);
width = (hi - lo) ./ n;

% The points: cells 2 to n + 1 along each axis, in a frame of the centres of the faces on the sides
% (see cells.c).
axis_points = @(d) [lo(d), lo(d) + ((1:n(d)) - 0.5) * width(d), hi(d)];
in_x = 2:n(1) + 1;
if dim == 1
    points = axis_points(1)';
    in_y = 1;
    shape = [n(1) + 2, 1];
    write_rows([args{2} '.points'], 'x,dx', [points, repmat(width, rows(points), 1)]);
    scene = ask(field.oracle, [args{2} '.points'], '0', 'initial_mean,source,rho_c,k_x,wall_x', 8);
else
    [x, y] = ndgrid(axis_points(1), axis_points(2));
    points = [x(:), y(:)];
    in_y = 2:n(2) + 1;
    shape = n + 2;
    write_rows([args{2} '.points'], 'x,y,dx,dy', [points, repmat(width, rows(points), 1)]);
    what = 'initial_mean,source,rho_c,k_x,wall_x,k_y,wall_y';
    scene = ask(field.oracle, [args{2} '.points'], '0', what, 13);
end
column = @(i) reshape(scene(:, dim + i), shape);
T = column(1);
source = column(2)(in_x, in_y);
rho_c = column(3)(in_x, in_y);

% The faces: half cells in series, or a half cell and what the wall resists.
flux = zeros(size(source));
speed = zeros(size(source));
for face = 1:2 * dim
    d = ceil(face / 2);
    step = 2 * mod(face + 1, 2) - 1;
    beyond_x{face} = in_x + step * (d == 1); % where the neighbours are
    beyond_y{face} = in_y + step * (d == 2);
    k = column(4 * d)(in_x, in_y);
    k_beyond = column(4 * d)(beyond_x{face}, beyond_y{face});
    kind = column(4 * d + 1)(beyond_x{face}, beyond_y{face}); % 1: held, 2: a given flux, 3: cooled
    value = column(4 * d + 2)(beyond_x{face}, beyond_y{face});
    b = column(4 * d + 3)(beyond_x{face}, beyond_y{face});
    is_wall = false(size(source));
    if d == 1
        is_wall((step + 1) / 2 * (n(1) - 1) + 1, :) = true;
    else
        is_wall(:, (step + 1) / 2 * (n(2) - 1) + 1) = true;
    end
    is_flux = is_wall & kind == 2;
    is_cooled = is_wall & kind == 3;

    beyond = width(d) ./ (2 * k_beyond);
    beyond(is_wall) = 0;
    beyond(is_cooled) = 1 ./ b(is_cooled);
    conductance{face} = 1 ./ (width(d) ./ (2 * k) + beyond) / width(d);
    conductance{face}(is_flux) = 0;
    flux(is_flux) += value(is_flux) / width(d);

    around = T(beyond_x{face}, beyond_y{face});
    around(is_wall) = value(is_wall);
    T(beyond_x{face}, beyond_y{face}) = around;
    speed += k ./ (width(d) ^ 2 * rho_c) / 2;
end

% A source that changes in time is asked for at the start of every step.
steps = ceil(t_end * max(speed(:)) / 0.25);
dt = t_end / steps;
changing = strcmp(field.source, 'changing');
if changing
    times = sprintf('0:%.17g:%d', t_end, steps + 1);
    answers = ask(field.oracle, [args{2} '.points'], times, 'source', dim + 2);
    sources = reshape(answers(:, end), prod(shape), []);
end
begun = cputime;
for step = 1:steps
    if changing
        source = reshape(sources(:, step), shape)(in_x, in_y);
    end
    rate = source + flux;
    for face = 1:2 * dim
        rate += conductance{face} .* (T(beyond_x{face}, beyond_y{face}) - T(in_x, in_y));
    end
    T(in_x, in_y) += dt * rate ./ rho_c;
end
seconds = cputime - begun;

is_cell = false(shape);
is_cell(in_x, in_y) = true;
header = {'x,T', 'x,y,T'}{dim};
header = sprintf('# steps = %d\n# seconds = %g\n%s', steps, seconds, header);
write_rows(args{2}, header, [points(is_cell(:), :), T(is_cell)]);
