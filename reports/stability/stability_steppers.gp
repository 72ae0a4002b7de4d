# |G| of the steppers along the real axis.
name = 'stability_steppers'
wide = 1000
load 'reports/figure/style.gp'
set logscale x
set xrange [0.5:160]
set yrange [0:1.5]
set xlabel '-dt λ  [-]'
set ylabel '|G|  [-]' noenhanced
set key outside right top Left reverse noenhanced
set arrow 1 from 0.5, 1 to 160, 1 nohead lc rgb GREY lw 0.8
plot data index 'euler' using 1:2 with lines lc rgb BLACK lw 1.3 dt 1 title 'Euler', \
     data index 'rk2' using 1:2 with lines lc rgb RED lw 1.3 dt 2 title 'RK2', \
     data index 'rkl2 3' using 1:2 with lines lc rgb BLUE lw 1.3 dt 1 title 'RKL2, 3 stages', \
     data index 'rkl2 5' using 1:2 with lines lc rgb GREEN lw 1.3 dt 4 title '5 stages', \
     data index 'rkl2 9' using 1:2 with lines lc rgb PURPLE lw 1.3 dt 5 title '9 stages', \
     data index 'rkl2 15' using 1:2 with lines lc rgb ORANGE lw 1.3 dt 1 title '15 stages', \
     for [s in "'euler' 'rk2' 'rkl2 3' 'rkl2 5' 'rkl2 9' 'rkl2 15'"] data index 'measured '.s using 1:(1) \
         with points pt 6 ps 1.4 * P lc rgb BLACK lw 1.3 notitle, \
     NaN with points pt 6 ps 1.4 * P lc rgb BLACK lw 1.3 title 'measured: growth begins'
