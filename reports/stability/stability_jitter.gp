# Under jitter: what is refused, what grows, what decays, and the condition number.
name = 'stability_jitter'
wide = 980; high = 860
load 'reports/figure/style.gp'
unset title
set label 98 heading at screen 0.5, screen 0.975 center noenhanced font size_of(13)
unset bmargin
set multiplot layout 2,2 margins screen 0.075, 0.875, 0.165, 0.915 spacing screen 0.15, 0.095
set xrange [0.675:2.025]
set xtics 0.2
unset grid
do for [m = 1:2] {
    method = word('so_ssph fo_ssph', m)
    label = word('SO-SSPH FO-SSPH', m)
    set xlabel (m == 2 ? 'h/dx  [-]' : '') offset 0,0.4
    set ylabel 'jitter/dx  [-]' offset 1
    set title sprintf('%s: log_{10} of the condition number; grey: refused', label) enhanced font size_of(11) offset 0,-0.6
    set palette defined (0 '#ffffff', 1 '#9ecae1', 3 '#4292c6', 6 '#08306b')
    set cbrange [0:6]
    set colorbox
    set yrange [-0.025:0.525]
    unset key
    plot data index method using 1:2:(stringcolumn(5) eq 'nan' ? 0 : NaN) with points pt 5 ps 1.6 lc rgb '#bbbbbb', \
         data index method using 1:2:(stringcolumn(5) eq 'nan' ? NaN : $3) with image
    unset label 98
    unset label 99
    set title sprintf('%s: largest real part of an eigenvalue', label) enhanced font size_of(11) offset 0,-0.6
    unset colorbox
    if (m == 2) { set key at screen 0.875, screen 0.045 bottom right noenhanced vertical maxrows 1 samplen 1 width -2 }
    plot data index method using 1:(column(5) < 0 ? $2 : NaN) with points pt 7 ps 0.8 lc rgb SKY title 'decays', \
         data index method using 1:(column(5) > 0 ? $2 : NaN) with points pt 9 ps 1.0 lc rgb RED title 'grows', \
         data index method using 1:(stringcolumn(5) eq 'nan' ? $2 : NaN) with points pt 2 ps 0.8 lc rgb GREY title 'refused'
}
unset multiplot
