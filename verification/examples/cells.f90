! SPDX-License-Identifier: GPL-3.0-or-later
! cells CASE OUT: finite volumes on a grid of cells, explicit Euler.
!
!     rho_c dT/dt = source + sum over the faces of a cell of conductance (T_beyond - T)
!
! The case file gives the grid and the end time.  `heatladder reference` gives all else (start,
! source, coefficients, walls) at the centres of the cells and of the faces on the sides.
! $HEATLADDER is the path of that program.
program cells
    implicit none
    integer, parameter :: dp = kind(1d0)
    ! Kinds of walls in the answers of `reference`; 1: held.
    integer, parameter :: flux_wall = 2, cooled_wall = 3
    character(4096) :: case_file, answer_file, oracle
    integer :: dim = 1, n(2) = 1, steps, step, unit
    integer :: first_row, last_row ! of points along y: a rod is one row without a frame
    logical :: changing = .false., tensor = .false.
    real(dp) :: lo(2) = 0, hi(2) = 1, width(2), t_end, begun, ended
    ! Points (0:n(1) + 1, 0:n(2) + 1): cells from 1 to n, in a frame of the centres of the faces on
    ! the sides.
    real(dp), allocatable :: x(:, :, :), T(:, :), source(:, :), rho_c(:, :), k_xy(:, :)
    ! First index: the axis.
    real(dp), allocatable :: k(:, :, :), kind_of(:, :, :), value(:, :, :), b(:, :, :)
    ! Of cells: the conductances to x low, x high, y low, y high and what walls of given flux add.
    real(dp), allocatable :: conductance(:, :, :), flux(:, :)

    if (command_argument_count() /= 2) error stop 'cells: two arguments are needed: CASE OUT'
    call get_command_argument(1, case_file)
    call get_command_argument(2, answer_file)
    call read_case()
    call make_points()
    call ask_scene()
    call make_faces()
    call run()
    call write_answer()

contains

    subroutine read_case()
        character(4096) :: line, key, text
        integer :: equals, status
        open (newunit=unit, file=case_file, status='old', action='read', iostat=status)
        if (status /= 0) error stop 'cells: the case cannot be opened'
        do
            read (unit, '(a)', iostat=status) line
            if (status /= 0) exit
            equals = index(line, ' = ')
            key = line(:equals)
            text = line(equals + 3:)
            select case (key)
            case ('dim'); read (text, *) dim
                if (dim == 3) stop 77 ! rods and rectangles alone
            case ('cells'); read (text, *) n(:dim)
            case ('lo'); read (text, *) lo(:dim)
            case ('hi'); read (text, *) hi(:dim)
            case ('t_end'); read (text, *) t_end
            case ('source'); changing = text == 'changing'
            case ('oracle'); oracle = text
            case ('conductivity'); tensor = .true. ! that varies, between held walls
            case ('shape', 'walls', 'k_law', 'contact_resistance'); stop 77 ! boxes with steady walls and k
            end select
            if (text == 'periodic') stop 77 ! with walls alone
        end do
        close (unit)
        width = (hi - lo)/n
        first_row = 2 - dim
        last_row = n(2) + dim - 1
    end subroutine

    subroutine make_points()
        integer :: i, j
        allocate (x(2, 0:n(1) + 1, 0:n(2) + 1))
        do j = 0, n(2) + 1
            do i = 0, n(1) + 1
                x(:, i, j) = min(max(lo + ([i, j] - 0.5_dp)*width, lo), hi)
            end do
        end do
        open (newunit=unit, file=trim(answer_file)//'.points')
        write (unit, '(a)') 'x,y,dx,dy'
        do j = first_row, last_row
            do i = 0, n(1) + 1
                write (unit, '(3(es25.17e3, ","), es25.17e3)') x(:, i, j), width
            end do
        end do
        close (unit)
    end subroutine

    ! Asks `reference` at the points and opens its answer after the header.
    subroutine ask(times, what)
        character(*), intent(in) :: times, what
        character(4096) :: header
        integer :: status
        call execute_command_line('${HEATLADDER:-heatladder} reference '//trim(oracle)//" --points '"// &
            trim(answer_file)//".points' --time "//times//' --what '//what// &
            " >'"//trim(answer_file)//".reference'", &
            exitstat=status)
        if (status /= 0) error stop 'cells: no answer from heatladder reference'
        open (newunit=unit, file=trim(answer_file)//'.reference', action='read')
        read (unit, '(a)') header
    end subroutine

    subroutine ask_scene()
        integer :: i, j
        real(dp) :: place(dim), wall(4, dim)
        allocate (T(0:n(1) + 1, 0:n(2) + 1), source(0:n(1) + 1, 0:n(2) + 1))
        allocate (rho_c(0:n(1) + 1, 0:n(2) + 1), k_xy(0:n(1) + 1, 0:n(2) + 1))
        allocate (k(2, 0:n(1) + 1, 0:n(2) + 1), kind_of(2, 0:n(1) + 1, 0:n(2) + 1))
        allocate (value(2, 0:n(1) + 1, 0:n(2) + 1), b(2, 0:n(1) + 1, 0:n(2) + 1))
        T = 0
        if (dim == 1) call ask('0', 'initial_mean,source,rho_c,k_x,wall_x')
        if (dim == 2) call ask('0', 'initial_mean,source,rho_c,k_x,wall_x,k_y,wall_y'// &
            trim(merge(',k_xy', '     ', tensor)))
        do j = first_row, last_row
            do i = 0, n(1) + 1
                if (tensor) read (unit, *) place, T(i, j), source(i, j), rho_c(i, j), wall, k_xy(i, j)
                if (.not. tensor) read (unit, *) place, T(i, j), source(i, j), rho_c(i, j), wall
                k(:dim, i, j) = wall(1, :)
                kind_of(:dim, i, j) = wall(2, :)
                value(:dim, i, j) = wall(3, :)
                b(:dim, i, j) = wall(4, :)
            end do
        end do
        close (unit)
    end subroutine

    ! Half cells in series, or a half cell and what the wall resists.
    subroutine make_faces()
        integer :: i, j, d, face, e(2)
        real(dp) :: resistance
        allocate (conductance(4, n(1), n(2)), flux(n(1), n(2)))
        conductance = 0
        flux = 0
        do j = 1, n(2)
            do i = 1, n(1)
                do face = 1, 2*dim
                    d = (face + 1)/2
                    e = [i, j] ! the point beyond the face
                    e(d) = e(d) + merge(-1, 1, mod(face, 2) == 1)
                    resistance = width(d)/(2*k(d, i, j))
                    if (e(d) >= 1 .and. e(d) <= n(d)) then
                        resistance = resistance + width(d)/(2*k(d, e(1), e(2)))
                    else
                        T(e(1), e(2)) = value(d, e(1), e(2))
                        if (nint(kind_of(d, e(1), e(2))) == flux_wall) then
                            flux(i, j) = flux(i, j) + value(d, e(1), e(2))/width(d)
                            cycle
                        end if
                        if (nint(kind_of(d, e(1), e(2))) == cooled_wall) &
                            resistance = resistance + 1/b(d, e(1), e(2))
                    end if
                    if (tensor) then ! K of the face, the mean of both cells
                        resistance = 2*width(d)/(k(d, i, j) + k(d, e(1), e(2)))
                        if (e(d) < 1 .or. e(d) > n(d)) resistance = width(d)/(2*k(d, e(1), e(2)))
                    end if
                    conductance(face, i, j) = 1/(resistance*width(d))
                end do
            end do
        end do
    end subroutine

    ! A source that changes in time is asked for at the start of every step.
    subroutine run()
        character(64) :: times
        integer :: i, j, d
        real(dp) :: fastest, dt, now, place(dim)
        fastest = 0
        do j = 1, n(2)
            do i = 1, n(1)
                fastest = max(fastest, sum([(k(d, i, j)/(width(d)**2*rho_c(i, j)), d=1, dim)]))
            end do
        end do
        steps = ceiling(t_end*fastest/0.25_dp)
        dt = t_end/steps
        write (times, '(a, es23.17, a, i0)') '0:', t_end, ':', steps + 1
        if (changing) call ask(trim(times), 'source')
        call cpu_time(begun)
        do step = 1, steps
            if (changing) &
                read (unit, *) ((now, place, source(i, j), i=0, n(1) + 1), j=first_row, last_row)
            call step_by(dt)
        end do
        call cpu_time(ended)
        if (changing) close (unit)
    end subroutine

    ! The fluxes of k_xy, with the mean derivative of the two cells of a face; beyond a held wall T is
    ! 2 T_wall - T, and through it none flows, as T is uniform along it.
    function cross_rate() result(rate)
        real(dp) :: rate(n(1), n(2)), U(0:n(1) + 1, 0:n(2) + 1), g(n(1), n(2)), q(n(1), n(2))
        U = T
        U(0, :) = 2*T(0, :) - T(1, :)
        U(n(1) + 1, :) = 2*T(n(1) + 1, :) - T(n(1), :)
        U(:, 0) = 2*T(:, 0) - T(:, 1)
        U(:, n(2) + 1) = 2*T(:, n(2) + 1) - T(:, n(2))
        rate = 0
        associate (m => n(1), l => n(2), c => k_xy(1:n(1), 1:n(2)))
            g = (U(1:m, 2:) - U(1:m, :l - 1))/(2*width(2))
            q(:m - 1, :) = (c(:m - 1, :) + c(2:, :))*(g(:m - 1, :) + g(2:, :))/(4*width(1))
            rate(:m - 1, :) = rate(:m - 1, :) + q(:m - 1, :)
            rate(2:, :) = rate(2:, :) - q(:m - 1, :)
            g = (U(2:, 1:l) - U(:m - 1, 1:l))/(2*width(1))
            q(:, :l - 1) = (c(:, :l - 1) + c(:, 2:))*(g(:, :l - 1) + g(:, 2:))/(4*width(2))
            rate(:, :l - 1) = rate(:, :l - 1) + q(:, :l - 1)
            rate(:, 2:) = rate(:, 2:) - q(:, :l - 1)
        end associate
    end function

    subroutine step_by(dt)
        real(dp), intent(in) :: dt
        integer :: i, j
        real(dp) :: rate(n(1), n(2))
        do j = 1, n(2)
            do i = 1, n(1)
                rate(i, j) = source(i, j) + flux(i, j) + &
                    conductance(1, i, j)*(T(i - 1, j) - T(i, j)) + &
                    conductance(2, i, j)*(T(i + 1, j) - T(i, j)) + &
                    conductance(3, i, j)*(T(i, j - 1) - T(i, j)) + &
                    conductance(4, i, j)*(T(i, j + 1) - T(i, j))
            end do
        end do
        if (tensor) rate = rate + cross_rate()
        T(1:n(1), 1:n(2)) = T(1:n(1), 1:n(2)) + dt*rate/rho_c(1:n(1), 1:n(2))
    end subroutine

    subroutine write_answer()
        integer :: i, j
        open (newunit=unit, file=answer_file)
        write (unit, '(a, i0)') '# steps = ', steps
        write (unit, '(a, es9.3)') '# seconds = ', ended - begun
        if (dim == 1) write (unit, '(a)') 'x T'
        if (dim == 2) write (unit, '(a)') 'x y T'
        do j = 1, n(2)
            do i = 1, n(1)
                write (unit, '(3es26.17e3)') x(:dim, i, j), T(i, j)
            end do
        end do
        close (unit)
    end subroutine
end program
