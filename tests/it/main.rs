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

mod bulk_strain;
mod cancelled_solves;
mod closed_form_validation;
mod closed_forms;
mod coated_bodies;
#[cfg(feature = "dense")]
mod contact_edges;
mod contact_reference_data;
mod contact_reference_histories;
mod contact_reference_normal;
mod contact_reference_tangential;
mod contact_spots;
#[cfg(feature = "dense")]
mod convolution_equals_direct_sum;
mod coupled_contact;
mod coupled_histories;
mod coupled_projection_reference;
mod coupled_rolling;
mod coupled_termination;
mod custom_operators;
mod cycle_sums;
mod displacement_control;
mod distributed_io;
mod distributed_io_is_atomic;
mod engine_exact_minimum;
mod extreme_inputs;
mod file_formats;
mod file_round_trip;
mod fretting_loops;
mod frozen_scenes;
mod gaussian_filters;
mod growing_contact_step_size;
#[cfg(feature = "dense")]
mod hard_cases;
mod height_moments;
mod hertz_and_cattaneo_mindlin;
mod history_coatings;
mod history_continuation_is_bitwise;
mod history_energy_balance;
mod history_failed_steps;
mod history_hardness;
mod history_laws;
mod history_mindlin_deresiewicz;
mod history_restart;
mod history_springs;
mod history_vector_model;
mod history_wear;
mod influence_coefficients;
mod input_validation;
mod kernels_take_the_place_of_bodies;
mod known_contacts_beyond_spheres;
mod laws_hold;
mod levelling_takes_off_the_form;
mod lines_are_plane_strain;
mod load_paths_close_and_turn_exactly;
mod load_validation;
mod long_calls_stop_when_told;
#[cfg(feature = "dense")]
mod matrix_validation;
mod measured_surfaces_are_prepared;
mod messages_name_value_and_remedy;
mod methods_agree;
mod moments_and_energies_follow_from_the_fields;
mod near_gross_slip;
mod nested_start_accuracy;
mod one_way_coupling_is_goodmans;
mod operators_take_the_place_of_bodies;
mod periodic_contact;
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
mod rough_surface_refinement;
mod rough_surfaces_follow_their_law;
mod same_bits_on_any_threads;
mod scene_laws;
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
mod study_restart;
mod superposition_is_exact;
mod surface_validation;
mod surfaces_of_slabs_are_those_of_the_whole;
mod the_certificate_is_its_formula;
#[cfg(feature = "dense")]
mod the_error_of_the_grid_is_estimated;
mod the_hardness_bounds_the_pressure;
mod too_large_is_refused;
mod unchanged_problems_stop_at_once;
mod vector_model;
mod warnings_name_the_trap;
mod wear_laws_sum_up;
mod what_is_shown_is_short;
mod window_shrinking;
