# Order reached and order expected of every ladder, then for each scene the errors of its methods.
name = 'gates'
wide = 820; high = 1500
load 'reports/figure/style.gp'
scenes = ''
stats data index 'groups' using (scenes = scenes . strcol(2) . ' ', $1) nooutput
stats data index 'orders' using 1 nooutput
lines = STATS_max
set title heading noenhanced font size_of(13)
unset label 99
unset bmargin
set margins screen 0.2, screen 0.97, screen 0.07, screen 0.965
set yrange [lines + 1:-2]
set xrange [-0.2:*]
set xtics 1
set xlabel 'order  [-]'
set key below
plot data index 'groups' using (0):1:ytic(2) with points ps 0 notitle, \
     data index 'orders' using 2:1:($3 - $2):(0) with vectors nohead lc rgb '#bbbbbb' lw 3.5 title 'expected', \
     data index 'orders' using ($5 == 1 ? $4 : NaN):1 with points pt 7 ps 0.5 * P lc rgb BLUE title 'reached', \
     data index 'orders' using ($5 == 1 ? NaN : $4):1 with points pt 2 ps 1.2 * P lw 2 lc rgb RED \
         title 'reached, the gate does not hold'

set terminal svg size 460, 500 enhanced dashed font 'DejaVu Sans,13' background rgb 'white' linewidth 1
set margins screen 0.19, screen 0.96, screen 0.40, screen 0.92
set xrange [*:*] noextend
set yrange [*:*] noextend
set logscale xy
set format y '10^{%T}'
set xtics autofreq
set ytics autofreq
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
set xlabel 'dx  [m]'
set ylabel 'E1  [-]' offset 0.5
set key at screen 0.03, screen 0.28 left top Left reverse vertical samplen 2 spacing 1.1 maxrows 6
do for [scene in scenes] {
    methods = int(system(sprintf("grep -c '^# %s [0-9]$' '%s'", scene, data)))
    if (methods > 0) {
        set output sprintf('%s/scene_%s.svg', to, scene)
        set title scene noenhanced font size_of(12)
        plot for [k = methods:1:-1] data index sprintf('%s %d', scene, k) using 1:2 with lines ls k notitle, \
             for [k = 1:methods] data index sprintf('%s %d', scene, k) using 1:($3 == 1 ? $2 : NaN) with points \
                 ls k title columnheader(2), \
             for [k = 1:methods] data index sprintf('%s %d', scene, k) using 1:($3 == 1 ? NaN : $2) with points \
                 ls k pt (k == 1 ? 1 : 6) lc rgb GREY notitle
    }
}
