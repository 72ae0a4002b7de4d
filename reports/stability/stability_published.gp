# Published over true limit: above 1 a run may blow up, below it steps are wasted.  Left over h/dx, for one diffusivity;
# right in the plane over kappa_y/kappa_x.
name = 'stability_published'
if (!exists("out")) out = 'reports/out'
data = sprintf('%s/stability_limits.csv', out)
wide = 1180; high = 600
load 'reports/figure/style.gp'
unset title
unset bmargin
kernels = 'cubic quartic wendland'
colour(k) = k == 1 ? RED : k == 2 ? BLUE : GREEN
mark(k) = k == 1 ? 7 : k == 2 ? 5 : 9
set multiplot layout 1,2 title 'Song 2018, eq. 34 (SO-SSPH): the published bound over the true one' noenhanced font size_of(13) \
    margins screen 0.065, 0.985, 0.17, 0.86 spacing screen 0.07, 0.05
set yrange [0.55:1.4]
set ytics 0.1
set ylabel 'published / true limit  [-]'
set object 1 rectangle from graph 0, first 1 to graph 1, graph 1 fc rgb RED fs transparent solid 0.10 noborder behind
set label 1 'a run at the published bound blows up' at graph 0.97, first 1.03 right noenhanced font size_of(10)
set label 2 'steps are wasted' at graph 0.97, first 0.965 right noenhanced font size_of(10)
set title 'κ_y = κ_x' enhanced font size_of(11) offset 0, -0.6
set xlabel 'h/dx  [-]'
set xrange [0.5:3]
set key top right noenhanced maxrows 3 width -1
plot for [d = 1:2] for [k = 1:3] data index sprintf('so_ssph %s %dD', word(kernels, k), d) using 1:($2/$3) \
    with linespoints lc rgb colour(k) lw 1.4 dt d pt mark(k) ps 0.7 * P pi 12 title sprintf('%s, %dD', word(kernels, k), d)
unset label 99
set title 'in the plane, h/dx = 1.1' enhanced font size_of(11) offset 0, -0.6
set xlabel 'κ_y / κ_x  [-]' enhanced
set xrange [0:1]
unset ylabel
set label 2 at graph 0.03, first 0.965 left
set label 1 at graph 0.97, first 1.03 right
plot for [k = 1:3] data index 'unequal '.word(kernels, k) using 1:($2/$3) with linespoints lc rgb colour(k) lw 1.4 dt k*k-2*k+2 \
    pt mark(k) ps 0.7 * P pi 2 title word(kernels, k)
unset multiplot
