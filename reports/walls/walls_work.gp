# Error against work, one panel a kind of wall: the same runs as walls_error's, and rods, the mean of ten offsets.
name = 'walls_work'
if (!exists("out")) out = 'reports/out'
data = out.'/walls_error.csv'
wide = 1400; high = 560
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.965 center noenhanced font size_of(13)
unset bmargin
set multiplot layout 1,5 margins screen 0.08, 0.985, 0.29, 0.86 spacing screen 0.02, 0.05
set logscale xy
set format y '10^{%T}'
set xrange [3e4:2e7]
set yrange [3e-6:2e-2]
set format x '10^{%T}'
set xlabel 'pairs, in all steps  [-]'
bodies = '"disc held" "disc flux" "disc cooled" "annulus held and flux" "rod-cooling"'
titles = '"disc held" "disc flux" "disc cooled" "annulus held and flux" "rod, held and cooled"'
names = 'fixed distance average image fit one_sided mirror'
colours = sprintf('%s %s %s %s %s %s %s', RED, ORANGE, SKY, BLUE, BLACK, PURPLE, GREEN)
shapes = '7 9 11 5 13 4 6'
has(b, k) = b == 5 ? k > 3 : k < 7 && (b == 1 || k > 3 || (k == 3 && b != 3))
place(w) = sum [k = 1:7] (word(names, k) eq w ? k : 0)
do for [b = 1:5] {
    if (b == 5) { set xrange [3e3:5e6] }
    set title word(titles, b) font size_of(11) offset 0,-0.6
    if (b == 1) { set ylabel 'E = Σ|T_e − T_n| / ΣT_e  [-]' offset 0.5 } else { unset ylabel; set format y '' }
    if (b == 1) { set key at screen 0.985, 0.1 bottom right maxrows 1 width 2 } else { unset key }
    list = ''
    do for [k = 1:7] { if (has(b, k)) { list = list.' '.word(names, k) } }
    plot for [w in list] data index sprintf('%s, %s', w, word(bodies, b)) \
        using 3:2 with linespoints lc rgb word(colours, place(w)) pt int(word(shapes, place(w))) ps 0.9 * P \
        lw (w eq 'fit' ? 2 : 1.2) title w, \
        1/0 with linespoints lc rgb GREEN pt 6 ps 0.9 * P lw 1.2 title 'mirror'
    unset label 98; unset label 99
}
unset multiplot
