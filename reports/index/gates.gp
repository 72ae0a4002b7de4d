# Each order in the band of its own gate, a row a scene; then the errors of the methods against dx, one plot per scene.
name = 'gates'
wide = 640; high = 680
keys = 2
load 'reports/figure/style.gp'
scenes = ''
stats data index 'groups' using (scenes = scenes . strcol(2) . ' ', $1) name 'ROW' nooutput
# The place in a band: -1 at its lower end, 1 at its upper one.
in_band(order) = (2 * order - column(2) - column(3)) / (column(3) - column(2))
place(order) = in_band(order) < -2.2 ? -2.2 : in_band(order) > 2.2 ? 2.2 : in_band(order)
expected(low, high) = floor((low + high) / 2 + 0.5)
set title heading.', a row a scene' font size_of(11)
unset label 99
set margins screen 0.265, screen 0.975, screen 0.185, screen 0.925
set yrange [ROW_max + 0.6:-0.6]
set xrange [-2.3:2.3]
set xtics ('below' -2, 'lowest' -1, 'middle' 0, 'highest' 1, 'above' 2) nomirror
eval sprintf("set ytics scale 0 font '%s'", size_of(9))
set grid noxtics noytics
set errorbars 0
set xlabel 'order measured, in the band of the gate  [half widths]' offset 0, 0.3
set object 1 rectangle from first -1, graph 0 to first 1, graph 1 behind fillcolor rgb '#e6e6e6' fillstyle solid noborder
set key at screen 0.5, screen 0.088 center top vertical maxrows 2 Left reverse samplen 1.5 width 2
array MARK[4] = [8, 6, 2, 4]
array INK[4] = [RED, BLUE, GREEN, PURPLE]
array NAME[4] = ['order 1', 'order 2', '', 'order 4']
plot data index 'groups' using (0):1:ytic(2) with points pt 0 lc rgb 'white' notitle, \
     data index 'orders' using (place($4)):1:(place($5)):(place($6)) with xerrorbars pt 0 lw 0.8 lc rgb '#888888' notitle, \
     for [p in '1 2 4'] data index 'orders' using (expected($2, $3) == int(p) && $7 == 1 ? place($4) : NaN):1 \
         with points pt MARK[int(p)] ps 0.75 * P lw 1.3 lc rgb INK[int(p)] notitle, \
     data index 'orders' using ($7 == 1 ? NaN : place($4)):1 with points pt 2 ps 1.6 * P lw 2.6 lc rgb RED notitle, \
     for [p in '1 2 4'] keyentry with points pt MARK[int(p)] ps P lw 1.3 lc rgb INK[int(p)] title NAME[int(p)], \
     keyentry with lines lw 0.8 lc rgb '#888888' title '95 % interval', \
     keyentry with boxes fs solid noborder lc rgb '#e6e6e6' title 'passes', \
     keyentry with points pt 2 ps 1.6 * P lw 2.6 lc rgb RED title 'fails'

# One plot per scene.  Axes are logarithmic with labels at 1, 2 and 5, over more than two decades at powers of ten.
unset object 1
set ytics scale 0.7
set mxtics 1
set mytics 1
set grid xtics ytics
eval sprintf("set ytics font '%s'", size_of(10.5))
set xlabel 'dx  [m]' offset 0, 0.4
set ylabel 'E1  [-]' offset 1.5
array COLOUR[8] = [BLUE, RED, GREEN, PURPLE, ORANGE, BLACK, SKY, RED]
array POINT[8] = [6, 4, 8, 12, 10, 1, 14, 2]
size_of_point(k) = (2.4 - 0.2 * k) * P
below(x) = floor(log10(x))
array ORDER[8]; array LOW[8]; array NEAR[8]; array FAR[8]
do for [scene in scenes] {
    unset logscale
    set xrange [*:*]
    set yrange [*:*]
    methods = int(system(sprintf("grep -c '^# %s [0-9]$' '%s'", scene, data)))
    if (methods > 0) {
        dx_low = 1e99; dx_high = 0; error_low = 1e99; error_high = 0; out_of_fit = 0
        orders = 0
        do for [k=1:methods] {
            stats data index sprintf('%s %d', scene, k) using 1:2 name 'CURVE' nooutput
            stats data index sprintf('%s %d', scene, k) using 3:4 name 'FIT' nooutput
            out_of_fit = out_of_fit + (FIT_min_x < 1)
            dx_low = CURVE_min_x < dx_low ? CURVE_min_x : dx_low
            dx_high = CURVE_max_x > dx_high ? CURVE_max_x : dx_high
            error_low = CURVE_min_y < error_low ? CURVE_min_y : error_low
            error_high = CURVE_max_y > error_high ? CURVE_max_y : error_high
            p = FIT_max_y
            at = 0
            do for [q=1:orders] { if (ORDER[q] == p) { at = q } }
            if (at == 0) { orders = orders + 1; at = orders; ORDER[at] = p; LOW[at] = 1e99 }
            if (CURVE_min_y / CURVE_min_x ** p < LOW[at]) {
                LOW[at] = CURVE_min_y / CURVE_min_x ** p
                NEAR[at] = CURVE_min_x; FAR[at] = CURVE_max_x
            }
        }
        # Reference slopes are lines at half the lowest error of their order.
        unset label
        unset arrow
        do for [q=1:orders] {
            p = ORDER[q]
            set arrow from NEAR[q], 0.5 * LOW[q] * NEAR[q] ** p to FAR[q], 0.5 * LOW[q] * FAR[q] ** p \
                nohead lc rgb '#999999'
            error_low = 0.5 * LOW[q] * NEAR[q] ** p < error_low ? 0.5 * LOW[q] * NEAR[q] ** p : error_low
            # A long label is below the end of its line, where the frame does not cut it.
            long = strlen(sprintf('%g', p)) > 1
            aside = long ? -1.5 : 1
            above = long ? -1.1 : -0.3
            set label sprintf('%g', p) at FAR[q], 0.5 * LOW[q] * FAR[q] ** p left offset aside, above \
                textcolor rgb '#555555'
        }
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
        # One column of the key where names are long.
        longest = int(system(sprintf("awk -F, '/^# %s [0-9]$/ { getline; if (length($2) > n) n = length($2) } END { print n + 0 }' '%s'", scene, data)))
        keys = longest > 30 ? methods + 1 + (out_of_fit > 0) : (methods + 2 + (out_of_fit > 0)) / 2
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
