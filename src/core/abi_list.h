/* abi_list.h -- every public struct with its members, every enumeration with its constants. Made by
 * tools/abi.py --update of include/taut; do not edit. */
#ifndef TAUT_CORE_ABI_LIST_H
#define TAUT_CORE_ABI_LIST_H

/* clang-format off */

#define TAUT_ABI_MEMBERS_taut_abi_enum(X) \
    X(taut_abi_enum, name, "const char *") \
    X(taut_abi_enum, size, "size_t") \
    X(taut_abi_enum, count, "size_t") \
    X(taut_abi_enum, values, "const taut_abi_value *")

#define TAUT_ABI_MEMBERS_taut_abi_member(X) \
    X(taut_abi_member, name, "const char *") \
    X(taut_abi_member, type, "const char *") \
    X(taut_abi_member, offset, "size_t") \
    X(taut_abi_member, size, "size_t")

#define TAUT_ABI_MEMBERS_taut_abi_struct(X) \
    X(taut_abi_struct, name, "const char *") \
    X(taut_abi_struct, size, "size_t") \
    X(taut_abi_struct, count, "size_t") \
    X(taut_abi_struct, members, "const taut_abi_member *")

#define TAUT_ABI_MEMBERS_taut_abi_table(X) \
    X(taut_abi_table, number, "int") \
    X(taut_abi_table, pointer_size, "int") \
    X(taut_abi_table, size_size, "size_t") \
    X(taut_abi_table, struct_count, "size_t") \
    X(taut_abi_table, structs, "const taut_abi_struct *") \
    X(taut_abi_table, enum_count, "size_t") \
    X(taut_abi_table, enums, "const taut_abi_enum *")

#define TAUT_ABI_MEMBERS_taut_abi_value(X) \
    X(taut_abi_value, constant, "const char *") \
    X(taut_abi_value, word, "const char *") \
    X(taut_abi_value, value, "int")

#define TAUT_ABI_MEMBERS_taut_asymptotic_corners(X) \
    X(taut_asymptotic_corners, degree, "int") \
    X(taut_asymptotic_corners, points, "double[4][3]") \
    X(taut_asymptotic_corners, edges, "taut_asymptotic_edge[4]") \
    X(taut_asymptotic_corners, has_branch, "int") \
    X(taut_asymptotic_corners, branch, "int[4]")

#define TAUT_ABI_MEMBERS_taut_asymptotic_edge(X) \
    X(taut_asymptotic_edge, legs, "double[2][3]") \
    X(taut_asymptotic_edge, curvature, "double[2]") \
    X(taut_asymptotic_edge, weights, "double[4]")

#define TAUT_ABI_MEMBERS_taut_asymptotic_problem(X) \
    X(taut_asymptotic_problem, given, "taut_asymptotic_given") \
    X(taut_asymptotic_problem, corners, "taut_asymptotic_corners") \
    X(taut_asymptotic_problem, curves, "const taut_curve *[4]") \
    X(taut_asymptotic_problem, surface, "taut_asymptotic_surface") \
    X(taut_asymptotic_problem, report_singular, "int") \
    X(taut_asymptotic_problem, free_all, "int")

#define TAUT_ABI_MEMBERS_taut_basis_spec(X) \
    X(taut_basis_spec, type, "const char *") \
    X(taut_basis_spec, degree, "int") \
    X(taut_basis_spec, count, "int") \
    X(taut_basis_spec, knot_count, "int") \
    X(taut_basis_spec, knots, "const double *") \
    X(taut_basis_spec, alpha, "double") \
    X(taut_basis_spec, beta, "double") \
    X(taut_basis_spec, gamma, "double") \
    X(taut_basis_spec, segments, "int") \
    X(taut_basis_spec, has_range, "int") \
    X(taut_basis_spec, range, "double[2]")

#define TAUT_ABI_MEMBERS_taut_biharmonic_neighbour(X) \
    X(taut_biharmonic_neighbour, surface, "const taut_surface *") \
    X(taut_biharmonic_neighbour, edge, "taut_edge") \
    X(taut_biharmonic_neighbour, width, "double") \
    X(taut_biharmonic_neighbour, contact, "int") \
    X(taut_biharmonic_neighbour, allow_ill_conditioned, "int")

#define TAUT_ABI_MEMBERS_taut_biharmonic_problem(X) \
    X(taut_biharmonic_problem, given, "taut_biharmonic_given") \
    X(taut_biharmonic_problem, rows, "taut_biharmonic_rows") \
    X(taut_biharmonic_problem, neighbour, "taut_biharmonic_neighbour")

#define TAUT_ABI_MEMBERS_taut_biharmonic_rows(X) \
    X(taut_biharmonic_rows, name, "const char *") \
    X(taut_biharmonic_rows, u, "const taut_basis *") \
    X(taut_biharmonic_rows, v, "const taut_basis *") \
    X(taut_biharmonic_rows, points, "const double *") \
    X(taut_biharmonic_rows, known, "const unsigned char *")

#define TAUT_ABI_MEMBERS_taut_bonnet_problem(X) \
    X(taut_bonnet_problem, lambda, "double[2]") \
    X(taut_bonnet_problem, frames, "int") \
    X(taut_bonnet_problem, sign, "int") \
    X(taut_bonnet_problem, alpha, "double") \
    X(taut_bonnet_problem, beta, "double") \
    X(taut_bonnet_problem, bspline, "int") \
    X(taut_bonnet_problem, segments, "int[2]") \
    X(taut_bonnet_problem, theta, "double") \
    X(taut_bonnet_problem, normalize, "int") \
    X(taut_bonnet_problem, start, "double[2]")

#define TAUT_ABI_MEMBERS_taut_certify_options(X) \
    X(taut_certify_options, threads, "int") \
    X(taut_certify_options, tolerance, "double") \
    X(taut_certify_options, exact, "int") \
    X(taut_certify_options, monitor, "taut_monitor")

#define TAUT_ABI_MEMBERS_taut_claim(X) \
    X(taut_claim, claim, "const char *") \
    X(taut_claim, kind, "taut_claim_kind") \
    X(taut_claim, residual, "double") \
    X(taut_claim, limit, "double") \
    X(taut_claim, holds, "taut_verdict") \
    X(taut_claim, where, "const char *") \
    X(taut_claim, as_saved, "int")

#define TAUT_ABI_MEMBERS_taut_curve_measure(X) \
    X(taut_curve_measure, length, "double") \
    X(taut_curve_measure, max_curvature, "double") \
    X(taut_curve_measure, max_torsion, "double")

#define TAUT_ABI_MEMBERS_taut_dirichlet_problem(X) \
    X(taut_dirichlet_problem, name, "const char *") \
    X(taut_dirichlet_problem, u, "const taut_basis *") \
    X(taut_dirichlet_problem, v, "const taut_basis *") \
    X(taut_dirichlet_problem, points, "const double *") \
    X(taut_dirichlet_problem, known, "const unsigned char *") \
    X(taut_dirichlet_problem, weights, "const double *") \
    X(taut_dirichlet_problem, aspect, "double") \
    X(taut_dirichlet_problem, aspect_auto, "int") \
    X(taut_dirichlet_problem, regular, "int") \
    X(taut_dirichlet_problem, through, "const taut_through *") \
    X(taut_dirichlet_problem, through_count, "int")

#define TAUT_ABI_MEMBERS_taut_edge_measure(X) \
    X(taut_edge_measure, length, "double") \
    X(taut_edge_measure, max_abs_normal_curvature, "double") \
    X(taut_edge_measure, max_angle_normal_binormal, "double")

#define TAUT_ABI_MEMBERS_taut_error(X) \
    X(taut_error, status, "taut_status") \
    X(taut_error, reason, "char[32]") \
    X(taut_error, found, "double") \
    X(taut_error, limit, "double") \
    X(taut_error, expected, "char[192]") \
    X(taut_error, where, "char[192]") \
    X(taut_error, message, "char[768]")

#define TAUT_ABI_MEMBERS_taut_extension_c1(X) \
    X(taut_extension_c1, width, "double")

#define TAUT_ABI_MEMBERS_taut_extension_g1(X) \
    X(taut_extension_g1, width, "double") \
    X(taut_extension_g1, c, "double") \
    X(taut_extension_g1, alpha, "double") \
    X(taut_extension_g1, beta, "double")

#define TAUT_ABI_MEMBERS_taut_extension_merge(X) \
    X(taut_extension_merge, neighbour, "const taut_surface *")

#define TAUT_ABI_MEMBERS_taut_family_member(X) \
    X(taut_family_member, name, "const char *") \
    X(taut_family_member, scale, "double") \
    X(taut_family_member, lambda, "double") \
    X(taut_family_member, theta, "double") \
    X(taut_family_member, residual, "double") \
    X(taut_family_member, turned, "int") \
    X(taut_family_member, shift, "double[2]") \
    X(taut_family_member, motion, "double[3][4]")

#define TAUT_ABI_MEMBERS_taut_film_along(X) \
    X(taut_film_along, name, "const char *") \
    X(taut_film_along, count, "int") \
    X(taut_film_along, sides, "const taut_film_side *") \
    X(taut_film_along, edge, "taut_film_edge")

#define TAUT_ABI_MEMBERS_taut_film_cell(X) \
    X(taut_film_cell, name, "const char *") \
    X(taut_film_cell, count, "int") \
    X(taut_film_cell, sides, "const taut_film_face *") \
    X(taut_film_cell, has_volume, "unsigned char") \
    X(taut_film_cell, volume, "double") \
    X(taut_film_cell, pressure, "double") \
    X(taut_film_cell, from, "double[3]")

#define TAUT_ABI_MEMBERS_taut_film_edge(X) \
    X(taut_film_edge, kind, "taut_film_edge_kind") \
    X(taut_film_edge, curve, "const taut_curve *") \
    X(taut_film_edge, law, "taut_film_law") \
    X(taut_film_edge, force, "double") \
    X(taut_film_edge, length, "double") \
    X(taut_film_edge, sag, "double") \
    X(taut_film_edge, unstressed, "double") \
    X(taut_film_edge, stiffness, "double") \
    X(taut_film_edge, has_plane, "unsigned char") \
    X(taut_film_edge, is_mirror, "unsigned char") \
    X(taut_film_edge, plane, "taut_film_guide") \
    X(taut_film_edge, along, "int")

#define TAUT_ABI_MEMBERS_taut_film_face(X) \
    X(taut_film_face, patch, "int") \
    X(taut_film_face, reversed, "unsigned char")

#define TAUT_ABI_MEMBERS_taut_film_gradient_request(X) \
    X(taut_film_gradient_request, of, "taut_film_gradient_of") \
    X(taut_film_gradient_request, edge, "int") \
    X(taut_film_gradient_request, corner, "int") \
    X(taut_film_gradient_request, axis, "int") \
    X(taut_film_gradient_request, monitor, "taut_monitor")

#define TAUT_ABI_MEMBERS_taut_film_guide(X) \
    X(taut_film_guide, point, "double[3]") \
    X(taut_film_guide, direction, "double[3]")

#define TAUT_ABI_MEMBERS_taut_film_image(X) \
    X(taut_film_image, kind, "taut_film_image_kind") \
    X(taut_film_image, guide, "taut_film_guide") \
    X(taut_film_image, angle, "double") \
    X(taut_film_image, vector, "double[3]") \
    X(taut_film_image, count, "int")

#define TAUT_ABI_MEMBERS_taut_film_problem(X) \
    X(taut_film_problem, name, "const char *") \
    X(taut_film_problem, u, "const taut_basis *") \
    X(taut_film_problem, v, "const taut_basis *") \
    X(taut_film_problem, corners, "double[4][3]") \
    X(taut_film_problem, has_corner, "unsigned char[4]") \
    X(taut_film_problem, edges, "taut_film_edge[4]") \
    X(taut_film_problem, tension, "double") \
    X(taut_film_problem, tolerance, "double") \
    X(taut_film_problem, max_iterations, "int") \
    X(taut_film_problem, equilibrium, "double") \
    X(taut_film_problem, without_least, "int") \
    X(taut_film_problem, ring, "taut_film_ring") \
    X(taut_film_problem, corner_kinds, "taut_film_corner_kind[4]") \
    X(taut_film_problem, guides, "taut_film_guide[4]") \
    X(taut_film_problem, force_density, "double[2]") \
    X(taut_film_problem, prestress, "double[2]") \
    X(taut_film_problem, reference, "const taut_surface *") \
    X(taut_film_problem, updates, "int") \
    X(taut_film_problem, start, "const double *") \
    X(taut_film_problem, method, "taut_film_method") \
    X(taut_film_problem, accepts_stationary, "int") \
    X(taut_film_problem, refine, "int") \
    X(taut_film_problem, patch_count, "int") \
    X(taut_film_problem, patches, "const taut_film_problem *") \
    X(taut_film_problem, seam_count, "int") \
    X(taut_film_problem, seams, "const taut_film_seam *") \
    X(taut_film_problem, cell_count, "int") \
    X(taut_film_problem, cells, "const taut_film_cell *") \
    X(taut_film_problem, along_count, "int") \
    X(taut_film_problem, along, "const taut_film_along *") \
    X(taut_film_problem, image_count, "int") \
    X(taut_film_problem, images, "const taut_film_image *")

#define TAUT_ABI_MEMBERS_taut_film_seam(X) \
    X(taut_film_seam, count, "int") \
    X(taut_film_seam, sides, "const taut_film_side *") \
    X(taut_film_seam, edge, "taut_film_edge")

#define TAUT_ABI_MEMBERS_taut_film_side(X) \
    X(taut_film_side, patch, "int") \
    X(taut_film_side, edge, "int") \
    X(taut_film_side, reversed, "unsigned char")

#define TAUT_ABI_MEMBERS_taut_film_slopes(X) \
    X(taut_film_slopes, corners, "double[4][3]") \
    X(taut_film_slopes, laws, "double[4]") \
    X(taut_film_slopes, stiffness, "double[4]") \
    X(taut_film_slopes, points, "double *")

#define TAUT_ABI_MEMBERS_taut_forms(X) \
    X(taut_forms, e, "double") \
    X(taut_forms, f, "double") \
    X(taut_forms, g, "double") \
    X(taut_forms, w, "double") \
    X(taut_forms, normal, "double[3]") \
    X(taut_forms, l, "double") \
    X(taut_forms, m, "double") \
    X(taut_forms, n, "double") \
    X(taut_forms, mean, "double") \
    X(taut_forms, gaussian, "double") \
    X(taut_forms, regular, "int")

#define TAUT_ABI_MEMBERS_taut_gradient_request(X) \
    X(taut_gradient_request, of, "taut_gradient_of") \
    X(taut_gradient_request, factors, "const double *") \
    X(taut_gradient_request, monitor, "taut_monitor")

#define TAUT_ABI_MEMBERS_taut_harmonic_boundary(X) \
    X(taut_harmonic_boundary, points, "const double *") \
    X(taut_harmonic_boundary, known, "const unsigned char *")

#define TAUT_ABI_MEMBERS_taut_harmonic_derivative(X) \
    X(taut_harmonic_derivative, edge, "const double *") \
    X(taut_harmonic_derivative, cross, "const double *") \
    X(taut_harmonic_derivative, exact_edge, "const char *const *") \
    X(taut_harmonic_derivative, exact_cross, "const char *const *") \
    X(taut_harmonic_derivative, raise, "int") \
    X(taut_harmonic_derivative, allow_ill_conditioned, "int")

#define TAUT_ABI_MEMBERS_taut_harmonic_extension_problem(X) \
    X(taut_harmonic_extension_problem, surface, "const taut_surface *") \
    X(taut_harmonic_extension_problem, edge, "taut_edge") \
    X(taut_harmonic_extension_problem, given, "taut_extension_given") \
    X(taut_harmonic_extension_problem, c1, "taut_extension_c1") \
    X(taut_harmonic_extension_problem, g1, "taut_extension_g1") \
    X(taut_harmonic_extension_problem, merge, "taut_extension_merge")

#define TAUT_ABI_MEMBERS_taut_harmonic_problem(X) \
    X(taut_harmonic_problem, name, "const char *") \
    X(taut_harmonic_problem, u, "const taut_basis *") \
    X(taut_harmonic_problem, v, "const taut_basis *") \
    X(taut_harmonic_problem, given, "taut_harmonic_given") \
    X(taut_harmonic_problem, rows, "taut_harmonic_rows") \
    X(taut_harmonic_problem, derivative, "taut_harmonic_derivative") \
    X(taut_harmonic_problem, boundary, "taut_harmonic_boundary")

#define TAUT_ABI_MEMBERS_taut_harmonic_rows(X) \
    X(taut_harmonic_rows, points, "const double *") \
    X(taut_harmonic_rows, known, "const unsigned char *") \
    X(taut_harmonic_rows, exact, "const char *const *") \
    X(taut_harmonic_rows, even, "taut_harmonic_even") \
    X(taut_harmonic_rows, allow_ill_conditioned, "int")

#define TAUT_ABI_MEMBERS_taut_jacobian(X) \
    X(taut_jacobian, state, "taut_jacobian_state") \
    X(taut_jacobian, sign, "int") \
    X(taut_jacobian, lowest, "double") \
    X(taut_jacobian, at, "double[2]") \
    X(taut_jacobian, cells, "int64_t")

#define TAUT_ABI_MEMBERS_taut_join(X) \
    X(taut_join, max_gap, "double") \
    X(taut_join, gap_bound, "double") \
    X(taut_join, max_tangent_angle, "double") \
    X(taut_join, max_normal_angle, "double") \
    X(taut_join, c_order, "int") \
    X(taut_join, g_order, "int") \
    X(taut_join, reversed, "int") \
    X(taut_join, one_surface, "int") \
    X(taut_join, kind, "taut_join_kind")

#define TAUT_ABI_MEMBERS_taut_join_options(X) \
    X(taut_join_options, monitor, "taut_monitor")

#define TAUT_ABI_MEMBERS_taut_make_options(X) \
    X(taut_make_options, tolerance, "double") \
    X(taut_make_options, threads, "int") \
    X(taut_make_options, monitor, "taut_monitor") \
    X(taut_make_options, exact, "int") \
    X(taut_make_options, time_limit, "double")

#define TAUT_ABI_MEMBERS_taut_measure_options(X) \
    X(taut_measure_options, grid, "int") \
    X(taut_measure_options, threads, "int") \
    X(taut_measure_options, monitor, "taut_monitor")

#define TAUT_ABI_MEMBERS_taut_mesh_group(X) \
    X(taut_mesh_group, name, "const char *") \
    X(taut_mesh_group, surface, "int") \
    X(taut_mesh_group, nu, "int") \
    X(taut_mesh_group, nv, "int") \
    X(taut_mesh_group, turned, "int") \
    X(taut_mesh_group, first_vertex, "size_t") \
    X(taut_mesh_group, first_quad, "size_t")

#define TAUT_ABI_MEMBERS_taut_mesh_options(X) \
    X(taut_mesh_options, tolerance, "double") \
    X(taut_mesh_options, divide, "int") \
    X(taut_mesh_options, threads, "int") \
    X(taut_mesh_options, surface, "const char *") \
    X(taut_mesh_options, monitor, "taut_monitor") \
    X(taut_mesh_options, thickness, "double")

#define TAUT_ABI_MEMBERS_taut_monitor(X) \
    X(taut_monitor, progress, "int (*)(void *context, double done, const char *what)") \
    X(taut_monitor, context, "void *")

#define TAUT_ABI_MEMBERS_taut_panels_options(X) \
    X(taut_panels_options, kind, "taut_panels_kind") \
    X(taut_panels_options, divide, "int[2]") \
    X(taut_panels_options, surface, "const char *") \
    X(taut_panels_options, monitor, "taut_monitor")

#define TAUT_ABI_MEMBERS_taut_pattern_allowance(X) \
    X(taut_pattern_allowance, seam, "double") \
    X(taut_pattern_allowance, border, "double") \
    X(taut_pattern_allowance, overlap, "double") \
    X(taut_pattern_allowance, is_split, "int") \
    X(taut_pattern_allowance, has_butt, "int") \
    X(taut_pattern_allowance, butt, "double") \
    X(taut_pattern_allowance, corner, "taut_pattern_corner") \
    X(taut_pattern_allowance, seam_count, "int") \
    X(taut_pattern_allowance, seams, "const taut_pattern_seam_allowance *")

#define TAUT_ABI_MEMBERS_taut_pattern_at(X) \
    X(taut_pattern_at, uv, "double[2]") \
    X(taut_pattern_at, is_on_edge, "int") \
    X(taut_pattern_at, edge, "taut_edge") \
    X(taut_pattern_at, place, "taut_pattern_place") \
    X(taut_pattern_at, value, "double")

#define TAUT_ABI_MEMBERS_taut_pattern_cloth(X) \
    X(taut_pattern_cloth, width, "double") \
    X(taut_pattern_cloth, length, "double") \
    X(taut_pattern_cloth, material, "taut_pattern_material") \
    X(taut_pattern_cloth, thread, "double") \
    X(taut_pattern_cloth, has_gap, "int") \
    X(taut_pattern_cloth, gap, "double") \
    X(taut_pattern_cloth, has_nap, "int") \
    X(taut_pattern_cloth, shows_lower, "int")

#define TAUT_ABI_MEMBERS_taut_pattern_compensation(X) \
    X(taut_pattern_compensation, warp, "double") \
    X(taut_pattern_compensation, weft, "double") \
    X(taut_pattern_compensation, has_seam, "int") \
    X(taut_pattern_compensation, seam, "double")

#define TAUT_ABI_MEMBERS_taut_pattern_decompensate(X) \
    X(taut_pattern_decompensate, edge, "taut_edge") \
    X(taut_pattern_decompensate, length, "double") \
    X(taut_pattern_decompensate, component, "taut_pattern_component")

#define TAUT_ABI_MEMBERS_taut_pattern_flat_piece(X) \
    X(taut_pattern_flat_piece, name, "const char *") \
    X(taut_pattern_flat_piece, flat, "const taut_surface *") \
    X(taut_pattern_flat_piece, cut, "const taut_curve *") \
    X(taut_pattern_flat_piece, edges, "taut_pattern_sewn_edge[4]") \
    X(taut_pattern_flat_piece, area, "double") \
    X(taut_pattern_flat_piece, flat_area, "double") \
    X(taut_pattern_flat_piece, cut_area, "double") \
    X(taut_pattern_flat_piece, curvature, "double") \
    X(taut_pattern_flat_piece, extent, "double[2]") \
    X(taut_pattern_flat_piece, strain, "double[2]") \
    X(taut_pattern_flat_piece, energy, "double") \
    X(taut_pattern_flat_piece, on_roll, "double[2]") \
    X(taut_pattern_flat_piece, is_turned, "int")

#define TAUT_ABI_MEMBERS_taut_pattern_held(X) \
    X(taut_pattern_held, borders, "int[4]") \
    X(taut_pattern_held, edges, "int[4]")

#define TAUT_ABI_MEMBERS_taut_pattern_hem(X) \
    X(taut_pattern_hem, edge, "taut_edge") \
    X(taut_pattern_hem, pocket, "double")

#define TAUT_ABI_MEMBERS_taut_pattern_marks(X) \
    X(taut_pattern_marks, spacing, "double") \
    X(taut_pattern_marks, notch, "taut_pattern_notch")

#define TAUT_ABI_MEMBERS_taut_pattern_material(X) \
    X(taut_pattern_material, e, "double[2]") \
    X(taut_pattern_material, nu, "double") \
    X(taut_pattern_material, g, "double")

#define TAUT_ABI_MEMBERS_taut_pattern_prestress(X) \
    X(taut_pattern_prestress, warp, "double") \
    X(taut_pattern_prestress, weft, "double")

#define TAUT_ABI_MEMBERS_taut_pattern_problem(X) \
    X(taut_pattern_problem, model, "const taut_model *") \
    X(taut_pattern_problem, of, "const taut_problem *") \
    X(taut_pattern_problem, surface, "const char *") \
    X(taut_pattern_problem, rule_count, "int") \
    X(taut_pattern_problem, rules, "const taut_pattern_rule *") \
    X(taut_pattern_problem, seam_length, "taut_pattern_seam_length") \
    X(taut_pattern_problem, cloth, "taut_pattern_cloth") \
    X(taut_pattern_problem, compensation, "taut_pattern_compensation") \
    X(taut_pattern_problem, has_prestress, "int") \
    X(taut_pattern_problem, prestress, "taut_pattern_prestress") \
    X(taut_pattern_problem, allowance, "taut_pattern_allowance") \
    X(taut_pattern_problem, hem_count, "int") \
    X(taut_pattern_problem, hems, "const taut_pattern_hem *") \
    X(taut_pattern_problem, marks, "taut_pattern_marks") \
    X(taut_pattern_problem, strain, "double") \
    X(taut_pattern_problem, held, "taut_pattern_held") \
    X(taut_pattern_problem, ends, "taut_pattern_ends") \
    X(taut_pattern_problem, decompensate_count, "int") \
    X(taut_pattern_problem, decompensate, "const taut_pattern_decompensate *") \
    X(taut_pattern_problem, flatten, "taut_pattern_flattening")

#define TAUT_ABI_MEMBERS_taut_pattern_rule(X) \
    X(taut_pattern_rule, kind, "taut_pattern_rule_kind") \
    X(taut_pattern_rule, edges, "taut_edge[2]") \
    X(taut_pattern_rule, count, "int") \
    X(taut_pattern_rule, width, "double") \
    X(taut_pattern_rule, strain, "double") \
    X(taut_pattern_rule, trim, "double") \
    X(taut_pattern_rule, by, "taut_pattern_by") \
    X(taut_pattern_rule, at, "taut_pattern_at[2]") \
    X(taut_pattern_rule, spacing, "double") \
    X(taut_pattern_rule, held, "int") \
    X(taut_pattern_rule, value_count, "int") \
    X(taut_pattern_rule, values, "const double *") \
    X(taut_pattern_rule, curve, "const char *") \
    X(taut_pattern_rule, strip, "int") \
    X(taut_pattern_rule, surface, "const char *")

#define TAUT_ABI_MEMBERS_taut_pattern_seam_allowance(X) \
    X(taut_pattern_seam_allowance, seam, "const char *") \
    X(taut_pattern_seam_allowance, right, "double") \
    X(taut_pattern_seam_allowance, left, "double")

#define TAUT_ABI_MEMBERS_taut_pattern_sewn_edge(X) \
    X(taut_pattern_sewn_edge, seam, "const char *") \
    X(taut_pattern_sewn_edge, part, "double[2]") \
    X(taut_pattern_sewn_edge, length, "double") \
    X(taut_pattern_sewn_edge, flat_length, "double") \
    X(taut_pattern_sewn_edge, allowance, "double") \
    X(taut_pattern_sewn_edge, line, "const taut_curve *")

#define TAUT_ABI_MEMBERS_taut_pattern_sewn_seam(X) \
    X(taut_pattern_sewn_seam, name, "const char *") \
    X(taut_pattern_sewn_seam, kind, "const char *") \
    X(taut_pattern_sewn_seam, curve, "const taut_curve *") \
    X(taut_pattern_sewn_seam, length, "double") \
    X(taut_pattern_sewn_seam, flat_length, "double") \
    X(taut_pattern_sewn_seam, stretch, "double[2]") \
    X(taut_pattern_sewn_seam, disagreement, "double") \
    X(taut_pattern_sewn_seam, piece_count, "int") \
    X(taut_pattern_sewn_seam, mark_count, "int")

#define TAUT_ABI_MEMBERS_taut_pipe_axis(X) \
    X(taut_pipe_axis, kind, "taut_pipe_axis_kind") \
    X(taut_pipe_axis, polygon, "double[4][3]") \
    X(taut_pipe_axis, ends, "taut_pipe_end[2]")

#define TAUT_ABI_MEMBERS_taut_pipe_ellipse(X) \
    X(taut_pipe_ellipse, a, "double") \
    X(taut_pipe_ellipse, b, "double") \
    X(taut_pipe_ellipse, direction, "double[3]")

#define TAUT_ABI_MEMBERS_taut_pipe_end(X) \
    X(taut_pipe_end, point, "double[3]") \
    X(taut_pipe_end, direction, "double[3]") \
    X(taut_pipe_end, handle, "double")

#define TAUT_ABI_MEMBERS_taut_pipe_leg(X) \
    X(taut_pipe_leg, kind, "taut_pipe_leg_kind") \
    X(taut_pipe_leg, from, "double[3]") \
    X(taut_pipe_leg, to, "double[3]") \
    X(taut_pipe_leg, direction, "double[3]")

#define TAUT_ABI_MEMBERS_taut_pipe_problem(X) \
    X(taut_pipe_problem, axis, "taut_pipe_axis") \
    X(taut_pipe_problem, section, "taut_pipe_section") \
    X(taut_pipe_problem, shape, "taut_pipe_shape") \
    X(taut_pipe_problem, joint, "taut_pipe_joint") \
    X(taut_pipe_problem, frame, "taut_pipe_frame") \
    X(taut_pipe_problem, lengths, "double[2]") \
    X(taut_pipe_problem, bend_radius, "double") \
    X(taut_pipe_problem, caps, "int")

#define TAUT_ABI_MEMBERS_taut_pipe_route(X) \
    X(taut_pipe_route, kind, "taut_pipe_route_kind") \
    X(taut_pipe_route, count, "int") \
    X(taut_pipe_route, corners, "const double *") \
    X(taut_pipe_route, legs, "const taut_pipe_leg *") \
    X(taut_pipe_route, closed, "int")

#define TAUT_ABI_MEMBERS_taut_pipe_run_problem(X) \
    X(taut_pipe_run_problem, route, "taut_pipe_route") \
    X(taut_pipe_run_problem, radius, "double") \
    X(taut_pipe_run_problem, shape, "taut_pipe_shape") \
    X(taut_pipe_run_problem, joint, "taut_pipe_joint") \
    X(taut_pipe_run_problem, bend_radius, "double") \
    X(taut_pipe_run_problem, caps, "int") \
    X(taut_pipe_run_problem, elbow, "taut_pipe_elbow_kind") \
    X(taut_pipe_run_problem, wall, "double")

#define TAUT_ABI_MEMBERS_taut_pipe_section(X) \
    X(taut_pipe_section, kind, "taut_pipe_section_kind") \
    X(taut_pipe_section, radius, "double") \
    X(taut_pipe_section, ellipses, "taut_pipe_ellipse[2]") \
    X(taut_pipe_section, radii, "double[2]")

#define TAUT_ABI_MEMBERS_taut_pipe_shape(X) \
    X(taut_pipe_shape, kind, "taut_pipe_shape_kind") \
    X(taut_pipe_shape, alpha, "double") \
    X(taut_pipe_shape, beta, "double") \
    X(taut_pipe_shape, gamma, "double") \
    X(taut_pipe_shape, extended, "int")

#define TAUT_ABI_MEMBERS_taut_plateau_problem(X) \
    X(taut_plateau_problem, net, "taut_dirichlet_problem") \
    X(taut_plateau_problem, curves, "const taut_curve *[4]") \
    X(taut_plateau_problem, start, "const double *") \
    X(taut_plateau_problem, tolerance, "double") \
    X(taut_plateau_problem, max_iterations, "int") \
    X(taut_plateau_problem, method, "taut_plateau_method") \
    X(taut_plateau_problem, refine, "int") \
    X(taut_plateau_problem, tolerance_area, "double") \
    X(taut_plateau_problem, without_least, "int") \
    X(taut_plateau_problem, gap, "double")

#define TAUT_ABI_MEMBERS_taut_read_options(X) \
    X(taut_read_options, untrim, "int") \
    X(taut_read_options, edges, "int") \
    X(taut_read_options, monitor, "taut_monitor")

#define TAUT_ABI_MEMBERS_taut_surface_measure(X) \
    X(taut_surface_measure, area, "double") \
    X(taut_surface_measure, area_error, "double") \
    X(taut_surface_measure, dirichlet_energy, "double") \
    X(taut_surface_measure, dirichlet_energy_error, "double") \
    X(taut_surface_measure, bending_energy, "double") \
    X(taut_surface_measure, bending_energy_error, "double") \
    X(taut_surface_measure, box, "double[2][3]") \
    X(taut_surface_measure, max_abs_mean, "double") \
    X(taut_surface_measure, mean_abs_mean, "double") \
    X(taut_surface_measure, min_gaussian, "double") \
    X(taut_surface_measure, max_gaussian, "double") \
    X(taut_surface_measure, max_e_minus_g, "double") \
    X(taut_surface_measure, max_f, "double") \
    X(taut_surface_measure, isothermality, "double") \
    X(taut_surface_measure, isothermality_error, "double") \
    X(taut_surface_measure, max_laplacian, "double") \
    X(taut_surface_measure, max_abs_mean_at, "double[2]") \
    X(taut_surface_measure, edges, "taut_edge_measure[4]") \
    X(taut_surface_measure, singular_points, "int64_t") \
    X(taut_surface_measure, jacobian, "taut_jacobian")

#define TAUT_ABI_MEMBERS_taut_through(X) \
    X(taut_through, u, "double") \
    X(taut_through, v, "double") \
    X(taut_through, point, "double[3]")

#define TAUT_ABI_MEMBERS_taut_trace_bending(X) \
    X(taut_trace_bending, seed, "double") \
    X(taut_trace_bending, most, "double") \
    X(taut_trace_bending, most_at, "double")

#define TAUT_ABI_MEMBERS_taut_trace_end(X) \
    X(taut_trace_end, word, "const char *") \
    X(taut_trace_end, at, "double[2]") \
    X(taut_trace_end, length, "double") \
    X(taut_trace_end, steps, "int")

#define TAUT_ABI_MEMBERS_taut_trace_lath(X) \
    X(taut_trace_lath, name, "const char *") \
    X(taut_trace_lath, family, "const char *") \
    X(taut_trace_lath, from_word, "const char *") \
    X(taut_trace_lath, to_word, "const char *") \
    X(taut_trace_lath, seed, "double[2]") \
    X(taut_trace_lath, from, "double[2]") \
    X(taut_trace_lath, to, "double[2]") \
    X(taut_trace_lath, length, "double") \
    X(taut_trace_lath, twist, "double") \
    X(taut_trace_lath, turn, "double") \
    X(taut_trace_lath, k_n, "taut_trace_bending") \
    X(taut_trace_lath, k_g, "taut_trace_bending") \
    X(taut_trace_lath, tau_g, "taut_trace_bending") \
    X(taut_trace_lath, steps, "int") \
    X(taut_trace_lath, node_count, "int") \
    X(taut_trace_lath, width, "double") \
    X(taut_trace_lath, thickness, "double") \
    X(taut_trace_lath, least_radius, "double") \
    X(taut_trace_lath, edge_length, "double") \
    X(taut_trace_lath, mean_stretch, "double") \
    X(taut_trace_lath, cut_length, "double") \
    X(taut_trace_lath, pattern_end, "double[3]") \
    X(taut_trace_lath, use, "double")

#define TAUT_ABI_MEMBERS_taut_trace_laths(X) \
    X(taut_trace_laths, strip, "taut_trace_strip") \
    X(taut_trace_laths, width, "double") \
    X(taut_trace_laths, thickness, "double") \
    X(taut_trace_laths, material, "taut_trace_material") \
    X(taut_trace_laths, cut, "taut_trace_cut") \
    X(taut_trace_laths, has_play, "int") \
    X(taut_trace_laths, play, "double")

#define TAUT_ABI_MEMBERS_taut_trace_material(X) \
    X(taut_trace_material, e, "double") \
    X(taut_trace_material, g, "double") \
    X(taut_trace_material, strength, "double")

#define TAUT_ABI_MEMBERS_taut_trace_node(X) \
    X(taut_trace_node, name, "const char *") \
    X(taut_trace_node, at, "double[2]") \
    X(taut_trace_node, point, "double[3]") \
    X(taut_trace_node, normal, "double[3]") \
    X(taut_trace_node, angle, "double") \
    X(taut_trace_node, tau, "double") \
    X(taut_trace_node, mean_curvature, "double") \
    X(taut_trace_node, s, "double[2]") \
    X(taut_trace_node, slot, "double") \
    X(taut_trace_node, slot_twisted, "double") \
    X(taut_trace_node, is_on_border, "int")

#define TAUT_ABI_MEMBERS_taut_trace_piece(X) \
    X(taut_trace_piece, name, "const char *") \
    X(taut_trace_piece, lath, "const char *") \
    X(taut_trace_piece, sheet, "int") \
    X(taut_trace_piece, point_count, "int") \
    X(taut_trace_piece, slot_count, "int")

#define TAUT_ABI_MEMBERS_taut_trace_problem(X) \
    X(taut_trace_problem, model, "const taut_model *") \
    X(taut_trace_problem, of, "const taut_problem *") \
    X(taut_trace_problem, surface, "const char *") \
    X(taut_trace_problem, carry, "int") \
    X(taut_trace_problem, net, "taut_trace_net") \
    X(taut_trace_problem, families, "int") \
    X(taut_trace_problem, seed_count, "int") \
    X(taut_trace_problem, seeds, "const taut_trace_seed *") \
    X(taut_trace_problem, max_length, "double") \
    X(taut_trace_problem, laths, "const taut_trace_laths *") \
    X(taut_trace_problem, sheet, "const taut_trace_sheet *") \
    X(taut_trace_problem, panels, "int")

#define TAUT_ABI_MEMBERS_taut_trace_seed(X) \
    X(taut_trace_seed, kind, "taut_trace_seed_kind") \
    X(taut_trace_seed, family, "int") \
    X(taut_trace_seed, has_at, "int") \
    X(taut_trace_seed, at, "double[2]") \
    X(taut_trace_seed, to, "double[2]") \
    X(taut_trace_seed, has_to, "int") \
    X(taut_trace_seed, direction, "double[2]") \
    X(taut_trace_seed, both, "int") \
    X(taut_trace_seed, edge, "taut_edge") \
    X(taut_trace_seed, count, "int") \
    X(taut_trace_seed, ends, "int") \
    X(taut_trace_seed, by, "taut_trace_by") \
    X(taut_trace_seed, lath, "const char *") \
    X(taut_trace_seed, surface, "const char *") \
    X(taut_trace_seed, cell, "double")

#define TAUT_ABI_MEMBERS_taut_trace_sheet(X) \
    X(taut_trace_sheet, size, "double[2]") \
    X(taut_trace_sheet, has_gap, "int") \
    X(taut_trace_sheet, gap, "double")

#define TAUT_ABI_MEMBERS_taut_trace_step(X) \
    X(taut_trace_step, s, "double") \
    X(taut_trace_step, at, "double[2]") \
    X(taut_trace_step, point, "double[3]") \
    X(taut_trace_step, tangent, "double[3]") \
    X(taut_trace_step, normal, "double[3]") \
    X(taut_trace_step, k_n, "double") \
    X(taut_trace_step, k_g, "double") \
    X(taut_trace_step, tau_g, "double")

#define TAUT_ABI_MEMBERS_taut_write_options(X) \
    X(taut_write_options, tolerance, "double") \
    X(taut_write_options, divide, "int") \
    X(taut_write_options, threads, "int") \
    X(taut_write_options, format, "const char *") \
    X(taut_write_options, formats, "const taut_formats *") \
    X(taut_write_options, surface, "const char *") \
    X(taut_write_options, short_knots, "int") \
    X(taut_write_options, colour, "taut_colour") \
    X(taut_write_options, no_net, "int") \
    X(taut_write_options, has_view, "int") \
    X(taut_write_options, view, "double[2]") \
    X(taut_write_options, title, "const char *") \
    X(taut_write_options, isolines, "int") \
    X(taut_write_options, reflections, "int") \
    X(taut_write_options, combs, "int") \
    X(taut_write_options, side_by_side, "int") \
    X(taut_write_options, width, "int") \
    X(taut_write_options, labels, "const char *const *") \
    X(taut_write_options, monitor, "taut_monitor") \
    X(taut_write_options, bound, "double *") \
    X(taut_write_options, thickness, "double") \
    X(taut_write_options, coefficients, "int") \
    X(taut_write_options, reactions, "int") \
    X(taut_write_options, column, "int") \
    X(taut_write_options, tiles, "taut_paper") \
    X(taut_write_options, reduction, "double") \
    X(taut_write_options, lagrange, "int")

#define TAUT_ABI_STRUCT_LIST(X) \
    X(taut_abi_enum) \
    X(taut_abi_member) \
    X(taut_abi_struct) \
    X(taut_abi_table) \
    X(taut_abi_value) \
    X(taut_asymptotic_corners) \
    X(taut_asymptotic_edge) \
    X(taut_asymptotic_problem) \
    X(taut_basis_spec) \
    X(taut_biharmonic_neighbour) \
    X(taut_biharmonic_problem) \
    X(taut_biharmonic_rows) \
    X(taut_bonnet_problem) \
    X(taut_certify_options) \
    X(taut_claim) \
    X(taut_curve_measure) \
    X(taut_dirichlet_problem) \
    X(taut_edge_measure) \
    X(taut_error) \
    X(taut_extension_c1) \
    X(taut_extension_g1) \
    X(taut_extension_merge) \
    X(taut_family_member) \
    X(taut_film_along) \
    X(taut_film_cell) \
    X(taut_film_edge) \
    X(taut_film_face) \
    X(taut_film_gradient_request) \
    X(taut_film_guide) \
    X(taut_film_image) \
    X(taut_film_problem) \
    X(taut_film_seam) \
    X(taut_film_side) \
    X(taut_film_slopes) \
    X(taut_forms) \
    X(taut_gradient_request) \
    X(taut_harmonic_boundary) \
    X(taut_harmonic_derivative) \
    X(taut_harmonic_extension_problem) \
    X(taut_harmonic_problem) \
    X(taut_harmonic_rows) \
    X(taut_jacobian) \
    X(taut_join) \
    X(taut_join_options) \
    X(taut_make_options) \
    X(taut_measure_options) \
    X(taut_mesh_group) \
    X(taut_mesh_options) \
    X(taut_monitor) \
    X(taut_panels_options) \
    X(taut_pattern_allowance) \
    X(taut_pattern_at) \
    X(taut_pattern_cloth) \
    X(taut_pattern_compensation) \
    X(taut_pattern_decompensate) \
    X(taut_pattern_flat_piece) \
    X(taut_pattern_held) \
    X(taut_pattern_hem) \
    X(taut_pattern_marks) \
    X(taut_pattern_material) \
    X(taut_pattern_prestress) \
    X(taut_pattern_problem) \
    X(taut_pattern_rule) \
    X(taut_pattern_seam_allowance) \
    X(taut_pattern_sewn_edge) \
    X(taut_pattern_sewn_seam) \
    X(taut_pipe_axis) \
    X(taut_pipe_ellipse) \
    X(taut_pipe_end) \
    X(taut_pipe_leg) \
    X(taut_pipe_problem) \
    X(taut_pipe_route) \
    X(taut_pipe_run_problem) \
    X(taut_pipe_section) \
    X(taut_pipe_shape) \
    X(taut_plateau_problem) \
    X(taut_read_options) \
    X(taut_surface_measure) \
    X(taut_through) \
    X(taut_trace_bending) \
    X(taut_trace_end) \
    X(taut_trace_lath) \
    X(taut_trace_laths) \
    X(taut_trace_material) \
    X(taut_trace_node) \
    X(taut_trace_piece) \
    X(taut_trace_problem) \
    X(taut_trace_seed) \
    X(taut_trace_sheet) \
    X(taut_trace_step) \
    X(taut_write_options)

#define TAUT_ABI_VALUES_taut_asymptotic_given(X) \
    X(TAUT_ASYMPTOTIC_CORNERS, "corners") \
    X(TAUT_ASYMPTOTIC_CURVES, "curves")

#define TAUT_ABI_VALUES_taut_asymptotic_surface(X) \
    X(TAUT_BIDEGREE_5N_MINUS_7, "5n-7") \
    X(TAUT_BIDEGREE_N_PLUS_3, "n+3")

#define TAUT_ABI_VALUES_taut_biharmonic_given(X) \
    X(TAUT_BIHARMONIC_ROWS, "rows") \
    X(TAUT_BIHARMONIC_NEIGHBOUR, "neighbour")

#define TAUT_ABI_VALUES_taut_claim_kind(X) \
    X(TAUT_CHECK, "check") \
    X(TAUT_BOUND, "bound") \
    X(TAUT_EXACT, "exact")

#define TAUT_ABI_VALUES_taut_colour(X) \
    X(TAUT_COLOUR_PLAIN, "plain") \
    X(TAUT_COLOUR_MEAN, "mean") \
    X(TAUT_COLOUR_GAUSSIAN, "gaussian") \
    X(TAUT_COLOUR_ISOTHERMALITY, "isothermality") \
    X(TAUT_COLOUR_GAP, "gap") \
    X(TAUT_COLOUR_WARP, "warp") \
    X(TAUT_COLOUR_WEFT, "weft") \
    X(TAUT_COLOUR_STRAIN, "strain")

#define TAUT_ABI_VALUES_taut_edge(X) \
    X(TAUT_EDGE_U0, "u0") \
    X(TAUT_EDGE_U1, "u1") \
    X(TAUT_EDGE_V0, "v0") \
    X(TAUT_EDGE_V1, "v1")

#define TAUT_ABI_VALUES_taut_extension_given(X) \
    X(TAUT_EXTENSION_C1, "c1") \
    X(TAUT_EXTENSION_G1, "g1") \
    X(TAUT_EXTENSION_MERGE, "merge")

#define TAUT_ABI_VALUES_taut_film_corner_kind(X) \
    X(TAUT_FILM_HELD, "held") \
    X(TAUT_FILM_FREE, "free") \
    X(TAUT_FILM_ON_LINE, "on-line") \
    X(TAUT_FILM_ON_PLANE, "on-plane")

#define TAUT_ABI_VALUES_taut_film_edge_kind(X) \
    X(TAUT_FILM_FIXED, "fixed") \
    X(TAUT_FILM_CABLE, "cable") \
    X(TAUT_FILM_SLIDE, "slide") \
    X(TAUT_FILM_POLE, "pole")

#define TAUT_ABI_VALUES_taut_film_gradient_of(X) \
    X(TAUT_FILM_GRADIENT_ENERGY, "energy") \
    X(TAUT_FILM_GRADIENT_AREA, "area") \
    X(TAUT_FILM_GRADIENT_LENGTH, "length") \
    X(TAUT_FILM_GRADIENT_TENSION, "tension") \
    X(TAUT_FILM_GRADIENT_REACTION, "reaction")

#define TAUT_ABI_VALUES_taut_film_image_kind(X) \
    X(TAUT_FILM_MIRROR, "mirror") \
    X(TAUT_FILM_HALF_TURN, "half-turn") \
    X(TAUT_FILM_TURN, "turn") \
    X(TAUT_FILM_TRANSLATE, "translate")

#define TAUT_ABI_VALUES_taut_film_law(X) \
    X(TAUT_FILM_FORCE, "force") \
    X(TAUT_FILM_LENGTH, "length") \
    X(TAUT_FILM_SAG, "sag") \
    X(TAUT_FILM_ELASTIC, "elastic")

#define TAUT_ABI_VALUES_taut_film_method(X) \
    X(TAUT_FILM_FULL, "full") \
    X(TAUT_FILM_NORMAL, "normal")

#define TAUT_ABI_VALUES_taut_film_ring(X) \
    X(TAUT_FILM_OPEN, "open") \
    X(TAUT_FILM_RING_U, "ring-u") \
    X(TAUT_FILM_RING_V, "ring-v")

#define TAUT_ABI_VALUES_taut_gradient_of(X) \
    X(TAUT_GRADIENT_AREA, "area") \
    X(TAUT_GRADIENT_DIRICHLET_ENERGY, "dirichlet-energy") \
    X(TAUT_GRADIENT_POINTS, "points")

#define TAUT_ABI_VALUES_taut_harmonic_even(X) \
    X(TAUT_EVEN_REFUSE, "refuse") \
    X(TAUT_EVEN_CORNER, "corner") \
    X(TAUT_EVEN_PROJECT, "project") \
    X(TAUT_EVEN_RAISE, "raise")

#define TAUT_ABI_VALUES_taut_harmonic_given(X) \
    X(TAUT_HARMONIC_ROWS, "rows") \
    X(TAUT_HARMONIC_DERIVATIVE, "derivative") \
    X(TAUT_HARMONIC_BOUNDARY, "boundary")

#define TAUT_ABI_VALUES_taut_jacobian_state(X) \
    X(TAUT_JACOBIAN_NONE, "none") \
    X(TAUT_JACOBIAN_ONE_SIGN, "one-sign") \
    X(TAUT_JACOBIAN_FOLDS, "folds") \
    X(TAUT_JACOBIAN_UNDECIDED, "undecided") \
    X(TAUT_JACOBIAN_UNSUPPORTED, "unsupported")

#define TAUT_ABI_VALUES_taut_join_kind(X) \
    X(TAUT_JOIN_CHECK, "check") \
    X(TAUT_JOIN_BOUND, "bound")

#define TAUT_ABI_VALUES_taut_panels_kind(X) \
    X(TAUT_PANELS_CONICAL, "conical") \
    X(TAUT_PANELS_CIRCULAR, "circular")

#define TAUT_ABI_VALUES_taut_paper(X) \
    X(TAUT_PAPER_NONE, "none") \
    X(TAUT_PAPER_A4, "a4") \
    X(TAUT_PAPER_A3, "a3")

#define TAUT_ABI_VALUES_taut_pattern_by(X) \
    X(TAUT_PATTERN_BY_LENGTH, "length") \
    X(TAUT_PATTERN_BY_PARAMETER, "parameter")

#define TAUT_ABI_VALUES_taut_pattern_component(X) \
    X(TAUT_PATTERN_COMPONENT_ALONG, "along") \
    X(TAUT_PATTERN_COMPONENT_BOTH, "both")

#define TAUT_ABI_VALUES_taut_pattern_corner(X) \
    X(TAUT_PATTERN_MITRE, "mitre") \
    X(TAUT_PATTERN_SQUARE, "square") \
    X(TAUT_PATTERN_MIRROR, "mirror")

#define TAUT_ABI_VALUES_taut_pattern_ends(X) \
    X(TAUT_PATTERN_ENDS_FREE, "free") \
    X(TAUT_PATTERN_ENDS_STRAIGHT, "straight")

#define TAUT_ABI_VALUES_taut_pattern_flattening(X) \
    X(TAUT_PATTERN_ELASTIC, "elastic") \
    X(TAUT_PATTERN_CONFORMAL, "conformal")

#define TAUT_ABI_VALUES_taut_pattern_notch(X) \
    X(TAUT_PATTERN_SLIT, "slit") \
    X(TAUT_PATTERN_V, "v") \
    X(TAUT_PATTERN_DOT, "dot")

#define TAUT_ABI_VALUES_taut_pattern_place(X) \
    X(TAUT_PATTERN_PART, "part") \
    X(TAUT_PATTERN_LENGTH, "length") \
    X(TAUT_PATTERN_PARAMETER, "parameter")

#define TAUT_ABI_VALUES_taut_pattern_rule_kind(X) \
    X(TAUT_PATTERN_ACROSS, "across") \
    X(TAUT_PATTERN_RADIAL, "radial") \
    X(TAUT_PATTERN_PARALLEL, "parallel") \
    X(TAUT_PATTERN_GEODESIC, "geodesic") \
    X(TAUT_PATTERN_LINE, "line") \
    X(TAUT_PATTERN_CURVE, "curve") \
    X(TAUT_PATTERN_BUTT, "butt")

#define TAUT_ABI_VALUES_taut_pattern_seam_length(X) \
    X(TAUT_PATTERN_SHARED, "shared") \
    X(TAUT_PATTERN_TRUE, "true")

#define TAUT_ABI_VALUES_taut_pipe_axis_kind(X) \
    X(TAUT_PIPE_POLYGON, "polygon") \
    X(TAUT_PIPE_ENDS, "ends") \
    X(TAUT_PIPE_FEET, "feet")

#define TAUT_ABI_VALUES_taut_pipe_elbow_kind(X) \
    X(TAUT_PIPE_ELBOW_BLEND, "blend") \
    X(TAUT_PIPE_ELBOW_ARC, "arc")

#define TAUT_ABI_VALUES_taut_pipe_frame(X) \
    X(TAUT_PIPE_ROTATION_MINIMIZING, "rotation-minimizing") \
    X(TAUT_PIPE_FRENET, "frenet")

#define TAUT_ABI_VALUES_taut_pipe_joint(X) \
    X(TAUT_PIPE_G1, "g1") \
    X(TAUT_PIPE_G2, "g2")

#define TAUT_ABI_VALUES_taut_pipe_leg_kind(X) \
    X(TAUT_PIPE_LEG_SPAN, "span") \
    X(TAUT_PIPE_LEG_POINT, "point")

#define TAUT_ABI_VALUES_taut_pipe_route_kind(X) \
    X(TAUT_PIPE_CORNERS, "corners") \
    X(TAUT_PIPE_LEGS, "legs")

#define TAUT_ABI_VALUES_taut_pipe_section_kind(X) \
    X(TAUT_PIPE_ROUND, "round") \
    X(TAUT_PIPE_ELLIPTIC, "elliptic") \
    X(TAUT_PIPE_CANAL, "canal") \
    X(TAUT_PIPE_NAIVE_SWEEP, "naive-sweep")

#define TAUT_ABI_VALUES_taut_pipe_shape_kind(X) \
    X(TAUT_PIPE_SHAPE_GIVEN, "given") \
    X(TAUT_PIPE_LEAST_BENDING, "least-bending") \
    X(TAUT_PIPE_LEAST_CURVATURE, "least-curvature")

#define TAUT_ABI_VALUES_taut_plateau_method(X) \
    X(TAUT_PLATEAU_FULL, "full") \
    X(TAUT_PLATEAU_NORMAL, "normal") \
    X(TAUT_PLATEAU_EITHER, "either")

#define TAUT_ABI_VALUES_taut_record_kind(X) \
    X(TAUT_RECORD_NULL, "null") \
    X(TAUT_RECORD_BOOL, "bool") \
    X(TAUT_RECORD_NUMBER, "number") \
    X(TAUT_RECORD_TEXT, "text") \
    X(TAUT_RECORD_LIST, "list") \
    X(TAUT_RECORD_OBJECT, "object")

#define TAUT_ABI_VALUES_taut_status(X) \
    X(TAUT_OK, "ok") \
    X(TAUT_NOT_CONVERGED, "not-converged") \
    X(TAUT_CHECK_FAILED, "check-failed") \
    X(TAUT_BAD_ARGUMENT, "bad-argument") \
    X(TAUT_BAD_INPUT, "bad-input") \
    X(TAUT_NO_SOLUTION, "no-solution") \
    X(TAUT_IO, "io") \
    X(TAUT_NO_MEMORY, "no-memory") \
    X(TAUT_INTERNAL, "internal") \
    X(TAUT_INTERRUPTED, "interrupted")

#define TAUT_ABI_VALUES_taut_trace_by(X) \
    X(TAUT_TRACE_CONFORMAL, "conformal") \
    X(TAUT_TRACE_LENGTH, "length") \
    X(TAUT_TRACE_PARAMETER, "parameter")

#define TAUT_ABI_VALUES_taut_trace_cut(X) \
    X(TAUT_TRACE_CUT_MEAN, "mean") \
    X(TAUT_TRACE_CUT_AXIS, "axis")

#define TAUT_ABI_VALUES_taut_trace_net(X) \
    X(TAUT_TRACE_ASYMPTOTIC, "asymptotic") \
    X(TAUT_TRACE_PRINCIPAL, "principal") \
    X(TAUT_TRACE_GEODESIC, "geodesic") \
    X(TAUT_TRACE_ISOPARAMETRIC, "isoparametric")

#define TAUT_ABI_VALUES_taut_trace_seed_kind(X) \
    X(TAUT_TRACE_AT, "at") \
    X(TAUT_TRACE_EDGE, "edge") \
    X(TAUT_TRACE_LINE, "line") \
    X(TAUT_TRACE_LATH, "lath") \
    X(TAUT_TRACE_CELL, "cell") \
    X(TAUT_TRACE_CELLS, "cells")

#define TAUT_ABI_VALUES_taut_trace_strip(X) \
    X(TAUT_TRACE_STANDING, "standing") \
    X(TAUT_TRACE_PLANK, "plank") \
    X(TAUT_TRACE_DEVELOPABLE, "developable") \
    X(TAUT_TRACE_ENVELOPE, "envelope")

#define TAUT_ABI_VALUES_taut_verdict(X) \
    X(TAUT_FALSE, "false") \
    X(TAUT_TRUE, "true") \
    X(TAUT_UNDECIDED, "undecided")

#define TAUT_ABI_ENUM_LIST(X) \
    X(taut_asymptotic_given) \
    X(taut_asymptotic_surface) \
    X(taut_biharmonic_given) \
    X(taut_claim_kind) \
    X(taut_colour) \
    X(taut_edge) \
    X(taut_extension_given) \
    X(taut_film_corner_kind) \
    X(taut_film_edge_kind) \
    X(taut_film_gradient_of) \
    X(taut_film_image_kind) \
    X(taut_film_law) \
    X(taut_film_method) \
    X(taut_film_ring) \
    X(taut_gradient_of) \
    X(taut_harmonic_even) \
    X(taut_harmonic_given) \
    X(taut_jacobian_state) \
    X(taut_join_kind) \
    X(taut_panels_kind) \
    X(taut_paper) \
    X(taut_pattern_by) \
    X(taut_pattern_component) \
    X(taut_pattern_corner) \
    X(taut_pattern_ends) \
    X(taut_pattern_flattening) \
    X(taut_pattern_notch) \
    X(taut_pattern_place) \
    X(taut_pattern_rule_kind) \
    X(taut_pattern_seam_length) \
    X(taut_pipe_axis_kind) \
    X(taut_pipe_elbow_kind) \
    X(taut_pipe_frame) \
    X(taut_pipe_joint) \
    X(taut_pipe_leg_kind) \
    X(taut_pipe_route_kind) \
    X(taut_pipe_section_kind) \
    X(taut_pipe_shape_kind) \
    X(taut_plateau_method) \
    X(taut_record_kind) \
    X(taut_status) \
    X(taut_trace_by) \
    X(taut_trace_cut) \
    X(taut_trace_net) \
    X(taut_trace_seed_kind) \
    X(taut_trace_strip) \
    X(taut_verdict)

#define TAUT_ABI_CONSTANT_LIST(X) \
    X(TAUT_ABI_NUMBER, "TAUT_ABI_NUMBER") \
    X(TAUT_ASYMPTOTIC_DEGREE_MAX, "TAUT_ASYMPTOTIC_DEGREE_MAX") \
    X(TAUT_ASYMPTOTIC_V0, "TAUT_ASYMPTOTIC_V0") \
    X(TAUT_ASYMPTOTIC_U0, "TAUT_ASYMPTOTIC_U0") \
    X(TAUT_ASYMPTOTIC_V1, "TAUT_ASYMPTOTIC_V1") \
    X(TAUT_ASYMPTOTIC_U1, "TAUT_ASYMPTOTIC_U1") \
    X(TAUT_ASYMPTOTIC_U0V0, "TAUT_ASYMPTOTIC_U0V0") \
    X(TAUT_ASYMPTOTIC_U1V0, "TAUT_ASYMPTOTIC_U1V0") \
    X(TAUT_ASYMPTOTIC_U0V1, "TAUT_ASYMPTOTIC_U0V1") \
    X(TAUT_ASYMPTOTIC_U1V1, "TAUT_ASYMPTOTIC_U1V1") \
    X(TAUT_ORDER_MAX, "TAUT_ORDER_MAX") \
    X(TAUT_THROUGH_MAX, "TAUT_THROUGH_MAX") \
    X(TAUT_FILM_POINTS_MAX, "TAUT_FILM_POINTS_MAX") \
    X(TAUT_FILM_PATCHES_MAX, "TAUT_FILM_PATCHES_MAX") \
    X(TAUT_FILM_PATCHES_POINTS_MAX, "TAUT_FILM_PATCHES_POINTS_MAX") \
    X(TAUT_FILM_ALONG_MAX, "TAUT_FILM_ALONG_MAX") \
    X(TAUT_FILM_CELLS_MAX, "TAUT_FILM_CELLS_MAX") \
    X(TAUT_FILM_IMAGES_MAX, "TAUT_FILM_IMAGES_MAX") \
    X(TAUT_FILM_IMAGES_POINTS_MAX, "TAUT_FILM_IMAGES_POINTS_MAX") \
    X(TAUT_FILM_REFINE_MAX, "TAUT_FILM_REFINE_MAX") \
    X(TAUT_FILM_UPDATES_MAX, "TAUT_FILM_UPDATES_MAX") \
    X(TAUT_DEGREE_MAX, "TAUT_DEGREE_MAX") \
    X(TAUT_COUNT_MAX, "TAUT_COUNT_MAX") \
    X(TAUT_POINTS_MAX, "TAUT_POINTS_MAX") \
    X(TAUT_NAME_MAX, "TAUT_NAME_MAX") \
    X(TAUT_OBJECTS_MAX, "TAUT_OBJECTS_MAX") \
    X(TAUT_MEMBERS_MAX, "TAUT_MEMBERS_MAX") \
    X(TAUT_GRID_MAX, "TAUT_GRID_MAX") \
    X(TAUT_THREADS_MAX, "TAUT_THREADS_MAX") \
    X(TAUT_ISOLINES_MAX, "TAUT_ISOLINES_MAX") \
    X(TAUT_LIGHTS_MAX, "TAUT_LIGHTS_MAX") \
    X(TAUT_WIDTH_MAX, "TAUT_WIDTH_MAX") \
    X(TAUT_GO_ON, "TAUT_GO_ON") \
    X(TAUT_STOP, "TAUT_STOP") \
    X(TAUT_ENOUGH, "TAUT_ENOUGH") \
    X(TAUT_ALONG_U, "TAUT_ALONG_U") \
    X(TAUT_ALONG_V, "TAUT_ALONG_V") \
    X(TAUT_PATTERN_PIECES_MAX, "TAUT_PATTERN_PIECES_MAX") \
    X(TAUT_PATTERN_RULES_MAX, "TAUT_PATTERN_RULES_MAX") \
    X(TAUT_PLATEAU_REFINE_MAX, "TAUT_PLATEAU_REFINE_MAX") \
    X(TAUT_PLATEAU_REFINED_MAX, "TAUT_PLATEAU_REFINED_MAX") \
    X(TAUT_PLATEAU_ADAPTED_MAX, "TAUT_PLATEAU_ADAPTED_MAX") \
    X(TAUT_PLATEAU_LEAST_MAX, "TAUT_PLATEAU_LEAST_MAX") \
    X(TAUT_X, "TAUT_X") \
    X(TAUT_XU, "TAUT_XU") \
    X(TAUT_XV, "TAUT_XV") \
    X(TAUT_XUU, "TAUT_XUU") \
    X(TAUT_XUV, "TAUT_XUV") \
    X(TAUT_XVV, "TAUT_XVV") \
    X(TAUT_TRACE_SEEDS_MAX, "TAUT_TRACE_SEEDS_MAX") \
    X(TAUT_TRACE_LATHS_MAX, "TAUT_TRACE_LATHS_MAX") \
    X(TAUT_VERSION_MAJOR, "TAUT_VERSION_MAJOR") \
    X(TAUT_VERSION_MINOR, "TAUT_VERSION_MINOR") \
    X(TAUT_VERSION_PATCH, "TAUT_VERSION_PATCH") \
    X(TAUT_MODELS_MAX, "TAUT_MODELS_MAX")

#endif /* TAUT_CORE_ABI_LIST_H */
