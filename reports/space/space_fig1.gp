# The jump in space: slices through the error of two operators, and E1 of four methods against spacing.
name = 'space_fig1'
wide = 1180; high = 500
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.955 center noenhanced font size_of(11)
set multiplot
set palette defined (0 '#00224e', 1 '#35456c', 2 '#666970', 3 '#948e77', 4 '#c8b866', 5 '#fee838') # cividis
set logscale cb
set format cb '10^{%T}'
set cbrange [1e-5:1]
set xrange [-2:2]
set yrange [-2:2]
set xtics -1, 1
set ytics -2, 1
set xlabel 'x  [m]'
set size ratio -1
unset grid
unset key
unset colorbox
set tmargin at screen 0.86
set bmargin at screen 0.25
set lmargin at screen 0.055; set rmargin at screen 0.305
set ylabel 'y  [m]' offset 1.5
set title 'FO-SSPH' font size_of(11) offset 0,-0.6
plot data index 'slice, fo_ssph' using 1:2:3 with image
unset label 98; unset label 99
set lmargin at screen 0.32; set rmargin at screen 0.57
unset ylabel
set format y ''
set title 'SO-SSPH' font size_of(11) offset 0,-0.6
set colorbox user origin screen 0.575, screen 0.25 size screen 0.012, screen 0.61
set cblabel '|T_n − T_e|  [K]' offset 1
plot data index 'slice, so_ssph' using 1:2:3 with image
unset colorbox
set size noratio
set lmargin at screen 0.745; set rmargin at screen 0.885
set grid xtics ytics ls 98
set title 'errors' font size_of(11) offset 0,-0.6
set logscale xy
set format y '10^{%T}'
set xlabel 'dx  [m]'
set ylabel 'E = Σ|T_e − T_n| / ΣT_e  [-]' offset 0.5
set xrange [0.028:0.12]
set yrange [1e-4:0.4]
set xtics ('1/30' 1/30., 0.05, 0.1)
set ytics autofreq
set key at screen 0.893, screen 0.86 left top Left reverse vertical samplen 1.5
names = 'fo_ssph so_ssph brookshaw ftcs'
colours = sprintf('%s %s %s %s', RED, BLUE, ORANGE, GREEN)
plot for [k = 1:4] data index 'error, '.word(names, k) using 1:2 with linespoints lc rgb word(colours, k) \
        pt int(word('7 5 11 9', k)) ps 0.9 * P lw 1.2 title word(names, k), \
    1.2 * x with lines lc rgb GREY dt 2 title 'slope 1', 0.5 * x**2 with lines lc rgb GREY dt 3 title 'slope 2'
unset multiplot
