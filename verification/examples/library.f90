! SPDX-License-Identifier: GPL-3.0-or-later
! An explicit code that verifies itself on a rod with held ends, by libheatladder:
!
!     gfortran heatladder.f90 library.f90 $(pkg-config --libs heatladder) && ./a.out
program library
    use heatladder
    implicit none
    integer, parameter :: n = 80
    type(hl_error) :: why
    type(hl_box) :: box
    type(c_ptr) :: problem
    real(c_double), target :: x(n), dx(n)
    real(c_double) :: data(n, 3), T(0:n + 1), exact(n), bound(n), F
    integer :: i, steps
    problem = hl_problem('rod-step', ['kappa'], [0.02d0], why)
    if (why%status /= HL_OK) stop 'no problem'
    call hl_problem_box(problem, box)
    dx = (box%hi(1) - box%lo(1)) / n
    x = [(box%lo(1) + (i - 0.5d0) * dx(i), i = 1, n)]
    if (hl_reference(problem, 'initial_mean,k_x,rho_c'//c_null_char, 0d0, &
        hl_points(n=n, x=c_loc(x), dx=c_loc(dx)), data, why) /= HL_OK) stop 'no data'
    T(1:n) = data(:, 1)
    steps = ceiling(4 * box%t_end * data(1, 2) / data(1, 3) / dx(1)**2)
    F = box%t_end / steps * data(1, 2) / data(1, 3) / dx(1)**2
    do i = 1, steps
        T(0) = -T(1); T(n + 1) = -T(n) ! the ends are held at 0 K, half a cell away
        T(1:n) = T(1:n) + F * (T(0:n - 1) - 2 * T(1:n) + T(2:n + 1))
    end do
    if (hl_exact_at(problem, box%t_end, int(n, c_size_t), x, c_null_ptr, c_null_ptr, exact, bound, why) /= HL_OK) &
        stop 'no solution'
    print '(a, i0, a, es8.1, a)', 'cells: ', n, ', largest error ', maxval(abs(T(1:n) - exact)), ' K'
    call hl_problem_free(problem)
end program
