# How true the frames are along the walk, and what the images left uncovered.  Lines break where no image is shown.
set terminal svg size 900,820 dynamic font 'sans-serif,13' background 'white' linewidth 1
set multiplot layout 3,1 title title noenhanced margins 0.1,0.86,0.09,0.94 spacing 0.06
unset title
set ylabel 'PSNR in the portals [dB]'
set yrange [0:50]
plot for [m in methods] data using (only(m)):(measured('psnr_portals_db')) with lines lw 1.2 lc rgb color(m) title m
unset key
set ylabel 'SSIM in the portals'
set yrange [0:1]
plot for [m in methods] data using (only(m)):(measured('ssim_portals')) with lines lw 1.2 lc rgb color(m)
set xlabel 'frame'
set ylabel 'uncovered [% of the frame]'
set yrange [0:*]
plot for [m in methods] data using (only(m)):(measured('uncovered_percent')) with lines lw 1.2 lc rgb color(m)
unset multiplot
