# Order of E1 against the offset of the lattice, plane walls.
name = 'walls_offset'
wide = 900; high = 560
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.965 center noenhanced font size_of(13)
unset bmargin
set multiplot layout 1,2 margins screen 0.1, 0.98, 0.29, 0.86 spacing screen 0.05, 0.05
set xrange [-0.05:0.95]
set yrange [0:3]
set xlabel 'offset  [dx]'
rods = 'rod-cooling rod-cosine'
titles = '"held and cooled (rod-cooling)" "insulated (rod-cosine)"'
names = 'mirror average image fit one_sided'
colours = sprintf('%s %s %s %s %s', GREEN, SKY, BLUE, BLACK, PURPLE)
shapes = '9 11 5 13 4'
place(w) = sum [k = 1:5] (word(names, k) eq w ? k : 0)
do for [b = 1:2] {
    set title word(titles, b) font size_of(11) offset 0,-0.6 noenhanced
    if (b == 1) { set ylabel 'order of E1  [-]' } else { unset ylabel }
    if (b == 2) { set key at screen 0.98, 0.1 bottom right maxrows 1 width 2 } else { unset key }
    plot for [w in (b == 1 ? 'mirror image fit one_sided' : names)] data index word(rods, b).' '.w \
        using 1:2 with linespoints lc rgb word(colours, place(w)) pt int(word(shapes, place(w))) ps 0.9 * P \
        lw (w eq 'fit' ? 2 : 1.2) title w
    unset label 98; unset label 99
}
unset multiplot
