# Style of every figure.  A script sets `name` (and `wide`, `high` if they differ) and loads this file, which sets
# `data`, the file to plot; the output is written beside it.  The key is below the plot, `keys` rows of it (1 by
# default); a figure of 640 pixels is one column of the page, a wider one is both.
#
#     gnuplot -e "out='reports/out'; kind='svg'" reports/song/song_fig1b.gp        (kind: svg or png)
#
# Title and caption are in the head of the data file, so that a figure shows the command that made it.
if (!exists("out")) out = 'reports/out'
if (!exists("to")) to = out
if (!exists("kind")) kind = 'svg'
if (!exists("wide")) wide = 640
if (!exists("high")) high = 540

if (!exists("data")) data = sprintf('%s/%s.csv', out, name)
# SVG counts fonts in pixels (3/4 point each) and draws points larger.
svg = kind eq 'svg'
size_of(points) = sprintf(',%g', svg ? points * 4.0 / 3 : points)
P = svg ? 0.62 : 1.0
if (svg) {
    set terminal svg size wide,high enhanced dashed font 'DejaVu Sans,14' background rgb 'white' linewidth 1
} else {
    set terminal pngcairo size wide,high enhanced dashed font 'DejaVu Sans,10.5' background rgb 'white' linewidth 1
}
set output sprintf('%s/%s.%s', to, name, kind)
set encoding utf8
set minussign
set datafile separator comma

# The head of the data file.
heading = system(sprintf("sed -n 's/^# title: //p' '%s'", data))
commands = int(system(sprintf("grep -c '^# command: ' '%s'", data)))
# The value of an option in the first of its commands.
option(name) = system(sprintf("sed -n '/^# command: /{s/.* --%s \\([^ ]*\\).*/\\1/p;q;}' '%s'", name, data))
fold(columns, text) = system(sprintf("fold -s -w %d <<'END'\n%s\nEND", columns, text))
caption = fold(wide / 6.3, system(sprintf("sed -n 's/^# command: //p' '%s' | head -n %d", data, commands > 2 ? 1 : 2)))
if (commands > 2) caption = caption . sprintf("\nand %d more, in the head of %s.csv", commands - 1, name)
lines = int(system(sprintf("wc -l <<'END'\n%s\nEND", caption)))
foot = 8 + 14.5 * lines # pixels of the caption
if (!exists("keys")) keys = 1
heading = fold(wide / 8.0, heading)
set title heading noenhanced font size_of(11)
set label 99 caption at screen 0.012, screen (foot - 10.0) / high left noenhanced font size_of(8.5) textcolor rgb '#555555'
set bmargin at screen (foot + 25 * keys + 80) / high

# Okabe & Ito's palette, distinguishable with colour-vision deficiency; each colour has its own point and dash.
BLACK = '#000000'; ORANGE = '#E69F00'; SKY = '#56B4E9'; GREEN = '#009E73'
BLUE = '#0072B2'; RED = '#D55E00'; PURPLE = '#CC79A7'; GREY = '#777777'
set style line 1 lc rgb BLACK lw 1.3 dt 1 pt 1 ps 0.7 * P
set style line 2 lc rgb RED lw 1.2 dt 2 pt 7 ps 0.7 * P
set style line 3 lc rgb BLUE lw 1.2 dt 1 pt 5 ps 0.65 * P
set style line 4 lc rgb GREEN lw 1.2 dt 4 pt 9 ps 0.8 * P
set style line 5 lc rgb PURPLE lw 1.2 dt 5 pt 13 ps 0.8 * P
set style line 6 lc rgb ORANGE lw 1.2 dt 3 pt 11 ps 0.8 * P
set style line 7 lc rgb GREY lw 1.0 dt 1            # triangles
set style line 12 lc rgb RED lw 1.2 dt 3 pt 6 ps 1.5 * P  # published, around the measured point
set style line 13 lc rgb BLUE lw 1.2 dt 3 pt 4 ps 1.5 * P
set style line 98 lc rgb '#e4e4e4' lw 0.8 dt 1
set style line 99 lc rgb '#f2f2f2' lw 0.6 dt 1

set border lw 0.8
set tics nomirror out scale 0.7
set grid xtics ytics ls 98
set key samplen 2.5 spacing 1.25 noopaque noenhanced
if (wide <= 640) { set key at screen 0.5, screen (foot + 25.0 * keys + 4) / high center top horizontal Left reverse }
eval sprintf("set key font '%s'", size_of(10))
