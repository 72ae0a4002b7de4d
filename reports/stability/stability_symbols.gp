# |G| over the wave-number square.
name = 'stability_symbols'
wide = 900; high = 920
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.975 center noenhanced font size_of(13)
unset bmargin
set multiplot layout 2,2 margins screen 0.075, 0.885, 0.155, 0.915 spacing screen 0.085, 0.085
set size ratio 1
set xrange [-1:1]
set yrange [-1:1]
set cbrange [0:1.6]
set palette defined (0 '#ffffff', 0.5 '#9ecae1', 1.004 '#08306b', 1.005 '#D55E00', 1.6 '#7f2704')
set cblabel '|G|  [-]; above 1, in orange, a wave grows' noenhanced
set colorbox user origin screen 0.905, screen 0.155 size screen 0.022, screen 0.76
set xtics 0.5
set ytics 0.5
unset grid
names = "'so_ssph cubic' 'fo_ssph cubic' 'brookshaw cubic' 'ftcs published'"
titles = "'SO-SSPH, h/dx = 1.1, at its limit' 'FO-SSPH, h/dx = 1.1, at its limit' 'Brookshaw, h/dx = 1.2, at its limit' \
    'FTCS at Pamplona eq. 17, twice its limit'"
do for [i = 1:4] {
    set title word(titles, i) noenhanced font size_of(11) offset 0,-0.6
    set xlabel (i > 2 ? 'θ_x/π  [-]' : '') enhanced offset 0,0.4
    set ylabel (i % 2 ? 'θ_y/π  [-]' : '') enhanced offset 1
    plot data index word(names, i) using 1:2:3 with image notitle
    unset label 98
    unset label 99
    unset colorbox
}
unset multiplot
