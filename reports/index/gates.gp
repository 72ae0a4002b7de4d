# Measured and expected order, one row per scene; then the errors of the methods against dx, one plot per scene.
name = 'gates'
wide = 1080; high = 560
load 'reports/figure/style.gp'
scenes = ''
stats data index 'groups' using (scenes = scenes . strcol(2) . ' ', $1) name 'ROW' nooutput
stats data index 'orders' using 4 name 'ORDER' nooutput
stats data index 'orders' using 3 name 'HIGH' nooutput
row(place) = floor(place + 0.5)
unset title
unset label 99
unset bmargin
set margins screen 0.155, screen 0.985, screen 0.15, screen 0.93
set yrange [ROW_max + 0.6:-0.6]
left = ORDER_min - 0.25
right = (HIGH_max > ORDER_max ? HIGH_max : ORDER_max) + 0.1
set xrange [left:right]
set x2range [left:right]
set xtics 1 nomirror
set x2tics 1
set mxtics 2
set ytics scale 0
set grid xtics noytics
set errorbars 0
set label 98 'order  [-]' at screen 0.14, screen 0.105 right
set key at screen 0.57, screen 0.025 center bottom Left reverse vertical maxrows 1 samplen 2
plot data index 'groups' using (0):1:ytic(2) with points pt 0 lc rgb 'white' notitle, \
     data index 'orders' using 4:(row($1)):2:3:(row($1) - 0.42):(row($1) + 0.42) with boxxyerror \
         fs solid noborder lc rgb '#dcdcdc' notitle, \
     data index 'orders' using 4:1:5:6 with xerrorbars pt 0 lw 1 lc rgb '#555555' notitle, \
     data index 'orders' using ($7 == 1 ? $4 : NaN):1 with points pt 6 ps P lw 1.6 lc rgb BLUE notitle, \
     data index 'orders' using ($7 == 1 ? NaN : $4):1 with points pt 2 ps 1.6 * P lw 2.6 lc rgb RED notitle, \
     keyentry with boxes fs solid noborder lc rgb '#dcdcdc' title 'expected', \
     keyentry with points pt 6 ps P lw 1.6 lc rgb BLUE title 'measured', \
     keyentry with lines lw 1 lc rgb '#555555' title '95 % interval', \
     keyentry with points pt 2 ps 1.6 * P lw 2.6 lc rgb RED title 'measured, gate fails'

# One plot per scene.  Axes are logarithmic with labels at 1, 2 and 5, over more than two decades at powers of ten.
unset x2tics
unset label 98
set ytics scale 0.7
set mxtics 1
set mytics 1
set grid xtics ytics
set xlabel 'dx  [m]' offset 0, 0.4
set ylabel 'E1  [-]' offset 0.5
array COLOUR[8] = [BLUE, RED, GREEN, PURPLE, ORANGE, BLACK, SKY, RED]
array POINT[8] = [6, 4, 8, 12, 10, 1, 14, 2]
size_of_point(k) = (2.4 - 0.2 * k) * P
below(x) = floor(log10(x))
array LOW[6]; array NEAR[6]; array FAR[6]
do for [scene in scenes] {
    unset logscale
    set xrange [*:*]
    set yrange [*:*]
    methods = int(system(sprintf("grep -c '^# %s [0-9]$' '%s'", scene, data)))
    if (methods > 0) {
        dx_low = 1e99; dx_high = 0; error_low = 1e99; error_high = 0; out_of_fit = 0
        do for [p=1:6] { LOW[p] = 1e99 }
        do for [k=1:methods] {
            stats data index sprintf('%s %d', scene, k) using 1:2 name 'CURVE' nooutput
            stats data index sprintf('%s %d', scene, k) using 3:4 name 'FIT' nooutput
            out_of_fit = out_of_fit + (FIT_min_x < 1)
            dx_low = CURVE_min_x < dx_low ? CURVE_min_x : dx_low
            dx_high = CURVE_max_x > dx_high ? CURVE_max_x : dx_high
            error_low = CURVE_min_y < error_low ? CURVE_min_y : error_low
            error_high = CURVE_max_y > error_high ? CURVE_max_y : error_high
            p = int(FIT_max_y)
            if (p > 0 && p <= 6) { if (CURVE_min_y / CURVE_min_x ** p < LOW[p]) {
                LOW[p] = CURVE_min_y / CURVE_min_x ** p
                NEAR[p] = CURVE_min_x; FAR[p] = CURVE_max_x
            } }
        }
        # Reference slopes are lines at half the lowest error of their order.
        unset label
        unset arrow
        do for [p=1:6] { if (LOW[p] < 1e99) {
            set arrow from NEAR[p], 0.5 * LOW[p] * NEAR[p] ** p to FAR[p], 0.5 * LOW[p] * FAR[p] ** p \
                nohead lc rgb '#999999'
            error_low = 0.5 * LOW[p] * NEAR[p] ** p < error_low ? 0.5 * LOW[p] * NEAR[p] ** p : error_low
            set label sprintf('%d', p) at FAR[p], 0.5 * LOW[p] * FAR[p] ** p left offset 1, -0.3 \
                textcolor rgb '#555555'
        } }
        many = error_high / error_low > 100
        tics = ''
        do for [d=below(dx_low):below(dx_high)] { do for [m in '1 2 5'] {
            tics = tics . sprintf("'%g' %s.0e%d, ", m * 10.0 ** d, m, d)
        } }
        eval 'set xtics (' . tics . '1e99)'
        tics = ''
        do for [d=below(error_low):below(error_high)] { do for [m in error_high / error_low > 1e4 ? '1' : '1 2 5'] {
            text = m eq '1' ? sprintf('10^{%d}', d) : many ? '' : sprintf('%s·10^{%d}', m, d)
            tics = tics . sprintf("'%s' %s.0e%d, ", text, m, d)
        } }
        eval 'set ytics (' . tics . '1e99)'
        keys = (methods + 2 + (out_of_fit > 0)) / 2
        high = 440 + 24 * keys
        set terminal svg size 640, high enhanced dashed font 'DejaVu Sans,14' background rgb 'white' linewidth 1
        set output sprintf('%s/scene_%s.svg', to, scene)
        set title scene noenhanced font size_of(11)
        set margins screen 0.15, screen 0.96, screen 1 - 366.0 / high, screen 1 - 44.0 / high
        set key at screen 0.13, screen (24.0 * keys + 10) / high left top Left reverse vertical samplen 3 maxrows keys
        set xrange [dx_low * (dx_low / dx_high) ** 0.05:dx_high * (dx_high / dx_low) ** 0.08]
        set yrange [error_low * (error_low / error_high) ** 0.06:error_high * (error_high / error_low) ** 0.08]
        set logscale xy
        plot for [k=methods:1:-1] data index sprintf('%s %d', scene, k) using 1:2 with lines \
                 lc rgb COLOUR[k] lw (k == 1 ? 2.4 : 1.2) dt k notitle, \
             for [k=1:methods] data index sprintf('%s %d', scene, k) using 1:($3 == 1 ? $2 : NaN) with points \
                 lc rgb COLOUR[k] pt POINT[k] ps size_of_point(k) lw 1.6 notitle, \
             for [k=1:methods] data index sprintf('%s %d', scene, k) using 1:($3 == 1 ? NaN : $2) with points \
                 lc rgb GREY pt POINT[k] ps size_of_point(k) lw 1.6 notitle, \
             for [k=1:methods] data index sprintf('%s %d', scene, k) using (NaN):(NaN) with linespoints \
                 lc rgb COLOUR[k] lw (k == 1 ? 2.4 : 1.2) dt k pt POINT[k] ps size_of_point(k) \
                 title columnheader(2), \
             keyentry with lines lw 1 lc rgb '#999999' title 'reference slope', \
             for [k=1:(out_of_fit > 0)] data index sprintf('%s %d', scene, k) using (NaN):(NaN) with points \
                 lc rgb GREY pt POINT[k] ps size_of_point(k) lw 1.6 title 'left out of the fit'
    }
}
