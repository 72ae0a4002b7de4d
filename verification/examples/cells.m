% octave-cli cells.m CASE OUT: finite volumes on a grid of cells, explicit Euler.  All that the case does not tell,
% `heatladder reference` does, at the centres of the cells and of the faces on the sides; $HEATLADDER is that program.
args = argv();
for row = regexp(fileread(args{1}), '([^\n]+?) = ([^\n]*)', 'tokens')
    field.(row{1}{1}) = row{1}{2};
end
number = @(key) sscanf(strrep(field.(key), ',', ' '), '%f')';
dim = number('dim'); lo = number('lo'); hi = number('hi'); n = number('cells'); t_end = number('t_end');
h = (hi - lo) ./ n;
% Cells 2 to n + 1 along each axis, framed by the faces on the sides; a rod is one column, without a frame in y.
along = @(d) [lo(d), lo(d) + ((1:n(d)) - 0.5) * h(d), hi(d)];
if dim == 1
    points = along(1)'; ny = 1; in_y = 1; header = 'x,dx'; more = ''; answer = 'x,T';
else
    [x, y] = ndgrid(along(1), along(2));
    points = [x(:), y(:)]; ny = n(2) + 2; in_y = 2:n(2) + 1;
    header = 'x,y,dx,dy'; more = ',k_y,wall_y'; answer = 'x,y,T';
end
in_x = 2:n(1) + 1; shape = [n(1) + 2, ny]; f = fopen([args{2} '.points'], 'w');
fprintf(f, '%s\n', header);
fprintf(f, [strjoin(repmat({'%.17g'}, 1, 2 * dim), ',') '\n'], [points, repmat(h, rows(points), 1)]');
fclose(f);
ask = ['${HEATLADDER:-heatladder} reference ' field.oracle ' --points ''' args{2} '.points'' --time 0'];
[status, told] = system([ask ' --what initial_heat,source,rho_c,k_x,wall_x' more]);
if status error('no answer from heatladder reference'); end
told = sscanf(strrep(regexprep(told, '^[^\n]*\n', ''), ',', ' '), '%f', [5 * dim + 3, Inf])'(:, dim + 1:end);
p = @(column) reshape(told(:, column), shape);

% Conductances of the faces, over the cell's width: half cells in series, and at a side Robin's coefficient.
T = p(1); source = p(2)(in_x, in_y); flux = 0 * source; rho_c = p(3)(in_x, in_y); g = cell(1, 2 * dim); speed = 0;
for s = 1:2 * dim
    d = ceil(s / 2); step = 2 * mod(s + 1, 2) - 1;
    ix{s} = in_x + step * (d == 1); iy{s} = in_y + step * (d == 2);
    k = p(4 * d)(in_x, in_y); k_e = p(4 * d)(ix{s}, iy{s}); kind = p(4 * d + 1)(ix{s}, iy{s});
    value = p(4 * d + 2)(ix{s}, iy{s}); b = p(4 * d + 3)(ix{s}, iy{s});
    place = {ix{s}' * ones(1, numel(in_y)), ones(n(1), 1) * iy{s}}{d};
    side = place == 1 | place == n(d) + 2;
    beyond = h(d) ./ (2 * k_e); beyond(side) = 0; beyond(side & kind == 3) = 1 ./ b(side & kind == 3);
    g{s} = 1 ./ (h(d) ./ (2 * k) + beyond) / h(d); g{s}(side & kind == 2) = 0;
    flux(side & kind == 2) += value(side & kind == 2) / h(d);
    around = T(ix{s}, iy{s}); around(side) = value(side); T(ix{s}, iy{s}) = around;
    speed = speed + k ./ (h(d) ^ 2 * rho_c) / 2;
end
steps = ceil(t_end * max(speed(:)) / 0.25); change = strcmp(field.source, 'changing');
if change [~, told] = system(sprintf('%s:%.17g:%d --what source | sed "1d; s/.*,//"', ask, t_end, steps + 1)); end
for step = 1:steps
    if step * change == 1 told = sscanf(told, '%f', [prod(shape), Inf]); end
    if change source = reshape(told(:, step), shape)(in_x, in_y); end
    rate = source + flux;
    for s = 1:2 * dim
        rate += g{s} .* (T(ix{s}, iy{s}) - T(in_x, in_y));
    end
    T(in_x, in_y) += t_end / steps * rate ./ rho_c;
end
keep = false(shape); keep(in_x, in_y) = true;
f = fopen(args{2}, 'w');
fprintf(f, '# steps = %d\n%s\n', steps, answer);
fprintf(f, [strjoin(repmat({'%.17g'}, 1, dim + 1), ',') '\n'], [points(keep(:), :), T(keep)]');
fclose(f);
