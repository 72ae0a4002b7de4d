# Error against spacing, one panel a kind of wall.
name = 'walls_error'
wide = 1180; high = 560
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.965 center noenhanced font size_of(13)
unset bmargin
set multiplot layout 1,4 margins screen 0.08, 0.985, 0.29, 0.86 spacing screen 0.02, 0.05
set logscale xy
set format y '10^{%T}'
set xrange [0.02:0.125]
set yrange [3e-6:5e-3]
set xtics (0.025, 0.05, 0.1)
set xlabel 'dx  [m]'
bodies = '"disc held" "disc flux" "disc cooled" "annulus held and flux"'
names = 'fixed distance average image fit one_sided'
colours = sprintf('%s %s %s %s %s %s', RED, ORANGE, SKY, BLUE, BLACK, PURPLE)
shapes = '7 9 11 5 13 4'
has(b, k) = b == 1 || k > 3 || (k == 3 && b != 3)
place(w) = sum [k = 1:6] (word(names, k) eq w ? k : 0)
do for [b = 1:4] {
    set title word(bodies, b) font size_of(11) offset 0,-0.6
    if (b == 1) { set ylabel 'E = Σ|T_e − T_n| / ΣT_e  [-]' offset 0.5 } else { unset ylabel; set format y '' }
    if (b == 1) { set key at screen 0.985, 0.1 bottom right maxrows 1 width -1 } else { unset key }
    list = ''
    do for [k = 1:6] { if (has(b, k)) { list = list.' '.word(names, k) } }
    plot for [w in list] data index sprintf('%s, %s', w, word(bodies, b)) \
        using 1:2 with linespoints lc rgb word(colours, place(w)) pt int(word(shapes, place(w))) ps 0.9 * P \
        lw (w eq 'fit' ? 2 : 1.2) title w, \
        0.02 * x**2 with lines lc rgb GREY dt 2 title (b == 1 ? 'slope 2' : ''), \
        0.03 * x with lines lc rgb GREY dt 3 title (b == 1 ? 'slope 1' : '')
    unset label 98; unset label 99
}
unset multiplot
