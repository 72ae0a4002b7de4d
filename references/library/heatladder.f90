! SPDX-License-Identifier: GPL-3.0-or-later
! libheatladder from Fortran: the functions of heatladder.h, with its names, types and statuses (see there).  Compile
! this file before your own.  A C string ends with c_null_char; an optional array is c_null_ptr or c_loc(array).
!
! hl_problem and hl_message take and return Fortran strings.
module heatladder
    use, intrinsic :: iso_c_binding
    implicit none

    integer(c_int), parameter :: HL_OK = 0, HL_INPUT = 2, HL_NUMERICAL = 3, HL_NOT_APPLICABLE = 5, HL_UNSTABLE = 6, &
        HL_MEMORY = 7

    type, bind(c) :: hl_error
        integer(c_int) :: status = HL_OK
        character(kind=c_char) :: text(480) = c_null_char
    end type

    type, bind(c) :: hl_setting
        type(c_ptr) :: name
        real(c_double) :: value
    end type

    type, bind(c) :: hl_box
        integer(c_int) :: dim
        real(c_double) :: lo(3), hi(3), hole, radius, t_end
    end type

    type, bind(c) :: hl_points
        integer(c_size_t) :: n = 0
        type(c_ptr) :: x = c_null_ptr, y = c_null_ptr, z = c_null_ptr
        type(c_ptr) :: dx = c_null_ptr, dy = c_null_ptr, dz = c_null_ptr
    end type

    type, bind(c) :: hl_options
        real(c_double) :: dx = 0, dt = 0, fourier = 0, h = 0, jitter = 0
        integer(c_int) :: order = 0
        integer(c_long) :: seed = 0
        type(c_ptr) :: kernel = c_null_ptr, stepper = c_null_ptr, layout = c_null_ptr, sampling = c_null_ptr, &
            walls = c_null_ptr, mean = c_null_ptr
    end type

    type, bind(c) :: hl_field
        integer(c_int) :: dim = 0
        integer(c_size_t) :: n = 0
        type(c_ptr) :: x = c_null_ptr, y = c_null_ptr, T = c_null_ptr, z = c_null_ptr
        real(c_double) :: time = 0, dt = 0
        integer(c_long_long) :: steps = 0
    end type

    interface
        type(c_ptr) function hl_problem_create(scene, settings, why) bind(c)
            import
            character(kind=c_char), intent(in) :: scene(*)
            type(hl_setting), intent(in) :: settings(*)
            type(hl_error), intent(out) :: why
        end function

        subroutine hl_problem_free(problem) bind(c)
            import
            type(c_ptr), value :: problem
        end subroutine

        subroutine hl_problem_box(problem, box) bind(c)
            import
            type(c_ptr), value :: problem
            type(hl_box), intent(out) :: box
        end subroutine

        ! T(n) and bound(n); y and z are c_null_ptr on a rod, z in the plane.
        integer(c_int) function hl_exact_at(problem, time, n, x, y, z, T, bound, why) bind(c)
            import
            type(c_ptr), value :: problem, y, z
            real(c_double), value :: time
            integer(c_size_t), value :: n
            real(c_double), intent(in) :: x(*)
            real(c_double), intent(out) :: T(*), bound(*)
            type(hl_error), intent(out) :: why
        end function

        ! values(n, count), count from hl_reference_values.
        integer(c_int) function hl_reference(problem, what, time, points, values, why) bind(c)
            import
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: what(*)
            real(c_double), value :: time
            type(hl_points), intent(in) :: points
            real(c_double), intent(out) :: values(*)
            type(hl_error), intent(out) :: why
        end function

        integer(c_int) function hl_reference_values(problem, what, names, size, why) bind(c)
            import
            type(c_ptr), value :: problem, names
            character(kind=c_char), intent(in) :: what(*)
            integer(c_size_t), value :: size
            type(hl_error), intent(out) :: why
        end function

        integer(c_int) function hl_solve(problem, method, options, field, why) bind(c)
            import
            type(c_ptr), value :: problem
            character(kind=c_char), intent(in) :: method(*)
            type(hl_options), intent(in) :: options
            type(hl_field), intent(out) :: field
            type(hl_error), intent(out) :: why
        end function

        subroutine hl_field_free(field) bind(c)
            import
            type(hl_field), intent(inout) :: field
        end subroutine
    end interface

contains

    ! The scene with values(i) for its parameter names(i); c_null_ptr with why filled where one is refused.
    type(c_ptr) function hl_problem(scene, names, values, why) result(problem)
        character(*), intent(in) :: scene, names(:)
        real(c_double), intent(in) :: values(:)
        type(hl_error), intent(out) :: why
        character(kind=c_char), target :: text(len(names) + 1, size(names))
        type(hl_setting) :: settings(size(names) + 1)
        integer :: i, k
        text = c_null_char
        do i = 1, size(names)
            do k = 1, len_trim(names(i))
                text(k, i) = names(i)(k:k)
            end do
            settings(i) = hl_setting(c_loc(text(1, i)), values(i))
        end do
        settings(size(settings)) = hl_setting(c_null_ptr, 0)
        problem = hl_problem_create(trim(scene)//c_null_char, settings, why)
    end function

    ! The text of an error.
    function hl_message(why) result(message)
        type(hl_error), intent(in) :: why
        character(:), allocatable :: message
        integer :: i
        message = ''
        do i = 1, size(why%text)
            if (why%text(i) == c_null_char) exit
            message = message//why%text(i)
        end do
    end function
end module
