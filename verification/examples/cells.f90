! cells CASE OUT: finite volumes on a grid of cells, explicit Euler.  All that the case does not tell, `heatladder
! reference` does, at the centres of the cells and of the faces on the sides; $HEATLADDER is that program.
program cells
    implicit none; logical :: changing = .false.
    character(4096) :: line, argument(3) ! case, answer, a question
    integer :: dim = 1, n(2) = 1, at, status, i, j, d, s, e(2), first, last
    double precision :: lo(2) = 0, hi(2) = 1, h(2), t_end, speed, fastest = 0, beyond, q(0:3)
    double precision, allocatable :: p(:, :, :), T(:, :), x(:, :, :), g(:, :, :)
    call get_command_argument(1, argument(1)); call get_command_argument(2, argument(2))
    open (10, file=argument(1), status='old', iostat=status); if (status /= 0) error stop 'cells CASE OUT'
    do while (status >= 0)
        read (10, '(a)', iostat=status) line
        at = index(line, ' = ')
        if (line(:at) == 'dim') read (line(at + 3:), *) dim
        if (line(:at) == 't_end') read (line(at + 3:), *) t_end
        if (line(:at) == 'lo') read (line(at + 3:), *) lo(:dim)
        if (line(:at) == 'hi') read (line(at + 3:), *) hi(:dim)
        if (line(:at) == 'cells') read (line(at + 3:), *) n(:dim)
        if (line(:at) == 'oracle') argument(3) = '${HEATLADDER:-heatladder} reference '//line(at + 3:)
        if (line(:at) == 'source') changing = line(at + 3:) == 'changing'
    end do
    ! Cells 1 to n along each axis, framed by the faces on the sides; a rod is one row, without a frame in y.
    h = (hi - lo)/n; first = 2 - dim; last = n(2) + dim - 1; i = n(1) + 1; j = n(2)
    allocate (p(3 + 4*dim, 0:i, first:last), x(2, 0:i, first:last), T(0:i, 0:j + 1), g(4, n(1), j))
    forall (i=0:n(1) + 1, j=first:last) x(:, i, j) = min(max(lo + ([i, j] - 0.5d0)*h, lo), hi)
    open (11, file=trim(argument(2))//'.points'); write (11, '(a)') 'x,y,dx,dy'
    write (11, '(3(es25.17e3, ","), es25.17e3)') ((x(:, i, j), h, i=0, n(1) + 1), j=first, last); close (11)
    argument(3) = trim(argument(3))//' --points "'//trim(argument(2))//'.points" >"'//trim(argument(2))//'.told"'
    line = ' --time 0 --what initial_heat,source,rho_c,k_x,wall_x'//merge(',k_y,wall_y', '           ', dim == 2)
    call execute_command_line(trim(argument(3))//line, exitstat=status)
    if (status /= 0) error stop 'cells: no answer from heatladder reference'
    open (12, file=trim(argument(2))//'.told'); read (12, '(a)') line
    read (12, *) ((q(:dim - 1), p(:, i, j), i=0, n(1) + 1), j=first, last)
    T = 0; T(:, first:last) = p(1, :, :); g = 0; p(1, :, :) = 0 ! from here on what flows in
    ! Conductances of the faces, over the cell's width: half cells in series, and at a side Robin's coefficient.
    do j = 1, n(2); do i = 1, n(1); speed = 0
        do s = 0, 2*dim - 1
            d = s/2 + 1; e = [i, j]; e(d) = e(d) + 2*mod(s, 2) - 1
            q = p(4*d:4*d + 3, e(1), e(2)); beyond = h(d)/(2*q(0)) ! k, kind, value, b
            if (e(d) < 1 .or. e(d) > n(d)) then
                T(e(1), e(2)) = q(2); beyond = merge(1/max(q(3), tiny(1d0)), 0d0, q(1) == 3)
                if (q(1) == 2) p(1, i, j) = p(1, i, j) + q(2)/h(d)
                if (q(1) == 2) beyond = huge(1d0) ! nothing but that flux
            end if
            g(s + 1, i, j) = 1/(h(d)/(2*p(4*d, i, j)) + beyond)/h(d)
            speed = speed + p(4*d, i, j)/h(d)**2/p(3, i, j)/2; fastest = max(fastest, speed)
    end do; end do; end do
    at = ceiling(t_end*fastest/0.25d0); i = n(1); j = n(2); close (12)
    write (line, '(a, es23.17, a, i0, a)') ' --time 0:', t_end, ':', at + 1, ' --what source' ! of all steps
    if (changing) call execute_command_line(trim(argument(3))//line)
    open (12, file=trim(argument(2))//'.told'); read (12, '(a)') line; do s = 1, at
        if (changing) read (12, *) ((q(:dim), p(2, d, status), d=0, i + 1), status=first, last)
        T(1:i, 1:j) = T(1:i, 1:j) + t_end/at/p(3, 1:i, 1:j)*(p(1, 1:i, 1:j) + p(2, 1:i, 1:j) + &
            g(1, :, :)*(T(:i - 1, 1:j) - T(1:i, 1:j)) + g(2, :, :)*(T(2:, 1:j) - T(1:i, 1:j)) + &
            g(3, :, :)*(T(1:i, :j - 1) - T(1:i, 1:j)) + g(4, :, :)*(T(1:i, 2:) - T(1:i, 1:j)))
    end do
    open (13, file=argument(2)); write (13, '(a, i0/a)') '# steps = ', at, merge('x y T', 'x T  ', dim == 2)
    write (13, merge('(3es26.17e3)', '(2es26.17e3)', dim == 2)) ((x(:dim, i, j), T(i, j), i=1, n(1)), j=1, n(2))
end program
