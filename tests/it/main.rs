//! The promises of the library, one module each.
//!
//! They are one program, so that the library and what they share are linked once. What counts allocations is in
//! `tests/alloc`.

#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "a test fails loudly, compares exact results, and counts small things"
)]

mod a_finer_grid_keeps_the_long_waves;
mod a_grid_that_repeats;
mod a_study_killed_goes_on;
mod an_independent_method_agrees_on_dissimilar_bodies;
mod another_code_agrees;
mod another_code_agrees_in_the_plane;
mod another_code_agrees_through_histories;
mod bad_closed_forms_are_refused;
mod bad_input_is_refused;
mod bad_loads_are_refused;
#[cfg(feature = "dense")]
mod bad_matrices_are_refused;
mod bad_surfaces_are_refused;
mod both_tractions_in_the_plane;
mod bulk_strain_moves_the_stick_zone;
mod cancelled_solves;
mod close_to_sliding_in_the_plane;
mod closed_forms;
mod coarse_answers_hand_down_their_edges;
mod coated_bodies;
mod contact_spots_add_up;
mod contacts_that_shrink_need_no_more_than_they_are;
#[cfg(feature = "dense")]
mod convolution_equals_direct_sum;
mod coupled_rolling;
mod cycles_add_up_their_steps;
mod data_of_another_code_is_consistent;
mod displacement_control;
mod dissimilar_bodies_are_coupled;
mod dissimilar_contacts_end_as_documented;
mod dissimilar_histories_remember;
#[cfg(feature = "dense")]
mod edges_are_found_inside_the_cells;
mod engine_finds_the_exact_minimum;
mod engine_serves_any_operator;
mod every_scene_goes_on_to_the_same_bits;
mod every_scene_obeys_the_laws;
mod extremes_are_met;
mod files_of_other_programs_are_read;
mod files_of_slabs_are_never_half;
mod files_of_slabs_are_those_of_the_whole;
mod files_survive_a_round_trip;
mod fretting_loops_become_steady;
mod frozen_scenes;
mod gaussian_filters;
mod growing_contacts_take_any_steps;
#[cfg(feature = "dense")]
mod hard_cases_are_right;
mod heights_of_asked_skewness_and_kurtosis;
mod hertz_and_cattaneo_mindlin;
mod histories_balance_energy;
mod histories_fail_without_a_trace;
mod histories_follow_mindlin_deresiewicz;
mod histories_go_on_after_a_restart;
mod histories_in_the_plane;
mod histories_keep_their_state_through_wear;
mod histories_obey_the_spring;
mod histories_obey_their_laws;
mod histories_of_coated_bodies;
mod histories_remember_what_has_yielded;
mod influence_coefficients;
mod kernels_take_the_place_of_bodies;
mod known_contacts_beyond_spheres;
mod laws_hold;
mod levelling_takes_off_the_form;
mod lines_are_plane_strain;
mod load_paths_close_and_turn_exactly;
mod long_calls_stop_when_told;
mod measured_surfaces_are_prepared;
mod messages_name_value_and_remedy;
mod methods_agree;
mod moments_and_energies_follow_from_the_fields;
mod one_way_coupling_is_goodmans;
mod operators_take_the_place_of_bodies;
#[cfg(feature = "serde")]
mod plain_types_survive_serialisation;
mod planes_below_the_surface;
mod pressing_in_steps_meets_closed_forms;
mod pressures_at_centres;
mod problems_take_every_load;
#[cfg(feature = "dense")]
mod random_scenes_are_right;
mod ranks_exchange_blocks;
mod ranks_fail_together;
mod ranks_share_a_contact;
mod ranks_share_a_coupled_contact;
mod ranks_share_a_history;
mod ranks_share_stresses;
mod ranks_with_other_inputs_are_told;
mod repeated_solves_start_near_the_answer;
mod rolling_carries_the_memory;
mod rolling_lines_by_force;
mod rolling_loads_follow_their_creepages;
mod rolling_meets_closed_forms;
mod rolling_moments_are_reached;
mod rolling_slip_direction;
mod rolling_under_changing_loads;
mod rough_contacts_follow_theory;
mod rough_surfaces_follow_their_law;
mod same_bits_on_any_threads;
mod settings_change_between_solves;
mod shapes_are_their_formulas;
mod signs_follow_from_equilibrium;
mod solves_stop_when_told;
mod springs_drag_in_the_plane;
mod starts_do_not_matter;
mod states_and_endings;
mod states_are_kept_and_returned_to;
mod statistics_agree_with_an_independent_evaluation;
mod statistics_obey_their_laws;
mod steady_rolling;
mod stick_zones_of_histories_have_edges;
mod stiffness_is_the_slope_of_solves;
mod stiffness_of_sheared_histories;
mod stiffness_of_the_next_step;
mod stresses_below_the_surface;
mod stresses_in_coated_bodies;
mod superposition_is_exact;
mod surfaces_of_slabs_are_those_of_the_whole;
mod the_certificate_is_its_formula;
#[cfg(feature = "dense")]
mod the_error_of_the_grid_is_estimated;
mod the_hardness_bounds_the_pressure;
mod too_large_is_refused;
mod unchanged_problems_stop_at_once;
mod warnings_name_the_trap;
mod wear_laws_sum_up;
mod what_is_shown_is_short;
